"""Centrodes on paper: the fixed curve and the moving one that rolls on it, with the mechanism."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.running.path import along
from graphkin.say.centre_about import curves_met
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, link_label, plain, quantity_label
from graphkin.sheet.marks import Disc, Place, Stroke
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import PenName
from graphkin.sheet.path_figure import clipped
from graphkin.sheet.single_figure import SingleFigure, place_for
from graphkin.sheet.window import Figure, corners, enlarged
from graphkin.studies.centres.centrodes import Centrodes

FRAMES = 48
_ROUND = 0.75  # curves are shown so far around the mechanism, as part of its size
_CENTRE = 2.0  # so many times larger the figure may become to show the centre itself
_AGAIN = 0.03  # a curve that runs over itself within this is drawn once [mm]
_PENS: tuple[PenName, ...] = ("visible", "dashed")

HEADING: dict[Lang, str] = {"en": "Centrodes of links {first} and {second}", "zh": "构件 {first}、{second} 的瞬心线"}
PATH: dict[Lang, str] = {"en": "Path of the instant centre {name}", "zh": "瞬心 {name} 的轨迹"}
CURVES: Mapping[str, dict[Lang, str]] = {
    "fixed": {"en": "fixed centrode (link ", "zh": "定瞬心线（构件 "},
    "moving": {"en": "moving centrode (link ", "zh": "动瞬心线（构件 "},
    "on": {"en": "centrode (link ", "zh": "瞬心线（构件 "},
}
OF: dict[Lang, tuple[str, str]] = {"en": ("path of ", ""), "zh": ("", " 的轨迹")}
END: dict[Lang, str] = {"en": ")", "zh": "）"}


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
    more = _ROUND * max((high - low).real, (high - low).imag) * (1 + 1j)
    low, high = low - more, high + more
    places = np.concatenate([curve for t in times for link in curves.axes for curve in _carried(curves, link, t)])
    across = (low.real <= places.real) & (places.real <= high.real)
    near = places[across & (low.imag <= places.imag) & (places.imag <= high.imag)]
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
        lines = list[list[Stroke]]()
        for link, pen in zip(curves.axes, _PENS, strict=False):
            strokes = list[Stroke]()
            for curve, piece in zip(_carried(curves, link, t), curves.pieces, strict=True):
                places = [*(on.window.origin + np.conj(curve) / on.window.scale)]
                strokes += clipped([*places, places[0]] if piece.closed else _once(places), on.room, pen)
            lines.append(strokes)
        figure, machine = Figure([stroke for strokes in lines for stroke in strokes]), on.mechanism(plot)
        if lettered:
            for label, strokes, share in zip(self._labels(), lines, (0.25, 0.75), strict=False):
                if strokes:
                    longest = max(strokes, key=lambda stroke: _lengths(stroke.places)[-1]).places
                    lengths = _lengths(longest)
                    k = int(np.searchsorted(lengths, share * lengths[-1]))
                    figure.wanted.append(LabelRequest(label, longest[min(k, len(longest) - 1)], gap=1.2))
        figure += machine if lettered else Figure(machine.marks)
        if centre is not None and on.room.holds(on.window(centre)):
            figure.marks.append(Disc(on.window(centre), 1.0, "vector", "paper" if lettered else "ink"))
            if lettered:
                figure.wanted.append(LabelRequest(quantity_label("P", curves.name[1:]), on.window(centre), gap=1.2))
        called = curves.found.method.mechanism.called
        names = {"name": curves.name, "first": called(curves.first), "second": called(curves.second)}
        words = PATH if len(curves.axes) == 1 else HEADING
        return on.sheet(plot, words[self.lang].format(**names), figure, self.lang)

    def _labels(self) -> list[Label]:
        """The names of the curves, or of the path."""
        if len(self.curves.axes) == 1:
            before, after = OF[self.lang]
            return [(*plain(before), *quantity_label("P", self.curves.name[1:]), *plain(after))]
        kinds = ("fixed", "moving") if self.curves.second == FRAME else ("on", "on")
        links = [link_label(self.curves.found.method.mechanism.called(link)) for link in self.curves.axes]
        starts = [plain(CURVES[kind][self.lang]) for kind in kinds]
        return [(*start, *link, *plain(END[self.lang])) for start, link in zip(starts, links, strict=True)]


def _once(places: list[Place]) -> list[Place]:
    """A curve that comes back to its first place and goes on over itself, up to there: dashes must not cover gaps."""
    import shapely

    away = np.abs(np.array(places) - places[0])
    step = 2 * float(np.max(np.abs(np.diff(np.array(places)))))
    left = np.flatnonzero(away > 2 * step)
    back = np.flatnonzero(away[left[0] :] <= step) + left[0] if left.size else left
    if not back.size:
        return places
    end = int(back[0] + np.argmin(away[back[0] : back[0] + 8])) + 1
    if end + 1 >= len(places):
        return places
    rest = shapely.points([(z.real, z.imag) for z in places[end:]])
    line = shapely.LineString([(z.real, z.imag) for z in places[: end + 1]])
    return places[: end + 1] if np.all(shapely.distance(line, rest) < _AGAIN) else places


def _lengths(places: Sequence[Place]) -> np.ndarray:
    """Length of a curve up to each of its places."""
    return np.concatenate([[0.0], np.cumsum(np.abs(np.diff(np.array(places))))])
