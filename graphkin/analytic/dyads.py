"""One loop with two unknowns, closed by formula: both ways at once, where a search would try many starts.

The loop is A u + B v + C = 0 with unknown directions u and v, (A + P s) u + C + R s = 0 with one direction u and a
displacement s, or P s + R t + C = 0 with two displacements.
Source: Sun Huan, Theory of Machines, section 3-3 (complex vectors).
"""

from __future__ import annotations

import numpy as np

from graphkin.analytic.blocks import LoopBlock
from graphkin.analytic.vectors import Complex, Real

_NOTHING = 1e-12
"""Coefficients below this are rounding, in units of size."""


def ways(block: LoopBlock, given: Real) -> Real | None:
    """Both ways to close a block of one loop (b, 2, 2); the nearest to it where the loop does not close.

    None where it is not of such a kind, or where it is open to any direction.
    """
    if len(block.columns) != 2 or len(block.rows) != 1:
        return None
    vectors = block.part.loops.vectors
    length, unit = vectors.polar(block.at(np.zeros((len(given), 2)), given))
    turning, stretching, arms = vectors.turning[:, :2], vectors.stretching[:, :2], block.part.loops.rows[0] * unit
    angles = [np.abs(turning - way).max(axis=1) < _NOTHING for way in ((1, 0), (0, 1), (0, 0))]
    if not np.any(angles, axis=0).all():
        return None
    sums = [(arms * length) @ kind for kind in angles]
    stretch = np.abs(stretching).max(axis=0) > _NOTHING
    with np.errstate(all="ignore"):
        if not stretch.any():
            found = _two_angles(*sums)
        elif stretch.sum() == 1 and not angles[int(np.argmax(stretch))].any():
            s = int(np.argmax(stretch))
            growing = arms * stretching[:, s]
            found = _angle_and_length(sums[1 - s], growing @ angles[1 - s], sums[2], growing @ angles[2])
            found = found[..., ::-1] if s == 0 else found
        elif stretch.all() and angles[2].all():
            found = _two_lengths(arms @ stretching[:, 0], arms @ stretching[:, 1], sums[2])
        else:
            return None
    return found if np.isfinite(found).all() else None


def _two_angles(a: Complex, b: Complex, c: Complex) -> Real:
    """A u + B v + C = 0: by the law of cosines."""
    cosine = (np.abs(b) ** 2 - np.abs(a) ** 2 - np.abs(c) ** 2) / (2 * np.abs(a) * np.abs(c))
    turn = np.arccos(np.clip(cosine, -1, 1))[:, None] * [1, -1]
    first = (np.angle(c) - np.angle(a))[:, None] + turn
    rest = -(a[:, None] * np.exp(1j * first) + c[:, None]) / b[:, None]
    return np.stack([first, np.angle(rest / (np.abs(rest) > 0))], axis=-1)


def _two_lengths(p: Complex, r: Complex, c: Complex) -> Real:
    """P s + R t + C = 0: the same both ways."""
    across = (p.conj() * r).imag
    both = np.stack([(r.conj() * c).imag / across, -(p.conj() * c).imag / across], axis=-1)
    return np.stack([both, both], axis=1)


def _angle_and_length(a: Complex, p: Complex, c: Complex, r: Complex) -> Real:
    """(A + P s) u + C + R s = 0: |A + P s| = |C + R s| gives s, and that u."""
    square = np.abs(p) ** 2 - np.abs(r) ** 2
    half = (a * p.conj() - c * r.conj()).real
    root = np.sqrt(np.maximum(half**2 - square * (np.abs(a) ** 2 - np.abs(c) ** 2), 0.0))
    s = (-half[:, None] + root[:, None] * [1, -1]) / square[:, None]
    turn = -(c[:, None] + r[:, None] * s) / (a[:, None] + p[:, None] * s)
    return np.stack([np.angle(turn / (np.abs(turn) > 0)), s], axis=-1)
