"""The legend: every letter once, with its meaning and the reader of its value on an analytic motion.

Links and slots that stand for cams and rolling (the lower-pair equivalent) are no links of the mechanism; their values
follow from the points they join.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from graphkin.analytic import Motion
from graphkin.base.geometry import Real, Value
from graphkin.base.value import frozen
from graphkin.equations.expressions import AngleSum, Kind, Symbol
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Slide
from graphkin.planning.structure import Topology
from graphkin.say.catalogue import Meaning

Unit = Literal["mm", "deg", "rad/s", "rad/s^2", "m/s", "m/s^2", "mm rad", "1"]
Reader = Callable[[Motion], Value]
Three = tuple[Reader, Reader, Reader]  # readers of a value, its rate and its second rate


@frozen
class LegendEntry:
    """A line of the legend: the meaning of a symbol, the unit it is written in, and its value in SI at a motion."""

    meaning: Meaning
    unit: Unit
    read: Reader


@dataclass
class Legend:
    """All symbols with their entries, in the order they came up.

    alias   names of angles fixed to one another: θ2 = θ3 + γ
    """

    entries: dict[Symbol, LegendEntry] = field(default_factory=dict)
    alias: dict[Symbol, AngleSum] = field(default_factory=dict)
    _used: set[tuple[str, str, int]] = field(default_factory=set)

    def fresh(self, letter: str, low: str, kind: Kind = "constant", steady: bool = False) -> Symbol:
        """A symbol nothing else bears: primes of a name are primes of the letter, and more are added where needed."""

        def keys(symbol: Symbol) -> set[tuple[str, str, int]]:
            return {(each.letter + "." * each.dots, each.low, each.primes) for each in _family(symbol)}

        bare = low.rstrip("'")
        symbol = Symbol(letter, bare, len(low) - len(bare), 0, kind, steady)
        while self._used & keys(symbol):
            symbol = replace(symbol, primes=symbol.primes + 1)
        self._used |= keys(symbol)
        return symbol

    def constant(self, letter: str, low: str, meaning: Meaning, unit: Unit, value: float) -> Symbol:
        """A dimension, whatever the position [m, rad]."""
        symbol = self.fresh(letter, low)
        self.entries[symbol] = LegendEntry(meaning, unit, lambda motion: value)
        return symbol

    def variable(
        self, symbol: Symbol, meanings: tuple[Meaning, ...], units: tuple[Unit, Unit, Unit], readers: Three
    ) -> Symbol:
        """A symbol that moves, with its rates."""
        for each, meaning, unit, read in zip(_family(symbol), meanings, units, readers, strict=False):
            self.entries[each] = LegendEntry(meaning, unit, read)
        return symbol


def _family(symbol: Symbol) -> tuple[Symbol, ...]:
    """The symbol, its rate, and the rate of that."""
    family = [symbol]
    while family[-1].kind != "push" and (rate := family[-1].rate) is not None:
        family.append(rate)
    return tuple(family)


def values(legend: Legend, motion: Motion) -> dict[Symbol, Value]:
    """Every symbol's value at a motion, in SI units: scalars, or arrays over positions."""
    return {symbol: entry.read(motion) for symbol, entry in legend.entries.items()}


def angle_readers(structure: Topology, body: str, drawn: Motion) -> Three:
    """θ, ω, α of a body [rad, rad/s, rad/s^2]; of a link of the equivalent, by its two points."""
    if structure.is_pin(body):
        slide = structure.pins[body]
        theta, omega, alpha = angle_readers(structure, slide.guide, drawn)
        return lambda motion: theta(motion) + cmath.phase(slide.line.direction), omega, alpha
    if structure.is_link(body):
        return (lambda motion: motion.theta[body], lambda motion: motion.omega[body], lambda motion: motion.alpha[body])
    tail, head = structure.bodies[body][:2]

    def arm(motion: Motion) -> Value:
        return motion.position[head] - motion.position[tail]

    def counted(motion: Motion) -> Real:
        """On from the drawn position, as rolling needs it."""
        return np.angle(arm(drawn)) + np.angle(arm(motion) / arm(drawn))

    def rate(motion: Motion) -> Real:
        return np.imag((motion.velocity[head] - motion.velocity[tail]) / arm(motion))

    def push(motion: Motion) -> Real:
        return np.imag((motion.acceleration[head] - motion.acceleration[tail]) / arm(motion))

    return counted, rate, push


def difference(first: Three, second: Three) -> Three:
    """One body against another."""
    theta, omega, alpha = zip(first, second, strict=True)
    return (
        lambda motion: theta[0](motion) - theta[1](motion), lambda motion: omega[0](motion) - omega[1](motion),
        lambda motion: alpha[0](motion) - alpha[1](motion),
    )  # fmt: skip


def point_place(structure: Topology, point: str, body: str, motion: Motion) -> Value:
    """The place of a point of a body [m], also of one that stands for a parallel of the equivalent."""
    if point in motion.position:
        return motion.position[point]
    shape, along = structure.shapes[body], np.exp(1j * motion.theta[body])
    placed = next((name for name in shape if name in motion.position), None)
    start = motion.position[placed] - shape[placed] * along if placed is not None else 0.0
    return start + shape[point] * along


def slide_readers(structure: Topology, slide: Slide) -> Three:
    """s, its rate and second rate, from the motion of the point as seen on the guide [m, m/s, m/s^2]."""
    guide, point, origin = slide.guide, slide.point, slide.line.origin

    def along(motion: Motion) -> Value:
        return np.exp(-1j * motion.theta[guide]) * slide.line.direction.conjugate()

    def seen(motion: Motion) -> Value:
        return motion.velocity[point] - motion.velocity_at(point, guide)

    def displacement(motion: Motion) -> Real:
        return np.real(along(motion) * (motion.position[point] - point_place(structure, origin, guide, motion)))

    def rate(motion: Motion) -> Real:
        return np.real(along(motion) * seen(motion))

    def push(motion: Motion) -> Real:
        turning = 2j * (0.0 if guide == FRAME else motion.omega[guide]) * seen(motion)
        return np.real(along(motion) * (motion.acceleration[point] - motion.acceleration_at(point, guide) - turning))

    return displacement, rate, push
