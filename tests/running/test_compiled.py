"""The program made of the steps, beside plain replay: the same plot at every position, reached or not."""

from __future__ import annotations

import os
import pickle
import threading
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from programs import (
    COUNT,
    MAKERS,
    alike_on_its_way,
    around,
    by_a_program,
    hold_alike,
    least_sines,
    nudged,
    plainly,
    random_tape,
    records,
    rows,
)
from random_mechanisms import (
    circular_slot,
    epicyclic,
    geared_five_bar,
    rolling,
    triad,
)

from graphkin.errors import GraphkinError
from graphkin.files import library
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.running.other_positions import FITTED_MANY, MANY, by_program, on_one_path, program_of, replay_along
from graphkin.running.recorder import TABLES, Recorded
from graphkin.running.replay_program import BLOCK, recorded_program
from graphkin.running.tape import CannotRecord, Tape, in_numpy
from graphkin.running.tracing import trace

MOVING_ON = {"triad": triad, "geared": geared_five_bar, "epicyclic": epicyclic, "rolling": rolling, "circular": circular_slot}


# --- the same plot ----------------------------------------------------------------------------


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_library_alike(name: str):
    method = plan(library.load(name))
    if method.moves_on:
        assert alike_on_its_way(method)
        return
    values = around(method)
    assert hold_alike(method, records(method).run(values), plainly(method, values), COUNT)


@pytest.mark.many
@pytest.mark.parametrize("kind", MAKERS)
def test_random_mechanisms_alike(kind: str):
    tried = 0
    for seed in range(40 if "GRAPHKIN_RANDOM" in os.environ else 14):
        try:
            method = plan(MAKERS[kind](seed))
        except GraphkinError:
            continue
        if not method.moves_on:
            values = around(method, 181)
            tried += hold_alike(method, records(method).run(values), plainly(method, values), 181)
    assert tried > 1000


@pytest.mark.parametrize("kind", MOVING_ON)
def test_what_moves_on_alike(kind: str):
    """Where links are fitted, or wheels roll, along the way from the drawn position; never without one."""
    tried = 0
    for seed in range(3, 8 if "GRAPHKIN_RANDOM" in os.environ else 6):
        try:
            method = plan(MOVING_ON[kind](seed))
        except GraphkinError:
            continue
        if not method.moves_on:
            continue
        assert by_program(method, around(method)) is None
        tried += alike_on_its_way(method)
    assert tried > 1000


@pytest.mark.parametrize("kind", ["RRR", "RPR", "cylinder"])
def test_one_driver_standing(kind: str):
    """A driver that is one number, or one of no dimensions, stands for all positions."""
    method = plan(MAKERS[kind](2))
    moving = around(method)[0]
    still = [float(value) for value in method.facts().values[1:]]
    plain = plainly(method, [moving, *still])
    assert still
    for values in (still, [np.array(value) for value in still], [np.full(COUNT, value) for value in still]):
        assert hold_alike(method, records(method).run([moving, *values]), plain, COUNT)


def test_other_sides():
    """Crossings taken on the other side, everywhere or from some position on."""
    method = plan(library.load("ex3-5"))
    (choice,) = records(method).sides
    values = around(method)
    later = np.where(np.arange(COUNT) > 200, -1, 1) * records(method).sides[choice]
    for side in (-1, 1, later):
        found, plain = records(method).run(values, {choice: side}), plainly(method, values, {choice: side})
        assert hold_alike(method, found, plain, COUNT)


def test_more_than_a_chunk():
    method = plan(library.load("ex3-7"))
    count = 2 * BLOCK + 77
    values = around(method, count)
    assert hold_alike(method, records(method).run(values), plainly(method, values), count) > BLOCK


def test_failing_positions_are_those_of_plain_replay():
    """Beyond a dead point, and at one, not a digit differs."""
    method = plan(library.load("fig3-6"))
    values = around(method)
    found, plain = records(method).run(values), plainly(method, values)
    bad = ~np.isfinite(least_sines(plain, COUNT))
    assert bad.any()
    assert not bad.all()
    for table in TABLES:
        for name, value in getattr(plain, table).items():
            one = rows(getattr(found, table)[name], COUNT)[bad]
            assert np.array_equal(one, rows(value, COUNT)[bad], equal_nan=True), (table, name)


def test_along_a_way_through_change_points():
    """The side that is right before a change point and behind it, and what is left at the very point."""
    changed = 0
    for name in library.names():
        method = plan(library.load(name))
        if method.moves_on:
            continue
        pace = [1.0, *[0.0] * (len(method.drivers) - 1)]
        far = 2 * np.pi if method.drivers[0].kind != "slide" else method.size
        path = trace(method, pace, -far, far)
        t = np.linspace(0.999 * path.first, 0.999 * path.last, COUNT)
        plain = plainly(method, path.values(t), path.crossings(t))
        assert hold_alike(method, replay_along(method, path, t), plain, COUNT), name
        changed += len(path.changes)
    assert changed


# --- whole calls ------------------------------------------------------------------------------


@pytest.mark.parametrize("shape", [(MANY - 1,), (MANY,), (16, 20)])
def test_any_shape(shape: tuple[int, ...]):
    """Few positions, many, and arrays of more dimensions."""
    method = plan(library.load("ex3-1"))
    angles = method.facts().values[0] + np.linspace(0, 1, int(np.prod(shape))).reshape(shape)
    found, plain = replay_all(method, [angles]), plainly(method, [angles])
    assert np.shape(found.omega["3"]) == shape
    assert np.allclose(found.omega["3"], plain.omega["3"], rtol=1e-12, atol=0)
    assert by_a_program(found) == (shape == (MANY,))


def test_where_links_are_fitted_a_program_is_made_for_many():
    """A turn or two come sooner without."""
    method = plan(library.load("p3-15"))
    values = around(method)
    turns = [replay_all(method, values) for _ in range(-(-FITTED_MANY // COUNT))]
    assert [by_a_program(plot) for plot in turns] == [False] * (len(turns) - 1) + [True]
    assert (way := on_one_path(method, values)) is not None
    assert hold_alike(method, turns[-1], turns[0], COUNT, lambda change: nudged(method, *way, 10 * change))


def test_what_can_not_be_recorded_is_replayed(monkeypatch: pytest.MonkeyPatch):
    def refuse(*_: Any) -> None:
        raise CannotRecord("a step")

    method = plan(library.load("ex3-1"))
    values = around(method)
    monkeypatch.setattr("graphkin.running.replay_program.record", refuse)
    found, plain = replay_all(method, values), plainly(method, values)
    assert program_of(method) is None
    assert np.array_equal(found.acceleration["b3'"], plain.acceleration["b3'"])


def test_no_number_at_all():
    """Angles that are no numbers give none, as plainly; what stands still remains where it is."""
    method = plan(library.load("ex3-5"))
    values = around(method)
    values[0][300:400] = np.nan
    assert hold_alike(method, records(method).run(values), plainly(method, values), COUNT)


def test_runs_share_nothing():
    """What is done with one plot, or with the angles, changes no other."""
    method = plan(library.load("ex3-5"))
    values = around(method)
    first, second, plain = (*(replay_all(method, values) for _ in range(2)), plainly(method, values))
    values[0][:] = 0.0
    for table in TABLES:
        for name in getattr(first, table):
            value = getattr(first, table)[name]
            if np.ndim(value):
                if value.flags.writeable:
                    value[:] = -1.0
                getattr(first, table)[name] = value + 1
    plain.facts = second.facts
    assert hold_alike(method, second, plain, COUNT)
    assert second.facts.values[0][-1] != 0


@pytest.mark.parametrize("name", ["ex3-5", "ex3-7", "p3-15"])
def test_what_is_worked_out_late_is_of_what_was_replayed(name: str):
    """Whatever is written into the arrays that were read, and the angles: it is refused, or changes nothing else."""
    method, late = plan(library.load(name)), ("sines", "misses", "senses", "s", "s_rate", "s_acceleration")
    values = [start + np.linspace(0, 2 * np.pi, MANY) for start in method.facts().values]
    records(method)
    found, untouched = replay_all(method, values), replay_all(method, values)
    refused = 0
    read = [each for table in TABLES if table not in late for each in getattr(found, table).values()]
    for array in (*read, *found.facts.values):
        try:
            np.asarray(array)[...] = 0.0
        except ValueError:  # it is read-only
            refused += 1
    assert by_a_program(found)
    assert refused > len(method.mechanism.points)
    for table in late:
        for key, value in getattr(untouched, table).items():
            assert np.array_equal(getattr(found, table)[key], value, equal_nan=True), (table, key)


def test_what_was_read_is_worked_out_at_once():
    """What a run is asked for is all that it does; the rest is the same, later."""
    method = plan(library.load("ex3-7"))
    values, program = around(method), records(plan(library.load("ex3-7")))
    asked = set[tuple[str, Any]]()
    first = program.run(values, asked=asked)
    read = [first.omega["4"], first.velocity["e"], first.acceleration["n4'"]]
    assert asked == {("omega", "4"), ("velocity", "e"), ("acceleration", "n4'")}
    again = program.run(values, asked=asked)
    for one, other in zip(read, (again.omega["4"], again.velocity["e"], again.acceleration["n4'"]), strict=True):
        assert np.allclose(one, other, rtol=1e-12, equal_nan=True)
    few, usual = (program.part(of).calls.calls for of in (asked, program.usual))
    assert len(few) < len(usual)
    assert hold_alike(method, again, plainly(method, values), COUNT)


def test_threads():
    """Two at once, on one method, give what one gives."""
    method = plan(library.load("ex3-7"))
    courses = [[value + shift for value in around(method, 3 * BLOCK)] for shift in (0.0, 0.1)]
    alone = [replay_all(method, course).acceleration["e'"] for course in courses]
    wrong: list[int] = []

    def work(k: int) -> None:
        for _ in range(20):
            if not np.array_equal(replay_all(method, courses[k]).acceleration["e'"], alone[k], equal_nan=True):
                wrong.append(k)

    threads = [threading.Thread(target=work, args=(k,)) for k in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_methods_and_plots_travel():
    method = plan(library.load("ex3-7"))
    values = around(method)
    plot = replay_all(method, values)
    again, there = pickle.loads(pickle.dumps((method, plot)))
    assert again == method
    assert np.array_equal(replay_all(again, values).alpha["3"], plot.alpha["3"], equal_nan=True)
    assert np.array_equal(there.alpha["3"], plot.alpha["3"], equal_nan=True)
    assert there.position.keys() == plot.position.keys()


def test_plots_are_replaced_and_added_to_as_any_plot():
    method = plan(library.load("ex3-7"))
    plot = replay_all(method, around(method))
    other = replace(plot, alpha={})
    assert other.alpha == {}
    assert np.array_equal(other.omega["3"], plot.omega["3"], equal_nan=True)
    plot.sines["position", "another"] = 1.0
    assert plot.sines.pop(("position", "another")) == 1.0
    assert ("position", "another") not in plot.sines
    with pytest.raises(AttributeError):
        plot.momentum  # noqa: B018
    with pytest.raises(KeyError):
        plot.omega["another"]


# --- the tape -------------------------------------------------------------------------------


def carried_out(tape: Tape, places: Sequence[int], *inputs: np.ndarray) -> list[np.ndarray]:
    """The results at some places."""
    calls = in_numpy(tape, len(inputs), places)
    rows, registers = np.empty((len(places), inputs[0].size)), np.empty((calls.registers, inputs[0].size))
    calls.run(inputs, [*rows], [*registers])
    return [*rows]




@pytest.mark.parametrize("seed", range(40))
def test_whatever_is_done(seed: int):
    tape, places, inputs, values = random_tape(seed)
    rows, registers = np.empty((len(places), 70)), np.empty((len(places), 70))
    in_numpy(tape, 3, places).run(inputs, [*rows], [*registers])
    for row, value in zip(rows, values, strict=True):
        assert np.allclose(row, value, rtol=1e-6, atol=1e-6)


def test_cosine_and_sine_by_one_tangent():
    """To 4e-16, near and at multiples of a quarter turn and far out as well."""
    near = np.add.outer(np.arange(-40, 41) * np.pi / 2, np.linspace(-1e-8, 1e-8, 11)).ravel()
    angle = np.concatenate([near, np.linspace(-1000, 1000, 100_003), [0.0, 1e-300, 12345678.9]])
    tape = Tape()
    cos, sin = carried_out(tape, tape.turned(tape.input(0)), angle)
    assert np.max(np.abs(cos - np.cos(angle))) <= 4e-16
    assert np.max(np.abs(sin - np.sin(angle))) <= 4e-16


ALGEBRA: list[tuple[str, Callable[..., int], Callable[..., int]]] = [
    ("x + 0", lambda do, x, y: do.add(x, do.number(0)), lambda do, x, y: x),
    ("x - x", lambda do, x, y: do.subtract(x, x), lambda do, x, y: do.number(0)),
    ("x - (-y)", lambda do, x, y: do.subtract(x, do.negative(y)), lambda do, x, y: do.add(y, x)),
    ("-x + y", lambda do, x, y: do.add(do.negative(x), y), lambda do, x, y: do.subtract(y, x)),
    ("y - x", lambda do, x, y: do.subtract(y, x), lambda do, x, y: do.negative(do.subtract(x, y))),
    ("-x y", lambda do, x, y: do.multiply(do.negative(x), y), lambda do, x, y: do.negative(do.multiply(x, y))),
    ("-2 x", lambda do, x, y: do.multiply(x, do.number(-2)), lambda do, x, y: do.negative(do.multiply(do.number(2), x))),
    ("sqrt x squared", lambda do, x, y: do.multiply(do.done("sqrt", x), do.done("sqrt", x)), lambda do, x, y: x),
    ("|-x|", lambda do, x, y: do.absolute(do.negative(x)), lambda do, x, y: do.absolute(x)),
    ("x / x", lambda do, x, y: do.divide(x, x), lambda do, x, y: do.number(1)),
    ("1 / -x", lambda do, x, y: do.reciprocal(do.negative(x)), lambda do, x, y: do.negative(do.reciprocal(x))),
    ("cos of a measured angle", lambda do, x, y: do.turned(do.done("arctan2", y, x))[0],
     lambda do, x, y: do.divide(x, do.length(x, y))),
]  # fmt: skip


@pytest.mark.parametrize(("found", "meant"), [row[1:] for row in ALGEBRA], ids=[row[0] for row in ALGEBRA])
def test_algebra(found: Callable[..., int], meant: Callable[..., int]):
    """What is one and the same is entered once, and it is the same for numbers, too."""
    tape = Tape()
    x, y = tape.input(0), tape.input(1)
    assert found(tape, x, y) == meant(tape, x, y)


@pytest.mark.parametrize(
    "do",
    [
        lambda value: value < 1, bool, np.asarray, lambda value: np.where(value, 1, 2), lambda value: value**3,
        lambda value: np.exp(value), lambda value: value + np.zeros(3), lambda value: np.sqrt(1j * value),
    ],
)  # fmt: skip
def test_what_a_tape_has_no_operation_for(do: Callable[[Any], Any]):
    tape = Tape()
    with pytest.raises(CannotRecord):
        do(Recorded(tape, tape.input(0)))


def test_numbers_that_fail_are_refused():
    tape = Tape()
    for do in (lambda: tape.reciprocal(tape.number(0)), lambda: tape.done("sqrt", tape.number(-1))):
        with pytest.raises(CannotRecord):
            do()


def test_a_program_is_made_once():
    method = plan(library.load("ex3-1"))
    assert program_of(method) is program_of(method)
    assert recorded_program(method.constructions, lambda _: method.facts(), len(method.drivers)) is not program_of(method)
