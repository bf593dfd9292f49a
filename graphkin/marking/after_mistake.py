"""All that follows from mistakes that were named: the drawing with them, and with a student's own values beside."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.base.geometry import Real, Value
from graphkin.base.value import frozen
from graphkin.construction import Image, LayOff, Measure, Plane, Size
from graphkin.marking.carried import CarriedProblem
from graphkin.marking.consequences import combined, table_of, written_otherwise
from graphkin.marking.follow_through import Followed, Own
from graphkin.marking.hand import Redrawing, redraw
from graphkin.marking.read_off import ASTRAY
from graphkin.marking.rewrite import Mistaken, Rewrite


class OwnMistaken(Mistaken):
    """Draws with mistakes, and with own values in their place."""

    def __init__(self, columns: Sequence[Sequence[Rewrite]], own: Own) -> None:
        super().__init__(columns)
        self.own = own

    def arrow(self, plot: Redrawing, plane: Plane, size: Size, right: Value) -> Value:
        return super().arrow(plot, plane, size, self.own.arrow(plot, plane, size, right))

    def tip(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        return self.own.tip(plot, plane, step, super().tip(plot, plane, step, right))

    def met(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        plot.met[plane, point] = mistaken = self.crossing(plot, plane, point, right)
        return self.own.crossing(plot, plane, point, mistaken)

    def further(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        plot.met[plane, step.point] = mistaken = self.corner(plot, plane, step, right)
        return self.own.corner(plot, plane, step, mistaken)

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Real) -> Real:
        return self.own.read(plot, plane, step, super().read(plot, plane, step, right))

    def settled(self, plot: Redrawing, quantity: str, links: tuple[str, ...], of: str) -> None:
        super().settled(plot, quantity, links, of)
        for link in links:  # an own value stands for what the mistake gives
            plot.before.pop((quantity, link), None)
        self.own.settled(plot, quantity, links, of)


@frozen
class Aftermath:
    """The outcomes of mistakes, each student's own (students, quantities).

    values   NaN where they say nothing
    turned   whether they turn a vector so far that it is astray
    """

    values: np.ndarray
    turned: np.ndarray


def aftermath(
    problem: CarriedProblem, columns: Sequence[tuple[Rewrite, ...]], given: np.ndarray, wrong: np.ndarray
) -> Aftermath:
    """The outcomes of each student's mistakes, and of those own wrong values that the mistakes do not give."""
    distinct = list(dict.fromkeys(tuple(rewrite.name for rewrite in column) for column in columns))
    number = {names: k for k, names in enumerate(distinct)}
    each = {tuple(rewrite.name for rewrite in column): column for column in columns}
    drawn = combined(problem.method, problem.plot, problem.quantities, [(), *(each[names] for names in distinct)])
    row = np.array([number[tuple(rewrite.name for rewrite in column)] for column in columns], dtype=int) + 1
    with np.errstate(invalid="ignore", divide="ignore"):
        turned = np.abs(np.angle(drawn.vectors[row] / drawn.vectors[0])) > ASTRAY
    values = drawn.values[row]
    # beside a mistake that is known an own value may be of any size
    own = wrong & ~problem.near(given, values) & problem.usable(given, of_any_size=True)
    some = np.flatnonzero(own.any(axis=1)).tolist()
    if some:
        values[some] = _with_own(problem, [columns[k] for k in some], given[some], own[some])
    return Aftermath(np.where(problem.table.size, np.abs(values), values), turned)


def _with_own(
    problem: CarriedProblem, columns: Sequence[tuple[Rewrite, ...]], given: np.ndarray, used: np.ndarray
) -> np.ndarray:
    hand = OwnMistaken(columns, Own(problem.own(given, used), problem.arrows))
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        plot = redraw(problem.method, hand.placed(problem.method, problem.plot), hand, hand.shape)
        followed = Followed(problem.method, problem.arrows, plot)
        answers = [followed.value(quantity) for quantity in problem.quantities]
        values = table_of([answer.value for answer in answers], len(columns), float)
        vectors = table_of([np.nan if a.vector is None else a.vector for a in answers], len(columns), complex)
        written_otherwise(problem.quantities, columns, values, vectors)
    return values
