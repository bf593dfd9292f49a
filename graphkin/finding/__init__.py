"""Positions with a property: where a condition holds, extremes, strokes, the slowest point, speeds that are wanted.

    condition --conditions--> what is asked --stretch (where it is looked)--> comparing, extremes | points
        --> Found --wording, data--> lines, JSON;  drawing --> positions side by side on a sheet
    varying: the same for many values of a dimension

`search` holds the numerics (all zeros, all extremes, to the last digits), `rates` what the drawing itself tells of how
a quantity changes, so that a greatest value is as exact as a zero.
"""

from graphkin.finding.answers import Found, Interval, Position
from graphkin.finding.data import as_json
from graphkin.finding.drawing import drawn
from graphkin.finding.find import check_limit, find, limit
from graphkin.finding.varying import VaryingRow, VaryingTable, table_json, table_lines, vary
from graphkin.finding.wording import lines

__all__ = [
    "Found", "Interval", "Position", "VaryingRow", "VaryingTable", "as_json", "check_limit", "drawn", "find", "limit",
    "lines", "table_json", "table_lines", "vary",
]  # fmt: skip
