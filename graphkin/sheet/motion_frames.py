"""A mechanism and its polygons through its whole motion: one sheet a position, all at the same scales.

Where the first driver turns fully, once round; else as far as it gets to both sides, there and back. What would hop
from side to side from one position to the next is drawn as it suits all of them: the ground, and letters.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot, replay
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.planning import Method
from graphkin.planning.method import births
from graphkin.running import replay_all
from graphkin.running.path import along, stride
from graphkin.sheet.composed import HEADINGS
from graphkin.sheet.fit import Extent
from graphkin.sheet.fixed_link import drives
from graphkin.sheet.layout import Layout, lay_out, papers_for
from graphkin.sheet.lettering import joined, plain, point_label
from graphkin.sheet.marks import Text
from graphkin.sheet.mechanism_figure import moving_figure
from graphkin.sheet.page import Page, Panel, Sheet, heading
from graphkin.sheet.paper import LABEL
from graphkin.sheet.plain_mechanism import mechanism_places
from graphkin.sheet.polygons import PolygonFigure, polygon_figure
from graphkin.sheet.quiet_letters import lettered
from graphkin.sheet.scales import KEYS, TooLargeForPaper
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.titleblock import Strip, strip_height
from graphkin.sheet.wanted import LabelRequest
from graphkin.sheet.window import PLANES, Figure, Window, constructions
from graphkin.studies.sweeps import Course, course, prove

FRAMES = 60
_SHORT_OF_STOP = 1e-3
"""How near to a dead point the motion is shown [of the way between two of them]."""
_ASIDE_DEG, _ASIDE_PART = 0.05, 0.001
"""How far beside a change point its position is drawn, where the polygons would be 0/0."""
_ONE = 1e-6
"""Points of a polygon that are never farther apart are one [of its size]."""
_LARGE, _ENDLESS = 4.0, 12.0
"""A polygon so many times larger than half of them are is not drawn: near a dead point; where a turn has none, but a
special point goes far off."""
_WORTH = 2
"""A polygon is drawn as large as if it had so many times its letters: most of the time it is smaller than its room."""
TOO_LARGE: dict[Lang, str] = {"en": "too large to be drawn here", "zh": "此处图形过大，不画"}
BACK: dict[Lang, str] = {"en": "there and back; polygons: the way there", "zh": "往返运动；多边形按去程画"}


def motion_frames(
    method: Method, count: int = FRAMES, *, paper: str | None = None, lang: Lang = "en", only: Plane | None = None
) -> list[Sheet]:
    """The sheets, in the order of the motion from the drawn position on; after the last comes the first again.

    Raises UnknownPaper, NoSuchDriver, DeadPoint where the drawn position is one, and RoadsDiffer where the analysis
    does not confirm the positions.
    """
    replay_all(method)
    moved = course(method, ())
    prove(moved)
    times = _times(moved, count)
    plots = [_plot(method, moved, t) for t in times]
    frames = _Frames(method, plots, (only,) if only else PLANES, lang, bool(moved.path.stops) or not moved.angular)
    return list(frames.sheets(paper))


def _times(moved: Course, count: int) -> list[float]:
    """Where on the path the positions are, evenly."""
    path, sense = moved.path, -1.0 if moved.driver.rate < 0 else 1.0
    if moved.full_turn:
        return [sense * float(t) for t in np.arange(count) * (2 * np.pi / count)]
    short = _SHORT_OF_STOP * (path.last - path.first)
    low, high = path.first + short, path.last - short
    ends = [0.0, high, low, 0.0] if sense > 0 else [0.0, low, high, 0.0]
    way = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(ends)))])
    return [float(t) for t in np.interp(np.arange(count) * (way[-1] / count), way, ends)]


def _plot(method: Method, moved: Course, t: float) -> Plot:
    """The drawing at t, a little beside a change point."""
    aside = stride(method, moved.path.pace, _ASIDE_DEG, _ASIDE_PART)
    if any(abs(t - change.at) < aside for change in moved.path.changes):
        t += 2 * aside
    return replay(method.acceleration, replay(method.velocity, along(method, moved.path, t)))


@frozen
class _Frames:
    """The positions with what is drawn of each; `back`: the mechanism goes there and back."""

    method: Method
    plots: Sequence[Plot]
    planes: tuple[Plane, ...]
    lang: Lang
    back: bool

    def sheets(self, paper: str | None) -> Iterator[Sheet]:
        layout = self._layout(paper)
        windows = {plane: layout.window(plane, self._extents[plane]) for plane in self.planes}
        rooms = {plane: layout.rooms[plane].inset(1, 1, 1) for plane in self.planes}
        heads = {plane: heading(HEADINGS[self.lang][plane], plane, windows[plane].scale, layout.rooms[plane])
                 for plane in self.planes}  # fmt: skip
        drawn = {plane: lettered(self._figures(plane, windows[plane]), rooms[plane], heads[plane])
                 for plane in self.planes}  # fmt: skip
        foot = Strip(layout.strip)
        for k, plot in enumerate(self.plots):
            panels = []
            for plane in self.planes:
                figure = Figure(drawn[plane][k])
                if k not in self._shown[plane]:
                    figure = Figure([self._note(TOO_LARGE, heads[plane])])
                elif plane == "position" and self.back:
                    figure.marks.append(self._note(BACK, heads[plane]))
                panels.append(Panel(figure, windows[plane], rooms[plane], heads[plane], (), plane))
            yield Page(layout.paper, panels, self.method.mechanism, plot.facts.values, self.lang, foot).sheet()

    def _note(self, words: Mapping[Lang, str], head: Sequence[object]) -> Text:
        """Under a heading."""
        lowest = max((mark.at for mark in head if isinstance(mark, Text)), key=lambda at: at.imag)
        left = min(mark.at.real for mark in head if isinstance(mark, Text))
        return Text(plain(words[self.lang]), complex(left, lowest.imag + 5.5), LABEL)

    # --- how large ----------------------------------------------------------------------------

    @cached_property
    def _values(self) -> dict[Plane, list[list[complex]]]:
        """The points each plane shows, position by position, in SI units."""
        return {plane: [self._points(plane, plot) for plot in self.plots] for plane in self.planes}

    def _points(self, plane: Plane, plot: Plot) -> list[complex]:
        if plane == "position":
            return mechanism_places(self.method, plot)
        construction, points = constructions(self.method)[plane], plot.points(plane)
        return [complex(points[name]) for name in (construction.pole, *construction.nodes) if name in points]

    @cached_property
    def _shown(self) -> dict[Plane, set[int]]:
        """The positions at which a plane is drawn: the first, and all others but those at which it is endless."""
        found: dict[Plane, set[int]] = {}
        for plane, values in self._values.items():
            sizes = np.array([max((abs(v) for v in at), default=0.0) for at in values])
            usual = float(np.median(sizes[np.isfinite(sizes)]))
            most = np.inf if plane == "position" else usual * (_LARGE if self.back else _ENDLESS)
            fits = np.isfinite(sizes) & (sizes <= max(most, sizes[0]))
            found[plane] = set(np.flatnonzero(fits).tolist())
        return found

    @cached_property
    def _extents(self) -> dict[Plane, Extent]:
        return {plane: self._extent(plane) for plane in self.planes}

    def _extent(self, plane: Plane) -> Extent:
        """With the reach of the signs at each quarter of the way."""
        shown = sorted(self._shown[plane])
        places = [value for k in shown for value in self._values[plane][k]]
        spread = shown[:: max(1, len(shown) // 8)]

        def drawn(window: Window) -> Figure:
            figures = [self._figure(plane, window, k) for k in spread]
            return Figure([mark for figure in figures for mark in figure.marks], figures[0].wanted)

        found = Extent.of(places, drawn, self.method.mechanism.scales.get(KEYS[plane]), letters=9.0)
        return found if plane == "position" else replace(found, labels=_WORTH * found.labels)

    def _layout(self, paper: str | None) -> Layout:
        """A given scale at which the whole motion does not fit is not kept."""
        try:
            return lay_out(self._extents, strip_height, papers_for(paper))
        except TooLargeForPaper:
            free = {plane: replace(extent, given=None) for plane, extent in self._extents.items()}
            return lay_out(free, strip_height, papers_for(paper))

    # --- what is drawn ------------------------------------------------------------------------

    def _figures(self, plane: Plane, window: Window) -> list[Figure]:
        return [self._figure(plane, window, k) if k in self._shown[plane] else Figure() for k in range(len(self.plots))]

    def _figure(self, plane: Plane, window: Window, k: int) -> Figure:
        born = births(self.method, plane)
        if plane != "position":
            polygon = PolygonFigure(
                self.method.mechanism, constructions(self.method)[plane], self.plots[k], window, born
            )
            return Figure(polygon_figure(polygon).marks, self._letters(polygon, self._as_one[plane]))
        first, here, *others = (
            Skeleton(self.method.mechanism, plot, window, born)
            for plot in (self.plots[0], self.plots[k], *self.plots[:: max(1, len(self.plots) // 8)])
        )
        return moving_figure(here, self.method, others, drives(first if self._drives_stand else here))

    @cached_property
    def _as_one(self) -> dict[Plane, list[tuple[str, ...]]]:
        """The points of each polygon; those that never part are one, the pole and what is fixed first."""
        found: dict[Plane, list[tuple[str, ...]]] = {}
        for plane in self.planes:
            construction = constructions(self.method)[plane]
            nodes = dict.fromkeys((construction.pole, *construction.nodes))
            names = [name for name in nodes if name in self.plots[0].points(plane)]
            ways = {name: np.array([complex(plot.points(plane)[name]) for plot in self.plots]) for name in names}
            size = max((float(np.nanmax(np.abs(way))) for way in ways.values()), default=0.0)
            groups: dict[str, list[str]] = {}
            for name in names:
                alike = (one for one in groups if np.nanmax(np.abs(ways[one] - ways[name])) <= _ONE * size)
                groups.setdefault(next(alike, name), []).append(name)
            found[plane] = [tuple(group) for group in groups.values()]
        return found

    @staticmethod
    def _letters(polygon: PolygonFigure, groups: Sequence[tuple[str, ...]]) -> list[LabelRequest]:
        """A label for each point that bears a letter."""
        places = polygon.named
        middle = sum(polygon.points.values()) / max(1, len(polygon.points))
        named = [[name for name in group if name in places] for group in groups]
        at = {tuple(group): places[group[0]] for group in named if group}
        return [
            LabelRequest(joined([point_label(name) for name in group]), place, gap=0.5, away=place - middle)
            for group, place in at.items()
        ]

    @cached_property
    def _drives_stand(self) -> bool:
        """Whether all drivers turn or slide at the frame: then their arrows stand still, too."""
        owners = self.method.mechanism.owners
        return all(d.vector is not None and FRAME in owners[d.vector[0]] for d in self.method.drivers)
