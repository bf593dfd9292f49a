"""Modules import in one direction, and the two roads never meet."""

from __future__ import annotations

import ast
import importlib
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

import graphkin

PACKAGE = Path(graphkin.__file__).parent
FILES = sorted(path for path in PACKAGE.rglob("*.py") if path.parent != PACKAGE)


def part(path: Path) -> str:
    """The module of the architecture that a file belongs to."""
    return path.relative_to(PACKAGE).parts[0].removesuffix(".py")


class Contents(NamedTuple):
    """Of a file: its imports and calls, the texts that stand alone in it, the names of its classes."""

    used: tuple[ast.ImportFrom | ast.Import | ast.Call, ...]
    texts: tuple[str, ...]
    classes: tuple[str, ...]


@cache
def contents(path: Path) -> Contents:
    """Read once: the whole tree of a file is not kept."""
    every = [*ast.walk(ast.parse(path.read_text("utf-8")))]
    alone = [node.value.value for node in every if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)]
    return Contents(
        tuple(node for node in every if isinstance(node, ast.ImportFrom | ast.Import | ast.Call)),
        tuple(text for text in alone if isinstance(text, str)),
        tuple(node.name for node in every if isinstance(node, ast.ClassDef)),
    )


def imported(path: Path) -> set[str]:
    """The modules of the architecture that a file imports, wherever in it."""
    found = set()
    for node in contents(path).used:
        if isinstance(node, ast.ImportFrom) and node.module and node.module.split(".")[0] == "graphkin":
            names = node.module.split(".")[1:] or [alias.name for alias in node.names]
            found |= {names[0]} if node.module != "graphkin" else set(names)
        elif isinstance(node, ast.Import):
            found |= {a.name.split(".")[1] for a in node.names if a.name.startswith("graphkin.")}
    return found


def test_every_module_has_its_place():
    assert {part(path) for path in FILES} == set(graphkin.ORDER)


def test_imports_go_one_way():
    before = {name: graphkin.ORDER[: place + 1] for place, name in enumerate(graphkin.ORDER)}
    back = {(str(path.relative_to(PACKAGE)), name) for path in FILES for name in imported(path) if name not in before[part(path)]}
    assert not back


# --- circles ----------------------------------------------------------------------------------

def dotted(path: Path) -> str:
    """A file as it is imported."""
    return ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts).removesuffix(".__init__")


MODULES = {dotted(path): path for path in FILES}


@cache
def needed(path: Path) -> frozenset[str]:
    """The modules that a file imports anywhere: in functions, by a written name, for types; a package is its `__init__`."""
    found = set[str]()
    for node in contents(path).used:
        if isinstance(node, ast.ImportFrom) and node.module:
            found |= {f"{node.module}.{alias.name}" for alias in node.names if f"{node.module}.{alias.name}" in MODULES}
            if any(f"{node.module}.{alias.name}" not in MODULES for alias in node.names):
                found.add(node.module)
        elif isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.Call) and ast.unparse(node.func).endswith("import_module"):
            found |= {word.value for word in node.args if isinstance(word, ast.Constant)}
    return frozenset(found & MODULES.keys() - {dotted(path)})


def circles(needs: dict[str, frozenset[str]]) -> set[frozenset[str]]:
    """Sets of modules each of which is reached from every other."""
    reach = {name: set(others) for name, others in needs.items()}
    for middle in needs:
        for name in needs:
            if middle in reach[name]:
                reach[name] |= reach[middle]
    return {frozenset(o for o in reach[name] if name in reach[o]) for name in needs if name in reach[name]}


def test_no_circle_of_imports():
    assert circles({name: needed(path) for name, path in MODULES.items()}) == set()


def reached(start: str) -> set[str]:
    """The packages of all modules that importing those of a package brings in, one after another."""
    found, waiting = set(), {name for name in MODULES if name.startswith(f"graphkin.{start}.")}
    while waiting:
        name = waiting.pop()
        found.add(name)
        waiting |= needed(MODULES[name]) - found
    return {name.split(".")[1] for name in found}


def test_analysis_never_reads_a_construction():
    assert not reached("analytic") & {"construction", "planning", "running", "say", "sheet", "proof"}


def test_planning_never_reads_the_analysis():
    assert not (reached("planning") | reached("running")) & {"analytic", "check", "proof"}


FACES = [name for name, path in MODULES.items() if "\n__all__ = " in path.read_text("utf-8")]


@pytest.mark.parametrize("name", FACES)
def test_all_names_exist(name: str):
    module = importlib.import_module(name)
    for public in module.__all__:
        assert hasattr(module, public), public


def test_public_names():
    for name in graphkin.__all__:
        assert getattr(graphkin, name) is not None


def test_docstrings_name_their_thing():
    """They are no questions; those under constants count, too."""
    texts = [(path.name, text) for path in FILES for text in contents(path).texts]
    assert len(texts) > 1000
    assert [(name, text) for name, text in texts if text.split()[0] in ("What", "Whether", "How", "Who")] == []


def test_a_class_name_stands_for_one_thing():
    names = [name for path in FILES for name in contents(path).classes if not name.startswith("_")]
    assert len(names) > 500
    assert {name for name in names if names.count(name) > 1} == set()


def test_packages_are_loaded_plainly():
    """No module is faked, replaced or loaded past its package."""
    assert [path.name for path in FILES if "sys.modules" in path.read_text("utf-8")] == []


@pytest.mark.parametrize(
    ("arguments", "spared"),
    [
        (
            ["draw", "ex3-1", "-o", "-"],
            {"matplotlib", "scipy", "graphkin.check", "graphkin.studies.sweeps", "numpy.ma", "numpy.random", "pydantic",
             "html", "graphkin.say.explained", "graphkin.say.problems"},
        ),
        (["list"], {"numpy", "pydantic_core", "shapely", "svgwrite", "graphkin.files.loader"}),
        (["equations", "ex3-1"], {"matplotlib", "shapely", "svgwrite", "numpy.ma", "urllib.request", "pydantic"}),
        (["sweep", "ex3-1", "--table"], {"matplotlib", "shapely", "svgwrite", "numpy.ma", "pyarrow", "graphkin.sheet"}),
    ],
    ids=lambda given: given[0] if isinstance(given, list) else "",
)
def test_light_start(arguments: list[str], spared: set[str]):
    """A command loads what it uses."""
    code = (
        "import sys; from click.testing import CliRunner; from graphkin.cli import main\n"
        f"result = CliRunner().invoke(main, {arguments})\n"
        "assert result.exit_code == 0, result.output\n"
        f"loaded = {spared} & set(sys.modules)\n"
        "assert not loaded, loaded"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
