"""There is one page: what every sheet needs is done in one place of the whole house."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import graphkin
from graphkin import library
from graphkin.centres import centres
from graphkin.centres.about import about
from graphkin.loading import loads
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet import Sheet, sheet
from graphkin.sheet.about_sheet import about_sheet
from graphkin.sheet.centre_sheet import centre_sheet
from graphkin.sheet.gallery_sheet import side_by_side

PACKAGE = Path(graphkin.__file__).parent
TEXTS = {path.relative_to(PACKAGE).as_posix(): path.read_text("utf-8") for path in PACKAGE.rglob("*.py")}
TREES = {path: ast.parse(text) for path, text in TEXTS.items()}


def names_of(tree: ast.AST, module: str, name: str) -> set[str]:
    """What a file calls something: `settle`, or `labels.settle`, or by another name it was imported under."""
    found = {node.name for node in ast.walk(tree) if isinstance(node, ast.ClassDef | ast.FunctionDef)} & {name}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            for alias in node.names:
                known = alias.asname or alias.name
                if alias.name == name and node.module in (module, module.rpartition(".")[0]):
                    found.add(known)
                elif f"{node.module}.{alias.name}" == module:
                    found.add(f"{known}.{name}")
        elif isinstance(node, ast.Import):
            found |= {f"{alias.asname or alias.name}.{name}" for alias in node.names if alias.name == module}
    return found


def calls(module: str, name: str) -> Iterator[str]:
    """The file of each call of something that a module defines."""
    for path, tree in TREES.items():
        known = names_of(tree, module, name) if name in TEXTS[path] else set()
        for node in ast.walk(tree) if known else ():
            if isinstance(node, ast.Call) and ast.unparse(node.func) in known:
                yield path


ONCE = (
    ("graphkin.sheet.page", "Sheet", "a finished drawing is made"),
    ("graphkin.sheet.labels", "settle", "labels find their places"),
    ("graphkin.sheet.titleblock", "strip", "the strip at the foot is drawn"),
)


@pytest.mark.parametrize(("module", "name", "what"), ONCE, ids=lambda word: word.rpartition(".")[2])
def test_done_in_one_line_of_the_page(module: str, name: str, what: str):
    assert list(calls(module, name)) == ["sheet/page.py"], what


def test_a_figure_is_fitted_in_one_place():
    """Nobody else says through which window a figure is seen."""
    assert {*calls("graphkin.sheet.window", "Window")} == {"sheet/fit.py"}


def test_step_sheets_are_made_in_one_line_of_the_page():
    """What a step adds is emphasised there, and nowhere else."""
    words = ((path, node) for path, tree in TREES.items() for node in ast.walk(tree) if isinstance(node, ast.keyword))
    assert [path for path, word in words if word.arg == "new"] == ["sheet/page.py"]


def test_a_breach_is_seen():
    """The ways a file may call something are known."""
    lines = (
        "from graphkin.sheet.labels import settle\nsettle()",
        "from graphkin.sheet.labels import settle as placed\nplaced()",
        "from graphkin.sheet import labels\nlabels.settle()",
        "import graphkin.sheet.labels\ngraphkin.sheet.labels.settle()",
    )
    for text in lines:
        tree = ast.parse(text)
        call = next(node for node in ast.walk(tree) if isinstance(node, ast.Call))
        assert ast.unparse(call.func) in names_of(tree, "graphkin.sheet.labels", "settle"), text


# --- scales -----------------------------------------------------------------------------------


def of_a_file(scale: float) -> Iterator[Sheet]:
    """Every sheet of a mechanism whose file gives its scale."""
    text = library.text("ex3-1")
    method = plan(loads(re.sub(r"(?m)^length = .*", f"length = {scale}", text), name="scaled", file="scaled.toml"))
    plot = replay_all(method)
    found = centres(method, plot)
    yield sheet(method, plot)
    yield centre_sheet(found)
    yield about_sheet(about(found, "2"))
    yield side_by_side(method, [plot], ["here"])


@pytest.mark.parametrize("scale", [0.001, 0.0027, 0.00048])
def test_the_scale_of_the_file_is_kept_where_the_figure_fits(scale: float):
    """A scale that is not of the series, too, and by every sheet."""
    assert [drawn.scales["position"] for drawn in of_a_file(scale)] == [scale] * 4
