"""What the pencil did, written down: a replay with quantities that only keep a tape.

`record` replays constructions once. Where plain replay has numbers, this one has `Written` quantities: complex numbers
whose two parts are places in a tape. Whatever is done with them, by operators or by NumPy, is entered there. So the
steps stay the one place that says how a mechanism is drawn; `program` reads the tape.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any, ClassVar

import numpy as np

from graphkin.construction.construction import Construction
from graphkin.construction.kinds import Meet, Swing
from graphkin.construction.pencil import Compass, replay
from graphkin.construction.plot import Facts, Plot
from graphkin.geometry import Value, cross, leg, meet_circles, meet_line_circle, meet_lines, third_corner
from graphkin.running.compiled.calculated import fitted, together
from graphkin.running.compiled.operations import CannotRecord
from graphkin.running.compiled.tape import Tape
from graphkin.value import Lazy, frozen


@frozen
class Recording:
    """A replay written down.

    plot   its plot: every value a number, or `Written`
    sides  of the crossings that may be taken either way, as the steps have them, by number of the choice; the tape is
           given the drivers' values, then a side of each of these
    near   what is asked of a position close by, given last: angles by base link, displacements by `slide_key`
    sound  what is above 0 where links that are fitted are found
    """

    tape: Tape
    plot: Plot
    sides: Mapping[int, int]
    near: tuple[str, ...]
    sound: tuple[Written, ...]


def record(constructions: Sequence[Construction], facts: Facts, near: Iterable[str] = ()) -> Recording:
    """Replay position, velocity and acceleration once, for all values of the drivers and all sides of the crossings.

    The drivers' rates and accelerations are numbers: what stands still costs nothing. `near` has what a position close
    by can tell. Raises CannotRecord.
    """
    tape = Tape()
    count = len(facts.values)
    values = tuple(Written(tape, tape.given(k)) for k in range(count))
    meant = {
        step.choice: step.side
        for step in constructions[0].steps
        if isinstance(step, Meet | Swing) and step.choice is not None
    }
    sides = {choice: Written(tape, tape.side(count + k)) for k, choice in enumerate(meant)}
    read: list[str] = []
    sound: list[Written] = []

    def close_by(name: str) -> Value:
        read.append(name)
        return Written(tape, tape.given(count + len(meant) + len(read) - 1))

    plot = Plot(replace(facts, values=values), Lazy(near, close_by))
    compass = replace(WRITING, fit=lambda step, plot: sound.append(fitted(step, plot)))
    for construction in constructions:
        replay(construction, plot, sides if construction.plane == "position" else None, compass)
    return Recording(tape, plot, meant, tuple(read), tuple(sound))


# --- a quantity that keeps a tape -----------------------------------------------------------


class Written:
    """A complex number of which only is known how it comes about: places of its real and its imaginary part."""

    __slots__ = ("imag_at", "real_at", "tape")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, tape: Tape, real_at: int, imag_at: int | None = None) -> None:
        self.tape, self.real_at = tape, real_at
        self.imag_at = tape.number(0.0) if imag_at is None else imag_at

    def _lifted(self, value: Value) -> Written:
        """A number as a quantity of the same tape."""
        if isinstance(value, Written):
            return value
        if np.ndim(value):
            raise CannotRecord("an array")
        number = complex(value)
        return Written(self.tape, self.tape.number(number.real), self.tape.number(number.imag))

    @property
    def real(self) -> Written:
        return Written(self.tape, self.real_at)

    @property
    def imag(self) -> Written:
        return Written(self.tape, self.imag_at)

    @property
    def number(self) -> complex | None:
        """The number that it is, at all positions; None where it is none."""
        x, y = self.tape.number_at(self.real_at), self.tape.number_at(self.imag_at)
        return None if x is None or y is None else complex(x, y)

    @property
    def straight(self) -> bool:
        """Whether one of its parts is a number."""
        return any(self.tape.number_at(part) is not None for part in (self.real_at, self.imag_at))

    @property
    def _is_real(self) -> bool:
        return self.tape.number_at(self.imag_at) == 0

    def __add__(self, other: Value) -> Written:
        do, more = self.tape.add, self._lifted(other)
        return Written(self.tape, do(self.real_at, more.real_at), do(self.imag_at, more.imag_at))

    __radd__ = __add__

    def __sub__(self, other: Value) -> Written:
        do, less = self.tape.subtract, self._lifted(other)
        return Written(self.tape, do(self.real_at, less.real_at), do(self.imag_at, less.imag_at))

    def __rsub__(self, other: Value) -> Written:
        return self._lifted(other) - self

    def __neg__(self) -> Written:
        return Written(self.tape, self.tape.negative(self.real_at), self.tape.negative(self.imag_at))

    def __mul__(self, other: Value) -> Written:
        tape, times = self.tape, self._lifted(other)
        if self._is_real and times._is_real:
            return Written(tape, tape.multiply_numbers(self.real_at, times.real_at))
        (k, a, b), (m, c, d) = self._drawn_out(), times._drawn_out()
        if self._is_real or times._is_real:
            number = tape.multiply(tape.number(k * m), a if self._is_real else c)
            parts = (c, d) if self._is_real else (a, b)
            x, y = (tape.multiply(number, part) for part in parts)
        else:
            for one, arrow in ((self, times), (times, self)):
                if (found := one._along(arrow)) is not None:
                    return found
            x = tape.times(k * m, tape.subtract(tape.multiply(a, c), tape.multiply(b, d)))
            y = tape.times(k * m, tape.add(tape.multiply(a, d), tape.multiply(b, c)))
        if known := times.number:
            tape.know_multiple((x, y), known, (self.real_at, self.imag_at))
        return Written(tape, x, y)

    def _along(self, arrow: Written) -> Written | None:
        """The product with an arrow that is known to lie along this vector's mirror image, or across it."""
        if (known := self.tape.along((arrow.real_at, arrow.imag_at))) is None:
            return None
        times, of = known
        found = self * Written(self.tape, *of)
        straight = self.tape.number_at(found.real_at) == 0 or found._is_real
        return found * Written(self.tape, times) if straight else None

    def _drawn_out(self) -> tuple[float, int, int]:
        """The number that both parts begin with, and these parts."""
        return (1.0, self.real_at, self.imag_at) if self._is_real else self.tape.drawn_out(self.real_at, self.imag_at)

    __rmul__ = __mul__

    def __truediv__(self, other: Value) -> Written:
        tape, by = self.tape, self._lifted(other)
        if self._is_real and by._is_real:
            return Written(tape, tape.divide_numbers(self.real_at, by.real_at))
        if by._is_real:
            return Written(tape, tape.divide(self.real_at, by.real_at), tape.divide(self.imag_at, by.real_at))
        if (known := tape.quotient((self.real_at, self.imag_at), (by.real_at, by.imag_at))) is not None:
            return Written(tape, *known)
        square = (by * by.conjugate()).real_at
        whole = self * by.conjugate()
        return Written(tape, tape.divide(whole.real_at, square), tape.divide(whole.imag_at, square))

    def __rtruediv__(self, other: Value) -> Written:
        return self._lifted(other) / self

    def __pow__(self, power: int) -> Written:
        if power != 2:
            raise CannotRecord(f"the power {power}")
        return self * self

    def conjugate(self) -> Written:
        return Written(self.tape, self.real_at, self.tape.negative(self.imag_at))

    def know_length(self, length: Value) -> None:
        """How long it is, where that was laid off."""
        self.tape.know_length(self.real_at, self.imag_at, self._lifted(length).real_at)

    def know_along(self, times: Value, of: Value) -> None:
        """Of which vector it is so many times."""
        times, of = self._lifted(times), self._lifted(of)
        self.tape.know_along((self.real_at, self.imag_at), times.real_at, (of.real_at, of.imag_at))

    def know_cross(self, other: Written, value: Value) -> None:
        """Its vector product with another one."""
        self.tape.know_cross((self.real_at, self.imag_at), (other.real_at, other.imag_at), self._lifted(value).real_at)

    def know_image(self, first: Value, second: Value, ratio: complex) -> None:
        """That it is the third corner of a triangle whose shape does not change."""
        vectors = ((each.real_at, each.imag_at) for each in (self, self._lifted(first), self._lifted(second)))
        self.tape.know_image(vectors, ratio)

    # --- by NumPy -----------------------------------------------------------------------------

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Value, **more: Any) -> Written:
        do = self.UFUNCS.get(ufunc.__name__)
        if do is None or method != "__call__" or more:
            raise CannotRecord(ufunc.__name__)
        return do(*map(self._lifted, inputs))

    def __array_function__(self, function: Any, types: Any, inputs: Sequence[Value], more: Any) -> Written:
        if function is not np.angle or more or len(inputs) > 1:
            raise CannotRecord(function.__name__)
        return Written(self.tape, self.tape.angle(self.real_at, self.imag_at))

    def __array__(self, *_: Any, **__: Any) -> np.ndarray:
        raise CannotRecord("an array of it")

    def __bool__(self) -> bool:
        raise CannotRecord("a decision")

    def _refused(self, other: Value) -> bool:
        raise CannotRecord("a comparison")

    __lt__ = __le__ = __gt__ = __ge__ = __eq__ = __ne__ = _refused

    def _length(self) -> Written:
        return Written(self.tape, self.tape.length(self.real_at, self.imag_at))

    __abs__ = _length

    def _exponential(self) -> Written:
        if self.tape.number_at(self.real_at) != 0:
            raise CannotRecord("exp of other than i times an angle")
        return Written(self.tape, *self.tape.turned(self.imag_at))

    def _real_only(self) -> int:
        if not self._is_real:
            raise CannotRecord("a vector where a number is wanted")
        return self.real_at

    def _sqrt(self) -> Written:
        return Written(self.tape, self.tape.sqrt(self._real_only()))

    def _sign(self) -> Written:
        return Written(self.tape, self.tape.sign(self._real_only()))

    def _whole(self) -> Written:
        return Written(self.tape, self.tape.whole(self._real_only()))

    def _maximum(self, other: Written) -> Written:
        return Written(self.tape, self.tape.maximum(self._real_only(), other._real_only()))

    UFUNCS: ClassVar[Mapping[str, Callable[..., Written]]] = {
        "add": __add__,
        "subtract": __sub__,
        "multiply": __mul__,
        "divide": __truediv__,
        "negative": __neg__,
        "conjugate": conjugate,
        "absolute": _length,
        "exp": _exponential,
        "sqrt": _sqrt,
        "sign": _sign,
        "rint": _whole,
        "maximum": _maximum,
    }


# --- crossings that can be written down --------------------------------------------------------


def _leg(hypotenuse: Value, other: Value) -> Value:
    """`geometry.leg` as a plain root.

    What that makes of squares below 0 is left to it: their roots fail, and whoever carries the tape out does such
    positions by plain replay.
    """
    if isinstance(hypotenuse, Written) or isinstance(other, Written):
        return np.sqrt(hypotenuse * hypotenuse - other * other)
    return leg(hypotenuse, other)


def _meet_lines(p: Value, u: Value, q: Value, w: Value) -> tuple[Value, Value]:
    """The same crossing; how far it lies along both lines is known where that is measured.

    On a line that is drawn along an axis, one of its coordinates is a number; the other line gives the other sooner.
    """
    point, sine = meet_lines(p, u, q, w)
    if not isinstance(point, Written):
        return point, sine
    start, way, far = p, u, cross(q - p, w) / cross(u, w)
    if isinstance(w, Written) and not isinstance(u, Written):
        times = cross(q - p, u) / cross(u, w)
        if (sooner := q + w * times).straight:
            start, way, far, point = q, w, times, sooner
    (point - start).know_along(far, way)
    return point, sine


def _meet_line_circle(p: Value, u: Value, c: Value, r: Value, side: Value) -> tuple[Value, Value, Value]:
    """The same crossing; the compass has laid its distance from the centre off, and it need not be measured again."""
    found = meet_line_circle(p, u, c, r, side, _leg)
    _know_length(found[0] - c, r)
    return found


def _meet_circles(c1: Value, r1: Value, c2: Value, r2: Value, side: Value) -> tuple[Value, Value, Value]:
    """The same crossing; nor need the area between its arms."""
    point, sine, miss = meet_circles(c1, r1, c2, r2, side, _leg)
    arm, other = point - c1, point - c2
    _know_length(arm, r1)
    _know_length(other, r2)
    if isinstance(arm, Written) and isinstance(other, Written):
        arm.know_cross(other, side * sine * r1 * r2)
    return point, sine, miss


def _image(first: Value, second: Value, ratio: Value) -> Value:
    """The same corner; it may be found with the vectors as wholes."""
    found = third_corner(first, second, ratio)
    number = ratio.number if isinstance(ratio, Written) else complex(ratio)
    if number is not None and isinstance(found, Written):
        found.know_image(first, second, number)
    return found


def _know_length(arm: Value, length: Value) -> None:
    if isinstance(arm, Written):
        arm.know_length(length)


WRITING = Compass(_leg, _meet_lines, _meet_line_circle, _meet_circles, _image, together=together)
