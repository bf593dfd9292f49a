"""Instant centres in words: every formula is worked out from the figures it prints, and the answers are right."""

from __future__ import annotations

import re
from functools import cache

import numpy as np
import pytest
from calculator import hold

from graphkin import files as loading
from graphkin.analytic import Motion, motion
from graphkin.errors import NOWHERE, Lang
from graphkin.files import library
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import named
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.say import names
from graphkin.say.centre_velocities import advantage_lines, centre_entries
from graphkin.say.entry import Calculation, Sentence, text_lines
from graphkin.studies.centres import Centres, centres


def explained(of: Centres, lang: Lang) -> list[str]:
    return list(text_lines(centre_entries(of, lang), lang))


GEARED_MOTOR = """
[frame]
name = "0"
A = [0, 0]
D = [80, 0]

[links.1]
AB = 30

[links."2'"]
BC = 70

[links.rocker]
CD = 50

[[driver]]
vector = "BC"
from = "BA"
angle = -150
omega = 4

[sketch]
B = [5, 29]
C = [70, 48]
"""
"""Driven in the joint between two moving links."""
PARALLEL = """
[frame]
name = "4"
A = [0, 0]
D = [60, 0]

[links.1]
AB = 30

[links.2]
BC = 60
points = ["B", "C"]

[links.3]
DC = 30

[[driver]]
vector = "AB"
angle = 75
omega = "30 rpm"

[sketch]
B = [8, 29]
C = [68, 29]
"""
"""A parallelogram: the coupler does not turn, its centre is at infinity."""
STILL = PARALLEL.replace('omega = "30 rpm"', "omega = 0")
WRITTEN = {"geared motor": GEARED_MOTOR, "parallel": PARALLEL}


@cache
def mechanism(name: str) -> Mechanism:
    return loading.loads(WRITTEN[name], name=name) if name in WRITTEN else library.load(name)


@cache
def found(name: str) -> Centres:
    method = plan(mechanism(name))
    return centres(method, replay_all(method))


@cache
def exact(name: str) -> Motion:
    return motion(mechanism(name))


def calculations(name: str, scale: float | None = None) -> list[Calculation]:
    return [entry for entry in centre_entries(found(name), "en", scale) if isinstance(entry, Calculation)]


EVERY = [*library.names(), *WRITTEN]


@pytest.mark.parametrize("scale", [None, 0.0005, 0.00123])
@pytest.mark.parametrize("name", EVERY)
def test_every_value_comes_from_the_figures_before_it(name: str, scale: float | None):
    for entry in calculations(name, scale):
        assert hold([entry.text]) == bool(entry.figures and entry.value)


@pytest.mark.parametrize("name", EVERY)
def test_rotations_are_right_in_size_and_sense(name: str):
    told = {entry.name: entry for entry in calculations(name)}
    fastest = max(abs(float(omega)) for omega in exact(name).omega.values())
    for link in mechanism(name).moving:
        entry, omega = told.get(names.of_link("ω", mechanism(name).called(link))), float(exact(name).omega[link])
        if entry is not None:
            assert entry.value == pytest.approx(abs(omega), rel=1e-9, abs=1e-9 * fastest + 1e-12)
            if entry.value:
                assert entry.note.startswith("counter-clockwise" if omega > 0 else "clockwise")


@pytest.mark.parametrize("name", EVERY)
def test_every_velocity_asked_for_is_answered(name: str):
    told = {entry.name: entry for entry in calculations(name)}
    given = " ".join(e.text for e in centre_entries(found(name), "en") if isinstance(e, Sentence) if "Given" in e.text)
    for question in mechanism(name).ask:
        right = named(mechanism(name), question, NOWHERE).answer(exact(name))
        quantity, _, of = question.partition(" ")
        if "/" in question:
            assert float(right.value) == pytest.approx(calculations(name)[-1].value, rel=1e-9)
        elif quantity == "v":
            entry = told[f"v_{names.point(of)}"]
            assert entry.value == pytest.approx(float(right.value), rel=1e-9, abs=1e-9)
            if entry.value and "from both velocities" not in entry.note:  # a difference is told by its size alone
                angle = np.degrees(np.angle(complex(right.vector)))
                said = re.search(r"at ([\d.]+)° to \+x$|(right|upwards|left|downwards)$", entry.note)
                off = (float(said[1] or 90 * ("right", "upwards", "left", "downwards").index(said[2])) - angle) % 360
                assert min(off, 360 - off) < 0.3
        elif quantity == "omega":
            rate = names.of_link("ω", mechanism(name).called(of))
            assert rate in told or f"{rate} = " in given


@pytest.mark.parametrize("name", library.names())
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_every_centre_is_told_once_with_links_that_give_it(name: str, lang):
    text = explained(found(name), lang)
    count = len(mechanism(name).links)
    assert any(f"= {count * (count - 1) // 2}" in line for line in text)
    for centre, links in found(name).centring.links.items():
        own = names.point(centre)
        lines = [line.strip() for line in text if re.match(rf"{re.escape(own)}(:|：| )", line.strip())]
        assert len(lines) == 1
        for group in re.findall(r"[(（，](?:links|构件) ([^()（）]+)[)）]", lines[0]):
            three = re.split(r", |、", group)
            assert len(three) == 3
            assert {names.point(mechanism(name).called(link)) for link in links} <= set(three)


def test_figure_3_4_as_the_book_does_it():
    """omega_4 = omega_2 P12P24 / P14P24, v_E = omega_3 P13E mu_l."""
    lines = explained(found("fig3-4"), "en")
    assert any(line.strip().startswith("ω4 = ω2 P12P24/P14P24 = 10 × ") for line in lines)
    assert any(line.strip().startswith("v_E = ω3 P13E μ_l = ") for line in lines)


def test_translations_and_relative_drivers_are_told():
    coupler = next(entry for entry in calculations("parallel") if entry.name == "v_2")
    assert coupler.value == pytest.approx(0.03 * np.pi, rel=1e-9)
    assert any("parallel" in line for line in explained(found("parallel"), "en"))
    first = calculations("geared motor")[0]
    assert first.formulas == ("ω_2′,1 P01 P1,2′/P0,2′ P01",)


def test_nothing_is_said_of_speeds_where_no_driver_moves():
    method = plan(loading.loads(STILL, name="still"))
    still = centres(method, replay_all(method))
    text = "\n".join(explained(still, "en"))
    assert "No driver moves" in text
    assert len(still.centring.links) == 6


DIFFERENTIAL = """
frame = {{ name = "0", O = [0, 0] }}
ask = ["omega 3"]
[links]
sun.points = ["O"]
ring.points = ["O"]
3.PM = 14
arm.OP = 60
[[gear]]
links = ["sun", "3"]
centres = ["O", "P"]
radii = [40, 20]
[[gear]]
links = ["ring", "3"]
centres = ["O", "P"]
radii = [80, 20]
internal = true
[[driver]]
link = "sun"
omega = -20
[[driver]]
link = "ring"
omega = {ring}
[[pose]]
vector = "OP"
angle = 130
[[pose]]
vector = "PM"
angle = 20
"""
"""A planet between two driven wheels: omega_3 = (v_ring - v_sun) over the distance of the contacts."""
FIVE_BAR = """
frame = { name = "1", A = [0, 0], E = [110, -14] }
links = { 2.AB = 41, 3.BC = 77, 4.CD = 69, 5.ED = 36 }
driver = [{ vector = "AB", angle = 117, omega = -6 }, { vector = "ED", angle = 95, omega = -2 }]
sketch = { B = [-19, 36], C = [45, 75], D = [107, 22] }
"""


def _told(text: str, lang) -> tuple[str, list[str]]:
    method = plan(loading.loads(text))
    of = centres(method, replay_all(method))
    return "\n".join(explained(of, lang)), list(advantage_lines(of, lang))


def test_of_several_drivers_each_is_given_and_a_pole_is_from_what_is_given():
    text, advantages = _told(DIFFERENTIAL.format(ring=7), "en")
    assert "Given: ω_sun = 20 rad/s (clockwise), ω_ring = 7 rad/s (counter-clockwise)." in text
    # by hand: 20 * 0.04 = 0.8 m/s at the sun, 7 * 0.08 = 0.56 m/s the other way at the ring, 40 mm from there
    assert re.search(r"From the velocities of two points of link 3, v_\S+ = ω_sun .* = 0\.8 m/s and v_\S+ = ω_ring .* = 0\.56 m/s", text)
    assert "= 34 rad/s (counter-clockwise" in text
    assert not advantages  # each of the drivers has a power of its own: no ratio of speeds is one of torques
    text, advantages = _told(FIVE_BAR, "zh")
    assert "由速度图（按给定的 ω2、ω5 作出）求得" in text
    assert "已知：ω2 = 6 rad/s（顺时针）、ω5 = 2 rad/s（顺时针）" in text
    assert not advantages


def test_a_driver_that_rests_holds_its_link_and_the_other_has_an_advantage():
    """With the ring held the arm turns a third as fast as the sun (Willis: 1 + 80/40): three times the torque."""
    assert any("= 3 (same sense)" in line for line in _told(DIFFERENTIAL.format(ring=0), "en")[1])
