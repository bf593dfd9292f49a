"""The tour notebook shows what its cells give: kept with its outputs, which are made by `python tests/test_tour.py`."""

from __future__ import annotations

import ast
import contextlib
import html
import io
import json
import re
from pathlib import Path
from typing import Any

NOTEBOOK = Path(__file__).parent.parent / "figures" / "tour.ipynb"


def run(source: str, names: dict[str, Any]) -> list[dict[str, Any]]:
    """The outputs of a cell: what is printed, and what its last line is."""
    tree, printed = ast.parse(source), io.StringIO()
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell", "exec"), names)
        value = None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    outputs: list[dict[str, Any]] = []
    if text := printed.getvalue():
        outputs.append({"output_type": "stream", "name": "stdout", "text": text.splitlines(keepends=True)})
    if value is not None:
        data = {"text/plain": repr(value).splitlines(keepends=True)}
        if hasattr(value, "_repr_svg_"):
            data["image/svg+xml"] = value._repr_svg_().splitlines(keepends=True)
        outputs.append({"output_type": "display_data", "metadata": {}, "data": data})
    return outputs


def executed() -> dict[str, Any]:
    """The notebook, every cell run."""
    book: dict[str, Any] = json.loads(NOTEBOOK.read_text("utf-8"))
    names: dict[str, Any] = {}
    code = (cell for cell in book["cells"] if cell["cell_type"] == "code")
    for count, cell in enumerate(code, 1):
        cell |= {"execution_count": count, "outputs": run("".join(cell["source"]), names)}
    return book


def words(outputs: list[dict[str, Any]]) -> list[object]:
    """What can be read in outputs: of drawings all letters, wherever they stand."""
    found: list[object] = []
    for one in outputs:
        data = one.get("data", {})
        drawn = "".join(data.get("image/svg+xml", ()))
        letters = re.sub("<[^>]*>", "", "".join(re.findall(r"(?s)<(?:text|title)\b.*?</(?:text|title)>", drawn)))
        found.append([one.get("text"), [*data], sorted(html.unescape(letters).split())])
    return found


def test_the_tour_shows_what_its_cells_give():
    kept, now = json.loads(NOTEBOOK.read_text("utf-8")), executed()
    for old, new in zip(kept["cells"], now["cells"], strict=True):
        assert words(old.get("outputs", [])) == words(new.get("outputs", [])), "".join(old["source"])
    pictures = [one for cell in now["cells"] for one in cell.get("outputs", ()) if "image/svg+xml" in one.get("data", ())]
    assert len(pictures) == 5


if __name__ == "__main__":
    NOTEBOOK.write_text(json.dumps(executed(), ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
