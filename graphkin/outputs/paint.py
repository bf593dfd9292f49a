"""The colours, widths and dashes that a mark is painted with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Literal

from graphkin.base.value import frozen
from graphkin.outputs.typesetting import mm
from graphkin.sheet import Sheet
from graphkin.sheet.marks import ArcMark, Fill, Mark, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.page import Layer
from graphkin.sheet.paper import PENS

_PAPER = "#ffffff"
_INK, _NEW, _PALE = "#000000", "#c00000", "#777777"
ACCENTS: Mapping[str, str] = {"velocity": "#0b4f9c", "acceleration": "#a3200d", "grey": _PALE}
"""Dark in print without colours; widths, not colours, tell what is what."""
Ink = Literal["accent", "black"]


@frozen
class Colours:
    """The colours of marks: an accent a plane, or black alone; of a stage, only what is new stands out."""

    ink: Ink
    staged: bool

    @classmethod
    def of(cls, sheet: Sheet, ink: Ink) -> Colours:
        return cls(ink, any(mark.new for mark in sheet.marks))

    def of_mark(self, mark: Mark, layer: Layer) -> str:
        if isinstance(mark, Stroke | VectorMark) and mark.pen == "leader":
            return _half(self.of_mark(replace(mark, pen="thin"), layer))
        if self.ink == "black" or (self.staged and not mark.new):
            return _INK
        plane: str | None = getattr(mark, "accent", None) or layer.plane
        if isinstance(mark, Stroke) and mark.pen in ("construction", "measured") and not mark.new:
            return _PALE
        return ACCENTS.get(plane or "", _NEW if mark.new else _INK)

    def paint(self, layer: Layer, mark: Mark) -> tuple[tuple[str, str], ...]:
        """The attributes a viewer paints a mark by; in a detail an arrow's head is part of its outline."""
        colour = self.of_mark(mark, layer)
        if isinstance(mark, Text):
            weight = {"font-weight": "bold"} if mark.new and self.ink == "black" else {}
            return (("fill", colour), *weight.items())
        fill: Fill = "none" if isinstance(mark, ArcMark | VectorMark) else mark.fill
        if isinstance(mark, PointMark):
            pen = PENS["outline" if mark.fill == "paper" else "construction"]
        else:
            pen = PENS[mark.pen]
            fill = "ink" if isinstance(mark, VectorMark) and mark.plane == "detail" else fill
        attributes = {"fill": {"paper": _PAPER, "grey": "#dddddd", "none": "none"}.get(fill, colour)}
        attributes |= {"fill-opacity": "0.1"} if fill == "tint" else {}
        attributes |= {"stroke": colour, "stroke-width": mm(pen.width * (1.8 if mark.new else 1))}
        attributes |= {"stroke-dasharray": " ".join(map(mm, pen.dashes))} if pen.dashes else {}
        return tuple(attributes.items())


def _half(colour: str) -> str:
    """A colour mixed with as much white."""
    return "#" + "".join(f"{(int(colour[k : k + 2], 16) + 256) // 2:02x}" for k in (1, 3, 5))
