"""The kinds of kinematic pair, one file each, against one contract.

A pair is a frozen value that names links and points and holds lengths in metres and angles in radians. It says in
plain data which links it joins, which circles and lines touch, what rolls, and which lower pairs do the same (`Pair`).
Two roads that never meet read these data: `graphkin.planning` makes bodies and joints of a construction of them,
`graphkin.analytic` terms of closed vector loops.

How to add a pair kind; `tests/model/test_pairs.py` names the table in which it is still missing:

    here      a file with a frozen class on `Pair`, and its class in `PAIRS`
    files     its keys in `schema` (and `graphkin.schema.json`, by `json_schema_text`), its reader in `pairs.READERS`
              or, where it shares a table of the file, in that table's reader; what may be wrong, in `errors.mechanism`
    analytic  its rule in `rules.RULES`; `replaced` where its lower-pair equivalent is all there is to it
    planning  nothing, where it has a lower-pair equivalent or rolls as wheels do: those are data
    say       its line in `structure.KINDS`; its sentence in `equivalents.EQUIVALENTS`, where it has an equivalent; its
              normal in `centre_steps.NORMALS`, where its links slide on each other; the phrases of all these in
              `phrases`; its name in messages in `errors.motion.PAIRS`
    sheet     its sign in `mechanism_figure.BEFORE_LINKS` or `OVER_LINKS`, or its wheels in `wheels.UNDER_LINKS`; a new
              form of line that a ruler is to hold: its rule in `check.links`
    library   a mechanism with it; `tests/gallery.py` and `tests/golden.py` draw and write it
    tests     random mechanisms of it in `tests/random_mechanisms.py`, in the lists of kinds of the tests that use them
"""

from __future__ import annotations

from graphkin.model.pairs.cam import Cam, Profile
from graphkin.model.pairs.circular_slot import CircularSlot
from graphkin.model.pairs.gear import Gear
from graphkin.model.pairs.pair import Circle, Line, Pair, Rod, Rolling, Slot, pin_name, rod_name, start_name
from graphkin.model.pairs.revolute import Revolute
from graphkin.model.pairs.roll import RollingContact
from graphkin.model.pairs.slide import Slide

__all__ = [
    "PAIRS", "Cam", "Circle", "CircularSlot", "Gear", "Line", "Pair", "Profile", "Revolute", "Rod", "Rolling",
    "RollingContact", "Slide", "Slot", "pin_name", "rod_name", "start_name",
]  # fmt: skip

PAIRS: tuple[type[Pair], ...] = (Revolute, Slide, CircularSlot, Gear, RollingContact, Cam)
"""The kinds, in the order in which a mechanism lists its pairs. Every table that depends on kinds has exactly these."""
