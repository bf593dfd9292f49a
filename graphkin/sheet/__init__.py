"""The sheet: a mechanism and its polygons on paper, as a value in millimetres.

`sheet(method, plot)` turns the points of a replay into marks (`marks`): the mechanism with its signs
(`mechanism_figure`, `symbols`), the polygons (`polygons`), tables and title, each figure in a room of the
smallest paper that holds all (`layout`), and labels where nothing else lies (`labels`). What file it goes
into is `graphkin.outputs`' business.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace

from graphkin.errors import Lang
from graphkin.mechanism import Mechanism
from graphkin.methods import Method
from graphkin.sheet.composition import compose
from graphkin.sheet.marks import Mark, Place
from graphkin.sheet.paper import PAPERS, Paper
from graphkin.sheet.scales import TooLargeForPaper, UnknownPaper
from graphkin.sheet.window import step_count
from graphkin.steps import Plane, Plot

__all__ = ["PAPERS", "Paper", "Sheet", "TooLargeForPaper", "UnknownPaper", "sheet", "step_count"]


@dataclass(frozen=True)
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
        from graphkin.outputs.svg import svg

        return svg(self)


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
    planes: tuple[Plane, ...] = ("position", "velocity", "acceleration")
    if only is not None:
        wanted = (only,) if isinstance(only, str) else only
        planes = tuple(plane for plane in planes if plane in wanted)
    composed = compose(method, plot, planes, paper, lang, upto)
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
