"""A GeoGebra construction as it is written down, and its formulas: complex numbers are pairs of formulas.

GeoGebra reads what it saves: an `<expression>` or a `<command>`, followed by an `<element>` for each object made, with
how it is shown. Objects hang on one another in their order. Labels are plain ones, so that formulas can name them; what
a reader sees is the caption. Sums and products leave out noughts and ones, so that a reader who opens an object sees
what it comes from.
"""

from __future__ import annotations

import cmath
import re
from xml.sax.saxutils import quoteattr

from graphkin.base.value import frozen

_SIMPLE = re.compile(r"[\w.{}']+|\w+\([^()]*\)")  # a number, a label, or a function of one: what needs no brackets
_NUMBER = re.compile(r"-?[0-9.]+")
_POINT_NAME = re.compile(r"([A-Za-df-hj-w])(_\{\d\w*\})?('*)")
"""Letters that stand for nothing else in a formula (e, i, x, y and z do), as people write them."""
Colour = tuple[int, int, int]
BLACK: Colour = (0, 0, 0)
_UNSEEN = '<show object="false" label="false"/><auxiliary val="true"/>'
_BLACK_LINE = '<show object="true" label="false"/><objColor r="0" g="0" b="0" alpha="0.0"/>'
_THIN = (
    '<show object="true" label="false"/><objColor r="150" g="150" b="150" alpha="0.0"/>'
    '<auxiliary val="true"/><lineStyle thickness="1" type="10"/>'
)


def value(number: float) -> str:
    """A number as GeoGebra reads it, which knows no `1e-05`."""
    text = repr(float(number) + 0.0).removesuffix(".0")
    mantissa, _, power = text.partition("e")
    return f"{mantissa} * 10^({int(power)})" if power else text


def grouped(formula: str) -> str:
    """In brackets, where it is more than one thing."""
    return formula if _SIMPLE.fullmatch(formula) else f"({formula})"


def plus(one: str, other: str) -> str:
    """A sum as GeoGebra writes it."""
    if one == "0" or other == "0":
        return one if other == "0" else other
    return f"{one} + {grouped(other)}"


def minus(one: str, other: str) -> str:
    """A difference as GeoGebra writes it."""
    if other == "0":
        return one
    return f"-{grouped(other)}" if one == "0" else f"{one} - {grouped(other)}"


def product(one: str, other: str) -> str:
    """A product as GeoGebra writes it."""
    if "0" in (one, other):
        return "0"
    if "1" in (one, other):
        return one if other == "1" else other
    if "-1" in (one, other):
        return minus("0", one if other == "-1" else other)
    return f"{grouped(one)} * {grouped(other)}"


@frozen
class FormulaPair:
    """A vector of the plane: two formulas, x and y."""

    x: str = "0"
    y: str = "0"

    @classmethod
    def of(cls, number: complex) -> FormulaPair:
        return cls(value(number.real), value(number.imag))

    @classmethod
    def along(cls, angle: str) -> FormulaPair:
        """The unit vector at an angle [rad]."""
        if _NUMBER.fullmatch(angle):
            return cls.of(cmath.rect(1.0, float(angle)))
        return cls(f"cos({angle})", f"sin({angle})")

    @classmethod
    def between(cls, tail: str, head: str) -> FormulaPair:
        """From a point to a point, both by label."""
        return cls(minus(f"x({head})", f"x({tail})"), minus(f"y({head})", f"y({tail})"))

    def __add__(self, other: FormulaPair) -> FormulaPair:
        return FormulaPair(plus(self.x, other.x), plus(self.y, other.y))

    def times(self, factor: str) -> FormulaPair:
        """Longer by a factor."""
        return FormulaPair(product(factor, self.x), product(factor, self.y))

    @property
    def turned(self) -> FormulaPair:
        """By 90 deg, counter-clockwise."""
        return FormulaPair(minus("0", self.y), self.x)

    def by(self, other: FormulaPair) -> FormulaPair:
        """The product of complex numbers."""
        across, along = product(self.y, other.y), product(self.x, other.x)
        return FormulaPair(minus(along, across), plus(product(self.x, other.y), product(self.y, other.x)))

    def dot(self, other: FormulaPair) -> str:
        return plus(product(self.x, other.x), product(self.y, other.y))

    def cross(self, other: FormulaPair) -> str:
        """Positive where the other is counter-clockwise of it."""
        return minus(product(self.x, other.y), product(self.y, other.x))

    @property
    def angle(self) -> str:
        """Its direction [rad], between -90 and 270 deg."""
        return f"atan({grouped(self.y)} / {grouped(self.x)}) + If[{self.x} < 0, pi, 0]"

    @property
    def point(self) -> str:
        return f"({self.x}, {self.y})"


class Protocol:
    """The objects written so far. Every method adds one and gives its label, by which later ones name it."""

    def __init__(self) -> None:
        self._lines: list[str] = []
        self._count = 0
        self._labels: set[str] = set()

    def text(self) -> str:
        """The objects as XML, one element a line."""
        return "\n".join(self._lines)

    def number(self, formula: str) -> str:
        """A number that is only counted with."""
        return self._formula(self._label("q"), formula, "numeric", _UNSEEN)

    def constant(self, name: str, now: float, unit: str) -> str:
        """A number that a reader may change in the list of objects."""
        shown = f'<value val="{now!r}"/>' + _seen(f"{name} [{unit}]", BLACK, drawn=False)
        return self._element(self._label("g"), "numeric", shown)

    def slider(self, name: str, now: float, reach: float, step: float, at: complex) -> str:
        """A slider around its value now, `at` in units of the drawing."""
        bounds = (
            f'<slider min="{now - reach!r}" max="{now + reach!r}" absoluteScreenLocation="false" width="60" '
            f'x="{at.real!r}" y="{at.imag!r}" fixed="true" horizontal="true" showAlgebra="true"/>'
        )
        shown = _seen(name, BLACK) + f'<animation step="{step!r}" speed="1" type="0" playing="false"/>'
        return self._element(self._label("d"), "numeric", f'<value val="{now!r}"/>{bounds}{shown}')

    def free_point(self, name: str, at: complex, colour: Colour) -> str:
        """A point that can be dragged."""
        return self._element(self._point_label(name), "point", _point(at, name, colour))

    def point(self, name: str, formula: str, at: complex, colour: Colour) -> str:
        """A point by a formula. `at`: where it lies now; a point without a name is not shown."""
        return self._formula(self._point_label(name), formula, "point", _point(at, name, colour))

    def vector(self, name: str, tail: str, head: str, colour: Colour) -> str:
        """An arrow between two points, with its name."""
        width = '<lineStyle thickness="5" type="0" typeHidden="1"/>'
        return self._command("Vector", (tail, head), "u", "vector", (_seen(name, colour) if name else _UNSEEN) + width)

    def direction(self, formula: str) -> str:
        """A direction that is not drawn, as a vector from the origin."""
        return self._formula(self._label("w"), formula, "vector", _UNSEEN)

    def line(self, through: str, direction: str, *, across: bool = False) -> str:
        """A thin line through a point along a direction, or at right angles to it."""
        return self._command("OrthogonalLine" if across else "Line", (through, direction), "h", "line", _THIN)

    def circle(self, about: str, radius: str) -> str:
        """A thin circle."""
        return self._command("Circle", (about, radius), "c", "conic", _THIN)

    def segment(self, tail: str, head: str) -> str:
        """A side of a link."""
        shown = _BLACK_LINE + '<lineStyle thickness="6" type="0"/>'
        return self._command("Segment", (tail, head), "s", "segment", shown)

    def crossing(self, one: str, other: str, which: int = 0) -> str:
        """The crossing of two lines, or the first or second crossing of a circle; not shown."""
        order = (str(which),) if which else ()
        return self._command("Intersect", (one, other, *order), "i", "point", _UNSEEN)

    def matrix(self, formula: str) -> str:
        """A list of lists."""
        return self._formula(self._label("m"), formula, "list", _UNSEEN)

    def note(self, formula: str, at: complex) -> str:
        """A line of text; `formula` as GeoGebra joins texts and numbers."""
        place = f'<fixed val="true"/><startPoint x="{at.real!r}" y="{at.imag!r}" z="1.0"/>'
        return self._formula(self._label("t"), formula, "text", _BLACK_LINE + place)

    def _label(self, letter: str) -> str:
        self._count += 1
        return f"{letter}_{{{self._count}}}"

    def _point_label(self, name: str) -> str:
        """A point's own name where GeoGebra takes it for a label, primes first: b_{3}' is b'_{3} there."""
        parts = _POINT_NAME.fullmatch(name)
        label = f"{parts[1]}{parts[3]}{parts[2] or ''}" if parts is not None else ""
        if not label or label in self._labels:
            return self._label("P")
        self._labels.add(label)
        return label

    def _formula(self, label: str, formula: str, kind: str, shown: str) -> str:
        self._lines.append(f'<expression label="{label}" exp={quoteattr(formula)} type="{kind}"/>')
        return self._element(label, kind, shown)

    def _command(self, name: str, arguments: tuple[str, ...], letter: str, kind: str, shown: str) -> str:
        label = self._label(letter)
        inputs = " ".join(f"a{k}={quoteattr(text)}" for k, text in enumerate(arguments))
        self._lines.append(f'<command name="{name}"><input {inputs}/><output a0="{label}"/></command>')
        return self._element(label, kind, shown)

    def _element(self, label: str, kind: str, shown: str) -> str:
        self._lines.append(f'<element type="{kind}" label="{label}">{shown}</element>')
        return label


def _seen(caption: str, colour: Colour, *, drawn: bool = True) -> str:
    """The children of an element that is shown with its caption, in GeoGebra's order."""
    red, green, blue = colour
    return (
        f'<show object="{str(drawn).lower()}" label="{str(drawn).lower()}"/>'
        f'<objColor r="{red}" g="{green}" b="{blue}" alpha="0.0"/><layer val="0"/>'
        f'<labelMode val="3"/><caption val={quoteattr(caption)}/>'
    )


def _point(at: complex, name: str, colour: Colour) -> str:
    seen = _seen(name, colour) if name else _UNSEEN
    return f'{seen}<coords x="{at.real!r}" y="{at.imag!r}" z="1.0"/><pointSize val="3"/>'
