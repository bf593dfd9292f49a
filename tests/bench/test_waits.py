"""What people wait for, in CPU time, each beside a part of the same run: centres, tolerances, a handout of long chains."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Mapping
from dataclasses import replace

import pytest
from large_mechanisms import dyads

from graphkin import loads
from graphkin.construction import Plane
from graphkin.files.loader import MechanismFile
from graphkin.handouts import handout
from graphkin.homework.grading.keys import marking_of
from graphkin.marking.key_making import make_key
from graphkin.marking.tolerances import tolerances
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.say.centre_velocities import centre_lines
from graphkin.sheet import scales_of
from graphkin.sheet.paper import KEYS
from graphkin.studies.centres import centres
from graphkin.studies.linkages.inversion import filed

MOST = 2.5
"""The power with which centres may grow from 16 dyads to 64: they are N(N-1)/2 for N links. A quiet machine gives 2."""


def chain(count: int) -> MechanismFile:
    return loads(filed(dyads(count, kinds=("RRR",))).text, name="chain")


def seconds(work: Callable[[], object], times: int = 2) -> float:
    """The least CPU time of some tries."""

    def once() -> float:
        start = time.thread_time()
        work()
        return time.thread_time() - start

    return min(once() for _ in range(times))


@pytest.mark.bench
def test_centres_grow_with_their_number(capsys: pytest.CaptureFixture[str]) -> None:
    took, planned = dict[int, float](), dict[int, float]()
    for count in (16, 32, 64):
        machine = chain(count)
        method = plan(machine)
        plot = replay_all(method)
        planned[count] = seconds(lambda machine=machine: replay_all(plan(replace(machine))))
        took[count] = seconds(lambda method=method, plot=plot: [*centre_lines(centres(method, plot), "en")])
    power = {count: math.log2(took[count] / took[count // 2]) for count in (32, 64)}
    with capsys.disabled():
        print("\ncentres of 16, 32, 64 dyads, ms: " + ", ".join(f"{1e3 * each:.0f}" for each in took.values()))
        print("beside planning and drawing them: " + ", ".join(f"{took[count] / planned[count]:.1f}" for count in took))
        print("power of the growth: " + ", ".join(f"{each:.2f}" for each in power.values()))
    assert sum(power.values()) / 2 < MOST


@pytest.mark.bench
def test_tolerances_and_a_handout_beside_the_sheet(capsys: pytest.CaptureFixture[str]) -> None:
    """The handout, which is told alone, takes twice the sheet: with GRAPHKIN_RANDOM in the environment."""
    machine = chain(8)
    method, plot = plan(machine), replay_all(plan(machine))
    scales: list[Mapping[Plane, float]] = []
    sheet = seconds(lambda: scales.append(scales_of(method, plot)), 1)
    marking = marking_of(method, scales={KEYS[plane]: scale for plane, scale in scales[0].items()})
    key, marks = (seconds(lambda marks=marks: make_key(method, marking, marks=marks), 1) for marks in (False, True))
    told = seconds(lambda: tolerances(make_key(method, marking, marks=False), method), 1)
    solution = seconds(lambda: handout([machine], "solution", "en"), 1) if "GRAPHKIN_RANDOM" in os.environ else math.nan
    with capsys.disabled():
        print(f"\n8 dyads, beside the arrangement of their sheet ({1e3 * sheet:.0f} ms): a key to be read {key / sheet:.2f}, "
              f"one to mark by {marks / sheet:.2f}; tolerances {1 + told / sheet:.2f}, solution {solution / sheet:.2f}")  # fmt: skip
    assert key < 0.5 * marks
