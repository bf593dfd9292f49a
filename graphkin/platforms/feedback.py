"""What a student is told about a submission, in stages: hint, mistake, answer."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from graphkin.errors import Lang
from graphkin.platforms.numbers import exponentless
from graphkin.platforms.phrases import say
from graphkin.platforms.result import Line, Result, Suspicion, texts_in
from graphkin.quantities import EDGE

__all__ = ["Reveal", "diagnosis", "lines", "override", "quantity", "reason", "suspected", "total", "verdict"]

Reveal = Literal["hint", "mistake", "answer"]
"""How much is told: the verdicts; what they are consistent with, too; the right values, too."""


def lines(result: Result, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """All of it, a sentence a line."""
    if result.status == "not marked":
        yield reason(result, lang)
    for each in result.lines:
        yield say("stop", lang, text=quantity(each, lang, reveal))
    if reveal != "hint":
        yield from diagnosis(result, lang)
    if told := override(result, lang):
        yield told
    if result.total is not None:
        yield total(result, lang)


def reason(result: Result, lang: Lang) -> str:
    """Why it was not marked."""
    told = texts_in([result.reason], lang)[0] or say("no reason", lang)
    return say("not marked why", lang, reason=told)


def verdict(line: Line, lang: Lang) -> str:
    """`wrong, the sense`."""
    plain = say(f"verdict {line.verdict}", lang)
    return say("wrong sense", lang, verdict=plain) if line.sense == "wrong" else plain


def quantity(line: Line, lang: Lang, reveal: Reveal) -> str:
    """One quantity: verdict, points, what was handed in, and what it should be where that is told."""
    if line.feedback:
        return texts_in([line.feedback], lang)[0]
    told = [say("line", lang, name=line.name, verdict=verdict(line, lang)), *_numbers(line, lang, reveal)]
    if line.most:
        told.append(say("points of", lang, points=exponentless(line.points), most=exponentless(line.most)))
    return told[0] + "".join(say("after", lang, more=more) for more in told[1:])


def _numbers(line: Line, lang: Lang, reveal: Reveal) -> Iterator[str]:
    if line.given is not None:
        yield say("given", lang, value=_shown(line.given, line.unit))
    if line.tolerance is None or reveal != "answer":
        return
    off = _shown(line.tolerance, line.unit)
    if line.carried is not None:
        yield say("carried", lang, value=_shown(line.carried, line.unit), tolerance=off)
    if line.right is not None:
        yield say("answer", lang, value=_shown(line.right, line.unit), tolerance=off)


def _shown(value: float, unit: str) -> str:
    return EDGE[unit].shown(value) if unit in EDGE else f"{value:.6g} {unit}".rstrip()


def diagnosis(result: Result, lang: Lang) -> Iterator[str]:
    """What the numbers are consistent with; the best explanation alone."""
    for one in result.suspicions[:1]:
        explained = say("and", lang).join(one.explains)
        told = say("consistent", lang, explains=explained, mistake=suspected(one, lang))
        yield say("stop", lang, text=told.rstrip(" .。"))


def suspected(one: Suspicion, lang: Lang) -> str:
    """The mistakes in words, or by their ids."""
    told = texts_in(one.sentences, lang) or list(one.ids)
    told = [text.rstrip(" .。") for text in told]
    return told[0] if len(told) == 1 else say("one of", lang, mistakes=say("or", lang).join(told))


def override(result: Result, lang: Lang) -> str:
    """That the teacher gave the points; nothing where not."""
    if result.override is None:
        return ""
    return say("override", lang, points=exponentless(result.override), most=exponentless(result.most))


def total(result: Result, lang: Lang) -> str:
    """The points that count. Only of a result that has some."""
    assert result.total is not None
    return say("total", lang, points=exponentless(result.total), most=exponentless(result.most))
