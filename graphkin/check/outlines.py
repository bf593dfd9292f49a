"""SVG shapes where a viewer puts them: numbers, lengths, transforms, the paper, and outlines as polylines."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

NUMBER = r"[+-]?(?:[0-9]+(?:\.[0-9]+)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"  # as SVG writes numbers: ASCII digits alone
_LENGTH = re.compile(rf"\s*({NUMBER})(\s*)(px|mm|cm|in|pt|pc|Q)?\s*")
_LIST = re.compile(rf"\s*(?:{NUMBER}\s*(?:,\s*|(?=[\s+.-])|\Z)\s*)*")
_CALL = re.compile(r"\s*([A-Za-z]+)\s*\(([^()]*)\)\s*,?")
_INCH = {"in": 1.0, "px": 96.0, "pt": 72.0, "pc": 6.0, "mm": 25.4, "cm": 2.54, "Q": 101.6}
_ASPECT = re.compile(r"\s*(?:x(?:Min|Mid|Max)Y(?:Min|Mid|Max)(?:\s+meet)?)?\s*")


class Unread(ValueError):
    """Something of which this reader cannot tell what a viewer makes of it."""


class Affine(NamedTuple):
    """x' = a x + c y + e, y' = b x + d y + f, as `matrix(a b c d e f)`."""

    a: float = 1.0
    b: float = 0.0
    c: float = 0.0
    d: float = 1.0
    e: float = 0.0
    f: float = 0.0

    def __call__(self, x: float, y: float) -> complex:
        """The place on paper, with y up."""
        return complex(self.a * x + self.c * y + self.e, -(self.b * x + self.d * y + self.f))

    def then(self, inner: Affine) -> Affine:
        """First `inner`, then this."""
        a, b, c, d, e, f = self
        p, q, r, s, t, u = inner
        return Affine(a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s, a * t + c * u + e, b * t + d * u + f)

    @property
    def scale(self) -> float:
        """The factor by which lines become longer; Unread where that depends on their direction."""
        size = math.hypot(self.a, self.b)
        even, square = abs(math.hypot(self.c, self.d) - size), abs(self.a * self.c + self.b * self.d)
        if even > 1e-6 * size or square > 1e-6 * size**2:
            raise Unread("a transform that stretches one way")
        return size


def numbers_in(text: str) -> list[float]:
    """A list of numbers, by blanks or commas."""
    numbers = [float(number) for number in re.findall(NUMBER, text)] if _LIST.fullmatch(text) else [math.nan]
    if not all(map(math.isfinite, numbers)):
        raise Unread(f"the numbers {text.strip()[:40]!r}")
    return numbers


@lru_cache(maxsize=1024)
def length(text: str) -> float:
    """A length in user units; a unit counts as CSS has it, 96 to the inch."""
    match = _LENGTH.fullmatch(text)
    plain = match is not None and not (match[2] and match[3])
    value = float(match[1]) * (96.0 / _INCH[match[3]] if match[3] else 1.0) if match and plain else math.nan
    if not math.isfinite(value):
        raise Unread(f"the length {text.strip()[:40]!r}")
    return value


def transform(text: str) -> Affine:
    """The affine map of a `transform` attribute."""
    found, at = Affine(), 0
    if text.strip() in ("", "none"):
        return found
    while at < len(text) and (call := _CALL.match(text, at)) is not None:
        found, at = found.then(_call(call[1], numbers_in(call[2]))), call.end()
    if at < len(text):
        raise Unread(f"transform={text.strip()[:40]!r}")
    return found


def _call(name: str, given: list[float]) -> Affine:
    match name, given:
        case "matrix", [a, b, c, d, e, f]:
            return Affine(a, b, c, d, e, f)
        case "translate", [x, *rest] if len(rest) < 2:
            return Affine(e=x, f=rest[0] if rest else 0.0)
        case "scale", [x, *rest] if len(rest) < 2:
            return Affine(a=x, d=rest[0] if rest else x)
        case "rotate", [degrees, *about] if len(about) in (0, 2):
            x, y = about or (0.0, 0.0)
            cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            return Affine(e=x, f=y).then(Affine(cos, sin, -sin, cos)).then(Affine(e=-x, f=-y))
        case "skewX", [degrees]:
            return Affine(c=math.tan(math.radians(degrees)))
        case "skewY", [degrees]:
            return Affine(b=math.tan(math.radians(degrees)))
        case _:
            raise Unread(f"transform {name}")


def paper(attributes: Mapping[str, str]) -> tuple[Affine, complex, str]:
    """From the root's units to mm on paper, the paper's width and height [mm], and what is doubtful about them.

    A blank between number and unit is read, as drawing programs do (a browser fits such a sheet to its window).
    Raises Unread where width, height and viewBox do not say how large a unit is.
    """
    sizes = []
    for key in ("width", "height"):
        found = _LENGTH.fullmatch(attributes.get(key, ""))
        if found is None or not float(found[1]) > 0:
            raise Unread(f'{key}="{attributes.get(key, "")}"')
        sizes.append(float(found[1]) * 25.4 / _INCH[found[3] or "px"])
    wide, high = sizes
    box = numbers_in(attributes.get("viewBox", ""))
    if len(box) != 4 or not (box[2] > 0 and box[3] > 0) or abs(wide / box[2] - high / box[3]) > 1e-5 * wide / box[2]:
        raise Unread(f'viewBox="{attributes.get("viewBox", "")}"')
    if not _ASPECT.fullmatch(attributes.get("preserveAspectRatio", "")):
        raise Unread(f'preserveAspectRatio="{attributes["preserveAspectRatio"]}"')
    scale = wide / box[2]
    doubt = next((attributes[k] for k in ("width", "height") if re.search(r"[0-9]\s+[a-zA-Z]", attributes[k])), "")
    return Affine(scale, 0.0, 0.0, scale, -box[0] * scale, -box[1] * scale), complex(wide, high), doubt


SHAPES = ("line", "polyline", "polygon", "rect", "circle", "ellipse", "path", "image")
_PIECE = re.compile("([MmLlHhVvCcSsQqTtAaZz])([^MmLlHhVvCcSsQqTtAaZz]*)")
_TAKES = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
_CURVES = re.compile("[CcSsQqTtAa]")
_ARC = re.compile(r"[\s,]*".join([f"({NUMBER})"] * 3 + ["([01])"] * 2 + [f"({NUMBER})"] * 2 + [""]))

Line = list[complex]


def is_plain(tag: str, attributes: Mapping[str, str]) -> bool:
    """True if the polyline is the shape itself, and not near it."""
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
    curve = []
    for t in (k / 8 for k in range(1, 9)):
        level = controls
        while len(level) > 1:  # De Casteljau's construction
            level = [a + (b - a) * t for a, b in pairwise(level)]
        curve.append(level[0])
    return curve, controls[-2]
