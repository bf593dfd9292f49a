"""Each student's marking has its time: one that takes too long is one row, and costs nobody else theirs."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest

from graphkin.homework.grading import grade, key_from
from graphkin.marking.marker import Marker
from graphkin.submissions import Limits


def test_marking_that_takes_too_long_is_one_row(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    for k in range(4):
        (tmp_path / f"s{k}.txt").write_text(f"omega 3 = -3.9{k}")
    mark = Marker.mark

    def slow(self: Marker, works: Any) -> Any:
        if any(work.student == "s2" for work in works):
            time.sleep(60)
        return mark(self, works)

    monkeypatch.setattr(Marker, "mark", slow)
    began = time.monotonic()
    found = list(grade(key_from("ex3-1"), [tmp_path], Limits(seconds=0.4)))
    assert time.monotonic() - began < 15
    assert [one.marked is not None for one in found] == [True, True, False, True]
    assert "0.4 s" in found[2].reason.message("en")  # type: ignore[union-attr]
    assert not found[2].prints
