"""A drawing with mistakes beside the right one: which planes differ, and what in them was drawn otherwise."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import get_args

import numpy as np

from graphkin.base.geometry import cross
from graphkin.base.value import frozen
from graphkin.construction import Construction, Drawn, Equation, Image, LayOff, Plane, Plot, Term
from graphkin.marking.consequences import rewritten
from graphkin.marking.rewrite import Rewrite
from graphkin.planning import Method

_NOTHING = 1e-6
"""What differs by less, as part of the largest value of its plane, is the same."""


@frozen
class Beside:
    """The right drawing and one with mistakes.

    planes  in which a point lies elsewhere, or nowhere: lines hardly cross there
    arrows  of each plane those laid off or directed otherwise, by their two ends; others only follow from these
    images  points of each plane that are found by another image

    Where the mechanism itself is drawn otherwise, all of its polygons only follows.
    """

    right: Plot
    other: Plot
    planes: tuple[Plane, ...]
    arrows: Mapping[Plane, frozenset[frozenset[str]]]
    images: Mapping[Plane, frozenset[str]]


def beside(method: Method, plot: Plot, rewrites: Sequence[Rewrite]) -> Beside:
    """What mistakes made together draw otherwise, at the position of a plot."""
    right, other = rewritten(method, plot, ()), rewritten(method, plot, rewrites)
    planes = tuple(plane for plane in get_args(Plane) if _differs(right, other, plane))
    polygons = [] if "position" in planes else [method.velocity, method.acceleration]
    return Beside(
        right, other, planes,
        {one.plane: frozenset(_arrows(one, right, other)) for one in polygons},
        {one.plane: frozenset(_images(one, right, other)) for one in polygons},
    )  # fmt: skip


def _size(right: Plot, other: Plot, plane: Plane) -> float:
    """What counts as nothing in a plane."""
    values = [abs(value) for plot in (right, other) for value in plot.points(plane).values()]
    return _NOTHING * max((size for size in values if np.isfinite(size)), default=0.0)


def _differs(right: Plot, other: Plot, plane: Plane) -> bool:
    nothing, there = _size(right, other, plane), other.points(plane)
    found = ((value, there.get(name, np.nan)) for name, value in right.points(plane).items() if np.isfinite(value))
    return any(not abs(one - two) <= nothing for one, two in found)


def _arrows(construction: Construction, right: Plot, other: Plot) -> Iterator[frozenset[str]]:
    """Known arrows that differ, and unknown ones that lie in another direction."""
    plane = construction.plane
    nothing = _size(right, other, plane)
    for term in _terms(construction):
        one, two = (_drawn(plot, plane, term.tail, term.head) for plot in (right, other))
        if not (np.isfinite(one) and np.isfinite(two)) or isinstance(term.size, Drawn):
            continue
        turned = term.direction is not None and abs(cross(one, two)) > _NOTHING * abs(one) * abs(two)
        if turned if term.size is None else abs(one - two) > nothing:
            yield frozenset((term.tail, term.head))


def _terms(construction: Construction) -> Iterator[Term]:
    for part in construction.parts:
        if isinstance(part, Equation):
            yield from (*part.left, *part.right)
        elif isinstance(part, LayOff):
            yield part.term


def _drawn(plot: Plot, plane: Plane, tail: str, head: str) -> complex:
    points = plot.points(plane)
    return complex(points.get(head, np.nan) - points.get(tail, np.nan))


def _images(construction: Construction, right: Plot, other: Plot) -> Iterator[str]:
    """Points that stand otherwise on their base."""
    plane = construction.plane
    nothing = _size(right, other, plane)
    for step in construction.steps:
        if isinstance(step, Image):
            tail, head = step.base
            (one, base), (two, base_now) = (
                (_drawn(plot, plane, tail, step.point), _drawn(plot, plane, tail, head)) for plot in (right, other)
            )
            if np.isfinite(two) and abs(base) > nothing and abs(two - one * base_now / base) > nothing:
                yield step.point
