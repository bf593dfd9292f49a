"""Markers and dots on a page that is to be photographed: where they stand, in mm from its left upper corner, y down.

The markers are ArUco's DICT_4X4_250: 0 to 3 in the corners, clockwise; two of the others, at the left and the right
edge, are the digits of the sheet's number. The white around each is left free: a line that touches one costs its place.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

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
SIZE, EDGE, WHITE = 12.0, 8.0, 2.5  # of a marker, how far it stands from the paper's edge, the white around it [mm]
DOT, _PITCH = 0.7, 10.0  # width of a dot, and from one to the next [mm]
CORNERS = 4
DIGITS = len(MARKERS) - CORNERS  # the count of markers that are digits of numbers
MOST = DIGITS**2 - 1  # the largest number of a sheet


def digits(number: int) -> tuple[int, int]:
    """The markers at the left and the right edge that tell a number."""
    return CORNERS + number // DIGITS, CORNERS + number % DIGITS


def number_of(left: int, right: int) -> int:
    """The number that the markers at the left and the right edge tell."""
    return (left - CORNERS) * DIGITS + right - CORNERS


def corners(width: float, height: float) -> tuple[complex, ...]:
    """Left upper corners of the markers 0 to 3, clockwise [mm]."""
    right, low = width - EDGE - SIZE, height - EDGE - SIZE
    return complex(EDGE, EDGE), complex(right, EDGE), complex(right, low), complex(EDGE, low)


def edges(width: float, height: float) -> tuple[complex, complex]:
    """Left upper corners of the markers that tell the number [mm]."""
    return complex(EDGE, (height - SIZE) / 2), complex(width - EDGE - SIZE, (height - SIZE) / 2)


def dots(width: float, height: float) -> Iterator[complex]:
    """Middles of the dots of a page, which keep off its markers [mm]."""
    middles = [corner + complex(SIZE, SIZE) / 2 for corner in (*corners(width, height), *edges(width, height))]
    for x in range(1, round(width / _PITCH)):
        for y in range(1, round(height / _PITCH)):
            place = complex(x * _PITCH, y * _PITCH)
            if all(max(abs((place - m).real), abs((place - m).imag)) >= SIZE / 2 + WHITE + DOT for m in middles):
                yield place
