"""Centrodes on paper: the fixed curve and the moving one that rolls on it, with the mechanism at a position."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.construction import Plot
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.running.path import along
from graphkin.say.centre_curves import curves_met
from graphkin.sheet.curves import clipped
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, link_label, plain, quantity_label
from graphkin.sheet.marks import Disc, Mark, Place, Stroke
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import PenName
from graphkin.sheet.single_figure import SingleFigure, place_for
from graphkin.sheet.window import Figure, corners, enlarged
from graphkin.studies.centres.centrodes import Centrodes

_ROUND = 0.75
"""Curves are shown so far around the mechanism, as part of its size."""
_CENTRE = 2.0
"""So many times larger the figure may become to show the centre itself."""
_AGAIN = 0.03
"""A curve that runs over itself within this is drawn once [mm]."""
_FIXED: PenName = "visible"
_MOVING: PenName = "dashed"

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
    """Both curves (or a path) with the mechanism at t on the way, 0 being the drawn position.

    Raises UnknownPaper.
    """
    plot = plot_at(curves, t)
    on = centrode_page(curves, [t], paper, [*curves_met(curves, centre_at(curves, t), lang)])
    figure = Figure([*centrode_marks(curves, t, on)])
    figure.wanted += _names(curves, t, on, figure.marks, lang)
    figure += on.mechanism(plot)
    centre = centre_at(curves, t)
    if centre is not None and on.room.holds(on.window(centre)):
        figure.marks.append(Disc(on.window(centre), 1.0, "vector", "paper"))
        figure.wanted.append(LabelRequest(quantity_label("P", curves.name[1:]), on.window(centre), gap=1.2))
    return on.sheet(plot, heading(curves, lang), figure, lang)


def heading(curves: Centrodes, lang: Lang) -> str:
    """What the figure is."""
    if len(curves.axes) == 1:
        return PATH[lang].format(name=curves.name)
    called = curves.found.method.mechanism.called
    return HEADING[lang].format(first=called(curves.first), second=called(curves.second))


def plot_at(curves: Centrodes, t: float) -> Plot:
    """The mechanism at t on the way."""
    return along(curves.found.method, curves.path, t)


def centrode_page(
    curves: Centrodes, times: Sequence[float], paper: str | None, told: Sequence[str] = ()
) -> SingleFigure:  # fmt: skip
    """A page with room for the mechanism at all these t, and for the curves near it; told: sentences in its strip."""
    method = curves.found.method
    plots = [plot_at(curves, t) for t in times]
    values = [place for plot in plots for place in shown_places(method, plot)]
    low, high = corners(values)
    size = max((high - low).real, (high - low).imag)
    places = np.concatenate([curve for t in times for link in curves.axes for curve in _carried(curves, link, t)])
    more = _ROUND * size * (1 + 1j)
    near = places[_between(places, low - more, high + more)]
    centre = centre_at(curves, times[0])
    shown = enlarged([*values, *(corners(near) if near.size else ())], [] if centre is None else [centre], _CENTRE)
    return place_for(method, plots, shown, paper, told=told)


def _between(places: np.ndarray, low: complex, high: complex) -> np.ndarray:
    across = (low.real <= places.real) & (places.real <= high.real)
    return np.asarray(across & (low.imag <= places.imag) & (places.imag <= high.imag))


def _carried(curves: Centrodes, link: str, t: float) -> list[np.ndarray]:
    """The curve on a link, as the link stands at t [m]."""
    origin, turn = curves.standing(link, t)
    found = curves.fixed if link == curves.axes[0] else curves.moving
    return [origin + turn * curve for curve in found]


def centrode_marks(curves: Centrodes, t: float, on: SingleFigure) -> Iterator[Mark]:
    """The curves as far as they lie in the room; a centre that stays at one point is a dot."""
    for link, pen in zip(curves.axes, (_FIXED, _MOVING), strict=False):
        yield from _curve(curves, link, t, on, pen)


def _curve(curves: Centrodes, link: str, t: float, on: SingleFigure, pen: PenName) -> Iterator[Stroke]:
    for curve, piece in zip(_carried(curves, link, t), curves.pieces, strict=True):
        places = [*(on.window.origin + np.conj(curve) / on.window.scale)]
        yield from clipped([*places, places[0]] if piece.closed else _once(places), on.room, pen)


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


def centre_at(curves: Centrodes, t: float) -> complex | None:
    """Where the centre is at t, if the curves were followed there [m]."""
    origin, turn = curves.standing(curves.axes[0], t)
    for piece in curves.pieces:
        if piece.t[0] <= t <= piece.t[-1]:
            place = np.interp(t, piece.t, piece.places[0].real) + 1j * np.interp(t, piece.t, piece.places[0].imag)
            return complex(origin + turn * place)
    return None


# --- names ------------------------------------------------------------------------------------


def _names(curves: Centrodes, t: float, on: SingleFigure, marks: Sequence[Mark], lang: Lang) -> Iterator[LabelRequest]:
    """Each curve's name at the longest part that is on the paper."""
    for k, (pen, label) in enumerate(zip((_FIXED, _MOVING), _labels(curves, lang), strict=False)):
        strokes = [mark for mark in marks if isinstance(mark, Stroke) and mark.pen == pen]
        if strokes:
            places = max(strokes, key=_length).places
            yield LabelRequest(label, _at(places, (0.25, 0.75)[k]), gap=1.2)


def _labels(curves: Centrodes, lang: Lang) -> list[Label]:
    if len(curves.axes) == 1:
        before, after = OF[lang]
        return [(*plain(before), *quantity_label("P", curves.name[1:]), *plain(after))]
    kinds = ("fixed", "moving") if curves.second == FRAME else ("on", "on")
    called = curves.found.method.mechanism.called
    return [
        (*plain(CURVES[kind][lang]), *link_label(called(link)), *plain(END[lang]))
        for kind, link in zip(kinds, curves.axes, strict=True)
    ]


def _length(stroke: Stroke) -> float:
    return float(np.sum(np.abs(np.diff(np.array(stroke.places)))))


def _at(places: Sequence[Place], share: float) -> Place:
    """The place at a part of a curve's length."""
    steps = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(np.array(places))))])
    k = int(np.searchsorted(steps, share * steps[-1]))
    return places[min(k, len(places) - 1)]
