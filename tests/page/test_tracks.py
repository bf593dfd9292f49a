"""Between knots all is drawn where a replay has it; numbers are packed without loss."""

from __future__ import annotations

import os
import random
from functools import cache

import numpy as np
import pytest

from graphkin import api
from graphkin.construction import Plane
from graphkin.page import knots as page_grids
from graphkin.page.knots import Knots, PageKnots, cells_shown, page_knots, stencil
from graphkin.page.reach import DriverRange, Reach
from graphkin.page.rows import rows
from graphkin.page.tracks import OF_GRID, Tracks, packed
from graphkin.sheet.marks import Stroke
from graphkin.sheet.window import PLANES

LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-"


@cache
def knots_of(name: str) -> PageKnots:
    """As a page has them; of the scissors fewer, as they tell the same of the cells that are shown."""
    with pytest.MonkeyPatch.context() as patch:
        if name == "p3-14":
            patch.setattr(page_grids, "_OF_SEVERAL", 5_000)
        return page_knots(Reach.of(api.plan(api.load(name))))


@cache
def cells_of(name: str, plane: Plane) -> np.ndarray:
    return cells_shown(knots_of(name), plane)


def reached(knots: PageKnots) -> int:
    """The number of cells of a grid to all corners of which the mechanism gets."""
    there = np.array([plot is not None for plot in knots.plots]).reshape(knots.shape)
    for n, axis in enumerate(knots.axes):
        beside = np.roll(there, -1, n)
        there = np.delete(there & beside, [] if axis.period else -1, n)
    return int(there.sum())


def unpacked(text: str) -> list[int]:
    numbers, pieces = [], []
    for letter in text:
        value = LETTERS.index(letter)
        pieces.append(value % 32)
        if value < 32:
            whole = sum(piece << 5 * k for k, piece in enumerate(pieces))
            numbers.append(-(whole >> 1) if whole & 1 else whole >> 1)
            pieces = []
    return numbers


@pytest.mark.parametrize("name", ["ex3-1", "fig3-10"])
def test_what_is_drawn_between_knots_is_near_enough(name):
    """A full turn, and a short range between dead points: arrows, points and bars, replayed anew."""
    knots, rng, seen = page_knots(Reach.of(api.plan(api.load(name)))), random.Random(name), 0
    (axis,), (low, high) = knots.axes, knots.reach.axes[0].span
    for plane in PLANES:
        frames = [knots.figures.figure(plane, plot).marks for plot in knots.plots]
        for _ in range(6):
            u = rng.uniform(low, high)
            there = knots.figures.figure(plane, knots.reach.plot([u])).marks
            for row in rows([*frames, there]):
                held = row.there[:-1]
                if row.is_known and row.there[-1] and held.all() and not (isinstance(row.mark, Stroke) and row.form):
                    numbers, weights = stencil([axis], [u], held)
                    assert np.abs(weights @ row.numbers[numbers] - row.numbers[-1]).max() < 0.01, (plane, row.mark)
                    seen += 1
    assert seen > 150


@pytest.mark.parametrize("plane", PLANES)
def test_cells_of_a_grid_are_shown_where_they_are_near_enough(plane):
    """Two drivers, each between dead points that go with the other: beyond the rim of what is shown there is nothing,
    and what a page rounds counts many times."""
    knots, rng, seen = knots_of("p3-14"), random.Random(7), 0
    cells, shown = (every.reshape(knots.shape) for every in (cells_of("p3-14", plane), knots.shown[plane]))
    quantum = OF_GRID * knots.figures.window(plane).scale
    held = quantum * np.round(knots.points[plane] / quantum)
    for _ in range(600):
        us = [rng.uniform(*axis.span) for axis in knots.reach.axes]
        if cells[tuple(axis.cell(u) for axis, u in zip(knots.axes, us, strict=True))]:
            there = knots.reach.plot(us).points(plane)
            numbers, weights = stencil(knots.axes, us, shown)
            off = weights @ held[numbers] - [complex(there[name]) for name in knots.names[plane]]
            assert np.abs(off).max() < 0.02 * knots.figures.window(plane).scale
            seen += 1
    assert seen > 30


@pytest.mark.parametrize("name", ["p3-21", "p3-22", "s4-ex6"] if "GRAPHKIN_RANDOM" in os.environ else ["s4-ex6"])
def test_the_drawn_position_of_several_drivers_is_a_knot(name):
    """There all planes are shown, and in many of the cells to whose corners the mechanism gets."""
    knots = knots_of(name)
    drawn = knots.reach.drawn
    at = tuple(int(np.abs(axis.u - u).argmin()) for axis, u in zip(knots.axes, drawn, strict=True))
    assert [axis.u[k] for axis, k in zip(knots.axes, at, strict=True)] == pytest.approx(drawn, abs=1e-9)
    for plane in PLANES:
        assert knots.shown[plane].reshape(knots.shape)[at], plane
        assert cells_of(name, plane).sum() > 0.45 * reached(knots), plane


@pytest.mark.parametrize("ends", ["line", "low", "high", "both"])
def test_a_driver_goes_to_its_ends(ends):
    axis = DriverRange(api.load("ex3-1").drivers[0], 0.3, 2.5, ends)
    low, high = (axis.value(u) for u in axis.span)
    assert 0.3 <= low < 0.31
    assert 2.49 < high <= 2.5
    for value in np.linspace(low, high, 9):
        assert axis.value(axis.u_at(value)) == pytest.approx(value, abs=1e-9)


def test_eight_knots_hold_powers_up_to_the_seventh():
    """Within a run of knots, at uneven distances; over a grid, the product of its drivers."""
    uneven, even = Knots(np.array([0, 1, 1.5, 2, 3, 4, 6, 7.0])), Knots(np.arange(9.0))
    table = np.array([(x**7 - x) * (y**6 + 1) for x in uneven.u for y in even.u])
    mask = np.ones((8, 9), dtype=bool)
    mask[0, 0] = False
    numbers, weights = stencil([uneven, even], [1.7, 7.9], mask)
    assert weights @ table[numbers] == pytest.approx((1.7**7 - 1.7) * (7.9**6 + 1), rel=1e-9)
    round_about = Knots(np.arange(12) * np.pi / 6, 2 * np.pi)
    numbers, weights = stencil([round_about], [6.2], np.ones(12, dtype=bool))
    assert weights @ np.cos(round_about.u)[numbers] == pytest.approx(np.cos(6.2), abs=1e-5)


def test_tracks_are_packed_without_loss():
    values = np.cumsum(np.random.default_rng(5).normal(size=90))
    values[[3, 4, 40]] = np.nan
    tracks = Tracks([], [])
    assert tracks.place(np.full(90, 2.5)) == 2.5
    assert tracks.place(values) == tracks.place(values.copy()) == [0]
    order, *whole = unpacked(tracks.texts[0])
    for _ in range(order):
        whole = np.cumsum(whole)
    held = ~np.isnan(values)
    assert np.abs(np.array(whole)[held] / 1000 - values[held]).max() <= 0.0005 + 1e-9
    assert unpacked(packed(np.array([0, -1, 31, -5000, 2**40]))) == [0, -1, 31, -5000, 2**40]
    assert tracks.mask(held) == 0
    assert tracks.mask(np.ones(90, dtype=bool)) is None
    first, *lengths = unpacked(tracks.masks[0])
    assert (first, lengths) == (1, [2, 2, 35, 1])
