"""The start of a replay, `Facts`, and its outcome, `Plot`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cached_property
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Real, Value, unit
from graphkin.base.value import Lazy, filled, frozen
from graphkin.construction import terms
from graphkin.construction.terms import Arm, Plane


def slide_key(slide: str) -> str:
    """A slide in tables that hold displacements beside angles by link: a file may call a link and a slide alike."""
    return f"s {slide}"


def length(arm: Value) -> Real:
    """The length of a vector; of a single one as Python rounds it, which no array does."""
    return np.abs(arm) if isinstance(arm, np.ndarray) else abs(arm)


@frozen
class TurnOf:
    """The dependence of a link's angle on another's: theta = theta(base) + constant + sum of sign * driver value."""

    base: str
    constant: float = 0.0
    drivers: tuple[tuple[int, int], ...] = ()


def grouped(turns: Mapping[str, TurnOf]) -> dict[str, list[str]]:
    """The links whose angles hang on that of each base link, itself among them."""
    groups: dict[str, list[str]] = {}
    for link, turn in turns.items():
        groups.setdefault(turn.base, []).append(link)
    return groups


@frozen
class Facts:
    """Data known before the pencil moves: dimensions and drivers. SI units; drivers scalar or (n,) each.

    shapes  points of each link in its axes [m]; lines: guide, origin and direction (guide's axes) of each slide
    turns   each link's angle by that of its group's base link
    slides_driven  driver number by slide
    """

    frame: str
    shapes: Mapping[str, Mapping[str, complex]]
    lines: Mapping[str, tuple[str, str, complex]]
    turns: Mapping[str, TurnOf]
    slides_driven: Mapping[str, int]
    values: tuple[Real, ...]
    rates: tuple[Real, ...]
    accelerations: tuple[Real, ...]
    drawn: Mapping[str, float] = field(default_factory=dict)
    """Angles by link [rad] and displacements by `slide_key` [m] as drawn, from where contacts count."""

    @cached_property
    def groups(self) -> Mapping[str, Sequence[str]]:
        """The links that hang on each base link, itself among them."""
        return grouped(self.turns)

    def drivers_between(self, link: str, other: str) -> frozenset[int]:
        """The drivers that turn one of two links of a group against the other."""
        one, two = ({k for k, _ in self.turns[each].drivers} for each in (link, other))
        return frozenset(one ^ two)

    def relative_angle(self, link: str) -> Real:
        """Angle of a link against its base link [rad]."""
        turn = self.turns[link]
        return turn.constant + sum([sign * self.values[k] for k, sign in turn.drivers])

    def relative_rate(self, link: str, order: int) -> Real:
        """Angular velocity (order 1) or acceleration (order 2) of a link against its base link."""
        given = self.rates if order == 1 else self.accelerations
        return sum([sign * given[k] for k, sign in self.turns[link].drivers])


def within_a_turn(angle: Real) -> Real:
    """From 0 on; over many positions `np.mod` takes ten times as long."""
    return angle - 2 * np.pi * np.floor(angle / (2 * np.pi))


@filled
class Plot:
    """Named points and quantities of the finished drawing; every value a scalar or an array over positions.

    position     points of the mechanism [m], `position["B"]`; velocity [m/s], acceleration [m/s^2]: points of the
                 polygons, measured from the pole, `velocity["b2"]`, `acceleration["b3'"]`
    theta, omega, alpha          by link [rad, rad/s, rad/s^2]
    s, s_rate, s_acceleration    by slide [m, m/s, m/s^2]
    sines        sine of the angle at which two lines or circles met, by plane and point
    misses       by how much two circles, or a line and a circle, miss each other [m]; 0 or less where they meet
    senses       +1 or -1: on which side of its change points a group lies that is found by fitting
    near         angles by base link and displacements by `slide_key` of a position close by: what is fitted starts
                 there, and angles are counted on from there
    follows      the positions follow one another closely: each angle counts on from the one before
    """

    facts: Facts
    near: Mapping[str, Value] = field(default_factory=dict)
    follows: bool = False
    position: dict[str, Value] = field(default_factory=dict)
    velocity: dict[str, Value] = field(default_factory=dict)
    acceleration: dict[str, Value] = field(default_factory=dict)
    theta: dict[str, Real] = field(default_factory=dict)
    omega: dict[str, Real] = field(default_factory=dict)
    alpha: dict[str, Real] = field(default_factory=dict)
    s: dict[str, Real] = field(default_factory=dict)
    s_rate: dict[str, Real] = field(default_factory=dict)
    s_acceleration: dict[str, Real] = field(default_factory=dict)
    sines: dict[tuple[Plane, str], Real] = field(default_factory=dict)
    misses: dict[str, Real] = field(default_factory=dict)
    senses: dict[str, Real] = field(default_factory=dict)

    @property
    def turn(self) -> Mapping[str, Real]:
        """Angles of links between 0 and a full turn [rad]."""
        return Lazy(self.theta, lambda link: within_a_turn(self.theta[link]))

    def points(self, plane: Plane) -> dict[str, Value]:
        return {"position": self.position, "velocity": self.velocity, "acceleration": self.acceleration}[plane]

    def arm(self, tail: str, head: str) -> Value:
        """Vector between two points of the mechanism [m]."""
        return self.position[head] - self.position[tail]

    def guide_direction(self, slide: str) -> Value:
        """Unit vector of a slide's line."""
        guide, _, direction = self.facts.lines[slide]
        return direction * np.exp(1j * self.theta[guide])

    def span(self, span: terms.Span) -> Value:
        """Sum of the parts, in the axes of their group's base link [m]."""
        total: Value = 0j
        for part in span.parts:
            if isinstance(part, Arm):
                shape = self.facts.shapes[part.link]
                turned = np.exp(1j * self.facts.relative_angle(part.link))
                total = total + (shape[part.head] - shape[part.tail]) * turned
            else:
                total = total + part.sign * self.s[part.slide] * self.slide_line(part.slide)
        return total

    def slide_line(self, slide: str) -> Value:
        """Unit vector of a slide's line, in the axes of its guide's base link."""
        guide, _, direction = self.facts.lines[slide]
        return direction * np.exp(1j * self.facts.relative_angle(guide))

    def direction(self, direction: terms.Direction) -> Value:
        """Unit vector of a direction."""
        match direction:
            case terms.Along(tail, head):
                return unit(self.arm(tail, head))
            case terms.Across(tail, head):
                return 1j * unit(self.arm(tail, head))
            case terms.AlongGuide(slide):
                return self.guide_direction(slide)
            case terms.AcrossGuide(slide):
                return 1j * self.guide_direction(slide)
            case terms.Quarter(link, tail, head):
                return 1j * np.sign(self.omega[link]) * unit(self.velocity[head] - self.velocity[tail])
            case _:
                assert_never(direction)

    def arrow(self, size: terms.Size, plane: Plane) -> Value:
        """The vector of a known term, in the units of its plane."""
        match size:
            case terms.Drawn(tail, head):
                points = self.points(plane)
                return points[head] - points[tail]
            case terms.Span():
                part = size.parts[0]
                link = part.link if isinstance(part, Arm) else self.facts.lines[part.slide][0]
                return self.span(size) * np.exp(1j * self.theta[self.facts.turns[link].base])
            case terms.Turning(link, tail, head):
                return 1j * self.omega[link] * self.arm(tail, head)
            case terms.Normal(link, tail, head):
                return -(self.omega[link] ** 2) * self.arm(tail, head)
            case terms.Tangential(link, tail, head):
                return 1j * self.alpha[link] * self.arm(tail, head)
            case terms.Coriolis(link, tail, head):
                return 2j * self.omega[link] * (self.velocity[head] - self.velocity[tail])
            case terms.Driven(slide, sign):
                known = self.s_rate if plane == "velocity" else self.s_acceleration
                return sign * known[slide] * self.guide_direction(slide)
            case terms.Relative():
                arm, facts = self.arm(size.tail, size.head), self.facts
                if size.part == "t":
                    return 1j * (facts.relative_rate(size.link, 2) - facts.relative_rate(size.seen_from, 2)) * arm
                rate = facts.relative_rate(size.link, 1) - facts.relative_rate(size.seen_from, 1)
                return -(rate**2) * arm if size.part == "n" else 1j * rate * arm
            case _:
                assert_never(size)

    def settle(self, quantity: str, base: str, value: Real, counted: bool = False, of: str = "") -> None:
        """Give a whole group of links that hold their angles to one another its angle or its rate.

        counted  the angle holds whole turns already, as that of a wheel that rolls does
        of       the link of the group from which it was read, for plots that keep count of that
        """
        table: dict[str, Real] = getattr(self, quantity)
        if quantity == "theta" and base in self.near and not counted:
            # with the whole turns that it has close by, or, where positions follow one another, just before
            near = self.near[base]
            if self.follows and np.ndim(value):
                angles, there = np.array(value), np.isfinite(value)
                angles[there] = np.unwrap(np.concatenate([[near], angles[there]]))[1:]
                value = angles
            else:
                value = value + 2 * np.pi * np.rint((near - value) / (2 * np.pi))
        order = ("theta", "omega", "alpha").index(quantity)
        for link in self.facts.groups[base]:
            more = self.facts.relative_rate(link, order) if order else self.facts.relative_angle(link)
            table[link] = value + more
