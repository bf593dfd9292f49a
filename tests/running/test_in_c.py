"""A program as a C function: the same plot as by plain replay, where a compiler is at hand and asked for."""

from __future__ import annotations

import logging
import os
import stat
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from programs import COUNT, MAKERS, alike_on_its_way, around, hold_alike, plainly, random_tape, records
from random_mechanisms import cylinder, rolling

import graphkin
from graphkin.errors import GraphkinError
from graphkin.files import library
from graphkin.model.mechanism import Mechanism
from graphkin.planning import plan
from graphkin.running import in_c, replay_all
from graphkin.running import replay_program as program
from graphkin.running.in_c import compiled, compiler

ONE = "long long run(long long n, long long begin, long long end, const double *const *in, double *out) { return n; }"


@pytest.fixture(scope="module", autouse=True)
def cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A cache folder of the tests' own."""
    folder = tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(folder))
        patch.delenv("GRAPHKIN_CC", raising=False)
        compiled.cache_clear()
        yield folder / "graphkin"
        compiled.cache_clear()


@pytest.fixture
def called(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The texts for which a function was used."""
    texts: list[str] = []

    def spied(text: str, command: str) -> in_c.Function | None:
        function = compiled(text, command)
        if function is not None:
            texts.append(text)
        return function

    monkeypatch.setattr(in_c, "compiled", spied)
    return texts


@pytest.fixture
def at_hand() -> None:
    """A compiler that makes what is asked of it."""
    method = plan(library.load("ex3-1"))
    part = records(method).part(records(method).usual)
    if part.function([np.zeros(2), *map(np.array, records(method).sides.values())]) is None:
        pytest.skip("no compiler that knows functions of vectors")


KINDS: dict[str, Callable[[], Mechanism]] = {
    **{name: partial(library.load, name) for name in ("ex3-5", "p3-23a", "ex3-7", "fig3-6")},
    **{kind: partial(make, 2) for kind, make in MAKERS.items()},
}


@pytest.mark.many(12)
@pytest.mark.usefixtures("at_hand")
@pytest.mark.parametrize("kind", KINDS)
def test_the_same_plot(kind: str, called: list[str]) -> None:
    """Far beyond what is reached, and at no number at all; one driver after the other standing still."""
    try:
        method = plan(KINDS[kind]())
    except GraphkinError:
        pytest.skip("not solved")
    values = around(method)
    values[0][300:400] = np.nan
    for still in ([], range(1, len(values))):
        values = [value[:1][0] if k in still else value for k, value in enumerate(values)]
        plot = records(method).run(values, compiled=True)
        assert hold_alike(method, plot, plainly(method, values), COUNT)
    assert called


@pytest.mark.usefixtures("at_hand")
@pytest.mark.parametrize("seed", range(3))
def test_whatever_is_done(seed: int) -> None:
    tape, places, inputs, values = random_tape(seed)
    function = compiled(in_c.written(tape, [True, True, False], [], places, tape.one, 0.0), compiler())
    assert function is not None
    room = np.empty((len(places) + 1, 70))
    assert not function(inputs, room.ravel(), 70 * len(places), [slice(0, 50), slice(50, 70)])
    for row, value in zip(room, values):
        assert np.allclose(row, value, rtol=1e-6, atol=1e-6)


@pytest.mark.usefixtures("at_hand")
@pytest.mark.parametrize("mechanism", [partial(library.load, "p3-15"), partial(rolling, 3)])
def test_what_moves_on(mechanism: Callable[[], Mechanism], called: list[str]) -> None:
    """Where links are fitted, or wheels roll."""
    assert alike_on_its_way(plan(mechanism()), compiled=True)
    assert called


@pytest.mark.usefixtures("at_hand")
def test_more_than_a_block(called: list[str]) -> None:
    method = plan(library.load("fig3-6"))
    values = around(method, 2 * program.BLOCK + 77)
    assert hold_alike(method, replay_all(method, values, True), plainly(method, values), values[0].size)
    assert called


@pytest.mark.usefixtures("at_hand")
def test_when_a_compiler_is_asked(called: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """Of very many positions, or where one says so; not with GRAPHKIN_CC=none."""
    monkeypatch.setattr(program, "VERY_MANY", 500)
    method = plan(library.load("ex3-1"))
    few, many = ([60 + np.linspace(0, 57, count)] for count in (499, 500))
    for values, asked, uses in ((few, None, 0), (many, None, 1), (many, False, 1), (few, True, 2)):
        graphkin.replay(method, values, compiled=asked)
        assert len(called) == uses
    monkeypatch.setenv("GRAPHKIN_CC", "none")
    assert compiler() == ""
    graphkin.replay(method, many, compiled=True)
    assert len(called) == 2


@pytest.mark.usefixtures("at_hand")
def test_long_programs_are_left_to_numpy(called: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(program, "MOST_CALLS", 50)
    method = plan(library.load("ex3-1"))
    values = around(method)
    assert hold_alike(method, replay_all(method, values, True), plainly(method, values), COUNT)
    assert not called


@pytest.mark.usefixtures("at_hand")
def test_sweeps_ask_too(called: list[str]) -> None:
    mechanism = library.load("ex3-7")
    degrees = {"AB": np.linspace(0, 360, 3 * program.BLOCK)}
    plain = graphkin.sweep(mechanism, degrees, "theta 4, v E, a E")
    assert not called
    swept = graphkin.sweep(mechanism, degrees, "theta 4, v E, a E", compiled=True)
    assert called
    for name in plain:
        assert np.max(np.abs(swept[name].values - plain[name].values)) <= 1e-12 * np.max(np.abs(plain[name].values))


# --- the compiler -----------------------------------------------------------------------------


@pytest.mark.parametrize("failing", ["false", "/no/such/compiler", "true", "cc -no-such-option", "cc '", " "])
def test_a_compiler_that_fails(failing: str, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture) -> None:
    """NumPy does it, and a note for who looks for one."""
    monkeypatch.setenv("CC", failing)
    method = plan(library.load("ex3-1"))
    values = around(method)
    with caplog.at_level(logging.DEBUG, "graphkin"):
        plot = records(method).run(values, compiled=True)
    assert hold_alike(method, plot, plainly(method, values), COUNT)
    assert bool(caplog.records) == (failing not in ("/no/such/compiler", " "))
    assert all(record.levelno == logging.DEBUG for record in caplog.records)


def test_compiled_once_in_a_private_folder(cache: Path, tmp_path: Path) -> None:
    """By whichever process came first, in a folder that is nobody else's."""
    counted = tmp_path / "counted"
    script = tmp_path / "compiler"
    script.write_text(f'#!/bin/sh\necho x >> {counted}\nexec cc "$@"\n')
    script.chmod(0o700)
    work = f"import ctypes; from graphkin.running.in_c import compiled; print(compiled({ONE!r}, {str(script)!r}).run(7, 0, 0, None, None))"
    for _ in range(2):
        done = subprocess.run([sys.executable, "-c", work], capture_output=True, text=True, check=True)
        assert done.stdout.strip() == "7"
    assert counted.read_text() == "x\n"
    assert stat.S_IMODE(cache.stat().st_mode) == 0o700
    assert {file.suffix for file in cache.iterdir()} == {".so"}


def test_processes_at_once(cache: Path) -> None:
    """None of them sees half a file."""
    text = ONE.replace("return n", "return n + 1")
    work = f"from graphkin.running.in_c import compiled; print(compiled({text!r}, 'cc').run(7, 0, 0, None, None))"
    at_once = [subprocess.Popen([sys.executable, "-c", work], stdout=subprocess.PIPE, text=True) for _ in range(3)]
    assert [each.communicate()[0].strip() for each in at_once] == ["8"] * 3
    assert {file.suffix for file in cache.iterdir()} == {".so"}


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="no owners of folders")
def test_a_folder_that_others_may_write_in_is_not_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "graphkin"
    folder.mkdir()
    folder.chmod(0o777)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert compiled(ONE.replace("return n", "return n + 2"), "cc") is None
    assert not [*folder.iterdir()]


@pytest.mark.usefixtures("at_hand")
def test_threads(called: list[str]) -> None:
    """Two at once, on one method, give what one gives."""
    method = plan(cylinder(2))
    courses = [[value + shift for value in around(method, 3 * program.BLOCK)] for shift in (0.0, 0.001)]
    alone = [replay_all(method, course, True).alpha for course in courses]
    wrong: list[int] = []

    def work(k: int) -> None:
        for _ in range(10):
            alpha = replay_all(method, courses[k], True).alpha
            if not all(np.array_equal(alpha[link], alone[k][link], equal_nan=True) for link in alpha):
                wrong.append(k)

    threads = [threading.Thread(target=work, args=(k,)) for k in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert called
    assert not wrong
