"""The closed vector loops of a mechanism, one for each independent cycle of its link graph.

Loops are made of arrows; an arrow's angle and length follow the unknowns linearly. There is one arrow of length 1 for
each link, along its axis, and one for each slide, from the line's origin to the point (length s, turned by the guide).
Every place is a sum of these with fixed complex coefficients, a `row`: r = row . arrows. One row serves position,
velocity and acceleration.

Links are the nodes of the graph and joints the edges. A tree of joints grown from the frame places every link; each
joint left over closes one loop. Lengths are in units of the mechanism's `size` here, so that a residual or a matrix
says the same of a watch and of a crane.

Shapes: q is (..., n) for n unknowns, arrows are (..., m), rows are (..., m) or (r, m).
Source: Sun Huan, Theory of Machines, section 3-3 (complex vectors).
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from functools import cached_property
from itertools import combinations
from math import prod

import numpy as np
from numpy.typing import NDArray

from graphkin.analytic.rules import Joint, LinearRelation, Unknown, shares, theta
from graphkin.base.cache import kept
from graphkin.base.geometry import Array
from graphkin.base.value import frozen
from graphkin.errors import NotJoined
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Rod

Reals = NDArray[np.float64]
Complex = NDArray[np.complex128]
Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]
Polar = tuple[Reals, Complex]  # length and unit vector of each arrow (.., m)
SMALL = 2**13
"""Products of fewer multiplications are done by one thread; dealt out to several, each waits for the slowest."""


def applied(matrix: Array, vectors: Array) -> Array:
    """A matrix (r, m) on vectors (..., m): (..., r)."""
    if vectors.size * len(matrix) < SMALL:
        return np.asarray(vectors @ matrix.T)
    return _sparse(vectors, len(matrix), _entries(matrix, 1))


def through(rows: Array, matrix: Array) -> Array:
    """Rows (.., m) times a matrix (m, n), as one product: of a stack numpy would do each small one by itself."""
    *many, m = rows.shape
    if rows.size * matrix.shape[1] < SMALL:
        return np.asarray((rows.reshape(prod(many), m) @ matrix).reshape(*many, matrix.shape[1]))
    return _sparse(rows, matrix.shape[1], _entries(matrix, 0))


def _sparse(rows: Array, count: int, entries: tuple[Array, ...]) -> Array:
    """The same product from the entries alone that are not 0: few, of a large matrix."""
    sources, values, columns, starts = entries
    product = np.zeros((*rows.shape[:-1], count), np.result_type(rows, values))
    if columns.size:
        product[..., columns] = np.add.reduceat(rows[..., sources] * values, starts, axis=-1)
    return product


@kept(32)
def _entries(matrix: Array, summed: int) -> tuple[Array, ...]:
    """The entries of a matrix that are not 0, to be summed along an axis: where along it, and value; in order of the
    other axis, the places there that have any, and where each begins."""
    ends = np.nonzero(np.moveaxis(matrix, summed, 1))
    values = np.moveaxis(matrix, summed, 1)[ends]
    return ends[1], values, *np.unique(ends[0], return_index=True)


@frozen
class LoopVectors:
    """Arrows that hang on the unknowns q: angle = turning q, length = base + stretching q. turning, stretching (m, n);
    base (m,) is 1 for a link's arrow, 0 for a slide's. What asks for `polar` works that out where it is not given."""

    turning: Reals
    stretching: Reals
    base: Reals

    def polar(self, q: Reals) -> Polar:
        """Length and unit vector of each arrow."""
        return self.base + applied(self.stretching, q), np.exp(1j * applied(self.turning, q))

    def at(self, q: Reals, polar: Polar | None = None) -> Complex:
        length, unit = polar or self.polar(q)
        return length * unit

    def rate(self, q: Reals, dq: Reals, polar: Polar | None = None) -> Complex:
        """d/dt of each arrow: l' along it, l phi' across it."""
        length, unit = polar or self.polar(q)
        turn, stretch = applied(self.turning, dq), applied(self.stretching, dq)
        return np.asarray(unit * (stretch + 1j * length * turn))

    def acceleration(self, q: Reals, dq: Reals, ddq: Reals, polar: Polar | None = None) -> Complex:
        """d2/dt2 of each arrow: l'' - l phi'^2 along it, l phi'' + 2 l' phi' (Coriolis) across it."""
        length, unit = polar or self.polar(q)
        turn, stretch = applied(self.turning, dq), applied(self.stretching, dq)
        along = applied(self.stretching, ddq) - length * turn**2
        return np.asarray(unit * (along + 1j * (length * applied(self.turning, ddq) + 2 * stretch * turn)))

    def slope(self, rows: Complex, q: Reals, polar: Polar | None = None) -> Complex:
        """d(rows . arrows)/dq: (..., r, n) for rows (r, m)."""
        length, unit = polar or self.polar(q)
        turned = (1j * length * unit)[..., None, :] * rows
        stretched = unit[..., None, :] * rows
        return through(turned, self.turning) + through(stretched, self.stretching)


@frozen
class Loops:
    """The unknowns and what ties them together, drivers apart.

    unknowns    angles first, then displacements: n of them
    unit        (n,): SI value of one internal unit of each unknown (1 rad, `size` m)
    size        the largest dimension of the mechanism [m]
    rows        (r, m): row . arrows = 0 closes a loop
    points      row of each point, origins: row of each link's origin
    relations   what the pairs ask besides
    joints      where the links meet
    """

    unknowns: tuple[Unknown, ...]
    unit: Reals
    size: float
    vectors: LoopVectors
    rows: Complex
    points: dict[str, Complex]
    origins: dict[str, Complex]
    relations: tuple[LinearRelation, ...]
    joints: tuple[Joint, ...]

    def weights(self, relations: Sequence[LinearRelation]) -> Reals:
        """Left sides of relations as a matrix on the internal unknowns: (k, n)."""
        table = np.zeros((len(relations), len(self.unknowns)))
        for row, relation in zip(table, relations, strict=True):
            for unknown, weight in relation.weights.items():
                row[self.column[unknown]] += weight
        return table * self.unit

    @cached_property
    def column(self) -> dict[Unknown, int]:
        """The number of each unknown."""
        return {unknown: at for at, unknown in enumerate(self.unknowns)}

    @cached_property
    def places(self) -> Complex:
        """The rows of all points: (p, m)."""
        return np.stack([*self.points.values()])

    def gap(self, q: Reals, polar: Polar | None = None) -> Reals:
        """The gap of each loop, x and y: (..., 2r), in units of size."""
        return parts(applied(self.rows, self.vectors.at(q, polar)), -1)

    def open_by(self, q: Reals) -> Reals:
        """The widest gap of any loop: (...), in units of size."""
        return np.asarray(np.max(np.abs(applied(self.rows, self.vectors.at(q))), axis=-1, initial=0.0))

    def slope(self, q: Reals, polar: Polar | None = None) -> Reals:
        """d gap / dq: (..., 2r, n)."""
        return parts(self.vectors.slope(self.rows, q, polar), -2)

    def moves(self, rows: Complex) -> Flags:
        """True for unknowns that move any of these rows: (n,)."""
        arrows = np.abs(np.reshape(rows, (-1, len(self.vectors.base)))).sum(axis=0)
        return np.asarray(arrows @ (np.abs(self.vectors.turning) + np.abs(self.vectors.stretching)) > 0)

    @cached_property
    def moving(self) -> Flags:
        """True for unknowns that move any arrow of a loop, or any point: (n,)."""
        return self.moves(np.vstack([self.rows, self.places]))

    def silent(self, relations: Sequence[LinearRelation]) -> tuple[Unknown, ...]:
        """Unknowns that move nothing and stand in no relation: the rotation of a link of one point."""
        if self.moving.all():
            return ()
        named = np.abs(self.weights(relations)).sum(axis=0) > 0
        loud = self.moving | named
        return tuple(unknown for unknown, on in zip(self.unknowns, loud, strict=True) if not on)


def loops_of(mechanism: Mechanism) -> Loops:
    """Write the loops of a mechanism."""
    brought, size = tuple(shares(mechanism)), size_of(mechanism)
    joints = tuple(joint for share in brought for joint in share.joints)
    met = (name for joint in joints for name in (joint.tail, joint.head))
    links = tuple(dict.fromkeys((FRAME, *mechanism.links, *met)))  # those of a pair's own making last
    slides = {joint.slide: joint.tail for joint in joints if joint.slide is not None}
    sums = _ArrowSums(links, tuple(slides), size)
    origins, closing = sums.grow(joints)
    for link in mechanism.moving:
        if link not in origins:
            raise NotJoined(mechanism.where("links", link), link)
    points = {point: origins[owners[0]] + sums.arm(owners[0], mechanism.links[owners[0]].points[point])
              for point, owners in mechanism.owners.items()}  # fmt: skip
    unknowns = (*(theta(link) for link in links[1:]), *(Unknown("s", name) for name in slides))
    unit = np.array([1.0] * len(links[1:]) + [size] * len(slides))
    moving = len(links) - 1
    turning = np.zeros((len(links) + len(slides), moving + len(slides)))
    stretching = np.zeros_like(turning)
    for arrow, link in enumerate((*links, *slides.values())):
        if link != FRAME:  # which does not turn
            turning[arrow, links.index(link) - 1] = 1.0
    stretching[len(links) :, moving:] = np.eye(len(slides))
    vectors = LoopVectors(turning, stretching, np.array([1.0] * len(links) + [0.0] * len(slides)))
    rows = np.array(closing).reshape(-1, len(vectors.base))
    relations = tuple(relation for share in brought for relation in share.relations)
    return Loops(unknowns, unit, size, vectors, rows, points, origins, relations, joints)


def parts(values: Complex, axis: int) -> Reals:
    """The x and y parts of complex equations, as twice as many real ones."""
    return np.concatenate([values.real, values.imag], axis=axis)


def size_of(mechanism: Mechanism) -> float:
    """The longest distance between two points of one link, or radius [m]; without any, the largest displacement."""
    circles = [radius for pair in mechanism.pairs for _, _, radius in pair.circles]
    circles += [rod.length for pair in mechanism.pairs if isinstance(rod := pair.equivalent, Rod)]
    arms = [abs(a - b) for link in mechanism.links.values() for a, b in combinations(link.points.values(), 2)]
    values = [abs(driver.value) for driver in mechanism.drivers if driver.kind == "slide" and driver.value]
    return max([*arms, *circles], default=0.0) or max(values, default=0.0) or 1.0


@frozen
class _ArrowSums:
    """Sums of arrows, written as rows of coefficients in units of size."""

    links: tuple[str, ...]
    slides: tuple[str, ...]
    size: float

    def arm(self, link: str, arm: complex) -> Complex:
        row = np.zeros(len(self.links) + len(self.slides), dtype=np.complex128)
        row[self.links.index(link)] = arm / self.size
        return row

    def grow(self, joints: Sequence[Joint]) -> tuple[dict[str, Complex], list[Complex]]:
        """A tree from the frame, nearest links first: links' origins, and a row for each joint left over."""
        origins, left, rows = {FRAME: self.arm(FRAME, 0)}, list(joints), []
        queue = deque([FRAME])
        while queue:
            link = queue.popleft()
            for joint in [joint for joint in left if link in (joint.tail, joint.head)]:
                left = [other for other in left if other is not joint]
                far, sign = (joint.head, 1) if joint.tail == link else (joint.tail, -1)
                step = self.arm(joint.tail, joint.tail_arm) - self.arm(joint.head, joint.head_arm)
                if joint.slide is not None:
                    step[len(self.links) + self.slides.index(joint.slide)] = joint.direction
                end = origins[link] + sign * step
                if far in origins:
                    rows.append(end - origins[far])
                else:
                    origins[far] = end
                    queue.append(far)
        return origins, rows
