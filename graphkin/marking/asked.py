"""What is asked, read off a drawing as a student reads it: arrows where they were drawn, else by what is known."""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Value, dot
from graphkin.base.value import frozen
from graphkin.construction import Normal, Plane, Site, Term
from graphkin.marking.hand import Redrawing
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import Seen
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
from graphkin.model.quantities.kinds import Answer, on_axis
from graphkin.planning import Method
from graphkin.proof.readings import readings

ACROSS = 1e-9
"""Less along a guide, as part of a vector, is nothing."""

Ends = tuple[Plane, str, str]
"""Plane, tail and head of an arrow."""


@frozen
class ArrowPlaces:
    """Where arrows lie in the polygons of a method.

    nodes   by link and point, its name in each plane
    parts   ends of the arrows seen from another point, by plane, part and both points of the plane
    """

    nodes: Mapping[tuple[str, str, Plane], str]
    poles: Mapping[Plane, str]
    parts: Mapping[tuple[Plane, str, str, str], Ends]

    def node(self, site: Seen | Site, plane: Plane) -> str | None:
        return self.poles[plane] if site.link == FRAME else self.nodes.get((site.link, site.point, plane))

    def of(self, quantity: Moving) -> tuple[Ends, int] | None:
        """The arrow a quantity names, and 1, or -1 where the polygon has it the other way round; None where none."""
        plane: Plane = "velocity" if quantity.letter == "v" else "acceleration"
        head = self.node(quantity.site, plane)
        tail = self.poles[plane] if quantity.seen_from is None else self.node(quantity.seen_from, plane)
        if head is None or tail is None:
            return None
        if quantity.part == "":
            return (plane, tail, head), 1
        part = quantity.part
        if (plane, part, head, tail) in self.parts:
            return self.parts[plane, part, head, tail], 1
        turned = self.parts.get((plane, part, tail, head))
        return None if turned is None else (turned, -1)


def arrows_of(method: Method) -> ArrowPlaces:
    """The arrows of both polygons."""
    nodes: dict[tuple[str, str, Plane], str] = {}
    owners = method.mechanism.owners
    poles: dict[Plane, str] = {}
    parts: dict[tuple[Plane, str, str, str], Ends] = {}
    for construction in (method.velocity, method.acceleration):
        plane = construction.plane
        poles[plane] = construction.pole
        for node in construction.nodes.values():
            if node.site is not None:
                own = owners.get(node.site.point, ())
                for link in own if node.site.link in own else (node.site.link,):
                    nodes.setdefault((link, node.site.point, plane), node.name)
    known = ArrowPlaces(nodes, poles, parts)
    for construction in (method.velocity, method.acceleration):
        for term in construction.vectors().values():
            _put(known, parts, term, construction.plane, method.mechanism)
    return known


def _put(
    known: ArrowPlaces, parts: dict[tuple[Plane, str, str, str], Ends], term: Term, plane: Plane, mechanism: Mechanism
) -> None:
    """Under its part, where it is an arrow between two sites; a lone normal arrow of a crank too."""
    if len(term.sites) != 2:
        return
    head, tail = (_node_of(known, site, plane, mechanism) for site in term.sites)
    part = term.part or ("n" if isinstance(term.size, Normal) else "")
    if part and head is not None and tail is not None:
        parts.setdefault((plane, part, head, tail), (plane, term.tail, term.head))


def _node_of(known: ArrowPlaces, site: Site, plane: Plane, mechanism: Mechanism) -> str | None:
    """The point of a pin's own block is that of the links which bear the pin."""
    links = (site.link,) if site.link in mechanism.links else mechanism.owners.get(site.point, ())
    found = (known.node(Site(site.point, link), plane) for link in links)
    return next((node for node in found if node is not None), None)


def asked(method: Method, plot: Redrawing, quantity: Quantity, arrows: ArrowPlaces, before: bool = False) -> Answer:
    """What a drawing gives for a quantity: one value a column; along a guide with its sign.

    before  as it follows from what was drawn earlier, where the hand then put a point elsewhere
    """
    match quantity:
        case Moving():
            vector = _vector(method, plot, quantity, arrows, before)
            return Answer(size_of(quantity, vector), quantity.unit, vector)
        case Component(axis=axis, whole=whole):
            return Answer(on_axis(_vector(method, plot, whole, arrows, before), axis), quantity.unit)
        case Quotient():
            top, bottom = (asked(method, plot, half, arrows, before).value for half in quantity.halves)
            with np.errstate(divide="ignore", invalid="ignore"):
                return Answer(np.divide(top, bottom), "1")
        case Rotation() | Displacement() | Place() | Track() | Centre():
            return quantity.answer(readings(method, plot))
        case _:
            assert_never(quantity)


def size_of(quantity: Quantity, vector: Value) -> Value:
    """The size of a vector; of one along a guide with its sign, the whole of it though a mistake has it beside, and
    without one where a mistake has it across."""
    size = np.abs(vector)
    if quantity.along is None:
        return size
    return np.where(dot(quantity.along, vector) < -ACROSS * size, -size, size)[()]


def _vector(method: Method, plot: Redrawing, quantity: Moving, arrows: ArrowPlaces, before: bool) -> Value:
    found = arrows.of(quantity)
    if found is None:
        return quantity.vector(readings(method, plot))
    (plane, tail, head), sign = found
    if (plane, tail, head) in plot.laid:
        return sign * plot.laid[plane, tail, head]
    points = plot.points(plane)
    end = plot.met.get((plane, head), points[head]) if before and tail == arrows.poles[plane] else points[head]
    return sign * (end - points[tail])
