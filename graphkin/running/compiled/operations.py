"""Operations of a tape: real operations, each entered once."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

NUMBER, GIVEN, SIDE = "number", "given", "side"
RISKY = ("reciprocal", "sqrt")
"""What has no finite value for some numbers."""

WITH_NUMBERS: Mapping[str, Callable[..., float]] = {
    "add": lambda a, b: a + b,
    "subtract": lambda a, b: a - b,
    "multiply": lambda a, b: a * b,
    "maximum": max,
    "arctan2": math.atan2,
    "negative": lambda a: -a,
    "absolute": abs,
    "rint": lambda a: float(round(a)),
    "sign": lambda a: float((a > 0) - (a < 0)),
    "reciprocal": lambda a: 1 / a,
    "sqrt": math.sqrt,
    "cos": math.cos,
    "sin": math.sin,
}


class CannotRecord(Exception):
    """A construction does what the tape has no word for; it is replayed as ever."""


class Operation(NamedTuple):
    """A line of the tape.

    does    "number", "given", "side", or the NumPy function
    of      places of the operations it is done with
    number  the number; which of what is given it is
    """

    does: str
    of: tuple[int, ...] = ()
    number: float = 0.0


class Operations:
    """Operations in the order in which they can be carried out; spoken of by their places."""

    def __init__(self) -> None:
        self.operations: list[Operation] = []
        self._places: dict[Operation, int] = {}
        self._numbers: dict[float, int] = {}

    def number(self, value: float) -> int:
        if (place := self._numbers.get(value)) is None:
            place = self._numbers[value] = self._entered(Operation(NUMBER, (), float(value)))
        return place

    def given(self, which: int) -> int:
        return self._entered(Operation(GIVEN, number=which))

    def side(self, which: int) -> int:
        """Given, too, and always 1 or -1."""
        return self._entered(Operation(SIDE, number=which))

    def number_at(self, place: int) -> float | None:
        """The number at a place, None where another kind of operation stands."""
        does, _, number = self.operations[place]
        return number if does == NUMBER else None

    def known(self, operation: Operation) -> int | None:
        """Where an operation stands, if it is entered."""
        return self._places.get(operation)

    def _entered(self, operation: Operation) -> int:
        count = len(self.operations)
        place = self._places.setdefault(operation, count)
        if place == count:
            self.operations.append(operation)
        return place

    def _done(self, does: str, *of: int) -> int:
        """A function of operations: a number where all of them are."""
        if any(self.operations[place].does != NUMBER for place in of):
            return self._entered(Operation(does, of))
        numbers = [self.operations[place].number for place in of]
        try:
            return self.number(WITH_NUMBERS[does](*numbers))
        except (ValueError, ZeroDivisionError) as error:
            raise CannotRecord(f"{does} of {numbers}") from error

    def _inside(self, place: int, does: str) -> int | None:
        """What a function is of, where this very function stands at the place."""
        operation = self.operations[place]
        return operation.of[0] if operation.does == does else None

    def _beside(self, does: str, one: int, whole: int) -> int | None:
        """The other one of two that were added or multiplied; None where `whole` is nothing like that."""
        operation = self.operations[whole]
        if operation.does != does or one not in operation.of:
            return None
        return operation.of[1 - operation.of.index(one)]
