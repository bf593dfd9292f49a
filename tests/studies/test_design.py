"""Designs, analysed back from their lengths by roads that know nothing of the construction."""

import cmath
import math
import os
from itertools import pairwise

import numpy as np
import pytest
from designs import DESIGNS, rad

import graphkin
from graphkin import files as loading
from graphkin.errors import (
    CouplerChanges,
    NotOnBisector,
    OneCondition,
    SameWanted,
    WantedRange,
    WrongNumber,
)
from graphkin.outputs.study_json import as_json
from graphkin.say import design as words
from graphkin.say.numbers import SentenceNumber
from graphkin.studies.design import angle_pairs, coupler_positions, guide_bar, hinges, rocker, slider
from graphkin.studies.linkages import FourBar, SliderCrank, report

RANDOM = np.random.default_rng(23)
COUNT = 60 if "GRAPHKIN_RANDOM" in os.environ else 12
WELL_POSED = rad(2)
"""Nearer to a change point, lengths do not tell angles to nine figures: an arc cosine near 1."""


# --- closed forms of our own --------------------------------------------------------------------------


def four_back(a, b, c, d):
    """Swing, theta and gamma_min of a crank-rocker: three triangles by the law of cosines, a sweep for gamma."""

    def corner(p, q, opposite):
        return math.acos((p * p + q * q - opposite * opposite) / (2 * p * q))

    swing = corner(c, d, b + a) - corner(c, d, b - a)
    theta = corner(b - a, d, c) - corner(b + a, d, c)
    phi = np.linspace(0, math.tau, 7201)
    square = a * a + d * d - 2 * a * d * np.cos(phi)
    gamma = np.arccos(np.abs((b * b + c * c - square) / (2 * b * c))).min()
    return swing, abs(theta), gamma


def slider_back(a, b, e):
    """Stroke, theta and gamma_min of a slider-crank."""
    stroke = math.sqrt((b + a) ** 2 - e * e) - math.sqrt((b - a) ** 2 - e * e)
    theta = math.asin(abs(e) / (b - a)) - math.asin(abs(e) / (b + a))
    phi = np.linspace(0, math.tau, 7201)
    return stroke, theta, math.pi / 2 - np.abs(np.arcsin((a * np.sin(phi) - e) / b)).max()


def ratio(theta):
    return (math.pi + theta) / (math.pi - theta)


def within(family):
    """A place of the family, away from the ends of its arcs, where linkages are change points."""
    arcs = sum(arc.name == "admissible" for arc in family.arcs)
    count = len(family.angle) // arcs
    return int(RANDOM.integers(arcs)) * count + int(RANDOM.integers(60, count - 60))


def rockers(count):
    while count:
        length, swing, k = 10 ** RANDOM.uniform(-3, 1), rad(RANDOM.uniform(5, 150)), RANDOM.uniform(1.02, 2.8)
        if rocker(length, swing, k).best.gamma_min > rad(10):
            count -= 1
            yield length, swing, k


def as_wanted(one, length, swing, k):
    assert one.valid
    assert one.c == length
    if one.gamma_min < WELL_POSED:
        return
    found = four_back(one.a, one.b, one.c, one.d)
    assert found[0] == pytest.approx(swing, abs=1e-9)
    assert ratio(found[1]) == pytest.approx(k, abs=1e-9)
    assert one.gamma_min == pytest.approx(found[2], abs=1e-9)
    told = report(FourBar(one.a, one.b, one.c, one.d, places=tuple(one.places[p] for p in "ABCD")))
    assert told.kind == "crank-rocker"
    assert told.swing == pytest.approx(swing, abs=1e-9)
    assert told.k == pytest.approx(k, abs=1e-9)
    slow = told.slow
    first = told.limits[slow[0]].places[2]
    ways = one.limits[0]["C"], one.limits[1]["C"]
    assert (abs(first - ways[0]) < abs(first - ways[1])) == (one.pace > 0)


# --- crank-rockers ------------------------------------------------------------------------------------


def test_example_2_3():
    found = rocker(0.080, rad(40), 1.3, frame=0.071)
    assert len(found.solutions) == 1
    one = found.best
    board = one.board()
    assert math.degrees(board.numbers["theta"]) == pytest.approx(23.4783, abs=5e-5)
    assert board.numbers["AC1"] * 1e3 == pytest.approx(69.1865, abs=5e-5)
    assert board.numbers["AC2"] * 1e3 == pytest.approx(110.7329, abs=5e-5)
    assert (one.a * 1e3, one.b * 1e3) == (pytest.approx(20.7732, abs=5e-5), pytest.approx(89.9597, abs=5e-5))
    assert board.at("A").imag > 0, "the crank's centre is above the rocker's"
    as_wanted(one, 0.080, rad(40), 1.3)


@pytest.mark.parametrize("name", ["frame", "crank", "coupler", "ac1", "gamma_min", ""])
def test_random_rockers_are_found_and_analysed_back(name):
    seen = 0
    for length, swing, k in rockers(COUNT):
        free = rocker(length, swing, k)
        as_wanted(free.best, length, swing, k)
        for family in free.families:
            if not len(family.angle):
                continue
            at = within(family)
            size = {
                "frame": family.d, "crank": family.a, "coupler": family.b, "gamma_min": family.gamma_min,
                "ac1": abs(family.at - free.best.limits[0]["C"]),
            }  # fmt: skip
            wanted = {name: float(size[name][at])} if name else {}
            if name == "gamma_min" and wanted[name] > family.best[1] * 0.99:
                continue
            found = rocker(length, swing, k, **wanted)
            for one in found.solutions:
                as_wanted(one, length, swing, k)
            if name:
                here = [float(v[at]) for v in (family.a, family.b, family.d)]
                tolerance = 1e-6 * length
                close = [one for one in found.solutions if math.dist((one.a, one.b, one.d), here) < tolerance]
                assert close, f"{name}: the member of the family the wish was taken from is not found"
                seen += 1
    assert seen > COUNT or not name


def test_family_is_all_there_is():
    """A crank-rocker taken at random is found again from its own c, psi, K and d."""
    found = 0
    while found < (100 if "GRAPHKIN_RANDOM" in os.environ else 40):
        a, b, c, d = np.sort(RANDOM.uniform(0.01, 0.1, 4))[[0, *(1 + RANDOM.permutation(3))]]
        if a + max(b, c, d) >= (a + b + c + d) / 2 * 0.995:
            continue
        swing, theta, _ = four_back(a, b, c, d)
        if not 1.005 < ratio(theta) < 2.9:
            continue
        found += 1
        for wish in ({"frame": d}, {"crank": a}, {"coupler": b}):
            solutions = rocker(c, swing, ratio(theta), **wish).solutions
            assert any(math.dist((s.a, s.b, s.d), (a, b, d)) < 1e-6 for s in solutions), (wish, a, b, c, d)


def test_best_of_the_family_is_best():
    for length, swing, k in rockers(25):
        free = rocker(length, swing, k)
        greatest = max(family.gamma_min.max() for family in free.families if len(family.angle))
        assert free.best.gamma_min >= greatest
        assert free.best.gamma_min == pytest.approx(max(f.best[1] for f in free.families if len(f.angle)), abs=1e-9)
        for family in free.families:
            if len(family.angle):
                turn = family.best[0] + np.linspace(-1e-4, 1e-4, 2001)
                at = family.centre + family.radius * np.exp(1j * turn)
                c1, c2 = free.best.limits[0]["C"], free.best.limits[1]["C"]
                near, far = abs(at - c1), abs(at - c2)
                a, b, d = abs(far - near) / 2, (far + near) / 2, abs(at)
                inner = np.abs((b * b + length**2 - (d - a) ** 2) / (2 * b * length))
                outer = np.abs((b * b + length**2 - (d + a) ** 2) / (2 * b * length))
                assert np.arccos(np.maximum(inner, outer)).max() <= family.best[1] + 1e-9


def test_arcs_cover_the_circle_and_tell_what_does_not_serve():
    """Points of FG and of the minor arc, analysed: the lengths do not give back swing and K."""
    for length, swing, k in rockers(40):
        for family in rocker(length, swing, k).families:
            assert sum(arc.end - arc.start for arc in family.arcs) == pytest.approx(math.tau, abs=1e-6)
            c1, c2 = (length * cmath.exp(1j * (math.pi / 2 + sign * swing / 2)) for sign in (1, -1))
            for arc in family.arcs:
                at = family.centre + cmath.rect(family.radius, arc.start + 0.37 * (arc.end - arc.start))
                a, b, d = abs(abs(at - c1) - abs(at - c2)) / 2, (abs(at - c1) + abs(at - c2)) / 2, abs(at)
                back = four_back(a, b, length, d) if _is_crank_rocker(a, b, length, d) else (0.0, 0.0)
                same = abs(back[0] - swing) < 1e-9 and abs(ratio(back[1]) - k) < 1e-9
                assert same == (arc.name == "admissible"), (arc, back)


def _is_crank_rocker(a, b, c, d):
    return a == min(a, b, c, d) and a + max(b, c, d) < (a + b + c + d) / 2


def test_a_wish_out_of_range_is_told_within_what_bounds():
    for length, swing, k in rockers(30):
        found = rocker(length, swing, k, frame=40 * length / (k - 1))
        assert not found.solutions
        assert found.why
        limits = [family.best[1] for family in found.families if len(family.angle)]
        for reason, best in zip(found.why, limits, strict=True):
            low, high = dict(reason.data)["low"], dict(reason.data)["high"]
            for part in (0.02, 0.5, 0.98) if best > WELL_POSED else ():
                assert rocker(length, swing, k, frame=low + part * (high - low)).solutions
            if low > 1e-3 * length:
                others = [dict(other.data) for other in found.why if other is not reason]
                below = low * (1 - 1e-6)
                inside = any(other["low"] < below < other["high"] for other in others)
                assert inside or not rocker(length, swing, k, frame=below).solutions
        assert "mm" in words.error(found).message("zh")


@pytest.mark.parametrize(
    ("wish", "error"),
    [
        ({"k": 1.0}, WantedRange), ({"k": 3.0}, WantedRange), ({"k": 0.7}, WantedRange), ({"k": math.nan}, WantedRange),
        ({"swing": 0.0}, WantedRange), ({"swing": math.pi}, WantedRange), ({"length": -1.0}, WantedRange),
        ({"frame": 0.0}, WantedRange), ({"gamma_min": math.pi / 2}, WantedRange), ({"length": math.inf}, WantedRange),
        ({"frame": 0.07, "crank": 0.02}, OneCondition),
    ],
)  # fmt: skip
def test_wishes_without_sense_are_refused(wish, error):
    with pytest.raises(error) as caught:
        rocker(**{"length": 0.08, "swing": rad(40), "k": 1.3, **wish})
    for lang in ("en", "zh"):
        assert "{" not in caught.value.message(lang)
        assert caught.value.message(lang)


# --- slider-cranks and guide bars -----------------------------------------------------------------------


@pytest.mark.parametrize("name", ["offset", "crank", "rod", "gamma_min", ""])
def test_random_sliders_are_found_and_analysed_back(name):
    for _ in range(60 if "GRAPHKIN_RANDOM" in os.environ else 25):
        stroke, k = 10 ** RANDOM.uniform(-3, 1), RANDOM.uniform(1.02, 2.2)
        family = slider(stroke, k).families[0]
        if family.best[1] < rad(10):
            continue
        at = within(family)
        size = {"offset": family.e, "crank": family.a, "rod": family.b, "gamma_min": family.gamma_min}
        wanted = {name: float(size[name][at])} if name else {}
        if name == "offset" and RANDOM.random() < 0.5:
            wanted[name] *= -1
        if name == "gamma_min" and wanted[name] > family.best[1] * 0.99:
            continue
        found = slider(stroke, k, **wanted)
        assert found.solutions
        for one in found.solutions:
            if one.gamma_min < WELL_POSED:
                continue
            back = slider_back(one.a, one.b, one.e)
            assert back[0] == pytest.approx(stroke, rel=1e-9)
            assert ratio(back[1]) == pytest.approx(k, abs=1e-9)
            assert one.gamma_min == pytest.approx(back[2], abs=1e-9)
            told = report(SliderCrank(one.a, one.b, one.e, places=tuple(one.places[p] for p in "ABC"), way=one.turn))
            assert told.kind == "slider-crank"
            assert told.stroke == pytest.approx(stroke, rel=1e-9)
            assert told.k == pytest.approx(k, abs=1e-9)
        if name:
            here = abs(np.array([one.a for one in found.solutions]) - family.a[at]).min()
            assert here < 1e-6 * stroke
        else:
            assert found.best.gamma_min >= family.gamma_min.max()


def test_a_slider_has_no_solution_past_p():
    """e may be at most H cot theta, where A is straight under C2."""
    stroke, k = 0.04, 1.2
    most = stroke / math.tan(math.pi * (k - 1) / (k + 1))
    assert slider(stroke, k, offset=most * (1 - 1e-4)).solutions
    beyond = slider(stroke, k, offset=most * (1 + 1e-6))
    assert not beyond.solutions
    assert [reason.key for one in beyond.rejected for reason in one.why] == ["FG"]
    assert dict(beyond.why[0].data)["high"] == pytest.approx(most, rel=1e-9)


def test_guide_bars():
    for k in (1.01, 1.5, 2.5, 3.0, 7.0):
        for wish in ({"frame": 0.1}, {"crank": 0.03}):
            one = guide_bar(k, **wish).best
            theta = 2 * math.asin(one.a / one.d)
            assert ratio(theta) == pytest.approx(k, abs=1e-9)
            assert one.swing == pytest.approx(theta, abs=1e-9)
            assert wish in ({"frame": pytest.approx(one.d)}, {"crank": pytest.approx(one.a)})
    with pytest.raises(OneCondition):
        guide_bar(1.5)
    with pytest.raises(WantedRange):
        guide_bar(1.0, frame=0.1)
    for k in (720.0, 1e16):
        with pytest.raises(WantedRange):
            guide_bar(k, crank=0.1)
    assert guide_bar(718.0, frame=0.1).best.k == pytest.approx(718.0)


def test_a_crank_leaves_no_choice_of_the_rocker_s_direction():
    pairs = [(rad(phi), rad(psi)) for phi, psi in ((40, 70), (70, 85), (110, 110))]
    with pytest.raises(OneCondition, match="Given: crank, psi0"):
        angle_pairs(pairs, 0.1, crank=0.04, psi0=0.2)


def test_the_ends_of_a_range_are_outside_it():
    with pytest.raises(WantedRange, match="above 1 and below 3"):
        rocker(0.08, rad(40), 1.0)


# --- positions of the coupler ---------------------------------------------------------------------------


def turned(bar, phi, side):
    """B and C of a four-bar on the origin with its frame along +x; NaN where it does not close."""
    a, b, c, d = bar
    foot = a * np.exp(1j * phi)
    way = d - foot
    along = (abs(way) ** 2 + b * b - c * c) / (2 * abs(way))
    with np.errstate(invalid="ignore"):
        return foot, foot + (along + 1j * side * np.sqrt(b * b - along * along)) * way / abs(way)


def bars(count):
    for _ in range(count):
        yield tuple(RANDOM.uniform(0.02, 0.1, 4))


def test_three_positions_give_back_the_linkage_they_were_taken_from():
    found = 0
    for bar in bars(400):
        phi = RANDOM.uniform(0, math.tau, 3)
        b, c = turned(bar, phi, RANDOM.choice([-1, 1], 3))
        spread = min(abs(b[i] - b[k]) for i, k in ((0, 1), (0, 2), (1, 2)))
        if np.isnan(c).any() or spread < 0.01 or min(abs(c[0] - c[1]), abs(c[1] - c[2]), abs(c[0] - c[2])) < 0.01:
            continue
        found += 1
        move = cmath.rect(1, RANDOM.uniform(0, 6)), complex(*RANDOM.uniform(-1, 1, 2))
        points = [(complex(p * move[0] + move[1]), complex(q * move[0] + move[1])) for p, q in zip(b, c)]
        one = coupler_positions(points).solutions[0]
        assert (one.a, one.b, one.c, one.d) == pytest.approx(bar, rel=1e-9)
        assert abs(one.places["A"] - move[1]) < 1e-9
        _against_a_sweep(one, bar, phi, c)
    assert found > 60


def _against_a_sweep(one, bar, phi, c):
    """Whether the crank can go from each position to the next on one assembly: small steps, no gap on the way."""
    a, d = bar[0], bar[3]
    feet = a * np.exp(1j * phi)
    sides = np.sign(np.imag(np.conj(d - feet) * (c - feet))).tolist()
    fine = np.linspace(0, math.tau, 14401)

    def open_way(start, end):
        """Turning from start to end, the way ccw or the way cw, without losing the assembly."""
        ways = []
        for sense in (1, -1):
            span = (sense * (end - start)) % math.tau
            turn = start + sense * fine[fine <= span]
            ways.append(not np.isnan(turned(bar, turn, 1)[1]).any())
        return any(ways)

    joined = all(open_way(p, q) for p, q in pairwise(phi))
    same = len(set(sides)) == 1
    keys = {reason.key for reason in one.why}
    assert ("branch" in keys) == (not same)
    if same:
        assert ("circuit" in keys) == (not joined)
        assert one.valid == (joined and "order" not in keys)
    else:
        assert not one.valid


def test_order_is_told():
    """A crank that rocks meets positions out of order where its angle goes there and back."""
    bar = (0.06, 0.05, 0.06, 0.1)
    b, c = turned(bar, np.radians([20.0, 45.0, 30.0]), np.ones(3))
    one = coupler_positions([(complex(p), complex(q)) for p, q in zip(b, c)]).solutions[0]
    assert [reason.key for reason in one.why] == ["order"]
    b, c = turned(bar, np.radians([20.0, 30.0, 45.0]), np.ones(3))
    assert coupler_positions([(complex(p), complex(q)) for p, q in zip(b, c)]).solutions[0].valid


def test_three_positions_in_line_have_no_centre():
    found = coupler_positions(hinges([0j, 0.01 + 0j, 0.02 + 0j], [0.2, 0.5, 0.9], 0.05))
    assert not found.solutions
    assert [reason.key for reason in found.why] == ["in line"]
    assert "infinity" in words.error(found).message("en")


def test_two_positions_leave_pivots_free():
    points = hinges([0.02j, 0.03 + 0.03j], [0.2, 0.9], 0.05)
    one = coupler_positions(points).best
    assert one.valid
    assert one.gamma_min > rad(15)
    for name, row in (("A", 0), ("D", 1)):
        pivot = one.places[name]
        assert abs(pivot - points[0][row]) == pytest.approx(abs(pivot - points[1][row]), rel=1e-12)
    given = coupler_positions(points, pivot_a=one.places["A"], pivot_d=one.places["D"]).best
    assert (given.a, given.c, given.d) == pytest.approx((one.a, one.c, one.d))
    with pytest.raises(NotOnBisector) as caught:
        coupler_positions(points, pivot_a=one.places["A"] + 0.001)
    error = caught.value
    nearest = complex(error.x_mm, error.y_mm) / 1e3
    assert coupler_positions(points, pivot_a=nearest).best.places["A"] == nearest


def test_positions_without_sense_are_refused():
    with pytest.raises(CouplerChanges):
        coupler_positions([(0j, 0.05 + 0j), (0.01j, 0.0501 + 0.01j)])
    with pytest.raises(WrongNumber):
        coupler_positions([(0j, 0.05 + 0j)])
    with pytest.raises(SameWanted):
        coupler_positions([(0j, 0.05 + 0j), (0j, 0.05j)])


# --- pairs of angles --------------------------------------------------------------------------------------


@pytest.mark.parametrize("inverted", [False, True])
def test_pairs_give_back_the_linkage_they_were_taken_from(inverted):
    found = 0
    for bar in bars(300):
        phi = RANDOM.uniform(0, math.tau, 3)
        b, c = turned(bar, phi, RANDOM.choice([-1, 1]))
        if np.isnan(c).any() or min(abs(b[0] - b[1]), abs(b[1] - b[2]), abs(b[0] - b[2])) < 0.01:
            continue
        psi = np.angle(c - bar[3])
        if np.linalg.cond(np.stack([np.cos(psi), -np.cos(phi), np.ones(3)])) > 300:
            continue
        found += 1
        pairs = [(float(p), float(q)) for p, q in zip(phi, psi)]
        if inverted:
            some = RANDOM.uniform(0, 6)
            pairs = [(p, q + some) for p, q in pairs]
        one = angle_pairs(pairs, bar[3], crank=bar[0] if inverted else None).solutions[0]
        assert (one.a, one.b, one.c, one.d) == pytest.approx(bar, rel=1e-9)
        board = one.board()
        for k in range(3):
            assert abs(board.at(f"C{k + 1}") - c[k]) < 1e-9
    assert found > 60


def test_a_negative_length_is_no_solution_that_does():
    found = angle_pairs([(rad(p), rad(q)) for p, q in ((40, 70), (65, 85), (100, 110))], 0.1)
    assert not found.best.valid
    assert {reason.key for reason in found.best.why} == {"turned"}


def test_pairs_that_determine_nothing():
    assert not angle_pairs([(0.1, 0.1), (0.5, 0.5), (1.0, 1.0)], 0.1).solutions
    with pytest.raises(WrongNumber):
        angle_pairs([(0.1, 0.2)], 0.1)
    with pytest.raises(SameWanted):
        angle_pairs([(0.1, 0.2), (0.1, 0.3), (1.0, 0.9)], 0.1)


def test_positions_of_any_kind_are_judged_told_and_written():
    """Random positions and pairs, most of them with a defect: an answer in words, and a file that loads."""
    for _ in range(40 if "GRAPHKIN_RANDOM" in os.environ else 20):
        count = int(RANDOM.integers(2, 4))
        places = [complex(*RANDOM.uniform(-0.1, 0.1, 2)) for _ in range(count)]
        found = [coupler_positions(hinges(places, RANDOM.uniform(0, 6, count).tolist(), RANDOM.uniform(0.01, 0.2)))]
        pairs = [(float(p), float(q)) for p, q in RANDOM.uniform(0, 6, (3, 2))]
        found += [angle_pairs(pairs, 0.1), angle_pairs(pairs, 0.1, crank=RANDOM.uniform(0.01, 0.2))]
        for one in found:
            assert one.solutions or one.why
            assert len(words.lines(one, "zh")) == len(words.lines(one, "en"))
            for solution in one.solutions:
                assert solution.valid == (not solution.why)
                lengths = (solution.a, solution.b, solution.c, solution.d)
                at = solution.places
                drawn = [abs(at[q] - at[p]) for p, q in ("AB", "BC", "CD", "AD")]
                assert drawn == pytest.approx(lengths, rel=1e-9), "places are those of the linkage"
                loading.loads(words.mechanism_of(solution, one.kind).text)


# --- told, written ----------------------------------------------------------------------------------------



@pytest.mark.parametrize("name", DESIGNS)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_every_design_is_told(name, lang):
    found = DESIGNS[name]
    text = words.lines(found, lang)
    assert text[1].startswith("(1) ")
    assert not any("{" in line or "nan" in line for line in text)
    for one in found.solutions:
        assert any(f"{SentenceNumber(one.a):mm}" in line for line in text)


def test_the_sentences_of_example_2_3():
    one = DESIGNS["rocker"].best
    text = words.sentences(one.construction, one.board(), "zh")
    for number, part in enumerate(("23.478°", "40°", "66.522°", "△C1C2P", "71 mm", "20.773 mm")):
        assert part in text[number]


@pytest.mark.many
@pytest.mark.parametrize("name", DESIGNS)
def test_every_solution_is_a_mechanism_that_is_analysed_back(name):
    found = DESIGNS[name]
    for one in found.solutions:
        machine = loading.loads(words.mechanism_of(one, found.kind).text)
        assert machine.headline("zh") != machine.headline("en")
        graphkin.plan(machine)
        start = float(graphkin.motion(machine).values[0])
        if one.swing is None and one.stroke is None:
            continue
        if found.kind in ("coupler", "angles"):
            continue
        motion = graphkin.motion(machine, [np.degrees(start + np.linspace(0, math.tau, 2881))])
        if one.stroke is not None:
            s = next(iter(motion.s.values()))
            assert s.max() - s.min() == pytest.approx(one.stroke, rel=1e-5)
        else:
            theta = motion.theta["3"]
            assert theta.max() - theta.min() == pytest.approx(one.swing, rel=1e-5)
        at = _polished(machine, start, motion.theta["3"] if one.stroke is None else s)
        assert at[1] - at[0] == pytest.approx(one.swing if one.stroke is None else one.stroke, abs=1e-9)
        span = (at[3] - at[2]) % math.tau
        assert max(span, math.tau - span) / min(span, math.tau - span) == pytest.approx(one.k, abs=1e-9)


def _polished(machine, start, values):
    """Least and greatest output over a turn, and the driver there: where the output's rate is 0, halved out."""
    turn = start + np.linspace(0, math.tau, 2881)
    ends = []
    for k in (int(values[:-1].argmin()), int(values[:-1].argmax())):
        low, high = turn[k] - math.tau / 2880, turn[k] + math.tau / 2880
        for _ in range(6):
            grid = np.linspace(low, high, 33)
            rate, _ = _outputs(machine, grid)
            at = int(np.flatnonzero(np.diff(np.sign(rate)))[0])
            low, high = grid[at], grid[at + 1]
        low = low + (high - low) * rate[at] / (rate[at] - rate[at + 1])
        ends.append((float(_outputs(machine, np.array([low]))[1][0]), low))
    return ends[0][0], ends[1][0], ends[0][1], ends[1][1]


def _outputs(machine, values):
    """The output's rate and value: of a slider on the frame, else of link 3."""
    found = graphkin.motion(machine, [np.degrees(values)])
    if found.s and machine.slides[0].guide == "frame":
        return next(iter(found.s_rate.values())), next(iter(found.s.values()))
    return found.omega["3"], found.theta["3"]


@pytest.mark.parametrize("name", DESIGNS)
def test_as_data(name):
    import json

    data = json.loads(json.dumps(as_json(DESIGNS[name]), allow_nan=False))
    assert data["format"] == 1
    assert [one["a"] for one in data["solutions"]] == [one.a for one in DESIGNS[name].solutions]
    assert set("abcde") <= set(data["solutions"][0])
    lines = data["bisectors"]
    assert (lines is not None) == (name == "two positions")
    for pivot, line in (lines or {}).items():
        off = complex(*data["solutions"][0]["points"][pivot]) - complex(*line["through"])
        assert abs((off * cmath.exp(-1j * line["direction"])).imag) < 1e-12
