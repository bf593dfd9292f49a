"""A mechanism moved along: which positions are reached, and quantities over all of them, by either road."""

from graphkin.model.quantities.reading import split
from graphkin.studies.sweeps.course import Course, Ranges, course
from graphkin.studies.sweeps.point_path import PointPath, point_path
from graphkin.studies.sweeps.roads import Road, prove
from graphkin.studies.sweeps.sweep import Series, Sweep, asked, drawable, in_parts, quantities_at, sweep, sweep_over

__all__ = [
    "Course", "PointPath", "Ranges", "Road", "Series", "Sweep", "asked", "course", "drawable", "in_parts", "point_path",
    "prove", "quantities_at", "split", "sweep", "sweep_over",
]  # fmt: skip
