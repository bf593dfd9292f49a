"""Centrodes on paper: the fixed curve and the moving one that rolls on it; and a pole from two velocities."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import numpy as np

from graphkin.base.rooms import corners, enlarged
from graphkin.base.scales import finest
from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME, Link, Mechanism
from graphkin.running.path import along
from graphkin.say.catalogue import in_both, say
from graphkin.say.centre_about import curves_met, pole_words
from graphkin.sheet.drafting_figure import named, spot
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import formula, point_label, quantity_label
from graphkin.sheet.marks import Place, Stroke
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.motion_frames import lettered
from graphkin.sheet.page import Page, Sheet
from graphkin.sheet.paper import PenName, papers_for
from graphkin.sheet.path_figure import clipped
from graphkin.sheet.single_figure import Picture, SingleFigure, gridded, place_for
from graphkin.sheet.symbols import SWEEP, arrow, right_angle, spin
from graphkin.sheet.titleblock import Strip
from graphkin.sheet.window import Entry, Extent, Figure, Window
from graphkin.studies.centres.centrodes import Centrodes
from graphkin.studies.centres.two_velocities import TwoVelocities

FRAMES = 48
_ROUND = 1.25  # curves are shown so far from the middle of the mechanism, as part of its size
_WHOLE = 3.5  # they are shown whole if the figure becomes no more times larger than the mechanism
_CENTRE = 2.0  # so many times larger the figure may become to show the centre itself
_PENS: tuple[PenName, ...] = ("visible", "thin")


def centrode_sheet(curves: Centrodes, *, t: float = 0.0, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """Both curves (or a path) with the mechanism at t along the motion (0: the drawn position). Raises UnknownPaper."""
    centre = _centre_at(curves, t)
    page = _page(curves, [t], paper, [*curves_met(curves, centre, lang)])
    if centre is not None and not page.room.holds(page.window(centre)):
        page = _page(curves, [t], paper, [*curves_met(curves, centre, lang, off=True)])
    drawing = _CentrodePage(curves, page, lang)
    return drawing.sheet(t, drawing.figure(t) + Figure(wanted=[*drawing.names(t)]))


def centrode_frames(
    curves: Centrodes, count: int = FRAMES, *, paper: str | None = None, lang: Lang = "en"
) -> Iterator[Sheet]:
    """The same sheet at `count` positions evenly over the motion; its curves are named by their pens. Of a motion that
    begins anew, the last position is the first; of others, they go there and back. Raises UnknownPaper."""
    (low, high), links = curves.span, (curves.first, curves.second)
    ends = [np.array(curves.standing(link, np.array(curves.span))) for link in links]
    comes_back = all(bool(np.all(np.abs(end[:, 1] - end[:, 0]) < 1e-8)) for end in ends)
    if comes_back or any(piece.closed for piece in curves.pieces):
        times = low + (high - low) * np.arange(count) / count
    else:
        there = np.linspace(low, high, count // 2 + 1)
        times = np.concatenate([there, there[-2:0:-1]])
    words = dict(zip(("first", "second"), _names(curves, lang), strict=False))
    told = [say("about.sheet pens", lang, **words)] if len(words) > 1 else []
    on = _page(curves, [*times[:: max(1, count // 12)]], paper, told)
    page = _CentrodePage(curves, on, lang)
    every = lettered([page.figure(float(t)) for t in times], on.room)
    yield from (page.sheet(float(t), Figure(marks)) for t, marks in zip(times, every, strict=True))


def _page(curves: Centrodes, times: Sequence[float], paper: str | None, told: Sequence[str] = ()) -> SingleFigure:
    """A page with room for the mechanism at all these t, and for the curves near it; told: sentences in its strip."""
    method = curves.found.method
    plots = [along(method, curves.path, t) for t in times]
    values = [place for plot in plots for place in shown_places(method, plot)]
    low, high = corners(values)
    every = [curve for t in times for link in curves.axes for curve in _carried(curves, link, t)]
    places, centre = np.concatenate(every), _centre_at(curves, times[0])
    first, last = corners([*values, *places])
    if abs(last - first) > _WHOLE * abs(high - low):
        places = places[np.abs(places - (low + high) / 2) <= _ROUND * max((high - low).real, (high - low).imag)]
    ends = corners([*places]) if places.size else ()
    shown = enlarged([*values, *ends], [] if centre is None else [centre], _CENTRE)
    return place_for(method, plots, shown, paper, Strip(told=told))


def _carried(curves: Centrodes, link: str, t: float) -> list[np.ndarray]:
    """The curve on a link, as the link stands at t [m]."""
    origin, turn = curves.standing(link, t)
    return [origin + turn * curve for curve in (curves.fixed if link == curves.axes[0] else curves.moving)]


def _centre_at(curves: Centrodes, t: float) -> complex | None:
    """The centre at t, if the curves were followed there [m]."""
    origin, turn = curves.standing(curves.axes[0], t)
    for piece, at in ((piece, at) for piece in curves.pieces for at in (t, t + curves.span[1] - curves.span[0])):
        if piece.t[0] <= at <= piece.t[-1]:  # a piece that goes over the seam counts on beyond the span
            place = np.interp(at, piece.t, piece.places[0].real) + 1j * np.interp(at, piece.t, piece.places[0].imag)
            return complex(origin + turn * place)
    return None


@frozen
class _CentrodePage:
    """Curves on a page, with the mechanism at any t along the motion."""

    curves: Centrodes
    on: SingleFigure
    lang: Lang

    def figure(self, t: float) -> Figure:
        """The curves as far as they lie in the room, the mechanism, and the centre."""
        curves, on = self.curves, self.on
        plot, centre = along(curves.found.method, curves.path, t), _centre_at(curves, t)
        figure = Figure([stroke for strokes in self._strokes(t) for stroke in strokes]) + on.mechanism(plot)
        if centre is not None and on.room.holds(on.window(centre)):
            figure += Figure.of(spot(on.window(centre), quantity_label("P", curves.name[1:]), 1.0, "paper"))
        return figure

    def sheet(self, t: float, figure: Figure) -> Sheet:
        curves, called = self.curves, self.curves.found.method.mechanism.called
        names = {"name": curves.name, "first": called(curves.first), "second": called(curves.second)}
        key = "about.sheet path" if len(curves.axes) == 1 else "about.sheet centrodes"
        plot = along(curves.found.method, curves.path, t)
        return self.on.sheet(plot, say(key, self.lang, **names), figure, self.lang)

    def names(self, t: float) -> Iterator[LabelRequest]:
        """The names of the curves, or of the path."""
        every, labels = self._strokes(t), map(formula, _names(self.curves, self.lang))
        for own, other, label in zip(every, every[::-1], labels, strict=True):
            yield from named(own, label, other if len(every) > 1 else ())

    def _strokes(self, t: float) -> list[list[Stroke]]:
        """The pieces of each curve on paper."""
        every, window = list[list[Stroke]](), self.on.window
        for link, pen in zip(self.curves.axes, _PENS, strict=False):
            pieces = zip(_carried(self.curves, link, t), self.curves.pieces, strict=True)
            closed = ([*curve, *curve[:1]] if piece.closed else curve for curve, piece in pieces)
            places = (window.origin + np.conj(curve) / window.scale for curve in closed)
            every.append([stroke for curve in places for stroke in clipped(curve, self.on.room, pen)])
        return every


def _names(curves: Centrodes, lang: Lang) -> list[str]:
    """The curves, or the path, in words."""
    if len(curves.axes) == 1:
        return [say("about.sheet path of", lang, name=curves.name[1:])]
    kinds, called = ("fixed", "moving"), curves.found.method.mechanism.called
    keys = [f"about.sheet {kind if curves.second == FRAME else 'on'}" for kind in kinds]
    return [say(key, lang, link=called(link)) for key, link in zip(keys, curves.axes, strict=True)]


# --- the pole of a body from two of its velocities --------------------------------------------------------------------


_ARROW = 45.0  # the greater velocity is drawn no longer than this [mm]
_BEYOND = 12.0  # the length of lines past their points [mm]; a line that meets none, so much more
_RADIUS = 9.0  # of the arc of omega [mm]


def pole_sheet(velocities: TwoVelocities, lang: Lang = "en", *, paper: str | None = None) -> Sheet:
    """Raises UnknownPaper."""
    chosen = papers_for(paper or "A4-landscape")[0]
    fastest = max(map(abs, velocities.velocities))
    speed = finest(complex(fastest, fastest), complex(_ARROW, _ARROW))

    def draw(window: Window) -> Figure:
        return Figure.of(_entries(velocities, window, speed))

    places = [*velocities.points, *([velocities.place] if cmath.isfinite(velocities.place) else [])]
    strip = Strip(told=[*pole_words(velocities, lang)], further={"velocity": speed} if fastest else {})
    _, panels = gridded([[Picture(Extent.of(places, draw), draw)]], chosen, strip)
    title = in_both("about.pole title")
    machine = Mechanism("velocities", "1", {FRAME: Link(FRAME, {})}, title=title, file="velocities")
    return Page(chosen, panels, machine, None, lang, strip).sheet()


def _entries(velocities: TwoVelocities, window: Window, speed: float) -> Iterator[Entry]:
    pole = window(velocities.place) if cmath.isfinite(velocities.place) else None
    ends = [window(point) for point in velocities.points]
    tips = [end + velocity.conjugate() / speed for end, velocity in zip(ends, velocities.velocities, strict=True)]
    if velocities.case == "similar" and pole is not None:
        yield _line([*ends, pole])
        yield _line([*tips, pole])
    elif velocities.case in ("meet", "infinity"):
        for end, tip in zip(ends, tips, strict=True):
            if abs(tip - end) < 1:
                continue
            side = (tip - end) / abs(tip - end) * 1j  # the perpendicular of a velocity, with its right angle
            side *= -1 if pole is not None and ((pole - end) / side).real < 0 else 1
            reach = _BEYOND * 4 if pole is None else abs(pole - end) + _BEYOND
            yield Stroke((end, end + side * reach), "construction")
            yield from right_angle(end, tip - end, side)
    yield Stroke((ends[0], ends[1]), "visible")
    for name, end, tip in zip(velocities.names, ends, tips, strict=True):
        yield from spot(end, point_label(name))
        if abs(tip - end) > 1:
            yield from arrow(end, tip, "velocity")
            yield LabelRequest(quantity_label("v", name), end, tip)
    if pole is not None:
        yield from spot(pole, quantity_label("P", ""), 0.9, "paper")
        if velocities.omega:
            sweep = math.copysign(SWEEP, velocities.omega)
            middle = cmath.rect(1, math.radians(30) - sweep / 2)
            yield from spin(pole, middle, sweep, _RADIUS)
            yield LabelRequest(quantity_label("ω", ""), pole + middle * _RADIUS, gap=0.9, away=middle)


def _line(places: list[Place]) -> Stroke:
    """Through places on one line, and on past them."""
    one, other = max(((a, b) for a in places for b in places), key=lambda pair: abs(pair[1] - pair[0]))
    beyond = (other - one) / (abs(other - one) or 1) * _BEYOND
    return Stroke((one - beyond, other + beyond), "construction")
