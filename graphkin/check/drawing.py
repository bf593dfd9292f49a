"""A drawing file, parsed: its lines and points in mm, and what it claims to be."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from xml.etree.ElementTree import Element, ParseError

from graphkin import loading
from graphkin.errors import BadDrawing, NoDrawing, Where
from graphkin.mechanism import Mechanism
from graphkin.steps import Plane
from graphkin.value import frozen

__all__ = ["UNITS", "DrawingFile", "Fault", "mechanism_of", "numbers", "plane_of", "read", "scales_of"]

LIMIT = 16 << 20
"""Larger drawings are not ours [bytes]."""

UNITS: Mapping[Plane, str] = {"position": "m", "velocity": "m/s", "acceleration": "m/s^2"}
WRITTEN = re.compile(r"μ\s*([lva])\s*=\s*([0-9.]+(?:\s*[×·]\s*10[−+-]?[0-9]+)?)")
"""A scale as it is printed on the sheet: μ_v = 0.01 (m/s)/mm, or 2×10⁻⁵ with its exponent raised."""
SCALES: Mapping[Plane, str] = {"position": "length", "velocity": "velocity", "acceleration": "acceleration"}


@frozen
class Fault:
    """Something wrong with a drawing file that is no length.

    kind  "paper", "transform", "changed", "scale", "missing", "extra", "end", "loose"
    what  which element, and what about it
    """

    kind: str
    what: str


@frozen
class DrawingFile:
    """A parsed drawing file: lines and circles in mm, y up, scales as written, and what the file claims to be."""

    file: str
    vectors: tuple[tuple[Mapping[str, str], complex, complex], ...]
    points: tuple[tuple[Mapping[str, str], complex], ...]
    written: tuple[tuple[str, str], ...]
    claims: Mapping[str, object]
    faults: tuple[Fault, ...]


def read(path: Path) -> DrawingFile:
    """The drawing in a file; `BadDrawing` where it is none of graphkin's."""
    from defusedxml.common import DefusedXmlException
    from defusedxml.ElementTree import fromstring

    file = str(path)
    try:
        if path.stat().st_size > LIMIT:
            raise BadDrawing(Where(file), "large")
        root = fromstring(path.read_bytes())
    except FileNotFoundError:
        raise NoDrawing(Where(file)) from None
    except OSError as error:
        raise BadDrawing(Where(file), "unreadable", error.strerror or "") from error
    except (ParseError, DefusedXmlException, ValueError, LookupError, RecursionError) as error:
        raise BadDrawing(Where(file), "xml") from error
    if not root.tag.endswith("}svg"):
        raise BadDrawing(Where(file), "svg")
    return _parse(file, root)


def _parse(file: str, root: Element) -> DrawingFile:
    vectors, points, written = [], [], list[tuple[str, str]]()
    faults = _paper(root)
    try:
        for element, moved in _walk(root):
            tag, kind = element.tag.rpartition("}")[2], element.get("class", "").split()
            if tag == "line" and "vector" in kind:
                vectors.append((element.attrib, _place(element, "x1", "y1"), _place(element, "x2", "y2")))
            elif tag == "circle" and "point" in kind:
                points.append((element.attrib, _place(element, "cx", "cy")))
            elif tag == "text" and (found := WRITTEN.search("".join(element.itertext()))):
                written.append((found[1], found[2]))
                continue
            else:
                continue
            if moved:
                faults.append(Fault("transform", str(element.get("data-name"))))
    except (KeyError, ValueError) as error:
        raise BadDrawing(Where(file), "element", str(error)) from error
    if not points:
        raise BadDrawing(Where(file), "points")
    return DrawingFile(file, tuple(vectors), tuple(points), tuple(written), _claims(file, root), tuple(faults))


def _walk(root: Element) -> Iterator[tuple[Element, bool]]:
    """Every element, and whether a transform stands on it or above it."""
    stack = [(root, False)]
    while stack:
        element, moved = stack.pop()
        moved = moved or "transform" in element.attrib or "transform" in element.get("style", "")
        yield element, moved
        stack.extend((child, moved) for child in reversed(element))


def _place(element: Element, x: str, y: str) -> complex:
    place = complex(float(element.attrib[x]), -float(element.attrib[y]))
    if not (math.isfinite(place.real) and math.isfinite(place.imag)):
        raise ValueError("finite coordinates")
    return place


def _paper(root: Element) -> list[Fault]:
    """Whether one unit of the drawing is one millimetre on paper."""
    size = f"{root.get('width', '')} {root.get('height', '')}".split()
    box = root.get("viewBox", "").split()
    try:
        true = len(box) == 4 and [float(v) for v in box] == [0, 0, *(float(v.removesuffix("mm")) for v in size)]
    except ValueError:
        true = False
    return [] if true and all(v.endswith("mm") for v in size) else [Fault("paper", "")]


def _claims(file: str, root: Element) -> Mapping[str, object]:
    for element in root.iter():
        if element.tag.rpartition("}")[2] == "sheet" and element.text:
            try:
                claims = json.loads(element.text)
            except ValueError as error:
                raise BadDrawing(Where(file), "json") from error
            if isinstance(claims, dict) and claims.get("program") == "graphkin":
                return claims
    raise BadDrawing(Where(file), "metadata")


# --- what it claims ---------------------------------------------------------------------------


def mechanism_of(drawing: DrawingFile) -> Mechanism:
    """The mechanism that a drawing carries."""
    text = drawing.claims.get("mechanism")
    if not isinstance(text, str):
        raise BadDrawing(Where(drawing.file), "mechanism")
    return loading.loads(text, name=Path(drawing.file).stem, file=f"{drawing.file} (mechanism)")


def numbers(drawing: DrawingFile, key: str, count: int) -> list[float]:
    """So many finite numbers that a drawing gives under a key."""
    given = drawing.claims.get(key)
    if not isinstance(given, list) or len(given) != count or not all(_is_number(v) for v in given):
        raise BadDrawing(Where(drawing.file), "value", key)
    return [float(v) for v in given]


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def scales_of(drawing: DrawingFile) -> Mapping[Plane, float]:
    """Scale of each plane that the drawing shows [m, m/s or m/s^2 per mm]."""
    given = drawing.claims.get("scales")
    scales: dict[Plane, float] = {}
    for plane, key in SCALES.items():
        value = given.get(key) if isinstance(given, dict) else None
        if value is None and not any(attributes.get("data-plane") == plane for attributes, *_ in drawing.points):
            continue
        if not (_is_number(value) and isinstance(value, int | float) and value > 0):
            raise BadDrawing(Where(drawing.file), "value", f"scales.{key}")
        scales[plane] = float(value)
    return scales


def plane_of(drawing: DrawingFile, attributes: Mapping[str, str]) -> Plane:
    """The plane that an element says it lies in."""
    plane = attributes.get("data-plane", "")
    for known in UNITS:
        if plane == known:
            return known
    raise BadDrawing(Where(drawing.file), "value", f"data-plane={plane}")
