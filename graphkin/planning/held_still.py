"""A polygon in which the points that drivers at rest hold are what they are: fixed points, on the pole.

Only the telling of a polygon changes: its steps stay as they were planned, for drivers that move.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.construction import Arc, Drawn, Equation, Image, LayOff, Measure, Meet, Plane, Ray, Step, Term
from graphkin.model.mechanism import FRAME
from graphkin.planning.method import Method
from graphkin.planning.needed import Fact, Part, rests


def held_points(method: Method, plane: Plane, rested: frozenset[Fact]) -> tuple[str, ...]:
    """The points of the mechanism that drivers at rest hold."""
    nodes = _held(method, plane, rested)
    return tuple(dict.fromkeys(point for point, _ in nodes.values()))


def held_labels(method: Method, plane: Plane, rested: frozenset[Fact]) -> dict[str, str]:
    """How those points are written in the polygon, `D7`, and their letters."""
    return {of: point for point, of in _held(method, plane, rested).values()}


def standing(method: Method, plane: Plane, parts: tuple[Part, ...], rested: frozenset[Fact]) -> tuple[Part, ...]:
    """The parts that find something that moves, with the pole for every point that does not."""
    construction = method.velocity if plane == "velocity" else method.acceleration
    nodes = _held(method, plane, rested)
    writer = _PartsWriter(plane, construction.pole, nodes, {of: point for point, of in nodes.values()})
    return tuple(writer.part(part) for part in parts if not rests(method, plane, part, rested))


def _held(method: Method, plane: Plane, rested: frozenset[Fact]) -> dict[str, tuple[str, str]]:
    """By node of the polygon, its point and how it is written there; fixed points are on the pole anyway."""
    construction = method.velocity if plane == "velocity" else method.acceleration
    moving = ((name, node) for name, node in construction.nodes.items() if (plane, name) in rested)
    return {name: (node.site.point, node.of) for name, node in moving if node.site and node.site.link != FRAME}


@frozen
class _PartsWriter:
    """Writes parts anew: `nodes` become the pole, `labels` the letters of their points."""

    plane: Plane
    pole: str
    nodes: Mapping[str, tuple[str, str]]
    labels: Mapping[str, str]

    def part(self, part: Part) -> Part:
        if not self.nodes:
            return part
        if isinstance(part, Equation):
            steps = tuple(self.step(step) for step in part.steps)
            return replace(part, left=self.side(part.left), right=self.side(part.right), steps=steps)
        return self.step(part)

    def step(self, step: Step) -> Step:
        if isinstance(step, LayOff):
            return replace(step, term=self.term(step.term), start=self.node(step.start), tip=self.node(step.tip))
        if isinstance(step, Ray):
            return replace(step, through=self.node(step.through))
        if isinstance(step, Meet):
            return replace(step, first=self.ray(step.first), second=self.ray(step.second))
        if isinstance(step, Image):
            return replace(step, base=(self.node(step.base[0]), self.node(step.base[1])))
        if isinstance(step, Measure):
            return replace(step, tail=self.node(step.tail), head=self.node(step.head))
        return step

    def ray(self, locus: Ray | Arc) -> Ray | Arc:
        return replace(locus, through=self.node(locus.through)) if isinstance(locus, Ray) else locus

    def side(self, terms: tuple[Term, ...]) -> tuple[Term, ...]:
        """A side of an equation without the motion of a point that has none, where anything is left."""
        held = isinstance(terms[0].size, Drawn) and terms[0].head in self.nodes
        return tuple(self.term(term) for term in (terms[1:] if held and len(terms) > 1 else terms))

    def term(self, term: Term) -> Term:
        return replace(relabelled(term, self.plane, self.labels), tail=self.node(term.tail), head=self.node(term.head))

    def node(self, name: str) -> str:
        return self.pole if name in self.nodes else name


def relabelled(term: Term, plane: Plane, labels: Mapping[str, str]) -> Term:
    """With the letters of fixed points; seen from one, a velocity is an absolute one."""
    absolute = plane == "velocity" and term.seen_from in labels
    seen_from = "" if absolute else labels.get(term.seen_from, term.seen_from)
    return replace(term, of=labels.get(term.of, term.of), seen_from=seen_from)
