"""Redundant (passive) constraints (虚约束): what repeats the constraints of other pairs, found by rank.

The equations of all pairs are ranked at places close to the drawn one, so that a dead point, where they repeat each
other for an instant only, is not taken for one. What repeats others is set aside, as a textbook does before it counts
freedoms and solves: of several, the one that comes last in the file; none that is driven or posed, and none that is
asked for while another will do. A link that hangs on hinges alone is left where it is (a `Bridge` is drawn last).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from graphkin.mechanism import Driver, Mechanism
from graphkin.planning.candidates import Candidates, SetAside, over
from graphkin.planning.contradicting import Contradictions
from graphkin.planning.ranks import drawn_place, open_by, rank
from graphkin.planning.restraints import Array, Restraints, Row, Rows, settled
from graphkin.planning.structure import Aside, Structure
from graphkin.tolerances import CLOSED
from graphkin.value import frozen

_NUDGE = 0.05
"""How far bodies are moved to see the general rank [size, rad]."""
_NUDGES = 4


def repeated(mechanism: Mechanism, structure: Structure) -> tuple[SetAside, ...]:
    """What repeats others, in the order in which it is set aside.

    Raises NotRepeated for a constraint that comes close to repeating others, but contradicts them.
    """
    if structure.surplus <= 0:
        return ()
    restraints = Restraints(structure, tuple(_given(mechanism)))
    drawn, _ = drawn_place(restraints)
    candidates = Candidates(mechanism, structure, frozenset(restraints.rows(drawn).labels))
    return _Search(candidates, restraints, drawn).found()


def as_aside(found: Iterable[SetAside]) -> Aside:
    """What the planner leaves out; links on hinges stay where they are."""
    pairs = [each for each in found if each.part != "link"]
    gone = {row for each in pairs for row in each.rows}
    return Aside(
        slides=frozenset(row.name for row in gone if row.kind == "line"),
        angles=frozenset(row.name for row in gone if row.kind == "angle" and Row("line", row.name) not in gone),
        contacts=frozenset(row.name for row in gone if row.kind == "slip"),
    )


def still_repeated(structure: Structure, found: Sequence[SetAside]) -> tuple[SetAside, ...]:
    """Those that repeat others even where wheels may slip and the drawn position's drivers and poses hold."""
    if not found:
        return ()
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
class _Search:
    """The search for what repeats others in one mechanism; `drawn` is its position."""

    candidates: Candidates
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

    def _general(self) -> Rows:
        """The pairs' equations where they are most independent: at the drawn position, or next to it."""
        given = [Row("given", str(k)) for k in range(len(self.restraints.given))]
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
    def _repeats(rows: Rows, candidate: SetAside) -> bool:
        """Whether nothing moves more freely without it."""
        fewer = rows.without(candidate.rows).slopes
        if candidate.part == "link":
            return rank(fewer) + 3 == rank(rows.slopes)
        return rank(fewer) == rank(rows.slopes)
