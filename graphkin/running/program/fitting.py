"""Calculated positions and rates for a recorder: links tried until they fit, chains of arrows closed at once.

From close by, two steps of Newton's method come to the last digit. Where the second is not as short as that asks for,
a position is replayed plainly, as where a division fails.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction.fitting import reach, settle_all
from graphkin.construction.kinds import Closure, Fit, Simultaneous
from graphkin.construction.linear import Row, chains, in_step, settle_rates, two, unknowns_of
from graphkin.construction.plot import Plot, slide_key
from graphkin.construction.terms import Arm, Plane, Slid
from graphkin.running.program.tape import CannotRecord

STEPS = 2
SHORT = 1e-7
"""The last step at most [rad, of the group's size]; what it leaves is of the order of its square."""


@frozen
class GroupSense:
    """A group's sense (0) or its sine (1), which is calculated from the finished plot when it is read."""

    step: Fit
    which: int


def fitted(step: Fit, plot: Plot) -> Value:
    """Settle a group's unknowns; the result is above 0 where they converge, 1 at best."""
    x: list[Value] = [plot.near[name] for name in unknowns_of(step)]
    units = _units(step, reach(step, plot))
    for _ in range(STEPS):
        settle_all(step, plot, x)
        change = solved(_gaps(step, plot), dict(zip(unknowns_of(step), units)))
        x = [value - part * unit for value, part, unit in zip(x, change, units)]
    settle_all(step, plot, x)
    plot.senses[step.name], plot.sines["position", step.name] = GroupSense(step, 0), GroupSense(step, 1)
    plot.misses[step.name] = 0.0
    longest = np.abs(change[0])
    for part in change[1:]:
        longest = np.maximum(longest, np.abs(part))
    return 1.0 - longest / SHORT


def _units(step: Fit, size: float) -> list[float]:
    """The unit of each unknown: 1 rad, or the group's size [m]."""
    return [1.0] * len(step.angles) + [size] * len(step.slides)


def together(step: Simultaneous, plot: Plot, plane: Plane) -> None:
    """The unknown rates of a group."""
    rows = [(-known, coefficients) for known, coefficients in chains(step, plot, plane)]
    settle_rates(step, plot, plane, solved(rows, dict.fromkeys(unknowns_of(step), 1.0)))


# --- gaps -------------------------------------------------------------------------------------


def _gaps(step: Fit, plot: Plot) -> list[Row]:
    """The gaps of closures and contacts, with their slope for each unknown."""
    rows = [row for closure in step.closures for row in two(*_closure(closure, plot))]
    for contact in step.contacts:
        gap, _ = in_step(contact, plot, "position", set(), set())
        rows.append((gap, in_step(contact, plot, "position", set(step.angles), set(step.slides))[1]))
    return rows


def _closure(closure: Closure, plot: Plot) -> Row:
    """What is left open of a way round, and what each unknown does to it [m]."""
    gap = 0.0 if closure.floats else plot.position[closure.start] - plot.position[closure.end]
    slopes: dict[str, Value] = {}
    for part in closure.parts:
        base, arrow = _stretch(part, plot)
        gap = gap + arrow
        slopes[base] = slopes.get(base, 0.0) + 1j * arrow
        if isinstance(part, Slid):
            slopes[slide_key(part.slide)] = part.sign * plot.guide_direction(part.slide)
    return gap, slopes


def _stretch(part: Arm | Slid, plot: Plot) -> tuple[str, Value]:
    """One part of a closure as it lies now, with the base link that turns it [m]."""
    if isinstance(part, Arm):
        shape = plot.facts.shapes[part.link]
        arrow = (shape[part.head] - shape[part.tail]) * np.exp(1j * plot.theta[part.link])
        return plot.facts.turns[part.link].base, arrow
    guide = plot.facts.lines[part.slide][0]
    return plot.facts.turns[guide].base, part.sign * plot.s[part.slide] * plot.guide_direction(part.slide)


# --- linear equations -------------------------------------------------------------------------


def solved(rows: Sequence[Row], units: Mapping[str, float]) -> list[Value]:
    """x, in units, of which each row's coefficients times x give what the row knows.

    Rows are turned in pairs, each time so that a coefficient becomes 0: nothing grows, and none has to be chosen by its
    size, which a tape does not know.
    """
    if len(rows) != len(units):
        raise CannotRecord("more equations than unknowns")
    lines = [[*(of.get(name, 0.0) * unit for name, unit in units.items()), known] for known, of in rows]
    for column in range(len(lines)):
        for upper, lower in [*pairwise(range(column, len(lines)))][::-1]:
            lines[upper], lines[lower] = _turned(lines[upper], lines[lower], column)
    return _upwards(lines)


def _turned(upper: list[Value], lower: list[Value], column: int) -> tuple[list[Value], list[Value]]:
    """Two rows turned so that the lower one has nothing in a column."""
    a, b = upper[column], lower[column]
    if _nothing(b):
        return upper, lower
    if _nothing(a):
        return lower, upper
    length = np.abs(a + 1j * b)
    cos, sin = a / length, b / length
    pairs = [*zip(upper, lower)][column + 1 :]
    done: list[Value] = [0.0] * column
    return (
        [*done, length, *(cos * one + sin * other for one, other in pairs)],
        [*done, 0.0, *(cos * other - sin * one for one, other in pairs)],
    )


def _nothing(value: Value) -> bool:
    """Whether a coefficient is 0 at all positions."""
    known = value if isinstance(value, int | float) else value.number
    return known == 0


def _upwards(lines: Sequence[Sequence[Value]]) -> list[Value]:
    """The unknowns of rows that have nothing before the diagonal, from the last one on."""
    x: dict[int, Value] = {}
    for k in reversed(range(len(lines))):
        rest = lines[k][-1]
        for other, value in x.items():
            rest = rest - lines[k][other] * value
        x[k] = rest / lines[k][k]
    return [x[k] for k in range(len(lines))]
