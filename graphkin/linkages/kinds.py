"""The kinds of linkage there are."""

from __future__ import annotations

from collections.abc import Callable

from graphkin.errors import GraphkinError, Where
from graphkin.linkages.four import FourBar
from graphkin.linkages.guide import GuideBar
from graphkin.linkages.linkage import Linkage
from graphkin.linkages.slider import SliderCrank

KINDS: dict[str, Callable[..., Linkage]] = {kind.word: kind for kind in (FourBar, SliderCrank, GuideBar)}
"""Every kind by its word."""


def from_lengths(kind: str, *lengths: float, driver: str = "crank") -> Linkage:
    """A linkage by its lengths [m]: "fourbar" (crank, coupler, rocker, frame), "slider" (crank, rod, offset),
    "guide" (crank, frame, offset). Raises NotALength, CannotClose, OnlyStretched, CannotDriveBy."""
    try:
        return KINDS[kind](*lengths, driver=driver)
    except GraphkinError as error:
        raise error.at(Where(f"--{kind}")) from None
