"""A replay made into a program: one NumPy call after another, on all positions at once.

    steps -- recorder.record --> tape -- calls.written_out --> Calls -- Program.run --> LazyPlot, a plot

The tape's operations become calls of NumPy functions that write into registers, which are used again as soon as nothing
needs what is in them, or into the rows of the result. Nothing is allocated on the way, and registers stay in the
processor's cache, for positions are done in chunks. The steps remain the one place that says what is drawn.

Where a division or a root fails, and at dead points, plain replay has its own ways (0, NaN, or infinite). The processor
notes that something failed somewhere; then the program is run again to see at which positions, and these are replayed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.construction.construction import Construction
from graphkin.construction.pencil import replay
from graphkin.construction.plot import Facts, Plot
from graphkin.geometry import Value
from graphkin.running.compiled.calls import Calls
from graphkin.running.compiled.layout import Layout, laid_out
from graphkin.running.compiled.lazy_plot import TABLES, LazyPlot, Numbers, Patch, Told
from graphkin.running.compiled.memory import lent
from graphkin.running.compiled.recorder import record
from graphkin.value import frozen

CHUNK = 8192
"""Positions done at once."""
FLAT_SINE = 1e-5
"""Crossings under a smaller angle are dead points but for rounding: such positions are replayed plainly."""

Registers = np.ndarray
"""Sines, and after them what is worked with (k, size)."""
Chunk = tuple[Sequence[np.ndarray], Sequence[np.ndarray], Sequence[np.ndarray], Sequence[np.ndarray]]
"""What is given, rows, parts of vectors, registers."""
_NONE = np.empty(0, dtype=int)


def compiled_program(constructions: Sequence[Construction], facts: Facts, near: Iterable[str] = ()) -> Program:
    """The program of a method's three constructions. Raises CannotRecord where they can't be written down.

    near  what a position close by can tell: angles by base link, displacements by `slide_key`
    """
    recording = record(constructions, facts, near)
    tables = {name: getattr(recording.plot, name) for name in TABLES}
    given = len(facts.values) + len(recording.sides) + len(recording.near)
    layout = laid_out(recording, tables, given)
    return Program(tuple(constructions), facts, recording.sides, recording.near, layout, [])


@frozen
class Program:
    """Three constructions as one list of calls, for any values of the drivers and any sides of the crossings.

    facts    with the drivers at any values
    sides    the side of each choice that the steps have
    near     what a run must be given of positions close by, where links are fitted or roll
    layout   its calls, and where each quantity of a plot is found after them
    spare    registers that no run has in hand: a run takes a set from here, or new ones, so runs never share any
    """

    constructions: tuple[Construction, ...]
    facts: Facts
    sides: Mapping[int, int]
    near: tuple[str, ...]
    layout: Layout
    spare: list[Registers]

    @property
    def calls(self) -> Calls:
        return self.layout.calls

    def run(
        self, values: Sequence[Value], sides: Mapping[int, Value] | None = None, near: Mapping[str, Value] | None = None
    ) -> Plot:
        """The plot at driver values, crossings taken on given sides, from positions close by: each scalar or (n,), one
        at least (n,)."""
        taken, near = self.sides if sides is None else {**self.sides, **sides}, near or {}
        told, doubtful = self._tried(values, taken, near)
        if doubtful.size:
            parts = np.array_split(doubtful, -(-doubtful.size // CHUNK))
            patches = [Patch(part, self._replayed(part, told.facts.values, taken, near)) for part in parts]
            told = replace(told, patches=patches)
        return LazyPlot.of(told)

    def tried(
        self, values: Sequence[Value], sides: Mapping[int, Value], near: Mapping[str, Value]
    ) -> tuple[Plot, np.ndarray]:
        """The same, and at which positions it is not to be relied on (m,), for plain replay does them otherwise."""
        told, doubtful = self._tried(values, {**self.sides, **sides}, near)
        return LazyPlot.of(told), doubtful

    def _tried(
        self, values: Sequence[Value], taken: Mapping[int, Value], near: Mapping[str, Value]
    ) -> tuple[Told, np.ndarray]:
        given = tuple(
            np.array(value, dtype=float) for value in (*values, *taken.values(), *(near[name] for name in self.near))
        )
        block, vectors = self._room(max(value.size for value in given))
        sound = self._filled(block, vectors, given)
        doubtful = _NONE if sound else self._doubtful(block, vectors, given)
        return Told(self.facts, self.layout.columns, Numbers(block, vectors, given), self._late), doubtful

    def _late(self, given: Sequence[np.ndarray]) -> np.ndarray:
        """What is asked for late (k, n)."""
        calls, count = self.layout.late_calls, max(value.size for value in given)
        found, none = np.empty((calls.rows, count)), np.empty((0, count), dtype=complex)
        with np.errstate(all="ignore"):
            for _, chunk in _chunks(found, none, given, [*np.empty((calls.registers, min(count, CHUNK)))]):
                calls.run(*chunk)
        return found

    def _room(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """For rows without the sines (rows, n), and vectors (pairs, n)."""
        numbers = (self.calls.rows - self.calls.sines) * count
        room = lent(numbers + self.calls.parts * count)
        return room[:numbers].reshape(-1, count), room[numbers:].view(complex).reshape(-1, count)

    # --- running ------------------------------------------------------------------------------

    def _filled(self, block: np.ndarray, vectors: np.ndarray, given: Sequence[np.ndarray]) -> bool:
        """Fill the block, and the vectors; whether no division or root failed, and no crossing is flat."""
        failures: list[str] = []

        def note(failure: str, _: int) -> None:
            failures.append(failure)

        with np.errstate(call=note, divide="call", invalid="call", over="ignore", under="ignore"):
            for _, chunk, sines in self._chunks(block, vectors, given):
                self.calls.run(*chunk)
                if not np.minimum.reduce(sines, axis=None, initial=1.0) > FLAT_SINE:  # NaN, too
                    failures.append("flat")
        return not failures

    def _doubtful(self, block: np.ndarray, vectors: np.ndarray, given: Sequence[np.ndarray]) -> np.ndarray:
        """Positions at which something failed, or that are dead points: their numbers (m,)."""
        sound = np.ones(block.shape[1], dtype=bool)
        with np.errstate(all="ignore"):
            for here, chunk, sines in self._chunks(block, vectors, given):
                self.calls.run_watched(*chunk, _Watched(sound[here]))
                sound[here] &= np.all(sines > FLAT_SINE, axis=0)
        return np.flatnonzero(~sound)

    def _chunks(
        self, block: np.ndarray, vectors: np.ndarray, given: Sequence[np.ndarray]
    ) -> Iterator[tuple[slice, Chunk, np.ndarray]]:
        """Where a chunk lies, what it is done with, and where its sines are found, which nobody keeps."""
        size, sines = min(block.shape[1], CHUNK), self.calls.sines
        registers = self._borrowed(size)
        for here, (values, rows, sides, rooms) in _chunks(block, vectors, given, [*registers]):
            yield here, (values, rooms[:sines] + rows, sides, rooms[sines:]), registers[:sines, : rooms[0].size]
        self.spare.append(registers)

    def _borrowed(self, size: int) -> Registers:
        try:
            registers = self.spare.pop()
        except IndexError:
            registers = None
        if registers is not None and registers.shape[1] == size:
            return registers
        return np.empty((self.calls.sines + max(self.calls.registers, 1), size))

    # --- positions that fail ------------------------------------------------------------------

    def _replayed(
        self, here: np.ndarray, values: Sequence[Value], sides: Mapping[int, Value], near: Mapping[str, Value]
    ) -> Plot:
        """Plain replay at some positions."""
        values = tuple(value[here] if np.ndim(value) else value for value in values)
        sides = {choice: side[here] if np.ndim(side) else side for choice, side in sides.items()}
        close = {name: value[here] if np.ndim(value) else value for name, value in near.items()}
        plot = Plot(replace(self.facts, values=values), close)
        for construction in self.constructions:
            replay(construction, plot, sides if construction.plane == "position" else None)
        return plot


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
    """The parts of vectors (k, n), x and y of each."""
    return [side for vector in vectors for side in (vector.real, vector.imag)]


class _Watched:
    """Strikes out positions at which something is not finite."""

    def __init__(self, sound: np.ndarray) -> None:
        self.sound = sound

    def __call__(self, found: np.ndarray) -> None:
        np.logical_and(self.sound, np.isfinite(found), out=self.sound)
