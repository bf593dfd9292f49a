"""The sheet: a mechanism and what is found of it on paper, as a value in millimetres.

    a subject's data -- a figure through a window --> Figure     marks, and labels that want a place
    Figure -- window, layout --> Panel                           its paper, its scale, its room
    Panels, Strip -- page --> Sheet                              labels settled, title and results, single steps

`sheet(method, plot)` is the sheet of a mechanism with its polygons (`mechanism_sheet`); each other one is a small file
of its own, `.._sheet`. A mechanism is drawn by `mechanism_figure` with the signs of `symbols`, for all of them. What
file a sheet goes into is `graphkin.outputs`' business.

How to add a sheet:
 1. the figure: a function from a `Window` to a `Figure`, and the places it is to show [SI units];
 2. its room: alone under a heading (`single_figure.place_for`, `.sheet`), or in cells over captions
    (`single_figure.Picture` with its `Extent.of(places, draw)`; `gridded`); what ruler and compass draw on it is a
    `drafting_figure.DraftingFigure`, which has points with letters, angles and the names of curves, too;
 3. the page, unless it is alone: `Page(paper, panels, mechanism, drivers, lang, Strip(tables)).sheet()`, where
    `paper.papers_for` knows the paper and `Paper.divided` parts it into field and strip (`Strip.height`);
 4. one sheet a step: number the marks (`step`), then `page.step_sheets(whole, numbers)`;
 5. the command that writes it hands it to `graphkin.outputs`; its command line in `tests/golden.py` keeps it.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from graphkin.errors import TooLargeForPaper, UnknownPaper
    from graphkin.sheet.composition import Style
    from graphkin.sheet.mechanism_sheet import mechanism_sheet as sheet
    from graphkin.sheet.mechanism_sheet import mechanism_step_sheets as step_sheets
    from graphkin.sheet.mechanism_sheet import scales_of
    from graphkin.sheet.page import Sheet
    from graphkin.sheet.paper import PAPERS, Paper
    from graphkin.sheet.path_figure import Paths

__all__ = [
    "PAPERS", "Paper", "Paths", "Sheet", "Style", "TooLargeForPaper", "UnknownPaper", "scales_of", "sheet",
    "step_sheets",
]  # fmt: skip

_HOMES = {
    "TooLargeForPaper": "errors", "UnknownPaper": "errors", "Style": "sheet.composition", "Sheet": "sheet.page",
    "PAPERS": "sheet.paper", "Paper": "sheet.paper", "Paths": "sheet.path_figure",
}  # fmt: skip
_CALLED = {"sheet": "mechanism_sheet", "step_sheets": "mechanism_step_sheets"}


def __getattr__(name: str) -> Any:
    """Public names are imported when first used: whoever letters a formula needs little of what draws a sheet."""
    if name in __all__:
        home = import_module(f"graphkin.{_HOMES.get(name, 'sheet.mechanism_sheet')}")
        return getattr(home, _CALLED.get(name, name))
    raise AttributeError(f"module 'graphkin.sheet' has no attribute {name!r}")
