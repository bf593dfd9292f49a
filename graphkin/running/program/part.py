"""The part of a program that calculates some entries of a plot at once, block by block."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property

import numpy as np

from graphkin.geometry import Value
from graphkin.running.program.compiler import Function, compiled, compiler
from graphkin.running.program.fitting import Judged
from graphkin.running.program.in_c import in_c
from graphkin.running.program.in_numpy import Calls, in_numpy
from graphkin.running.program.memory import lent
from graphkin.running.program.recorder import Entry, Recorded, Recording
from graphkin.value import frozen

BLOCK = 8192
"""Positions done at once: what they need stays in the processor's cache."""
VERY_MANY = 10**6
"""From so many positions on a C compiler is asked for without being told to."""
FLAT_SINE = 1e-5
"""Crossings under a smaller angle are dead points but for rounding: such positions are replayed plainly."""
PLANES = ("position", "velocity", "acceleration")
"""Tables of vectors; the others are of numbers."""


@frozen
class Part:
    """The operations for some entries of a plot, and where their results lie.

    vectors    places of x and y of each vector; numbers: of each real result
    rooms      by entry, the number of its vector or (after these) of its number
    registers  sets that no run has in hand: a run takes one from here, or a new one, so runs never share any
    texts      in C, by which inputs are arrays
    """

    recording: Recording
    vectors: tuple[tuple[int, int], ...]
    numbers: tuple[int, ...]
    rooms: Mapping[Entry, int]
    registers: list[np.ndarray]
    texts: dict[tuple[bool, ...], str]

    @classmethod
    def of(cls, recording: Recording, entries: Iterable[Entry]) -> Part:
        """For some entries; those that are the same lie in one room."""
        vectors, numbers, rooms = dict[tuple[int, int], int](), dict[int, int](), dict[Entry, int]()
        for table, name in entries:
            value: Recorded = recording.tables[table][name]
            if table in PLANES:
                rooms[table, name] = vectors.setdefault((value.x, value.y), len(vectors))
            else:
                rooms[table, name] = ~numbers.setdefault(value.x, len(numbers))
        rooms = {entry: room if room >= 0 else len(vectors) + ~room for entry, room in rooms.items()}
        return cls(recording, (*vectors,), (*numbers,), rooms, [], {})

    @cached_property
    def at_hand(self) -> Mapping[str, tuple[dict[str, Value], list[tuple[str, int]]]]:
        """By table, what is the same at all positions, and the rooms of the rest."""
        tables: dict[str, tuple[dict[str, Value], list[tuple[str, int]]]] = {}
        for table, values in self.recording.tables.items():
            still = {name: value for name, value in values.items() if not isinstance(value, Recorded | Judged)}
            rooms = [(name, self.rooms[table, name]) for name in values if (table, name) in self.rooms]
            tables[table] = still, rooms
        return tables

    @cached_property
    def calls(self) -> Calls:
        """On rows for x of each vector, then y of each, numbers, and the least sine."""
        x, y = zip(*self.vectors) if self.vectors else ((), ())
        return in_numpy(self.recording.tape, self.recording.inputs, [*x, *y, *self.numbers, self.recording.sure])

    def run(self, inputs: Sequence[np.ndarray], in_c: bool | None) -> tuple[list[np.ndarray], np.ndarray]:
        """The arrays of all rooms (n,), and the numbers of positions that are to be replayed plainly (m,)."""
        count, split = max(value.size for value in inputs), 2 * len(self.vectors)
        end = (split + len(self.numbers)) * count
        room = lent(end + min(count, BLOCK))
        vectors = room[: split * count].view(complex).reshape(-1, count)
        numbers = room[split * count : end].reshape(-1, count)
        function = self._function(inputs) if in_c or (in_c is None and count >= VERY_MANY) else None
        if function is None:
            doubtful = self._by_numpy(inputs, vectors, numbers, room[end:])
        else:
            doubtful = _by_c(function, inputs, count, room, room[end:].view(np.longlong))
        vectors.flags.writeable = numbers.flags.writeable = False
        return [*vectors, *numbers], np.concatenate(doubtful) if doubtful else np.empty(0, dtype=int)

    def _by_numpy(
        self, inputs: Sequence[np.ndarray], vectors: np.ndarray, numbers: np.ndarray, least: np.ndarray
    ) -> list[np.ndarray]:
        """Fill all rooms; positions at which something failed, or that are dead points."""
        failures, doubtful, registers = list[str](), list[np.ndarray](), self._borrowed(least.size)
        with np.errstate(call=lambda kind, _: failures.append(kind), divide="call", invalid="call", over="ignore"):
            for here in _blocks(numbers.shape[1]):
                sines = least[: here.stop - here.start]
                rows = [*vectors.real[:, here], *vectors.imag[:, here], *numbers[:, here], sines]
                values = [value[here] if value.ndim else value for value in inputs]
                self.calls.run(values, rows, registers[:, : sines.size])
                if failures or not np.minimum.reduce(sines) > FLAT_SINE:  # NaN, too
                    failures.clear()
                    sound = np.logical_and.reduce([sines > FLAT_SINE, *map(np.isfinite, rows)])
                    doubtful.append(here.start + np.flatnonzero(~sound))
        self.registers.append(registers)
        return doubtful

    def _borrowed(self, size: int) -> np.ndarray:
        """Registers (k, size)."""
        try:
            registers = self.registers.pop()
        except IndexError:
            registers = np.empty((0, 0))
        return registers if registers.shape[1] == size else np.empty((self.calls.registers, size))

    def _function(self, inputs: Sequence[np.ndarray]) -> Function | None:
        """In C, for inputs of which the same are arrays."""
        arrays, recording = tuple(value.ndim > 0 for value in inputs), self.recording
        if arrays not in self.texts:
            text = in_c(recording.tape, arrays, self.vectors, self.numbers, recording.sure, FLAT_SINE)
            self.texts[arrays] = text
        return compiled(self.texts[arrays], compiler())


def _by_c(
    function: Function, inputs: Sequence[np.ndarray], count: int, room: np.ndarray, marks: np.ndarray
) -> list[np.ndarray]:
    """The same; the function marks doubtful positions of a block."""
    pointers, doubtful = (ctypes.c_void_p * len(inputs))(*(value.ctypes.data for value in inputs)), list[np.ndarray]()
    results = room.ctypes.data
    for here in _blocks(count):
        if function(count, here.start, here.stop, pointers, results):
            doubtful.append(here.start + np.flatnonzero(marks[: here.stop - here.start]))
    return doubtful


def _blocks(count: int) -> Iterator[slice]:
    return (slice(begin, min(begin + BLOCK, count)) for begin in range(0, count, BLOCK))
