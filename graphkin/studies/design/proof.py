"""A solution handed to the other road: the linkage by its lengths alone, and a report of it."""

from __future__ import annotations

from graphkin.studies.design.model import Solution
from graphkin.studies.linkages import FourBar, GuideBar, Linkage, Report, SliderCrank, report


def linkage_of(solution: Solution) -> Linkage:
    """The linkage of a solution, as it stands in the construction.

    Raises OnlyStretched, CannotClose for lengths that cannot move (only for what is not valid).
    """
    at = solution.places
    if solution.shape == "four-bar":
        lengths = (solution.a, solution.b or 0.0, solution.c or 0.0, solution.d or 0.0)
        return FourBar(*lengths, places=tuple(at[name] for name in "ABCD"))
    places = tuple(at[name] for name in "ABC")
    if solution.shape == "slider-crank":
        return SliderCrank(solution.a, solution.b or 0.0, solution.e or 0.0, places=places, way=solution.turn)
    return GuideBar(solution.a, solution.d or 0.0, solution.e or 0.0, places=places, turn=solution.turn)


def proof(solution: Solution) -> Report:
    """What the lengths say of swing, stroke, theta, K, transmission angle, in closed form and without the drawing."""
    return report(linkage_of(solution))
