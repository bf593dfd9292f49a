"""Spoilt files and hostile command lines: never a traceback, a status that is not promised, or an end that does not come.

`GRAPHKIN_FUZZ=20000 pytest tests/test_fuzz.py` runs that many, with limits of time and memory, in processes of their own.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import fuzzing
import pytest

COUNT = int(os.environ.get("GRAPHKIN_FUZZ", "120"))
HERE, PART = 200, 500
"""Cases run in this process; cases of each of the others."""


def test_nothing_breaks_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    done = [fuzzing.run(fuzzing.case(number)) for number in range(min(COUNT, HERE))]
    assert not [(case.number, case.words, case.fault) for case in done if case.fault]


@pytest.mark.parametrize("begin", range(HERE, COUNT, PART))
def test_nothing_breaks_it_in_the_long_run(begin: int) -> None:
    words = [sys.executable, fuzzing.__file__, str(begin), str(min(PART, COUNT - begin))]
    found = subprocess.run(words, capture_output=True, text=True, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    assert (found.returncode, found.stdout, found.stderr) == (0, "", "")


def test_cases_are_made_from_their_numbers() -> None:
    assert fuzzing.case(7) == fuzzing.case(7) != fuzzing.case(8)
