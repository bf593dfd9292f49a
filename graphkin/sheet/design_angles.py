"""The angles of a designed linkage on paper, with their values: θ, the swing, and the right angles that give them."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from graphkin.base.value import frozen
from graphkin.construction.drafting import Board
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, number, plain
from graphkin.sheet.marks import ArcMark, Stroke
from graphkin.sheet.paper import BODY
from graphkin.sheet.single_figure import SingleFigure
from graphkin.sheet.window import Entry
from graphkin.studies.design import Solution

_SQUARE = 2.2
"""Side of the square in a right angle [mm]."""
_ARC = 13.0
"""Radius of the arcs that show angles [mm]."""


@frozen
class DesignAngles:
    """Of a solution on a page, whose construction is drawn on a board."""

    solution: Solution
    on: SingleFigure
    board: Board

    def entries(self) -> Iterator[Entry]:
        """theta at A, and the swing at D (at C for a guide bar), with their values."""
        at, one = self.board.places, self.solution
        if one.theta is None or len(one.limits) != 2 or "theta" not in self.board.numbers:
            return
        if one.shape == "guide-bar":
            yield from self._angle(at["C"], at["B1"], at["B2"], "ψ = θ", one.theta, 2)
            for pin in ("B1", "B2"):
                yield from self._right_angle(pin, "A", "C", "")
            return
        yield from self._angle(at["A"], at["C1"], at["C2"], "θ", one.theta, len(one.construction.stages))
        yield from self._seen_under()
        if one.swing is not None and "D" in at:
            yield from self._angle(at["D"], at["C1"], at["C2"], "ψ", one.swing, 2)
        if one.stroke is not None:
            ends = self.on.window(at["C1"]), self.on.window(at["C2"])
            label = self._valued("H", 1e3 * one.stroke, " mm")
            yield LabelRequest(label, ends[0], ends[1], gap=3.4, step=2, spare=True)

    def _seen_under(self) -> Iterator[Entry]:
        """The triangle on C1C2 that gives the circle: 90° at C2, 90° − θ at C1."""
        if not {"C1", "C2", "P"} <= self.board.places.keys():
            return
        if not (square := list(self._right_angle("C2", "C1", "P", "90°"))):
            return
        yield from square
        first, second, third = (self.on.window(self.board.places[name]) for name in ("C1", "C2", "P"))
        back, stage = first - second, self.solution.construction.born("P")
        start, sweep = cmath.phase(-back), cmath.phase((third - first) / -back)
        radius = min(_ARC, 0.5 * abs(back))
        yield ArcMark(first, radius, start, sweep, "thin", step=stage)
        middle = cmath.rect(radius, start + sweep / 2)
        label = (*plain("90° − "), Run("θ", True))
        yield LabelRequest(label, first + middle, gap=0.6, away=middle, size=BODY, step=stage, spare=True)

    def _right_angle(self, corner: str, one: str, other: str, said: str) -> Iterator[Entry]:
        """A square in a corner, with what is said of it; nothing where the angle is another, or the sides are short."""
        at, first, second = (self.on.window(self.board.places[name]) for name in (corner, one, other))
        a, b = first - at, second - at
        if abs((a.conjugate() * b).real) > 1e-6 * abs(a * b) or min(abs(a), abs(b)) < 3 * _SQUARE:
            return
        stage = max(self.solution.construction.born(name) or 0 for name in (corner, one, other))
        a, b = a / abs(a) * _SQUARE, b / abs(b) * _SQUARE
        yield Stroke((at + a, at + a + b, at + b), "construction", step=stage)
        if said:
            yield LabelRequest(plain(said), at + a + b, gap=0.5, away=a + b, size=BODY, step=stage, spare=True)

    def _angle(
        self, centre: complex, first: complex, second: complex, letter: str, value: float, stage: int
    ) -> Iterator[Entry]:
        at, one, other = (self.on.window(z) for z in (centre, first, second))
        radius = min(_ARC, 0.6 * min(abs(one - at), abs(other - at)))
        start = cmath.phase(one - at)
        sweep = cmath.phase((other - at) / (one - at))
        yield ArcMark(at, radius, start, sweep, "thin", step=stage)
        middle = at + cmath.rect(radius, start + sweep / 2)
        yield LabelRequest(
            self._valued(letter, math.degrees(value), "°"), middle, gap=0.8, away=middle - at, step=stage
        )

    @staticmethod
    def _valued(letter: str, value: float, unit: str) -> Label:
        return (*(Run(c, c.isalpha()) for c in letter), Run(" = "), *number(value, 5), *plain(unit))
