"""Whatever is handed in, a row with its values or its reason comes out. GRAPHKIN_BROKEN sets how many are tried."""

from __future__ import annotations

import math
import os
import time
from pathlib import Path

import pytest
from broken_submissions import broken
from reading_all import read

from graphkin import api
from graphkin.errors import GraphkinError, OwnFault, TookTooLong, steers
from graphkin.submissions import Limits, ReadableProblem, Submission, safe_name

MANY = int(os.environ.get("GRAPHKIN_BROKEN", "300"))
PART = 50
MECHANISM = api.load("ex3-1")
ASKED = ReadableProblem(MECHANISM, MECHANISM.ask)


@pytest.mark.parametrize("start", range(0, MANY, PART))
def test_every_submission_is_a_row(tmp_path: Path, start: int):
    for seed in range(start, min(start + PART, MANY)):
        name, content = broken(seed)
        path = tmp_path / f"{seed}" / name
        path.parent.mkdir()
        path.write_bytes(content)
        before = time.perf_counter()
        found = list(read([path], ASKED, Limits(seconds=5.0)))
        assert time.perf_counter() - before < 8, seed
        assert found or name.endswith((".csv", ".xlsx")), seed
        for submission in found:
            _check(submission, seed)
        assert [inside.name for inside in path.parent.iterdir()] == [name], seed


def _check(submission: Submission, seed: int) -> None:
    assert not isinstance(submission.reason, OwnFault | TookTooLong), (seed, submission.reason)
    assert (submission.reason is None) == bool(submission.values) or _empty_row(submission), seed
    assert not any(steers(letter) for letter in submission.student), seed
    assert len(submission.student) <= 200, seed
    assert not set(safe_name(submission.student)) & set("/\\:."), seed
    for said in (submission.reason, *submission.notes):
        _speaks(said)
    for value in submission.values.values():
        assert value.value is None or math.isfinite(value.value), seed
        assert value.value is not None or value.fault is not None, seed
        _speaks(value.fault)


def _empty_row(submission: Submission) -> bool:
    return submission.reason is not None and not submission.values


def _speaks(said: GraphkinError | None) -> None:
    if said is not None:
        assert said.message("zh")
        assert "\n" not in said.message("en")
