"""What a problem gives of the links themselves, in sentences: lengths, guides, radii."""

from __future__ import annotations

from cmath import phase
from collections.abc import Callable, Iterator, Mapping
from math import degrees as in_degrees
from math import remainder
from typing import Any

from graphkin.mechanism import FRAME
from graphkin.pairs import Cam, CircularSlot, Gear, Line, Pair, Roll, Slide
from graphkin.say import names
from graphkin.say.equivalents import points_of
from graphkin.say.given_sizes import Size, beside, circle, millimetres, radius, sides
from graphkin.say.guide_angle import guide_angle
from graphkin.say.numbers import degrees, given
from graphkin.say.reading import Reading


def dimensions(reading: Reading) -> Iterator[str]:
    """A sentence each: lengths, fixed points, guides, rolling circles, profiles."""
    say, also = reading.say, reading.say("common.and")
    if lengths := list(_lengths(reading)):
        yield say("solution.lengths", lengths=also.join(lengths))
    if shapes := list(_senses(reading)):
        yield say("solution.lettered", shapes=also.join(shapes))
    shape, frame = reading.mechanism.links[FRAME].points, names.point(reading.mechanism.called(FRAME))
    fixed = [f"{names.point(p)}{_place(reading, shape[p])}" for p in reading.mechanism.named(FRAME)]
    yield say("solution.frame points" if fixed else "solution.frame", link=frame, points=also.join(fixed))
    for kind, tell in GIVEN.items():
        for pair in reading.mechanism.of(kind):
            yield tell(reading, pair)


# --- links --------------------------------------------------------------------------------------


def _lengths(reading: Reading) -> Iterator[str]:
    """`l_AB = 24 mm` of every bar; of a link of more points the sides that fix it, each once."""
    for link in reading.mechanism.moving:
        for side in sides(reading, link):
            yield Size(f"l_{side.name}", millimetres(reading, side.length), "mm").text


def _senses(reading: Reading) -> Iterator[str]:
    """`B→C→E counter-clockwise` of every further point that is not in line with the first two."""
    for link in reading.mechanism.moving:
        yield from (reading.way_round(corners, ccw) for corners, ccw in beside(reading, link))


# --- pairs --------------------------------------------------------------------------------------


def _slide(reading: Reading, pair: Slide) -> str:
    """Which block slides where, by what the file says of the line."""
    link = reading.link(pair.block) if pair.block is not None else ""
    words = {"block": link, "point": names.point(pair.point), "guide": _guide(reading, pair)}
    kind = "pin" if pair.block is None else "block"
    words["tilt"] = _tilt(reading, pair)
    if pair.guide == FRAME:
        return reading.say(f"solution.{kind} on frame", line=_line(reading, pair.line), **words)
    where = _on_link(reading, pair)
    return reading.say(f"solution.{kind} on link", link=reading.link(pair.guide), where=where, **words)


def _tilt(reading: Reading, pair: Slide) -> str:
    """`; AB makes 30 deg with the guide` of a block of more points than one."""
    points = reading.mechanism.named(pair.block) if pair.block is not None else ()
    if len(points) < 2:
        return ""
    line, turned = names.arrow(*points[:2]), remainder(round(in_degrees(pair.tilt), 9), 360)
    sense = reading.say("common.ccw" if turned > 0 else "common.cw")
    words = {"line": line, "angle": f"{given(abs(turned))}°", "sense": sense}
    return reading.say("solution.tilt" if turned else "solution.tilt none", **words)


def _guide(reading: Reading, pair: Slide) -> str:
    """` (ram, displacement s_ram)`: what the file calls the pair, where its block is not called so."""
    if not pair.named:
        return ""
    own = pair.block is not None and reading.link(pair.block) == reading.slide_name(pair.name)
    note = reading.say("solution.displacement", s=names.of_slide("s", pair.name))
    name = [] if own else [reading.slide_name(pair.name)]
    return reading.say("common.note", note=reading.say("common.and").join([*name, note]))


def _on_link(reading: Reading, pair: Slide) -> str:
    if (angle := guide_angle(reading, pair)) is not None:
        size = f"{angle.symbol} = {given(abs(in_degrees(angle.angle)))}°"
        sense = reading.say("common.ccw" if angle.angle > 0 else "common.cw")
        through = names.point(angle.through)
        return reading.say("solution.at angle", through=through, arrow=angle.arrow, angle=size, sense=sense)
    if (two := reading.points_on(pair.name)) and all(p in reading.mechanism.named(pair.guide) for p in two):
        return reading.say("solution.along", line=names.pair(*two))
    origin = pair.line.origin
    return reading.say("solution.own axis", through=names.point(origin)) if reading.named(origin) else ""


def _line(reading: Reading, line: Line) -> str:
    place = reading.mechanism.links[FRAME].points[line.origin]
    start = names.point(line.origin) if line.named else _place(reading, place)
    return reading.say("solution.line", start=start, angle=degrees(line.direction))


def _circular(reading: Reading, pair: CircularSlot) -> str:
    words = {"pin": names.point(pair.point), "centre": names.point(pair.centre), "link": reading.link(pair.guide)}
    return reading.say("solution.circular slot", radius=circle(reading, pair.centre, pair.radius).text, **words)


def _gear(reading: Reading, pair: Gear) -> str:
    sizes = zip(pair.links, pair.radii, strict=True)
    radii = [radius(reading, link, size).text for link, size in sizes]
    key = "solution.internal gears" if pair.internal else "solution.gears"
    return reading.say(key, wheels=reading.listed([reading.link(link) for link in pair.links]),
                       radii=reading.say("common.and").join(radii))  # fmt: skip


def _roll(reading: Reading, pair: Roll) -> str:
    words = {"wheel": reading.link(pair.wheel), "centre": names.point(pair.centre), "track": reading.link(pair.track)}
    words["radius"] = radius(reading, pair.wheel, pair.radius).text
    if pair.line is None:
        about = names.point(pair.track_centre or "")
        other = radius(reading, pair.track, pair.track_radius).text
        where = reading.say("solution.inside" if pair.internal else "solution.outside")
        return reading.say("solution.rolls on circle", about=about, other=other, where=where, **words)
    side = reading.say("solution.wheel left" if pair.left else "solution.wheel right", centre=words["centre"])
    return reading.say("solution.rolls on line", line=_track(reading, pair.line), side=side, **words)


def _track(reading: Reading, line: Line) -> str:
    """` B→Q`, ` (through D at 30° to E→F)`: where a line lies in its link, and which way it points."""
    if line.link == FRAME:
        return reading.say("common.note", note=_line(reading, line))
    if ends := points_of(reading, line):
        return f" {names.arrow(*ends)}"
    link, points = reading.mechanism.links[line.link], reading.mechanism.named(line.link)
    arms = ((one, p) for one in points[:1] for p in points[1:] if abs(link.arm(one, p)) > reading.noise)
    through = names.point(line.origin) if line.named else ""
    for first, second in arms:
        turned = float(in_degrees(phase(line.direction / link.arm(first, second))))
        size, sense = f"{given(abs(turned))}°", reading.say("common.ccw" if turned > 0 else "common.cw")
        words = {"through": through, "arrow": names.arrow(first, second), "angle": size, "sense": sense}
        return reading.say("common.note", note=reading.say("solution.at angle", **words))
    return reading.say("common.note", note=reading.say("solution.own axis", through=through)) if through else ""


def _cam(reading: Reading, pair: Cam) -> str:
    one, other = (_profile(reading, pair, k) for k in (0, 1))
    one = one[0].upper() + one[1:]
    return reading.say("solution.cam", first=one, second=other)


def _profile(reading: Reading, pair: Cam, k: int) -> str:
    profile, link = pair.profiles[k], reading.link(pair.links[k])
    if profile.line is not None:
        centre = names.point(pair.profiles[1 - k].centre or "")
        side = reading.say("solution.wheel left" if profile.left else "solution.wheel right", centre=centre)
        return reading.say("solution.flat face", link=link, line=_track(reading, profile.line), side=side)
    centre = names.point(profile.centre or "")
    if not profile.radius:
        return reading.say("solution.knife edge", link=link, point=centre)
    return reading.say("solution.circle", link=link, centre=centre,
                       radius=circle(reading, profile.centre or "", profile.radius).text)  # fmt: skip


GIVEN: Mapping[type[Pair], Callable[[Reading, Any], str]] = {
    Slide: _slide,
    CircularSlot: _circular,
    Gear: _gear,
    Roll: _roll,
    Cam: _cam,
}
"""What is given of each kind that is no hinge, in this order."""


def _place(reading: Reading, place: complex) -> str:
    """Coordinates of the mechanism itself, in mm."""
    x, y = (given(millimetres(reading, value)) for value in (place.real, place.imag))
    return f"({x}, {y})"
