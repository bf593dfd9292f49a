"""What a pencil gives for each quantity, right or with mistakes: values over many drawings, and how they scatter."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.marking.asked import ArrowPlaces, arrows_of, asked, size_of
from graphkin.marking.hand import Hands, Redrawing
from graphkin.marking.key import Sort
from graphkin.marking.pencil import Pencil, PencilHand, drawn_positions
from graphkin.marking.redrawing import redraw
from graphkin.marking.rewrite import Mistaken, Rewrite, RewrittenValue
from graphkin.marking.slips import Mark, Slips
from graphkin.model.quantities import (
    Centre,
    Component,
    Displacement,
    Moving,
    Place,
    Quantity,
    Quotient,
    Rotation,
    Track,
)
from graphkin.planning import Method

_AT_ONCE, _NUMBERS = 64, 2**21
"""Mistakes that are drawn at once, each many times; fewer where more numbers than these are read off."""
_HARDLY = 0.05
"""Where a smaller part of the drawings closes, nobody begins again."""
_PARTS = ((0.6826894921370859, 1.0), (0.99, 2.5758293035489004))
"""These parts of its values lie within so many standard deviations of a normal quantity."""


@frozen
class Drawings:
    """One mechanism drawn many times with a pencil, positions (n,).

    failed  part of the drawings whose links did not meet. Whoever draws one begins again, on another sheet: it is none
            of the n, unless hardly any closes
    """

    method: Method
    pencil: Pencil
    slips: Slips
    arrows: ArrowPlaces
    positions: Plot
    failed: float = 0.0

    @classmethod
    def of(cls, method: Method, pencil: Pencil, slips: Slips) -> Drawings:
        with np.errstate(invalid="ignore", divide="ignore"):
            positions = drawn_positions(method, pencil, slips)
            failed = float(1 - _closed(positions, slips.count).mean())
            if 0 < failed < 1 - _HARDLY:
                slips = _begun_again(method, pencil, slips, failed)
                positions = drawn_positions(method, pencil, slips)
            return cls(method, pencil, slips, arrows_of(method), positions, failed)

    def values(self, quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]] = ((),)) -> np.ndarray:
        """What is read off: (columns, n, quantities); each column is drawn with its mistakes."""
        parts = [*self.parts(quantities, columns)]
        return np.concatenate(parts) if parts else np.empty((0, self.slips.count, len(quantities)))

    def parts(self, quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]]) -> Iterator[np.ndarray]:
        """The same, some columns at a time: of many links all of them are more than a memory holds."""
        some = min(_AT_ONCE, max(1, _NUMBERS // (self.slips.count * max(1, len(quantities)))))
        for k in range(0, len(columns), some):
            yield self._values(quantities, columns[k : k + some])

    def _values(self, quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]]) -> np.ndarray:
        mistaken = Mistaken(columns, (self.slips.count,))
        hand = Hands(mistaken, PencilHand(self.pencil, self.slips, self.method.facts()))
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            plot = redraw(self.method, mistaken.placed(self.method, self.positions), hand, mistaken.shape)
            found = [np.broadcast_to(self._read(plot, quantity), mistaken.shape) for quantity in quantities]
        values = np.stack(found, axis=-1).astype(float, copy=False) if found else np.empty((*mistaken.shape, 0))
        for row, rewrites in enumerate(columns):
            for written in (one for rewrite in rewrites for one in rewrite.asked):
                k = [q.text for q in quantities].index(written.quantity)
                values[row, :, k] = _written(quantities[k], written, values[row, :, k])
        return values

    def _read(self, plot: Redrawing, quantity: Quantity) -> Value:
        """A value as it is read off, with what a ruler or a protractor errs by."""
        value = asked(self.method, plot, quantity, self.arrows).value
        return value + self._slip(plot, quantity)

    def _slip(self, plot: Redrawing, quantity: Quantity) -> Value:
        """Only what is read off at the end; rotations were read on the way, products of readings are calculated."""
        lengths, slips = self.pencil.lengths, self.slips
        match quantity:
            case Rotation(word="theta"):
                return self.pencil.angle * slips.of(Mark("position", "reading", (quantity.text,)))
            case Displacement() | Place():
                return lengths["position"] * slips.of(Mark("position", "reading", (quantity.text,)))
            case Moving() | Component():
                plane = "velocity" if quantity.letter == "v" else "acceleration"
                ends = self.arrows.of(quantity if isinstance(quantity, Moving) else quantity.whole)
                if ends is not None and ends[0] in plot.laid:
                    return 0.0
                of = (quantity.text,) if ends is None else ends[0][1:]
                return lengths[plane] * slips.of(Mark(plane, "reading", of))  # type: ignore[index, arg-type]
            case Rotation() | Quotient() | Track() | Centre():
                return 0.0
            case _:
                assert_never(quantity)


def _closed(positions: Plot, count: int) -> np.ndarray:
    """Which drawings have a place for every point (count,)."""
    found = np.ones(count, dtype=bool)
    for place in positions.position.values():
        found &= np.isfinite(place)
    return found


def _begun_again(method: Method, pencil: Pencil, slips: Slips, failed: float) -> Slips:
    """The first drawings that close, as many as there were."""
    more = slips.more(int(1.5 * slips.count / (1 - failed)) + 10)
    kept = np.flatnonzero(_closed(drawn_positions(method, pencil, more), more.count))
    return more.only(kept[: slips.count])


def _written(quantity: Quantity, written: RewrittenValue, values: np.ndarray) -> np.ndarray:
    """What is handed in for values that were read: so many times them, or another value that scatters as they do."""
    if written.instead is not None:
        other = complex(written.factor * written.instead)
        around: float = size_of(quantity, other) if isinstance(quantity, Moving) else other.real
        return values + (around - float(np.nanmean(values)))
    factor = complex(written.factor)
    return values * (abs(factor) if isinstance(quantity, Moving) else factor.real)


def spread(values: np.ndarray, around: np.ndarray, sorts: Sequence[Sort]) -> np.ndarray:
    """Standard deviations over drawings (.., n, quantities) from values (.., quantities).

    NaN where most drawings fail; others are left out. By how much two thirds of the values are off at most, or nearly
    all, whichever is more: near a dead point the ends reach far.
    """
    off = np.sort(_off(values, around[..., None, :], sorts), axis=-2)  # NaN come last
    count = np.isfinite(off).sum(axis=-2)
    found = []
    for part, sigmas in _PARTS:
        place = np.maximum(np.ceil(part * count).astype(int) - 1, 0)
        found.append(np.take_along_axis(off, place[..., None, :], axis=-2)[..., 0, :] / sigmas)
    return np.where(2 * count < values.shape[-2], np.nan, np.maximum(*found))


def _off(values: np.ndarray, around: np.ndarray, sorts: Sequence[Sort]) -> np.ndarray:
    """By how much: sizes without sign, angles modulo a turn."""
    size, angle = (np.array([sort == kind for sort in sorts], dtype=bool) for kind in ("size", "angle"))
    plain = np.where(size, np.abs(values) - np.abs(around), values - around)
    found: np.ndarray = np.abs(np.where(angle, plain - 2 * np.pi * np.round(plain / (2 * np.pi)), plain))
    return found
