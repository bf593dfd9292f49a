"""Protocol."""

from __future__ import annotations

import cmath
import re
from collections.abc import Iterable, Iterator
from xml.sax.saxutils import quoteattr

from graphkin.base.value import frozen

_SIMPLE = re.compile(r"[\w.{}']+|\w+\([^()]*\)")
"""A number, a label, or a function of one: what needs no brackets."""

_NUMBER = re.compile(r"-?[0-9.]+")


def value(number: float) -> str:
    """A number as GeoGebra reads it, which knows no `1e-05`."""
    text = repr(float(number) + 0.0).removesuffix(".0")
    mantissa, _, power = text.partition("e")
    return f"{mantissa} * 10^({int(power)})" if power else text


def grouped(formula: str) -> str:
    """In brackets, where it is more than one thing."""
    return formula if _SIMPLE.fullmatch(formula) else f"({formula})"


def plus(one: str, other: str) -> str:
    if one == "0" or other == "0":
        return one if other == "0" else other
    return f"{one} + {grouped(other)}"


def minus(one: str, other: str) -> str:
    if other == "0":
        return one
    return f"-{grouped(other)}" if one == "0" else f"{one} - {grouped(other)}"


def product(one: str, other: str) -> str:
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

    x: str
    y: str

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

    @property
    def square(self) -> str:
        """The square of its length."""
        return self.dot(self)

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


NOTHING = FormulaPair("0", "0")


def known(number: complex) -> FormulaPair:
    return FormulaPair(value(number.real), value(number.imag))


def along(angle: str) -> FormulaPair:
    """The unit vector at an angle [rad]."""
    if _NUMBER.fullmatch(angle):
        return known(cmath.rect(1.0, float(angle)))
    return FormulaPair(f"cos({angle})", f"sin({angle})")


def between(tail: str, head: str) -> FormulaPair:
    """From a point to a point, both by label."""
    return FormulaPair(minus(f"x({head})", f"x({tail})"), minus(f"y({head})", f"y({tail})"))


Colour = tuple[int, int, int]
BLACK: Colour = (0, 0, 0)
GREY: Colour = (150, 150, 150)

_SHOWN_AS_CAPTION = 3
_POINT_NAME = re.compile(r"([A-Za-df-hj-w])(_\{\d\w*\})?('*)")
"""Letters that stand for nothing else in a formula (e, i, x, y and z do), as people write them."""


class Protocol:
    """What is written so far. Every method adds one object and gives its label, by which later ones name it."""

    def __init__(self) -> None:
        self._lines: list[str] = []
        self._count = 0
        self._labels: set[str] = set()

    def text(self) -> str:
        """The objects as XML, one element a line."""
        return "\n".join(self._lines)

    def number(self, formula: str) -> str:
        """A number that is only counted with."""
        return self._formula(self._label("q"), formula, "numeric", _unseen())

    def constant(self, name: str, now: float, unit: str) -> str:
        """A number that a reader may change in the list of objects."""
        shown = f'<value val="{now!r}"/>' + "".join(_seen(f"{name} [{unit}]", BLACK, drawn=False))
        return self._element(self._label("g"), "numeric", shown)

    def slider(self, name: str, now: float, least: float, most: float, step: float, at: complex) -> str:
        """A slider, `at` in units of the drawing."""
        bounds = f'<slider min="{least!r}" max="{most!r}" absoluteScreenLocation="false" width="60" ' + (
            f'x="{at.real!r}" y="{at.imag!r}" fixed="true" horizontal="true" showAlgebra="true"/>'
        )
        shown = "".join(_seen(name, BLACK)) + f'<animation step="{step!r}" speed="1" type="0" playing="false"/>'
        return self._element(self._label("d"), "numeric", f'<value val="{now!r}"/>{bounds}{shown}')

    def free_point(self, name: str, at: complex, colour: Colour) -> str:
        """A point that can be dragged."""
        return self._element(self._named(name), "point", _point(at, name, colour))

    def point(self, name: str, formula: str, at: complex, colour: Colour) -> str:
        """A point by a formula. `at`: where it lies now; a point without a name is not shown."""
        return self._formula(self._named(name), formula, "point", _point(at, name, colour))

    def vector(self, name: str, tail: str, head: str, colour: Colour) -> str:
        """An arrow between two points, with its name."""
        width = '<lineStyle thickness="5" type="0" typeHidden="1"/>'
        shown = "".join(_seen(name, colour)) if name else _unseen()
        return self._command("Vector", (tail, head), "u", "vector", shown + width)

    def direction(self, formula: str) -> str:
        """A direction that is not drawn, as a vector from the origin."""
        return self._formula(self._label("w"), formula, "vector", _unseen())

    def line(self, through: str, direction: str, *, across: bool = False) -> str:
        """A thin line through a point along a direction, or at right angles to it."""
        name = "OrthogonalLine" if across else "Line"
        return self._command(name, (through, direction), "h", "line", _thin())

    def circle(self, about: str, radius: str) -> str:
        """A thin circle."""
        return self._command("Circle", (about, radius), "c", "conic", _thin())

    def segment(self, tail: str, head: str) -> str:
        """A side of a link."""
        shown = '<show object="true" label="false"/><objColor r="0" g="0" b="0" alpha="0.0"/>'
        return self._command("Segment", (tail, head), "s", "segment", shown + '<lineStyle thickness="6" type="0"/>')

    def crossing(self, one: str, other: str, which: int = 0) -> str:
        """Where two lines cross, or the first or second crossing of a circle; not shown."""
        order = (str(which),) if which else ()
        return self._command("Intersect", (one, other, *order), "i", "point", _unseen())

    def matrix(self, formula: str) -> str:
        """A list of lists."""
        return self._formula(self._label("m"), formula, "list", _unseen())

    def list_of(self, numbers: Iterable[float]) -> str:
        """Numbers one after the other, to nine digits."""
        return self.matrix("{" + ", ".join(value(float(f"{number:.9g}")) for number in numbers) + "}")

    def note(self, formula: str, at: complex) -> str:
        """A line of text; `formula` as GeoGebra joins texts and numbers."""
        place = f'<startPoint x="{at.real!r}" y="{at.imag!r}" z="1.0"/>'
        shown = '<show object="true" label="false"/><objColor r="0" g="0" b="0" alpha="0.0"/>'
        return self._formula(self._label("t"), formula, "text", shown + '<fixed val="true"/>' + place)

    def _label(self, letter: str) -> str:
        self._count += 1
        return f"{letter}_{{{self._count}}}"

    def _named(self, name: str) -> str:
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

    def _command(self, name: str, given: tuple[str, ...], letter: str, kind: str, shown: str) -> str:
        label = self._label(letter)
        inputs = " ".join(f"a{k}={quoteattr(text)}" for k, text in enumerate(given))
        self._lines.append(f'<command name="{name}"><input {inputs}/><output a0="{label}"/></command>')
        return self._element(label, kind, shown)

    def _element(self, label: str, kind: str, shown: str) -> str:
        self._lines.append(f'<element type="{kind}" label="{label}">{shown}</element>')
        return label


def _seen(caption: str, colour: Colour, *, drawn: bool = True) -> Iterator[str]:
    """The children of an element that is shown with its caption, in GeoGebra's order."""
    red, green, blue = colour
    yield f'<show object="{str(drawn).lower()}" label="{str(drawn).lower()}"/>'
    yield f'<objColor r="{red}" g="{green}" b="{blue}" alpha="0.0"/><layer val="0"/>'
    yield f'<labelMode val="{_SHOWN_AS_CAPTION}"/><caption val={quoteattr(caption)}/>'


def _unseen() -> str:
    return '<show object="false" label="false"/><auxiliary val="true"/>'


def _thin() -> str:
    red, green, blue = GREY
    return (
        f'<show object="true" label="false"/><objColor r="{red}" g="{green}" b="{blue}" alpha="0.0"/>'
        '<auxiliary val="true"/><lineStyle thickness="1" type="10"/>'
    )


def _point(at: complex, name: str, colour: Colour) -> str:
    seen = "".join(_seen(name, colour)) if name else _unseen()
    return f'{seen}<coords x="{at.real!r}" y="{at.imag!r}" z="1.0"/><pointSize val="3"/>'
