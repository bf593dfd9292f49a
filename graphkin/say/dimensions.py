"""The numbers that a mechanism file gives, each read once: lengths, offsets, angles, radii, and how it is driven.

`problem_data` tells them in sentences; `dimensions` are the figures of a sheet.
"""

from __future__ import annotations

from cmath import phase, rect
from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations, pairwise
from math import degrees, pi

from graphkin.base.geometry import cross
from graphkin.base.value import frozen
from graphkin.construction import LayOff, Normal, Swing, Tangential, Term, Turning, kinds
from graphkin.files.shapes import Length, Measure
from graphkin.model.mechanism import FRAME, Driver
from graphkin.model.pairs import Cam, Gear, RollingContact, Slide
from graphkin.say import names
from graphkin.say.numbers import given_figure, number
from graphkin.say.reading import Reading, aside


@frozen
class Size:
    """A symbol with its value in a unit: `r2 = 20 mm`."""

    symbol: str
    value: float
    unit: str

    @property
    def text(self) -> str:
        after = self.unit if self.unit == "°" else f" {self.unit}"
        return f"{self.symbol} = {given_figure(self.value)}{after}"


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


def measure_size(measure: Measure) -> Size:
    """`l_AB = 24 mm`, `∠BDE = 90°`, by which a file gives a link."""
    if isinstance(measure, Length):
        return Size(f"l_{names.pair(*measure.points)}", measure.value * 1000, "mm")
    return Size(f"∠{''.join(map(names.point, measure.points))}", degrees(measure.value), "°")


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
    """The value of a driver, its rate, and the rate of that; counter-clockwise is positive."""
    facts = reading.plot.facts
    place, rate, more = (float(table[k]) for table in (facts.values, facts.rates, facts.accelerations))
    if driver.kind == "slide":
        at, first, second = (names.of_slide(symbol, driver.link) for symbol in ("s", "ṡ", "s̈"))
        return Size(at, place * 1000, "mm"), Size(first, rate, "m/s"), Size(second, more, "m/s²")
    at, first, second = (reading.against(driver, symbol) for symbol in ("φ", "ω", "α"))
    return Size(at, degrees(place), "°"), Size(first, rate, "rad/s"), Size(second, more, "rad/s²")


@frozen
class GuideAngle:
    """The line through `through` makes `angle` [rad] with corner -> through, counter-clockwise where positive.

    symbol  γ, with the number of the link where several guides have such an angle; "" where another is given
    corner  the point about which the drawing turns the link, from which γ is counted
    """

    symbol: str
    corner: str
    through: str
    angle: float


def guide_angle(reading: Reading, slide: Slide) -> GuideAngle | None:
    """The angle at which a moving guide's line lies; None of one through two points, or that is the link itself."""
    corners = {pair.name: corner for pair in reading.mechanism.slides if (corner := _corner(reading, pair))}
    if slide.name not in corners:
        return None
    corner, through = corners[slide.name], slide.line.origin
    arm = reading.mechanism.links[slide.guide].arm(corner, through)
    angle = (phase(slide.line.direction / arm) + pi) % (2 * pi) - pi
    alone = len({pair.guide for pair in reading.mechanism.slides if pair.name in corners}) == 1
    symbol = "γ" if alone else names.of_link("γ", reading.mechanism.called(slide.guide))
    return GuideAngle(symbol if slide.line.base in (None, (corner, through)) else "", corner, through, angle)


def _corner(reading: Reading, slide: Slide) -> str:
    """The point from which γ is counted: the pivot of the drawing, else another point of the guide; "" for none."""
    if slide.guide == FRAME or not slide.line.named:
        return ""
    link, through = reading.mechanism.links[slide.guide], slide.line.origin
    points = [p for p in reading.mechanism.named(slide.guide) if abs(link.arm(p, through)) > reading.noise]
    if any(aside(slide.line.direction, link.arm(p, through)) <= reading.noise for p in points):
        return ""
    stated = [slide.line.base[0]] if slide.line.base is not None and slide.line.base[1] == through else []
    swings = (step for step in reading.method.position.steps if isinstance(step, Swing))
    pivots = (step.pivot for step in swings if step.slide == slide.name)
    return next((point for point in (*stated, *pivots, *points) if point in points), "")


def dimensions(reading: Reading) -> list[str]:
    """`AD = 78 mm`, `AB = 24 mm`, .. link by link; then offsets of guides, radii of wheels, driven rates."""
    tables = (_lengths, _offsets, _radii_and_rates)
    return [*dict.fromkeys(text for table in tables for text in table(reading))]


def _lengths(reading: Reading) -> Iterator[str]:
    """`AD = 78 mm` of fixed points, `x_D` and `y_D` of oblique ones; then the distances that fix each link's points."""
    shape = reading.plot.facts.shapes[FRAME]
    first, *others = _drawn_points(reading, FRAME) or [""]
    for other in others:
        away = complex(shape[other] - shape[first])
        if min(abs(away.real), abs(away.imag)) <= reading.noise:
            yield f"{names.pair(first, other)} = {given_figure(abs(away) * 1000)} mm"
        else:
            called = names.pair(first, other) if shape[first] else names.point(other)
            parts = (("x", away.real), ("y", away.imag))
            yield from (f"{sign}_{called} = {given_figure(part * 1000)} mm" for sign, part in parts)
    for link in reading.mechanism.moving:
        body, row = reading.mechanism.links[link], pairwise(reading.mechanism.named(link))
        in_line = not [*beside(reading, link)]
        for side in [Side(*ends, abs(body.arm(*ends))) for ends in row] if in_line else sides(reading, link):
            yield Size(side.name, millimetres(reading, side.length), "mm").text


def _drawn_points(reading: Reading, link: str) -> list[str]:
    return [point for point in reading.mechanism.named(link) if point in reading.plot.position]


def _offsets(reading: Reading) -> Iterator[str]:
    """`e_A = 20 mm`, `β_C = 30°`, `h_A = 20 mm`: how guides and flat faces lie beside the first point of their link."""
    for slide in reading.mechanism.of(Slide):
        points = _drawn_points(reading, slide.guide)
        if points and slide.stands_for is None:
            off = aside(reading.guide(slide.name), reading.arm(points[0], slide.point))
            if off > reading.noise:
                yield f"{'e' if slide.guide == FRAME else 'h'}_{names.point(points[0])} = {given_figure(off * 1000)} mm"
    for slide in reading.mechanism.slides:
        if slide.guide == FRAME and slide.stands_for is None:
            angle = round(degrees(phase(slide.line.direction)), 9) % 180
            if angle % 90:
                yield f"β_{names.point(slide.point)} = {given_figure(angle)}°"
    for line in (line for cam in reading.mechanism.of(Cam) for line in cam.lines):
        points = _drawn_points(reading, line.link)
        if points and line.origin in reading.plot.position:
            along = line.direction * rect(1, float(reading.plot.theta.get(line.link, 0.0)))
            off = aside(along, reading.arm(points[0], line.origin))
            if off > reading.noise:
                yield f"h_{names.point(points[0])} = {given_figure(off * 1000)} mm"


def _radii_and_rates(reading: Reading) -> Iterator[str]:
    """`r2 = 20 mm` of wheels and profiles; `s_ram = 90 mm` of driven slides, then `φ1 = 30°` and the rates of all."""
    for link, _, size in (rim for gear in reading.mechanism.of(Gear) for rim in gear.circles):
        yield radius(reading, link, size).text
    for roll in reading.mechanism.of(RollingContact):
        yield radius(reading, roll.wheel, roll.radius).text
    for centre, size in reading.circles:
        yield circle(reading, centre, size).text
    drivers = [(driver, driven(reading, k, driver)) for k, driver in enumerate(reading.mechanism.drivers)]
    yield from (place.text for driver, (place, *_) in drivers if driver.kind == "slide")
    for driver, (place, *rates) in drivers:
        if driver.kind == "angle" and driver.value is not None:
            yield place.text
        for rate in rates:
            if rate.value:
                yield replace(rate, value=rate.value if driver.kind == "slide" else abs(rate.value)).text


def measured_lengths(reading: Reading) -> list[tuple[str, str]]:
    """The distances by which rotations are found or sizes made that no link gives: they are measured in the drawing."""
    method, owners, levers = reading.method, reading.mechanism.owners, dict[tuple[str, str], None]()
    for step in (step for construction in (method.velocity, method.acceleration) for step in construction.steps):
        match step:
            case kinds.Measure(lever=lever):
                pass
            case LayOff(term=Term(size=Turning(_, tail, head) | Normal(_, tail, head) | Tangential(_, tail, head))):
                lever = (tail, head)
            case _:
                continue
        if lever[0]:
            first, second = sorted(lever)
            if reading.named(first) and reading.named(second) and reading.distance(first, second):
                levers[first, second] = None
    return [ends for ends in levers if not {*owners.get(ends[0], ())} & {*owners.get(ends[1], ())}]


def length_text(reading: Reading, one: str, other: str) -> str:
    """`l_BD = 69.2 mm`, of the mechanism itself."""
    return f"l_{names.pair(one, other)} = {number(reading.distance(one, other) * 1000)} mm"
