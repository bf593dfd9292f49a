"""A link about its pole, drawn: velocities, poles, circles, centres of curvature; and Bobillier's construction."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from itertools import chain

from graphkin.base.geometry import place as as_place
from graphkin.base.lines import circle_places
from graphkin.base.rooms import enlarged
from graphkin.base.scales import finest
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.construction.drafting import CarriedAngle, LineStep, PointStep, Step
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.say.catalogue import say
from graphkin.say.centre_about import bobillier_words, link_words
from graphkin.sheet import symbols
from graphkin.sheet.centre_figure import INFINITY, centre_label, coordinates
from graphkin.sheet.drafting_figure import DraftingFigure, angle, named, pointer, spot
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, number, plain, point_label, quantity_label
from graphkin.sheet.marks import Fill, Stroke
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import PenName
from graphkin.sheet.path_figure import FINE, clipped
from graphkin.sheet.single_figure import SingleFigure, place_for
from graphkin.sheet.titleblock import Strip, Table
from graphkin.sheet.window import Entry, Figure
from graphkin.studies.centres.about import About, Circle, InflectionLine
from graphkin.studies.centres.about_bobillier import Bobillier

_POLE, _MOST = 2.6, 1.5
"""So many times larger the figure may become for the pole; and then for circles and centres of curvature."""
_LONGEST = 28.0  # the longest velocity arrow [mm]
_AXIS = 38.0  # half of the pole tangent, and of the normal [mm]
_TOWARDS = 30.0  # how far a ray goes to a pole that is not on the paper [mm]

_CURVATURE, _ARC, _WITHIN, _NEARER, _TICK, _INSIDE = 2.6, 12.0, 0.8, 0.85, 1.0, 6.0
"""So many times larger Bobillier's figure may become; the length of the arcs of its equal angles [mm], how far out they
lie on the shortest of their lines, one against the other, half of a tick; the end of an arrow from the edge [mm]."""


def about_sheet(link: About, *, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """Draw a link about its pole, to scale; what lies too far off is shown by its direction. Raises UnknownPaper."""
    method, plot = link.found.method, link.plot
    beside: list[complex] = [] if link.acceleration_pole is None else [link.acceleration_pole]
    beside += [carried.centre for carried in link.points.values()]
    for drawn in (link.inflection, link.returning):
        if isinstance(drawn, Circle):
            beside += [drawn.centre + drawn.radius * side for side in (1, 1j, -1, -1j)]
    places = enlarged(enlarged(shown_places(method, plot), [link.pole], _POLE), beside, _MOST)
    on = place_for(method, [plot], places, paper, Strip(_point_tables(link, lang), [*link_words(link, lang)]))
    drawing = _LinkDrawing(link, on, lang)
    under = chain(drawing.circles(), drawing.axes(), drawing.rays())
    over = chain(drawing.velocities(), drawing.centres())
    figure = Figure.of(under) + on.mechanism(plot) + Figure.of(over)
    further: dict[Plane, float] = {"velocity": drawing.pace} if link.moves else {}
    return on.sheet(plot, say("about.sheet heading", lang, link=link.called), figure, lang, further)


def _point_tables(link: About, lang: Lang) -> list[Table]:
    """Speed, acceleration and curvature of its points; empty for a link without named points."""
    heads = [(Run(letter, True), Run(f" [{unit}]")) for letter, unit in (("v", "m/s"), ("a", "m/s²"), ("ρ", "mm"))]
    centre = tuple(Run(letter, letter in "Kxy") for letter in say("about.sheet centre", lang))
    head = (plain(say("about.sheet point", lang)), *heads, centre)
    rows = []
    for name, carried in link.points.items():
        sizes = [number(abs(value)) for value in (carried.velocity, carried.acceleration)]
        dash = plain("–") if cmath.isnan(carried.centre) else plain("∞")  # it stands still; its path is straight
        curving = dash, dash
        if cmath.isfinite(carried.centre):
            curving = number(carried.radius * 1e3), coordinates(link.found, carried.centre)
        rows.append((point_label(name), *sizes, *curving))
    return [Table(head, tuple(rows))] if rows else []


@frozen
class _LinkDrawing:
    link: About
    on: SingleFigure
    lang: Lang

    @property
    def pace(self) -> float:
        """Scale of the velocity arrows, which stay within the room [(m/s)/mm]."""
        points, window, room = self.link.points.values(), self.on.window, self.on.room
        fastest = max((abs(carried.velocity) for carried in points), default=0.0)
        fastest = fastest or abs(self.link.base[1]) or abs(self.link.omega) * self.link.size
        for part in (1.0, 0.7, 0.5, 0.35, 0.25):
            pace = finest(complex(fastest, 0), complex(part * _LONGEST, _LONGEST))
            if all(room.holds(window(each.place) + 1.1 * window.turned(each.velocity / pace)) for each in points):
                break
        return pace

    def circles(self) -> Iterator[Entry]:
        """Inflection and return circle; the inflection pole W."""
        link, window, room = self.link, self.on.window, self.on.room
        if isinstance(link.inflection, InflectionLine):
            foot, along = window(link.inflection.through), window.turned(link.inflection.direction)
            reach = abs(room.size) + abs(foot - room.middle)
            line = list(clipped([foot - reach * along, foot + reach * along], room, "thin"))
            yield from line
            yield from named(line, plain(say("about.sheet inflection line", self.lang)))
        if not link.diameter or link.returning is None or not isinstance(link.inflection, Circle):
            return
        pens: tuple[PenName, ...] = ("thin", "dashed")
        both = link.inflection, link.returning
        seen = room.middle, abs(room.size), FINE
        rims = [circle_places(window(each.centre), each.radius / window.scale, *seen) for each in both]
        every = [list(clipped(rim, room, pen)) for rim, pen in zip(rims, pens, strict=True)]
        for own, others, words in zip(every, every[::-1], ("inflection", "return"), strict=True):
            yield from own
            yield from named(own, plain(say(f"about.sheet {words}", self.lang)), others)
        yield from self._spot(link.pole + link.diameter, plain("W", italic=True))

    def axes(self) -> Iterator[Entry]:
        """Pole tangent t and normal n."""
        link, start = self.link, self.on.window(self.link.pole)
        if link.tangent is None or link.normal is None or not self.on.room.holds(start):
            return
        for letter, direction in (("t", link.tangent), ("n", link.normal)):
            along = self.on.window.turned(direction)
            for stroke in clipped([start - _AXIS * along, start + _AXIS * along], self.on.room, "centre"):
                yield stroke
                yield LabelRequest(plain(letter, italic=True), stroke.places[-1], gap=0.6, away=along)

    def rays(self) -> Iterator[Entry]:
        """From each point to the pole; towards a pole that is not on the paper, with an arrow."""
        link, window, room = self.link, self.on.window, self.on.room
        if not link.moves:
            return
        far, last = cmath.isinf(link.pole), list[Entry]()
        where = INFINITY if far else (Run(" "), *coordinates(link.found, link.pole), Run(" mm"))
        name = (*centre_label(link.found.name(FRAME, link.link)), *where)
        for at, carried in ((window(carried.place), carried) for carried in link.points.values()):
            along = window.turned(link.towards if far else link.pole - carried.place)
            if not far and room.holds(window(link.pole)):
                yield from clipped([at, window(link.pole)], room, "construction")
            elif abs(along) > 0:
                arrow = [*pointer(at, at + along / abs(along) * _TOWARDS, room, name)]
                yield from arrow[:-1]
                last = arrow[-1:] or last
        yield from last

    def velocities(self) -> Iterator[Entry]:
        """The velocity of each point, to the scale of velocities."""
        for name, carried in self.link.points.items():
            arrow = self.on.window.turned(carried.velocity / self.pace)
            if abs(arrow) < 0.3:
                continue
            start = self.on.window(carried.place)
            yield from symbols.arrow(start, start + arrow, "velocity")
            yield LabelRequest(quantity_label("v", name), start, start + arrow, gap=0.7)

    def centres(self) -> Iterator[Entry]:
        """The poles P and J; centres of curvature, and the radius from each point."""
        window = self.on.window
        yield from self._spot(self.link.pole, centre_label(self.link.found.name(FRAME, self.link.link)), 1.0, "paper")
        if self.link.acceleration_pole is not None:
            yield from self._spot(self.link.acceleration_pole, plain("J", italic=True), 1.0, "paper")
        for name, carried in self.link.points.items():
            if cmath.isfinite(carried.centre) and carried.radius > 1e-9 * self.link.size:
                yield from clipped([window(carried.place), window(carried.centre)], self.on.room, "dashed")
                yield from self._spot(carried.centre, quantity_label("K", name))

    def _spot(self, place: complex, label: Label, radius: float = 0.6, fill: Fill = "ink") -> Iterator[Entry]:
        if self.on.room.holds(at := self.on.window(place)):
            yield from spot(at, label, radius, fill)


# --- Bobillier --------------------------------------------------------------------------------


def bobillier_sheet(solution: Bobillier, *, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """Bobillier's whole construction over the mechanism, a step for each sentence. Raises UnknownPaper."""
    link = solution.seen
    method, plot = link.found.method, link.plot
    names = (solution.point, solution.pole, solution.answer, *solution.crossings)
    places = [as_place(solution.board.at(name)) for name in names]
    shown = enlarged(shown_places(method, plot), places, _CURVATURE)
    on = place_for(method, [plot], shown, paper, Strip(told=bobillier_words(solution, lang)))
    drawing = _BobillierDrawing(solution, DraftingFigure(solution.construction, solution.board, on.window, on.room))
    points = drawing.points(solution.point not in method.mechanism.points)
    figure = Figure.of(drawing.on.stages(drawing.step)) + on.mechanism(plot) + Figure.of(points)
    return on.sheet(plot, say("about.sheet bobillier", lang, point=solution.point, link=link.called), figure, lang)


@frozen
class _BobillierDrawing:
    solution: Bobillier
    on: DraftingFigure

    def step(self, made: Step, stage: int) -> Iterator[Entry]:
        """A thin line, an axis as a centre line, with equal angles."""
        if isinstance(made, LineStep):
            yield from self.on.line(made, stage, "centre" if made.name in ("axis", "axis c") else "construction")
        if isinstance(made, CarriedAngle):
            yield from self._equal_angles(made, stage)

    def _equal_angles(self, carried: CarriedAngle, stage: int) -> Iterator[Entry]:
        """The angle between two rays of the pole and, nearer to it, the same between the axes: arcs with ticks."""
        lines, ends, (pole,) = self.solution.construction.made_by, dict[str, complex](), self.on.at(carried.at)
        for name in (carried.start, carried.end, carried.line, carried.name):
            if isinstance(line := lines[name], LineStep):
                shown = (at for stroke in self.on.line(line, stage) for at in stroke.places)
                ends[name] = max(shown, key=lambda at: abs(at - pole), default=pole) - pole
        if not all(ends.values()) or not self.on.room.holds(pole):
            return
        turn = cmath.phase((ends[carried.end] / ends[carried.start]) ** 2) / 2  # of lines: by less than a right angle
        most = min(_ARC / min(abs(turn) + 1e-9, 1.0), _WITHIN * min(map(abs, ends.values())))
        for name, radius in ((carried.end, most), (carried.name, _NEARER * most)):
            first = ends[name] * cmath.rect(1, -turn)
            yield from angle(pole, first, turn, radius, plain("δ", italic=True), stage, heads=False)
            middle = ends[name] / abs(ends[name]) * cmath.rect(1, -turn / 2)
            yield Stroke((pole + (radius - _TICK) * middle, pole + (radius + _TICK) * middle), "thin", step=stage)

    def points(self, new: bool) -> Iterator[Entry]:
        """The points of the construction; new: and the point itself, where the mechanism does not show it."""
        point, solution = self.solution.point, self.solution
        labels = {point: point_label(point), solution.crossings[-1]: quantity_label("Q", point),
                  solution.answer: quantity_label("K", point)}  # fmt: skip
        made = (step.name for step in solution.construction.steps if isinstance(step, PointStep))
        for name, stage in [*[(point, None)] * new, *((name, solution.construction.born(name)) for name in made)]:
            label = labels.get(name, plain(name.replace("'", "′"), italic=True))
            for at in self.on.at(name):
                if self.on.room.holds(at):
                    yield from spot(at, label, step=stage)
                elif name == solution.answer:  # too far off: its direction from the point
                    start, inside = *self.on.at(point), self.on.room.inset(_INSIDE, _INSIDE, _INSIDE)
                    yield from pointer(start, at, inside, (Run("→ "), *label), stage)
