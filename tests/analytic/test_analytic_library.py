"""The analytic road on the library: exact values of the textbook's problems, and laws that every mechanism keeps."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np
import pytest
from contacts import touching
from roads import definite

from graphkin.analytic import Motion, mobility, motion
from graphkin.files import library

TABLE = [
    # name, quantity (v, a: sizes; vx, vy: parts; px, py: instant centre), exact value in SI, source
    ("ex3-2", "v C", "0.35460", "Sun Huan, example 3-2"),
    ("ex3-2", "v D", "0.38582", "Sun Huan, example 3-2"),
    ("ex3-2", "v E", "0.40754", "Sun Huan, example 3-2"),
    ("ex3-2", "px 4", "0.099663", "Sun Huan, example 3-2"),
    ("ex3-2", "py 4", "0.192108", "Sun Huan, example 3-2"),
    ("ex3-3", "omega 6", "-1.5686", "Sun Huan, example 3-3"),
    ("ex3-3", "omega 3", "6.6667", "Sun Huan, example 3-3"),
    ("ex3-4", "omega 1", "-0.48957", "Sun Huan, example 3-4"),
    ("ex3-4", "omega 3", "-0.92700", "Sun Huan, example 3-4"),
    ("fig2-32", "omega 2", "1.4904", "Sun Huan, figure 2-32"),
    ("fig2-32", "alpha 2", "35.934", "Sun Huan, figure 2-32"),
    ("fig3-5", "vy K", "0.16576", "Sun Huan, figure 3-5"),
    ("p3-8", "omega 2", "2.32719", "Sun Huan, exercise 3-8"),
    ("p3-8", "alpha 2", "9.35023", "Sun Huan, exercise 3-8"),
    ("p3-12", "omega 1 / omega 3", "0.534962", "Sun Huan, exercise 3-12"),
    ("p3-15", "vx C", "-1.22039", "Sun Huan, exercise 3-15"),
    ("p3-15", "a C", "0.41152", "Sun Huan, exercise 3-15"),
    ("p3-16", "v E", "0.16341", "Sun Huan, exercise 3-16"),
    ("p3-16", "omega 3", "-6.1263", "Sun Huan, exercise 3-16"),
    ("p3-16", "omega 4", "31.865", "Sun Huan, exercise 3-16"),
    ("p3-17", "omega 5", "-0.12181", "Sun Huan, exercise 3-17"),
    ("p3-19", "omega 2", "-0.05878", "Sun Huan, exercise 3-19"),
    ("p3-19", "omega 3", "1.48107", "Sun Huan, exercise 3-19"),
    ("p3-19", "a B", "0.018000", "Sun Huan, exercise 3-19"),
    ("s3-1-18a", "omega 2", "-2.000000", "Yang Kezhen, exercise 1-18"),
    ("s3-1-18b", "omega 2", "1.428571", "Yang Kezhen, exercise 1-18"),
    ("s3-cam", "v B", "0.09616", "course notes, example 2"),
    ("s3-sieve", "omega 3", "-2.53871", "course notes, sieve"),
    ("s3-sieve", "alpha 3", "-4.22917", "course notes, sieve"),
    ("s3-sieve", "a C", "2.07648", "course notes, sieve"),
    ("s3-sieve", "a D", "2.09855", "course notes, sieve"),
    ("s3-sieve", "a E", "2.41455", "course notes, sieve"),
    ("s4-ex2", "omega 1", "2.000000", "theoretical mechanics, example 2"),
    ("s4-ex2", "v B", "1.73205", "theoretical mechanics, example 2"),
    ("s4-ex2", "alpha 1", "-6.92820", "theoretical mechanics, example 2"),
    ("s4-ex2", "a B", "8.000000", "theoretical mechanics, example 2"),
    ("s4-ex2", "alpha 2", "40.000000", "theoretical mechanics, example 2"),
    ("s4-ex4", "omega 2", "-7.500000", "theoretical mechanics, example 4"),
    ("s4-ex4", "omega 1", "10.000000", "theoretical mechanics, example 4"),
    ("s4-ex5", "omega 2", "-1.500000", "theoretical mechanics, example 5"),
    ("s4-ex5", "omega 4", "-3.750000", "theoretical mechanics, example 5"),
    ("s4-ex5", "a A", "27.000000", "theoretical mechanics, example 5"),
    ("s4-ex5", "alpha 4", "-9.74279", "theoretical mechanics, example 5"),
    ("s4-ex5", "omega 3", "-6.000000", "theoretical mechanics, example 5"),
    ("s4-ex5", "alpha 3", "-25.33124", "theoretical mechanics, example 5"),
    ("s4-ex5", "alpha 2", "5.84567", "theoretical mechanics, example 5"),
    ("s4-ex6", "v C", "0.55509", "theoretical mechanics, example 6"),
    ("s4-ex6", "a C", "1.27995", "theoretical mechanics, example 6"),
    ("scotch-yoke", "vx B", "-0.3464102", "v = -r omega sin(theta) = -0.04 x 10 x sin 60 deg"),
    ("scotch-yoke", "ax B", "-2.0000000", "a = -r omega^2 cos(theta) = -0.04 x 100 x cos 60 deg"),
]


def centre(found: Motion, link: str) -> complex:
    """Instant centre of a link against the frame [m]."""
    point = next(iter(found.mechanism.links[link].points))
    return complex(found.position[point] + 1j * found.velocity[point] / found.omega[link])


READERS: dict[str, Callable[[Motion, str], float]] = {
    "omega": lambda found, link: float(found.omega[link]),
    "alpha": lambda found, link: float(found.alpha[link]),
    "v": lambda found, point: abs(found.velocity[point]),
    "vx": lambda found, point: float(found.velocity[point].real),
    "vy": lambda found, point: float(found.velocity[point].imag),
    "a": lambda found, point: abs(found.acceleration[point]),
    "ax": lambda found, point: float(found.acceleration[point].real),
    "px": lambda found, link: centre(found, link).real,
    "py": lambda found, link: centre(found, link).imag,
}


def read(found: Motion, quantity: str) -> float:
    over, *under = (READERS[kind](found, name) for kind, name in re.findall(r"(\w+) (\w+)", quantity))
    return over / under[0] if under else over


@pytest.mark.parametrize(("name", "quantity", "exact", "source"), TABLE)
def test_exact_value(name: str, quantity: str, exact: str, source: str) -> None:
    """To the last digit printed."""
    digit = 10.0 ** -len(exact.partition(".")[2])
    assert read(motion(library.load(name)), quantity) == pytest.approx(float(exact), abs=0.501 * digit), source


def test_the_scotch_yoke_swings_harmonically() -> None:
    """s = r cos(theta), v = -r omega sin(theta), a = -r omega^2 cos(theta) over the whole turn."""
    theta = np.linspace(0, 2 * np.pi, 73)
    found, r, omega = motion(library.load("scotch-yoke"), [theta]), 0.04, 10.0
    wanted = r * np.cos(theta), -r * omega * np.sin(theta), -r * omega**2 * np.cos(theta)
    for seen, exact in zip((found.s["ram"], found.s_rate["ram"], found.s_acceleration["ram"]), wanted, strict=True):
        assert seen == pytest.approx(exact, abs=1e-12)


def test_swing_of_the_windscreen_wiper() -> None:
    """Exercise 3-19: rack 39.72 deg, wiper 171.89 deg."""
    mechanism = library.load("p3-19")
    found = motion(mechanism, [mechanism.drivers[0].value - np.linspace(0, 2 * np.pi, 20001)])
    assert np.degrees([np.ptp(found.theta[link]) for link in "23"]) == pytest.approx([39.72, 171.89], abs=5e-3)


@pytest.mark.parametrize("name", library.names())
def test_every_mechanism_is_solved(name: str) -> None:
    mechanism = library.load(name)
    found, counted = motion(mechanism), mobility(mechanism)
    assert definite(mechanism)
    assert (counted.free, counted.redundant, counted.unplaced) == ((), (), ())
    assert set(found.omega) == set(mechanism.links)
    assert all(np.isfinite(value) for value in [*found.acceleration.values(), *found.alpha.values()])


@pytest.mark.parametrize("name", library.names())
def test_motion_is_the_derivative_along_a_sweep(name: str) -> None:
    mechanism, h = library.load(name), 2e-5
    here, t = motion(mechanism), 2e-5 * np.arange(-2, 3)
    values = [
        value + driver.rate * t + driver.acceleration * t**2 / 2
        for value, driver in zip(here.values, mechanism.drivers, strict=True)
    ]
    around = motion(mechanism, values)
    for places, first, second in (
        (around.position, here.velocity, here.acceleration),
        (around.theta, here.omega, here.alpha),
        (around.s, here.s_rate, here.s_acceleration),
    ):
        for key, x in places.items():
            x = x - x[2]
            slope, bend = np.array([1, -8, 0, 8, -1]) @ x / (12 * h), np.array([-1, 16, -30, 16, -1]) @ x
            assert first[key] == pytest.approx(slope, rel=1e-6, abs=1e-8)
            assert second[key] == pytest.approx(bend / (12 * h * h), rel=2e-4, abs=2e-3)


@pytest.mark.parametrize("name", library.names())
def test_links_touch_as_their_pairs_say(name: str) -> None:
    for gap, slip in touching(motion(library.load(name))):
        assert np.max(abs(gap)) < 1e-9
        assert np.max(abs(slip)) < 1e-9


@pytest.mark.parametrize("name", library.names())
def test_also_is_reached_by_moving_on(name: str) -> None:
    mechanism = library.load(name)
    start = motion(mechanism).values
    longest = max((len(driver.also) for driver in mechanism.drivers), default=0)
    for k in range(longest):
        values = [d.also[k] if k < len(d.also) else s for d, s in zip(mechanism.drivers, start, strict=True)]
        assert all(np.isfinite(v) for v in motion(mechanism, values).velocity.values())
