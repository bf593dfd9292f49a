"""The matrix method: velocities and accelerations from the loops' own matrix.

Derived once and twice, the loops give A y' = B and A y'' = -A' y' + B', with the drivers' rates on the right.
Source: Sun Huan, Theory of Machines, section 3-3, (3-21) to (3-29), written for any number of drivers.
"""

from __future__ import annotations

import numpy as np

from graphkin.analytic.loops import parts
from graphkin.analytic.newton import EquationSystem, inverse
from graphkin.analytic.vectors import Real, applied, through
from graphkin.base.value import frozen


@frozen
class Rates:
    """q', q'' (..., n), and the reciprocal condition number of A (...)."""

    first: Real
    second: Real
    condition: Real


def rates(closure: EquationSystem, q: Real, first: Real, second: Real) -> Rates:
    """Rates of the unknowns at q (..., n), for rates of the relations' right sides (k,)."""
    polar = closure.loops.vectors.polar(q)
    slope = closure.loops.slope(q, polar)
    inverted, condition = inverse(through(slope, closure.known.left))
    dq = _solved(closure, inverted, slope, first, np.zeros(slope.shape[:-1]))
    bend = applied(closure.loops.rows, closure.loops.vectors.acceleration(q, dq, np.zeros_like(dq), polar))
    ddq = _solved(closure, inverted, slope, second, parts(bend, -1))
    return Rates(dq, ddq, condition)


def tangent(closure: EquationSystem, q: Real, first: Real) -> tuple[Real, Real, Real]:
    """q' alone (p, n), the reciprocal condition number of A (p,), and its determinant's sign (p,), 1 if it has none.

    `first` (..., k) may differ from position to position. The sign changes only through a change point, or to another
    assembly.
    """
    slope = closure.loops.slope(q)
    matrix = through(slope, closure.known.left)
    inverted, condition = inverse(matrix)
    square = matrix.shape[-1] == matrix.shape[-2]
    sense = np.asarray(np.linalg.slogdet(matrix)[0]) if square else np.ones(len(q))
    return _solved(closure, inverted, slope, first, np.zeros(slope.shape[:-1])), condition, sense


def reaching(closure: EquationSystem, q: Real) -> Real:
    """The reciprocal condition number at q (p, n), far displacements and their loops measured by how far they reach.

    Beside guides that become parallel, blocks run off: rows and columns of many sizes there make A ill-conditioned long
    before it is singular.
    """
    slides = np.array([unknown.kind == "s" for unknown in closure.loops.unknowns])[closure.known.free]
    reach = np.where(slides, np.maximum(np.abs(q[..., closure.known.free]), 1.0), 1.0)
    matrix = closure.matrix(q) * reach[..., None, :]
    farthest = np.max(np.abs(matrix[..., slides]), axis=-1, initial=1.0, keepdims=True)
    return inverse(matrix / farthest)[1]


def _solved(closure: EquationSystem, inverted: Real, slope: Real, given: Real, rest: Real) -> Real:
    """The x with W x = given and slope x + rest = 0."""
    driven = applied(closure.known.given, given)
    right = -(slope @ driven[..., None])[..., 0] - rest
    return np.asarray(driven + applied(closure.known.left, (inverted @ right[..., None])[..., 0]))
