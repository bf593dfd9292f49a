"""Many mechanisms of one file at once, `replay`, `motion` and `sweep` of `Mechanism.variants`; and one again and again,
as one who looks for an optimum asks for it."""

from __future__ import annotations

import numbers
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from graphkin.analytic import Motion, motion
from graphkin.base.cache import kept
from graphkin.base.geometry import Real
from graphkin.base.value import filled
from graphkin.errors import GraphkinError, RoadsDiffer, WrongCount
from graphkin.files import MechanismFile
from graphkin.files.builder import places_of
from graphkin.files.variants import OneByOne, Variants, built, in_si, parts_of, within
from graphkin.model.mechanism import KeyPath
from graphkin.model.readout import State
from graphkin.planning import Method, plan
from graphkin.proof.readings import places, readings
from graphkin.proof.roads import AGREE, held, hold_rows
from graphkin.running import replay_all
from graphkin.running.recorder import TABLES, Entry
from graphkin.running.replay_program import ReplayProgram
from graphkin.running.variants import numbers_program, replay_many
from graphkin.studies.sweeps import Ranges, Road, course
from graphkin.studies.sweeps.course import given_ranges

Many: TypeAlias = Variants[MechanismFile]
Values: TypeAlias = Sequence[ArrayLike] | None


@kept(4)
def method_of(variants: Many) -> Method:
    """The method by which all are drawn. Raises what is wrong with the first."""
    return variants.first(plan)


def replayed(variants: Many, values: Values, held: bool) -> State:
    """As `api.replay` has it: values (n,) or (positions, n)."""
    method, goals = method_of(variants), _beside(values)
    drawn = replay_many(method, variants, goals)
    if held:
        hold_rows(method, variants, goals, drawn)
    return State(partial(readings, method, drawn.plot), drawn.plot, places(method), drawn.refused)


def moved(variants: Many, values: Values) -> State:
    """As `api.motion` has it, one after another: values (n,) or (positions, n)."""
    there, refused, goals = dict[int, Motion](), dict[int, GraphkinError](), _beside(values)
    shape = np.broadcast_shapes((len(variants),), *map(np.shape, goals or ()))
    every = None if goals is None else [np.broadcast_to(value, shape) for value in goals]
    for row in range(len(variants)):
        try:
            there[row] = motion(variants[row], None if every is None else [value[..., row] for value in every])
        except GraphkinError as error:
            refused[row] = error
    if not there:
        raise refused[0]

    def together(parts: Sequence[Any]) -> Any:
        """Tables and tuples of values as such of arrays."""
        if isinstance(parts[0], Mapping):
            return {name: together([part[name] for part in parts]) for name in parts[0]}
        if isinstance(parts[0], tuple):
            return tuple(map(together, zip(*parts, strict=True)))
        values = np.full(shape, np.nan, dtype=np.result_type(float, *parts))
        values[..., [*there]] = np.stack(parts, axis=-1)
        return values

    first, *_ = each = [vars(one) for one in there.values()]
    tables = {name: together([one[name] for one in each]) for name in first.keys() - {"mechanism", "idle"}}
    return State(replace(next(iter(there.values())), **tables), refused=refused)


def swept(variants: Many, ranges: Ranges, of: Sequence[str], by: Road) -> State:
    """As `api.sweep` has it: values (positions, n)."""
    values = positions(method_of(variants), ranges)
    many = replayed(variants, values, held=True) if by == "construction" else moved(variants, values)
    for text in of:
        many.quantity(text)  # a wrong name is said at once
    return many


def _beside(values: Values) -> list[np.ndarray] | None:
    """Positions (m,) as (m, 1), beside mechanisms."""
    arrays = [np.asarray(value, dtype=float) for value in (() if values is None else values)]
    return None if values is None else [value[:, None] if value.ndim == 1 else value for value in arrays]


def positions(method: Method, ranges: Ranges) -> list[Real]:
    """Each driver's values over ranges, as `api.sweep` has them; a driver without one stands still [rad, m]. No ranges:
    all as far as they get."""
    spans = given_ranges(method, ranges)
    if not spans:
        whole = course(method)
        return [*whole.path.values(whole.t)]
    return [drawn if (span := spans.get(k)) is None else span.values if span.moves else span.begin
            for k, drawn in enumerate(method.facts(None).values)]  # fmt: skip


@filled
class Trial:
    """A mechanism with other values of some names, at positions that stay: `graphkin.trial` makes it.

    Called with a value for each name it gives a `State`, in a tenth of a millisecond for a point at 361 positions; in
    some milliseconds where wheels, cams, links that are fitted or an angle not between two given lengths want to be
    planned anew. That is not proved, is drawn on the branch of the mechanism that it was made of, and is nan where
    links do not reach each other; all of it for numbers that no mechanism has, a length below nought: `refused[0]` says
    why. What is then taken is proved: `taken`.
    """

    mechanism: MechanismFile
    paths: dict[str, KeyPath]  # of the names
    method: Method
    values: list[np.ndarray]
    asked: set[Entry]

    @classmethod
    def of(cls, mechanism: MechanismFile, names: Sequence[str], over: Ranges) -> Trial:
        """See `graphkin.trial`."""
        method = plan(mechanism)
        values = np.broadcast_arrays(*map(np.atleast_1d, positions(method, over)))
        paths = dict(zip(names, places_of(mechanism, dict.fromkeys(names))))
        return cls(mechanism, paths, method, [*values], set())

    def __repr__(self) -> str:
        return f"<Trial of {self.mechanism.name}: {', '.join(self.paths)} at {self.values[0].size} position(s)>"

    def __call__(self, *values: object) -> State:
        """All positions with these values: numbers, or places (x, y), in the units of the file."""
        return self._state(self.values, values)

    def taken(self, *values: object) -> State:
        """The same, held against the analysis. Its `mechanism` has these values, and in its sketch the places at which
        the trial draws its points. Raises RoadsDiffer, and what reading, planning and moving it raise."""
        found, sketch = self(*values), dict[str, object]()
        if self._program is not None:
            drawn = self._state([np.array([value]) for value in self.method.facts(None).values], values).position
            there = {point: drawn[point].mm[0] for point in self.mechanism.sketch}  # type: ignore[index]
            sketch = {f"sketch.{point}": place for point, place in there.items() if np.isfinite(place)}
        method = plan(self.mechanism.with_({**dict(zip(self.paths, values)), **sketch}))
        plot = held(method, self.values)
        state = State(partial(readings, method, plot), plot, places(method))
        for point in self.mechanism.points:
            off = float(np.nanmax(np.abs(np.subtract(state.position[point], found.position[point])), initial=0.0))
            if off > AGREE * method.size:
                raise RoadsDiffer(method.mechanism.where("sketch", point), off / method.size)
        return state

    def _state(self, drivers: Sequence[Real], values: Sequence[object]) -> State:
        if len(values) != len(self.paths):
            raise WrongCount(self.mechanism.where(), len(self.paths), len(values))
        given = zip(self.paths.values(), values)
        parts = dict(part for path, value in given for part in parts_of(self.mechanism, path, value))
        try:
            if self._program is None or any(map(np.ndim, parts.values())):  # type: ignore[arg-type]
                raise OneByOne
            si = {place: in_si(self.mechanism, place, part) for place, part in parts.items()}
            if not all(within(self.mechanism, *number) for number in si.items()):
                raise OneByOne
            method, plot = self.method, self._program.run(drivers, asked=self.asked, numbers=[*si.values()])
        except OneByOne:
            return self._alone(drivers, values, [*parts.values()])
        return State(partial(readings, method, plot), plot, places(method))

    def _alone(self, drivers: Sequence[Real], values: Sequence[object], parts: Sequence[object]) -> State:
        """That of a mechanism by itself; nan where numbers are those of none. Raises what is wrong with no numbers."""
        method, refused = self.method, dict[int, GraphkinError]()
        try:
            method = plan(self.mechanism.with_(dict(zip(self.paths, values))))
        except GraphkinError as error:
            if not all(isinstance(part, numbers.Real) for part in parts):
                raise
            refused = {0: error}
        plot = replay_all(method, drivers)
        for table in TABLES if refused else ():
            setattr(plot, table, {name: value * np.nan for name, value in getattr(plot, table).items()})
        return State(partial(readings, method, plot), plot, places(method), refused)

    @cached_property
    def _program(self) -> ReplayProgram | None:
        """The replay of all positions from the values on; None where more hangs on them."""
        values = {path: given.written for path in self.paths.values() if (given := self.mechanism.given.get(path))}
        places = [place for path, value in values.items() for place, _ in parts_of(self.mechanism, path, value)]
        made = partial(built, self.mechanism, places)
        return numbers_program(self.method, len(places), made) if len(values) == len(self.paths) else None
