"""A tape of real operations: each is entered once, and simplified as far as algebra goes.

An operation is a number, a given quantity, a side (1 or -1), or what one NumPy function makes of those before it; it is
spoken of by its place on the tape. What is found here holds for all numbers but those at which a division or a root
fails: `risky` operations are never crossed out, so that whoever carries the tape out sees where that happens.
"""

from __future__ import annotations

from graphkin.running.compiled.operations import SIDE, Operation, Operations


class Tape(Operations):
    """Each method enters an operation, and gives the place of its result."""

    def __init__(self) -> None:
        super().__init__()
        self._lengths: dict[frozenset[int], int] = {}

    # --- sums -------------------------------------------------------------------------------------

    def add(self, a: int, b: int) -> int:
        for one, other in ((a, b), (b, a)):
            if self.number_at(one) == 0:
                return other
            if (inside := self._inside(one, "negative")) is not None:
                return self.subtract(other, inside)
        square = self._known_square(a, b)
        return self._done("add", min(a, b), max(a, b)) if square is None else square

    def subtract(self, a: int, b: int) -> int:
        """b - a is entered as the negative of a - b: both are met in one drawing, one is enough."""
        if self.number_at(b) == 0:
            return a
        if self.number_at(a) == 0:
            return self.negative(b)
        if a == b:
            return self.number(0.0)
        if (rest := self._beside("add", b, a)) is not None:
            return rest
        if (rest := self._beside("add", a, b)) is not None:
            return self.negative(rest)
        if (inside := self._inside(b, "negative")) is not None:
            return self.add(a, inside)
        if (inside := self._inside(a, "negative")) is not None:
            return self.negative(self.add(inside, b))
        return self._done("subtract", a, b) if a < b else self.negative(self._done("subtract", b, a))

    def negative(self, a: int) -> int:
        if (inside := self._inside(a, "negative")) is not None:
            return inside
        return self._done("negative", a)

    def unsigned(self, place: int) -> tuple[int, int]:
        """What a place is the negative of, and -1; else itself, and 1."""
        inside = self._inside(place, "negative")
        return (place, 1) if inside is None else (inside, -1)

    # --- products ---------------------------------------------------------------------------------

    def multiply(self, a: int, b: int) -> int:
        for one, other in ((a, b), (b, a)):
            found = self._by_number(one, other)
            if found is None and (inside := self._inside(one, "negative")) is not None:
                found = self.negative(self.multiply(inside, other))
            if found is None:
                found = self._cancelled(one, other)
            if found is not None:
                return found
        if a == b:
            a = b = self._bare(a)
        return self._done("multiply", min(a, b), max(a, b))

    def _by_number(self, one: int, other: int) -> int | None:
        """A product with 0, 1 or -1; numbers of two factors are drawn together."""
        number, factors = self.number_at(one), self.operations[other]
        if number == 0:
            return one
        if number in (1.0, -1.0):
            return other if number == 1 else self.negative(other)
        if number is not None and factors.does == "multiply":
            for first, second in (factors.of, factors.of[::-1]):
                if (more := self.number_at(first)) is not None:
                    return self.multiply(self.number(number * more), second)
        return None

    def _cancelled(self, one: int, other: int) -> int | None:
        """(1/d) d is 1, (1/d) (d x) is x, so it is with a side for 1/d; and a root times itself is its square."""
        if one == other and (square := self._inside(one, "sqrt")) is not None:
            return square
        divisor = one if self.operations[one].does == SIDE else self._inside(one, "reciprocal")
        if divisor is None:
            return None
        return self.number(1.0) if divisor == other else self._beside("multiply", divisor, other)

    def _side_of(self, product: int) -> tuple[int, int] | None:
        """The side and the other factor, where a side is one of two factors."""
        operation = self.operations[product]
        sides = [of for of in operation.of if self.operations[of].does == SIDE] if operation.does == "multiply" else []
        return (sides[0], operation.of[1 - operation.of.index(sides[0])]) if sides else None

    def _bare(self, a: int) -> int:
        """What is as long, where a sign makes no difference."""
        for does in ("absolute", "negative"):
            if (inside := self._inside(a, does)) is not None:
                return inside
        found = self._side_of(a)
        return a if found is None else found[1]

    def divide(self, a: int, b: int) -> int:
        return self.multiply(a, self.reciprocal(b))

    def reciprocal(self, a: int) -> int:
        if (inside := self._inside(a, "negative")) is not None:
            return self.negative(self.reciprocal(inside))
        if (found := self._side_of(a)) is not None:
            return self.multiply(found[0], self.reciprocal(found[1]))
        return self._done("reciprocal", a)

    # --- lengths and signs ------------------------------------------------------------------------

    def sqrt(self, a: int) -> int:
        return self._done("sqrt", a)

    def length(self, x: int, y: int) -> int:
        """Of a vector; squares are quicker than `hypot` and lengths of mechanisms don't overflow."""
        if self.number_at(y) == 0:
            return self.absolute(x)
        if self.number_at(x) == 0:
            return self.absolute(y)
        known = self._lengths.get(self._vector(x, y))
        return self.sqrt(self.add(self.multiply(x, x), self.multiply(y, y))) if known is None else known

    def know_length(self, x: int, y: int, length: int) -> None:
        """A length that a compass has laid off: it will not be measured again."""
        self._lengths[self._vector(x, y)] = length

    def _vector(self, x: int, y: int) -> frozenset[int]:
        """What a vector is found by where only its length counts."""
        return frozenset((self._bare(x), self._bare(y)))

    def _known_square(self, a: int, b: int) -> int | None:
        """Of a length that is known, where two squares are added."""
        roots = [of for place in (a, b) if (of := self._root(place)) is not None]
        known = self._lengths.get(frozenset(roots)) if len(roots) == 2 else None
        return None if known is None else self.multiply(known, known)

    def _root(self, place: int) -> int | None:
        """What a place is the square of."""
        operation = self.operations[place]
        return operation.of[0] if operation.does == "multiply" and operation.of[0] == operation.of[1] else None

    def absolute(self, a: int) -> int:
        if (inside := self._inside(a, "negative")) is not None:
            return self.absolute(inside)
        a = self._bare(a)
        return a if self.operations[a].does == "sqrt" else self._done("absolute", a)

    def sign(self, a: int) -> int:
        return self._done("sign", a)

    def whole(self, a: int) -> int:
        """The nearest whole number."""
        return self._done("rint", a)

    def maximum(self, a: int, b: int) -> int:
        return self._done("maximum", min(a, b), max(a, b))

    # --- angles -----------------------------------------------------------------------------------

    def angle(self, x: int, y: int) -> int:
        """Of a vector, from -pi to pi."""
        return self._done("arctan2", y, x)

    def turned(self, angle: int) -> tuple[int, int]:
        """Cosine and sine. Of an angle that was measured they are quotients of lengths: no angle is needed for them."""
        operation = self.operations[angle]
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
