"""The kinds of kinematic pair, one file each, against one contract.

A pair is a frozen value that names links and points and holds lengths in metres and angles in
radians. It says which links it joins; what it asks of their motion is said twice, by two roads
that never meet: `graphkin.planning` turns it into steps of a construction, `graphkin.analytic`
into terms of closed vector loops.

How to add a pair kind: a file here with a frozen class that fulfils `Pair`, its class in `PAIRS`,
its table in `graphkin.loading`, a rule in `graphkin.planning` and one in `graphkin.analytic`.
"""

from __future__ import annotations

from typing import ClassVar, Protocol

from graphkin.pairs.cam import Cam, Profile
from graphkin.pairs.gear import Gear
from graphkin.pairs.line import Line
from graphkin.pairs.revolute import Revolute
from graphkin.pairs.roll import Roll
from graphkin.pairs.slide import Slide

__all__ = ["PAIRS", "Cam", "Gear", "Line", "Pair", "Profile", "Revolute", "Roll", "Slide"]


class Pair(Protocol):
    """The contract of a pair kind."""

    table: ClassVar[str]
    """Name of its table in the mechanism file; empty where the file has none (a hinge is a shared point)."""

    @property
    def joins(self) -> tuple[str, ...]:
        """The links it joins."""


PAIRS: tuple[type[Revolute] | type[Slide] | type[Gear] | type[Roll] | type[Cam], ...] = (
    Revolute,
    Slide,
    Gear,
    Roll,
    Cam,
)
