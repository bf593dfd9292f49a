"""Groups of Class III, gears, rolling and cams: two roads to one answer, and the book's own equations."""

from __future__ import annotations

import numpy as np
import pytest
import random_mechanisms
from roads import BATCHES, DERIVED, hold_derivatives, hold_roads_together, kinds

from graphkin.analytic import motion
from graphkin.construction import Equation, Simultaneous, Term
from graphkin.errors import GearsApart
from graphkin.files import library, loads
from graphkin.planning import Method, plan
from graphkin.proof.roads import compare
from graphkin.running import replay_all
from graphkin.studies.sweeps import course
from graphkin.studies.sweeps.roads import moving

KINDS = ("triad", "six_bar", "geared_five_bar", "epicyclic", "rolling", "cam", "circular_slot")


@pytest.mark.parametrize("batch", BATCHES)
@pytest.mark.parametrize("kind", KINDS)
def test_polygons_equal_loop_equations(kind: str, batch: int):
    hold_roads_together(getattr(random_mechanisms, kind), kinds(batch))


@pytest.mark.parametrize("kind", KINDS)
def test_velocity_is_the_derivative_of_position(kind: str):
    """A guide that turns keeps its whole Coriolis term."""
    hold_derivatives(getattr(random_mechanisms, kind), range(10**6, 10**6 + DERIVED))


def test_triads_are_solved_by_a_special_point():
    methods = [plan(random_mechanisms.triad(seed)) for seed in range(60)]
    together = sum(any(isinstance(s, Simultaneous) for s in m.velocity.steps) for m in methods)
    assert together <= 2


# --- the equations of the worked examples -------------------------------------------------------


def chain(terms: tuple[Term, ...], plane: str) -> str:
    return " + ".join(term.name(plane) + "?" * term.unknowns for term in terms)


def equations(method: Method, plane: str) -> list[str]:
    construction = method.velocity if plane == "velocity" else method.acceleration
    return [sided(e, plane) for e in construction.equations if not _sum(e)]


def sided(equation: Equation, plane: str) -> str:
    return f"{chain(equation.left, plane)} = {chain(equation.right, plane)}"


def _sum(equation: Equation) -> bool:
    return len(equation.left) == 1 and equation.left[0].unknowns == 2


BOOK = {
    "ex3-1": (["v_B3? = v_B2 + v_B3B2?"], ["a^n_B3D + a^t_B3D? = a_B2 + a^k_B3B2 + a^r_B3B2?"]),
    "fig3-1": (["v_C? = v_B + v_CB?"], ["a_C? = a_B + a^n_CB + a^t_CB?"]),
    "fig2-32": (["v_O2? = v_O1 + v_O2O1?"], ["a^n_O2B + a^t_O2B? = a_O1 + a^n_O2O1 + a^t_O2O1?"]),
    "ex3-2": (
        ["v_E+v_S4E? = v_D+v_S4D?", "v_S4 + v_CS4? = v_B + v_CB?"],
        [
            "a^n_EF + a^n_S4E + a^t_EF+a^t_S4E? = a^n_DG + a^n_S4D + a^t_DG+a^t_S4D?",
            "a_S4 + a^n_CS4 + a^t_CS4? = a_B + a^n_CB + a^t_CB?",
        ],
    ),
    "ex3-4": (
        ["v_C2? = v_C1? + v_C2C1"],
        ["a^n_C2D + a^t_C2D? = a^n_C1A + a^k_C2C1 + a^rn_C2C1 + a^rt_C2C1 + a^t_C1A?"],
    ),
    "ex3-5": (["v_C? = v_B + v_CB?"], ["a^n_CD + a^t_CD? = a_B + a^n_CB + a^t_CB?"]),
    "ex3-7": (
        ["v_B3? = v_B2 + v_B3B2?", "v_E? = v_D + v_ED?"],
        ["a^n_B3C + a^t_B3C? = a_B2 + a^k_B3B2 + a^r_B3B2?", "a_E? = a_D + a^n_ED + a^t_ED?"],
    ),
    "p3-7": (
        ["v_F5? = v_F1 + v_F5F1?", "v_B + v_CB? = v_D + v_CD?"],
        ["a^n_F5E + a^t_F5E? = a_F1 + a^k_F5F1 + a^r_F5F1?", "a_B + a^n_CB + a^t_CB? = a_D + a^n_CD + a^t_CD?"],
    ),
    "p3-15": (
        ["v_D+v_S3D? = v_C+v_S3C?", "v_S3 + v_B3S3? = v_B2 + v_B3B2?"],
        [
            "a^n_DE + a^n_S3D + a^t_DE+a^t_S3D? = a^n_S3C + a_C+a^t_S3C?",
            "a_S3 + a^n_B3S3 + a^t_B3S3? = a_B2 + a^k_B3B2 + a^r_B3B2?",
        ],
    ),
    "p3-12": (
        ["v_C? = v_B + v_CB?"],
        [
            "a^n_CD + a^t_CD? = a_B + a^n_CB + a^t_CB?",
            "a_C + a^n_K2C + a^t_K2C? = a_K1 + a_K2K1?",
            "a^n_L3D + a^t_L3D? = a_L2 + a_L3L2?",
        ],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", BOOK)
def test_equations_are_the_book_s(name: str):
    method = plan(library.load(name))
    velocity, acceleration = BOOK[name]
    assert equations(method, "velocity") == velocity
    assert equations(method, "acceleration") == acceleration


# --- choices and refusals -----------------------------------------------------------------------


@pytest.mark.parametrize(("name", "points"), [("ex3-1", "BCD"), ("p3-5", "BCDE"), ("p3-24a", "BCK"), ("s4-ex7", "ABQ")])
def test_any_coincident_point_gives_the_same(name: str, points: str):
    mechanism = library.load(name)
    exact = motion(mechanism)
    for point in points:
        method = plan(mechanism, coincident=point)
        assert compare(method, replay_all(method), exact) < 1e-12, point


def test_gears_that_do_not_mesh_are_refused():
    text = library.text("p3-12").replace("radii = [30, 20]", "radii = [30, 21]")
    with pytest.raises(GearsApart) as refused:
        plan(loads(text, name="gears", file="gears.toml"))
    assert "-1 mm from the 51 mm" in refused.value.message("en")
    fitting = text.replace("radii = [30, 21]", "radii = [29.411765, 20.588235]")
    assert "29.411765 and 20.588235 mm fit" in refused.value.message("en")
    assert "相合的半径为 29.411765、20.588235 mm" in refused.value.message("zh")
    plan(loads(fitting, name="gears", file="gears.toml"))


def test_positions_by_fit_keep_the_branch():
    mechanism = library.load("p3-15")
    method = plan(mechanism)
    moved = course(method, ["135:495:2"])
    drawn, exact = (moving(method, moved.path, moved.t, by) for by in ("construction", "analysis"))
    beside = np.min([np.abs(moved.t - change.at) for change in moved.path.changes], axis=0) < np.radians(0.5)
    for link in mechanism.moving:
        off, largest = np.abs(drawn.omega[link] - exact.omega[link]), np.max(np.abs(exact.omega[link]))
        assert np.all(off[~beside] < 1e-9)
        assert np.all(off[beside] <= 1e-8 * largest)  # a tenth of a degree from a change point digits are lost
    plot = replay_all(method, [method.drivers[0].value + np.linspace(0, 2 * np.pi, 181)])
    assert abs(plot.position["C"][0] - plot.position["C"][-1]) < 1e-9


CLASS_IV = """
title = "Class IV"
[frame]
A = [0, 0]
D = [120, 0]
[links.1]
AB = 20
[links.2]
shape = { B = [0, 0], C = [40, 10], E = [35, 45] }
[links.3]
CF = 50
[links.4]
EG = 45
[links.5]
shape = { D = [0, 0], F = [-20, 25], G = [-30, 60] }
[[driver]]
vector = "AB"
angle = 80
omega = 10
[sketch]
C = [43, 30]
E = [38, 65]
F = [93, 32]
G = [83, 66]
"""


def test_a_group_of_class_four_is_solved_together():
    mechanism = loads(CLASS_IV, name="four")
    method = plan(mechanism)
    assert any(isinstance(step, Simultaneous) for step in method.velocity.steps)
    assert compare(method, replay_all(method), motion(mechanism)) < 1e-9


def test_the_pole_is_found_last():
    """Sun Huan, example 3-4: both sides start with an unknown arrow, so the known one is laid off first."""
    equation = plan(library.load("ex3-4")).velocity.equations[0]
    kinds = [type(step).__name__ for step in equation.steps]
    assert kinds == ["Given", "LayOff", "Ray", "Ray", "Meet"]
    assert equation.steps[-1].point == "p"


RACK = """
[frame]
A = [0, 0]
[links.3]
AP = 20
[links.4]
TU = 120
[[slide]]
name = "table"
block = "4"
point = "T"
tilt = {tilt}
guide = "frame"
through = [0, 20]
angle = {angle}
[[roll]]
wheel = "3"
centre = "A"
radius = 20
on = "4"
through = "T"
{track}
side = "{side}"
[[pose]]
slide = "table"
at = {at}
[[driver]]
vector = "AP"
angle = 60
omega = -6
"""


@pytest.mark.parametrize(
    ("tilt", "angle", "track", "side", "at", "speed"),
    [
        (0, 0, 'toward = "U"', "right", -40, 0.12), (180, 0, 'toward = "U"', "left", 40, 0.12),
        (0, 180, 'toward = "U"', "left", 40, -0.12), (0, 0, 'from = "TU"\nangle = 180', "left", -40, 0.12),
    ],
)  # fmt: skip
def test_a_rack_in_a_guide_of_its_own(tilt: int, angle: int, track: str, side: str, at: int, speed: float):
    """The wheel stands above or below as the guide says; the rack moves with the wheel's rim, whichever way it is written."""
    text = RACK.format(tilt=tilt, angle=angle, track=track, side=side, at=at)
    method = plan(loads(text, name="rack", file="rack.toml"))
    plot = replay_all(method)
    assert compare(method, plot, motion(method.mechanism)) < 1e-12
    assert float(plot.s_rate["table"]) == pytest.approx(speed)
    assert float(plot.omega["3"]) == -6


CROSSHEAD = """
[frame]
A = [0, 0]
[links.1]
AB = 30
[links.2]
BC = 100
[links.3]
CP = 20
[links.5]
points = ["C"]
[[slide]]
block = "5"
point = "C"
guide = "frame"
through = [0, 10]
[[roll]]
wheel = "3"
centre = "C"
radius = 20
on = "frame"
through = [0, -10]
[[pose]]
vector = "CP"
angle = 60
[[driver]]
vector = "AB"
angle = 60
omega = -6
alpha = 2
[sketch]
C = [110, 10]
"""


def test_a_wheel_on_a_crosshead_rolls():
    method = plan(loads(CROSSHEAD, name="crosshead", file="crosshead.toml"))
    plot = replay_all(method)
    assert compare(method, plot, motion(method.mechanism)) < 1e-12
    assert float(plot.omega["3"]) * 0.02 == pytest.approx(-float(plot.s_rate["s0"]))
