"""A drawing file, read: what a viewer shows of it in mm, and what it claims to be."""

from __future__ import annotations

import json
import math
import re
import sys
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from xml.etree.ElementTree import Element, ParseError, TreeBuilder

from graphkin import files as loading
from graphkin.base.value import frozen
from graphkin.check.outlines import Unread
from graphkin.check.shown import ShownMark, Sight, seen_in
from graphkin.construction import Plane
from graphkin.errors import BadDrawing, NoDrawing, NothingToMeasure, Where
from graphkin.model.mechanism import Mechanism

LIMIT = 16 << 20  # larger drawings are not ours [bytes]
FORMAT = 3
MARKS = ("vector", "point", "link")  # classes of what a ruler is laid on
UNITS: Mapping[Plane, str] = {"position": "m", "velocity": "m/s", "acceleration": "m/s^2"}
SCALES: Mapping[Plane, str] = {"position": "length", "velocity": "velocity", "acceleration": "acceleration"}


@frozen
class Fault:
    """Something wrong with a drawing file that is no length; or, as a note, what was not judged.

    kind  as the catalogue has it, `checks.fault ..`
    what  which element, and what about it
    """

    kind: str
    what: str


@frozen
class DrawingFile:
    """A drawing file: the elements a viewer shows, what the file claims to be, and its root."""

    file: str
    sight: Sight
    claims: Mapping[str, object]
    root: Element

    def measures(self, element: ShownMark) -> bool:
        """A ruler is laid on it: a vector's line, a point's dot, a line of a link where links have points."""
        if "link" in element.kind:
            return self.measures_links or element.attributes.get("data-form") == "ruler"
        tag = next((tag for kind, tag in (("vector", "line"), ("point", "circle")) if kind in element.kind), "")
        return element.tag == tag

    @property
    def title(self) -> str:
        """The name of the sheet in a viewer."""
        return next((element.text or "" for element in self.root if element.tag.endswith("}title")), "")

    def of_class(self, kind: str) -> tuple[ShownMark, ...]:
        return tuple(element for element in self.sight.shown if kind in element.kind)

    @cached_property
    def vectors(self) -> tuple[tuple[Mapping[str, str], complex, complex], ...]:
        """Attributes, tail and head [mm, y up], where they belong if it is drawn aside or broken. A vector is a `line`;
        anything else cannot be one."""
        return tuple((line.attributes, *ends(line)) for line in self._arrows)

    @cached_property
    def _arrows(self) -> list[ShownMark]:
        return [element for element in self.of_class("vector") if element.tag == "line"]

    @cached_property
    def measures_links(self) -> bool:
        """Links are held against points of theirs; a sheet of other positions has none."""
        return any(attributes.get("data-plane") in UNITS for attributes, _ in self.points)

    @cached_property
    def points(self) -> tuple[tuple[Mapping[str, str], complex], ...]:
        """Attributes and place [mm, y up], where it belongs if it is the head of a vector that is drawn broken."""
        circles = [element for element in self.of_class("point") if element.tag == "circle"]
        moved = {(line.attributes.get("data-plane"), line.attributes.get("data-head")): piece
                 for line in self._arrows if (piece := _left_out(line))}  # fmt: skip
        keys = [(circle.attributes.get("data-plane"), circle.attributes.get("data-name")) for circle in circles]
        return tuple((circle.attributes, circle.middle + moved.get(key, 0))
                     for circle, key in zip(circles, keys, strict=True))  # fmt: skip


def stated(element: ShownMark) -> tuple[str, ...]:
    """The claim of an element: its class and its `data-*`, as the file lists them."""
    kind = next(kind for kind in MARKS if kind in element.kind)
    data = {key.removeprefix("data-"): value for key, value in element.attributes.items() if key.startswith("data-")}
    return (kind, *sorted(f"{key}={value}" for key, value in data.items() if key != "step" and value))


class _TreeBuilder(TreeBuilder):
    """Builds the tree, and sees what stands before it."""

    def pi(self, target: str, text: str | None = None) -> Element:
        if "stylesheet" in target:
            raise Unread("a style sheet")
        return super().pi(target, text)


def read(path: Path) -> DrawingFile:
    """The drawing in a file, or through a pipe (`-`). `BadDrawing` where it is none, or cannot be followed."""
    file = "<stdin>" if str(path) == "-" else str(path)
    root = _root(path, file)
    if not root.tag.endswith("}svg"):
        raise BadDrawing(Where(file), "svg")
    for element in root.iter():
        if element.tag.rpartition("}")[2] != "sheet" or not element.text:
            continue
        try:
            claims = json.loads(element.text)
        except (ValueError, RecursionError) as error:
            raise BadDrawing(Where(file), "json") from error
        if isinstance(claims, dict) and claims.get("program") == "graphkin":
            break
    else:
        raise BadDrawing(Where(file), "metadata")
    if claims.get("format") != FORMAT:
        raise BadDrawing(Where(file), "older")
    if (style := claims.get("style")) in ("given", "moving", "bare"):
        raise NothingToMeasure(Where(file), str(style))
    try:
        return DrawingFile(file, seen_in(root), claims, root)
    except Unread as error:
        raise BadDrawing(Where(file), "shown", str(error)) from None


def _root(path: Path, file: str) -> Element:
    from defusedxml.common import DefusedXmlException
    from defusedxml.ElementTree import DefusedXMLParser

    parser = DefusedXMLParser(target=_TreeBuilder())
    try:
        if str(path) == "-":
            content = sys.stdin.buffer.read(LIMIT + 1)
        else:
            content = path.read_bytes() if path.stat().st_size <= LIMIT else b" " * (LIMIT + 1)
        if len(content) > LIMIT:
            raise BadDrawing(Where(file), "large")
        parser.feed(content)
        root: Element = parser.close()
    except FileNotFoundError:
        raise NoDrawing(Where(file)) from None
    except OSError as error:
        raise BadDrawing(Where(file), "unreadable", error.strerror or "") from error
    except Unread as error:
        raise BadDrawing(Where(file), "shown", str(error)) from None
    except (ParseError, DefusedXmlException, ValueError, LookupError, RecursionError) as error:
        raise BadDrawing(Where(file), "xml") from error
    level, depth = [root], 0  # how deep elements are nested
    while level:
        level, depth = [child for element in level for child in element], depth + 1
    if depth > 100:
        raise BadDrawing(Where(file), "xml")
    return root


def mechanism_of(drawing: DrawingFile) -> Mechanism:
    """The mechanism that a drawing carries."""
    text = drawing.claims.get("mechanism")
    if not isinstance(text, str) or not text.strip():
        raise BadDrawing(Where(drawing.file), "mechanism")
    return loading.loads(text, name=Path(drawing.file).stem, file=f"{drawing.file} (mechanism)")


def driver_values(drawing: DrawingFile, count: int) -> list[float]:
    """The values of so many drivers that a drawing gives, all finite."""
    given = drawing.claims.get("drivers")
    if not isinstance(given, list) or len(given) != count or not all(_is_number(v) for v in given):
        raise BadDrawing(Where(drawing.file), "value", "drivers")
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


def ends(vector: ShownMark) -> tuple[complex, complex]:
    """The ends of a vector's line, moved back by what it says it is drawn to its left, and on by what it leaves out."""
    tail, head = vector.lines[0][0], vector.lines[0][-1]
    aside = re.fullmatch(r"-?\d\.\d{4}", vector.attributes.get("data-aside", ""))
    off = 1j * (head - tail) / (abs(head - tail) or 1.0) * float(aside[0]) if aside else 0j
    return tail - off, head - off + _left_out(vector)


def _left_out(vector: ShownMark) -> complex:
    """The piece of a vector that it says it leaves out, of one with a gap [mm, y up]."""
    along = vector.lines[0][-1] - vector.lines[0][0]
    broken = re.fullmatch(r"\d+\.\d{4}", vector.attributes.get("data-broken", ""))
    gap = vector.style.get("stroke-dasharray", "none") not in ("none", "")
    return along / (abs(along) or 1.0) * float(broken[0]) if broken and gap else 0j
