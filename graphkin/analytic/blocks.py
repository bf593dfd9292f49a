"""Loops in the order in which they can be closed: the fewest at a time that have as many equations as unknowns.

A loop gives two equations. Each takes an unknown for itself; a loop then waits for those that have taken its other
unknowns, and loops that wait for one another make a block. So a long chain is closed dyad by dyad, and a search
from many starts never has to hit upon all of it at once.

One loop with two unknowns is closed by formula: both ways at once, where a search would try many starts. It is
A u + B v + C = 0 with unknown directions u and v, (A + P s) u + C + R s = 0 with one direction u and a displacement s,
or P s + R t + C = 0 with two displacements.
Source: Sun Huan, Theory of Machines, section 3-3 (complex vectors).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphkin.analytic.loops import Complex, Flags, Indices, LoopVectors, Reals
from graphkin.analytic.newton import Elimination, EquationSystem
from graphkin.base.value import frozen

_NOTHING = 1e-12  # coefficients below this are rounding, in units of size


@frozen
class LoopBlock:
    """Some loops (rows) and the unknowns left (of y) that they give, with all others known. In the loops' own closure
    (`part`) q is (y of the block, angles and lengths that the rest gives its arrows); what does not move with y is one
    arrow a loop. `moving`, `still`: the arrows in its loops."""

    columns: Indices
    moving: Indices
    still: Indices
    rows: Complex
    part: EquationSystem
    whole: EquationSystem

    def given(self, q: Reals) -> Reals:
        """Angles, then lengths (b, 2m + 2r) that the other unknowns give the arrows, from all unknowns q (b, n)."""
        vectors, left = self.whole.loops.vectors, self.whole.known.left[:, self.columns]
        others = q - q[:, self.whole.known.free[self.columns]] @ left.T
        angles, lengths = others @ vectors.turning[self.moving].T, others @ vectors.stretching[self.moving].T
        sums = vectors.at(others)[:, self.still] @ self.rows[:, self.still].T
        return np.hstack([angles, np.angle(sums), lengths + vectors.base[self.moving], np.abs(sums)])

    def at(self, y: Reals, given: Reals) -> Reals:
        """The part's own q from its unknowns (b, k)."""
        return np.hstack([y, given])


def blocks_of(closure: EquationSystem) -> tuple[LoopBlock, ...]:
    """The blocks in order; none where equations and unknowns do not match."""
    uses = moved_by(closure, closure.loops.rows)
    loops, unknowns = uses.shape
    takers = np.full(unknowns, -1)  # for each unknown the loop that takes it, two for each loop
    even = 2 * loops == unknowns and all(
        _taken(loop, uses, takers, np.zeros(unknowns, dtype=bool)) for loop in (*range(loops), *range(loops))
    )
    if not even or not takers.size:
        return ()
    # loops that wait for one another together, those they wait for before them
    waits = np.eye(loops, dtype=bool)
    for loop, row in enumerate(uses):
        waits[loop, takers[row]] = True
    for _ in range(max(1, loops).bit_length()):
        waits = (waits.astype(np.float64) @ waits) > 0
    together = waits & waits.T
    heads = np.flatnonzero(np.argmax(together, axis=1) == np.arange(loops))
    in_order = (np.flatnonzero(together[head]) for head in sorted(heads, key=lambda head: int(waits[head].sum())))
    return tuple(_block(closure, rows, np.flatnonzero(np.isin(takers, rows))) for rows in in_order)


def moved_by(closure: EquationSystem, rows: Complex) -> Flags:
    """True for those of the unknowns left that move what rows (r, m) give: (r, y)."""
    vectors = closure.loops.vectors
    on = (np.abs(rows) > _NOTHING) @ (np.abs(vectors.turning) + np.abs(vectors.stretching)) > 0
    return np.asarray(on.astype(np.float64) @ (np.abs(closure.known.left) > _NOTHING) > 0)


def _taken(loop: int, uses: Flags, takers: Indices, seen: Flags) -> bool:
    """One more unknown for a loop, others changing theirs where they can."""
    for unknown in np.flatnonzero(uses[loop] & (takers != loop)):
        if seen[unknown]:
            continue
        seen[unknown] = True
        if takers[unknown] < 0 or _taken(int(takers[unknown]), uses, takers, seen):
            takers[unknown] = loop
            return True
    return False


def _block(closure: EquationSystem, rows: Indices, columns: Indices) -> LoopBlock:
    """The closure of some loops alone: the other unknowns only turn and stretch their arrows."""
    loops, left = closure.loops, closure.known.left[:, columns]
    there = (np.abs(loops.rows[rows]) > _NOTHING).any(axis=0)
    turning, stretching = loops.vectors.turning @ left, loops.vectors.stretching @ left
    moves = (np.abs(turning) + np.abs(stretching) > _NOTHING).any(axis=1)
    moving, still = np.flatnonzero(there & moves), np.flatnonzero(there & ~moves)
    count, size = len(columns), len(moving) + len(rows)
    one, none, idle = np.eye(size), np.zeros((size, size)), np.zeros((len(rows), count))
    vectors = LoopVectors(np.hstack([np.vstack([turning[moving], idle]), one, none]),
                          np.hstack([np.vstack([stretching[moving], idle]), none, one]), np.zeros(size))  # fmt: skip
    given = np.vstack([np.zeros((count, 2 * size)), np.eye(2 * size)])
    free = np.vstack([np.eye(count), np.zeros((2 * size, count))])
    known = Elimination(given, free, np.arange(count), np.zeros((0, 2 * size)))
    part = replace(loops, vectors=vectors, rows=np.hstack([loops.rows[np.ix_(rows, moving)], np.eye(len(rows))]))
    return LoopBlock(columns, moving, still, loops.rows[rows], EquationSystem(part, given.T, known), closure)


def dyad_ways(block: LoopBlock, given: Reals) -> Reals | None:
    """Both ways to close a block of one loop (b, 2, 2); the nearest to it where the loop does not close. None where it
    is not of such a kind, or where it is open to any direction."""
    if len(block.columns) != 2 or len(block.rows) != 1:
        return None
    vectors = block.part.loops.vectors
    length, unit = vectors.polar(block.at(np.zeros((len(given), 2)), given))
    turning, stretching, arms = vectors.turning[:, :2], vectors.stretching[:, :2], block.part.loops.rows[0] * unit
    angles = [np.abs(turning - row).max(axis=1) < _NOTHING for row in ((1, 0), (0, 1), (0, 0))]
    if not np.any(angles, axis=0).all():
        return None
    sums = [(arms * length) @ kind for kind in angles]
    stretch = np.abs(stretching).max(axis=0) > _NOTHING
    with np.errstate(all="ignore"):
        if not stretch.any():
            both = _two_angles(*sums)
        elif stretch.sum() == 1 and not angles[int(np.argmax(stretch))].any():
            s = int(np.argmax(stretch))
            growing = arms * stretching[:, s]
            both = _angle_and_length(sums[1 - s], growing @ angles[1 - s], sums[2], growing @ angles[2])
            both = both[..., ::-1] if s == 0 else both
        elif stretch.all() and angles[2].all():
            p, r, c = arms @ stretching[:, 0], arms @ stretching[:, 1], sums[2]
            across = (p.conj() * r).imag
            lengths = np.stack([(r.conj() * c).imag / across, -(p.conj() * c).imag / across], axis=-1)
            both = np.stack([lengths, lengths], axis=1)  # the same both ways
        else:
            return None
    return both if np.isfinite(both).all() else None


def _two_angles(a: Complex, b: Complex, c: Complex) -> Reals:
    """A u + B v + C = 0: by the law of cosines."""
    cosine = (np.abs(b) ** 2 - np.abs(a) ** 2 - np.abs(c) ** 2) / (2 * np.abs(a) * np.abs(c))
    turn = np.arccos(np.clip(cosine, -1, 1))[:, None] * [1, -1]
    first = (np.angle(c) - np.angle(a))[:, None] + turn
    rest = -(a[:, None] * np.exp(1j * first) + c[:, None]) / b[:, None]
    return np.stack([first, np.angle(rest / (np.abs(rest) > 0))], axis=-1)


def _angle_and_length(a: Complex, p: Complex, c: Complex, r: Complex) -> Reals:
    """(A + P s) u + C + R s = 0: |A + P s| = |C + R s| gives s, and that u."""
    square = np.abs(p) ** 2 - np.abs(r) ** 2
    half = (a * p.conj() - c * r.conj()).real
    root = np.sqrt(np.maximum(half**2 - square * (np.abs(a) ** 2 - np.abs(c) ** 2), 0.0))
    s = (-half[:, None] + root[:, None] * [1, -1]) / square[:, None]
    turn = -(c[:, None] + r[:, None] * s) / (a[:, None] + p[:, None] * s)
    return np.stack([np.angle(turn / (np.abs(turn) > 0)), s], axis=-1)
