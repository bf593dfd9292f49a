"""Marks on the paper, in millimetres: strokes, circles, letters, vectors and points.

A place on paper is a complex number x + iy [mm] with y DOWN, as in SVG; the mechanism's own axes have y up.
Marks are painted in their order, so a white circle hides the lines under it. `step` is the number of the
construction step a mark belongs to; `new` marks are those of the newest step of a step-by-step drawing.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.sheet.lettering import Label
from graphkin.sheet.paper import PenName

Place = complex
BREAK = 3.0  # of a line under another, 1 mm on each side of a link [mm]
Fill = Literal["none", "paper", "ink", "grey", "tint"]  # a tint hides nothing under it
Layer = Plane | Literal["centres", "detail"]
"""The layer of a mark: a plane of the construction, the instant centres over the mechanism, a detail of a plane."""
Accent = Plane | Literal["grey"]
"""A mark that has another colour than its layer: a plane's, or grey, as what is not given."""
Half = Literal["", "left", "right"]
Form = Literal["bar", "guide", "block", "slot", "wheel", "arc", "path", "omega", "alpha", "push", "thrust", "ruler"]


@frozen
class Shows:
    """The meaning of a line of a link, so that a ruler can hold it against the link.

    form    "bar": corners at `points`, one by one; "guide": on a line of the link, reaching over `points`;
            "block": about its point, sides along and across the line; "slot": its middle on the line, sides along it,
            reaching over `points`; "wheel": a circle about its point; "arc": about the first point, past the second,
            or a slot along it; "path": where the point goes as the driver `line` moves;
            "omega", "alpha": the head of an arrow about its point, as the link turns against the link `line`;
            "push", "thrust": along a slide, as it moves and is accelerated; "ruler": 100 mm on paper, of no link
    points  of the plane, as their marks are called
    line    the slide, roll, slot or cam whose line it is; of a path the driver
    """

    link: str
    form: Form
    points: tuple[str, ...] = ()
    line: str = ""
    plane: Plane = "position"


@frozen
class Stroke:
    """A line through `places`, `closed` back to the first; shows: of lines of links; accent: its colour where that is
    not its layer's; breaks: where another goes over it, the step that draws that, and the half of the gap [mm]."""

    places: tuple[Place, ...]
    pen: PenName = "outline"
    closed: bool = False
    fill: Fill = "none"
    shows: Shows | None = None
    step: int | None = None
    new: bool = False
    accent: Accent | None = None
    breaks: tuple[tuple[Place, int | None, float], ...] = ()

    @property
    def outline(self) -> tuple[Place, ...]:
        """Its corners, and the first again where it is closed."""
        return (*self.places, self.places[0]) if self.closed else self.places

    @property
    def dashes(self) -> tuple[float, ...]:
        """The lengths of line and gap in turn, from its start past its end; none of an unbroken line [mm]."""
        if not self.breaks:
            return ()
        from shapely import LineString, Point

        line = LineString([(place.real, place.imag) for place in self.outline])
        dashes, drawn, least = list[float](), 0.0, BREAK / 2  # between two breaks as much line as gap
        for middle, half in sorted((line.project(Point(at.real, at.imag)), half) for at, _, half in self.breaks):
            low, high = middle - half, middle + half
            if low - drawn >= least and line.length - high >= BREAK / 2:
                dashes += (low - drawn, high - low)
                drawn, least = high, 2 * half
        return (*dashes, line.length - drawn + 1.0, 1.0) if dashes else ()


@frozen
class Disc:
    """A circle."""

    centre: Place
    radius: float
    pen: PenName = "outline"
    fill: Fill = "none"
    shows: Shows | None = None
    step: int | None = None
    new: bool = False
    accent: Accent | None = None


@frozen
class ArcMark:
    """A part of a circle from angle `start` over `sweep` [rad, clockwise on paper]."""

    centre: Place
    radius: float
    start: float
    sweep: float
    pen: PenName = "thin"
    step: int | None = None
    new: bool = False
    accent: Accent | None = None


@frozen
class Text:
    """Letters, `"".join(run.text for run in label)`; `at` is the left end of the base line, which is turned about it
    [rad, clockwise on paper]."""

    label: Label
    at: Place
    size: float
    step: int | None = None
    new: bool = False
    accent: Accent | None = None
    turn: float = 0.0


@frozen
class VectorMark:
    """An arrow of a polygon from `start` to `end`; a zero vector has both at one place.

    sites  of, seen from, over and onto (as in `Term`), each as `B@3`: the point, then the link of which it is meant to
           be a part
    also   the names of others with the same ends, which it shows, too
    part   which part of the motion, as in `Term`
    solved the construction found its length
    half   on which side of the line alone its head opens, seen along it; back: how far its tip stands off the end [mm]
    pen    a lighter one for an arrow that is laid off, or only compared with
    aside  how far it lies to the left of where it belongs, seen along it [mm]
    broken  the length that is left out of it, in the gap in its middle [mm]
    """

    plane: Layer
    name: str
    tail: str
    head: str
    start: Place
    end: Place
    step: int | None = None
    new: bool = False
    sites: tuple[str, ...] = ()
    also: tuple[str, ...] = ()
    part: str = ""
    solved: bool = False
    half: Half = ""
    back: float = 0.0
    pen: PenName = "vector"
    aside: float = 0.0
    broken: float = 0.0

    @property
    def length(self) -> float:
        """Its length by a ruler [mm]."""
        return abs(self.end - self.start)

    @property
    def dashes(self) -> tuple[float, ...]:
        """The lengths of line and gap in turn, from its start past its end; none of a whole one [mm]."""
        half = (self.length - BREAK) / 2
        return (half, BREAK, half + 1.0, 1.0) if self.broken else ()


@frozen
class PointMark:
    """A named point of a plane and what it belongs to (`B`, `B3`, `pole`): a dot, or a hinge's white circle.

    site  the point and the link of which it is meant to be a part, as `B@3`; "" for what is no point of a link
    """

    plane: Layer
    name: str
    of: str
    at: Place
    radius: float = 0.4
    fill: Fill = "ink"
    step: int | None = None
    new: bool = False
    site: str = ""


Mark = Stroke | Disc | ArcMark | Text | VectorMark | PointMark


_MEASURES: dict[type[Mark], tuple[str, ...]] = {
    Disc: ("centre", "radius"), ArcMark: ("centre", "radius"), Text: ("at", "size"), PointMark: ("at", "radius"),
    VectorMark: ("start", "end", "aside", "broken"),
}  # fmt: skip


def enlarged(mark: Mark, times: float) -> Mark:
    """A mark so many times as large; its lines are as wide as before."""
    if isinstance(mark, Stroke):
        breaks = tuple((times * place, step, half) for place, step, half in mark.breaks)
        return replace(mark, places=tuple(times * place for place in mark.places), breaks=breaks)
    return replace(mark, **{name: times * getattr(mark, name) for name in _MEASURES[type(mark)]})
