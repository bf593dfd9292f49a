"""How an SVG viewer paints things: presentation attributes and inline styles, inherited; visible or not."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache

from graphkin.base.value import frozen
from graphkin.check.transforms import Unread, length, numbers_in

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
"""What moves and hides nothing but letters."""
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


FAINT = 0.3
"""Ink fainter than this is none."""
HAIR = 0.1
"""A thinner line is none [mm]."""


@frozen
class Style:
    """What a viewer paints an element with. `painted`: the inherited properties; `opacity`: of it and all above it."""

    painted: Mapping[str, str]
    opacity: float = 1.0
    shown: bool = True

    def get(self, key: str, usual: str = "") -> str:
        return self.painted.get(key, usual)

    def visible(self) -> bool:
        return self.shown and self.get("visibility", "visible") not in ("hidden", "collapse")

    def share(self, what: str) -> float:
        """How much of the paper `fill` or `stroke` hides: 0 nothing, 1 all."""
        if self.get(what, "#000" if what == "fill" else "none") == "none" or not self.visible():
            return 0.0
        return self.opacity * _share(self.get(f"{what}-opacity", "1"))

    def ink(self, what: str) -> float:
        """How much darker than the paper that is, 0 to 1; of paints that this reader does not know, nothing."""
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
    """Whether a style sheet sets type and nothing else."""
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
    """Whether dashes leave less than half of a line, or gaps one could lose it in."""
    text = style.get("stroke-dasharray", "none")
    if text in ("none", ""):
        return False
    dashes = [length(part) for part in text.replace(",", " ").split()]
    dashes *= 1 + len(dashes) % 2
    return length_of_path or 2 * sum(dashes[::2]) < sum(dashes) or max(dashes[1::2]) > 3
