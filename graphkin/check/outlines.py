"""The outlines of SVG shapes in their own units, as polylines."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterator, Mapping
from itertools import pairwise

from graphkin.check.transforms import NUMBER, Unread, length, numbers_in

SHAPES = ("line", "polyline", "polygon", "rect", "circle", "ellipse", "path", "image")
_PIECE = re.compile("([MmLlHhVvCcSsQqTtAaZz])([^MmLlHhVvCcSsQqTtAaZz]*)")
_TAKES = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
_CURVES = re.compile("[CcSsQqTtAa]")
_ARC = re.compile(r"[\s,]*".join([f"({NUMBER})"] * 3 + ["([01])"] * 2 + [f"({NUMBER})"] * 2 + [""]))

Line = list[complex]


def is_plain(tag: str, attributes: Mapping[str, str]) -> bool:
    """Whether the polyline is the shape itself, and not near it."""
    return tag in ("line", "polyline", "polygon") or (tag == "path" and not _CURVES.search(attributes.get("d", "")))


def outline(tag: str, attributes: Mapping[str, str]) -> list[Line]:
    """Polylines x + iy, y down as in the file; a closed one ends where it begins. What is not given is 0."""

    def at(key: str) -> float:
        return length(attributes.get(key, "0"))

    match tag:
        case "line":
            return [[complex(at("x1"), at("y1")), complex(at("x2"), at("y2"))]]
        case "rect" | "image":
            x, y, wide, high = (at(key) for key in ("x", "y", "width", "height"))
            corner = complex(x, y)
            return [[corner, corner + wide, corner + wide + 1j * high, corner + 1j * high, corner]]
        case "circle" | "ellipse":
            rx, ry = (at("r"), at("r")) if tag == "circle" else (at("rx"), at("ry"))
            ways = (cmath.rect(1, math.tau * k / 32) for k in range(33))
            return [[complex(at("cx") + rx * way.real, at("cy") + ry * way.imag) for way in ways]]
        case "polyline" | "polygon":
            found = numbers_in(attributes.get("points", ""))
            if len(found) % 2:
                raise Unread("points")
            places = [complex(x, y) for x, y in zip(found[::2], found[1::2], strict=True)]
            return [places + places[:1] if tag == "polygon" else places]
        case _:
            return _path(attributes.get("d", ""))


def _path(text: str) -> list[Line]:
    """The polylines of a path; curves by points on them, arcs by the square about their circle's half."""
    if re.sub(_PIECE, "", text).strip() or (text.strip() and text.strip()[0] not in "Mm"):
        raise Unread(f"the path {text[:40]!r}")
    lines: list[Line] = []
    here = last = 0j
    for letter, given in _commands(text):
        kind, start = letter.upper(), here if letter.islower() else 0j
        if kind == "M":
            here = start + complex(*given)
            lines.append([here])
        elif kind == "Z":
            here = lines[-1][0]
            lines[-1].append(here)
            lines.append([here])
        else:
            drawn, last = _drawn(kind, given, start, here, last)
            lines[-1] += drawn
            here = drawn[-1]
        if kind not in "CSQT":
            last = here
    return [line for line in lines if len(line) > 1]


def _commands(text: str) -> Iterator[tuple[str, list[float]]]:
    """Each command with the numbers of one turn of it; after a move, more pairs are lines."""
    for letter, rest in _PIECE.findall(text):
        takes = _TAKES[letter.upper()]
        numbers = _arc_numbers(rest) if letter in "Aa" else numbers_in(rest)
        if not takes:
            yield letter, []
        if len(numbers) % (takes or 1) or bool(takes) != bool(numbers):
            raise Unread(f"the path {text[:40]!r}")
        for k in range(0, len(numbers), takes or 1):
            yield ("l" if letter == "m" else "L") if letter in "Mm" and k else letter, numbers[k : k + takes]


def _arc_numbers(text: str) -> list[float]:
    """Flags of an arc need no blank after them."""
    found: list[float] = []
    at = len(text) - len(text.lstrip())
    while at < len(text):
        arc = _ARC.match(text, at)
        if arc is None:
            raise Unread(f"the arc {text[:40]!r}")
        found += map(float, arc.groups())
        at = arc.end()
    return found


def _drawn(kind: str, given: list[float], start: complex, here: complex, last: complex) -> tuple[Line, complex]:
    """Places after the one where the pencil is, and the last control point."""
    if kind in "HV":
        along = complex(given[0], here.imag - start.imag) if kind == "H" else complex(here.real - start.real, given[0])
        return [start + along], here
    if kind == "A":
        end = start + complex(*given[5:])
        reach, middle = max(*given[:2], abs(end - here) / 2), (here + end) / 2
        return [middle + reach * way for way in (1 + 1j, 1 - 1j, -1 - 1j, -1 + 1j)] + [end], end
    places = [start + complex(x, y) for x, y in zip(given[::2], given[1::2], strict=True)]
    if kind == "L":
        return places, places[-1]
    controls = [here, *([2 * here - last] if kind in "ST" else []), *places]
    return [_bezier(controls, k / 8) for k in range(1, 9)], controls[-2]


def _bezier(controls: Line, t: float) -> complex:
    """De Casteljau's construction."""
    while len(controls) > 1:
        controls = [a + (b - a) * t for a, b in pairwise(controls)]
    return controls[0]
