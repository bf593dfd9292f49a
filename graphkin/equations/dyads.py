"""Closed forms of a polygon with two unknown scalars: which of them an equation can be had for, and what it is.

With the unknowns' vectors apart the polygon reads K + U e^(iθ) + .. = 0, K known. What is multiplied crosswise by an
unknown's direction loses that unknown; squares of lengths lose an angle. All dyads are solved by these two rules.
"""

from __future__ import annotations

from functools import cached_property

from graphkin.base.value import frozen
from graphkin.equations.expressions import Sum, SymbolProduct, number, phasor
from graphkin.equations.symbols import AngleSum, Symbol


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
        return Sum(tuple(term for term in self.sum.terms if not any(term.has(symbol) for symbol in self.unknowns)))

    def slid(self, slide: Symbol) -> SymbolProduct:
        """The term of an unknown displacement."""
        return next(term for term in self.sum.terms if any(symbol == slide for symbol, _ in term.symbols))

    def lever(self, angle: Symbol) -> Sum:
        """U of U e^(iθ): what turns with an angle, unknown displacements left out."""
        sliding = [self.slid(slide) for slide in self.slides]
        turning = tuple(term for term in self.sum.terms if term.has(angle) and term not in sliding)
        return Sum(turning) * phasor(number(1.0), -AngleSum.of(angle))

    @property
    def turns_with(self) -> bool:
        """Whether the unknown displacement's own direction turns with the unknown angle."""
        return bool(self.angles and self.slides and self.slid(self.slides[0]).angle.has(self.angles[0]))


def unit(term: SymbolProduct) -> Sum:
    """The direction of a term, of length 1."""
    return phasor(number(1.0), term.angle)


def single(vector: Sum) -> SymbolProduct | None:
    """The only term of a vector; None where there are several."""
    return vector.terms[0] if len(vector.terms) == 1 else None
