"""What a student fills in: rooms to draw in at the scale, empty rows of an equation, tables, boxes for the answers."""

from __future__ import annotations

import cmath
import math

from graphkin.construction import Construction, LayOff, Plane
from graphkin.handouts.document import Room, Rows, Table
from graphkin.handouts.told import Told
from graphkin.quantities import EDGE, Centre, Quantity, Rotation
from graphkin.say.catalogue import say
from graphkin.say.entry import VectorEquation
from graphkin.sheet.formula import formula
from graphkin.sheet.lettering import Label, plain, point_label

_MORE = 1.2
_LEAST = 60.0
_STEP = 10.0
"""Rooms are so many millimetres, or a multiple of it."""
_TERMS = 3


def room(told: Told, plane: Plane) -> Room:
    """The hidden polygon's box and a fifth more, in whole centimetres, so that it tells nothing; p where it belongs."""
    construction = _construction(told, plane)
    names = (construction.pole, *construction.nodes)
    points = told.drawing.plot.points(plane)
    places = [complex(points[name]) / told.scales[plane] for name in names if name in points]
    low = complex(min(at.real for at in places), min(at.imag for at in places))
    high = complex(max(at.real for at in places), max(at.imag for at in places))
    wide, tall = _whole((high - low).real), _whole((high - low).imag)
    middle = (low + high) / 2
    pole = complex(wide / 2 - middle.real, tall / 2 + middle.imag)
    direction, mark = _first_direction(told, construction)
    return Room(wide, tall, _on_grid(pole), point_label(construction.pole), direction, mark)


def _construction(told: Told, plane: Plane) -> Construction:
    return told.drawing.method.velocity if plane == "velocity" else told.drawing.method.acceleration


def _whole(length: float) -> float:
    return max(_LEAST, _STEP * math.ceil(_MORE * length / _STEP))


def _on_grid(place: complex) -> complex:
    """The nearest crossing of the grid's lines."""
    return complex(5 * round(place.real / 5), 5 * round(place.imag / 5))


def _first_direction(told: Told, construction: Construction) -> tuple[float, Label]:
    """The line of the first arrow that is laid off, which is given with the driver [rad, y up]."""
    points = told.drawing.plot.points(construction.plane)
    for step in construction.steps:
        if isinstance(step, LayOff):
            arrow = complex(points[step.term.head] - points[step.term.tail])
            if abs(arrow) > 0:
                turned = cmath.phase(arrow) % math.pi
                return turned, plain(f"{round(math.degrees(turned), 1):g}°")
    return 0.0, plain("0°")


def empty_rows(told: Told, equation: VectorEquation | None = None) -> Rows:
    """Lines to write an equation on: as many terms as it has, or as any may have."""
    lang = told.lang
    heads = tuple(plain(say(key, lang)) for key in ("derivation.direction row", "derivation.size row"))
    columns: list[tuple[Label, Label, Label] | None] = []
    sides = [len(side) for side in equation.sides] if equation is not None else [1, _TERMS - 1]
    if equation is not None and equation.front:
        sides = [1, *sides]
    for k, count in enumerate(sides):
        columns += [(plain("="), (), ())] if k else []
        for n in range(count):
            columns += [(plain("+"), (), ()), None] if n else [None]
    return Rows((heads[0], heads[1]), tuple(columns))


def measured(told: Told, count: int = 5) -> Table:
    """Room for what is read off: a vector, its length on paper, its value."""
    heads = tuple(plain(say(f"handouts.{key}", told.lang)) for key in ("vector", "measured", "value"))
    return Table(heads, tuple(((), (), ()) for _ in range(count)))


def boxes(told: Told) -> Table:
    """A box an answer, with its unit, and one for the sense where it has one."""
    heads = tuple(plain(say(f"handouts.{key}", told.lang)) for key in ("quantity", "answer", "unit", "sense"))
    return Table(heads, tuple(_box(told, quantity) for quantity in told.goal.wanted if quantity is not None))


def _box(told: Told, quantity: Quantity) -> tuple[Label, ...]:
    unit = "" if isinstance(quantity, Centre) else EDGE[quantity.unit].sign
    turns = isinstance(quantity, Rotation) and quantity.word != "theta"
    return formula(told.goal.symbol(quantity)), (), plain(unit), () if turns else plain("—")
