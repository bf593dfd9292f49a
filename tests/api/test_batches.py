"""Many mechanisms on processes and on a cluster: the same results, in order, with few in flight."""

from __future__ import annotations

import multiprocessing
import warnings
from collections.abc import Iterable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest
from random_mechanisms import dyad

import graphkin
from graphkin import api, solve_many, sweep_many
from graphkin.api.batches import Swept
from graphkin.errors import GraphkinError
from graphkin.files import library

RANGES: list[str] = []
OF: list[str] = []


@pytest.fixture(scope="module")
def sources(tmp_path_factory: pytest.TempPathFactory) -> list[object]:
    """Library names, mechanisms, and a file that cannot be read."""
    broken = tmp_path_factory.mktemp("sources") / "broken.toml"
    broken.write_text("[frame\n", encoding="utf-8")
    return ["ex3-1", "ex3-7", *(dyad("RRR", seed) for seed in range(4)), broken, "fig3-10", library.load("p3-23a")]


@pytest.fixture(scope="module")
def plainly(sources: list[object]) -> list[Swept]:
    """In this process, one after the other."""
    return list(sweep_many(sources, RANGES, OF))


def same(one: Iterable[Swept], other: Iterable[Swept]) -> int:
    count = 0
    for first, second in zip(one, other, strict=True):
        count += 1
        assert (first.name, first.driver, first.reach) == (second.name, second.driver, second.reach) or first.error
        assert (first.error and first.error.message()) == (second.error and second.error.message())
        assert np.array_equal(first.driven, second.driven)
        for a, b in zip(first.found.values(), second.found.values(), strict=True):
            assert (a.name, a.unit) == (b.name, b.unit)
            assert np.array_equal(a.values, b.values, equal_nan=True)
    return count


def test_processes_give_the_same(sources: list[object], plainly: list[Swept]):
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        assert same(sweep_many(sources, RANGES, OF, executor=pool, batch=4), plainly) == len(sources)


def test_a_cluster_gives_the_same(sources: list[object], plainly: list[Swept]):
    distributed = pytest.importorskip("distributed", reason="needs graphkin[dask]")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with distributed.Client(n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None) as client:
            found = list(sweep_many(sources, RANGES, OF, executor=client.get_executor(), batch=4))
    assert same(found, plainly) == len(sources)


def test_a_bad_one_stops_nothing(plainly: list[Swept]):
    assert [result.name for result in plainly if result.error] == ["broken"]
    assert "broken.toml" in next(result.error.message() for result in plainly if result.error)


class Counting(ThreadPoolExecutor):
    """How many were sent and not yet asked for, at most."""

    most = taken = 0

    def submit(self, *args, **kwargs):
        self.most = max(self.most, self.taken)
        return super().submit(*args, **kwargs)


def test_few_are_in_flight():
    pool = Counting(2)
    given = 0

    def endless() -> Iterator[str]:
        nonlocal given
        while True:
            given += 1
            pool.taken = given - got
            yield "ex3-1"

    got = 0
    with pool:
        for _ in sweep_many(endless(), ["0:90:30"], executor=pool, batch=3, in_flight=4):
            got += 1
            if got == 60:
                break
    assert pool.most <= 3 * (4 + 1)


def test_any_executor_will_do():
    assert issubclass(ThreadPoolExecutor, Executor)
    with ThreadPoolExecutor(2) as pool:
        names = ["ex3-1", "ex3-5", "ex3-7"] * 5
        assert [result.name for result in graphkin.sweep_many(names, RANGES, executor=pool, batch=2)] == names


def test_many_are_solved_as_one_is():
    """Each has the value, or the error, that it has alone."""
    machine = library.load("ex3-5")
    many = [machine.with_(AB=length) for length in (20, 24, 500, 28)]
    found = list(solve_many(many, ["omega 3"]))
    assert [solved.error is None for solved in found] == [True, True, False, True]
    for one, solved in zip(many, found, strict=True):
        try:
            assert solved["omega 3"] == float(api.Drawing.of(one)["omega 3"])
        except GraphkinError as error:
            assert solved.error is not None
            assert solved.error.message() == error.message()
            assert len(solved) == 0
