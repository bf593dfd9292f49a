"""Closed forms of a polygon with two unknown scalars: positions with their two roots, rates as quotients.

With the unknowns' vectors apart the polygon reads K + U e^(iθ) + .. = 0, K known. What is multiplied crosswise by an
unknown's direction loses that unknown; squares of lengths lose an angle. All dyads are solved by these two rules.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.geometry import number as real
from graphkin.base.value import frozen
from graphkin.equations.document import EquationPage
from graphkin.equations.expressions import ONE, AngleSum, Sum, Symbol, SymbolProduct, cross, dot, squared, unit_vector
from graphkin.equations.formulas import ZERO, Call, Frac, Letter, Node, Num, Op, Pow, Root, Row
from graphkin.equations.legend import Legend
from graphkin.equations.pretty import Pretty, added

Values = Mapping[Symbol, Value]


@frozen
class Split:
    """A polygon's sum, the terms of its unknowns apart."""

    sum: Sum
    unknowns: tuple[Symbol, ...]

    @cached_property
    def angles(self) -> tuple[Symbol, ...]:
        return tuple(symbol for symbol in self.unknowns if symbol.kind == "angle")

    @cached_property
    def slides(self) -> tuple[Symbol, ...]:
        return tuple(symbol for symbol in self.unknowns if symbol.kind == "displacement")

    @property
    def known(self) -> Sum:
        return self.sum.lacking(*self.unknowns)

    def slid(self, slide: Symbol) -> SymbolProduct:
        """The term of an unknown displacement."""
        return next(term for term in self.sum.terms if any(symbol == slide for symbol, _ in term.symbols))

    def lever(self, angle: Symbol) -> Sum:
        """U of U e^(iθ): what turns with an angle, unknown displacements left out."""
        sliding = [self.slid(slide) for slide in self.slides]
        turning = tuple(term for term in self.sum.terms if term.has(angle) and term not in sliding)
        return Sum(turning) * unit_vector(-AngleSum.of(angle))


def quotients(split: Split, order: int) -> Iterator[tuple[Symbol, Sum, Sum]]:
    """The first (order 1) or second (2) derivatives of the unknowns, symbol, top and bottom of each: (3-13), (3-14),
    (3-16), (3-17) for every dyad. The polygon derived is linear in them: c1 x1 + c2 x2 + rest = 0 with plane vectors c.
    Multiplied crosswise by c2 it gives x1. A displacement beside an angle is projected on its own line, as the angle's
    rate is known by then."""
    derived = split.sum.rate if order == 1 else split.sum.rate.rate
    unknowns = (*split.angles, *split.slides)
    rates = {symbol: symbol.derivative(order) for symbol in unknowns}
    rest = derived.lacking(*rates.values())
    columns = {symbol: split.sum.partial(symbol) for symbol in unknowns}
    for symbol in (*reversed(split.angles), *split.slides):
        others = [other for other in unknowns if other != symbol]
        if symbol in split.slides and split.angles:
            term = split.slid(symbol)
            top = dot(unit_vector(term.angle), derived.lacking(rates[symbol]))
            bottom = Sum((SymbolProduct(term.factor),))
        elif others:
            across = _unit_along(columns[others[0]])
            top, bottom = cross(across, rest), cross(across, columns[symbol])
        else:
            along = _unit_along(columns[symbol])
            top, bottom = dot(along, rest), dot(along, columns[symbol])
        only = bottom.only
        if only is not None and not only.symbols and not only.waves:  # a bare number is put into the top
            yield rates[symbol], (-top).times(1 / only.factor), ONE
        elif bottom.terms and bottom.terms[0].factor < 0:
            yield rates[symbol], top, -bottom
        else:
            yield rates[symbol], -top, bottom


def _unit_along(column: Sum) -> Sum:
    """A vector of the same direction, of length 1 where it is one arrow."""
    return column if column.only is None else unit_vector(column.only.angle)


@frozen
class Solver:
    """Writes the positions of one polygon's unknowns on a page: the equation left, its two roots and the sign taken.

    values  all letters at the drawn position: they tell which root is taken
    low     subscript of A, B, C where several polygons have them
    """

    page: EquationPage
    pretty: Pretty
    legend: Legend
    values: Values
    low: str

    def write(self, split: Split) -> None:
        match len(split.angles), len(split.slides):
            case 2, 0:  # RRR: |U|² = |V e^(iθ) + K|², which is A sin θ + B cos θ + C = 0
                other, angle = split.angles
                lever, arm, known = split.lever(other), split.lever(angle), split.known
                turned = known.conjugate * arm
                self.page.say("equations.eliminate angle", other=Letter(other), angle=Letter(angle))
                rest = squared(lever) - squared(arm) - squared(known)
                self._half_angle(angle, turned.imag.times(2.0), turned.real.times(-2.0), rest)
                self._direction(other, lever, known + arm * unit_vector(AngleSum.of(angle)))
            case 1, 1 if split.slid(split.slides[0]).angle.has(split.angles[0]):  # its line turns with the angle
                self._turning_slide(split)
            case 1, 1:
                self._angle_and_slide(split)
            case 0, 2:  # both directions are known: each displacement across the other's line
                self.page.say("equations.each across")
                rows = []
                for slide, other in (split.slides, split.slides[::-1]):
                    across, term = unit_vector(split.slid(other).angle), split.slid(slide)
                    bottom = cross(across, unit_vector(term.angle)).times(term.factor)
                    rows.append((Letter(slide), self.pretty.quotient(-cross(across, split.known), bottom)))
                self.page.show(*rows)
            case 1, 0:
                self._direction(split.angles[0], split.lever(split.angles[0]), split.known)
            case _:
                raise ValueError(f"{len(split.unknowns)} unknowns of one polygon")

    def _angle_and_slide(self, split: Split) -> None:
        """RRP: across the guide the displacement vanishes."""
        angle, slide = split.angles[0], split.slides[0]
        term, lever, known = split.slid(slide), split.lever(angle), split.known
        line = unit_vector(term.angle)
        self.page.say("equations.eliminate slide", other=Letter(slide))
        if lever.only is not None:
            # one arrow of unknown angle against a line: its sine is known, its cosine up to the sign
            turned = lever * unit_vector(AngleSum.of(angle))
            (first,), (second,) = cross(line, turned).terms, dot(line, turned).terms
            sine, cosine = (Sum((SymbolProduct(1.0, waves=each.waves),)) for each in (first, second))
            left = self.pretty.sum(sine)
            right = self.pretty.quotient(-cross(line, known), Sum((SymbolProduct(first.factor, first.symbols),)))
            root = Root(Row((Num("1"), Op("−"), Pow(left, 2))))
            self.page.show((left, right), (self.pretty.sum(cosine), Row((Op("±"), root))))
            self._sign(real(cosine.at(self.values)) > 0)
        else:
            turned = line.conjugate * lever
            self._half_angle(angle, turned.real, turned.imag, cross(line, known))
        self.page.say("equations.along", slide=Letter(slide))
        rest = Sum(tuple(other for other in split.sum.terms if other != term))
        self.page.show((Letter(slide), self.pretty.sum(dot(line, rest).times(-1 / term.factor))))

    def _turning_slide(self, split: Split) -> None:
        """RPR: the displacement's line turns with the lever; |K|² = |U + s e^(iβ)|²."""
        angle, slide = split.angles[0], split.slides[0]
        lever, known, term = split.lever(angle), split.known, split.slid(slide)
        line = unit_vector(term.angle - AngleSum.of(angle))
        offset = dot(line, lever).times(-term.factor)
        under = squared(known) - cross(line, lever) * cross(line, lever)
        self.page.say("equations.square", angle=Letter(angle))
        root = Root(self.pretty.sum(under))
        if offset.terms or real(self.values[slide]) < 0:
            node = self.pretty.sum(offset)
            is_sum = isinstance(node, Row) and any(isinstance(item, Op) for item in node.items)
            before = node.items if isinstance(node, Row) and is_sum else (node,) * bool(offset.terms)
            self.page.show((Letter(slide), Row((*before, Op("±"), root))))
            self._sign(real(self.values[slide]) - real(offset.at(self.values)) > 0)
        else:
            self.page.show((Letter(slide), root))
        self._direction(angle, lever + Sum((SymbolProduct(term.factor, ((slide, 1),)),)) * line, known)

    def _half_angle(self, angle: Symbol, a: Sum, b: Sum, c: Sum) -> None:
        """A sin θ + B cos θ + C = 0, and tan(θ/2) = (A ± √(A² + B² − C²)) / (B − C)."""
        first, second, third = letters = [Letter(self.legend.fresh(letter, self.low)) for letter in ("A", "B", "C")]
        theta = Letter(angle)
        terms = Row((first, Call("sin", (theta,)))), Row((second, Call("cos", (theta,)))), third
        self.page.show((added([(False, term) for term in terms]), ZERO))
        self.page.say("equations.with")
        self.page.show(*((letter, self.pretty.factored(of)) for letter, of in zip(letters, (a, b, c), strict=True)))
        root = Root(added([(False, Pow(first, 2)), (False, Pow(second, 2)), (True, Pow(third, 2))]))
        half = Call("tan", (Row((theta, Op("/"), Num("2"))),))
        self.page.say("equations.solved")
        self.page.show((half, Frac(Row((first, Op("±"), root)), Row((second, Op("−"), third)))))
        x = real(self.values[angle])
        self._sign(bool(real(a.at(self.values)) * np.cos(x) - real(b.at(self.values)) * np.sin(x) < 0))

    def _direction(self, angle: Symbol, lever: Sum, rest: Sum) -> None:
        """lever · e^(iθ) = −rest: θ is the direction of −rest less that of the lever."""
        self.page.say("equations.direction of", angle=Letter(angle))
        if lever.terms and lever.terms[0].factor < 0:
            lever, rest = -lever, -rest
        if lever.only is None:
            self.page.show((Letter(angle), Row((self._direction_of(-rest), Op("−"), self._direction_of(lever)))))
        else:
            self.page.show((self.pretty.angle(AngleSum.of(angle) + lever.only.angle), self._direction_of(-rest)))

    def _direction_of(self, vector: Sum) -> Node:
        return Call("atan2", (self.pretty.sum(vector.imag), self.pretty.sum(vector.real)))

    def _sign(self, positive: bool) -> None:
        self.page.say("equations.sign", sign="+" if positive else "−")
