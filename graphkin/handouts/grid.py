"""Gridded paper with a pole on it, as SVG in true millimetres."""

from __future__ import annotations

import math
from typing import Any

from graphkin.handouts.document import GridRoom
from graphkin.outputs.typesetting import mm
from graphkin.sheet.lettering import Label, scripts

_FINE, _BOLD, _FRAME = ("#d5dde5", 0.1), ("#a9b8c6", 0.18), ("#000000", 0.35)
_STEP = 5.0
_LETTERS = 4.2
_OFF, _HIGH, _WIDE = 1.4, 3.0, 4.0
"""What letters keep from a line, how high they are, and how wide a pole's letter is [mm]."""
_FAMILY = "Times New Roman, Liberation Serif, Tinos, serif"


def room_svg(room: GridRoom) -> str:
    """The grid, the pole, and one direction through it with its mark."""
    drawing = drawing_of(room.width, room.height)
    for k in range(round(room.width / _STEP) + 1):
        _line(drawing, complex(k * _STEP, 0), complex(k * _STEP, room.height), *(_FINE if k % 2 else _BOLD))
    for k in range(round(room.height / _STEP) + 1):
        _line(drawing, complex(0, k * _STEP), complex(room.width, k * _STEP), *(_FINE if k % 2 else _BOLD))
    frame = drawing.rect((0, 0), (mm(room.width), mm(room.height)), fill="none", stroke=_FRAME[0])
    frame["stroke-width"] = mm(_FRAME[1])
    drawing.add(frame)
    along = complex(math.cos(room.direction), -math.sin(room.direction))
    start, end = _through(room, along)
    _line(drawing, start, end, "#555555", 0.18)
    drawing.add(drawing.circle((mm(room.pole.real), mm(room.pole.imag)), "0.6", fill="#000000"))
    away = room.pole + 22 * (along if _inside(room, room.pole + 30 * along) else -along)
    right, left = _beside(along)
    _letters(drawing, room.name, room.pole + left)
    _letters(drawing, room.mark, away + right)
    return str(drawing.tostring())


def drawing_of(width: float, height: float) -> Any:
    """An empty drawing of this size [mm]."""
    import svgwrite

    size = (f"{mm(width)}mm", f"{mm(height)}mm")
    return svgwrite.Drawing(size=size, viewBox=f"0 0 {mm(width)} {mm(height)}", profile="full", debug=False)


def _line(drawing: Any, start: complex, end: complex, colour: str, width: float) -> None:
    element = drawing.line((mm(start.real), mm(start.imag)), (mm(end.real), mm(end.imag)), stroke=colour)
    element["stroke-width"] = mm(width)
    drawing.add(element)


def _through(room: GridRoom, along: complex) -> tuple[complex, complex]:
    """The ends of a line through the pole, a little inside the frame."""
    ends = []
    for way in (along, -along):
        reach = [math.inf]
        for place, step, most in ((room.pole.real, way.real, room.width), (room.pole.imag, way.imag, room.height)):
            if abs(step) > 1e-9:
                reach.append(((most if step > 0 else 0.0) - place) / step)
        ends.append(room.pole + way * min(reach))
    return ends[1], ends[0]


def _beside(along: complex) -> tuple[complex, complex]:
    """From a place on a line to where letters begin that stand clear of it: to the right of it, and to the left."""
    way = along if along.real >= 0 else -along
    rises = way.imag <= 0
    off = _OFF * (way * 1j if rises else way * -1j)
    return off + (1j * _HIGH if rises else 0), -off - _WIDE + (0 if rises else 1j * _HIGH)


def _inside(room: GridRoom, place: complex) -> bool:
    return 8 < place.real < room.width - 12 and 8 < place.imag < room.height - 4


def _letters(drawing: Any, label: Label, at: complex) -> None:
    for run, start, drop in scripts(label, _LETTERS):
        place = at + complex(start, drop)
        size = _LETTERS * (1.0 if run.place == "base" else 0.68)
        element = drawing.text(run.text, (mm(place.real), mm(place.imag)), font_size=mm(size), font_family=_FAMILY)
        if run.italic:
            element["font-style"] = "italic"
        drawing.add(element)
