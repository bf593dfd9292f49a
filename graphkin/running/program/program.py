"""A replay made into a program that does many positions at once, as NumPy calls or as a C function.

Where a division or a root fails, and at dead points, plain replay has its own rules (0, NaN, or infinite): these
positions are replayed plainly.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, MutableMapping, Sequence, Set
from dataclasses import fields, replace
from functools import cached_property, partial
from typing import Any

import numpy as np

from graphkin.construction.construction import Construction
from graphkin.construction.fitting import sense_and_sine
from graphkin.construction.kinds import Fit
from graphkin.construction.pencil import replay
from graphkin.construction.plot import Facts, Plot, within_a_turn
from graphkin.geometry import Value
from graphkin.running.program.fitting import Judged
from graphkin.running.program.part import BLOCK, Part
from graphkin.running.program.recorder import TABLES, Entry, Recorded, Recording, record
from graphkin.value import Lazy, filled, frozen

USUAL = ("position", "velocity", "acceleration", "theta", "omega", "alpha", "turn")
"""Tables that are calculated at once; the others when they are read."""


def compiled_program(constructions: Sequence[Construction], facts: Facts, near: Iterable[str] = ()) -> Program:
    """The program of a method's three constructions. Raises CannotRecord where they can't be recorded.

    near  what a position close by has: angles by base link, displacements by `slide_key`
    """
    return Program(tuple(constructions), facts, record(constructions, facts, near), {})


@frozen
class Program:
    """Three constructions as one list of operations, for any values of the drivers and any sides of the crossings.

    facts  with the drivers at any values
    parts  what calculates some entries of a plot at once, by these
    """

    constructions: tuple[Construction, ...]
    facts: Facts
    recording: Recording
    parts: dict[frozenset[Entry], Part]

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

    def part(self, entries: Set[Entry]) -> Part:
        """What calculates some entries at once."""
        if (key := frozenset(entries)) not in self.parts:
            self.parts[key] = Part.of(self.recording, sorted(key, key=str))
        return self.parts[key]

    def run(
        self,
        values: Sequence[Value],
        sides: Mapping[int, Value] | None = None,
        near: Mapping[str, Value] | None = None,
        asked: set[Entry] | None = None,
        compiled: bool | None = None,
    ) -> Plot:
        """The plot at driver values, crossings taken on other sides, from positions close by: each scalar or (n,), one
        at least (n,).

        asked     what is calculated at once, all else when it is read; what that is, is added for the next run
        compiled  by a C function, if a compiler is at hand; None: only of very many positions
        """
        taken = {**self.sides, **(sides or {})}
        everything = (*values, *taken.values(), *((near or {})[name] for name in self.recording.near))
        inputs = tuple(np.array(value, dtype=float) for value in everything)
        for value in inputs:
            value.flags.writeable = False  # what is read late is calculated from it
        at_once = self.usual if asked is None else self.entries & asked
        results = Results(self, inputs, at_once, compiled, asked)
        return LazyPlot.of(results)

    def plainly(self, facts: Facts, inputs: Sequence[np.ndarray], here: np.ndarray) -> Plot:
        """Plain replay at some positions, by their numbers."""
        inputs = [value[here] if value.ndim else value[()] for value in inputs]
        count = len(facts.values)
        sides = dict(zip(self.sides, inputs[count:]))
        near = dict(zip(self.recording.near, inputs[count + len(sides) :]))
        plot = Plot(replace(facts, values=tuple(inputs[:count])), near)
        for construction in self.constructions:
            replay(construction, plot, sides if construction.plane == "position" else None)
        return plot


class Table(Lazy[Value], MutableMapping[str, Value]):
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

    @classmethod
    def of(cls, results: Results) -> LazyPlot:
        plot = cls.__new__(cls)
        plot.__dict__ |= {"near": {}, "follows": False, "results": results}
        return plot

    def __getattr__(self, name: str) -> Any:
        if name not in ("facts", *TABLES) or "results" not in self.__dict__:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        made = self.__dict__[name] = self.results.facts if name == "facts" else Table(self.results, name)
        return made

    @cached_property
    def turn(self) -> Mapping[str, Value]:
        """Angles of links between 0 and a full turn [rad]."""
        return Table(self.results, "turn") if "results" in self.__dict__ else super().turn

    def __reduce__(self) -> tuple[type[Plot], tuple[Any, ...]]:
        """Sent elsewhere it is a plain plot."""
        return Plot, tuple(getattr(self, each.name) for each in fields(Plot))


@filled
class Results:
    """Quantities over positions, some calculated at once and the others when one of them is read.

    asked  takes up what is read late
    """

    program: Program
    inputs: tuple[np.ndarray, ...]
    entries: frozenset[Entry]
    compiled: bool | None
    asked: set[Entry] | None = None

    def __post_init__(self) -> None:
        self.part = self.program.part(self.entries)
        self.rows, doubtful = self.part.run(self.inputs, self.compiled)
        blocks = np.array_split(doubtful, -(-doubtful.size // BLOCK)) if doubtful.size else []
        self.patches = [(here, self.program.plainly(self.facts, self.inputs, here)) for here in blocks]

    def at_hand(self, table: str) -> Mapping[str, Value]:
        """What is the same at all positions, and what lies in the rooms, where nothing is to be mended."""
        if self.patches:
            return {}
        still, rooms = self.part.at_hand[table]
        return still | {name: self.rows[room] for name, room in rooms}

    @cached_property
    def facts(self) -> Facts:
        """With the drivers where they are."""
        facts = self.program.facts
        return replace(facts, values=tuple(value[()] for value in self.inputs[: len(facts.values)]))

    @cached_property
    def late(self) -> Results:
        """All other quantities."""
        return Results(self.program, self.inputs, self.program.entries - self.entries, self.compiled)

    def read(self, table: str, name: Any) -> Value:
        """A scalar, or an array (n,) that cannot be written into."""
        entry, value = (table, name), self.program.recording.tables[table][name]
        if isinstance(value, Judged):
            value = self._judged[value.step.name][value.which]
        elif isinstance(value, Recorded) and entry not in self.entries:
            if self.asked is not None:
                self.asked.add(entry)
            return self.late.read(table, name)
        elif isinstance(value, Recorded):
            value = self.rows[self.part.rooms[entry]]
        for here, plot in self.patches:
            plain = getattr(plot, table)[name] if table != "turn" else within_a_turn(plot.theta[name])
            value = _patched(value, self.count, here, plain)
        return value

    @property
    def count(self) -> int:
        """Of positions."""
        return max(value.size for value in self.inputs)

    @cached_property
    def _judged(self) -> Mapping[str, tuple[Value, Value]]:
        """Senses and sines of groups that are fitted."""
        fits = (step for step in self.program.constructions[0].steps if isinstance(step, Fit))
        return {step.name: sense_and_sine(step, LazyPlot.of(self)) for step in fits}


def _patched(value: Value, count: int, here: np.ndarray, other: Value) -> Value:
    """A quantity with other values at some positions; a scalar remains one where they are no other."""
    if not np.ndim(value):
        if np.all(np.equal(other, value)):
            return value
        value = np.full(count, value)
    patched = np.array(value)
    patched[here] = other
    return patched
