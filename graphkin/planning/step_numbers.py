"""In which act of the pencil each step is done, each point of a plane is found, each rotation is read."""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.base.cache import kept
from graphkin.construction import Measure, Plane, Roll, Simultaneous, Step
from graphkin.planning.acts import made
from graphkin.planning.method import Method


@kept(8)
def pages(method: Method) -> Mapping[tuple[Plane, Step], int]:
    """In which act each step is done."""
    return {(act.plane, step): act.page for act in method.acts for step in act.steps}


@kept(8)
def births(method: Method, plane: Plane) -> Mapping[str, int]:
    """The act in which each point of a plane is found."""
    found: dict[str, int] = {}
    for act in method.acts:
        for step in act.steps if act.plane == plane else ():
            for name in made(step):
                found.setdefault(name, act.page)
    return found


def rate_found(method: Method, plane: Plane, link: str) -> int | None:
    """The act in which a link's rotation is found in a polygon's plane; None for one that is driven."""
    base = method.structure.base(link)
    for act in method.acts:
        for step in act.steps if act.plane == plane else ():
            match step:
                case Measure(quantity="omega" | "alpha", of=of) if method.structure.base(of) == base:
                    return act.page
                case Roll(angle=angle) if angle == base:
                    return act.page
                case Simultaneous(angles=angles) if base in angles:
                    return act.page
                case _:
                    pass
    return None
