"""The kinds of kinematic pair, one file each, against one contract.

A pair is a frozen value that names links and points and holds lengths in metres and angles in
radians. It says which links it joins; what it asks of their motion is said twice, by two roads
that never meet: `graphkin.planning` turns it into steps of a construction, `graphkin.analytic`
into terms of closed vector loops.

How to add a pair kind: a file here with a frozen class that fulfils `Pair`, its class in `PAIRS`,
its table in `graphkin.loading`, a rule in `graphkin.planning` and one in `graphkin.analytic`.
"""

from __future__ import annotations

from graphkin.pairs.cam import Cam, Profile
from graphkin.pairs.gear import Gear
from graphkin.pairs.line import Line
from graphkin.pairs.pair import Circle, Pair, Rod, Rolling, Slot, pin_name, rod_name, start_name
from graphkin.pairs.revolute import Revolute
from graphkin.pairs.roll import Roll
from graphkin.pairs.slide import Slide

__all__ = [
    "PAIRS", "Cam", "Circle", "Gear", "Line", "Pair", "Profile", "Revolute", "Rod", "Roll", "Rolling", "Slide", "Slot",
    "pin_name", "rod_name", "start_name",
]  # fmt: skip

PAIRS: tuple[type[Pair], ...] = (Revolute, Slide, Gear, Roll, Cam)
"""The kinds, in the order in which a mechanism lists its pairs. Every table that depends on kinds has exactly these."""
