"""A quantity that keeps a tape: a complex number of which only is known how it comes about."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, ClassVar

import numpy as np

from graphkin.geometry import Value
from graphkin.running.compiled.operations import CannotRecord
from graphkin.running.compiled.tape import Tape


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
