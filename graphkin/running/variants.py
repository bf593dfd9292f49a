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
from typing import cast

import numpy as np

from graphkin.base.geometry import Array, Real, Value
from graphkin.base.value import Lazy, frozen
from graphkin.construction import Facts, Meet, Plot, Swing, replay
from graphkin.errors import GraphkinError
from graphkin.files.variants import Built, Made, OneByOne, Variants
from graphkin.model.mechanism import Mechanism
from graphkin.model.pairs import Slide
from graphkin.planning import plan
from graphkin.planning.branch_search import BETWEEN, cylinders
from graphkin.planning.method import Method, facts_of
from graphkin.planning.refusals import DEAD_SINE
from graphkin.running import replay_all
from graphkin.running.recorder import TABLES
from graphkin.running.replay_program import ReplayProgram, recorded_program
from graphkin.running.tape import CannotRecord

PART = 2048  # so many mechanisms at once; what they need stays in the cache
SAME_PLACE = 1e-9  # points of a link nearer than this to each other do not give its axis [size]; as `Link.axis` has it
CHOICES = 6  # crossings of circles of which every combination is drawn


@frozen
class DrawnVariants:
    """Many mechanisms drawn: values (n,) or (positions, n), NaN for those that are `refused`, by their numbers."""

    plot: Plot
    refused: Mapping[int, GraphkinError]


def replay_many(method: Method, variants: Variants[Made], values: Sequence[Array] | None = None) -> DrawnVariants:
    """Every mechanism of a method's topology, at its drawn position or at driver values that go with (n,); none is held
    against the analysis."""
    count, structure, columns = variants.count, method.structure, [*variants.columns.values()]
    shape = np.broadcast_shapes((count,), *map(np.shape, values or ()))
    given = None if values is None else [np.broadcast_to(value, shape) for value in values]
    sure, drawn = np.zeros(count, dtype=bool), Plot(method.facts(given))
    if (program := numbers_program(method, len(columns), variants.built)) is not None:
        cuts = [slice(start, min(start + PART, count)) for start in range(0, count, PART)]
        parts = [_assemblies(method, variants, cut) for cut in cuts]
        sure = np.concatenate([part.sure for part in parts])
        own = [np.concatenate([part.values[k] for part in parts]) for k in range(len(method.drivers))]
        sides = {choice: np.concatenate([part.sides[choice] for part in parts]) for choice in parts[0].sides}
        flat = partial(_flat, shape=shape)
        drawn = program.run([*map(flat, given or own)], {choice: flat(side) for choice, side in sides.items()},
                            numbers=[*map(flat, columns)])  # fmt: skip
    alone, refused = dict[int, Plot](), dict[int, GraphkinError]()
    for row in map(int, np.flatnonzero(~sure)):
        try:
            single = plan(variants[row], structure.coincident, structure.centres)
            alone[row] = replay_all(single, None if given is None else [value[..., row] for value in given])
        except GraphkinError as error:
            refused[row] = error
    return DrawnVariants(_together(drawn, shape, alone, refused), refused)


def numbers_program(method: Method, count: int, built: Built) -> ReplayProgram | None:
    """The replay from so many numbers of a file on; None where more hangs on them."""

    def facts(numbers: Sequence[Real]) -> Facts:
        mechanism, _ = built(cast(Sequence[Array], numbers))
        return facts_of(replace(method.structure, mechanism=mechanism), None, {})

    if not is_simple(method):
        return None
    try:
        with np.errstate(all="ignore"):
            needed = [np.ndim(a) for a in facts([np.ones(1)] * count).accelerations]
        if any(needs and not driver.acceleration for needs, driver in zip(needed, method.drivers)):
            drivers = (replace(driver, acceleration=1.0) for driver in method.drivers)  # a uniform one lacks such terms
            structure = method.structure
            accelerated = replace(method.mechanism, drivers=tuple(drivers))
            method = plan(accelerated, structure.coincident, structure.centres)
        return recorded_program(method.constructions, facts, len(method.drivers), count)
    except (OneByOne, CannotRecord):
        return None


def is_simple(method: Method) -> bool:
    """True if crossings of lines and circles are all that a position asks for: then arrays do what numbers do."""
    plain = all(type(pair) is Slide for pair in method.mechanism.pairs) and not method.mechanism.poses
    few = not method.doubtful and len(_choices(method)) <= CHOICES and bool(list(method.position.steps))
    return plain and few and not method.moves_on


def _choices(method: Method) -> list[int]:
    steps = method.position.steps
    return [step.choice for step in steps if isinstance(step, Meet | Swing) and step.choice is not None]


def _flat(value: Array, shape: tuple[int, ...]) -> Array:
    return np.broadcast_to(value, shape).reshape(-1)


def _together(drawn: Plot, shape: tuple[int, ...], alone: Mapping[int, Plot], refused: Mapping[int, object]) -> Plot:
    """A plot of arrays (n,) or (positions, n), each made when it is read: those drawn together, then single ones."""

    def read(table: str, name: str) -> Value:
        whole = np.asarray(getattr(drawn, table).get(name, np.nan))
        values = np.broadcast_to(whole, shape) if whole.ndim == 0 else whole.reshape(shape)
        if alone or refused:
            own = {row: getattr(one, table).get(name, np.nan) for row, one in alone.items()}
            values = np.array(values, dtype=np.result_type(values, *[*own.values()][:1]))
            for row, value in {**dict.fromkeys(refused, np.nan), **own}.items():
                values[..., row] = value
        return values

    plot = Plot(drawn.facts)
    for table in TABLES:
        names = dict.fromkeys(name for each in (drawn, *alone.values()) for name in getattr(each, table))
        setattr(plot, table, Lazy(names, partial(read, table)))
    return plot


def rows_of(many: Plot, rows: np.ndarray | int, plot: Plot) -> Plot:
    """A plot that is given some rows of another's, or one."""

    def read(table: Mapping[str, Value], name: str) -> Value:
        value = table[name]
        return cast(Value, value[..., rows]) if isinstance(value, np.ndarray) and value.ndim else value

    for name in TABLES:
        setattr(plot, name, Lazy(table := getattr(many, name), partial(read, table)))
    return plot


@frozen
class _Assemblies:
    """As `Assembly`, of many mechanisms: sides by choice, (n,) each; drivers' values as drawn; which are sure."""

    sides: Mapping[int, Array]
    values: Sequence[Array]
    sure: Array


def _assemblies(method: Method, variants: Variants[Made], part: slice) -> _Assemblies:
    """Every combination of crossings drawn, and for each mechanism the nearest to its sketch taken. Sure is what
    closes, lies well off its dead points, and has no other assembly that the sketch may mean; and is a mechanism whose
    points lie in one place where they do in the method's own."""
    mechanism, sound = variants.built([column[part] for column in variants.columns.values()])
    count = part.stop - part.start
    facts, sketch = facts_of(replace(method.structure, mechanism=mechanism), None, {}), mechanism.sketch
    planned, own_points = _coincidences(method.structure.mechanism), _coincidences(mechanism)
    alike = (own_points.reshape(len(planned), -1) == planned[:, None]).all(axis=0)
    choices = _choices(method)
    sides = np.array([*product((1, -1), repeat=len(choices))], dtype=float).reshape(2 ** len(choices), len(choices))
    plot = replay(method.position, Plot(facts), {choice: sides[:, [k]] for k, choice in enumerate(choices)})
    every = (len(sides), count)
    points = {point: np.broadcast_to(z, every) for point, z in plot.position.items()}
    shown = [point for point in sketch if point in points]
    far = sum((np.abs(points[point] - sketch[point]) ** 2 for point in shown), np.zeros(every))
    closed = [np.isfinite(places) for places in points.values()]
    closed += [np.broadcast_to(plot.s[name] > 0, every) for name in cylinders(method.structure)]
    far = np.where(np.all(closed, axis=0), far, np.inf)
    best, row = np.argmin(far, axis=0), np.arange(count)
    sines = [np.broadcast_to(sine, every)[best, row] for (plane, _), sine in plot.sines.items() if plane == "position"]
    nearest = far[best, row]
    clear = np.min([np.ones(count), *np.nan_to_num(sines)], axis=0) >= DEAD_SINE
    sure = sound() & alike & np.isfinite(nearest) & clear
    slides = [np.broadcast_to(s, every) for s in plot.s.values()]
    places = np.array([*points.values()])
    size = np.abs(places - places[0])[:, best, row].max(axis=0)
    for other in range(len(sides)):
        with np.errstate(invalid="ignore"):
            same = np.all([np.abs(z[other] - z[best, row]) <= 1e-9 * size for z in (*points.values(), *slides)], axis=0)
            apart = sum((np.abs(points[p][other] - points[p][best, row]) ** 2 for p in shown), np.zeros(count))
            doubt = (apart <= (1e-9 * size) ** 2) | (far[other] - nearest < BETWEEN * apart)
        sure &= same | ~np.isfinite(far[other]) | ~doubt
    values = [np.broadcast_to(value, count) for value in facts.values]
    return _Assemblies({choice: sides[best, k] for k, choice in enumerate(choices)}, values, sure)


def _coincidences(mechanism: Mechanism) -> Array:
    """Points of a link in one place (0) or nearly (1), lines that are their links' own axes: (k,), or (k, b)."""
    rows: list[Array] = [np.equal(slide.line.direction, 1) for slide in mechanism.slides]
    for link in mechanism.links.values():
        points: list[Value] = [*link.points.values()]
        size: Value = 0.0
        for z in points:
            size = np.maximum(size, np.abs(z - points[0]))
        for k, z in enumerate(points):
            gaps = [np.abs(z - other) for other in points[:k]]
            rows += [np.where(gap == 0, 0, np.where(gap <= SAME_PLACE * size, 1, 2)) for gap in gaps]
    return np.array(np.broadcast_arrays(*rows), dtype=np.int8) if rows else np.zeros(0, dtype=np.int8)
