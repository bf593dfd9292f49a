"""How long `graphkin draw ex3-1` takes as a whole process, beside its imports alone."""

from __future__ import annotations

import compileall
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

import graphkin

IMPORTS = "import numpy, shapely, svgwrite, click, pydantic"
LIMIT = 1.5
TRIES, ROUNDS = 15, 5


def seconds(command: list[str]) -> float:
    """Wall-clock time of one fresh process [s]."""
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


@pytest.mark.bench
def test_draw_starts_about_as_fast_as_its_imports(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """The best of several tries each, taken in turns, on a machine that does other things too: more where it does.

    Both are byte-compiled: what Python would do at the first run, were it allowed to write.
    """
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    compileall.compile_dir(Path(graphkin.__file__).parent, quiet=2)
    command = str(Path(sys.executable).with_name("graphkin"))
    draw = [command, "draw", "ex3-1", "-o", str(tmp_path / "ex3-1.svg"), "--force"]
    subprocess.run(draw, check=True, stdout=subprocess.DEVNULL)
    imports = whole = float("inf")
    for _ in range(ROUNDS):
        pairs = [(seconds([sys.executable, "-c", IMPORTS]), seconds(draw)) for _ in range(TRIES)]
        imports, whole = (min(least, *times) for least, times in zip((imports, whole), zip(*pairs)))
        if whole <= LIMIT * imports:
            break
    with capsys.disabled():
        print(f"\ndraw ex3-1: {whole * 1e3:.0f} ms, imports alone {imports * 1e3:.0f} ms, ratio {whole / imports:.2f}")
    assert whole <= LIMIT * imports
