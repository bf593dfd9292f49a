"""What a viewer shows of an SVG: every shape and every text where it comes to lie on paper, and how it is painted.

Groups, plain transforms, presentation attributes and inline styles are followed. What is in `defs` is not shown.
Where a reader would have to be a browser (scripts, animation, style sheets, copies, clipping), it says so and stops.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from xml.etree.ElementTree import Element

from graphkin.base.value import frozen
from graphkin.check.outlines import SHAPES, is_plain, outline
from graphkin.check.styles import Style, harmless_sheet, styled
from graphkin.check.transforms import Affine, Unread, length, paper, transform

SVG = "{http://www.w3.org/2000/svg}"
_ALIVE = ("script", "animate", "animateTransform", "animateMotion", "animateColor", "set", "discard", "handler")
_COPIES = ("use", "switch", "foreignObject", "svg", "iframe", "object", "video", "canvas")
_NOT_SHOWN = (
    "defs", "symbol", "marker", "clipPath", "mask", "pattern", "linearGradient", "radialGradient", "filter", "metadata",
    "title", "desc", "style", "view", "cursor",
)  # fmt: skip


@frozen
class ShownMark:
    """A shape or a text on paper.

    tag, attributes  as in the file
    lines            its polylines in mm on paper, y up; of a circle and of curves near to them
    plain            whether they are the shape itself
    scale            mm to a unit
    text             the letters that can be read, of a text
    tip              what a viewer shows where it is pointed at
    """

    tag: str
    attributes: Mapping[str, str]
    style: Style
    affine: Affine
    lines: tuple[tuple[complex, ...], ...] = ()
    plain: bool = True
    text: str = ""
    tip: str = ""

    @property
    def kind(self) -> list[str]:
        return self.attributes.get("class", "").split()

    @property
    def scale(self) -> float:
        return self.affine.scale

    @property
    def middle(self) -> complex:
        """Of a circle."""
        return self.affine(*(length(self.attributes.get(key, "0")) for key in ("cx", "cy")))

    @property
    def width(self) -> float:
        """Of its line [mm]."""
        return length(self.style.get("stroke-width", "1")) * self.scale if self.style.share("stroke") else 0.0


@frozen
class Sight:
    """A whole sheet: its paper [mm], what is on it from the bottom up, and what is doubtful about its size."""

    paper: complex
    shown: tuple[ShownMark, ...]
    doubt: str


def seen_in(root: Element) -> Sight:
    """What a viewer shows of a drawing. Raises Unread, with what stands in the way."""
    _still(root)
    if transform(root.attrib.get("transform", "")) != Affine():
        raise Unread("a transform of the sheet")
    affine, size, doubt = paper(root.attrib)
    return Sight(size, tuple(_walk(root, affine, Style({}))), doubt)


def _still(root: Element) -> None:
    """Nothing in the file acts, and no style sheet reaches a line."""
    for element in root.iter():
        name = _name(element)
        if name in _ALIVE or any(key.rpartition("}")[2].startswith("on") for key in element.attrib):
            raise Unread(f"<{name}>" if name in _ALIVE else f"an event of <{name}>")
        if name == "style" and not harmless_sheet("".join(element.itertext())):
            raise Unread("a style sheet")


def _name(element: Element) -> str:
    return element.tag.rpartition("}")[2]


def _walk(element: Element, outer: Affine, above: Style) -> Iterator[ShownMark]:
    style = styled(element.attrib, above)
    affine = outer.then(transform(element.attrib.get("transform", "")))
    for child in element:
        name = _name(child)
        if not child.tag.startswith(SVG) or name in _NOT_SHOWN:
            continue
        if name in _COPIES:
            raise Unread(f"<{name}>")
        if name in ("g", "a"):
            yield from _walk(child, affine, style)
        elif name in SHAPES or name == "text":
            yield _shape(child, name, affine, style)


def _shape(element: Element, name: str, outer: Affine, above: Style) -> ShownMark:
    style = styled(element.attrib, above)
    affine = outer.then(transform(element.attrib.get("transform", "")))
    if name == "text":
        if style.share("stroke") and length(style.get("stroke-width", "1")) * affine.scale > 1:
            raise Unread("a text drawn with a thick pen")
        text = "".join(_letters(element, style, affine))
        return ShownMark(name, element.attrib, style, affine, ((_begin(element, affine),),), text=text)
    lines = tuple(tuple(affine(p.real, p.imag) for p in line) for line in outline(name, element.attrib))
    tip = "".join(child.text or "" for child in element if _name(child) == "title")
    return ShownMark(name, element.attrib, style, affine, lines, is_plain(name, element.attrib), tip=tip)


def _letters(element: Element, style: Style, affine: Affine) -> Iterator[str]:
    """The letters of a text that can be read: dark enough, large enough, not hidden."""
    if any(style.share(what) > 0.3 and style.ink(what) < 0.2 for what in ("fill", "stroke")):
        raise Unread("a text too light to be read")
    if _readable(style, affine):
        yield element.text or ""
    for child in element:
        if child.tag.startswith(SVG) and _name(child) in ("tspan", "a"):
            yield from _letters(child, styled(child.attrib, style), affine)
        elif child.tag.startswith(SVG) and _name(child) not in _NOT_SHOWN:
            raise Unread(f"<{_name(child)}> in a text")
        if _readable(style, affine):
            yield child.tail or ""


def _begin(element: Element, affine: Affine) -> complex:
    """Where a text begins."""
    x, y = (next((e.attrib[key] for e in element.iter() if e.get(key)), "0") for key in "xy")
    return affine(*(length(value.replace(",", " ").split()[0]) for value in (x, y)))


def _readable(style: Style, affine: Affine) -> bool:
    return style.ink("fill") > 0.2 and length(style.get("font-size", "16")) * affine.scale > 0.8
