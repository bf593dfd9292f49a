"""A replay made into a program: one NumPy call after another, on all positions at once.

    steps -- recorder.record --> tape -- calls.written_out --> Calls -- Program.run --> LazyPlot, a plot

The tape's operations become calls of NumPy functions that write into registers, which are used again as soon as nothing
needs what is in them, or into the rows of the result. Nothing is allocated on the way, and registers stay in the
processor's cache, for positions are done in chunks. The steps remain the one place that says what is drawn.

Where a division or a root fails, and at dead points, plain replay has its own ways (0, NaN, or infinite). The processor
notes that something failed somewhere; then the program is run again to see at which positions, and these are replayed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, TypeGuard

import numpy as np

from graphkin.construction.construction import Construction
from graphkin.construction.pencil import replay
from graphkin.construction.plot import Facts, Plot
from graphkin.geometry import Value
from graphkin.running.compiled.calls import Calls, written_out
from graphkin.running.compiled.columns import Column, Columns, Judged, Pair, Place, Vector
from graphkin.running.compiled.lazy_plot import TABLES, LazyPlot, Numbers, Patch, Told
from graphkin.running.compiled.operations import NUMBER
from graphkin.running.compiled.recorder import Written, record
from graphkin.running.compiled.tape import Tape
from graphkin.value import frozen

CHUNK = 8192
"""Positions done at once."""
FLAT_SINE = 1e-5
"""Crossings under a smaller angle are dead points but for rounding: such positions are replayed plainly."""

PLANES = ("position", "velocity", "acceleration")
"""Tables of vectors; the others are of numbers."""

Registers = list[np.ndarray]


def compiled_program(constructions: Sequence[Construction], facts: Facts, near: Iterable[str] = ()) -> Program:
    """The program of a method's three constructions. Raises CannotRecord where they can't be written down.

    near  what a position close by can tell: angles by base link, displacements by `slide_key`
    """
    recording = record(constructions, facts, near)
    tape = recording.tape
    tables: dict[str, Mapping[Any, Value]] = {name: getattr(recording.plot, name) for name in TABLES}
    sines = [value.real_at for value in (*tables["sines"].values(), *recording.sound) if isinstance(value, Written)]
    vectors = [value for name in PLANES for value in tables[name].values()]
    numbers = [value for name in tables if name not in PLANES for value in tables[name].values()]
    shown, parts = ([place for value in of for place in _places(value, tape)] for of in (numbers, vectors))
    given = len(facts.values) + len(recording.sides) + len(recording.near)
    calls = written_out(tape, given, sines, shown, parts)
    pairs: dict[Vector, Pair] = {}
    columns: Mapping[str, Mapping[Any, Place]] = {
        name: {key: _found(value, tape, calls, pairs if name in PLANES else None) for key, value in table.items()}
        for name, table in tables.items()
    }
    told = {name: Columns.of(table) for name, table in _told_apart(columns).items()}
    return Program(tuple(constructions), facts, recording.sides, recording.near, calls, told, (*pairs,), [])


def _places(value: Value, tape: Tape) -> tuple[int, ...]:
    """Where what is shown stands in the tape; a negative is shown by what it is the negative of."""
    if not isinstance(value, Written):
        return ()
    return tuple(tape.unsigned(place)[0] for place in (value.real_at, value.imag_at))


def _found(value: Value, tape: Tape, calls: Calls, pairs: dict[Vector, Pair] | None) -> Place:
    """Where a quantity of the plot is found after a run; a vector that takes work is entered among the pairs."""
    if isinstance(value, Judged):
        return value
    if isinstance(value, Written):
        x, y = (_column(*tape.unsigned(place), tape, calls) for place in (value.real_at, value.imag_at))
    else:
        x, y = (Column(number=float(part)) for part in (np.real(value), np.imag(value)))
    if pairs is None:
        return x
    vector = Vector(x, y)
    return vector if x.row is None and y.row is None else pairs.setdefault(vector, Pair(len(pairs)))


def _told_apart(columns: Mapping[str, Mapping[Any, Place]]) -> dict[str, dict[Any, Place]]:
    """The same, with those marked that are alone in their row."""
    used = Counter(_row(place) for table in columns.values() for place in table.values())
    return {
        name: {
            key: replace(place, alone=True) if _as_it_is(place) and used[_row(place)] == 1 else place
            for key, place in table.items()
        }
        for name, table in columns.items()
    }


def _as_it_is(place: Place) -> TypeGuard[Column | Pair]:
    """Whether it is what lies there, and nothing is to be done with it."""
    return isinstance(place, Pair) or (isinstance(place, Column) and place.row is not None and place.sign == 1)


def _row(place: Place) -> object:
    """What a quantity lies in: a row of numbers, a pair; else nothing that could be shared."""
    return (Pair, place.number) if isinstance(place, Pair) else (Column, getattr(place, "row", None))


def _column(place: int, sign: int, tape: Tape, calls: Calls) -> Column:
    operation = tape.operations[place]
    if place in calls.rows:
        return Column(row=calls.rows[place], sign=sign)
    if operation.does == NUMBER:
        return Column(number=sign * operation.number)
    return Column(given=int(operation.number), sign=sign)


@frozen
class Program:
    """Three constructions as one list of calls, for any values of the drivers and any sides of the crossings.

    facts    with the drivers at any values
    sides    the side of each choice that the steps have
    near     what a run must be given of positions close by, where links are fitted or roll
    columns  where each quantity of a plot is found, by table and name
    pairs    vectors whose parts are laid side by side, in the order of their numbers
    spare    registers that no run has in hand: a run takes a set from here, or new ones, so runs never share any
    """

    constructions: tuple[Construction, ...]
    facts: Facts
    sides: Mapping[int, int]
    near: tuple[str, ...]
    calls: Calls
    columns: Mapping[str, Columns]
    pairs: tuple[Vector, ...]
    spare: list[Registers]

    def run(
        self, values: Sequence[Value], sides: Mapping[int, Value] | None = None, near: Mapping[str, Value] | None = None
    ) -> Plot:
        """The plot at driver values, crossings taken on given sides, from positions close by: each scalar or (n,), one
        at least (n,)."""
        taken, near = self.sides if sides is None else {**self.sides, **sides}, near or {}
        given = tuple(
            np.array(value, dtype=float) for value in (*values, *taken.values(), *(near[name] for name in self.near))
        )
        count = max(value.size for value in given)
        block, vectors = np.empty((self.calls.kept, count)), np.empty((len(self.pairs), count), dtype=complex)
        failed = self._filled(block, vectors, given)
        told = Told(self.facts, self.columns, Numbers(block, vectors, given))
        # not least > .. : NaN, too
        if failed or not np.minimum.reduce(block[: self.calls.sines], axis=None, initial=1.0) > FLAT_SINE:
            doubtful = self._doubtful(block, given, failed)
            parts = np.array_split(doubtful, -(-doubtful.size // CHUNK)) if doubtful.size else []
            patches = [Patch(part, self._replayed(part, told.facts.values, taken, near)) for part in parts]
            told = replace(told, patches=patches)
        return LazyPlot.of(told)

    # --- running ------------------------------------------------------------------------------

    def _filled(self, block: np.ndarray, vectors: np.ndarray, given: Sequence[np.ndarray]) -> bool:
        """Fill the block, and the vectors; whether a division or a root failed anywhere."""
        failures: list[str] = []

        def note(failure: str, _: int) -> None:
            failures.append(failure)

        with np.errstate(call=note, divide="call", invalid="call", over="ignore", under="ignore"):
            for here, parts, rows, registers in self._chunks(block, given):
                self.calls.run(parts, rows, registers)
                self._side_by_side(vectors[:, here], rows, parts)
        return bool(failures)

    def _side_by_side(self, vectors: np.ndarray, rows: Sequence[np.ndarray], given: Sequence[np.ndarray]) -> None:
        """The parts of each vector laid where they are read, while they are still in the cache."""
        for vector, pair in zip(vectors, self.pairs):
            for part, column in ((vector.real, pair.x), (vector.imag, pair.y)):
                if column.sign == 1:
                    part[:] = column.of(rows, given)
                else:
                    np.negative(column.of(rows, given), out=part)

    def _chunks(
        self, block: np.ndarray, given: Sequence[np.ndarray]
    ) -> Iterator[tuple[slice, Sequence[np.ndarray], Sequence[np.ndarray], Registers]]:
        """Where a chunk lies, and what it is done with: what is given, rows of the result, registers."""
        count, parts = block.shape[1], len(self.calls.rows) - self.calls.kept
        borrowed = self._borrowed(min(count, CHUNK))
        for begin in range(0, count, CHUNK):
            here = slice(begin, min(begin + CHUNK, count))
            size = here.stop - begin
            values = given if size == count else [value[here] if value.ndim else value for value in given]
            work = borrowed if size == borrowed[0].size else [register[:size] for register in borrowed]
            yield here, values, [*block[:, here], *work[:parts]], work[parts : parts + self.calls.registers]
        self.spare.append(borrowed)

    def _borrowed(self, size: int) -> Registers:
        try:
            registers = self.spare.pop()
        except IndexError:
            registers = []
        if registers and registers[0].size == size:
            return registers
        return list(np.empty((max(len(self.calls.rows) - self.calls.kept + self.calls.registers, 1), size)))

    # --- positions that fail ------------------------------------------------------------------

    def _doubtful(self, block: np.ndarray, given: Sequence[np.ndarray], failed: bool) -> np.ndarray:
        """Positions at which something failed, or that are dead points: their numbers (m,)."""
        sound: np.ndarray = np.all(block[: self.calls.sines] > FLAT_SINE, axis=0)
        if failed:
            with np.errstate(all="ignore"):
                for here, parts, rows, registers in self._chunks(block, given):
                    self.calls.run_watched(parts, rows, registers, _Watched(sound[here]))
        return np.flatnonzero(~sound)

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


class _Watched:
    """Strikes out positions at which something is not finite."""

    def __init__(self, sound: np.ndarray) -> None:
        self.sound = sound

    def __call__(self, found: np.ndarray) -> None:
        np.logical_and(self.sound, np.isfinite(found), out=self.sound)
