"""Angular accelerations of gears: by the constant ratios of a train, by an arrow where the arm's own is read off one."""

from __future__ import annotations

import pytest

from graphkin import Drawing
from graphkin.construction.kinds import Roll
from graphkin.files import library, loads
from graphkin.planning import plan

TRAIN = """
frame = { O = [0, 0] }
ask = ["omega 3", "alpha 3"]
[links]
H.OC = 50
2.points = ["C"]
3.points = ["O"]
[[gear]]
links = ["frame", "2"]
centres = ["O", "C"]
radii = [30, 20]
[[gear]]
links = ["2", "3"]
centres = ["C", "O"]
radii = [15, 35]
[[driver]]
vector = "OC"
angle = 25
omega = "300 r/min"
alpha = 5
"""


def test_a_train_has_the_ratios_of_its_velocities():
    """omega_H / omega_3 = 2.8 is constant, so alpha_3 is alpha_H / 2.8, in one line and of no length on paper."""
    machine = loads(TRAIN, name="train", file="train.toml")
    assert float(Drawing.of(machine).alpha["3"]) == pytest.approx(5 / 2.8, rel=1e-12)
    text = "\n".join(Drawing.of(machine).explain())
    assert "α3 = α_H − r2′(α2 − α_H)/r3 = 5 − 0.015 × (12.5 − 5)/0.035 = 1.786 rad/s²" in text
    assert "a_L3" not in text


def test_a_gear_on_a_coupler_is_drawn():
    """The coupler's own angular acceleration is read off the polygon."""
    method = plan(library.load("p3-12"))
    assert not any(isinstance(part, Roll) for part in method.acceleration.parts)
