"""Gears, racks and wheels in files of every form: solved, told, and refused where they contradict themselves."""

from __future__ import annotations

import cmath
import os
import random
import re
from math import degrees

import numpy as np
import pytest
from contacts import touching
from rolling_machines import FAMILIES

from graphkin.analytic import motion
from graphkin.api import Drawing
from graphkin.errors import GearsApart, GraphkinError, Lang, NotPlaced, OffTrack, PosesDiffer
from graphkin.files import loads
from graphkin.model.mechanism import Mechanism
from graphkin.planning import plan
from graphkin.proof.roads import compare
from graphkin.running import replay_all
from graphkin.say import explain

COUNT = max(4, int(os.environ.get("GRAPHKIN_RANDOM", "400")) // 40)
"""Random files of each family; more of them with GRAPHKIN_RANDOM=8000 in the environment."""


def read(text: str) -> Mechanism:
    return loads(text, name="file", file="file.toml")


def solved(mechanism: Mechanism) -> Drawing:
    """A drawing that the analysis agrees with, and in which nothing slips; DeadPoint passes."""
    drawing = Drawing.of(mechanism)
    exact = motion(mechanism)
    assert compare(drawing.method, drawing.plot, exact) < 1e-9
    size, fast = drawing.method.size, max(abs(v) for v in exact.velocity.values()) + 1e-6
    for gap, slip in touching(exact):
        assert np.max(np.abs(gap)) < 1e-6 * size
        assert np.max(np.abs(slip)) < 1e-6 * fast
    return drawing


@pytest.mark.parametrize("family", FAMILIES)
def test_random_files_are_solved(family: str):
    """The sketch tells where everything stands: that is the assembly, and both roads find it."""
    for seed in range(COUNT):
        mechanism = read(FAMILIES[family](seed))
        plot = solved(mechanism).plot
        assert all(abs(plot.position[p] - z) < 2e-6 for p, z in mechanism.sketch.items()), seed


@pytest.mark.many
@pytest.mark.parametrize("family", FAMILIES)
def test_random_files_are_told(family: str):
    for seed in range(COUNT // 2):
        drawing = Drawing.of(read(FAMILIES[family](seed)))
        assert all(len(told(drawing, lang)) > 10 for lang in ("en", "zh"))


def told(drawing: Drawing, lang: Lang = "en") -> list[str]:
    scales: dict[str, float] = {"length": 1e-3, "velocity": 1e-2, "acceleration": 1e-1}
    return explain(drawing.method, drawing.plot, scales, lang)


# --- poses --------------------------------------------------------------------------------------


def one_more_pose(text: str, seed: int, wrong_deg: float) -> tuple[str, Drawing]:
    """The file with a pose of any link, against the frame or any other, and the drawing without it."""
    drawing, rng = Drawing.of(read(text)), random.Random(seed)
    links = drawing.mechanism.links
    arms = [
        (link, (a, b)) for link in drawing.mechanism.moving for a in links[link].points for b in links[link].points
        if abs(links[link].arm(a, b)) > 1e-6 and a[0].isupper() and b[0].isupper()
    ]  # fmt: skip
    link, vector = rng.choice(arms)
    angle, others = cmath.phase(drawing.plot.arm(*vector)), [arm for arm in arms if arm[0] != link]
    measured_from = rng.choice(others)[1] if others and rng.random() < 0.5 else None
    if measured_from:
        angle -= cmath.phase(drawing.plot.arm(*measured_from))
    keys = [f'vector = "{"".join(vector)}"', f"angle = {degrees(angle) + wrong_deg!r}"]
    keys += [f'from = "{"".join(measured_from)}"'] if measured_from else []
    at = text.index("[sketch]")
    return text[:at] + "\n".join(["[[pose]]", *keys, ""]) + text[at:], drawing


@pytest.mark.parametrize("family", FAMILIES)
def test_a_pose_that_repeats_is_fine(family: str):
    for seed in range(COUNT // 4):
        text, before = one_more_pose(FAMILIES[family](seed), seed, 0.0)
        after = solved(read(text))
        for point, place in before.plot.position.items():
            assert abs(after.plot.position[point] - place) < 1e-8


@pytest.mark.parametrize("family", FAMILIES)
def test_a_pose_that_contradicts_is_refused_with_how_much(family: str):
    for seed in range(COUNT // 4):
        wrong = random.Random(seed).choice((-1, 1)) * random.Random(-seed).uniform(0.01, 170)
        text, _ = one_more_pose(FAMILIES[family](seed), seed, wrong)
        with pytest.raises(PosesDiffer) as refused:
            plan(read(text))
        if text.count("[[roll]]") > text.count("side ="):
            continue  # the side that is left out is taken from the pose, too, and so is how much it misses by
        assert float(refused.value.apart.removesuffix("°")) == pytest.approx(abs(wrong), rel=1e-4)
        assert refused.value.where.key.startswith("pose.")


@pytest.mark.parametrize("family", FAMILIES)
def test_a_pose_that_is_missing_is_asked_for(family: str):
    for seed in range(COUNT // 4):
        text = FAMILIES[family](seed)
        for pose in re.findall(r"\[\[pose\]\]\n(?:[^\[].*\n)*", text):
            with pytest.raises(GraphkinError) as refused:
                plan(read(text.replace(pose, "", 1)))
            assert type(refused.value).__name__ in ("NotPlaced", "Several", "SayValue")


# --- single files ---------------------------------------------------------------------------------

CONTRADICTING = """
[frame]
A = [0, 0]
D = [100, 0]
[links.1]
AB = 40
[links.2]
BC = 110
[links.3]
DC = 70
[[driver]]
vector = "AB"
angle = 60
omega = 2
{poses}
[sketch]
B = [20, 35]
C = [120, 67]
"""


@pytest.mark.parametrize(
    ("poses", "apart", "others"),
    [
        ('[[pose]]\nvector = "AB"\nangle = 61', "1°", ["driver.0"]),
        ('[[pose]]\nvector = "AB"\nangle = -299', "1°", ["driver.0"]),
        ('[[pose]]\nvector = "BA"\nangle = -121', "1°", ["driver.0"]),
        ('[[pose]]\nvector = "DC"\nangle = 90', "21.5351°", ["driver.0"]),
        ('[[pose]]\nvector = "AB"\nangle = 60\n[[pose]]\nvector = "BC"\nfrom = "AB"\nangle = 0', "43.9174°", ["driver.0", "pose.0"]),
    ],
)  # fmt: skip
def test_both_lines_are_named(poses: str, apart: str, others: list[str]):
    with pytest.raises(PosesDiffer) as refused:
        plan(read(CONTRADICTING.format(poses=poses)))
    assert (refused.value.apart, [other.key for other in refused.value.others]) == (apart, others)
    for lang in ("en", "zh"):
        assert apart in refused.value.message(lang)


RACK = """
[frame]
A = [0, 0]
[links.1]
AB = 30
[links.2]
CQ = 100
[[roll]]
wheel = "1"
centre = "A"
radius = 40
on = "2"
through = "C"
toward = "Q"
side = "{side}"
[[slide]]
name = "2"
block = "2"
point = "C"
guide = "frame"
through = [0, {height}]
tilt = 0
[[pose]]
slide = "2"
at = -50
{more}
[[driver]]
vector = "AB"
angle = 30
omega = 5
[sketch]
C = [-50, {height}]
Q = [50, {height}]
"""


def test_a_rack_in_a_guide_is_told():
    """Its guide may bear the rack's own name."""
    drawing = solved(read(RACK.format(side="left", height=-40, more="")))
    assert drawing.plot.s_rate["2"] == pytest.approx(0.2)
    assert any("a sliding pair keeps its centre A at the distance" in line for line in told(drawing))


@pytest.mark.parametrize(("side", "height", "gap"), [("left", 40, 80), ("right", 41, 1), ("left", -39.9, 0.1)])
def test_a_rack_beside_its_pinion_is_refused(side: str, height: float, gap: float):
    with pytest.raises(OffTrack) as refused:
        plan(read(RACK.format(side=side, height=height, more="")))
    assert f"{gap:g} mm apart" in refused.value.message("en")
    assert f"相差 {gap:g} mm" in refused.value.message("zh")


def test_a_slide_posed_twice():
    again = '[[pose]]\nslide = "2"\nat = {}\n'
    solved(read(RACK.format(side="left", height=-40, more=again.format(-50))))
    with pytest.raises(PosesDiffer) as refused:
        plan(read(RACK.format(side="left", height=-40, more=again.format(-48))))
    assert refused.value.apart == "2 mm"


HELD = """
[frame]
A = [0, 0]
D = [100, 0]
[links.1]
shape = {{ A = [0, 0], B = [40, 0], E = [60, 0] }}
[links.2]
BC = 100
[links.3]
shape = {{ D = [0, 0], C = [40, 0], F = [60, 0] }}
[links.one]
points = ["E"]
[links.two]
points = ["F"]
[[gear]]
links = ["one", "two"]
centres = ["E", "F"]
radii = [70, {radius}]
[[driver]]
vector = "AB"
angle = 60
omega = 2
alpha = 5
[[driver]]
link = "one"
omega = -3
[sketch]
B = [20, 35]
C = [120, 35]
"""


def test_several_links_keep_the_distance_of_two_gears():
    """The line of centres of a parallelogram does not turn: ω_two = −70/30 ω_one."""
    drawing = solved(read(HELD.format(radius=30)))
    assert drawing.plot.omega["two"] == pytest.approx(7.0)
    assert drawing.plot.alpha["two"] == pytest.approx(0.0, abs=1e-9)
    assert any("line of centres" in line for line in told(drawing))
    with pytest.raises(GearsApart):
        plan(read(HELD.format(radius=31)))


UNPLACED = """
[frame]
A = [24, 4.6]
E = [15.9, 40.8]
[links.1]
AB = 29.4
[links.2]
CD = 15.15
[links.3]
CE = 62.52
[[driver]]
vector = "CD"
angle = 111
omega = 10
[[roll]]
wheel = "2"
centre = "C"
radius = 15.15
on = "1"
through = "A"
toward = "B"
[[pose]]
vector = "CD"
angle = 111
"""


def test_links_that_nothing_places_are_named():
    with pytest.raises(NotPlaced) as refused:
        plan(read(UNPLACED))
    assert refused.value.links == ("1", "3")


def test_more_contacts_than_letters():
    """Fifteen wheels in a row on the frame: contacts go on with primes."""
    wheels = range(1, 16)
    text = "[frame]\n" + "\n".join(f"O{k} = [{40 * k}, 0]" for k in wheels)
    text += "".join(f'\n[links.{k}]\npoints = ["O{k}"]' for k in wheels)
    text += "".join(
        f'\n[[gear]]\nlinks = ["{k}", "{k + 1}"]\ncentres = ["O{k}", "O{k + 1}"]\nradii = [20, 20]' for k in wheels[:-1]
    )
    drawing = solved(read(text + '\n[[driver]]\nlink = "1"\nomega = 3\n'))
    assert drawing.plot.omega["15"] == pytest.approx(3.0)
    assert len(told(drawing, "zh")) > 20


def test_a_rack_in_a_slot_is_drawn_from_what_is_given() -> None:
    """Its pose is laid off, its velocities start from the point of contact; elsewhere the rack is the template."""
    scales, tried = {"length": 0.001, "velocity": 0.01, "acceleration": 0.1}, 0
    for seed in range(12):
        try:
            drawing = solved(read(FAMILIES["rack_in_a_slot"](seed)))
            method, there = drawing.method, replay_all(drawing.method, [drawing.method.drivers[0].value + 0.02])
        except GraphkinError:
            continue
        tried += 1
        text = "\n".join(explain(method, drawing.plot, scales, "en", everything=True))
        position, rest = text.split("(1) ")[1].split("(2) ")
        velocities = rest.split("(3) ")[0]
        assert "template" not in position, seed
        assert "No order of ruler" not in velocities, seed
        assert "Pure rolling of links" in velocities, seed
        moved = "\n".join(explain(method, there, scales, "en")).split("(1) ")[1].split("(2) ")[0]
        before, trial = moved.split("On paper a template")
        (template,) = re.findall(r"link (\S+) on tracing paper", trial)
        assert template != method.mechanism.frame, seed
        pairs = re.findall(r"\b((?:[A-Z]\d*′*){2}) = ", trial.split(" fit")[0])
        letters = {mark for pair in pairs for mark in re.findall(r"[A-Z]\d*′*", pair)}
        assert all(mark in method.mechanism.points or f" {mark} " in before for mark in letters), seed
    assert tried > 6
