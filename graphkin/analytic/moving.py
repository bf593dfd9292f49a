"""From the drawn position to other driver values, by moving on: so the assembly is kept.

Positions on one straight line of driver values (any sweep of one driver) share one path. Beside a change point they are
told by positions on both sides of it. Other positions go each its own way, in sub-steps along the tangent that are
closed by Newton, and taken back and halved where Newton has to go far.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.analytic.loops import Flags, Indices, Reals
from graphkin.analytic.newton import Closed, EquationSystem, close, tangent
from graphkin.analytic.path import MotionPath, RightSides, path_along
from graphkin.base.geometry import weights_of
from graphkin.base.value import frozen

_SAME = 1e-12  # right sides that differ by less are the same [rad, m]
_STRIDE = 0.0517  # longest sub-step of a driver [rad]: 2.96 deg, an odd number so that sub-steps miss the change points
_LENGTH_STRIDE = 0.02  # the same for a displacement, in units of the mechanism's size
_SHORTEST = 1e-5  # sub-steps this much shorter than the longest are the end of the way
_CROSSING = 2e-5
"""Through a change point only by sub-steps this much shorter: longer ones could cut across to another assembly."""
_MARGIN = 4 * _SHORTEST
"""So near its end a way still counts as leading there: a dead point itself is reached by Newton only."""
_REACH = 0.2  # longest sub-step of any unknown in the loops [rad, size]
_SWERVE, _SLIP = 0.15, 0.005
"""The turning over a sub-step may differ so much between its ends, and from their mean [rad, size].

Two assemblies that come close to each other turn in opposite senses there: more than this, and it is another one.
"""
_TRUST = 0.1  # Newton may correct a sub-step by this much [rad, size]


_AS_BEFORE = 1e-9  # a turn that ends so near to where it began comes there again and again [rad, size]
_ASIDE, _PLACES = 0.25, np.array([-4, -3, -2, -1, 1, 2, 3, 4], dtype=float)
"""Neighbours of a change point: how far apart, in longest steps of a path, and where."""
_ALIKE, _NEARER = 1e-7, 4
"""All neighbours and the inner six may tell the change point so far apart [rad, size]; else nearer ones are taken."""
_CLEAR = 10  # the outermost neighbour is not so near another change point, or the end, as this many times its distance


@frozen
class Limit:
    """Positions beside a change point, as weighted sums of neighbours on both sides. rows (m,) which positions; q (8,
    n) the neighbours' unknowns; weights (m, 8)."""

    rows: Indices
    q: Reals
    weights: Reals


def moved(closure: EquationSystem, start: Reals, c: Reals, change: Reals) -> tuple[Reals, list[Limit]]:
    """Unknowns (p, n) where the right sides are c (k,) + change (p, k), and the positions beside change points. nan
    where the way does not lead. `start` are the unknowns (n,) at c."""
    goals = np.full((len(change), len(start)), np.nan)
    there = np.flatnonzero(np.isfinite(change).all(axis=1))
    if not there.size:
        return goals, []
    q, done = np.broadcast_to(start, (len(there), len(start))), np.zeros(len(there))
    if (on_line := _on_line(closure, start, c, change[there])) is None:
        # every position on its own straight path
        for q, done in _walk(closure, start, c, change[there]):  # noqa: B007 - the last one counts
            pass
        closed = close(closure, q, c + change[there], steps=25)
        reached = done >= 1 - _MARGIN * _longest(closure, change[there])
        goals[there] = np.where((reached & _good(closure, closed, q))[:, None], closed.q, np.nan)
        return goals, []
    goals[there], limits = on_line
    return goals, [Limit(there[limit.rows], limit.q, limit.weights) for limit in limits]


def _on_line(closure: EquationSystem, start: Reals, c: Reals, change: Reals) -> tuple[Reals, list[Limit]] | None:
    """Positions on one line: straight to it, then all at once along its path; None where no line joins them."""
    base, direction = change[0], change[int(np.argmax(np.abs(change - change[0]).sum(axis=1)))] - change[0]
    square = float(direction @ direction)
    if square < _SAME**2:
        base, direction = np.zeros_like(base), base
    else:
        base = base - direction * float(base @ direction) / square
    along = (change - base) @ direction / max(float(direction @ direction), np.finfo(float).tiny)
    if not np.allclose(base + along[:, None] * direction, change, rtol=0, atol=_SAME):
        return None
    if np.max(np.abs(base), initial=0.0) > _SAME:
        aside = path_along(RightSides(closure, c, base), start, 0.0, 1.0)
        if aside.at[-1] < 1.0:
            return None
        start, c = aside.between(np.ones(1))[0], c + base
    line = RightSides(closure, c, direction)
    beyond = 4 * _ASIDE * line.longest if np.any(direction) else 0.0
    ends = min(along.min(), 0.0) - beyond, max(along.max(), 0.0) + beyond
    if ends[1] - ends[0] > 2 * line.turn and (by_turn := _turn_by_turn(line, start, along, beyond)) is not None:
        return by_turn
    return _on(path_along(line, start, *ends), along)


def _turn_by_turn(line: RightSides, start: Reals, along: Reals, beyond: float) -> tuple[Reals, list[Limit]] | None:
    """The same by the path of one turn, where that ends as it began; None where it does not."""
    path = path_along(line, start, -beyond, line.turn + beyond)
    begin, end = _closed_at(path, np.array([0.0, line.turn]))
    whole = np.where(line.slides, 0.0, 2 * np.pi * np.round((end - begin) / (2 * np.pi)))
    gone = np.where(line.heard, whole, end - begin)  # a wheel in no loop may stand anyhow
    if not np.max(np.abs(end - begin - gone), initial=0.0) < _AS_BEFORE:
        return None
    turns = np.floor(along / line.turn)
    q, limits = _on(path, along - turns * line.turn)
    return q + turns[:, None] * gone, limits


def _on(path: MotionPath, along: Reals) -> tuple[Reals, list[Limit]]:
    q = _closed_at(path, along)
    limits = [limit for change in path.changes if (limit := _beside(path, along, change)) is not None]
    for limit in limits:
        q[limit.rows] = limit.weights @ limit.q
    return q, limits


def _closed_at(path: MotionPath, along: Reals) -> Reals:
    line, guess = path.line, path.between(along)
    closed = close(line.closure, guess, line.c + along[:, None] * line.toward, steps=25)
    margin = _MARGIN * line.longest
    reached = (along >= path.at[0] - margin) & (along <= path.at[-1] + margin)
    return np.where((reached & _good(line.closure, closed, guess))[:, None], closed.q, np.nan)


def _beside(path: MotionPath, along: Reals, change: float) -> Limit | None:
    """The positions beside a change point; none where its neighbours are not all reached."""
    others = [*(abs(change - other) for other in path.changes if other != change), *np.abs(path.at[[0, -1]] - change)]
    aside = min(_ASIDE * path.line.longest, min(others) / _CLEAR)
    if not np.any(np.abs(along - change) < aside):
        return None
    for _ in range(_NEARER):
        q = _closed_at(path, change + aside * _PLACES)
        if not np.isfinite(q).all():
            return None
        if np.max(np.abs((weights_of(np.zeros(1), _PLACES) - _MIDDLE) @ q)) < _ALIKE:
            break
        aside /= 2
    rows = np.flatnonzero(np.abs(along - change) < aside)
    return Limit(rows, q, weights_of((along[rows] - change) / aside, _PLACES))


_MIDDLE = np.concatenate([[0.0], weights_of(np.zeros(1), _PLACES[1:-1])[0], [0.0]])
"""The change point itself by the inner neighbours alone."""


def _walk(closure: EquationSystem, start: Reals, c: Reals, change: Reals) -> Iterator[tuple[Reals, Reals]]:
    """Yield (q (p, n), share of the way done (p,)) after each sub-step, until all arrive or are stuck."""
    q, done = np.repeat(start[None], len(change), axis=0), np.zeros(len(change))
    longest, heard = _longest(closure, change), closure.loops.moves(closure.loops.rows)
    stride, (slope, _, side) = longest.copy(), tangent(closure, q, change)
    while (active := (done < 1) & (stride > _SHORTEST * longest)).any():
        toward = slope[active]
        fastest = np.max(np.abs(toward[:, heard]), axis=1, initial=0.0)
        share = np.minimum(stride[active], _REACH / np.maximum(fastest, _REACH))
        ahead = np.where(done[active] + share > 1 - 1e-12, 1.0, done[active] + share)
        step = (ahead - done[active])[:, None]
        tried = q[active] + step * toward
        closed = close(closure, tried, c + ahead[:, None] * change[active], steps=7)
        onward, _, beyond = tangent(closure, closed.q, change[active])
        swerve = np.abs(step * (onward - toward))
        slip = np.abs(closed.q - q[active] - step * (onward + toward) / 2)
        smooth = (np.max(swerve[:, heard], axis=1, initial=0.0) < _SWERVE) & (
            np.max(slip[:, heard], axis=1, initial=0.0) < _SLIP
        )
        same = (beyond == side[active]) | (share <= _CROSSING * longest[active])
        good = _good(closure, closed, tried) & smooth & same
        stride[active] = np.where(good, np.minimum(2 * share, longest[active]), share / 2)
        q[active] = np.where(good[:, None], closed.q, q[active])
        slope[active] = np.where(good[:, None], onward, toward)
        side[active] = np.where(good, beyond, side[active])
        done[active] = np.where(good, ahead, done[active])
        yield q.copy(), done.copy()


def _longest(closure: EquationSystem, change: Reals) -> Reals:
    """The longest sub-step of each position, as a share of its way: (p,)."""
    lengths = np.max(np.abs(closure.weights), axis=1, initial=0.0) == closure.loops.size
    angle = np.where(lengths, _STRIDE / _LENGTH_STRIDE / closure.loops.size, 1.0)
    far = np.max(np.abs(change) * angle, axis=1, initial=0.0)
    return np.asarray(np.minimum(1.0, _STRIDE / np.maximum(far, _STRIDE)))


def _good(closure: EquationSystem, closed: Closed, tried: Reals) -> Flags:
    """Closed, settled, and not far from where it was expected."""
    away = np.abs(closed.q - tried)[:, closure.loops.moves(closure.loops.rows)]
    near = np.max(away, axis=-1, initial=0.0) < _TRUST
    return np.asarray((closed.gap < 1e-6) & (closed.step < 1e-8) & near)
