"""From the drawn position to other driver values, by moving on: so the assembly is kept.

Each sub-step goes along the tangent and is then closed by Newton; it is taken back and halved where
Newton has to go far, so that a dead point is found as the end of the way and not jumped over.
Positions on one straight line of driver values (any sweep of one driver) share one way.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from graphkin.analytic.newton import Closed, Closure, close
from graphkin.analytic.rates import tangent
from graphkin.analytic.vectors import Real

__all__ = ["moved"]

_STRIDE = 0.0517
"""Longest sub-step of a driver [rad]: 2.96 deg, an odd number so that sub-steps miss the change points."""
_LENGTH_STRIDE = 0.02
"""The same for a displacement, in units of the mechanism's size."""
_SHORTEST = 1e-5
"""Sub-steps this much shorter than the longest are the end of the way."""
_CROSSING = 2e-5
"""Through a change point only by sub-steps this much shorter: longer ones could cut across to another assembly."""
_MARGIN = 4 * _SHORTEST
"""So near its end a way still counts as leading there: a dead point itself is reached by Newton only."""
_REACH = 0.2
"""Longest sub-step of any unknown in the loops [rad, size]."""
_SWERVE, _SLIP = 0.15, 0.005
"""How much the turning over a sub-step may differ between its ends, and from their mean [rad, size].

Two assemblies that come close to each other turn in opposite senses there: more than this, and it is another one.
"""
_TRUST = 0.1
"""Newton may correct a sub-step by this much [rad, size]."""


def moved(closure: Closure, start: Real, c: Real, change: Real) -> Real:
    """Unknowns (p, n) where the right sides are c (k,) + change (p, k); nan where the way does not lead.

    start   the unknowns (n,) at c
    """
    goals = np.full((len(change), len(start)), np.nan)
    finite = np.isfinite(change).all(axis=1)
    if not finite.any():
        return goals
    change = change[finite]
    line = change[int(np.argmax(np.abs(change).sum(axis=1)))]
    along = change @ line / max(float(line @ line), np.finfo(float).tiny)
    if np.allclose(along[:, None] * line, change, rtol=0, atol=1e-12):
        goals[finite] = _on_line(closure, start, c, line, along)
    else:
        goals[finite] = _fanned(closure, start, c, change)
    return goals


def _fanned(closure: Closure, start: Real, c: Real, change: Real) -> Real:
    """Every position on its own straight way."""
    q, done = np.broadcast_to(start, (len(change), len(start))), np.zeros(len(change))
    for q, done in _walk(closure, start, c, change):  # noqa: B007 - the last one counts
        pass
    closed = close(closure, q, c + change, steps=25)
    reached = done >= 1 - _MARGIN * _longest(closure, change)
    return np.where((reached & _good(closure, closed, q))[:, None], closed.q, np.nan)


def _on_line(closure: Closure, start: Real, c: Real, line: Real, along: Real) -> Real:
    """Positions at c + along (p,) line: one way, and from its sub-steps to each position."""
    back, forth = (_way(closure, start, c, line, end) for end in (along.min(), along.max()))
    at = np.concatenate([back[0][:0:-1], forth[0]])
    nodes = np.concatenate([back[1][:0:-1], forth[1]])
    guess = _between(at, nodes, tangent(closure, nodes, line), along)
    closed = close(closure, guess, c + along[:, None] * line, steps=25)
    margin = _MARGIN * _longest(closure, line[None])[0]
    reached = (along >= at[0] - margin) & (along <= at[-1] + margin)
    return np.where((reached & _good(closure, closed, guess))[:, None], closed.q, np.nan)


def _way(closure: Closure, start: Real, c: Real, line: Real, end: float) -> tuple[Real, Real]:
    """Sub-steps from 0 to `end` along the line: how far (w,), and the unknowns there (w, n)."""
    at, nodes = [0.0], [start]
    if end != 0:
        for q, done in _walk(closure, start, c, end * line[None]):
            if end * done[0] != at[-1]:
                at.append(end * float(done[0]))
                nodes.append(q[0])
    return np.array(at), np.array(nodes)


def _between(at: Real, nodes: Real, slopes: Real, along: Real) -> Real:
    """Cubic Hermite between sub-steps: (p, n)."""
    if len(at) == 1:
        return np.broadcast_to(nodes[0], (len(along), nodes.shape[1]))
    right = np.clip(np.searchsorted(at, along), 1, len(at) - 1)
    left, width = right - 1, (at[right] - at[right - 1])[:, None]
    t = (along[:, None] - at[left][:, None]) / width
    ends = nodes[left] * (1 + 2 * t) * (1 - t) ** 2 + nodes[right] * t**2 * (3 - 2 * t)
    bends = slopes[left] * t * (1 - t) ** 2 - slopes[right] * t**2 * (1 - t)
    return np.asarray(ends + width * bends)


def _walk(closure: Closure, start: Real, c: Real, change: Real) -> Iterator[tuple[Real, Real]]:
    """Yield (q (p, n), share of the way done (p,)) after each sub-step, until all arrive or are stuck."""
    q, done = np.repeat(start[None], len(change), axis=0), np.zeros(len(change))
    longest, heard = _longest(closure, change), closure.loops.moves(closure.loops.rows)
    stride, slope, side = longest.copy(), tangent(closure, q, change), _side(closure, q)
    while (active := (done < 1) & (stride > _SHORTEST * longest)).any():
        toward = slope[active]
        fastest = np.max(np.abs(toward[:, heard]), axis=1, initial=0.0)
        share = np.minimum(stride[active], _REACH / np.maximum(fastest, _REACH))
        ahead = np.where(done[active] + share > 1 - 1e-12, 1.0, done[active] + share)
        step = (ahead - done[active])[:, None]
        tried = q[active] + step * toward
        closed = close(closure, tried, c + ahead[:, None] * change[active], steps=7)
        onward = tangent(closure, closed.q, change[active])
        swerve = np.abs(step * (onward - toward))
        slip = np.abs(closed.q - q[active] - step * (onward + toward) / 2)
        smooth = (np.max(swerve[:, heard], axis=1, initial=0.0) < _SWERVE) & (
            np.max(slip[:, heard], axis=1, initial=0.0) < _SLIP
        )
        beyond = _side(closure, closed.q)
        same = (beyond == side[active]) | (share <= _CROSSING * longest[active])
        good = _good(closure, closed, tried) & smooth & same
        stride[active] = np.where(good, np.minimum(2 * share, longest[active]), share / 2)
        q[active] = np.where(good[:, None], closed.q, q[active])
        slope[active] = np.where(good[:, None], onward, toward)
        side[active] = np.where(good, beyond, side[active])
        done[active] = np.where(good, ahead, done[active])
        yield q.copy(), done.copy()


def _side(closure: Closure, q: Real) -> Real:
    """The sign of the matrix's determinant: it changes only through a change point, or to another assembly."""
    matrix = closure.matrix(q)
    square = matrix.shape[-1] == matrix.shape[-2]
    return np.asarray(np.linalg.slogdet(matrix)[0]) if square else np.ones(len(q))


def _longest(closure: Closure, change: Real) -> Real:
    """The longest sub-step of each position, as a share of its way: (p,)."""
    lengths = np.max(np.abs(closure.weights), axis=1, initial=0.0) == closure.loops.size
    angle = np.where(lengths, _STRIDE / _LENGTH_STRIDE / closure.loops.size, 1.0)
    way = np.max(np.abs(change) * angle, axis=1, initial=0.0)
    return np.asarray(np.minimum(1.0, _STRIDE / np.maximum(way, _STRIDE)))


def _good(closure: Closure, closed: Closed, tried: Real) -> NDArray[np.bool_]:
    """Closed, settled, and not far from where it was expected."""
    away = np.abs(closed.q - tried)[:, closure.loops.moves(closure.loops.rows)]
    near = np.max(away, axis=-1, initial=0.0) < _TRUST
    return np.asarray((closed.gap < 1e-6) & (closed.step < 1e-8) & near)
