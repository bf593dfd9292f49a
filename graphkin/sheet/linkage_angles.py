"""Angles and lengths dimensioned in a linkage's figure: psi, theta, gamma, alpha as arcs, the stroke H as a line."""

from __future__ import annotations

import cmath
import math

from graphkin.linkages import FourBar, GuideBar, Report, SliderCrank
from graphkin.linkages.linkage import Position
from graphkin.sheet import symbols
from graphkin.sheet.labels import Wanted
from graphkin.sheet.lettering import Label, Run
from graphkin.sheet.linkage_figure import guide_side, on_paper
from graphkin.sheet.marks import Arc, Mark, Place, Stroke
from graphkin.sheet.paper import BODY
from graphkin.sheet.window import Figure, Window

__all__ = ["dimensioned_limits", "dimensioned_transmission"]

_FOOT = 15.0
"""How far from the guide the stroke's dimension line lies [mm]."""
_NO_HEADS = 7.0
"""An arc shorter than this has no arrow heads [mm]."""


def _degrees(sign: str, angle: float, primes: int = 0) -> Label:
    """`ψ = 40.54°`, `γ′ = 32.98°`."""
    index = (Run("′" * primes),) if primes else ()
    return (Run(sign, True), *index, Run(f" = {math.degrees(angle):.2f}°"))


def _arc(centre: Place, radius: float, start: complex, end: complex, label: Label) -> Figure:
    """The smaller arc between two directions on paper, with arrow heads and its value; nothing for no angle."""
    return _swept(centre, radius, cmath.phase(start), cmath.phase(end / start), label)


def _swept(centre: Place, radius: float, begin: float, sweep: float, label: Label) -> Figure:
    figure = Figure()
    if abs(sweep) < 1e-6:
        return figure
    figure.marks.append(Arc(centre, radius, begin, sweep, "thin"))
    if abs(sweep) * radius > _NO_HEADS:
        for angle, way in ((begin, -1), (begin + sweep, 1)):
            turn = way * (1 if sweep > 0 else -1) * (math.pi / 2 - 1.5 / radius)
            tip = centre + cmath.rect(radius, angle)
            figure.marks.append(symbols.arrow_head(tip, cmath.rect(1, angle + turn), None))
    middle = cmath.rect(1, begin + sweep / 2)
    figure.wanted.append(Wanted(label, centre + radius * middle, gap=0.6, away=middle, size=BODY + 0.3))
    return figure


def _joined(*figures: Figure) -> Figure:
    whole = Figure()
    for figure in figures:
        whole.marks += figure.marks
        whole.wanted += figure.wanted
    return whole


# --- limits -------------------------------------------------------------------------------------


def dimensioned_limits(report: Report, window: Window) -> Figure:
    """psi or H between the limits, and theta at the crank's pivot."""
    first, second = report.limits
    parts = [_theta(report, window)]
    if report.swing is not None:
        parts.append(_psi(report, window))
    elif isinstance(report.linkage, SliderCrank):
        parts.append(_stroke(report.linkage, first, second, report.stroke or 0.0, window))
    return _joined(*parts)


def _psi(report: Report, window: Window) -> Figure:
    """At the output's pivot, over its range."""
    linkage, first = report.linkage, report.limits[0]
    pivot, tip = _output(report)
    at, reach = window(first.places[pivot]), abs(window(first.places[tip]) - window(first.places[pivot]))
    radius = min(max(0.42 * reach, 11.0), 30.0) if isinstance(linkage, FourBar) else min(max(0.3 * reach, 14.0), 34.0)
    span = report.output_range
    figure = _swept(at, radius, -span.low, -span.width, _degrees("ψ", span.width))
    if isinstance(linkage, GuideBar) and linkage.offset and report.linkage.driver == "crank":
        for end in report.limits:
            along = window.turned(cmath.rect(1, end.turn))
            figure.marks.append(Stroke((at, at + along * (radius + 3)), "construction"))
    return figure


def _output(report: Report) -> tuple[int, int]:
    """Which places are the output's pivot and its moving hinge."""
    linkage = report.linkage
    if isinstance(linkage, FourBar):
        return (0, 1) if linkage.driver == "rocker" else (3, 2)
    return (2, 1) if isinstance(linkage, GuideBar) and linkage.driver == "crank" else (0, 1)


def _theta(report: Report, window: Window) -> Figure:
    """Between the crank at the first limit and the crank at the second, carried on beyond its pivot."""
    figure = Figure()
    if report.theta is None or report.theta < 1e-6 or report.timed_by:
        return figure
    order = -1 if report.linkage.driver == "rocker" else 1
    first, second = (on_paper(end, window)[::order] for end in report.limits)
    at, start, end = first[0], first[1] - first[0], second[0] - second[1]
    radius = max(abs(start) + 7.0, 13.0)
    if isinstance(report.linkage, GuideBar):
        figure.marks.append(Stroke((at, at + end / abs(end) * (radius + 3)), "construction"))
        figure.marks.append(Stroke((first[1], at + start / abs(start) * (radius + 3)), "construction"))
    return _joined(figure, _arc(at, radius, start / abs(start), end / abs(end), _degrees("θ", report.theta)))


def _stroke(slider: SliderCrank, first: Position, second: Position, length: float, window: Window) -> Figure:
    """A dimension line beside the guide, on the side of the ground."""
    along = window.turned(cmath.rect(1, slider.way))
    a, one, other = window(first.places[0]), window(first.places[2]), window(second.places[2])
    foot = one - along * ((one - a) * along.conjugate()).real
    side = guide_side(foot, a, along)
    ends = [place + _FOOT * side for place in (one, other)]
    marks: list[Mark] = [
        Stroke((place + 4.5 * side, place + (_FOOT + 1.5) * side), "construction") for place in (one, other)
    ]
    marks.append(Stroke((ends[0], ends[1]), "thin"))
    way = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
    marks += [symbols.arrow_head(ends[0], -way, None), symbols.arrow_head(ends[1], way, None)]
    label: Label = (Run("H", True), Run(f" = {length * 1e3:.2f} mm"))
    return Figure(marks, [Wanted(label, ends[0], ends[1], gap=0.4, away=side, size=BODY + 0.3)])


# --- transmission -------------------------------------------------------------------------------


def dimensioned_transmission(report: Report, positions: tuple[Position, ...], window: Window) -> Figure:
    """gamma at each position; for a slider the pressure angle alpha, which is seen against the guide."""
    return _joined(*(_gamma(report, end, window, number) for number, end in enumerate(positions, start=1)))


def _gamma(report: Report, end: Position, window: Window, number: int) -> Figure:
    linkage, places = report.linkage, on_paper(end, window)
    gamma, radius = end.gamma or 0.0, 8.0 + 8.0 * number
    if isinstance(linkage, FourBar):
        one, other = places[2] - places[1], places[3] - places[2]
        if linkage.driver == "rocker":
            return _between(places[1], places[1] - places[2], places[0] - places[1], 15.0, _degrees("γ", gamma, number))
        return _between(places[2], one, other, 15.0, _degrees("γ", gamma, number))
    if isinstance(linkage, SliderCrank) and linkage.driver == "crank":
        along = window.turned(cmath.rect(1, linkage.way))
        rod = places[1] - places[2]
        along = along if (along.conjugate() * rod).real > 0 else -along
        return _between(places[2], along, rod, radius, _degrees("α", math.pi / 2 - gamma, number))
    if isinstance(linkage, SliderCrank):
        return _between(places[1], places[1] - places[0], places[2] - places[1], 15.0, _degrees("γ", gamma, number))
    return Figure()


def _between(at: Place, one: complex, other: complex, radius: float, label: Label) -> Figure:
    """The acute angle between two lines through a point; what no link shows is drawn on."""
    figure = Figure()
    one, other = one / abs(one), other / abs(other)
    if (one.conjugate() * other).real < 0:
        one = -one
    for way in (one, other):
        figure.marks.append(Stroke((at, at + way * (radius + 3)), "construction"))
    return _joined(figure, _arc(at, radius, one, other, label))
