"""Ruler, compass and protractor on named points, lines, circles and numbers: for what is no polygon.

    Drafting (stages of steps) -- replay --> Board -- readers --> words, sheets, JSON

A step is a frozen value that names what it makes, and from what; it holds no result. Steps stand in stages, and a
stage is what one sentence speaks of. A board may lie over a drawing: its points are pricked through, its lines traced.

`steps` holds the kinds of steps, `pencil` does them, and the sums beside the drawing; `board` is what is drawn then,
its points and lines so that one at infinity is no exception. All works on arrays alike.

To add a kind of step: its class in `steps`, there in the group of what it makes. The type checker then names each
reader that has to know it.
"""

from __future__ import annotations  # isort: skip_file

from graphkin.construction.drafting.board import INFINITE, Board, Homogeneous, Underlay
from graphkin.construction.drafting.pencil import draw, replay, ruled, theta_of
from graphkin.construction.drafting.steps import (  # fmt: skip
    Bisector, CarriedAngle, ChosenPoint, CircleAbout, CircleStep, CircleThrough, Drafting, DraftLayOff, DraftMeasure,
    DraftMeet, DraftTurn, Far, LineStep, MarkOn, MeasureAngle, NumberStep, Parallel, Perpendicular, PointStep,
    Pricked, Reckon, Slanted, Stage, Step, Through, Traced, drawn_through,
)

__all__ = [
    "INFINITE", "Bisector", "Board", "CarriedAngle", "ChosenPoint", "CircleAbout", "CircleStep", "CircleThrough",
    "DraftLayOff", "DraftMeasure", "DraftMeet", "DraftTurn", "Drafting", "Far", "Homogeneous", "LineStep", "MarkOn",
    "MeasureAngle", "NumberStep", "Parallel", "Perpendicular", "PointStep", "Pricked", "Reckon", "Slanted", "Stage",
    "Step", "Through", "Traced", "Underlay", "draw", "drawn_through", "replay", "ruled", "theta_of",
]  # fmt: skip
