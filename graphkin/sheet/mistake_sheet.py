"""The right drawing, and beside it what mistakes make of it, at one scale; a student's own drawing over both.

    versions (`Version`) of a plane --> Pictures in a row, a row a plane --> Page on a paper cut to them

What is laid off or directed otherwise is drawn thick in both; the right drawing is thin. A picture that must not give
the answer away has the wrong drawing alone, and tells no scale.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from graphkin.base.geometry import place
from graphkin.base.value import frozen
from graphkin.construction import Construction, Plane, Plot
from graphkin.errors import Lang
from graphkin.marking.consequences import DrawingComparison
from graphkin.planning import Method
from graphkin.say.catalogue import say
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.layout import HEAD
from graphkin.sheet.lettering import joined, plain, point_label
from graphkin.sheet.marks import Disc, Mark, PointMark, Stroke, VectorMark
from graphkin.sheet.mechanism_figure import plain_mechanism, shown_places
from graphkin.sheet.page import HEADINGS, Page, Panel, Sheet, heading
from graphkin.sheet.paper import Paper, Room
from graphkin.sheet.polygons import PolygonFigure, polygon_figure
from graphkin.sheet.single_figure import Caption, Picture
from graphkin.sheet.window import PLANES, Extent, Figure, Window, constructions, enlarged

Own = Mapping[Plane, Mapping[str, complex]]
"""A student's drawing as it was measured: points of each plane by their letters, SI, from any of them."""

_WIDE, _HIGH = 92.0, 84.0
"""Of the room for one of two figures side by side, with its heading and its caption, at most [mm]."""
_CROWDED, _LARGE = 22, 2.0
"""Figures with more labels than this leave out those that others tell, too; with more still they stand under one
another, in rooms so many times as wide and high."""
_FOOT = 7.0
_SMALL = 14.0  # a figure that comes out smaller beside another has a scale of its own [mm]
_OFF = 2.5  # a point of the student's that lies farther off than this bears its letter [mm]
_RING = 0.9  # radius of the circles about the student's points [mm]
_FAR = 2.0  # points of the student's that would make the figure more than so many times as large are not drawn
_OTHERWISE = 1  # the step that what is drawn otherwise is marked with, until it is emphasised


def mistake_sheet(
    method: Method, plot: Plot, *, found: DrawingComparison | None = None, own: Own | None = None, answer: bool = True,
    lang: Lang = "en",
) -> Sheet | None:  # fmt: skip
    """The planes that mistakes change, and those that a student has drawn; None where there is nothing to show.

    plot    the right drawing
    found   what mistakes draw otherwise; the right drawing alone where left out
    own     the student's drawing, laid over with its pole on the pole
    answer  whether the right drawing may be shown: without it, the drawing with the mistakes alone
    """
    panels, top = list[Panel](), 0.0
    for plane in PLANES:
        if row := [*_versions(method, plot, plane, found, own or {}, answer)]:
            panels += _row(row, top, answer, lang)
            top = panels[-1].room.bottom + _FOOT
    if not panels:
        return None
    paper = Paper("figure", max(panel.room.right for panel in panels) + 1, top, 0.0)
    page = Page(paper, panels, method.mechanism, plot.facts.values, lang, title=say("pictures.title", lang))
    return page.sheet().upto(_OTHERWISE).redrawn(lambda mark: replace(mark, step=None))


@frozen
class Version:
    """A plane as it is drawn by somebody.

    name    its name in the catalogue, to be said under it
    thin    only to be compared with
    arrows, images   drawn otherwise, as in `Beside`
    own     the student's points, from the pole
    """

    method: Method
    plane: Plane
    plot: Plot
    name: str
    thin: bool = False
    arrows: frozenset[frozenset[str]] = frozenset()
    images: frozenset[str] = frozenset()
    own: Mapping[str, complex] | None = None

    @property
    def construction(self) -> Construction:
        return constructions(self.method)[self.plane]

    def places(self) -> list[complex]:
        """The places that it shows, SI."""
        if self.plane == "position":
            return shown_places(self.method, self.plot)
        return [*self._there.values(), *self._own.values()]

    @property
    def _there(self) -> Mapping[str, complex]:
        """The polygon's points."""
        names = {self.construction.pole, *self.construction.nodes}
        return {name: place(v) for name, v in self.plot.points(self.plane).items() if name in names}

    def figure(self, window: Window) -> Figure:
        if self.plane == "position":
            figure = plain_mechanism(self.method, self.plot, window).numbered(None)
            return Figure([self._penned(mark) for mark in figure.marks], figure.wanted)
        figure = polygon_figure(self._polygon(self.plot, window))
        crowded = len(figure.wanted) > _CROWDED
        labels = [label for label in figure.wanted if not (crowded and label.spare)]
        return Figure([self._penned(mark) for mark in figure.marks], labels) + self._over(window)

    def _polygon(self, plot: Plot, window: Window) -> PolygonFigure:
        return PolygonFigure(self.method.mechanism, self.construction, plot, window, {})

    def _penned(self, mark: Mark) -> Mark:
        """Thick where it is drawn otherwise; thin where it is only compared with."""
        otherwise = False
        match mark:
            case VectorMark(tail=tail, head=head):
                ends = frozenset((tail, head))
                otherwise = ends in self.arrows or (self.construction.pole in ends and bool(ends & self.images))
            case PointMark(name=name):
                otherwise = name in self.images
            case Stroke(shows=shows) if shows is not None:
                otherwise = bool(self.images.intersection(shows.points))
        if otherwise:
            return replace(mark, step=_OTHERWISE)
        if self.thin and isinstance(mark, VectorMark | Stroke) and mark.pen in ("vector", "visible"):
            return replace(mark, pen="thin")
        return mark

    @property
    def _own(self) -> Mapping[str, complex]:
        """The student's points where this version has its own: the pole upon the pole, or the first upon the first."""
        there = self._there
        own = {name: value for name, value in (self.own or {}).items() if name in there}
        if not own:
            return {}
        first = self.construction.pole if self.construction.pole in own else next(iter(own))
        laid = {name: there[first] + value - own[first] for name, value in own.items()}
        near = {*enlarged([*there.values()], laid.values(), _FAR)}
        return {name: value for name, value in laid.items() if value in near}

    def _over(self, window: Window) -> Figure:
        """The student's drawing, dashed; letters in brackets where its points lie elsewhere."""
        plot = Plot(self.plot.facts)
        plot.points(self.plane).update(self._own)
        polygon = self._polygon(plot, window)
        figure = Figure([Stroke((arrow.start, arrow.end), "dashed") for arrow in polygon.vectors()])
        for name, at in polygon.points.items():
            figure.marks.append(Disc(at, _RING, "thin"))
            if abs(at - window(self._there[name])) > _OFF:
                label = joined([plain("("), point_label(name), plain(")")], "")
                figure.wanted.append(LabelRequest(label, at, gap=_RING))
        return figure


def _versions(
    method: Method, plot: Plot, plane: Plane, found: DrawingComparison | None, own: Own, answer: bool
) -> Iterator[Version]:
    changed = found is not None and plane in found.planes
    students = own.get(plane) if plane != "position" else None
    arrows = found.arrows.get(plane, frozenset()) if found is not None else frozenset()
    images = found.images.get(plane, frozenset()) if found is not None else frozenset()
    if answer and (changed or students):
        yield Version(method, plane, _drawable(plot, plane), "right", changed, arrows, images, students)
    if changed and found is not None:
        yield Version(method, plane, _drawable(found.other, plane), "mistake", False, arrows, images, students)


def _drawable(plot: Plot, plane: Plane) -> Plot:
    """The same with the points alone that lie somewhere."""
    there = {name: value for name, value in plot.points(plane).items() if cmath.isfinite(place(value))}
    if len(there) == len(plot.points(plane)):
        return plot
    drawable = Plot(plot.facts, position=dict(plot.position), theta=dict(plot.theta), s=dict(plot.s))
    drawable.points(plane).clear()
    drawable.points(plane).update(there)
    return drawable


def _row(versions: Sequence[Version], top: float, answer: bool, lang: Lang) -> list[Panel]:
    """Side by side, or under one another, at one scale where all are large enough to be read at it."""
    extents = [Extent.of(version.places(), version.figure) for version in versions]
    crowded = max(extent.labels for extent in extents) > _CROWDED
    wide, high = (_LARGE * _WIDE, _LARGE * _HIGH) if crowded else (_WIDE, _HIGH)
    finest = [extent.finest(Room(0, HEAD, wide, high - _FOOT)) for extent in extents]
    scales = [max(finest) if extent.longest / max(finest) >= _SMALL else own for extent, own in zip(extents, finest)]
    heights = [HEAD + e.size.imag / scale + e.reach.imag + _FOOT for e, scale in zip(extents, scales, strict=True)]
    panels: list[Panel] = []
    for k, (version, extent, scale) in enumerate(zip(versions, extents, scales, strict=True)):
        cell = Room(k * wide, top, (k + 1) * wide, top + max(heights))
        if crowded:
            cell = Room(0.0, top + sum(heights[:k]), wide, top + sum(heights[: k + 1]))
        caption = Caption((say(f"pictures.under {version.name}", lang),), _FOOT, first=4.0)
        panel = Picture(extent, version.figure, caption).panel(cell.inset(0, HEAD, 0), scale)
        head = heading(HEADINGS[lang][version.plane], version.plane, scale, cell)
        panels.append(replace(panel, before=head if answer else head[:1], plane=None))
    return panels
