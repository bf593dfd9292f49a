"""Centrodes and paths of centres for people: how many pieces, over what, and how far each reaches."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from graphkin.errors import Lang
from graphkin.say.catalogue import say
from graphkin.say.numbers import at_edge, number
from graphkin.studies.centres.centrodes import Centrodes


def curves_met(curves: Centrodes, centre: complex | None, lang: Lang) -> Iterator[str]:
    """What the curves do at a centre [m], for a sheet that shows them; how far each reaches."""
    if centre is not None:
        x, y = (number(1e3 * part, 1e-6) for part in (centre.real, centre.imag))
        key = "about.hinge" if curves.is_point else "about.rolling" if len(curves.axes) > 1 else "about.centre now"
        yield say(key, lang, centre=curves.name, place=f"({x}, {y}) mm")
    for piece in () if curves.is_point else curves.pieces:
        for link, places in zip(curves.axes, piece.places):
            yield _reach(curves, link, places, lang, _read)


def curve_lines(curves: Centrodes, lang: Lang) -> Iterator[str]:
    """A line for each piece, and under it one for each link that the curve lies in."""
    yield say("about.curves", lang, centre=curves.name, count=len(curves.pieces))
    for count, piece in enumerate(curves.pieces, 1):
        form = "about.piece closed" if piece.closed else "about.piece open"
        yield f"  {count}. " + say(form, lang, places=piece.t.size)
        for link, places in zip(curves.axes, piece.places):
            yield "     " + _reach(curves, link, places, lang, _mm)
    yield say("about.where curves", lang)


def _reach(
    curves: Centrodes, link: str, places: np.ndarray, lang: Lang, shown: Callable[[np.floating], str]
) -> str:  # fmt: skip
    sides = ((shown(part.min()), shown(part.max())) for part in (places.real, places.imag))
    x, y = (say("finding.interval", lang, begin=low, end=high) for low, high in sides)
    return say("about.reach", lang, link=curves.found.method.mechanism.called(link), x=x, y=y)


def _mm(value: np.floating) -> str:
    return at_edge(float(value), "m").replace("-", "−")


def _read(value: np.floating) -> str:
    return f"{number(1e3 * float(value), 1e-6)} mm"
