"""Bobillier's construction drawn over the mechanism, whole or step by step."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

from graphkin.base.value import frozen
from graphkin.construction.drafting import INFINITE, LineStep, PointStep, drawn_through
from graphkin.errors import Lang
from graphkin.say.centre_about import bobillier_words
from graphkin.sheet.curves import clipped
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, plain, point_label, quantity_label
from graphkin.sheet.marks import Disc, Mark, Place
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet, step_sheets
from graphkin.sheet.paper import PenName
from graphkin.sheet.single_figure import SingleFigure, place_for
from graphkin.sheet.window import Entry, Figure, enlarged
from graphkin.studies.centres.about import About
from graphkin.studies.centres.about_bobillier import Bobillier

_MOST = 2.6
"""So many times larger the figure may become for what the construction gives."""
_BEYOND = 7.0
"""How far a line goes on past its points [mm]."""
_PENS: dict[str, PenName] = {"axis": "centre", "axis c": "centre"}

HEADING: dict[Lang, str] = {
    "en": "Centre of curvature of the path of {point} of link {link} (Bobillier)",
    "zh": "构件 {link} 上点 {point} 轨迹的曲率中心（波比利尔作图法）",
}


def bobillier_sheet(seen: About, drawn: Bobillier, *, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """The whole construction over the mechanism. Raises UnknownPaper."""
    method, plot = seen.found.method, seen.plot
    on = place_for(method, [plot], _places(seen, drawn), paper, told=bobillier_words(drawn, lang))
    drawing = _BobillierDrawing(drawn, on, drawn.point not in method.mechanism.points)
    figure = Figure.of(drawing.lines()) + on.mechanism(plot) + Figure.of(drawing.points())
    return on.sheet(plot, HEADING[lang].format(point=drawn.point, link=seen.called), figure, lang)


def bobillier_step_sheets(
    seen: About, drawn: Bobillier, *, paper: str | None = None, lang: Lang = "en"
) -> Iterator[Sheet]:
    """One sheet a step, its newest marks emphasised."""
    whole = bobillier_sheet(seen, drawn, paper=paper, lang=lang)
    yield from step_sheets(whole, range(1, len([*drawn.construction.steps]) + 1))


def _places(seen: About, drawn: Bobillier) -> list[complex]:
    names = (drawn.point, drawn.pole, drawn.answer, *drawn.crossings)
    places = [place for name in names if cmath.isfinite(place := drawn.board.at(name))]
    return enlarged(shown_places(seen.found.method, seen.plot), places, _MOST)


@frozen
class _BobillierDrawing:
    """The construction on a page. new: its point is a place of the plane, no point of the mechanism."""

    drawn: Bobillier
    on: SingleFigure
    new: bool

    def lines(self) -> Iterator[Mark]:
        """Every line, past the points on it; thin, the axes as centre lines."""
        for number, step in enumerate(self.drawn.construction.steps, start=1):
            if isinstance(step, LineStep):
                yield from clipped(self._ends(step), self.on.room, _PENS.get(step.name, "construction"), number)

    def _ends(self, line: LineStep) -> list[Place]:
        """From the first to the last of the points on a line, and a little more; towards one at infinity, farther.

        Nothing for the line at infinity.
        """
        start, way = self.drawn.board.line(line.name)
        if not abs(start) * INFINITE < 1:
            return []
        along = self.on.window.turned(way)
        names = [*drawn_through(line), *self.drawn.construction.met_on(line.name)]
        places = [self.on.window(place) for name in names if cmath.isfinite(place := self.drawn.board.at(name))]
        far = len(places) < len(names)
        reach = [((place - places[0]) * along.conjugate()).real for place in places]
        more = 8 * _BEYOND if far or len(places) < 2 else _BEYOND
        return [places[0] + along * (max(reach) + more), places[0] + along * (min(reach) - more)]

    def points(self) -> Iterator[Entry]:
        """What is found, and the point itself where the mechanism does not show it."""
        entries: list[tuple[str, int | None]] = [(self.drawn.point, None)] if self.new else []
        numbered = enumerate(self.drawn.construction.steps, start=1)
        entries += [(step.name, number) for number, step in numbered if isinstance(step, PointStep)]
        for name, number in entries:
            place = self.drawn.board.at(name)
            if cmath.isfinite(place) and self.on.room.holds(at := self.on.window(place)):
                yield Disc(at, 0.6, "vector", "ink", step=number)
                yield LabelRequest(self._label(name), at, gap=0.9, step=number)

    def _label(self, name: str) -> Label:
        if name == self.drawn.answer:
            return quantity_label("K", self.drawn.point)
        if name == self.drawn.crossings[1]:
            return quantity_label("Q", self.drawn.point)
        return point_label(name) if name == self.drawn.point else plain(name.replace("'", "′"), italic=True)
