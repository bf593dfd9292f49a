"""A student at the drawing board, played: draws both polygons step by step, and hands in the board's file.

What the student does otherwise is said by hand: an arrow that is laid off otherwise, a line through another point or in
another direction. All that follows is drawn from that, and read off it.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from html import escape

from graphkin import load, plan
from graphkin.api.drawing import Source
from graphkin.base.geometry import Value, place
from graphkin.construction import Construction, Image, LayOff, Meet, Plane, Plot, Ray, Size
from graphkin.marking.answers import arrows_of, asked_of, drawn_answer
from graphkin.marking.equation_choices import EquationChoices, equation_choices
from graphkin.marking.hand import PolygonHand, Redrawing, redraw
from graphkin.model.quantities import EDGE, Rotation
from graphkin.planning import Method
from graphkin.running import replay_all

Json = dict[str, object]


@dataclass
class StudentHand(PolygonHand):
    """Draws otherwise: arrows times a factor by their name, sizes as they are calculated by their kind; lines by the
    point they lead to and the one they go through, through another one or turned by a factor; images mirrored."""

    arrows: Mapping[str, complex] = field(default_factory=dict)
    sizes: Mapping[str, complex] = field(default_factory=dict)
    through_others: Mapping[tuple[str, str], str] = field(default_factory=dict)
    turned: Mapping[tuple[str, str], complex] = field(default_factory=dict)
    mirrored: frozenset[str] = frozenset()

    def arrow(self, plot: Redrawing, plane: Plane, size: Size, right: Value) -> Value:
        return right * self.sizes.get(type(size).__name__, 1)

    def tip(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        start = plot.points(plane)[step.start]
        return start + (right - start) * self.arrows.get(step.term.name(plane), 1)

    def through(self, plot: Redrawing, plane: Plane, step: Meet, ray: Ray, right: Value) -> Value:
        other = self.through_others.get((step.point, ray.through))
        return right if other is None else plot.points(plane)[other]

    def line(self, plot: Redrawing, plane: Plane, step: Meet, ray: Ray, right: Value) -> Value:
        return right * self.turned.get((step.point, ray.through), 1)

    def corner(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        if step.point not in self.mirrored:
            return right
        tail, head = (plot.points(plane)[name] for name in step.base)
        return tail + (head - tail) * ((right - tail) / (head - tail)).conjugate()


@dataclass
class BoardStudent:
    """One student's work on a problem; millimetres by own scales.

    choices_of   changes the tokens of a term: (direction, magnitude) by (plane, number, term)
    """

    source: Source
    hand: PolygonHand = field(default_factory=PolygonHand)
    name: str = "s1"
    choices_of: Mapping[tuple[str, int, str], tuple[str, str]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.method: Method = plan(self.source)
        self.right: Plot = replay_all(self.method)
        self.plot = redraw(self.method, self.right, self.hand)
        self.choices = equation_choices(self.method, self.right)
        self.steps: list[Json] = []
        self.marks: list[str] = []
        self.scales: dict[str, float] = {}

    def data(self) -> Json:
        """The metadata of the file."""
        polygons = (self.method.velocity, self.method.acceleration)
        for down, polygon in enumerate(polygons):
            if any(abs(place(at)) > 0 for at in self.plot.points(polygon.plane).values()):
                self._draw(polygon, complex(150.0, 150.0 + 300.0 * down))
        problem: Json = {"mechanism": load(self.source).text, "student": self.name}
        return {
            "kind": "graphkin board", "format": 1, "lang": "en", "problem": problem, "scales": self.scales,
            "answers": self._answers(), "equations": [self._filled(one) for one in self.choices], "steps": self.steps,
        }  # fmt: skip

    def file(self) -> str:
        """The board's file, an SVG."""
        data = escape(json.dumps(self.data()), quote=False)
        head = '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="600mm" viewBox="0 0 300 600">'
        return f'{head}<metadata id="graphkin-board">{data}</metadata>{"".join(self.marks)}</svg>'

    def _answers(self) -> Json:
        answers: Json = {}
        for question, quantity in asked_of(self.method.mechanism).items():
            value = float(drawn_answer(self.method, self.plot, quantity, arrows_of(self.method)).value.real)
            edge, sense = EDGE[quantity.unit], ""
            if isinstance(quantity, Rotation) and quantity.word != "theta":
                sense, value = "clockwise" if value < 0 else "counter-clockwise", abs(value)
            answers[question] = {"value": f"{value * edge.factor:.4g}", "unit": edge.name, "sense": sense}
        return answers

    def _filled(self, one: EquationChoices) -> Json:
        terms = []
        for term in one.terms:
            own = self.choices_of.get((one.plane, one.number, term.name), (term.directions[0], term.magnitudes[0]))
            terms.append({"term": term.name, "direction": own[0], "magnitude": own[1]})
        return {"plane": one.plane, "equation": one.number, "terms": terms}

    # --- the drawing ----------------------------------------------------------------------------

    def _draw(self, polygon: Construction, pole: complex) -> None:
        plane, points = polygon.plane, self.plot.points(polygon.plane)
        scale = self.scales[plane] = max(abs(place(at)) for at in points.values()) / 100
        at = {name: place(point) / scale for name, point in points.items()}

        def mark(name: str) -> None:
            self._step(plane, "point", [at[name]], name=name)
            there = pole + at[name].conjugate()
            self.marks.append(f'<circle class="point" data-plane="{plane}" data-name="{name}" cx="{there.real:.4f}" '
                              f'cy="{there.imag:.4f}" r="0.8"/>')  # fmt: skip

        def arrow(name: str, tail: str, head: str) -> None:
            if abs(at[head] - at[tail]) < 0.05:
                return
            self._step(plane, "vector", [at[tail], at[head]], name=name, ends=[tail, head])
            start, end = (pole + at[each].conjugate() for each in (tail, head))
            self.marks.append(f'<line class="vector" data-plane="{plane}" data-name="{name}" data-tail="{tail}" '
                              f'data-head="{head}" x1="{start.real:.4f}" y1="{start.imag:.4f}" x2="{end.real:.4f}" '
                              f'y2="{end.imag:.4f}"/>')  # fmt: skip

        mark(polygon.pole)
        self.steps.clear() if not self.scales else self.steps.pop()  # the pole is there before the first step
        for step in polygon.steps:
            match step:
                case LayOff(term, start, tip, backwards):
                    arrow(term.name(plane), *((tip, start) if backwards else (start, tip)))
                    mark(tip)
                case Meet(Ray() as first, Ray() as second, point):
                    for ray in (first, second):
                        self._line(polygon, ray, point, at)
                    mark(point)
                case Image(point=point):
                    mark(point)
        for name, term in polygon.vectors().items():
            if term.size is None:
                arrow(name, self._other(term.head, term.tail), term.head)

    def _other(self, point: str, through: str) -> str:
        """The point through which a line to a point is drawn."""
        hand = self.hand if isinstance(self.hand, StudentHand) else StudentHand()
        return hand.through_others.get((point, through), through)

    def _line(self, polygon: Construction, ray: Ray, point: str, at: Mapping[str, complex]) -> None:
        """A line by set square, named after the direction that its equation gives it."""
        hand = self.hand if isinstance(self.hand, StudentHand) else StudentHand()
        through = self._other(point, ray.through)
        turned = hand.turned.get((point, ray.through), 1)
        way = place(self.right.direction(ray.direction)) * turned
        terms = (term for part in polygon.equations for term in part.left + part.right
                 if term.direction == ray.direction and term.size is None)  # fmt: skip
        name = next(terms).name(polygon.plane)
        tokens = [each.directions[0] for one in self.choices if one.plane == polygon.plane
                  for each in one.terms if each.name == name]  # fmt: skip
        tool, _, line = (tokens or ["parallel x"])[0].partition(" ")
        if turned != 1:
            tool = {"parallel": "perpendicular", "perpendicular": "parallel"}[tool]
        here = at[through]
        self._step(polygon.plane, tool, [here - 90 * way, here + 90 * way], through=through, line=line)

    def _step(self, plane: str, tool: str, places: list[complex], **words: object) -> None:
        at = [[round(each.real, 4), round(each.imag, 4)] for each in places]
        self.steps.append({"step": len(self.steps) + 1, "plane": plane, "tool": tool, "at": at, **words})
