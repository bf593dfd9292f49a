"""The matrix method written out: all polygons in one system, solved for all unknown rates at once."""

from __future__ import annotations

import numpy as np

from graphkin.equations.chains import PointChain, asked_points, chain, vectors
from graphkin.equations.complex_method import complex_sides, ring
from graphkin.equations.driven import listed
from graphkin.equations.expressions import Sum
from graphkin.equations.layout import Grid, Letter, Node, Op, Row
from graphkin.equations.legend import LegendEntry, Reader
from graphkin.equations.matrices import matrices
from graphkin.equations.model import Model
from graphkin.equations.page import EquationPage
from graphkin.equations.pretty import ZERO, Pretty
from graphkin.equations.symbols import Symbol
from graphkin.say.catalogue import meaning


def write_matrix(model: Model, page: EquationPage) -> None:
    """The polygons in complex form, their components with the unknowns left, the matrices, the points asked for."""
    pretty = Pretty(model.alias)
    if not model.unknowns:
        _points(model, page, pretty)
        return
    page.head("equations.position", 3)
    page.say("equations.unknown", unknowns=listed(model.unknowns))
    for number, polygon in enumerate((p for task in model.tasks for p in task.polygons), start=1):
        page.head("equations.polygon", 3, number=number, names=ring(model, polygon))
        page.show(complex_sides(pretty, polygon, polygon.sum))
    page.say("equations.all unknowns")
    equations = [each for task in model.tasks for each in task.equations]
    page.show(*(_unknown_left(pretty, each, model.unknowns) for each in equations))
    _differentiated(page, pretty, equations, model.unknowns)
    matrices(model, page, pretty, equations, model.unknowns)
    _points(model, page, pretty)


def _unknown_left(pretty: Pretty, of: Sum, unknowns: tuple[Symbol, ...]) -> tuple[Node, Node]:
    left = of.having(*unknowns)
    return pretty.sum(left), pretty.sum(left - of)


def _differentiated(page: EquationPage, pretty: Pretty, equations: list[Sum], unknowns: tuple[Symbol, ...]) -> None:
    """(3-22): unknown rates left."""
    rates = tuple(symbol.rate for symbol in unknowns if symbol.rate is not None)
    page.say("equations.derived")
    page.show(*(_unknown_left(pretty, each.rate, rates) for each in equations))


def _points(model: Model, page: EquationPage, pretty: Pretty) -> None:
    points = asked_points(model)
    for number, point in enumerate(points, start=1):
        found = chain(model, point, "" if len(points) == 1 else str(number))
        page.head("equations.point", name=point)
        page.say("equations.point from", start=model.bodies.spot(found.start), name=point)
        _point(model, page, pretty, found)


def _point(model: Model, page: EquationPage, pretty: Pretty, found: PointChain) -> None:
    """(3-25) to (3-27)."""
    whole = vectors(model, found)
    letters = [_components(model, symbol, axes) for symbol, axes in zip(whole, _AXES, strict=True)]
    for symbol in whole:  # the vectors are written by their components here
        del model.ledger.entries[symbol]
    parts = found.sum.real, found.sum.imag
    moving = found.sum.moving
    page.show(*((Letter(letter), pretty.sum(part)) for letter, part in zip(letters[0], parts, strict=True)))
    slope = [[part.partial(symbol) for symbol in moving] for part in parts]
    first = [symbol.rate for symbol in moving]
    second = [None if rate is None else rate.rate for rate in first]
    matrix = _grid(pretty, slope)
    page.show((_column(letters[1]), Row((matrix, _column(first)))))
    bent = _grid(pretty, [[entry.rate for entry in row] for row in slope])
    page.show((_column(letters[2]), Row((matrix, _column(second), Op("+"), bent, _column(first)))))


_AXES = ("", "v", "a")


def _components(model: Model, symbol: Symbol, axis: str) -> tuple[Symbol, Symbol]:
    """x_E, y_E; v_Ex, v_Ey; a_Ex, a_Ey."""
    entry, found = model.ledger.entries[symbol], []
    for name, turn in (("x", 1.0), ("y", -1j)):
        letter, low = (axis, f"{symbol.low}{name}") if axis else (name, symbol.low)
        made = model.ledger.fresh(letter, low + "'" * symbol.primes)
        what = meaning("equations.component", of=entry.meaning, axis=name)
        model.ledger.entries[made] = LegendEntry(what, entry.unit, _turned(entry.read, turn))
        found.append(made)
    return found[0], found[1]


def _turned(read: Reader, turn: complex) -> Reader:
    """One component of a vector: the real part once it is turned."""
    return lambda motion: np.real(read(motion) * turn)


def _grid(pretty: Pretty, entries: list[list[Sum]]) -> Grid:
    return Grid(tuple(tuple(pretty.sum(entry) for entry in row) for row in entries))


def _column(symbols: tuple[Symbol, ...] | list[Symbol] | list[Symbol | None]) -> Grid:
    return Grid(tuple((ZERO if symbol is None else Letter(symbol),) for symbol in symbols))
