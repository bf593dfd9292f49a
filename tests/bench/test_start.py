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
TRIES = 7


def best(command: list[str]) -> float:
    """Least wall-clock time of several fresh processes [s]."""
    times = []
    for _ in range(TRIES):
        start = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        times.append(time.perf_counter() - start)
    return min(times)


@pytest.mark.bench
def test_draw_starts_about_as_fast_as_its_imports(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """Both byte-compiled: what Python would do at the first run, were it allowed to write."""
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    compileall.compile_dir(Path(graphkin.__file__).parent, quiet=2)
    draw = [sys.executable, "-m", "graphkin.cli", "draw", "ex3-1", "-o", str(tmp_path / "ex3-1.svg"), "--force"]
    subprocess.run(draw, check=True, stdout=subprocess.DEVNULL)
    imports, whole = best([sys.executable, "-c", IMPORTS]), best(draw)
    with capsys.disabled():
        print(f"\ndraw ex3-1: {whole * 1e3:.0f} ms, imports alone {imports * 1e3:.0f} ms, ratio {whole / imports:.2f}")
    assert whole <= LIMIT * imports
