"""Gridded paper with a pole on it, as SVG in true millimetres; and the marks by which a photograph is set straight."""

from __future__ import annotations

import math
from typing import Any

from graphkin.handouts.document import Room
from graphkin.outputs.spans import mm
from graphkin.sheet.lettering import Label, scripts

_FINE, _BOLD, _FRAME = ("#d5dde5", 0.1), ("#a9b8c6", 0.18), ("#000000", 0.35)
_STEP = 5.0
_LETTERS = 4.2
_FAMILY = "Times New Roman, Liberation Serif, Tinos, serif"

MARKERS = (
    0b1011010100110010, 0b0000111110011010, 0b0011001100101101, 0b1001100101000110,
    0b0101010010011110, 0b0111100111001101, 0b1001111000101110, 0b1100010011110010,
)  # fmt: skip
"""ArUco markers DICT_4X4_50, 0 to 7: rows of bits, 1 is white."""
SIZE, EDGE = 12.0, 8.0
"""Of a marker, and how far it stands from the paper's edge [mm]."""
_DOTS, _DOT = 10.0, 0.7


def room_svg(room: Room) -> str:
    """The grid, the pole, and one direction through it with its mark."""
    drawing = _drawing(room.width, room.height)
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
    _letters(drawing, room.name, room.pole + complex(-5.5, -1.5))
    away = room.pole + 22 * (along if _inside(room, room.pole + 30 * along) else -along)
    _letters(drawing, room.mark, away + complex(1.5, -1.5))
    return str(drawing.tostring())


def markers_svg(width: float, height: float, number: int) -> str:
    """What is printed on a page of this size that is to be photographed: corners, dots, the sheet's number.

    number  0 to 15, by two markers at the left and the right edge

    The white around each marker is left free: a line that touches one costs its place.
    """
    drawing = _drawing(width, height)
    for x in range(1, round(width / _DOTS)):
        for y in range(1, round(height / _DOTS)):
            place = complex(x * _DOTS, y * _DOTS)
            if not _near_marker(place, width, height):
                drawing.add(drawing.circle((mm(place.real), mm(place.imag)), mm(_DOT / 2), fill="#b0b0b0"))
    for id, corner in enumerate(_corners(width, height)):
        _marker(drawing, id, corner)
    for digit, corner in zip((number // 4 % 4, number % 4), _edges(width, height), strict=True):
        _marker(drawing, 4 + digit, corner)
    return str(drawing.tostring())


def _corners(width: float, height: float) -> tuple[complex, ...]:
    """Left upper corners of the markers 0 to 3, clockwise."""
    right, low = width - EDGE - SIZE, height - EDGE - SIZE
    return complex(EDGE, EDGE), complex(right, EDGE), complex(right, low), complex(EDGE, low)


def _edges(width: float, height: float) -> tuple[complex, complex]:
    return complex(EDGE, (height - SIZE) / 2), complex(width - EDGE - SIZE, (height - SIZE) / 2)


def _near_marker(place: complex, width: float, height: float) -> bool:
    corners = (*_corners(width, height), *_edges(width, height))
    middles = (corner + complex(SIZE, SIZE) / 2 for corner in corners)
    return any(max(abs((place - m).real), abs((place - m).imag)) < SIZE / 2 + 2.5 + _DOT for m in middles)


def _marker(drawing: Any, id: int, corner: complex) -> None:
    """Six by six squares: a black rim, and four rows of four bits."""
    cell = SIZE / 6
    drawing.add(drawing.rect((mm(corner.real), mm(corner.imag)), (mm(SIZE), mm(SIZE)), fill="#000000"))
    for row in range(4):
        for column in range(4):
            if MARKERS[id] >> (15 - 4 * row - column) & 1:
                place = corner + cell * complex(column + 1, row + 1)
                drawing.add(drawing.rect((mm(place.real), mm(place.imag)), (mm(cell), mm(cell)), fill="#ffffff"))


def _drawing(width: float, height: float) -> Any:
    from graphkin.outputs.svgwriting import svgwrite

    size = (f"{mm(width)}mm", f"{mm(height)}mm")
    return svgwrite().Drawing(size=size, viewBox=f"0 0 {mm(width)} {mm(height)}", profile="full", debug=False)


def _line(drawing: Any, start: complex, end: complex, colour: str, width: float) -> None:
    element = drawing.line((mm(start.real), mm(start.imag)), (mm(end.real), mm(end.imag)), stroke=colour)
    element["stroke-width"] = mm(width)
    drawing.add(element)


def _through(room: Room, along: complex) -> tuple[complex, complex]:
    """The ends of a line through the pole, a little inside the frame."""
    ends = []
    for way in (along, -along):
        reach = [math.inf]
        for place, step, most in ((room.pole.real, way.real, room.width), (room.pole.imag, way.imag, room.height)):
            if abs(step) > 1e-9:
                reach.append(((most if step > 0 else 0.0) - place) / step)
        ends.append(room.pole + way * min(reach))
    return ends[1], ends[0]


def _inside(room: Room, place: complex) -> bool:
    return 8 < place.real < room.width - 12 and 8 < place.imag < room.height - 4


def _letters(drawing: Any, label: Label, at: complex) -> None:
    for run, start, drop in scripts(label, _LETTERS):
        place = at + complex(start, drop)
        size = _LETTERS * (1.0 if run.place == "base" else 0.68)
        element = drawing.text(run.text, (mm(place.real), mm(place.imag)), font_size=mm(size), font_family=_FAMILY)
        if run.italic:
            element["font-style"] = "italic"
        drawing.add(element)
