"""How work grows with the links: from a file to a drawing's numbers and words, over chains of dyads of all kinds."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from itertools import product
from typing import Any

import pytest
from large_mechanisms import dyads

import graphkin
from graphkin import analytic
from graphkin.outputs.svg import svg
from graphkin.running import replay_all
from graphkin.say import explain
from graphkin.sheet import sheet
from graphkin.studies.linkages.inversion import filed

LINKS = (4, 8, 16, 32, 64)
DRAWN = (4, 16)
"""A sheet takes longer than all else together."""
SCALES = {"length": 0.001, "velocity": 0.01, "acceleration": 0.1}
MOST = 2.5
"""How many times as long twice the links may take: 2 is a straight line, 4 a square."""


ROUNDS = 3, 15
"""All are timed in turns, as a busy machine is slower for a while: so often, and again so often at most if that seems to tell
of more than it should."""


def timed(work: Callable[[], Any]) -> float:
    """CPU time [ms]."""
    start = time.thread_time()
    work()
    return (time.thread_time() - start) * 1e3


def works(links: int) -> dict[str, Callable[[], Any]]:
    """Each step alone; whatever is kept of a mechanism is kept of another one."""
    machine, hinged = dyads(links // 2), dyads(links // 2, kinds=("RRR",))
    text, method = filed(hinged).text, graphkin.plan(replace(machine))
    plot = replay_all(method)
    return {
        "load": lambda: graphkin.loads(text, name="hinged"),
        "plan": lambda: graphkin.plan(replace(machine)),
        "replay": lambda: replay_all(method),
        "analysis": lambda: analytic.motion(replace(machine)),
        "explain": lambda: explain(method, plot, SCALES, "en"),
        **({"svg": lambda: svg(sheet(method, plot))} if links in DRAWN else {}),
    }


def too_fast(table: dict[int, dict[str, float]]) -> list[str]:
    """What grows faster than it may."""
    return [head for head in table[64].keys() - {"analysis"} if table[64][head] >= MOST**2 * table[16][head]]


@pytest.mark.bench
def test_work_grows_with_the_links(capsys: pytest.CaptureFixture[str]) -> None:
    """From 16 links to 64 nothing grows like their square. The analysis is reported: large matrices are done by threads
    of their own, which a busy machine lets wait."""
    jobs = {links: works(links) for links in LINKS}
    table = {links: dict.fromkeys(job, float("inf")) for links, job in jobs.items()}
    for count in range(ROUNDS[1]):
        if count >= ROUNDS[0] and not too_fast(table):
            break
        for (links, job), head in product(jobs.items(), jobs[DRAWN[0]]):
            if head in job and (not count or head != "svg"):
                table[links][head] = min(table[links][head], timed(job[head]))
    with capsys.disabled():
        print("\nlinks " + "".join(f"{head:>10}" for head in table[DRAWN[0]]) + " [ms]")
        for links, took in table.items():
            print(f"{links:5} " + "".join(f"{value:10.1f}" for value in took.values()))
    assert too_fast(table) == []
    assert table[16]["svg"] < MOST**2 * table[4]["svg"]
