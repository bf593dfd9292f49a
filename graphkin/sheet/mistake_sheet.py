"""Drawings with a mistake in them, or a student's own, laid over the right one; a small figure a sheet.

    versions (`Version`) of a plane --> a Picture each --> Page on a paper cut to it

What is laid over is bold, what it lies on is grey; laid off or directed otherwise is emphasised, and a short arrow of
that kind is magnified. A picture that must not give the answer away has no right drawing, and tells no scale.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from graphkin.base.geometry import place
from graphkin.base.rooms import Room, corners, enlarged
from graphkin.base.value import frozen
from graphkin.construction import Construction, Plane, Plot
from graphkin.errors import Lang
from graphkin.marking.consequences import DrawingComparison
from graphkin.planning import Method
from graphkin.say.catalogue import say
from graphkin.sheet.detail import lens
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.layout import HEAD
from graphkin.sheet.lettering import joined, plain, point_label
from graphkin.sheet.marks import Disc, Mark, PointMark, Stroke, VectorMark
from graphkin.sheet.mechanism_figure import plain_mechanism, shown_places
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.page import Page, Sheet, heading
from graphkin.sheet.paper import Paper
from graphkin.sheet.polygons import PolygonFigure, polygon_figure
from graphkin.sheet.single_figure import Picture, foot_of
from graphkin.sheet.window import PLANES, Entry, Extent, Figure, Window

Own = Mapping[Plane, Mapping[str, complex]]
"""A student's drawing as it was measured: points of each plane by their letters, SI, from any of them."""

_WIDE, _HIGH = 98.0, 96.0
"""Of the room for a figure with its heading and its caption, at most: so much that a telephone shows arrow heads of
2.5 mm [mm]."""
_CROWDED = 22  # figures with more labels than this leave out those that others tell, too
_OFF = 2.5  # a point of the student's that lies farther off than this bears its letter [mm]
_RING = 0.9  # radius of the circles about the student's points [mm]
_FAR = 2.0  # points of the student's that would make the figure more than so many times as large are not drawn
_UNLIKE = 4.0  # drawings of which one is more than so many times as large are not laid over one another
_GONE, _SHORT = 0.5, 8.0  # arrows that are missing, and those that are magnified, are shorter [mm]
_LENS, _BELOW = 52.0, 6.0  # room for what is magnified, and for letters below it [mm]
_OTHERWISE = 1  # the step that what is drawn otherwise is marked with, until it is emphasised


def mistake_sheets(
    method: Method, plot: Plot, *, found: DrawingComparison | None = None, own: Own | None = None, answer: bool = True,
    lang: Lang = "en",
) -> list[Sheet]:  # fmt: skip
    """The planes that mistakes change, and those that a student has drawn; none where there is nothing to show.

    plot    the right drawing
    found   what mistakes draw otherwise; the right drawing alone where left out
    own     the student's drawing, laid over with its pole on the pole
    answer  whether the right drawing may be shown: without it, the drawing with the mistakes alone
    """
    every = (_versions(method, plot, plane, found, own or {}, answer) for plane in PLANES)
    return [version.sheet(answer, lang) for versions in every for version in versions]


@frozen
class Version:
    """A plane as it is drawn by somebody; name: in the catalogue, to be said under it; arrows, images: drawn otherwise
    (`DrawingComparison`); own: points that are laid over it, from the pole."""

    method: Method
    plane: Plane
    plot: Plot
    name: str
    arrows: frozenset[frozenset[str]] = frozenset()
    images: frozenset[str] = frozenset()
    own: Mapping[str, complex] | None = None

    def sheet(self, answer: bool, lang: Lang) -> Sheet:
        """As large as a page has room for; with its scale where it may be told."""
        extent = Extent.of(self.places(), self.figure)
        picture = Picture(extent, self.figure, (say(f"pictures.under {self.name}", lang),))
        foot = foot_of([picture], _WIDE)
        scale = extent.scale(Room(0, HEAD, _WIDE, _HIGH - foot))
        short = self._short(scale) if self.plane != "position" else []
        cell = Room(0.0, 0.0, _WIDE, HEAD + extent.cut_out(scale).bottom + foot)
        panel = replace(picture.panel(cell.inset(0, HEAD, 0), foot, scale), before=())
        if short:  # a lens stands in the figure, or else under it: as far down as it goes
            deep = replace(panel, room=replace(panel.room, bottom=panel.room.bottom + _LENS))
            panel = lens(deep, self.figure, self.plane, [panel.window(at) for at in short])
            lowest = bounds(panel.figure.marks)[3] + _BELOW + foot
            cell = replace(cell, bottom=max(cell.bottom, min(cell.bottom + _LENS, lowest)))
        head = heading(say(f"sheet.plane {self.plane}", lang), self.plane, scale, cell)
        before = (*(head if answer else head[:1]), *picture.caption(cell, foot))
        panel = replace(panel, room=cell.inset(1, HEAD + 1, foot), before=before, plane=None)
        paper, title = Paper("figure", cell.right, cell.bottom, 0.0), say(f"sheet.plane {self.plane}", lang)
        page = Page(paper, [panel], self.method.mechanism, self.plot.facts.values, lang, title=title)
        return page.sheet().upto(_OTHERWISE).redrawn(lambda mark: replace(mark, step=None))

    def _short(self, scale: float) -> list[complex]:
        """The ends of an arrow that is drawn otherwise and is short in all that is shown, as it is laid over; SI."""
        drawings = [self._own, self.there] if self._own else [self.there]
        for ends in sorted(self.arrows, key=sorted):
            pairs = [[there[name] for name in ends] for there in drawings if ends <= there.keys()]
            lengths = [abs(pair[-1] - pair[0]) / scale for pair in pairs]
            if lengths and _GONE < max(lengths) < _SHORT:
                return pairs[next(k for k, length in enumerate(lengths) if length > _GONE)]
        return []

    @property
    def construction(self) -> Construction:
        return self.method.construction(self.plane)

    def places(self) -> list[complex]:
        if self.plane == "position":
            return shown_places(self.method, self.plot)
        return [*self.there.values(), *self._own.values()]

    @property
    def there(self) -> Mapping[str, complex]:
        """The polygon's points."""
        names = {self.construction.pole, *self.construction.nodes}
        return {name: place(v) for name, v in self.plot.points(self.plane).items() if name in names}

    def figure(self, window: Window) -> Figure:
        if self.plane == "position":
            figure = plain_mechanism(self.method, self.plot, window).numbered(None)
            return Figure([self._penned(mark, window.scale) for mark in figure.marks], figure.wanted)
        figure = polygon_figure(self._polygon(self.plot, window))
        ends = [[window(self.there[name]) for name in sorted(pair) if name in self.there] for pair in self.arrows]
        gone = {pair[0] for pair in ends if len(pair) > 1 and abs(pair[1] - pair[0]) < _GONE}
        figure.marks += [Disc(at, 2 * _RING, "thin", step=_OTHERWISE) for at in sorted(gone, key=abs)]
        crowded = len(figure.wanted) > _CROWDED
        labels = [label for label in figure.wanted if not (crowded and label.spare)]
        marks = [self._penned(mark, window.scale) for mark in figure.marks]
        return Figure(marks, labels) + Figure.of(self._over(window))

    def _polygon(self, plot: Plot, window: Window) -> PolygonFigure:
        return PolygonFigure(self.method.mechanism, self.construction, plot, window, {})

    def _penned(self, mark: Mark, scale: float) -> Mark:
        """Emphasised where it is drawn otherwise, or is missing in what is laid over; grey under that."""
        own = self._own
        if not own:
            return self._emphasised(mark)
        if isinstance(mark, VectorMark) and frozenset((mark.tail, mark.head)) in self.arrows:
            start, end = own.get(mark.tail), own.get(mark.head)
            if start is None or end is None or abs(end - start) < _GONE * scale:
                return self._emphasised(mark)
        if isinstance(mark, VectorMark | Stroke) and mark.pen in ("asked", "vector", "visible"):
            return replace(mark, pen="leader")
        return mark

    def _emphasised(self, mark: Mark) -> Mark:
        otherwise = False
        match mark:
            case VectorMark(tail=tail, head=head):
                ends = frozenset((tail, head))
                otherwise = ends in self.arrows or (self.construction.pole in ends and bool(ends & self.images))
            case PointMark(name=name):
                otherwise = name in self.images
            case Stroke(shows=shows) if shows is not None:
                otherwise = bool(self.images.intersection(shows.points))
        return replace(mark, step=_OTHERWISE) if otherwise else mark

    @property
    def _own(self) -> Mapping[str, complex]:
        """The points that are laid over, where it has them: the pole upon the pole, or the first upon the first."""
        there = self.there
        own = {name: value for name, value in (self.own or {}).items() if name in there}
        if not own:
            return {}
        first = self.construction.pole if self.construction.pole in own else next(iter(own))
        laid = {name: there[first] + value - own[first] for name, value in own.items()}
        near = {*enlarged([*there.values()], laid.values(), _FAR)}
        return {name: value for name, value in laid.items() if value in near}

    def _over(self, window: Window) -> Iterator[Entry]:
        """The drawing laid over, bold; letters in brackets where its points lie elsewhere."""
        plot = Plot(self.plot.facts)
        plot.points(self.plane).update(self._own)
        polygon = self._polygon(plot, window)
        marks = (mark for mark in polygon_figure(polygon).marks if not isinstance(mark, PointMark))
        yield from map(self._emphasised, marks)
        for name, at in polygon.points.items():
            yield Disc(at, _RING, "thin")
            if abs(at - window(self.there[name])) > _OFF:
                label = joined([plain("("), point_label(name), plain(")")], "")
                yield LabelRequest(label, at, gap=_RING)


def _versions(
    method: Method, plot: Plot, plane: Plane, found: DrawingComparison | None, own: Own, answer: bool
) -> list[Version]:
    """The drawing with mistakes over the right one, or beside it where they are not of one size."""
    students = own.get(plane) if plane != "position" else None
    right = Version(method, plane, _drawable(plot, plane), "right own" if students else "right", own=students)
    if found is None or plane not in found.planes:
        return [right] if answer and students else []
    if plane == "position" and _drawable(found.other, plane) is not found.other:
        return []  # a mechanism that does not close
    arrows, images = found.arrows.get(plane, frozenset()), found.images.get(plane, frozenset())
    right = replace(right, arrows=arrows, images=images)
    wrong = replace(right, plot=_drawable(found.other, plane), name="mistake own" if students else "mistake")
    if not answer:
        return [wrong]
    first, second = (abs(high - low) for low, high in (corners(each.places()) for each in (right, wrong)))
    if plane != "position" and (students or 1 / _UNLIKE < (second or 1.0) / (first or 1.0) < _UNLIKE):
        return [right if students else replace(right, name="right over", own=wrong.there)]
    return [right, wrong]


def _drawable(plot: Plot, plane: Plane) -> Plot:
    """The same with the points alone that lie somewhere."""
    there = {name: value for name, value in plot.points(plane).items() if cmath.isfinite(place(value))}
    changed: dict[str, Any] = {plane: there}
    return plot if len(there) == len(plot.points(plane)) else replace(plot, **changed)
