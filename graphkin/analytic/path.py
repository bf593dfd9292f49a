"""The path of all unknowns along one straight line of driver values: nodes on it, and change points it goes through.

At a change point the matrix is singular, though one smooth motion goes through it; another motion crosses it there.
Where the matrix tends to a singular one, the path is therefore not felt for in smaller and smaller steps: one step goes
from well before to well after the place that is foretold, where the motion that goes on smoothly differs from the
other. It is a change point if the loops close at the singular place between. If they do not, two motions only come near
each other, and the path bends as they do, however sharply; where it turns back in the driver's value, it ends: a dead
point.
"""

from __future__ import annotations

from dataclasses import field, replace
from functools import cached_property

import numpy as np

from graphkin.analytic.loops import Flags, Reals
from graphkin.analytic.newton import EquationSystem, close, tangent
from graphkin.base.tolerances import TOUCH
from graphkin.base.value import filled, frozen

STRIDE = 0.12  # longest step of a driver [rad]: 4.7 deg
LENGTH_STRIDE = 0.03  # the same for a displacement, in units of the mechanism's size
SHORTEST = 1e-6  # steps this much shorter than the longest are the end of the path
REACH = 0.2  # longest step of any unknown in the loops [rad, size]
AWAY, SWERVE = 1e-3, 3e-3
"""A position, and its turning over a step, may be so far from what was foretold [rad, size]."""
CLOSED, SETTLED = 1e-9, 1e-8
"""The gap [size] and the last step of Newton's method [rad, size] at a node."""
FLAT = 1e-4  # singular values below this part of the largest belong to a change point


@frozen
class PathNode:
    """Unknowns (n,) and their slopes at a place on the line; the reciprocal condition, with the determinant's sign."""

    at: float
    q: Reals
    slope: Reals
    measure: float


@frozen
class RightSides:
    """Right sides c + at * toward (k,) of the relations; `longest` is the longest step along it."""

    closure: EquationSystem
    c: Reals
    toward: Reals

    @cached_property
    def lengths(self) -> Flags:
        """True for those of displacements: (k,)."""
        return np.asarray(np.max(np.abs(self.closure.weights), axis=1, initial=0.0) == self.closure.loops.size)

    @cached_property
    def longest(self) -> float:
        units = np.where(self.lengths, LENGTH_STRIDE * self.closure.loops.size, STRIDE)
        return float(1 / np.max(np.abs(self.toward) / units, initial=1e-300))

    @cached_property
    def turn(self) -> float:
        """So far along it one driver has turned once, and all others stand still; without end, where there is none."""
        moving = np.flatnonzero(self.toward)
        alone = moving.size == 1 and not self.lengths[moving[0]]
        return float(2 * np.pi / abs(self.toward[moving[0]])) if alone else np.inf

    @cached_property
    def heard(self) -> Flags:
        """True for unknowns that stand in the loops: (n,)."""
        return self.closure.loops.moves(self.closure.loops.rows)

    @cached_property
    def slides(self) -> Flags:
        """True for unknowns that are displacements: (n,)."""
        return np.array([unknown.kind == "s" for unknown in self.closure.loops.unknowns])

    def node(self, at: float, guess: Reals) -> PathNode | None:
        """The position at a place, from one close by; None where it is not closed."""
        closed = close(self.closure, guess[None], self.c + at * self.toward, steps=9)
        if not (closed.gap[0] < CLOSED and closed.step[0] < SETTLED):
            return None
        slope, condition, sense = tangent(self.closure, closed.q, self.toward)
        return PathNode(at, closed.q[0], slope[0], float(condition[0] * sense[0]))

    def largest(self, change: Reals, q: Reals) -> float:
        """The largest change of an unknown in the loops [rad, size]; of a displacement far off, as part of it."""
        scale = np.where(self.slides, np.maximum(np.abs(q), 1.0), 1.0)
        return float(np.max(np.abs(change / scale)[self.heard], initial=0.0))


@frozen
class MotionPath:
    """Nodes in the order of their places, and the places of change points."""

    line: RightSides
    nodes: tuple[PathNode, ...]
    changes: tuple[float, ...]

    @cached_property
    def at(self) -> Reals:
        return np.array([node.at for node in self.nodes])

    def between(self, at: Reals) -> Reals:
        """Unknowns at places (p,), as far as the nodes tell them: (p, n)."""
        q, slopes = np.array([node.q for node in self.nodes]), np.array([node.slope for node in self.nodes])
        if len(self.nodes) == 1:
            return np.broadcast_to(q[0], (len(at), q.shape[1]))
        right = np.clip(np.searchsorted(self.at, at), 1, len(self.nodes) - 1)
        ends = (self.at[right - 1], q[right - 1], slopes[right - 1]), (self.at[right], q[right], slopes[right])
        return _cubic(*ends, at)[0]


def path_along(line: RightSides, start: Reals, low: float, high: float) -> MotionPath:
    """The path from the unknowns `start` (n,) at 0 down to `low` and up to `high`, or as far as it leads."""
    forth = _MotionWalk(line, start)
    back = _MotionWalk(replace(line, toward=-line.toward), start)
    forth.walk(high)
    back.walk(-low)
    before = tuple(PathNode(-node.at, node.q, -node.slope, node.measure) for node in back.nodes[:0:-1])
    changes = (*(-at for at in reversed(back.changes)), *forth.changes)
    return MotionPath(line, (*before, *forth.nodes), changes)


@filled
class _MotionWalk:
    """One direction of a path; `missed` is where two motions only came near each other."""

    line: RightSides
    start: Reals
    nodes: list[PathNode] = field(default_factory=list)
    changes: list[float] = field(default_factory=list)
    missed: float = -np.inf

    def __post_init__(self) -> None:
        slope, condition, sense = tangent(self.line.closure, self.start[None], self.line.toward)
        self.nodes.append(PathNode(0.0, self.start, slope[0], float(condition[0] * sense[0])))

    @property
    def last(self) -> PathNode:
        return self.nodes[-1]

    @property
    def longest(self) -> float:
        """The longest step here: no unknown of the loops goes too far."""
        return float(min(self.line.longest, REACH / max(self.line.largest(self.last.slope, self.last.q), 1e-300)))

    def walk(self, end: float) -> None:
        step = self.longest / 8
        while end - self.last.at > 1e-12 * self.line.longest and step > SHORTEST * self.line.longest:
            step = min(step, self.longest)
            if (place := self._foretold()) is not None:
                beyond = self._as_foretold(place + max(place - self.last.at, self.longest / 2))
                if beyond is not None and self._gone_through(beyond):  # one step over where the matrix is singular
                    step = self.longest
                    continue
                self.missed = place
            node = self._as_foretold(end if end - self.last.at < 1.001 * step else self.last.at + step)
            same_side = node is not None and not node.measure * self.last.measure <= 0
            if node is not None and same_side:
                self.nodes.append(node)
            # else it lies beyond a change point, if at all
            step = step * 2 if node is not None and (same_side or self._gone_through(node)) else step / 2

    def _as_foretold(self, at: float) -> PathNode | None:
        """The position that goes on from the nodes so far, smoothly."""
        here = self.last
        q, slope = here.q + (at - here.at) * here.slope, here.slope
        if len(self.nodes) > 1:
            q, slope = (rows[0] for rows in _between(self.nodes[-2], here, np.array([at])))
        node = self.line.node(at, q)
        if node is None or self.line.largest(node.q - q, q) > AWAY:
            return None
        return node if self.line.largest(node.slope - slope, q) * (at - here.at) < SWERVE else None

    def _foretold(self) -> float | None:
        """The place where the matrix becomes singular, if soon; not again where it just was."""
        if len(self.nodes) == 1 or (self.changes and self.nodes[-2].at <= self.changes[-1]):
            return None
        before, here = self.nodes[-2:]
        falls = (abs(before.measure) - abs(here.measure)) / (here.at - before.at)
        ahead = abs(here.measure) / falls if falls > 0 else np.inf
        place = here.at + ahead
        return place if ahead < 1.25 * self.longest and place - self.missed > self.longest else None

    def _gone_through(self, beyond: PathNode) -> bool:
        """Take the change point between here and there, if it is one."""
        here = self.last
        place = _meeting(here.at, beyond.at, abs(here.measure), abs(beyond.measure))
        half, inside = min(self.longest / 4, place - here.at, beyond.at - place), list[PathNode]()
        for at, end in ((place - half, here), (place + half, beyond)):  # where both ends tell it to be
            q = _between(here, beyond, np.array([at]))[0][0]
            node = self.line.node(at, q)
            if node is None or self.line.largest(node.q - q, q) >= AWAY or node.measure * end.measure <= 0:
                return False
            inside.append(node)
        left, right = inside
        # the condition falls and rises there in straight lines: so close to each other these nodes tell the singular
        # place well, where nodes further off, one of them beside the place, do not
        place = _meeting(left.at, right.at, abs(left.measure), abs(right.measure))
        width = (right.at - left.at) / 16
        for _ in range(3):
            close_by = np.clip(place + width * np.array([-1.0, 1.0]), left.at, right.at)
            _, condition, _ = tangent(self.line.closure, _between(left, right, close_by)[0], self.line.toward)
            place = _meeting(*close_by.tolist(), *condition.tolist())
            width /= 16
        # true if the loops close at the singular place, but for the direction in which the matrix tells nothing
        closure, right_side = self.line.closure, self.line.c + place * self.line.toward
        q = _between(left, right, np.array([place]))[0][0]
        q = closure.known.unknowns(q[closure.known.free], right_side)
        for _ in range(4):
            gap = closure.loops.gap(q)
            left_vectors, sizes, right_vectors = np.linalg.svd(closure.matrix(q), full_matrices=False)
            clear = sizes > FLAT * sizes[0]
            q = closure.move(q, -((left_vectors[:, clear].T @ gap) / sizes[clear]) @ right_vectors[clear])
        if not (not clear.all() and float(closure.loops.open_by(q)) < TOUCH):
            return False
        self.changes.append(place)
        self.nodes += [*(node for node in inside if here.at < node.at < beyond.at), beyond]
        return True


def _meeting(left: float, right: float, before: float, after: float) -> float:
    """The place where a condition that falls from `before` at `left`, and rises to `after` at `right`, is 0."""
    return left + (right - left) * before / max(before + after, 1e-300)


def _between(left: PathNode, right: PathNode, at: Reals) -> tuple[Reals, Reals]:
    """Unknowns and slopes (p, n) at places (p,) between two nodes, or beyond them."""
    first, last = ((np.full(len(at), node.at), node.q[None], node.slope[None]) for node in (left, right))
    return _cubic(first, last, at)


End = tuple[Reals, Reals, Reals]  # places (p,), unknowns and slopes (p, n)


def _cubic(left: End, right: End, at: Reals) -> tuple[Reals, Reals]:
    """Hermite's cubic: values and slopes (p, n)."""
    width = (right[0] - left[0])[:, None]
    t = (at - left[0])[:, None] / width
    value = left[1] * (1 + 2 * t) * (1 - t) ** 2 + right[1] * t**2 * (3 - 2 * t)
    value += width * (left[2] * t * (1 - t) ** 2 - right[2] * t**2 * (1 - t))
    slope = 6 * t * (1 - t) * (right[1] - left[1]) / width
    slope += left[2] * (1 - t) * (1 - 3 * t) - right[2] * t * (2 - 3 * t)
    return np.asarray(value), np.asarray(slope)
