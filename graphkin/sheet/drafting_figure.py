"""Constructions with ruler and compass on paper: lines as far as their points, stages with their numbers; angles.

Points at one place share a label.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from graphkin.base import geometry
from graphkin.base.boxes import free_about
from graphkin.base.rooms import Room
from graphkin.base.value import frozen
from graphkin.construction import drafting
from graphkin.construction.drafting import Bisector, Board, Drafting, LineStep, Step, drawn_through
from graphkin.say.numbers import circled
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, Label, joined, plain, width
from graphkin.sheet.marks import ArcMark, Disc, Fill, Place, Stroke
from graphkin.sheet.paper import PenName
from graphkin.sheet.path_figure import clipped
from graphkin.sheet.symbols import HINGE, angle_arc, arrow_head
from graphkin.sheet.window import Entry, Window

NEAR = 0.25  # points nearer than this on paper are one [mm]
_STRAIGHT = 8.0  # a shorter piece of a curve is named as a point of it [mm]
_SHARES, _APART = (0.3, 0.7, 0.5, 0.2, 0.8, 0.05, 0.95), 3.0  # where names stand; what is left beside them [mm]
_FAR = 4  # a line that meets others at infinity, or has no two points on it, goes on so many times farther


@frozen
class DraftingFigure:
    """A construction through a window, in a room of the paper; beyond: how far a line goes on past its points [mm]."""

    construction: Drafting
    board: Board
    window: Window
    room: Room
    beyond: float = 5.0

    def at(self, *names: str) -> list[Place]:
        """Points on the paper or beyond its edge; none for those at infinity."""
        places = (geometry.place(self.board.at(name)) for name in names)
        return [self.window(place) for place in places if cmath.isfinite(place)]

    def stages(self, draw: Callable[[Step, int], Iterator[Entry]]) -> Iterator[Entry]:
        """Everything that the steps of each stage draw, and its number at its longest line, the first of equals."""
        for number, stage in enumerate(self.construction.stages, start=1):
            entries = [entry for step in stage.steps for entry in draw(step, number)]
            yield from entries
            if strokes := [entry for entry in entries if isinstance(entry, Stroke)]:
                longest = max(strokes, key=lambda stroke: round(abs(stroke.places[-1] - stroke.places[0]), 3)).places
                start, end = longest[len(longest) // 2 - 1 :][:2]
                yield LabelRequest(plain(circled(number)), start, end, gap=0.5, size=LABEL, step=number)

    def line(self, step: LineStep, number: int, pen: PenName = "construction") -> Iterator[Stroke]:
        """A line as far as the paper goes."""
        yield from clipped(self.ends(step), self.room, pen, number)

    def ends(self, step: LineStep, also: Sequence[Place] = ()) -> list[Place]:
        """The ends of a line, beyond the first and the last place on it; none of the line at infinity."""
        foot, direction = map(geometry.place, self.board.line(step.name))
        if not abs(foot) * drafting.INFINITE < 1:
            return []
        start, along = self.window(foot), self.window.turned(direction)
        met = self.construction.met_on(step.name)
        places = [*self.at(*drawn_through(step), *met), *also]
        if isinstance(step, Bisector):
            one, other = self.at(step.first, step.second)
            steps = self.construction.steps
            chosen = self.at(*(made.name for made in steps if isinstance(made, drafting.ChosenPoint)))
            places += [at for at in chosen if abs(((at - start) / along).imag) < NEAR]
            places += [(one + other) / 2 + side * abs(other - one) * along for side in (0.3, -0.3)]
        base = places[0] if places else start
        reach = [((place - base) / along).real for place in places] or [0.0]
        far = max(reach) - min(reach) < NEAR or len(self.at(*met)) < len(met)
        more = self.beyond * (_FAR if far else 1)
        return [base + along * (min(reach) - more), base + along * (max(reach) + more)]


def together(wanted: Iterable[LabelRequest]) -> Iterator[LabelRequest]:
    """Labels of points at one place as one label, each once, whose parts come with steps of their own."""
    groups: list[list[LabelRequest]] = []
    for want in wanted:
        same = (group for group in groups if _at_one_place(group[0], want))
        if (group := next(same, None)) is None:
            groups.append([want])
        elif all(each.label != want.label for each in group):
            group.append(want)
    for first, *others in (sorted(group, key=lambda want: want.step or 0) for group in groups):
        if not others:
            yield first
            continue
        parts = ((first.label, first.step), *((joined([(), other.label]), other.step) for other in others))
        label, gap = tuple(run for part, _ in parts for run in part), max(each.gap for each in (first, *others))
        yield replace(first, label=label, gap=gap, parts=parts if len({step for _, step in parts}) > 1 else ())


def _at_one_place(one: LabelRequest, other: LabelRequest) -> bool:
    points = all(want.end is None and not want.parts and want.gap <= HINGE for want in (one, other))  # not of blocks
    return points and one.size == other.size and abs(one.start - other.start) < NEAR


def spot(at: Place, label: Label, radius: float = 0.6, fill: Fill = "ink", step: int | None = None) -> Iterator[Entry]:
    """A point with its letters."""
    yield Disc(at, radius, "vector", fill, step=step)
    yield LabelRequest(label, at, gap=radius + 0.3, step=step)


def pointer(start: Place, at: Place, room: Room, label: Label, step: int | None = None) -> Iterator[Entry]:
    """An arrow from a place on the paper towards one beyond its edge, with the name of that."""
    along = (at - start) / abs(at - start)
    for ray in clipped([start, at], room, "construction", step):
        yield from (ray, arrow_head(ray.places[-1], along, step))
        yield LabelRequest(label, ray.places[-1], gap=1.0, away=along, step=step)


def angle(
    at: Place, first: complex, sweep: float, radius: float, label: Label, step: int | None = None, heads: bool = True
) -> Iterator[Entry]:
    """An arc from a direction on [rad, clockwise on paper] with its value; nothing for no angle."""
    if abs(sweep) > 1e-6:
        first /= abs(first)
        middle = first * cmath.rect(1, sweep / 2)
        bare = ArcMark(at, radius, cmath.phase(first), sweep, "thin", step)
        yield from angle_arc(at, radius, first, sweep, step) if heads else [bare]
        yield LabelRequest(label, at + radius * middle, gap=0.6, away=middle, size=LABEL, step=step)


def named(strokes: Sequence[Stroke], label: Label, others: Sequence[Stroke] = ()) -> Iterator[LabelRequest]:
    """The name of a curve, beside the longest of its pieces where other curves are farther than it is long; else where
    any piece is farthest from them."""
    lines = [ends for stroke in others for ends in pairwise(stroke.places)]
    pieces = list[np.ndarray]()
    for places in sorted((np.array(stroke.places) for stroke in strokes), key=lambda each: -abs(np.diff(each)).sum()):
        passed = abs(np.diff(places)).cumsum()
        pieces += [places[k:][:2] for k in np.searchsorted(passed, np.array(_SHARES) * passed[-1])]
    if pieces:
        free = free_about([start for start, _ in pieces], lines, width(label, LABEL) + _APART)
        start, end = map(complex, pieces[int(free.argmax())])
        yield LabelRequest(label, start, end if abs(end - start) > _STRAIGHT else None, gap=0.8)
