"""Positions with a property: where a condition holds, extremes, strokes, the slowest point, speeds of the drivers.

    text -- conditions --> Condition -- find: stretch, comparing | single positions --> Findings -- as_json --> JSON
    varying: the same for many values of a dimension

`search` holds the numerics (all zeros, all extremes, to the last digits), `stretch` the rates that the drawing itself
tells, so that a greatest value is as exact as a zero.
"""

from graphkin.studies.finding.answers import Findings, Interval, Position, as_json
from graphkin.studies.finding.find import check_limit, find, limit
from graphkin.studies.finding.varying import VaryingRow, VaryingTable, table_json, vary

__all__ = [
    "Findings", "Interval", "Position", "VaryingRow", "VaryingTable", "as_json", "check_limit", "find", "limit",
    "table_json", "vary",
]  # fmt: skip
