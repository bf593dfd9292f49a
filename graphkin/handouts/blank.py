"""What a student fills in: rooms to draw in at the scale, empty rows of an equation, tables, boxes for the answers."""

from __future__ import annotations

import cmath
import hashlib
import math
from collections.abc import Iterator

from graphkin.construction import Construction, LayOff, Plane
from graphkin.handouts.document import GridRoom, HandoutTable, TermRows
from graphkin.handouts.told import HandoutProblem
from graphkin.model.quantities import EDGE, Centre, Quantity, Rotation
from graphkin.say.catalogue import say
from graphkin.say.entry import VectorEquation
from graphkin.sheet.lettering import Label, formula, plain, point_label
from graphkin.sheet.window import corners

ROOM = complex(160.0, 120.0)
"""Of any polygon that is drawn as large as a handout draws it [mm]."""
_MORE = 1.2
_EDGE, _GRID = 4.0, 5.0
"""What the polygon keeps from the edge; the pole stands on a line of the grid [mm]."""
_STEP = 10.0
"""Rooms are so many millimetres, or a multiple of it."""
_EQUATIONS, _TERMS = 3, {"velocity": 3, "acceleration": 5}


def room(told: HandoutProblem, plane: Plane) -> GridRoom:
    """The same room for every problem, with the pole somewhere, by lot, from where its polygon has room: neither tells
    anything of the polygon. Where a scale of the file's own makes that larger, the box of the polygon and a fifth more.
    """
    construction = _construction(told, plane)
    low, high = corners(_places(told, construction))
    wide, tall = _whole((high - low).real, ROOM.real), _whole((high - low).imag, ROOM.imag)
    right, up = _lots(told.drawing.mechanism.text + plane)
    pole = complex(_stood(low.real, high.real, wide, right), tall - _stood(low.imag, high.imag, tall, up))
    direction, mark = _first_direction(told, construction)
    return GridRoom(wide, tall, pole, point_label(construction.pole), direction, mark)


def _places(told: HandoutProblem, construction: Construction) -> list[complex]:
    """The corners of a polygon from its pole, on paper [mm, y up]."""
    points = told.drawing.plot.points(construction.plane)
    names = (construction.pole, *construction.nodes)
    return [complex(points[name]) / told.scales[construction.plane] for name in names if name in points]


def _lots(text: str) -> tuple[float, float]:
    """Two numbers from 0 to 1 that hang on the text of the problem alone."""
    digest = hashlib.sha256(text.encode()).digest()
    return digest[0] / 255, digest[1] / 255


def _stood(low: float, high: float, room: float, lot: float) -> float:
    """Where in a room the pole may stand so that what reaches from low to high about it keeps off the edge."""
    first, last = _EDGE - low, room - _EDGE - high
    least, most = math.ceil(first / _GRID), math.floor(last / _GRID)
    return _GRID * (least + round(lot * (most - least)))


def _construction(told: HandoutProblem, plane: Plane) -> Construction:
    return told.drawing.method.velocity if plane == "velocity" else told.drawing.method.acceleration


def _whole(length: float, usual: float) -> float:
    return max(usual, _STEP * math.ceil(_MORE * length / _STEP))


def _first_direction(told: HandoutProblem, construction: Construction) -> tuple[float, Label]:
    """The line of the first arrow that is laid off, which is given with the driver [rad, y up]."""
    points = told.drawing.plot.points(construction.plane)
    for step in construction.steps:
        if isinstance(step, LayOff):
            arrow = complex(points[step.term.head] - points[step.term.tail])
            if abs(arrow) > 0:
                turned = cmath.phase(arrow) % math.pi
                return turned, plain(f"{round(math.degrees(turned), 1):g}°")
    return 0.0, plain("0°")


def equations(told: HandoutProblem, plane: Plane) -> Iterator[TermRows]:
    """Lines for as many equations as a polygon takes, three at most, each with as many terms as its plane may have."""
    construction = _construction(told, plane)
    for _ in construction.equations[:_EQUATIONS]:
        yield empty_rows(told, terms=_TERMS[plane])


def empty_rows(told: HandoutProblem, equation: VectorEquation | None = None, terms: int = 3) -> TermRows:
    """Lines to write an equation on: as many terms as it has, or as any may have."""
    lang = told.lang
    heads = tuple(plain(say(key, lang)) for key in ("derivation.direction row", "derivation.size row"))
    columns: list[tuple[Label, Label, Label] | None] = []
    sides = [len(side) for side in equation.sides] if equation is not None else [1, terms - 1]
    if equation is not None and equation.front:
        sides = [1, *sides]
    for k, count in enumerate(sides):
        columns += [(plain("="), (), ())] if k else []
        for n in range(count):
            columns += [(plain("+"), (), ()), None] if n else [None]
    return TermRows((heads[0], heads[1]), tuple(columns))


def measured(told: HandoutProblem, count: int = 3) -> HandoutTable:
    """Room for what is read off: a vector, its length on paper, its value; twice beside each other."""
    heads = tuple(plain(say(f"handouts.{key}", told.lang)) for key in ("vector", "measured", "value"))
    return HandoutTable(heads * 2, (((),) * 6,) * count)


def boxes(told: HandoutProblem) -> HandoutTable:
    """A box an answer, with its unit, and one for the sense where it has one."""
    heads = tuple(plain(say(f"handouts.{key}", told.lang)) for key in ("quantity", "answer", "unit", "sense"))
    return HandoutTable(heads, tuple(_box(told, quantity) for quantity in told.goal.wanted if quantity is not None))


def _box(told: HandoutProblem, quantity: Quantity) -> tuple[Label, ...]:
    unit = "" if isinstance(quantity, Centre) else EDGE[quantity.unit].sign
    turns = isinstance(quantity, Rotation) and quantity.word != "theta"
    return formula(told.goal.symbol(quantity)), (), plain(unit), () if turns else plain("—")
