"""The calls of a layout carried out, chunk by chunk."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphkin.running.compiled.calls import Calls
from graphkin.running.compiled.layout import Layout
from graphkin.running.compiled.memory import lent
from graphkin.value import frozen

CHUNK = 8192
"""Positions done at once."""
FLAT_SINE = 1e-5
"""Crossings under a smaller angle are dead points but for rounding: such positions are replayed plainly."""

Registers = np.ndarray
"""Sines, and after them what is worked with (k, size)."""
Flat = list[tuple[slice, np.ndarray]]
"""Chunks in which crossings are flat, and at which of their positions they are not."""
Chunk = tuple[Sequence[np.ndarray], Sequence[np.ndarray], Sequence[np.ndarray], Sequence[np.ndarray]]
"""What is given, rows, parts of vectors, registers."""


@frozen
class Run:
    """How the calls of a layout are carried out."""

    layout: Layout
    calls: Calls

    def late(self, given: Sequence[np.ndarray]) -> np.ndarray:
        """What is asked for late (k, n)."""
        calls, count = self.layout.late_calls, max(value.size for value in given)
        found, none = lent(calls.rows * count).reshape(-1, count), np.empty((0, count), dtype=complex)
        with np.errstate(all="ignore"):
            for _, chunk in _chunks(found, none, given, [*np.empty((calls.registers, min(count, CHUNK)))]):
                calls.run(*chunk)
        return found

    def room(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """For rows without the sines (rows, n), and vectors (pairs, n)."""
        numbers = (self.calls.rows - self.calls.sines) * count
        room = lent(numbers + self.calls.parts * count)
        return room[:numbers].reshape(-1, count), room[numbers:].view(complex).reshape(-1, count)

    def filled(self, block: np.ndarray, vectors: np.ndarray, given: Sequence[np.ndarray]) -> tuple[bool, Flat]:
        """Fill the block, and the vectors; whether a division or a root failed, and where crossings are flat."""
        failures: list[str] = []
        flat: Flat = []

        def note(failure: str, _: int) -> None:
            failures.append(failure)

        with np.errstate(call=note, divide="call", invalid="call", over="ignore", under="ignore"):
            for here, chunk, sines in self._chunks(block, vectors, given):
                self.calls.run(*chunk)
                if not np.minimum.reduce(sines, axis=None, initial=1.0) > FLAT_SINE:  # NaN, too
                    flat.append((here, np.all(sines > FLAT_SINE, axis=0)))
        return bool(failures), flat

    def doubtful(
        self, block: np.ndarray, vectors: np.ndarray, given: Sequence[np.ndarray], failed: bool, flat: Flat
    ) -> np.ndarray:
        """Positions at which something failed, or that are dead points: their numbers (m,)."""
        sound = np.ones(block.shape[1], dtype=bool)
        if failed:
            with np.errstate(all="ignore"):
                for here, chunk, _ in self._chunks(block, vectors, given):
                    self.calls.run_watched(*chunk, _Watched(sound[here]))
        for here, apart in flat:
            sound[here] &= apart
        return np.flatnonzero(~sound)

    def _chunks(
        self, block: np.ndarray, vectors: np.ndarray, given: Sequence[np.ndarray]
    ) -> Iterator[tuple[slice, Chunk, np.ndarray]]:
        """Where a chunk lies, what it is done with, and where its sines are found, which nobody keeps."""
        size, sines = min(block.shape[1], CHUNK), self.calls.sines
        registers = self._borrowed(size)
        for here, (values, rows, parts, rooms) in _chunks(block, vectors, given, [*registers]):
            yield here, (values, rooms[:sines] + rows, parts, rooms[sines:]), registers[:sines, : rooms[0].size]
        self.layout.spare.append(registers)

    def _borrowed(self, size: int) -> Registers:
        try:
            registers = self.layout.spare.pop()
        except IndexError:
            registers = None
        if registers is not None and registers.shape[1] == size:
            return registers
        return np.empty((self.calls.sines + max(self.calls.registers, 1), size))


def _chunks(
    block: np.ndarray, vectors: np.ndarray, given: Sequence[np.ndarray], registers: list[np.ndarray]
) -> Iterator[tuple[slice, tuple[Sequence[np.ndarray], list[np.ndarray], list[np.ndarray], list[np.ndarray]]]]:
    """Where each chunk lies, and what of all this belongs to it."""
    count = block.shape[1]
    if count <= CHUNK:
        yield slice(None), (given, [*block], _sides(vectors), registers)
        return
    for begin in range(0, count, CHUNK):
        here = slice(begin, min(begin + CHUNK, count))
        values = [value[here] if value.ndim else value for value in given]
        rooms = [register[: here.stop - begin] for register in registers]
        yield here, (values, [*block[:, here]], _sides(vectors[:, here]), rooms)


def _sides(vectors: np.ndarray) -> list[np.ndarray]:
    """The parts of vectors (k, n): x of each, then y of each, then the vectors."""
    return [*vectors.real, *vectors.imag, *vectors]


class _Watched:
    """Strikes out positions at which something is not finite."""

    def __init__(self, sound: np.ndarray) -> None:
        self.sound = sound

    def __call__(self, found: np.ndarray) -> None:
        np.logical_and(self.sound, np.isfinite(found), out=self.sound)
