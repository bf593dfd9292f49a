"""The data of a problem as its file states them, each read once: lengths, angles, radii, and how it is driven.

`problem_data` tells them in sentences; a sheet draws them where they lie, and writes what finds no room.
"""

from __future__ import annotations

from cmath import phase, rect
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import combinations, permutations
from math import degrees, fmod, isclose, sin, tau

from graphkin.base.cache import kept
from graphkin.base.geometry import cross, dot
from graphkin.base.value import frozen
from graphkin.construction import LayOff, Measure, Normal, Swing, Tangential, Term, Turning
from graphkin.model.mechanism import FRAME, Dimension, Driver, KeyPath, Pose
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, Pair, RollingContact, Slide
from graphkin.planning.position import contact_letters
from graphkin.say import names
from graphkin.say.numbers import number
from graphkin.say.reading import Reading, aside
from graphkin.say.sizes import DrawnAngle, DrawnLength, Size, in_unit, length_unit, sized


def beside(reading: Reading, link: str) -> Iterator[tuple[tuple[str, str, str], bool]]:
    """Each further point that is not in line with the first two, after these, and whether they go counter-clockwise."""
    shape, points = reading.mechanism.links[link], reading.mechanism.named(link)
    for third in points[2:]:
        side = float(cross(shape.arm(points[0], points[1]), shape.arm(points[0], third)))
        if abs(side) > reading.noise * abs(shape.arm(points[0], third)):
            yield (points[0], points[1], third), side > 0


# --- lengths and angles of links --------------------------------------------------------------------------------------


def link_sizes(reading: Reading, link: str) -> Iterator[Size]:
    """The lengths and angles that the file states of a link; of one whose points it has by coordinates, the distances
    that fix them: from the first two points, or along a line from the first."""
    machine, shape, points = reading.mechanism, reading.mechanism.links[link], reading.mechanism.named(link)
    keys = {path[2]: each for path, each in machine.given.items() if path[:2] == ("links", link) and len(path) == 3}
    coordinates = [path for path in machine.given if path[:3] == ("links", link, "shape")]
    ends = [pair for pair in permutations(points, 2) if "".join(pair) in keys]
    triples = [corners for corners in permutations(points, 3) if "".join(corners) in keys]
    if any(not isclose(abs(shape.arm(*pair)), keys["".join(pair)].si or 0.0, rel_tol=1e-6) for pair in ends):
        ends, triples = [], []  # another size than the file's
    if not ends:
        in_line = not [*beside(reading, link)]
        ends = [pair for pair in combinations(points, 2) if points.index(pair[0]) < (1 if in_line else 2)]
    for pair in ends:
        place = "links", link, "".join(pair)
        bar, arm = _bar(reading, link, pair), shape.arm(*pair)
        size = sized(reading, f"l_{names.pair(*pair)}", abs(arm), "length", place, *coordinates, shape=bar)
        typed = [[machine.given[*path[:3], p, k].si or 0.0 for p in pair] for path in coordinates[:1] for k in (0, 1)]
        yield replace(size, derived=bool(typed) and all(abs(a - b) > reading.noise for a, b in typed))
    for one, corner, other in triples:
        angle = phase(shape.arm(corner, other) / shape.arm(corner, one))
        at = (one, corner, other)
        placed = _placed(reading, at)
        drawn = DrawnAngle(reading.at(corner), _unit(reading.arm(corner, one)), angle, at) if placed else None
        symbol = "∠" + "".join(map(names.point, at))
        yield sized(reading, symbol, abs(angle), "angle", ("links", link, "".join(at)), shape=drawn)


def _placed(reading: Reading, points: tuple[str, ...]) -> bool:
    return all(point in reading.plot.position for point in points)


def _unit(arm: complex) -> complex:
    return arm / abs(arm)


def _bar(reading: Reading, link: str, ends: tuple[str, str]) -> DrawnLength | None:
    """The stretch of a link between two of its points; beside it, where others lie on it."""
    if not _placed(reading, ends) or abs(reading.arm(*ends)) <= reading.noise:
        return None
    start, end = map(reading.at, ends)
    along = _unit(end - start)
    others = (point for point in reading.mechanism.named(link) if point not in ends and _placed(reading, (point,)))
    offs = [(reading.at(point) - start) / along for point in others]
    between = any(abs(off.imag) < 0.02 * abs(end - start) and 0 < off.real < abs(end - start) for off in offs)
    return DrawnLength(start, end, along, ends, "apart" if between else "bar")


def frame_sizes(reading: Reading) -> Iterator[Size]:
    """The places of fixed points from the first: the distance of one that lies level with it, or straight above, else
    `x_D` and `y_D`."""
    shape = reading.mechanism.links[FRAME].points
    first, *others = reading.mechanism.named(FRAME) or ("",)
    for other in others:
        away, start = shape[other] - shape[first], shape[first]
        both = (("x", away.real, 1 + 0j), ("y", away.imag, 1j))
        parts = [each for each in both if abs(each[1]) > reading.noise]
        for sign, part, axis in parts:
            lone = len(parts) == 1
            called = names.pair(first, other) if lone or shape[first] else names.point(other)
            symbol, places = (f"l_{called}" if lone else f"{sign}_{called}"), _coordinates(("frame", other), first)
            span = DrawnLength(start, shape[other], axis, (first, other))
            yield sized(reading, symbol, abs(part) if lone else part, "length", *places, shape=span)


def _coordinates(path: KeyPath, first: str) -> list[KeyPath]:
    """Where the file has the two coordinates of a place, and those of the frame's first point."""
    return [(*start, axis) for start in (path, ("frame", first)) for axis in (0, 1)]


@frozen
class GuideAngle:
    """The angle that a moving guide's line through `through` makes with corner -> through.

    symbol  γ, with the number of the link where several guides have such an angle; "" where another is given
    corner  the point about which the drawing turns the link, from which γ is counted
    """

    symbol: str
    corner: str
    through: str


def guide_angle(reading: Reading, slide: Slide) -> GuideAngle | None:
    """The angle at which a moving guide's line lies; None of one through two points, or that is the link itself."""
    corners = _corners(reading)
    if slide.name not in corners:
        return None
    corner, through = corners[slide.name], slide.line.origin
    alone = len({pair.guide for pair in reading.mechanism.slides if pair.name in corners}) == 1
    symbol = "γ" if alone else names.of_link("γ", reading.mechanism.called(slide.guide))
    return GuideAngle(symbol if slide.line.base in (None, (corner, through)) else "", corner, through)


@kept(2)  # each slide asks for all
def _corners(reading: Reading) -> dict[str, str]:
    """The points from which γ is counted, by slide."""
    return {pair.name: corner for pair in reading.mechanism.slides if (corner := _corner(reading, pair))}


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


# --- guides, wheels, drivers ------------------------------------------------------------------------------------------


def guide_sizes(reading: Reading) -> Iterator[Size]:
    """Places of lines in their links: `e_B = 20 mm` from the first fixed point, `γ = 100°`; tilts of blocks."""
    yield from _eccentricities(reading)
    machine, taken = reading.mechanism, set[str]()
    for pair in (pair for pair in machine.pairs if getattr(pair, "stands_for", None) is None):
        faces = [profile.line for profile in pair.profiles] if isinstance(pair, Cam) else list(pair.lines)
        for face, line in enumerate(faces):
            if line is not None and pair.table:
                path = (*machine.path(pair), *(("profiles", face) if isinstance(pair, Cam) else ()))
                for size in _inclination(reading, pair, line, path):  # a second line at a point is called by its link
                    other = names.of_link(size.symbol[0], machine.called(line.link))
                    yield replace(size, symbol=other) if size.symbol in taken else size
                    taken.add(size.symbol)
        if isinstance(pair, Slide) and round(degrees(pair.tilt), 6) % 90:
            shape = DrawnAngle(reading.at(pair.point), reading.guide(pair.name), pair.tilt, (pair.point,))
            path = (*machine.path(pair), "tilt")
            yield sized(reading, f"δ_{names.point(pair.point)}", pair.tilt, "angle", path, shape=shape)


def _eccentricities(reading: Reading) -> list[Size]:
    """Distances of fixed guides and tracks from the first fixed point; without such from the first that is parallel, or
    of the places where they begin from that of the first of all."""
    machine, fixed, every = reading.mechanism, reading.plot.facts.shapes[FRAME], list[Size]()
    letters = contact_letters(reading.method.structure)
    every_line: list[tuple[Slide | RollingContact, Line | None, str, str]] = [
        *((roll, roll.line, roll.centre, letters[roll.name]) for roll in machine.of(RollingContact)),
        *((slide, slide.line, slide.point, slide.point) for slide in machine.slides if slide.stands_for is None),
    ]
    lines = [(pair, line, point, name) for pair, line, point, name in every_line if line and line.link == FRAME]
    for pair, line, point, name in lines:
        along, place = line.direction, fixed[line.origin]
        points = machine.named(FRAME) or [one.origin for _, one, *_ in lines if aside(along, one.direction) < 1e-9][:1]
        if all(aside(along, place - fixed[other]) > reading.noise for other in points):
            end = place + along * float(dot(along, reading.at(point) - place))
            span = DrawnLength(fixed[points[0]], end, 1j * along, (points[0], point))
            path = (*machine.path(pair), "through")
            places = [*_coordinates(path, points[0]), *_coordinates(("frame", line.origin), points[0])]
            off, symbol = aside(along, place - fixed[points[0]]), f"e_{names.point(name)}"
            size = sized(reading, symbol, off, "length", *places, shape=span)
            size = replace(size, derived=abs(along.real * along.imag) > 1e-9, since=points[0])
            if not line.named and (pair.named or size.derived):
                stated = (1 + 0j, 1j) if size.derived else (1 + 0j if abs(along.real) > abs(along.imag) else 1j,)
                every += _start(reading, line, points[0], path, name, stated)
            every.append(size)
        elif machine.named(FRAME) and pair.named and not line.named:
            every += _start(reading, line, points[0], (*machine.path(pair), "through"), name)
        elif points == [line.origin] != [first := lines[0][1].origin]:
            every += _start(reading, line, first, (*machine.path(pair), "through"), name)
    return every


def _start(
    reading: Reading, line: Line, first: str, path: KeyPath, name: str, axes: tuple[complex, ...] = (1 + 0j, 1j)
) -> Iterator[Size]:
    """The coordinates of where a fixed line begins, from the first place on."""
    corner, place = (reading.plot.facts.shapes[FRAME][point] for point in (first, line.origin))
    for axis in axes:
        part, span = float(dot(axis, place - corner)), DrawnLength(corner, place, axis, (first, line.origin))
        if abs(part) > reading.noise:
            symbol = f"{'x' if axis.real else 'y'}_{names.point(name)},0"  # where its displacement is 0
            yield sized(reading, symbol, part, "length", *_coordinates(path, first), shape=span)


def stated_angle(reading: Reading, angle: float, path: KeyPath) -> float:
    """An angle [rad]; that of the file where it is the same direction."""
    stated = reading.mechanism.given.get(path)
    value = stated.si if stated is not None and stated.si is not None else angle
    return value if abs(rect(1, value) - rect(1, angle)) < 1e-6 else angle


def _inclination(reading: Reading, pair: Pair, line: Line, path: KeyPath) -> Iterator[Size]:
    """The angle of a line with +x, or with two points of its link; none of one that goes through two points."""
    start = reading.arm(*line.base) if line.base is not None and _placed(reading, line.base) else 1 + 0j
    turn = float(reading.plot.theta.get(line.link, 0.0))
    drawn = phase(line.direction * rect(1, turn) / start)
    angle = stated_angle(reading, drawn, (*path, "angle"))
    if (*path, "angle") not in reading.mechanism.given and line.link != FRAME:
        return
    if not round(degrees(angle), 6) % 90:
        return
    symbol = f"β_{names.point(pair.point if isinstance(pair, Slide) else line.origin)}"
    if isinstance(pair, Slide) and (of := guide_angle(reading, pair)) is not None and of.symbol:
        symbol = of.symbol
    at = line.origin if line.named or not isinstance(pair, Slide) else pair.point
    shape = DrawnAngle(reading.at(at), _unit(start), angle, (at,)) if at in reading.plot.position else None
    yield sized(reading, symbol, angle, "angle", (*path, "angle"), shape=shape)


def radii(reading: Reading, pair: Pair) -> list[Size]:
    """The radii of a pair's circles: `r2` of wheels, `r_P` of profiles and circular slots."""
    keys: list[KeyPath]
    match pair:
        case Gear():
            keys = [("radii", 0), ("radii", 1)]
        case RollingContact():
            keys = [("on_radius",), ("radius",)] if pair.line is None else [("radius",)]
        case Cam():
            rounds = (which for which, face in enumerate(pair.profiles) if face.centre is not None)
            keys = [("profiles", which, "radius") for which in rounds]
        case CircularSlot():
            keys = [("radius",)]
        case _:
            return []
    path = reading.mechanism.path(pair)
    circles = [(pair.guide, pair.centre, pair.radius)] if isinstance(pair, CircularSlot) else pair.circles
    return [_radius(reading, pair, *one, (*path, *key)) for one, key in zip(circles, keys, strict=True) if one[2]]


def _radius(reading: Reading, pair: Pair, link: str, centre: str, size: float, path: KeyPath) -> Size:
    symbol = reading.radius(link, size) if pair.rolling is not None else reading.circle(centre, size)
    at = reading.at(centre) if centre in reading.plot.position else None
    end = reading.at(pair.point) if isinstance(pair, CircularSlot) else (at or 0j) + size
    points = (centre, pair.point) if isinstance(pair, CircularSlot) else (centre,)
    shape = None if at is None else DrawnLength(at, end, _unit(end - at), points, "radius")
    return sized(reading, symbol, size, "length", path, shape=shape)


def driven(reading: Reading, k: int, driver: Driver) -> tuple[Size, Size, Size]:
    """The value of a driver, its rate, and the rate of that; counter-clockwise is positive."""
    facts, path = reading.plot.facts, ("driver", k)
    place, rate, more = (float(table[k]) for table in (facts.values, facts.rates, facts.accelerations))
    at = drawn_value(reading, driver, place, path)
    if driver.kind == "slide":
        first, second = (reading.slid(symbol, driver.link) for symbol in SIGNED)
        speed, change = (*path, "velocity"), (*path, "acceleration")
        return at, sized(reading, first, rate, "velocity", speed), sized(reading, second, more, "acceleration", change)
    return at, _rate(reading, driver, path, "ω", rate), _rate(reading, driver, path, "α", more)


SIGNED = ("ṡ", "s̈")  # by which a displacement grows; of all others a word or an arrow tells the sense

_RATES: Mapping[str, tuple[str, Dimension, str, Dimension]] = {
    "ω": ("omega", "angular velocity", "v", "velocity"), "α": ("alpha", "angular acceleration", "aᵗ", "acceleration"),
}  # fmt: skip
"""Of a rotation and of the tip of its vector: key, letter and dimension."""


def _rate(reading: Reading, driver: Driver, path: KeyPath, letter: str, value: float) -> Size:
    """Of a driven rotation; of the tip of its vector, where the file states that."""
    key, kind, tip, along = _RATES[letter]
    if driver.vector is not None and (*path, along) in reading.mechanism.given:
        turned = value * abs(reading.mechanism.links[driver.link].arm(*driver.vector))
        size = sized(reading, f"{tip}_{names.point(driver.vector[1])}", turned, along, (*path, along))
        symbol = reading.against(driver, letter)
        worked = sized(reading, f"{symbol} = {size.symbol}/l_{names.pair(*driver.vector)}", value, kind)
        told = f"{size.worked}{reading.say('common.and')}{worked.text}"
        return replace(size, value=worked.value, unit=worked.unit, worked=told)
    return sized(reading, reading.against(driver, letter), value, kind, (*path, key))


def drawn_value(reading: Reading, driver: Driver | Pose, value: float, path: KeyPath) -> Size:
    """The angle or the displacement of a driver or a pose."""
    if driver.kind == "slide":
        slot = reading.method.structure.slides[driver.link]
        pair, point = reading.mechanism.pair(driver.link), slot.point
        track = pair.line if isinstance(pair, RollingContact) and pair.line and pair.line.named else slot.line
        start = reading.at(track.origin)
        span = DrawnLength(start, reading.at(point), reading.guide(driver.link), (point,))
        size = sized(reading, names.of_slide("s", driver.link), value, "length", (*path, "at"), shape=span)
        return replace(size, since=track.origin)
    corner = None
    if driver.vector is not None:
        start = reading.arm(*driver.from_vector) if driver.from_vector is not None else 1 + 0j
        corner = DrawnAngle(reading.at(driver.vector[0]), _unit(start), fmod(value, tau), driver.vector)
    return sized(reading, reading.against(driver, "φ"), value, "angle", (*path, "angle"), shape=corner)


def _pose(reading: Reading, pose: Pose, path: KeyPath) -> Size:
    """A condition of the drawn position; at another one as the angle that is seen there, by its symbol alone."""
    size = drawn_value(reading, pose, pose.value, path)
    if isinstance(corner := size.shape, DrawnAngle) and pose.vector is not None:
        seen = phase(reading.arm(*pose.vector) / corner.start)
        if abs(rect(1, seen) - rect(1, corner.turn)) > 1e-6:
            return replace(size, moved=True, shape=replace(corner, turn=seen))
    return size


# --- all of them ------------------------------------------------------------------------------------------------------


def sizes(reading: Reading) -> list[Size]:
    """Every datum of the problem once: lengths and angles link by link, guides, wheels, the position, the drivers."""
    machine = reading.mechanism
    every = [*frame_sizes(reading), *(size for link in machine.moving for size in link_sizes(reading, link))]
    every += [*guide_sizes(reading), *(size for pair in machine.pairs for size in radii(reading, pair))]
    every += [_pose(reading, pose, ("pose", k)) for k, pose in enumerate(machine.poses)]
    for k, driver in enumerate(machine.drivers):
        place, *rates = driven(reading, k, driver)
        every += [place] if driver.value is not None else []
        kind: Dimension = "length" if driver.kind == "slide" else "angle"
        symbol = reading.say("sheet.also", symbol=place.symbol)
        now = float(reading.plot.facts.values[k])
        if also := [sized(reading, symbol, value, kind) for value in driver.also if abs(value - now) > 1e-9]:
            values = ", ".join(size.figure for size in also)  # which a sheet has little room for
            every.append(replace(also[0], value=1.0, written=values))
        every += [rate if rate.symbol.startswith(SIGNED) else rate.bare for rate in rates if rate.value]
    seen = (size for size in every if size.value or isinstance(size.shape, DrawnAngle))
    return [*{size.text: size for size in seen if not in_line(size)}.values()]


def in_line(size: Size) -> tuple[str, ...]:
    """The three points of an angle of 0 or 180 degrees, which a drawing shows; none of other data."""
    points = size.shape.points if isinstance(size.shape, DrawnAngle) and abs(sin(size.shape.turn)) < 1e-9 else ()
    return points if len(points) > 2 else ()


def measured_lengths(reading: Reading) -> list[tuple[str, str]]:
    """The distances by which rotations are found or sizes made that no link gives: they are measured in the drawing."""
    method, owners, levers = reading.method, reading.mechanism.owners, dict[tuple[str, str], None]()
    for step in (step for construction in (method.velocity, method.acceleration) for step in construction.steps):
        match step:
            case Measure(lever=lever):
                pass
            case LayOff(term=Term(size=Turning() | Normal() | Tangential() as size)):
                lever = ("", "") if reading.translates(size.link) else (size.tail, size.head)
            case _:
                continue
        if lever[0]:
            first, second = sorted(lever)
            if reading.named(first) and reading.named(second) and reading.distance(first, second):
                levers[first, second] = None
    stated = [size for pair in reading.mechanism.pairs for size in radii(reading, pair)]
    known = {(size.shape.points[0], round(size.value, 6)) for size in stated if size.shape is not None}
    # what two points of a link are apart is given, and how far from a centre its rim lies
    return [
        ends for ends in levers
        if not {*owners.get(ends[0], ())} & {*owners.get(ends[1], ())}
        and not any((end, round(1000 * reading.distance(*ends), 6)) in known for end in ends)
    ]  # fmt: skip


def length_size(reading: Reading, one: str, other: str) -> Size:
    """`l_BD = 69.2 mm`, of the mechanism itself, as it is measured."""
    length, unit = reading.distance(one, other), length_unit(reading.mechanism)
    start, end = reading.at(one), reading.at(other)
    span = DrawnLength(start, end, _unit(end - start), (one, other), "measured")
    written = f"{number(in_unit(length, unit, 'length'))} {unit}"
    return Size(f"l_{names.pair(one, other)}", length * 1000, "mm", written, shape=span, derived=True)


def dimensions(reading: Reading) -> list[str]:
    """`l_AB = 24 mm`, `φ1 = 60°`, .. in text."""
    return [size.text for size in sizes(reading)]
