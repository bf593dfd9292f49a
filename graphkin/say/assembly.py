"""In which assembly a mechanism is drawn: on which side of a line a point lies."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.errors import Lang
from graphkin.running.drawn_sides import DrawnSides, PointSide
from graphkin.say import names
from graphkin.say.catalogue import say


def assembly(found: DrawnSides, lang: Lang) -> str:
    """`C above BD`, one after another; nothing where there is no choice."""
    told = say("common.and", lang).join(dict.fromkeys(_told(found, lang)))
    return told and say("assembly.drawn", lang, told=told)


def _told(found: DrawnSides, lang: Lang) -> Iterator[str]:
    for lies in found.lies:
        line = "".join(map(names.point, lies.line))
        yield say(f"assembly.side {_side(lies)}", lang, point=names.point(lies.point), line=line)
    for point, place in found.near:
        x, y = (f"{1000 * part + 0.0:.4g}" for part in (place.real, place.imag))
        yield say("assembly.near", lang, point=names.point(point), x=x, y=y)


def _side(lies: PointSide) -> str:
    if lies.by_distance:
        return "far" if lies.to.real > 0 else "near"
    if abs(lies.to.imag) >= abs(lies.to.real):
        return "above" if lies.to.imag > 0 else "below"
    return "right" if lies.to.real > 0 else "left"
