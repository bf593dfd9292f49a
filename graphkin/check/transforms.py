"""Where an SVG viewer puts things: numbers, lengths, transforms, and the paper under them."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from functools import lru_cache
from typing import NamedTuple

NUMBER = r"[+-]?(?:[0-9]+(?:\.[0-9]+)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
"""As SVG writes numbers: ASCII digits alone."""
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
        """How much longer lines become; Unread where that hangs on their direction."""
        size = math.hypot(self.a, self.b)
        even, square = abs(math.hypot(self.c, self.d) - size), abs(self.a * self.c + self.b * self.d)
        if even > 1e-6 * size or square > 1e-6 * size**2:
            raise Unread("a transform that stretches one way")
        return size


def numbers_in(text: str) -> list[float]:
    """A list of numbers, by blanks or commas."""
    if not _LIST.fullmatch(text):
        raise Unread(f"the numbers {text.strip()[:40]!r}")
    found = [float(number) for number in re.findall(NUMBER, text)]
    if not all(map(math.isfinite, found)):
        raise Unread(f"the numbers {text.strip()[:40]!r}")
    return found


@lru_cache(maxsize=1024)
def length(text: str) -> float:
    """A length in user units; a unit counts as CSS has it, 96 to the inch."""
    found = _LENGTH.fullmatch(text)
    if found is None or (found[2] and found[3]):
        raise Unread(f"the length {text.strip()[:40]!r}")
    value = float(found[1]) * (96.0 / _INCH[found[3]] if found[3] else 1.0)
    if not math.isfinite(value):
        raise Unread(f"the length {text.strip()[:40]!r}")
    return value


def transform(text: str) -> Affine:
    """What a `transform` attribute does."""
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
