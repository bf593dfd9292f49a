"""The mechanism to scale with the link vectors of its polygons drawn over it, each with its letter."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace

from graphkin.equations.document import Figure
from graphkin.equations.model import Model
from graphkin.equations.polygons import Arrow
from graphkin.equations.readers import place
from graphkin.equations.symbols import Symbol
from graphkin.sheet.labels import Wanted, settle
from graphkin.sheet.lettering import Label, Run
from graphkin.sheet.marks import Arc, Mark, Place, Stroke, VectorMark
from graphkin.sheet.mechanism_figure import mechanism_figure
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import Room
from graphkin.sheet.scales import finest
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.wheels import rims
from graphkin.sheet.window import Figure as Drawn
from graphkin.sheet.window import Window

__all__ = ["figure"]

_ROOM = complex(130.0, 95.0)
"""The largest the mechanism's points may reach [mm]."""
_MARGIN = 9.0
"""What letters need around it [mm]."""
_ARC = 8.0
"""Radius of the arcs that show angles [mm]."""
_VECTORS = 1
"""The step the vectors and their letters are marked with, until they are coloured."""


def figure(model: Model, caption: str) -> Figure:
    """Drawn at the drawn position, at the finest standard scale that fits a page of text."""
    plot = model.plot
    machine = model.method.mechanism
    named = [complex(value) for name, value in plot.position.items() if name in machine.points]
    values = [*named, *rims(machine, plot.position)]
    arrows = list(_arrows(model))
    ends = [end for arrow in arrows for end in _ends(model, arrow)]
    xs, ys = [v.real for v in (*values, *ends)], [v.imag for v in (*values, *ends)]
    scale = finest(complex(max(xs) - min(xs), max(ys) - min(ys)), _ROOM)
    drawn = _drawn(model, plot, Window(0j, scale), values, arrows)
    left, top, right, bottom = bounds(drawn.marks)
    window = Window(complex(_MARGIN - left, _MARGIN - top), scale)
    drawn = _drawn(model, plot, window, values, arrows)
    width, height = right - left + 2 * _MARGIN, bottom - top + 2 * _MARGIN
    marks = [*drawn.marks, *settle(drawn.wanted, drawn.marks, Room(1, 1, width - 1, height - 1), far=True).marks]
    return Figure(tuple(_coloured(mark) for mark in marks), width, height, caption)


def _coloured(mark: Mark) -> Mark:
    """Vectors and their letters stand out; steps of a construction there are none."""
    return replace(mark, new=mark.step == _VECTORS, step=None)


def _thin(mark: Mark) -> Mark:
    """Links as thin lines under their vectors."""
    if isinstance(mark, Stroke) and mark.pen == "visible":
        return replace(mark, pen="thin", step=None)
    return replace(mark, step=None)


def _drawn(model: Model, plot: object, window: Window, values: list[complex], arrows: list[Arrow]) -> Drawn:
    skeleton = Skeleton(model.method.mechanism, plot, window, {})  # type: ignore[arg-type]
    found = mechanism_figure(skeleton, model.method, values)
    found.marks = [_thin(mark) for mark in found.marks]
    found.wanted = [replace(wanted, step=None) for wanted in found.wanted]
    turned: set[Symbol] = set()
    for arrow in arrows:
        start, end = (window(value) for value in _ends(model, arrow))
        label = symbol_label(arrow.length)
        name = "".join(run.text for run in label)
        found.marks.append(VectorMark("position", name, arrow.tail[0], arrow.head[0], start, end, _VECTORS))
        found.wanted.append(Wanted(label, start, end, gap=1.0, step=_VECTORS))
        if (theta := _own_angle(arrow)) is not None and theta not in turned:
            turned.add(theta)
            _angle(found, theta, float(model.values[theta]), start, abs(end - start))
    return found


def _own_angle(arrow: Arrow) -> Symbol | None:
    """The θ of an arrow that points along it."""
    only = arrow.angle.parts
    return only[0][0] if len(only) == 1 and only[0] == (only[0][0], 1) and not arrow.angle.quarters else None


def _angle(found: Drawn, theta: Symbol, value: float, at: Place, length: float) -> None:
    """An arc from the x axis to the arrow, with its θ, where there is room for one."""
    radius = min(_ARC, 0.6 * length)
    sweep = value if abs(value) <= math.tau else math.remainder(value, math.tau)
    if not theta.moves or radius < _ARC / 2 or abs(sweep) < math.radians(8):
        return
    found.marks.append(Stroke((at, at + 1.4 * radius), "construction", step=_VECTORS))
    found.marks.append(Arc(at, radius, 0.0, -sweep, "thin", step=_VECTORS))
    away = cmath.rect(1.0, -sweep / 2)
    found.wanted.append(Wanted(symbol_label(theta), at + radius * away, away=away, step=_VECTORS))


def _arrows(model: Model) -> Iterator[Arrow]:
    """Every arrow of the polygons once, as it points."""
    seen: set[Symbol] = set()
    for task in model.tasks:
        for polygon in task.polygons:
            for arrow in (*polygon.sides[0], *polygon.sides[1]):
                if arrow.length not in seen:
                    seen.add(arrow.length)
                    yield arrow


def _ends(model: Model, arrow: Arrow) -> tuple[complex, complex]:
    """Tail and head [m]; a displacement counted negative points from its origin to the point all the same."""
    first, last = (complex(place(model.method.structure, *site, model.drawn)) for site in (arrow.tail, arrow.head))
    return first, last


def symbol_label(symbol: Symbol) -> Label:
    """A symbol lettered as in drawings."""
    low = (Run(symbol.low, not symbol.low.isdigit(), "sub"),) if symbol.low else ()
    primes = (Run("′" * symbol.primes),) if symbol.primes else ()
    return (Run(symbol.letter, True), *low, *primes)
