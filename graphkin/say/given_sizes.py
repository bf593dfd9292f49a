"""What a mechanism file gives as numbers, read once: the distances of a link's points, radii, how drivers move.

`given_dimensions` and `given` tell them in sentences, `dimensions` as the figures of a sheet.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, pairwise
from math import degrees

from graphkin.base.geometry import cross
from graphkin.base.value import frozen
from graphkin.model.mechanism import Driver
from graphkin.say import names
from graphkin.say.numbers import given
from graphkin.say.reading import Reading


@frozen
class Size:
    """A symbol with its value in a unit: `r2 = 20 mm`."""

    symbol: str
    value: float
    unit: str

    @property
    def text(self) -> str:
        after = self.unit if self.unit == "°" else f" {self.unit}"
        return f"{self.symbol} = {given(self.value)}{after}"


@frozen
class Side:
    """Two points of a link, and how far apart they are [m]."""

    first: str
    second: str
    length: float

    @property
    def name(self) -> str:
        return names.pair(self.first, self.second)


def sides(reading: Reading, link: str) -> list[Side]:
    """The distances that fix the points of a link: of each from the first two, between which it may lie."""
    shape, points = reading.mechanism.links[link], reading.mechanism.named(link)
    pairs = (pair for pair in combinations(points, 2) if points.index(pair[0]) < 2)
    return [Side(first, second, abs(shape.arm(first, second))) for first, second in pairs]


def in_a_row(reading: Reading, link: str) -> list[Side]:
    """The distances of points that lie in one line, each from the one before."""
    shape = reading.mechanism.links[link]
    return [Side(*pair, abs(shape.arm(*pair))) for pair in pairwise(reading.mechanism.named(link))]


def beside(reading: Reading, link: str) -> Iterator[tuple[tuple[str, str, str], bool]]:
    """Each further point that is not in line with the first two, after these, and whether they go counter-clockwise."""
    shape, points = reading.mechanism.links[link], reading.mechanism.named(link)
    for third in points[2:]:
        side = float(cross(shape.arm(points[0], points[1]), shape.arm(points[0], third)))
        if abs(side) > reading.noise * abs(shape.arm(points[0], third)):
            yield (points[0], points[1], third), side > 0


def millimetres(reading: Reading, length: float) -> float:
    """A length, or a coordinate, as it is given; noise is none."""
    return length * 1000 if abs(length) > reading.noise else 0.0


def radius(reading: Reading, link: str, size: float) -> Size:
    """Of a wheel: `r2`."""
    return Size(reading.radius(link, size), millimetres(reading, size), "mm")


def circle(reading: Reading, centre: str, size: float) -> Size:
    """Of a profile or a circular slot: `r_P`."""
    return Size(reading.circle(centre, size), millimetres(reading, size), "mm")


def driven(reading: Reading, k: int, driver: Driver) -> tuple[Size, Size, Size]:
    """Where a driver stands, how fast it moves, and how that changes; counter-clockwise is positive."""
    facts = reading.plot.facts
    place, rate, more = (float(table[k]) for table in (facts.values, facts.rates, facts.accelerations))
    if driver.kind == "slide":
        at, first, second = (names.of_slide(symbol, driver.link) for symbol in ("s", "ṡ", "s̈"))
        return Size(at, place * 1000, "mm"), Size(first, rate, "m/s"), Size(second, more, "m/s²")
    at, first, second = (reading.against(driver, symbol) for symbol in ("φ", "ω", "α"))
    return Size(at, degrees(place), "°"), Size(first, rate, "rad/s"), Size(second, more, "rad/s²")
