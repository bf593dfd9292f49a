"""Verdicts in words, the same everywhere."""

from __future__ import annotations

from typing import Literal, Protocol

from graphkin.errors import Lang
from graphkin.marking.records import Verdict
from graphkin.say.catalogue import say


class VerdictData(Protocol):
    """What a verdict is told by."""

    @property
    def verdict(self) -> Verdict: ...
    @property
    def sense(self) -> Literal["right", "wrong"] | None: ...
    @property
    def unit(self) -> str: ...
    @property
    def unit_right(self) -> bool: ...
    @property
    def credit(self) -> float: ...


def verdict(one: VerdictData, lang: Lang) -> str:
    """With what is wrong, where that is the unit or the sense alone."""
    if one.verdict != "wrong":
        return say(f"verdicts.verdict {one.verdict}", lang)
    if not one.unit_right:
        return say("verdicts.verdict wrong unit", lang)
    if not (one.credit > 0 and one.sense == "wrong"):
        return say("verdicts.verdict wrong", lang)
    return say(f"verdicts.verdict wrong {'direction' if one.unit in ('m/s', 'm/s^2') else 'sense'}", lang)
