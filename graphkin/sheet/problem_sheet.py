"""The figure of a problem: the mechanism with its letters, and nothing that is found of it."""

from __future__ import annotations

from graphkin.construction import Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.sheet.alone import place_for
from graphkin.sheet.composed import HEADINGS
from graphkin.sheet.page import Sheet
from graphkin.sheet.plain_mechanism import bare_figure, mechanism_places, plainly
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Figure


def problem_sheet(method: Method, plot: Plot, lang: Lang) -> Sheet:
    """At the position of a plot, without results and in no step of a construction."""
    alone = place_for(method, [plot], mechanism_places(method, plot), None)
    bare = bare_figure(method, Skeleton(method.mechanism, plot, alone.window, {}))
    figure = Figure([plainly(mark) for mark in bare.marks], bare.wanted)
    return alone.sheet(plot, HEADINGS[lang]["position"], figure, lang)
