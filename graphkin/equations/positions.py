"""Positions in closed form, dyad by dyad: what is eliminated, the equation left, its two roots and the sign taken."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.equations.dyads import Split, single, unit
from graphkin.equations.expressions import Sum, SymbolProduct, cross, dot, number, one, phasor, squared
from graphkin.equations.layout import Call, Frac, Letter, Node, Num, Op, Pow, Root, Row
from graphkin.equations.legend import Legend
from graphkin.equations.page import EquationPage
from graphkin.equations.pretty import ZERO, Pretty, added
from graphkin.equations.symbols import AngleSum, Symbol

Values = Mapping[Symbol, Value]


@frozen
class Solver:
    """Writes the positions of one polygon's unknowns on a page.

    values  all letters at the drawn position: they tell which root is taken
    low     subscript of A, B, C where several polygons want them
    """

    page: EquationPage
    pretty: Pretty
    ledger: Legend
    values: Values
    low: str

    def write(self, split: Split) -> None:
        match len(split.angles), len(split.slides):
            case 2, 0:
                self._two_angles(split)
            case 1, 1 if split.turns_with:
                self._turning_slide(split)
            case 1, 1:
                self._angle_and_slide(split)
            case 0, 2:
                self._two_slides(split)
            case 1, 0:
                self._direction(split.angles[0], split.lever(split.angles[0]), split.known)
            case _:
                raise ValueError(f"{len(split.unknowns)} unknowns of one polygon")

    # --- the dyads -----------------------------------------------------------------------------

    def _two_angles(self, split: Split) -> None:
        """RRR: |U|² = |V e^(iθ) + K|², which is A sin θ + B cos θ + C = 0."""
        other, angle = split.angles
        lever, arm, known = split.lever(other), split.lever(angle), split.known
        turned = known.conjugate * arm
        self.page.say("equations.eliminate angle", other=Letter(other), angle=Letter(angle))
        self._half_angle(
            angle, turned.imag.times(2.0), turned.real.times(-2.0), squared(lever) - squared(arm) - squared(known)
        )
        self._direction(other, lever, known + arm * phasor(number(1.0), AngleSum.of(angle)))

    def _angle_and_slide(self, split: Split) -> None:
        """RRP: across the guide the displacement vanishes."""
        angle, slide = split.angles[0], split.slides[0]
        line, lever, known = unit(split.slid(slide)), split.lever(angle), split.known
        self.page.say("equations.eliminate slide", other=Letter(slide))
        if single(lever) is not None:
            self._sine(line, lever * phasor(number(1.0), AngleSum.of(angle)), known)
        else:
            turned = line.conjugate * lever
            self._half_angle(angle, turned.real, turned.imag, cross(line, known))
        self.page.say("equations.along", slide=Letter(slide))
        self._projected(split, slide)

    def _turning_slide(self, split: Split) -> None:
        """RPR: the displacement's line turns with the lever; |K|² = |U + s e^(iβ)|²."""
        angle, slide = split.angles[0], split.slides[0]
        lever, known, term = split.lever(angle), split.known, split.slid(slide)
        line = phasor(number(1.0), term.angle - AngleSum.of(angle))
        offset = dot(line, lever).times(-term.factor)
        under = squared(known) - cross(line, lever) * cross(line, lever)
        self.page.say("equations.square", angle=Letter(angle))
        root = Root(self.pretty.sum(under))
        if offset.terms or float(self.values[slide]) < 0:
            self.page.show((Letter(slide), Row((*_items(offset, self.pretty), Op("±"), root))))
            self._sign(float(self.values[slide] - offset.at(self.values)) > 0)
        else:
            self.page.show((Letter(slide), root))
        self._direction(angle, lever + (one(slide) * line).times(term.factor), known)

    def _two_slides(self, split: Split) -> None:
        """Both directions are known: each displacement across the other's line."""
        self.page.say("equations.each across")
        rows = []
        for slide, other in (split.slides, split.slides[::-1]):
            across, term = unit(split.slid(other)), split.slid(slide)
            bottom = cross(across, unit(term)).times(term.factor)
            rows.append((Letter(slide), self.pretty.quotient(-cross(across, split.known), bottom)))
        self.page.show(*rows)

    # --- their parts ---------------------------------------------------------------------------

    def _half_angle(self, angle: Symbol, a: Sum, b: Sum, c: Sum) -> None:
        """A sin θ + B cos θ + C = 0, and tan(θ/2) = (A ± √(A² + B² − C²)) / (B − C)."""
        names = [self.ledger.fresh(letter, self.low) for letter in ("A", "B", "C")]
        first, second, third = (Letter(name) for name in names)
        theta = Letter(angle)
        whole = added([(False, Row((first, Call("sin", (theta,))))), (False, Row((second, Call("cos", (theta,))))),
                       (False, third)])  # fmt: skip
        self.page.show((whole, ZERO))
        self.page.say("equations.with")
        self.page.show(*((Letter(name), self.pretty.factored(of)) for name, of in zip(names, (a, b, c), strict=True)))
        root = Root(added([(False, Pow(first, 2)), (False, Pow(second, 2)), (True, Pow(third, 2))]))
        top = Row((first, Op("±"), root))
        half = Call("tan", (Row((theta, Op("/"), Num("2"))),))
        self.page.say("equations.solved")
        self.page.show((half, Frac(top, Row((second, Op("−"), third)))))
        x = float(self.values[angle])
        rise = float(a.at(self.values)) * np.cos(x) - float(b.at(self.values)) * np.sin(x)
        self._sign(bool(rise < 0))

    def _sine(self, line: Sum, turned: Sum, known: Sum) -> None:
        """One arrow of unknown angle against a line: its sine is known, its cosine up to the sign."""
        first, second = (term for part in (cross(line, turned), dot(line, turned)) for term in part.terms)
        (sine,), (cosine,) = first.waves, second.waves
        size = Sum((SymbolProduct(first.factor, first.symbols),))
        left = self.pretty.sum(Sum((SymbolProduct(1.0, waves=(sine,)),)))
        under = Row((Num("1"), Op("−"), Pow(left, 2)))
        right = self.pretty.sum(Sum((SymbolProduct(1.0, waves=(cosine,)),)))
        self.page.show((left, self.pretty.quotient(-cross(line, known), size)), (right, Row((Op("±"), Root(under)))))
        self._sign(float(Sum((SymbolProduct(1.0, waves=(cosine,)),)).at(self.values)) > 0)

    def _projected(self, split: Split, slide: Symbol) -> None:
        term = split.slid(slide)
        rest = Sum(tuple(other for other in split.sum.terms if other != term))
        self.page.show((Letter(slide), self.pretty.sum(dot(unit(term), rest).times(-1 / term.factor))))

    def _direction(self, angle: Symbol, lever: Sum, rest: Sum) -> None:
        """lever · e^(iθ) = −rest: θ is the direction of −rest less that of the lever."""
        self.page.say("equations.direction of", angle=Letter(angle))
        term = single(lever)
        if term is None:
            if lever.terms and lever.terms[0].factor < 0:
                lever, rest = -lever, -rest
            ends = [self._atan(-rest), self._atan(lever)]
            self.page.show((Letter(angle), Row((ends[0], Op("−"), ends[1]))))
            return
        theta = AngleSum.of(angle) + term.angle
        right = self._atan(rest.times(-1.0 if term.factor > 0 else 1.0))
        self.page.show((self.pretty.angle(theta), right))

    def _atan(self, vector: Sum) -> Node:
        return Call("atan2", (self.pretty.sum(vector.imag), self.pretty.sum(vector.real)))

    def _sign(self, positive: bool) -> None:
        self.page.say("equations.sign", sign="+" if positive else "−")


def _items(of: Sum, pretty: Pretty) -> tuple[Node, ...]:
    """A sum's nodes, to be followed by more."""
    if not of.terms:
        return ()
    node = pretty.sum(of)
    return node.items if isinstance(node, Row) and any(isinstance(item, Op) for item in node.items) else (node,)

