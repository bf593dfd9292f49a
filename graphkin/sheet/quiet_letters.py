"""Letters of figures that are shown in turn: each keeps one side of what it names, and goes along without hopping.

The side is the one on which it lies on the fewest lines and letters, all positions together. Arrows are not lettered:
the letters at their ends say as much.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

import numpy as np

from graphkin.sheet.crossings import overlap
from graphkin.sheet.lettering import Label, box
from graphkin.sheet.marks import Mark, Place, Text
from graphkin.sheet.obstacles import Obstacles, obstacles
from graphkin.sheet.paper import Room
from graphkin.sheet.wanted import LabelRequest
from graphkin.sheet.window import Figure

_SIDES = tuple(cmath.rect(1, math.tau * k / 12) for k in range(12))
_RINGS = (0.0, 2.8)
"""How far from its sign a letter may stand: farther, it has got past a block [mm]."""
_FARTHER = 0.15
"""What that costs in each position."""
_ALONG = (0.5, 0.35, 0.65)
"""Where beside a line its number may stand."""
_CLEAR = 0.4
"""What letters keep from lines [mm]."""
_SELDOM = 0.1
"""Letters that points share for a moment, where they lie on one another, flash up: those on fewer of the figures."""
_OUTSIDE = 6.0
"""Leaving its room counts like lying on so many lines."""
_WAYS = (1 + len(_SIDES)) * len(_RINGS)

Boxes = tuple[np.ndarray, np.ndarray]
"""Upper left and lower right corners (n, 2) [mm]."""


def lettered(figures: Sequence[Figure], room: Room, off: Sequence[Mark]) -> list[list[Mark]]:
    """The marks of each figure with their letters; `off`: what letters keep off, too."""
    found: list[list[Mark]] = [list(figure.marks) for figure in figures]
    standing = [obstacles([*figure.marks, *off]) for figure in figures]
    taken: list[list[Boxes]] = [[] for _ in figures]
    for wants in _by_label(figures).values():
        at = list(wants)
        middles = np.array([_middles(want) for want in wants.values()])
        half = _half(wants[at[0]].label, wants[at[0]].size)
        costs = [_costs(row, half, standing[k], taken[k], room) for k, row in zip(at, middles, strict=True)]
        best = int(np.argmin(np.sum(costs, axis=0) + len(costs) * _dislikes(middles.shape[1])))
        for k, row in zip(at, middles, strict=True):
            place = _boxes(row[best : best + 1], half)
            if not any(_lies(place, other) for other in taken[k]):  # hidden while it would lie on another
                found[k].append(_text(wants[k], row[best]))
                taken[k].append(place)
    return found


def _by_label(figures: Sequence[Figure]) -> dict[tuple[Label, bool], dict[int, LabelRequest]]:
    """Letters by what they say, and by figure; what is named so most often comes first, what seldom is not at all."""
    found: dict[tuple[Label, bool], dict[int, LabelRequest]] = {}
    for k, figure in enumerate(figures):
        for want in figure.wanted:
            if not want.of:
                found.setdefault((want.label, want.end is None), {}).setdefault(k, want)
    often = {label: wants for label, wants in found.items() if len(wants) >= _SELDOM * len(figures)}
    return dict(sorted(often.items(), key=lambda entry: -len(entry[1])))


def _middles(want: LabelRequest) -> list[Place]:
    """Where its middle may be: around its point, the side it likes among them; or beside its line."""
    half = _half(want.label, want.size)
    if want.end is None or abs(want.end - want.start) < 1e-6:
        away = want.away / abs(want.away) if abs(want.away) > 1e-9 else 1 + 0j
        return [_touching(want.place, side, want.gap + 0.6 + far, half) for far in _RINGS for side in (away, *_SIDES)]
    along = (want.end - want.start) / abs(want.end - want.start)
    ways = [(want.start + (want.end - want.start) * t, along * turn) for t in _ALONG for turn in (-1j, 1j)]
    found = [at + way * (_support(way, half) + want.gap) for at, way in ways]
    return found + found[:1] * (_WAYS - len(found))


def _dislikes(count: int) -> np.ndarray:
    """Near is better."""
    return _FARTHER * (np.arange(count) >= count // len(_RINGS))


def _touching(at: Place, side: complex, reach: float, half: complex) -> Place:
    """A box that a ring about a place touches with its near side."""
    return at + side * reach + complex(_held(side.real) * half.real, _held(side.imag) * half.imag)


def _held(x: float) -> float:
    return max(-1.0, min(1.0, x * 1.6))


def _support(way: complex, half: complex) -> float:
    return abs(way.real) * half.real + abs(way.imag) * half.imag


def _half(label: Label, size: float) -> complex:
    wide, up, down = box(label, size)
    return complex(wide, up + down) / 2


def _boxes(middles: np.ndarray, half: complex) -> Boxes:
    places = np.stack([middles.real, middles.imag], axis=1)
    reach = np.array([half.real + _CLEAR, half.imag + _CLEAR])
    return places - reach, places + reach


def _lies(one: Boxes, other: Boxes) -> np.ndarray:
    """Which of the boxes lie on the other; what they keep from lines they need not keep twice from one another."""
    lies: np.ndarray = overlap(one[0].T, one[1].T, other[0].T + _CLEAR, other[1].T - _CLEAR)
    return lies


def _costs(middles: np.ndarray, half: complex, drawn: Obstacles, taken: Sequence[Boxes], room: Room) -> np.ndarray:
    """On how many things each of the places lies."""
    low, high = _boxes(middles, half)
    cost = np.bincount(drawn.touched(low, high), minlength=len(middles)).astype(float)
    for other in taken:
        cost += _lies((low, high), other)
    outside = (low < [room.left, room.top]).any(axis=1) | (high > [room.right, room.bottom]).any(axis=1)
    return cost + _OUTSIDE * outside


def _text(want: LabelRequest, middle: Place) -> Text:
    wide, up, down = box(want.label, want.size)
    return Text(want.label, complex(middle) + complex(-wide, up - down) / 2, want.size, want.step)
