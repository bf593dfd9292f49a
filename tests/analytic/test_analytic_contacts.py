"""Gears, rolling and cams on the analytic road: every kind and side, on fixed and on moving links."""

from __future__ import annotations

import cmath
from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest
from contacts import touching
from roads import definite

from graphkin.analytic import NoAssembly, mobility, motion
from graphkin.files import loads
from graphkin.model.mechanism import Mechanism
from graphkin.model.pairs import RollingContact

CRANK = """
[frame]
name = "0"
A = [0, 0]
D = [90, 10]

[links.1]
AB = 20

[[driver]]
vector = "AB"
angle = 50
omega = 6
alpha = -3
"""
"""A crank; D is a second fixed point."""

ROCKER = (
    CRANK
    + """
[links.3]
DE = 80

[sketch]
E = [40, 70]
"""
)
"""A rocker to be moved by the crank through a pair."""

CARRIER = """
[frame]
name = "0"
A = [0, 0]

[links.H]
AB = 50

[[driver]]
vector = "AB"
angle = 40
omega = 3
alpha = 2

[links.2]
BP = 8
"""
"""A carrier with a planet that shows its angle by a point; a pose for it."""

POSE = """
[[pose]]
vector = "BP"
angle = 100
"""


def wheel_and_rail(side: str, angle: float = 0.0) -> str:
    """The crank moves the centre of a wheel through a rod; the rail lies at an angle to +x."""
    y = 0 if side == "left" else 40
    return (
        CRANK
        + f"""
        [links.2]
        BC = 80
        [links.4]
        CP = 12
        [[roll]]
        wheel = "4"
        centre = "C"
        radius = 20
        on = "frame"
        through = [30, {y}]
        angle = {angle}
        side = "{side}"
        [[pose]]
        vector = "CP"
        angle = 30
        [sketch]
        C = [90, 20]
        """
    )


def rack_on_wheel(side: str) -> str:
    """As in exercise 3-19: a rack carried by the crank rolls on a wheel about D."""
    height = -2 if side == "left" else 22
    return (
        CRANK
        + f"""
        [links.2]
        BQ = 120
        [links.3]
        DW = 30
        [[roll]]
        wheel = "3"
        centre = "D"
        radius = 12
        on = "2"
        through = "B"
        toward = "Q"
        side = "{side}"
        [[pose]]
        vector = "DW"
        angle = 90
        [sketch]
        Q = [130, {height}]
        """
    )


def driven_roll(side: str, name: str = "along") -> str:
    """A wheel driven along a turning bar."""
    return (
        ROCKER.partition("[links.3]")[0]
        + f"""
        [links.4]
        CP = 10
        [[roll]]
        wheel = "4"
        centre = "C"
        radius = 15
        on = "1"
        through = "A"
        toward = "B"
        side = "{side}"
        name = "{name}"
        [[driver]]
        slide = "{name}"
        at = 70
        velocity = 0.3
        acceleration = -0.5
        [[pose]]
        vector = "CP"
        from = "AB"
        angle = 20
        """
    )


def circle_roll(radius: float, track: float, internal: bool, on: str, at: tuple[float, float]) -> str:
    """The crank moves the centre of a wheel on a circle about D, which stands still or turns."""
    turning = '[[driver]]\nlink = "5"\nomega = 2.5\nalpha = 1\n[links.5]\npoints = ["D"]' if on == "5" else ""
    return (
        CRANK
        + f"""
        [links.2]
        BC = 60
        [links.4]
        CP = 9
        {turning}
        [[roll]]
        wheel = "4"
        centre = "C"
        radius = {radius}
        on = "{on}"
        on_centre = "D"
        on_radius = {track}
        internal = {str(internal).lower()}
        [[pose]]
        vector = "CP"
        angle = 10
        [sketch]
        C = [{at[0]}, {at[1]}]
        """
    )


def gears(first: tuple[str, float], second: tuple[str, float], internal: bool, more: str = "") -> str:
    """A gear pair of two links about A and B on the carrier."""
    return f"""
        [[gear]]
        links = ["{first[0]}", "{second[0]}"]
        centres = ["A", "B"]
        radii = [{first[1]}, {second[1]}]
        internal = {str(internal).lower()}
        {more}
        """


def cam(first: str, second: str, more: str = "", links: str = '["1", "3"]') -> str:
    return f"""
        [[cam]]
        links = {links}
        profiles = [{first}, {second}]
        {more}
        """


LIFTER = """
[links.3]
points = ["C", "F"]
CF = 30
[[slide]]
block = "3"
point = "C"
guide = "frame"
through = [15, 0]
angle = 90
tilt = -90
[sketch]
C = [15, 55]
F = [45, 55]
"""
"""A follower that goes up and down; CF lies across its way."""

MOVING_GUIDE = (
    ROCKER.replace("[40, 70]", "[40, 70]\nL = [30, 60]")
    + """
[links.2]
BK = 30
[links.5]
points = ["L"]
[[driver]]
vector = "DE"
angle = 140
omega = 1
[[driver]]
vector = "BK"
from = "BA"
angle = 150
omega = -2
[[slide]]
block = "5"
point = "L"
guide = "3"
through = "D"
toward = "E"
"""
)
"""A block on a rocker that is driven itself, with a second driven link carried by the crank."""

FILES = {
    "rail_left": wheel_and_rail("left"),
    "rail_right": wheel_and_rail("right"),
    "rail_sloping": wheel_and_rail("left", 8),
    "rail_backwards": wheel_and_rail("right", 180).replace("[30, 40]", "[30, 0]"),
    "rack_left": rack_on_wheel("left"),
    "rack_right": rack_on_wheel("right"),
    "driven_roll_left": driven_roll("left"),
    "driven_roll_right": driven_roll("right"),
    "roll_outside": circle_roll(12, 30, False, "frame", (70, 50)),
    "roll_inside": circle_roll(20, 60, True, "frame", (75, 50)),
    "ring_around": circle_roll(60, 25, True, "frame", (75, 45)),
    "roll_on_turning_circle": circle_roll(12, 30, False, "5", (70, 50)),
    "roll_in_turning_ring": circle_roll(20, 60, True, "5", (75, 50)),
    "ring_around_turning": circle_roll(60, 25, True, "5", (75, 45)),
    "sun_fixed": CARRIER + POSE + gears(("frame", 30), ("2", 20), False),
    "ring_fixed": CARRIER + POSE + gears(("frame", 70), ("2", 20), True),
    "planet_is_the_ring": CARRIER + POSE + gears(("frame", 20), ("2", 70), True),
    "sun_free": CARRIER
    + POSE
    + gears(
        ("S", 30),
        ("2", 20),
        False,
        """
        [links.S]
        points = ["A"]
        [[driver]]
        link = "S"
        omega = 4
        alpha = 1.5""",
    ),
    "carrier_is_a_wheel": CARRIER + POSE + gears(("H", 30), ("2", 20), False),
    "gears_without_carrier": CRANK
    + """
        [links.2]
        shape = { K = [0, 0], C = [0, 0], P = [8, 0] }
        [links.4]
        DM = 10
        [links.5]
        BK = 50
        [links.7]
        CD = 40
        [[gear]]
        links = ["1", "2"]
        centres = ["B", "C"]
        radii = [30, 20]
        [[gear]]
        links = ["2", "4"]
        centres = ["C", "D"]
        radii = [20, 20]
        [[pose]]
        vector = "DM"
        angle = 5
        [[pose]]
        vector = "CP"
        angle = 70
        [sketch]
        C = [60, 35]
        K = [60, 35]
        """,
    "cam_circles_outside": ROCKER + cam('{ centre = "B", radius = 25 }', '{ centre = "E", radius = 30 }'),
    "cam_circle_inside": ROCKER
    + cam('{ centre = "B", radius = 70 }', '{ centre = "E", radius = 10 }', "internal = true"),
    "cam_ring_second": ROCKER
    + cam('{ centre = "B", radius = 10 }', '{ centre = "E", radius = 70 }', "internal = true"),
    "cam_knife_edge": ROCKER + cam('{ centre = "B", radius = 60 }', '{ centre = "E", radius = 0 }'),
    "cam_flat_left": ROCKER.replace("[40, 70]", "[20, 40]")
    + cam('{ centre = "B", radius = 15 }', '{ through = "D", toward = "E", side = "left" }'),
    "cam_flat_right": ROCKER.replace("[40, 70]", "[20, 5]")
    + cam('{ centre = "B", radius = 15 }', '{ through = "D", toward = "E", side = "right" }'),
    "cam_flat_first": ROCKER.replace("[40, 70]", "[80, 90]")
    + cam('{ through = "A", toward = "B", side = "right" }', '{ centre = "E", radius = 9 }'),
    "cam_edge_on_line": ROCKER.replace("[40, 70]", "[20, 30]")
    + cam('{ centre = "B", radius = 0 }', '{ through = "D", from = "DE", angle = 5 }'),
    "lifter_roller": CRANK + LIFTER + cam('{ centre = "B", radius = 30 }', '{ centre = "C", radius = 10 }'),
    "lifter_knife_edge": CRANK + LIFTER + cam('{ centre = "B", radius = 40 }', '{ centre = "C", radius = 0 }'),
    "lifter_flat": CRANK
    + LIFTER
    + cam('{ centre = "B", radius = 30 }', '{ through = "C", toward = "F", side = "right" }'),
    "lifter_sloping": CRANK
    + LIFTER
    + cam('{ centre = "B", radius = 30 }', '{ through = "C", from = "CF", angle = 25, side = "right" }'),
    "lifter_ring": CRANK
    + LIFTER
    + cam('{ centre = "B", radius = 10 }', '{ centre = "C", radius = 55 }', "internal = true"),
    "cam_on_moving_guide": MOVING_GUIDE
    + cam('{ centre = "K", radius = 20 }', '{ centre = "L", radius = 15 }', links='["2", "5"]'),
}
each_file = pytest.mark.parametrize("name", FILES)


def made(name: str) -> Mechanism:
    return loads(FILES[name], name=name, file=f"{name}.toml")


def in_time(mechanism: Mechanism, t: np.ndarray) -> list[np.ndarray]:
    """Driver values while rates and accelerations hold."""
    start = motion(mechanism).values
    pairs = zip(start, mechanism.drivers, strict=True)
    return [value + driver.rate * t + driver.acceleration * t**2 / 2 for value, driver in pairs]


@each_file
def test_drawn_near_the_sketch_and_counted_right(name: str) -> None:
    mechanism = made(name)
    found, counted = motion(mechanism), mobility(mechanism)
    assert definite(mechanism)
    assert (counted.free, counted.redundant, counted.repeated) == ((), (), 0)
    assert all(abs(found.position[point] - place) < 0.02 for point, place in mechanism.sketch.items())
    assert found.condition > 0.05


@each_file
@pytest.mark.parametrize("seconds", [0.0, 0.05])
def test_rates_are_derivatives_and_the_links_touch(name: str, seconds: float) -> None:
    mechanism, h = made(name), 1e-5
    around = motion(mechanism, in_time(mechanism, seconds + h * np.arange(-2, 3)))
    here = motion(at_speed(mechanism, seconds), in_time(mechanism, np.array(seconds)))
    for places, first, second in (
        (around.position, here.velocity, here.acceleration),
        (around.theta, here.omega, here.alpha),
        (around.s, here.s_rate, here.s_acceleration),
    ):
        for key, x in places.items():
            x = x - x[2]
            slope, bend = np.array([1, -8, 0, 8, -1]) @ x / (12 * h), np.array([-1, 16, -30, 16, -1]) @ x
            assert first[key] == pytest.approx(slope, rel=1e-6, abs=1e-7)
            assert second[key] == pytest.approx(bend / (12 * h * h), rel=1e-3, abs=1e-2)
    for gap, slip in touching(here):
        assert gap == pytest.approx(0, abs=1e-12)
        assert slip == pytest.approx(0, abs=1e-12)


def at_speed(mechanism: Mechanism, seconds: float) -> Mechanism:
    """With the drivers as fast as they are after a time."""
    drivers = (replace(driver, rate=driver.rate + driver.acceleration * seconds) for driver in mechanism.drivers)
    return replace(mechanism, drivers=tuple(drivers))


@each_file
def test_results_have_the_names_of_the_file(name: str) -> None:
    mechanism, found = made(name), motion(made(name))
    rolls = {roll.name for roll in mechanism.of(RollingContact) if roll.line is not None}
    assert set(found.omega) == set(mechanism.links)
    assert set(found.s) == {slide.name for slide in mechanism.slides} | rolls
    for link in mechanism.links:
        for point in mechanism.links[link].points:
            assert found.velocity_at(point, link) == pytest.approx(found.velocity[point], abs=1e-12)
            assert found.acceleration_at(point, link) == pytest.approx(found.acceleration[point], abs=1e-10)


@each_file
def test_an_exact_sketch_is_taken_at_once(name: str) -> None:
    """And gives what a rough one gives."""
    mechanism, rough = made(name), motion(made(name))
    exact = {point: complex(rough.position[point]) for point in mechanism.sketch}
    found = motion(replace(mechanism, sketch=exact))
    assert all(found.position[p] == pytest.approx(rough.position[p], abs=1e-12) for p in rough.position)
    assert found.alpha == pytest.approx(rough.alpha, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("name", ["lifter_roller", "lifter_knife_edge", "lifter_flat", "lifter_ring", "sun_fixed"])
def test_a_whole_turn_comes_back(name: str) -> None:
    mechanism = made(name)
    turn = motion(mechanism, [mechanism.drivers[0].value + np.linspace(0, 2 * pi, 361)])
    for point in (p for p in mechanism.points if p != "P"):
        assert turn.position[point][0] == pytest.approx(turn.position[point][-1], abs=1e-12)
    for gap, slip in touching(turn):
        assert np.max(abs(gap)) < 1e-12
        assert np.max(abs(slip)) < 1e-9


def test_a_planet_round_a_fixed_sun() -> None:
    """Turns 1 + 30/20 times as fast as its carrier; in a fixed ring of 70: 1 - 70/20."""
    angles = radians(40) + np.linspace(0, 40, 9)
    for name, ratio in (("sun_fixed", 1 + 30 / 20), ("ring_fixed", 1 - 70 / 20), ("planet_is_the_ring", 1 - 20 / 70)):
        found = motion(made(name), [angles])
        assert found.omega["2"] == pytest.approx(ratio * 3)
        assert found.alpha["2"] == pytest.approx(ratio * 2)
        assert found.theta["2"] - found.theta["2"][0] == pytest.approx(ratio * (angles - angles[0]))


def test_a_wheel_rolls_its_rim_off() -> None:
    """Ahead by r for each radian: clockwise on the left of the line, counter-clockwise on the right."""
    for name, sign in (("driven_roll_left", -1), ("driven_roll_right", 1)):
        mechanism = made(name)
        found = motion(mechanism, [mechanism.drivers[0].value, 0.070 + np.array([0, 1.0]) * 0.015 * 2 * pi])
        assert np.diff(found.theta["4"]) == pytest.approx(sign * 2 * pi)
        assert found.s["along"][0] == pytest.approx(0.070)
        assert found.s_rate["along"] == pytest.approx(0.3)
        assert found.s_acceleration["along"] == pytest.approx(-0.5)


@pytest.mark.parametrize("x", [111, -86])
def test_a_rack_of_one_point_may_be_passed_either_way(x: float) -> None:
    """It is a block, so the sketch alone says where it is."""
    text = (
        CRANK
        + f"""
        [links.2]
        BC = 100
        [links.4]
        points = ["D"]
        [links.5]
        points = ["C"]
        [[slide]]
        block = "5"
        point = "C"
        guide = "frame"
        through = [0, -2]
        angle = 0
        [[roll]]
        wheel = "4"
        centre = "D"
        radius = 12
        on = "5"
        through = "C"
        name = "rack"
        [sketch]
        C = [{x}, -2]
        """
    )
    found = motion(loads(text))
    assert found.position["C"].real == pytest.approx(x / 1e3, abs=1e-3)
    assert found.s["rack"] == pytest.approx(0.090 - found.position["C"].real)
    assert found.omega["4"] == pytest.approx(found.velocity["C"].real / 0.012)
    assert definite(loads(text))


def test_the_frame_rolls_too() -> None:
    """A bar rolling on a fixed disc: the wheel of the pair is the frame."""
    text = """
        [frame]
        name = "0"
        A = [0, 0]
        [links.1]
        PQ = 100
        [[roll]]
        wheel = "frame"
        centre = "A"
        radius = 40
        on = "1"
        through = "P"
        toward = "Q"
        side = "right"
        name = "touch"
        [[driver]]
        vector = "PQ"
        angle = 30
        omega = 2
        [[pose]]
        slide = "touch"
        at = 60
        """
    found = motion(loads(text))
    normal, along = 1j * cmath.rect(1, radians(30)), cmath.rect(1, radians(30))
    assert found.position["P"] == pytest.approx(0.04 * normal - 0.06 * along)
    for gap, slip in touching(found):
        assert (gap, slip) == pytest.approx((0, 0), abs=1e-12)
    assert definite(loads(text))


def test_planets_that_repeat_each_other() -> None:
    """Three planets between a sun and a fixed ring."""
    carrier = "[links.H]\nshape = { A = [0, 0], B = [50, 0], C = [-25, 43.30127], E = [-25, -43.30127] }\n"
    wheels = '[links.S]\npoints = ["A"]\n' + "".join(f'[links.{p}]\npoints = ["{p}"]\n' for p in "BCE")
    mesh = "".join(
        f'[[gear]]\nlinks = ["{link}", "{p}"]\ncentres = ["A", "{p}"]\nradii = [{r}, 20]\ninternal = {inside}\n'
        for p in "BCE"
        for link, r, inside in (("S", 30, "false"), ("frame", 70, "true"))
    )
    driver = '[[driver]]\nvector = "AB"\nangle = 10\nomega = 3\nalpha = 1\n'
    mechanism = loads('[frame]\nname = "0"\nA = [0, 0]\n' + carrier + wheels + mesh + driver)
    counted, found = mobility(mechanism), motion(mechanism, [np.linspace(0, 7, 30)])
    assert definite(mechanism)
    assert counted.repeated == 2
    assert found.omega["S"] == pytest.approx(10)
    assert found.alpha["S"] == pytest.approx(10 / 3)
    assert all(found.omega[p] == pytest.approx(-7.5) for p in "BCE")


def test_a_wheel_that_nothing_turns() -> None:
    """A roller on a pin of its own: idle; its follower moves as if it did not turn."""
    text = FILES["lifter_roller"].replace('links = ["1", "3"]', 'links = ["1", "9"]')
    roller = text.replace("[sketch]", '[links.9]\npoints = ["C"]\n[sketch]')
    found, plain = motion(loads(roller)), motion(made("lifter_roller"))
    assert found.idle == mobility(loads(roller)).idle == ("9",)
    assert definite(loads(roller))
    assert found.velocity["C"] == pytest.approx(plain.velocity["C"])


def test_a_wheel_driven_by_its_spin_starts_at_zero() -> None:
    mechanism = made("sun_free")
    assert motion(mechanism).values == (pytest.approx(radians(40)), 0.0)
    found = motion(mechanism, [radians(40), np.array([0.0, 1.0, -20.0])])
    assert np.degrees(found.theta["2"]) == pytest.approx(100 - np.degrees([0, 1.5, -30]))
    posed = FILES["sun_free"].replace('points = ["A"]', "AT = 6") + '[[pose]]\nvector = "AT"\nangle = 25'
    assert motion(loads(posed)).values[1] == pytest.approx(radians(25))


def test_a_mark_without_a_pose() -> None:
    """Solved all the same, at 0; but it is said that nothing places it."""
    mechanism = loads(FILES["sun_fixed"].replace(POSE, ""))
    assert mobility(mechanism).unplaced == ("2",)
    assert motion(mechanism).theta["2"] == pytest.approx(0, abs=1e-12)
    sketched = replace(mechanism, sketch={"P": 0.0383 + 0.050j})
    assert motion(sketched).theta["2"] == pytest.approx(pi / 2, abs=0.01)


def test_gears_of_a_high_ratio() -> None:
    """Neither slow nor lost: the last wheel turns 400 times as fast as the first."""
    text = """
        [frame]
        name = "0"
        A = [0, 0]
        B = [105, 0]
        [links.1]
        points = ["A"]
        [links.2]
        shape = { B = [0, 0], C = [0, 0], P = [5, 0] }
        [links.3]
        AD = 1
        [[gear]]
        links = ["1", "2"]
        centres = ["A", "B"]
        radii = [100, 5]
        [[gear]]
        links = ["2", "3"]
        centres = ["C", "A"]
        radii = [100, 5]
        [[pose]]
        vector = "AD"
        angle = 0
        [[pose]]
        vector = "BP"
        angle = 0
        [[driver]]
        link = "1"
        omega = 1
        """
    found = motion(loads(text), [np.linspace(0, 2 * pi, 100)])
    assert found.omega["3"] == pytest.approx(400)
    assert found.theta["3"][-1] == pytest.approx(800 * pi)


def test_a_track_too_small_for_its_wheel() -> None:
    """The rod does not reach the circle of the centres."""
    with pytest.raises(NoAssembly) as caught:
        motion(loads(circle_roll(1, 2, False, "frame", (70, 50))))
    reach = abs(complex(90, 10) - cmath.rect(20, radians(50)))
    assert caught.value.gap_mm == pytest.approx(reach - 60 - 3, rel=1e-3)


def test_a_sketch_tells_on_which_side_a_follower_leans() -> None:
    mechanism = made("cam_circles_outside")
    high = motion(mechanism)
    low = motion(replace(mechanism, sketch={"E": 0.03 - 0.04j}))
    assert low.position["E"].imag < 0 < high.position["E"].imag


def test_the_way_ends_where_contact_would_be_lost() -> None:
    """A follower too short to let the cam past: the positions beyond are nan."""
    short = FILES["cam_circles_outside"].replace("DE = 80", "DE = 40").replace("[90, 10]", "[105, 0]")
    angles = np.linspace(0, 2 * pi, 73)
    found = motion(loads(short.replace("[40, 70]", "[65, 15]")), [angles])
    beyond = abs(0.020 * np.exp(1j * angles) - 0.105) > 0.055 + 0.040
    assert np.isnan(found.position["E"][beyond]).all()
    assert np.isfinite(found.position["E"][:10]).all()
    assert 0 < beyond.sum() < 73
