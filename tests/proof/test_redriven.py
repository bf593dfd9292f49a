"""Whatever fixes the drawn position and the motion of a mechanism leads to the same mechanism."""

from __future__ import annotations

import cmath
import math
import os
import random
from collections.abc import Iterator

import numpy as np
import pytest
from redriving import FAMILIES, KINDS, redriven
from roads import planned

from graphkin.analytic import Motion, motion
from graphkin.api import Drawing
from graphkin.construction import LayOff, Measure, Plot, Simultaneous, replay
from graphkin.files import loads
from graphkin.planning import Method, plan
from graphkin.planning.at_rest import at_rest
from graphkin.planning.drawn_position import by_pose
from graphkin.planning.needed import turnings
from graphkin.proof.roads import compare
from graphkin.running import replay_all

COUNT = max(1, int(os.environ.get("GRAPHKIN_RANDOM", "400")) // 400)
"""Random mechanisms of each family and kind; more of them with GRAPHKIN_RANDOM=20000 in the environment."""

POSED = [kind for kind in KINDS if "posed" in kind]


def solved(family: str, kind: str, count: int) -> Iterator[tuple[int, Motion, Method, Plot]]:
    """The mechanisms that are posed well, each with its seed and its motion before."""
    for seed in range(count):
        if (found := redriven(family, kind, seed)) is not None:
            mechanism, before = found
            if (drawn := planned(mechanism)) is not None:
                yield seed, before, *drawn


@pytest.mark.many
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("family", FAMILIES)
def test_another_quantity_gives_the_same_motion(family: str, kind: str) -> None:
    for seed, before, method, plot in solved(family, kind, COUNT):
        assert compare(method, plot, motion(method.mechanism)) < 1e-8, seed
        for point in method.mechanism.points:
            assert abs(plot.position[point] - before.position[point]) < 1e-6, (seed, point)
        for link in method.mechanism.moving:
            assert plot.omega[link] == pytest.approx(before.omega[link], rel=1e-6, abs=1e-6), (seed, link)


@pytest.mark.many
@pytest.mark.usefixtures("one_paper")
@pytest.mark.parametrize(
    ("family", "kind"),
    [*((each, "link") for each in ("RRP", "PRR", "cylinder", "truss", "truss_on_links")),
     *((each, "relative") for each in ("RRR", "six_bar", "triad", "chain", "geared_five_bar", "rolling", "circular_slot"))],
)  # fmt: skip
def test_links_driven_as_no_crank_is_are_drawn_told_and_moved(family: str, kind: str) -> None:
    for _, _, method, plot in solved(family, kind, COUNT):
        drawing = Drawing(method.mechanism, method, plot)
        assert len(list(drawing.step_sheets())) > 1
        assert all(len(drawing.explain(lang, everything=True)) > 20 for lang in ("en", "zh"))
        steps = np.linspace(-1, 1, 5)
        spans = [1e-4 if driver.kind == "slide" else math.radians(0.2) for driver in method.drivers]
        values = [d.value + span * steps for d, span in zip(method.drivers, spans, strict=True)]
        assert compare(method, replay_all(method, values), motion(method.mechanism, values)) < 1e-8


@pytest.mark.parametrize("family", ["RPR", "PRP", "cylinder", "rolling", "cam", "circular_slot"])
def test_a_coincident_point_of_links_that_a_driver_turns_apart(family: str) -> None:
    for seed, _, method, plot in solved(family, "relative", 2 * COUNT):
        exact = motion(method.mechanism, plot.facts.values)
        for point in method.mechanism.points:
            other = plan(method.mechanism, point)
            assert compare(other, replay_all(other), exact) < 1e-6, (seed, point)


@pytest.mark.usefixtures("one_paper")
@pytest.mark.parametrize("family", ["relative_angle", "six_bar", "triad"])
def test_what_a_relative_driver_turns_does_not_stand_still(family: str) -> None:
    """The rates of links that are solved together hang on a driver that turns two of them against each other."""
    for seed, _, method, plot in solved(family, "relative", 2 * COUNT):
        groups = [step for step in method.velocity.steps if isinstance(step, Simultaneous)]
        told = "\n".join(Drawing(method.mechanism, method, plot).explain("en", everything=True))
        for link in {one.link for group in groups for chain in group.chains for one in chain.unknown if one.link}:
            assert "at rest, so these links stand still" not in told, seed
            assert any(f"ω{a} = ω{b} + ω" in told for a in method.mechanism.links for b in method.mechanism.links), link


RELATIVE = """
[frame]
A = [0, 0]
B = [50, 0]
[links.1]
AC = 40
[links.2]
BC = 30
[links.3]
{other}
[links.4]
{last}
[[driver]]
vector = "{vector}"
from = "{base}"
omega = {rate}
alpha = {more}
angle = {angle}
[sketch]
C = [32, 24]
D = [{x}, {y}]
E = [90, 40]
"""


@pytest.mark.parametrize("base", ["AC", "CB"])
@pytest.mark.parametrize(("rate", "more"), [(0, 0), (3, 0), (0, -5), (-2, 4)])
@pytest.mark.parametrize("at", "ABC")
def test_at_rest_is_what_does_not_move(base: str, rate: float, more: float, at: str) -> None:
    """A link driven against one that cannot move moves, unless its driver is at rest."""
    pivot = {"A": 0, "B": 50, "C": 32 + 24j}[at]
    D = pivot + cmath.rect(45, 0.9)
    along = {"AC": 32 + 24j, "CB": 18 - 24j}[base]
    text = RELATIVE.format(other=f"{at}D = 45", last="DE = 42", vector=f"{at}D", base=base, rate=rate, more=more,
                           angle=math.degrees(0.9 - cmath.phase(along)), x=D.real, y=D.imag)  # fmt: skip
    text += '[[slide]]\npin = "E"\nguide = "frame"\nthrough = [0, 40]\n'
    method = plan(loads(text))
    plot = replay_all(method)
    assert compare(method, plot, motion(method.mechanism)) < 1e-8
    rested = at_rest(method, plot.facts)
    for link in method.mechanism.moving:
        still = plot.omega[link] == plot.alpha[link] == 0
        assert rested.issuperset(turnings(method, "omega", link)) == still, link


@pytest.mark.many
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("family", FAMILIES)
def test_nothing_that_moves_is_taken_to_be_at_rest(family: str, kind: str) -> None:
    for seed, _, method, plot in solved(family, kind, COUNT):
        rested = at_rest(method, plot.facts)
        for link in method.mechanism.moving:
            if rested.issuperset(turnings(method, "omega", link)):
                assert abs(plot.omega[link]) + abs(plot.alpha[link]) < 1e-9, (seed, link)


@pytest.mark.many
@pytest.mark.usefixtures("one_paper")
@pytest.mark.parametrize("kind", POSED)
@pytest.mark.parametrize("family", ["RRP", "geared_five_bar", "rolling", "truss"])
def test_what_is_given_is_laid_off_and_the_driver_read_off(family: str, kind: str) -> None:
    for seed, _, method, plot in solved(family, kind, COUNT):
        placed, drawn = by_pose(method, plot)
        again = replay(placed.position, Plot(drawn.facts, drawn.near))
        assert all(abs(again.position[p] - plot.position[p]) < 1e-8 for p in method.mechanism.points), seed
        given = [*method.mechanism.poses, *(d for d in method.mechanism.drivers if d.value is not None)]
        fixed = {(d.link, d.from_link) for d in given}
        drawing = Drawing(method.mechanism, method, plot)
        assert {(d.link, d.from_link) for d in placed.drivers if d.kind != "spin"} <= fixed, seed
        if not seed:
            acts = [act for act in placed.acts if act.plane == "position"]
            assert len(list(drawing.step_sheets(only="position", tight=True))) == len(acts)
        free = [d for d in method.mechanism.drivers if d.value is None and d.kind == "angle"]
        for lang, measured in (("en", "Measured: φ"), ("zh", "量得：φ")) if free else ():
            assert any(line.strip().startswith(measured) for line in drawing.explain(lang)), seed


def _five_bar(rng: random.Random, reverse: tuple[bool, bool], straight: int) -> str:
    """A coupler along its crank or against it, its angle left to a pose of the rocker."""
    turned, shift = cmath.rect(1, rng.uniform(-math.pi, math.pi)), complex(rng.uniform(-50, 50), rng.uniform(-50, 50))
    a, e = 0j, 90 + 0j
    b = a + cmath.rect(rng.uniform(30, 40), rng.uniform(0.8, 2.2))
    c = b + straight * (b - a) / abs(b - a) * rng.uniform(45, 70)
    d = e + cmath.rect(rng.uniform(30, 40), rng.uniform(0.8, 2.2))
    a, b, c, d, e = (shift + z * turned for z in (a, b, c, d, e))
    crank, coupler = ("BA" if reverse[0] else "AB"), ("CB" if reverse[1] else "BC")
    angle = math.degrees(cmath.phase((a - b) if reverse[0] else (b - a)))
    return f"""[frame]
A = [{a.real!r}, {a.imag!r}]
E = [{e.real!r}, {e.imag!r}]
[links.1]
AB = {abs(b - a)!r}
[links.2]
BC = {abs(c - b)!r}
[links.3]
CD = {abs(d - c)!r}
[links.4]
ED = {abs(e - d)!r}
[[driver]]
vector = "{crank}"
angle = {angle!r}
omega = 3
[[driver]]
vector = "{coupler}"
from = "{crank}"
omega = -2
alpha = 5
[[pose]]
vector = "ED"
angle = {math.degrees(cmath.phase(d - e))!r}
[sketch]
B = [{b.real}, {b.imag}]
C = [{c.real}, {c.imag}]
D = [{d.real}, {d.imag}]
"""


@pytest.mark.parametrize("straight", [1, -1])
@pytest.mark.parametrize("reverse", [(False, False), (False, True), (True, False), (True, True)])
def test_a_half_turn_is_the_same_on_both_roads(reverse: tuple[bool, bool], straight: int) -> None:
    for seed in range(8):
        mechanism = loads(_five_bar(random.Random(f"{seed}"), reverse, straight))
        method = plan(mechanism)
        value, exact = method.drivers[1].value, motion(mechanism)
        assert abs(math.remainder(value, math.pi)) < 1e-9
        assert float(exact.values[1]) == pytest.approx(value, abs=1e-8)
        plot = replay_all(method)
        assert compare(method, plot, motion(mechanism, plot.facts.values)) < 1e-9, seed


def test_the_follower_s_position_given() -> None:
    mechanism = loads(
        """
        [frame]
        A = [0, 0]
        D = [60, 0]
        [links.1]
        AB = 20
        [links.2]
        BC = 55
        [links.3]
        DC = 40
        [[driver]]
        vector = "AB"
        omega = 10
        [[pose]]
        vector = "DC"
        angle = 100
        [sketch]
        B = [10, 17]
        C = [55, 40]
        """
    )
    drawing = Drawing.of(mechanism)
    placed, _ = by_pose(drawing.method, drawing.plot)
    laid = [step for step in placed.position.steps if isinstance(step, LayOff)]
    assert [(step.start, step.tip) for step in laid] == [("D", "C")]
    assert {step.of for step in placed.position.steps if isinstance(step, Measure)} == {"1", "2"}
    text = drawing.explain("en")
    told = text[text.index("(1) The mechanism, drawn to scale") :]
    assert " mm at 100° to +x: C." in told[2]
    assert "circle about A with radius" in told[3]
    assert told[3].endswith("They cross at B (B above AC).")
    assert "  Measured: φ1 = 85.38°." in told[4:6]
