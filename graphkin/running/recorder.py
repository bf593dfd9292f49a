"""A replay with quantities that note on a tape what is done with them: steps say how a mechanism is drawn, once.

Calculated positions and rates are noted, too: links tried until they fit, chains of arrows closed at once. From close
by, two steps of Newton's method come to the last digit. Where the second is not as short as that asks for, a position
is replayed plainly, as where a division fails.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields, replace
from functools import partial
from itertools import pairwise
from typing import ClassVar, TypeAlias, Union, cast

import numpy as np

from graphkin.base.geometry import Real, Value, leg, meet_circles, meet_line_circle, meet_lines
from graphkin.base.value import Lazy, frozen
from graphkin.construction import Construction, Facts, Plane, Plot, kinds, replay, slide_key, unknowns_of
from graphkin.construction.fitting import reach, settle_all
from graphkin.construction.linear import Row, chains, in_step, settle_rates, two
from graphkin.construction.pencil import Compass
from graphkin.construction.plot import within_a_turn
from graphkin.construction.terms import Arm, Slid
from graphkin.running.tape import CannotRecord, Tape

TABLES = tuple(each.name for each in fields(Plot) if each.name not in ("facts", "near", "follows"))
"""The tables of a plot."""
Entry = tuple[str, str]  # a table of a plot, or "turn", and a name in it (a plane and a point in that of sines)
Quantity: TypeAlias = Union[Value, "Recorded"]
STEPS = 2
SHORT = 1e-7  # the last step at most [rad, of the group's size]; what it leaves is of the order of its square


def _real(does: str, *of: Recorded) -> Recorded:
    """A function of real numbers."""
    if any(each.y != each.tape.zero for each in of):
        raise CannotRecord("a vector where a number belongs")
    return Recorded(of[0].tape, of[0].tape.done(does, *(each.x for each in of)))


class Recorded:
    """A complex number of which only is known how it comes about: places of its real and its imaginary part."""

    __slots__ = ("tape", "x", "y")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, tape: Tape, x: int, y: int | None = None) -> None:
        self.tape, self.x, self.y = tape, x, tape.zero if y is None else y

    def lifted(self, value: Quantity) -> Recorded:
        """A number as a quantity of the same tape."""
        if isinstance(value, Recorded):
            return value
        if np.ndim(value):
            raise CannotRecord("an array")
        number = complex(value)
        return Recorded(self.tape, self.tape.number(number.real), self.tape.number(number.imag))

    @property
    def real(self) -> Recorded:
        return Recorded(self.tape, self.x)

    @property
    def imag(self) -> Recorded:
        return Recorded(self.tape, self.y)

    @property
    def number(self) -> complex | None:
        """The number that it is at all positions; None where it is none."""
        x, y = self.tape.number_at(self.x), self.tape.number_at(self.y)
        return None if x is None or y is None else complex(x, y)

    def __add__(self, other: Quantity) -> Recorded:
        do, more = self.tape.add, self.lifted(other)
        return Recorded(self.tape, do(self.x, more.x), do(self.y, more.y))

    __radd__ = __add__

    def __sub__(self, other: Quantity) -> Recorded:
        do, less = self.tape.subtract, self.lifted(other)
        return Recorded(self.tape, do(self.x, less.x), do(self.y, less.y))

    def __rsub__(self, other: Quantity) -> Recorded:
        return self.lifted(other) - self

    def __neg__(self) -> Recorded:
        return Recorded(self.tape, self.tape.negative(self.x), self.tape.negative(self.y))

    def __mul__(self, other: Quantity) -> Recorded:
        do, times, by = self.tape, self.tape.multiply, self.lifted(other)
        x = do.subtract(times(self.x, by.x), times(self.y, by.y))
        return Recorded(do, x, do.add(times(self.x, by.y), times(self.y, by.x)))

    __rmul__ = __mul__

    def __truediv__(self, other: Quantity) -> Recorded:
        do, by = self.tape, self.lifted(other)
        if by.y == do.zero:
            return Recorded(do, do.divide(self.x, by.x), do.divide(self.y, by.x))
        return self * by.conjugate() / (by * by.conjugate())

    def __rtruediv__(self, other: Quantity) -> Recorded:
        return self.lifted(other) / self

    def __pow__(self, power: int) -> Recorded:
        if power != 2:
            raise CannotRecord(f"the power {power}")
        return self * self

    def conjugate(self) -> Recorded:
        return Recorded(self.tape, self.x, self.tape.negative(self.y))

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *operands: Quantity, **more: object) -> Recorded:
        do = self.UFUNCS.get(ufunc.__name__)
        if do is None or method != "__call__" or more:
            raise CannotRecord(ufunc.__name__)
        return do(*map(self.lifted, operands))

    def __array_function__(
        self, function: Callable[..., object], types: object, operands: Sequence[Quantity], more: object
    ) -> Recorded:
        if function is not np.angle or more or len(operands) > 1:
            raise CannotRecord(function.__name__)
        return Recorded(self.tape, self.tape.done("arctan2", self.y, self.x))

    def __array__(self, *_: object, **__: object) -> np.ndarray:
        raise CannotRecord("an array of it")

    def __bool__(self) -> bool:
        raise CannotRecord("a decision")

    def _refused(self, other: object) -> bool:
        raise CannotRecord("a comparison")

    __lt__ = __le__ = __gt__ = __ge__ = __eq__ = __ne__ = _refused

    def __abs__(self) -> Recorded:
        return Recorded(self.tape, self.tape.length(self.x, self.y))

    def _exponential(self) -> Recorded:
        if self.x != self.tape.zero:
            raise CannotRecord("exp of other than i times an angle")
        return Recorded(self.tape, *self.tape.turned(self.y))

    UFUNCS: ClassVar[Mapping[str, Callable[..., Recorded]]] = {
        "add": __add__,
        "subtract": __sub__,
        "multiply": __mul__,
        "divide": __truediv__,
        "negative": __neg__,
        "conjugate": conjugate,
        "absolute": __abs__,
        "exp": _exponential,
        **{name: partial(_real, name) for name in ("sqrt", "sign", "floor", "rint", "maximum")},
    }


# --- a replay that is recorded ----------------------------------------------------------------


@frozen
class Recording:
    """A replay noted on a tape.

    tables of its plot, every value a number or `Recorded`; and "turn": angles of links between 0 and a full turn
    sides  of the crossings that may be taken either way, as the steps have them, by number of the choice; the tape's
           inputs are the drivers' values, a side of each of these, then what dimensions hang on
    near   what is asked of a position close by, the last inputs: angles by base link, displacements by `slide_key`
    inputs how many there are
    sure   the least of the sines of all crossings, and of what is above 0 where links that are fitted are found
    """

    tape: Tape
    tables: Mapping[str, Mapping[str, Quantity | GroupSense]]
    sides: Mapping[int, int]
    near: tuple[str, ...]
    inputs: int
    sure: int


FactsOf = Callable[[Sequence[Real]], Facts]
"""Facts by the numbers that dimensions and speeds hang on, which may be `Recorded`."""


def record(
    constructions: Sequence[Construction], facts: FactsOf, drivers: int, numbers: int = 0, near: Iterable[str] = ()
) -> Recording:
    """Replay position, velocity and acceleration once, for all values of the drivers, all sides of the crossings, and
    so many numbers on which the facts hang. What else the facts have are numbers: what stands still costs nothing.
    `near` names what a position close by has. Raises CannotRecord."""
    tape, inputs, read, fits = Tape(), list[int](), list[str](), list[Quantity]()

    def one_more() -> Real:
        """An input of the tape, in the place of a number."""
        inputs.append(tape.input(len(inputs)))
        return cast(Real, Recorded(tape, inputs[-1]))

    def close_by(name: str) -> Real:
        read.append(name)
        return one_more()

    def together(step: kinds.Simultaneous, plot: Plot, plane: Plane) -> None:
        rows = [(-known, coefficients) for known, coefficients in chains(step, plot, plane)]
        settle_rates(step, plot, plane, solved(rows, dict.fromkeys(unknowns_of(step), 1.0)))

    values = tuple(one_more() for _ in range(drivers))
    choices = [step for step in constructions[0].steps if isinstance(step, kinds.Meet | kinds.Swing)]
    usual = {step.choice: step.side for step in choices if step.choice is not None}
    sides = {choice: one_more() for choice in usual}
    plot = Plot(replace(facts([one_more() for _ in range(numbers)]), values=values), Lazy(near, close_by))
    compass = replace(COMPASS, fit=lambda step, plot: fits.append(_fitted(step, plot)), together=together)
    for construction in constructions:
        replay(construction, plot, sides if construction.plane == "position" else None, compass)
    sure = tape.one
    for value in (*plot.sines.values(), *fits):
        if isinstance(value, Recorded):
            sure = tape.done("minimum", sure, value.x)
    tables = {table: getattr(plot, table) for table in TABLES}
    tables["turn"] = {link: within_a_turn(angle) for link, angle in plot.theta.items()}
    return Recording(tape, tables, usual, tuple(read), len(inputs), sure)


def _leg(hypotenuse: Real, other: Real) -> Real:
    """`geometry.leg` as a plain root: it fails where that rounds squares to 0, and such positions are replayed."""
    if isinstance(hypotenuse, Recorded) or isinstance(other, Recorded):
        return cast(Real, np.sqrt(hypotenuse * hypotenuse - other * other))
    return leg(hypotenuse, other)


COMPASS = Compass(
    _leg, partial(meet_lines, known=lambda sine: sine),  # what is flat is replayed plainly
    partial(meet_line_circle, leg=_leg), partial(meet_circles, leg=_leg),
)  # fmt: skip


# --- links that are fitted --------------------------------------------------------------------


@frozen
class GroupSense:
    """A group's sense (0) or its sine (1), which is calculated from the finished plot when it is read."""

    step: kinds.Fit
    which: int


def _fitted(step: kinds.Fit, plot: Plot) -> Quantity:
    """Settle a group's unknowns; the result is above 0 where they converge, 1 at best."""
    x = [plot.near[name] for name in unknowns_of(step)]
    units = [1.0] * len(step.angles) + [reach(step, plot)] * len(step.slides)  # 1 rad, or the group's size [m]
    for _ in range(STEPS):
        settle_all(step, plot, x)
        rows = [row for closure in step.closures for row in two(*_closure(closure, plot))]
        for contact in step.contacts:
            gap, _ = in_step(contact, plot, "position", set(), set())
            rows.append((gap, in_step(contact, plot, "position", set(step.angles), set(step.slides))[1]))
        change = solved(rows, dict(zip(unknowns_of(step), units)))
        x = [value - part * unit for value, part, unit in zip(x, change, units)]
    settle_all(step, plot, x)
    sense, sine = (cast(Real, GroupSense(step, which)) for which in (0, 1))
    plot.senses[step.name], plot.sines["position", step.name] = sense, sine
    plot.misses[step.name] = 0.0
    longest = np.abs(change[0])
    for part in change[1:]:
        longest = np.maximum(longest, np.abs(part))
    return 1.0 - longest / SHORT


def _closure(closure: kinds.Closure, plot: Plot) -> Row:
    """The gap of a closed chain of arms and displacements, and its slope for each unknown [m]."""
    gap = 0.0 if closure.floats else plot.position[closure.start] - plot.position[closure.end]
    slopes: dict[str, Value] = {}
    for part in closure.parts:
        if isinstance(part, Arm):
            shape, link = plot.facts.shapes[part.link], part.link
            arrow: Value = (shape[part.head] - shape[part.tail]) * np.exp(1j * plot.theta[link])
        else:
            link = plot.facts.lines[part.slide][0]
            arrow = part.sign * plot.s[part.slide] * plot.guide_direction(part.slide)
        base = plot.facts.turns[link].base
        gap = gap + arrow
        slopes[base] = slopes.get(base, 0.0) + 1j * arrow
        if isinstance(part, Slid):
            slopes[slide_key(part.slide)] = part.sign * plot.guide_direction(part.slide)
    return gap, slopes


def solved(rows: Sequence[Row], units: Mapping[str, float]) -> list[Value]:
    """x, in units, of which each row's coefficients times x give what the row knows. Rows are turned in pairs, each
    time so that a coefficient becomes 0: nothing grows, and none has to be chosen by its size, which a tape does not
    know."""
    if len(rows) != len(units):
        raise CannotRecord("more equations than unknowns")
    lines = [[*(of.get(name, 0.0) * unit for name, unit in units.items()), known] for known, of in rows]
    for column in range(len(lines)):
        for upper, lower in [*pairwise(range(column, len(lines)))][::-1]:
            lines[upper], lines[lower] = _rotated(lines[upper], lines[lower], column)
    x: dict[int, Value] = {}
    for k in reversed(range(len(lines))):
        rest = lines[k][-1]
        for other, value in x.items():
            rest = rest - lines[k][other] * value
        x[k] = rest / lines[k][k]
    return [x[k] for k in range(len(lines))]


def _rotated(upper: list[Value], lower: list[Value], column: int) -> tuple[list[Value], list[Value]]:
    """Two rows rotated so that the lower one has nothing in a column."""
    a, b = upper[column], lower[column]
    if _is_zero(b):
        return upper, lower
    if _is_zero(a):
        return lower, upper
    length = np.abs(a + 1j * b)
    cos, sin = a / length, b / length
    pairs = [*zip(upper, lower)][column + 1 :]
    done: list[Value] = [0.0] * column
    return ([*done, length, *(cos * one + sin * other for one, other in pairs)],
            [*done, 0.0, *(cos * other - sin * one for one, other in pairs)])  # fmt: skip


def _is_zero(value: Quantity) -> bool:
    """True if a coefficient is 0 at all positions."""
    return bool((value.number if isinstance(value, Recorded) else value) == 0)
