"""A replay with quantities that note on a tape what is done with them: steps say how a mechanism is drawn, once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields, replace
from functools import partial
from typing import Any, ClassVar

import numpy as np

from graphkin.base.geometry import Value, leg, meet_circles, meet_line_circle
from graphkin.base.value import Lazy, frozen
from graphkin.construction.construction import Construction
from graphkin.construction.kinds import Meet, Swing
from graphkin.construction.pencil import Compass, replay
from graphkin.construction.plot import Facts, Plot, within_a_turn
from graphkin.running.program.fitting import fitted, together
from graphkin.running.program.tape import CannotRecord, Tape

TABLES = tuple(each.name for each in fields(Plot) if each.name not in ("facts", "near", "follows"))
"""What a plot holds."""
Entry = tuple[str, Any]
"""A table of a plot, or "turn", and a name in it."""


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

    def lifted(self, value: Value) -> Recorded:
        """A number as a quantity of the same tape."""
        if isinstance(value, Recorded):
            return value
        if np.ndim(value):
            raise CannotRecord("an array")
        return Recorded(self.tape, self.tape.number(np.real(value)), self.tape.number(np.imag(value)))

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

    def __add__(self, other: Value) -> Recorded:
        do, more = self.tape.add, self.lifted(other)
        return Recorded(self.tape, do(self.x, more.x), do(self.y, more.y))

    __radd__ = __add__

    def __sub__(self, other: Value) -> Recorded:
        do, less = self.tape.subtract, self.lifted(other)
        return Recorded(self.tape, do(self.x, less.x), do(self.y, less.y))

    def __rsub__(self, other: Value) -> Recorded:
        return self.lifted(other) - self

    def __neg__(self) -> Recorded:
        return Recorded(self.tape, self.tape.negative(self.x), self.tape.negative(self.y))

    def __mul__(self, other: Value) -> Recorded:
        do, times, by = self.tape, self.tape.multiply, self.lifted(other)
        x = do.subtract(times(self.x, by.x), times(self.y, by.y))
        return Recorded(do, x, do.add(times(self.x, by.y), times(self.y, by.x)))

    __rmul__ = __mul__

    def __truediv__(self, other: Value) -> Recorded:
        do, by = self.tape, self.lifted(other)
        if by.y == do.zero:
            return Recorded(do, do.divide(self.x, by.x), do.divide(self.y, by.x))
        return self * by.conjugate() / (by * by.conjugate())

    def __rtruediv__(self, other: Value) -> Recorded:
        return self.lifted(other) / self

    def __pow__(self, power: int) -> Recorded:
        if power != 2:
            raise CannotRecord(f"the power {power}")
        return self * self

    def conjugate(self) -> Recorded:
        return Recorded(self.tape, self.x, self.tape.negative(self.y))

    # --- by NumPy -----------------------------------------------------------------------------

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *operands: Value, **more: Any) -> Recorded:
        do = self.UFUNCS.get(ufunc.__name__)
        if do is None or method != "__call__" or more:
            raise CannotRecord(ufunc.__name__)
        return do(*map(self.lifted, operands))

    def __array_function__(self, function: Any, types: Any, operands: Sequence[Value], more: Any) -> Recorded:
        if function is not np.angle or more or len(operands) > 1:
            raise CannotRecord(function.__name__)
        return Recorded(self.tape, self.tape.done("arctan2", self.y, self.x))

    def __array__(self, *_: Any, **__: Any) -> np.ndarray:
        raise CannotRecord("an array of it")

    def __bool__(self) -> bool:
        raise CannotRecord("a decision")

    def _refused(self, other: Value) -> bool:
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
           inputs are the drivers' values, then a side of each of these
    near   what is asked of a position close by, the last inputs: angles by base link, displacements by `slide_key`
    inputs how many there are
    sure   the least of the sines of all crossings, and of what is above 0 where links that are fitted are found
    """

    tape: Tape
    tables: Mapping[str, Mapping[Any, Value]]
    sides: Mapping[int, int]
    near: tuple[str, ...]
    inputs: int
    sure: int


def record(constructions: Sequence[Construction], facts: Facts, near: Iterable[str] = ()) -> Recording:
    """Replay position, velocity and acceleration once, for all values of the drivers and all sides of the crossings.

    The drivers' rates and accelerations are numbers: what stands still costs nothing. `near` names what a position
    close by has. Raises CannotRecord.
    """
    tape = Tape()
    count = len(facts.values)
    values = tuple(Recorded(tape, tape.input(k)) for k in range(count))
    choices = [step for step in constructions[0].steps if isinstance(step, Meet | Swing)]
    usual = {step.choice: step.side for step in choices if step.choice is not None}
    sides = {choice: Recorded(tape, tape.input(count + k)) for k, choice in enumerate(usual)}
    read: list[str] = []
    fits: list[Recorded] = []

    def close_by(name: str) -> Value:
        read.append(name)
        return Recorded(tape, tape.input(count + len(usual) + len(read) - 1))

    plot = Plot(replace(facts, values=values), Lazy(near, close_by))
    compass = replace(COMPASS, fit=lambda step, plot: fits.append(fitted(step, plot)), together=together)
    for construction in constructions:
        replay(construction, plot, sides if construction.plane == "position" else None, compass)
    sure = tape.one
    for value in (*plot.sines.values(), *fits):
        if isinstance(value, Recorded):
            sure = tape.done("minimum", sure, value.x)
    tables = {table: getattr(plot, table) for table in TABLES}
    tables["turn"] = {link: within_a_turn(angle) for link, angle in plot.theta.items()}
    return Recording(tape, tables, usual, tuple(read), count + len(usual) + len(read), sure)


def _leg(hypotenuse: Value, other: Value) -> Value:
    """`geometry.leg` as a plain root: it fails where that rounds squares to 0, and such positions are replayed."""
    if isinstance(hypotenuse, Recorded) or isinstance(other, Recorded):
        return np.sqrt(hypotenuse * hypotenuse - other * other)
    return leg(hypotenuse, other)


def _meet_line_circle(p: Value, u: Value, c: Value, r: Value, side: Value) -> tuple[Value, Value, Value]:
    """The same crossing, whose distance from the centre is known."""
    crossing = meet_line_circle(p, u, c, r, side, _leg)
    _know_length(crossing[0] - c, r)
    return crossing


def _meet_circles(c1: Value, r1: Value, c2: Value, r2: Value, side: Value) -> tuple[Value, Value, Value]:
    """The same crossing, whose distances from both centres are known."""
    crossing = meet_circles(c1, r1, c2, r2, side, _leg)
    _know_length(crossing[0] - c1, r1)
    _know_length(crossing[0] - c2, r2)
    return crossing


def _know_length(arm: Value, length: Value) -> None:
    if isinstance(arm, Recorded):
        arm.tape.know_length(arm.x, arm.y, arm.lifted(length).x)


COMPASS = Compass(_leg, line_circle=_meet_line_circle, circles=_meet_circles)
