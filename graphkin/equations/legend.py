"""The legend in the making: every letter once, what it stands for, and how its value is read off a motion."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Literal

from graphkin.analytic import Motion
from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.equations.symbols import AngleSum, Kind, Symbol
from graphkin.say.catalogue import Meaning

Unit = Literal["mm", "deg", "rad/s", "rad/s^2", "m/s", "m/s^2", "mm rad", "1"]
Reader = Callable[[Motion], Value]


@frozen
class LegendEntry:
    """A line of the legend: what a symbol is, the unit it is written in, and its value in SI at a motion."""

    meaning: Meaning
    unit: Unit
    read: Reader


@dataclass
class Legend:
    """All symbols with their entries, in the order they came up.

    alias   how angles fixed to one another are called: θ2 = θ3 + γ
    """

    entries: dict[Symbol, LegendEntry] = field(default_factory=dict)
    alias: dict[Symbol, AngleSum] = field(default_factory=dict)
    _taken: set[tuple[str, str, int]] = field(default_factory=set)

    def fresh(self, letter: str, low: str, kind: Kind = "constant", steady: bool = False) -> Symbol:
        """A symbol nothing else bears: primes of a name are primes of the letter, and more are added where taken."""
        bare = low.rstrip("'")
        symbol = Symbol(letter, bare, len(low) - len(bare), 0, kind, steady)
        while any(self._key(each) in self._taken for each in _family(symbol)):
            symbol = replace(symbol, primes=symbol.primes + 1)
        self._taken.update(self._key(each) for each in _family(symbol))
        return symbol

    @staticmethod
    def _key(symbol: Symbol) -> tuple[str, str, int]:
        return symbol.letter + "." * symbol.dots, symbol.low, symbol.primes

    def constant(self, letter: str, low: str, meaning: Meaning, unit: Unit, value: float) -> Symbol:
        """A dimension, whatever the position [m, rad]."""
        symbol = self.fresh(letter, low)
        self.entries[symbol] = LegendEntry(meaning, unit, lambda motion: value)
        return symbol

    def variable(
        self, symbol: Symbol, meanings: tuple[Meaning, ...], units: tuple[Unit, Unit, Unit],
        readers: tuple[Reader, Reader, Reader],
    ) -> Symbol:  # fmt: skip
        """A symbol that moves, with its rates."""
        for each, meaning, unit, read in zip(_family(symbol), meanings, units, readers, strict=False):
            self.entries[each] = LegendEntry(meaning, unit, read)
        return symbol


def _family(symbol: Symbol) -> tuple[Symbol, ...]:
    """The symbol, its rate, and the rate of that."""
    found = [symbol]
    while found[-1].kind != "push" and (rate := found[-1].rate) is not None:
        found.append(rate)
    return tuple(found)


def values(ledger: Legend, motion: Motion) -> dict[Symbol, Value]:
    """Every symbol's value at a motion, in SI units: scalars, or arrays over positions."""
    return {symbol: entry.read(motion) for symbol, entry in ledger.entries.items()}
