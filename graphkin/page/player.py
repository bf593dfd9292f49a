"""The page that plays: mechanisms with their polygons, dragged along and drawn step by step.

Its data of a mechanism: `stage` (its elements), `axes` (drivers, their knots), `tracks` and `masks` (see `tracks`),
`planes` with rows of marks (see `rows`), `steps` (see `spoken`), `values`. A number in a row is a number, or `[k]` for
the k-th track.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from html import escape
from itertools import product
from pathlib import Path
from typing import assert_never

import numpy as np

from graphkin.api.drawing import Drawing, Source, method_of
from graphkin.base.geometry import dot, number
from graphkin.base.value import bulky
from graphkin.construction import Plane, Plot
from graphkin.errors import GraphkinError, Lang, Where
from graphkin.errors.arguments import checked
from graphkin.model.mechanism import Driver
from graphkin.model.pairs import RollingContact
from graphkin.model.quantities import EDGE, Quantity, centre_of, driven, named
from graphkin.outputs.files import UnknownEnding
from graphkin.outputs.paint import Colours
from graphkin.page import writer
from graphkin.page.diagrams import Frame, diagram, frame
from graphkin.page.elements import signs_of
from graphkin.page.figures import layer_of
from graphkin.page.knots import PageKnots, cells_shown, knots_along, page_knots
from graphkin.page.layers import MovingLayers, layers, moving
from graphkin.page.quiz import quiz
from graphkin.page.reach import Reach
from graphkin.page.rows import MarkTrack, rows
from graphkin.page.spoken import StepWords, spoken_steps, unfolded
from graphkin.page.stage import (
    PlayerElements,
    driver,
    figure,
    kind_of,
    mark_element,
    overlay_drawing,
    page_head,
    result,
)
from graphkin.page.tracks import OF_GRID, QUANTUM, Tracks
from graphkin.planning import Method
from graphkin.planning.needed import without_aids
from graphkin.proof.readings import readings
from graphkin.running import replay_all
from graphkin.running.path import Event
from graphkin.say.catalogue import LANGUAGES, for_scripts
from graphkin.say.sweeps import change_line, stop_line
from graphkin.sheet.lettering import vector_label
from graphkin.sheet.marks import ArcMark, Disc, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.page import Layer
from graphkin.sheet.paper import written
from graphkin.sheet.results import label_of
from graphkin.sheet.window import PLANES
from graphkin.studies.sweeps import Course, asked, drawable

_WORD_KNOTS = 16  # along each of several drivers
_TOLD = 120  # places of a turn, or between the ends of a way, at which sentences are told
Data = dict[str, object]


def page_of(every: Sequence[Data], lang: Lang) -> str:
    """The page of mechanisms that are made."""
    titles = {str(each["name"]): title for each in every if isinstance(title := each["title"], dict)}
    words = for_scripts("page") | for_scripts("quiz") | for_scripts("layers")
    return writer.page(
        " · ".join(title[lang] for title in titles.values()), lang, scripts=["player"],
        styles=["player", "layers", "quiz"], data={"words": words, "mechanisms": list(every)}, body=page_head(titles),
    )  # fmt: skip


def played(method: Method, values: Sequence[float] | None = None) -> Data:
    """The data of one mechanism, shown first at driver values [rad, m], or as its file has it. Raises what proving
    raises."""
    method = without_aids(method)
    knots = page_knots(Reach.of(method))
    start = [float(value) for value in method.facts(None).values] if values is None else [*values]
    tracks = Tracks([], [], QUANTUM if len(knots.axes) == 1 else OF_GRID)
    return _Played(knots, tracks, start, PlayerElements([], [], [], [], [])).data()


@bulky
class _Played:
    knots: PageKnots
    tracks: Tracks
    start: Sequence[float]
    stage: PlayerElements

    @property
    def method(self) -> Method:
        return self.knots.reach.method

    def data(self) -> Data:
        machine, figures = self.method.mechanism, self.knots.figures
        overlays = self._overlays()
        planes = [self._plane(plane, overlays) for plane in PLANES]
        axes = [self._axis(k) for k in range(len(self.knots.axes))]
        steps, words = self._steps()
        values = [*self._values()]
        questions = quiz(self.method, replay_all(self.method), figures.scales)
        return {
            "name": machine.name, "title": {lang: machine.headline(lang) for lang in LANGUAGES}, "axes": axes,
            "planes": planes, "wordKnots": words, "steps": steps, "values": values, "quiz": questions,
            "overlays": overlays and {kind: [*map(moving, overlays[kind])] for kind in ("centres", "centrodes")},
            "stage": self.stage.html(overlays, questions), "tracks": self.tracks.texts, "masks": self.tracks.masks,
        }  # fmt: skip

    def _overlays(self) -> MovingLayers | None:
        """The layers over the motion of one driver."""
        reach, figures = self.knots.reach, self.knots.figures
        if len(reach.axes) > 1:
            return None
        (course,), (axis,) = reach.courses, self.knots.axes
        t = np.array([course.at(reach.values([float(u)])[0]) for u in axis.u])
        return layers(course, t, figures.window("position"), figures.room("position"), self.tracks)

    # --- drivers ----------------------------------------------------------------------------------

    def _axis(self, k: int) -> Data:
        axis, course, knots = self.knots.reach.axes[k], self.knots.reach.courses[k], self.knots.axes[k]
        unit = EDGE[driven(axis.driver.kind == "slide")]
        events = [{"value": float(course.value(event.at).real), **line} for event, line in _events(course)]
        ends = axis.reached[0] * unit.factor, axis.reached[1] * unit.factor
        ticks = [unit.factor * float(course.value(event.at).real) for event, _ in _events(course)]
        self.stage.bars.append(driver(k, axis.driver.name, unit.sign, ends, ticks))
        data: Data = {
            "name": axis.driver.name, "unit": unit.sign, "factor": unit.factor, "low": axis.low, "high": axis.high,
            "wave": axis.wave, "ends": axis.reached, "round": axis.round, "u": [round(float(u), 9) for u in knots.u],
            "period": knots.period, "start": self.start[k], "rate": axis.driver.rate, "events": events,
        }  # fmt: skip
        if handle := self._handle(axis.driver):
            window = self.knots.figures.window("position")
            places = [window(complex(plot.position[handle])) if plot is not None else complex("nan+nanj")
                      for plot in self.knots.plots]  # fmt: skip
            data["handle"] = [self.tracks.place(np.array([getattr(at, side) for at in places]))
                              for side in ("real", "imag")]  # fmt: skip
        return data

    def _handle(self, driver: Driver) -> str:
        """The point that is dragged; "" for a wheel, which has none."""
        if driver.vector is not None:
            return driver.vector[1]
        machine = self.method.mechanism
        slid = {slide.name: slide.point for slide in machine.slides}
        return (slid | {roll.name: roll.centre for roll in machine.of(RollingContact)}).get(driver.link, "")

    # --- figures ----------------------------------------------------------------------------------

    def _plane(self, plane: Plane, overlays: MovingLayers | None) -> Data:
        figures, knots, colours = self.knots.figures, self.knots, Colours("accent", False)
        window, room, layer = figures.window(plane), figures.room(plane), Layer("mechanism", (), plane)
        in_a_row = len(knots.axes) == 1
        every = [*rows(figures.lettered(plane, knots.drawn(plane), in_a_row), leaps=in_a_row)]
        marks = [mark_element(row, dict(colours.paint(layer, row.mark))) for row in every]
        self.stage.switched.extend(map(layer_of, (row.mark for row in every)))
        over = overlay_drawing(overlays) if overlays and plane == "position" else ""
        self.stage.figures.append(figure(plane, window.scale, room.size, written(plane, window.scale), [*marks, over]))
        data: Data = {
            "plane": plane, "scale": window.scale, "rows": [*map(self._row, every)],
            "width": round(room.size.real, 3), "height": round(room.size.imag, 3),
            "origin": [round(window.origin.real, 4), round(window.origin.imag, 4)],
        }  # fmt: skip
        if len(knots.axes) > 1:
            data["cells"] = self.tracks.mask(cells_shown(knots, plane))
        return data | ({"mask": mask} if (mask := self.tracks.mask(knots.shown[plane])) is not None else {})

    def _row(self, row: MarkTrack) -> Data:
        mark = row.mark
        data: Data = {"kind": kind_of(row), "numbers": [self.tracks.place(column) for column in row.numbers.T]}
        more = {"step": mark.step, "mask": self.tracks.mask(row.there)}
        data |= {key: value for key, value in more.items() if value is not None}
        match mark:
            case Stroke() if row.form:
                at, end = row.form[row.base[0]], row.form[row.base[1]]
                data |= {"base": [at.real, at.imag, end.real, end.imag]}
            case Stroke():
                data |= {"closed": True} if mark.closed else {}
            case ArcMark():
                data["flags"] = f"{int(abs(mark.sweep) > np.pi)} {int(mark.sweep > 0)}"
            case VectorMark():
                data["sign"] = signs_of(vector_label(mark.name))
            case PointMark() | Text() | Disc():
                pass
            case _:
                assert_never(mark)
        return data

    # --- words and values -------------------------------------------------------------------------

    def _steps(self) -> tuple[list[Data], list[list[float]]]:
        """The steps, and the knots at which they are told."""
        axes = self.knots.reach.axes
        counts = [_TOLD + (not axes[0].round)] if len(axes) == 1 else [_WORD_KNOTS] * len(axes)
        us = [[*map(float, knots_along(self.knots.reach, *each).u)] for each in enumerate(counts)]
        known = dict(zip(self.knots.places, self.knots.plots, strict=True))
        plots = [known[at] if at in known else self.knots.reach.plot(at) for at in product(*us)]
        steps = spoken_steps(StepWords(self.method, self.knots.figures.scales), plots, self.tracks, len(axes) == 1)
        return steps, [[round(u, 9) for u in each] for each in us]

    def _values(self) -> Iterator[Data]:
        """The quantities that are asked for, or that a sweep shows."""
        machine = self.method.mechanism
        for name in drawable(machine, asked(machine)):
            if centre_of(machine, name) is not None:
                continue
            quantity = named(machine, name, Where("page"))
            unit = EDGE[quantity.unit]
            column = np.array([self._value(plot, quantity) for plot in self.knots.plots]) * unit.factor
            if np.isnan(column).all():
                continue
            turning = quantity.unit == "rad"
            rise = self._unwound(column) if turning and len(self.knots.axes) == 1 else 0.0
            sizes = unfolded(column) if len(self.knots.axes) == 1 else column
            data: Data = {"name": name, "unit": unit.sign, "value": self.tracks.fine(sizes)}
            data |= {"turn": 360} if turning and len(self.knots.axes) > 1 else {}
            data |= {"size": True} if np.nanmin(sizes) < 0 <= np.nanmin(column) else {}
            mask = self.tracks.mask(~np.isnan(column))
            grid, data["diagram"] = self._frame(sizes, rise, unit.sign, bool(data.get("size")))
            self.stage.results.append(result(name, label_of(quantity)))
            self.stage.diagrams.append(diagram(name, label_of(quantity), grid))
            yield data | ({"rise": rise} if rise else {}) | ({"mask": mask} if mask is not None else {})

    def _frame(self, values: np.ndarray, rise: float, unit: str, sizes: bool) -> tuple[str, Frame]:
        """The frame of a diagram over the first driver."""
        knots, axis = self.knots.axes[0], self.knots.reach.axes[0]
        along = EDGE[driven(axis.driver.kind == "slide")]
        ends = axis.reached[0] * along.factor, axis.reached[1] * along.factor
        whole = values + rise * (knots.u - knots.u[0]) / knots.period if rise else values
        if rise:  # what is drawn goes on to the end of the turn
            whole = np.append(whole, whole[0] + rise)
        return frame(np.abs(whole) if sizes else whole, unit, ends, along.sign, len(self.knots.axes) > 1)

    def _unwound(self, column: np.ndarray) -> float:
        """Angles [deg] that go on past a full turn, without what they rise by each time the driver comes round."""
        held, axis = ~np.isnan(column), self.knots.axes[0]
        column[held] = np.unwrap(column[held], period=360.0)
        if not axis.period:
            return 0.0
        rise = 360.0 * round(float(column[held][-1] - column[held][0]) / 360.0)
        column -= rise * (axis.u - axis.u[0]) / axis.period
        return rise

    def _value(self, plot: Plot | None, quantity: Quantity) -> float:
        if plot is None:
            return float("nan")
        try:
            answer = quantity.answer(readings(self.method, plot))
        except GraphkinError:
            return float("nan")
        value = float(answer.value.real)
        if quantity.along is not None and answer.vector is not None:  # a guide, along which it has a sign
            value = float(dot(quantity.along, answer.vector))
        return value if np.isfinite(value) else float("nan")


def _events(course: Course) -> Iterator[tuple[Event, Mapping[Lang, str]]]:
    for stop in course.stops:
        yield stop, {lang: stop_line(course, stop, lang) for lang in LANGUAGES}
    for change in course.changes:
        yield change, {lang: change_line(course, change, lang) for lang in LANGUAGES}


# --- as programs ask for it --------------------------------------------------------------------

_HIGH = 820  # of the frame in a notebook [px]


@bulky
class SavedPage:
    """A page: `save("x.html")`; `text` is the same for a program; a notebook shows it."""

    text: str

    @checked
    def save(self, path: str | Path, *, force: bool = False) -> Path:
        """Write it as .html; force: even over a file of another's."""
        file = Path(path)
        if file.suffix.lower() != ".html":
            raise UnknownEnding(str(file), (".html",))
        writer.write(file, self.text, force)
        return file

    def _repr_html_(self) -> str:
        style = f"width:100%;height:{_HIGH}px;border:0"
        return f'<iframe style="{style}" title="graphkin" srcdoc="{escape(self.text)}"></iframe>'


def play(*mechanisms: Source | Drawing | Method, lang: Lang = "en") -> SavedPage:
    """Mechanisms that play in a browser: drag the crank, the polygons follow. Several make a lecture; a drawing begins
    at its position."""
    return SavedPage(page_of([*map(_played, mechanisms)], lang))


def _played(mechanism: Source | Drawing | Method) -> Data:
    if isinstance(mechanism, Drawing):
        return played(mechanism.method, [*map(number, mechanism.plot.facts.values)])
    return played(method_of(mechanism))
