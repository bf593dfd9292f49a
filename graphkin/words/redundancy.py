"""The redundant (passive) constraints (虚约束) of a planned mechanism in words: which, and what holds the same."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.errors import Lang, called_pair, listed
from graphkin.naming import named
from graphkin.planning import Method
from graphkin.planning.candidates import SetAside
from graphkin.planning.stages import Bridge

__all__ = ["redundant_constraints"]

PARTS: dict[str, dict[Lang, str]] = {
    "whole": {"en": "{pair}", "zh": "{pair}"},
    "link": {"en": "{pair}", "zh": "{pair}"},
    "line": {"en": "the distance from the track in {pair}", "zh": "{pair} 中轮心到轨道的距离"},
    "angle": {"en": "the angle kept by {pair}", "zh": "{pair} 所保持的角度"},
    "slip": {"en": "no slip in {pair}", "zh": "{pair} 的无滑动条件"},
}
HELD: dict[Lang, str] = {
    "en": "{what} ({held} hold the same already)",
    "zh": "{what}（其约束已由 {held} 给出）",
}
HELD_BY_ONE: dict[Lang, str] = {"en": "{what} ({held} holds the same already)", "zh": HELD["zh"]}
DISTANCE: dict[Lang, str] = {
    "en": "{what} (the points it joins keep their distance without it)",
    "zh": "{what}（它所连接的两点间的距离本来就保持不变）",
}


def redundant_constraints(method: Method, lang: Lang) -> Iterator[str]:
    """One line each: `guide high (guide low holds the same already)`."""
    yield from (_told(method, each, lang) for each in method.aside)
    if not any(each.part == "link" for each in method.aside):
        bridged = (stage.body for stage in method.stages if isinstance(stage, Bridge))
        links = (body for body in bridged if body in method.mechanism.links)
        yield from (DISTANCE[lang].format(what=called_pair("links", link, lang)) for link in links)


def _told(method: Method, each: SetAside, lang: Lang) -> str:
    what = PARTS[each.part][lang].format(pair=called_pair(*named(method.mechanism, each.pair), lang))
    if not each.held or each.part == "link":
        return DISTANCE[lang].format(what=what)
    held = listed((called_pair(*named(method.mechanism, pair), lang) for pair in each.held), lang)
    return (HELD if len(each.held) > 1 else HELD_BY_ONE)[lang].format(what=what, held=held)
