"""The drawn position by what the file gives of it: poses and driver values, while nothing rolls.

What a pose gives instead of a driver's value is laid off; the driver's value is measured in the end. So arcs may do
what a template would have to: of a cylinder whose stroke is open, or a wheel that rolls on a moving rack.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from graphkin.base.cache import kept
from graphkin.construction import Construction, Equation, Meet, Plot, Ray, Step, Touch
from graphkin.planning.equivalent import lower_pairs
from graphkin.planning.method import Method

if TYPE_CHECKING:
    from graphkin.planning.drawn_position import DrawnPlacement


def by_pose(method: Method, plot: Plot) -> tuple[Method, Plot] | None:
    """A method whose position is drawn from what is given of it, with its plot; None where that is the method's own,
    or for another position."""
    if not (method.mechanism.poses or method.structure.contacts) or not _as_drawn(method, plot):
        return None
    placed = _placement(method)
    near = 1e-9 * method.size
    if not all(abs(placed.plot.position[p] - plot.position[p]) < near for p in method.mechanism.points):
        return None
    structure = replace(placed.structure, contacts=method.structure.contacts)
    drawn = replace(placed.plot, position={**plot.position, **placed.plot.position})
    return replace(method, structure=structure, position=_construction(method, placed)), drawn


def shown(method: Method, plot: Plot) -> tuple[Method, Plot]:
    """The same method and plot, with the position as `by_pose` draws it."""
    if (posed := by_pose(method, plot)) is None:
        return method, plot
    return replace(method, position=posed[0].position), replace(plot, position=posed[1].position)


@kept(4)
def _placement(method: Method) -> DrawnPlacement:
    from graphkin.planning.drawn_position import placement

    return placement(method.mechanism, lower_pairs(method.mechanism), method.aside)


def _construction(method: Method, placed: DrawnPlacement) -> Construction:
    """With the points of contact, and the special points, of the method's own."""
    own, nodes = method.position, placed.construction.nodes
    more = tuple(part for part in own.parts if _further(part, method))
    return replace(placed.construction, parts=(*placed.construction.parts, *more), nodes={**own.nodes, **nodes})


def _further(part: Step | Equation, method: Method) -> bool:
    return isinstance(part, Touch | Ray) or (isinstance(part, Meet) and part.point in method.special)


def _as_drawn(method: Method, plot: Plot) -> bool:
    now, drawn = plot.facts.values, method.facts().values
    return all(abs(float(value) - float(there)) < 1e-12 for value, there in zip(now, drawn, strict=True))
