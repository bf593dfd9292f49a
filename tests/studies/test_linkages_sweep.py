"""Closed forms against a dense sweep: thousands of linkages, positions found from the lengths alone.

A limit is right if the position told for it closes, and no position of the sweep lies beyond it.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from graphkin.errors import CannotClose, OnlyStretched
from graphkin.studies.linkages import FourBar, GuideBar, SliderCrank, report

STEPS = 3600
CLOSE = 1e-7
"""Positions in line are found from squares: half the digits."""
TURNED = np.exp(1j * np.arange(STEPS) * math.tau / STEPS)
STEP = math.tau / STEPS


def made(kind, rows, **more):
    """The linkages that close, with their rows."""
    found = []
    for row in rows:
        try:
            found.append((row, kind(*(float(x) for x in row), **more)))
        except (CannotClose, OnlyStretched):
            continue
    return found


def lengths(count, columns, seed, signed_last=False):
    """Half whole numbers, among which are many change points, half any numbers."""
    rng = np.random.default_rng(seed)
    whole, broken = rng.integers(1, 13, (count // 2, columns)), rng.uniform(0.5, 12, (count // 2, columns))
    rows = np.concatenate([whole.astype(float), broken])
    if signed_last:
        rows[:, -1] = (rows[:, -1] - 1) * rng.choice([-1, 1], len(rows)) * 0.5
    return rows


def corners(near, far, base):
    """Both third corners of triangles over base vectors: near and far sides from its ends; nan where none."""
    size = np.abs(base)
    with np.errstate(invalid="ignore", divide="ignore"):
        along = (near**2 - far**2 + size**2) / (2 * size)
        high = np.sqrt(near**2 - along**2)
        return np.stack([(along + 1j * high) * base / size, (along - 1j * high) * base / size], axis=-1)


def angle_between(one, other):
    product = np.conj(one) * other
    return np.arctan2(np.abs(product.imag), np.abs(product.real))


def attained(found, measured):
    """The least transmission angle is that of a position told, measured there."""
    assert min(measured) == pytest.approx(found.gamma_min, abs=CLOSE)


def within(directions, ends, full):
    """How far directions lie outside the arc from ends[0] to ends[1] [rad]."""
    if full:
        return np.zeros(len(directions))
    middle, half = (ends[0] + ends[1]) / 2, (ends[1] - ends[0]) / 2
    return np.abs(np.angle(np.exp(1j * (directions - middle)))) - half


def loop(bar, found, places):
    """By how much the links of a position are too long or too short."""
    a, b, c, d = places
    mine = (bar.crank, bar.coupler, bar.rocker, bar.frame)
    return max(abs(abs(x) - y) for x, y in zip((b - a, c - b, d - c, d - a), mine))


def output_arc(found):
    """The output's range, whose ends are the limits told."""
    span = found.output_range
    ends = sorted(end.output % math.tau for end in found.limits)
    assert ends == pytest.approx(sorted((span.low % math.tau, span.high % math.tau)), abs=1e-9)
    return span.low, span.high


def four_bar_positions(row):
    """Every B and C of a sweep of AB and one of CD, in both assemblies."""
    a, b, c, d = row
    first_b = np.repeat((a * TURNED)[:, None], 2, axis=1)
    first_c = first_b + corners(np.float64(b), np.float64(c), d - a * TURNED)
    second_c = np.repeat((d + c * TURNED)[:, None], 2, axis=1)
    second_b = second_c + corners(np.float64(b), np.float64(a), -(d + c * TURNED))
    return first_b, first_c, second_b, second_c


def same_assembly(row, places):
    """Keeps the positions reached from the drawn one: two links that are not the shortest never come in line."""
    _a, _b, _c, _d = row
    short, rest = min(row), sum(row)
    if 2 * (short + max(row)) >= rest - 1e-9:
        return lambda *_: True
    at = list(row).index(short)

    def sign(pa, pb, pc, pd):
        arms = [pb - pa, pc - pb, pd - pc, pa - pd]
        return np.sign((np.conj(arms[(at + 1) % 4]) * arms[(at + 2) % 4]).imag)

    drawn = sign(*places)
    return lambda *where: sign(*where) == drawn


@pytest.mark.many
@pytest.mark.parametrize("chunk", range(5))
def test_four_bars(chunk):
    kinds = set()
    for row, bar in made(FourBar, lengths(1400, 4, chunk)):
        found = report(bar)
        kinds.add(found.kind)
        check_four_bar(row, bar, found)
    assert kinds == {"crank-rocker", "rocker-crank", "double-crank", "double-rocker", "triple-rocker", "change-point"}


def check_four_bar(row, bar, found):
    positions = four_bar_positions(row)
    keep = same_assembly(row, bar.places)
    b = np.concatenate([positions[0].ravel(), positions[2].ravel()])
    c = np.concatenate([positions[1].ravel(), positions[3].ravel()])
    there = np.isfinite(b) & np.isfinite(c)
    there &= keep(0, b, c, row[3])
    b, c = b[there], c[there]
    for end in (*found.limits, *found.critical):
        assert loop(bar, found, end.places) < CLOSE * max(row), row
    for end in found.limits:
        assert angle_between(end.places[1] - end.places[0], end.places[2] - end.places[1]) < CLOSE, row
    span = found.driver_range
    assert within(np.angle(b), (span.low, span.high), span.full).max() < CLOSE, row
    assert abs(len(np.unique(np.round(np.angle(b[: there[: 2 * STEPS].sum()]) / STEP))) - min(span.width, math.tau) / STEP) <= 2, row
    gamma = angle_between(b - c, row[3] - c)
    assert gamma.min() > found.gamma_min - CLOSE, row
    attained(found, [angle_between(end.places[1] - end.places[2], row[3] - end.places[2]) for end in found.critical])
    swings(row, bar, found, np.angle(c - row[3]))
    if found.theta is not None:
        ratio(row, bar, found, positions)


def swings(row, bar, found, directions):
    if not found.limits:
        assert len(np.unique(np.round(directions / STEP * 0.2))) >= 715, row
        return
    low, high = output_arc(found)
    assert within(directions, (low, high), False).max() < CLOSE, row


def ratio(row, bar, found, positions):
    """K: how long the output goes each way while the crank turns evenly."""
    _b, c = positions[0], positions[1]
    side = 0 if (np.conj(row[3] - bar.places[1]) * (bar.places[2] - bar.places[1])).imag >= 0 else 1
    turned = np.angle((np.roll(c[:, side], -1) - row[3]) / (c[:, side] - row[3]))
    share = max((turned > 0).sum(), (turned < 0).sum()) / STEPS
    assert abs(share - (math.pi + found.theta) / math.tau) < 2.5 / STEPS, row
    assert found.k == pytest.approx((math.pi + found.theta) / (math.pi - found.theta), rel=1e-12)
    if found.slow is not None:
        first = found.limits[found.slow[0]]
        start = round((first.driver + 0.3) / STEP) % STEPS
        end = found.limits[found.slow[1]].output
        before, after = (abs(np.angle(np.exp(1j * (np.angle(c[k % STEPS, side] - row[3]) - end)))) for k in (start, start + 1))
        assert after < before or found.theta < 0.02, row


@pytest.mark.many
@pytest.mark.parametrize("chunk", range(4))
def test_sliders(chunk):
    kinds = set()
    for row, slider in made(SliderCrank, lengths(1000, 3, chunk, signed_last=True)):
        found = report(slider)
        kinds.add((found.kind, found.family))
        r, rod, e = row
        b = np.repeat((r * TURNED)[:, None], 2, axis=1)
        with np.errstate(invalid="ignore"):
            leg = np.sqrt(rod**2 - (e - b[:, :1].imag) ** 2) * np.array([1, -1])
        s = b.real + leg
        there = np.isfinite(s)
        if abs(abs(r - rod) - abs(e)) > 1e-9 and abs(r - rod) > abs(e):
            there &= np.sign(s) == np.sign(slider.places[2].real)
        assert s[there].max() < found_reach(found)[1] + CLOSE, row
        assert s[there].min() > found_reach(found)[0] - CLOSE, row
        assert abs(found.stroke - np.ptp(found_reach(found))) < 1e-9
        span = found.driver_range
        assert within(np.angle(b[there]), (span.low, span.high), span.full).max() < CLOSE, row
        gamma = math.pi / 2 - np.arcsin(np.abs(e - b[there].imag) / rod)
        assert gamma.min() > found.gamma_min - CLOSE, row
        attained(found, [math.pi / 2 - angle_between(end.places[2] - end.places[1], 1.0) for end in found.critical])
        for end in (*found.limits, *found.critical):
            pa, pb, pc = end.places
            assert max(abs(abs(pb - pa) - r), abs(abs(pc - pb) - rod), abs(pc.imag - e)) < CLOSE, row
        if found.theta is not None:
            moved = np.roll(s[:, 0], -1) - s[:, 0] if slider.places[2].real > 0 else np.roll(s[:, 1], -1) - s[:, 1]
            share = max((moved > 0).sum(), (moved < 0).sum()) / STEPS
            assert abs(share - (math.pi + found.theta) / math.tau) < 2.5 / STEPS, row
    assert {"slider-crank", "rocker-slider", "change-point"} <= {kind for kind, _ in kinds}


def found_reach(found):
    return sorted(end.output for end in found.limits)


@pytest.mark.many
@pytest.mark.parametrize("chunk", range(4))
def test_guide_bars(chunk):
    kinds = set()
    for row, bar in made(GuideBar, lengths(1000, 3, chunk + 50, signed_last=True)):
        found = report(bar)
        kinds.add(found.kind)
        r, d, e = row
        b = np.repeat((r * TURNED)[:, None], 2, axis=1)
        arm = b - d
        with np.errstate(invalid="ignore"):
            along = np.sqrt(np.abs(arm[:, :1]) ** 2 - e**2) * np.array([1, -1])
        there = np.isfinite(along) & (np.abs(arm) > 1e-9)
        if abs(abs(d - r) - abs(e)) > 1e-9 and abs(d - r) > abs(e):
            there &= np.sign(along) == np.sign(((bar.places[1] - bar.places[2]) * np.exp(-1j * bar.turn)).real)
        turned = np.angle(arm[there] / (along[there] + 1j * e))
        if found.limits:
            low, high = output_arc(found)
            assert within(turned, (low, high), False).max() < CLOSE, row
        elif found.kind != "change-point":
            line = np.angle(arm[:, 0] / (along[:, 0] + 1j * e))
            assert abs(np.angle(np.exp(1j * (np.roll(line, -1) - line))).sum()) == pytest.approx(math.tau), row
        span = found.driver_range
        assert within(np.angle(b[there]), (span.low, span.high), span.full).max() < CLOSE, row
        gamma = np.arctan2(np.abs(along[there]), abs(e))
        assert gamma.min() > found.gamma_min - CLOSE, row
        if found.kind != "change-point":
            arms = [(end.places[1] - end.places[2]) * np.exp(-1j * end.turn) for end in found.critical]
            attained(found, [angle_between(arm, 1j) for arm in arms])
        if found.theta is not None:
            column = there[:, 0].argmin() if not there[:, 0].all() else 0
            line = np.angle(np.roll(arm[:, column] / (along[:, column] + 1j * e), -1) / (arm[:, column] / (along[:, column] + 1j * e)))
            share = max((line > 0).sum(), (line < 0).sum()) / STEPS
            assert abs(share - (math.pi + found.theta) / math.tau) < 2.5 / STEPS, row
        for end in (*found.limits, *found.critical):
            pa, pb, pc = end.places
            off = ((pb - pc) * np.exp(-1j * end.turn)).imag
            assert max(abs(abs(pb - pa) - r), abs(abs(pc - pa) - d), abs(off - e)) < CLOSE, row
    assert kinds == {"oscillating guide bar", "rotating guide bar", "rocking guide bar", "change-point"}
