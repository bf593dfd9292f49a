"""The mechanism to scale with the link vectors of its polygons drawn over it, each with its letter."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from graphkin.equations.model import Model
from graphkin.equations.polygons import LinkVector
from graphkin.equations.readers import place
from graphkin.equations.symbols import Symbol
from graphkin.errors import Lang
from graphkin.sheet import Sheet
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run
from graphkin.sheet.marks import ArcMark, Mark, Place, Stroke, VectorMark
from graphkin.sheet.mechanism_figure import mechanism_figure, mechanism_places
from graphkin.sheet.page import Page, Panel
from graphkin.sheet.paper import Paper, finest
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Figure, Window, corners, cut_out

_ROOM = complex(130.0, 95.0)
"""The largest the mechanism's points may reach [mm]."""
_MARGIN = 9.0
"""What letters need around it [mm]."""
_ARC = 8.0
"""Radius of the arcs that show angles [mm]."""
_VECTORS = 1
"""The step the vectors and their letters are marked with, until they are coloured."""


def figure(model: Model, caption: str, lang: Lang) -> Sheet:
    """At the drawn position, at the finest standard scale that fits a page of text, on a paper cut to its size.

    Vectors and their letters stand out; steps of a construction there are none.
    """
    method, arrows = model.method, list(_arrows(model))
    places = mechanism_places(method, model.plot)
    low, high = corners([*places, *(end for arrow in arrows for end in _ends(model, arrow))])
    draw = partial(_drawn, model, places, arrows)
    window, whole = cut_out(draw, finest(high - low, _ROOM), _MARGIN)
    panel = Panel(draw(window), window, whole.inset(1, 1, 1), plane=None)
    page = Page(Paper("figure", whole.right, whole.bottom, 0.0), [panel], method.mechanism, (), lang, title=caption)
    return page.sheet().upto(_VECTORS).redrawn(lambda mark: replace(mark, step=None))


def _thin(mark: Mark) -> Mark:
    """Links as thin lines under their vectors."""
    if isinstance(mark, Stroke) and mark.pen == "visible":
        return replace(mark, pen="thin")
    return mark


def _drawn(model: Model, places: list[complex], arrows: list[LinkVector], window: Window) -> Figure:
    skeleton = Skeleton(model.method.mechanism, model.plot, window, {})
    found = mechanism_figure(skeleton, model.method, places).numbered(None)
    found.marks = [_thin(mark) for mark in found.marks]
    turned: set[Symbol] = set()
    values = model.values
    for arrow in arrows:
        start, end = (window(value) for value in _ends(model, arrow))
        label = symbol_label(arrow.length)
        name = "".join(run.text for run in label)
        found.marks.append(VectorMark("position", name, arrow.tail[0], arrow.head[0], start, end, _VECTORS))
        found.wanted.append(LabelRequest(label, start, end, gap=1.0, step=_VECTORS))
        if (theta := _own_angle(arrow)) is not None and theta not in turned:
            turned.add(theta)
            _angle(found, theta, float(values[theta]), start, abs(end - start))
    return found


def _own_angle(arrow: LinkVector) -> Symbol | None:
    """The θ of an arrow that points along it."""
    only = arrow.angle.parts
    return only[0][0] if len(only) == 1 and only[0] == (only[0][0], 1) and not arrow.angle.quarters else None


def _angle(found: Figure, theta: Symbol, value: float, at: Place, length: float) -> None:
    """An arc from the x axis to the arrow, with its θ, where there is room for one."""
    radius = min(_ARC, 0.6 * length)
    sweep = value if abs(value) <= math.tau else math.remainder(value, math.tau)
    if not theta.moves or radius < _ARC / 2 or abs(sweep) < math.radians(8):
        return
    found.marks.append(Stroke((at, at + 1.4 * radius), "construction", step=_VECTORS))
    found.marks.append(ArcMark(at, radius, 0.0, -sweep, "thin", step=_VECTORS))
    away = cmath.rect(1.0, -sweep / 2)
    found.wanted.append(LabelRequest(symbol_label(theta), at + radius * away, away=away, step=_VECTORS))


def _arrows(model: Model) -> Iterator[LinkVector]:
    """Every arrow of the polygons once, as it points."""
    seen: set[Symbol] = set()
    for task in model.tasks:
        for polygon in task.polygons:
            for arrow in (*polygon.sides[0], *polygon.sides[1]):
                if arrow.length not in seen:
                    seen.add(arrow.length)
                    yield arrow


def _ends(model: Model, arrow: LinkVector) -> tuple[complex, complex]:
    """Tail and head [m]; a displacement counted negative points from its origin to the point all the same."""
    first, last = (complex(place(model.method.structure, *site, model.drawn)) for site in (arrow.tail, arrow.head))
    return first, last


def symbol_label(symbol: Symbol) -> Label:
    """A symbol lettered as in drawings."""
    low = (Run(symbol.low, not symbol.low.isdigit(), "sub"),) if symbol.low else ()
    primes = (Run("′" * symbol.primes),) if symbol.primes else ()
    return (Run(symbol.letter, True), *low, *primes)
