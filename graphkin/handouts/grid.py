"""Gridded paper with a pole, and what is printed on a page to be photographed, as SVG in true millimetres.

The markers are ArUco's DICT_4X4_250: 0 to 3 in the corners, clockwise; two of the others, at the left and the right
edge, are the digits of the sheet's number. The white around each is left free: a line that touches one costs its place.
"""

from __future__ import annotations

import math
import re
from typing import Any

import svgwrite

from graphkin.handouts.document import GridRoom
from graphkin.outputs.typesetting import mm
from graphkin.sheet.lettering import Label, scripts

_FINE, _BOLD, _FRAME, _DIRECTION = ("#d5dde5", 0.1), ("#a9b8c6", 0.18), ("#000000", 0.35), ("#555555", 0.18)
_STEP = 5.0
_LETTERS = 4.2
_OFF, _HIGH, _WIDE = 1.4, 3.0, 4.0
"""Distance of letters from a line, their height, and the width of a pole's letter [mm]."""
_FAMILY = "Times New Roman, Liberation Serif, Tinos, serif"

_BITS = """
b5320f9a332d9946549e79cd9e2ec4f2fedacf56f99111a70eb72a0f24b1263e466566006c5e76af868bb02bccd5dd82fe47
9471ace4a5542123346f441557b29ecff0cb08ae0929187504ff0df61c5a17182a28328c38b224e82eeb2d3f4b64502e5013
519455685d415f9768016867612461e96b126fe567df7e1b80a083448ba2937a846c852a859c9c899fa1bb7cbc04b65bbfc8
b7abca1fc962d958d3d5cc98c7a0c537e95df925fbbbee2af74d35758aad76170acf064b2dc149d843f44f364fd369e470c7
7a6eb4eaed4ffce7fea6002500430a880a86026f001c009708370a3109c60b0109fb0b581082182d10781073127412b11af9
13060c0e0cf104330c9f0ef20efd074c0fa4072f05b50f9107db1ee414391d8015c81f8b15ba1db1208028e922a228532af0
22f72940214629b92b9c2bb238ca382e300738e73a493a65325d3b88391d3bd3264727802faa2d1425de25532f7734483ca8
3c41340d34fb369a3de0356a3d093ded3fc43f6c37ce3d5c3d7637b03f173fff48e542684a2d4160495141dd4bdf584f5a48
5816505d5afa5ab551235b8a591951354c6946c14e0b445f4e594d834d7d47d847735c855e44562b5cbb55c35f6e5feb5d12
555e6270621561c26b2063456b5c6b5b780c7acf787f798071e5717479b671d37b33646a66a86ea76e9165226dcb678d6d31
"""
MARKERS = tuple(int(word, 16) for word in re.findall("....", _BITS))
"""Rows of four bits, 1 is white, inside a black rim; one number a marker."""
SIZE, EDGE = 12.0, 8.0  # of a marker, and how far it stands from the paper's edge [mm]
_DOTS, _DOT, _WHITE = 10.0, 0.7, 2.5
_CORNERS = 4
DIGITS = len(MARKERS) - _CORNERS  # the count of markers that are digits of numbers
MOST = DIGITS**2 - 1  # the largest number of a sheet


def room_svg(room: GridRoom) -> str:
    """The grid, the pole, and one direction through it with its mark."""
    drawing = _empty(room.width, room.height)
    for k in range(round(room.width / _STEP) + 1):
        _line(drawing, complex(k * _STEP, 0), complex(k * _STEP, room.height), *(_FINE if k % 2 else _BOLD))
    for k in range(round(room.height / _STEP) + 1):
        _line(drawing, complex(0, k * _STEP), complex(room.width, k * _STEP), *(_FINE if k % 2 else _BOLD))
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


def digits(number: int) -> tuple[int, int]:
    """The markers at the left and the right edge that tell a number."""
    return _CORNERS + number // DIGITS, _CORNERS + number % DIGITS


def markers_svg(width: float, height: float) -> str:
    """The corners and dots that all pages of this size share."""
    drawing = _empty(width, height)
    middles = [corner + complex(SIZE, SIZE) / 2 for corner in (*corners(width, height), *edges(width, height))]
    for x in range(1, round(width / _DOTS)):
        for y in range(1, round(height / _DOTS)):
            place = complex(x * _DOTS, y * _DOTS)
            if all(max(abs((place - m).real), abs((place - m).imag)) >= SIZE / 2 + _WHITE + _DOT for m in middles):
                drawing.add(drawing.circle(_xy(place), mm(_DOT / 2), fill="#b0b0b0"))
    cell = SIZE / 6
    for id, corner in enumerate(corners(width, height)):
        drawing.add(drawing.rect(_xy(corner), (mm(SIZE), mm(SIZE)), fill="#000000"))
        for k in range(16):  # six by six squares: a black rim, and four rows of four bits
            if MARKERS[id] >> (15 - k) & 1:
                place = corner + cell * complex(k % 4 + 1, k // 4 + 1)
                drawing.add(drawing.rect(_xy(place), (mm(cell), mm(cell)), fill="#ffffff"))
    return str(drawing.tostring())


def corners(width: float, height: float) -> tuple[complex, ...]:
    """Left upper corners of the markers 0 to 3, clockwise [mm]."""
    right, low = width - EDGE - SIZE, height - EDGE - SIZE
    return complex(EDGE, EDGE), complex(right, EDGE), complex(right, low), complex(EDGE, low)


def edges(width: float, height: float) -> tuple[complex, complex]:
    """Left upper corners of the markers that tell the number [mm]."""
    return complex(EDGE, (height - SIZE) / 2), complex(width - EDGE - SIZE, (height - SIZE) / 2)
