"""What is installed from a wheel is whole: library, schema, phrases and letters are in it; the sdist has all its tests need."""

from __future__ import annotations

import importlib
import importlib.util
import re
import subprocess
import sys
import sysconfig
import tarfile
import venv
import zipfile
from email import message_from_bytes
from pathlib import Path

import pytest

import graphkin

ROOT = Path(__file__).parent.parent
NEEDED = ("numpy", "shapely", "matplotlib", "svgwrite", "click", "pydantic", "defusedxml")
CALLS = """
import sys
import graphkin
from click.testing import CliRunner
from graphkin.cli import main
from graphkin.cli import manual
assert graphkin.__file__.startswith(sys.prefix), graphkin.__file__
readme = manual.whole_readme().partition("# graphkin 中文")[2]
assert "图解法" in readme and "## Set up" not in readme and manual.skeleton("zh"), readme
for words in sys.argv[1:]:
    result = CliRunner().invoke(main, words.split())
    assert result.exit_code == 0, (words, result.output)
    print(result.stdout)
"""


def built(folder: Path) -> tuple[Path, Path]:
    """Wheel and sdist of what stands here, built without network."""
    subprocess.run([sys.executable, "-m", "hatchling", "build", "-d", folder], cwd=ROOT, check=True, capture_output=True)
    (wheel,), (sdist,) = folder.glob("*.whl"), folder.glob("*.tar.gz")
    return wheel, sdist


def bare(folder: Path) -> Path:
    """The python of an environment that has nothing but what graphkin needs, and where modules of its own go."""
    venv.create(folder, with_pip=False)
    modules = Path(sysconfig.get_path("purelib", "venv", {"base": str(folder), "platbase": str(folder)}))
    homes = {str(Path(importlib.import_module(name).__file__ or "").parents[1]) for name in NEEDED}
    (modules / "needed.pth").write_text("\n".join(sorted(homes)) + "\n", encoding="utf-8")
    return Path(sysconfig.get_path("scripts", "venv", {"base": str(folder)})) / Path(sys.executable).name


@pytest.mark.skipif(importlib.util.find_spec("hatchling") is None, reason="hatchling, which builds wheels, is not here")
def test_a_wheel_in_a_bare_environment(tmp_path: Path) -> None:
    (wheel, sdist), python = built(tmp_path), bare(tmp_path / "bare")
    with tarfile.open(sdist) as archive:
        packed = {name.partition("/")[2] for name in archive.getnames()}
    tops = [path for name in ("graphkin", "tests", "figures", ".ci") for path in (ROOT / name).rglob("*.*")]
    passing = {".pyc", "node_modules"}  # what is no part of the project
    tops = [path for path in tops if path.is_file() and passing.isdisjoint((path.suffix, *path.parts))]
    assert {str(path.relative_to(ROOT)) for path in tops} <= packed
    assert {"cli.py", "README.md", "CHANGELOG.md", "LICENSE", "pyproject.toml"} <= packed
    assert wheel.name.startswith(f"graphkin-{graphkin.__version__}-")
    inside = zipfile.ZipFile(wheel).namelist()
    about = message_from_bytes(zipfile.ZipFile(wheel).read(f"graphkin-{graphkin.__version__}.dist-info/METADATA"))
    shown = re.findall(r"!\[[^]]*\]\(([^)]*)\)", str(about.get_payload()))
    assert len(shown) > 4
    for address in shown:
        home, _, path = address.partition("/main/")
        assert home.startswith("https://raw.githubusercontent.com/")
        assert (ROOT / path).is_file()
    there = {str(path.relative_to(ROOT)) for path in (ROOT / "graphkin").rglob("*") if path.suffix in (".py", ".toml", ".json", ".typed", ".md", ".js", ".css", ".html")}
    assert there <= set(inside)
    pip = [sys.executable, "-m", "pip", "--python", python, "install", "-q", "--no-deps", "--no-index", "--no-compile", wheel]
    subprocess.run(pip, check=True, capture_output=True)
    drawn = subprocess.run([python.parent / "graphkin", "draw", "ex3-1", "--lang", "zh", "--only", "velocity"], cwd=tmp_path, check=True,
                           capture_output=True, text=True, encoding="utf-8")  # fmt: skip
    assert drawn.stdout.strip() == "ex3-1.svg"
    assert "速度多边形" in (tmp_path / "ex3-1.svg").read_text(encoding="utf-8")
    told = subprocess.run([python, "-c", CALLS, "explain ex3-5 --lang zh", "schema", "list"], cwd=tmp_path, check=True,
                          capture_output=True, text=True, encoding="utf-8", env={"PYTHONIOENCODING": "utf-8"})  # fmt: skip
    assert all(said in told.stdout for said in ("解", '"$schema"', "scotch-yoke"))
