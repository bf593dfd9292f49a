"""A tape of real operations in the order in which they can be done.

An operation is spoken of by its place. What is the same is entered once, operations of numbers are done at once, and
signs are drawn out of sums and products. NumPy does a tape over a block of positions: registers are used again, and
nothing is allocated on the way.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphkin.base.value import frozen

NUMBER, INPUT = "number", "input"
FAILING = ("reciprocal", "sqrt")  # operations that have no finite value for some numbers

WITH_NUMBERS: Mapping[str, Callable[..., float]] = {
    "add": lambda a, b: a + b,
    "subtract": lambda a, b: a - b,
    "multiply": lambda a, b: a * b,
    "minimum": min,
    "maximum": max,
    "arctan2": math.atan2,
    "negative": lambda a: -a,
    "absolute": abs,
    "floor": lambda a: float(math.floor(a)),
    "rint": lambda a: float(round(a)),
    "sign": lambda a: float((a > 0) - (a < 0)),
    "reciprocal": lambda a: 1 / a,
    "sqrt": math.sqrt,
    "tan": math.tan,
}
"""Operations by the names of their NumPy functions."""


class CannotRecord(Exception):
    """A construction does what the tape has no operation for; it is replayed plainly."""


class Operation(NamedTuple):
    """A line of the tape: it does "number", "input", or a key of `WITH_NUMBERS`, with operands at places `of`; its
    `number` is the value, or which input it is."""

    does: str
    of: tuple[int, ...] = ()
    number: float = 0.0


class Tape:
    """Each method enters an operation and returns the place of its result."""

    def __init__(self) -> None:
        self.operations: list[Operation] = []
        self._places: dict[Operation, int] = {}
        self.zero, self.one = self.number(0.0), self.number(1.0)

    def number(self, value: float) -> int:
        return self._entered(Operation(NUMBER, number=float(value) + 0.0))  # never -0

    def input(self, which: int) -> int:
        return self._entered(Operation(INPUT, number=which))

    def number_at(self, place: int) -> float | None:
        """The number at a place; None where another kind of operation stands."""
        does, _, number = self.operations[place]
        return number if does == NUMBER else None

    def done(self, does: str, *of: int) -> int:
        """An operation, or its result where all operands are numbers."""
        if any(self.number_at(place) is None for place in of):
            return self._entered(Operation(does, of))
        numbers = [self.operations[place].number for place in of]
        try:
            return self.number(WITH_NUMBERS[does](*numbers))
        except (ValueError, ZeroDivisionError) as error:
            raise CannotRecord(f"{does} of {numbers}") from error

    def _entered(self, operation: Operation) -> int:
        place = self._places.setdefault(operation, len(self.operations))
        if place == len(self.operations):
            self.operations.append(operation)
        return place

    def _of(self, does: str, place: int) -> tuple[int, ...]:
        """The operands of a place at which this operation stands; nothing where another does."""
        operation = self.operations[place]
        return operation.of if operation.does == does else ()

    def add(self, a: int, b: int) -> int:
        for one, other in ((a, b), (b, a)):
            if one == self.zero:
                return other
            if inside := self._of("negative", one):
                return self.subtract(other, inside[0])
        return self.done("add", min(a, b), max(a, b))

    def subtract(self, a: int, b: int) -> int:
        if a == b:
            return self.zero
        if b == self.zero:
            return a
        if inside := self._of("negative", b):
            return self.add(a, inside[0])
        if inside := self._of("negative", a):
            return self.negative(self.add(inside[0], b))
        if a == self.zero or a > b:  # one of a - b and b - a is enough
            return self.negative(self.subtract(b, a))
        return self.done("subtract", a, b)

    def negative(self, a: int) -> int:
        inside = self._of("negative", a)
        return inside[0] if inside else self.done("negative", a)

    def multiply(self, a: int, b: int) -> int:
        for one, other in ((a, b), (b, a)):
            if one == self.zero:
                return self.zero
            if one == self.one:
                return other
            if (number := self.number_at(one)) is not None and number < 0:
                return self.negative(self.multiply(self.number(-number), other))
            if inside := self._of("negative", one):
                return self.negative(self.multiply(inside[0], other))
        root = self._of("sqrt", a)
        return root[0] if root and a == b else self.done("multiply", min(a, b), max(a, b))

    def divide(self, a: int, b: int) -> int:
        return self.one if a == b else self.multiply(a, self.reciprocal(b))

    def reciprocal(self, a: int) -> int:
        inside = self._of("negative", a)
        return self.negative(self.reciprocal(inside[0])) if inside else self.done("reciprocal", a)

    def length(self, x: int, y: int) -> int:
        """Of a vector: squares are quicker than `hypot`, and lengths of mechanisms do not overflow."""
        if self.zero in (x, y):
            return self.absolute(x if y == self.zero else y)
        return self.done("sqrt", self.add(self.multiply(x, x), self.multiply(y, y)))

    def absolute(self, a: int) -> int:
        inside = self._of("negative", a)
        a = inside[0] if inside else a
        return a if self._of("sqrt", a) else self.done("absolute", a)

    def turned(self, angle: int) -> tuple[int, int]:
        """Cosine and sine; of an angle that was measured they are quotients of lengths."""
        does, of, number = self.operations[angle]
        match does:
            case "number":
                return self.number(math.cos(number)), self.number(math.sin(number))
            case "arctan2":
                length = self.length(*of)
                return self.divide(of[1], length), self.divide(of[0], length)
            case "negative":
                cos, sin = self.turned(*of)
                return cos, self.negative(sin)
            case "add" | "subtract":
                (cos, sin), (more, up) = map(self.turned, of)
                up = up if does == "add" else self.negative(up)
                return (self.subtract(self.multiply(cos, more), self.multiply(sin, up)),
                        self.add(self.multiply(sin, more), self.multiply(cos, up)))  # fmt: skip
            case _:
                # cosine and sine from t = tan(angle / 2), as 2 / (1 + t^2) - 1 and 2 t / (1 + t^2). NumPy's tangent
                # takes a fifteenth of the time of its sine and cosine where it is vectorised. Its relative error comes
                # out as an absolute one of at most 4e-16, for large t as well
                tangent = self.done("tan", self.multiply(angle, self.number(0.5)))
                square = self.add(self.multiply(tangent, tangent), self.one)
                twice = self.divide(self.number(2.0), square)
                return self.subtract(twice, self.one), self.multiply(tangent, twice)

    def needed(self, results: Iterable[int]) -> list[int]:
        """The places of operations that some results need, in their order."""
        waiting, reached = [*results], set[int]()
        while waiting:
            place = waiting.pop()
            if place not in reached and self.operations[place].does not in (NUMBER, INPUT):
                reached.add(place)
                waiting += self.operations[place].of
        return sorted(reached)


Call = tuple[Callable[..., object], int, int, int]
"""A NumPy function, its operands' places in memory (-1: it has one operand), and its result's."""


@frozen
class Calls:
    """NumPy calls on a memory of arrays: inputs, rows for results, numbers, registers."""

    calls: tuple[Call, ...]
    numbers: tuple[np.ndarray, ...]
    registers: int

    def run(self, inputs: Sequence[np.ndarray], rows: Sequence[np.ndarray], registers: Iterable[np.ndarray]) -> None:
        """Fill the rows (n,) each; inputs (n,) or () each."""
        memory = [*inputs, *rows, *self.numbers, *registers]
        for function, a, b, into in self.calls:
            if b < 0:
                function(memory[a], memory[into])
            else:
                function(memory[a], memory[b], memory[into])


def in_numpy(tape: Tape, inputs: int, rows: Sequence[int]) -> Calls:
    """The calls that fill rows with the results at some places of a tape."""
    writer = _CallWriter(tape, inputs, rows)
    for place in tape.needed(rows):
        writer.write(place)
    for row, place in enumerate(rows, start=inputs):
        if writer.held[place] != row:  # a result that lies in another row, too, or an input or a number
            writer.call("positive", [writer.held[place]], row)
    return Calls(tuple(writer.calls), writer.numbers, writer.registers)


class _CallWriter:
    """Writes calls, and deals out registers: one is free again after the last call that reads it."""

    def __init__(self, tape: Tape, inputs: int, rows: Sequence[int]) -> None:
        self.tape, self.calls, self.registers = tape, list[Call](), 0
        needed = tape.needed(rows)
        self.last = {of: place for place in needed for of in tape.operations[place].of}
        self.held = {place: inputs + row for row, place in reversed([*enumerate(rows)])}
        self.at_once = {*self.held}
        numbers = [place for place in (tape.one, *self.last, *rows) if tape.number_at(place) is not None]
        self.numbers = tuple(np.array(tape.number_at(place)) for place in dict.fromkeys(numbers))
        self.first, self.free = inputs + len(rows) + len(self.numbers), list[int]()
        self.held |= {place: inputs + len(rows) + k for k, place in enumerate(dict.fromkeys(numbers))}
        self.held |= {place: int(op.number) for place, op in enumerate(tape.operations) if op.does == INPUT}

    def write(self, place: int) -> None:
        """The call for one operation, into the row of its result or a register."""
        does, of, _ = self.tape.operations[place]
        operands = [self.held[each] for each in of]
        self.free += {self.held[each] for each in of if self.last[each] == place and self.held[each] >= self.first}
        if place not in self.at_once:
            if not self.free:
                self.free.append(self.first + self.registers)
                self.registers += 1
            self.held[place] = self.free.pop()
        self.call(does, operands, self.held[place])

    def call(self, does: str, operands: list[int], into: int) -> None:
        if does == "reciprocal":  # NumPy's own is not vectorised
            does, operands = "divide", [self.held[self.tape.one], *operands]
        if does == "multiply" and operands[0] == operands[1]:
            does, operands = "square", operands[:1]
        function = _OWN.get(does) or getattr(np, does)
        self.calls.append((function, operands[0], operands[1] if len(operands) > 1 else -1, into))


_OWN: dict[str, Callable[..., object]] = {"maximum": lambda a, b, into: np.maximum(a, b, out=into),
                                          "minimum": lambda a, b, into: np.minimum(a, b, out=into)}  # fmt: skip
"""NumPy takes what these give by name only."""
