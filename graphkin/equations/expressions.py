"""Sums of products of numbers, symbols, and cos, sin or e^i of angles: all that loop equations are made of.

A small closed set of values with the few operations kinematics needs: add, multiply, conjugate, real and imaginary
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
from graphkin.equations.symbols import NO_ANGLE, AngleSum, Symbol

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
        plain = [wave for wave in (*self.waves, *other.waves) if wave.kind != "exp"]
        turning = [wave.angle for wave in (*self.waves, *other.waves) if wave.kind == "exp"]
        made = _plain(self.factor * other.factor, symbols, tuple(plain), self.turns + other.turns)
        return _turned(made, sum(turning, NO_ANGLE)) if turning else made

    @property
    def key(self) -> tuple[object, ...]:
        return self.symbols, self.waves, self.turns

    @property
    def angle(self) -> AngleSum:
        """The angle of the arrow this term is."""
        return next((wave.angle for wave in self.waves if wave.kind == "exp"), NO_ANGLE).turned(self.turns)

    def has(self, symbol: Symbol) -> bool:
        return any(symbol == s for s, _ in self.symbols) or any(wave.angle.has(symbol) for wave in self.waves)


def _plain(
    factor: float, symbols: tuple[tuple[Symbol, int], ...], waves: tuple[Wave, ...], turns: int
) -> SymbolProduct:
    """A term whose power of i is folded into its sign."""
    sign = -1.0 if turns % 4 in (2, 3) else 1.0
    return SymbolProduct(sign * factor, symbols, waves, turns % 2)


def _turned(term: SymbolProduct, angle: AngleSum) -> SymbolProduct:
    """The term times e^(i angle): half turns go into the sign; a plain quarter turn is i."""
    quarters = angle.quarters
    if not angle.parts:
        return _plain(term.factor, term.symbols, term.waves, term.turns + quarters)
    sign, rest = (-1.0 if quarters >= 2 else 1.0), quarters % 2
    return replace(term, factor=sign * term.factor, waves=(*term.waves, Wave("exp", AngleSum(angle.parts, rest))))


@frozen
class Sum:
    """Terms to be added; none is zero."""

    terms: tuple[SymbolProduct, ...] = ()

    @classmethod
    def of(cls, terms: Iterable[SymbolProduct]) -> Sum:
        """Like terms together, in the order of their first."""
        found: dict[tuple[object, ...], SymbolProduct] = {}
        for term in terms:
            known = found.get(term.key)
            found[term.key] = term if known is None else replace(known, factor=known.factor + term.factor)
        return cls(tuple(term for term in found.values() if term.factor != 0))

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
        return Sum.of(_conjugate(term) for term in self.terms)

    @property
    def real(self) -> Sum:
        return Sum.of(part for term in self.terms for part in _part(term, 0))

    @property
    def imag(self) -> Sum:
        return Sum.of(part for term in self.terms for part in _part(term, 1))

    @property
    def over_i(self) -> Sum:
        return self * Sum((SymbolProduct(-1.0, turns=1),))

    def having(self, *symbols: Symbol) -> Sum:
        """The terms in which any of these stands."""
        return Sum(tuple(term for term in self.terms if any(term.has(symbol) for symbol in symbols)))

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
        found: dict[Symbol, None] = {}
        for term in self.terms:
            found |= dict.fromkeys(symbol for symbol, _ in term.symbols if symbol.moves)
            found |= dict.fromkeys(symbol for wave in term.waves for symbol, _ in wave.angle.moving)
        return tuple(found)

    @property
    def rate(self) -> Sum:
        """Time derivative, term by term."""
        return Sum.of(part for term in self.terms for symbol in Sum((term,)).moving if symbol.rate is not None
                      for part in (Sum.of(_partial(term, symbol)) * one(symbol.rate)).terms)  # fmt: skip

    def at(self, values: Values) -> Value:
        """Its value (complex where e^i or i stands in it); scalars or arrays."""
        return sum((_value(term, values) for term in self.terms), start=np.float64(0.0))


def one(symbol: Symbol) -> Sum:
    """A symbol alone."""
    return Sum((SymbolProduct(1.0, ((symbol, 1),)),))


def number(value: float) -> Sum:
    return Sum((SymbolProduct(value),)) if value else Sum()


def phasor(length: Sum, angle: AngleSum) -> Sum:
    """length · e^(i angle)."""
    return Sum.of(_turned(term, angle) for term in length.terms)


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


def _conjugate(term: SymbolProduct) -> SymbolProduct:
    rest = [wave for wave in term.waves if wave.kind != "exp"]
    plain = replace(term, waves=tuple(rest), factor=-term.factor if term.turns else term.factor)
    exps = [wave.angle for wave in term.waves if wave.kind == "exp"]
    return _turned(plain, -exps[0]) if exps else plain


def _part(term: SymbolProduct, quarter: int) -> Iterable[SymbolProduct]:
    """Real (0) or imaginary (1) part: e^iψ gives cos ψ or sin ψ."""
    exps = [wave.angle for wave in term.waves if wave.kind == "exp"]
    plain = replace(term, waves=tuple(wave for wave in term.waves if wave.kind != "exp"), turns=0)
    angle = (exps[0] if exps else NO_ANGLE).turned(term.turns)
    return (Sum((plain,)) * wave("sin" if quarter else "cos", angle)).terms


def _partial(term: SymbolProduct, symbol: Symbol) -> Iterable[SymbolProduct]:
    for at, (found, power) in enumerate(term.symbols):
        if found == symbol:
            left = ((found, power - 1),) if power > 1 else ()
            symbols = (*term.symbols[:at], *left, *term.symbols[at + 1 :])
            yield replace(term, factor=term.factor * power, symbols=symbols)
    for at, found_wave in enumerate(term.waves):
        count = found_wave.angle.symbols.get(symbol, 0)
        if count:
            rest = replace(term, factor=term.factor * count, waves=(*term.waves[:at], *term.waves[at + 1 :]))
            yield from (Sum((rest,)) * _slope(found_wave)).terms


def _slope(of: Wave) -> Sum:
    """Derivative of a wave by its angle."""
    if of.kind == "exp":
        return phasor(Sum((SymbolProduct(1.0, turns=1),)), of.angle)
    return -wave("sin", of.angle) if of.kind == "cos" else wave("cos", of.angle)


def cross(first: Sum, second: Sum) -> Sum:
    """x1 y2 − y1 x2 of two plane vectors."""
    return (first.conjugate * second).imag


def dot(first: Sum, second: Sum) -> Sum:
    return (first.conjugate * second).real


def squared(vector: Sum) -> Sum:
    """The square of a vector's length: squares, then twice the products by pairs."""
    arrows = [Sum((term,)) for term in vector.terms]
    squares = [term for arrow in arrows for term in dot(arrow, arrow).terms]
    pairs = [term for k, arrow in enumerate(arrows) for other in arrows[k + 1 :]
             for term in dot(other, arrow).times(2.0).terms]  # fmt: skip
    return Sum.of((*squares, *pairs))


def angle_value(angle: AngleSum, values: Values) -> Value:
    """[rad]"""
    return sum((count * values[symbol] for symbol, count in angle.parts), start=angle.quarters * np.pi / 2)


def _value(term: SymbolProduct, values: Values) -> Value:
    product: Value = term.factor * (1j if term.turns else 1.0)
    for symbol, power in term.symbols:
        product = product * values[symbol] ** power
    for found in term.waves:
        angle = angle_value(found.angle, values)
        product = product * (np.exp(1j * angle) if found.kind == "exp" else getattr(np, found.kind)(angle))
    return product
