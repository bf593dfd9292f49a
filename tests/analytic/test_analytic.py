"""The analytic road, against numbers of the textbook, against derivatives, and at awkward places.

Source of the numbers: Sun Huan, Theory of Machines, chapter 3.
"""

import cmath
import dataclasses
from collections.abc import Callable
from math import pi, radians, sqrt

import numpy as np
import pytest
from roads import definite

from graphkin.analytic import NoAssembly, NotJoined, SingularPosition, mobility, motion
from graphkin.analytic.newton import eliminate, inverse
from graphkin.analytic.rules import RULES
from graphkin.model.mechanism import FRAME, Driver, Link, Mechanism, Pose
from graphkin.model.pairs import PAIRS, Line, Slide


def build(links: dict[str, dict[str, complex]], sketch: dict[str, complex], *rest: object) -> Mechanism:
    """Points and sketch in mm; the rest are slides, drivers and poses, in SI units."""
    made = {name: Link(name, {p: z / 1e3 for p, z in points.items()}) for name, points in links.items()}
    return Mechanism(
        name="test",
        frame="0",
        links=made,
        pairs=tuple(x for x in rest if isinstance(x, Slide)),
        drivers=tuple(x for x in rest if isinstance(x, Driver)),
        poses=tuple(x for x in rest if isinstance(x, Pose)),
        sketch={point: z / 1e3 for point, z in sketch.items()},
    )


def slide(name: str, guide: str, origin: str, deg: float, point: str, block: str | None) -> Slide:
    return Slide(name, True, Line(guide, origin, cmath.rect(1, radians(deg))), point, block, 0.0)


def crank(link: str, vector: str, deg: float | None, rate: float = 10.0, accel: float = 0.0) -> Driver:
    value = None if deg is None else radians(deg)
    return Driver("angle", link, (vector[0], vector[1]), value=value, rate=rate, acceleration=accel)


def piston(name: str, mm: float | None, rate: float, accel: float = 0.0) -> Driver:
    return Driver("slide", name, value=None if mm is None else mm / 1e3, rate=rate, acceleration=accel)


def four_bar(a: float = 30, b: float = 70, c: float = 60, d: float = 80, deg: float = 60) -> Mechanism:
    """Example 3-5 with chosen lengths."""
    links = {FRAME: {"A": 0, "D": d}, "1": {"A": 0, "B": a}, "2": {"B": 0, "C": b, "E": 35 + 20j}}
    return build({**links, "3": {"D": 0, "C": c}}, {"C": d + 1j * c}, crank("1", "AB", deg))


def slider_crank(deg: float = 60, accel: float = 0.0) -> Mechanism:
    """Exercise 3-23."""
    links = {FRAME: {"A": 0, "s0": 30j}, "1": {"A": 0, "B": 100}, "2": {"B": 0, "C": 300}, "3": {"C": 0}}
    rail = slide("ram", FRAME, "s0", 0, "C", "3")
    return build(links, {"C": 300 + 30j}, rail, crank("1", "AB", deg, 10, accel))


def sliding_bar() -> Mechanism:
    """Example 3-1: a block on a line of link 3 beside its pivot."""
    links = {FRAME: {"A": 0, "D": 78}, "1": {"A": 0, "B": 24}, "2": {"B": 0}, "3": {"D": 0, "C": 48}}
    return build(links, {"C": 65 + 46j}, slide("s0", "3", "C", 100, "B", "2"), crank("1", "AB", 60))


def guide_bar() -> Mechanism:
    links = {FRAME: {"A": 0, "C": -70j}, "1": {"A": 0, "B": 28}, "2": {"B": 0}, "3": {"C": 0, "Q": 110}}
    return build(links, {"Q": 28 + 35j}, slide("s0", "3", "C", 0, "B", "2"), crank("1", "AB", 35, 10, 5))


def oscillating_block() -> Mechanism:
    """Exercise 3-5: the rod slides through a block that turns about C."""
    rod = {"B": 0, "D": 50, "E": 50 - 40j}
    links = {FRAME: {"A": 0, "C": -100}, "1": {"A": 0, "B": 30}, "2": rod, "3": {"C": 0}}
    block = slide("s0", "2", "B", 0, "C", "3")
    return build(links, {"D": -28 + 13j}, block, crank("1", "AB", 45, -10))


def pin_in_slot() -> Mechanism:
    links = {FRAME: {"O": 0, "B": 150 - 40j}, "1": {"O": 0, "A": 80}, "2": {"B": 0, "Q": 200}}
    return build(links, {"Q": 20 + 110j}, slide("s0", "2", "B", 0, "A", None), crank("1", "OA", 75, 4, 6))


def trammel() -> Mechanism:
    links = {FRAME: {"s0": 0}, "1": {"A": 0, "B": 400, "M": 150}}
    pins = slide("across", FRAME, "s0", 0, "A", None), slide("up", FRAME, "s0", 90, "B", None)
    return build(links, {"A": 200, "B": 346j, "M": 125 + 130j}, *pins, piston("across", 200, -0.5))


def five_bar() -> Mechanism:
    ends = {FRAME: {"A": 0, "E": 100}, "1": {"A": 0, "B": 40}, "4": {"E": 0, "D": 40}}
    links = {**ends, "2": {"B": 0, "C": 70}, "3": {"C": 0, "D": 70}}
    drivers = crank("1", "AB", 100, 3, 2), crank("4", "ED", 70, -5, 1)
    return build(links, {"C": 55 + 95j}, *drivers)


def cylinder(mm: float | None = None, *more: object) -> Mechanism:
    """A lever swung by a cylinder whose barrel and rod have one point each."""
    links = {FRAME: {"A": 0, "D": 100}, "1": {"A": 0}, "2": {"B": 0}, "3": {"D": 0, "B": 80, "E": 120}}
    return build(links, {"B": 80 + 75j}, slide("jack", "1", "A", 0, "B", "2"), piston("jack", mm, 0.05), *more)


def relative() -> Mechanism:
    """Example 3-4: a motor on link 1 turns link 2 against link 1."""
    ends = {FRAME: {"A": 0, "D": 45 + 10j}, "1": {"A": 0, "B": 60}, "3": {"D": 0, "C": 50}}
    motor = Driver("angle", "2", ("B", "C"), "1", ("B", "A"), radians(70), 2.0, 1.0)
    return build({**ends, "2": {"B": 0, "C": 18}}, {"B": 10 + 59j, "C": 22 + 45j}, motor)


def sieve() -> Mechanism:
    """Example 3-2: Class III, so no order of dyads solves it."""
    y = sqrt(34**2 - ((34**2 + 60**2 - 91**2) / 120) ** 2)
    plate = {"D": 0, "E": 60, "C": complex((34**2 + 60**2 - 91**2) / 120, y)}
    legs = {"1": {"A": 0, "B": 25}, "2": {"B": 0, "C": 75}, "5": {"E": 0, "F": 82}, "4": {"G": 0, "D": 71}}
    links = {FRAME: {"A": 0, "G": 80 - 30j, "F": 170 - 40j}, **legs, "3": plate}
    sketch = {"C": 60 + 55j, "D": 90 + 40j, "E": 150 + 40j}
    return build(links, sketch, crank("1", "AB", 110))


def multiple_hinge() -> Mechanism:
    """Exercise 3-3b: three links at C, three at D."""
    links = {FRAME: {"A": 0}, "1": {"A": 0, "B": 30}, "2": {"B": 0, "C": 80}, "3": {"C": 0}}
    more = {"4": {"B": 0, "D": 75}, "5": {"D": 0}, "6": {"C": 0, "E": 80}, "7": {"D": 0, "E": 75}}
    rails = slide("x", FRAME, "A", 0, "C", "3"), slide("y", FRAME, "A", 90, "D", "5")
    return build({**links, **more}, {"C": 100, "D": 90j, "E": 70 + 70j}, *rails, crank("1", "AB", 40))


def arm() -> Mechanism:
    """An open chain: no loop at all."""
    links = {FRAME: {"A": 0}, "1": {"A": 0, "B": 100}, "2": {"B": 0, "C": 60}}
    elbow = Driver("angle", "2", ("B", "C"), "1", ("A", "B"), radians(40), -3.0, 2.0)
    return build(links, {}, crank("1", "AB", 30, 2, 1), elbow)


MECHANISMS = {
    made.__name__: made
    for made in (
        four_bar,
        slider_crank,
        sliding_bar,
        guide_bar,
        oscillating_block,
        pin_in_slot,
        trammel,
        five_bar,
        relative,
        sieve,
        multiple_hinge,
        arm,
    )
}
MECHANISMS["cylinder"] = lambda: cylinder(110)
each_mechanism = pytest.mark.parametrize("made", MECHANISMS.values(), ids=MECHANISMS.keys())


def degrees(angle: object) -> float:
    return float(np.degrees(angle) % 360)  # type: ignore[call-overload]


def test_every_solved_kind_of_pair_has_a_rule() -> None:
    assert set(PAIRS) <= set(RULES)


def test_example_3_1() -> None:
    found = motion(sliding_bar())
    assert degrees(found.theta["3"]) == pytest.approx(105.610, abs=5e-4)
    assert degrees(found.theta["2"]) == pytest.approx(205.610, abs=5e-4)
    assert found.s["s0"] == pytest.approx(0.058867, abs=5e-7)
    assert found.omega["3"] == pytest.approx(-3.9193, abs=5e-5)
    assert found.omega["2"] == found.omega["3"]
    assert found.alpha["3"] == pytest.approx(62.224, abs=5e-4)
    assert abs(found.velocity_at("B", "3")) == pytest.approx(0.27120, abs=5e-6)
    relative = found.velocity_at("B", "3") - found.velocity["B"]
    assert abs(relative) == pytest.approx(0.32083, abs=5e-6)
    assert abs(2 * found.omega["3"] * relative) == pytest.approx(2.5149, abs=5e-5)


def test_example_3_5() -> None:
    found = motion(four_bar())
    assert [degrees(found.theta[k]) for k in "23"] == pytest.approx([28.967, 93.590], abs=5e-4)
    assert [found.omega[k] for k in "23"] == pytest.approx([-2.6243, 2.8529], abs=5e-5)
    assert [found.alpha[k] for k in "23"] == pytest.approx([35.059, 52.451], abs=5e-4)
    assert found.velocity["E"] == pytest.approx(-0.16940 + 0.09506j, abs=1e-5)
    assert found.acceleration["E"] == pytest.approx(-2.85190 - 2.10136j, abs=1e-5)


@pytest.mark.parametrize(
    ("deg", "theta", "omega", "alpha", "velocity", "acceleration"),
    [
        (60, 349.1245, -1.69715, 28.8421, -0.96209, -4.21604),
        (120, 349.1245, 1.69715, 28.8421, -0.76996, 5.78396),
        (220, 18.3163, 2.68976, -20.1748, 0.38920, 7.50202),
    ],
)
@pytest.mark.parametrize("swept", [False, True])
def test_exercise_3_23(
    deg: float, theta: float, omega: float, alpha: float, velocity: float, acceleration: float, swept: bool
) -> None:
    """Drawn there, or reached by moving on from 60 deg."""
    found = motion(slider_crank(), [radians(deg)]) if swept else motion(slider_crank(deg))
    assert degrees(found.theta["2"]) == pytest.approx(theta, abs=5e-5)
    assert found.omega["2"] == pytest.approx(omega, abs=1e-5)
    assert found.alpha["2"] == pytest.approx(alpha, abs=5e-5)
    assert found.velocity["C"] == pytest.approx(velocity, abs=5e-6)
    assert found.s_rate["ram"] == pytest.approx(velocity, abs=5e-6)
    assert found.s_acceleration["ram"] == pytest.approx(acceleration, abs=5e-6)


def test_class_three() -> None:
    found = motion(sieve())
    assert found.omega["3"] == pytest.approx(-2.53871, abs=5e-6)
    assert found.alpha["3"] == pytest.approx(-4.22917, abs=5e-6)
    assert [abs(found.acceleration[p]) for p in "CDE"] == pytest.approx([2.07648, 2.09855, 2.41455], abs=5e-6)


def test_pin_in_slot_and_trammel() -> None:
    bar, ladder = motion(pin_in_slot()), motion(trammel())
    assert (bar.omega["2"], bar.alpha["2"]) == pytest.approx((0.838212, 5.04557), abs=5e-6)
    assert (ladder.omega["1"], ladder.alpha["1"]) == pytest.approx((-1.44338, 1.20281), abs=5e-6)
    assert abs(ladder.acceleration["M"]) == pytest.approx(0.36084, abs=5e-6)


def in_time(mechanism: Mechanism, t: np.ndarray) -> list[np.ndarray]:
    """Driver values while rates and accelerations hold."""
    start = motion(mechanism).values
    return [
        value + driver.rate * t + driver.acceleration * t**2 / 2
        for value, driver in zip(start, mechanism.drivers, strict=True)
    ]


@each_mechanism
def test_velocity_and_acceleration_are_derivatives(made: Callable[[], Mechanism]) -> None:
    mechanism, h = made(), 1e-5
    here, around = motion(mechanism), motion(mechanism, in_time(mechanism, h * np.arange(-2, 3)))
    for name in ("position", "theta", "s"):
        first, second = {
            "position": (here.velocity, here.acceleration),
            "theta": (here.omega, here.alpha),
            "s": (here.s_rate, here.s_acceleration),
        }[name]
        for key, x in getattr(around, name).items():
            x = x - x[2]
            slope, bend = np.array([1, -8, 0, 8, -1]) @ x / (12 * h), np.array([-1, 16, -30, 16, -1]) @ x
            assert first[key] == pytest.approx(slope, rel=1e-6, abs=1e-8)
            assert second[key] == pytest.approx(bend / (12 * h * h), rel=1e-4, abs=1e-3)


@each_mechanism
def test_loops_close_and_links_keep_their_shape(made: Callable[[], Mechanism]) -> None:
    mechanism = made()
    found = motion(mechanism, in_time(mechanism, np.linspace(-0.02, 0.02, 9)))
    for link in mechanism.links.values():
        base = next(iter(link.points), None)
        for point, place in link.points.items():
            arm = (place - link.points[base]) * np.exp(1j * found.theta[link.name])
            assert found.position[point] - found.position[base] == pytest.approx(arm, abs=1e-12)
            assert found.velocity_at(point, link.name) == pytest.approx(found.velocity[point], abs=1e-9)
            assert found.acceleration_at(point, link.name) == pytest.approx(found.acceleration[point], abs=1e-7)


@each_mechanism
def test_faster_drivers(made: Callable[[], Mechanism]) -> None:
    """k times the rate and k^2 times the acceleration of the drivers: v times k, a times k^2."""
    mechanism, k = made(), 3.0
    quick = [
        dataclasses.replace(driver, rate=k * driver.rate, acceleration=k * k * driver.acceleration)
        for driver in mechanism.drivers
    ]
    slow, fast = motion(mechanism), motion(dataclasses.replace(mechanism, drivers=tuple(quick)))
    for point in mechanism.points:
        assert fast.velocity[point] == pytest.approx(k * slow.velocity[point], abs=1e-12)
        assert fast.acceleration[point] == pytest.approx(k * k * slow.acceleration[point], abs=1e-9)


@each_mechanism
def test_drivers_are_counted_right(made: Callable[[], Mechanism]) -> None:
    mechanism = made()
    counted = mobility(mechanism)
    assert definite(mechanism)
    assert (counted.free, counted.redundant, counted.repeated) == ((), (), 0)
    assert motion(mechanism).condition > 0.02


@each_mechanism
def test_rough_sketch_picks_the_same_assembly(made: Callable[[], Mechanism]) -> None:
    mechanism, rng = made(), np.random.default_rng(3)
    exact = motion(mechanism).position
    for _ in range(5):
        shift = {p: 0.01 * complex(*rng.uniform(-1, 1, 2)) for p in mechanism.sketch}
        rough = dataclasses.replace(mechanism, sketch={p: exact[p] + shift[p] for p in shift})
        found = motion(rough).position
        assert all(found[p] == pytest.approx(exact[p], abs=1e-9) for p in exact)


def test_sketch_chooses_the_assembly() -> None:
    mechanism = four_bar()
    low = dataclasses.replace(mechanism, sketch={"C": 0.04 - 0.04j})
    assert motion(low).position["C"].imag < 0 < motion(mechanism).position["C"].imag


def test_without_a_sketch_the_bar_points_to_its_block() -> None:
    assert motion(dataclasses.replace(guide_bar(), sketch={})).s["s0"] > 0


def test_cylinder_is_as_long_as_drawn() -> None:
    found = motion(cylinder(110))
    assert found.s["jack"] == pytest.approx(0.110)
    assert found.position["B"] == pytest.approx(0.110 * cmath.exp(1j * found.theta["1"]))


def test_pose_gives_the_drawn_position_and_the_drivers_value() -> None:
    pose = Pose("angle", "3", radians(120), ("D", "B"))
    found = motion(cylinder(None, pose))
    assert degrees(found.theta["3"]) == pytest.approx(120)
    assert found.values[0] == found.s["jack"] == pytest.approx(abs(0.1 + cmath.rect(0.08, radians(120))))
    assert found.s_rate["jack"] == pytest.approx(0.05)
    assert definite(cylinder(None, pose))
    assert mobility(cylinder()).unplaced == ("1", "2", "3")


def test_shapes() -> None:
    one, row = motion(four_bar(), [1.0]), motion(four_bar(), [np.ones(3)])
    grid = motion(five_bar(), [np.linspace(1.5, 2, 4)[:, None], np.linspace(1, 1.4, 3)])
    assert np.ndim(one.theta["2"]) == np.ndim(one.position["C"]) == np.ndim(one.condition) == 0
    assert row.velocity["C"].shape == row.theta[FRAME].shape == (3,)
    assert grid.alpha["2"].shape == grid.velocity_at("C", "1").shape == (4, 3)
    assert row.position["C"] == pytest.approx(one.position["C"], abs=1e-15)
    with pytest.raises(ValueError, match="1 drivers, 2 values"):
        motion(four_bar(), [1.0, 2.0])


def test_a_grid_of_two_drivers_agrees_with_single_positions() -> None:
    first, second = np.linspace(1.5, 2, 3), np.linspace(1, 1.4, 2)
    grid = motion(five_bar(), [first[:, None], second])
    for i, j in np.ndindex(3, 2):
        single = motion(five_bar(), [first[i], second[j]])
        assert grid.position["C"][i, j] == pytest.approx(single.position["C"], abs=1e-12)
        assert grid.acceleration["C"][i, j] == pytest.approx(single.acceleration["C"], abs=1e-9)


def test_a_whole_turn_comes_back() -> None:
    found = motion(four_bar(), [radians(60) + np.linspace(-2 * pi, 2 * pi, 1441)])
    assert np.isfinite(found.position["C"]).all()
    assert np.ptp(found.position["C"][[0, 720, 1440]]) == pytest.approx(0, abs=1e-12)
    assert np.max(abs(np.diff(found.position["C"]))) < 5e-4


def test_beyond_a_dead_point_is_not_reached() -> None:
    """A rocker drives: it turns no further than where crank and coupler are in line."""
    rocker = dataclasses.replace(four_bar(), drivers=(crank("3", "DC", 93.59),))
    limit = np.arccos((80**2 + 60**2 - 100**2) / (2 * 80 * 60))
    angles = pi - limit + np.array([0.3, 1e-3, 1e-5, -1e-6, -0.01, -1.0, np.nan])
    folded = motion(rocker, [angles[::-1]]).position["B"][::-1]
    assert np.isfinite(folded[:3]).all()
    assert np.isnan(folded[3:]).all()
    stuck = motion(rocker, [3.0])
    assert np.isnan(stuck.velocity["B"])


def test_parallelogram_passes_its_change_points() -> None:
    found = motion(four_bar(30, 70, 30, 70), [np.radians([0.0, 60, 170, 180, 181, 300, 359, 361, 420])])
    held = np.exp(1j * found.theta["2"])
    assert held == pytest.approx(1, abs=1e-9)
    assert found.omega["3"] == pytest.approx(10, rel=1e-9)


def test_drawn_at_a_dead_point() -> None:
    flat = four_bar(30, 70, 30, 70, deg=0)
    with pytest.raises(SingularPosition) as caught:
        motion(flat)
    assert caught.value.condition < 1e-7
    assert "dead point" in caught.value.message("en")
    assert "死点" in caught.value.message("zh")
    with pytest.raises(SingularPosition):  # which way it goes from there is anyone's guess
        motion(flat, [[0.1, 0.2]])
    with pytest.raises(SingularPosition):
        motion(four_bar(30, 70, 30, 70), [pi])
    assert definite(flat)


def test_piston_drawn_at_the_end_of_its_stroke() -> None:
    mechanism = slider_crank()
    end = piston("ram", 1e3 * sqrt(0.4**2 - 0.03**2), 0.1)
    mechanism = dataclasses.replace(mechanism, drivers=(end,), sketch={"C": 0.4 + 0.03j})
    with pytest.raises(SingularPosition):
        motion(mechanism)
    assert definite(mechanism)


def test_lengths_that_do_not_close() -> None:
    short = four_bar(30, 20, 35, 80)
    with pytest.raises(NoAssembly) as caught:
        motion(short)
    gap = abs(80 - 30 * cmath.exp(1j * pi / 3)) - 20 - 35
    assert caught.value.gap_mm == pytest.approx(gap, rel=1e-3)
    counted = mobility(short)
    assert counted.gap_mm == pytest.approx(gap, rel=1e-3)
    assert (counted.freedoms, definite(short)) == (1, False)
    apart = mobility(four_bar(10, 20, 25, 80))
    assert apart.freedoms is None
    assert apart.gap_mm == pytest.approx(25, rel=1e-3)


def test_a_kite_that_does_not_close_is_not_judged_folded() -> None:
    """With C in A crank and coupler turn while the rocker rests, which no other position does."""
    links = {FRAME: {"A": 0, "D": 80}, "1": {"A": 0, "B": 30}, "2": {"B": 0, "C": 30}, "3": {"D": 0, "C": 80}}
    counted = mobility(build(links, {"B": -30 + 1j}, crank("3", "DC", 30)))
    assert (counted.freedoms, counted.redundant) == (1, ())
    assert counted.gap_mm == pytest.approx(abs(80 + 80 * cmath.exp(1j * pi / 6)) - 60, rel=1e-3)


def third_crank() -> Mechanism:
    """A parallelogram with a third crank that repeats what the two ask."""
    cranks = {"1": {"A": 0, "B": 30}, "3": {"D": 0, "C": 30}, "4": {"F": 0, "E": 30}}
    links = {FRAME: {"A": 0, "D": 70, "F": 35 + 10j}, **cranks, "2": {"B": 0, "C": 70, "E": 35 + 10j}}
    return build(links, {"C": 80 + 30j}, crank("1", "AB", 60, 10, 7))


def test_a_repeated_constraint_that_is_met() -> None:
    counted, found = mobility(third_crank()), motion(third_crank(), [np.linspace(0.5, 2.5, 50)])
    assert definite(third_crank())
    assert counted.repeated == 1
    assert found.omega["4"] == pytest.approx(10)
    assert found.alpha["4"] == pytest.approx(7)
    assert found.omega["2"] == pytest.approx(0, abs=1e-9)


def test_too_few_drivers() -> None:
    lone = dataclasses.replace(five_bar(), drivers=five_bar().drivers[:1])
    counted = mobility(lone)
    assert (counted.freedoms, counted.redundant) == (2, ())
    assert counted.free == ("4", "2", "3")
    assert counted.unplaced == counted.free


@pytest.mark.parametrize("deg", [93.5901, 130.0])
def test_too_many_drivers(deg: float) -> None:
    """Whether the second one agrees with the first, or not."""
    second = crank("3", "DC", deg, 2.0)
    counted = mobility(dataclasses.replace(four_bar(), drivers=(*four_bar().drivers, second)))
    assert counted.freedoms == 1
    assert counted.redundant == (1,)


def test_the_same_driver_twice() -> None:
    twice = dataclasses.replace(four_bar(), drivers=(crank("1", "AB", 60), crank("1", "BA", 50)))
    assert mobility(twice).redundant == (1,)
    assert mobility(twice).gap_mm is not None


def test_a_driver_of_a_link_that_cannot_move() -> None:
    truss = {FRAME: {"A": 0, "B": 50}, "1": {"A": 0, "C": 40}, "2": {"B": 0, "C": 45}}
    counted = mobility(build(truss, {"C": 20 + 35j}, crank("1", "AC", 60)))
    assert (counted.freedoms, counted.redundant) == (0, (0,))
    still = motion(build(truss, {"C": 20 + 35j}))
    assert still.velocity["C"] == 0


def test_a_loose_end_and_an_idle_roller() -> None:
    base = four_bar()
    roller, tail = Link("5", {"C": 0j}), Link("6", {"C": 0j, "T": 0.02 + 0j})
    idle = dataclasses.replace(base, links={**base.links, "5": roller})
    counted = mobility(idle)
    assert definite(idle)
    assert counted.idle == motion(idle).idle == ("5",)
    assert motion(idle).omega["5"] == 0
    loose = mobility(dataclasses.replace(base, links={**base.links, "6": tail}))
    assert (loose.freedoms, loose.free) == (2, ("6",))


def test_a_wheel_driven_by_its_spin() -> None:
    base = four_bar()
    spin = Driver("spin", "5", rate=4.0, acceleration=-1.0)
    links, drivers = {**base.links, "5": Link("5", {"D": 0j})}, (*base.drivers, spin)
    turned = dataclasses.replace(base, links=links, drivers=drivers)
    assert definite(turned)
    found = motion(turned)
    assert (found.omega["5"], found.alpha["5"], found.idle) == (4.0, -1.0, ())


def test_two_parallel_slides_repeat_each_other() -> None:
    carriage = {FRAME: {"s0": 0, "s1": 50j}, "1": {"A": 0, "B": 30 + 50j}}
    rails = slide("low", FRAME, "s0", 0, "A", "1"), slide("high", FRAME, "s1", 0, "B", "1")
    rails = tuple(dataclasses.replace(rail, tilt=cmath.phase(30 + 50j)) for rail in rails)
    links = {FRAME: carriage[FRAME], "1": {"A": 0, "B": abs(30 + 50j)}}
    made = build(links, {"A": 10}, *rails, piston("low", 10, 0.2))
    assert mobility(made).repeated == 2
    assert definite(made)
    assert motion(made).s["high"] == pytest.approx(0.040)
    assert motion(made).velocity["B"] == pytest.approx(0.2)


def test_a_link_nothing_joins() -> None:
    base = four_bar()
    with pytest.raises(NotJoined) as caught:
        motion(dataclasses.replace(base, links={**base.links, "9": Link("9", {"X": 0j, "Y": 1 + 0j})}))
    assert caught.value.link == "9"


@pytest.mark.parametrize("shape", [(4, 2), (2, 2)])
def test_condition_of_matrices(shape: tuple[int, int]) -> None:
    """1 for perpendicular columns, 0 for equal ones; for as many equations as unknowns, and for more."""
    matrix = np.zeros((2, *shape))
    matrix[0, :2] = [[0.6, -0.8], [0.8, 0.6]]
    matrix[1, :2] = 1.0
    assert inverse(matrix)[1] == pytest.approx([1, 0])
    assert inverse(matrix[:1])[1] == pytest.approx([1])
    assert inverse(matrix[1:, :1])[1] == 0


def test_elimination_solves_relations() -> None:
    rng = np.random.default_rng(4)
    weights = rng.integers(-2, 3, (3, 6)).astype(float)
    weights = np.vstack([weights, weights[0] - weights[2]])
    solved = eliminate(weights)
    y, c = rng.normal(size=(5, len(solved.free))), weights @ rng.normal(size=6)
    q = solved.unknowns(y, np.broadcast_to(c, (5, 4)))
    assert q @ weights.T == pytest.approx(np.broadcast_to(c, (5, 4)))
    assert q[:, solved.free] == pytest.approx(y)
    assert solved.mismatch(c) == pytest.approx(0, abs=1e-12)
    assert solved.mismatch(c + np.array([0, 0, 0, 0.1])) > 0.04


def test_scale_does_not_matter() -> None:
    """A watch and a crane: the same angles, lengths times the scale."""
    base, k = sliding_bar(), 1e-3
    links = {n: Link(n, {p: k * z for p, z in link.points.items()}) for n, link in base.links.items()}
    small = dataclasses.replace(base, links=links, sketch={p: k * z for p, z in base.sketch.items()})
    assert motion(small).alpha["3"] == pytest.approx(motion(base).alpha["3"], rel=1e-9)
    assert motion(small).condition == pytest.approx(motion(base).condition, rel=1e-9)
    assert motion(small).s["s0"] == pytest.approx(k * motion(base).s["s0"], rel=1e-9)


def test_offset_of_the_crank_from_closed_form() -> None:
    """Slider-crank over a turn against s = r cos + sqrt(l^2 - (e - r sin)^2)."""
    angles = np.linspace(-4, 9, 200)
    found = motion(slider_crank(accel=3.0), [angles])
    across = 0.03 - 0.1 * np.sin(angles)
    assert found.s["ram"] == pytest.approx(0.1 * np.cos(angles) + np.sqrt(0.09 - across**2), abs=1e-13)
