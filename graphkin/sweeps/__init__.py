"""A mechanism moved along: which positions are reached, and quantities over all of them, by either road."""

from graphkin.quantities import split
from graphkin.sweeps.course import Course, course
from graphkin.sweeps.point_path import PointPath, point_path
from graphkin.sweeps.proof import prove
from graphkin.sweeps.quantities import Series, asked, drawable
from graphkin.sweeps.ranges import Ranges
from graphkin.sweeps.roads import Road
from graphkin.sweeps.sweep import Sweep, in_parts, quantities_at, sweep, sweep_over

__all__ = [
    "Course", "PointPath", "Ranges", "Road", "Series", "Sweep", "asked", "course", "drawable", "in_parts", "point_path",
    "prove", "quantities_at", "split", "sweep", "sweep_over",
]  # fmt: skip
