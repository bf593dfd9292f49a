"""A label that wants a place, and where it may stand: around its point, along its line, or far off on a leader."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from graphkin.sheet.lettering import Label, width
from graphkin.sheet.marks import Place, Text
from graphkin.sheet.paper import LABEL
from graphkin.value import frozen

_RINGS = (0.0, 1.0, 2.2, 4.0, 6.5, 9.5, 13.0)
_LED = 4.0
"""From this ring on a leader is drawn."""
_TURNS = tuple(cmath.rect(1, math.tau * k / 16) for k in range(16))
_FAR_RINGS = (17.0, 21.5, 26.5, 32.0, 38.0, 44.5, 51.5, 59.0)
"""Where labels of a crowd go when nothing nearer is free [mm]."""
_FAR_TURNS = tuple(cmath.rect(1, math.tau * k / 32) for k in range(32))
_ANCHORS = (0.5, 0.3, 0.7)
"""Where along a line a far leader may end."""
_LED_ALONG = (0.3, 0.7)
"""Where else than at its middle a leader may meet an arrow."""
_OFF_MIDDLE = 0.5
_ALONG = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82)


class Candidate(NamedTuple):
    """A candidate: the middle of the label's box, what it costs, and where a leader would go."""

    middle: Place
    cost: float
    anchor: Place | None


@frozen
class Wanted:
    """A label and what it names: a point (`start` only) or a line from start to end.

    gap   how far the symbol at the point, or the line's width, reaches [mm]
    away  the side it likes (any length; 0 for none)
    spare  what it says can be read from other labels too
    of     the name of the arrow it names
    parts  the label in parts that come with steps of their own; else it is one
    """

    label: Label
    start: Place
    end: Place | None = None
    gap: float = 0.75
    away: complex = 0j
    size: float = LABEL
    step: int | None = None
    spare: bool = False
    parts: tuple[tuple[Label, int | None], ...] = ()
    of: str = ""

    def texts(self, at: Place) -> Iterator[Text]:
        """Its letters, from the left end of the base line."""
        for label, step in self.parts or ((self.label, self.step),):
            yield Text(label, at, self.size, step)
            at += width(label, self.size)

    @property
    def place(self) -> Place:
        """What it names, as one point."""
        return self.start if self.end is None else (self.start + self.end) / 2

    def candidates(self, half: complex) -> Iterator[Candidate]:
        """Where it may stand near what it names; half: of the width and height of its box [mm]."""
        if self.end is not None and abs(self.end - self.start) > 1.5:
            yield from _beside(self.start, self.end, half, self)
            yield from _around((self.start + self.end) / 2, half, self, first=3)
            if self.of:
                for t in _LED_ALONG:
                    for spot in _around(self.start + (self.end - self.start) * t, half, self, first=3):
                        yield spot._replace(cost=spot.cost + _OFF_MIDDLE)
        else:
            yield from _around(self.start, half, self)

    def far_candidates(self, half: complex, crowd: Place) -> Iterator[Candidate]:
        """Wide rings, away from the middle of the crowd first."""
        ends = (self.start, self.start if self.end is None else self.end)
        for anchor in dict.fromkeys(ends[0] + (ends[1] - ends[0]) * t for t in _ANCHORS):
            away = (anchor - crowd).conjugate() / max(abs(anchor - crowd), 1e-9)
            for turn in _FAR_TURNS:
                side = complex(_held(turn.real) * half.real, _held(turn.imag) * half.imag)
                liking = 5.0 * (1 - (turn * away).real)
                for ring in _FAR_RINGS:
                    yield Candidate(anchor + (self.gap + 0.6 + ring) * turn + side, 1.6 * ring + 6 + liking, anchor)


def _around(point: Place, half: complex, want: Wanted, first: int = 0) -> Iterator[Candidate]:
    """Rings about a point; a box touches the ring with its near side or corner."""
    away = want.away.conjugate() / abs(want.away) if want.away else 0j
    likings = [0.8 * (1 - (turn * away).real) if away else 0.05 * ((k - 14) % 16) for k, turn in enumerate(_TURNS)]
    sides = [complex(_held(turn.real) * half.real, _held(turn.imag) * half.imag) for turn in _TURNS]
    for ring in _RINGS[first:]:
        reach = want.gap + 0.6 + ring
        price, anchor = (1.6 * ring + 6, point) if ring >= _LED else (1.6 * ring, None)
        for turn, side, liking in zip(_TURNS, sides, likings):
            yield Candidate(point + reach * turn + side, price + liking, anchor)


def _held(x: float) -> float:
    """Cosine or sine of a direction, so that four of eight directions put the box's corners to the ring."""
    return max(-1.0, min(1.0, x * 1.6))


def _beside(start: Place, end: Place, half: complex, want: Wanted) -> Iterator[Candidate]:
    """Both sides of a line, at several places along it."""
    along = (end - start) / abs(end - start)
    away = want.away / abs(want.away) if want.away else 0j
    for normal in (along * -1j, along * 1j):
        support = abs(normal.real) * half.real + abs(normal.imag) * half.imag
        liking = 0.6 * (1 - (normal * away.conjugate()).real) if away else (0.0 if normal.imag <= 0 else 0.1)
        for more in (0.0, 0.75, 1.65):
            for t in _ALONG:
                middle = start + (end - start) * t + normal * (support + want.gap + more)
                yield Candidate(middle, 1.2 * more + 2.5 * abs(t - 0.5) + liking, None)
