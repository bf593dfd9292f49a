"""The letters of the formulas, and the angles made of them.

A symbol is a letter with a subscript: l3, l3', s_E, θ3, γ. Its rate is another symbol: θ3, ω3, α3 and s, ṡ, s̈.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Literal

from graphkin.base.value import frozen

Kind = Literal["constant", "angle", "displacement", "rate", "push"]
_RANKS: dict[Kind, int] = {"constant": 0, "displacement": 1, "angle": 2, "rate": 3, "push": 4}


@frozen
class Symbol:
    """One letter of the formulas.

    low     subscript without its primes: a link, a point
    dots    time derivatives written over the letter (ṡ, s̈); ω and α have letters of their own
    kind    what it is; a "push" is a second derivative
    steady  its second derivative is zero: a driver at constant speed
    """

    letter: str
    low: str = ""
    primes: int = 0
    dots: int = 0
    kind: Kind = "constant"
    steady: bool = False

    @property
    def rate(self) -> Symbol | None:
        """Its time derivative: None where that is zero."""
        if self.kind == "constant" or (self.kind == "rate" and self.steady):
            return None
        if self.kind == "push":
            raise ValueError("third derivatives have no letters")
        kind: Kind = "rate" if self.kind in ("angle", "displacement") else "push"
        if self.letter in _ANGULAR:
            return replace(self, letter=_ANGULAR[self.letter], kind=kind)
        return replace(self, dots=self.dots + 1, kind=kind)

    @property
    def moves(self) -> bool:
        return self.kind != "constant"

    @property
    def order(self) -> tuple[int, str, int, str, int, int]:
        """Where it stands in a product: dimensions, displacements, rates."""
        return _RANKS[self.kind], self.letter, len(self.low), self.low, self.primes, self.dots


_ANGULAR = {"θ": "ω", "φ": "ω", "ω": "α"}


@frozen
class AngleSum:
    """A sum of angles, θ1 − θ3 + γ + 90°: symbols with whole coefficients in their order, and quarter turns."""

    parts: tuple[tuple[Symbol, int], ...] = ()
    quarters: int = 0

    @classmethod
    def of(cls, symbol: Symbol, quarters: int = 0) -> AngleSum:
        return cls(((symbol, 1),), quarters)

    @classmethod
    def sum_of(cls, parts: Iterable[tuple[Symbol, int]], quarters: int) -> AngleSum:
        """Like symbols together, in their order; whole turns left out."""
        found: dict[Symbol, int] = {}
        for symbol, count in parts:
            found[symbol] = found.get(symbol, 0) + count
        kept = sorted(((s, n) for s, n in found.items() if n), key=lambda part: (not part[0].moves, part[0].order))
        return cls(tuple(kept), quarters % 4)

    def __add__(self, other: AngleSum) -> AngleSum:
        return AngleSum.sum_of((*self.parts, *other.parts), self.quarters + other.quarters)

    def __neg__(self) -> AngleSum:
        return AngleSum.sum_of(((s, -n) for s, n in self.parts), -self.quarters)

    def __sub__(self, other: AngleSum) -> AngleSum:
        return self + -other

    def turned(self, quarters: int) -> AngleSum:
        return AngleSum.sum_of(self.parts, self.quarters + quarters)

    @property
    def symbols(self) -> Mapping[Symbol, int]:
        return dict(self.parts)

    @property
    def moving(self) -> tuple[tuple[Symbol, int], ...]:
        """The symbols that change with time."""
        return tuple(part for part in self.parts if part[0].moves)

    def has(self, symbol: Symbol) -> bool:
        return any(symbol == part for part, _ in self.parts)


NO_ANGLE = AngleSum()
