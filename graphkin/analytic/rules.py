"""The equations of each kind of pair: one function a kind, found by the pair's class in `RULES`.

A kind contributes joints (a place where two links meet; joints make the vector loops) and relations
(equations linear in angles and displacements). How to add a kind: one function here, and a line in `RULES`.
A joint may name links of its own making (the line of centres of a wheel on a circle): their angles
become unknowns like any other. Such names, and those of a cam's displacement along its line, have a
space in them (`cam c0`), so no name of a file can clash.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Mapping
from typing import NamedTuple

from graphkin.base.tolerances import ROUNDED
from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Driver, Mechanism, Pose
from graphkin.model.pairs import Cam, CircularSlot, Gear, Pair, Revolute, Rod, Rolling, RollingContact, Slide, Slot


class Unknown(NamedTuple):
    """The angle of a link (kind "theta") or the displacement along a line (kind "s")."""

    kind: str
    name: str


def theta(link: str) -> Unknown:
    """The angle of a link as an unknown."""
    return Unknown("theta", link)


@frozen
class Joint:
    """`tail` and `head` meet: tail_arm (+ s direction, of the unknown `slide`) on tail = head_arm on head, arms and
    direction in the axes of their link [m, -]."""

    tail: str
    tail_arm: complex
    head: str
    head_arm: complex
    slide: str | None = None
    direction: complex = 1


@frozen
class LinearRelation:
    """sum of weight x unknown + offset = value, which is 0 but for drivers and poses [rad or m]; offset is None where
    the sum is whatever it is at the drawn position, and then stays."""

    weights: Mapping[Unknown, float]
    offset: float | None = 0.0

    @property
    def constant(self) -> float:
        return 0.0 if self.offset is None else self.offset


class Share(NamedTuple):
    """Joints and relations of one pair."""

    joints: tuple[Joint, ...] = ()
    relations: tuple[LinearRelation, ...] = ()


def shares(mechanism: Mechanism) -> Iterable[Share]:
    """Joints and relations of a mechanism, pair by pair."""
    for pair in (*mechanism.hinges, *mechanism.pairs):
        yield RULES[type(pair)](mechanism, pair)


def hinge(mechanism: Mechanism, pair: Revolute) -> Share:
    """n links at one point: n - 1 joints, each with the first of them."""
    arms = [(link, mechanism.links[link].points[pair.point]) for link in pair.links]
    return Share(tuple(Joint(*arms[0], *arm) for arm in arms[1:]))


def slide(mechanism: Mechanism, pair: Slide) -> Share:
    """The point stays on the guide's line at s; a block also keeps its angle to the guide."""
    carrier = pair.block or next(link for link in mechanism.owners[pair.point] if link != pair.guide)
    origin = mechanism.links[pair.guide].points[pair.line.origin]
    point = mechanism.links[carrier].points[pair.point]
    joint = Joint(pair.guide, origin, carrier, point, pair.name, pair.line.direction)
    if pair.block is None:
        return Share((joint,))
    return Share((joint,), (LinearRelation(_turned(pair.block, pair.guide), -pair.turn),))


def gear(mechanism: Mechanism, pair: Gear) -> Share:
    """No slip at the pitch point. Nothing here keeps the centre distance: other links do."""
    line, joints = _line_of_centres(mechanism, pair, pair.equivalent, None)
    return Share(joints, (_no_slip(pair.rolling, line),))


def roll(mechanism: Mechanism, pair: RollingContact) -> Share:
    """On a line: the centre at distance r from it, s and the angle tied by s + r (theta_wheel - theta_track) = const
    where the centre lies left of the line, s - r (..) where right. On a circle: as gears, in contact.
    """
    if (path := pair.path) is not None:
        turned = {unknown: path.offset * weight for unknown, weight in _turned(pair.wheel, pair.track).items()}
        relation = LinearRelation({Unknown("s", pair.name): 1.0, **turned}, None)
        return Share((_beside(mechanism, path, pair.wheel, pair.name),), (relation,))
    assert isinstance(pair.equivalent, Rod)
    line, joints = _line_of_centres(mechanism, pair, pair.equivalent, pair.equivalent.length)
    return Share(joints, (_no_slip(pair.rolling, line),))


def replaced(mechanism: Mechanism, pair: Cam | CircularSlot) -> Share:
    """A higher pair by its lower-pair equivalent alone: two points at a distance, or a point beside a line. Source: Sun
    Huan, Theory of Machines, section 2-6 (replacement of higher pairs)."""
    same = pair.equivalent
    if isinstance(same, Rod):
        return Share(_line_of_centres(mechanism, pair, same, same.length)[1])
    link = next(link for link in pair.joins if link != same.line.link)
    return Share((_beside(mechanism, same, link, _own(pair)),))


RULES: dict[type[object], Callable[..., Share]] = {
    Revolute: hinge,
    Slide: slide,
    CircularSlot: replaced,
    Gear: gear,
    RollingContact: roll,
    Cam: replaced,
}


def _own(pair: Pair) -> str:
    """The name of a link, or a displacement, of a pair's own making."""
    return f"{pair.table} {pair.name}"


def _line_of_centres(mechanism: Mechanism, pair: Pair, rod: Rod, length: float | None) -> tuple[str, tuple[Joint, ...]]:
    """The link that carries both centres, at this `length` [m] if given; or a new rod and its joints."""
    for link in mechanism.links.values() if rod.carried else ():
        if link.points.keys() >= set(rod.points):
            carried = abs(link.arm(*rod.points))
            if length is None or abs(carried - length) <= ROUNDED * length:
                return link.name, ()
    name, (first, second) = _own(pair), rod.links
    arm, far = (mechanism.links[link].points[point] for link, point in zip(rod.links, rod.points, strict=True))
    start = Joint(first, arm, name, 0)
    if length is None:
        return name, (start, Joint(name, 0, second, far, name))
    return name, (start, Joint(name, length, second, far))


def _no_slip(rolling: Rolling, line: str) -> LinearRelation:
    """r1 (theta1 - phi) + r2 (theta2 - phi) = const with phi the angle of the line of centres; a ring counts -r."""
    most, weights = max(rolling.radii), dict.fromkeys((*rolling.wheels, line), 0.0)
    for link, radius in zip(rolling.wheels, rolling.radii, strict=True):
        share = (-1 if rolling.internal and radius == most else 1) * radius / most
        weights[link] += share
        weights[line] -= share
    return LinearRelation({theta(link): weight for link, weight in weights.items() if link != FRAME}, None)


def _beside(mechanism: Mechanism, slot: Slot, link: str, name: str) -> Joint:
    """A point of a link that keeps its distance from a line; `name` is its displacement along the line."""
    line = slot.line
    origin = mechanism.links[line.link].points[line.origin]
    arm = mechanism.links[link].points[slot.point]
    return Joint(line.link, origin + slot.offset * 1j * line.direction, link, arm, name, line.direction)


def driven(mechanism: Mechanism, driver: Driver | Pose) -> LinearRelation:
    """The left side of a driver's (or pose's) equation, theta + arg(arm) - (theta_from + arg(from arm)) = value, or s =
    value for a slide."""
    if driver.kind == "slide":
        return LinearRelation({Unknown("s", driver.link): 1.0})
    weights = _turned(driver.link, driver.from_link)
    offset = _axis_to(mechanism, driver.link, driver.vector)
    return LinearRelation(weights, offset - _axis_to(mechanism, driver.from_link, driver.from_vector))


def placing(mechanism: Mechanism) -> list[tuple[Driver | Pose, float]]:
    """The drivers and poses that fix the drawn position, with their values [rad or m]."""
    given: tuple[Driver | Pose, ...] = (*mechanism.drivers, *mechanism.poses)
    return [(each, each.value) for each in given if each.value is not None]


def _turned(link: str, reference: str) -> dict[Unknown, float]:
    """Weights of theta_link - theta_reference; the frame does not turn."""
    return {theta(name): sign for name, sign in ((link, 1.0), (reference, -1.0)) if name != FRAME}


def _axis_to(mechanism: Mechanism, link: str, vector: tuple[str, str] | None) -> float:
    """Angle from a link's axis to the direction of two of its points [rad]; 0 where none is named."""
    return 0.0 if vector is None else cmath.phase(mechanism.links[link].arm(*vector))
