"""What is drawn as obstacles: boxes and lines among random marks, held against shapely's geometry."""

from __future__ import annotations

import cmath
import random
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import shapely

from graphkin.base.rooms import Room
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_candidates import LabelScene
from graphkin.sheet.lettering import plain
from graphkin.sheet.marks import ArcMark, Disc, Mark, Stroke, Text
from graphkin.sheet.obstacles import arc_places, obstacles

_COUNT = 60


def _star(rng: random.Random, centre: complex, corners: int, bulge: float) -> tuple[complex, ...]:
    """Corners of an area about its middle; it bulges inwards where the bulge is large."""
    turns = sorted(rng.uniform(0, cmath.pi * 2) for _ in range(corners))
    return tuple(centre + cmath.rect(rng.uniform(4 - bulge, 4 + bulge), turn) for turn in turns)


def _marks(rng: random.Random) -> Iterator[tuple[Mark, shapely.Geometry]]:
    """Marks of all kinds, each with its geometry."""
    for k in range(_COUNT):
        at = complex(rng.uniform(0, 100), rng.uniform(0, 80))
        far = at + cmath.rect(rng.choice((0.0, 3.0, 30.0)), rng.choice((0.0, cmath.pi / 2, rng.uniform(0, 6))))
        corners = _star(rng, at, 3 + k % 9, rng.uniform(0, 3))
        arc = ArcMark(at, rng.uniform(1, 9), rng.uniform(0, 6), rng.uniform(-6, 6), "thin")
        rim = [at + cmath.rect(2, cmath.pi / 12 * turn) for turn in range(24)]
        low = at + 1j * 0.04 * 3.5
        yield Stroke((at, far, at + 5), "thin"), shapely.LineString(_xy([at, far, at + 5]))
        yield Stroke(corners, "thin", closed=True, fill="ink"), shapely.Polygon(_xy(corners))
        yield Stroke(corners, "thin", closed=True), shapely.LinearRing(_xy(corners))
        yield arc, shapely.LineString(_xy(arc_places(arc)))
        yield Disc(at, 2, "thin", "ink"), shapely.Polygon(_xy(rim))
        yield Text(plain("A"), at, 3.5), shapely.box(low.real, at.imag - 0.68 * 3.5, at.real + 0.722 * 3.5, low.imag)


def _xy(places: Any) -> list[tuple[float, float]]:
    return [(place.real, place.imag) for place in places]


@pytest.mark.parametrize("at_once", [1000, 70, 7])
@pytest.mark.parametrize("seed", range(3))
def test_boxes_and_lines_touch_what_they_touch(seed: int, at_once: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("graphkin.base.segments._AT_ONCE", at_once)
    rng = random.Random(seed)
    marks = list(_marks(rng))
    things = [shape for _, shape in marks]
    one, other = (obstacles(mark for mark, _ in some) for some in (marks[:50], marks[50:]))
    known, dice = one + other, np.random.default_rng(seed)
    low = dice.uniform(0, 80, (200, 2))
    high, end = low + dice.uniform(2, 9, low.shape), low + dice.uniform(-30, 30, low.shape)  # as large as letters are
    boxes, lines = shapely.box(*low.T, *high.T), shapely.linestrings(np.stack([low, end], axis=1))
    rims = [thing.exterior if isinstance(thing, shapely.Polygon) else thing for thing in things]
    assert np.flatnonzero(known.touched(low.T, high.T)).tolist() == _met(boxes, things)
    assert {*_met(lines, rims)} <= {*np.flatnonzero(known.crossed(low.T, end.T))} <= {*_met(lines, things)}
    wide, narrow = known.around(low.T, high.T, (1.3, 0.4))
    for margin, counted in ((1.3, wide), (0.4, narrow)):
        assert np.flatnonzero(counted).tolist() == _met(shapely.box(*(low - margin).T, *(high + margin).T), things)


def _met(shapes: Any, things: list[shapely.Geometry]) -> list[int]:
    """The numbers of the shapes that touch one of the things."""
    return sorted({*shapely.STRtree(things).query(shapes, predicate="intersects")[0].tolist()})


@pytest.mark.parametrize("from_below", [False, True])
@pytest.mark.parametrize("size", [4 + 3j, 9 + 6j, 16 + 4j])
def test_a_free_rectangle_touches_nothing(size: complex, from_below: bool) -> None:
    marks = [mark for mark, _ in _marks(random.Random(1))][:12]
    room = FreeRoom(LabelScene([], marks, Room(0.0, 0.0, 100.0, 80.0)))
    corner = room.corner(size, from_below)
    assert corner is not None
    low = np.array([[corner.real, corner.imag]])
    assert room.free(low, low + np.array([size.real, size.imag])).all()


def test_nothing_larger_than_its_room_is_free() -> None:
    room = FreeRoom(LabelScene([], [], Room(0.0, 0.0, 20.0, 20.0)))
    assert room.corner(15 + 15j) == 2 + 2j
    assert [room.corner(size) for size in (17 + 5j, 5 + 17j, 50 + 50j)] == [None] * 3
