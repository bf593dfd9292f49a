"""The mechanism to scale with the link vectors of its polygons drawn over it, each with its letter."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from functools import partial

from graphkin.base.geometry import number, place
from graphkin.base.rooms import corners
from graphkin.base.scales import finest
from graphkin.equations.expressions import Symbol
from graphkin.equations.legend import point_place
from graphkin.equations.model import Model
from graphkin.equations.polygons import LinkVector
from graphkin.errors import Lang
from graphkin.sheet import Sheet
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run
from graphkin.sheet.marks import ArcMark, Stroke, VectorMark
from graphkin.sheet.mechanism_figure import mechanism_figure, mechanism_places
from graphkin.sheet.page import Page, Panel
from graphkin.sheet.paper import Paper
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Extent, Figure, Window

_ROOM = complex(130.0, 95.0)  # the largest the mechanism's points may reach [mm]
_MARGIN = 9.0  # room that letters need around it [mm]
_ARC = 8.0  # radius of the arcs that show angles [mm]
_VECTORS = 1  # the step the vectors and their letters are marked with, until they are coloured


def figure(model: Model, caption: str, lang: Lang) -> Sheet:
    """At the drawn position, at the finest standard scale that fits a page of text, on a paper cut to its size. Vectors
    and their letters stand out; steps of a construction there are none."""
    method, places = model.method, mechanism_places(model.method, model.plot)
    sides = (polygon.sides for task in model.tasks for polygon in task.polygons)
    by_length: dict[Symbol, LinkVector] = {}
    for left, right in sides:
        for arrow in (*left, *right):
            by_length.setdefault(arrow.length, arrow)
    arrows = list(by_length.values())
    low, high = corners([*places, *(end for arrow in arrows for end in _ends(model, arrow))])
    draw = partial(_draw, model, places, arrows)
    scale = finest(high - low, _ROOM)
    extent = Extent.of([low, high], draw, scale, letters=_MARGIN)
    whole = extent.cut_out(scale)
    window = extent.window(whole, scale)
    panel = Panel(draw(window), window, whole.inset(1, 1, 1), plane=None)
    page = Page(Paper("figure", whole.right, whole.bottom, 0.0), [panel], method.mechanism, (), lang, title=caption)
    return page.sheet().upto(_VECTORS).redrawn(lambda mark: replace(mark, step=None))


def _draw(model: Model, places: list[complex], arrows: list[LinkVector], window: Window) -> Figure:
    """Links as thin lines under their vectors; an arc for each θ that an arrow points along."""
    skeleton = Skeleton(model.method.mechanism, model.plot, window, {})
    drawing = mechanism_figure(skeleton, model.method, places).numbered(None)
    drawing.marks = [replace(mark, pen="thin") if isinstance(mark, Stroke) and mark.pen == "visible" else mark
                     for mark in drawing.marks]  # fmt: skip
    with_arc: set[Symbol] = set()
    values = model.values
    for arrow in arrows:
        start, end = (window(value) for value in _ends(model, arrow))
        label = symbol_label(arrow.length)
        name = "".join(run.text for run in label)
        drawing.marks.append(VectorMark("position", name, arrow.tail[0], arrow.head[0], start, end, _VECTORS))
        drawing.wanted.append(LabelRequest(label, start, end, gap=1.0, step=_VECTORS))
        theta, count = arrow.angle.parts[0] if len(arrow.angle.parts) == 1 else (None, 0)
        if theta is not None and count == 1 and not arrow.angle.quarters and theta not in with_arc:
            with_arc.add(theta)
            value, radius = number(values[theta]), min(_ARC, 0.6 * abs(end - start))
            sweep = value if abs(value) <= math.tau else math.remainder(value, math.tau)
            if not theta.moves or radius < _ARC / 2 or abs(sweep) < math.radians(8):
                continue  # no room for an arc from the x axis to the arrow
            drawing.marks.append(Stroke((start, start + 1.4 * radius), "construction", step=_VECTORS))
            drawing.marks.append(ArcMark(start, radius, 0.0, -sweep, "thin", step=_VECTORS))
            away = cmath.rect(1.0, -sweep / 2)
            drawing.wanted.append(LabelRequest(symbol_label(theta), start + radius * away, away=away, step=_VECTORS))
    return drawing


def _ends(model: Model, arrow: LinkVector) -> tuple[complex, complex]:
    """Tail and head [m]; a displacement counted negative points from its origin to the point all the same."""
    tail, head = (place(point_place(model.method.structure, *site, model.motion)) for site in (arrow.tail, arrow.head))
    return tail, head


def symbol_label(symbol: Symbol) -> Label:
    """A symbol lettered as in drawings."""
    low = (Run(symbol.low, not symbol.low.isdigit(), "sub"),) if symbol.low else ()
    primes = (Run("′" * symbol.primes),) if symbol.primes else ()
    return (Run(symbol.letter, True), *low, *primes)
