"""Outcomes of all mistakes that can be made, all drawn at once; and a drawing with mistakes beside the right one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import get_args

import numpy as np

from graphkin.base.geometry import Value, cross, number, place
from graphkin.base.value import frozen
from graphkin.construction import Construction, Drawn, Equation, Image, LayOff, Plane, Plot
from graphkin.marking import mistakes as _entered  # noqa: F401  (enters them)
from graphkin.marking.answers import arrows_of, drawn_answer, size_of
from graphkin.marking.hand import Redrawing, redraw
from graphkin.marking.key import Name
from graphkin.marking.rewrite import Mistaken, Rewrite
from graphkin.marking.scene import MISTAKES, Scene
from graphkin.model.quantities import Answer, Centre, Quantity
from graphkin.planning import Method

SAME = 1e-9  # values that differ by less, as part of their size, are one

_TABLES = ("position", "velocity", "acceleration", "theta", "omega", "alpha", "s", "s_rate", "s_acceleration", "sines",
           "laid", "met", "before")  # fmt: skip


@frozen
class Consequences:
    """The consequences of mistakes.

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
        values = np.array([answer.value for answer in self.right], dtype=float)
        vectors = np.array([np.nan if one.vector is None else one.vector for one in self.right], dtype=complex)
        same = _equal(self.values, values, self.sizes) & _equal(self.vectors, vectors, self.sizes)
        return np.asarray(~same.all(axis=1))


def _equal(one: np.ndarray, other: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Values that equal others but for rounding; what is not judged equals what is not."""
    with np.errstate(invalid="ignore"):
        near = np.abs(one - other) <= SAME * np.maximum(np.maximum(np.abs(one), np.abs(other)), sizes)
    return np.asarray(near | (one == other) | (np.isnan(one) & np.isnan(other)))


def rewrites(
    method: Method, plot: Plot, quantities: Sequence[Quantity] = (), scales: Mapping[str, float] | None = None
) -> tuple[Rewrite, ...]:
    """Every mistake that can be made in a construction, once for each place and form."""
    scene = Scene(method, plot, tuple(quantities), scales or {})
    count: Counter[Name] = Counter()
    numbered = []
    for rewrite in (replace(one, id=id) for id, mistake in MISTAKES.items() for one in mistake.find(scene)):
        count[rewrite.name] += 1  # two slides may be looked at in one coincident point
        nth = count[rewrite.name]
        *others, last = rewrite.of or ("",)
        numbered.append(rewrite if nth == 1 else replace(rewrite, of=(*others, f"{last} ({nth})")))
    return tuple(numbered)


def consequences(
    method: Method, plot: Plot, quantities: Sequence[Quantity], scales: Mapping[str, float] | None = None
) -> Consequences:
    """All single mistakes at the position of a plot; quantities that are no numbers there must be left out."""
    return combined(method, plot, quantities, [(one,) for one in rewrites(method, plot, quantities, scales)])


def combined(
    method: Method, plot: Plot, quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]]
) -> Consequences:
    """The consequences of mistakes, those of a column made together. Instant centres come from the mechanism's drawing
    alone: no polygon moves them."""
    arrows = arrows_of(method)
    hand = Mistaken(columns)
    placed = hand.placed(method, plot)
    drawn, right, still = redraw(method, placed, hand, hand.shape), redraw(method, plot), redraw(method, placed)
    with np.errstate(divide="ignore", invalid="ignore"):  # of what a mistake leaves nothing of
        answers = [drawn_answer(method, still if isinstance(q, Centre) else drawn, q, arrows) for q in quantities]
    cut = method.mechanism.usual.cut
    values = table_of([cut(answer.value, answer.unit) for answer in answers], len(columns), float)
    vectors = table_of([np.nan if a.vector is None else cut(a.vector, a.unit) for a in answers], len(columns), complex)
    written_otherwise(quantities, columns, values, vectors)
    return Consequences(
        tuple(quantities), tuple(drawn_answer(method, right, quantity, arrows) for quantity in quantities),
        tuple(map(tuple, columns)), values, vectors,
        np.array([method.mechanism.usual.size(quantity.unit) for quantity in quantities]), drawn,
    )  # fmt: skip


def written_otherwise(
    quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]], values: np.ndarray, vectors: np.ndarray
) -> None:
    """Puts what is drawn right and written otherwise in the place of what was read (columns, quantities)."""
    numbers = {quantity.text: k for k, quantity in enumerate(quantities)}
    for row, rewrites in enumerate(columns):
        read, whole = values[row].copy(), vectors[row].copy()
        for one in (one for rewrite in rewrites for one in rewrite.asked):
            if not {one.quantity, one.other or one.quantity} <= numbers.keys():
                continue
            k = numbers[one.quantity]
            if one.other:
                values[row, k], vectors[row, k] = read[numbers[one.other]], whole[numbers[one.other]]
            elif np.isfinite(vectors[row, k]):
                vectors[row, k] = one.factor * (vectors[row, k] if one.instead is None else one.instead)
                values[row, k] = size_of(quantities[k], vectors[row, k])
            else:
                values[row, k] = (one.factor * (values[row, k] if one.instead is None else one.instead)).real


def table_of(columns: Sequence[Value], count: int, kind: type) -> np.ndarray:
    """Columns of values, or of one for all, beside each other (count, columns)."""
    if not columns:
        return np.zeros((count, 0), dtype=kind)
    return np.stack([np.broadcast_to(np.asarray(value, dtype=kind), (count,)) for value in columns], axis=1)


def rewritten(method: Method, plot: Plot, rewrites: Sequence[Rewrite]) -> Redrawing:
    """One drawing with mistakes, as a plot of its own (scalars): for the figure beside the right one."""
    hand = Mistaken([rewrites])
    drawn = redraw(method, hand.placed(method, plot), hand, hand.shape)
    for table in _TABLES:
        alone = {name: value[0] if np.ndim(value) else value for name, value in getattr(drawn, table).items()}
        setattr(drawn, table, alone)
    return drawn


# --- beside the right drawing ------------------------------------------------------------------


_NOTHING = 1e-6  # what differs by less, as part of the largest value of its plane, is the same


@frozen
class DrawingComparison:
    """The right drawing and one with mistakes.

    planes  in which a point lies elsewhere, or nowhere: lines hardly cross there
    arrows  of each plane those laid off or directed otherwise, by their two ends; others only follow from these
    images  points of each plane that are found by another image

    Where the mechanism itself is drawn otherwise, all of its polygons only follows.
    """

    other: Plot
    planes: tuple[Plane, ...]
    arrows: Mapping[Plane, frozenset[frozenset[str]]]
    images: Mapping[Plane, frozenset[str]]


def compare_drawings(method: Method, plot: Plot, rewrites: Sequence[Rewrite]) -> DrawingComparison:
    """The parts of a drawing that mistakes made together draw otherwise, at the position of a plot."""
    right, other = rewritten(method, plot, ()), rewritten(method, plot, rewrites)
    planes: list[Plane] = []
    for plane in get_args(Plane):
        nothing, there = _least(right, other, plane), other.points(plane)
        places = ((place(value), place(there.get(name, np.nan))) for name, value in right.points(plane).items())
        if any(not abs(one - two) <= nothing for one, two in places if np.isfinite(one)):
            planes.append(plane)
    polygons = [] if "position" in planes else [method.velocity, method.acceleration]
    arrows = {one.plane: frozenset(_arrows(one, right, other)) for one in polygons}
    images = {one.plane: frozenset(_images(one, right, other)) for one in polygons}
    return DrawingComparison(other, tuple(planes), arrows, images)


def _least(right: Plot, other: Plot, plane: Plane) -> float:
    """The size up to which a value of a plane is nothing."""
    sizes = [abs(place(value)) for plot in (right, other) for value in plot.points(plane).values()]
    return _NOTHING * max((size for size in sizes if np.isfinite(size)), default=0.0)


def _arrows(construction: Construction, right: Plot, other: Plot) -> Iterator[frozenset[str]]:
    """Known arrows that differ, and unknown ones that lie in another direction."""
    plane = construction.plane
    nothing = _least(right, other, plane)
    for part in construction.parts:
        terms = (*part.left, *part.right) if isinstance(part, Equation) else ()
        for term in (part.term,) if isinstance(part, LayOff) else terms:
            one, two = (_between(plot, plane, term.tail, term.head) for plot in (right, other))
            if not (np.isfinite(one) and np.isfinite(two)) or isinstance(term.size, Drawn):
                continue
            turned = term.direction is not None and abs(number(cross(one, two))) > _NOTHING * abs(one) * abs(two)
            if turned if term.size is None else abs(one - two) > nothing:
                yield frozenset((term.tail, term.head))


def _between(plot: Plot, plane: Plane, tail: str, head: str) -> complex:
    points = plot.points(plane)
    return complex(points.get(head, np.nan) - points.get(tail, np.nan))


def _images(construction: Construction, right: Plot, other: Plot) -> Iterator[str]:
    """Points that stand otherwise on their base."""
    plane = construction.plane
    nothing = _least(right, other, plane)
    for step in construction.steps:
        if isinstance(step, Image):
            tail, head = step.base
            (one, base), (two, base_now) = (
                (_between(plot, plane, tail, step.point), _between(plot, plane, tail, head)) for plot in (right, other)
            )
            if np.isfinite(two) and abs(base) > nothing and abs(two - one * base_now / base) > nothing:
                yield step.point
