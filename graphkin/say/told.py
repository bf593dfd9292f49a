"""What the answers to a set of problems tell of mistakes, for its teacher."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphkin.errors import Lang
from graphkin.marking.discriminability import LOOKED_AT, SetDiscriminability
from graphkin.say.catalogue import say
from graphkin.say.marks import table
from graphkin.say.numbers import number

_MOST = 10
"""Pairs that are told."""


def told_lines(told: SetDiscriminability, lang: Lang) -> Iterator[str]:
    """A row a mistake, then what is always one set, what the numbers make one, and false alarms."""
    length, angle = (f"{error:g}" for error in told.pencil)
    yield say("told.head", lang, problems=_problems(told.problems, lang), length=length, angle=angle)
    heads = [say(f"told.column {name}", lang) for name in ("mistake", "places", "seen", "apart")]
    rows = [_row(kind, counts) for kind, counts in told.kinds.items()]
    yield from table([[*heads, ""], *rows, _row(say("told.all", lang), (told.places, told.seen, told.apart))])
    yield say("told.not applicable", lang, share=_share(1 - told.seen))
    yield from _pairs("sets", told.sets, lang)
    yield from _pairs("rivals", told.rivals, lang)
    lost = "told.lost" if told.lost else "told.nothing lost"
    yield say(lost, lang, share=_share(told.lost), looked=LOOKED_AT)
    if told.tried:
        wrong, named = (f"{part:.2%}" for part in told.alarms)
        yield say("told.false alarms", lang, problems=_problems(told.tried, lang), wrong=wrong, named=named)


def _problems(count: int, lang: Lang) -> str:
    return say("told.problems one" if count == 1 else "told.problems many", lang, count=count)


def _row(name: str, counts: tuple[float, float, float]) -> list[str]:
    places, seen, apart = counts
    return [name, number(places), _share(seen), _share(apart), ""]


def _pairs(what: str, pairs: Mapping[tuple[str, str], float], lang: Lang) -> Iterator[str]:
    if not pairs:
        return
    yield say(f"told.pairs {what}", lang)
    for (first, second), share in list(pairs.items())[:_MOST]:
        yield "  " + say("told.pair", lang, first=first, second=second, share=_share(share))
    if len(pairs) > _MOST:
        yield "  " + say("told.more", lang, count=len(pairs) - _MOST)


def _share(part: float) -> str:
    return f"{part:.0%}"
