"""A tape as NumPy calls over a block of positions: registers are used again, and nothing is allocated on the way."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.running.tape import INPUT, Tape

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
