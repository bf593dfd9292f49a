"""Centrodes and paths of centres for people: how many pieces, over what, and how far each reaches."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.centres.centrodes import Centrodes
from graphkin.errors import Lang
from graphkin.say.catalogue import say
from graphkin.say.numbers import at_edge


def curve_lines(curves: Centrodes, lang: Lang) -> Iterator[str]:
    """A line for each piece, and under it one for each link that the curve lies in."""
    machine = curves.found.method.mechanism
    yield say("about.curves", lang, centre=curves.name, count=len(curves.pieces))
    for number, piece in enumerate(curves.pieces, 1):
        form = "about.piece closed" if piece.closed else "about.piece open"
        yield f"  {number}. " + say(form, lang, places=piece.t.size)
        for link, places in zip(curves.axes, piece.places):
            x, y = (f"{_mm(part.min())} .. {_mm(part.max())}" for part in (places.real, places.imag))
            yield "     " + say("about.reach", lang, link=machine.called(link), x=x, y=y)
    yield say("about.where curves", lang)


def _mm(value: np.floating) -> str:
    return at_edge(float(value), "m")
