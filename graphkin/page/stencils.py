"""Values between knots: Lagrange's polynomials through eight knots along each driver, or as many as there are in a row.

The script does the same (`tracks.js`); what is held here to be near enough is what the page draws.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np

from graphkin.base.value import frozen

MOST = 8
Mask = np.ndarray  # True at the knots that count, in the shape of the grid


@frozen
class Knots:
    """Places along one driver, u (n,) growing; period: after which the first comes again, 0 if never."""

    u: np.ndarray
    period: float = 0.0

    def within(self, number: int, part: float) -> float:
        """The place so far on the way from a knot to the next."""
        size = len(self.u)
        following = self.u[(number + 1) % size] + self.period * ((number + 1) // size)
        return float(self.u[number] + part * (following - self.u[number]))

    def cell(self, u: float) -> int:
        """The last knot that is not beyond u."""
        k = int(np.searchsorted(self.u, u, "right")) - 1
        return k if self.period else min(max(k, 0), len(self.u) - 2)

    def windows(self, u: float, count: int) -> Iterator[tuple[int, ...]]:
        """Runs of so many knots with one that is beside a place, the best centred first; counted on beyond the last,
        round and round."""
        middle, size = self.cell(u) - count // 2 + 1, len(self.u)
        for shift in sorted(range(-(count // 2), count // 2 + 1), key=lambda shift: (abs(shift), shift)):
            first = middle + shift
            if self.period or 0 <= first <= size - count:
                yield tuple(range(first, first + count))

    def weights(self, u: float, window: Sequence[int]) -> np.ndarray:
        size = len(self.u)
        at = np.array([self.u[k % size] + self.period * (k // size) for k in window])
        gaps = at[:, None] - at[None, :]
        np.fill_diagonal(gaps, 1.0)
        ahead = np.broadcast_to(u - at, gaps.shape).copy()
        np.fill_diagonal(ahead, 1.0)
        return np.asarray((ahead / gaps).prod(axis=1))


def stencil(
    knots: Sequence[Knots], us: Sequence[float], mask: Mask, fewer: int = 0
) -> tuple[np.ndarray, np.ndarray] | None:
    """The numbers (m,) of the knots that give the value at a place of a grid, and their weights; None: none give it;
    fewer: than usual along each driver."""
    for count in range(MOST - fewer, 0, -2):
        counts = [min(count, len(axis.u)) for axis in knots]
        for windows in product(*(axis.windows(u, few) for axis, u, few in zip(knots, us, counts, strict=True))):
            places = np.ix_(*(np.array(window) % len(axis.u) for axis, window in zip(knots, windows, strict=True)))
            if mask[places].all():
                weights = np.ones(())
                for axis, u, window in zip(knots, us, windows, strict=True):
                    weights = np.multiply.outer(weights, axis.weights(u, window))
                numbers = np.arange(mask.size).reshape(mask.shape)[places]
                return numbers.ravel(), weights.ravel()
    return None
