"""A ruler on a drawing: the drawing file beside the analytic solution.

`measure` takes a drawing file, sees of it what a viewer would show (`shown`, made of `transforms`, `styles` and
`outlines`), lays a ruler on its vectors, points and lines of links (`ruler`), solves the mechanism it carries anew by
the matrix method, and compares. Of the numbers in the file it uses the scales and the drivers' values to know what the
drawing claims, and nothing else (`claims` says what that proves). What a mark should be follows from the sites it names
(`expected`, `links`); marks of instant centres are held against the velocities of that solution.
Beside lengths: arrow `heads`, what is `hidden`, and `signs` that show no length, held to where they were drawn.
"""

from __future__ import annotations

from graphkin.check.drawing import Fault
from graphkin.check.expected import added_point
from graphkin.check.ruler import RulerReading, RulerReport, measure, measured

__all__ = ["Fault", "RulerReading", "RulerReport", "added_point", "measure", "measured"]
