"""The mechanism for sheets that are looked at, not measured: its points are plain circles."""

from __future__ import annotations

from graphkin.construction import Plot
from graphkin.planning import Method
from graphkin.planning.method import births
from graphkin.sheet.marks import Disc, Mark, PointMark
from graphkin.sheet.mechanism_figure import mechanism_figure
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.specials import named_specials, specials
from graphkin.sheet.wheels import equivalents, rims
from graphkin.sheet.window import Figure, Window


def mechanism_places(method: Method, plot: Plot) -> list[complex]:
    """The places that the mechanism itself takes up [m]."""
    machine, points = method.mechanism, plot.position
    return [*(complex(points[p]) for p in machine.points if p in points), *rims(machine, points)]


def shown_places(method: Method, plot: Plot) -> list[complex]:
    """The places its figure shows: the mechanism's, and special points near it [m]."""
    places = mechanism_places(method, plot)
    return [*places, *named_specials(method, plot, places).values()]


def plain_mechanism(method: Method, plot: Plot, window: Window) -> Figure:
    """The mechanism's own figure with its points as circles."""
    born = births(method, "position")
    figure = mechanism_figure(Skeleton(method.mechanism, plot, window, born), method, shown_places(method, plot))
    return Figure([plainly(mark) for mark in figure.marks], figure.wanted)


def bare_figure(method: Method, skeleton: Skeleton) -> Figure:
    """The mechanism as a problem gives it: no special points and no lower-pair equivalents, which a solution finds."""
    whole, beside = mechanism_figure(skeleton, method, []), specials(method, skeleton, [])
    left_out = [*beside.marks, *equivalents(skeleton)]
    marks = [mark for mark in whole.marks if mark not in left_out]
    return Figure(marks, [want for want in whole.wanted if want not in beside.wanted])


def plainly(mark: Mark) -> Mark:
    """A point as a circle and nothing more."""
    if not isinstance(mark, PointMark):
        return mark
    return Disc(mark.at, mark.radius, "outline" if mark.fill == "paper" else "construction", mark.fill, step=mark.step)
