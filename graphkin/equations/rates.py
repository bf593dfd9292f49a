"""Velocities and accelerations of a polygon's unknowns as quotients: (3-13), (3-14), (3-16), (3-17) for every dyad."""

from __future__ import annotations

from graphkin.base.value import frozen
from graphkin.equations.dyads import Split, single, unit
from graphkin.equations.expressions import Sum, SymbolProduct, cross, dot, number
from graphkin.equations.symbols import Symbol


@frozen
class RateQuotient:
    """symbol = top / bottom."""

    symbol: Symbol
    top: Sum
    bottom: Sum


def quotients(split: Split, order: int) -> tuple[RateQuotient, ...]:
    """The first (order 1) or second (2) derivatives of the unknowns, angles before displacements.

    The polygon derived is linear in them: c1 x1 + c2 x2 + rest = 0 with plane vectors c. Multiplied crosswise by c2
    it gives x1. A displacement beside an angle found already is projected on its own line.
    """
    derived = split.sum.rate if order == 1 else split.sum.rate.rate
    wanted = {symbol: _derivative(symbol, order) for symbol in (*split.angles, *split.slides)}
    rest = Sum(tuple(term for term in derived.terms if not any(term.has(found) for found in wanted.values())))
    columns = {symbol: split.sum.partial(symbol) for symbol in wanted}
    found: list[RateQuotient] = []
    for symbol in (*reversed(split.angles), *split.slides):
        others = [other for other in wanted if other != symbol]
        if symbol in split.slides and split.angles:
            found.append(_along(split, symbol, derived, wanted[symbol]))
        elif not others:
            found.append(_alone(columns[symbol], rest, wanted[symbol]))
        else:
            across = _direction(columns[others[0]])
            found.append(_signed(wanted[symbol], -cross(across, rest), cross(across, columns[symbol])))
    return tuple(found)


def _derivative(symbol: Symbol, order: int) -> Symbol:
    first = symbol.rate
    second = first if first is None or order == 1 else first.rate
    assert second is not None
    return second


def _direction(column: Sum) -> Sum:
    """A vector of the same direction, of length 1 where it is one arrow."""
    term = single(column)
    return column if term is None else unit(term)


def _along(split: Split, slide: Symbol, derived: Sum, wanted: Symbol) -> RateQuotient:
    """The displacement's rate by projection on its line, the angle's rate known."""
    term = split.slid(slide)
    others = Sum(tuple(part for part in derived.terms if not part.has(wanted)))
    return _signed(wanted, -dot(unit(term), others), Sum((SymbolProduct(term.factor),)))


def _alone(column: Sum, rest: Sum, wanted: Symbol) -> RateQuotient:
    """The only unknown of a polygon."""
    across = _direction(column)
    return _signed(wanted, -dot(across, rest), dot(across, column))


def _signed(symbol: Symbol, top: Sum, bottom: Sum) -> RateQuotient:
    """Factors of bare numbers put into the top."""
    term = single(bottom)
    if term is not None and not term.symbols and not term.waves:
        return RateQuotient(symbol, top.times(1 / term.factor), number(1.0))
    if bottom.terms and bottom.terms[0].factor < 0:
        return RateQuotient(symbol, -top, -bottom)
    return RateQuotient(symbol, top, bottom)
