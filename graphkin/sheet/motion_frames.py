"""A mechanism and its polygons through its whole motion: one sheet a position, all at the scales of most of them.

A polygon much larger than most is drawn a round number of times smaller, about the same pole, and says so.

Where the first driver turns fully, once round; else as far as it gets to both sides, there and back. What would hop
from side to side from one position to the next is drawn as it suits all of them: the ground. A letter goes about what
it names where it lies on the fewest lines and letters, on a short way; arrows are not lettered, as the letters at their
ends say as much. What is asked for stands under the headings with its running values.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache, cached_property
from itertools import pairwise, repeat

import numpy as np

from graphkin.base.boxes import xy
from graphkin.base.geometry import Array
from graphkin.base.rooms import Room
from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot, replay
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import EDGE, centre_of
from graphkin.planning import Method
from graphkin.planning.method import births
from graphkin.running import replay_all
from graphkin.running.path import along, stride
from graphkin.say.catalogue import say
from graphkin.sheet.fixed_link import drives, grounds
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.layout import Layout, lay_out
from graphkin.sheet.lettering import LABEL, Label, joined, plain, point_label, quantity_label, valued, width
from graphkin.sheet.marks import Mark, Place, Text
from graphkin.sheet.mechanism_figure import mechanism_figure, mechanism_places
from graphkin.sheet.obstacles import obstacles
from graphkin.sheet.page import Page, Panel, Sheet, heading
from graphkin.sheet.paper import KEYS, papers_for
from graphkin.sheet.polygons import PolygonFigure, polygon_figure
from graphkin.sheet.results import label_of
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.titleblock import PITCH, Strip
from graphkin.sheet.window import PLANES, Extent, Figure, Window
from graphkin.studies.sweeps import Course, asked, course, drawable, prove, quantities_at

FRAMES = 60
_ASIDE_DEG, _ASIDE_PART = 0.05, 0.001
"""The distance from a change point at which its position is drawn, where the polygons would be 0/0."""
_ROWS = 6  # so many values run along under a heading
_PLANE: dict[str, Plane] = {"rad/s": "velocity", "m/s": "velocity", "rad/s^2": "acceleration", "m/s^2": "acceleration"}
_NAMES = 4  # so many names bear points that are always in one place
_ONE = 6  # points of a polygon are one that are always the same in so many decimals of its size
_LARGE, _ENDLESS = 4.0, 12.0
"""A polygon so many times larger than half of them are is not drawn: near a dead point; where a turn has none, but a
special point goes far off."""
_USUAL, _SMALLER = 1.6, (1, 2, 5, 10)
"""Polygons up to so many times as large as half of them, and the first, have one scale; larger ones are drawn so many
times smaller."""
_WORTH = 4
"""A polygon is drawn as large as if it had so many times its letters: most of the time it is smaller than its room."""


def motion_frames(
    method: Method, count: int = FRAMES, *, paper: str | None = None, lang: Lang = "en", only: Plane | None = None
) -> list[Sheet]:
    """The sheets, in the order of the motion from the drawn position on; after the last comes the first again.

    Raises UnknownPaper, NoSuchDriver, DeadPoint where the drawn position is one, and RoadsDiffer where the analysis
    does not confirm the positions.
    """
    replay_all(method)
    once = course(method)
    moved = once.on if (turns := once.turns()) > 1 else once
    prove(moved)
    aside = stride(method, moved.path.pace, _ASIDE_DEG, _ASIDE_PART)
    times = [t + 2 * aside if any(abs(t - change.at) < aside for change in moved.path.changes) else t
             for t in moved.evenly(count, turns)]  # fmt: skip
    plots = [replay(method.acceleration, replay(method.velocity, along(method, moved.path, t))) for t in times]
    papers = [one for one in papers_for(paper) if one.width > one.height or paper]  # as screens are
    values = _running_values(moved, times, lang, turns)
    figures = [MotionFigure(method, plots, plane, lang, not turns, values.get(plane, ()))
               for plane in ((only,) if only else PLANES)]  # fmt: skip
    extents = {figure.plane: figure.extent(figure.smaller) for figure in figures}
    layout = lay_out(extents, Strip().height, papers, freely=True)
    panels = zip(*(figure.panels(layout, extents[figure.plane]) for figure in figures), strict=True)
    return [Page(layout.paper, each, method.mechanism, plot.facts.values, lang, Strip()).sheet()
            for plot, each in zip(plots, panels, strict=True)]  # fmt: skip


def _running_values(moved: Course, times: Sequence[float], lang: Lang, turns: int) -> dict[Plane, list[list[Label]]]:
    """Values of the driver and of what is asked: by plane a row a quantity, in it a label a position. Sizes, as in the
    polygons, with the sense of what turns."""
    machine, driver, t = moved.method.mechanism, moved.driver, np.array(times)
    of = machine.called(driver.link) if driver.kind == "angle" else machine.driver_title(driver, lang)
    letters = quantity_label("s" if driver.kind == "slide" else "φ", driver.name if driver.from_vector else of)
    unit, driven = EDGE[moved.unit], np.asarray(moved.value(t))
    driven = (driven % (math.tau * max(1, turns)) if moved.angular else driven) * unit.factor
    rows: dict[Plane, list[list[Label]]] = {"position": [[valued(letters, value, unit.after) for value in driven]]}
    names = (name for name in drawable(machine, asked(machine)) if centre_of(machine, name) is None)
    for series in quantities_at(moved, [*dict.fromkeys(names)], t).series:
        unit, values, letters = EDGE[series.unit], series.values, label_of(series.quantity)
        turning = series.unit.startswith("rad/")
        senses = [f" {say('sheet.sense', lang, which=int(v < 0))}" if turning and v else "" for v in values]
        sizes = (valued(letters, (abs(v) if turning else v) * unit.factor, unit.after) for v in values)
        row = [(*size, *plain(sense)) for size, sense in zip(sizes, senses, strict=True)]
        if row not in (every := rows.setdefault(_PLANE.get(series.unit, "position"), [])):
            every.append(row)
    return {plane: every[:_ROWS] for plane, every in rows.items()}


@frozen
class MotionFigure:
    """A plane at all positions; at any other one it is drawn to suit them. back: the mechanism goes there and back;
    values: rows of labels, one a position."""

    method: Method
    plots: Sequence[Plot]
    plane: Plane
    lang: Lang = "en"
    back: bool = False
    values: Sequence[Sequence[Label]] = ()

    def panels(self, layout: Layout, extent: Extent) -> Iterator[Panel]:
        """On paper at each position, with its heading, a note and the values."""
        (window, corners), room = layout.placed(self.plane, extent), layout.rooms[self.plane]
        windows = [replace(window, scale=window.scale * self.smaller.get(k, 1)) for k in range(len(self.plots))]
        corner, name, inner = dict(corners).get(0, 0j), say(f"sheet.plane {self.plane}", self.lang), room.inset(1, 1, 1)
        before = [[*heading(name, self.plane, each.printed, room)] for each in windows]
        for k, own in enumerate(before):
            own += (Text(label, corner + 1j * PITCH * (row + 0.75), LABEL) for row, label in enumerate(self._words(k)))
        figures = [self.figure(each, plot) if k in self.smaller else Figure()
                   for k, (each, plot) in enumerate(zip(windows, self.plots, strict=True))]  # fmt: skip
        for each, words, marks in zip(windows, before, lettered(figures, inner, before[0]), strict=True):
            yield Panel(Figure(marks), each, inner, tuple(words), self.plane)

    def _words(self, k: int) -> Iterator[Label]:
        """A note and the values of a position."""
        if (times := self.smaller.get(k)) is None:
            yield plain(say("sheet.too large", self.lang))
        elif times > 1:
            yield plain(say("sheet.smaller", self.lang, times=times))
        elif self.plane == "position" and self.back:
            yield plain(say("sheet.there and back", self.lang))
        yield from (row[k] for row in self.values)

    @cached_property
    def _names(self) -> list[str]:
        """The points of the polygon, the pole first."""
        polygon, there = self.method.construction(self.plane), self.plots[0].points(self.plane)
        return [name for name in dict.fromkeys((polygon.pole, *polygon.nodes)) if name in there]

    def _places(self, plot: Plot) -> list[complex]:
        """The points it shows at a position, in SI units."""
        if self.plane == "position":
            return mechanism_places(self.method, plot)
        points = plot.points(self.plane)
        return [complex(points[name]) for name in self._names]

    def fits(self, plot: Plot) -> bool:
        """True where it is drawn at a position: it is not endless there."""
        return bool(np.isfinite(size := self._reach(plot))) and size <= self._most

    def _reach(self, plot: Plot) -> float:
        """The distance of its farthest point from its origin at a position [SI]."""
        return max(map(abs, self._places(plot)), default=0.0)

    @cached_property
    def _most(self) -> float:
        """The size of the largest figure that is drawn [SI]."""
        sizes = np.array([self._reach(plot) for plot in self.plots])
        usual = float(np.median(sizes[np.isfinite(sizes)]))
        large = np.inf if self.plane == "position" else usual * (_LARGE if self.back else _ENDLESS)
        return max(large, float(sizes[0]))

    @cached_property
    def smaller(self) -> dict[int, int]:
        """The divisor of its scale at each position at which it is not endless."""
        sizes = {k: self._reach(plot) for k, plot in enumerate(self.plots) if self.fits(plot)}
        usual = np.inf if self.plane == "position" else max(_USUAL * float(np.median([*sizes.values()])), sizes[0])
        return {k: next((times for times in _SMALLER if size <= times * usual), _SMALLER[-1])
                for k, size in sizes.items()}  # fmt: skip

    def extent(self, smaller: Mapping[int, int]) -> Extent:
        """Of positions, each drawn so many times smaller; with the reach of the signs at each quarter of the way."""
        places = [value / times for k, times in smaller.items() for value in self._places(self.plots[k])]
        spread = [*smaller][:: max(1, len(smaller) // 8)]

        def drawn(window: Window) -> Figure:
            figures = [self.figure(replace(window, scale=window.scale * smaller[k]), self.plots[k]) for k in spread]
            return Figure([mark for figure in figures for mark in figure.marks], figures[0].wanted)

        words = [[*self._words(k)] for k in range(len(self.plots))]
        wide = max((width(label, LABEL) for labels in words for label in labels), default=0.0)
        size = complex(wide, PITCH * max(map(len, words)))
        extent = Extent.of(places, drawn, self.method.mechanism.scales.get(KEYS[self.plane]), letters=9.0)
        extent = replace(extent, blocks=(((size,), False),) if wide else ())
        return extent if self.plane == "position" else replace(extent, labels=_WORTH * extent.labels)

    def figure(self, window: Window, plot: Plot) -> Figure:
        """At a position, and the letters it wants."""
        born, machine = births(self.method, self.plane), self.method.mechanism
        if self.plane != "position":
            polygon = PolygonFigure(machine, self.method.construction(self.plane), plot, window, born)
            places, middle = polygon.named, sum(polygon.points.values()) / max(1, len(polygon.points))
            named = [[name for name in group if name in places] for group in self.as_one]
            words = [[*map(point_label, group[:_NAMES]), *[plain("…")] * (len(group) > _NAMES)] for group in named]
            letters = [(joined(each), places[group[0]]) for each, group in zip(words, named, strict=True) if group]
            wanted = [LabelRequest(label, at, gap=0.5, away=at - middle) for label, at in letters]
            return Figure(polygon_figure(polygon).marks, wanted)
        here, (first, ground), drivers = Skeleton(machine, plot, window, born), self._ground(window), machine.drivers
        stand = all(driver.vector is not None and FRAME in machine.owners[driver.vector[0]] for driver in drivers)
        driving = drives(first if stand else here, self.method)  # arrows at the frame stand
        return mechanism_figure(here, self.method, None, ground, driving)

    @cached_property
    def _ground(self) -> Callable[[Window], tuple[Skeleton, Figure]]:
        """The first position drawn through a window, and what stands still all along the motion."""
        born, some = births(self.method, "position"), self.plots[:: max(1, len(self.plots) // 24)]

        def drawn(window: Window) -> tuple[Skeleton, Figure]:
            every = [Skeleton(self.method.mechanism, plot, window, born) for plot in some]
            return every[0], grounds(*every)

        return cache(drawn)

    @cached_property
    def as_one(self) -> list[tuple[str, ...]]:
        """The points of the polygon; those that never part are one, the pole and what is fixed first."""
        paths, groups = np.nan_to_num(np.array([self._places(plot) for plot in self.plots]).T), dict[bytes, list[str]]()
        size = abs(paths).max(initial=0.0) or 1.0
        for name, path in zip(self._names, np.round(paths / size, _ONE), strict=True):
            groups.setdefault((path + 0.0).tobytes(), []).append(name)  # 0 for -0
        return [*map(tuple, groups.values())]


# --- letters that go along without hopping ----------------------------------------------------------------------------

_LIKING = 0.1  # the weight of what a place costs by itself, against the things that a letter lies on there
_CLEAR, _APART = 0.4, 1.0  # the room that letters keep from lines, and from letters beside them [mm]
_SELDOM = 0.1
"""Letters that points share for a moment, where they lie on one another, flash up: those on fewer of the figures."""
_WAY = 0.15  # the cost of a letter's way about what it names [1/mm]
_OUTSIDE = 6.0  # leaving its room counts like lying on so many lines


def lettered(
    figures: Sequence[Figure], room: Room, off: Sequence[Mark] = (), step: int | None = None
) -> list[list[Mark]]:
    """The marks of each figure with their letters, of figures that follow one another; `off`: what letters keep off,
    too; step: of figures in any order, a letter is on one side of its point on all, which suits each so-many-th."""
    looked_at = range(0, len(figures), step or 1)
    marks: list[list[Mark]] = [list(figure.marks) for figure in figures]
    drawn = {k: obstacles([*figures[k].marks, *off]) for k in looked_at}
    letters: list[list[Place]] = [[] for _ in figures]
    halves: list[list[complex]] = [[] for _ in figures]
    every: dict[tuple[Label, bool], dict[int, LabelRequest]] = {}
    for k, figure in enumerate(figures):
        for want in (want for want in figure.wanted if not want.of):
            every.setdefault((want.label, want.end is None), {}).setdefault(k, want)
    often = (wants for wants in every.values() if len(wants) >= _SELDOM * len(figures))
    for wants in sorted(often, key=len, reverse=True):  # the most frequent come first, seldom ones not at all
        half, clear = next(iter(wants.values())).half, complex(_CLEAR, _CLEAR)
        sides, costs = list[Array](), list[Array]()
        nearby = {k: want.near(half, wide=True) for k, want in wants.items()}
        for k in (k for k in wants if k in looked_at):  # the number of things on which each of the places lies
            near = nearby[k]
            low, high = xy(near.middle - half - clear), xy(near.middle + half + clear)
            cost = _LIKING * near.cost + drawn[k].around(low, high, (0.0,))[0]
            outside = ([room.left, room.top] > low.T).any(axis=1) | ([room.right, room.bottom] < high.T).any(axis=1)
            costs.append(cost + _on_others(near.middle, half, letters[k], halves[k]).sum(axis=1) + _OUTSIDE * outside)
            sides.append(near.middle - wants[k].place)
        alike = int(np.sum(costs, axis=0).argmin()) if step and costs else 0
        for (k, want), best in zip(wants.items(), repeat(alike) if step else _gliding(sides, costs), strict=False):
            row = nearby[k].middle
            if not _on_others(row[best : best + 1], half, letters[k], halves[k]).any():  # hidden while it would be
                marks[k] += want.about(complex(row[best]))
                letters[k].append(complex(row[best]))
                halves[k].append(half)
    return marks


def _on_others(middles: Array, half: complex, letters: Sequence[Place], halves: Sequence[complex]) -> Array:
    """True where a letter in each of the middles lies on others (n, others)."""
    off, reach = middles[:, None] - np.array(letters, dtype=complex), np.array(halves, dtype=complex) + half
    return np.asarray((abs(off.real) < reach.real + _APART) & (abs(off.imag) < reach.imag + _CLEAR))


def _gliding(sides: Sequence[Array], costs: Sequence[Array]) -> list[int]:
    """The place of a letter on each figure, round and round: cheap, with little way to the next; sides: (n,) [mm]."""
    rounds = [*range(len(costs))] * 2
    total, before = costs[0], list[Array]()
    for last, k in pairwise(rounds):
        ways = total + _WAY * abs(sides[k][:, None] - sides[last])
        before.append(ways.argmin(axis=1))
        total = ways.min(axis=1) + costs[k]
    chosen = [int(total.argmin())]
    for cheapest in reversed(before[len(costs) :]):
        chosen.append(int(cheapest[chosen[-1]]))
    return chosen[::-1]
