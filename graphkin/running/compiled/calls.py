"""A tape written out as a Python function of NumPy calls, `multiply(r3, k7, r0)`, one an operation."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from graphkin.geometry import Value
from graphkin.running.compiled.operations import GIVEN, NUMBER, RISKY, SIDE, Operation
from graphkin.running.compiled.tape import Tape
from graphkin.value import frozen

Watch = Callable[[np.ndarray], None]
"""Is shown what each risky operation gives."""


@frozen
class Instruction:
    """One call, and the register or row that it writes into."""

    call: str
    into: str
    risky: bool


@frozen
class Calls:
    """What is left of a tape.

    lines      calls in their order
    constants  numbers by their names in the calls
    rows       which row of the result an operation is, by its place; the first `sines` of them are sines, the first
               `kept` are shown as they are, the rest are only parts of vectors
    given, registers  how many there are
    """

    lines: tuple[Instruction, ...]
    constants: Mapping[str, np.ndarray]
    rows: Mapping[int, int]
    sines: int
    kept: int
    given: int
    registers: int

    @cached_property
    def run(self) -> Callable[[Sequence[Value], Iterable[np.ndarray], Iterable[np.ndarray]], None]:
        """`run(given, rows, registers)`."""
        return self._made("given, rows, registers", "")

    @cached_property
    def run_watched(self) -> Callable[[Sequence[Value], Iterable[np.ndarray], Iterable[np.ndarray], Watch], None]:
        """`run_watched(given, rows, registers, watch)`: the same, and shows what each risky operation gives."""
        return self._made("given, rows, registers, watch", "; watch({})")

    def _made(self, parameters: str, after: str) -> Callable[..., None]:
        body = [_unpacked("x", self.given, "given"), _unpacked("y", len(self.rows), "rows")]
        body.append(_unpacked("r", self.registers, "registers"))
        body += [line.call + (after.format(line.into) if line.risky else "") for line in self.lines]
        functions = {line.call.partition("(")[0] for line in self.lines}
        names: dict[str, Any] = {name: getattr(np, name) for name in functions} | dict(self.constants)
        exec(f"def run({parameters}):\n " + "\n ".join(body), names)
        made: Callable[..., None] = names["run"]
        return made


def _unpacked(letter: str, count: int, name: str) -> str:
    return "".join(f"{letter}{k}," for k in range(count)) + f" = {name}" if count else "pass"


def written_out(tape: Tape, given: int, sines: Iterable[int], shown: Iterable[int], parts: Iterable[int]) -> Calls:
    """Of the operations those that are shown, or parts of vectors, those they are made of, and those that may fail; the
    rest is left out."""
    sines = _at_work(tape, sines)
    kept = _at_work(tape, [*sines, *shown])
    results = _at_work(tape, [*kept, *parts])
    rows = {place: row for row, place in enumerate(results)}
    writer = _Writer(tape, rows)
    for place in _needed(tape, rows):
        writer.write(place)
    return Calls(tuple(writer.lines), writer.constants, rows, len(sines), len(kept), given, writer.registers)


def _at_work(tape: Tape, places: Iterable[int]) -> list[int]:
    """Places at which something is done, each once."""
    return [place for place in dict.fromkeys(places) if _works(tape.operations[place])]


def _works(operation: Operation) -> bool:
    return operation.does not in (NUMBER, GIVEN, SIDE)


def _needed(tape: Tape, rows: Iterable[int]) -> list[int]:
    """Places of operations to be done, in their order."""
    waiting = [*rows, *(place for place, operation in enumerate(tape.operations) if operation.does in RISKY)]
    found: set[int] = set()
    while waiting:
        place = waiting.pop()
        if place not in found and _works(tape.operations[place]):
            found.add(place)
            waiting += _to_do(tape, place).of
    return sorted(found)


def _to_do(tape: Tape, place: int) -> Operation:
    """What is to be done: the negative of a difference is a difference, too, and that of a multiple a multiple."""
    operation = tape.operations[place]
    if operation.does != "negative":
        return operation
    inside = tape.operations[operation.of[0]]
    numbers = [tape.number_at(of) for of in inside.of]
    if inside.does == "subtract":
        return Operation("subtract", inside.of[::-1])
    if inside.does in ("add", "multiply") and (known := [number for number in numbers if number is not None]):
        rest = inside.of[numbers.index(None)]
        turned = tape.number(-known[0])
        return Operation("multiply", (turned, rest)) if inside.does == "multiply" else Operation("subtract", (turned, rest))
    return operation


class _Writer:
    """Writes calls, and deals out registers: one is free again after the last call that needs what is in it."""

    def __init__(self, tape: Tape, rows: Mapping[int, int]) -> None:
        self.tape, self.operations, self.rows = tape, tape.operations, rows
        # NumPy takes an array of no dimensions quicker than a float
        self.constants: dict[str, np.ndarray] = {"one": np.array(1.0)}
        self.last = {of: place for place in _needed(tape, rows) for of in _to_do(self.tape, place).of}
        self.names: dict[int, str] = {}
        self.lines: list[Instruction] = []
        self.free: list[str] = []
        self.registers = 0

    def write(self, place: int) -> None:
        operation = _to_do(self.tape, place)
        operands = [self._name(of) for of in operation.of]
        self.free += {name for of, name in zip(operation.of, operands) if self.last[of] == place and name[0] == "r"}
        into = self.names[place] = f"y{self.rows[place]}" if place in self.rows else self._register()
        if place not in self.last and into[0] == "r":
            self.free.append(into)
        self.lines.append(Instruction(_call(operation, operands, into), into, operation.does in RISKY))

    def _name(self, place: int) -> str:
        operation = self.operations[place]
        if operation.does in (GIVEN, SIDE):
            return f"x{int(operation.number)}"
        if operation.does == NUMBER:
            self.constants[f"k{place}"] = np.array(operation.number)
            return f"k{place}"
        return self.names[place]

    def _register(self) -> str:
        if self.free:
            return self.free.pop()
        self.registers += 1
        return f"r{self.registers - 1}"


def _call(operation: Operation, operands: Sequence[str], into: str) -> str:
    if operation.does == "reciprocal":  # NumPy's own reciprocal is not vectorised
        return f"divide(one, {operands[0]}, {into})"
    if operation.does == "multiply" and operands[0] == operands[1]:
        return f"square({operands[0]}, {into})"
    if operation.does == "maximum":  # the one that wants its result named; the others take it quicker by place
        into = f"out={into}"
    return f"{operation.does}({', '.join(operands)}, {into})"
