"""What each kind of pair asks of the unknowns: one function a kind, found by the pair's class in `RULES`.

A kind contributes joints (a place where two links meet; joints make the vector loops) and relations
(equations linear in angles and displacements). How to add a kind: one function here, and a line in `RULES`.
A joint may name links of its own making (the line of centres of a wheel on a circle): their angles
become unknowns like any other.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from graphkin.mechanism import FRAME, Driver, Mechanism, Pose
from graphkin.pairs import Revolute, Slide

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
    """What the pairs of a mechanism bring, pair by pair. Kinds without a rule are the caller's to refuse."""
    m = mechanism
    for pair in (*m.hinges, *m.slides, *m.gears, *m.rolls, *m.cams):
        assert type(pair) in RULES, f"no analytic rule for {type(pair).__name__}"
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


RULES: dict[type[Any], Callable[[Mechanism, Any], Share]] = {
    Revolute: hinge,
    Slide: slide,
}


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
