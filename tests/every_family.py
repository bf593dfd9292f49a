"""Every family of random mechanisms, by name."""

from __future__ import annotations

import random
from collections.abc import Callable
from functools import partial

import random_mechanisms
import repeating
import rolling_machines

from graphkin.files import loads
from graphkin.model.mechanism import Mechanism

Make = Callable[[int], Mechanism]
OTHERS = ("cylinder", "relative_angle", "coupler_angle", "chain", "triad", "six_bar", "geared_five_bar", "epicyclic",
          "rolling", "cam")  # fmt: skip
REPEATING = ("table_on_guides", "wheel_between_plates", "wheel_between_racks", "wheel_on_belt", "carriage",
             "cardan_wheel", "twin_cams", "breadth_cam", "planets", "cranks", "trammel")  # fmt: skip


def from_text(write: Callable[[int], str], seed: int) -> Mechanism:
    return loads(write(seed), name="file", file="file.toml")


def repeated(name: str, seed: int) -> str:
    text: str = getattr(repeating, name)(random.Random(seed), 0.0)
    return text
FAMILIES: dict[str, Make] = {
    **{kind: partial(random_mechanisms.dyad, kind) for kind in random_mechanisms.DYADS},
    **{name: getattr(random_mechanisms, name) for name in OTHERS},
    **{name: partial(from_text, family) for name, family in rolling_machines.FAMILIES.items()},
    **{name: partial(from_text, partial(repeated, name)) for name in REPEATING},
}
