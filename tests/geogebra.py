"""A reader of GeoGebra's files that reckons them through anew: it knows nothing of how graphkin writes them.

Only the kinds of objects are here that a construction needs; angles in radians. Points are complex numbers.
"""

from __future__ import annotations

import functools
import io
import math
import re
import xml.etree.ElementTree as ET
import zipfile
from typing import Any

import numpy as np

_LABEL = re.compile(r"[A-Za-z]'*_\{\d\w*\}|[A-Za-z]'+")


class Reckoned:
    """Every object of a file by its label, with numbers of the reader's own for some."""

    def __init__(self, content: bytes, given: dict[str, float] | None = None) -> None:
        self.values: dict[str, Any] = {}
        self.captions: dict[str, str] = {}
        self.sliders: list[str] = []
        self.given = given or {}
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            root = ET.fromstring(archive.read("geogebra.xml"))
        construction = root.find("construction")
        assert construction is not None
        for element in construction:
            getattr(self, f"_{element.tag}")(element)

    def point(self, name: str) -> complex:
        """A point by what it is called."""
        label = next(label for label, caption in self.captions.items() if caption == name)
        return complex(self.values[label])

    def _element(self, element: ET.Element) -> None:
        label = element.attrib["label"]
        if (caption := element.find("caption")) is not None:
            self.captions[label] = caption.attrib["val"]
        if element.find("slider") is not None:
            self.sliders.append(label)
        if label in self.values:
            return
        if (number := element.find("value")) is not None:
            self.values[label] = self.given.get(label, float(number.attrib["val"]))
        elif (coords := element.find("coords")) is not None:
            self.values[label] = complex(float(coords.attrib["x"]), float(coords.attrib["y"]))

    def _expression(self, element: ET.Element) -> None:
        self.values[element.attrib["label"]] = self.reckon(element.attrib["exp"])

    def _command(self, element: ET.Element) -> None:
        given, made = element.find("input"), element.find("output")
        assert given is not None
        assert made is not None
        inputs = [self.reckon(given.attrib[f"a{k}"]) for k in range(len(given.attrib))]
        self.values[made.attrib["a0"]] = _COMMANDS[element.attrib["name"]](*inputs)

    def reckon(self, text: str) -> Any:
        """The value of a formula."""
        if text.startswith('"'):
            return text
        names: dict[str, Any] = dict(_FUNCTIONS)

        def label(found: re.Match[str]) -> str:
            value = self.values[found[0]]
            names[key := f"_{len(names)}"] = np.float64(value) if isinstance(value, float) else value
            return key

        plain = _LABEL.sub(label, text)
        plain = re.sub(r"\b(If|Invert|Transpose|Element)\[", r"\1(", plain).replace("]", ")").replace("^", "**")
        plain = plain.replace("{", "[").replace("}", "]")
        if plain.startswith("[") and "[" not in plain[1:]:
            return _row(plain)
        plain = _pairs_named(plain)
        names |= {key: self.values[key] for key in self.values if re.fullmatch("[A-Za-z]", key)}
        with np.errstate(divide="ignore", invalid="ignore"):
            return _made(eval(plain, {"__builtins__": {}}, names))


def _pairs_named(formula: str) -> str:
    """`(a, b)`, which is a point there, as `complex(a, b)`; the commas of functions stay."""
    opened: list[int] = []
    points: set[int] = set()
    for k, letter in enumerate(formula):
        if letter == "(":
            opened.append(k)
        elif letter == ")":
            opened.pop()
        elif letter == "," and opened and not re.match(r"\w", formula[opened[-1] - 1 : opened[-1]]):
            points.add(opened[-1])
    return "".join("complex(" if k in points else letter for k, letter in enumerate(formula))


class _Row(list):
    """A list of numbers, counted from 1."""


@functools.cache
def _row(text: str) -> _Row:
    parts = (part.partition(" * 10**") for part in text[1:-1].split(", "))
    return _Row(float(digits) * 10 ** int(power.strip("()") or 0) for digits, _, power in parts)


class _Matrix:
    """A list of lists: `*` is the product of matrices."""

    def __init__(self, rows: Any) -> None:
        self.rows = np.array(rows, dtype=float)

    def __mul__(self, other: _Matrix) -> _Matrix:
        return _Matrix(self.rows @ other.rows)


def _element(held: Any, row: int, *column: int) -> float:
    if column:
        return float(held.rows[row - 1, column[0] - 1])
    return held[row - 1] if 1 <= row <= len(held) else math.nan


def _made(value: Any) -> Any:
    return _Matrix(value) if isinstance(value, list) and not isinstance(value, _Row) else value


def _line(through: complex, direction: complex) -> tuple[complex, complex]:
    return complex(through), complex(direction)


def _meet(one: Any, other: Any, which: float = 0) -> complex:
    """Lines are (place, direction), circles (centre, radius)."""
    (p, u), (q, w) = one, other
    if isinstance(u, complex) and isinstance(w, complex):
        return p + u * ((np.conj(q - p) * w).imag / (np.conj(u) * w).imag)
    if isinstance(u, complex):
        foot = p + u * (np.conj(u) * (q - p)).real / abs(u) ** 2
        half = np.sqrt(complex(w**2 - abs(foot - q) ** 2))
        half = half.real if not half.imag else math.nan
        return foot + (1 if which == 1 else -1) * half * u / abs(u)
    distance = abs(q - p)
    along = (distance**2 + u**2 - w**2) / (2 * distance)
    height = math.sqrt(u**2 - along**2) if u**2 >= along**2 else math.nan
    return p + (along + (1j if which == 1 else -1j) * height) * (q - p) / distance


_COMMANDS = {
    "Line": _line,
    "OrthogonalLine": lambda through, direction: _line(through, 1j * direction),
    "Circle": lambda centre, radius: (complex(centre), float(radius)),
    "Intersect": _meet,
    "Vector": lambda tail, head: head - tail,
    "Segment": lambda tail, head: abs(head - tail),
}
_FUNCTIONS: dict[str, Any] = {
    "x": lambda place: place.real, "y": lambda place: place.imag, "pi": math.pi, "round": round,
    "cos": math.cos, "sin": math.sin, "atan": math.atan, "complex": complex,
    "sqrt": lambda number: math.sqrt(number) if number >= 0 else math.nan,
    "If": lambda asked, then, otherwise: then if asked else otherwise,
    "Invert": lambda matrix: _Matrix(np.linalg.inv(matrix.rows)), "Transpose": lambda matrix: _Matrix(matrix.rows.T),
    "Element": lambda held, row, *column: _element(held, int(row), *column), "floor": math.floor,
}  # fmt: skip
