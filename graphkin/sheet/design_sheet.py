"""The sheet of a design: the construction at true scale, its limit positions, and the linkage that was found.

A step is a numbered sentence that draws something; the linkage comes last.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import chain
from typing import assert_never

from graphkin import planning
from graphkin.base import geometry
from graphkin.base.value import frozen
from graphkin.construction import Plot, drafting
from graphkin.construction.drafting import Bisector, Board, ChosenPoint, Drafting, LineStep, Stage, Step
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.proof.roads import proved
from graphkin.say.design import error, mechanism_of, sentences
from graphkin.say.numbers import circled
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, Label, Run, joined, number, plain, point_label, quantity_label
from graphkin.sheet.marks import ArcMark, Disc, Place, Stroke
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import PenName
from graphkin.sheet.path_figure import clipped
from graphkin.sheet.single_figure import SingleFigure, place_for, stage_number
from graphkin.sheet.titleblock import Table
from graphkin.sheet.window import Entry, Figure, enlarged
from graphkin.studies.design import Design, Family, Solution

_MOST = 3.0  # so many times larger than the linkage the figure may become, for centres and circles
_HEADING: dict[Lang, str] = {"en": "Design by construction", "zh": "图解设计"}


def design_sheet(design: Design, *, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """Draw the best solution of a design that has one. Raises NoDesign, UnknownPaper."""
    chosen = design.best
    if chosen is None:
        raise error(design) or AssertionError("a design without a best solution has none")
    method = planning.plan(mechanism_of(chosen, design.kind))
    plot, last = proved(method).plot, len(chosen.construction.stages) + 1
    told = [f"{circled(k)} {text}" for k, text in enumerate(sentences(chosen.construction, chosen.board(), lang), 1)]
    on = _page(chosen, method, plot, paper, told)
    construction, machine = DesignFigure(chosen, on, design.families), on.mechanism(plot).numbered(last)
    for k, want in enumerate(machine.wanted):  # with the construction's letters for that place; pivots from the start
        name = next((name for name in "ABCD" if want.label == point_label(name)), "")
        if name in construction.places:
            machine.wanted[k] = replace(want, step=chosen.construction.born(name))
        elif name and (also := construction.also(name)):
            machine.wanted[k] = replace(want, label=joined([want.label, *map(point_label, also)]))
    return on.sheet(plot, _HEADING[lang], construction.figure() + machine, lang)


def _page(one: Solution, method: Method, plot: Plot, paper: str | None, told: Sequence[str]) -> SingleFigure:
    """Room for the linkage at all positions, the construction's points, and its circle if that is not too large."""
    board = one.board()
    values = shown_places(method, plot) + [place for places in one.limits for place in places.values()]
    values = enlarged(values, map(geometry.place, board.places.values()), _MOST)
    if "locus" in board.circles:
        centre, radius = geometry.place(board.circles["locus"][0]), geometry.number(board.circles["locus"][1])
        sides = [centre + radius * side for side in (1, 1j, -1, -1j)]
        wider = enlarged(values, sides, _MOST)
        values = wider if all(place in wider for place in sides) else values
    return place_for(method, [plot], values, paper, [_sizes(one)], told)


def _sizes(one: Solution) -> Table:
    """The linkage's lengths, and its least transmission angle."""
    named = {"AB": one.a, "BC": one.b, "CD": one.c, ("AC" if one.shape == "guide-bar" else "AD"): one.d}
    sizes = [(quantity_label("l", name), (*number(1e3 * size, 5), *plain(" mm")))
             for name, size in named.items() if size is not None]  # fmt: skip
    if one.shape == "slider-crank" and one.e is not None:
        sizes.append((plain("e", italic=True), (*number(1e3 * one.e, 5), *plain(" mm"))))
    if one.gamma_min is not None:
        least = (*number(math.degrees(one.gamma_min), 5), *plain("°"))
        sizes.append(((Run("γ", True), Run("min", False, "sub")), least))
    names, values = zip(*sizes, strict=True)
    return Table(names, (values,))


# --- the figure -------------------------------------------------------------------------------------------------------


_BEYOND = 5.0  # how far a construction line goes on past its points [mm]
_NEAR = 0.25  # points nearer than this on paper are one [mm]
_DOT = 0.45
_PENS: Mapping[str, PenName] = {"admissible": "thin", "FG": "dashed", "minor": "dashed"}
_PART = math.radians(14)  # half of a drawn arc of a compass
_SQUARE = 2.2  # side of the square in a right angle [mm]
_ARC = 13.0  # radius of the arcs that show angles [mm]


@frozen
class DesignFigure:
    """A solution on a page.

    A line reaches as far as the points that lie on it, a circle is whole; the number of each is that of its stage, the
    numbered sentence of the solution.
    """

    solution: Solution
    on: SingleFigure
    families: tuple[Family, ...] = ()

    @property
    def construction(self) -> Drafting:
        return self.solution.construction

    @cached_property
    def board(self) -> Board:
        return self.solution.board()

    @cached_property
    def places(self) -> Mapping[str, complex]:
        """The construction's points [m]."""
        return {name: geometry.place(value) for name, value in self.board.places.items()}

    def _at(self, name: str) -> Place:
        return self.on.window(self.places[name])

    def _circle(self, name: str) -> tuple[complex, float]:
        centre, radius = self.board.circles[name]
        return geometry.place(centre), geometry.number(radius)

    def figure(self) -> Figure:
        """Construction, positions and angles; marks carry the number of their stage."""
        stages = enumerate(self.construction.stages, start=1)
        drawn = (self._stage(stage, number) for number, stage in stages)
        return Figure.of(chain(*drawn, self._positions(), self._points(), self._angles()))

    def _stage(self, stage: Stage, number: int) -> Iterator[Entry]:
        """The steps of a stage, and its number at the longest of its lines."""
        entries = [entry for step in stage.steps for entry in self._step(step, number)]
        yield from entries
        if strokes := [entry for entry in entries if isinstance(entry, Stroke)]:
            yield stage_number(max(strokes, key=lambda stroke: abs(stroke.places[-1] - stroke.places[0])), number)

    def _step(self, step: Step, stage: int) -> Iterator[Entry]:
        if isinstance(step, LineStep):
            yield from self._ruled(step, stage)
            return
        match step:
            case drafting.DraftLayOff(end, start) | drafting.DraftMeasure(_, start, end):
                places = self._at(start), self._at(end)
                if abs(places[0] - places[1]) > _NEAR:
                    yield Stroke(places, "construction", step=stage)
            case drafting.CircleThrough():
                yield from self._locus(stage) if step.name == "locus" else self._spanned(step, stage)
            case drafting.CircleAbout(name):
                centre_of, radius = self._circle(name)
                part = min(_PART, 9.0 * self.on.window.scale / radius)
                for met in self.construction.met_on(name):  # a short arc at each point that is constructed with it
                    turn = cmath.phase(self.places[met] - centre_of)
                    yield from self._swept(centre_of, radius, (turn - part, turn + part), "thin", stage)
            case drafting.DraftTurn(point, of, about):
                centre, old, new = (self._at(name) for name in (about, of, point))
                start_angle, sweep = cmath.phase(old - centre), cmath.phase((new - centre) / (old - centre))
                yield ArcMark(centre, abs(old - centre), start_angle, sweep, "dashed", step=stage)
                yield Stroke((centre, new), "construction", step=stage)
            case ChosenPoint() | drafting.Pricked() | drafting.Far() | drafting.Reckon() | drafting.MarkOn():
                pass
            case drafting.DraftMeet() | drafting.MeasureAngle():
                pass
            case _:
                assert_never(step)

    def _ruled(self, step: LineStep, stage: int) -> Iterator[Entry]:
        """A line from the first to the last of the points that lie on it, and a little beyond."""
        places = self.places
        start, along = map(geometry.place, self.board.line(step.name))
        size = max(abs(p - q) for p in places.values() for q in places.values())
        lying: list[str] = self.construction.met_on(step.name)
        if not lying and isinstance(step, Bisector):  # points chosen on it
            chosen = (one.name for one in self.construction.steps if isinstance(one, ChosenPoint))
            lying = [p for p in chosen if abs((along.conjugate() * (places[p] - start)).imag) < 1e-6 * size]
        names = {*drafting.drawn_through(step), *lying}
        reach = [(along.conjugate() * (places[name] - start)).real for name in names]
        if isinstance(step, Bisector):
            half = abs(places[step.first] - places[step.second]) / 2
            middle = (along.conjugate() * (places[step.first] - start)).real
            reach += [middle, middle + 0.6 * half, middle - 0.6 * half]
        if not reach or max(reach) - min(reach) < 1e-9 * size:
            reach = [(reach or [0.0])[0] + side * 0.2 * size for side in (-1, 1)]
        more = _BEYOND * self.on.window.scale
        ends = [self.on.window(start + along * t) for t in (min(reach) - more, max(reach) + more)]
        pen: PenName = "centre" if isinstance(step, Bisector) else "construction"
        yield from clipped(ends, self.on.room, pen, stage)

    def _locus(self, stage: int) -> Iterator[Entry]:
        """The circle of crank centres: full where A may lie, dashed elsewhere; F and G end the arc between them."""
        centre, radius = self._circle("locus")
        family = min(self.families, key=lambda one: abs(one.centre - centre))
        for arc in family.arcs:
            yield from self._swept(centre, radius, (arc.start, arc.end), _PENS[arc.name], stage)
        for turn in {end for arc in family.arcs if arc.name == "FG" for end in (arc.start, arc.end)}:
            at, first = centre + cmath.rect(radius, turn), self.places["C1"]
            spot = self.on.window(at)
            along = self.places["D"] - first if "D" in self.places else 1j
            off = (along.conjugate() * (at - first)).imag / abs(along)
            if self.on.room.holds(spot) and all(abs(self._at(name) - spot) >= _NEAR for name in self.places):
                yield Disc(spot, _DOT, "thin", "ink", step=stage)
                letter = "F" if abs(off) < 1e-6 * abs(at - first) else "G"  # F on the line C1D, or under C1
                yield LabelRequest(point_label(letter), spot, gap=0.9, step=stage, spare=True)

    def _spanned(self, step: drafting.CircleThrough, stage: int) -> Iterator[Entry]:
        """A circle through three points, from the first to the last and a little beyond."""
        centre, radius = self._circle(step.name)
        turns = sorted(cmath.phase(self.places[name] - centre) for name in step.points)
        gaps = [(turns[(k + 1) % 3] - turns[k]) % math.tau for k in range(3)]
        widest = gaps.index(max(gaps))
        start = turns[(widest + 1) % 3]
        ends = start - _PART, start + math.tau - gaps[widest] + _PART
        yield from self._swept(centre, radius, ends, "thin", stage)

    def _swept(
        self, centre: complex, radius: float, ends: tuple[float, float], pen: PenName, stage: int
    ) -> Iterator[Entry]:
        """An arc as a polyline, as far as the paper goes."""
        count = max(24, math.ceil((ends[1] - ends[0]) * 60))
        turns = (ends[0] + (ends[1] - ends[0]) * k / count for k in range(count + 1))
        places = [self.on.window(centre + cmath.rect(radius, turn)) for turn in turns]
        yield from clipped(places, self.on.room, pen, stage)

    def _positions(self) -> Iterator[Entry]:
        """The linkage at its limits, or at the positions asked for, in thin lines."""
        order, last = "ABCD" if "D" in self.solution.limits[0] else "ABC", len(self.construction.stages)
        for places in self.solution.limits:
            yield Stroke(tuple(self.on.window(places[name]) for name in order), "thin", step=last)
            for name in "BC":
                yield Disc(self.on.window(places[name]), 0.8, "thin", "paper", step=last)

    def _points(self) -> Iterator[Entry]:
        """Points of the construction with their letters; those of the linkage itself are lettered with it."""
        for name in (name for name in self.places if name in self.solution.places):
            yield Disc(self._at(name), _DOT, "thin", "ink", step=self.construction.born(name))
        shown = {name: self.on.window(z) for name, z in self._lettered.items()}
        hinges = [self.on.window(z) for places in self.solution.limits for z in places.values()]
        used = [self.on.window(z) for z in self.solution.places.values()]
        for name, at in shown.items():
            if any(abs(at - other) < _NEAR for other in used) or not self.on.room.holds(at):
                continue
            used.append(at)
            same = [point_label(other) for other, z in shown.items() if abs(z - at) < _NEAR]
            if all(abs(at - other) > _NEAR for other in hinges):
                yield Disc(at, _DOT, "thin", "ink", step=self.construction.born(name))
            yield LabelRequest(joined(same), at, gap=0.9, step=self.construction.born(name))

    def also(self, name: str) -> list[str]:
        """Points of the construction where a point of the linkage lies: B is at B3."""
        at, near = self.solution.places.get(name), _NEAR * self.on.window.scale
        return [] if at is None else [other for other, z in self._lettered.items() if abs(z - at) < near]

    @cached_property
    def _lettered(self) -> Mapping[str, complex]:
        """The construction's points, and B and C of the positions, where they are no pivots, if it has none."""
        limits = self.solution.limits
        moving = [n for n in "BC" if n in limits[0] and any(places[n] != limits[0][n] for places in limits)]
        points = {name: z for name, z in self.places.items() if name != "X"}
        for k, places in enumerate(limits, start=1):
            points |= {f"{name}{k}": places[name] for name in moving if f"{name}1" not in self.places}
        return {name: z for name, z in points.items() if name not in self.solution.places}

    def _angles(self) -> Iterator[Entry]:
        """theta at A, and the swing at D (at C for a guide bar), with their values, and the right angles for them."""
        at, one = self.places, self.solution
        if one.theta is None or len(one.limits) != 2 or "theta" not in self.board.numbers:
            return
        if one.shape == "guide-bar":
            yield from self._angle("C", "B1", "B2", "ψ = θ", one.theta, 2)
            for pin in ("B1", "B2"):
                yield from self._right_angle(pin, "A", "C", "")
            return
        yield from self._angle("A", "C1", "C2", "θ", one.theta, len(one.construction.stages))
        if {"C1", "C2", "P"} <= at.keys() and (square := list(self._right_angle("C2", "C1", "P", "90°"))):
            yield from square
            first, second, third = map(self._at, ("C1", "C2", "P"))  # 90° − θ at C1 in the triangle on C1C2
            start, sweep = cmath.phase(second - first), cmath.phase((third - first) / (second - first))
            radius, stage = min(_ARC, 0.5 * abs(first - second)), self.construction.born("P")
            yield ArcMark(first, radius, start, sweep, "thin", step=stage)
            middle, text = cmath.rect(radius, start + sweep / 2), (*plain("90° − "), Run("θ", True))
            yield LabelRequest(text, first + middle, gap=0.6, away=middle, size=LABEL, step=stage, spare=True)
        if one.swing is not None and "D" in at:
            yield from self._angle("D", "C1", "C2", "ψ", one.swing, 2)
        if one.stroke is not None:
            label = _valued("H", 1e3 * one.stroke, " mm")
            yield LabelRequest(label, self._at("C1"), self._at("C2"), gap=3.4, step=2, spare=True)

    def _right_angle(self, corner: str, one: str, other: str, text: str) -> Iterator[Entry]:
        """A square in a corner, with a text; nothing where the angle is another, or the sides are short."""
        at = self._at(corner)
        a, b = self._at(one) - at, self._at(other) - at
        if abs((a.conjugate() * b).real) > 1e-6 * abs(a * b) or min(abs(a), abs(b)) < 3 * _SQUARE:
            return
        stage = max(self.construction.born(name) or 0 for name in (corner, one, other))
        a, b = a / abs(a) * _SQUARE, b / abs(b) * _SQUARE
        yield Stroke((at + a, at + a + b, at + b), "construction", step=stage)
        if text:
            yield LabelRequest(plain(text), at + a + b, gap=0.5, away=a + b, size=LABEL, step=stage, spare=True)

    def _angle(self, centre: str, first: str, second: str, letter: str, value: float, stage: int) -> Iterator[Entry]:
        """An arc between the directions of two points from a third, with its value."""
        at, one, other = map(self._at, (centre, first, second))
        radius = min(_ARC, 0.6 * min(abs(one - at), abs(other - at)))
        start, sweep = cmath.phase(one - at), cmath.phase((other - at) / (one - at))
        yield ArcMark(at, radius, start, sweep, "thin", step=stage)
        middle, label = at + cmath.rect(radius, start + sweep / 2), _valued(letter, math.degrees(value), "°")
        yield LabelRequest(label, middle, gap=0.8, away=middle - at, step=stage)


def _valued(letter: str, value: float, unit: str) -> Label:
    return (*(Run(c, c.isalpha()) for c in letter), Run(" = "), *number(value, 5), *plain(unit))
