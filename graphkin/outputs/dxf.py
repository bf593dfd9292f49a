"""A sheet as DXF, in true millimetres: a layer a plane, arrows as lines with filled heads, names as text.

Needs ezdxf. A drawing program has y up: the foot of the paper is y = 0.
"""

from __future__ import annotations

import cmath
import io
import math
from collections.abc import Iterator, Sequence
from typing import Any, assert_never

from graphkin.outputs.files import needed
from graphkin.outputs.typesetting import stacked
from graphkin.sheet import Sheet
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.paper import PENS, PenName

MARK = b"graphkin sheet"
_LAYERS = {"": 7, "mechanism": 7, "velocity": 5, "acceleration": 1, "centres": 3, "labels": 7}
"""Each layer with its colour, as AutoCAD numbers them."""
_NAMES = {"position": "mechanism"}
_HEAD = 2.8
_WIDE = 0.7 / 2.8  # half the width of a head against its length
_CAP = 0.66  # height of a capital letter against the em: what a drawing program calls the height of a text


def dxf(sheet: Sheet) -> bytes:
    """The DXF file of a sheet, the same bytes for the same sheet. Raises NeedsExtra without ezdxf."""
    ezdxf = needed("ezdxf", "dxf")
    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        document = ezdxf.new("R2010", units=4)
        document.header["$LWDISPLAY"] = 1
        document.header.custom_vars.append("Creator", MARK.decode())
        document.styles.add("letters", font="times.ttf")
        for name, colour in _LAYERS.items():
            if name:
                document.layers.add(name, color=colour)
        page = _DxfPage(document.modelspace(), sheet)
        for mark in sheet.marks:
            page.add(mark)
        for name in sorted(document.entitydb.dxf_types_in_use()):  # else in an order that changes
            document.classes.add_class(name)
        held = io.StringIO()
        document.write(held)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before
    return held.getvalue().encode(document.output_encoding)


class _DxfPage:
    """The marks of one sheet, painted into a space of the document."""

    def __init__(self, space: Any, sheet: Sheet) -> None:
        self.space, self.sheet = space, sheet

    def add(self, mark: Mark) -> None:
        match mark:
            case Stroke():
                corners = [self._xy(place) for place in mark.places]
                if mark.fill == "ink" and len(corners) > 2:
                    hatch = self.space.add_hatch(dxfattribs={"layer": "0"})
                    hatch.paths.add_polyline_path(corners, is_closed=True)
                look = self._look(mark.pen, mark.shows.plane if mark.shows is not None else "")
                if not mark.dashes:
                    self.space.add_lwpolyline(corners, close=mark.closed, dxfattribs=look)
                for piece in _pieces(mark.outline, mark.dashes):
                    self.space.add_lwpolyline([self._xy(place) for place in piece], dxfattribs=look)
            case Disc():
                look = self._look(mark.pen, mark.shows.plane if mark.shows is not None else "")
                self.space.add_circle(self._xy(mark.centre), mark.radius, dxfattribs=look)
            case ArcMark():
                start, end = -math.degrees(mark.start), -math.degrees(mark.start + mark.sweep)
                start, end = (end, start) if mark.sweep > 0 else (start, end)
                self.space.add_arc(self._xy(mark.centre), mark.radius, start, end, dxfattribs=self._look(mark.pen, ""))
            case VectorMark():
                self._arrow(mark)
            case PointMark():
                self.space.add_circle(self._xy(mark.at), mark.radius, dxfattribs=self._look("outline", mark.plane))
            case Text():
                (x, y), (_, _, depth) = self._xy(mark.at), box(mark.label, mark.size)
                foot = complex(x, y) - 1j * depth * cmath.rect(1, -mark.turn)
                look = {"layer": "labels", "style": "letters", "char_height": mark.size * _CAP, "attachment_point": 7}
                look |= {"insert": (foot.real, foot.imag)}
                look |= {"rotation": -math.degrees(mark.turn)} if mark.turn else {}
                self.space.add_mtext(stacked(mark.label), dxfattribs=look)
            case _:
                assert_never(mark)

    def _arrow(self, mark: VectorMark) -> None:
        """The line as long as the vector is; the head lies on it."""
        look = self._look(mark.pen, mark.plane)
        tail, head = complex(*self._xy(mark.start)), complex(*self._xy(mark.end))
        for piece in _pieces((tail, head), mark.dashes) if mark.dashes else [[tail, head]]:
            self.space.add_line(*((end.real, end.imag) for end in piece), dxfattribs=look)
        if mark.length <= 0.05:
            return
        along = cmath.rect(min(_HEAD, mark.length / 2), cmath.phase(head - tail))
        tip = head - along / abs(along) * min(mark.back, mark.length / 3)
        left, right = (0.0 if mark.half == other else _WIDE for other in ("right", "left"))
        outline = (tip, tip - along + along * left * 1j, tip - along - along * right * 1j)
        solid = [(corner.real, corner.imag) for corner in outline]
        self.space.add_solid(solid, dxfattribs={"layer": look["layer"]})

    def _xy(self, place: Place) -> tuple[float, float]:
        return round(place.real, 6), round(self.sheet.paper.height - place.imag, 6)

    def _look(self, pen: PenName, plane: str) -> dict[str, object]:
        """Layer and width [hundredths of a millimetre, of the widths that DXF knows]."""
        weight = min((13, 18, 25, 35, 50, 70, 100), key=lambda weight: abs(weight - round(100 * PENS[pen].width)))
        return {"layer": _NAMES.get(plane, plane) or "0", "lineweight": weight}


def _pieces(places: Sequence[Place], dashes: Sequence[float]) -> Iterator[list[Place]]:
    """The pieces of a broken line that are drawn."""
    from shapely import LineString
    from shapely.ops import substring

    line, start = LineString([(place.real, place.imag) for place in places]), 0.0
    for length, gap in zip(dashes[::2], dashes[1::2], strict=True):
        yield [complex(x, y) for x, y in substring(line, start, start + length).coords]
        start += length + gap
