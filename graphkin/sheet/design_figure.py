"""A designed linkage on paper: the construction in thin lines, the positions asked for, and the linkage found.

Each step of the construction is drawn by what it does; a line reaches as far as the points that lie on it, a circle is
whole, and its number is that of its stage, the numbered sentence of the solution.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction.drafting import (
    Bisector,
    Board,
    ChosenPoint,
    CircleAbout,
    CircleThrough,
    Drafting,
    DraftLayOff,
    DraftMeasure,
    DraftMeet,
    DraftTurn,
    Far,
    LineStep,
    MarkOn,
    MeasureAngle,
    Pricked,
    Reckon,
    Step,
    drawn_through,
)
from graphkin.sheet.curves import clipped
from graphkin.sheet.design_angles import DesignAngles
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import joined, point_label
from graphkin.sheet.marks import ArcMark, Disc, Stroke
from graphkin.sheet.paper import PenName
from graphkin.sheet.single_figure import SingleFigure
from graphkin.sheet.window import Entry, Figure
from graphkin.studies.design import Family, Solution

_BEYOND = 5.0
"""How far a construction line goes on past its points [mm]."""
_NEAR = 0.25
"""Points nearer than this on paper are one [mm]."""
_DOT = 0.45
_PENS: Mapping[str, PenName] = {"admissible": "thin", "FG": "dashed", "minor": "dashed"}
_PART = math.radians(14)
"""Half of a drawn arc of a compass."""


@frozen
class DesignFigure:
    """A solution on a page."""

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
        return self.board.places

    def figure(self) -> Figure:
        """Construction and positions; marks carry the number of their stage."""
        return Figure.of(self._entries())

    def _entries(self) -> Iterator[Entry]:
        for number_, stage in enumerate(self.construction.stages, start=1):
            for step in stage.steps:
                yield from self._drawn(step, number_)
        yield from self._positions()
        yield from self._points()
        yield from DesignAngles(self.solution, self.on, self.board).entries()

    # --- steps -----------------------------------------------------------------------------------

    def _drawn(self, step: Step, stage: int) -> Iterator[Entry]:
        if isinstance(step, LineStep):
            yield from self._ruled(step, stage)
            return
        match step:
            case DraftLayOff(point, about):
                yield from self._line([about, point], "construction", stage)
            case CircleThrough():
                yield from self._locus(stage) if step.name == "locus" else self._spanned(step, stage)
            case CircleAbout():
                yield from self._compass(step, stage)
            case DraftTurn(point, of, about):
                yield from self._turned(point, of, about, stage)
            case DraftMeasure(_, first, second):
                yield from self._line([first, second], "construction", stage)
            case ChosenPoint() | Pricked() | Far() | Reckon() | MarkOn() | DraftMeet() | MeasureAngle():
                pass
            case _:
                assert_never(step)

    def _line(self, names: list[str], pen: PenName, stage: int) -> Iterator[Entry]:
        places = [self.on.window(self.places[name]) for name in names]
        if abs(places[0] - places[-1]) > _NEAR:
            yield Stroke(tuple(places), pen, step=stage)

    def _ruled(self, step: LineStep, stage: int) -> Iterator[Entry]:
        """A line from the first to the last of the points that lie on it, and a little beyond."""
        start, along = self.board.line(step.name)
        size = self._size
        known = {*drawn_through(step), *(self.construction.met_on(step.name) or self._lying_on(step))}
        ways = [(along.conjugate() * (self.places[name] - start)).real for name in known]
        if isinstance(step, Bisector):
            half = abs(self.places[step.first] - self.places[step.second]) / 2
            middle = (along.conjugate() * (self.places[step.first] - start)).real
            ways += [middle, middle + 0.6 * half, middle - 0.6 * half]
        if not ways or max(ways) - min(ways) < 1e-9 * size:
            here = ways[0] if ways else 0.0
            ways = [here - 0.2 * size, here + 0.2 * size]
        reach = _BEYOND * self.on.window.scale
        ends = [self.on.window(start + along * way) for way in (min(ways) - reach, max(ways) + reach)]
        pen: PenName = "centre" if isinstance(step, Bisector) else "construction"
        yield from clipped(ends, self.on.room, pen, stage)

    def _lying_on(self, step: Step) -> list[str]:
        """Points chosen on a bisector."""
        if not isinstance(step, Bisector):
            return []
        start, along = self.board.line(step.name)
        placed = (one.name for one in self.construction.steps if isinstance(one, ChosenPoint))
        return [p for p in placed if abs((along.conjugate() * (self.places[p] - start)).imag) < 1e-6 * self._size]

    def _locus(self, stage: int) -> Iterator[Entry]:
        """The circle of crank centres: full where A may lie, dashed elsewhere; F and G end the arc between them."""
        centre, radius = self.board.circles["locus"]
        family = min(self.families, key=lambda one: abs(one.centre - centre))
        for arc in family.arcs:
            yield from self._swept(centre, radius, (arc.start, arc.end), _PENS[arc.name], stage)
        parted = [arc for arc in family.arcs if arc.name == "FG"]
        for turn in {end for arc in parted for end in (arc.start, arc.end)}:
            yield from self._parting(centre + cmath.rect(radius, turn), stage)

    def _parting(self, at: complex, stage: int) -> Iterator[Entry]:
        """F on the line C1D, or under C1; else G. Neither where it is a point of the linkage or of the construction."""
        first = self.places["C1"]
        way = self.places["D"] - first if "D" in self.places else 1j
        off = (way.conjugate() * (at - first)).imag / abs(way)
        place = self.on.window(at)
        taken = any(abs(self.on.window(z) - place) < _NEAR for z in self.places.values())
        if not taken and self.on.room.holds(place):
            yield Disc(place, _DOT, "thin", "ink", step=stage)
            letter = "F" if abs(off) < 1e-6 * abs(at - first) else "G"
            yield LabelRequest(point_label(letter), place, gap=0.9, step=stage, spare=True)

    def _spanned(self, step: CircleThrough, stage: int) -> Iterator[Entry]:
        """A circle through three points, from the first to the last and a little beyond."""
        centre, radius = self.board.circles[step.name]
        turns = sorted(cmath.phase(self.places[name] - centre) for name in step.points)
        gaps = [(turns[(k + 1) % 3] - turns[k]) % math.tau for k in range(3)]
        widest = max(range(3), key=lambda k: gaps[k])
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

    def _compass(self, step: CircleAbout, stage: int) -> Iterator[Entry]:
        """A short arc at each point found with it."""
        centre, radius = self.board.circles[step.name]
        for name in self.construction.met_on(step.name):
            turn = cmath.phase(self.places[name] - centre)
            part = min(_PART, 9.0 * self.on.window.scale / radius)
            yield from self._swept(centre, radius, (turn - part, turn + part), "thin", stage)

    def _turned(self, point: str, of: str, about: str, stage: int) -> Iterator[Entry]:
        centre, old, new = (self.on.window(self.places[name]) for name in (about, of, point))
        start = cmath.phase(old - centre)
        sweep = cmath.phase((new - centre) / (old - centre))
        yield ArcMark(centre, abs(old - centre), start, sweep, "dashed", step=stage)
        yield Stroke((centre, new), "construction", step=stage)

    # --- positions, points -------------------------------------------------------------------------

    @property
    def _size(self) -> float:
        places = list(self.places.values())
        return max(abs(p - q) for p in places for q in places)

    @property
    def _last(self) -> int:
        return len(self.construction.stages)

    def _positions(self) -> Iterator[Entry]:
        """The linkage at its limits, or at the positions asked for, in thin lines."""
        order = "ABCD" if "D" in self.solution.limits[0] else "ABC"
        for places in self.solution.limits:
            bars = tuple(self.on.window(places[name]) for name in order)
            yield Stroke(bars, "thin", step=self._last)
            for name in order[1:-1] if order == "ABCD" else order[1:]:
                yield Disc(self.on.window(places[name]), 0.8, "thin", "paper", step=self._last)

    def _points(self) -> Iterator[Entry]:
        """Points of the construction with their letters; those of the linkage itself are lettered with it."""
        for name in (name for name in self.places if name in self.solution.places):
            at = self.on.window(self.places[name])
            yield Disc(at, _DOT, "thin", "ink", step=self.construction.born(name))
        shown = {name: self.on.window(z) for name, z in self._lettered().items()}
        hinges = [self.on.window(z) for places in self.solution.limits for z in places.values()]
        used: list[complex] = [self.on.window(z) for z in self.solution.places.values()]
        for name, at in shown.items():
            if any(abs(at - other) < _NEAR for other in used) or not self.on.room.holds(at):
                continue
            used.append(at)
            same = [other for other, z in shown.items() if abs(z - at) < _NEAR]
            if all(abs(at - other) > _NEAR for other in hinges):
                yield Disc(at, _DOT, "thin", "ink", step=self.construction.born(name))
            yield LabelRequest(
                joined([point_label(one) for one in same]), at, gap=0.9, step=self.construction.born(name)
            )

    def also(self, name: str) -> list[str]:
        """Points of the construction where a point of the linkage lies: B is at B3."""
        at = self.solution.places.get(name)
        if at is None:
            return []
        return [other for other, z in self._lettered().items() if abs(z - at) < _NEAR * self.on.window.scale]

    def _lettered(self) -> Mapping[str, complex]:
        """The construction's points, and B and C of the positions where it has none."""
        found = {name: z for name, z in self.places.items() if name != "X"}
        for k, places in enumerate(self.solution.limits, start=1):
            for name in self._moving:
                if f"{name}1" not in self.places:
                    found[f"{name}{k}"] = places[name]
        return {name: z for name, z in found.items() if name not in self.solution.places}

    @property
    def _moving(self) -> list[str]:
        """B and C, where they are not pivots."""
        first = self.solution.limits[0]
        return [name for name in "BC" if name in first and any(p[name] != first[name] for p in self.solution.limits)]
