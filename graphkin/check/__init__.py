"""A ruler on a drawing: the drawing file beside the analytic solution.

`measure` takes a drawing file, lays a
ruler on its lines, solves the mechanism it carries anew by the matrix method, and compares; of the numbers
in the file it uses the scales and the drivers' values to know what the drawing claims, and nothing else. Marks of
instant centres are held against the velocities of that solution (`centre_measure`).
"""

from __future__ import annotations

from graphkin.check.drawing import Fault
from graphkin.check.ruler import Measured, Report, measure
from graphkin.check.widened import added_point

__all__ = ["Fault", "Measured", "Report", "added_point", "measure"]
