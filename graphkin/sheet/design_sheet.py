"""The sheet of a design: the construction at true scale, its limit positions, and the linkage that was found.

A step is a numbered sentence that draws something; the linkage comes last.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import chain, pairwise
from typing import assert_never

from graphkin import planning
from graphkin.base import geometry
from graphkin.base.lines import arc_places
from graphkin.base.rooms import enlarged
from graphkin.base.value import frozen
from graphkin.construction import Plot, drafting
from graphkin.construction.drafting import Bisector, CircleThrough, LineStep, Step
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.proof.roads import proved
from graphkin.say.catalogue import say
from graphkin.say.design import error, judgement, mechanism_of, sentences, swing_letter
from graphkin.say.numbers import circled
from graphkin.sheet import symbols
from graphkin.sheet.drafting_figure import NEAR, DraftingFigure, angle, spot
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, plain, point_label, quantity_label, valued
from graphkin.sheet.linkage_sheet import found_sizes
from graphkin.sheet.marks import ArcMark, Disc, Stroke
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import PenName
from graphkin.sheet.path_figure import clipped
from graphkin.sheet.single_figure import SingleFigure, place_for
from graphkin.sheet.titleblock import Strip
from graphkin.sheet.window import Entry, Figure
from graphkin.studies.design import Design, Family, Solution, linkage_of
from graphkin.studies.linkages import report

_MOST = 3.0  # so many times larger than the linkage the figure may become, for centres and circles


def design_sheet(design: Design, *, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """Draw the best solution of a design that has one. Raises NoDesign, UnknownPaper."""
    chosen = design.best
    if chosen is None:
        raise error(design) or AssertionError("a design without a best solution has none")
    method = planning.plan(mechanism_of(chosen, design.kind))
    plot, last = proved(method).plot, len(chosen.construction.stages) + 1
    told = [f"{circled(k)} {text}" for k, text in enumerate(sentences(chosen.construction, chosen.board(), lang), 1)]
    on = _page(chosen, method, plot, paper, [*told, *judgement(chosen, lang)])
    drafting = DraftingFigure(chosen.construction, chosen.board(), on.window, on.room)
    figure, machine = DesignFigure(chosen, drafting, design.families).figure(), on.mechanism(plot).numbered(last)
    named = {want.label for want in figure.wanted}  # pivots are lettered from the start; the end of a bar not at all
    named |= {point_label(name) for name in method.mechanism.points if name not in "ABCD"}
    machine.wanted = [want for want in machine.wanted if want.label not in named]
    return on.sheet(plot, say("design.sheet heading", lang), figure + machine, lang)


def _page(one: Solution, method: Method, plot: Plot, paper: str | None, told: Sequence[str]) -> SingleFigure:
    """Room for the linkage at all positions, the construction's points, and its circle if that is not too large."""
    board = one.board()
    values = shown_places(method, plot) + [place for places in one.limits for place in places.values()]
    values = enlarged(values, map(geometry.place, board.places.values()), _MOST)
    if "locus" in board.circles:
        centre, radius = geometry.place(board.circles["locus"][0]), geometry.number(board.circles["locus"][1])
        values = enlarged(values, [centre + radius * side for side in (1, 1j, -1, -1j)], _MOST)
    sizes = found_sizes(report(linkage_of(one)), swing=swing_letter(one))
    return place_for(method, [plot], values, paper, Strip([sizes], told))


_DOT = 0.45
_PENS: Mapping[str, PenName] = {"admissible": "thin", "FG": "dashed", "minor": "dashed"}
_GREEK = {"phi": "φ", "psi": "ψ"}
_PART = math.radians(14)  # half of a drawn arc of a compass
_ARC, _LONG = 13.0, 6.6  # radius of the arcs that show angles; the least length of the sides of a square [mm]


@frozen
class DesignFigure:
    """A solution on a page; the number of each thing is that of its stage, the numbered sentence of the solution."""

    solution: Solution
    on: DraftingFigure
    families: tuple[Family, ...] = ()

    @cached_property
    def places(self) -> Mapping[str, complex]:
        """The construction's points [m]."""
        return {name: geometry.place(value) for name, value in self.on.board.places.items()}

    def _circle(self, name: str) -> tuple[complex, float]:
        centre, radius = self.on.board.circles[name]
        return geometry.place(centre), geometry.number(radius)

    def figure(self) -> Figure:
        """Construction, positions and angles; marks carry the number of their stage."""
        drawn = self.on.stages(self._step)
        return Figure.of(chain(drawn, self._positions(), self._points(), self._angles()))

    def _step(self, step: Step, stage: int) -> Iterator[Entry]:
        if isinstance(step, LineStep):
            strokes = [*self.on.line(step, stage, "centre" if isinstance(step, Bisector) else "construction")]
            yield from strokes
            if strokes and step.name in ("m", "n"):  # the limits Cm and Cn of a bar
                far = max(strokes[0].places, key=lambda at: abs(at - self.on.window(self.places["C"])))
                yield LabelRequest(plain(step.name, italic=True), far, gap=0.6, step=stage)
            return
        match step:
            case drafting.DraftLayOff(end, start) | drafting.DraftMeasure(_, start, end):
                one, other = self.on.at(start, end)
                if abs(one - other) > NEAR:
                    yield Stroke((one, other), "construction", step=stage)
                if isinstance(step, drafting.DraftLayOff) and step.angle[:-1] in _GREEK:
                    yield from self._laid_off(step.angle, one, stage)
            case CircleThrough():
                yield from self._locus(stage) if step.name == "locus" else self._spanned(step, stage)
            case drafting.CircleAbout(name):
                centre_of, radius = self._circle(name)
                part = min(_PART, 9.0 * self.on.window.scale / radius)
                for met in self.on.construction.met_on(name):  # a short arc at each point that is constructed with it
                    turn = cmath.phase(self.places[met] - centre_of)
                    yield from self._swept(centre_of, radius, (turn - part, turn + part), "thin", stage)
            case drafting.DraftTurn(point, of, about):
                centre, old, new = self.on.at(about, of, point)
                start_angle, sweep = cmath.phase(old - centre), cmath.phase((new - centre) / (old - centre))
                yield ArcMark(centre, abs(old - centre), start_angle, sweep, "dashed", step=stage)
                yield Stroke((centre, new), "construction", step=stage)
            case drafting.ChosenPoint() | drafting.Pricked() | drafting.Far() | drafting.Reckon() | drafting.MarkOn():
                pass
            case drafting.DraftMeet() | drafting.MeasureAngle():
                pass
            case _:
                assert_never(step)

    def _laid_off(self, name: str, at: complex, stage: int) -> Iterator[Entry]:
        """A given angle, `phi1`, at its pivot, from the direction of the frame."""
        value, radius = geometry.number(self.on.board.numbers[name]), 5.0 + 6.0 * int(name[3:])
        yield Stroke((at, at + radius + 3), "construction", step=stage)
        label = valued(quantity_label(_GREEK[name[:3]], name[3:]), math.degrees(value), "°", 5)
        yield from angle(at, 1 + 0j, -value, radius, label, stage)

    def _locus(self, stage: int) -> Iterator[Entry]:
        """The circle of crank centres: full where A may lie, else dashed; F and G, on C1D and C2D or below."""
        centre, radius = self._circle("locus")
        family = min(self.families, key=lambda one: abs(one.centre - centre))
        for arc in family.arcs:
            yield from self._swept(centre, radius, (arc.start, arc.end), _PENS[arc.name], stage)
        for turn in {end for arc in family.arcs if arc.name == "FG" for end in (arc.start, arc.end)}:
            at, first = centre + cmath.rect(radius, turn), self.places["C1"]
            place = self.on.window(at)
            along = self.places["D"] - first if "D" in self.places else 1j
            off = (along.conjugate() * (at - first)).imag / abs(along)
            if self.on.room.holds(place):
                letter = "F" if abs(off) < 1e-6 * abs(at - first) else "G"  # F on the line C1D, or under C1
                (start,) = self.on.at("D" if "D" in self.places else f"C{'FG'.index(letter) + 1}")
                yield Stroke((start, place), "construction", step=stage)
                yield from spot(place, point_label(letter), _DOT, step=stage)

    def _spanned(self, step: CircleThrough, stage: int) -> Iterator[Entry]:
        """A circle through three points, from the first to the last and a little beyond."""
        centre, radius = self._circle(step.name)
        turns = sorted(cmath.phase(self.places[name] - centre) for name in step.points)
        gap, start = max(((after - turn) % math.tau, after) for turn, after in pairwise((*turns, turns[0])))
        ends = start - _PART, start + math.tau - gap + _PART
        yield from self._swept(centre, radius, ends, "thin", stage)

    def _swept(
        self, centre: complex, radius: float, ends: tuple[float, float], pen: PenName, stage: int
    ) -> Iterator[Entry]:
        """An arc as a polyline, as far as the paper goes."""
        places = arc_places(self.on.window(centre), radius / self.on.window.scale, -ends[0], -ends[1])
        yield from clipped(places, self.on.room, pen, stage)

    def _positions(self) -> Iterator[Entry]:
        """The linkage at its limits, or at the positions asked for, in thin lines."""
        order, last = "ABCD" if "D" in self.solution.limits[0] else "ABC", len(self.on.construction.stages)
        for places in self.solution.limits:
            yield Stroke(tuple(self.on.window(places[name]) for name in order), "thin", step=last)
            yield from (Disc(self.on.window(places[name]), 0.8, "thin", "paper", step=last) for name in "BC")

    def _points(self) -> Iterator[Entry]:
        """The construction's points with their letters; and B and C of the positions, where it has none for them."""
        limits, points = self.solution.limits, {name: z for name, z in self.places.items() if name != "X"}
        moving = [n for n in "BC" if n in limits[0] and any(places[n] != limits[0][n] for places in limits)]
        for k, places in enumerate(limits, start=1):
            points |= {f"{name}{k}": places[name] for name in moving if f"{name}1" not in self.places}
        hinges = [self.on.window(places[name]) for places in limits for name in "BC"]
        for name, at in ((name, self.on.window(z)) for name, z in points.items()):
            if self.on.room.holds(at):
                dot, *letters = spot(at, point_label(name), _DOT, step=self.on.construction.born(name))
                yield from letters if any(abs(at - other) < NEAR for other in hinges) else (dot, *letters)

    def _angles(self) -> Iterator[Entry]:
        """theta at A, and the swing at D (at C for a guide bar), with their values, and the right angles for them."""
        one, last = self.solution, len(self.on.construction.stages)
        if one.theta is None or len(one.limits) != 2 or "theta" not in self.on.board.numbers:
            return
        if one.shape == "guide-bar":
            both = valued(tuple(Run(c, c.isalpha()) for c in "ψ = θ"), math.degrees(one.theta), "°", 5)
            yield from self._angle("C", "B1", "B2", both, 2)
            for pin in ("B1", "B2"):
                yield from self._right_angle(pin, "A", "C", last)
            return
        yield from self._angle("A", "C1", "C2", valued(plain("θ", True), math.degrees(one.theta), "°", 5), last)
        if {"C1", "C2", "P"} <= self.places.keys() and (
            square := self._right_angle("C2", "C1", "P", self.on.construction.born("P"))
        ):
            yield from square
            yield from self._angle("C1", "C2", "P", (*plain("90° − "), Run("θ", True)), self.on.construction.born("P"))
        if one.swing is not None and "D" in self.places:
            yield from self._angle("D", "C1", "C2", valued(plain("ψ", True), math.degrees(one.swing), "°", 5), 2)
        if one.stroke is not None:
            label = valued(plain("H", True), 1e3 * one.stroke, " mm", 5)
            one_end, other = self.on.at("C1", "C2")
            yield LabelRequest(label, one_end, other, gap=3.4, step=2, spare=True)

    def _right_angle(self, corner: str, one: str, other: str, stage: int) -> list[Stroke]:
        """A square in a corner; nothing where the angle is another, or the sides are short."""
        at, first, second = self.on.at(corner, one, other)
        long = min(abs(first - at), abs(second - at)) > _LONG
        return symbols.right_angle(at, first - at, second - at, step=stage) if long else []

    def _angle(self, centre: str, first: str, second: str, label: Label, stage: int) -> Iterator[Entry]:
        """An arc between the directions of two points from a third."""
        at, one, other = self.on.at(centre, first, second)
        radius = min(_ARC, 0.6 * min(abs(one - at), abs(other - at)))
        return angle(at, one - at, cmath.phase((other - at) / (one - at)), radius, label, stage)
