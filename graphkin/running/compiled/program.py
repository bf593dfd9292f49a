"""A replay made into a program: one NumPy call after another, on all positions at once.

    steps -- recorder.record --> tape -- layout.laid_out --> Calls -- Program.run --> LazyPlot, a plot

The tape's operations become calls of NumPy functions that write into registers, which are used again as soon as nothing
needs what is in them, or into the rows and vectors of the result. Nothing is allocated on the way, and registers stay
in the processor's cache, for positions are done in chunks. The steps remain the one place that says what is drawn.

Where a division or a root fails, and at dead points, plain replay has its own ways (0, NaN, or infinite). The processor
notes that something failed somewhere; then the program is run again to see at which positions, and these are replayed.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.construction.construction import Construction
from graphkin.construction.pencil import replay
from graphkin.construction.plot import Facts, Plot
from graphkin.geometry import Value
from graphkin.running.compiled.columns import Entry
from graphkin.running.compiled.layout import laid_out
from graphkin.running.compiled.lazy_plot import TABLES, LazyPlot, Numbers, Patch, Told
from graphkin.running.compiled.recorder import Recording, record
from graphkin.running.compiled.run import CHUNK, Run
from graphkin.value import frozen

USUAL = ("position", "velocity", "acceleration", "theta", "omega", "alpha")
"""Tables that are worked out at once."""
TRIED = ("position", "theta", "omega", "s", "s_rate")
"""The same where a way is looked for."""
_NONE = np.empty(0, dtype=int)


def compiled_program(constructions: Sequence[Construction], facts: Facts, near: Iterable[str] = ()) -> Program:
    """The program of a method's three constructions. Raises CannotRecord where they can't be written down.

    near  what a position close by can tell: angles by base link, displacements by `slide_key`
    """
    return Program(tuple(constructions), facts, record(constructions, facts, near), {})


@frozen
class Program:
    """Three constructions as one list of calls, for any values of the drivers and any sides of the crossings.

    facts    with the drivers at any values
    runs     its calls, and where each quantity of a plot is found after them, by what is worked out at once, and the
             drivers that have a value for each position
    """

    constructions: tuple[Construction, ...]
    facts: Facts
    recording: Recording
    runs: dict[tuple[frozenset[Entry] | None, tuple[int, ...]], Run]

    @property
    def sides(self) -> Mapping[int, int]:
        """The side of each choice that the steps have."""
        return self.recording.sides

    @property
    def near(self) -> tuple[str, ...]:
        """What a run must be given of positions close by, where links are fitted or roll."""
        return self.recording.near

    def prepared(self, asked: frozenset[Entry] | None = None, arrays: tuple[int, ...] = (0,)) -> Run:
        """By which what is asked for is worked out at once, else what usually is: points, and how links turn."""
        if (found := self.runs.get((asked, arrays))) is None:
            tables = {name: getattr(self.recording.plot, name) for name in TABLES}
            given = len(self.facts.values) + len(self.sides) + len(self.near)
            at_once = self._entries(USUAL) if asked is None else asked
            layout = laid_out(self.recording, tables, given, at_once, arrays)
            found = self.runs[asked, arrays] = Run(layout, layout.calls)
        return found

    def _entries(self, tables: Sequence[str]) -> set[Entry]:
        """All of some tables, but for points of polygons that belong to none of the mechanism."""
        between = {name for each in self.constructions for name, node in each.nodes.items() if node.site is None}
        return {(name, key) for name in tables for key in getattr(self.recording.plot, name) if key not in between}

    def run(
        self,
        values: Sequence[Value],
        sides: Mapping[int, Value] | None = None,
        near: Mapping[str, Value] | None = None,
        asked: set[Entry] | None = None,
    ) -> Plot:
        """The plot at driver values, crossings taken on given sides, from positions close by: each scalar or (n,), one
        at least (n,).

        asked  what is worked out at once, all else when it is read; what that is, is added for the next run
        """
        taken, near = self.sides if sides is None else {**self.sides, **sides}, near or {}
        told, doubtful = self._tried(values, taken, near, asked)
        if doubtful.size:
            parts = np.array_split(doubtful, -(-doubtful.size // CHUNK))
            patches = [Patch(part, self._replayed(part, told.facts.values, taken, near)) for part in parts]
            told = replace(told, patches=patches)
        return LazyPlot.of(told)

    def tried(
        self, values: Sequence[Value], sides: Mapping[int, Value], near: Mapping[str, Value]
    ) -> tuple[Plot, np.ndarray]:
        """The same, and at which positions it is not to be relied on (m,), for plain replay does them otherwise;
        accelerations are worked out late."""
        told, doubtful = self._tried(values, {**self.sides, **sides}, near, self._entries(TRIED))
        return LazyPlot.of(told), doubtful

    def _tried(
        self, values: Sequence[Value], taken: Mapping[int, Value], near: Mapping[str, Value], asked: set[Entry] | None
    ) -> tuple[Told, np.ndarray]:
        given = tuple(
            np.array(value, dtype=float) for value in (*values, *taken.values(), *(near[name] for name in self.near))
        )
        arrays = tuple(k for k in range(len(values)) if given[k].ndim)
        run = self.prepared(None if asked is None else frozenset(asked), arrays)
        block, vectors = run.room(max(value.size for value in given))
        failed, flat = run.filled(block, vectors, given)
        doubtful = run.doubtful(block, vectors, given, failed, flat) if failed or flat else _NONE
        block.flags.writeable = vectors.flags.writeable = False  # what is read is a view of them
        return Told(self.facts, run.layout.columns, Numbers(block, vectors, given), run.late, asked), doubtful

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
