"""Wheels, cams and circular slots: pitch circles, profiles, followers, and lower-pair equivalents in dashes."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import product

import numpy as np

from graphkin.base.boxes import free_about
from graphkin.base.lines import arc_places, off_stretch
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import spelled
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, Rod, RollingContact, Slide, Slot, rod_name
from graphkin.model.wheels import Wheel, wheels_of
from graphkin.sheet import symbols
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, link_label, width
from graphkin.sheet.marks import Disc, Mark, Place, Shows, Stroke
from graphkin.sheet.skeleton import OVERRUN, Skeleton
from graphkin.sheet.window import Entry

_RIM = 3.0  # thickness of a ring's rim [mm]
_TOOTH, _DEPTH = 2.7, 0.85  # from tooth to tooth of those that are shown, and half as high as they are [mm]
_SMALL = 9.0  # in a wheel of less radius there is no room for its number [mm]
_REACH = 14.0  # how far a slot of the equivalent goes to both sides of its block [mm]
_ROD, _BUSH = 34.0, (15.0, 27.0)  # a follower's rod from its tip, and where it is guided [mm]
_STEEP = 0.2  # a face and the guide of its follower make an angle of more than this sine
_ARC = 15.0  # how far a slot goes on to both sides of its pin, along the arc [mm]
_BESIDE = 10.0  # nearer to a bar of another link a wheel's number looks like its own [mm]
_FREE = 4.0  # farther from another link nothing looks like a joint with it [mm]
_ON = 1e-6  # nearer to a line, in parts of its length, a place is on it
_MOST = 2.4  # half of the widest slot there is room for on a small circle [rad]


def wheels(skeleton: Skeleton) -> Iterator[Entry]:
    """All wheels, and the straight tracks of those that roll on a line."""
    named = numbered(skeleton)
    for wheel in wheels_of(skeleton.mechanism):
        yield from _wheel(skeleton, wheel)
        if named.get(wheel.link) == wheel:
            yield _number(skeleton, wheel)
    for roll in skeleton.mechanism.of(RollingContact):
        if roll.line is not None:
            line, step = track(skeleton, roll), skeleton.step(roll.centre)
            under = (1j if roll.left else -1j) * skeleton.direction(roll.line)
            if gap := toothed(skeleton, roll):
                along = skeleton.direction(roll.line)
                rack = [gap[0] + along * t - under * high for t, high in _teeth(round(2 * gap[1] / _TOOTH + 0.5))]
                rack += [end + 2 * _DEPTH * under for end in (rack[-1], rack[0])]
                yield Stroke(tuple(rack), "outline", closed=True, step=step)
            ground = symbols.guide(line.places[0], line.places[1], under, step, line.shows)
            line, *wall = ground if roll.line.link == FRAME else [line]
            yield from (*(rack_line(line, *gap) if gap else [line]), *wall)
    for gear in skeleton.mechanism.of(Gear):
        yield from _mesh(skeleton, gear)


def numbered(skeleton: Skeleton) -> dict[str, Wheel]:
    """The wheel that bears its link's number, by link: not the frame's, nor where a bar can bear what is too wide."""
    first = {wheel.link: wheel for wheel in reversed([*wheels_of(skeleton.mechanism)]) if wheel.link != FRAME}
    wide = {link: width(link_label(skeleton.mechanism.called(link)), LABEL) for link in first}
    return {link: wheel for link, wheel in first.items() if disc(skeleton, link) or not any(skeleton.bars(link))
            or wide[link] < 0.7 * wheel.radius / skeleton.window.scale}  # fmt: skip


def toothed(skeleton: Skeleton, roll: RollingContact) -> tuple[Place, float] | None:
    """The middle and half of a rack's teeth about its pinion; None of other tracks."""
    wheels = [wheel for wheel in wheels_of(skeleton.mechanism) if wheel.gear and wheel.link == roll.wheel]
    if roll.line is None or not any(abs(wheel.radius - roll.radius) < 1e-9 for wheel in wheels):
        return None
    along, foot = skeleton.direction(roll.line), skeleton.at(roll.line.origin)
    start, end = straight(skeleton, roll.line, roll.name, roll.centre, 6 * _TOOTH, None).places
    low, high = (((end - foot) / along).real / _TOOTH for end in (start, end))
    first, last = math.ceil(low + 1), math.floor(high - 1)
    return foot + along * _TOOTH * (first + last) / 2, _TOOTH * (last - first + 0.5) / 2


def rack_line(line: Stroke, at: Place, half: float) -> list[Stroke]:
    """The line of a rack, thin along its teeth."""
    start, end = line.places[0], line.places[-1]
    near, far = (at + sign * half * (end - start) / abs(end - start) for sign in (-1, 1))
    rest = [ends for ends in ((start, near), (far, end)) if ((ends[1] - ends[0]) / (end - start)).real > 0]
    return [replace(line, pen="thin"), *(replace(line, places=ends, shows=None) for ends in rest)]


def _mesh(skeleton: Skeleton, gear: Gear) -> Iterator[Mark]:
    """Teeth of the larger gear where they touch: its gaps are the teeth of the other."""
    large, small = sorted(zip(gear.radii, gear.centres, strict=True), reverse=True)
    at, radius = skeleton.at(large[1]), large[0] / skeleton.window.scale
    arm = (skeleton.at(small[1]) - at) / abs(skeleton.at(small[1]) - at)
    if radius > 2 * _TOOTH:
        places = (at + (radius + high) * arm * cmath.rect(1, t / radius) for t, high in _teeth(5))
        yield Stroke(tuple(places), "outline", step=skeleton.step(*gear.centres))


def _teeth(count: int) -> list[tuple[float, float]]:
    """Corners of teeth along a pitch line from their middle on, and above it; they begin and end on it [mm]."""
    corners = [((k + share - (count - 1) / 2) * _TOOTH, high) for k in range(count)
               for share, high in ((-0.36, -_DEPTH), (-0.14, _DEPTH), (0.14, _DEPTH), (0.36, -_DEPTH))]  # fmt: skip
    end = (count - 0.5) / 2 * _TOOTH
    return [(-end, 0.0), *corners[1:-1], (end, 0.0)]


def _wheel(skeleton: Skeleton, wheel: Wheel) -> Iterator[Mark]:
    at, radius = skeleton.at(wheel.centre), wheel.radius / skeleton.window.scale
    step, shows = skeleton.step(wheel.centre), Shows(wheel.link, "wheel", (wheel.centre,))
    yield Disc(at, radius, "centre" if wheel.gear else "outline", shows=shows, step=step)
    rim, fixed = radius, wheel.link == FRAME
    if wheel.gear and wheel.ring:
        rim = radius + _RIM
        yield Disc(at, rim, "outline", step=step)
    arms = [place - at for place in map(skeleton.at, skeleton.named(wheel.link)) if abs(place - at) > radius + 1]
    for arm in arms if radius > _SMALL / 2 and not fixed and not disc(skeleton, wheel.link) else ():
        for side in (1, -1):  # a bar of one piece with it that goes on past its rim
            on = at + radius * arm / abs(arm)
            yield from symbols.weld(on, at, on + side * 1j * arm, step)
    if fixed:
        yield from symbols.rim_hatch(at, rim, 1.0 if wheel.ring else -1.0, step)


def disc(skeleton: Skeleton, link: str) -> str:
    """The centre of the wheel within whose rim all points of a link lie; "" of other links."""
    places = [skeleton.at(point) for point in skeleton.named(link)]
    own = [wheel for wheel in wheels_of(skeleton.mechanism) if wheel.link == link and not wheel.ring]
    rims = ((wheel.centre, skeleton.at(wheel.centre), wheel.radius / skeleton.window.scale + 0.1) for wheel in own)
    return next((name for name, at, radius in rims if all(abs(place - at) <= radius for place in places)), "")


def _number(skeleton: Skeleton, wheel: Wheel) -> LabelRequest:
    """The number of a wheel's link, within its rim or beside it, where no other link's bar is near."""
    at, radius = skeleton.at(wheel.centre), wheel.radius / skeleton.window.scale
    label, step = link_label(skeleton.mechanism.called(wheel.link)), skeleton.step(wheel.centre)
    out, gap = (radius + _RIM, 0.6) if wheel.ring else (radius, 0.4) if radius < _SMALL else (radius - 4.2, -2.6)
    taken = [*skeleton.directions(wheel.centre), 1 + 0j]  # to the right an angle may begin
    offs = [(skeleton.at(other.centre) - at, other.ring) for other in wheels_of(skeleton.mechanism)]
    taken += [(-off if ring else off) / abs(off) for off, ring in offs if abs(off) > 0.5]
    taken += [1j] if FRAME in skeleton.mechanism.owners.get(wheel.centre, ()) else []
    directions = [cmath.rect(1, math.radians(a)) for a in (-45, -135, -90, 45, 135, 0, 180, 90)]
    bars = [bar for link in skeleton.mechanism.moving if link != wheel.link for bar in skeleton.bars(link)]
    free = dict(zip(directions, free_about(at + out * np.array(directions), bars, _BESIDE), strict=True))
    away = max(directions, key=lambda one: (free[one], -max((t * one.conjugate()).real for t in taken)))
    return LabelRequest(label, at + away * out, gap=gap, away=away, step=step)


def track(skeleton: Skeleton, roll: RollingContact) -> Stroke:
    """The straight track of a wheel, to both sides of it."""
    assert roll.line is not None
    reach = roll.radius / skeleton.window.scale + 12
    return straight(skeleton, roll.line, roll.name, roll.centre, reach, skeleton.step(roll.centre))


def straight(skeleton: Skeleton, line: Line, name: str, near: str, reach: float, step: int | None) -> Stroke:
    """The line of a link in the roll or cam `name`, `reach` mm to both sides of a point, within the link's points."""
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


def profiles(skeleton: Skeleton, cam: Cam) -> Iterator[Mark]:
    """The profiles that touch."""
    step, scale = skeleton.step(*(centre for _, centre, _ in cam.circles)), skeleton.window.scale
    for link, profile, other in zip(cam.links, cam.profiles, cam.profiles[::-1], strict=True):
        if profile.centre is None:
            assert profile.line is not None
            near, reach = other.centre or profile.line.origin, other.radius / scale
            face = straight(skeleton, profile.line, cam.name, near, reach + 8, step)
            stems = (follower(skeleton, slide) for slide in skeleton.mechanism.slides if slide.block == link)
            half, line = reach * skeleton.direction(profile.line), skeleton.at(profile.line.origin)
            for foot in (stem[0].places[0] for stem in stems if stem):  # to both sides of its own stem alike
                if abs(((line - foot) / half).imag) < _ON and abs(((skeleton.at(near) - foot) / half).real) < 1:
                    face = replace(face, places=(foot - half, foot + half))
            yield face
        elif profile.radius > 0:
            shows = Shows(link, "wheel", (profile.centre,))
            yield Disc(skeleton.at(profile.centre), profile.radius / scale, "outline", shows=shows, step=step)


def equivalents(skeleton: Skeleton) -> Iterator[Entry]:
    """In dashes: the link between two centres with its letter, or the slot through a centre at a face's distance."""
    for pair in (pair for pair in skeleton.mechanism.pairs if pair.rolling is None):
        match pair.equivalent:
            case Rod(_, centres):
                edges, step = {centre for _, centre, radius in pair.circles if radius == 0}, skeleton.step(*centres)
                start, end = map(skeleton.at, centres)
                yield Stroke((start, end), "dashed", step=step)
                hinges = (skeleton.at(centre) for centre in centres if centre not in edges)
                yield from (Disc(hinge, symbols.HINGE, "thin", step=step) for hinge in hinges)
                yield LabelRequest(link_label(spelled(rod_name(pair))), start, end, step=step)
            case Slot(line, centre):
                at, along, step = skeleton.at(centre), skeleton.direction(line), skeleton.step(centre)
                yield Stroke((at - along * _REACH, at + along * _REACH), "dashed", step=step)
                # the block runs on the face's line moved to the centre; both belong to one link
                yield Stroke(symbols.block_corners(at, along), "dashed", closed=True, step=step)
                yield Disc(at, symbols.HINGE, "thin", step=step)
            case None:
                pass


def follower(skeleton: Skeleton, slide: Slide) -> list[Stroke] | None:
    """A fixed guide's block that a cam moves, or its roller: a rod with its tip, face or roller, guided above."""
    if slide.guide != FRAME or slide.block is None:
        return None
    for cam in skeleton.mechanism.of(Cam):
        for link, profile, other in zip(cam.links, cam.profiles, cam.profiles[::-1], strict=True):
            if (link == slide.block or profile.centre == slide.point) and other.centre is not None and other.radius > 0:
                cam_centre, at = skeleton.at(other.centre), skeleton.at(slide.point)
                if profile.centre == slide.point:
                    return _rod(skeleton, slide, at, cam_centre, profile.radius / skeleton.window.scale)
                if profile.line is not None:  # where the face crosses the line on which the block slides
                    face, along = skeleton.direction(profile.line), skeleton.direction(slide.line)
                    off, turn = skeleton.at(profile.line.origin) - at, (along.conjugate() * face).imag
                    if abs(turn) > _STEEP:
                        foot = at + along * (off.conjugate() * face).imag / turn
                        return _rod(skeleton, slide, foot, cam_centre, None)
    return None


def _rod(skeleton: Skeleton, slide: Slide, at: Place, cam_centre: Place, radius: float | None) -> list[Stroke]:
    """From its end at the cam on; of a face no radius."""
    along = skeleton.direction(slide.line)
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


def circular_slot(skeleton: Skeleton, slot: CircularSlot) -> Iterator[Mark]:
    """Over its link's arc, or on the ground; the centre line is what a ruler holds against the radius."""
    centre, pin = skeleton.at(slot.centre), skeleton.at(slot.point)
    step, radius = skeleton.step(slot.centre, slot.point), slot.radius / skeleton.window.scale
    arm, half = radius * ((pin - centre) / abs(pin - centre)), min(_ARC / radius, _MOST)
    cut = arc_places(centre, arm, -half, half)
    shows = Shows(slot.guide, "arc", (slot.centre, slot.point), slot.name)
    if slot.guide == FRAME:
        yield from symbols.arc_hatch(centre, arm * (1 + symbols.SLOT / radius), half, 1.0, step)
    else:  # the arc of a moving link that carries the slot, joined to the nearest of the link's points
        more = half + min(OVERRUN / abs(arm), 0.4)
        points = [skeleton.at(point) for point in skeleton.named(slot.guide)]
        bars = [bar for link in skeleton.mechanism.moving if link != slot.guide for bar in skeleton.bars(link)]
        ends = {centre + arm * cmath.rect(1, turn): turn for turn in (-more, more)}
        near = {end: min([_FREE, *(off_stretch(end, *bar) for bar in bars)]) for end in ends}
        joint = min(product(near, points), key=lambda pair: (-near[pair[0]], abs(pair[1] - pair[0])))  # no false joint
        bar = arc_places(centre, arm, math.copysign(half, -ends[joint[0]]), ends[joint[0]])
        yield from (Stroke(tuple(bar), "visible", shows=shows, step=step), Stroke(joint, "visible", step=step))
    yield from symbols.slot(cut, shows, step)
    yield Stroke(tuple(cut), "centre", shows=shows, step=step)
