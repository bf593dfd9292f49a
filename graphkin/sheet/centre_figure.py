"""The mechanism with its instant centres: Kennedy's lines, marks and names, arrows to centres that no mark shows.

Source: Sun Huan, 机械原理, section 3-2.2.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base import geometry
from graphkin.base.boxes import xy
from graphkin.base.geometry import place
from graphkin.base.lines import free_pieces
from graphkin.base.rooms import Room, corners
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.construction.drafting import Far, Stage
from graphkin.model.pairs import Cam, Rod
from graphkin.planning import Method
from graphkin.say.solution_goal import solution_centres
from graphkin.sheet.added_points import drawn_when
from graphkin.sheet.drafting_figure import DraftingFigure, together
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, number, plain, quantity_label
from graphkin.sheet.marks import Disc, Mark, Place, PointMark, Stroke, VectorMark
from graphkin.sheet.mechanism_figure import mechanism_figure, mechanism_places
from graphkin.sheet.obstacles import obstacles
from graphkin.sheet.paper import PenName
from graphkin.sheet.path_figure import clipped
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import BLOCK, HINGE
from graphkin.sheet.window import Entry, Figure, Window
from graphkin.studies.centres import Centres, centres
from graphkin.studies.centres.instant_centres import shortest

SAME = 0.05  # places closer than this are one on paper [mm]


@frozen
class Spot:
    """A centre at one position, found in a stage (the first is 1): its place [m]; None at infinity, in a direction."""

    name: str
    number: int
    stage: Stage
    place: complex | None
    direction: complex = 0j


def spots(found: Centres) -> Iterator[Spot]:
    """All centres in the order in which they are found."""
    for step, stage in enumerate(found.centring.stages, start=1):
        name, place = stage.last.name, geometry.place(found.board.at(stage.last.name))
        finite = cmath.isfinite(place)
        turn = 0.0 if finite else round(geometry.number(found.board.direction(name)), 9) % round(cmath.pi, 9)
        direction = 0j if finite else cmath.rect(1, turn)  # as it is told, from 0 to 180 degrees
        yield Spot(name, step, stage, place if finite else None, direction)


def centre_label(name: str) -> Label:
    """`P13` with its numbers as a subscript."""
    return quantity_label("P", name[1:])


def coordinates(found: Centres, place: complex) -> Label:
    """`(34.37, −115.6)`: in mm; what is smaller than rounding is 0."""
    shown = 1000 * geometry.place(found.method.mechanism.usual.cut(place, "m"))
    return (Run("("), *number(shown.real), Run(", "), *number(shown.imag), Run(")"))


_BEYOND = 4.0  # how far a line goes on past the centres on it [mm]
_NORMAL = 12.0  # how far a common normal goes on past the rim of the smaller profile about its centre [mm]
_SHORT = 0.8  # a shorter rest of a line already drawn is not drawn [mm]
INFINITY: Label = plain(" → ∞ ")  # the room after the sign is because it is wider than what letters count as
_ARROW, _EDGE_ARROW = 13.0, 8.0  # an arrow to infinity, and one to a centre beyond the edge [mm]
_OFF = BLOCK.imag / 2 + 1.0  # from a block's middle to where its arrow starts [mm]
_APART = 5.0  # arrows in one direction start at least so far from one another [mm]
_CIRCLE, _DOT = 1.0, 0.5  # radius of the circle and of the dot that mark a centre [mm]


@frozen
class OnPaper:
    """The centres through a window on the mechanism, in a room of the paper."""

    found: Centres
    window: Window
    room: Room

    @cached_property
    def spots(self) -> list[Spot]:
        return [*spots(self.found)]

    def at(self, spot: Spot) -> Place:
        """The place of a centre that is not at infinity, on the paper or beyond it."""
        assert spot.place is not None
        return self.window(spot.place)

    def shown(self, spot: Spot) -> bool:
        """True for a centre in the room."""
        return spot.place is not None and self.room.holds(self.at(spot))

    def lines(self, spot: Spot) -> Iterator[Stroke]:
        """The lines that give a centre, past the centres on them; common normals past profiles, as centre lines."""
        construction, board = self.found.centring.construction, self.found.board
        drafting = DraftingFigure(construction, board, self.window, self.room, _BEYOND)
        for line in spot.stage.lines if spot.stage.say == "two lines" else ():
            normal, also = self.found.centring.normals.get(line.name), list[Place]()
            if normal is not None:
                along, pair = self.window.turned(place(self.found.plot.direction(normal.line.direction))), normal.pair
                least = min((radius for *_, radius in pair.circles), default=0.0) if isinstance(pair, Cam) else 0.0
                past = (_NORMAL + least / self.window.scale) * along / abs(along)
                names = pair.slipping.points if isinstance(pair.slipping, Rod) else (normal.line.through,)
                centres = [self.window(place(self.found.plot.position[name])) for name in names]
                also = [at + side * past for at in centres for side in (1, -1)]
            pen: PenName = "dashed" if normal is None else "centre"
            yield from clipped(drafting.ends(line, also), self.room, pen, spot.number)


def centre_lines(paper: OnPaper) -> Iterator[Entry]:
    """The lines of all steps, the later ones where no earlier one lies."""
    drawn = list[Stroke]()
    for spot in paper.spots:
        for line in paper.lines(spot):
            drawn += (fresh := [*_fresh(line, drawn)])
            yield from fresh
            for end, other in (line.places, line.places[::-1]) if line.pen == "centre" else ():
                yield LabelRequest(plain("n", italic=True), end, gap=0.2, away=end - other, step=spot.number)


def asked_lines(method: Method, skeleton: Skeleton, drawn: list[complex]) -> Iterator[Entry]:
    """Kennedy's lines to the solution's centres that are shown; those of a special point's legs are there already."""
    plot, asked = skeleton.plot, solution_centres(method.mechanism)
    if not isinstance(plot, Plot) or not plot.omega:
        return iter(())
    found, near = centres(method, plot), SAME * skeleton.window.scale
    legs, names = [place(plot.position[name]) for name in method.special], set[str]()
    for name in (found.name(*one.links) for one in asked if found.exists(*one.links)):
        at = place(found.board.at(name))
        shown, leg = (min((abs(at - other) for other in some), default=near) for some in (drawn, legs))
        if shown < near <= leg:
            names.add(name)
    low, high = corners([skeleton.window(at) for at in drawn])
    room = Room(low.real, low.imag, high.real, high.imag).inset(-_BEYOND, -_BEYOND, -_BEYOND)
    found, last = replace(found, centring=shortest(found, names)), drawn_when(method)
    return (replace(entry, step=last) for entry in centre_lines(OnPaper(found, skeleton.window, room)))


def _fresh(line: Stroke, drawn: Sequence[Stroke]) -> Iterator[Stroke]:
    """The pieces of a line on which no other lies."""
    start, end = line.places
    along = (end - start) / abs(end - start)
    every = [[(at - start) / along for at in other.places] for other in drawn]
    on = [sorted(off.real for off in ends) for ends in every if max(abs(off.imag) for off in ends) < 2 * SAME]
    for low, high in free_pieces(abs(end - start), ((one, two) for one, two in on)):
        if high - low > _SHORT:
            yield replace(line, places=(start + low * along, start + high * along))


def centre_arrows(paper: OnPaper, drawn: Sequence[Mark]) -> Figure:
    """One arrow for each centre that is not marked, with its name; off the sheet also with its coordinates. It stands
    where it crosses the fewest lines, in the room, off other arrows; the first of equals."""
    figure, off = Figure(), list[Place]()
    for spot in (spot for spot in paper.spots if not paper.shown(spot)):
        head, where, length = ("∞", INFINITY, _ARROW) if spot.place is None else (
            spot.name, (Run(" "), *coordinates(paper.found, spot.place), Run(" mm")), _EDGE_ARROW)  # fmt: skip
        tried = [(start, along, start + length * along) for start, along in _places(paper, spot)]
        skew = [(start + 0.4j * along, end - 0.4j * along) for start, along, end in tried]  # a bar along it is crossed
        crossed = obstacles([*drawn, *figure.marks]).crossed(*(xy(np.array(ends)) for ends in zip(*skew)))
        price = [min(hits, 6) + 0.4 * k for k, hits in enumerate(crossed.tolist())]
        for k, (start, _, end) in enumerate(tried):
            price[k] += 8 * any(min(abs(start - other), abs(end - other)) < _APART for other in off)
            price[k] += 30 * (not (paper.room.holds(start) and paper.room.holds(end)))
        start, along, end = tried[price.index(min(price))]
        off += (start, end)
        figure.marks.append(VectorMark("centres", spot.name, "", head, start, end, spot.number))
        label = (*centre_label(spot.name), *where)
        figure.wanted.append(LabelRequest(label, end, gap=0.7, away=along, step=spot.number))
    return figure


def _places(paper: OnPaper, spot: Spot) -> Iterator[tuple[Place, complex]]:
    """Its starts, with their directions: on both sides of its slide's block, at the end of a line, at last anywhere."""
    if isinstance(spot.stage.last, Far):
        name = spot.stage.last.line
        slide = next(slide for slide in paper.found.method.mechanism.slides if slide.name == name)
        at, normal = paper.window(place(paper.found.plot.position[slide.point])), paper.window.turned(spot.direction)
        for off in (_OFF, _OFF + 6, _OFF + 14):
            yield from ((at + start * normal, normal) for start in (off, -off - _ARROW))
    for line in paper.lines(spot):
        for start, end in (line.places, line.places[::-1]):
            along = (end - start) / abs(end - start)
            ahead = paper.window.turned(spot.direction) if spot.place is None else paper.at(spot) - end
            if (ahead * along.conjugate()).real > 0:  # that end leads to the centre
                starts = (2.0,) if spot.place is None else (_EDGE_ARROW + 0.5 + k * (_EDGE_ARROW + 4) for k in range(3))
                yield from ((end - start * along, along) for start in starts)
    spread = 0.35 * paper.room.size  # from about the middle of the figure to its edge
    for x, y in ((0, 0), (1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, -1), (1, -1), (-1, 1)):
        foot = paper.room.middle + complex(x * spread.real, y * spread.imag)
        along = paper.window.turned(spot.direction) if spot.place is None else paper.at(spot) - foot
        along /= abs(along)
        for line in clipped([foot, foot + along * abs(paper.room.size)], paper.room, "thin"):
            yield line.places[-1] - along * (_ARROW + 1), along


def bare_mechanism(found: Centres, window: Window) -> Figure:
    """The mechanism before its first centre."""
    skeleton = Skeleton(found.method.mechanism, found.plot, window, {})
    return mechanism_figure(skeleton, found.method, bare=True).numbered(None)


def centre_figure(paper: OnPaper, whole: bool = True) -> Figure:
    """Lines first, the mechanism over them, then the centres and, of a whole one, the arrows to those off the paper."""
    lines, machine = Figure.of(centre_lines(paper)), bare_mechanism(paper.found, paper.window)
    hinges = [paper.window(place) for place in mechanism_places(paper.found.method, paper.found.plot)]
    marks: list[Mark] = []
    for spot in filter(paper.shown, paper.spots):  # a small circle with a dot; over a hinge the dot alone shows
        at, step = paper.at(spot), spot.number
        if all(abs(hinge - at) >= _CIRCLE for hinge in hinges):
            marks.append(Disc(at, _CIRCLE, "thin", "paper", step=step))
        marks.append(PointMark("centres", spot.name, spot.name, at, _DOT, step=step))
    drawn, shown = [*lines.marks, *machine.marks, *marks], filter(paper.shown, paper.spots)
    names = (LabelRequest(centre_label(s.name), paper.at(s), gap=HINGE, step=s.number) for s in shown)
    arrows = centre_arrows(paper, drawn) if whole else Figure()
    wanted = [*machine.wanted, *together(names), *arrows.wanted, *lines.wanted]
    return Figure([*drawn, *arrows.marks], wanted)
