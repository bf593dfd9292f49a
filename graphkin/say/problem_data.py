"""The head of a derivation: the title, the data of the problem in sentences, and the scales of the paper."""

from __future__ import annotations

from cmath import phase, rect
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from functools import partial
from itertools import combinations
from math import degrees, pi, remainder

from graphkin.base.geometry import dot
from graphkin.construction import Plane
from graphkin.model.mechanism import FRAME, Driver, KeyPath, Pose
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, Pair, RollingContact, Slide
from graphkin.say import names
from graphkin.say.dimensions import (
    SIGNED,
    beside,
    drawn_value,
    driven,
    guide_angle,
    in_line,
    link_sizes,
    radii,
    stated_angle,
)  # fmt: skip
from graphkin.say.entry import Entry, Heading, Sentence
from graphkin.say.equivalents import points_of
from graphkin.say.numbers import direction, given_figure, heading, inclination, number
from graphkin.say.reading import Reading, aside, capitalized
from graphkin.say.sizes import Size, length_unit, sized
from graphkin.say.structure import redundant_constraints

_SCALES = (("length", "μ_l", "m/mm"), ("velocity", "μ_v", "(m/s)/mm"), ("acceleration", "μ_a", "(m/s²)/mm"))
"""Each scale of the paper with its symbol and its unit."""


def problem_data(reading: Reading) -> Iterator[Entry]:
    """The title, the story of the file, and what is given: links, pairs, drivers, the drawn position."""
    between = reading.say("common.semicolon")
    yield Heading(reading.mechanism.headline(reading.lang))
    yield from (Sentence(text) for text in [reading.mechanism.story(reading.lang)] if text)
    yield Heading(reading.say("solution.given"))
    yield from map(Sentence, _dimensions(reading))
    drivers = [_driver(reading, k, driver) for k, driver in enumerate(reading.mechanism.drivers)]
    yield Sentence(reading.say("derivation.given", drivers=between.join(drivers), which=int(len(drivers) > 1)))
    if reading.mechanism.poses:
        poses = []  # conditions that held when the mechanism was drawn
        for k, pose in enumerate(reading.mechanism.poses):
            value = drawn_value(reading, pose, pose.value, ("pose", k))
            if pose.vector is None:
                words = {"slide": reading.slide_name(pose.link), "place": value.whole}
                key = f"derivation.driven {_kind(reading, pose.link)}"
            else:
                angle = f"{value.figure}{value.worked}"
                words = {"angle": angle, "heading": heading(angle, reading.lang), **_turned(reading, pose)}
                key = "derivation.pose line" if pose.from_vector is None else "derivation.pose joint"
            poses.append(reading.say(key, which=words.get("line") == words.get("link"), **words))
        yield Sentence(reading.say("derivation.posed", poses=between.join(poses)))


def solution_head(reading: Reading, drawn: Collection[str], leaves_out: bool) -> Iterator[Entry]:
    """The head of the solution itself: what plays no part in it, and the paper's scales.

    drawn       the names of those scales that are used
    leaves_out  some steps of the drawing are not told
    """
    yield Heading(reading.say("solution.solution"))
    if idle := reading.mechanism.idle:
        yield Sentence(reading.say("derivation.idle", links=reading.links(idle)))
    for line in redundant_constraints(reading.method, reading.lang):
        yield Sentence(reading.say("derivation.redundant", line=line))
    scales = [f"{symbol} = {number(reading.scales[key])} {unit}" for key, symbol, unit in _SCALES if key in drawn]
    yield Sentence(reading.say("derivation.scales", scales=reading.joined(scales)))
    yield Sentence(reading.say("derivation.by hand" if reading.ruler else "derivation.exactly"))
    if leaves_out:
        yield Sentence(reading.say("derivation.numbers left out"))


def _turned(reading: Reading, turned: Driver | Pose) -> dict[str, str]:
    """The link that is turned, its line by two points in their order, and what its angle is measured from."""
    words = {"link": reading.link(turned.link)}
    if turned.vector is not None:
        words["line"] = "".join(map(names.point, turned.vector))
    if turned.from_vector is not None:
        words |= {"other": "".join(map(names.point, turned.from_vector)), "seen_from": reading.link(turned.from_link)}
    return words


def _kind(reading: Reading, slide: str) -> str:
    """A sliding pair or a rolling contact."""
    return "roll" if slide in reading.contact_slides else "slide"


def _driver(reading: Reading, k: int, driver: Driver) -> str:
    """A driven line or slide, its value, and its rates; no angle of a wheel, or of a line that a pose has fixed."""
    place, *rates = driven(reading, k, driver)
    now, drawn = (float(facts.values[k]) for facts in (reading.plot.facts, reading.method.facts()))
    shown = None if driver.value is None and abs(now - drawn) < 1e-12 else place
    if driver.kind == "slide":
        kind, slide = _kind(reading, driver.link), reading.slide_name(driver.link)
        if shown is None:
            start = reading.say(f"derivation.driven {kind} free", slide=slide)
        else:
            start = reading.say(f"derivation.driven {kind}", slide=slide, place=shown.whole)
        planes: tuple[Plane, ...] = ("velocity", "acceleration")
        return reading.joined([start, *map(partial(_slid, reading, driver.link), planes, rates)])
    texts = [_rated(size, reading.note(reading.sense(size.value))) for size in rates]
    if driver.vector is None or shown is None:
        key = "derivation.driven wheel" if driver.vector is None else "derivation.driven line free"
    elif driver.from_vector is not None:
        key = "derivation.driven joint"
    else:
        key = "derivation.driven link" if shown.value else "derivation.driven along x"
    words = _turned(reading, driver) | ({"angle": shown.whole} if shown is not None else {})
    return reading.joined([reading.say(key, which=words.get("line") == words["link"], **words), *texts])


def _slid(reading: Reading, slide: str, plane: Plane, size: Size) -> str:
    """The rate of a driven slide: with its sign as it is called `ṡ_ram`, else in the sense in which s_ram changes, or
    towards which it is changed."""
    if size.symbol.startswith(SIGNED):
        return size.whole if size.value else f"{size.symbol} = 0"
    words = {"s": names.of_slide("s", slide), "which": size.value < 0}
    return _rated(size, reading.note(reading.say(f"derivation.slide sense {plane}", **words)))


def _rated(size: Size, sense: str) -> str:
    """`ω1 = 60 r/min (clockwise), ..`; nothing has no sense."""
    return f"{size.bare.text}{sense}{size.bare.worked}" if size.value else f"{size.symbol} = 0"


def _dimensions(reading: Reading) -> Iterator[str]:
    """A sentence each: lengths, fixed points, guides, rolling circles, profiles."""
    say, mechanism = reading.say, reading.mechanism
    placed = [link for link in mechanism.moving if _by_coordinates(reading, link)]
    measured = [link for link in mechanism.moving if link not in placed]
    stated = [(link, size) for link in measured for size in link_sizes(reading, link)]
    if lengths := [size.whole for _, size in stated if not in_line(size)]:
        yield say("solution.lengths", lengths=reading.joined(lengths))
    if lines := [_on_line(reading, link, on) for link, size in stated if (on := in_line(size))]:
        yield say("solution.on lines", lines=reading.joined(lines))
    shapes = [reading.way_round(*corners) for link in measured for corners in beside(reading, link)]
    if shapes:
        yield say("solution.lettered", shapes=reading.joined(shapes))
    for link in (*placed, FRAME):
        path = ("frame",) if link == FRAME else ("links", link, "shape")
        words = {"link": names.point(mechanism.called(link)), "unit": (unit := length_unit(mechanism))}
        places = _as_typed(reading, link, path)
        points = [names.point(p) + _place(reading, place, (*path, p), unit) for p, place in places.items()]
        key = "solution.shape" if link in placed else "solution.frame points" if points else "solution.frame"
        own = link == FRAME and words["link"] == say("linkages.frame")  # it says itself what it is
        if points or not own:
            yield say(key, points=reading.joined(points), which=int(own), **words)
    for kind, sentence in PAIR_SENTENCES.items():
        for pair in mechanism.of(kind):
            yield sentence(reading, pair)


def _on_line(reading: Reading, link: str, points: Collection[str]) -> str:
    """`P lies on AB produced`: the last of three points on a line of a link, by the two before it."""
    first, second, last = (point for point in reading.mechanism.named(link) if point in points)
    part = (reading.arm(first, last) / reading.arm(first, second)).real
    ends = (first, second) if part > 0 else (second, first)
    within = 0 < part < 1
    words = {"point": names.point(last), "line": names.pair(*ends) if within else names.stretch(*ends)}
    return reading.say("solution.on line", which=int(within), **words)


def _by_coordinates(reading: Reading, link: str) -> bool:
    """True of a link that the file has by coordinates, which are not just lengths from the first point on one axis."""
    if (path := ("links", link, "shape")) not in reading.mechanism.given:
        return False
    first, *others = _as_typed(reading, link, path).values()
    on_axis = (all(abs(at) - float(dot(axis, at)) <= reading.noise for at in others) for axis in (1 + 0j, 1j))
    return abs(first) > reading.noise or not any(on_axis)


def _as_typed(reading: Reading, link: str, path: KeyPath) -> dict[str, complex]:
    """The points of a link that have letters, in the axes of its file: the link's own begin along its first arm."""
    places = {point: reading.mechanism.links[link].points[point] for point in reading.mechanism.named(link)}
    if link == FRAME or (axis := reading.mechanism.links[link].axis) is None:
        return places
    start, end = (complex(*(reading.mechanism.given[*path, p, k].si or 0.0 for k in (0, 1))) for p in axis)
    return {p: start + (place - places[axis[0]]) * rect(1, phase(end - start)) for p, place in places.items()}


def _place(reading: Reading, place: complex, path: KeyPath, told: str = "") -> str:
    """Coordinates of the mechanism itself as the file states them, `(−4, 2) ft`; without the unit that is `told`."""
    axes = [sized(reading, "", part, "length", (*path, k)) for k, part in enumerate((place.real, place.imag))]
    unit = next((axis.figure.split()[-1] for axis in axes if axis.value), told or length_unit(reading.mechanism))
    x, y = (axis.figure.removesuffix(f" {unit}") if axis.value else "0" for axis in axes)
    return reading.say("common.place", x=x, y=y) + f" {unit}" * (unit != told)


def _angle(reading: Reading, turned: float, path: KeyPath, signed: bool = False) -> str:
    """`30°`: as the file states it where it is that, mostly without the sign, as words tell the sense."""
    size = sized(reading, "", stated_angle(reading, turned, path), "angle", path)
    return (size if signed else size.bare).figure


def _start(reading: Reading, line: Line, path: KeyPath) -> str:
    """Where a line begins, and the displacement along it is 0: by its letter, else by its coordinates."""
    place = reading.mechanism.links[line.link].points.get(line.origin)
    named = line.named or place is None
    return names.point(line.origin) if named else _place(reading, place or 0j, (*path, "through"))


def _begins(reading: Reading, line: Line, path: KeyPath, told: str) -> str:
    """The same behind what is told of the line: its coordinates are not said twice."""
    start = _start(reading, line, path)
    return reading.say("solution.there") if not line.named and start in told else start


def _slide(reading: Reading, pair: Slide) -> str:
    """The block and the guide on which it slides, by what the file says of the line."""
    words = {"block": reading.link(pair.block) if pair.block is not None else "", "point": names.point(pair.point)}
    words |= {"guide": "", "tilt": ""}
    path = reading.mechanism.path(pair)
    where = _lying(reading, pair.line, path, pair)
    if pair.named:  # ` (ram, displacement s_ram from C)`: the file's name of the pair, where its block is not called so
        title, s = reading.slide_name(pair.name), names.of_slide("s", pair.name)
        notes = [] if pair.block is not None and reading.link(pair.block) == title else [title]
        start, told = _begins(reading, pair.line, path, where), s in where  # its displacement, with the line
        if not told and start == reading.say("solution.there"):
            where += reading.say("solution.displacement on line", s=s, start=start, centre=words["point"])
        elif not told:
            notes.append(reading.say("solution.displacement", s=s, start=start))
        words["guide"] = reading.note(reading.joined(notes)) if notes else ""
    if axis := _axis(reading, pair):  # `; the direction of A→B is the guide's turned by 30° ..`
        turned = remainder(round(degrees(pair.tilt), 9), 360)
        angle = {"angle": _angle(reading, pair.tilt, (*path, "tilt")), "sense": reading.sense(turned)}
        kind = " half" if abs(turned) == 180 else "" if turned else " none"
        words["tilt"] = reading.say(f"solution.tilt{kind}", line=axis, **angle)
    kind = "pin" if pair.block is None else "block"
    if pair.guide == FRAME:
        return reading.say(f"solution.{kind} on frame", line=where, **words)
    return reading.say(f"solution.{kind} on link", link=reading.link(pair.guide), where=where, **words)


def _axis(reading: Reading, pair: Slide) -> str:
    """The direction of a block: of its points, +x of the frame, of one point that slid before the line it slid on."""
    if pair.block is None or pair.block == FRAME:
        return "+x" if pair.block else ""
    if (axis := reading.mechanism.links[pair.block].axis) is not None:
        return names.arrow(*axis)
    first = next(slide for slide in reading.mechanism.slides if slide.block == pair.block)
    return "" if first.name == pair.name else reading.say("derivation.guide of link", link=reading.link(first.guide))


def _circular_slot(reading: Reading, pair: CircularSlot) -> str:
    words = {"pin": names.point(pair.point), "centre": names.point(pair.centre), "link": reading.link(pair.guide)}
    return reading.say("solution.circular slot", radius=radii(reading, pair)[0].whole, **words)


def _gears(reading: Reading, pair: Gear) -> str:
    words = {"wheels": reading.links(pair.links), "centres": reading.listed([*map(names.point, pair.centres)])}
    words["radii"] = reading.joined(size.whole for size in radii(reading, pair))
    return reading.say("solution.gears", which=pair.internal, **words)


def _rolling(reading: Reading, pair: RollingContact) -> str:
    words = {"wheel": reading.link(pair.wheel), "centre": names.point(pair.centre), "track": reading.link(pair.track)}
    *tracks, rim = radii(reading, pair)
    words["radius"] = rim.whole
    if pair.line is None:
        about = names.point(pair.track_centre or "")
        other = tracks[0].whole
        where = reading.say("solution.touch", which=pair.internal)
        return reading.say("solution.rolls on circle", about=about, other=other, where=where, **words)
    path = reading.mechanism.path(pair)
    track = _track(reading, pair.line, path)
    side = reading.say("solution.wheel side", which=not pair.left, centre=words["centre"])
    if pair.named:  # `; s_wheel is the displacement of C along it from E`
        start, s = _begins(reading, pair.line, path, track), names.of_slide("s", pair.name)
        side += reading.say("solution.displacement on line", s=s, start=start, centre=words["centre"])
    return reading.say("solution.rolls on line", line=track, side=side, **words)


def _cam(reading: Reading, pair: Cam) -> str:
    texts, sizes = [], iter(radii(reading, pair))
    whose = zip(pair.profiles, pair.links, reversed(pair.profiles), strict=True)
    for k, (profile, member, facing) in enumerate(whose):
        link, centre = reading.link(member), names.point(profile.centre or "")
        if profile.line is not None:
            other = names.point(facing.centre or "")
            side = reading.say("solution.wheel side", which=not profile.left, centre=other)
            line = _track(reading, profile.line, (*reading.mechanism.path(pair), "profiles", k))
            texts.append(reading.say("solution.flat face", link=link, line=line, side=side))
        elif not profile.radius:
            texts.append(reading.say("solution.knife edge", link=link, point=centre))
        else:
            texts.append(reading.say("solution.circle", link=link, centre=centre, radius=next(sizes).whole))
    where = reading.say("solution.touch", which=pair.internal)
    touch = reading.note(where) if all(profile.radius for profile in pair.profiles) else ""
    return reading.say("solution.cam", first=capitalized(texts[0]), second=texts[1], where=touch)


PAIR_SENTENCES: Mapping[type[Pair], Callable[..., str]] = {
    Slide: _slide, CircularSlot: _circular_slot, Gear: _gears, RollingContact: _rolling, Cam: _cam,
}  # fmt: skip
"""The sentence of each kind that is no hinge, in this order."""


def _track(reading: Reading, line: Line, path: KeyPath) -> str:
    """` B→Q`, ` (through D at 30° to E→F)`: where a line lies in its link, and which way it points."""
    ends = _points_along(reading, line)
    return f" {names.arrow(*ends)}" if ends else reading.note(_lying(reading, line, path))


def _lying(reading: Reading, line: Line, path: KeyPath, slide: Slide | None = None) -> str:
    """`along DE`, `through C that makes γ = 100° with D→C (..)`, `through (0, 10), vertically upwards`."""
    angle = guide_angle(reading, slide) if slide is not None else None
    either = slide is not None and not slide.named and not _axis(reading, slide)
    through, stated = _start(reading, line, path), (*path, "angle")
    for _ in reading.mechanism.links:  # of one point: in the guide on which it slides without turning
        held = next((slide for slide in reading.mechanism.slides if slide.block == line.link), None)
        if line.link == FRAME or len(reading.mechanism.links[line.link].points) > 1 or held is None:
            break
        line = replace(line, link=held.guide, direction=line.direction * held.line.direction)
    if ends := _points_along(reading, line):
        return reading.say("solution.along", line=(names.pair if either else names.arrow)(*ends))
    if line.base is None and line.link == FRAME:
        along = f"{given_figure(direction(line.direction))}°"
        if direction(line.direction) % 90:
            along = _angle(reading, phase(line.direction), stated, signed=True)
        if either:
            return reading.say("solution.line", start=through, heading=inclination(along, reading.lang))
        counted = names.of_slide("s", slide.name) if slide is not None and slide.named else ""
        key = "solution.line counted" if counted else "solution.line"
        return reading.say(key, start=through, heading=heading(along, reading.lang), s=counted)
    shape, points = reading.mechanism.links[line.link], reading.mechanism.named(line.link)
    apart = (ends for ends in combinations(points, 2) if abs(shape.arm(*ends)) > reading.noise)
    # where no file says it, a line is measured from the points of γ, else from the link's first
    base = line.base or (next(apart, None) if angle is None else (angle.corner, angle.through))
    if base is None:
        return reading.say("solution.own axis", through=through)
    turned = stated_angle(reading, phase(line.direction / shape.arm(*base)), stated)
    symbol = f"{angle.symbol} = " if angle is not None and angle.symbol else ""
    words = {"through": through, "arrow": names.arrow(*base), "angle": symbol + _angle(reading, turned, stated)}
    key = "solution.at angle" if abs(remainder(turned, 2 * pi)) > 1e-9 else "solution.parallel"
    return reading.say(key, sense=reading.sense(turned), **words)


def _points_along(reading: Reading, line: Line) -> tuple[str, str] | None:
    """Two points on a line, in its direction: those from which the file measures it, else any of its moving link."""
    link = reading.mechanism.links[line.link]
    if line.base is None or not {line.origin, *line.base} <= link.points.keys():
        return points_of(reading, line) if line.origin in link.points else None
    on_it = all(aside(line.direction, link.arm(line.origin, end)) <= reading.noise for end in line.base)
    return line.base if on_it and dot(line.direction, link.arm(*line.base)) > 0 else None
