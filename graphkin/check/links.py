"""Lines of links held against the links: bars by points, guides and blocks by the line they lie on, wheels by radius.

Each mark gives a place that should be where it is drawn, the worst one: [mm on paper, y up].
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator, Mapping

import numpy as np

from graphkin.check.shown import ShownMark
from graphkin.check.widened import Widened, lines_of
from graphkin.model.mechanism import Mechanism
from graphkin.model.pairs import Rod

Pair = tuple[complex, complex]
"""Where something is drawn, and where it should be."""


def link_name(attributes: Mapping[str, str]) -> str:
    """`link 3: A B`."""
    on = attributes.get("data-line", "") if attributes.get("data-form") != "bar" else attributes.get("data-points", "")
    return f"{attributes.get('data-link', '')}: {on or attributes.get('data-points', '')}"


def worst_place(mark: ShownMark, exact: Widened, at: Callable[[str], complex], scale: float) -> Pair | None:
    """The place of a link's line that is farthest off; None for a mark that says nothing known.

    at  where a point of its plane should be on paper [mm]; raises KeyError.  scale  [m/mm]
    """
    form, points = mark.attributes.get("data-form", ""), mark.attributes.get("data-points", "").split()
    if not mark.lines or mark.attributes.get("data-link", "") not in {*exact.mechanism.links, *exact.bodies}:
        return None
    if form == "wheel":
        pairs = list(_wheel(mark, exact.mechanism, at, scale)) if mark.tag == "circle" else []
    elif not mark.plain or len(mark.lines) > 1:
        return None
    elif form == "arc":
        pairs = list(_arc(mark, exact.mechanism, [at(point) for point in points], scale))
    elif form in ("omega", "alpha", "push"):
        pairs = [_sense(mark, form, exact, [at(point) for point in points])]
    elif form == "bar":
        pairs = _bar(mark, [at(point) for point in points])
    else:
        pairs = list(_on_line(mark, form, exact, at, points))
    return max(pairs, key=lambda pair: abs(pair[0] - pair[1]), default=None)


def _corners(mark: ShownMark) -> list[complex]:
    places = list(mark.lines[0])
    return places[:-1] if len(places) > 2 and abs(places[0] - places[-1]) < 1e-9 else places


def _bar(mark: ShownMark, wanted: list[complex]) -> list[Pair]:
    corners = _corners(mark)
    return list(zip(corners, wanted, strict=True)) if len(corners) == len(wanted) else []


def _wheel(mark: ShownMark, mechanism: Mechanism, at: Callable[[str], complex], scale: float) -> Iterator[Pair]:
    """The circle's middle, and its radius beside the nearest one that its link has there."""
    link, centre = mark.attributes["data-link"], mark.attributes.get("data-points", "")
    middle, radius = mark.middle, abs(mark.lines[0][0] - mark.middle)
    yield middle, at(centre)
    radii = [r / scale for r in _radii(mechanism, link, centre)]
    if not radii or mark.scale <= 0:
        raise KeyError(centre)
    yield middle + radius, middle + min(radii, key=lambda right: abs(right - radius))


def _arc(mark: ShownMark, mechanism: Mechanism, points: list[complex], scale: float) -> Iterator[Pair]:
    """Every corner at its radius from the centre, a slot's half a width off it; and the pin between the ends."""
    centre, pin = points
    (radius,) = (pair.equivalent.length for pair in mechanism.pairs
                 if pair.name == mark.attributes.get("data-line", "") and isinstance(pair.equivalent, Rod))  # fmt: skip
    corners = _corners(mark)
    off = [abs(place - centre) - radius / scale for place in corners]
    half = (max(off) - min(off)) / 2 if len(corners) < len(mark.lines[0]) else 0.0
    for place, beyond in zip(corners, off, strict=True):
        yield place, place + (centre - place) / abs(centre - place) * (beyond - min(max(beyond, -half), half))
    turns = [cmath.phase((place - centre) / (pin - centre)) for place in corners]
    if min(turns) > 0 or max(turns) < 0:
        yield corners[0], pin


def _sense(mark: ShownMark, form: str, exact: Widened, points: list[complex]) -> Pair:
    """The middle of an arrow head's back, behind its tip on the side from which the motion comes."""
    tip, *back = _corners(mark)
    foot = sum(back) / len(back)
    link, line, long = mark.attributes["data-link"], mark.attributes.get("data-line", ""), abs(tip - foot)
    if form == "push":
        rate = float(exact.s_rate[line]) or float(exact.s_acceleration[line])
        way = lines_of(exact.mechanism)[line].direction * cmath.rect(1, float(np.real(exact.theta[link])))
        return foot, tip - long * way * float(np.sign(rate))
    turning = exact.turning if form == "omega" else exact.swing
    rate = float(turning(link)) - (float(turning(line)) if line else 0.0)
    arm = tip - points[0]
    chord = arm - arm * cmath.rect(1, -float(np.sign(rate)) * long / abs(arm))
    return foot, tip - long * chord / abs(chord)


def _radii(mechanism: Mechanism, link: str, centre: str) -> set[float]:
    """Radii of a link's circles about one point [m]."""
    return {radius for pair in mechanism.pairs for *at, radius in pair.circles if at == [link, centre]}


# --- on a line of a link ----------------------------------------------------------------------


def _on_line(
    mark: ShownMark, form: str, exact: Widened, at: Callable[[str], complex], points: list[str]
) -> Iterator[Pair]:
    """Ends or middle on the line, sides along it, over its points; a block's middle on its point."""
    line = lines_of(exact.mechanism)[mark.attributes.get("data-line", "")]
    foot, along = at(line.origin), line.direction * cmath.rect(1, float(np.real(exact.theta[line.link])))
    corners = _corners(mark)
    middle = sum(corners) / len(corners)
    for place in corners if len(corners) == 2 else [middle]:
        yield place, foot + along * ((place - foot) / along).real
    sides = list(zip(corners, [*corners[1:], corners[0]], strict=True))
    if form == "block":
        yield middle, at(points[0])
        yield from (_squared(side, along) for side in sides)
    else:
        longest = max(sides, key=lambda side: abs(side[1] - side[0]))
        yield longest[1], longest[0] + along * ((longest[1] - longest[0]) / along).real
    stretch = [((corner - foot) / along).real for corner in corners]
    for point in points:
        t = ((at(point) - foot) / along).real
        yield foot + along * min(max(t, min(stretch)), max(stretch)), foot + along * t


def _squared(side: Pair, along: complex) -> Pair:
    """A side's end, and where it would be along or across the line."""
    way = (side[1] - side[0]) / along
    return side[1], side[0] + along * (way.real if abs(way.real) > abs(way.imag) else 1j * way.imag)
