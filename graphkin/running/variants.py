"""Many mechanisms of one topology, drawn at once by one method: their dimensions lie side by side in arrays.

A mechanism whose lengths, directions and drivers are arrays (n,) is a mechanism all the same: its structure, and what
the pencil does, are worked out of it as ever. Which assembly each of them is, its own sketch says: all are drawn, and
the nearest is taken. Where that is not the whole question (no assembly, a sketch between two, a dead point, links
that are fitted, contacts), a mechanism is planned by itself, and gives what it gives alone.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.construction import Plot
from graphkin.errors import GraphkinError
from graphkin.geometry import Value
from graphkin.mechanism import Mechanism
from graphkin.pairs import Slide
from graphkin.planning import plan
from graphkin.planning.method import Method
from graphkin.planning.starting_facts import facts_of
from graphkin.running.assemblies import few_ways
from graphkin.running.at_once import alike, drawn_at_once, facts_in
from graphkin.running.program import TABLES
from graphkin.running.replaying import replay_all
from graphkin.stacking import count_of, cut, single, stacked, topology
from graphkin.value import filled, frozen

PART = 2048
"""So many mechanisms at once; what they need stays in the cache."""


@frozen
class Drawn:
    """Many mechanisms drawn: values (n,) or (positions, n).

    refused   what is wrong with some of them, by their numbers; their values are NaN
    """

    plot: Plot
    refused: Mapping[int, GraphkinError]


def replay_many(
    method: Method, mechanisms: Sequence[Mechanism] | Mechanism, values: Sequence[Value] | None = None
) -> Drawn:
    """Every mechanism of a method's topology, each at its own drawn position or at driver values.

    mechanisms  one after another; or one whose numbers are arrays (n,), those that all share scalars
    values      one entry a driver, scalar, (positions, 1) or (positions, n) [rad, m]

    Each is the assembly that its own sketch means. Raises ValueError for a mechanism of another topology.
    """
    _refuse_others(method, [mechanisms] if isinstance(mechanisms, Mechanism) else mechanisms)
    method = _accelerated(method, [mechanisms] if isinstance(mechanisms, Mechanism) else mechanisms)
    count = count_of(mechanisms) if isinstance(mechanisms, Mechanism) else len(mechanisms)
    found = _Drawing(method, count, _shape(count, values), {table: {} for table in TABLES})
    left = np.arange(count)
    if count and is_simple(method):
        left = found.together(mechanisms if isinstance(mechanisms, Mechanism) else stacked(mechanisms), values)
    refused = dict[int, GraphkinError]()
    for row in map(int, left):
        own = single(mechanisms, row) if isinstance(mechanisms, Mechanism) else mechanisms[row]
        if (error := found.alone(row, own, values)) is not None:
            refused[row] = error
    plot = Plot(method.facts(values))
    for name, table in found.tables.items():
        setattr(plot, name, table)
    return Drawn(plot, refused)


def is_simple(method: Method) -> bool:
    """Whether crossings of lines and circles are all that a position asks for: then arrays do what numbers do."""
    plain = all(type(pair) is Slide for pair in method.mechanism.pairs) and not method.mechanism.poses
    return plain and few_ways(method) and not method.moves_on


def _refuse_others(method: Method, mechanisms: Sequence[Mechanism]) -> None:
    wanted = topology(method.mechanism)
    for mechanism in mechanisms:
        if topology(mechanism) != wanted:
            raise ValueError(f"{mechanism.name} is of another topology than {method.mechanism.name}")


def _accelerated(method: Method, mechanisms: Sequence[Mechanism]) -> Method:
    """The method, with the terms that a uniform rotation has not, where some driver of a mechanism is not uniform."""
    own = method.mechanism.drivers
    wanted = [any(np.any(mechanism.drivers[k].acceleration) for mechanism in mechanisms) for k in range(len(own))]
    if not any(want and not driver.acceleration for want, driver in zip(wanted, own)):
        return method
    drivers = tuple(replace(driver, acceleration=float(want)) for want, driver in zip(wanted, own))
    structure = method.structure
    return plan(replace(method.mechanism, drivers=drivers), structure.coincident, structure.centres)


def _shape(count: int, values: Sequence[Value] | None) -> tuple[int, ...]:
    return np.broadcast_shapes((count,), *(np.shape(value) for value in values or ()))


@filled
class _Drawing:
    """Tables of arrays in the making, `count` mechanisms along the last axis."""

    method: Method
    count: int
    shape: tuple[int, ...]
    tables: dict[str, dict[object, Value]]

    def together(self, mechanism: Mechanism, values: Sequence[Value] | None) -> np.ndarray:
        """All mechanisms but those, returned by their numbers, that ask for a plan of their own."""
        sure = alike(self.method, mechanism, self.count)
        facts = facts_of(replace(self.method.structure, mechanism=mechanism), None, {})
        for start in range(0, self.count, PART):
            part = slice(start, min(start + PART, self.count))
            own = None if values is None else [cut(value, part, self.count) for value in values]
            sketch = {point: cut(z, part) for point, z in mechanism.sketch.items()}
            found = drawn_at_once(self.method, facts_in(facts, part), sketch, own)
            self._keep(found.plot, part)
            sure[part] &= found.sure
        return np.flatnonzero(~sure)

    def alone(self, row: int, mechanism: Mechanism, values: Sequence[Value] | None) -> GraphkinError | None:
        """One mechanism by a plan of its own; what is wrong with it, and NaN, where it has none."""
        structure = self.method.structure
        own = None if values is None else [cut(value, row, self.count) for value in values]
        try:
            plot = replay_all(plan(mechanism, structure.coincident, structure.centres), own)
        except GraphkinError as error:
            self._erase(row)
            return error
        self._keep(plot, row)
        return None

    def _keep(self, plot: Plot, where: slice | int) -> None:
        """What some of them, or one, gave."""
        for name in TABLES:
            table = self.tables[name]
            for key, value in getattr(plot, name).items():
                if key not in table:
                    table[key] = np.full(self.shape, np.nan, np.result_type(value, np.float64))
                table[key][..., where] = value

    def _erase(self, row: int) -> None:
        for table in self.tables.values():
            for value in table.values():
                value[..., row] = np.nan
