"""Random mechanisms: what is found by the drawing, held against a dense scan by the analysis."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
import random_mechanisms as made

from graphkin.errors import CannotAssemble, DeadPoint
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.planning import Method, plan
from graphkin.studies import finding
from graphkin.studies.finding.search import differences
from graphkin.studies.finding.stretch import CourseStretch, stretch
from graphkin.studies.sweeps import course

KINDS: dict[str, Callable[[int], Mechanism]] = {
    **{kind: (lambda seed, kind=kind: made.dyad(kind, seed)) for kind in made.DYADS},
    "chain": made.chain, "six": made.six_bar, "cam": made.cam, "cylinder": made.cylinder,
    "epicyclic": made.epicyclic, "rolling": made.rolling, "coupler": made.coupler_angle,
}  # fmt: skip
KINDS["triad"] = lambda seed: made.triad(seed - 96)  # one whose special point goes far off between others
SEEDS = (100,)
ROWS = 801


def planned(kind: str, seed: int) -> Method | None:
    try:
        return plan(KINDS[kind](seed))
    except (DeadPoint, CannotAssemble):
        return None


def quantities(mechanism: Mechanism) -> list[str]:
    """Of the last link and the last point that moves."""
    link = mechanism.moving[-1]
    point = [p for p in mechanism.points if FRAME not in mechanism.owners[p]][-1]
    return [f"omega {link}", f"v {point}", f"x {point}", f"a_x {point}"]


def exactly(over: CourseStretch, t: np.ndarray) -> list[np.ndarray]:
    """All quantities by the analysis."""
    other = CourseStretch(over.course, "analysis", over.names, over.low, over.high, over.stopped)
    return [entry.signed for entry in other.read(t)]


@cache
def scan(kind: str, seed: int) -> tuple[Method, CourseStretch, np.ndarray, list[np.ndarray]] | None:
    """A random mechanism with its scan; None where it has none."""
    method = planned(kind, seed)
    return method and (method, *scanned(method))


def scanned(method: Method) -> tuple[CourseStretch, np.ndarray, list[np.ndarray]]:
    """All quantities by the analysis, evenly over the inside of what is looked at."""
    over = stretch(course(method), (), tuple(quantities(method.mechanism)), "construction")
    t = np.linspace(over.low, over.high, ROWS)[2:-2]
    return over, t, exactly(over, t)


@pytest.mark.many(7)
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", KINDS)
def test_every_change_of_sign_of_a_scan_is_found_and_nothing_else(kind: str, seed: int) -> None:
    if (known := scan(kind, seed)) is None:
        return
    method, over, t, scans = known
    found: dict[int, tuple[float, np.ndarray]] = {}
    for number, (name, values) in enumerate(zip(over.names, scans, strict=True)):
        there = values[np.isfinite(values)]
        target = float(np.percentile(there, 35)) * 1.0001 + 1e-7
        if np.ptp(there) < 1e-9 * np.max(np.abs(there)) or (target < 0 and name.startswith("v ")):
            continue
        si = {"omega": " rad/s", "v": " m/s", "x": " m", "a_x": " m/s^2"}[name.split(" ")[0]]
        positions = finding.find(method, f"{name} = {target!r}{si}").positions
        found[number] = target, np.array([position.t for position in positions])
    exact = exactly(over, np.concatenate([roots for _, roots in found.values()]))
    done = 0
    for number, (target, roots) in found.items():
        name, values = over.names[number], scans[number]
        counts = np.histogram(roots[(roots > t[0]) & (roots < t[-1])], t)[0]
        flips = np.isfinite(values[:-1] * values[1:]) & ((values[:-1] - target) * (values[1:] - target) < 0)
        assert np.array_equal(counts % 2 == 1, flips), name
        size = np.percentile(np.abs(values[np.isfinite(values)]), 90)
        steep = np.abs(differences(over.values(number), over.step / 2)(roots)) * (over.high - over.low)
        off = np.abs(exact[number][done : done + roots.size] - target)
        within = (roots > t[0]) & (roots < t[-1])
        assert np.all(off[within] < 1e-9 * (size + steep[within])), name
        done += roots.size


@pytest.mark.many(7)
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", KINDS)
def test_no_scanned_value_lies_beyond_the_extremes(kind: str, seed: int) -> None:
    if (known := scan(kind, seed)) is None:
        return
    method, over, t, scans = known
    found = [finding.find(method, f"range {name}") for name in over.names]
    near = np.array([-1.0, 0.0, 1.0]) * 1e-4 * (over.high - over.low)
    places = [np.clip(position.t + near, t[0], t[-1]) for one in found for position in one.positions]
    exact = exactly(over, np.concatenate(places))
    done = 0
    for number, (one, values) in enumerate(zip(found, scans, strict=True)):
        there = values[np.isfinite(values)]
        margin = 1e-9 * float(np.ptp(there))
        ends = [position.values[0] for position in one.positions]
        if one.everywhere:
            assert np.ptp(there) < 1e-9 * max(np.max(np.abs(there)), 1e-6)
        else:
            assert min(ends) - margin <= there.min() < there.max() <= max(ends) + margin, over.names[number]
        for position in one.positions:
            beside = exact[number][done : done + 3]
            done += 3
            if position.kind in ("max", "min") and t[0] < position.t < t[-1]:
                best = np.nanmax(beside) if position.kind == "max" else np.nanmin(beside)
                assert beside[1] == pytest.approx(position.values[0], rel=1e-7, abs=margin)
                assert best == pytest.approx(beside[1], rel=1e-9, abs=margin)
            elif position.kind == "pole" and t[0] < position.t < t[-1]:
                assert np.nanmax(np.abs(beside)) > np.percentile(np.abs(there), 90), over.names[number]
            elif position.kind == "pole":
                toward = np.abs(there if position.t >= t[-1] else there[::-1])
                assert toward[-1] > toward[-6], over.names[number]


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", KINDS)
def test_what_the_drawing_tells_of_change_is_the_derivative(kind: str, seed: int) -> None:
    if (method := planned(kind, seed)) is None:
        return
    link = method.mechanism.moving[-1]
    names = (f"theta {link}", *quantities(method.mechanism))
    over = stretch(course(method), (), names, "construction")
    t = over.low + (over.high - over.low) * np.linspace(0.2, 0.8, 41)
    for number, name in enumerate(names):
        told, differed = over.slope(number)(t), differences(over.values(number), over.step / 2)(t)
        smooth = np.abs(over.values(number)(t)) > 1e-2 * np.nanmax(np.abs(over.values(number)(t)))
        scale = max(float(np.nanmax(np.abs(differed))), float(np.nanmax(np.abs(over.values(number)(t)))), 1e-9)
        assert np.nanmax(np.abs(told - differed)[smooth], initial=0.0) < 1e-6 * scale, name


def test_a_rocker_pin_rests_where_its_link_does() -> None:
    """Zeros of a vector and zeros of a signed quantity are looked for in different ways."""
    tried = 0
    for seed in range(16):
        method = planned("six", seed)
        if method is None:
            continue
        mechanism = method.mechanism
        rocker = next(
            (link for link in mechanism.moving if any(FRAME in mechanism.owners[p] for p in mechanism.links[link].points)
             and all(driver.link != link for driver in method.drivers)), None)  # fmt: skip
        if rocker is None:
            continue
        pin = next(p for p in mechanism.links[rocker].points if FRAME not in mechanism.owners[p])
        by_point, by_link = (finding.find(method, f"{name} = 0") for name in (f"v {pin}", f"omega {rocker}"))
        one, other = ([position.t for position in found.positions] for found in (by_point, by_link))
        assert one == pytest.approx(other, abs=1e-8), (seed, pin)
        tried += bool(one)
        if tried == 4 and "GRAPHKIN_RANDOM" not in os.environ:
            break
    assert tried > 3
