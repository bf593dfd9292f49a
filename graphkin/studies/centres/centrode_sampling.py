"""Curves drawn fine: positions are added where a curve bends, and it is cut where it runs to infinity.

Positions come in cells, each with its middle, so that a length can be found from chords and half chords (Richardson).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import frozen

FIRST, DEEPEST = 90, 9
"""Cells to begin with, and the number of times a cell may be halved."""
BEND, FLAT = 0.08, 2e-4
"""A cell is halved while its half chords make a greater angle [rad], or its middle stands off more [of the size]."""
LEAST = 1e-5
"""Nothing smaller is looked at [of the size]."""


@frozen
class Sample:
    """Curves at positions: t (n,), the centre in each of k axes (k, n) [m], and homogeneous (3, n)."""

    t: np.ndarray
    places: np.ndarray
    homogeneous: np.ndarray


@frozen
class CentrodePiece:
    """An unbroken part of the curves: t (n,) and the places in each axes (k, n) [m]; each second t is a middle."""

    t: np.ndarray
    places: np.ndarray
    closed: bool = False


def pieces(at: Callable[[np.ndarray], Sample], low: float, high: float, size: float, far: float) -> list[CentrodePiece]:
    """The curves from t = low to high, as far as the centre lies within `far` [m] of the fixed point."""
    sample = at(np.linspace(low, high, 2 * FIRST + 1))
    for _ in range(DEEPEST):
        coarse = _coarse(sample, size, far)
        if not coarse.any():
            break
        sample = _halved(at, sample, coarse)
    return _cut(sample, far)


def _cells(values: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """First, middle and last of each cell."""
    return values[..., :-2:2], values[..., 1::2], values[..., 2::2]


def _coarse(sample: Sample, size: float, far: float) -> Array:
    """Cells that bend too much, or that leave the paper."""
    begin, middle, end = _cells(sample.places)
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        one, two = middle - begin, end - middle
        chord = np.abs(end - begin)
        bend = np.abs(np.angle(two * np.conj(one)))
        off = np.abs(middle - (begin + end) / 2)
        uneven = (off > FLAT * size) | (bend > BEND)
        bent = (uneven & ((np.abs(one) > LEAST * size) | (np.abs(two) > LEAST * size))).any(axis=0)
        long = (chord > size / 20).any(axis=0)
        inside = _inside(sample, far)
    first, mid, last = _cells(inside)
    some, all_of_it = first | mid | last, first & mid & last
    return np.asarray(some & (bent | long | ~all_of_it))


def _inside(sample: Sample, far: float) -> Array:
    with np.errstate(invalid="ignore"):
        return np.asarray((np.isfinite(sample.places) & (np.abs(sample.places) <= far)).all(axis=0))


def _halved(at: Callable[[np.ndarray], Sample], sample: Sample, coarse: np.ndarray) -> Sample:
    """Both halves of each coarse cell become cells with middles of their own."""
    begin, middle, end = _cells(sample.t)
    new = np.concatenate([(begin + middle)[coarse] / 2, (middle + end)[coarse] / 2])
    more = at(new)
    t = np.concatenate([sample.t, more.t])
    order = np.argsort(t, kind="stable")
    return Sample(
        t[order], np.concatenate([sample.places, more.places], axis=1)[:, order],
        np.concatenate([sample.homogeneous, more.homogeneous], axis=1)[:, order],
    )  # fmt: skip


def _cut(sample: Sample, far: float) -> list[CentrodePiece]:
    """Runs of cells that lie inside, cut between positions on two sides of infinity: w changes its sign there."""
    first, mid, last = _cells(_inside(sample, far))
    before, after = sample.homogeneous[:, :-1], sample.homogeneous[:, 1:]
    with np.errstate(invalid="ignore"):
        through = before[2] * after[2] * np.sign(np.sum(before * after, axis=0)) < 0
    good = first & mid & last & ~through[::2] & ~through[1::2]
    edges = np.flatnonzero(np.diff(np.concatenate([[0], good.astype(int), [0]])))
    return [
        CentrodePiece(sample.t[2 * a : 2 * b + 1], sample.places[:, 2 * a : 2 * b + 1])
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]


def arc_length(piece: CentrodePiece, axes: int = 0) -> np.ndarray:
    """The length from the piece's first place to the end of each cell [m]: (cells + 1,), to the fourth order."""
    begin, middle, end = _cells(piece.places[axes])
    halves, chord = np.abs(middle - begin) + np.abs(end - middle), np.abs(end - begin)
    return np.concatenate([[0.0], np.cumsum((4 * halves - chord) / 3)])


def joined(parts: Sequence[CentrodePiece], turn: float, near: float) -> list[CentrodePiece]:
    """The pieces of a motion that comes back to its beginning: the last goes on into the first.

    A single piece that meets itself is closed.
    turn  the extent of t; near  places closer than this are one [m]
    """
    if not parts:
        return []
    first, last = parts[0], parts[-1]
    if np.abs(first.places[:, 0] - last.places[:, -1]).max() > near:
        return list(parts)
    if len(parts) == 1:
        return [CentrodePiece(first.t, first.places, closed=True)]
    t = np.concatenate([last.t, first.t[1:] + turn])
    places = np.concatenate([last.places, first.places[:, 1:]], axis=1)
    return [CentrodePiece(t, places), *parts[1:-1]]
