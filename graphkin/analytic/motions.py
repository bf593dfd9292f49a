"""The motion of every link, slide and point, at the drawn position or at many driver values at once."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from graphkin.analytic.assembly import drawn, held, idle
from graphkin.analytic.loops import Complex, Flags, Indices, Loops, Reals, applied
from graphkin.analytic.newton import EquationSystem, Rates, inverse, rates, reaching
from graphkin.analytic.rules import driven
from graphkin.base.value import bulky
from graphkin.errors import SingularPosition, ValueForEach
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Mechanism

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from graphkin.analytic.moving import Limit

SINGULAR = 1e-5
"""Reciprocal condition below which velocities count as not determined.

A position is known to rounding / condition there, a velocity to rounding / condition^2: six digits. More, where it is
only displacements far off that make the condition bad: there they are measured by how far they reach.
"""


@bulky
class Motion(Motions):
    """The motions by the analysis. Every value has the shape of the driver values: () for one position.

    values                  each driver's value, in their order [rad or m]
    theta, omega, alpha     the frame's, too; theta on any branch
    velocity, acceleration  by point, complex [m/s, m/s^2]
    condition               reciprocal condition number, 0 at a dead point
    idle                    links whose rotation nothing shows: it is given as 0

    nan where the drivers' values cannot be reached by moving on from the drawn position, either way round; at a dead
    point velocities and accelerations are nan, too.
    """

    values: tuple[Reals, ...]
    velocity: Mapping[str, Complex]
    acceleration: Mapping[str, Complex]
    condition: Reals
    idle: tuple[str, ...]


def motion(mechanism: Mechanism, values: Sequence[ArrayLike] | None = None) -> Motion:
    """Position, velocity and acceleration by closed vector loops and the matrix method.

    values   one entry a driver, scalar or array, broadcast together [rad or m]; None: the drawn position.
    Drivers keep their rates and accelerations at every position. Raises NoAssembly for the drawn position,
    SingularPosition if that, or a single position asked for, is a dead point: no way leads on from it.
    """
    start = drawn(mechanism)
    closure, first = driving(mechanism, start.loops, start.closure)
    given = start.values if values is None else values
    if len(given) != len(mechanism.drivers):
        names = tuple(driver.name for driver in mechanism.drivers)
        raise ValueForEach(mechanism.where("driver"), len(given), names)
    goals = tuple(np.broadcast_arrays(*(np.asarray(value, dtype=np.float64) for value in given)))
    shape = goals[0].shape if goals else ()
    flat = np.stack([value.ravel() for value in goals], axis=-1) if goals else np.zeros((1, 0))
    change = np.zeros((len(flat), len(closure.weights)))
    change[:, first:] = flat - np.array(start.values).reshape(-1)
    if shape or change.any():  # else its rates tell
        condition = inverse(closure.matrix(start.q[None]))[1]
        if not _clear(closure, start.q[None], condition).all():
            raise SingularPosition(mechanism.where("driver"), float(condition[0]))
    limits: list[Limit] = []
    q = np.repeat(start.q[None], len(change), axis=0)
    if np.any(change):
        from graphkin.analytic.moving import moved

        now = closure.weights @ start.q
        q, limits = moved(closure, start.q, now, change)
        if (lost := _lost(mechanism, q, change)).size:  # an angle and one a turn from it are the same position
            other = change[lost]
            turning = [False] * first + [driver.kind == "angle" for driver in mechanism.drivers]
            other -= np.where(turning & (other != 0), np.copysign(2 * np.pi, other), 0.0)
            q[lost], more = moved(closure, start.q, now, other)
            limits += [replace(limit, rows=lost[limit.rows]) for limit in more]
    result = _rates_of(mechanism, closure, first, q, single=shape == ())
    for limit in limits:
        beside = _rates_of(mechanism, closure, first, limit.q, single=False)
        result.first[limit.rows] = limit.weights @ beside.first
        result.second[limit.rows] = limit.weights @ beside.second
    q, dq, ddq = (part.reshape(*shape, part.shape[-1]) for part in (q, result.first, result.second))
    return _motion(mechanism, closure, goals, q, Rates(dq, ddq, result.condition.reshape(shape)))


def _lost(mechanism: Mechanism, q: Reals, change: Reals) -> Indices:
    """The positions that were not reached, of mechanisms in which none hangs on how often a wheel has rolled round."""
    rolling = any(pair.rolling is not None for pair in mechanism.pairs)
    return np.flatnonzero(np.isnan(q).any(axis=1) & np.isfinite(change).all(axis=1) & (not rolling))


def _clear(closure: EquationSystem, q: Reals, condition: Reals) -> Flags:
    """True where velocities are determined, at q (p, n): (p,); also where it is only far displacements that weigh."""
    clear = condition >= SINGULAR
    if (doubtful := np.flatnonzero(~clear)).size:
        clear[doubtful] = reaching(closure, q[doubtful]) >= SINGULAR
    return clear


def driving(mechanism: Mechanism, loops: Loops, drawn: EquationSystem | None = None) -> tuple[EquationSystem, int]:
    """Loops closed with the drivers, and the first driver's row among the relations; the system that gave the drawn
    position may be the same."""
    drivers = tuple(driven(mechanism, driver) for driver in mechanism.drivers)
    pairs = loops.relations
    still = held(loops, (*pairs, *drivers))
    return EquationSystem.of(loops, (*pairs, *still, *drivers), drawn), len(pairs) + len(still)


def _rates_of(mechanism: Mechanism, closure: EquationSystem, first: int, q: Reals, single: bool) -> Rates:
    """Rates at q (p, n); nan where q is nan and at dead points."""
    speed, push = np.zeros((2, len(closure.weights)))
    speed[first:] = [driver.rate for driver in mechanism.drivers]
    push[first:] = [driver.acceleration for driver in mechanism.drivers]
    there = np.isfinite(q).all(axis=1)
    result = rates(closure, q[there], speed, push)
    clear = _clear(closure, q[there], result.condition)[:, None]
    if single and there.all() and not clear.all():
        raise SingularPosition(mechanism.where("driver"), float(result.condition[0]))
    full = np.full((3, *q.shape), np.nan)
    full[0, there] = np.where(clear, result.first, np.nan)
    full[1, there] = np.where(clear, result.second, np.nan)
    full[2, there] = result.condition[:, None]
    return Rates(full[0], full[1], full[2, :, 0])


def _motion(mechanism: Mechanism, closure: EquationSystem, values: tuple[Reals, ...], q: Reals, rated: Rates) -> Motion:
    """Read everything off the unknowns, points by name in SI units."""
    loops, vectors = closure.loops, closure.loops.vectors
    three = q, rated.first, rated.second
    still = np.zeros(q.shape[:-1])[()]
    along = [pair.name for pair in mechanism.pairs if pair.path is not None]
    theta, omega, alpha = ({FRAME: still, **_by_name(loops, part, "theta", mechanism.moving)} for part in three)
    s, s_rate, s_acceleration = (_by_name(loops, part, "s", along) for part in three)
    polar, points = vectors.polar(q), []
    for arrows in (vectors.at(q, polar), vectors.rate(*three[:2], polar), vectors.acceleration(*three, polar)):
        places = np.ascontiguousarray(np.moveaxis(applied(loops.places, arrows), -1, 0)) * loops.size
        points.append({point: place[()] for point, place in zip(loops.points, places, strict=True)})
    position, velocity, acceleration = points
    # of each link its first point; others are read as its image, so that this, too, is held against the loops
    firsts = {link: next(iter(mechanism.links[link].points)) for link in mechanism.moving}
    v, a = ({link: {point: of[point]} for link, point in firsts.items()} for of in (velocity, acceleration))
    return Motion(
        mechanism, theta, omega, alpha, s, s_rate, s_acceleration, position,
        v, a, values, velocity, acceleration, rated.condition[()], idle(mechanism, loops),
    )  # fmt: skip


def _by_name(loops: Loops, values: Reals, kind: str, names: Collection[str]) -> dict[str, Reals]:
    """Unknowns of one kind by name, those of the analysis' own making left out, in SI units."""
    return {unknown.name: np.asarray(values[..., at] * loops.unit[at])[()]
            for at, unknown in enumerate(loops.unknowns)
            if unknown.kind == kind and unknown.name in names}  # fmt: skip
