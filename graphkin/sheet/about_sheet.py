"""A link about its pole, drawn: velocities, poles, circles, centres of curvature; and Bobillier's construction."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping
from itertools import chain

import numpy as np

from graphkin.base.geometry import place as as_place
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.construction.drafting import CarriedAngle, LineStep, PointStep, Step
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.say.centre_about import bobillier_words, link_words
from graphkin.sheet import symbols
from graphkin.sheet.centre_figure import INFINITY, coordinates
from graphkin.sheet.drafting_figure import DraftingFigure, named, spot
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, number, plain, point_label, quantity_label
from graphkin.sheet.marks import ArcMark, Fill, Mark, Place, Stroke
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import PenName, finest
from graphkin.sheet.path_figure import circle, clipped
from graphkin.sheet.single_figure import SingleFigure, place_for
from graphkin.sheet.titleblock import Table
from graphkin.sheet.window import Entry, Figure, corners, enlarged
from graphkin.studies.centres.about import About, Circle, InflectionLine
from graphkin.studies.centres.about_bobillier import Bobillier

_POLE, _MOST = 2.6, 1.5
"""So many times larger the figure may become for the pole; and then for circles and centres of curvature."""
_LONGEST = 28.0  # the longest velocity arrow [mm]
_FIELD = 17.0  # how far the arrows of the field stand apart [mm]
_LIGHT = 0.5  # the field's arrows are so much shorter than the scale says, not to cover one another
_AXIS = 38.0  # half of the pole tangent, and of the normal [mm]
_TOWARDS = 30.0  # how far a ray goes to a pole that is not on the paper [mm]

_CURVATURE, _ARC = 2.6, 12.0
"""So many times larger Bobillier's figure may become; the length of the arcs of its equal angles [mm]."""

HEADING: dict[Lang, str] = {"en": "Link {link} about its instant centre", "zh": "构件 {link} 绕瞬心的运动"}
BOBILLIER: dict[Lang, str] = {
    "en": "Centre of curvature of the path of {point} of link {link} (Bobillier)",
    "zh": "构件 {link} 上点 {point} 轨迹的曲率中心（波比利尔作图法）",
}
INFLECTION: dict[Lang, str] = {"en": "inflection circle", "zh": "拐点圆"}
INFLECTION_LINE: dict[Lang, str] = {"en": "inflection circle (a line)", "zh": "拐点圆（退化为直线）"}
RETURN: dict[Lang, str] = {"en": "cuspidal circle", "zh": "尖点圆"}
_POINT: dict[Lang, str] = {"en": "point", "zh": "点"}
_CENTRE: dict[Lang, str] = {"en": "K (x, y) [mm]", "zh": "K（x，y）[mm]"}


def about_sheet(link: About, *, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """Draw a link about its pole, to scale; what lies too far off is shown by its direction. Raises UnknownPaper."""
    method, plot = link.found.method, link.plot
    beside: list[complex] = [] if link.acceleration_pole is None else [link.acceleration_pole]
    beside += [carried.centre for carried in link.points.values()]
    for drawn in (link.inflection, link.returning):
        if isinstance(drawn, Circle):
            beside += [drawn.centre + drawn.radius * side for side in (1, 1j, -1, -1j)]
    places = enlarged(enlarged(shown_places(method, plot), [link.pole], _POLE), beside, _MOST)
    on = place_for(method, [plot], places, paper, _point_tables(link, lang), [*link_words(link, lang)])
    drawing = _LinkDrawing(link, on, lang)
    under = chain(drawing.circles(), drawing.axes(), drawing.rays(), drawing.field())
    over = chain(drawing.velocities(), drawing.poles(), drawing.centres())
    figure = Figure.of(under) + on.mechanism(plot) + Figure.of(over)
    further: dict[Plane, float] = {"velocity": drawing.pace} if link.moves else {}
    return on.sheet(plot, HEADING[lang].format(link=link.called), figure, lang, further)


def _point_tables(link: About, lang: Lang) -> list[Table]:
    """Speed, acceleration and curvature of its points; empty for a link without named points."""
    heads = [(Run(letter, True), Run(f" [{unit}]")) for letter, unit in (("v", "m/s"), ("a", "m/s²"), ("ρ", "mm"))]
    head = (plain(_POINT[lang]), *heads, plain(_CENTRE[lang]))
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
    """A link on a page: its marks and labels in the order of painting."""

    link: About
    on: SingleFigure
    lang: Lang

    @property
    def pace(self) -> float:
        """Scale of the velocity arrows [(m/s)/mm]."""
        fastest = max((abs(carried.velocity) for carried in self.link.points.values()), default=0.0)
        fastest = fastest or abs(self.link.base[1]) or abs(self.link.omega) * self.link.size
        return finest(complex(fastest, 0), complex(_LONGEST, _LONGEST))

    @property
    def name(self) -> Label:
        """The pole's letters, P₁₃."""
        return quantity_label("P", self.link.found.name(FRAME, self.link.link)[1:])

    def circles(self) -> Iterator[Entry]:
        """Inflection and return circle; the inflection pole W."""
        link, window, room = self.link, self.on.window, self.on.room
        if isinstance(link.inflection, InflectionLine):
            foot, along = window(link.inflection.through), window.turned(link.inflection.direction)
            reach = abs(room.size) + abs(foot - room.middle)
            yield from self._curve([foot - reach * along, foot + reach * along], "thin", INFLECTION_LINE)
        if not link.diameter or link.returning is None or not isinstance(link.inflection, Circle):
            return
        pens: tuple[PenName, ...] = ("thin", "dashed")
        for drawn, pen, words in zip((link.inflection, link.returning), pens, (INFLECTION, RETURN), strict=True):
            places = circle(window(drawn.centre), drawn.radius / window.scale, room)
            yield from self._curve(places, pen, words)
        yield from self._spot(link.pole + link.diameter, plain("W", italic=True))

    def _curve(self, places: list[Place], pen: PenName, words: Mapping[Lang, str]) -> Iterator[Entry]:
        strokes = list(clipped(places, self.on.room, pen))
        yield from strokes
        yield from named(strokes, plain(words[self.lang]), 1 / 3)

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
        far, last = cmath.isinf(link.pole), list[tuple[Place, complex]]()
        for at, carried in ((window(carried.place), carried) for carried in link.points.values()):
            along = window.turned(link.towards if far else link.pole - carried.place)
            if not far and room.holds(window(link.pole)):
                yield from clipped([at, window(link.pole)], room, "construction")
            elif abs(along) > 0:
                along /= abs(along)
                for ray in clipped([at, at + along * _TOWARDS], room, "construction"):
                    last = [(ray.places[-1], along)]
                    yield from (ray, symbols.arrow_head(ray.places[-1], along, None))
        for at, along in last:
            where = INFINITY if far else (Run(" "), *coordinates(link.found, link.pole), Run(" mm"))
            yield LabelRequest((*self.name, *where), at, gap=1.0, away=along)

    def field(self) -> Iterator[Entry]:
        """A light field of velocities over the link's plane, about its points and its pole."""
        link, window, room = self.link, self.on.window, self.on.room
        if not link.moves:
            return
        places = [*filter(room.holds, map(window, (*(carried.place for carried in link.points.values()), link.pole)))]
        if not places:
            return
        low, high = corners(places)
        xs = np.arange(low.real - _FIELD, high.real + _FIELD + 1e-9, _FIELD)
        ys = np.arange(low.imag - _FIELD, high.imag + _FIELD + 1e-9, _FIELD)
        for at in (complex(x, y) for x in xs for y in ys):
            velocity = link.carried(((at - window.origin) * window.scale).conjugate()).velocity
            arrow = window.turned(velocity / self.pace) * _LIGHT
            inside = room.holds(at) and room.holds(at + arrow)
            if 1.0 < abs(arrow) <= _FIELD and inside and all(abs(at - p) > 5 for p in places):
                tip, along = at + arrow, arrow / abs(arrow)
                head = tip - (1.3 - 0.45j) * along, tip, tip - (1.3 + 0.45j) * along
                yield from (Stroke(line, "thin", accent="velocity") for line in ((at, tip), head))

    def velocities(self) -> Iterator[Entry]:
        """The velocity of each point, to the scale of velocities."""
        for name, carried in self.link.points.items():
            arrow = self.on.window.turned(carried.velocity / self.pace)
            if abs(arrow) < 0.3:
                continue
            start = self.on.window(carried.place)
            yield from symbols.arrow(start, start + arrow, "velocity")
            yield LabelRequest(quantity_label("v", name), start, start + arrow, gap=0.7)

    def poles(self) -> Iterator[Entry]:
        """P and J."""
        yield from self._spot(self.link.pole, self.name, 1.0, "paper")
        if self.link.acceleration_pole is not None:
            yield from self._spot(self.link.acceleration_pole, plain("J", italic=True), 1.0, "paper")

    def centres(self) -> Iterator[Entry]:
        """Centres of curvature, and the radius from each point."""
        window = self.on.window
        for name, carried in self.link.points.items():
            if cmath.isfinite(carried.centre) and carried.radius > 1e-9 * self.link.size:
                yield from clipped([window(carried.place), window(carried.centre)], self.on.room, "dashed")
                yield from self._spot(carried.centre, quantity_label("K", name))

    def _spot(self, place: complex, label: Label, radius: float = 0.6, fill: Fill = "ink") -> Iterator[Entry]:
        if self.on.room.holds(at := self.on.window(place)):
            yield from spot(at, label, radius, fill)


# --- Bobillier --------------------------------------------------------------------------------


def bobillier_sheet(link: About, solution: Bobillier, *, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """Bobillier's whole construction over the mechanism, a step for each sentence. Raises UnknownPaper."""
    method, plot = link.found.method, link.plot
    names = (solution.point, solution.pole, solution.answer, *solution.crossings)
    places = [as_place(solution.board.at(name)) for name in names]
    shown = enlarged(shown_places(method, plot), places, _CURVATURE)
    on = place_for(method, [plot], shown, paper, told=bobillier_words(solution, lang))
    drawing = _BobillierDrawing(solution, DraftingFigure(solution.construction, solution.board, on.window, on.room))
    points = drawing.points(solution.point not in method.mechanism.points)
    figure = Figure.of(drawing.on.stages(drawing.step)) + on.mechanism(plot) + Figure.of(points)
    return on.sheet(plot, BOBILLIER[lang].format(point=solution.point, link=link.called), figure, lang)


@frozen
class _BobillierDrawing:
    """The construction on a page."""

    solution: Bobillier
    on: DraftingFigure

    def step(self, made: Step, stage: int) -> Iterator[Entry]:
        """A thin line, an axis as a centre line, with equal angles."""
        if isinstance(made, LineStep):
            yield from self.on.line(made, stage, "centre" if made.name in ("axis", "axis c") else "construction")
        if isinstance(made, CarriedAngle):
            yield from self._equal_angles(made, stage)

    def _equal_angles(self, carried: CarriedAngle, stage: int) -> Iterator[Mark]:
        """The angle between two rays of the pole, and the same between the axes: arcs with a dash."""
        lines, ends = self.solution.construction.made_by, dict[str, complex]()
        (pole,) = self.on.at(carried.at)
        for name in (carried.start, carried.end, carried.line, carried.name):
            if isinstance(line := lines[name], LineStep):
                ends[name] = max(self.on.ends(line), key=lambda at: abs(at - pole), default=pole) - pole
        if not all(ends.values()) or not self.on.room.holds(pole):
            return
        turn = cmath.phase((ends[carried.end] / ends[carried.start]) ** 2) / 2  # of lines: by less than a right angle
        radius = min(_ARC / min(abs(turn) + 1e-9, 1.0), min(map(abs, ends.values())) - self.on.beyond)
        for name in (carried.end, carried.name):
            begin = cmath.phase(ends[name]) - turn
            middle = cmath.rect(1, begin + turn / 2)
            yield ArcMark(pole, radius, begin, turn, "construction", stage)
            yield Stroke((pole + (radius - 1) * middle, pole + (radius + 1) * middle), "construction", step=stage)

    def points(self, new: bool) -> Iterator[Entry]:
        """The points of the construction; new: and the point itself, where the mechanism does not show it."""
        point, solution = self.solution.point, self.solution
        named: list[tuple[str, int | None]] = [(point, None)] if new else []
        named += [(step.name, solution.construction.born(step.name)) for step in solution.construction.steps
                  if isinstance(step, PointStep)]  # fmt: skip
        labels = {point: point_label(point), solution.crossings[1]: quantity_label("Q", point)}
        labels[solution.answer] = quantity_label("K", point)
        for name, stage in named:
            for at in filter(self.on.room.holds, self.on.at(name)):
                own = plain(name.replace("'", "′"), italic=True)
                yield from spot(at, labels.get(name, own), step=stage)
