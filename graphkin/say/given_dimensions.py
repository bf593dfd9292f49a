"""What a problem gives of the links themselves, in sentences: lengths, guides, radii."""

from __future__ import annotations

from cmath import phase
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import combinations
from math import degrees as in_degrees
from math import remainder
from typing import Any

from graphkin.base.geometry import cross, dot
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, Pair, RollingContact, Slide
from graphkin.say import names
from graphkin.say.equivalents import points_of
from graphkin.say.given_sizes import Size, beside, circle, millimetres, radius, sides
from graphkin.say.guide_angle import GuideAngle, guide_angle
from graphkin.say.numbers import direction, given
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
        return reading.say(f"solution.{kind} on frame", line=_lying(reading, pair.line, pair), **words)
    where = _lying(reading, pair.line, pair)
    return reading.say(f"solution.{kind} on link", link=reading.link(pair.guide), where=where, **words)


def _tilt(reading: Reading, pair: Slide) -> str:
    """`; the direction of A→B is the guide's turned by 30° ..`, of a block with a direction of its own."""
    if not (line := _axis(reading, pair)):
        return ""
    turned = remainder(round(in_degrees(pair.tilt), 9), 360)
    sense = reading.say("common.ccw" if turned > 0 else "common.cw")
    words = {"line": line, "angle": f"{given(abs(turned))}°", "sense": sense}
    return reading.say("solution.tilt" if turned else "solution.tilt none", **words)


def _axis(reading: Reading, pair: Slide) -> str:
    """The direction of a block: of its points, +x of the frame, of one point that slid before the line it slid on."""
    if pair.block is None or pair.block == FRAME:
        return "+x" if pair.block else ""
    if (axis := reading.mechanism.links[pair.block].axis) is not None:
        return names.arrow(*axis)
    first = next(slide for slide in reading.mechanism.slides if slide.block == pair.block)
    return "" if first.name == pair.name else reading.say("solution.line of", link=reading.link(first.guide))


def _guide(reading: Reading, pair: Slide) -> str:
    """` (ram, displacement s_ram)`: what the file calls the pair, where its block is not called so."""
    if not pair.named:
        return ""
    own = pair.block is not None and reading.link(pair.block) == reading.slide_name(pair.name)
    note = reading.say("solution.displacement", s=names.of_slide("s", pair.name))
    name = [] if own else [reading.slide_name(pair.name)]
    return reading.say("common.note", note=reading.say("common.and").join([*name, note]))


def _circular(reading: Reading, pair: CircularSlot) -> str:
    words = {"pin": names.point(pair.point), "centre": names.point(pair.centre), "link": reading.link(pair.guide)}
    return reading.say("solution.circular slot", radius=circle(reading, pair.centre, pair.radius).text, **words)


def _gear(reading: Reading, pair: Gear) -> str:
    radii = [radius(reading, link, size).text for link, _, size in pair.circles]
    centres = reading.listed([names.point(centre) for centre in pair.centres])
    key = "solution.internal gears" if pair.internal else "solution.gears"
    return reading.say(key, wheels=reading.listed([reading.link(link) for link in pair.links]), centres=centres,
                       radii=reading.say("common.and").join(radii))  # fmt: skip


def _roll(reading: Reading, pair: RollingContact) -> str:
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
    ends = _along(reading, line)
    return f" {names.arrow(*ends)}" if ends else reading.say("common.note", note=_lying(reading, line))


def _lying(reading: Reading, line: Line, slide: Slide | None = None) -> str:
    """`along DE`, `through C that makes γ = 100° with D→C (..)`, `through (0, 10) at 0° to +x`."""
    angle = guide_angle(reading, slide) if slide is not None else None
    either = slide is not None and not slide.named and not _axis(reading, slide)
    place, line = reading.mechanism.links[line.link].points.get(line.origin), _carried(reading, line)
    through = names.point(line.origin) if line.named or place is None else _place(reading, place)
    if ends := _along(reading, line):
        return reading.say("solution.along", line=(names.pair if either else names.arrow)(*ends))
    if line.base is None and line.link == FRAME:
        return reading.say("solution.line", start=through, angle=f"{given(direction(line.direction))}°")
    if (base := line.base or _base(reading, line.link, angle)) is None:
        return reading.say("solution.own axis", through=through)
    turned = in_degrees(phase(line.direction / reading.mechanism.links[line.link].arm(*base)))
    sense = reading.say("common.ccw" if turned > 0 else "common.cw")
    symbol = f"{angle.symbol} = " if angle is not None and angle.symbol else ""
    words = {"through": through, "arrow": names.arrow(*base), "angle": f"{symbol}{given(abs(turned))}°", "sense": sense}
    return reading.say("solution.at angle" if abs(turned) > 1e-9 else "solution.parallel", **words)


def _base(reading: Reading, link: str, angle: GuideAngle | None) -> tuple[str, str] | None:
    """Two points from whose direction a line is measured where no file says it: those of γ, else the link's first."""
    if angle is not None:
        return angle.corner, angle.through
    shape, points = reading.mechanism.links[link], reading.mechanism.named(link)
    return next((ends for ends in combinations(points, 2) if abs(shape.arm(*ends)) > reading.noise), None)


def _along(reading: Reading, line: Line) -> tuple[str, str] | None:
    """Two points on a line, in its direction: those from which the file measures it, else any of its moving link."""
    link = reading.mechanism.links[line.link]
    if line.base is None or line.origin not in link.points:
        return points_of(reading, line) if line.origin in link.points else None
    on_it = all(abs(cross(line.direction, link.arm(line.origin, end))) <= reading.noise for end in line.base)
    return line.base if on_it and dot(line.direction, link.arm(*line.base)) > 0 else None


def _carried(reading: Reading, line: Line) -> Line:
    """The line of a link of one point in the guide along which it slides, against which it does not turn."""
    for _ in reading.mechanism.links:
        held = next((slide for slide in reading.mechanism.slides if slide.block == line.link), None)
        if line.link == FRAME or len(reading.mechanism.links[line.link].points) > 1 or held is None:
            break
        line = replace(line, link=held.guide, direction=line.direction * held.line.direction)
    return line


def _cam(reading: Reading, pair: Cam) -> str:
    one, other = (_profile(reading, pair, k) for k in (0, 1))
    one = one[0].upper() + one[1:]
    where = reading.say("solution.inside" if pair.internal else "solution.outside")
    round_both = all(profile.radius for profile in pair.profiles)
    touch = reading.say("common.note", note=where) if round_both else ""
    return reading.say("solution.cam", first=one, second=other, where=touch)


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
    RollingContact: _roll,
    Cam: _cam,
}
"""What is given of each kind that is no hinge, in this order."""


def _place(reading: Reading, place: complex) -> str:
    """Coordinates of the mechanism itself, in mm."""
    x, y = (given(millimetres(reading, value)) for value in (place.real, place.imag))
    return f"({x}, {y})"
