"""How much CPU time whole processes of graphkin take, beside importing what they load; and what they do without."""

from __future__ import annotations

import compileall
import os
import resource
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

import graphkin

PACKAGES = ("numpy", "svgwrite", "click", "pydantic_core")  # that `draw` needs
HEAVY = {"matplotlib", "pydantic", "typst", "resvg_py", "ezdxf", "openpyxl", "scipy", "cv2", "asyncio"}
"""What no drawing and no text needs."""
WITHOUT = {
    "list": HEAVY | {"numpy", "shapely", "svgwrite", "graphkin.planning"},
    "equations ex3-1": HEAVY | {"shapely", "svgwrite", "numpy.random"},
    "draw ex3-1": HEAVY | {"shapely", "numpy.random"},
    "draw ex3-2": HEAVY | {"shapely"},
}
TRIES = 2
MODULES = """
import os, sys
os._exit = sys.exit  # how the command line ends
sys.argv = ["graphkin", *sys.argv[1:]]
from graphkin.cli import main
try:
    main()
finally:
    print(*sys.modules, file=sys.stderr)
"""
IMPORT = """
import importlib, sys
for name in sys.argv[1:]:
    try:
        importlib.import_module(name)
    except ImportError:  # what a package puts beside its modules
        pass
"""


def seconds(command: Sequence[str]) -> float:
    """CPU time of one fresh process [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


@pytest.mark.bench
@pytest.mark.parametrize("line", WITHOUT)
def test_a_command_beside_its_imports(line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """Reported: the best of some tries each, in turns, all byte-compiled and with one thread. No busy machine loads more."""
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    compileall.compile_dir(Path(graphkin.__file__).parent, quiet=2)
    words = [*line.split(), *(["-o", str(tmp_path / "sheet.svg"), "--force"] if line.startswith("draw") else [])]
    loaded = subprocess.run([sys.executable, "-c", MODULES, *words], capture_output=True, text=True).stderr.split()
    assert "graphkin.cli" in loaded
    assert WITHOUT[line] & {*loaded} == set()
    works = {
        "all": [sys.executable, "-m", "graphkin", *words],
        "modules": [sys.executable, "-c", IMPORT, *(name for name in loaded if not name.startswith("__"))],
        "packages": [sys.executable, "-c", IMPORT, *PACKAGES],
    }
    best = dict.fromkeys(works, float("inf"))
    for _ in range(TRIES):
        best = {name: min(best[name], seconds(work)) for name, work in works.items()}
    with capsys.disabled():
        print(f"\n{line}: {best['all'] * 1e3:.0f} ms, {best['all'] / best['modules']:.2f} times importing the {len(loaded)} modules "
              f"that it loads, {best['all'] / best['packages']:.2f} times importing the packages that draw needs")  # fmt: skip
