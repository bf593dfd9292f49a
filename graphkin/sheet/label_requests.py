"""A label that wants a place, and its candidates: around its point, along its line, or on a leader."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import takewhile
from typing import NamedTuple

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.rooms import RoundRoom
from graphkin.base.value import frozen
from graphkin.sheet.lettering import LABEL, Label, box, width
from graphkin.sheet.marks import Place, Text

_RINGS, _LED = np.array([0.0, 1.0, 2.2]), np.array([2.5, 4.5, 7.0, 9.5])
"""Distances of a letter from its sign, and those from which on a leader is drawn [mm]."""
_TURNS = np.array([cmath.rect(1, math.tau * k / 16) for k in range(16)])
_LEANING = np.clip(_TURNS.real * 1.6, -1.0, 1.0) + 1j * np.clip(_TURNS.imag * 1.6, -1.0, 1.0)
"""The distance of a box to its side, and up or down, from what it touches, of its half width and height, in each
direction; in four of eight its corners come to the ring."""
_LITTLE = np.array([0.05 * ((k - 14) % 16) for k in range(16)])
"""The cost of a direction where none is liked: above and to the right first."""
_NOWHERE = complex("nan")
_LEADER, _FARTHER = 6.0, 1.6  # the cost of a leader, and of each millimetre from the sign
_WIDE, _OFF_WIDE = np.array([*_RINGS, 3.5, 5.0]), np.array([[0.0], [0.75], [1.65], [2.6], [3.6]])
"""Distances of a label from its sign, and from its line beyond what it needs, at which it needs no leader [mm]."""
_FAR = np.array([13.0, 16.0, 20.0, 25.0, 31.0, 39.0, 49.0])
"""Distances of labels of a crowd if nothing nearer is free [mm]."""
LEAST = tuple(_LEADER + _FARTHER * float(rings[0]) for rings in (_LED, _FAR))
"""No place on a leader costs less, none on a longer one."""
_LED_ALONG = (0.5, 0.38, 0.62, 0.26, 0.74, 0.14, 0.86)  # places along a line for the end of a leader
_OFF_MIDDLE = 1.5  # the cost of the whole length off the middle
_UPRIGHT, _LEANT = math.sin(math.radians(61)), 0.5  # a leader meets its line at the angle of this at least, a long one
LONGEST = 12.0  # no leader is longer [mm]
_ALONG = np.array([0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82, 0.1, 0.9])
_SPACE = 2.0  # beside and over a label [mm]
CRAMMED = 0.2  # a figure whose labels take a larger part of its room has no place for all of them
_SMALL, _TINY = 8.0, 2.0  # shorter arrows are small; of one under the second the head hides what it is [mm]
_ARROWS, _NODES = (10.0, 3), (8.0, 4)  # so many small arrows, or points, within so many millimetres are a knot
_TANGLED, _HIDDEN = 1.4, 4.0  # the burdens of such, where that of a label on a leader is 1
_POINT = 1.5  # a shorter line is a point [mm]
SIGN = 1.0  # of a sign that reaches farther, as a circle about more than a point, leaders end at the rim [mm]


class LabelCandidates(NamedTuple):
    """Candidate places of a label, all as arrays (n,).

    middle  of the label's box, complex [mm]
    cost    what it costs
    anchor  where a leader would go, complex; nan where none is drawn
    """

    middle: Array
    cost: Array
    anchor: Array

    @property
    def led(self) -> Array:
        return ~np.isnan(self.anchor)

    @classmethod
    def joined(cls, parts: Iterable[LabelCandidates]) -> LabelCandidates:
        return cls(*map(np.concatenate, zip(*parts, strict=True)))


@frozen
class LabelRequest:
    """A label and what it names: a point (`start` only) or a line from start to end.

    gap   how far the symbol at the point, or the line's width, reaches [mm]
    away  the side it likes (any length; 0 for none)
    spare  1 where what it says can be read from other labels too, 2 where that is left out only if it lies on others
    of     the name of the arrow it names
    between  of an angle between two bars: beyond one it would be that of another
    parts  the label in parts that come with steps of their own; else it is one
    """

    label: Label
    start: Place
    end: Place | None = None
    gap: float = 0.75
    away: complex = 0j
    size: float = LABEL
    step: int | None = None
    spare: int = 0
    parts: tuple[tuple[Label, int | None], ...] = ()
    of: str = ""
    between: bool = False

    def about(self, middle: Place) -> Iterator[Text]:
        """Its letters about a place."""
        wide, up, down = box(self.label, self.size)
        at = middle + complex(-wide / 2, (up - down) / 2)
        for label, step in self.parts or ((self.label, self.step),):
            yield Text(label, at, self.size, step)
            at += width(label, self.size)

    @property
    def alone(self) -> LabelRequest:
        """The same with the first of its names alone: of a pole or an arrow, where its others are told elsewhere."""
        return replace(self, label=tuple(takewhile(lambda run: run.text not in (", ", " = "), self.label)), parts=())

    @cached_property
    def half(self) -> complex:
        """Half of the width and height of its box [mm]."""
        wide, up, down = box(self.label, self.size)
        return complex(wide, up + down) / 2

    @property
    def place(self) -> Place:
        """The point or line that it names, as one point."""
        return self.start if self.end is None else (self.start + self.end) / 2

    def named_in(self, circle: RoundRoom) -> bool:
        """True where what it names lies in a circle wholly."""
        return circle.holds(self.start, self.start if self.end is None else self.end)

    def near(self, half: complex, wide: bool = False) -> LabelCandidates:
        """Its places at what it names, wide: and a little farther off; half: of the size of what stands there [mm]."""
        if self.end is None or abs(self.end - self.start) <= _POINT:
            return _around(self.start, half, self, _WIDE if wide else _RINGS)
        far = _OFF_WIDE[: None if wide else len(_RINGS)]
        along = self.end - self.start  # both sides of the line, at several places along it
        away = self.away / abs(self.away) if self.away else 0j
        normal = np.array([along / abs(along) * -1j, along / abs(along) * 1j])[:, None, None]
        support = np.abs(normal.real) * half.real + np.abs(normal.imag) * half.imag
        liking = 0.6 * (1 - (normal * away.conjugate()).real) if away else np.where(normal.imag <= 0, 0.0, 0.1)
        middle = self.start + along * _ALONG + normal * (support + self.gap + far)
        cost = 1.2 * far + 2.5 * np.abs(_ALONG - 0.5) + liking
        return LabelCandidates(middle.ravel(), cost.ravel(), np.full(middle.size, _NOWHERE))

    def led(self, far: bool = False) -> LabelCandidates:
        """Its places on a leader about what it names, or on a longer one."""
        start, end, half, rings = self.start, self.end, self.half, _FAR if far else _LED
        if end is None or abs(end - start) <= _POINT:
            return _around(start, half, self, rings, led=True)
        anchors = [start + (end - start) * t for t in _LED_ALONG]
        every = LabelCandidates.joined(_around(anchor, half, self, rings, led=True) for anchor in anchors)
        off, along = every.middle - every.anchor, (end - start) / abs(end - start)
        inside = np.clip(off.real, -half.real, half.real) + 1j * np.clip(off.imag, -half.imag, half.imag)
        off -= inside  # from what it names to the near side of its box
        upright = np.abs((off * along.conjugate()).imag) >= (_LEANT if far else _UPRIGHT) * np.abs(off)
        aside = np.repeat(np.abs(np.array(_LED_ALONG) - 0.5), len(off) // len(_LED_ALONG))
        every = every._replace(cost=every.cost + _OFF_MIDDLE * aside)
        return LabelCandidates(*(part[upright] for part in every))


def lettering(wanted: Iterable[LabelRequest]) -> float:
    """The room that labels take, with what is usually free about them [mm^2]."""
    boxes = (box(want.label, want.size) for want in wanted)
    return sum((wide + _SPACE) * (up + down + _SPACE) for wide, up, down in boxes)


def tangled(wanted: Sequence[LabelRequest], tiny: float = _TINY) -> Array:
    """The burden of short arrows (n,), or of points, of which several lie close together, or that are hardly seen."""
    length = np.array([2 * abs(want.place - want.start) if want.of else np.inf for want in wanted])
    middle, burdens = np.array([want.place for want in wanted]), _HIDDEN * (length < tiny)
    nodes = np.array([want.end is None and want.gap < SIGN for want in wanted]) & np.isfinite(length).any()
    for kind, (reach, many) in ((length < _SMALL, _ARROWS), (nodes, _NODES)):
        near = (np.abs(middle[:, None] - middle) <= reach) & kind & kind[:, None]
        burdens = burdens + _TANGLED * (near.sum(axis=1) >= many)
    return np.asarray(burdens)


def _around(point: Place, half: complex, want: LabelRequest, rings: Array, led: bool = False) -> LabelCandidates:
    """Rings about a point; a box touches the ring with its near side or corner."""
    away = want.away.conjugate() / abs(want.away) if want.away else 0j
    liking = 0.8 * (1 - (_TURNS * away).real) if away else _LITTLE
    rim = point + (want.gap if want.gap > SIGN else 0) * np.tile(_TURNS, len(rings))
    middle = point + (want.gap + 0.6 + rings[:, None]) * _TURNS
    middle += _LEANING.real * half.real + 1j * (_LEANING.imag * half.imag)  # from what a box touches to its middle
    cost = _FARTHER * rings[:, None] + _LEADER * led + liking
    return LabelCandidates(middle.ravel(), cost.ravel(), rim if led else np.full(middle.size, _NOWHERE))
