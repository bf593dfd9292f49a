"""Positions found on a path, and what they foretell: cubics through two of them and their slopes."""

from __future__ import annotations

import numpy as np

from graphkin.base.value import frozen


@frozen
class Nodes:
    """Positions in the order in which they were found.

    t      where on the path (m,)
    x      angles and displacements (m, n) [rad, m]; slope: how fast they change with t
    sines  of crossings, signed (m, k)
    """

    t: np.ndarray
    x: np.ndarray
    slope: np.ndarray
    sines: np.ndarray

    def __len__(self) -> int:
        return int(self.t.size)

    def __getitem__(self, which: slice) -> Nodes:
        return Nodes(self.t[which], self.x[which], self.slope[which], self.sines[which])

    def and_then(self, others: Nodes) -> Nodes:
        mine, theirs = ((nodes.t, nodes.x, nodes.slope, nodes.sines) for nodes in (self, others))
        return Nodes(*(np.concatenate(pair) for pair in zip(mine, theirs)))

    def in_order(self) -> Nodes:
        """As they lie on the path."""
        order = np.argsort(self.t)
        return Nodes(self.t[order], self.x[order], self.slope[order], self.sines[order])

    def expected(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Where the last two lead to at t (k,), and how fast: (k, n) each. One alone leads on in a straight line."""
        if len(self) == 1:
            return self.foretold(t), np.broadcast_to(self.slope, (t.size, self.x.shape[1]))
        return cubic(self[-2:-1], self[-1:], t)

    def foretold(self, t: np.ndarray) -> np.ndarray:
        """Where the last three lead to at t (k,): (k, n). By divided differences, each node taken twice."""
        last = self[-3:]
        twice, differences = np.repeat(last.t, 2), np.repeat(last.x, 2, axis=0)
        terms = [differences[0]]
        for order in range(1, twice.size):
            widths = (twice[order:] - twice[:-order])[:, None]
            differences = np.diff(differences, axis=0)
            if order == 1:
                differences[::2], widths[::2] = last.slope, 1.0
            differences = differences / widths
            terms.append(differences[0])
        found = np.broadcast_to(terms[-1], (t.size, terms[-1].size))
        for place, term in zip(twice[-2::-1], terms[-2::-1]):
            found = term + (t - place)[:, None] * found
        return found

    def between(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """So many places from each to the next, t (m,) and x (m, n), and the last one."""
        parts = np.arange(count) / count
        t = self.t[:-1, None] + np.diff(self.t)[:, None] * parts
        left, right = (nodes.repeated(count) for nodes in (self[:-1], self[1:]))
        x, _ = cubic(left, right, t.ravel())
        return np.append(t.ravel(), self.t[-1]), np.concatenate([x, self.x[-1:]])

    def repeated(self, count: int) -> Nodes:
        return Nodes(*(np.repeat(rows, count, axis=0) for rows in (self.t, self.x, self.slope, self.sines)))


def cubic(left: Nodes, right: Nodes, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Hermite's cubics through pairs of nodes, one or (k,), and their slopes at t (k,), between or beyond: (k, n)."""
    width = (right.t - left.t)[:, None]
    u = (t - left.t)[:, None] / width
    v = 1 - u
    x = left.x * ((1 + 2 * u) * v * v) + right.x * (u * u * (3 - 2 * u))
    x = x + width * (left.slope * (u * v * v) - right.slope * (u * u * v))
    slope = (6 * u * v / width) * (right.x - left.x)
    return x, slope + left.slope * (v * (1 - 3 * u)) - right.slope * (u * (2 - 3 * u))
