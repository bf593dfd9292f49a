"""How work grows with the links: from a file to a drawing's numbers and words, over chains of dyads of all kinds."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
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
DRAWN = (8, 32)
"""A sheet takes longer than all else together."""
SCALES = {"length": 0.001, "velocity": 0.01, "acceleration": 0.1}
MOST = 2.5
"""How many times as long twice the links may take: 2 is a straight line, 4 a square."""


def timed(work: Callable[[], Any], times: int = 3) -> tuple[float, Any]:
    """The least CPU time of so many [ms], and what it gave."""
    best = float("inf")
    for _ in range(times):
        start = time.thread_time()
        found = work()
        best = min(best, (time.thread_time() - start) * 1e3)
    return best, found


def row(links: int) -> dict[str, float]:
    """Each step alone; whatever is kept of a mechanism is kept of another one."""
    machine, hinged = dyads(links // 2), dyads(links // 2, kinds=("RRR",))
    text = filed(hinged).text
    took: dict[str, float] = {}
    took["load"], _ = timed(lambda: graphkin.loads(text, name="hinged"))
    took["plan"], method = timed(lambda: graphkin.plan(replace(machine)))
    took["replay"], plot = timed(lambda: replay_all(method))
    took["analysis"], _ = timed(lambda: analytic.motion(replace(machine)))
    took["explain"], _ = timed(lambda: explain(method, plot, SCALES, "en"))
    if links in DRAWN:
        took["svg"], _ = timed(lambda: svg(sheet(method, plot)), times=1)
    return took


@pytest.mark.bench
def test_work_grows_with_the_links(capsys: pytest.CaptureFixture[str]) -> None:
    """From 16 links to 64 nothing grows like their square. The analysis is reported: large matrices are done by threads
    of their own, which a busy machine lets wait."""
    table = {links: row(links) for links in LINKS}
    with capsys.disabled():
        print("\nlinks " + "".join(f"{head:>10}" for head in table[DRAWN[0]]) + " [ms]")
        for links, took in table.items():
            print(f"{links:5} " + "".join(f"{value:10.1f}" for value in took.values()))
    for head in table[64].keys() - {"analysis"}:
        assert table[64][head] < MOST**2 * table[16][head], head
    assert table[32]["svg"] < MOST**2 * table[8]["svg"]
