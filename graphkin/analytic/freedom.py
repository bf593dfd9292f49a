"""The number of drivers that a mechanism needs, counted by the rank of its equations at assembled positions.

Gruebler's formula counts pairs; the rank also sees constraints that repeat each other. A rank can drop
at a dead point or a change point, so it is taken at several positions near the drawn one.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.analytic.assembly import assemble, held, idle
from graphkin.analytic.loops import Loops, Reals, loops_of
from graphkin.analytic.newton import EquationSystem, close
from graphkin.analytic.rules import driven, placing
from graphkin.base.tolerances import RANK
from graphkin.base.value import frozen
from graphkin.model.mechanism import Mechanism

_NUDGES = 6
_NUDGE = 0.05  # the mechanism is moved so far to see its general rank [rad, size]
_FAR = 1.0  # so far where it may be in a position of another kind, folded for instance


@frozen
class Mobility:
    """The freedoms of a mechanism, and whether its drivers determine them.

    freedoms    degrees of freedom, idle rotations apart; None where the pairs alone cannot be assembled
    free        links that still can move when all drivers stand still
    redundant   numbers of drivers that repeat the constraints and the drivers before them
    repeated    constraint equations that repeat others (and are met)
    idle        links of one point whose rotation nothing shows
    unplaced    links that driver values and poses do not place at the drawn position
    gap_mm      smallest gap left where the drawn position cannot be assembled, else None [mm]
    """

    freedoms: int | None
    free: tuple[str, ...]
    redundant: tuple[int, ...]
    repeated: int
    idle: tuple[str, ...]
    unplaced: tuple[str, ...]
    gap_mm: float | None


def mobility(mechanism: Mechanism) -> Mobility:
    """Count the freedoms of a mechanism, whether its drivers are too few, right or too many."""
    loops = loops_of(mechanism)
    whole = assemble(mechanism, loops)
    pairs = whole if whole.q is not None else assemble(mechanism, loops, driving=False)
    drivers = tuple(driven(mechanism, driver) for driver in mechanism.drivers)
    quiet = idle(mechanism, loops)
    if pairs.q is None:
        return Mobility(None, (), (), 0, quiet, (), pairs.gap * 1e3)
    positions = _nearby(loops, pairs.q)
    if whole.q is None:  # put together anyhow, perhaps folded so that a driven link is at rest
        positions += _nearby(loops, pairs.q, anyhow=True)
    ranks = _Ranks.at(loops, loops.weights(drivers), positions)
    constraints, still = ranks.constraints(), loops.weights(held(loops, loops.relations))
    # at the drawn position driver values and poses place links; gears and rolling do not
    known = [relation for relation in loops.relations if relation.offset is not None]
    known += [driven(mechanism, each) for each, _ in placing(mechanism)]
    placed = loops.weights([*known, *held(loops, known)])
    return Mobility(
        freedoms=len(loops.unknowns) - len(quiet) - rank(constraints),
        free=_moving(mechanism, loops, ranks.q, np.vstack([constraints, ranks.driving, still])),
        redundant=tuple(ranks.redundant_drivers()),
        repeated=len(constraints) - rank(constraints),
        idle=quiet,
        unplaced=_moving(mechanism, loops, ranks.q, np.vstack([loops.slope(ranks.q), placed / _scale(placed)])),
        gap_mm=None if whole.q is not None else whole.gap * 1e3,
    )


def rank(matrix: Reals) -> int:
    """Rank of a matrix that may be empty."""
    return 0 if matrix.size == 0 else int(np.linalg.matrix_rank(matrix, tol=RANK))


def null_space(matrix: Reals) -> Reals:
    """Directions (f, n) in which the equations (k, n) let the unknowns go."""
    if matrix.size == 0:
        return np.eye(matrix.shape[1])
    return np.asarray(np.linalg.svd(matrix)[2][rank(matrix) :])


@frozen
class _Ranks:
    """Equations at the position q (n,) where they are most independent; driving: the drivers' rows (d, n)."""

    loops: Loops
    driving: Reals
    q: Reals

    @classmethod
    def at(cls, loops: Loops, driving: Reals, positions: list[Reals]) -> _Ranks:
        """Pick the position of the highest rank, with the drivers and then without."""

        def ranks(q: Reals) -> tuple[int, int]:
            constraints = cls(loops, driving, q).constraints()
            return rank(np.vstack([constraints, driving])), rank(constraints)

        return cls(loops, driving / _scale(driving), max(positions, key=ranks))

    def constraints(self) -> Reals:
        """Loops and relations of the pairs: (k, n)."""
        relations = self.loops.weights(self.loops.relations)
        return np.vstack([self.loops.slope(self.q), relations / _scale(relations)])

    def redundant_drivers(self) -> Iterator[int]:
        """The numbers of the drivers that do not add to the rank."""
        rows = self.constraints()
        for number, row in enumerate(self.driving):
            more = np.vstack([rows, row])
            if rank(more) == rank(rows):
                yield number
            rows = more


def _scale(rows: Reals) -> Reals:
    """Largest entry of each row, so that a driven length weighs as much as a driven angle."""
    most = np.max(np.abs(rows), axis=1, initial=0.0, keepdims=True)
    return np.where(most > 0, most, 1.0)


def _nearby(loops: Loops, q: Reals, anyhow: bool = False) -> list[Reals]:
    """The position, and some next to it along its freedoms, or anyhow and farther off, put together again."""
    closure = EquationSystem.of(loops, (*loops.relations, *held(loops, loops.relations)))
    rng = np.random.default_rng(2)
    slopes, nudge = closure.matrix(q), _FAR if anyhow else _NUDGE
    directions = null_space(slopes[:0] if anyhow else slopes)
    moves = rng.normal(0, 1, (_NUDGES, len(directions))) @ directions
    length = np.max(np.abs(moves), axis=1, initial=0.0, keepdims=True)
    shifted = closure.move(q, nudge * moves / np.where(length > 0, length, 1.0))
    closed = close(closure, shifted, closure.weights @ q, steps=30)
    return [q, *(each for each, gap in zip(closed.q, closed.gap, strict=True) if gap < RANK)]


def _moving(mechanism: Mechanism, loops: Loops, q: Reals, equations: Reals) -> tuple[str, ...]:
    """Links that turn, or whose origin moves, in some direction the equations leave open."""
    directions, moving = null_space(equations), []
    for link in mechanism.moving:
        turn = [unknown == ("theta", link) for unknown in loops.unknowns]
        shift = directions @ loops.vectors.slope(loops.origins[link][None], q)[0]
        if np.max(np.abs(directions[:, turn]), initial=0.0) + np.max(np.abs(shift), initial=0.0) > RANK:
            moving.append(link)
    return tuple(moving)
