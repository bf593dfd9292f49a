"""The assemblies near the sketch, block by block: ways to close one block branch off each way to close those before.

A block starts from the sketch. Where that shows all of the block, and so nearly that no other way to close it can be as
near, there is one way on; else the search starts from many places. The branches nearest to the sketch are kept. Where
not every block was as sketched, all are searched again for what lies nearer to the sketch as a whole.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from graphkin.analytic.blocks import LoopBlock, blocks_of, dyad_ways, moved_by
from graphkin.analytic.loops import Complex, Flags, Indices, Reals
from graphkin.analytic.newton import EquationSystem, close, inverse, search
from graphkin.base.tolerances import ROUNDED
from graphkin.base.value import filled, frozen

_WIDTHS = (1, 8, 64)  # branches kept
_STARTS = 24  # starts for each unknown of a block, as far as there are as many
_NEAR = 0.05  # a block this near to the sketch, as part of its condition, has no other assembly as near
Starts = Callable[[], Reals]
SAME = 1e-4  # positions of all unknowns nearer than this are one assembly [rad, size]


@frozen
class BranchJudge:
    """The sketch and custom by which branches are judged: rows of the sketched points and their places, in units of
    size; columns of displacements that must be (`backwards`) or are taken (`forwards`) positive."""

    rows: Complex
    places: Complex
    backwards: list[int]
    forwards: list[int]


def branched(closure: EquationSystem, judge: BranchJudge, seen: Reals, starts: Starts, c: Reals) -> Reals:
    """Positions (a, n) that close every block, the one nearest to the sketch among them; none where none is found.
    `seen`: what the sketch shows of the unknowns (n,), else nan; `starts` gives (b, n), the first at the sketch, and is
    asked only where the sketch does not settle a block."""
    blocks = blocks_of(closure)
    if not blocks:
        return np.zeros((0, len(seen)))
    for width in _WIDTHS:
        walk = _BranchWalk(closure, judge, seen, starts, c, width, np.inf)
        branches = walk.through(blocks)
        if len(branches):
            break
    if not len(branches) or walk.sure:
        return branches
    nearest = float(np.sqrt(walk.away(branches, np.ones(len(closure.known.free), dtype=bool)).min()))
    limit = (nearest + SAME) ** 2
    if walk.every and walk.left > limit:
        return branches
    more = _BranchWalk(closure, judge, seen, starts, c, _WIDTHS[-1], limit).through(blocks)
    return np.vstack([branches, more])


@filled
class _BranchWalk:
    """One search through the blocks. Branches farther from the sketch than `limit` are left [size²]. It is `sure` if
    every block was as sketched; looks at `every` way to close a block, each time; the nearest of those left all the
    same is `left` from the sketch [size²]."""

    closure: EquationSystem
    judge: BranchJudge
    seen: Reals
    starts: Starts
    c: Reals
    width: int
    limit: float
    sure: bool = True
    every: bool = True
    left: float = np.inf

    def __post_init__(self) -> None:
        self.moved = moved_by(self.closure, self.judge.rows)  # which unknowns left move each sketched point: (k, y)

    def through(self, blocks: tuple[LoopBlock, ...]) -> Reals:
        known = self.closure.known
        q = known.unknowns(np.zeros((1, len(known.free))), self.c)
        solved = np.zeros(len(known.free), dtype=bool)
        for block in blocks:
            solved[block.columns] = True
            q = self._thinned(self._closed(block, q, solved), solved)
            if not len(q):
                break
        return q

    def _closed(self, block: LoopBlock, q: Reals, solved: Flags) -> Reals:
        """Each branch with every way to close a block."""
        free = self.closure.known.free[block.columns]
        given, sketched = block.given(q), self.seen[free]
        both = dyad_ways(block, given)
        if both is not None:
            return self._either(block, q, solved, given, sketched, both)
        y, met = self._searched(block, np.repeat(np.nan_to_num(sketched)[None], len(q), axis=0), given)
        single = met & self._only(block, y, given, sketched) & np.isinf(self.limit)
        self.every &= not single.any()
        if single.all():
            return self._with(block, q, y)
        self.sure = False
        starts = self.starts()
        places = starts[:: max(1, len(starts) // max(1, _STARTS * len(free)))][:, free]
        unsure = np.flatnonzero(~single)
        parent = np.repeat(unsure, len(places))
        more, met = self._searched(block, np.tile(places, (len(unsure), 1)), given[parent])
        parent, more = parent[met], more[met]
        kept = _different(parent, more)
        parent = np.concatenate([np.flatnonzero(single), parent[kept]])
        order = np.argsort(parent, kind="stable")
        return self._with(block, q[parent[order]], np.vstack([y[single], more[kept]])[order])

    def _either(self, block: LoopBlock, q: Reals, solved: Flags, given: Reals, sketched: Reals, both: Reals) -> Reals:
        """Each branch with both ways (b, 2, 2) to close a block, or the one that the sketch shows."""
        unknowns = self.closure.loops.unknowns
        angles = [unknowns[column].kind == "theta" for column in self.closure.known.free[block.columns]]
        turned = np.round(np.where(angles, both - np.nan_to_num(sketched), 0.0) / (2 * np.pi))
        parent = np.repeat(np.arange(len(q)), 2)
        y, met = self._met(block, block.at((both - 2 * np.pi * turned).reshape(-1, 2), given[parent]), given[parent])
        single = met & self._only(block, y, given[parent], sketched) & np.isinf(self.limit)
        alone = single.reshape(-1, 2).any(axis=1)
        self.sure &= bool(alone.all())
        if (others := np.flatnonzero(met & ~single & alone[parent])).size:
            self.left = min(self.left, float(self.away(self._with(block, q[parent[others]], y[others]), solved).min()))
        kept = np.flatnonzero(np.where(alone[parent], single, met))
        kept = kept[_different(parent[kept], y[kept])]
        return self._with(block, q[parent[kept]], y[kept])

    def _searched(self, block: LoopBlock, y: Reals, given: Reals) -> tuple[Reals, Flags]:
        """The end of the search from y (b, k), and whether the block is closed there."""
        return self._met(block, search(block.part, block.at(y, given), given), given)

    def _met(self, block: LoopBlock, q: Reals, given: Reals) -> tuple[Reals, Flags]:
        """Newton from there: the block's unknowns, and whether it is closed by them."""
        closed = close(block.part, q, given, steps=40)
        return closed.q[:, : len(block.columns)], (closed.gap < ROUNDED) & (closed.step < ROUNDED)

    def _only(self, block: LoopBlock, y: Reals, given: Reals, sketched: Reals) -> Flags:
        """True where the sketch shows all of a block, so near that no other way to close it is as near: (b,)."""
        condition = inverse(block.part.matrix(block.at(y, given)))[1]
        return np.asarray(np.max(np.abs(y - sketched), axis=1, initial=0.0) < _NEAR * condition)

    def _with(self, block: LoopBlock, q: Reals, y: Reals) -> Reals:
        """Branches with a block's unknowns."""
        left = self.closure.known.left[:, block.columns]
        return q + (y - q[:, self.closure.known.free[block.columns]]) @ left.T

    def _thinned(self, q: Reals, solved: Flags) -> Reals:
        """The nearest branches: cylinders the right way round, then near the sketch, then displacements positive."""
        away = self.away(q, solved)
        q, away = q[away <= self.limit], away[away <= self.limit]
        if len(q) <= self.width:
            return q
        steps = np.round(np.sqrt(away) / SAME)
        ranks = self._negative(q, self.judge.forwards, solved), steps, self._negative(q, self.judge.backwards, solved)
        order = np.lexsort(ranks)
        self.left = min(self.left, float(away[order[self.width :]].min()))
        return q[np.sort(order[: self.width])]

    def away(self, q: Reals, solved: Flags) -> Reals:
        """Squared distance of the sketched points that are found from their places [size²]: (b,)."""
        there = ~(self.moved & ~solved).any(axis=1)
        places = self.closure.loops.vectors.at(q) @ self.judge.rows[there].T
        return np.asarray((np.abs(places - self.judge.places[there]) ** 2).sum(axis=1))

    def _negative(self, q: Reals, columns: list[int], solved: Flags) -> Reals:
        """The number of negative ones among those of some displacements that are found: (b,)."""
        left = np.abs(self.closure.known.left) > 0
        there = [column for column in columns if not (left[column] & ~solved).any()]
        return np.asarray((q[:, there] < 0).sum(axis=1))


def _different(parent: Indices, y: Reals) -> Indices:
    """The first of each way to close a block (b, k), of each branch (b,)."""
    left, kept = np.arange(len(parent)), list[int]()
    while left.size:
        branch, first = np.unique(parent[left], return_index=True)
        heads = left[first]
        kept += heads.tolist()
        head = heads[np.searchsorted(branch, parent[left])]
        apart = np.max(np.abs(np.exp(1j * (y[left] - y[head])) - 1), axis=1, initial=0.0)
        left = left[apart >= SAME]
    return np.array(sorted(kept), dtype=np.intp)
