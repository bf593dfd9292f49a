"""A link about its pole, drawn: velocities, poles, inflection and return circles, centres of curvature."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping
from itertools import chain

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.say.centre_about import link_words
from graphkin.say.numbers import number
from graphkin.sheet.about_table import point_tables
from graphkin.sheet.curves import circle, clipped
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, joined, plain, quantity_label
from graphkin.sheet.marks import Disc, Fill, Mark, Place, Stroke
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import PenName, Room, finest
from graphkin.sheet.single_figure import SingleFigure, place_for
from graphkin.sheet.symbols import arrow_head
from graphkin.sheet.window import Entry, Figure, enlarged
from graphkin.studies.centres.about import About, Circle, InflectionLine

_POLE, _MOST = 2.6, 1.5
"""So many times larger the figure may become for the pole; and then for circles and centres of curvature."""
_LONGEST = 28.0
"""The longest velocity arrow [mm]."""
_FIELD = 17.0
"""How far the arrows of the field stand apart [mm]."""
_LIGHT = 0.5
"""The field's arrows are so much shorter than the scale says, not to cover one another."""
_AXIS = 38.0
"""Half of the pole tangent, and of the normal [mm]."""
_TOWARDS = 30.0
"""How far a ray goes to a pole that is not on the paper [mm]."""

HEADING: dict[Lang, str] = {"en": "Link {link} about its instant centre", "zh": "构件 {link} 绕瞬心的运动"}
INFLECTION: dict[Lang, str] = {"en": "inflection circle", "zh": "拐点圆"}
INFLECTION_LINE: dict[Lang, str] = {"en": "inflection circle (a line)", "zh": "拐点圆（退化为直线）"}
RETURN: dict[Lang, str] = {"en": "cuspidal circle", "zh": "尖点圆"}


def about_sheet(seen: About, *, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """Draw a link about its pole, to scale; what lies too far off is shown by its direction.

    Raises UnknownPaper.
    """
    method, plot = seen.found.method, seen.plot
    places = enlarged(enlarged(shown_places(method, plot), [seen.pole], _POLE), _wanted_places(seen), _MOST)
    on = place_for(method, [plot], places, paper, point_tables(seen, lang), [*link_words(seen, lang)])
    drawing = _LinkDrawing(seen, on, lang)
    under = chain(drawing.circles(), drawing.axes(), drawing.rays(), drawing.field())
    over = chain(drawing.velocities(), drawing.poles(), drawing.centres())
    figure = Figure.of(under) + on.mechanism(plot) + Figure.of(over)
    further: dict[Plane, float] = {"velocity": drawing.pace} if seen.moves else {}
    return on.sheet(plot, HEADING[lang].format(link=seen.called), figure, lang, further)


def _wanted_places(seen: About) -> Iterator[complex]:
    """What the figure would like to show beside the mechanism [m]."""
    if seen.acceleration_pole is not None:
        yield seen.acceleration_pole
    yield from (carried.centre for carried in seen.points.values())
    for round_about in (seen.inflection, seen.returning):
        if isinstance(round_about, Circle):
            yield from (round_about.centre + round_about.radius * side for side in (1, 1j, -1, -1j))


@frozen
class _LinkDrawing:
    """A link on a page: its parts, marks and labels in the order of painting."""

    seen: About
    on: SingleFigure
    lang: Lang

    @property
    def pace(self) -> float:
        """Scale of the velocity arrows [(m/s)/mm]."""
        fastest = max((abs(carried.velocity) for carried in self.seen.points.values()), default=0.0)
        fastest = fastest or abs(self.seen.base[1]) or abs(self.seen.omega) * self.seen.size
        return finest(complex(fastest, 0), complex(_LONGEST, _LONGEST))

    @property
    def name(self) -> Label:
        """The pole's letters, P₁₃."""
        return quantity_label("P", self.seen.found.name(FRAME, self.seen.link)[1:])

    def circles(self) -> Iterator[Entry]:
        """Inflection and return circle; the inflection pole W."""
        seen, window, room = self.seen, self.on.window, self.on.room
        if isinstance(seen.inflection, InflectionLine):
            foot, along = window(seen.inflection.through), window.turned(seen.inflection.direction)
            reach = abs(room.size) + abs(foot - room.middle)
            yield from self._named([foot - reach * along, foot + reach * along], "thin", INFLECTION_LINE)
        if not seen.diameter or seen.returning is None or not isinstance(seen.inflection, Circle):
            return
        pens: tuple[PenName, ...] = ("thin", "dashed")
        for drawn, pen, words in zip((seen.inflection, seen.returning), pens, (INFLECTION, RETURN), strict=True):
            places = circle(window(drawn.centre), drawn.radius / window.scale, room)
            yield from self._named(places, pen, words)
        yield from self._spot(seen.pole + seen.diameter, plain("W", italic=True), 0.6)

    def _named(self, places: list[Place], pen: PenName, words: Mapping[Lang, str]) -> Iterator[Entry]:
        strokes = list(clipped(places, self.on.room, pen))
        yield from strokes
        if strokes:
            longest = max(strokes, key=lambda stroke: len(stroke.places))
            count = len(longest.places)
            start, end = longest.places[max(count // 3 - 1, 0)], longest.places[max(count // 3, 1)]
            yield LabelRequest(
                plain(words[self.lang]), start, end if abs(end - start) > 8 else None, gap=0.6, spare=False
            )

    def axes(self) -> Iterator[Entry]:
        """Pole tangent t and normal n."""
        seen, pole = self.seen, self.seen.pole
        if seen.tangent is None or seen.normal is None or not self.on.room.holds(self.on.window(pole)):
            return
        for letter, direction in (("t", seen.tangent), ("n", seen.normal)):
            start, way = self.on.window(pole), self.on.window.turned(direction)
            for stroke in clipped([start - _AXIS * way, start + _AXIS * way], self.on.room, "centre"):
                yield stroke
                yield LabelRequest(plain(letter, italic=True), stroke.places[-1], gap=0.6, away=way)

    def rays(self) -> Iterator[Entry]:
        """From each point to the pole; towards a pole that is not on the paper, with an arrow."""
        seen, window, room = self.seen, self.on.window, self.on.room
        if not seen.moves:
            return
        here = not cmath.isinf(seen.pole) and room.holds(window(seen.pole))
        last: tuple[Place, complex] | None = None
        for carried in seen.points.values():
            at = window(carried.place)
            way = window.turned(seen.towards if cmath.isinf(seen.pole) else seen.pole - carried.place)
            if here:
                yield from clipped([at, window(seen.pole)], room, "construction")
            elif abs(way) > 0:
                way /= abs(way)
                for ray in clipped([at, at + way * _TOWARDS], room, "construction"):
                    last = ray.places[-1], way
                    yield ray
                    yield arrow_head(*last, None)
        if last is not None:
            label = (*self.name, *plain(" → ∞" if cmath.isinf(seen.pole) else self._far(seen.pole)))
            yield LabelRequest(label, last[0], gap=1.0, away=last[1])

    @staticmethod
    def _far(place: complex) -> str:
        return f" ({number(1e3 * place.real, 1e-6)}, {number(1e3 * place.imag, 1e-6)})"

    def field(self) -> Iterator[Entry]:
        """A light field of velocities over the link's plane, about its points and its pole."""
        seen, window, room = self.seen, self.on.window, self.on.room
        if not seen.moves:
            return
        places = [window(carried.place) for carried in seen.points.values()]
        if not cmath.isinf(seen.pole) and room.holds(window(seen.pole)):
            places.append(window(seen.pole))
        for at in _lattice(places, room):
            velocity = seen.carried(_back(self.on, at)).velocity
            arrow = window.turned(velocity / self.pace) * _LIGHT
            if 1.0 < abs(arrow) <= _FIELD and room.holds(at + arrow) and all(abs(at - p) > 5 for p in places):
                yield Stroke((at, at + arrow), "leader")
                yield from _head(at + arrow, arrow / abs(arrow))

    def velocities(self) -> Iterator[Entry]:
        """The velocity of each point, to the scale of velocities."""
        for name, carried in self.seen.points.items():
            arrow = self.on.window.turned(carried.velocity / self.pace)
            if abs(arrow) < 0.3:
                continue
            start = self.on.window(carried.place)
            along = arrow / abs(arrow)
            yield Stroke((start, start + arrow - 0.5 * along), "vector")
            yield arrow_head(start + arrow, along, None)
            yield LabelRequest(quantity_label("v", name), start, start + arrow, gap=0.7)

    def poles(self) -> Iterator[Entry]:
        """P and J; at one place they share a label."""
        seen = self.seen
        pole, other = seen.pole, seen.acceleration_pole
        label, letter = self.name, plain("J", italic=True)
        if other is not None and cmath.isfinite(pole) and abs(self.on.window(pole) - self.on.window(other)) < 0.2:
            label, other = joined([label, letter]), None
        if cmath.isfinite(pole):
            yield from self._spot(pole, label, 1.0, "paper")
        if other is not None:
            yield from self._spot(other, letter, 1.0, "paper")

    def centres(self) -> Iterator[Entry]:
        """Centres of curvature, and the radius from each point; a mark where one is a pivot already drawn."""
        seen, window, room = self.seen, self.on.window, self.on.room
        taken: list[complex] = []
        for name, carried in seen.points.items():
            if not cmath.isfinite(carried.centre) or abs(carried.centre - carried.place) < 1e-9 * seen.size:
                continue
            at = window(carried.centre)
            yield from clipped([window(carried.place), at], room, "dashed")
            if room.holds(at) and all(abs(at - other) > 0.3 for other in taken):
                taken.append(at)
                yield from self._spot(carried.centre, quantity_label("K", name), 0.6)

    def _spot(self, place: complex, label: Label, radius: float, fill: Fill = "ink") -> Iterator[Entry]:
        at = self.on.window(place)
        if self.on.room.holds(at):
            yield Disc(at, radius, "vector", fill)
            yield LabelRequest(label, at, gap=radius + 0.2)


def _back(on: SingleFigure, at: Place) -> complex:
    """From paper to SI."""
    return ((at - on.window.origin) * on.window.scale).conjugate()


def _lattice(places: list[Place], room: Room) -> Iterator[Place]:
    """Places on paper at even distances, about those given, inside the room."""
    if not places:
        return
    left, right = min(p.real for p in places) - _FIELD, max(p.real for p in places) + _FIELD
    top, bottom = min(p.imag for p in places) - _FIELD, max(p.imag for p in places) + _FIELD
    for x in np.arange(left, right + 1e-9, _FIELD):
        for y in np.arange(top, bottom + 1e-9, _FIELD):
            if room.holds(complex(x, y)):
                yield complex(x, y)


def _head(tip: Place, along: complex) -> Iterator[Mark]:
    """A small open arrow head."""
    side = 0.45j * along
    yield Stroke((tip - 1.3 * along + side, tip, tip - 1.3 * along - side), "leader")
