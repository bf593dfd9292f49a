"""The drawn position by what is given of it: with a pose for a driver's value, arcs may do what a template would.

A cylinder that drives a group leaves its position to be fitted; if the file gives the angle of one of its links
instead of the stroke, the mechanism can be drawn from that angle, and the stroke is measured.
"""

from __future__ import annotations

from dataclasses import replace

from graphkin.construction import Plot, replay
from graphkin.errors import GraphkinError
from graphkin.mechanism import Driver, Mechanism
from graphkin.planning.method import Method
from graphkin.planning.planner import plan


def by_pose(method: Method, plot: Plot) -> tuple[Method, Plot] | None:
    """A method whose position needs no fitting, with its plot; None where there is none, or for another position."""
    if not method.fits or (posed := _driven_by_poses(method.mechanism)) is None or not _as_drawn(method, plot):
        return None
    try:
        other = plan(posed)
    except GraphkinError:
        return None
    if other.fits:
        return None
    drawn = replay(other.position, Plot(other.facts(), other.near))
    near = 1e-9 * method.size
    same = all(abs(drawn.position[point] - plot.position[point]) < near for point in method.mechanism.points)
    return (other, drawn) if same else None


def _driven_by_poses(mechanism: Mechanism) -> Mechanism | None:
    """The same mechanism with each pose as the driver whose value it gives; None where they are not as many."""
    valued = [driver for driver in mechanism.drivers if driver.value is not None]
    if len(mechanism.poses) != len(mechanism.drivers) - len(valued):
        return None
    posed = [Driver(p.kind, p.link, p.vector, p.from_link, p.from_vector, p.value) for p in mechanism.poses]
    return replace(mechanism, drivers=(*valued, *posed), poses=())


def _as_drawn(method: Method, plot: Plot) -> bool:
    now, drawn = plot.facts.values, method.facts().values
    return all(abs(float(value) - float(there)) < 1e-12 for value, there in zip(now, drawn, strict=True))
