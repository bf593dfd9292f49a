"""How much CPU time whole processes of graphkin take, beside the imports of `draw` alone."""

from __future__ import annotations

import compileall
import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

import graphkin

IMPORTS = "import numpy, shapely, svgwrite, click, pydantic_core"  # the packages that `draw` needs
TRIES, ROUNDS = 6, 8
LIMITS = {
    "list": 0.4,
    "equations ex3-1": 1.2,
    "draw ex3-1": 2.1,
    "draw ex3-2": 3.2,
    "draw p3-15": 4.5,
}
"""Of the time that the imports take. Where labels have leaders, a second arrangement of the sheet is composed with
details, each of which is tried in several places."""


def seconds(command: list[str]) -> float:
    """CPU time of one fresh process [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


@pytest.mark.bench
@pytest.mark.parametrize("line", LIMITS)
def test_starts_about_as_fast_as_the_imports(line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """The best of several tries each, taken in turns, on a machine that does other things too: more where it does.

    Both are byte-compiled: what Python would do at the first run, were it allowed to write.
    """
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    compileall.compile_dir(Path(graphkin.__file__).parent, quiet=2)
    command = [str(Path(sys.executable).with_name("graphkin")), *line.split()]
    command += ["-o", str(tmp_path / "sheet.svg"), "--force"] if line.startswith("draw") else []
    imports = whole = float("inf")
    for _ in range(ROUNDS):
        pairs = [(seconds([sys.executable, "-c", IMPORTS]), seconds(command)) for _ in range(TRIES)]
        imports, whole = (min(least, *times) for least, times in zip((imports, whole), zip(*pairs)))
        if whole <= LIMITS[line] * imports:
            break
    with capsys.disabled():
        print(f"\n{line}: {whole * 1e3:.0f} ms, imports alone {imports * 1e3:.0f} ms, ratio {whole / imports:.2f}")
    assert whole <= LIMITS[line] * imports
