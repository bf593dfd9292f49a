"""Programs of random mechanisms, held against plain replay."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from random_mechanisms import (
    DYADS,
    cam,
    chain,
    coupler_angle,
    cylinder,
    dyad,
    relative_angle,
    six_bar,
)

from graphkin.construction import Plot, replay
from graphkin.model.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.running.other_positions import program_of, replay_along
from graphkin.running.path import DriverPath, along
from graphkin.running.recorder import TABLES
from graphkin.running.replay_program import LazyPlot, ReplayProgram
from graphkin.running.tape import Tape
from graphkin.running.tracing import trace

COUNT = 721
OPEN_SINE = 0.1
"""Crossings that are flatter lose digits."""
FLATTER = {"velocity": 2, "omega": 2, "s_rate": 2, "acceleration": 3, "alpha": 3, "s_acceleration": 3}
"""By which power of the sine; all others by the first."""
NUDGE = 1e-13
"""What drivers are moved by to see how much a position lets rounding grow [rad, of the mechanism's size]."""
MAKERS: dict[str, Callable[[int], Mechanism]] = {
    **{kind: partial(dyad, kind) for kind in DYADS},
    "cylinder": cylinder, "relative": relative_angle, "coupler": coupler_angle, "chain": chain, "cam": cam, "six": six_bar,
}  # fmt: skip


def records(method: Method) -> ReplayProgram:
    """The program of a method that must have one."""
    found = program_of(method)
    assert found is not None, method.mechanism.name
    return found


def by_a_program(plot: Plot) -> bool:
    return isinstance(plot, LazyPlot)


def plainly(method: Method, values: Sequence[Any], sides: dict[int, Any] | None = None) -> Plot:
    plot = replay(method.position, Plot(method.facts(values)), sides)
    plot.taken = sides  # type: ignore[attr-defined]
    return replay(method.acceleration, replay(method.velocity, plot))


def around(method: Method, count: int = COUNT) -> list[np.ndarray]:
    """All drivers moving at once, far beyond what is reached: whole turns, and slides by the mechanism's size."""
    values = []
    for k, (start, driver) in enumerate(zip(method.facts().values, method.drivers, strict=True), 1):
        ways = (-0.7 * method.size, 0.9 * method.size) if driver.kind == "slide" else (-2 * np.pi * k, 2 * np.pi)
        values.append(start + np.linspace(*ways, count))
    return values


def rows(value: Any, count: int) -> np.ndarray:
    return np.broadcast_to(value, (count,))


def hold_alike(
    method: Method, found: Plot, plain: Plot, count: int, moved_by: Callable[[float], Plot] | None = None
) -> int:
    """Every table the same, to twelve digits of the largest of its kind at each position; at how many positions.

    Where a crossing is flat, rounding moves it by its inverse sine, and with it the lines of the polygons, whose own
    crossings are as flat: `FLATTER`. Where several are, the two may be as far apart as plain replay moves when its drivers
    do, by far less than anyone could tell.
    """
    with np.errstate(divide="ignore"):
        flat = np.fmax(1.0, OPEN_SINE / least_sines(plain, count))
    flat[np.isinf(flat)] = 1.0  # replayed plainly
    moved_by = moved_by or partial(besides, method, plain)
    sizes, near = sizes_of(method, plain, count), [moved_by(change) for change in (-NUDGE, NUDGE)]
    for table in TABLES:
        assert list(getattr(found, table)) == list(getattr(plain, table)), table
        for name, value in getattr(plain, table).items():
            one, other = rows(getattr(found, table)[name], count), rows(value, count)
            assert np.array_equal(np.isfinite(one), np.isfinite(other)), (table, name)
            moved = [apart(table, rows(getattr(plot, table)[name], count), other) for plot in near]
            allowed = 1e-12 * sizes.get(table, np.ones(count)) * flat ** FLATTER.get(table, 1) + np.fmax.reduce([*moved, np.zeros(count)])
            there = np.isfinite(other)
            assert np.all(apart(table, one, other)[there] <= allowed[there]), (table, name)
    return int(np.count_nonzero(flat == 1.0))


def least_sines(plot: Plot, count: int) -> np.ndarray:
    return np.minimum.reduce([np.ones(count), *(rows(sine, count) for sine in plot.sines.values())])


def besides(method: Method, plain: Plot, change: float) -> Plot:
    """Plain replay with its drivers moved a little."""
    values = [value + change * (method.size if driver.kind == "slide" else 1.0)
              for value, driver in zip(plain.facts.values, method.drivers, strict=True)]  # fmt: skip
    return plainly(method, values, plain.taken)  # type: ignore[attr-defined]


def apart(table: str, one: np.ndarray, other: np.ndarray) -> np.ndarray:
    with np.errstate(invalid="ignore"):
        far = np.abs(one - other)
        return np.abs((far + np.pi) % (2 * np.pi) - np.pi) if table == "theta" else far


def sizes_of(method: Method, plain: Plot, count: int) -> dict[str, np.ndarray]:
    """At each position, the size of what is in a table (n,)."""
    length, one = method.size, np.ones(count)

    def most(table: str) -> np.ndarray:
        return np.fmax.reduce([0 * one, *(np.abs(rows(value, count)) for value in getattr(plain, table).values())])

    places = np.fmax(most("position"), length)
    speeds = np.fmax.reduce([most("velocity"), most("s_rate"), length * most("omega")])
    changes = [most("acceleration"), most("s_acceleration"), length * most("alpha"), length * most("omega") ** 2]
    rates = np.fmax.reduce(changes)
    return {
        "position": places, "s": places, "misses": places, "theta": one, "sines": one,
        "velocity": speeds, "s_rate": speeds, "omega": speeds / length,
        "acceleration": rates, "s_acceleration": rates, "alpha": rates / length,
    }  # fmt: skip


def alike_on_its_way(method: Method, compiled: bool | None = None) -> int:
    """At how many positions of a turn, or of what is reached of it, the first driver moving, and somewhat beyond."""
    far = 2 * np.pi if method.drivers[0].kind != "slide" else method.size
    path = trace(method, [1.0, *[0.0] * (len(method.drivers) - 1)], -far, far)
    t = np.linspace(1.001 * path.first, 1.001 * path.last, COUNT)
    assert records(method)
    found, plain = replay_along(method, path, t, compiled=compiled), along(method, path, t)
    replay(method.acceleration, replay(method.velocity, plain))
    assert by_a_program(found)
    return hold_alike(method, found, plain, COUNT, lambda change: nudged(method, path, t, 10 * change))


def nudged(method: Method, path: DriverPath, t: np.ndarray, change: float) -> Plot:
    """Plain replay a little farther on the way: more than where nothing rolls, for one angle is found from the other."""
    return replay(method.acceleration, replay(method.velocity, along(method, path, t + change)))
ONE_OPERAND = ("negative", "absolute", "floor", "rint", "sign", "tan", "sqrt", "reciprocal")
TWO_OPERANDS = ("add", "subtract", "multiply", "divide", "minimum", "maximum", "arctan2")


def random_tape(seed: int) -> tuple[Tape, list[int], list[np.ndarray], list[np.ndarray]]:
    """Operations on what was there before, often on one and the same thing: their places, the inputs, and NumPy's own results."""
    rng, tape = np.random.default_rng(seed), Tape()
    inputs = [rng.uniform(0.5, 2.0, 70), rng.uniform(0.5, 2.0, 70), np.array(-1.0)]
    places, values = [tape.input(k) for k in range(3)], [np.broadcast_to(value, 70) for value in inputs]
    for number in (0.0, 1.0, -2.5):
        places.append(tape.number(number))
        values.append(np.full(70, number))
    while len(places) < 60:
        one, other = rng.integers(max(0, len(places) - 12), len(places), 2)
        two = bool(rng.random() < 0.7)
        does = str(rng.choice(TWO_OPERANDS if two else ONE_OPERAND))
        operands = [values[one], values[other]] if two else [values[one]]
        with np.errstate(all="ignore"):
            value, *beside = (getattr(np, does)(*(each + change for each in operands)) for change in (0.0, -1e-9, 1e-9))
        if np.all(np.abs(value) < 1e3) and all(np.allclose(value, each, rtol=0, atol=1e-6) for each in beside):
            of = (places[one], places[other]) if two else (places[one],)
            places.append(getattr(tape, does)(*of) if hasattr(tape, does) else tape.done(does, *of))
            values.append(value)
    return tape, places, inputs, values
