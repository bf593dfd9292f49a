"""The sheet: a mechanism and its polygons on paper, as a value in millimetres.

`sheet(method, plot)` turns the points of a replay into marks (`marks`): the mechanism with its signs
(`mechanism_figure`, `symbols`), the polygons (`polygons`), tables and title, each figure in a room of the
smallest paper that holds all (`layout`), and labels where nothing else lies (`labels`). What file it goes
into is `graphkin.outputs`' business. `centre_sheet` is the sheet of instant centres, made of the `centre_*` modules.
"""

from __future__ import annotations

from graphkin.sheet.composition import mechanism_sheet as sheet
from graphkin.sheet.composition import mechanism_step_sheets as step_sheets
from graphkin.sheet.composition import scales_of
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import PAPERS, Paper
from graphkin.sheet.scales import TooLargeForPaper, UnknownPaper
from graphkin.sheet.window import step_count

__all__ = [
    "PAPERS", "Paper", "Sheet", "TooLargeForPaper", "UnknownPaper", "scales_of", "sheet", "step_count", "step_sheets",
]  # fmt: skip
