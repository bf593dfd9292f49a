"""Positions of a linkage of four links over each other, the first in thick lines, with its angles and lengths."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations

from graphkin.model.mechanism import FRAME
from graphkin.sheet import symbols
from graphkin.sheet.fixed_link import away_from, grounds
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, point_label, points_label
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Stroke
from graphkin.sheet.mechanism_figure import moving_links
from graphkin.sheet.paper import BODY
from graphkin.sheet.single_figure import Caption, Picture
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Extent, Figure, Window
from graphkin.studies.linkages import Linkage, Report
from graphkin.studies.linkages.assembled import posed
from graphkin.studies.linkages.linkage import LinkagePosition

Row = Sequence[LinkagePosition]  # positions drawn over each other

_SHORT = 8.0  # a shorter bar bears no letters of its own [mm]
_TRIAL = 80.0  # size of a figure when it is drawn to see how far its signs reach [mm]
_FOOT = 15.0  # how far from the guide the stroke's dimension line lies [mm]
_BESIDE_HINGE, _BESIDE_BLOCK = (0.42, 11.0, 30.0), (0.3, 14.0, 34.0)
"""Radius of psi: share of the output's arm, least and most [mm]; beside a block it needs more room."""
_SEEN = 0.05  # an arm that leaves its link's line by more does not show its direction [mm]
_SQUARE, _PAST_BLOCK, _RIGHT = 2.4, 6.5, 1e-6
"""Side of the square in a right angle, and where it is to be seen beside a block [mm]; its cosine is no larger."""
_NO_HEADS = 7.0  # an arc shorter than this has no arrow heads [mm]


def pictured(positions: Row, draw: Callable[[Window], Figure], caption: Caption) -> Picture:
    """A figure of these positions that wants a cell."""
    places = [place for position in positions for place in position.places]
    return Picture(Extent.of(places, draw, trial=_TRIAL), draw, caption)


def on_paper(position: LinkagePosition, window: Window) -> list[Place]:
    """The points of a linkage on paper [mm]."""
    return [window(place) for place in position.places]


def drawn_over(linkage: Linkage, positions: Row, window: Window, primes: bool = False) -> Figure:
    """Ground first, then the thin positions, then the thick one; moving points lettered with numbers or primes."""
    machine = linkage.mechanism()
    first, *others = (Skeleton(machine, posed(linkage, machine, position), window, {}) for position in positions)
    marks = list(grounds(first, *others).marks)
    for skeleton in reversed(others):
        for mark in _links(linkage, skeleton):
            marks.append(replace(mark, pen="thin") if isinstance(mark, Stroke | Disc) else mark)
    labels = [*_names(linkage, positions, first, primes)]
    named = zip(linkage.names, on_paper(positions[0], window), strict=True)
    for (one, start), (other, end) in combinations(named, 2):  # links by their ends, as their lengths are called
        name = next((name for name in (one + other, other + one) if name in linkage.sizes), "")
        if name and abs(end - start) > _SHORT:
            labels.append(LabelRequest(points_label(name), start, end, gap=1.2, size=BODY, spare=True))
    return Figure([*marks, *_links(linkage, first)], labels)


def _links(linkage: Linkage, skeleton: Skeleton) -> Iterator[Mark]:
    """Hinges as plain circles, for such a figure is looked at, not measured; points without a letter are not shown."""
    for mark in moving_links(skeleton):
        if not isinstance(mark, PointMark):
            yield mark
        elif mark.name in linkage.names:
            yield Disc(mark.at, mark.radius, "outline", mark.fill)


def _names(linkage: Linkage, positions: Row, first: Skeleton, primes: bool) -> Iterator[LabelRequest]:
    """Pivots once, moving points at every position."""
    places = [place for position in positions for place in position.places]
    window, centre = first.window, sum(places) / len(places)
    for k, name in enumerate(linkage.names):
        fixed = FRAME in first.mechanism.owners[name]
        for number, position in enumerate(positions[:1] if fixed else positions, start=1):
            at, label = window(position.places[k]), point_label(name)
            if primes and not fixed and len(positions) > 1:
                label = (*label, Run("′" * number))
            elif not fixed and len(positions) > 1:  # after a comma where the name has a subscript of its own
                comma = "," if any(run.place == "sub" for run in label) else ""
                label = (*label, Run(f"{comma}{number}", False, "sub"))
            yield LabelRequest(label, at, gap=symbols.HINGE + 0.4, away=at - window(centre))


def _degrees(sign: str, angle: float, primes: int = 0) -> Label:
    """`ψ = 40.54°`, `γ′ = 32.98°`."""
    index = (Run("′" * primes),) if primes else ()
    return (Run(sign, True), *index, Run(f" = {math.degrees(angle):.2f}°"))


def _arc(centre: Place, radius: float, start: complex, end: complex, label: Label) -> Figure:
    """The smaller arc between two directions on paper."""
    return _swept(centre, radius, cmath.phase(start), cmath.phase(end / start), label)


def _swept(centre: Place, radius: float, begin: float, sweep: float, label: Label) -> Figure:
    """An arc with arrow heads and its value; nothing for no angle."""
    if abs(sweep) < 1e-6:
        return Figure()
    marks: list[Mark] = [ArcMark(centre, radius, begin, sweep, "thin")]
    if abs(sweep) * radius > _NO_HEADS:
        for angle, side in ((begin, -1), (begin + sweep, 1)):
            turn = side * (1 if sweep > 0 else -1) * (math.pi / 2 - 1.5 / radius)
            tip = centre + cmath.rect(radius, angle)
            marks.append(symbols.arrow_head(tip, cmath.rect(1, angle + turn), None))
    middle = cmath.rect(1, begin + sweep / 2)
    return Figure(marks, [LabelRequest(label, centre + radius * middle, gap=0.6, away=middle, size=BODY + 0.3)])


def dimensioned_limits(report: Report, window: Window) -> Figure:
    """psi or H between the limits, and theta at the crank's pivot."""
    figure = _theta(report, window)
    for end in report.limits:
        if end.how == "across":  # a crank at right angles to a bar that slides over its pin
            first, pin, last = on_paper(end, window)[:3]
            figure.marks += _square(pin, first - pin, last - pin, _PAST_BLOCK)
    if report.swing is not None:
        figure += _psi(report, window)
    elif report.stroke is not None:
        figure += _stroke(report, report.stroke, window)
    return figure


def _square(at: Place, one: complex, other: complex, side: float = _SQUARE) -> Iterator[Mark]:
    """Between two lines through a point that stand at right angles."""
    one, other = one / abs(one), other / abs(other)
    if abs((one.conjugate() * other).real) < _RIGHT:
        yield Stroke((at + side * one, at + side * (one + other), at + side * other), "construction")


def _psi(report: Report, window: Window) -> Figure:
    """At the output's pivot, over its range."""
    pivot, tip = report.linkage.arm
    first = on_paper(report.limits[0], window)
    at, span = first[pivot], report.output_range
    share, least, most = _BESIDE_BLOCK if report.slide else _BESIDE_HINGE
    radius = min(max(share * abs(first[tip] - at), least), most)
    figure = _swept(at, radius, -span.low, -span.width, _degrees("ψ", span.width))
    for end in report.limits:
        along = window.turned(cmath.rect(1, end.output))
        arm = on_paper(end, window)[tip] - at
        if abs((along.conjugate() * arm).imag) > _SEEN:
            figure.marks.append(Stroke((at, at + along * (radius + 3)), "construction"))
    return figure


def _theta(report: Report, window: Window) -> Figure:
    """Between the crank at the first limit and the crank at the second, carried on beyond its pivot."""
    figure = Figure()
    if report.theta is None or report.theta < 1e-6 or report.timed_by:
        return figure
    order = -1 if report.linkage.driver == "rocker" else 1
    first, second = (on_paper(end, window)[::order] for end in report.limits)
    at, start, end = first[0], first[1] - first[0], second[0] - second[1]
    radius = max(abs(start) + 7.0, 13.0)
    if report.limits[0].how == "across":
        lines = (at, at + end / abs(end) * (radius + 3)), (first[1], at + start / abs(start) * (radius + 3))
        figure.marks += [Stroke(line, "construction") for line in lines]
    return figure + _arc(at, radius, start / abs(start), end / abs(end), _degrees("θ", report.theta))


def _stroke(report: Report, length: float, window: Window) -> Figure:
    """A dimension line beside the guide, on the side of the ground."""
    along = window.turned(cmath.rect(1, report.limits[0].turn))
    places = [on_paper(end, window) for end in report.limits]
    one, other = (there[-1] for there in places)
    side = away_from(one, along, [place for there in places for place in there])
    start, end = one + _FOOT * side, other + _FOOT * side
    marks: list[Mark] = []
    for place in (one, other):
        marks.append(Stroke((place + 4.5 * side, place + (_FOOT + 1.5) * side), "construction"))
    forward = (end - start) / abs(end - start)
    heads = [symbols.arrow_head(start, -forward, None), symbols.arrow_head(end, forward, None)]
    marks += [Stroke((start, end), "thin"), *heads]
    label: Label = (Run("H", True), Run(f" = {length * 1e3:.2f} mm"))
    return Figure(marks, [LabelRequest(label, start, end, gap=0.4, away=side, size=BODY + 0.3)])


def dimensioned_transmission(report: Report, positions: tuple[LinkagePosition, ...], window: Window) -> Figure:
    """gamma at each position; for a slider the pressure angle alpha, which is seen against the guide."""
    figure = Figure()
    for number, end in enumerate(positions, start=1):
        angle, gamma = report.linkage.seen(end), end.gamma or 0.0
        if angle is None:
            continue
        radius, label = 15.0, _degrees("γ", gamma, number)
        if angle.pressure:
            radius, label = 8.0 + 8.0 * number, _degrees("α", math.pi / 2 - gamma, number)
        at, one, other = window(angle.at), window.turned(angle.one), window.turned(angle.other)
        one, other = one / abs(one), other / abs(other)
        one = -one if (one.conjugate() * other).real < 0 else one  # the acute angle; what no link shows is drawn on
        figure.marks += [Stroke((at, at + along * (radius + 3)), "construction") for along in (one, other)]
        figure.marks += _square(at, one, other)
        figure += _arc(at, radius, one, other, label)
    return figure
