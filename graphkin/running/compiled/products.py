"""Products on a tape: numbers and signs stand before them, and what cancels is left out."""

from __future__ import annotations

import math
from collections.abc import Mapping

from graphkin.running.compiled.operations import NUMBER, SIDE, Operation, Operations

ROUNDING = 5e-16
"""What a number and its reciprocal make may be off 1."""

Powers = Mapping[int, int]
"""Places with how often each is a factor; below 0 where it divides."""


class Products(Operations):
    """What is multiplied or divided."""

    def __init__(self) -> None:
        super().__init__()
        self._multiplied: dict[tuple[int, int], int] = {}
        self._powers: dict[int, Powers] = {}
        self._divided: set[int] = set()
        self.one = self.number(1.0)

    def negative(self, a: int) -> int:
        if (inside := self._inside(a, "negative")) is not None:
            return inside
        return self._done("negative", a)

    def unsigned(self, place: int) -> tuple[int, int]:
        """What a place is the negative of, and -1; else itself, and 1."""
        does, of, _ = self.operations[place]
        return (of[0], -1) if does == "negative" else (place, 1)

    def multiply(self, a: int, b: int) -> int:
        (a, sign), (b, other) = self.unsigned(a), self.unsigned(b)
        key = (a, b) if a < b else (b, a)
        if (found := self._multiplied.get(key)) is None:
            found = self._multiplied[key] = self._product(*key)
        return found if sign == other else self.negative(found)

    def multiply_numbers(self, a: int, b: int) -> int:
        """Of two that are no part of a vector: the numbers before both are drawn together."""
        (number, one), (more, other) = self.scaled(a), self.scaled(b)
        if a == b or abs(number) == 1 or abs(more) == 1:
            return self.multiply(a, b)
        return self.times(number * more, self.multiply(one, other))

    def divide_numbers(self, a: int, b: int) -> int:
        """The same of a quotient."""
        (number, one), (more, other) = self.scaled(a), self.scaled(self.reciprocal(b))
        return self.times(number * more, self.multiply(one, other))

    def divide(self, a: int, b: int) -> int:
        return self.multiply(a, self.reciprocal(b))

    def reciprocal(self, a: int) -> int:
        """Of a number and a side it is found without dividing, and of a square where that of its root is known."""
        number, rest = self.scaled(a)
        if rest == self.one:
            return self._done("reciprocal", a)
        sides, bare = self._sides(rest)
        (factor, power), *others = self.factored(bare).items()
        if not others and power > 1 and self.known(Operation("reciprocal", (factor,))) is not None:
            found = self.product({factor: -power})
        else:
            found = self._done("reciprocal", bare)
        return self.times(1 / number, self.multiply(sides, found))

    def times(self, number: float, place: int) -> int:
        more, rest = self.scaled(place)
        number *= more
        if abs(abs(number) - 1) < ROUNDING:
            number = math.copysign(1.0, number)
        if number == 0 or rest == self.one:
            return self.number(number)
        found = rest if abs(number) == 1 else self._entered_product(self.number(abs(number)), rest)
        return found if number > 0 else self.negative(found)

    def scaled(self, place: int) -> tuple[float, int]:
        """The number that a place begins with, its sign, too, and the rest."""
        does, of, number = self.operations[place]
        if does == NUMBER:
            return number, self.one
        if does == "negative":
            number, rest = self.scaled(of[0])
            return -number, rest
        if does == "multiply":
            for first, second in (of, of[::-1]):
                if (found := self.number_at(first)) is not None:
                    return found, second
        return 1.0, place

    def drawn_out(self, x: int, y: int) -> tuple[float, int, int]:
        """The number that both parts of a vector begin with, and what it leaves; 1 where they have none in common."""
        (number, one), (more, other) = self.scaled(x), self.scaled(y)
        if abs(number) in (0.0, 1.0) or abs(number) != abs(more):
            return 1.0, x, y
        one, other = (part if each > 0 else self.negative(part) for each, part in ((number, one), (more, other)))
        return abs(number), one, other

    def _product(self, a: int, b: int) -> int:
        """Of two without signs before them."""
        for one, other in ((a, b), (b, a)):
            if (number := self.number_at(one)) is not None:
                return self.times(number, other)
            if self._inside(one, "reciprocal") == other:
                return self.one
            if self.operations[one].does == SIDE and self.scaled(other)[0] != 1:
                number, rest = self.scaled(other)
                return self.times(number, self.multiply(one, rest))
        if a in self._divided or b in self._divided:
            of_a, of_b = self.factored(a), self.factored(b)
            if any(self._cancels(factor, power, of_b.get(factor, 0)) for factor, power in of_a.items()):
                before = len(self.operations)
                found = self.product(together(of_a, of_b))
                if len(self.operations) - before <= 1:
                    return found
        if a == b:
            before = len(self.operations)
            bare = self._bare(a)
            if len(self.operations) == before:
                a = b = bare
        return self._entered_product(a, b)

    def _entered_product(self, a: int, b: int) -> int:
        if self.one in (a, b):
            return a if b == self.one else b
        found = self._done("multiply", a, b) if a < b else self._done("multiply", b, a)
        if a in self._divided or b in self._divided:
            self._divided.add(found)
        return found

    def _cancels(self, factor: int, power: int, more: int) -> bool:
        """Whether there is less of a factor when both are multiplied; roots make squares."""
        if self.operations[factor].does == SIDE:
            return more != 0
        return power * more < 0 or (power > 0 and more > 0 and self.operations[factor].does == "sqrt")

    # --- factors ----------------------------------------------------------------------------------

    def _done(self, does: str, *of: int) -> int:
        """What may cancel with others is noted, and what a root was found of."""
        found = super()._done(does, *of)
        if does in ("reciprocal", "sqrt"):
            self._divided.add(found)
            if does == "sqrt" and self.number_at(found) is None:
                self._divided.add(of[0])
                self._powers[of[0]] = {found: 2}
        return found

    def side(self, which: int) -> int:
        found = super().side(which)
        self._divided.add(found)
        return found

    def factored(self, place: int) -> Powers:
        """A place as powers of others; a square is the second power of its root, where that is known."""
        found = self._powers.get(place)
        if found is None:
            found = self._powers[place] = self._factors(place)
        return found

    def _factors(self, place: int) -> Powers:
        does, of, _ = self.operations[place]
        if does == "multiply" and None is self.number_at(of[0]) is self.number_at(of[1]):
            return together(self.factored(of[0]), self.factored(of[1]))
        if does == "reciprocal" and len(powers := self.factored(of[0])) == 1:
            return {factor: -power for factor, power in powers.items()}
        return {place: 1}

    def product(self, powers: Powers) -> int:
        """The product of powers of places."""
        found = self.one
        for factor, power in sorted(powers.items()):
            if self.operations[factor].does == SIDE:
                power %= 2
            if self.operations[factor].does == "sqrt" and power > 1:
                found = self._entered_product(found, self._power(self.operations[factor].of[0], power // 2))
                power %= 2
            found = self._entered_product(found, self._power(factor, power))
        return found

    def _power(self, place: int, power: int) -> int:
        base = place if power >= 0 else self._done("reciprocal", place)
        found = self.one
        for _ in range(abs(power)):
            found = self._entered_product(found, base)
        return found

    def _sides(self, place: int) -> tuple[int, int]:
        """The sides among the factors of a place, and the rest."""
        powers = self.factored(place)
        sides = {factor: power for factor, power in powers.items() if self.operations[factor].does == SIDE}
        if not sides:
            return self.one, place
        return self.product(sides), self.product(together(powers, sides, -1))

    def _bare(self, a: int) -> int:
        """What is as long, where a sign makes no difference."""
        for does in ("absolute", "negative"):
            if (inside := self._inside(a, does)) is not None:
                return inside
        return self._sides(a)[1]


def together(powers: Powers, others: Powers, times: int = 1) -> Powers:
    """The powers of a product; `times` -1: of a quotient."""
    found = dict(powers)
    for factor, power in others.items():
        if more := found.get(factor, 0) + times * power:
            found[factor] = more
        else:
            found.pop(factor, None)
    return found
