"""The sheet of a design: the construction at true scale, its limit positions, and the linkage that was found.

`design_sheet` draws all, `design_step_sheets` one numbered sentence after the other.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from graphkin import planning
from graphkin.base import geometry
from graphkin.construction import Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.proof.roads import proved
from graphkin.say.design import error, mechanism_of
from graphkin.sheet.design_figure import DesignFigure
from graphkin.sheet.lettering import Label, Run, joined, number, plain, point_label
from graphkin.sheet.marks import Text
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.sheet.page import Sheet, step_sheets
from graphkin.sheet.paper import LABEL
from graphkin.sheet.single_figure import SingleFigure, place_for
from graphkin.sheet.window import enlarged
from graphkin.studies.design import Design, Solution

_COLUMN, _LINE = 42.0, 6.2
"""Between sizes in the strip [mm]."""
_MOST = 3.0  # so many times larger than the linkage the figure may become, for centres and circles
_HEADING: dict[Lang, str] = {"en": "Design by construction", "zh": "图解设计"}


def design_sheet(
    design: Design, *, solution: Solution | None = None, paper: str | None = None, lang: Lang = "en"
) -> Sheet:
    """Draw a design that has a solution: the best one, or the one given. Raises NoDesign, UnknownPaper."""
    chosen = solution or design.best
    if chosen is None:
        raise error(design) or AssertionError("a design without a best solution has none")
    method = planning.plan(mechanism_of(chosen, design.kind))
    plot, last = proved(method).plot, len(chosen.construction.stages) + 1
    on = _page(chosen, method, plot, paper)
    construction, machine = DesignFigure(chosen, on, design.families), on.mechanism(plot).numbered(last)
    for k, want in enumerate(machine.wanted):  # with the construction's letters for that place; pivots from the start
        name = next((name for name in "ABCD" if want.label == point_label(name)), "")
        if name in construction.places:
            machine.wanted[k] = replace(want, step=chosen.construction.born(name))
        elif name and (also := construction.also(name)):
            machine.wanted[k] = replace(want, label=joined([want.label, *map(point_label, also)]))
    corner = complex(on.layout.strip.left + 3, on.layout.strip.top + 6)
    sizes = [Text(label, corner + complex(_COLUMN * (k % 2), _LINE * (k // 2)), LABEL, last)
             for k, label in enumerate(_sizes(chosen))]  # fmt: skip
    return on.sheet(plot, _HEADING[lang], construction.figure() + machine, lang, after=sizes)


def design_step_sheets(
    design: Design, *, solution: Solution | None = None, paper: str | None = None, lang: Lang = "en"
) -> Iterator[Sheet]:
    """One sheet a numbered sentence that draws something; what it adds is emphasised. The linkage comes last."""
    whole = design_sheet(design, solution=solution, paper=paper, lang=lang)
    yield from step_sheets(whole, sorted({mark.step for mark in whole.marks if mark.step is not None}))


def _page(one: Solution, method: Method, plot: Plot, paper: str | None) -> SingleFigure:
    """Room for the linkage at all positions, the construction's points, and its circle if that is not too large."""
    board = one.board()
    values = shown_places(method, plot) + [place for places in one.limits for place in places.values()]
    values = enlarged(values, map(geometry.place, board.places.values()), _MOST)
    if "locus" in board.circles:
        centre, radius = geometry.place(board.circles["locus"][0]), geometry.number(board.circles["locus"][1])
        sides = [centre + radius * side for side in (1, 1j, -1, -1j)]
        wider = enlarged(values, sides, _MOST)
        values = wider if all(place in wider for place in sides) else values
    return place_for(method, [plot], values, paper)


def _sizes(one: Solution) -> Iterator[Label]:
    named = {"AB": one.a, "BC": one.b, "CD": one.c, ("AC" if one.shape == "guide-bar" else "AD"): one.d}
    for name, size in named.items():
        if size is not None:
            yield (Run("l", True), Run(name, True, "sub"), Run(" = "), *number(1e3 * size, 5), *plain(" mm"))
    if one.shape == "slider-crank" and one.e is not None:
        yield (Run("e", True), Run(" = "), *number(1e3 * one.e, 5), *plain(" mm"))
    if one.gamma_min is not None:
        gamma = number(math.degrees(one.gamma_min), 5)
        yield (Run("γ", True), Run("min", False, "sub"), Run(" = "), *gamma, *plain("°"))
