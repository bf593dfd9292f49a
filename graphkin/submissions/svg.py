"""SVG as drawing programs save it: layers, transforms, copies, units, texts in pieces; and graphkin's own sheets."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from itertools import pairwise
from xml.etree.ElementTree import Element, ParseError

from graphkin.base.value import frozen
from graphkin.check.outlines import Affine, Unread, is_plain, length, numbers_in, outline, transform
from graphkin.construction import SCALES, Plane
from graphkin.errors import BrokenSubmission, Where
from graphkin.submissions.picture import Dot, PagePicture, PictureArrow, PictureText
from graphkin.submissions.submission import Limits

BOARD = "graphkin-board"  # the id of the metadata of a drawing board's file
_PX = 25.4 / 96
_INK = "{http://www.inkscape.org/namespaces/inkscape}"
_ROLE = "{http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd}role"
_HREF = "{http://www.w3.org/1999/xlink}href"
_DEFINED = ("defs", "symbol", "marker", "clipPath", "mask", "pattern", "linearGradient", "radialGradient", "filter",
            "metadata", "title", "desc", "style", "script", "namedview", "foreignObject")  # fmt: skip
_LINES = ("line", "polyline", "polygon", "path")
_WIDE, _ABOVE, _BELOW = 0.52, 0.75, 0.22
"""A letter's width, and how far letters reach over and under their line, in parts of the type's size."""
_FAR = 1e9  # no page is so large [mm]
_Mark = list[tuple[complex, complex]] | Dot | PictureText


def xml_root(content: bytes, where: Where, kind: str, limits: Limits, forbid_dtd: bool = False) -> Element:
    """The tree of hostile XML. Raises BrokenSubmission, TooMuch."""
    from defusedxml.common import DefusedXmlException
    from defusedxml.ElementTree import fromstring

    try:
        root: Element = fromstring(content, forbid_dtd=forbid_dtd)
    except (ParseError, DefusedXmlException, ValueError, LookupError, RecursionError) as problem:
        reason = str(problem) if isinstance(problem, ParseError) else type(problem).__name__
        raise BrokenSubmission(where, kind, reason[:120]) from None
    level, depth, count = [root], 0, 0
    while level:
        count += len(level)
        depth += 1
        limits.check(where, "depth", depth)
        limits.check(where, "elements", count)
        level = [child for element in level for child in element]
    return root


def read_svg(content: bytes, where: Where, limits: Limits) -> PagePicture:
    """Raises BrokenSubmission, TooMuch."""
    root = xml_root(content, where, "SVG", limits)
    if _name(root) != "svg":
        raise BrokenSubmission(where, "SVG")
    reader = _SvgReader(root, where, limits)
    try:
        marks = list(reader.walk(root, _page(root.attrib), _Type()))
    except Unread as problem:
        raise BrokenSubmission(where, "SVG", str(problem)) from None
    except (OverflowError, ZeroDivisionError):
        raise BrokenSubmission(where, "SVG", "numbers") from None
    lines = tuple(line for mark in marks if isinstance(mark, list) for line in mark)
    dots = tuple(mark for mark in marks if isinstance(mark, Dot))
    texts = tuple(mark for mark in marks if isinstance(mark, PictureText))
    if BOARD in reader.by_id:  # its points say what they are, whatever letters stand beside them
        dots, texts = tuple(dot for dot in dots if dot.plane is not None), ()
    places = [*(end for line in lines for end in line), *(dot.place for dot in dots), *(text.corner for text in texts)]
    if not all(abs(place.real) + abs(place.imag) < _FAR for place in places):  # NaN is no place either
        raise BrokenSubmission(where, "SVG", "numbers")
    return PagePicture(lines, dots, texts, tuple(reader.arrows), _stated(root))


@frozen
class _Type:
    """The type of letters, as inherited: size in user units, and where they hang."""

    size: float = 16.0
    anchor: str = "start"
    shown: bool = True


class _SvgReader:
    """Walks the tree once; copies are followed as often as the limits allow."""

    def __init__(self, root: Element, where: Where, limits: Limits) -> None:
        self.where, self.limits = where, limits
        self.by_id = {element.attrib["id"]: element for element in root.iter() if "id" in element.attrib}
        self.copies = self.walked = self.pieces = 0
        self.arrows: list[PictureArrow] = []

    def walk(self, element: Element, affine: Affine, kind: _Type, depth: int = 0) -> Iterator[_Mark]:
        """The marks of an element's children."""
        self.limits.check(self.where, "depth", depth)
        for child in element:
            yield from self.mark(child, affine, kind, depth)

    def mark(self, element: Element, outer: Affine, above: _Type, depth: int) -> Iterator[_Mark]:
        name = _name(element)
        self.walked += 1
        self.limits.check(self.where, "elements", self.walked)
        kind = above if name in _DEFINED else _typed(element, above)
        if name in _DEFINED or not kind.shown:
            return
        affine = outer.then(transform(element.attrib.get("transform", "")))
        if name in ("g", "a", "switch"):
            yield from self.walk(element, affine, kind, depth + 1)
        elif name == "svg":
            inner = _shift(element.attrib)
            if {"viewBox", "width", "height"} <= element.attrib.keys():  # fitted to its own box
                box = _page(element.attrib)
                inner = inner.then(Affine(box.a / _PX, 0.0, 0.0, box.d / _PX, box.e / _PX, box.f / _PX))
            yield from self.walk(element, affine.then(inner), kind, depth + 1)
        elif name == "use":
            self.copies += 1
            self.limits.check(self.where, "copies", self.copies)
            self.limits.check(self.where, "depth", depth)
            href = element.attrib.get("href") or element.attrib.get(_HREF, "")
            if (target := self.by_id.get(href.removeprefix("#"))) is None:
                return
            moved = affine.then(_shift(element.attrib))
            if _name(target) == "symbol":
                yield from self.walk(target, moved, _typed(target, kind), depth + 1)
            else:
                yield from self.mark(target, moved, kind, depth + 1)
        elif name == "text":
            lines = [child for child in element if _name(child) == "tspan" and child.get(_ROLE) == "line"]
            for line in lines if len(lines) > 1 else [element]:
                yield from _text(line, affine, kind if line is element else _typed(line, kind), element)
        elif name in ("circle", "ellipse"):
            x, y = (length(element.attrib.get(key, "0")) for key in ("cx", "cy"))
            yield Dot(affine(x, y), *_named(element))
        elif name in _LINES and is_plain(name, element.attrib):
            yield self._line(name, element, affine)

    def _line(self, name: str, element: Element, affine: Affine) -> list[tuple[complex, complex]]:
        runs = [[affine(z.real, z.imag) for z in run] for run in outline(name, element.attrib)]
        pieces = [(a, b) for run in runs for a, b in pairwise(run) if a != b]
        self.pieces += len(pieces)
        self.limits.check(self.where, "elements", self.pieces)
        if len(pieces) == 1:
            gap = re.fullmatch(r"\d+\.\d{4}", element.attrib.get("data-broken", ""))
            unit = abs(affine(1.0, 0.0) - affine(0.0, 0.0))
            left_out = unit * float(gap[0]) if gap and "stroke-dasharray" in element.attrib else 0.0
            self.arrows.append(PictureArrow(_named(element)[0], *pieces[0], left_out))
        return pieces


def _name(element: Element) -> str:
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def _named(element: Element) -> tuple[str, Plane | None]:
    """The name that a dot bears in the file: graphkin's own, Inkscape's label, or its id."""
    attributes = element.attrib
    if "data-name" in attributes:
        plane = next((plane for plane in SCALES if plane == attributes.get("data-plane")), None)
        return attributes["data-name"][:60], plane
    return (attributes.get(f"{_INK}label") or attributes.get("id", ""))[:60], None


def _page(attributes: Mapping[str, str]) -> Affine:
    """From the root's units to mm on the page. Without a width in units a pixel is one of 96 to the inch."""
    box = numbers_in(attributes.get("viewBox", "").replace(",", " "))
    stated = (re.sub(r"(?<=[0-9])\s+(?=[a-zA-Z])", "", attributes.get(key, "")) for key in ("width", "height"))
    wide, high = (0.0 if text.strip()[-1:] in ("", "%") else length(text) * _PX for text in stated)
    if len(box) != 4 or not (box[2] > 0 and box[3] > 0):
        return Affine(_PX, 0.0, 0.0, _PX, 0.0, 0.0)
    ratios = [size / unit for size, unit in ((wide, box[2]), (high, box[3])) if size]
    if attributes.get("preserveAspectRatio", "").strip().startswith("none") and len(ratios) == 2:
        return Affine(ratios[0], 0.0, 0.0, ratios[1], -box[0] * ratios[0], -box[1] * ratios[1])
    scale = min(ratios, default=_PX)
    return Affine(scale, 0.0, 0.0, scale, -box[0] * scale, -box[1] * scale)


def _shift(attributes: Mapping[str, str]) -> Affine:
    return Affine(e=length(attributes.get("x", "0")), f=length(attributes.get("y", "0")))


def _typed(element: Element, above: _Type) -> _Type:
    declared = (declaration.partition(":") for declaration in element.attrib.get("style", "").split(";"))
    style = {name.strip(): value.strip() for name, _, value in declared}
    keys = ("font-size", "text-anchor", "display", "visibility")
    size, anchor, display, visibility = (style.get(key, element.attrib.get(key, "")) for key in keys)
    shown = above.shown and display != "none" and visibility not in ("hidden", "collapse")
    tall = above.size
    with suppress(Unread, ValueError):
        if size.endswith("%"):
            tall = tall * float(size[:-1]) / 100
        elif size.endswith("em"):
            tall *= float(size[:-2])
        elif size:
            tall = length(size)
    return _Type(tall, anchor or above.anchor, shown)


def _text(element: Element, affine: Affine, kind: _Type, whole: Element) -> Iterator[PictureText]:
    letters = "".join(_letters(element)).strip()
    if not letters:
        return
    pieces = [*element.iter(), *whole.iter()]  # of these the first that says so tells where the text starts
    starts = (next((text for piece in pieces if (text := piece.attrib.get(key, "")).strip()), "0") for key in "xy")
    x, y = (length(start.replace(",", " ").split()[0]) for start in starts)
    corner = affine(x, y)
    right, up = affine(x + 1, y) - corner, affine(x, y - 1) - corner
    scale, tall = abs(right), abs(up)
    if not (math.isfinite(scale * tall) and scale > 0 and tall > 0):
        return
    size = max(_typed(piece, kind).size for piece in element.iter())
    width = _WIDE * size * scale * len(letters)
    start = {"middle": width / 2, "end": width}.get(_typed(element, kind).anchor, 0.0)
    yield PictureText(
        letters[:400], corner - start * right / scale, right / scale, up / tall, width,
        _ABOVE * size * tall, _BELOW * size * tall,
    )  # fmt: skip


def _letters(element: Element) -> Iterator[str]:
    """All the letters of a text, without the line breaks between its pieces."""
    if _name(element) not in ("title", "desc"):
        yield re.sub(r"\s*\n\s*", "", element.text or "")
        for child in element:
            yield from _letters(child)
            yield re.sub(r"\s*\n\s*", "", child.tail or "")


def _stated(root: Element) -> dict[Plane, float]:
    """The scales in the metadata of a sheet of graphkin's own."""
    for element in root.iter():
        if _name(element) == "sheet" and element.text:
            try:
                scales = json.loads(element.text)["scales"].items()
            except (ValueError, RecursionError, KeyError, TypeError, AttributeError):
                return {}
            sized = {key: float(v) for key, v in scales if isinstance(v, float | int) and 1e-9 < v < 1e9}
            return {plane: sized[key] for plane, key in SCALES.items() if key in sized}
    return {}
