"""A solution handed to the other road: the linkage by its lengths alone, as a report and as a mechanism file."""

from __future__ import annotations

from dataclasses import replace

from graphkin.design.model import Solution
from graphkin.errors import Lang
from graphkin.linkages import FourBar, GuideBar, Linkage, Report, SliderCrank, filed, report
from graphkin.mechanism import Mechanism

__all__ = ["as_toml", "linkage_of", "mechanism_of", "proof"]

_TITLES: dict[str, dict[Lang, str]] = {
    "rocker": {"en": "Crank-rocker from K", "zh": "曲柄摇杆机构设计"},
    "slider": {"en": "Slider-crank from K", "zh": "曲柄滑块机构设计"},
    "guide-bar": {"en": "Oscillating guide bar from K", "zh": "摆动导杆机构设计"},
    "coupler": {"en": "Four-bar from coupler positions", "zh": "按连杆位置设计四杆机构"},
    "angles": {"en": "Four-bar from pairs of angles", "zh": "按对应角位置设计四杆机构"},
}


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


def mechanism_of(solution: Solution, kind: str) -> Mechanism:
    """The linkage driven at AB with 1 rad/s. kind: of the design (`Design.kind`)."""
    machine = linkage_of(solution).mechanism(omega=1.0)
    return filed(replace(machine, name="design", file="design.toml", title=_TITLES[kind]))


def as_toml(solution: Solution, kind: str) -> str:
    """The same as a mechanism file."""
    return mechanism_of(solution, kind).text
