"""Positions with a property: where a condition holds, extremes, strokes, the slowest point, speeds that are wanted.

    condition --conditions--> what is asked --stretch (where it is looked)--> comparing, extremes | points
        --> Found --data--> JSON
    varying: the same for many values of a dimension

`search` holds the numerics (all zeros, all extremes, to the last digits), `rates` what the drawing itself tells of how
a quantity changes, so that a greatest value is as exact as a zero.
"""

from graphkin.studies.finding.answers import Findings, Interval, Position
from graphkin.studies.finding.data import as_json
from graphkin.studies.finding.find import check_limit, find, limit
from graphkin.studies.finding.varying import VaryingRow, VaryingTable, table_json, vary

__all__ = [
    "Findings", "Interval", "Position", "VaryingRow", "VaryingTable", "as_json", "check_limit", "find", "limit",
    "table_json", "vary",
]  # fmt: skip
