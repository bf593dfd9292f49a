"""Proof: the drawing beside the analytic solution.

`compare` holds a replayed construction against the matrix method. `measure` takes a drawing file, lays a
ruler on its lines, solves the mechanism it carries anew by the matrix method, and compares; of the numbers
in the file it uses the scales and the drivers' values to know what the drawing claims, and nothing else. Marks of
instant centres are held against the velocities of that solution (`centre_measure`).
"""

from __future__ import annotations

from graphkin.check.comparison import compare
from graphkin.check.drawing import Fault
from graphkin.check.ruler import Measured, Report, held, measure
from graphkin.check.widened import added_point

__all__ = ["Fault", "Measured", "Report", "added_point", "compare", "held", "measure"]
