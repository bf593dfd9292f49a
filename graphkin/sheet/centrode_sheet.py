"""Centrodes on paper: the fixed curve and the moving one that rolls on it; and a pole from two velocities."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME, Link, Mechanism
from graphkin.running.path import along
from graphkin.say.catalogue import in_both
from graphkin.say.centre_about import curves_met, pole_words
from graphkin.sheet.drafting_figure import named, right_angle, spot
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, formula, point_label, quantity_label
from graphkin.sheet.marks import Place, Stroke
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import PenName, finest, papers_for
from graphkin.sheet.path_figure import clipped
from graphkin.sheet.single_figure import Picture, SingleFigure, gridded, place_for
from graphkin.sheet.symbols import SWEEP, arrow, spin
from graphkin.sheet.window import Entry, Extent, Figure, Window, corners, enlarged
from graphkin.studies.centres.centrodes import Centrodes
from graphkin.studies.centres.two_velocities import TwoVelocities

FRAMES = 48
_ROUND = 1.25  # curves are shown so far from the middle of the mechanism, as part of its size
_CENTRE = 2.0  # so many times larger the figure may become to show the centre itself
_PENS: tuple[PenName, ...] = ("visible", "thin")

HEADING: dict[Lang, str] = {"en": "Centrodes of links {first} and {second}", "zh": "构件 {first}、{second} 的瞬心线"}
PATH: dict[Lang, str] = {"en": "Path of the instant centre {name}", "zh": "瞬心 {name} 的轨迹"}
CURVES: Mapping[str, dict[Lang, str]] = {
    "fixed": {"en": "fixed centrode (link {link})", "zh": "定瞬心线（构件 {link}）"},
    "moving": {"en": "moving centrode (link {link})", "zh": "动瞬心线（构件 {link}）"},
    "on": {"en": "centrode (link {link})", "zh": "瞬心线（构件 {link}）"},
}
OF: dict[Lang, str] = {"en": "path of P_{name}", "zh": "P_{name} 的轨迹"}


def centrode_sheet(curves: Centrodes, *, t: float = 0.0, paper: str | None = None, lang: Lang = "en") -> Sheet:
    """Both curves (or a path) with the mechanism at t along the motion (0: the drawn position). Raises UnknownPaper."""
    sentences = [*curves_met(curves, _centre_at(curves, t), lang)]
    return _CentrodePage(curves, _page(curves, [t], paper, sentences), lang).sheet(t, lettered=True)


def centrode_frames(
    curves: Centrodes, count: int = FRAMES, *, paper: str | None = None, lang: Lang = "en"
) -> Iterator[Sheet]:
    """The same sheet at `count` positions evenly over the motion, without letters at what moves.

    Of a motion that begins anew, the last position is the first; of others, they go there and back. Raises
    UnknownPaper.
    """
    (low, high), links = curves.span, (curves.first, curves.second)
    ends = [np.array(curves.standing(link, np.array(curves.span))) for link in links]
    comes_back = all(bool(np.all(np.abs(end[:, 1] - end[:, 0]) < 1e-8)) for end in ends)
    if comes_back or any(piece.closed for piece in curves.pieces):
        times = low + (high - low) * np.arange(count) / count
    else:
        there = np.linspace(low, high, count // 2 + 1)
        times = np.concatenate([there, there[-2:0:-1]])
    page = _CentrodePage(curves, _page(curves, [*times[:: max(1, count // 12)]], paper), lang)
    yield from (page.sheet(float(t), lettered=False) for t in times)


def _page(curves: Centrodes, times: Sequence[float], paper: str | None, told: Sequence[str] = ()) -> SingleFigure:
    """A page with room for the mechanism at all these t, and for the curves near it; told: sentences in its strip."""
    method = curves.found.method
    plots = [along(method, curves.path, t) for t in times]
    values = [place for plot in plots for place in shown_places(method, plot)]
    low, high = corners(values)
    places = np.concatenate([curve for t in times for link in curves.axes for curve in _carried(curves, link, t)])
    near = places[np.abs(places - (low + high) / 2) <= _ROUND * max((high - low).real, (high - low).imag)]
    centre = _centre_at(curves, times[0])
    shown = enlarged([*values, *(corners([*near]) if near.size else ())], [] if centre is None else [centre], _CENTRE)
    return place_for(method, plots, shown, paper, told=told)


def _carried(curves: Centrodes, link: str, t: float) -> list[np.ndarray]:
    """The curve on a link, as the link stands at t [m]."""
    origin, turn = curves.standing(link, t)
    return [origin + turn * curve for curve in (curves.fixed if link == curves.axes[0] else curves.moving)]


def _centre_at(curves: Centrodes, t: float) -> complex | None:
    """The centre at t, if the curves were followed there [m]."""
    origin, turn = curves.standing(curves.axes[0], t)
    for piece in curves.pieces:
        if piece.t[0] <= t <= piece.t[-1]:
            place = np.interp(t, piece.t, piece.places[0].real) + 1j * np.interp(t, piece.t, piece.places[0].imag)
            return complex(origin + turn * place)
    return None


@frozen
class _CentrodePage:
    """Curves on a page, with the mechanism at any t along the motion."""

    curves: Centrodes
    on: SingleFigure
    lang: Lang

    def sheet(self, t: float, lettered: bool) -> Sheet:
        """The curves as far as they lie in the room, and the centre; lettered: with the names of curves and links."""
        curves, on = self.curves, self.on
        plot, centre = along(curves.found.method, curves.path, t), _centre_at(curves, t)
        figure = Figure()
        for link, pen, label, share in zip(curves.axes, _PENS, self._labels(), (0.25, 0.75), strict=False):
            strokes = list[Stroke]()
            for curve, piece in zip(_carried(curves, link, t), curves.pieces, strict=True):
                places = [*(on.window.origin + np.conj(curve) / on.window.scale)]
                strokes += clipped([*places, *places[:1]] if piece.closed else places, on.room, pen)
            figure += Figure([*strokes], [*named(strokes, label, share)])
        figure += on.mechanism(plot)
        if centre is not None and on.room.holds(on.window(centre)):
            figure += Figure.of(spot(on.window(centre), quantity_label("P", curves.name[1:]), 1.0, "paper"))
        figure = figure if lettered else Figure(figure.marks)
        called = curves.found.method.mechanism.called
        names = {"name": curves.name, "first": called(curves.first), "second": called(curves.second)}
        words = PATH if len(curves.axes) == 1 else HEADING
        return on.sheet(plot, words[self.lang].format(**names), figure, self.lang)

    def _labels(self) -> list[Label]:
        """The names of the curves, or of the path."""
        if len(self.curves.axes) == 1:
            return [formula(OF[self.lang].format(name=self.curves.name[1:]))]
        kinds, called = ("fixed", "moving"), self.curves.found.method.mechanism.called
        words = [CURVES[kind if self.curves.second == FRAME else "on"][self.lang] for kind in kinds]
        return [formula(text.format(link=called(link))) for text, link in zip(words, self.curves.axes, strict=True)]


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
    _, grid, panels = gridded([[Picture(Extent.of(places, draw), draw)]], chosen, told=[*pole_words(velocities, lang)])
    strip = replace(grid.strip, further={"velocity": speed} if fastest else {})
    title = in_both("about.pole title")
    machine = Mechanism("velocities", "1", {FRAME: Link(FRAME, {})}, title=title, file="velocities")
    return replace(grid, strip=strip).page(panels, machine, lang).sheet()


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
            start, sense = cmath.rect(1, math.radians(30)), math.copysign(1, velocities.omega)
            yield from spin(pole, start, sense, _RADIUS)
            middle = start * cmath.rect(1, -sense * SWEEP / 2)
            yield LabelRequest(quantity_label("ω", ""), pole + middle * _RADIUS, gap=0.9, away=middle)


def _line(places: list[Place]) -> Stroke:
    """Through places on one line, and on past them."""
    one, other = max(((a, b) for a in places for b in places), key=lambda pair: abs(pair[1] - pair[0]))
    beyond = (other - one) / (abs(other - one) or 1) * _BEYOND
    return Stroke((one - beyond, other + beyond), "construction")
