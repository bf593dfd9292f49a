"""In which sense something turns: a size with a word, never a sign with one."""

from __future__ import annotations

from graphkin.errors import Lang
from graphkin.say.catalogue import say
from graphkin.say.numbers import given


def sense(value: float, lang: Lang) -> str:
    return say("common.ccw" if value > 0 else "common.cw", lang)


def sensed(name: str, value: float, unit: str, lang: Lang) -> str:
    """`ω1 = 10 rad/s (counter-clockwise)`; nothing has no sense."""
    if value == 0:
        return f"{name} = 0"
    note = say("common.note", lang, note=sense(value, lang))
    return f"{name} = {given(abs(value))} {unit}{note}"
