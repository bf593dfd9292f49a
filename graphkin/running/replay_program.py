"""A replay made into a program that does many positions at once, as NumPy calls or as a C function.

Where a division or a root fails, and at dead points, plain replay has its own rules (0, NaN, or infinite): these
positions are replayed plainly.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, MutableMapping, Sequence, Set
from dataclasses import fields, replace
from functools import cached_property, partial
from typing import cast

import numpy as np

from graphkin.base.geometry import Real, Value
from graphkin.base.value import Lazy, filled, frozen
from graphkin.construction import Construction, Facts, Plot, replay
from graphkin.construction.fitting import sense_and_sine
from graphkin.running.recorder import TABLES, Entry, FactsOf, GroupSense, Recorded, Recording, record
from graphkin.running.tape import Calls, in_numpy

USUAL = ("position", "velocity", "acceleration", "theta", "omega", "alpha", "turn")
"""Tables that are calculated at once; the others when they are read."""
BLOCK = 8192  # positions done at once: what they need stays in the processor's cache
VERY_MANY = 10**6  # from so many positions on a C compiler is asked for without being told to
MOST_CALLS = 1000  # of more NumPy calls no C function is made: a compiler takes seconds for them, and they gain less
FLAT_SINE = 1e-5
"""Crossings under a smaller angle are dead points but for rounding: such positions are replayed plainly."""
Run = Callable[[Sequence[np.ndarray], np.ndarray, int, Iterable[slice]], list[np.ndarray]]
"""Fills a room (its first numbers are results) of inputs, block by block; positions that are doubtful."""
PLANES = ("position", "velocity", "acceleration")  # tables of vectors; the others are of numbers


def recorded_program(
    constructions: Sequence[Construction], facts: FactsOf, drivers: int, numbers: int = 0, near: Iterable[str] = ()
) -> ReplayProgram:
    """The program of a method's three constructions, with so many drivers; `numbers` on which the facts hang; `near`:
    angles by base link and displacements by `slide_key` that a position close by has. Raises CannotRecord where they
    can't be recorded."""
    recording = record(constructions, facts, drivers, numbers, near)
    return ReplayProgram(tuple(constructions), facts, (drivers, numbers), recording, {})


@frozen
class ReplayProgram:
    """Three constructions as one list of operations, for any values of the drivers, any sides of the crossings and any
    numbers on which `facts` hang; `counts`: how many drivers and numbers; `parts` calculate some entries at once, by
    these."""

    constructions: tuple[Construction, ...]
    facts: FactsOf
    counts: tuple[int, int]
    recording: Recording
    parts: dict[frozenset[Entry], ProgramPart]

    @property
    def sides(self) -> Mapping[int, int]:
        """The side of each choice that the steps have."""
        return self.recording.sides

    @cached_property
    def entries(self) -> frozenset[Entry]:
        """All quantities of the plot that are not the same at all positions."""
        of = ((table, name, value) for table, values in self.recording.tables.items() for name, value in values.items())
        return frozenset((table, name) for table, name, value in of if isinstance(value, Recorded))

    @cached_property
    def usual(self) -> frozenset[Entry]:
        """Those of `USUAL`, but for points of polygons that belong to none of the mechanism."""
        between = {name for each in self.constructions for name, node in each.nodes.items() if node.site is None}
        return frozenset(entry for entry in self.entries if entry[0] in USUAL and entry[1] not in between)

    def part(self, entries: Set[Entry]) -> ProgramPart:
        """The operations that calculate some entries at once."""
        if (key := frozenset(entries)) not in self.parts:
            self.parts[key] = ProgramPart.of(self.recording, sorted(key, key=str))
        return self.parts[key]

    def run(
        self,
        values: Sequence[Real], sides: Mapping[int, Real] | None = None, near: Mapping[str, Real] | None = None,
        asked: set[Entry] | None = None, compiled: bool | None = None, numbers: Sequence[Real] = (),
    ) -> Plot:  # fmt: skip
        """The plot at driver values, crossings taken on other sides, from positions close by, with the numbers that
        facts hang on: each scalar or (n,), one at least (n,).

        asked     what is calculated at once, all else when it is read; what that is, is added for the next run
        compiled  by a C function, if a compiler is at hand; None: only of very many positions
        """
        all_sides = {**self.sides, **(sides or {})}
        close = ((near or {})[name] for name in self.recording.near)
        everything = (*values, *all_sides.values(), *numbers, *close)
        inputs = tuple(np.array(value, dtype=float) for value in everything)
        for value in inputs:
            value.flags.writeable = False  # what is read late is calculated from it
        part = self.part(self.usual if asked is None else self.entries & asked)
        return LazyPlot.of(Results(self, part, inputs, compiled, asked))

    def facts_of(self, inputs: Sequence[np.ndarray]) -> Facts:
        """With the drivers where they are."""
        drivers, numbers = self.counts
        first = drivers + len(self.sides)
        return replace(self.facts(inputs[first : first + numbers]), values=tuple(inputs[:drivers]))

    def plainly(self, inputs: Sequence[np.ndarray], here: np.ndarray) -> Plot:
        """Plain replay at some positions, by their numbers."""
        inputs = [value[here] if value.ndim else value[()] for value in inputs]
        sides = dict(zip(self.sides, inputs[self.counts[0] :]))
        near = dict(zip(self.recording.near, inputs[sum(self.counts) + len(sides) :]))
        plot = Plot(self.facts_of(inputs), near)
        for construction in self.constructions:
            replay(construction, plot, sides if construction.plane == "position" else None)
        return plot


@frozen
class ProgramPart:
    """The operations for some entries of a plot: places of x and y of each vector, and of each real result; by entry
    its room, which is the number of its vector or (after these) of its number; C texts, by which inputs are arrays."""

    recording: Recording
    vectors: tuple[tuple[int, int], ...]
    numbers: tuple[int, ...]
    rooms: Mapping[Entry, int]
    texts: dict[tuple[bool, ...], str]

    @classmethod
    def of(cls, recording: Recording, entries: Iterable[Entry]) -> ProgramPart:
        """For some entries; those that are the same lie in one room."""
        vectors, numbers, rooms = dict[tuple[int, int], int](), dict[int, int](), dict[Entry, int]()
        for table, name in entries:  # ~k: the k-th number, which comes after all vectors
            value = recording.tables[table][name]
            assert isinstance(value, Recorded)
            if table in PLANES:
                rooms[table, name] = vectors.setdefault((value.x, value.y), len(vectors))
            else:
                rooms[table, name] = ~numbers.setdefault(value.x, len(numbers))
        rooms = {entry: room if room >= 0 else len(vectors) + ~room for entry, room in rooms.items()}
        return cls(recording, (*vectors,), (*numbers,), rooms, {})

    @cached_property
    def at_hand(self) -> Mapping[str, tuple[dict[str, Value], list[tuple[str, int]]]]:
        """By table, what is the same at all positions, and the rooms of the rest."""
        tables: dict[str, tuple[dict[str, Value], list[tuple[str, int]]]] = {}
        for table, values in self.recording.tables.items():
            still = {name: value for name, value in values.items() if not isinstance(value, Recorded | GroupSense)}
            rooms = [(name, self.rooms[table, name]) for name in values if (table, name) in self.rooms]
            tables[table] = still, rooms
        return tables

    @cached_property
    def calls(self) -> Calls:
        """On rows for x of each vector, then y of each, numbers, and the least sine."""
        x, y = zip(*self.vectors) if self.vectors else ((), ())
        return in_numpy(self.recording.tape, self.recording.inputs, [*x, *y, *self.numbers, self.recording.sure])

    def run(self, inputs: Sequence[np.ndarray], compiled: bool | None) -> tuple[list[np.ndarray], list[np.ndarray]]:
        """The arrays of all rooms (n,); positions, block by block, that are to be replayed plainly: (m,) each."""
        count, split = max(value.size for value in inputs), 2 * len(self.vectors)
        end = (split + len(self.numbers)) * count
        room = np.empty(end + min(count, BLOCK))
        vectors = room[: split * count].view(complex).reshape(-1, count)
        numbers = room[split * count : end].reshape(-1, count)
        by_compiler = compiled or (compiled is None and count >= VERY_MANY)
        function = self.function(inputs) if by_compiler else None
        if function is None:
            # fill all rooms; positions at which something failed, or that are dead points
            least = room[end:]
            failures, doubtful = list[str](), list[np.ndarray]()
            registers = np.empty((self.calls.registers, least.size))
            with np.errstate(call=lambda kind, _: failures.append(kind), divide="call", invalid="call", over="ignore"):
                for here in _blocks(numbers.shape[1]):
                    sines = least[: here.stop - here.start]
                    rows = [*vectors.real[:, here], *vectors.imag[:, here], *numbers[:, here], sines]
                    values = [value[here] if value.ndim else value for value in inputs]
                    self.calls.run(values, rows, registers[:, : sines.size])
                    if failures or not np.minimum.reduce(sines) > FLAT_SINE:  # NaN, too
                        failures.clear()
                        sound = np.logical_and.reduce([sines > FLAT_SINE, *map(np.isfinite, rows)])
                        doubtful += [here.start + np.flatnonzero(~sound)] * (not sound.all())
        else:
            doubtful = function(inputs, room, end, _blocks(count))
        vectors.flags.writeable = numbers.flags.writeable = False
        return [*vectors, *numbers], doubtful

    def function(self, inputs: Sequence[np.ndarray]) -> Run | None:
        """In C, for inputs of which the same are arrays; None where no compiler is at hand, or it would take long."""
        if len(self.calls.calls) > MOST_CALLS:
            return None
        from graphkin.running import in_c  # loaded where it is asked for: a compiler is called with much

        arrays, recording = tuple(value.ndim > 0 for value in inputs), self.recording
        if arrays not in self.texts:
            results = self.vectors, self.numbers, recording.sure
            self.texts[arrays] = in_c.written(recording.tape, arrays, *results, FLAT_SINE)
        return in_c.compiled(self.texts[arrays], in_c.compiler())


def _blocks(count: int) -> Iterator[slice]:
    return (slice(begin, min(begin + BLOCK, count)) for begin in range(0, count, BLOCK))


class PlotTable(Lazy[Value], MutableMapping[str, Value]):
    """A table of a plot, to be written in as any; an entry is made when it is first read."""

    def __init__(self, results: Results, table: str) -> None:
        super().__init__(results.program.recording.tables[table], partial(results.read, table))
        self._made |= results.at_hand(table)

    def __setitem__(self, name: str, value: Value) -> None:
        self._made[name] = value

    def __delitem__(self, name: str) -> None:
        del self._made[name]


class LazyPlot(Plot):
    """A finished plot, each table of which is made when it is first read."""

    results: Results

    @classmethod
    def of(cls, results: Results) -> LazyPlot:
        plot = cls.__new__(cls)
        plot.__dict__ |= {"near": {}, "follows": False, "results": results}
        return plot

    def __getattr__(self, name: str) -> object:
        if name not in ("facts", *TABLES) or "results" not in self.__dict__:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        made = self.__dict__[name] = self.results.facts if name == "facts" else PlotTable(self.results, name)
        return made

    @cached_property
    def turn(self) -> Mapping[str, Real]:
        """Angles of links between 0 and a full turn [rad]."""
        if "results" not in self.__dict__:
            return super().turn
        return cast(Mapping[str, Real], PlotTable(self.results, "turn"))

    def __reduce__(self) -> tuple[type[Plot], tuple[object, ...]]:
        """Sent elsewhere it is a plain plot."""
        return Plot, tuple(getattr(self, each.name) for each in fields(Plot))


@filled
class Results:
    """Quantities over positions, those of one part of a program at once, the others when one of them is read; `asked`
    takes up what is read late."""

    program: ReplayProgram
    part: ProgramPart
    inputs: tuple[np.ndarray, ...]
    compiled: bool | None
    asked: set[Entry] | None = None

    def __post_init__(self) -> None:
        self.judged: dict[str, tuple[Value, Value]] = {}  # senses and sines of groups that are fitted
        self.rows, doubtful = self.part.run(self.inputs, self.compiled)
        self.plain = [(here, self.program.plainly(self.inputs, here)) for here in doubtful]

    def at_hand(self, table: str) -> Mapping[str, Value]:
        """Values that are the same at all positions, and those that lie in the rooms, where nothing is to be mended."""
        if self.plain:
            return {}
        still, rooms = self.part.at_hand[table]
        return still | {name: self.rows[room] for name, room in rooms}

    @cached_property
    def facts(self) -> Facts:
        """With the drivers where they are."""
        return self.program.facts_of([value[()] for value in self.inputs])

    @cached_property
    def late(self) -> Results:
        """All other quantities."""
        part = self.program.part(self.program.entries - self.part.rooms.keys())
        return Results(self.program, part, self.inputs, self.compiled)

    def read(self, table: str, name: str) -> Value:
        """A scalar, or an array (n,) that cannot be written into."""
        value = self.program.recording.tables[table][name]
        if isinstance(value, GroupSense):
            if value.step.name not in self.judged:
                self.judged[value.step.name] = sense_and_sine(value.step, LazyPlot.of(self))
            value = self.judged[value.step.name][value.which]
        elif isinstance(value, Recorded):
            room = self.part.rooms.get((table, name))
            if room is None:
                if self.asked is not None:
                    self.asked.add((table, name))
                return self.late.read(table, name)
            value = self.rows[room]
        plain = [getattr(plot, table)[name] for _, plot in self.plain]
        if not np.ndim(value) and all(np.all(np.equal(other, value)) for other in plain):
            return value  # a scalar, as plain replay has it, too
        if plain:
            value = np.array(np.broadcast_to(value, (max(each.size for each in self.inputs),)))
            for (here, _), other in zip(self.plain, plain, strict=True):
                value[here] = other
        return value
