"""The search for redundant constraints in a mechanism that has more constraints than it can use; `repeated` begins it.

The equations of all pairs are ranked at places close to the drawn one, so that a dead point, where they repeat each
other for an instant only, is not taken for one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from graphkin.base.tolerances import CLOSED
from graphkin.base.value import frozen
from graphkin.model.mechanism import Driver, Mechanism
from graphkin.planning.conflicts import Contradictions
from graphkin.planning.constraint_jacobian import Array, ConstraintRow, ConstraintRows, Restraints, settled
from graphkin.planning.ranks import drawn_place, open_by, rank
from graphkin.planning.redundancy import PairEquations, SetAside, over
from graphkin.planning.structure import Topology

_NUDGE = 0.05
"""How far bodies are moved to see the general rank [size, rad]."""
_NUDGES = 4


def search(mechanism: Mechanism, structure: Topology) -> tuple[SetAside, ...]:
    """What repeats others, in the order in which it is set aside. Raises NotRepeated."""
    restraints = Restraints(structure, tuple(_given(mechanism)))
    drawn, _ = drawn_place(restraints)
    candidates = PairEquations(mechanism, structure, frozenset(restraints.rows(drawn).labels))
    return _RepeatSearch(candidates, restraints, drawn).found()


def still_over(structure: Topology, found: Sequence[SetAside]) -> tuple[SetAside, ...]:
    """Those that repeat others where wheels may slip, and the drawn position's drivers and poses hold."""
    restraints = Restraints(structure, tuple(d for d in structure.mechanism.drivers if d.kind != "spin"))
    return over(restraints.rows(drawn_place(restraints)[0]), found)


def _given(mechanism: Mechanism) -> Iterator[Driver]:
    """The drivers and poses that hold at the drawn position."""
    for driver in mechanism.drivers:
        if driver.value is not None and driver.kind != "spin":
            yield driver
    for pose in mechanism.poses:
        yield Driver(pose.kind, pose.link, pose.vector, pose.from_link, pose.from_vector, pose.value)


@frozen
class _RepeatSearch:
    """The search for what repeats others in one mechanism; `drawn` is its position."""

    candidates: PairEquations
    restraints: Restraints
    drawn: Array

    def found(self) -> tuple[SetAside, ...]:
        whole = rows = self._general()
        aside: list[SetAside] = []
        for candidate in self.candidates.all():
            if all(row in rows.labels for row in candidate.rows) and self._repeats(rows, candidate):
                aside.append(candidate)
                rows = rows.without(candidate.rows)
        contradictions = Contradictions(self.candidates, self.restraints)
        contradictions.refuse(aside, contradictions.near(rows))
        return tuple(replace(each, held=tuple(self.candidates.holding(each, whole, rows))) for each in aside)

    def _general(self) -> ConstraintRows:
        """The pairs' equations where they are most independent: at the drawn position, or next to it."""
        given = [ConstraintRow("given", str(k)) for k in range(len(self.restraints.given))]
        start = self.restraints.rows(self.drawn).without(given)
        free = np.linalg.svd(start.slopes)[2][rank(start.slopes) :]
        rng, places = np.random.default_rng(3), [start]
        for _ in range(_NUDGES if len(free) else 0):
            move = rng.normal(0, 1, len(free)) @ free
            moved = self.drawn + _NUDGE * move / np.max(np.abs(move))
            q, rows = settled(self.restraints, moved, given, self.drawn)
            if open_by(rows) < CLOSED:
                places.append(self.restraints.rows(q).without(given))
        return max(places, key=lambda rows: rank(rows.slopes))

    @staticmethod
    def _repeats(rows: ConstraintRows, candidate: SetAside) -> bool:
        """Whether nothing moves more freely without it."""
        fewer = rows.without(candidate.rows).slopes
        if candidate.part == "link":
            return rank(fewer) + 3 == rank(rows.slopes)
        return rank(fewer) == rank(rows.slopes)
