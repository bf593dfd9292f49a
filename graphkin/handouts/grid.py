"""Gridded paper with a pole, and what is printed on a page to be photographed, as SVG in true millimetres."""

from __future__ import annotations

import math
from typing import Any

import svgwrite

from graphkin.handouts.document import GRID, GridRoom
from graphkin.outputs.typesetting import mm
from graphkin.photo.markers import DOT, MARKERS, SIZE, corners, dots
from graphkin.sheet.lettering import Label, scripts

_FINE, _BOLD, _FRAME, _DIRECTION = ("#d5dde5", 0.1), ("#a9b8c6", 0.18), ("#000000", 0.35), ("#555555", 0.18)
_LETTERS = 4.2
_OFF, _HIGH, _WIDE = 1.4, 3.0, 4.0
"""Distance of letters from a line, their height, and the width of a pole's letter [mm]."""
_FAMILY = "Times New Roman, Liberation Serif, Tinos, serif"


def room_svg(room: GridRoom) -> str:
    """The grid, the pole, and one direction through it with its mark."""
    drawing = _empty(room.width, room.height)
    for k in range(round(room.width / GRID) + 1):
        _line(drawing, complex(k * GRID, 0), complex(k * GRID, room.height), *(_FINE if k % 2 else _BOLD))
    for k in range(round(room.height / GRID) + 1):
        _line(drawing, complex(0, k * GRID), complex(room.width, k * GRID), *(_FINE if k % 2 else _BOLD))
    frame = drawing.rect((0, 0), (mm(room.width), mm(room.height)), fill="none", stroke=_FRAME[0])
    frame["stroke-width"] = mm(_FRAME[1])
    drawing.add(frame)
    along = complex(math.cos(room.direction), -math.sin(room.direction))
    _line(drawing, _border(room, -along), _border(room, along), *_DIRECTION)
    drawing.add(drawing.circle(_xy(room.pole), "0.6", fill="#000000"))
    far = room.pole + 30 * along
    inside = 8 < far.real < room.width - 12 and 8 < far.imag < room.height - 4
    forward = along if along.real >= 0 else -along  # letters begin clear of the line, to the right or the left of it
    rises = forward.imag <= 0
    off = _OFF * (forward * 1j if rises else forward * -1j)
    right, left = off + (1j * _HIGH if rises else 0), -off - _WIDE + (0 if rises else 1j * _HIGH)
    _letters(drawing, room.name, room.pole + left)
    _letters(drawing, room.mark, room.pole + 22 * (along if inside else -along) + right)
    return str(drawing.tostring())


def _empty(width: float, height: float) -> Any:
    """An empty drawing of this size [mm]."""
    size = (f"{mm(width)}mm", f"{mm(height)}mm")
    return svgwrite.Drawing(size=size, viewBox=f"0 0 {mm(width)} {mm(height)}", profile="full", debug=False)


def _xy(place: complex) -> tuple[str, str]:
    return mm(place.real), mm(place.imag)


def _line(drawing: Any, start: complex, end: complex, colour: str, width: float) -> None:
    element = drawing.line(_xy(start), _xy(end), stroke=colour)
    element["stroke-width"] = mm(width)
    drawing.add(element)


def _border(room: GridRoom, along: complex) -> complex:
    """The place at which a ray from the pole leaves the room."""
    reach = [math.inf]
    for place, step, most in ((room.pole.real, along.real, room.width), (room.pole.imag, along.imag, room.height)):
        if abs(step) > 1e-9:
            reach.append(((most if step > 0 else 0.0) - place) / step)
    return room.pole + along * min(reach)


def _letters(drawing: Any, label: Label, at: complex) -> None:
    for run, start, drop in scripts(label, _LETTERS):
        size = _LETTERS * (1.0 if run.place == "base" else 0.68)
        element = drawing.text(run.text, _xy(at + complex(start, drop)), font_size=mm(size), font_family=_FAMILY)
        if run.italic:
            element["font-style"] = "italic"
        drawing.add(element)


def markers_svg(width: float, height: float) -> str:
    """The corners and dots that all pages of this size share."""
    drawing = _empty(width, height)
    for place in dots(width, height):
        drawing.add(drawing.circle(_xy(place), mm(DOT / 2), fill="#b0b0b0"))
    cell = SIZE / 6
    for id, corner in enumerate(corners(width, height)):
        drawing.add(drawing.rect(_xy(corner), (mm(SIZE), mm(SIZE)), fill="#000000"))
        for k in range(16):  # six by six squares: a black rim, and four rows of four bits
            if MARKERS[id] >> (15 - k) & 1:
                place = corner + cell * complex(k % 4 + 1, k // 4 + 1)
                drawing.add(drawing.rect(_xy(place), (mm(cell), mm(cell)), fill="#ffffff"))
    return str(drawing.tostring())
