"""A link about its pole: held against the analysis, against differences of paths, and against Bobillier's ruler."""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from random_mechanisms import DYADS, Build, cam, chain, coupler_angle, dyad, epicyclic, rolling, triad

from graphkin.analytic import Motion, motion
from graphkin.construction.drafting import replay
from graphkin.errors import GraphkinError, UnknownLink, UnknownPoint
from graphkin.errors.studies import FrameStands, NoBobillier
from graphkin.files import library, loads
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.say.catalogue import LANGUAGES
from graphkin.say.centre_about import about_words, bobillier_words
from graphkin.studies.centres import Centres, centres
from graphkin.studies.centres.about import About, Circle, InflectionLine, about
from graphkin.studies.centres.about_bobillier import bobillier, guided

MAKERS: dict[str, Callable[[int], Mechanism]] = {
    **{kind: lambda seed, kind=kind: dyad(kind, seed) for kind in DYADS},
    "chain": chain, "triad": triad, "epicyclic": epicyclic, "rolling": rolling, "cam": cam, "coupler": coupler_angle,
}  # fmt: skip


def found(mechanism: Mechanism) -> Centres:
    method = plan(mechanism)
    return centres(method, replay_all(method))


def each(kind: str, count: int = 8) -> list[tuple[Mechanism, Motion, About]]:
    """Every moving link of some random mechanisms that are far from dead points."""
    entries = []
    for seed in range(count):
        mechanism = MAKERS[kind](seed)
        try:
            seen = found(mechanism)
            exact = motion(mechanism)
        except GraphkinError:
            continue
        if min((float(np.min(sine)) for sine in seen.plot.sines.values()), default=1.0) > 0.2:
            entries += [(mechanism, exact, about(seen, link)) for link in mechanism.moving]
    assert len(entries) > 3
    return entries


def exact_at(exact: Motion, link: str, place: complex) -> tuple[complex, complex]:
    """Velocity and acceleration of the link's point at a place, by the analysis."""
    point = next(iter(exact.mechanism.links[link].points))
    arm = place - complex(exact.position[point])
    velocity = exact.velocity[point] + 1j * exact.omega[link] * arm
    turning = 1j * exact.alpha[link] - exact.omega[link] ** 2
    return complex(velocity), complex(exact.acceleration[point] + turning * arm)


def near(one: complex, other: complex, size: float, part: float = 1e-9) -> bool:
    """Places, however far off, by the angle under which they are seen from the mechanism."""
    if cmath.isinf(one) or cmath.isinf(other):
        return min(abs(1 / one) if one else math.inf, abs(1 / other) if other else math.inf) * size < 10 * part
    return abs(one - other) <= part * max(size, abs(one) ** 2 / size)


@pytest.mark.parametrize("kind", MAKERS)
def test_poles_and_circles_against_the_analysis(kind: str):
    for _, exact, seen in each(kind):
        fast = max(abs(float(value)) for value in exact.omega.values()) * seen.size
        if not cmath.isfinite(seen.pole):
            assert seen.diameter is None
            continue
        reach = 1 + abs(seen.pole) / seen.size
        assert abs(exact_at(exact, seen.link, seen.pole)[0]) < 1e-9 * fast * reach
        hard = fast**2 / seen.size + seen.size * max(abs(float(value)) for value in exact.alpha.values())
        other = seen.acceleration_pole
        if other is not None:
            assert abs(exact_at(exact, seen.link, other)[1]) < 1e-9 * hard * (1 + abs(other) / seen.size)
        if not isinstance(seen.inflection, Circle) or not seen.diameter:
            continue
        for k in range(1, 8):
            place = seen.pole + seen.diameter * (1 + cmath.rect(1, math.pi - 0.7 * k)) / 2
            velocity, acceleration = exact_at(exact, seen.link, place)
            bent = (velocity.conjugate() * acceleration).imag
            assert abs(bent) < 1e-8 * abs(velocity) * (abs(acceleration) + hard * reach)
        if other is not None:  # the acceleration pole lies on the inflection circle
            assert abs(other - seen.inflection.centre) == pytest.approx(seen.inflection.radius, rel=1e-7)
        assert seen.returning is not None
        assert seen.tangent is not None
        mirrored = seen.pole + seen.tangent**2 * (seen.inflection.centre - seen.pole).conjugate()
        assert abs(seen.returning.centre - mirrored) < 1e-9 * (seen.returning.radius + seen.size)


def savary(seen: About, place: complex) -> complex:
    """The centre of curvature of the path of a point by the inflection circle alone (Euler-Savary) [m].

    PA^2 = AK AJ, all on the ray from the pole P through the point A; J is where it meets the inflection circle.
    """
    assert seen.diameter is not None
    ray, away = place - seen.pole, abs(place - seen.pole)
    if away == 0:
        return place
    ray /= away
    on = (ray.conjugate() * seen.diameter).real
    if abs(on - away) <= 1e-12 * (away + abs(seen.diameter)):
        return complex("inf")
    return place + ray * away**2 / (on - away)


@pytest.mark.parametrize("kind", [kind for kind in MAKERS if kind != "cam"])  # links of cams turn about pivots
def test_centres_of_curvature_by_euler_savary(kind: str):
    tried = 0
    for mechanism, exact, seen in each(kind):
        for name, carried in seen.points.items():
            assert abs(carried.velocity - exact.velocity_at(name, seen.link)) < 1e-9 * (1 + abs(carried.velocity))
            if cmath.isnan(carried.centre) or not seen.diameter or not cmath.isfinite(seen.pole):
                continue
            if abs(carried.place - seen.pole) < 1e-3 * seen.size or abs(seen.pole) > 100 * seen.size:
                continue
            tried += 1
            assert near(carried.centre - carried.place, savary(seen, carried.place) - carried.place, seen.size), (
                mechanism.name, seen.link, name,
            )  # fmt: skip
    assert tried


@pytest.mark.parametrize("kind", ["RRR", "RRP", "RPR", "chain", "cam", "rolling"])
def test_curvature_and_pole_velocity_against_differences(kind: str):
    """Of the analysis alone, at five instants: the circle through the path, and how the pole goes on."""
    step, tried = 2e-5, 0
    times = step * np.arange(-2, 3)
    first, second = np.array([1, -8, 0, 8, -1]) / (12 * step), np.array([-1, 16, -30, 16, -1]) / (12 * step**2)
    for mechanism, exact, seen in each(kind, 5):
        drivers = [float(value) for value in exact.values]
        rates = [(d.rate, d.acceleration) for d in mechanism.drivers]
        values = [v + r * times + a * times**2 / 2 for v, (r, a) in zip(drivers, rates, strict=True)]
        moved = motion(mechanism, values)
        for name, carried in seen.points.items():
            places = np.broadcast_to(moved.position[name], 5)
            velocity, acceleration = complex(places @ first), complex(places @ second)
            if abs(velocity) < 0.02 or mechanism.owners[name][0] == FRAME:
                continue
            bend = (velocity.conjugate() * acceleration).imag / abs(velocity) ** 3
            own = 0.0 if cmath.isinf(carried.centre) else 1j * velocity / abs(velocity) / (carried.centre - carried.place)
            assert abs(own - bend) < 1e-4 * (1 / seen.size + abs(bend)), (mechanism.name, name)
            tried += 1
        if seen.pole_velocity is None or any(acceleration for _, acceleration in rates):
            continue
        point = next(iter(mechanism.links[seen.link].points))
        velocity = np.broadcast_to(moved.velocity_at(point, seen.link), 5)
        poles = moved.position[point] + 1j * velocity / np.broadcast_to(moved.omega[seen.link], 5)
        if np.all(np.abs(poles) < 20 * seen.size):
            wanted = abs(seen.pole_velocity) + 0.1
            assert abs(complex(np.broadcast_to(poles, 5) @ first) - seen.pole_velocity) < 1e-5 * wanted * 20
    assert tried > 5


def test_translation_has_a_line():
    """The crank upright: the coupler of s4-ex1 moves along for an instant."""
    seen = about(found(library.load("s4-ex1")), "2")
    assert cmath.isinf(seen.pole)
    assert isinstance(seen.inflection, InflectionLine)
    for k in (-2, 0.5, 3):
        carried = seen.carried(seen.inflection.through + 0.1 * k * seen.inflection.direction)
        assert cmath.isinf(carried.centre)
    assert abs(seen.carried(seen.acceleration_pole).acceleration) < 1e-12  # type: ignore[arg-type]
    assert any("瞬时平动" in line for line in about_words(seen, "zh"))


def test_pivots_guides_and_cusps():
    seen = found(library.load("fig3-4"))
    crank = about(seen, "2")
    assert crank.pole == 0
    assert crank.inflection == Circle(0j, 0.0)
    assert cmath.isnan(crank.points["A"].centre)
    assert abs(crank.points["B"].centre) < 1e-15
    coupler = about(seen, "3")
    assert coupler.carried(coupler.pole).radius == 0  # a cusp
    assert cmath.isinf(coupler.carried(coupler.pole + coupler.diameter).centre)  # type: ignore[operator]
    assert cmath.isinf(savary(coupler, coupler.pole + coupler.diameter))  # type: ignore[operator]
    assert cmath.isinf(about(found(library.load("p3-23a")), "2").points["C"].centre)


def test_what_cannot_be_asked():
    seen = found(library.load("fig3-4"))
    for error, words in ((FrameStands, ("1",)), (UnknownLink, ("9",)), (UnknownPoint, ("3", ["Z"]))):
        with pytest.raises(error) as raised:
            about(seen, *words)
        assert raised.value.message("en") != raised.value.message("zh")


STANDING = """
[frame]
name = "1"
A = [0, 0]
D = [100, 0]
[links.crank]
AB = 40
[links."guide'"]
BC = 80
[links.4]
DC = 70
[[driver]]
vector = "AB"
angle = 70
[sketch]
C = [90, 70]
"""


def test_no_speed_given():
    """Geometry does not hang on speeds: each driver is taken to move, and it is said."""
    seen, moving = about(found(loads(STANDING)), "guide'"), about(found(library.load("fig3-4")), "3")
    assert seen.assumed
    assert not moving.assumed
    assert abs(seen.pole - moving.pole) < 1e-12
    assert abs(seen.diameter - moving.diameter) < 1e-12  # type: ignore[operator]
    assert "1 rad/s" in about_words(seen, "en")[0]


@pytest.mark.parametrize("name", library.names())
def test_words_of_every_mechanism(name: str):
    seen = found(library.load(name))
    for link in seen.method.mechanism.moving:
        for lang in ("en", "zh"):
            told = about_words(about(seen, link), lang)
            assert told
            assert not any("nan" in line or "inf " in line or "{" in line for line in told)


# --- Bobillier --------------------------------------------------------------------------------


def four_bar(seed: int) -> Mechanism:
    return _closed(seed, slider=False)


def slider_crank(seed: int) -> Mechanism:
    return _closed(seed, slider=True)


def _closed(seed: int, slider: bool) -> Mechanism:
    rng = random.Random(f"bobillier{seed}{slider}")
    build = Build(rng, letters=["E", "P", "Q", "D", "C0", "B", "A"])
    build.body(FRAME)
    build.hinge(FRAME, "1")
    build.hinge("1", "2")
    build.hinge("2", "3")
    (build.slide if slider else build.hinge)("3", FRAME)
    build.drivers.append(Driver("angle", "1", rate=rng.uniform(1, 9), acceleration=rng.uniform(-9, 9)))
    return build.finish(f"bobillier-{seed}")


@pytest.mark.parametrize("make", [four_bar, slider_crank])
def test_bobillier_gives_the_exact_centre(make: Callable[[int], Mechanism]):
    tried = 0
    for seed in range(40):
        try:
            seen = about(found(make(seed)), "2")
        except GraphkinError:
            continue
        rng = random.Random(seed)
        places = [complex(rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)) for _ in range(4)]
        if not cmath.isfinite(seen.pole) or abs(seen.pole) > 20 * seen.size:
            continue
        for place in places:
            try:
                drawn = bobillier(seen, place)
            except NoBobillier as error:
                assert error.reason == "line"
                continue
            assert not any(entry.measured for entry in drawn.guides)
            assert abs(drawn.board.at(drawn.pole) - seen.pole) < 1e-9
            tried += 1
            clear = min(abs(entry.place - seen.pole) for entry in drawn.guides) / seen.size
            exact = seen.carried(place).centre
            assert near(drawn.board.at(drawn.answer) - place, exact - place, seen.size, 1e-9 / min(clear, 1) ** 2), (seed, place)
    assert tried > 60


def test_bobillier_steps_are_data():
    """Another point's figures put into the same steps give that point's centre."""
    seen = about(found(library.load("fig3-4")), "3")
    drawn, place = bobillier(seen, "E"), 0.08 + 0.02j
    points = {**drawn.construction.points, "E": (place.real, place.imag, 1.0)}
    other = replay(replace(drawn.construction, points=points))
    assert abs(other.at(drawn.answer) - seen.carried(place).centre) < 1e-9
    assert [entry.written for entry in guided(seen) if not entry.measured] == ["A", "D"]


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_bobillier_in_words(lang: str):
    drawn = bobillier(about(found(library.load("p3-23a")), "2"), 0.2 + 0.1j)
    told = bobillier_words(drawn, lang)  # type: ignore[arg-type]
    assert len(told) == 9
    assert drawn.answer.replace("'", "′") in told[-1]
    assert any("infinity" in line or "无穷远" in line for line in told)
    assert not any("{" in line for line in told)


PLANET = """
[frame]
O = [0, 0]
[links.1]
points = ["O"]
[links.H]
OC = 45
[links.2]
CE = {arm}
[[gear]]
links = ["1", "2"]
centres = ["O", "C"]
radii = [30, 15]
[[gear]]
links = ["2", "frame"]
centres = ["C", "O"]
radii = [15, 60]
internal = true
[[driver]]
link = "1"
omega = "90 rpm"
[[pose]]
vector = "OC"
angle = 25
[[pose]]
vector = "CE"
angle = {turn}
"""


@pytest.mark.parametrize(("arm", "turn"), [(15, 80), (10, 130), (22, 250)])
def test_a_wheel_on_the_frame_is_drawn_from_its_contact_not_from_the_answer(arm: float, turn: float):
    seen = about(found(loads(PLANET.format(arm=arm, turn=turn))), "2")
    drawn = bobillier(seen, "E")
    assert [entry.point for entry in drawn.guides] == ["C"]
    assert abs(drawn.board.at(drawn.answer) - seen.points["E"].centre) < 1e-9
    assert "E0" not in drawn.construction.points
    for lang in LANGUAGES:
        told = bobillier_words(drawn, lang)
        assert len(told) == 7
        assert not any("{" in line or "v²" in line for line in told)


@pytest.mark.parametrize(("name", "link", "reason"), [
    ("fig3-4", "2", "pivot"), ("p3-23a", "3", "translation"), ("s4-ex1", "2", "translation"), ("ex3-7", "2", "alone"),
])  # fmt: skip
def test_where_bobillier_gives_nothing(name: str, link: str, reason: str):
    seen = about(found(library.load(name)), link)
    with pytest.raises(NoBobillier) as raised:
        bobillier(seen, next(iter(seen.points)) if reason == "alone" else 0.1 + 0.1j)
    assert raised.value.reason == reason
    assert raised.value.message("zh")
