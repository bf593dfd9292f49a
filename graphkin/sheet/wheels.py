"""Wheels, cams and circular slots: pitch circles, profiles, followers, and lower-pair equivalents in dashes."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

from graphkin.base.geometry import Value, place
from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import spelled
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, Pair, Rod, RollingContact, Slide, Slot, rod_name
from graphkin.sheet import symbols
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import link_label
from graphkin.sheet.marks import Disc, Mark, Place, Shows, Stroke
from graphkin.sheet.skeleton import OVERRUN, Skeleton, off_stretch
from graphkin.sheet.window import Figure

_RIM = 3.0  # thickness of a ring's rim [mm]
_CROSS = 4.4
_TOOTH, _DEPTH = 3.4, 0.95  # from tooth to tooth of those that are shown, and half as high as they are [mm]
_SMALL = 9.0  # in a wheel of less radius there is no room for its number [mm]
_REACH = 14.0  # how far a slot of the equivalent goes to both sides of its block [mm]
_ROD, _BUSH = 34.0, (15.0, 27.0)
"""A follower's rod from its tip, and where it is guided [mm]."""
_STEEP = 0.2  # a face and the guide of its follower make an angle of more than this sine
_ARC = 15.0  # how far a slot goes on to both sides of its pin, along the arc [mm]
_FREE = 4.0  # farther from another link nothing looks like a joint with it [mm]
_MOST = 2.4  # half of the widest slot there is room for on a small circle [rad]


@frozen
class Wheel:
    """A circle that rolls: its link, centre and radius [m].

    gear  its pitch circle is drawn, not its outline
    ring  the others run inside it
    """

    link: str
    centre: str
    radius: float
    gear: bool
    ring: bool = False


def wheels_of(machine: Mechanism) -> list[Wheel]:
    """Every wheel once: gears, then what rolls and what it rolls on. A ring stays a ring."""
    every: dict[tuple[str, str, float], Wheel] = {}
    for kind, rims_of in UNDER_LINKS.items():
        for wheel in (wheel for pair in machine.of(kind) for wheel in rims_of(pair)):
            key = wheel.link, wheel.centre, round(wheel.radius, 12)
            if key not in every or (wheel.ring and not every[key].ring):
                every[key] = wheel
    return list(every.values())


def _gears(gear: Gear) -> Iterator[Wheel]:
    for link, centre, radius in gear.circles:
        yield Wheel(link, centre, radius, gear=True, ring=gear.internal and radius == max(gear.radii))


def _rolling(roll: RollingContact) -> Iterator[Wheel]:
    turning_inside = roll.internal and roll.track_radius < roll.radius
    rack = roll.line is not None and roll.track != FRAME
    yield Wheel(roll.wheel, roll.centre, roll.radius, gear=rack, ring=turning_inside)
    if roll.track_centre is not None:
        ring = roll.internal and not turning_inside
        yield Wheel(roll.track, roll.track_centre, roll.track_radius, gear=False, ring=ring)


UNDER_LINKS: Mapping[type[Pair], Callable[..., Iterator[Wheel]]] = {Gear: _gears, RollingContact: _rolling}
"""The wheels of the pairs whose signs stand under the links; see `mechanism_figure.OVER_LINKS`."""


def wheels(skeleton: Skeleton) -> Figure:
    """All wheels, and the straight tracks of those that roll on a line."""
    figure, numbered = Figure(), set[str]()
    for wheel in wheels_of(skeleton.mechanism):
        figure.marks += _wheel(skeleton, wheel)
        if wheel.link not in numbered and wheel.link != FRAME:
            numbered.add(wheel.link)
            figure.wanted.append(_number(skeleton, wheel))
    for roll in skeleton.mechanism.of(RollingContact):
        if roll.line is not None:
            step, reach = skeleton.step(roll.centre), roll.radius / skeleton.window.scale + 12
            track = straight(skeleton, roll.line, roll.name, roll.centre, reach, step)
            under = (1j if roll.left else -1j) * skeleton.direction(roll.line)
            ground = symbols.guide(track.places[0], track.places[1], under, step, track.shows)
            figure.marks += ground if roll.line.link == FRAME else [track, *_rack(skeleton, roll, roll.line)]
    for gear in skeleton.mechanism.of(Gear):
        figure.marks += _mesh(skeleton, gear)
    return figure


def _mesh(skeleton: Skeleton, gear: Gear) -> Iterator[Mark]:
    """A few teeth of both gears where they touch: three of one in the gaps of the other."""
    one, other = (skeleton.at(centre) for centre in gear.centres)
    radii, step = [radius / skeleton.window.scale for radius in gear.radii], skeleton.step(*gear.centres)
    for k, (at, radius, way) in enumerate(zip((one, other), radii, (other - one, one - other), strict=True)):
        ring = gear.internal and radius == max(radii)
        arm, out = way / abs(way) * (-1 if gear.internal and not ring else 1), -1 if ring else 1
        if radius > 2 * _TOOTH:
            corners = [(t, high) for t, high in _teeth((-1, 0, 1) if k else (-0.5, 0.5))]
            places = [at + (radius + out * high) * arm * cmath.rect(1, t / radius) for t, high in corners]
            yield Stroke(tuple(places), "thin", step=step)


def _teeth(middles: Sequence[float]) -> Iterator[tuple[float, float]]:
    """Corners of teeth along a pitch line, and above it [mm]."""
    for middle in middles:
        for share, high in ((-0.33, -_DEPTH), (-0.17, _DEPTH), (0.17, _DEPTH), (0.33, -_DEPTH)):
            yield (middle + share) * _TOOTH, high


def _rack(skeleton: Skeleton, roll: RollingContact, line: Line) -> Iterator[Mark]:
    """The teeth of a rack on the side of its pinion, about where they touch."""
    along = skeleton.direction(line)
    up = along * (-1j if roll.left else 1j)  # to the pinion, y down
    foot = skeleton.at(roll.centre) - up * roll.radius / skeleton.window.scale
    places = (foot + along * t + up * (high + _DEPTH) for t, high in _teeth(range(-5, 6)))
    yield Stroke(tuple(places), "outline", step=skeleton.step(roll.centre))


def _wheel(skeleton: Skeleton, wheel: Wheel) -> Iterator[Mark]:
    at, radius = skeleton.at(wheel.centre), wheel.radius / skeleton.window.scale
    step, shows = skeleton.step(wheel.centre), Shows(wheel.link, "wheel", (wheel.centre,))
    yield Disc(at, radius, "centre" if wheel.gear else "outline", shows=shows, step=step)
    rim, fixed = radius, wheel.link == FRAME
    if wheel.gear:
        for along in (1, 1j):  # a cross at its centre
            yield Stroke((at - _CROSS * along, at + _CROSS * along), "thin", step=step)
        if wheel.ring:
            rim = radius + _RIM
            yield Disc(at, rim, "outline", step=step)
    if (spoke := _spoke(skeleton, wheel)) is not None:
        bar, way = spoke
        yield Stroke((at, at + way * radius), "outline", step=step)
        yield Stroke((at, at + bar * _CROSS, at + way * _CROSS), "outline", closed=True, fill="ink", step=step)
    if fixed:
        yield from symbols.rim_hatch(at, rim, 1.0 if wheel.ring else -1.0, step)


def _spoke(skeleton: Skeleton, wheel: Wheel) -> tuple[complex, complex] | None:
    """Of a wheel on a link that reaches beyond its rim: the direction of a bar, and of the spoke welded to it."""
    at, scale = skeleton.at(wheel.centre), skeleton.window.scale
    arms = [place - at for place in map(skeleton.at, skeleton.named(wheel.link)) if abs(place - at) > _CROSS]
    if not arms or wheel.link == FRAME or wheel.radius / scale <= _CROSS or disc(skeleton, wheel.link):
        return None
    bar = arms[0] / abs(arms[0])
    taken = [*skeleton.directions(wheel.centre), 1 + 0j]  # to the right an angle may begin
    return bar, min((1j * bar, -1j * bar), key=lambda way: max((arm * way.conjugate()).real for arm in taken))


def disc(skeleton: Skeleton, link: str) -> str:
    """The centre of the wheel within whose rim all points of a link lie; "" of other links."""
    places = [skeleton.at(point) for point in skeleton.named(link)]
    for wheel in wheels_of(skeleton.mechanism):
        at, radius = skeleton.at(wheel.centre), wheel.radius / skeleton.window.scale + 0.1
        if wheel.link == link and not wheel.ring and all(abs(place - at) <= radius for place in places):
            return wheel.centre
    return ""


def _number(skeleton: Skeleton, wheel: Wheel) -> LabelRequest:
    """The number of a wheel's link, within its rim or beside it."""
    at, radius = skeleton.at(wheel.centre), wheel.radius / skeleton.window.scale
    label, step = link_label(skeleton.mechanism.called(wheel.link)), skeleton.step(wheel.centre)
    out, gap = (radius + _RIM, 0.6) if wheel.ring else (radius, 0.4) if radius < _SMALL else (radius - 4.2, -2.6)
    taken = [*skeleton.directions(wheel.centre), *((_spoke(skeleton, wheel) or ())[1:])]
    for other in wheels_of(skeleton.mechanism):
        off = skeleton.at(other.centre) - at
        if abs(off) > 0.5:
            taken.append(off / abs(off) if not other.ring else -off / abs(off))
    taken += [1j] if FRAME in skeleton.mechanism.owners.get(wheel.centre, ()) else []
    directions = [cmath.rect(1, math.radians(a)) for a in (-45, -135, -90, 45, 135, 0, 180, 90)]
    away = max(directions, key=lambda one: -max(((t * one.conjugate()).real for t in taken), default=-1.0))
    return LabelRequest(label, at + away * out, gap=gap, away=away, step=step)


def straight(skeleton: Skeleton, line: Line, name: str, near: str, reach: float, step: int | None) -> Stroke:
    """The line of a link in the roll or cam `name`, `reach` mm to both sides of the foot of a point on it; as far as
    the link's points on it.
    """
    along, foot = skeleton.direction(line), skeleton.at(line.origin)
    t = (along.conjugate() * (skeleton.at(near) - foot)).real
    low, high = t - reach, t + reach
    points = skeleton.named(line.link) if line.link != FRAME else ()
    offs = [along.conjugate() * (skeleton.at(point) - foot) for point in points]
    stops = [off.real for off in offs if abs(off.imag) < 0.05]
    if len(stops) > 1:
        low, high = min(max(low, min(stops)), t - 6), max(min(high, max(stops)), t + 6)
    elif stops:
        low, high = (stops[0], high) if stops[0] < t else (low, stops[0])
    shows = Shows(line.link, "guide", (near,), name)
    return Stroke((foot + along * low, foot + along * high), "visible", shows=shows, step=step)


def circles(skeleton: Skeleton) -> Iterator[tuple[Place, float]]:
    """Centre and radius of every circle on paper: of wheels and of cams [mm]."""
    for centre, radius in sorted({circle[1:] for pair in skeleton.mechanism.pairs for circle in pair.circles}):
        if radius > 0:
            yield skeleton.at(centre), radius / skeleton.window.scale


def rims(machine: Mechanism, position: Mapping[str, Value]) -> Iterator[complex]:
    """Corners of the squares around all circles, in the mechanism's plane: how far they reach [m]."""
    for _, centre, radius in (circle for pair in machine.pairs for circle in pair.circles):
        at = place(position[centre])
        yield from (at - complex(radius, radius), at + complex(radius, radius))


def profiles(skeleton: Skeleton, cam: Cam) -> list[Mark]:
    """The profiles that touch."""
    step, scale = skeleton.step(*(centre for _, centre, _ in cam.circles)), skeleton.window.scale
    marks: list[Mark] = []
    for link, profile, other in zip(cam.links, cam.profiles, cam.profiles[::-1], strict=True):
        if profile.centre is None:
            assert profile.line is not None
            near, reach = other.centre or profile.line.origin, other.radius / scale
            face = straight(skeleton, profile.line, cam.name, near, reach + 8, step)
            stems = (follower(skeleton, slide) for slide in skeleton.mechanism.slides if slide.block == link)
            if stem := next(filter(None, stems), None):  # to both sides of it alike
                half = reach * skeleton.direction(profile.line)
                face = replace(face, places=(stem[0].places[0] - half, stem[0].places[0] + half))
            marks.append(face)
        elif profile.radius > 0:
            shows = Shows(link, "wheel", (profile.centre,))
            marks.append(Disc(skeleton.at(profile.centre), profile.radius / scale, "outline", shows=shows, step=step))
    return marks


def equivalents(skeleton: Skeleton) -> list[Mark]:
    """In dashes: the link between two centres, or the slot through a centre at a face's distance."""
    marks: list[Mark] = []
    for pair in skeleton.mechanism.pairs:
        match pair.equivalent:
            case Rod(_, centres) if pair.rolling is None:
                edges, step = {centre for _, centre, radius in pair.circles if radius == 0}, skeleton.step(*centres)
                marks.append(Stroke((skeleton.at(centres[0]), skeleton.at(centres[1])), "dashed", step=step))
                hinges = [skeleton.at(centre) for centre in centres if centre not in edges]
                marks += [Disc(hinge, symbols.HINGE, "thin", step=step) for hinge in hinges]
            case Slot(line, centre) if pair.rolling is None:
                at, along, step = skeleton.at(centre), skeleton.direction(line), skeleton.step(centre)
                marks += [  # the block runs on the face's line moved sideways to the centre; both belong to one link
                    Stroke((at - along * _REACH, at + along * _REACH), "dashed", step=step),
                    Stroke(symbols.block_corners(at, along), "dashed", closed=True, step=step),
                    Disc(at, symbols.HINGE, "thin", step=step),
                ]
    return marks


def rod_letters(skeleton: Skeleton) -> Iterator[LabelRequest]:
    """The letters of links between two centres, which equations use."""
    for pair in skeleton.mechanism.pairs:
        if isinstance(rod := pair.equivalent, Rod) and pair.rolling is None:
            start, end = map(skeleton.at, rod.points)
            yield LabelRequest(link_label(spelled(rod_name(pair))), start, end, step=skeleton.step(*rod.points))


def follower(skeleton: Skeleton, slide: Slide) -> list[Stroke] | None:
    """A fixed guide's block that a cam moves at its point: a rod with its tip, face or roller, guided above."""
    if slide.guide != FRAME or slide.block is None:
        return None
    for cam in skeleton.mechanism.of(Cam):
        for link, profile, other in zip(cam.links, cam.profiles, cam.profiles[::-1], strict=True):
            if link == slide.block and other.centre is not None and other.radius > 0:
                cam_centre, at = skeleton.at(other.centre), skeleton.at(slide.point)
                if profile.centre == slide.point:
                    return _rod(skeleton, slide, at, cam_centre, profile.radius / skeleton.window.scale)
                if profile.line is not None:  # where the face crosses the line on which the block slides
                    face, along = skeleton.direction(profile.line), skeleton.along(slide)
                    off, turn = skeleton.at(profile.line.origin) - at, (along.conjugate() * face).imag
                    if abs(turn) > _STEEP:
                        foot = at + along * (off.conjugate() * face).imag / turn
                        return _rod(skeleton, slide, foot, cam_centre, None)
    return None


def _rod(skeleton: Skeleton, slide: Slide, at: Place, cam_centre: Place, radius: float | None) -> list[Stroke]:
    """From its end at the cam on; of a face no radius."""
    along = skeleton.along(slide)
    out = along * math.copysign(1, (along.conjugate() * (at - cam_centre)).real)
    side, step = 1j * out, skeleton.step(slide.point)
    shows = Shows(slide.block or "", "guide", (), slide.name)
    near, far = (max(0.0, (radius or 0.0) - 3) + reach for reach in _BUSH)
    foot = at + out * (2.6 if radius == 0 else 0.0)
    marks = [Stroke((foot, at + out * (far - _BUSH[1] + _ROD)), "visible", shows=shows, step=step)]
    if radius == 0:
        tip = (at, at + out * 3.4 + side * 1.1, at + out * 3.4 - side * 1.1)
        marks.append(Stroke(tip, "outline", closed=True, fill="ink", step=step))
    for wall in (side, -side):
        marks += symbols.guide(at + out * near + wall * 1.1, at + out * far + wall * 1.1, wall, step)
    return marks


def circular_slot(skeleton: Skeleton, slot: CircularSlot) -> list[Mark]:
    """Over its link's arc, or on the ground; the centre line is what a ruler holds against the radius."""
    centre, pin = skeleton.at(slot.centre), skeleton.at(slot.point)
    step, radius = skeleton.step(slot.centre, slot.point), slot.radius / skeleton.window.scale
    arm, half = radius * ((pin - centre) / abs(pin - centre)), min(_ARC / radius, _MOST)
    cut = symbols.arc_places(centre, arm, -half, half)
    shows = Shows(slot.guide, "arc", (slot.centre, slot.point), slot.name)
    if slot.guide == FRAME:
        marks: list[Mark] = [*symbols.arc_hatch(centre, arm * (1 + symbols.SLOT / radius), half, 1.0, step)]
    else:  # the arc of a moving link that carries the slot, joined to the nearest of the link's points
        more = half + min(OVERRUN / abs(arm), 0.4)
        points = [skeleton.at(point) for point in skeleton.named(slot.guide)]
        bars = [bar for link in skeleton.mechanism.moving if link != slot.guide for bar in skeleton.bars(link)]
        ends = {centre + arm * cmath.rect(1, turn): turn for turn in (-more, more)}
        near = {end: min([_FREE, *(off_stretch(end, *bar) for bar in bars)]) for end in ends}
        joint = min(product(near, points), key=lambda pair: (-near[pair[0]], abs(pair[1] - pair[0])))  # no false joint
        arc = symbols.arc_places(centre, arm, math.copysign(half, -ends[joint[0]]), ends[joint[0]])
        marks = [Stroke(tuple(arc), "visible", shows=shows, step=step), Stroke(joint, "visible", step=step)]
    marks += symbols.slot(cut, shows, step)
    return [*marks, Stroke(tuple(cut), "centre", shows=shows, step=step)]
