"""A ω = ω1 B and A α = −Ȧ ω + ω1 Ḃ: the equations derived, as matrices of symbols and of numbers.

Source: Sun Huan, Theory of Machines, section 3-3, (3-21) to (3-29). With several drivers B has a column for each.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.value import frozen
from graphkin.equations.driven import say_derived
from graphkin.equations.expressions import Sum
from graphkin.equations.layout import Grid, Letter, Minus, Node, Num, Op, Row
from graphkin.equations.model import Model
from graphkin.equations.page import EquationPage
from graphkin.equations.pretty import ZERO, Pretty
from graphkin.equations.symbols import Symbol
from graphkin.model.mechanism import ROUNDING

_JOINED = 4
"""So many unknowns still make one equation that fits a line."""
_DIGITS = 6
A, B = Symbol("A"), Symbol("B")
A_RATE, B_RATE = Symbol("A", dots=1), Symbol("B", dots=1)
OMEGA, ALPHA = Symbol("ω"), Symbol("α")
OMEGA_D, ALPHA_D = Symbol("ω", "d"), Symbol("α", "d")

Entries = tuple[tuple[Sum, ...], ...]


@frozen
class System:
    """Equations (each zero) in unknowns and drivers; all matrices by derivation.

    A is the derivative of the equations by the unknowns, B that by the drivers with its sign turned.
    """

    equations: tuple[Sum, ...]
    unknowns: tuple[Symbol, ...]
    drivers: tuple[Symbol, ...]

    @cached_property
    def a(self) -> Entries:
        return tuple(tuple(_slope(each, unknown) for unknown in self.unknowns) for each in self.equations)

    @cached_property
    def b(self) -> Entries:
        return tuple(tuple(-_slope(each, driver) for driver in self.drivers) for each in self.equations)

    @staticmethod
    def rate(of: Entries) -> Entries:
        return tuple(tuple(entry.rate if entry.terms else entry for entry in row) for row in of)


def _slope(of: Sum, symbol: Symbol) -> Sum:
    """Most equations of a large mechanism have few of the unknowns."""
    return of.partial(symbol) if symbol in of.symbols else Sum()


def matrices(
    model: Model,
    page: EquationPage,
    pretty: Pretty,
    equations: Sequence[Sum],
    unknowns: Sequence[Symbol],
    numbers: bool = True,
) -> None:
    """Velocity and acceleration in matrices; in numbers at the drawn position, too."""
    known = _moving(equations, unknowns, model)
    system = System(tuple(equations), tuple(unknowns), known)
    writer = _MatrixWriter(model, page, pretty, system)
    if len(equations) > len(unknowns):
        page.say("equations.more rows")
    page.head("equations.velocity", 3)
    writer.velocity()
    page.head("equations.acceleration", 3)
    writer.acceleration()
    if numbers:
        page.say("equations.numbers")
        writer.numbers()


def _moving(equations: Sequence[Sum], unknowns: Sequence[Symbol], model: Model) -> tuple[Symbol, ...]:
    """What else moves in the equations: the drivers in their order, then what earlier stages have given."""
    found = dict.fromkeys(symbol for each in equations for symbol in each.moving if symbol not in unknowns)
    first = [driver for driver in model.drivers if driver in found]
    return (*first, *(symbol for symbol in found if symbol not in first))


@frozen
class _MatrixWriter:
    model: Model
    page: EquationPage
    pretty: Pretty
    system: System

    def grid(self, entries: Entries) -> Grid:
        return Grid(tuple(tuple(self.pretty.sum(entry) for entry in row) for row in entries))

    def column(self, symbols: Sequence[Symbol], order: int) -> Grid:
        """The rates of symbols, one under another; 0 for what keeps its rate."""
        return Grid(tuple((ZERO if rate is None else Letter(rate),) for rate in _rates(symbols, order)))

    @property
    def one(self) -> Symbol | None:
        """The rate of the only driver."""
        return self.system.drivers[0].rate if len(self.system.drivers) == 1 else None

    def velocity(self) -> None:
        """(3-23)."""
        page, system = self.page, self.system
        name = Letter(A, bold=True), Letter(OMEGA, bold=True), Letter(B, bold=True)
        if not system.drivers:
            right: Node = ZERO
        elif self.one is not None:
            right = Row((Letter(self.one), name[2]))
        else:
            right = Row((name[2], Letter(OMEGA_D, bold=True)))
        page.say("equations.as matrices")
        page.show((Row((name[0], name[1])), right))
        self._joined(right)
        page.say("equations.matrix A")
        page.show((name[0], self.grid(system.a)))
        if system.drivers:
            page.say("equations.matrix B" if self.one is not None else "equations.matrix B many")
            page.show((name[2], self.grid(system.b)))
        page.say("equations.columns")
        page.show((name[1], self.column(system.unknowns, 1)), (Letter(ALPHA, True), self.column(system.unknowns, 2)))
        if len(system.drivers) > 1:
            page.say("equations.driver columns")
            page.show((Letter(OMEGA_D, bold=True), self.column(system.drivers, 1)),
                      (Letter(ALPHA_D, bold=True), self.column(system.drivers, 2)))  # fmt: skip

    def _joined(self, right: Node) -> None:
        """The whole equation in one line, as the book has it, where it fits."""
        system = self.system
        if self.one is None or len(system.unknowns) > _JOINED or not isinstance(right, Row):
            return
        left = Row((self.grid(system.a), self.column(system.unknowns, 1)))
        self.page.show((left, Row((right.items[0], self.grid(system.b)))))

    def acceleration(self) -> None:
        """(3-24), with the driver's own acceleration where it has one."""
        page, system = self.page, self.system
        say_derived(page, system.equations, again=True)
        page.show((Row((Letter(A, True), Letter(ALPHA, True))), Row(tuple(self._right()))))
        page.say("equations.derivatives")
        page.show((Letter(A_RATE, True), self.grid(system.rate(system.a))))
        if system.drivers:
            page.show((Letter(B_RATE, True), self.grid(system.rate(system.b))))

    def _right(self) -> list[Node]:
        """−Ȧ ω + ω1 Ḃ + α1 B."""
        items: list[Node] = [Minus(Row((Letter(A_RATE, True), Letter(OMEGA, True))))]
        pushes = [push for push in _rates(self.system.drivers, 2) if push is not None]
        if self.one is not None:
            items += [Op("+"), Row((Letter(self.one), Letter(B_RATE, True)))]
            items += [Op("+"), Row((Letter(pushes[0]), Letter(B, True)))] if pushes else []
        elif self.system.drivers:
            items += [Op("+"), Row((Letter(B_RATE, True), Letter(OMEGA_D, True)))]
            items += [Op("+"), Row((Letter(B, True), Letter(ALPHA_D, True)))] if pushes else []
        return items

    def numbers(self) -> None:
        """The same matrices with numbers, and the columns solved."""
        system, page = self.system, self.page
        sums = [(A, system.a), (B, system.b), (A_RATE, system.rate(system.a)), (B_RATE, system.rate(system.b))]
        for symbol, entries in sums:
            if entries and entries[0]:
                page.show((Letter(symbol, True), self._numbers(entries)))
        page.say("equations.solution")
        rows = []
        for symbol, order in ((OMEGA, 1), (ALPHA, 2)):
            values = [0.0 if rate is None else float(self._values[rate]) for rate in _rates(system.unknowns, order)]
            solved = Grid(tuple((written(value, max(map(abs, values))),) for value in values))
            rows.append((Letter(symbol, True), self.column(system.unknowns, order), solved))
        for row in rows:
            page.show(row)

    @cached_property
    def _values(self) -> dict[Symbol, float]:
        return self.model.values

    def _numbers(self, entries: Entries) -> Grid:
        return Grid(tuple(tuple(self._number(entry) for entry in row) for row in entries))

    def _number(self, of: Sum) -> Node:
        """A sum in figures; what is left of terms that cancel is 0."""
        if not of.terms:
            return ZERO
        plain = Sum(tuple(replace(term, waves=()) for term in of.terms))
        most = max((abs(float(Sum((term,)).at(self._values))) for term in plain.terms), default=0.0)
        return written(float(of.at(self._values)), most)


def written(value: float, most: float) -> Node:
    """Six digits; what is nothing beside the others is 0."""
    if abs(value) <= ROUNDING * most or not np.isfinite(value):
        return ZERO if np.isfinite(value) else Num("?")
    text = f"{abs(value):.{_DIGITS}g}"
    mantissa, e, exponent = text.partition("e")
    if e:
        number: Node = Num(f"{mantissa}·10^({int(exponent)})".replace("-", "−"))
    else:
        number = Num(mantissa)
    return Minus(number) if value < 0 else number


def _rates(symbols: Sequence[Symbol], order: int) -> list[Symbol | None]:
    first = [symbol.rate for symbol in symbols]
    return first if order == 1 else [None if rate is None else rate.rate for rate in first]
