"""Many mechanisms of one topology at their drawn positions at once: their numbers lie side by side in arrays (b,).

A sketch that is exact leads to its assembly by Newton. Else every loop that two unknowns close is closed both ways by
formula, and the assembly nearest to the sketch is taken. What that does not settle beyond doubt (loops that close
together, another assembly as near, displacements the wrong way round, dead points) is left to `motion`, one by one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from graphkin.analytic.assembly import (
    EXACT,
    columns,
    drawn_lengths,
    driver_values,
    sketched,
    standing,
    taken_forwards,
)
from graphkin.analytic.blocks import NOTHING, in_order
from graphkin.analytic.branching import SAME
from graphkin.analytic.dyads import ways_of
from graphkin.analytic.loops import Loops, loops_with, size_of
from graphkin.analytic.motions import SINGULAR, Motion, driving, motion_of, rates_of
from graphkin.analytic.newton import EquationSystem, close, inverse
from graphkin.analytic.rules import Joint, Relation, Share, shares
from graphkin.analytic.sketch import guess
from graphkin.analytic.vectors import Complex, Real, applied
from graphkin.geometry import Value
from graphkin.mechanism import Mechanism
from graphkin.pairs import Slide
from graphkin.stacking import coincidences, stacked
from graphkin.tolerances import ROUNDED
from graphkin.value import frozen

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]
_MOST = 6
"""Loops that are closed both ways in every combination."""
_OPEN = 1e-4
"""A combination that leaves loops open by more closes none [size]."""
_CLEAR = 1e-3
"""Reciprocal condition from which an assembly has no other close by."""


@frozen
class Many:
    """The motions of many mechanisms, every value (b,), and which of them are sure; the rest is nan."""

    motion: Motion
    sure: Flags

    def of(self, row: int, mechanism: Mechanism) -> Motion:
        """One mechanism's own."""
        many = self.motion

        def own(table: Mapping[str, Value]) -> dict[str, Value]:
            return {name: value[row] if np.ndim(value) else value for name, value in table.items()}

        return Motion(
            mechanism, own(many.theta), own(many.omega), own(many.alpha), own(many.s), own(many.s_rate),
            own(many.s_acceleration), own(many.position),
            {link: own(table) for link, table in many.velocities.items()},
            {link: own(table) for link, table in many.accelerations.items()},
            tuple(value[row] for value in many.values), own(many.velocity), own(many.acceleration),
            many.condition[row], many.idle,
        )  # fmt: skip


def motions(mechanisms: Sequence[Mechanism]) -> Many | None:
    """Position, velocity and acceleration of mechanisms of one topology; None where their loops are not alike.

    >>> from graphkin import library
    >>> found = motions([library.load("ex3-1"), library.load("ex3-1")])
    >>> found.sure, found.motion.omega["3"].round(5)
    (array([ True,  True]), array([-3.91933, -3.91933]))
    """
    mechanism, count = stacked(mechanisms), len(mechanisms)
    if (brought := _brought(mechanism, mechanisms)) is None:
        return None
    loops = loops_with(mechanism, brought, np.array([*map(size_of, mechanisms)]))
    closure, first = driving(mechanism, loops)
    q = _drawn(mechanism, loops)
    found = rates_of(mechanism, closure, first, q, single=False)
    sure = np.nan_to_num(found.condition) >= SINGULAR
    values = tuple(np.broadcast_to(value, (count,)) for value in driver_values(mechanism, loops, q))
    return Many(motion_of(mechanism, closure, values, q, found), sure)


def _brought(mechanism: Mechanism, mechanisms: Sequence[Mechanism]) -> tuple[Share, ...] | None:
    """What pairs bring, side by side; of slides and hinges, whose numbers lie side by side, at once."""
    if all(isinstance(pair, Slide) for pair in mechanism.pairs):
        return tuple(shares(mechanism))
    of_each = [tuple(shares(one)) for one in mechanisms]
    if any(_without_numbers(brought) != _without_numbers(of_each[0]) for brought in of_each):
        return None
    return tuple(_share(each) for each in zip(*of_each, strict=True))


def _without_numbers(brought: Sequence[Share]) -> list[object]:
    return [
        ([(joint.tail, joint.head, joint.slide) for joint in share.joints],
         [(relation.offset is None, [*relation.weights]) for relation in share.relations])
        for share in brought
    ]  # fmt: skip


def _share(of_each: Sequence[Share]) -> Share:
    joints = tuple(_joint(each) for each in zip(*(share.joints for share in of_each), strict=True))
    return Share(joints, tuple(_relation(each) for each in zip(*(share.relations for share in of_each), strict=True)))


def _joint(of_each: Sequence[Joint]) -> Joint:
    arms = ([getattr(joint, name) for joint in of_each] for name in ("tail_arm", "head_arm", "direction"))
    tail_arm, head_arm, direction = map(np.array, arms)
    return replace(of_each[0], tail_arm=tail_arm, head_arm=head_arm, direction=direction)


def _relation(of_each: Sequence[Relation]) -> Relation:
    weights = {unknown: np.array([each.weights[unknown] for each in of_each]) for unknown in of_each[0].weights}
    offset = None if of_each[0].offset is None else np.array([each.offset for each in of_each])
    return Relation(weights, offset)


def _drawn(mechanism: Mechanism, loops: Loops) -> Real:
    """The drawn positions (b, n), nan where they are not sure."""
    relations, c = standing(mechanism, loops)
    closure, q = EquationSystem.of(loops, relations), np.full((len(c), len(loops.unknowns)), np.nan)
    if not closure.known.mismatch(c) < ROUNDED:
        return q
    backwards, forwards = drawn_lengths(mechanism, loops), taken_forwards(mechanism)
    rows, places = sketched(mechanism, loops)
    every = _Search(
        closure, c, guess(mechanism, loops), rows, places / loops.size[:, None], columns(loops, backwards),
        columns(loops, forwards),
    )  # fmt: skip
    alike = _alike(mechanism, closure)
    for way in (_Search.at_sketch, _Search.nearest):
        left = np.flatnonzero(alike & np.isnan(q).any(axis=1))
        if left.size:
            q[left] = way(every.of_some(left))
    return q


def _alike(mechanism: Mechanism, closure: EquationSystem) -> Flags:
    """Which mechanisms have the same coefficients that are nothing as the first, so that all is alike in kind: (b,)."""
    tables = closure.loops.rows, closure.known.left, *closure.loops.points.values()
    patterns = np.hstack([np.abs(table).reshape(len(closure.weights), -1) > NOTHING for table in tables])
    special = coincidences(mechanism)
    same = special == special[..., :1] if special.ndim == 2 else True
    return np.asarray((patterns == patterns[0]).all(axis=1) & np.all(same, axis=0))


@frozen
class _Search:
    """The assemblies of many mechanisms, each with its own sketch.

    seen      what the sketch shows of the unknowns (b, n), nan elsewhere
    rows, places  of the sketched points (b, k, m), and where they are sketched (b, k) [size]
    backwards, forwards   columns of displacements that must be, or are taken, positive
    """

    closure: EquationSystem
    c: Real
    seen: Real
    rows: Complex
    places: Complex
    backwards: list[int]
    forwards: list[int]

    def of_some(self, some: Indices) -> _Search:
        closure = self.closure.of_some(some)
        return _Search(
            closure, self.c[some], self.seen[some], self.rows[some], self.places[some], self.backwards, self.forwards
        )

    def away(self, q: Real) -> Real:
        """Distance of all sketched points together from their places [size]: (b,)."""
        away = applied(self.rows, self.closure.loops.vectors.at(q)) - self.places
        return np.asarray(np.sqrt((np.abs(away) ** 2).sum(axis=-1)))

    def met(self, near: Real) -> tuple[Real, Flags]:
        """Where Newton leads from positions (b, n), and whether they are assemblies."""
        closed = close(self.closure, near, self.c, steps=40)
        return closed.q, (closed.gap < ROUNDED) & (closed.step < ROUNDED)

    def at_sketch(self) -> Real:
        """Assemblies that are where the sketch is, and well off others: (b, n), else nan."""
        q, met = self.met(np.nan_to_num(self.seen))
        told = np.isfinite(self.seen).all(axis=1) & (inverse(self.closure.matrix(q))[1] > _CLEAR)
        forward = told | (q[:, self.forwards] >= 0).all(axis=1)
        sure = met & forward & (q[:, self.backwards] >= 0).all(axis=1) & (self.away(q) < EXACT)
        return np.where(sure[:, None], q, np.nan)

    def nearest(self) -> Real:
        """Of all ways to close each loop the assembly nearest to the sketch (b, n), nan where that is in doubt."""
        count = len(self.c)
        found = self._every()
        if found is None:
            return np.full_like(self.seen, np.nan)
        each = self.of_some(np.repeat(np.arange(count), len(found) // count))
        likely = np.flatnonzero(np.nan_to_num(each.closure.loops.open_by(found), nan=1.0) < _OPEN)
        q, met = np.full_like(found, np.nan), np.zeros(len(found), dtype=bool)
        q[likely], met[likely] = each.of_some(likely).met(found[likely])
        away = np.where(met, each.away(q), np.inf).reshape(count, -1)
        wrong = (q[:, self.forwards] < 0).sum(axis=1).reshape(count, -1)
        close_by = away <= away.min(axis=1, keepdims=True) + SAME
        best = np.argmin(np.where(close_by, wrong, len(self.forwards) + 1), axis=1)
        ways, row = q.reshape(count, -1, q.shape[1]), np.arange(count)
        chosen = ways[row, best]
        with np.errstate(invalid="ignore"):
            apart = np.abs(np.exp(1j * (ways - chosen[:, None])) - 1).max(axis=2, initial=0.0) >= SAME
        rival = away <= away.min(axis=1, keepdims=True) + 2 * SAME
        doubt = (rival & apart).any(axis=1) | (chosen[:, self.backwards] < 0).any(axis=1)
        return np.where((np.isfinite(away.min(axis=1)) & ~doubt)[:, None], chosen, np.nan)

    def _every(self) -> Real | None:
        """Every combination of ways to close the loops (b ways, n); None where some loops close only together."""
        known = self.closure.known
        blocks = in_order(self.closure.of_some(0))
        if not 0 < len(blocks) <= _MOST or np.ptp(known.left, axis=0).any():
            return None
        q = known.unknowns(np.zeros((len(self.c), len(known.free))), self.c)
        for rows, unknowns in blocks:
            if len(rows) != 1 or len(unknowns) != 2 or (both := self._both(int(rows[0]), unknowns, q)) is None:
                return None
            q = both
        return q

    def _both(self, loop: int, unknowns: Indices, q: Real) -> Real | None:
        """Both ways on from each combination so far, for the loop that gives these two unknowns."""
        loops, known = self.closure.loops, self.closure.known
        left, there = known.left[0][:, unknowns], np.abs(loops.rows[0, loop]) > NOTHING
        others = q - q[:, known.free[unknowns]] @ left.T
        length, unit = loops.vectors.polar(others)
        arms = np.repeat(loops.rows[:, loop], len(q) // len(self.c), axis=0) * unit
        turning, stretching = loops.vectors.turning @ left, loops.vectors.stretching @ left
        both = ways_of(turning[there], stretching[there], arms[:, there], length[:, there])
        return None if both is None else np.repeat(others, 2, axis=0) + both.reshape(-1, 2) @ left.T
