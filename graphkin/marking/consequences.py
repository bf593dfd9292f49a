"""What every mistake that can be made leads to, all drawn at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from graphkin.construction import Plot
from graphkin.geometry import Value
from graphkin.marking import mistakes as _entered  # noqa: F401  (enters them)
from graphkin.marking.asked import arrows_of, asked
from graphkin.marking.redrawing import Redrawing, redraw
from graphkin.marking.rewrite import Mistaken, Rewrite
from graphkin.marking.scene import MISTAKES, Scene
from graphkin.planning import Method
from graphkin.quantities import Answer, Quantity
from graphkin.value import frozen

__all__ = ["Consequences", "combined", "consequences", "rewrites"]


@frozen
class Consequences:
    """What follows from mistakes.

    quantities  what is asked
    right       the right answers
    columns     the mistakes: one of them each, or several made together
    values      (columns, quantities): sizes, rotations with their sense, along a guide with their sign; NaN where the
                mistake leaves nothing to be judged
    vectors     (columns, quantities), complex; NaN for scalars
    plot        the drawings, one column a mistake
    """

    quantities: tuple[Quantity, ...]
    right: tuple[Answer, ...]
    columns: tuple[tuple[Rewrite, ...], ...]
    values: np.ndarray
    vectors: np.ndarray
    plot: Redrawing


def rewrites(
    method: Method, plot: Plot, quantities: Sequence[Quantity] = (), scales: Mapping[str, float] | None = None
) -> tuple[Rewrite, ...]:
    """Every mistake that can be made in a construction, once for each place and form."""
    scene = Scene(method, plot, tuple(quantities), scales or {})
    return tuple(found for one in MISTAKES.values() for found in one.find(scene))


def consequences(
    method: Method, plot: Plot, quantities: Sequence[Quantity], scales: Mapping[str, float] | None = None
) -> Consequences:
    """All single mistakes at the position of a plot; quantities that are no numbers there must be left out."""
    found = rewrites(method, plot, quantities, scales)
    return combined(method, plot, quantities, [(one,) for one in found])


def combined(
    method: Method, plot: Plot, quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]]
) -> Consequences:
    """What follows from mistakes, those of a column made together."""
    arrows = arrows_of(method)
    hand = Mistaken(columns)
    drawn = redraw(method, plot, hand, hand.shape)
    right = redraw(method, plot)
    answers = [asked(method, drawn, quantity, arrows) for quantity in quantities]
    values = _table([answer.value for answer in answers], len(columns), float)
    vectors = _table([np.nan if a.vector is None else a.vector for a in answers], len(columns), complex)
    _write_otherwise(columns, quantities, values, vectors)
    return Consequences(
        tuple(quantities), tuple(asked(method, right, quantity, arrows) for quantity in quantities),
        tuple(map(tuple, columns)), values, vectors, drawn,
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
        for text, factor in (pair for rewrite in rewrites for pair in rewrite.asked):
            values[row, place[text]] *= factor
            vectors[row, place[text]] *= factor
