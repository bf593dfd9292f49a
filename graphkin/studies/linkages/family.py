"""The kinds of linkage, and the family: every kind that has a name of its own, with lengths that show it.

Fix another link of one chain and another kind appears: the four-bar with one short link gives crank-rocker,
double-crank and double-rocker; the slider-crank gives guide bar, oscillating block and fixed block. An enlarged pin
changes nothing: an eccentric is a crank as long as its eccentricity (s2-1a, s2-1b in the library).
"""

from __future__ import annotations

from collections.abc import Callable

from graphkin.base.value import frozen
from graphkin.errors import GraphkinError, Where
from graphkin.studies.linkages.four import FourBar
from graphkin.studies.linkages.guide import GuideBar
from graphkin.studies.linkages.slider import SliderCrank

Linkage = FourBar | SliderCrank | GuideBar
"""Any kind; what each of them tells, `linkage` has."""
KINDS: dict[str, Callable[..., Linkage]] = {kind.word: kind for kind in (FourBar, SliderCrank, GuideBar)}
"""Every kind by its word."""


def from_lengths(kind: str, *lengths: float, driver: str = "crank") -> Linkage:
    """A linkage by its lengths [m]: "fourbar" (crank, coupler, rocker, frame), "slider" (crank, rod, offset),
    "guide" (crank, frame, offset). Raises NotALength, CannotClose, OnlyStretched, CannotDriveBy."""
    try:
        return KINDS[kind](*lengths, driver=driver)
    except GraphkinError as error:
        raise error.at(Where(f"--{kind}")) from None


@frozen
class Member:
    """One kind: a linkage that shows it, and mechanisms of the library that are of this kind."""

    linkage: Linkage
    library: tuple[str, ...] = ()


FAMILY: tuple[Member, ...] = (
    Member(FourBar(0.020, 0.055, 0.045, 0.060), ("s2-2", "s2-3", "ex3-5")),
    Member(FourBar(0.055, 0.045, 0.060, 0.020)),
    Member(FourBar(0.055, 0.018, 0.050, 0.040), ("fig3-6",)),
    Member(FourBar(0.035, 0.050, 0.040, 0.080), ("fig3-10",)),
    Member(FourBar(0.030, 0.060, 0.030, 0.060), ("p3-22",)),
    Member(SliderCrank(0.020, 0.060, 0.0), ("s2-1b", "p3-20")),
    Member(SliderCrank(0.020, 0.060, -0.012), ("s2-4", "fig3-1")),
    Member(GuideBar(0.040, 0.016, 0.0)),
    Member(GuideBar(0.020, 0.060, 0.0), ("s2-1a", "ex3-7", "s3-shaper")),
    Member(GuideBar(0.020, 0.060, 0.0, block=True), ("p3-5", "p3-11c")),
    Member(SliderCrank(0.060, 0.020, 0.0, block=True)),
    Member(SliderCrank(0.040, 0.040, 0.0)),
)
"""In the order in which textbooks derive them: four hinges first, then the inversions of the slider-crank."""
