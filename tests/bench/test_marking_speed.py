"""How fast submissions of numbers are marked, diagnosed and written: beside reading them, and by two processes."""

from __future__ import annotations

import os
import time
from pathlib import Path

import numpy as np
import pytest

import graphkin
from graphkin.homework.grading import grade, judge_from, key_from
from graphkin.homework.grading.running import MarkingOptions, items
from graphkin.marking.marker import Marker

STUDENTS, CLASSES = (1000, 6000) if "GRAPHKIN_RANDOM" in os.environ else (500, 1000)


def class_table(path: Path, name: str, count: int) -> Path:
    """A third of the class works right, a third makes a mistake, a third hands in numbers of its own."""
    key = key_from(name)
    table = Marker(key).table
    rng, rows = np.random.default_rng(1), []
    for k in range(count):
        row = rng.integers(len(key.singles.names))
        values, scatters = (key.singles.values[row], key.singles.scatters[row]) if k % 3 else (table.right, table.scatter)
        drawn = values + scatters * rng.standard_normal(len(values))
        rows.append(table.right * rng.uniform(0.3, 3, len(values)) if k % 3 == 2 else drawn)
    heads = ",".join(f'"{entry.text}"' for entry in key.entries)
    cells = "\n".join(f"s{k}," + ",".join(f"{v:.5g}" if np.isfinite(v) else "" for v in row) for k, row in enumerate(rows))
    path.write_text(f"student,{heads}\n{cells}\n", encoding="utf-8")
    return path


@pytest.mark.bench
@pytest.mark.parametrize("name", ["ex3-1", "ex3-7"])
def test_submissions_a_second(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    path = class_table(tmp_path / "class.csv", name, STUDENTS)
    start = time.process_time()
    assert sum(1 for _ in items([path], MarkingOptions(), judge_from(name))) == STUDENTS
    begun = time.process_time()
    count = sum(one.marked is not None for one in grade(name, [path]))
    took = time.process_time() - begun
    with capsys.disabled():
        print(f"\n{name}: {count / took:.0f} submissions a second, {took / (begun - start):.1f} times what reading their table takes")
    assert count == STUDENTS


@pytest.mark.bench
def test_two_processes_that_mark(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """Many submissions into a folder of results. The quotient of the clock counts where both cores are free; that of
    the work, half of which each core would do, tells it on a busy machine."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, range(os.cpu_count() or 1))  # the others here keep to one core
    path = class_table(tmp_path / "class.csv", "ex3-1", CLASSES)
    clock, work, written = dict[int, float](), dict[int, float](), set[bytes]()
    for workers in (0, 2):
        start, before = time.perf_counter(), os.times()
        graphkin.grade_into(tmp_path / f"{workers}", "ex3-1", path, ["json"], workers=workers)
        end = os.times()
        clock[workers], work[workers] = time.perf_counter() - start, sum(end[:4]) - sum(before[:4])
        written.add((tmp_path / f"{workers}" / "marks.json").read_bytes())
    with capsys.disabled():
        print(f"\n{CLASSES} submissions here {clock[0]:.1f} s, by two processes {clock[2]:.1f} s: {clock[0] / clock[2]:.2f} times as "
              f"fast; by their work on two free cores {2 * work[0] / work[2]:.2f}")  # fmt: skip
    assert len(written) == 1
