"""What drives the mechanism: an arc with an arrow for a turning link, a straight arrow for a driven slide."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

from graphkin.model.mechanism import FRAME, Driver
from graphkin.model.pairs import Line
from graphkin.sheet import symbols
from graphkin.sheet.fixed_link import ground_way
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, between, joined, quantity_label
from graphkin.sheet.marks import Place, Shows
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.wheels import circles, wheels_of
from graphkin.sheet.window import Figure

_APART = 3.0
"""Between two arcs about one point [mm]."""


def drives(skeleton: Skeleton) -> Figure:
    """Arrows of all drivers that move."""
    figure = Figure()
    for driver in skeleton.mechanism.drivers:
        if driver.rate == 0 and driver.acceleration == 0:
            continue
        if driver.kind == "slide":
            _slide_arrow(skeleton, driver, figure)
        elif driver.vector is not None:
            _turn_arrow(skeleton, driver, figure)
        elif driver.kind == "spin":
            _spin_arrow(skeleton, driver, figure)
    return figure


def _turn_arrow(skeleton: Skeleton, driver: Driver, figure: Figure) -> None:
    """About the vector's tail, starting at the link in the sense of its rotation."""
    assert driver.vector is not None
    at, tip = skeleton.at(driver.vector[0]), skeleton.at(driver.vector[1])
    if abs(tip - at) < 1:
        return
    towards = (tip - at) / abs(tip - at)
    ways = [towards * cmath.rect(1, math.radians(turn)) for turn in (-14, 76, -149)]
    radius = min(9.0, max(6.0, 0.45 * abs(tip - at)))
    _arcs(skeleton, driver, figure, driver.vector, (radius, [ways, [towards**2 * way.conjugate() for way in ways]]))


def _spin_arrow(skeleton: Skeleton, driver: Driver, figure: Figure) -> None:
    """In a wheel whose direction does not matter, about its centre."""
    own = [wheel for wheel in wheels_of(skeleton.mechanism) if wheel.link == driver.link]
    if own:
        reach = min(9.0, max(4.0, 0.6 * own[0].radius / skeleton.window.scale))
        ways = [cmath.rect(1, math.radians(turn)) for turn in range(0, 360, 45)]
        _arcs(skeleton, driver, figure, (own[0].centre,), (reach, [ways, ways]))


def _arcs(
    skeleton: Skeleton, driver: Driver, figure: Figure, on: tuple[str, ...],
    ways: tuple[float, Sequence[Sequence[complex]]],
) -> None:  # fmt: skip
    """An arc about the first point; where the acceleration opposes the rate each has its own, the one about the other.

    ways  the radius, and the directions at which an arc may begin, of counter-clockwise ones and of others
    """
    at, (radius, starts) = skeleton.at(on[0]), ways
    seen_from = driver.from_link if driver.from_link != FRAME else ""
    for sense, letters in _senses(driver).items():
        start = max(starts[sense < 0], key=lambda way: _room(skeleton, at + way * _half(sense) * radius))
        shows = Shows(driver.link, "omega" if "ω" in letters else "alpha", on[:1], seen_from)
        marks = symbols.spin(at, start, sense, radius, skeleton.step(*on), shows)
        figure.marks += marks
        middle = start * _half(sense)
        label, place = _turn_label(skeleton, driver, letters), at + middle * radius
        figure.wanted.append(LabelRequest(label, place, gap=0.3, away=middle, step=marks[0].step))
        radius += _APART


def _senses(driver: Driver) -> dict[float, str]:
    """The letters of rate and acceleration by the sense that they have."""
    senses = dict[float, str]()
    for letter, value in (("ω", driver.rate), ("α", driver.acceleration)):
        if value:
            sense = math.copysign(1, value)
            senses[sense] = senses.get(sense, "") + letter
    return senses


def _half(sense: float) -> complex:
    """From the start of a turning arrow to its middle."""
    return cmath.rect(1, -sense * symbols.SWEEP / 2)


def _room(skeleton: Skeleton, place: Place) -> float:
    """How far a place is from the nearest link, in steps of what matters to the eye [mm]."""
    grounds = [
        (at := skeleton.at(p), at + symbols.PIVOT_DEPTH * ground_way(p, skeleton))
        for p in skeleton.points
        if FRAME in skeleton.mechanism.owners[p]
    ]
    stretches = [*skeleton.segments(), *grounds]
    gaps = [_distance(place, a, b) for a, b in stretches]
    gaps += [abs(abs(place - at) - radius) for at, radius in circles(skeleton)]
    return min([5.0, *gaps])


def _distance(place: Place, start: Place, end: Place) -> float:
    """From a place to a stretch of line."""
    way = end - start
    t = ((way.conjugate() * (place - start)).real / abs(way) ** 2) if way else 0.0
    return abs(place - start - way * max(0.0, min(1.0, t)))


def _turn_label(skeleton: Skeleton, driver: Driver, letters: str) -> Label:
    links = [driver.link] if driver.from_link == FRAME else [driver.link, driver.from_link]
    called = between([skeleton.mechanism.called(link) for link in links])
    return joined([quantity_label(letter, called) for letter in letters])


def _slide_arrow(skeleton: Skeleton, driver: Driver, figure: Figure) -> None:
    """Beside the block, the way it goes."""
    point, line, pair = _path(skeleton, driver)
    along = skeleton.direction(line) * math.copysign(1, driver.rate or driver.acceleration)
    up = along * 1j if (along * 1j).imag <= 0 else along * -1j
    at = skeleton.at(point)
    for slide in skeleton.mechanism.slides:
        if slide.name == driver.link and skeleton.is_cylinder(slide):
            foot = skeleton.at(slide.line.origin)
            at = foot + (1 + symbols.TUBE) / 2 * (at - foot) - 2 * along
    out = 5.2 + max((radius for centre, radius in circles(skeleton) if abs(centre - at) < 0.1), default=0.0)
    out -= 1.5 if out > 6 else 0.0
    across = max((up, -up), key=lambda side: min(_room(skeleton, at + side * out + along * t) for t in (-3, 3, 6)))
    start = at + across * out - along * 4
    marks = symbols.push(start, along, Shows(line.link, "push", line=driver.link), skeleton.step(point))
    figure.marks += marks
    names = [skeleton.mechanism.called(link) for link in reversed(pair)]
    label = quantity_label("v", point if line.link == FRAME else between(names))
    figure.wanted.append(LabelRequest(label, start, start + 11 * along, away=across, step=marks[0].step))


def _path(skeleton: Skeleton, driver: Driver) -> tuple[str, Line, tuple[str, ...]]:
    """The point a driven slide (or roll) moves, the line it moves along, the links it joins."""
    pair = skeleton.mechanism.pair(driver.link)
    assert pair.path is not None
    return pair.path.point, pair.path.line, pair.joins
