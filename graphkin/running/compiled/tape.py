"""A tape of real operations: each is entered once, and simplified as far as algebra goes.

An operation is a number, a given quantity, a side (1 or -1), or what one NumPy function makes of those before it; it is
spoken of by its place on the tape. What is found here holds for all numbers but those at which a division or a root
fails: `risky` operations are never crossed out, so that whoever carries the tape out sees where that happens.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from graphkin.running.compiled.operations import Operation
from graphkin.running.compiled.products import Powers, Products, together

Signed = tuple[int, int]
"""A place, and the sign with which it is meant."""
Parts = tuple[Signed, Signed]
"""Those of a vector."""


class Tape(Products):
    """Each method enters an operation, and gives the place of its result."""

    def __init__(self) -> None:
        super().__init__()
        self._straight: dict[int, int] = {}
        self._sums: dict[tuple[int, int], int] = {}
        self._differences: dict[tuple[int, int], int] = {}
        self._lengths: dict[frozenset[tuple[tuple[int, int], ...]], tuple[float, Powers]] = {}
        self._multiples: dict[tuple[int, int], tuple[complex, tuple[int, int]]] = {}
        self.images: dict[Parts, tuple[Parts, Parts, complex]] = {}
        """Vectors that are third corners of triangles, the other two, and the ratio of the sides."""
        self._along: dict[tuple[int, int], tuple[int, tuple[int, int]]] = {}

    # --- sums -------------------------------------------------------------------------------------

    def add(self, a: int, b: int) -> int:
        key = (a, b) if a < b else (b, a)
        if (found := self._sums.get(key)) is None:
            found = self._sums[key] = self._added(a, b)
        return found

    def subtract(self, a: int, b: int) -> int:
        """b - a is entered as the negative of a - b: both are met in one drawing, one is enough."""
        if (found := self._differences.get((a, b))) is None:
            found = self._differences[a, b] = self._subtracted(a, b)
        return found

    def _added(self, a: int, b: int) -> int:
        for one, other in ((a, b), (b, a)):
            if self.number_at(one) == 0:
                return other
            if (inside := self._inside(one, "negative")) is not None:
                return self.subtract(other, inside)
            if (rest := self._with(one, other)) is not None:
                return rest
        found = self._drawn_together(a, b, 1)
        return self._done("add", min(a, b), max(a, b)) if found is None else found

    def _subtracted(self, a: int, b: int) -> int:
        if a == b:
            return self.number(0.0)
        if self.number_at(a) == 0:
            return self.negative(b)
        if (number := self.number_at(b)) is not None:
            return self.add(a, self.number(-number))
        if (inside := self._inside(b, "negative")) is not None:
            return self.add(a, inside)
        if (inside := self._inside(a, "negative")) is not None:
            return self.negative(self.add(inside, b))
        for whole, part, sign in ((a, b, 1), (b, a, -1)):
            if (rest := self._left_over(whole, part)) is not None:
                return rest if sign > 0 else self.negative(rest)
        if self.number_at(a) is not None or a > b:
            return self.negative(self.subtract(b, a))
        found = self._drawn_together(a, b, -1)
        return self._done("subtract", a, b) if found is None else found

    def _with(self, one: int, other: int) -> int | None:
        """one + (x - one) is x; the numbers of two sums are drawn together."""
        operation, number = self.operations[other], self.number_at(one)
        if operation.does == "subtract" and operation.of[1] == one:
            return operation.of[0]
        if number is not None and operation.does == "add":
            for first, second in (operation.of, operation.of[::-1]):
                if (more := self.number_at(first)) is not None:
                    return self.add(second, self.number(number + more))
        return None

    def _left_over(self, whole: int, part: int) -> int | None:
        """(x + part) - part is x, and (part - x) - part is -x."""
        if (rest := self._beside("add", part, whole)) is not None:
            return rest
        operation = self.operations[whole]
        return self.negative(operation.of[1]) if operation.does == "subtract" and operation.of[0] == part else None

    def _drawn_together(self, a: int, b: int, sign: int) -> int | None:
        """x y + x y is 2 x y; x u u + x v v is x times the square of a length that is known."""
        (number, one), (more, other) = self.scaled(a), self.scaled(b)
        powers, others = self.factored(one), self.factored(other)
        if powers == others:
            return self.times(number + sign * more, one)
        if sign * more != number:
            return None
        common = _common(powers, others)
        rests = together(powers, common, -1), together(others, common, -1)
        if any(power % 2 for rest in rests for power in rest.values()):
            return None
        known = self._lengths.get(frozenset(_key(rest, 2) for rest in rests))
        if known is None:
            return None
        length, rest = known
        return self.times(number * length**2, self.product(together(common, rest, 2)))

    # --- lengths and signs ------------------------------------------------------------------------

    def sqrt(self, a: int) -> int:
        number, rest = self.scaled(a)
        if number < 0 or rest == self.one:
            return self._done("sqrt", a)
        return self.times(math.sqrt(number), self._done("sqrt", rest))

    def length(self, x: int, y: int) -> int:
        """Of a vector; squares are quicker than `hypot` and lengths of mechanisms don't overflow."""
        if self.number_at(y) == 0:
            return self.absolute(x)
        if self.number_at(x) == 0:
            return self.absolute(y)
        number, x, y = self.drawn_out(x, y)
        found = self.sqrt(self.add(self.multiply(x, x), self.multiply(y, y)))
        self.know_length(x, y, found)
        return self.times(number, found)

    def know_length(self, x: int, y: int, length: int) -> None:
        """A length that a compass has laid off: it will not be measured again."""
        number, x, y = self.drawn_out(self.unsigned(x)[0], self.unsigned(y)[0])
        (size, rest), powers, others = self.scaled(length), self.factored(x), self.factored(y)
        common = _common(powers, others)
        key = frozenset(_key(together(each, common, -1)) for each in (powers, others))
        self._lengths.setdefault(key, (size / number, together(self.factored(rest), common, -1)))

    def know_multiple(self, vector: tuple[int, int], times: complex, of: tuple[int, int]) -> None:
        """A vector that is another one turned and stretched by numbers."""
        self._multiples[vector] = times, of

    def know_along(self, vector: tuple[int, int], times: int, of: tuple[int, int]) -> None:
        """A vector that is another one stretched, and its opposite."""
        x, y = vector
        self._along.setdefault(vector, (times, of))
        self._along.setdefault((self.negative(x), self.negative(y)), (self.negative(times), of))

    def along(self, vector: tuple[int, int]) -> tuple[int, tuple[int, int]] | None:
        """What it is known to be: so many times another vector."""
        return self._along.get(vector)

    def know_cross(self, a: tuple[int, int], b: tuple[int, int], value: int) -> None:
        """The vector product of two vectors."""
        (one, sign), (other, second) = (self.unsigned(self.multiply(a[k], b[1 - k])) for k in range(2))
        value = value if sign > 0 else self.negative(value)
        if sign == second:
            self._differences.setdefault((one, other), value)
            self._differences.setdefault((other, one), self.negative(value))
        else:
            self._sums.setdefault((min(one, other), max(one, other)), value)

    def know_image(self, corners: Iterable[tuple[int, int]], ratio: complex) -> None:
        """A vector that is the third corner of a triangle, told before the first two."""
        third, first, second = ((self.unsigned(x), self.unsigned(y)) for x, y in corners)
        self.images.setdefault(third, (first, second, ratio))

    def quotient(self, a: tuple[int, int], b: tuple[int, int]) -> tuple[int, int] | None:
        """A vector divided by another along which it lies, or of which it is a known multiple; None where it is not."""
        times, of = self._multiples.get(a, (0j, None))
        if of == b:
            return self.number(times.real), self.number(times.imag)
        (number, *ours), (by, *theirs) = self.drawn_out(*a), self.drawn_out(*b)
        signs, powers = zip(*(self._share(one, other) for one, other in zip(ours, theirs)))
        if powers[0] != powers[1] or signs[0] != signs[1]:
            return None
        return self.times(signs[0] * number / by, self.product(powers[0])), self.number(0.0)

    def _share(self, a: int, b: int) -> tuple[int, Powers]:
        (a, sign), (b, other) = self.unsigned(a), self.unsigned(b)
        return sign * other, together(self.factored(a), self.factored(b), -1)

    def absolute(self, a: int) -> int:
        """A product of roots, and of squares, is its own."""
        number, rest = self.scaled(a)
        bare = self._bare(rest)
        kinds = {self.operations[factor].does for factor, power in self.factored(bare).items() if power % 2}
        if bare != self.one and kinds - {"sqrt"}:
            return self._done("absolute", self._bare(a))
        return self.times(abs(number), bare)

    def sign(self, a: int) -> int:
        return self._done("sign", a)

    def whole(self, a: int) -> int:
        """The nearest whole number."""
        return self._done("rint", a)

    def maximum(self, a: int, b: int) -> int:
        return self._done("maximum", min(a, b), max(a, b))

    # --- angles -----------------------------------------------------------------------------------

    def angle(self, x: int, y: int) -> int:
        """Of a vector, from -pi to pi; of a length with a side along x it is 0 or pi."""
        side, length = self._sides(x)
        if self.number_at(y) == 0 and side != self.one and self.operations[length].does == "sqrt":
            found = self.multiply(self.number(math.pi / 2), self.subtract(self.one, side))
            self._straight[self.unsigned(found)[0]] = side
            return found
        return self._done("arctan2", y, x)

    def turned(self, angle: int) -> tuple[int, int]:
        """Cosine and sine. Of an angle that was measured they are quotients of lengths: no angle is needed for them."""
        operation = self.operations[angle]
        if angle in self._straight:
            return self._straight[angle], self.number(0.0)
        match operation.does:
            case "given":
                return self._half_tangent(angle)
            case "arctan2":
                y, x = operation.of
                length = self.length(x, y)
                return self.divide(x, length), self.divide(y, length)
            case "negative":
                cos, sin = self.turned(operation.of[0])
                return cos, self.negative(sin)
            case "add" | "subtract":
                return self._turned_further(operation)
            case _:
                return self._done("cos", angle), self._done("sin", angle)

    def _half_tangent(self, angle: int) -> tuple[int, int]:
        """Cosine and sine from t = tan(angle / 2): 2 / (1 + t^2) - 1 and 2 t / (1 + t^2).

        Where NumPy vectorises its tangent of doubles (AVX-512), one tangent takes a sixth of the time of a cosine and a
        sine; elsewhere it takes about as long as they. The tangent's relative error comes out as an absolute one of at
        most 4e-16, for large t as well, where what it is multiplied by falls off with its square.
        """
        tangent = self._done("tan", self.multiply(angle, self.number(0.5)))
        square = self.add(self.multiply(tangent, tangent), self.number(1.0))
        twice = self.divide(self.number(2.0), square)
        return self.subtract(twice, self.number(1.0)), self.multiply(tangent, twice)

    def _turned_further(self, operation: Operation) -> tuple[int, int]:
        """Of a sum or difference of angles."""
        (cos, sin), (more_cos, more_sin) = (self.turned(place) for place in operation.of)
        if operation.does == "subtract":
            more_sin = self.negative(more_sin)
        return (
            self.subtract(self.multiply(cos, more_cos), self.multiply(sin, more_sin)),
            self.add(self.multiply(sin, more_cos), self.multiply(cos, more_sin)),
        )


def _common(powers: Powers, others: Powers) -> Powers:
    """The factors that two products share."""
    shared = {factor: (power, others[factor]) for factor, power in powers.items() if power * others.get(factor, 0) > 0}
    return {factor: min(pair, key=abs) for factor, pair in shared.items()}


def _key(powers: Powers, root: int = 1) -> tuple[tuple[int, int], ...]:
    """Powers as a name, or those of the root."""
    return tuple(sorted((factor, power // root) for factor, power in powers.items()))
