"""Quantities that may be handed in, and their values read off a drawing as a student reads them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Real, Value, dot
from graphkin.base.value import frozen
from graphkin.construction import Given, Image, Normal, Plane, Site
from graphkin.marking.hand import Redrawing
from graphkin.marking.key import Sort
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import Seen
from graphkin.model.quantities import Quantity, kinds
from graphkin.model.quantities.kinds import Answer, on_axis
from graphkin.model.quantities.reading import quietly
from graphkin.planning import Method
from graphkin.proof.readings import readings

ACROSS = 1e-9  # less along a guide, as part of a vector, is nothing
Ends = tuple[Plane, str, str]  # plane, tail and head of an arrow


def asked_of(mechanism: Mechanism) -> dict[str, Quantity]:
    """The quantities a file asks for, by its own words, as far as the answer is a number."""
    questions = ((question, readable(mechanism, question)) for question in mechanism.ask)
    return {question: quantity for question, quantity in questions if quantity is not None}


def on_the_way(method: Method) -> tuple[Quantity, ...]:
    """Rotations of the links that no driver gives, arrows and images of both polygons, in the order they are drawn."""
    mechanism = method.mechanism
    driven = {driver.link for driver in mechanism.drivers if driver.kind != "slide"}
    links = [link for link in mechanism.moving if link not in driven]
    quantities: dict[str, Quantity] = {}
    for construction, letter, word in ((method.velocity, "v", "omega"), (method.acceleration, "a", "alpha")):
        texts = []
        for term in construction.vectors().values():
            if not term.over:  # `a_k B3B2` of the arrow a^k_B3B2
                comma = "," if "@" in term.of + term.seen_from and term.seen_from else ""
                texts.append(f"{letter}{'_' if term.part else ''}{term.part} {term.of}{comma}{term.seen_from}")
        images = [step.point for step in construction.steps if isinstance(step, Image)]
        points = [f"{letter} {construction.nodes[point].of}" for point in images if point in construction.nodes]
        for text in (*texts, *points, *(f"{word} {link}" for link in links)):
            if (quantity := readable(mechanism, text)) is not None:
                quantities.setdefault(quantity.text, quantity)
    return tuple(quantities.values())


def readable(mechanism: Mechanism, text: str) -> Quantity | None:
    """The quantity a text names, where its answer is a number."""
    quantity = quietly(mechanism, text)
    return None if quantity is not None and quantity.is_place else quantity


def sort_of(quantity: Quantity) -> Sort:
    """The meaning of a quantity's sign."""
    match quantity:
        case kinds.Moving():
            return "size"
        case kinds.Rotation(word="theta"):
            return "angle"
        case kinds.Rotation() | kinds.Displacement() | kinds.Place() | kinds.Track() | kinds.Component():
            return "sense"
        case kinds.Centre() | kinds.Quotient():
            return "sense"
        case _:
            assert_never(quantity)


@frozen
class ArrowPlaces:
    """The places of arrows in the polygons of a method.

    nodes   by link and point, its name in each plane
    resting the nodes that sit on the poles, as fixed points do
    parts   ends of the arrows seen from another point, by plane, part and both points of the plane
    sliding ends of those seen from a coincident point, by plane, part and both links, of links that turn together: at
            their other coincident points these are the same
    """

    nodes: Mapping[tuple[str, str, Plane], str]
    poles: Mapping[Plane, str]
    resting: frozenset[tuple[Plane, str]]
    parts: Mapping[tuple[Plane, str, str, str], Ends]
    sliding: Mapping[tuple[Plane, str, str, str], Ends]

    def node(self, site: Seen | Site, plane: Plane) -> str | None:
        return self.poles[plane] if site.link == FRAME else self.nodes.get((site.link, site.point, plane))

    def at_poles(self, ends: Ends) -> Ends:
        """The arrow with its ends at the pole where they sit on it."""
        plane, tail, head = ends
        tail, head = (self.poles[plane] if (plane, node) in self.resting else node for node in (tail, head))
        return plane, tail, head

    def of(self, quantity: kinds.Moving) -> tuple[Ends, int] | None:
        """The arrow a quantity names, and 1, or -1 where the polygon has it the other way round; None where none."""
        plane: Plane = "velocity" if quantity.letter == "v" else "acceleration"
        head = self.node(quantity.site, plane)
        tail = self.poles[plane] if quantity.seen_from is None else self.node(quantity.seen_from, plane)
        part, seen_from = quantity.part, quantity.seen_from
        if head is None or tail is None:
            if seen_from is None or seen_from.point != quantity.site.point:
                return None
            for links, sign in (((quantity.site.link, seen_from.link), 1), ((seen_from.link, quantity.site.link), -1)):
                if (plane, part, *links) in self.sliding:
                    return self.sliding[plane, part, *links], sign
            return None
        if part == "":
            return (plane, tail, head), 1
        if (plane, part, head, tail) in self.parts:
            return self.parts[plane, part, head, tail], 1
        reverse = self.parts.get((plane, part, tail, head))
        return None if reverse is None else (reverse, -1)


def arrows_of(method: Method) -> ArrowPlaces:
    """The arrows of both polygons."""
    nodes: dict[tuple[str, str, Plane], str] = {}
    owners, polygons = method.mechanism.owners, (method.velocity, method.acceleration)
    for construction in polygons:
        for node in construction.nodes.values():
            if node.site is not None:
                own = owners.get(node.site.point, ())
                for link in own if node.site.link in own else (node.site.link,):
                    nodes.setdefault((link, node.site.point, construction.plane), node.name)
    parts: dict[tuple[Plane, str, str, str], Ends] = {}
    resting = frozenset((construction.plane, name) for construction in polygons for step in construction.steps
                        if isinstance(step, Given) for name in step.also)  # fmt: skip
    sliding: dict[tuple[Plane, str, str, str], Ends] = {}
    poles, turns = {construction.plane: construction.pole for construction in polygons}, method.facts().turns
    arrows = ArrowPlaces(nodes, poles, resting, parts, sliding)
    for construction in polygons:
        plane = construction.plane
        for term in construction.vectors().values():
            links = [site.link for site in term.sites if site.point == term.sites[0].point and site.link in turns]
            if len(links) == len(term.sites) == 2 and turns[links[0]].base == turns[links[1]].base:
                sliding.setdefault((plane, term.part, links[0], links[1]), (plane, term.tail, term.head))
            part = term.part or ("n" if isinstance(term.size, Normal) else "")  # a lone normal arrow of a crank too
            if part and len(term.sites) == 2:
                head, tail = (_node_of(arrows, site, plane, method.mechanism) for site in term.sites)
                if head is not None and tail is not None:
                    parts.setdefault((plane, part, head, tail), (plane, term.tail, term.head))
    return arrows


def _node_of(arrows: ArrowPlaces, site: Site, plane: Plane, mechanism: Mechanism) -> str | None:
    """The point of a pin's own block is that of the links which bear the pin."""
    links = (site.link,) if site.link in mechanism.links else mechanism.owners.get(site.point, ())
    nodes = (arrows.node(Site(site.point, link), plane) for link in links)
    return next((node for node in nodes if node is not None), None)


def drawn_answer(
    method: Method, plot: Redrawing, quantity: Quantity, arrows: ArrowPlaces, before: bool = False
) -> Answer:
    """The value of a quantity in a drawing: one value a column; along a guide with its sign.

    before  as it follows from what was drawn earlier, where the hand then put a point elsewhere
    """
    match quantity:
        case kinds.Moving():
            vector = _vector(method, plot, quantity, arrows, before)
            return Answer(size_of(quantity, vector), quantity.unit, vector)
        case kinds.Component(axis=axis, whole=whole):
            return Answer(on_axis(_vector(method, plot, whole, arrows, before), axis), quantity.unit)
        case kinds.Quotient():
            top, bottom = (drawn_answer(method, plot, half, arrows, before).value for half in quantity.halves)
            with np.errstate(divide="ignore", invalid="ignore"):
                return Answer(np.divide(top, bottom), "1")
        case kinds.Rotation() | kinds.Displacement() | kinds.Place() | kinds.Track() | kinds.Centre():
            return quantity.answer(readings(method, plot))
        case _:
            assert_never(quantity)


def size_of(quantity: Quantity, vector: Value) -> Real:
    """The size of a vector; of one along a guide with its sign, the whole of it though a mistake has it beside, and
    without one where a mistake has it across."""
    size: Real = np.abs(vector)
    if quantity.along is not None:
        size = np.where(dot(quantity.along, vector) < -ACROSS * size, -size, size)[()]
    return size


def _vector(method: Method, plot: Redrawing, quantity: kinds.Moving, arrows: ArrowPlaces, before: bool) -> Value:
    arrow = arrows.of(quantity)
    if arrow is None:
        return quantity.vector(readings(method, plot))
    (plane, tail, head), sign = arrow
    if (plane, tail, head) in plot.laid:
        return sign * plot.laid[plane, tail, head]
    points = plot.points(plane)
    end = plot.met.get((plane, head), points[head]) if before and tail == arrows.poles[plane] else points[head]
    return sign * (end - points[tail])
