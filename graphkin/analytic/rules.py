"""What each kind of pair asks of the unknowns: one function a kind, found by the pair's class in `RULES`.

A kind contributes joints (a place where two links meet; joints make the vector loops) and relations
(equations linear in angles and displacements). How to add a kind: one function here, and a line in `RULES`.
A joint may name links of its own making (the line of centres of a wheel on a circle): their angles
become unknowns like any other. Such names, and those of a cam's displacement along its line, have a
space in them (`cam 0`), so no name of a file can clash.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from graphkin.mechanism import FRAME, Driver, Mechanism, Pose
from graphkin.pairs import Cam, Gear, Line, Revolute, Roll, Slide
from graphkin.tolerances import ROUNDED

__all__ = ["RULES", "Joint", "Relation", "Share", "Unknown", "driven", "placing", "shares", "theta"]



class Unknown(NamedTuple):
    """The angle of a link (kind "theta") or the displacement along a line (kind "s")."""

    kind: str
    name: str


def theta(link: str) -> Unknown:
    return Unknown("theta", link)


@dataclass(frozen=True, slots=True)
class Joint:
    """`tail` and `head` meet: tail_arm (+ s direction, of the unknown `slide`) on tail = head_arm on head.

    Arms and direction are in the axes of their link [m, -].
    """

    tail: str
    tail_arm: complex
    head: str
    head_arm: complex
    slide: str | None = None
    direction: complex = 1


@dataclass(frozen=True, slots=True)
class Relation:
    """sum of weight x unknown + offset = value; value is 0 but for drivers and poses [rad or m].

    offset is None where the sum is whatever it is at the drawn position, and then stays.
    """

    weights: Mapping[Unknown, float]
    offset: float | None = 0.0


class Share(NamedTuple):
    """What one pair brings."""

    joints: tuple[Joint, ...] = ()
    relations: tuple[Relation, ...] = ()


def shares(mechanism: Mechanism) -> Iterable[Share]:
    """What the pairs of a mechanism bring, pair by pair."""
    m = mechanism
    for pair in (*m.hinges, *m.slides, *m.gears, *m.rolls, *m.cams):
        yield RULES[type(pair)](mechanism, pair)


def hinge(mechanism: Mechanism, pair: Revolute) -> Share:
    """n links at one point: n - 1 joints, each with the first of them."""
    hub, *others = pair.links
    arm = mechanism.links[hub].points[pair.point]
    heads = ((link, mechanism.links[link].points[pair.point]) for link in others)
    return Share(tuple(Joint(hub, arm, link, head) for link, head in heads))


def slide(mechanism: Mechanism, pair: Slide) -> Share:
    """The point stays on the guide's line at s; a block also keeps its angle to the guide."""
    carrier = pair.block
    if carrier is None:
        carrier = next(link for link in mechanism.owners[pair.point] if link != pair.guide)
    origin = mechanism.links[pair.guide].points[pair.line.origin]
    point = mechanism.links[carrier].points[pair.point]
    joint = Joint(pair.guide, origin, carrier, point, pair.name, pair.line.direction)
    if pair.block is None:
        return Share((joint,))
    return Share((joint,), (Relation(_turned(pair.block, pair.guide), -pair.turn),))


def gear(mechanism: Mechanism, pair: Gear) -> Share:
    """No slip at the pitch point. Nothing here keeps the centre distance: other links do."""
    ends = _ends(mechanism, pair.links, pair.centres)
    line, joints = _line_of_centres(mechanism, pair.centres, ends, f"gear {_number(mechanism.gears, pair)}")
    return Share(joints, (_no_slip(pair.links, pair.radii, line, pair.internal),))


def roll(mechanism: Mechanism, pair: Roll) -> Share:
    """On a line: the centre at distance r from it, s and the angle tied by s + r (theta_wheel - theta_track) = const
    where the centre lies left of the line, s - r (..) = const where right. On a circle: as gears, in contact.
    """
    if pair.line is None:
        return _roll_on_circle(mechanism, pair)
    lever = pair.radius if pair.left else -pair.radius
    joint = _beside(mechanism, pair.line, lever, pair.wheel, pair.centre, pair.name)
    turned = {unknown: lever * weight for unknown, weight in _turned(pair.wheel, pair.track).items()}
    return Share((joint,), (Relation({Unknown("s", pair.name): 1.0, **turned}, None),))


def _roll_on_circle(mechanism: Mechanism, pair: Roll) -> Share:
    assert pair.track_centre is not None
    links, centres, radii = (pair.track, pair.wheel), (pair.track_centre, pair.centre), (pair.track_radius, pair.radius)
    ends, name = _ends(mechanism, links, centres), f"roll {_number(mechanism.rolls, pair)}"
    line, joints = _line_of_centres(mechanism, centres, ends, name, _apart(radii, pair.internal))
    return Share(joints, (_no_slip(links, radii, line, pair.internal),))


def cam(mechanism: Mechanism, pair: Cam) -> Share:
    """The lower-pair equivalent: two circles keep the distance of their centres, a circle's centre that from a line.

    Source: Sun Huan, Theory of Machines, section 2-6 (replacement of higher pairs).
    """
    name = f"cam {_number(mechanism.cams, pair)}"
    for line, circle, link in zip(pair.profiles, pair.profiles[::-1], pair.links[::-1], strict=True):
        if line.line is not None:
            assert circle.centre is not None
            distance = circle.radius if line.left else -circle.radius
            return Share((_beside(mechanism, line.line, distance, link, circle.centre, name),))
    one, other = pair.profiles
    assert one.centre is not None
    assert other.centre is not None
    centres, radii = (one.centre, other.centre), (one.radius, other.radius)
    ends = _ends(mechanism, pair.links, centres)
    return Share(_line_of_centres(mechanism, centres, ends, name, _apart(radii, pair.internal))[1])


RULES: dict[type[Any], Callable[[Mechanism, Any], Share]] = {
    Revolute: hinge,
    Slide: slide,
    Gear: gear,
    Roll: roll,
    Cam: cam,
}


class _End(NamedTuple):
    """A centre on its link, in the link's axes [m]."""

    link: str
    arm: complex


def _ends(mechanism: Mechanism, links: tuple[str, str], centres: tuple[str, str]) -> tuple[_End, _End]:
    arms = (mechanism.links[link].points[centre] for link, centre in zip(links, centres, strict=True))
    first, second = (_End(link, arm) for link, arm in zip(links, arms, strict=True))
    return first, second


def _number(pairs: Sequence[object], pair: object) -> int:
    """The place of a pair among those of its kind."""
    return next(number for number, other in enumerate(pairs) if other is pair)


def _apart(radii: tuple[float, float], internal: bool) -> float:
    """Distance of the centres of two circles that touch [m]."""
    return abs(radii[0] - radii[1]) if internal else radii[0] + radii[1]


def _line_of_centres(
    mechanism: Mechanism, centres: tuple[str, str], ends: tuple[_End, _End], name: str, length: float | None = None
) -> tuple[str, tuple[Joint, ...]]:
    """The link that carries both centres (at this `length` [m], if one is given), or a new one and its joints.

    A new link of open length is a rod from the first centre that slides through the second.
    """
    for link in mechanism.links.values():
        if link.points.keys() >= set(centres):
            carried = abs(link.arm(*centres))
            if length is None or abs(carried - length) <= ROUNDED * length:
                return link.name, ()
    first, second = ends
    start = Joint(first.link, first.arm, name, 0)
    if length is None:
        return name, (start, Joint(name, 0, second.link, second.arm, name))
    return name, (start, Joint(name, length, second.link, second.arm))


def _no_slip(links: tuple[str, str], radii: tuple[float, float], line: str, internal: bool) -> Relation:
    """r1 (theta1 - phi) + r2 (theta2 - phi) = const with phi the angle of the line of centres; a ring counts -r."""
    most, weights = max(radii), dict.fromkeys((*links, line), 0.0)
    for link, radius in zip(links, radii, strict=True):
        share = (-1 if internal and radius == most else 1) * radius / most
        weights[link] += share
        weights[line] -= share
    return Relation({theta(link): weight for link, weight in weights.items() if link != FRAME}, None)


def _beside(mechanism: Mechanism, line: Line, distance: float, link: str, centre: str, name: str) -> Joint:
    """A centre that keeps its `distance` [m] from a line, to its left; `name` is its displacement along the line."""
    origin = mechanism.links[line.link].points[line.origin]
    arm = mechanism.links[link].points[centre]
    return Joint(line.link, origin + distance * 1j * line.direction, link, arm, name, line.direction)


def driven(mechanism: Mechanism, driver: Driver | Pose) -> Relation:
    """The left side of a driver's (or pose's) equation; its value is the right side.

    Angle: theta + arg(arm) - (theta_from + arg(from arm)) = value. Slide: s = value.
    """
    if driver.kind == "slide":
        return Relation({Unknown("s", driver.link): 1.0})
    weights = _turned(driver.link, driver.from_link)
    offset = _axis_to(mechanism, driver.link, driver.vector)
    return Relation(weights, offset - _axis_to(mechanism, driver.from_link, driver.from_vector))


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
