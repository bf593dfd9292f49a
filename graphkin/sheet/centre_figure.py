"""The mechanism with its instant centres: Kennedy's lines, marks and names, arrows to centres that no mark shows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from graphkin.base.geometry import place
from graphkin.construction.drafting import Far
from graphkin.sheet.centre_places import SAME, CentreLine, Laid, OnPaper, Spot, centre_label, clipped, coordinates
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, joined, plain
from graphkin.sheet.marks import Disc, Mark, Place, PointMark, Stroke, VectorMark
from graphkin.sheet.mechanism_figure import bare_figure, mechanism_places
from graphkin.sheet.obstacles import obstacles
from graphkin.sheet.paper import PenName
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import BLOCK, HINGE
from graphkin.sheet.window import Figure, Window
from graphkin.studies.centres import Centres

_BEYOND = 4.0  # how far a line goes on past the centres on it [mm]
_NORMAL = 12.0  # how far a common normal goes on past the contact [mm]
_PARALLEL = 16.0  # how far lines to a centre at infinity go on [mm]
_SHORT = 0.8  # a shorter rest of a line already drawn is not drawn [mm]
INFINITY: Label = plain(" → ∞ ")  # the room after the sign is because it is wider than what letters count as
_ARROW, _EDGE_ARROW = 13.0, 8.0
"""An arrow to infinity, and one to a centre beyond the edge [mm]."""
_OFF = BLOCK.imag / 2 + 1.0  # from a block's middle to where its arrow starts [mm]
_APART = 5.0  # arrows in one direction start at least so far from one another [mm]
_Start = tuple[Place, complex]  # the start of an arrow, and its direction
_CIRCLE, _DOT = 1.0, 0.5
"""Radius of the circle and of the dot that mark a centre [mm]."""
_BETWEEN = ", "


def centre_lines(paper: OnPaper) -> Figure:
    """The lines of all steps, the later ones where no earlier one lies."""
    figure, drawn = Figure(), _DrawnStretches()
    for spot in paper.spots:
        for line in paper.lines(spot):
            if (laid := reach_of(paper, spot, line, line.normal)) is None:
                continue
            pen: PenName = "centre" if line.normal else "dashed"
            for piece in drawn.fresh(laid):
                figure.marks.append(Stroke(piece.ends, pen, step=spot.number))
            for end, other in (laid.ends, laid.ends[::-1]) if line.normal else ():
                normal = LabelRequest(plain("n", italic=True), end, gap=0.2, away=end - other, step=spot.number)
                figure.wanted.append(normal)
    return figure


def reach_of(paper: OnPaper, spot: Spot, line: CentreLine, normal: bool = False) -> Laid | None:
    """The stretch of a line that is drawn: past the centres on it, or to the room's edge towards those beyond."""
    if (span := clipped(line, paper.room)) is None:
        return None
    low, high = span
    beyond = _NORMAL if normal else _PARALLEL if spot.place is None else _BEYOND
    seen = [line.along(place) for place in line.stops if paper.room.holds(place)]
    outer = [line.along(place) for place in line.stops if not paper.room.holds(place)]
    ends = [*(max(low, t - beyond) for t in seen), *(min(high, t + beyond) for t in seen)]
    ends += [low if t < low else high for t in outer]
    return Laid(line, min(ends), max(ends)) if max(ends, default=0) - min(ends, default=0) > SAME else None


@dataclass
class _DrawnStretches:
    """Stretches that are drawn already."""

    pieces: list[Laid] = field(default_factory=list)

    def fresh(self, laid: Laid) -> list[Laid]:
        """The pieces of a stretch that are not yet drawn."""
        left = [(laid.start, laid.end)]
        for piece in self.pieces:
            one, other = laid.line, piece.line
            alike = abs((one.direction * other.direction.conjugate()).imag) <= 2e-4
            if alike and abs(((other.at - one.at) * one.direction.conjugate()).imag) < 2 * SAME:
                first, second = sorted(laid.line.along(end) for end in piece.ends)
                halves = (half for start, end in left for half in ((start, min(end, first)), (max(start, second), end)))
                left = [(start, end) for start, end in halves if start < end]
        fresh = [Laid(laid.line, *part) for part in left if part[1] - part[0] > _SHORT]
        self.pieces += fresh
        return fresh


def centre_arrows(paper: OnPaper, drawn: Sequence[Mark]) -> Figure:
    """One arrow for each centre that is not marked, with its name; off the sheet also with its coordinates."""
    figure = Figure()
    for spot in paper.spots:
        if paper.shown(spot):
            continue
        taken = [mark for mark in figure.marks if isinstance(mark, VectorMark)]
        length = _ARROW if spot.place is None else _EDGE_ARROW
        start, along = _free(_places(paper, spot), length, taken, drawn, paper)
        head, where = "∞", INFINITY
        if spot.place is not None:
            head, where = spot.name, (Run(" "), *coordinates(paper.found, spot.place), Run(" mm"))
        arrow = VectorMark("centres", spot.name, "", head, start, start + length * along, spot.number)
        figure.marks.append(arrow)
        label = (*centre_label(spot.name), *where)
        figure.wanted.append(LabelRequest(label, arrow.end, gap=0.7, away=along, step=spot.number))
    return figure


# --- where an arrow stands --------------------------------------------------------------------


def _places(paper: OnPaper, spot: Spot) -> Iterator[_Start]:
    """Starts of the arrow of a centre: on both sides of its slide's block, at the end of a line, at last anywhere."""
    if isinstance(spot.stage.last, Far):
        name = spot.stage.last.line
        slide = next(slide for slide in paper.found.method.mechanism.slides if slide.name == name)
        at, normal = paper.window(place(paper.found.plot.position[slide.point])), paper.window.turned(spot.direction)
        for off in (_OFF, _OFF + 6, _OFF + 14):
            yield from ((at + off * side, side) for side in (normal, -normal))
    for line in paper.lines(spot):
        if (laid := reach_of(paper, spot, line)) is not None:
            for end, along in ((laid.ends[1], line.direction), (laid.ends[0], -line.direction)):
                if spot.place is None:
                    yield end - 2 * along, along
                elif ((paper.at(spot) - end) * along.conjugate()).real > 0:  # that end leads to the centre
                    for back in (0.0, _EDGE_ARROW + 4, 2 * _EDGE_ARROW + 8):
                        start = end - (_EDGE_ARROW + 0.5 + back) * along
                        yield start, _towards(paper.at(spot), start)
    spread = 0.35 * paper.room.size  # from about the middle of the figure to its edge
    for x, y in ((0, 0), (1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, -1), (1, -1), (-1, 1)):
        foot = paper.room.middle + complex(x * spread.real, y * spread.imag)
        along = paper.window.turned(spot.direction) if spot.place is None else _towards(paper.at(spot), foot)
        if (span := clipped(CentreLine(foot, along, ()), paper.room)) is not None:
            yield foot + along * (span[1] - _ARROW - 1), along


def _towards(place: Place, start: Place) -> complex:
    return (place - start) / abs(place - start)


def _free(
    stands: Iterator[_Start], length: float, taken: Sequence[VectorMark], drawn: Sequence[Mark], paper: OnPaper
) -> _Start:
    """The place that touches the fewest things; the first of equals."""
    tried = [(start, along, start + length * along) for start, along in stands]
    low = np.array([(start.real, start.imag) for start, _, _ in tried])
    high = np.array([(end.real, end.imag) for _, _, end in tried])
    hits = np.bincount(obstacles([*drawn, *taken]).crossed(low, high), minlength=len(tried))

    def price(k: int) -> float:
        start, _, end = tried[k]
        near = any(abs(start - other.start) < _APART or abs(end - other.end) < _APART for other in taken)
        return float(min(hits[k], 6) + 8 * near + 30 * (not (paper.room.holds(start) and paper.room.holds(end))))

    best = min(range(len(tried)), key=lambda k: (price(k) + 0.4 * k, k))
    return tried[best][0], tried[best][1]


def bare_mechanism(found: Centres, window: Window) -> Figure:
    """The mechanism before its first centre."""
    skeleton = Skeleton(found.method.mechanism, found.plot, window, {})
    return bare_figure(found.method, skeleton).numbered(None)


def centre_figure(paper: OnPaper) -> Figure:
    """Lines first, the mechanism over them, then the marks of the centres and the arrows to those that have none."""
    lines, machine = centre_lines(paper), bare_mechanism(paper.found, paper.window)
    hinges = [paper.window(place) for place in mechanism_places(paper.found.method, paper.found.plot)]
    marks: list[Mark] = []
    for spot in filter(paper.shown, paper.spots):  # a small circle with a dot; over a hinge the dot alone shows
        at, step = paper.at(spot), spot.number
        if all(abs(hinge - at) >= _CIRCLE for hinge in hinges):
            marks.append(Disc(at, _CIRCLE, "thin", "paper", step=step))
        marks.append(PointMark("centres", spot.name, spot.name, at, _DOT, step=step))
    drawn = [*lines.marks, *machine.marks, *marks]
    arrows = centre_arrows(paper, drawn)
    wanted = [*machine.wanted, *_names(paper), *arrows.wanted, *lines.wanted]
    return Figure([*drawn, *arrows.marks], wanted)


def _names(paper: OnPaper) -> Iterator[LabelRequest]:
    """A label for each place, with all centres there; each name comes with its own step."""
    groups: list[list[Spot]] = []
    for spot in filter(paper.shown, paper.spots):
        group = next((group for group in groups if abs(paper.at(group[0]) - paper.at(spot)) < SAME), None)
        if group is None:
            groups.append(group := [])
        group.append(spot)
    for group in groups:
        labels, first = [centre_label(spot.name) for spot in group], group[0]
        starts: list[Label] = [(), *([(Run(_BETWEEN),)] * (len(group) - 1))]
        parts = tuple((start + label, spot.number) for start, label, spot in zip(starts, labels, group, strict=True))
        yield LabelRequest(joined(labels, _BETWEEN), paper.at(first), gap=HINGE, step=first.number, parts=parts)
