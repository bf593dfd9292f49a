"""Everything that a viewer shows of an SVG: each shape and text where it lies on paper, and the paint it has.

Groups, plain transforms, presentation attributes and inline styles are followed. What is in `defs` is not shown.
Where a reader would have to be a browser (scripts, animation, style sheets, copies, clipping), it says so and stops.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from xml.etree.ElementTree import Element

from graphkin.base.value import frozen
from graphkin.check.outlines import SHAPES, Affine, Unread, is_plain, length, numbers_in, outline, paper, transform

# --- paint: presentation attributes and inline styles ------------------------------------------


_PAINTED = (
    "fill", "stroke", "stroke-width", "stroke-opacity", "fill-opacity", "stroke-dasharray", "visibility",
    "marker-start", "marker-mid", "marker-end", "font-size", "color",
)  # fmt: skip
"""Properties that are inherited and say what is seen."""
_HARMLESS = re.compile(
    r"-inkscape-.*|font-(?!size).*|text-.*|(letter|word)-spacing|line-height|white-space|writing-mode|direction"
    r"|(shape|text|color|image)-rendering|color-interpolation.*|paint-order|(fill|clip)-rule|enable-background"
    r"|stroke-(linejoin|linecap|miterlimit|dashoffset)|stop-.*|solid-.*|(dominant|alignment)-baseline|baseline-shift"
)
"""Properties that move and hide nothing but letters."""
_TYPE_ALONE = re.compile(r"font-(family|style|weight|variant)|text-rendering|shape-rendering")
_REFUSED = (
    "clip-path", "mask", "filter", "clip", "transform-origin", "transform-box", "mix-blend-mode",
    "requiredFeatures", "requiredExtensions", "systemLanguage",
)  # fmt: skip
_NOTHING = ("", "none", "auto", "normal", "visible")
_NAMED: Mapping[str, str] = {
    "black": "000", "white": "fff", "red": "f00", "green": "008000", "blue": "00f", "yellow": "ff0", "gray": "808080",
    "grey": "808080", "silver": "c0c0c0", "maroon": "800000", "navy": "000080", "purple": "800080", "teal": "008080",
    "olive": "808000", "orange": "ffa500", "brown": "a52a2a", "darkgreen": "006400", "darkblue": "00008b",
    "darkred": "8b0000", "magenta": "f0f", "cyan": "0ff", "lime": "0f0", "currentcolor": "000",
}  # fmt: skip


FAINT = 0.3  # ink fainter than this is none
HAIR = 0.1  # a thinner line is none [mm]


@frozen
class Style:
    """The paint of an element. `painted`: the inherited properties; `opacity`: of it and all above it."""

    painted: Mapping[str, str]
    opacity: float = 1.0
    shown: bool = True

    def get(self, key: str, usual: str = "") -> str:
        return self.painted.get(key, usual)

    def share(self, what: str) -> float:
        """The part of the paper that `fill` or `stroke` hides: 0 nothing, 1 all."""
        visible = self.shown and self.get("visibility", "visible") not in ("hidden", "collapse")
        if self.get(what, "#000" if what == "fill" else "none") == "none" or not visible:
            return 0.0
        return self.opacity * _share(self.get(f"{what}-opacity", "1"))

    def ink(self, what: str) -> float:
        """The darkness beside the paper's, 0 to 1; of paints that this reader does not know, nothing."""
        light = brightness(self.get(what, "#000"))
        return self.share(what) * (1 - light) if light is not None else 0.0


def styled(attributes: Mapping[str, str], parent: Style) -> Style:
    """The style of an element. Raises Unread for what may move, hide or cut it in a way that is not followed."""
    for key in _REFUSED:
        if attributes.get(key, "").strip() not in _NOTHING:
            raise Unread(f"{key}={attributes[key].strip()[:40]!r}")
    own = {key: attributes[key].strip() for key in (*_PAINTED, "opacity", "display") if key in attributes}
    own |= dict(_declared(attributes["style"])) if "style" in attributes else {}
    opacity, display = own.pop("opacity", "1"), own.pop("display", "inline")
    if {opacity, display, *own.values()} & {"initial", "unset", "revert"}:
        raise Unread("a style that is set back")
    painted = {**parent.painted, **{key: value for key, value in own.items() if value != "inherit"}}
    shown = parent.shown and display != "none"
    return Style(painted, parent.opacity * _share(opacity), shown)


def _declared(style: str) -> list[tuple[str, str]]:
    """Name and value of each declaration that paints; harmless ones are left out."""
    found = []
    if re.search(r"/\*|\\|var\(|calc\(|[{}@]", style):
        raise Unread(f"style={style[:40]!r}")
    for declaration in filter(str.strip, style.split(";")):
        name, colon, value = (part.strip() for part in declaration.partition(":"))
        name, value = name.lower(), value.removesuffix("!important").strip()
        if name in (*_PAINTED, "opacity", "display") and colon:
            found.append((name, value))
        elif not _HARMLESS.fullmatch(name) and value not in _NOTHING:
            raise Unread(f"style {name}: {value[:40]}")
    return found


def harmless_sheet(text: str) -> bool:
    """True if a style sheet sets type and nothing else."""
    if "@" in text or "\\" in text:
        return False
    bare = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    blocks = re.findall(r"\{([^{}]*)\}", bare)
    names = [d.partition(":")[0].strip().lower() for block in blocks for d in block.split(";") if d.strip()]
    return re.sub(r"\{[^{}]*\}", "", bare).count("{") == 0 and all(_TYPE_ALONE.fullmatch(name) for name in names)


@lru_cache(maxsize=256)
def _share(text: str) -> float:
    """An opacity: a number or a percentage."""
    percent = text.endswith("%")
    found = numbers_in(text.removesuffix("%"))
    if len(found) != 1:
        raise Unread(f"the opacity {text!r}")
    return min(1.0, max(0.0, found[0] / (100 if percent else 1)))


@lru_cache(maxsize=256)
def brightness(paint: str) -> float | None:
    """0 black to 1 white; None for paints that are no plain colour."""
    text = paint.strip().lower()
    text = "#" + _NAMED[text] if text in _NAMED else text
    if re.fullmatch(r"#[0-9a-f]{3}", text):
        text = "#" + "".join(2 * digit for digit in text[1:])
    if re.fullmatch(r"#[0-9a-f]{6}", text):
        red, green, blue = (int(text[k : k + 2], 16) for k in (1, 3, 5))
    elif (rgb := re.fullmatch(r"rgb\(\s*([0-9]{1,3})\s*,?\s*([0-9]{1,3})\s*,?\s*([0-9]{1,3})\s*\)", text)) is not None:
        red, green, blue = (min(255, int(part)) for part in rgb.groups())
    else:
        return None
    return (0.299 * red + 0.587 * green + 0.114 * blue) / 255


def dashed_away(style: Style, length_of_path: bool) -> bool:
    """True if dashes leave less than half of a line, or gaps one could lose it in."""
    text = style.get("stroke-dasharray", "none")
    if text in ("none", ""):
        return False
    dashes = [length(part) for part in text.replace(",", " ").split()]
    dashes *= 1 + len(dashes) % 2
    return length_of_path or 2 * sum(dashes[::2]) < sum(dashes) or max(dashes[1::2]) > 3


# --- shapes and texts --------------------------------------------------------------------------


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
    """Everything that a viewer shows of a drawing. Raises Unread, with what stands in the way."""
    for element in root.iter():  # nothing in the file acts, and no style sheet reaches a line
        name = _name(element)
        if name in _ALIVE or any(key.rpartition("}")[2].startswith("on") for key in element.attrib):
            raise Unread(f"<{name}>" if name in _ALIVE else f"an event of <{name}>")
        if name == "style" and not harmless_sheet("".join(element.itertext())):
            raise Unread("a style sheet")
    if transform(root.attrib.get("transform", "")) != Affine():
        raise Unread("a transform of the sheet")
    affine, size, doubt = paper(root.attrib)
    return Sight(size, tuple(_walk(root, affine, Style({}))), doubt)


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
        x, y = (next((each.attrib[key] for each in element.iter() if each.get(key)), "0") for key in "xy")
        begin = affine(*(length(value.replace(",", " ").split()[0]) for value in (x, y)))
        return ShownMark(name, element.attrib, style, affine, ((begin,),), text=text)
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


def _readable(style: Style, affine: Affine) -> bool:
    return style.ink("fill") > 0.2 and length(style.get("font-size", "16")) * affine.scale > 0.8
