"""How many submissions of numbers are marked and diagnosed a second on one core."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
import pytest

from graphkin.homework.grading import grade, key_from
from graphkin.marking.marker import Marker

LEAST = 300
STUDENTS = 2000


@pytest.mark.bench
@pytest.mark.parametrize("name", ["ex3-1", "ex3-7"])
def test_submissions_a_second(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """A third of the class works right, a third makes a mistake, a third hands in numbers of its own."""
    key = key_from(name)
    table = Marker(key).table
    rng, rows = np.random.default_rng(1), []
    for k in range(STUDENTS):
        row = rng.integers(len(key.singles.names))
        values, scatters = (key.singles.values[row], key.singles.scatters[row]) if k % 3 else (table.right, table.scatter)
        drawn = values + scatters * rng.standard_normal(len(values))
        rows.append(table.right * rng.uniform(0.3, 3, len(values)) if k % 3 == 2 else drawn)
    heads = ",".join(f'"{entry.text}"' for entry in key.entries)
    cells = "\n".join(f"s{k}," + ",".join(f"{v:.5g}" if np.isfinite(v) else "" for v in row) for k, row in enumerate(rows))
    path = tmp_path / "class.csv"
    path.write_text(f"student,{heads}\n{cells}\n", encoding="utf-8")
    start = time.process_time()
    count = sum(one.marked is not None for one in grade(key, [path]))
    speed = count / (time.process_time() - start)
    with capsys.disabled():
        print(f"\n{name}: {speed:.0f} submissions a second, {len(key.entries)} values each")
    assert count == STUDENTS
    assert speed > LEAST
