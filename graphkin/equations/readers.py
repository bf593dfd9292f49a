"""Where on the analytic solution each letter's value is read: angles and displacements with their rates.

Links and slots that stand for cams and rolling (the lower-pair equivalent) are no links of the mechanism; their
values follow from the points they join.
"""

from __future__ import annotations

import cmath

import numpy as np

from graphkin.analytic import Motion
from graphkin.base.geometry import Value
from graphkin.equations.legend import Reader
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Slide
from graphkin.planning.structure import Topology

Three = tuple[Reader, Reader, Reader]


def angle_readers(structure: Topology, body: str, drawn: Motion) -> Three:
    """θ, ω, α of a body [rad, rad/s, rad/s^2]; of a link of the equivalent, by its two points."""
    if structure.is_pin(body):
        slide = structure.pins[body]
        return turned(angle_readers(structure, slide.guide, drawn), cmath.phase(slide.line.direction))
    if not structure.is_link(body):
        tail, head = structure.bodies[body][:2]
        return _between(tail, head, drawn)
    return (lambda motion: motion.theta[body], lambda motion: motion.omega[body], lambda motion: motion.alpha[body])


def turned(readers: Three, by: float) -> Three:
    """The same, of a body fixed at an angle to it [rad]."""
    theta, omega, alpha = readers
    return lambda motion: theta(motion) + by, omega, alpha


def difference(first: Three, second: Three) -> Three:
    """One body against another."""

    def minus(one: Reader, other: Reader) -> Reader:
        return lambda motion: one(motion) - other(motion)

    return minus(first[0], second[0]), minus(first[1], second[1]), minus(first[2], second[2])


def _between(tail: str, head: str, drawn: Motion) -> Three:
    """Of a link of the equivalent: its angle counts on from the drawn position, as rolling wants it."""

    def arm(motion: Motion) -> Value:
        return motion.position[head] - motion.position[tail]

    def omega(motion: Motion) -> Value:
        return np.imag((motion.velocity[head] - motion.velocity[tail]) / arm(motion))

    def alpha(motion: Motion) -> Value:
        return np.imag((motion.acceleration[head] - motion.acceleration[tail]) / arm(motion))

    def theta(motion: Motion) -> Value:
        return np.angle(arm(drawn)) + np.angle(arm(motion) / arm(drawn))

    return theta, omega, alpha


def place(structure: Topology, point: str, body: str, motion: Motion) -> Value:
    """Where a point of a body is [m], also one that stands for a parallel of the equivalent."""
    if point in motion.position:
        return motion.position[point]
    shape = structure.shapes[body]
    known = next((p for p in shape if p in motion.position), None)
    base = motion.position[known] - _arm(motion, body, shape[known]) if known is not None else 0.0
    return base + _arm(motion, body, shape[point])


def _arm(motion: Motion, body: str, arm: complex) -> Value:
    return arm * np.exp(1j * motion.theta[body])


def slide_readers(structure: Topology, slide: Slide) -> Three:
    """s, its rate and second rate, from the motion of the point as seen on the guide [m, m/s, m/s^2]."""
    guide, point, origin = slide.guide, slide.point, slide.line.origin

    def along(motion: Motion) -> Value:
        return np.exp(-1j * motion.theta[guide]) * np.conj(slide.line.direction)

    def s(motion: Motion) -> Value:
        return np.real(along(motion) * (motion.position[point] - place(structure, origin, guide, motion)))

    def seen(motion: Motion) -> Value:
        return motion.velocity[point] - motion.velocity_at(point, guide)

    def rate(motion: Motion) -> Value:
        return np.real(along(motion) * seen(motion))

    def push(motion: Motion) -> Value:
        turning = 2j * (0.0 if guide == FRAME else motion.omega[guide]) * seen(motion)
        whole = motion.acceleration[point] - motion.acceleration_at(point, guide)
        return np.real(along(motion) * (whole - turning))

    return s, rate, push
