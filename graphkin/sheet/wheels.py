"""Pitch circles of gears and rolling wheels: centre marks, rings with a rim, hatching where they stand still."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Gear, Line, Pair, RollingContact
from graphkin.sheet import symbols
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import link_label
from graphkin.sheet.marks import Disc, Mark, Place, Shows, Stroke
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Figure

_RIM = 3.0
"""Thickness of a ring's rim, and of the edge that is hatched in a fixed wheel [mm]."""
_CROSS = 4.4
_SMALL = 9.0
"""In a wheel of less radius there is no room for its number [mm]."""


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
    found: dict[tuple[str, str, float], Wheel] = {}
    for kind, rims in UNDER_LINKS.items():
        for pair in machine.of(kind):
            for wheel in rims(pair):
                _add(found, wheel)
    return list(found.values())


def _gears(gear: Gear) -> Iterator[Wheel]:
    for link, centre, radius in gear.circles:
        yield Wheel(link, centre, radius, gear=True, ring=gear.internal and radius == max(gear.radii))


def _rolling(roll: RollingContact) -> Iterator[Wheel]:
    turning_inside = roll.internal and roll.track_radius < roll.radius
    yield Wheel(roll.wheel, roll.centre, roll.radius, gear=False, ring=turning_inside)
    if roll.track_centre is not None:
        ring = roll.internal and not turning_inside
        yield Wheel(roll.track, roll.track_centre, roll.track_radius, gear=False, ring=ring)


UNDER_LINKS: Mapping[type[Pair], Callable[[Any], Iterator[Wheel]]] = {Gear: _gears, RollingContact: _rolling}
"""The wheels of the pairs whose signs stand under the links; see `mechanism_figure.OVER_LINKS`."""


def _add(found: dict[tuple[str, str, float], Wheel], wheel: Wheel) -> None:
    known = found.get((wheel.link, wheel.centre, round(wheel.radius, 12)))
    if known is None or (wheel.ring and not known.ring):
        found[wheel.link, wheel.centre, round(wheel.radius, 12)] = wheel


def wheels(skeleton: Skeleton) -> Figure:
    """All wheels, and the straight tracks of those that roll on a line."""
    figure = Figure()
    numbered: set[str] = set()
    for wheel in wheels_of(skeleton.mechanism):
        figure.marks += _wheel(skeleton, wheel)
        if wheel.link not in numbered and len(skeleton.named(wheel.link)) < 2 and wheel.link != FRAME:
            numbered.add(wheel.link)
            figure.wanted.append(_number(skeleton, wheel))
    for roll in skeleton.mechanism.of(RollingContact):
        if roll.line is not None:
            figure.marks += _track(skeleton, roll, roll.line)
    return figure


def _wheel(skeleton: Skeleton, wheel: Wheel) -> Iterator[Mark]:
    at, radius = skeleton.at(wheel.centre), wheel.radius / skeleton.window.scale
    step = skeleton.step(wheel.centre)
    shows = Shows(wheel.link, "wheel", (wheel.centre,))
    yield Disc(at, radius, "centre" if wheel.gear else "outline", shows=shows, step=step)
    fixed = wheel.link == FRAME
    if wheel.gear:
        yield from symbols.centre_mark(at, _CROSS, step)
    if wheel.ring:
        rim = radius + _RIM if wheel.gear else radius
        if wheel.gear:
            yield Disc(at, rim, "outline", step=step)
        if fixed:
            yield from symbols.rim_hatch(at, rim, 1.0, step)
    elif fixed:
        rim = max(0.0, radius - _RIM) if wheel.gear else radius
        if wheel.gear and rim > _RIM:
            yield Disc(at, rim, "outline", step=step)
        yield from symbols.rim_hatch(at, rim, -1.0, step)


def _number(skeleton: Skeleton, wheel: Wheel) -> LabelRequest:
    """The number of a link that is a wheel alone, beside its rim."""
    at, radius = skeleton.at(wheel.centre), wheel.radius / skeleton.window.scale
    label, step = link_label(skeleton.mechanism.called(wheel.link)), skeleton.step(wheel.centre)
    way = _free_way(skeleton, wheel.centre)
    if wheel.ring:
        return LabelRequest(label, at + way * (radius + _RIM), gap=0.6, away=way, step=step)
    if radius < _SMALL:
        return LabelRequest(label, at + way * radius, gap=0.4, away=way, step=step)
    return LabelRequest(label, at + way * (radius - 4.2), gap=-2.6, away=way, step=step)


def _free_way(skeleton: Skeleton, centre: str) -> complex:
    """The direction from a wheel's centre that is farthest from links and from the wheels beside it."""
    taken = list(skeleton.directions(centre))
    here = skeleton.at(centre)
    for other in wheels_of(skeleton.mechanism):
        off = skeleton.at(other.centre) - here
        if abs(off) > 0.5:
            taken += [off / abs(off)] if not other.ring else [-off / abs(off)]
    taken += [1j] if FRAME in skeleton.mechanism.owners.get(centre, ()) else []
    ways = [cmath.rect(1, math.radians(a)) for a in (-45, -135, -90, 45, 135, 0, 180, 90)]
    return max(ways, key=lambda way: -max(((t * way.conjugate()).real for t in taken), default=-1.0))


def _track(skeleton: Skeleton, roll: RollingContact, line: Line) -> list[Mark]:
    """The line a wheel rolls on: hatched ground, or a bar of its link."""
    step = skeleton.step(roll.centre)
    track = straight(skeleton, line, roll.name, roll.centre, roll.radius / skeleton.window.scale + 12, step)
    if line.link != FRAME:
        return [track]
    under = (1j if roll.left else -1j) * skeleton.direction(line)
    return symbols.guide(track.places[0], track.places[1], under, step, track.shows)


def straight(skeleton: Skeleton, line: Line, name: str, near: str, reach: float, step: int | None) -> Stroke:
    """The line of a link in the roll or cam `name`, `reach` mm to both sides of the foot of a point on it; as far as
    the link's points on it.
    """
    along, foot = skeleton.direction(line), skeleton.at(line.origin)
    t = (along.conjugate() * (skeleton.at(near) - foot)).real
    low, high = t - reach, t + reach
    stops = []
    for point in skeleton.named(line.link) if line.link != FRAME else ():
        off = along.conjugate() * (skeleton.at(point) - foot)
        stops += [off.real] if abs(off.imag) < 0.05 else []
    if len(stops) > 1:
        low, high = min(max(low, min(stops)), t - 6), max(min(high, max(stops)), t + 6)
    elif stops:
        low, high = (stops[0], high) if stops[0] < t else (low, stops[0])
    shows = Shows(line.link, "guide", (near,), name)
    return Stroke((foot + along * low, foot + along * high), "visible", shows=shows, step=step)


def circles(skeleton: Skeleton) -> Iterator[tuple[Place, float]]:
    """Centre and radius of every circle on paper: of wheels and of cams [mm]."""
    found = {(centre, radius) for pair in skeleton.mechanism.pairs for _, centre, radius in pair.circles}
    for centre, radius in sorted(found):
        if radius > 0:
            yield skeleton.at(centre), radius / skeleton.window.scale


def rims(machine: Mechanism, position: Mapping[str, complex]) -> Iterator[complex]:
    """Corners of the squares around all circles, in the mechanism's plane [m]: how far they reach."""
    for _, centre, radius in (circle for pair in machine.pairs for circle in pair.circles):
        at = complex(position[centre])
        yield from (at - complex(radius, radius), at + complex(radius, radius))
