"""The tour notebook runs from beginning to end, and what it shows last in a cell can be shown."""

from __future__ import annotations

import ast
import json
from pathlib import Path
from typing import Any

import pytest

NOTEBOOK = Path(__file__).parent.parent / "figures" / "tour.ipynb"


def run(source: str, names: dict[str, Any]) -> Any:
    """A cell as a notebook runs it: what its last line is, is shown."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)


def test_tour(capsys: pytest.CaptureFixture[str]):
    names: dict[str, Any] = {}
    shown = []
    for cell in json.loads(NOTEBOOK.read_text("utf-8"))["cells"]:
        if cell["cell_type"] == "code":
            shown.append(run("".join(cell["source"]), names))
    pictures = [found for found in shown if hasattr(found, "_repr_svg_")]
    assert len(pictures) == 3
    assert all("<svg" in found._repr_svg_() for found in pictures)
    printed = capsys.readouterr().out
    before, after = map(float, printed.splitlines()[-1].rpartition(": ")[2].split(" -> "))
    assert 0 < after < before
    assert names["worst"] < 1e-9 * 1e3


def test_no_output_is_kept():
    """Outputs change with every version of a library; the notebook is stored without."""
    cells = json.loads(NOTEBOOK.read_text("utf-8"))["cells"]
    assert not any(cell.get("outputs") or cell.get("execution_count") for cell in cells)
