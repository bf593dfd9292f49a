"""Symbols, sums of angles, and sums of products with cos, sin or e^i of them: all that loop equations are made of.

A symbol is a letter with a subscript: l3, l3', s_E, θ3, γ. Its rate is another symbol: θ3, ω3, α3 and s, ṡ, s̈. Sums
are a small closed set of values with the few operations kinematics needs: add, multiply, conjugate, real and imaginary
part, derive, evaluate. It is no computer algebra: nothing is simplified but like terms and quarter turns.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cached_property
from typing import Literal

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen

Kind = Literal["constant", "angle", "displacement", "rate", "push"]
_RANKS: dict[Kind, int] = {"constant": 0, "displacement": 1, "angle": 2, "rate": 3, "push": 4}
_ANGULAR = {"θ": "ω", "φ": "ω", "ω": "α"}


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

    def derivative(self, order: int) -> Symbol:
        """Its first (order 1) or second (2) derivative, which is not zero."""
        derivative = self if order == 0 else self.derivative(order - 1).rate
        assert derivative is not None
        return derivative

    @property
    def moves(self) -> bool:
        return self.kind != "constant"

    @property
    def order(self) -> tuple[int, str, int, str, int, int]:
        """Its place in a product: dimensions, displacements, rates."""
        return _RANKS[self.kind], self.letter, len(self.low), self.low, self.primes, self.dots


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
        counts: dict[Symbol, int] = {}
        for symbol, count in parts:
            counts[symbol] = counts.get(symbol, 0) + count
        nonzero = ((symbol, count) for symbol, count in counts.items() if count)
        return cls(tuple(sorted(nonzero, key=lambda part: (not part[0].moves, part[0].order))), quarters % 4)

    def __add__(self, other: AngleSum) -> AngleSum:
        return AngleSum.sum_of((*self.parts, *other.parts), self.quarters + other.quarters)

    def __neg__(self) -> AngleSum:
        return AngleSum.sum_of(((s, -n) for s, n in self.parts), -self.quarters)

    def __sub__(self, other: AngleSum) -> AngleSum:
        return self + -other

    def turned(self, quarters: int) -> AngleSum:
        return AngleSum.sum_of(self.parts, self.quarters + quarters)

    @property
    def moving(self) -> tuple[tuple[Symbol, int], ...]:
        """The symbols that change with time."""
        return tuple(part for part in self.parts if part[0].moves)

    def has(self, symbol: Symbol) -> bool:
        return any(symbol == part for part, _ in self.parts)


NO_ANGLE = AngleSum()


Values = Mapping[Symbol, Value]
WaveKind = Literal["cos", "sin", "exp"]


@frozen
class Wave:
    """cos, sin or e^i of an angle."""

    kind: WaveKind
    angle: AngleSum


@frozen
class SymbolProduct:
    """factor · i^turns · symbols · waves, in the order they are printed. `turns` is 0 or 1."""

    factor: float
    symbols: tuple[tuple[Symbol, int], ...] = ()
    waves: tuple[Wave, ...] = ()
    turns: int = 0

    def __mul__(self, other: SymbolProduct) -> SymbolProduct:
        powers = dict(self.symbols)
        for symbol, power in other.symbols:
            powers[symbol] = powers.get(symbol, 0) + power
        symbols = tuple(sorted(powers.items(), key=lambda item: item[0].order))
        waves = (*self.plain.waves, *other.plain.waves)
        product = SymbolProduct(self.factor * other.factor, symbols, waves).turned(self.turns + other.turns)
        return product.times_phasor(self.exponent + other.exponent)

    def turned(self, quarters: int) -> SymbolProduct:
        """The term times a power of i, half turns folded into its sign."""
        turns = (self.turns + quarters) % 4
        return replace(self, factor=-self.factor if turns >= 2 else self.factor, turns=turns % 2)

    def times_phasor(self, angle: AngleSum) -> SymbolProduct:
        """The term times e^(i angle): half turns go into the sign; a plain quarter turn is i."""
        if not angle.parts:
            return self.turned(angle.quarters)
        factor = -self.factor if angle.quarters >= 2 else self.factor
        return replace(self, factor=factor, waves=(*self.waves, Wave("exp", AngleSum(angle.parts, angle.quarters % 2))))

    @property
    def plain(self) -> SymbolProduct:
        """The term without its e^i."""
        return replace(self, waves=tuple(wave for wave in self.waves if wave.kind != "exp"))

    @property
    def exponent(self) -> AngleSum:
        """The angle of its e^i."""
        return next((wave.angle for wave in self.waves if wave.kind == "exp"), NO_ANGLE)

    @property
    def angle(self) -> AngleSum:
        """The angle of the arrow this term is."""
        return self.exponent.turned(self.turns)

    def has(self, symbol: Symbol) -> bool:
        return any(symbol == s for s, _ in self.symbols) or any(wave.angle.has(symbol) for wave in self.waves)


@frozen
class Sum:
    """Terms to be added; none is zero."""

    terms: tuple[SymbolProduct, ...] = ()

    @classmethod
    def of(cls, terms: Iterable[SymbolProduct]) -> Sum:
        """Like terms together, in the order of their first."""
        sums: dict[tuple[object, ...], SymbolProduct] = {}
        for term in terms:
            key = term.symbols, term.waves, term.turns
            like = sums.get(key)
            sums[key] = term if like is None else replace(like, factor=like.factor + term.factor)
        return cls(tuple(term for term in sums.values() if term.factor != 0))

    def __add__(self, other: Sum) -> Sum:
        return Sum.of((*self.terms, *other.terms))

    def __sub__(self, other: Sum) -> Sum:
        return self + -other

    def __neg__(self) -> Sum:
        return Sum(tuple(replace(term, factor=-term.factor) for term in self.terms))

    def __mul__(self, other: Sum) -> Sum:
        return Sum.of(a * b for a in self.terms for b in other.terms)

    def times(self, factor: float) -> Sum:
        return Sum.of(replace(term, factor=factor * term.factor) for term in self.terms)

    @property
    def conjugate(self) -> Sum:
        parts = ((term.plain, -term.exponent, -term.factor if term.turns else term.factor) for term in self.terms)
        return Sum.of(replace(plain, factor=factor).times_phasor(angle) for plain, angle, factor in parts)

    @property
    def real(self) -> Sum:
        """e^iψ gives cos ψ."""
        return self._part("cos")

    @property
    def imag(self) -> Sum:
        """e^iψ gives sin ψ."""
        return self._part("sin")

    def _part(self, kind: Literal["cos", "sin"]) -> Sum:
        parts = (Sum((replace(term.plain, turns=0),)) * wave(kind, term.angle) for term in self.terms)
        return Sum.of(term for part in parts for term in part.terms)

    @property
    def only(self) -> SymbolProduct | None:
        """Its only term; None where there are several, or none."""
        return self.terms[0] if len(self.terms) == 1 else None

    def having(self, *symbols: Symbol) -> Sum:
        """The terms in which any of these stands."""
        return Sum(tuple(term for term in self.terms if any(term.has(symbol) for symbol in symbols)))

    def lacking(self, *symbols: Symbol) -> Sum:
        """The terms in which none of these stands."""
        return Sum(tuple(term for term in self.terms if not any(term.has(symbol) for symbol in symbols)))

    def partial(self, symbol: Symbol) -> Sum:
        """Derivative by one symbol."""
        return Sum.of(part for term in self.terms for part in _partial(term, symbol))

    @cached_property
    def symbols(self) -> frozenset[Symbol]:
        """All that stand in it."""
        waves = (part for term in self.terms for wave in term.waves for part in wave.angle.parts)
        return frozenset(symbol for symbol, _ in (*waves, *(part for term in self.terms for part in term.symbols)))

    @property
    def moving(self) -> tuple[Symbol, ...]:
        """The symbols in it that change with time, in the order of the terms."""
        moving: dict[Symbol, None] = {}
        for term in self.terms:
            moving |= dict.fromkeys(symbol for symbol, _ in term.symbols if symbol.moves)
            moving |= dict.fromkeys(symbol for wave in term.waves for symbol, _ in wave.angle.moving)
        return tuple(moving)

    @property
    def rate(self) -> Sum:
        """Time derivative, term by term."""
        return Sum.of(part for term in self.terms for symbol in Sum((term,)).moving if symbol.rate is not None
                      for part in (Sum.of(_partial(term, symbol)) * one(symbol.rate)).terms)  # fmt: skip

    def at(self, values: Values) -> Value:
        """Its value (complex where e^i or i stands in it); scalars or arrays."""
        total: Value = np.float64(0.0)
        for term in self.terms:
            product: Value = term.factor * (1j if term.turns else 1.0)
            for symbol, power in term.symbols:
                product = product * values[symbol] ** power
            for each in term.waves:
                start: Value = each.angle.quarters * np.pi / 2
                angle = sum((count * values[symbol] for symbol, count in each.angle.parts), start=start)
                product = product * (np.exp(1j * angle) if each.kind == "exp" else getattr(np, each.kind)(angle))
            total = total + product
        return total


def one(symbol: Symbol) -> Sum:
    """A symbol alone."""
    return Sum((SymbolProduct(1.0, ((symbol, 1),)),))


def number(value: float) -> Sum:
    """A number alone."""
    return Sum((SymbolProduct(value),)) if value else Sum()


ONE = number(1.0)


def phasor(length: Sum, angle: AngleSum) -> Sum:
    """length · e^(i angle)."""
    return Sum.of(term.times_phasor(angle) for term in length.terms)


def unit_vector(angle: AngleSum) -> Sum:
    """e^(i angle), a vector of length 1."""
    return phasor(ONE, angle)


def wave(kind: Literal["cos", "sin"], angle: AngleSum) -> Sum:
    """cos or sin of an angle, quarter turns and common signs taken out: cos(−γ) is cos γ, sin(θ + 90°) cos θ."""
    quarters = (angle.quarters if kind == "cos" else angle.quarters - 1) % 4
    bare, sign = AngleSum(angle.parts), -1.0 if quarters in (1, 2) else 1.0
    name: Literal["cos", "sin"] = "cos" if quarters in (0, 2) else "sin"
    if not bare.parts:
        return number(sign if name == "cos" else 0.0)
    if all(count < 0 for _, count in bare.parts):
        bare, sign = -bare, sign if name == "cos" else -sign
    return Sum((SymbolProduct(sign, waves=(Wave(name, bare),)),))


def _partial(term: SymbolProduct, symbol: Symbol) -> Iterable[SymbolProduct]:
    for at, (factor, power) in enumerate(term.symbols):
        if factor == symbol:
            left = ((factor, power - 1),) if power > 1 else ()
            symbols = (*term.symbols[:at], *left, *term.symbols[at + 1 :])
            yield replace(term, factor=term.factor * power, symbols=symbols)
    for at, each in enumerate(term.waves):
        if count := dict(each.angle.parts).get(symbol, 0):
            rest = replace(term, factor=term.factor * count, waves=(*term.waves[:at], *term.waves[at + 1 :]))
            slope = -wave("sin", each.angle) if each.kind == "cos" else wave("cos", each.angle)
            if each.kind == "exp":
                slope = phasor(Sum((SymbolProduct(1.0, turns=1),)), each.angle)
            yield from (Sum((rest,)) * slope).terms


def cross(first: Sum, second: Sum) -> Sum:
    """x1 y2 − y1 x2 of two plane vectors."""
    return (first.conjugate * second).imag


def dot(first: Sum, second: Sum) -> Sum:
    """The scalar product of two sums."""
    return (first.conjugate * second).real


def squared(vector: Sum) -> Sum:
    """The square of a vector's length: squares, then twice the products by pairs."""
    arrows = [Sum((term,)) for term in vector.terms]
    squares = [term for arrow in arrows for term in dot(arrow, arrow).terms]
    pairs = [term for k, arrow in enumerate(arrows) for other in arrows[k + 1 :]
             for term in dot(other, arrow).times(2.0).terms]  # fmt: skip
    return Sum.of((*squares, *pairs))
