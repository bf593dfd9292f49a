"""The pencil's own lines on the mechanism: lines and arcs, shown in the drawings of single steps."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping

from graphkin.construction import Arc, Construction, Meet, Plane, Plot, Ray, Step
from graphkin.sheet.marks import ArcMark, Mark, Place, Stroke
from graphkin.sheet.window import Window

Pages = Mapping[tuple[Plane, Step], int]
_BEYOND = 9.0
"""How far a direction line goes on past its points [mm]."""
_SWING, _STROKE = math.radians(22), 12.0
"""Half of an arc: this angle, or this length [mm] if that is less."""


def pencil_lines(construction: Construction, plot: Plot, window: Window, pages: Pages) -> list[Mark]:
    """Each ray and arc from where it starts past where it meets another, with the number of its act."""
    ends: dict[Ray | Arc, list[str]] = {}
    for step in construction.steps:
        if isinstance(step, Meet):
            ends.setdefault(step.first, []).append(step.point)
            ends.setdefault(step.second, []).append(step.point)
    points = plot.points(construction.plane)
    marks: list[Mark] = []
    for step in construction.steps:
        number = pages.get((construction.plane, step))
        if isinstance(step, Ray | Arc):
            foot = window(points[step.through if isinstance(step, Ray) else step.about])
            tips = [window(points[name]) for name in ends.get(step, ()) if name in points]
            marks += (
                _ray(step, foot, tips, plot, window, number) if isinstance(step, Ray) else _arcs(foot, tips, number)
            )
    return marks


def _ray(ray: Ray, foot: Place, tips: list[Place], plot: Plot, window: Window, number: int | None) -> Iterator[Mark]:
    """A thin line through its point in its direction, past where it meets the other."""
    along = window.turned(complex(plot.direction(ray.direction)))
    if cmath.isnan(along):
        return
    stops = [(along.conjugate() * (tip - foot)).real for tip in tips] or [0.0]
    low, high = min(0.0, *stops) - _BEYOND, max(0.0, *stops) + _BEYOND
    yield Stroke((foot + along * low, foot + along * high), "construction", step=number)


def _arcs(foot: Place, tips: list[Place], number: int | None) -> Iterator[Mark]:
    """A short arc around each place where the circle is crossed."""
    for tip in tips:
        half = min(_SWING, _STROKE / max(abs(tip - foot), 1e-9))
        yield ArcMark(foot, abs(tip - foot), cmath.phase(tip - foot) - half, 2 * half, "construction", step=number)
