"""Many mechanisms of one topology, drawn at once by one method: their dimensions lie side by side in arrays.

A mechanism whose lengths, directions and drivers are arrays (n,) is a mechanism all the same: its structure, and what
the pencil does, are worked out of it as ever. Which assembly each of them is, its own sketch says: all are drawn, and
the nearest is taken. Where that is not the whole question (no assembly, a sketch between two, a dead point, links
that are fitted, contacts), a mechanism is planned by itself, and gives what it gives alone.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import product
from typing import TypeVar, cast

import numpy as np

from graphkin.base.geometry import Real, Value
from graphkin.base.value import filled, frozen
from graphkin.construction import Facts, Meet, Plot, Swing, replay, slide_key
from graphkin.errors import GraphkinError
from graphkin.model.mechanism import Mechanism
from graphkin.model.pairs import Slide
from graphkin.model.variants import coincidences, count_of, cut, single, stacked, topology
from graphkin.planning import plan
from graphkin.planning.branch_search import BETWEEN, cylinders
from graphkin.planning.method import Method, facts_of
from graphkin.planning.refusals import DEAD_SINE
from graphkin.running import replay_all
from graphkin.running.recorder import TABLES

PART = 2048  # so many mechanisms at once; what they need stays in the cache
CHOICES = 6  # crossings of circles of which every combination is drawn


@frozen
class DrawnVariants:
    """Many mechanisms drawn: values (n,) or (positions, n), NaN for those that are `refused`, by their numbers."""

    plot: Plot
    refused: Mapping[int, GraphkinError]


def replay_many(
    method: Method, mechanisms: Sequence[Mechanism] | Mechanism, values: Sequence[Real] | None = None
) -> DrawnVariants:
    """Every mechanism of a method's topology, as `api.replay_many` has it; none is held against the analysis."""
    each = [mechanisms] if isinstance(mechanisms, Mechanism) else mechanisms
    own_topology = topology(method.mechanism)
    for mechanism in each:
        if topology(mechanism) != own_topology:
            raise ValueError(f"{mechanism.name} is of another topology than {method.mechanism.name}")
    own = method.mechanism.drivers
    needed = [any(np.any(mechanism.drivers[k].acceleration) for mechanism in each) for k in range(len(own))]
    if any(needs and not driver.acceleration for needs, driver in zip(needed, own)):  # a uniform one lacks such terms
        drivers = tuple(replace(driver, acceleration=float(needs)) for needs, driver in zip(needed, own))
        structure = method.structure
        method = plan(replace(method.mechanism, drivers=drivers), structure.coincident, structure.centres)
    count = count_of(mechanisms) if isinstance(mechanisms, Mechanism) else len(mechanisms)
    shape = np.broadcast_shapes((count,), *map(np.shape, values or ()))
    variants = _VariantTables(method, count, shape, {table: {} for table in TABLES})
    left = np.arange(count)
    if count and is_simple(method):
        left = variants.together(mechanisms if isinstance(mechanisms, Mechanism) else stacked(mechanisms), values)
    refused = dict[int, GraphkinError]()
    for row in map(int, left):
        alone = single(mechanisms, row) if isinstance(mechanisms, Mechanism) else mechanisms[row]
        if (error := variants.alone(row, alone, values)) is not None:
            refused[row] = error
    plot = Plot(method.facts(values))
    for name, table in variants.tables.items():
        setattr(plot, name, table)
    return DrawnVariants(plot, refused)


def is_simple(method: Method) -> bool:
    """True if crossings of lines and circles are all that a position asks for: then arrays do what numbers do."""
    plain = all(type(pair) is Slide for pair in method.mechanism.pairs) and not method.mechanism.poses
    few = not method.doubtful and len(_choices(method)) <= CHOICES and bool(list(method.position.steps))
    return plain and few and not method.moves_on


def _choices(method: Method) -> list[int]:
    steps = method.position.steps
    return [step.choice for step in steps if isinstance(step, Meet | Swing) and step.choice is not None]


@filled
class _VariantTables:
    """Tables of arrays in the making, `count` mechanisms along the last axis."""

    method: Method
    count: int
    shape: tuple[int, ...]
    tables: dict[str, dict[object, np.ndarray]]

    def together(self, mechanism: Mechanism, values: Sequence[Real] | None) -> np.ndarray:
        """All mechanisms but those, returned by their numbers, that ask for a plan of their own."""
        planned, own_points = coincidences(self.method.structure.mechanism), coincidences(mechanism)
        same = (own_points.reshape(len(planned), -1) == planned[:, None]).all(axis=0)
        sure = np.array(np.broadcast_to(same, (self.count,)))  # points that lie in one place are the method's own
        facts = facts_of(replace(self.method.structure, mechanism=mechanism), None, {})
        for start in range(0, self.count, PART):
            part = slice(start, min(start + PART, self.count))
            own = None if values is None else [_cut(value, part, self.count) for value in values]
            sketch = {point: cut(z, part) for point, z in mechanism.sketch.items()}
            some = partial(_cut, part=part)
            own_facts = replace(
                facts,
                shapes={link: {point: some(z) for point, z in shape.items()} for link, shape in facts.shapes.items()},
                lines={slide: (guide, origin, some(z)) for slide, (guide, origin, z) in facts.lines.items()},
                turns={body: replace(turn, constant=some(turn.constant)) for body, turn in facts.turns.items()},
                values=tuple(map(some, facts.values)), rates=tuple(map(some, facts.rates)),
                accelerations=tuple(map(some, facts.accelerations)),
            )  # fmt: skip
            assemblies = _assemblies(self.method, own_facts, sketch)
            plot = Plot(own_facts if own is None else replace(own_facts, values=tuple(own)), assemblies.near)
            for construction in self.method.constructions:
                replay(construction, plot, assemblies.sides)
            self._keep(plot, part)
            sure[part] &= assemblies.sure
        return np.flatnonzero(~sure)

    def alone(self, row: int, mechanism: Mechanism, values: Sequence[Real] | None) -> GraphkinError | None:
        """One mechanism by a plan of its own; what is wrong with it, and NaN, where it has none."""
        structure = self.method.structure
        own = None if values is None else [_cut(value, row, self.count) for value in values]
        try:
            plot = replay_all(plan(mechanism, structure.coincident, structure.centres), own)
        except GraphkinError as error:
            for table in self.tables.values():
                for value in table.values():
                    value[..., row] = np.nan
            return error
        self._keep(plot, row)
        return None

    def _keep(self, plot: Plot, where: slice | int) -> None:
        """Keep the results of some of them, or one."""
        for name in TABLES:
            table = self.tables[name]
            for key, value in getattr(plot, name).items():
                if key not in table:
                    table[key] = np.full(self.shape, np.nan, np.result_type(value, np.float64))
                table[key][..., where] = value


def rows_of(many: Plot, rows: np.ndarray | int, plot: Plot) -> Plot:
    """A plot that is given some rows of another's, or one."""
    for name in TABLES:
        table = getattr(many, name)
        setattr(plot, name, {key: value[..., rows] if np.ndim(value) else value for key, value in table.items()})
    return plot


_Number = TypeVar("_Number", bound=Value)


def _cut(value: _Number, part: slice | int, count: int = 0) -> _Number:
    """`cut`, which keeps the kind of what it cuts."""
    return cast(_Number, cut(value, part, count))


@frozen
class Assemblies:
    """As `Assembly`, of many mechanisms: sides by choice, angles and displacements, (n,) each; which are sure."""

    sides: Mapping[int, np.ndarray]
    near: Mapping[str, Value]
    sure: np.ndarray


def _assemblies(method: Method, facts: Facts, sketch: Mapping[str, Value]) -> Assemblies:
    """Every combination of crossings drawn, and for each mechanism the nearest to its sketch taken. Sure is what
    closes, lies well off its dead points, and has no other assembly that the sketch may mean."""
    choices = _choices(method)
    sides = np.array([*product((1, -1), repeat=len(choices))], dtype=float).reshape(2 ** len(choices), len(choices))
    plot = replay(method.position, Plot(facts), {choice: sides[:, [k]] for k, choice in enumerate(choices)})
    count = np.broadcast_shapes((1,), *map(np.shape, (*sketch.values(), *plot.position.values())))[-1:]
    every = (len(sides), *count)
    points = {point: np.broadcast_to(z, every) for point, z in plot.position.items()}
    shown = [point for point in sketch if point in points]
    far = sum((np.abs(points[point] - sketch[point]) ** 2 for point in shown), np.zeros(every))
    closed = [np.isfinite(places) for places in points.values()]
    closed += [np.broadcast_to(plot.s[name] > 0, every) for name in cylinders(method.structure)]
    far = np.where(np.all(closed, axis=0), far, np.inf)
    best, row = np.argmin(far, axis=0), np.arange(every[1])
    sines = [np.broadcast_to(sine, every)[best, row] for (plane, _), sine in plot.sines.items() if plane == "position"]
    nearest = far[best, row]
    sure = np.isfinite(nearest) & (np.min([np.ones(every[1]), *np.nan_to_num(sines)], axis=0) >= DEAD_SINE)
    slides = [np.broadcast_to(s, every) for s in plot.s.values()]
    places = np.array([*points.values()])
    size = np.abs(places - places[0])[:, best, row].max(axis=0)
    for other in range(len(sides)):
        with np.errstate(invalid="ignore"):
            same = np.all([np.abs(z[other] - z[best, row]) <= 1e-9 * size for z in (*points.values(), *slides)], axis=0)
            apart = sum((np.abs(points[p][other] - points[p][best, row]) ** 2 for p in shown), np.zeros(every[1]))
            doubt = (apart <= (1e-9 * size) ** 2) | (far[other] - nearest < BETWEEN * apart)
        sure &= same | ~np.isfinite(far[other]) | ~doubt
    turned = [base for base in method.structure.bases if base in plot.theta]
    near = {base: np.broadcast_to(plot.theta[base], every)[best, row] for base in turned}
    near |= {slide_key(slide): np.broadcast_to(s, every)[best, row] for slide, s in plot.s.items()}
    return Assemblies({choice: sides[best, k] for k, choice in enumerate(choices)}, near, sure)
