"""Details: a part of a polygon that is too close together for its letters, drawn once more beside it, magnified.

As drawing practice has it (ISO 128-3, GB/T 4458.1): a circle about that part, and the same part in a larger one, both
dash-dotted, as no image of a gear is, under a Roman numeral. What bears its letters in the detail has none in the
circle. All arrows stay where they are, to scale; those of the detail are not measured.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import compress, pairwise

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.rooms import RIM, Room, RoundRoom
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_candidates import MANY
from graphkin.sheet.label_requests import LabelRequest, tangled
from graphkin.sheet.labels import UNCLEAR, burden
from graphkin.sheet.lettering import LABEL, plain, width
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.obstacles import arc_places
from graphkin.sheet.page import Panel
from graphkin.sheet.window import Figure, Window

_RADII = (1.2, 1.6, 2.5, 4.0, 6.0, 9.0, 13.0)  # of the circles that are tried about a part of a figure [mm]
_SCALES, _LESS, _MORE = (400.0, 200.0, 100.0, 50.0, 40.0, 20.0, 10.0, 5.0, 4.0, 2.5), 2.0, 20.0
"""The scales of details, after ISO 5455 and GB/T 14690; so many times as large as where its part is seen is each."""
_LARGEST = 45.0  # radius of a detail [mm]
DETAILS = (44 + 52j, 60 + 68j)  # the rooms for a small one and a large one [mm]
_AROUND, _HEAD = 6.0, 4.0  # room for letters around a detail, and for its own heading over it [mm]
_FEW = 3  # labels, of one arrow and its ends, are no knot
SAVED, _CLOSE = 4.0, 1e-6  # the burden that a detail saves at least, but for rounding
_LED, _SEEN = 3.0, 0.8  # the additional burden of a leader in a detail; a shorter arrow is hidden even there [mm]
_ROUND = 1.2, _RADII[0]  # a circle is so many times as large as what it is to show, and no smaller [mm]
_OWN = 2  # a detail of which a part is drawn once more keeps at least so many labels, with that part's numeral
_NUMERALS = ("I", "II", "III")  # of the details of one figure, which has no more
_PRIMES: dict[Plane, str] = {"position": "", "velocity": "", "acceleration": "\u2032"}


@frozen
class _View:
    """A part of a panel, shown elsewhere through a window of its own, so many times as large as the figure."""

    part: RoundRoom
    shown: RoundRoom
    times: float
    window: Window


def detailed(
    panel: Panel, draw: Callable[[Window], Figure], plane: Plane, parts: Sequence[tuple[complex, float]] = ()
) -> Panel:
    """The panel with details of some parts (centre and radius [SI]), and of more where they relieve it; `draw`: its
    figure through any window. A panel without a knot, or without room for a detail, is handed back as it is."""
    drawing = _DetailDrawing(panel, draw, _PRIMES[plane], panel.burdens)
    for place, radius in parts:  # of a detail that shows all of one already
        windows = [view.window for view in drawing.views
                   if abs(view.window(place) - view.shown.centre) + radius / view.window.scale < view.shown.radius]
        seen = [panel.window, *windows][-1]
        drawing = drawing.showing(RoundRoom(seen(place), radius / seen.scale))
    while len(drawing.views) < len(_NUMERALS) and (more := drawing.relieved()) is not None:
        drawing = more
    return drawing.panel


def lens(panel: Panel, draw: Callable[[Window], Figure], plane: Plane, about: Sequence[Place]) -> Panel:
    """The panel with a detail of the part that holds these places; as it is where it has no room for one."""
    return _DetailDrawing(panel, draw, _PRIMES[plane], panel.burdens).showing(RoundRoom.about(about, *_ROUND)).panel


@frozen
class _DetailDrawing:
    """A panel with the details it has so far; prime: after their numerals; burdens: of its labels on the eye, as far as
    they are known before all are lettered."""

    panel: Panel
    draw: Callable[[Window], Figure]
    prime: str
    burdens: Array
    views: tuple[_View, ...] = ()

    def relieved(self, deeper: bool = True) -> _DetailDrawing | None:
        """With the one more detail that relieves it most, or one with that of a knot in it; None where none does."""
        whole, free, best = burden(self.burdens), FreeRoom(self.panel.scene), None
        least = whole - SAVED + _CLOSE
        for knot, held in sorted(knots(self.panel.figure, self.burdens).items(), key=lambda each: -each[1]):
            if whole - held < least and (view := self._view(knot, free)) is not None:  # were its labels no burden
                other = self._with(view)
                if deeper and len(other.views) < len(_NUMERALS) and burden(other.burdens) >= least:
                    other = other.relieved(deeper=False) or other
                own = [sum(want.named_in(view.shown) for want in other.panel.figure.wanted) for view in other.views]
                if min(own) >= _OWN and burden(other.burdens) < least:
                    best, least = other, burden(other.burdens)  # no detail loses its own letters to another
        return best

    def showing(self, part: RoundRoom) -> _DetailDrawing:
        """With a detail of a part, where there is room for one."""
        view = self._view(part, FreeRoom(self.panel.scene))
        return self if view is None else self._with(view)

    def _view(self, knot: RoundRoom, free: FreeRoom) -> _View | None:
        """A part of the figure, or of a detail, as large as there is room for; None where there is none."""
        seen = next((view for view in self.views if view.shown.holds(knot.centre)), None)
        window, before = (seen.window, seen.times) if seen is not None else (self.panel.window, 1.0)
        for times in (scale / before for scale in _SCALES):
            if not _LESS <= times <= min(_MORE, _LARGEST / knot.radius):
                continue
            side = 2 * (knot.radius * times + _AROUND)
            if (corner := free.corner(complex(side, side + _HEAD))) is not None:
                shown = RoundRoom(corner + complex(side, side) / 2 + 1j * _HEAD, knot.radius * times)
                return _View(knot, shown, times * before, window.magnified(knot.centre, shown.centre, times))
        return None

    def _with(self, view: _View) -> _DetailDrawing:
        """The letters of one circle left to the other, where that part is drawn once more; others stand as they did."""
        whole, figure, at = self.draw(view.window), self.panel.figure, view.shown.centre
        marks = [mark for each in whole.marks for mark in _clipped(each, view.shown)]
        pole, seen = figure.pole, whole.pole
        if (self.burdens[[*pole]] >= UNCLEAR).any():
            pole = seen = set()  # it has no better place for its names either
        named = [want.alone if k in seen else want for k, want in enumerate(whole.wanted) if want.named_in(view.shown)]
        arrows = {want.of for want in named if want.of}
        bad = {figure.wanted[k].of for k in np.flatnonzero(self.burdens >= UNCLEAR / 2)} - {"", *arrows}
        heads = [replace(want, start=piece[0]) for want in whole.wanted if want.of in bad and want.end is not None
                 and view.shown.holds(want.end) and (piece := view.shown.piece(want.start, want.end))]  # fmt: skip
        named, arrows = named + heads, arrows | {want.of for want in heads}
        stay = [not (want.of in arrows if want.of else want.named_in(view.part) and k not in pole)
                for k, want in enumerate(figure.wanted)]  # fmt: skip
        step = min((mark.step for mark in marks if mark.step is not None), default=None)
        numeral = _NUMERALS[len(self.views)] + self.prime
        sign = LabelRequest(plain(numeral), view.part.centre, gap=view.part.radius, size=LABEL, step=step)
        marks += [Disc(circle.centre, circle.radius, "centre", step=step) for circle in (view.part, view.shown)]
        heading = plain(f"{numeral}  ({view.times:g} : 1)")
        top = at - 1j * (view.shown.radius + _AROUND - 1.0)  # over what is written around it
        marks.append(Text(heading, top - width(heading, LABEL) / 2, LABEL, step))
        room = Room(at.real, at.imag, at.real, at.imag).inset(*[-view.shown.radius - _AROUND] * 3)  # with its letters
        alone = Panel(Figure(marks, named), view.window, room)
        inside = alone.near.burdens(named) + tangled(named, _SEEN)
        inside += _LED * np.bincount(alone.near.led, minlength=len(named))
        inside[len(named) - len(heads) :] += 1.0  # named far from most of its arrow: as on a leader
        burdens = np.concatenate([self.burdens[stay], inside, [0.0]])
        drawn = Figure([*figure.marks, *marks], [*compress(figure.wanted, stay), *named, sign])
        magnified = *self.panel.magnified, (view.window.value(at), view.shown.radius * view.window.scale)
        panel = replace(self.panel, figure=drawn, magnified=magnified)
        return replace(self, panel=panel, views=(*self.views, view), burdens=burdens)


def knots(figure: Figure, burdens: Array) -> dict[RoundRoom, float]:
    """Where a detail may relieve labels: for each radius the circle about what is near one of them and weighs most, if
    that is enough; and that weight."""
    found = dict[RoundRoom, float]()
    if not 0 < len(figure.wanted) <= MANY:
        return found
    start = np.array([want.start for want in figure.wanted])
    end = np.array([want.start if want.end is None else want.end for want in figure.wanted])
    about = np.array([want.place for want in figure.wanted])[:, None]
    far = np.maximum(abs(start - about), abs(end - about))
    nameless = np.array([bool(want.of) for want in figure.wanted]) & (burdens >= UNCLEAR)
    for radius in _RADII:
        held = far <= radius + RIM
        inside = held[(held @ burdens).argmax()]
        knot = np.count_nonzero(inside) > _FEW or nameless[inside].any()
        if burdens[inside].sum() >= SAVED and knot:
            lighter = burden(burdens) - burden(np.where(inside, 0.0, burdens))
            found[RoundRoom.about([*start[inside], *end[inside]], *_ROUND)] = lighter
    return found


def _clipped(mark: Mark, circle: RoundRoom) -> Iterator[Mark]:
    """The part of a mark that lies in the circle, as a part of no plane."""
    match mark:
        case PointMark(at=at) if circle.holds(at):
            yield replace(mark, plane="detail")
        case VectorMark(start=start, end=end) if circle.holds(end):
            if (piece := circle.piece(start, end)) is not None:
                yield replace(mark, plane="detail", start=piece[0], broken=0.0)
        case VectorMark(start=start, end=end, pen=pen, step=step):
            if (piece := circle.piece(start, end)) is not None:
                yield Stroke(piece, pen, step=step)
        case Stroke():
            yield from _pieces(mark.outline, mark, circle)
        case Disc(centre=centre, radius=radius) if abs(centre - circle.centre) + radius <= circle.radius:
            yield mark
        case Disc() | ArcMark():
            arc = mark if isinstance(mark, ArcMark) else ArcMark(mark.centre, mark.radius, 0.0, cmath.tau)
            fine = 1 + math.sqrt(abs(arc.radius))  # pieces of a magnified arc show no corner
            yield from _pieces(arc_places(arc, fine), Stroke((), mark.pen, step=mark.step, accent=mark.accent), circle)
        case _:
            pass


def _pieces(places: tuple[Place, ...], line: Stroke, circle: RoundRoom) -> Iterator[Mark]:
    """A line's pieces within the circle, as lines like it that say nothing."""
    for start, end in pairwise(places):
        if (piece := circle.piece(start, end)) is not None:
            yield replace(line, places=piece, closed=False, fill="none", shows=None)
