"""Many positions at once, by a program made of the method's steps; what makes no program is replayed as ever."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from weakref import finalize

import numpy as np

from graphkin.base.geometry import Value
from graphkin.construction import Plot, replay
from graphkin.planning.method import Method
from graphkin.running.path import DriverPath, along
from graphkin.running.program import TABLES, CannotRecord, Entry, ReplayProgram, recorded_program

MANY = 64
"""From so many positions on a program is worth being made: a few such sweeps take as long as making it."""
FITTED_MANY = 2000
"""The same where links are fitted: to fit so many plainly takes about as long as making the program."""
PART = 4096
"""Positions that are fitted at once."""


_PROGRAMS: dict[int, ReplayProgram | None] = {}
"""By the identity of their methods, as long as these live: methods are alike by value, and too large to be hashed."""
_ASKED: dict[int, int] = {}
"""How many positions were replayed without a program, by method, the same."""


def program_of(method: Method) -> ReplayProgram | None:
    """The program, made once; None where a step can't be written down."""
    key = id(method)
    if key not in _PROGRAMS:
        _PROGRAMS[key] = _made(method)
        finalize(method, _PROGRAMS.pop, key, None)
    return _PROGRAMS[key]


def _made(method: Method) -> ReplayProgram | None:
    try:
        return recorded_program(method.constructions, method.facts(None), method.near if method.moves_on else ())
    except CannotRecord:
        return None


def _worth_it(method: Method, count: int) -> bool:
    """Whether a program is there, or so many positions were asked for by now that it is worth being made."""
    key = id(method)
    if not method.fits or key in _PROGRAMS:
        return True
    if key not in _ASKED:
        finalize(method, _ASKED.pop, key, None)
    _ASKED[key] = _ASKED.get(key, 0) + count
    return _ASKED[key] >= FITTED_MANY


def by_program(
    method: Method,
    values: Sequence[Value],
    sides: Mapping[int, Value] | None = None,
    near: Mapping[str, Value] | None = None,
    asked: set[Entry] | None = None,
    compiled: bool | None = None,
) -> Plot | None:
    """All three constructions at driver values, scalar or (n,) each; None where they are few, or no program does it.

    near   angles and displacements close by, without which no program does positions that hang on how they are reached
    asked, compiled  as `ReplayProgram.run` has them
    """
    if method.moves_on and not near:
        return None
    shapes = {value.shape if isinstance(value, np.ndarray) else np.shape(value) for value in values} - {()}
    if len(shapes) != 1 or len(shape := shapes.pop()) != 1 or shape[0] < MANY:
        return None
    made = program_of(method) if _worth_it(method, shape[0]) else None
    return None if made is None else made.run(values, sides, near, asked, compiled)


def along_in_parts(method: Method, path: DriverPath, t: Value) -> Plot:
    """The positions at t on the path by plain replay; many in parts, so that what they need stays in the cache."""
    if np.ndim(t) != 1 or t.size <= PART:
        return along(method, path, t)
    plots = [along(method, path, part) for part in np.array_split(t, -(-t.size // PART))]
    whole = Plot(method.facts(path.values(t)), dict(path.near(t)))
    for table in TABLES:
        for name in getattr(plots[0], table):
            getattr(whole, table)[name] = _joined([getattr(plot, table)[name] for plot in plots])
    return whole


def _joined(values: Sequence[Value]) -> Value:
    """One array of many; what is a scalar in one part is the same in all."""
    return np.concatenate(values) if np.ndim(values[0]) else values[0]


def replay_along(
    method: Method, path: DriverPath, t: np.ndarray, asked: set[Entry] | None = None, compiled: bool | None = None
) -> Plot:
    """All three constructions at t (n,) on the path, each choice on the side that is right there; `asked`, `compiled`:
    as `ReplayProgram.run` has them."""
    plot = by_program(method, path.values(t), path.crossings(t), path.near(t), asked, compiled)
    return plot or replay(method.acceleration, replay(method.velocity, along_in_parts(method, path, t)))
