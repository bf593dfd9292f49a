"""The sheet: a mechanism and its polygons on paper, as a value in millimetres.

`sheet(method, plot)` turns the points of a replay into marks (`marks`): the mechanism with its signs
(`mechanism_figure`, `symbols`), the polygons (`polygons`), tables and title, each figure in a room of the
smallest paper that holds all (`layout`), and labels where nothing else lies (`labels`). What file it goes
into is `graphkin.outputs`' business. `centre_sheet` is the sheet of instant centres, made of the `centre_*` modules.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from importlib import import_module

from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.sheet.composition import Composed, compose, scales_of
from graphkin.sheet.marks import Mark, Place
from graphkin.sheet.paper import PAPERS, Paper
from graphkin.sheet.scales import TooLargeForPaper, UnknownPaper
from graphkin.sheet.window import PLANES, step_count
from graphkin.value import frozen

__all__ = [
    "PAPERS", "Paper", "Sheet", "TooLargeForPaper", "UnknownPaper", "scales_of", "sheet", "step_count", "step_sheets",
]  # fmt: skip


@frozen
class Sheet:
    """A finished drawing.

    marks    in the order of painting [mm, y down]
    scales   by plane [m/mm, (m/s)/mm, (m/s²)/mm]; origins: where each plane's origin lies on the paper
    drivers  their values at the drawn position [rad, m]
    """

    paper: Paper
    marks: tuple[Mark, ...]
    scales: Mapping[Plane, float]
    origins: Mapping[Plane, Place]
    mechanism: Mechanism
    drivers: tuple[float, ...]
    title: str
    lang: Lang

    def _repr_svg_(self) -> str:
        """How a notebook shows it. Writers come after sheets, so the one for SVG is looked up by name here."""
        writer = import_module("graphkin.outputs.svg")
        return str(writer.svg(self))


def sheet(
    method: Method,
    plot: Plot,
    *,
    paper: str | None = None,
    lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None,
    upto: int | None = None,
) -> Sheet:
    """Draw a mechanism and its polygons to scale.

    plot   the method replayed at one position
    paper  a key of `PAPERS`; the smallest that fits where left out
    only   the plane or planes to draw; all three where left out
    upto   draw the construction as far as this step (1 to `step_count(method)`), its newest marks emphasised

    Raises TooLargeForPaper where a scale of the mechanism file is too fine for A3.
    """
    composed = compose(method, plot, _planes(only), paper, lang, stages=upto is not None)
    whole = _sheet(method, plot, composed, lang)
    return whole if upto is None else _at_step(whole, upto)


def step_sheets(
    method: Method,
    plot: Plot,
    *,
    paper: str | None = None,
    lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None,
) -> Iterator[Sheet]:
    """One sheet a step, as `sheet(.., upto=step)` gives them, drawn and lettered only once."""
    whole = _sheet(method, plot, compose(method, plot, _planes(only), paper, lang, stages=True), lang)
    for step in range(1, step_count(method) + 1):
        yield _at_step(whole, step)


def _planes(only: Plane | Collection[Plane] | None) -> tuple[Plane, ...]:
    wanted = PLANES if only is None else (only,) if isinstance(only, str) else only
    return tuple(plane for plane in PLANES if plane in wanted)


def _sheet(method: Method, plot: Plot, composed: Composed, lang: Lang) -> Sheet:
    return Sheet(
        paper=composed.layout.paper,
        marks=tuple(composed.marks),
        scales=composed.layout.scales,
        origins=composed.origins,
        mechanism=method.mechanism,
        drivers=tuple(float(value) for value in plot.facts.values),
        title=method.mechanism.headline(lang),
        lang=lang,
    )


def _at_step(whole: Sheet, upto: int) -> Sheet:
    """What is there after a step; its own marks are new."""
    marks = (mark for mark in whole.marks if mark.step is None or mark.step <= upto)
    return replace(whole, marks=tuple(replace(m, new=True) if m.step == upto else m for m in marks))
