"""Other positions: whether a mechanism gets there from the drawn one, and how, where each hangs on the one before.

Many at once are done by a program made of the method's steps; what makes no program is replayed as ever.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from weakref import finalize

import numpy as np

from graphkin.base.geometry import Real, number
from graphkin.construction import Plot, replay
from graphkin.errors import NotReached
from graphkin.model.quantities import EDGE, driven
from graphkin.planning import Method
from graphkin.running.path import STEP_DEG, STEP_PART, DriverPath, along, stride, turned
from graphkin.running.recorder import Entry
from graphkin.running.replay_program import ReplayProgram, recorded_program
from graphkin.running.tape import CannotRecord
from graphkin.running.tracing import trace

SURPRISE = 0.02  # a link may turn so far beside what its turning so far foretold [rad]; more, and the step is halved
SHORTEST = 1 / 256  # steps are not halved below this part of the longest, for many positions at once
MANY = 64  # from so many positions on a program is worth being made: a few such sweeps take as long as making it
FITTED_MANY = 2000  # the same where links are fitted: to fit so many plainly takes about as long as making the program

_PROGRAMS: dict[int, ReplayProgram | None] = {}
"""By the identity of their methods, as long as these live: methods are alike by value, and too large to be hashed."""
_COUNTS: dict[int, int] = {}  # numbers of positions that were replayed without a program, by method, the same


def reached(method: Method, values: Sequence[Real]) -> tuple[DriverPath, float]:
    """The path to a position, and how far on it; the other way round where only that one is free of dead points."""
    path, t = _to(method, values)
    if path.leads_to(t):
        return path, t
    starts = zip(method.facts(None).values, values, method.drivers, strict=True)
    second, far = _to(method, [
        end - np.copysign(2 * np.pi, end - begin) if driver.kind == "angle" and end != begin else end
        for begin, end, driver in starts
    ])  # fmt: skip
    if method.structure.contacts or not second.leads_to(far):
        moving = int(np.argmax(np.abs(path.pace)))
        driver = method.drivers[moving]
        unit = EDGE[driven(driver.kind == "slide")]
        start, end, stop = (unit.shown(number(path.values(at)[moving])) for at in (0.0, t, path.last))
        raise NotReached(method.mechanism.where("driver", moving), driver.name, start, end, stop)
    return second, far


def _to(method: Method, values: Sequence[Real]) -> tuple[DriverPath, float]:
    """The straight path from the drawn position: t counts the driver that goes farthest."""
    start = np.array([number(value) for value in method.facts(None).values])
    change = np.array([number(value) for value in values]) - start
    t = float(np.max(np.abs(change), initial=0.0))
    pace = change / t if t else np.zeros_like(change)
    return trace(method, tuple(pace), 0.0, t), t


def moved_to(method: Method, values: Sequence[Real]) -> Plot:
    """One position, reached from the drawn one; or many, all at once. Where each position hangs on the one before (a
    fit, rolling) the many are reached by moving on, too."""
    if not any(np.ndim(value) for value in values):
        return along(method, *reached(method, values))
    if not method.moves_on:
        return replay(method.position, Plot(method.facts(values)))
    course = on_one_path(method, values)
    return _fanned(method, values) if course is None else along(method, *course)


def on_one_path(method: Method, values: Sequence[Real]) -> tuple[DriverPath, np.ndarray] | None:
    """Many positions on one path, where each hangs on the one before; nan where it does not lead. None: on no one."""
    if not method.moves_on or not any(np.ndim(value) for value in values):
        return None
    start = np.array(method.facts(None).values)
    change = np.array([value - begin for value, begin in zip(np.broadcast_arrays(*values), start, strict=True)])
    far = change.reshape(len(start), -1)
    line = far[:, int(np.argmax(np.abs(far).sum(axis=0)))]
    along_it = np.tensordot(line, change, 1) / max(float(line @ line), np.finfo(float).tiny)
    if not np.allclose(np.multiply.outer(line, along_it), change, rtol=0, atol=1e-12):
        return None
    path = trace(method, tuple(line), float(min(along_it.min(), 0.0)), float(max(along_it.max(), 0.0)))
    return path, np.where(path.leads_to(along_it), along_it, np.nan)[()]


def _fanned(method: Method, values: Sequence[Real]) -> Plot:
    """Every position on its own straight path, step by step; a step that surprises one of them is halved for all."""
    facts = method.facts(values)
    start = method.facts(None).values
    changes = [np.asarray(end) - begin for begin, end in zip(start, facts.values, strict=True)]
    farthest = tuple(float(np.max(np.abs(change))) for change in changes)
    longest = min(1.0, stride(method, farthest, STEP_DEG, STEP_PART))
    done, step = 0.0, longest
    near: dict[str, Real] = {**method.near}
    slope: dict[str, Real] = dict.fromkeys(near, 0.0)
    while True:
        there = min(1.0, done + step)
        at = tuple(begin + change * there for begin, change in zip(start, changes, strict=True))
        guess = {name: near[name] + slope[name] * (there - done) for name in near}
        plot = replay(method.position, Plot(replace(facts, values=at), guess))
        now = turned(method, plot)
        surprises = (np.nanmax(np.abs(now[b] - guess[b]), initial=0.0) for b in method.structure.bases)
        if max(surprises, default=0.0) > SURPRISE and step > longest * SHORTEST:
            step /= 2
            continue
        if there == 1.0:
            return plot
        slope = {name: np.nan_to_num((now[name] - near[name]) / (there - done)) for name in now}
        near, done, step = now, there, min(longest, 1.5 * step)


def program_of(method: Method) -> ReplayProgram | None:
    """The program, made once; None where a step can't be written down."""
    key = id(method)
    if key not in _PROGRAMS:
        try:
            near, facts = method.near if method.moves_on else (), method.facts(None)
            _PROGRAMS[key] = recorded_program(method.constructions, lambda _: facts, len(facts.values), near=near)
        except CannotRecord:
            _PROGRAMS[key] = None
        finalize(method, _PROGRAMS.pop, key, None)
    return _PROGRAMS[key]


def by_program(
    method: Method, values: Sequence[Real], sides: Mapping[int, Real] | None = None,
    near: Mapping[str, Real] | None = None, asked: set[Entry] | None = None, compiled: bool | None = None,
) -> Plot | None:  # fmt: skip
    """All three constructions at driver values, scalar or (n,) each; None where they are few, or no program does it, as
    none does positions that hang on how they are reached without angles and displacements `near` by. `asked`,
    `compiled`: as `ReplayProgram.run` has them."""
    if method.moves_on and not near:
        return None
    shapes = {value.shape if isinstance(value, np.ndarray) else np.shape(value) for value in values} - {()}
    if len(shapes) != 1 or len(shape := shapes.pop()) != 1 or shape[0] < MANY:
        return None
    key = id(method)
    if method.fits and key not in _PROGRAMS:  # not worth being made until many positions were replayed
        if key not in _COUNTS:
            finalize(method, _COUNTS.pop, key, None)
        _COUNTS[key] = _COUNTS.get(key, 0) + shape[0]
        if _COUNTS[key] < FITTED_MANY:
            return None
    program = program_of(method)
    return None if program is None else program.run(values, sides, near, asked, compiled)


def replay_along(
    method: Method, path: DriverPath, t: np.ndarray, asked: set[Entry] | None = None, compiled: bool | None = None
) -> Plot:
    """All three constructions at t (n,) on the path, each choice on the side that is right there; `asked`, `compiled`:
    as `ReplayProgram.run` has them."""
    plot = by_program(method, path.values(t), path.crossings(t), path.near(t), asked, compiled)
    return plot or replay(method.acceleration, replay(method.velocity, along(method, path, t)))
