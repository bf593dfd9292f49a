"""The kinds of linkage there are."""

from __future__ import annotations

from collections.abc import Callable

from graphkin.errors import GraphkinError, Where
from graphkin.studies.linkages.four import FourBar
from graphkin.studies.linkages.guide import GuideBar
from graphkin.studies.linkages.linkage import Linkage
from graphkin.studies.linkages.slider import SliderCrank

KINDS: dict[str, Callable[..., Linkage]] = {kind.word: kind for kind in (FourBar, SliderCrank, GuideBar)}
"""Every kind by its word."""


def from_lengths(kind: str, *lengths: float, driver: str = "crank") -> Linkage:
    """A linkage by its lengths [m]: "fourbar" (crank, coupler, rocker, frame), "slider" (crank, rod, offset),
    "guide" (crank, frame, offset). Raises NotALength, CannotClose, OnlyStretched, CannotDriveBy."""
    try:
        return KINDS[kind](*lengths, driver=driver)
    except GraphkinError as error:
        raise error.at(Where(f"--{kind}")) from None
