"""A datum of a problem as its file states it: symbol, value and unit, and where it lies in the drawing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from math import isclose
from typing import Literal

from graphkin.base.value import frozen
from graphkin.files.values import DIMENSIONS, UNITS
from graphkin.model.mechanism import Dimension, KeyPath, Mechanism
from graphkin.model.units import EDGE, Unit
from graphkin.say import names
from graphkin.say.numbers import MOST_TYPED, given_figure, number, stated_figure
from graphkin.say.reading import Reading


@frozen
class DrawnLength:
    """A length in the drawing, between two places [m], measured in the direction `along`.

    points  of the mechanism from which on it can be drawn
    form    "bar": along a link, on which no other of its points lies between; "radius": from a centre to a rim;
            "measured": in the drawing
    """

    start: complex
    end: complex
    along: complex
    points: tuple[str, ...] = ()
    form: Literal["bar", "apart", "radius", "measured"] = "apart"


@frozen
class DrawnAngle:
    """An angle in the drawing: at a place [m], from a direction on, counter-clockwise where positive [rad]."""

    at: complex
    start: complex
    turn: float
    points: tuple[str, ...] = ()


@frozen
class Size:
    """A symbol with its value in a unit: `r2 = 20 mm`.

    written  the value as the file has it, where it states it
    worked   the value in the unit of the solution, where the file has another: ` = 50.8 mm`
    shape    where it lies in the drawing
    derived  it follows from data of the file, which does not state it
    moved    another value than the one told is drawn: its symbol alone stands there
    since    the point from which a guide's distance, or a displacement, is measured
    """

    symbol: str
    value: float
    unit: str
    written: str = ""
    worked: str = ""
    shape: DrawnLength | DrawnAngle | None = None
    derived: bool = False
    moved: bool = False
    since: str = ""

    @property
    def figure(self) -> str:
        if self.moved:
            return self.symbol
        return self.written or _with_unit(given_figure(self.value), self.unit)

    @property
    def ends(self) -> tuple[complex, ...]:
        """The places of a length between two points [m]."""
        shape = self.shape
        return (shape.start, shape.end) if isinstance(shape, DrawnLength) and len(shape.points) > 1 else ()

    @property
    def text(self) -> str:
        return self.symbol if self.moved else f"{self.symbol} = {self.figure}"

    @property
    def bare(self) -> Size:
        """Without its sign, where words or arrows tell its sense."""
        written, worked = (text.replace("−", "") for text in (self.written, self.worked))
        return replace(self, value=abs(self.value), written=written, worked=worked)

    @property
    def whole(self) -> str:
        """With the value in the unit of the solution."""
        return self.text + self.worked


_UNITS: Mapping[Dimension, str] = {
    "length": "mm", "angle": "°", "velocity": "m/s", "acceleration": "m/s²",
    "angular velocity": "rad/s", "angular acceleration": "rad/s²",
}  # fmt: skip
"""The units of the solution."""
_TURNS = {"r/min": "/60", "rev/min": "/60", "rev/s": ""}
_PRINTED = {"deg": "°", "rpm": "r/min", "rpm/s": "r/min/s"}


def in_words(reading: Reading, size: Size) -> str:
    """A datum that no dimension line tells; of a guide's distance from which point it is, of a displacement between
    which two."""
    if size.since not in reading.mechanism.points:
        return size.text
    words = {"datum": size.text, "point": names.point(size.since)}
    if isinstance(size.shape, DrawnLength) and len(size.shape.points) == 1:  # of a slide, which has one there
        return reading.say("sheet.stretch", end=names.point(size.shape.points[-1]), **words)
    return reading.say("sheet.since", **words)


def sized(
    reading: Reading, symbol: str, value: float, dimension: Dimension, *places: KeyPath,
    shape: DrawnLength | DrawnAngle | None = None,
) -> Size:  # fmt: skip
    """A value [SI] as the file states it at one of these places, or in the unit that the file uses."""
    unit, given = _UNITS[dimension], reading.mechanism.given
    there = (given[place] for place in places if place in given)
    value = 0.0 if dimension == "length" and abs(value) <= reading.noise else value
    size = Size(symbol, in_unit(value, unit, dimension), unit, shape=shape)
    stated = next((one for one in there if one.si is not None and isclose(abs(one.si), abs(value), rel_tol=1e-9)), None)
    if stated is None:
        used = length_unit(reading.mechanism) if dimension == "length" else unit
        own = f"{given_figure(in_unit(value, used, dimension))} {used}"
        return size if used == unit else replace(size, written=own, worked=_worked(size, used))
    figure, other = _split(stated.written) if isinstance(stated.written, str) else ("", unit)
    if (printed := _PRINTED.get(other, other)) == unit:
        return replace(size, written=_with_unit(stated_figure(size.value), unit))
    if sum(letter.isdigit() for letter in figure) > MOST_TYPED:
        figure = stated_figure(in_unit(abs(value), other, dimension))
    sign = "−" if value < 0 else ""
    size = replace(size, written=f"{sign}{figure.lstrip('+-')} {printed}", worked=_worked(size, printed))
    if printed in _TURNS:  # n1 = 60 r/min, and ω1 = 2πn1/60 of it
        turns = "n" + symbol.removeprefix("ω")
        comma = reading.say("common.and")
        size = replace(size, symbol=turns, worked=f"{comma}{symbol} = 2π{turns}{_TURNS[printed]}{size.worked}")
    return size


def _with_unit(figure: str, unit: str) -> str:
    return f"{figure}{'' if unit == '°' else ' '}{unit}"


def _worked(size: Size, stated: str) -> str:
    """The value once more in the unit of the solution, which calculates in metres and gives lengths in mm."""
    return "" if stated == "m" else f" = {size.figure}"


def _split(text: str) -> tuple[str, str]:
    """The figure of a stated value, and its unit."""
    text = text.strip().replace("^2", "²")
    figure = text.rstrip("abcdefghijklmnopqrstuvwxyz/²° ")
    return figure, text[len(figure) :].replace(" ", "")


def in_unit(value: float, unit: str, dimension: Dimension) -> float:
    """A value [SI] in a unit."""
    times, divided = UNITS[dimension][unit]
    return value * divided / times


def in_files_unit(mechanism: Mechanism, value: float, unit: str) -> str:
    """`48.58 in/s`: a value [SI] in the unit of the file; "" in a file in mm or m, and of what has no length in it."""
    own = files_unit(mechanism, unit)
    return "" if own is EDGE[unit] else f"{number(value * own.factor)} {own.sign}"


def files_unit(mechanism: Mechanism, unit: str) -> Unit:
    """The unit that values in this SI unit are shown in, by the file's unit of length where that is not mm or m."""
    dimension, length, edge = DIMENSIONS.get(unit, "angle"), length_unit(mechanism), EDGE[unit]
    if length in ("mm", "m") or dimension not in ("length", "velocity", "acceleration"):
        return edge
    name, own = (length + each.lstrip("m") for each in (edge.name, edge.sign))
    return Unit(name, own, in_unit(1.0, own, dimension))


def length_unit(mechanism: Mechanism) -> str:
    """The unit in which the file states most of its lengths."""
    stated = [each for each in mechanism.given.values() if each.dimension == "length" and each.si]
    lengths = (each.written for each in stated if each.path[0] != "sketch")
    units = Counter(_split(text)[1] if isinstance(text, str) else "mm" for text in lengths)
    return next((unit for unit, _ in units.most_common(1)), "mm")
