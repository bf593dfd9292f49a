"""What every mistake that can be made leads to, all drawn at once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.marking import mistakes as _entered  # noqa: F401  (enters them)
from graphkin.marking.asked import arrows_of, asked, size_of
from graphkin.marking.hand import Redrawing
from graphkin.marking.redrawing import redraw
from graphkin.marking.rewrite import Mistaken, Rewrite
from graphkin.marking.scene import MISTAKES, Scene
from graphkin.model.quantities import Answer, Centre, Quantity
from graphkin.planning import Method

SAME = 1e-9
"""Values that differ by less, as part of their size, are one."""

_TABLES = ("position", "velocity", "acceleration", "theta", "omega", "alpha", "s", "s_rate", "s_acceleration", "sines",
           "laid", "met", "before")  # fmt: skip


@frozen
class Consequences:
    """What follows from mistakes.

    quantities  what is asked
    right       the right answers
    columns     the mistakes: one of them each, or several made together
    values      (columns, quantities): sizes, rotations with their sense, along a guide with their sign; NaN where the
                mistake leaves nothing to be judged
    vectors     (columns, quantities), complex; NaN for scalars
    sizes       (quantities,): what is usual of its kind, beside which less than 1e-9 is nothing
    plot        the drawings, one column a mistake
    moves       (columns,): whether a mistake changes anything that is asked here, or leaves nothing of it to be judged
    """

    quantities: tuple[Quantity, ...]
    right: tuple[Answer, ...]
    columns: tuple[tuple[Rewrite, ...], ...]
    values: np.ndarray
    vectors: np.ndarray
    sizes: np.ndarray
    plot: Redrawing

    @cached_property
    def moves(self) -> np.ndarray:
        vectors = [np.nan if answer.vector is None else answer.vector for answer in self.right]
        right = np.array([answer.value for answer in self.right], dtype=float), np.array(vectors, dtype=complex)
        found: np.ndarray = ~self._like(*right)
        return found

    def alike(self) -> list[list[int]]:
        """Groups of columns that cannot be told apart by what is asked; those that change nothing left out."""
        groups: list[list[int]] = []
        left = np.flatnonzero(self.moves)
        while left.size:
            same = self._like(self.values[left[0]], self.vectors[left[0]])[left]
            groups.append(left[same].tolist())
            left = left[~same]
        return groups

    def _like(self, values: np.ndarray, vectors: np.ndarray) -> np.ndarray:
        """Which columns give these values and vectors (quantities,)."""
        found: np.ndarray = _equal(self.values, values, self.sizes) & _equal(self.vectors, vectors, self.sizes)
        return found


def _equal(one: np.ndarray, other: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Rows that equal another but for rounding; what is not judged equals what is not."""
    with np.errstate(invalid="ignore"):
        near = np.abs(one - other) <= SAME * np.maximum(np.maximum(np.abs(one), np.abs(other)), sizes)
    found: np.ndarray = (near | (one == other) | (np.isnan(one) & np.isnan(other))).all(axis=1)
    return found


def rewrites(
    method: Method, plot: Plot, quantities: Sequence[Quantity] = (), scales: Mapping[str, float] | None = None
) -> tuple[Rewrite, ...]:
    """Every mistake that can be made in a construction, once for each place and form."""
    scene = Scene(method, plot, tuple(quantities), scales or {})
    return tuple(_numbered(found for one in MISTAKES.values() for found in one.find(scene)))


def _numbered(found: Iterator[Rewrite]) -> Iterator[Rewrite]:
    """Rewrites of arrows of one name told apart: two slides may be looked at in one coincident point."""
    names: dict[tuple[str, ...], int] = {}
    for rewrite in found:
        nth = names[rewrite.name] = names.get(rewrite.name, 0) + 1
        yield rewrite if nth == 1 else replace(rewrite, of=f"{rewrite.of} ({nth})")


def consequences(
    method: Method, plot: Plot, quantities: Sequence[Quantity], scales: Mapping[str, float] | None = None
) -> Consequences:
    """All single mistakes at the position of a plot; quantities that are no numbers there must be left out."""
    found = rewrites(method, plot, quantities, scales)
    return combined(method, plot, quantities, [(one,) for one in found])


def combined(
    method: Method, plot: Plot, quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]]
) -> Consequences:
    """What follows from mistakes, those of a column made together. Instant centres come from the mechanism's drawing
    alone: no polygon moves them."""
    arrows = arrows_of(method)
    hand = Mistaken(columns)
    placed = hand.placed(method, plot)
    drawn, right, still = redraw(method, placed, hand, hand.shape), redraw(method, plot), redraw(method, placed)
    with np.errstate(divide="ignore", invalid="ignore"):  # of what a mistake leaves nothing of
        answers = [asked(method, still if isinstance(q, Centre) else drawn, q, arrows) for q in quantities]
    cut = method.mechanism.usual.cut
    values = _table([cut(answer.value, answer.unit) for answer in answers], len(columns), float)
    vectors = _table([np.nan if a.vector is None else cut(a.vector, a.unit) for a in answers], len(columns), complex)
    _write_otherwise(columns, quantities, values, vectors)
    return Consequences(
        tuple(quantities), tuple(asked(method, right, quantity, arrows) for quantity in quantities),
        tuple(map(tuple, columns)), values, vectors,
        np.array([method.mechanism.usual.size(quantity.unit) for quantity in quantities]), drawn,
    )  # fmt: skip


def _table(columns: Sequence[Value], count: int, kind: type) -> np.ndarray:
    if not columns:
        return np.zeros((count, 0), dtype=kind)
    return np.stack([np.broadcast_to(np.asarray(value, dtype=kind), (count,)) for value in columns], axis=1)


def _write_otherwise(
    columns: Sequence[Sequence[Rewrite]], quantities: Sequence[Quantity], values: np.ndarray, vectors: np.ndarray
) -> None:
    """Handed-in values that were drawn right and written otherwise."""
    place = {quantity.text: k for k, quantity in enumerate(quantities)}
    for row, rewrites in enumerate(columns):
        for one in (one for rewrite in rewrites for one in rewrite.asked):
            k = place[one.quantity]
            if np.isfinite(vectors[row, k]):
                vectors[row, k] = one.factor * (vectors[row, k] if one.instead is None else one.instead)
                values[row, k] = size_of(quantities[k], vectors[row, k])
            else:
                values[row, k] = (one.factor * (values[row, k] if one.instead is None else one.instead)).real


def rewritten(method: Method, plot: Plot, rewrites: Sequence[Rewrite]) -> Redrawing:
    """One drawing with mistakes, as a plot of its own (scalars): for the figure beside the right one."""
    hand = Mistaken([rewrites])
    drawn = redraw(method, hand.placed(method, plot), hand, hand.shape)
    for table in _TABLES:
        alone = {name: value[0] if np.ndim(value) else value for name, value in getattr(drawn, table).items()}
        setattr(drawn, table, alone)
    return drawn
