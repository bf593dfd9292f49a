"""A ω = ω1 B and A α = −Ȧ ω + ω1 Ḃ: the equations derived, as matrices of symbols and of numbers.

Source: Sun Huan, Theory of Machines, section 3-3, (3-21) to (3-29). With several drivers B has a column for each.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.geometry import number
from graphkin.base.value import frozen
from graphkin.equations.document import EquationPage
from graphkin.equations.expressions import Sum, Symbol
from graphkin.equations.formulas import ZERO, Grid, Letter, Minus, Node, Num, Op, Row
from graphkin.equations.model import Model
from graphkin.equations.pretty import Pretty
from graphkin.model.mechanism import ROUNDING

_JOINED = 4  # so many unknowns still make one equation that fits a line
A, B, A_RATE, B_RATE, OMEGA, ALPHA, OMEGA_D, ALPHA_D = (
    Letter(symbol, bold=True)
    for symbol in (
        Symbol("A"), Symbol("B"), Symbol("A", dots=1), Symbol("B", dots=1),
        Symbol("ω"), Symbol("α"), Symbol("ω", "d"), Symbol("α", "d"),
    )
)  # fmt: skip

Entries = tuple[tuple[Sum, ...], ...]


@frozen
class System:
    """Equations (each zero) in unknowns and drivers; all matrices by derivation. A is the derivative of the equations
    by the unknowns, B that by the drivers with its sign turned."""

    equations: tuple[Sum, ...]
    unknowns: tuple[Symbol, ...]
    drivers: tuple[Symbol, ...]

    @cached_property
    def a(self) -> Entries:
        return self._slopes(self.unknowns)

    @cached_property
    def b(self) -> Entries:
        return tuple(tuple(-slope for slope in row) for row in self._slopes(self.drivers))

    def _slopes(self, symbols: Sequence[Symbol]) -> Entries:
        """Derivatives; most equations of a large mechanism have few of the unknowns."""
        return tuple(tuple(of.partial(symbol) if symbol in of.symbols else Sum() for symbol in symbols)
                     for of in self.equations)  # fmt: skip

    @property
    def driver_rate(self) -> Symbol | None:
        """The rate of the only driver."""
        return self.drivers[0].rate if len(self.drivers) == 1 else None


def rates_of(entries: Sequence[Sequence[Sum]]) -> Entries:
    """The matrix with the rate of each entry."""
    return tuple(tuple(entry.rate if entry.terms else entry for entry in row) for row in entries)


def grid(pretty: Pretty, entries: Sequence[Sequence[Sum]]) -> Grid:
    """A matrix of sums."""
    return Grid(tuple(tuple(pretty.sum(entry) for entry in row) for row in entries))


def column(symbols: Sequence[Symbol | None]) -> Grid:
    """Symbols one under another; 0 for what keeps its rate."""
    return Grid(tuple((ZERO if symbol is None else Letter(symbol),) for symbol in symbols))


def derivatives(symbols: Sequence[Symbol], order: int) -> list[Symbol | None]:
    """First or second derivatives; None for one that is zero."""
    first = [symbol.rate for symbol in symbols]
    return first if order == 1 else [None if rate is None else rate.rate for rate in first]


def matrices(
    model: Model, page: EquationPage, pretty: Pretty, equations: Sequence[Sum], unknowns: Sequence[Symbol],
    numbers: bool = True,
) -> None:  # fmt: skip
    """Velocity and acceleration in matrices; in numbers at the drawn position, too."""
    moving = dict.fromkeys(symbol for each in equations for symbol in each.moving if symbol not in unknowns)
    drivers = [driver for driver in model.drivers if driver in moving]
    earlier = [symbol for symbol in moving if symbol not in drivers]  # what earlier stages have given
    system = System(tuple(equations), tuple(unknowns), (*drivers, *earlier))
    if len(equations) > len(unknowns):
        page.say("equations.more rows")
    page.head("equations.velocity", 3)
    _velocity(page, pretty, system)
    page.head("equations.acceleration", 3)
    _acceleration(page, pretty, system)
    if not numbers:
        return
    page.say("equations.numbers")
    values = model.values

    def figures(of: Sum) -> Node:
        """Its number; 0 for what is left of terms that cancel."""
        sizes = (abs(number(Sum((replace(term, waves=()),)).at(values))) for term in of.terms)
        return _figures(number(of.at(values)), max(sizes)) if of.terms else ZERO

    for letter, entries in (A, system.a), (B, system.b), (A_RATE, rates_of(system.a)), (B_RATE, rates_of(system.b)):
        if entries and entries[0]:
            page.show((letter, Grid(tuple(tuple(figures(entry) for entry in row) for row in entries))))
    page.say("equations.solution")
    for letter, order in ((OMEGA, 1), (ALPHA, 2)):
        rates = derivatives(system.unknowns, order)
        solution = [0.0 if rate is None else number(values[rate]) for rate in rates]
        solved = Grid(tuple((_figures(value, max(map(abs, solution))),) for value in solution))
        page.show((letter, column(rates), solved))


def _velocity(page: EquationPage, pretty: Pretty, system: System) -> None:
    """(3-23), as the book has it in one line, too, where it fits."""
    rate, unknowns = system.driver_rate, system.unknowns
    a, b = grid(pretty, system.a), grid(pretty, system.b)
    first, second = column(derivatives(unknowns, 1)), column(derivatives(unknowns, 2))
    right: Node = Row((B, OMEGA_D) if rate is None else (Letter(rate), B)) if system.drivers else ZERO
    page.say("equations.as matrices")
    page.show((Row((A, OMEGA)), right))
    if rate is not None and len(unknowns) <= _JOINED:
        page.show((Row((a, first)), Row((Letter(rate), b))))
    page.say("equations.matrix A")
    page.show((A, a))
    if system.drivers:
        page.say("equations.matrix B" if rate is not None else "equations.matrix B many")
        page.show((B, b))
    page.say("equations.columns")
    page.show((OMEGA, first), (ALPHA, second))
    if len(system.drivers) > 1:
        page.say("equations.driver columns")
        page.show((OMEGA_D, column(derivatives(system.drivers, 1))), (ALPHA_D, column(derivatives(system.drivers, 2))))


def _acceleration(page: EquationPage, pretty: Pretty, system: System) -> None:
    """(3-24) −Ȧ ω + ω1 Ḃ + α1 B, with the driver's own acceleration where it has one."""
    page.say_derived(system.equations, again=True)
    right: list[Node] = [Minus(Row((A_RATE, OMEGA)))]
    pushes = [Letter(push) for push in derivatives(system.drivers, 2) if push is not None]
    if system.driver_rate is not None:
        right += [Op("+"), Row((Letter(system.driver_rate), B_RATE))]
        right += [Op("+"), Row((pushes[0], B))] if pushes else []
    elif system.drivers:
        right += [Op("+"), Row((B_RATE, OMEGA_D))]
        right += [Op("+"), Row((B, ALPHA_D))] if pushes else []
    page.show((Row((A, ALPHA)), Row(tuple(right))))
    page.say("equations.derivatives")
    page.show((A_RATE, grid(pretty, rates_of(system.a))))
    if system.drivers:
        page.show((B_RATE, grid(pretty, rates_of(system.b))))


def _figures(value: float, most: float) -> Node:
    """Six digits; 0 for what is nothing beside the others."""
    if abs(value) <= ROUNDING * most or not np.isfinite(value):
        return ZERO if np.isfinite(value) else Num("?")
    mantissa, e, exponent = f"{abs(value):.6g}".partition("e")
    text = Num(f"{mantissa}·10^({int(exponent)})".replace("-", "−") if e else mantissa)
    return Minus(text) if value < 0 else text
