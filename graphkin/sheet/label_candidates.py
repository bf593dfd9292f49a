"""The candidate places of a figure's labels, and what lies about each; rated only where they are asked for.

Most labels stand where they would like to. So the places at what they name come first, for all labels at once; those
on a leader only for labels that find none there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import filled
from graphkin.sheet.boxes import OccupiedSquares, xy
from graphkin.sheet.label_requests import CRAMMED, LONGEST, LabelCandidates, LabelRequest, lettering
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import Mark, PointMark, Text, VectorMark
from graphkin.sheet.obstacles import Obstacles, obstacles, places
from graphkin.sheet.paper import Room

_NEARER = 0.3  # by so much, to the eye [mm]
_SHORTEST = 0.1  # shorter arrows are points [mm]
_OWN, _SAME = 2.0, 0.15
"""A leader ends so far from what is not its own at least; closer than the second, points are one [mm]."""
_ASIDE, _PARALLEL = 0.9, 0.05  # so far apart arrows on one line are told apart [mm]; the sine of their angle

NEAR, WIDE, LED, FAR = range(4)
"""Places at what a label names, a little farther off, on a leader about that, and on a longer one."""
MANY = 150  # more labels than this are a crowd that no care relieves
_FEWER = 6  # of the places of a crowd beyond help one in so many is rated
_CELL = 1.0  # the size of the squares that surely hold something [mm]
_CLEAR, _EASY = 0.45, 1.3
"""The distance of a label from lines at least, and the one it likes [mm]."""


class Boxes(NamedTuple):
    """Boxes of labels, and leaders of those that are led.

    places  corners low and high of each, where its leader begins and ends (4, 2, n) [mm]; without one, the box's middle
    """

    places: Array
    led: Array

    @classmethod
    def of(cls, spots: LabelCandidates, half: Array) -> Boxes:
        middle, half = xy(spots.middle), xy(half)
        low, high, anchor = middle - half, middle + half, xy(np.where(spots.led, spots.anchor, spots.middle))
        return cls(np.array([low, high, np.clip(anchor, low, high), anchor]), spots.led)

    def taken(self, rows: Array | list[int]) -> Boxes:
        """Some of them; numpy takes numbered columns several times as fast as it indexes them."""
        return Boxes(self.places.take(rows, axis=2), self.led.take(rows))

    def some(self, rows: Array) -> Boxes:
        """The same; a single one is that of all rows."""
        return self if len(self.led) == 1 else self.taken(rows)

    @classmethod
    def joined(cls, parts: Iterable[Boxes]) -> Boxes:
        places, led = zip(*parts, strict=True)
        return cls(np.concatenate(places, axis=-1), np.concatenate(led))

    @property
    def low(self) -> Array:
        return np.asarray(self.places[0])

    @property
    def high(self) -> Array:
        return np.asarray(self.places[1])

    @property
    def leader(self) -> Array:
        """Its two ends (2, 2, n)."""
        return np.asarray(self.places[2:])

    @property
    def reach(self) -> tuple[Array, Array]:
        """Corners of what boxes and leaders lie in (2, n)."""
        return np.minimum(self.low, self.places[3]), np.maximum(self.high, self.places[3])


class Rated(NamedTuple):
    """Candidates, row by row, with their costs and their surroundings.

    cost      what each costs by itself; near: how many things are too near to it; hits: on how many it lies
    strange   nearer to another arrow than to its own, or its leader is unclear; inside: in the room
    lettered  its leader passes through letters; lines: how many things it crosses, where that was asked
    """

    boxes: Boxes
    cost: Array
    near: Array
    hits: Array
    strange: Array
    inside: Array
    lettered: Array
    lines: Array

    def taken(self, rows: Array) -> Rated:
        return Rated(self.boxes.taken(rows), *(each[rows] for each in self[1:]))

    @classmethod
    def joined(cls, parts: Sequence[Rated]) -> Rated:
        if len(parts) == 1:
            return parts[0]
        boxes = Boxes.joined(part.boxes for part in parts)
        return cls(boxes, *map(np.concatenate, zip(*(part[1:] for part in parts), strict=True)))

    def parted(self, counts: Array | list[int]) -> Iterator[Rated]:
        """So many of them each time."""
        for end, count in zip(np.cumsum(counts), counts, strict=True):
            boxes = Boxes(self.boxes.places[:, :, end - count : end], self.boxes.led[end - count : end])
            yield Rated(boxes, *(each[end - count : end] for each in self[1:]))

    @property
    def free(self) -> Array:
        """Those that touch nothing."""
        return np.asarray((self.hits == 0) & self.inside & ~self.strange)


@filled
class LabelScene:
    """Labels that want a place, and all that is drawn where they want it."""

    wanted: Sequence[LabelRequest]
    drawn: Sequence[Mark]
    room: Room
    beneath: LabelScene | None = None
    _seen: dict[tuple[int, int], Rated] = field(default_factory=dict)
    _crossing: set[tuple[int, int]] = field(default_factory=set)

    def under(self, marks: Sequence[Mark]) -> LabelScene:
        """The same under some more lines."""
        return LabelScene(self.wanted, marks, self.room, self)

    @property
    def crammed(self) -> bool:
        """True where so much is to be lettered that some labels will lie on others."""
        size = self.room.size
        return lettering(self.wanted) > CRAMMED * size.real * size.imag

    @cached_property
    def beyond_help(self) -> bool:
        """True where very many labels have no room, so that no care helps."""
        return len(self.wanted) > MANY and self.crammed

    @cached_property
    def known(self) -> Obstacles:
        return obstacles(self.drawn)

    @cached_property
    def occupied(self) -> OccupiedSquares:
        """Squares that labels that look farther off need no closer look at."""
        return OccupiedSquares(places(self.drawn), _CELL)

    @cached_property
    def letters(self) -> Obstacles:
        """Obstacles that let no leader through."""
        return obstacles(mark for mark in self.drawn if isinstance(mark, Text))

    @cached_property
    def arrows(self) -> Arrows:
        return Arrows(self.drawn) if self.beneath is None else self.beneath.arrows

    def touched(self, low: Array, high: Array) -> Array:
        """Rows of the boxes low..high (n, 2) that touch something, once for each thing touched."""
        rows = self.known.touched(low, high)
        return rows if self.beneath is None else np.concatenate([rows, self.beneath.touched(low, high)])

    def crossed(self, start: Array, end: Array) -> Array:
        """Rows of the leaders start..end (n, 2) that cross something, once for each thing crossed."""
        rows = self.known.crossed(start, end)
        return rows if self.beneath is None else np.concatenate([rows, self.beneath.crossed(start, end)])

    @cached_property
    def halves(self) -> Array:
        """Half the width and height of each label's box, complex [mm]."""
        boxes = (box(want.label, want.size) for want in self.wanted)
        return np.array([complex(wide, up + down) / 2 for wide, up, down in boxes], dtype=complex)

    def rated(self, labels: Iterable[int], tier: int, lines: bool = False) -> list[Rated]:
        """The candidates of some labels up to a tier; lines: with what leaders cross."""
        labels = list(labels)
        for each in range(tier + 1):
            self._see([label for label in labels if (label, each) not in self._seen], each)
            if lines and each >= LED:
                self._cross([label for label in labels if (label, each) not in self._crossing], each)
        every = [Rated.joined([self._seen[label, each] for each in range(tier + 1)]) for label in labels]
        # those in the room, where there are such
        return [rated.taken(np.flatnonzero(rated.inside)) if rated.inside.any() and not rated.inside.all() else rated
                for rated in every]  # fmt: skip

    def _see(self, labels: Sequence[int], tier: int) -> None:
        """Candidates of one tier of some labels, all at once."""
        if not labels:
            return
        if self.beneath is None:
            counts, rated = self._rated(labels, tier)
        else:
            self.beneath._see([label for label in labels if (label, tier) not in self.beneath._seen], tier)
            parts = [self.beneath._seen[label, tier] for label in labels]
            counts, rated = np.array([len(part.cost) for part in parts]), Rated.joined(parts)
            near, hits = self.known.around(rated.boxes.low, rated.boxes.high, (_EASY, _CLEAR))
            rated = rated._replace(near=rated.near + near, hits=rated.hits + hits)
        for label, part in zip(labels, rated.parted(counts), strict=True):
            self._seen[label, tier] = part

    def _cross(self, labels: Sequence[int], tier: int) -> None:
        """Count the crossings of the leaders of one tier, of some labels at once; of boxes that lie on nothing."""
        if not labels:
            return
        parts = [self._seen[label, tier] for label in labels]
        rated = Rated.joined(parts)
        rows = np.flatnonzero(rated.inside & (rated.hits == 0))
        start, end = rated.boxes.leader.take(rows, axis=2).swapaxes(1, 2)
        lines = np.zeros(len(rated.cost))
        lines[rows] = np.bincount(self.crossed(start, end), minlength=len(rows))
        rated = rated._replace(lines=lines)
        for label, part in zip(labels, rated.parted([len(part.cost) for part in parts]), strict=True):
            self._seen[label, tier] = part
            self._crossing.add((label, tier))

    def _rated(self, labels: Sequence[int], tier: int) -> tuple[Array, Rated]:
        """The number of candidates of each label in the room, or anywhere where it has none there; and all of them.
        Farther off, none that surely lies on something, where it has others."""
        spots, thinned = list[LabelCandidates](), slice(None, None, _FEWER if self.beyond_help else 1)
        for want, half in ((self.wanted[label], complex(self.halves[label])) for label in labels):
            each = want.led(half, tier == FAR) if tier >= LED else want.near(half, tier == WIDE)
            spots.append(LabelCandidates(*(part[thinned] for part in each)))
        owner, every = np.repeat(labels, [len(each.cost) for each in spots]), LabelCandidates.joined(spots)
        boxes = Boxes.of(every, self.halves[owner])
        inside = self.inside(boxes)
        clear = inside if tier == NEAR else inside & ~self.occupied.within(boxes.low, boxes.high)
        rows = np.flatnonzero(clear | ~np.isin(owner, owner[clear]))
        owner, inside, boxes = owner[rows], inside[rows], boxes.taken(rows)
        near, hits = self.known.around(boxes.low, boxes.high, (_EASY, _CLEAR))
        free = np.flatnonzero(inside & (hits == 0))
        strange, lettered = np.zeros(len(rows), dtype=bool), np.zeros(len(rows), dtype=bool)
        if tier < LED:
            corners = boxes.low[:, free].T, boxes.high[:, free].T
            strange[free] = self.arrows.strange(self.wanted, owner[free], *corners, points=tier == WIDE)
        else:
            start, end = boxes.leader.take(free, axis=2).swapaxes(1, 2)
            lettered[free[self.letters.crossed(start, end)]] = True
            strange[free] = self.arrows.unclear(self.wanted, owner[free], start, end)
        rated = Rated(boxes, every.cost[rows], near, hits, strange, inside, lettered, np.zeros(len(rows)))
        return np.bincount(owner, minlength=len(self.wanted))[labels], rated

    def inside(self, boxes: Boxes) -> Array:
        """Those in the room."""
        room, low, high = self.room, boxes.low, boxes.high
        below = (high[0] <= room.right) & (high[1] <= room.bottom)
        return np.asarray((low[0] >= room.left) & (low[1] >= room.top) & below)


class Arrows:
    """The arrows of a figure, by name: a label is to be nearer to its own than to all others."""

    def __init__(self, drawn: Iterable[Mark]) -> None:
        drawn = [*drawn]
        vectors = [mark for mark in drawn if isinstance(mark, VectorMark) and mark.length > _SHORTEST]
        self.points = np.array([mark.at for mark in drawn if isinstance(mark, PointMark)], dtype=complex)
        self.names = np.array([vector.name for vector in vectors])
        self.start = np.array([vector.start for vector in vectors], dtype=complex)
        self.end = np.array([vector.end for vector in vectors], dtype=complex)

    def _hold(self, want: LabelRequest) -> Array:
        """The arrows on which all that a label names lies."""
        places, along = np.array([want.start, want.place]), self.end - self.start
        part = np.clip(((places[:, None] - self.start) / along).real, 0, 1)
        return np.asarray((np.abs(self.start + part * along - places[:, None]) < _SHORTEST).all(axis=0))

    def strange(
        self, wanted: Sequence[LabelRequest], owner: Array, low: Array, high: Array, points: bool = False
    ) -> Array:
        """Boxes low..high of labels that stand nearer to an arrow (points: to any point) that is not their owner's."""
        strange = np.zeros(len(owner), dtype=bool)
        for k in sorted(set(owner.tolist())):
            want, rows = wanted[k], np.flatnonzero(owner == k)
            own = self.names == want.of
            if want.of and own.any():
                own |= self._hold(want)  # arrows that lie on one another are one line
                apart = self._apart(low[rows, None], high[rows, None])
                strange[rows] = apart[:, own].min(axis=1) > apart[:, ~own].min(axis=1, initial=np.inf) - _NEARER
            elif points and want.end is None:
                places = np.array([want.start, *self.points[np.abs(self.points - want.start) > _SAME]])
                off = np.maximum(low[rows, None] - xy(places).T, xy(places).T - high[rows, None])
                apart = np.hypot(*np.maximum(off, 0.0).transpose(2, 0, 1))
                strange[rows] = apart[:, 0] > apart[:, 1:].min(axis=1, initial=np.inf) - _NEARER
        return strange

    def unclear(self, wanted: Sequence[LabelRequest], owner: Array, start: Array, end: Array) -> Array:
        """Leaders start..end (n, 2) that are long, or end too close to another arrow or point than their owner's."""
        start, end = (places @ (1, 1j) for places in (start, end))
        unclear = np.abs(end - start) > LONGEST
        for k in sorted(set(owner.tolist())):
            rows, want = np.flatnonzero(owner == k), wanted[k]
            points = np.abs(end[rows, None] - self.points)
            unclear[rows] |= ((points < _OWN) & ((points > _SAME) | (want.end is not None))).any(axis=1)
            others = self.names != want.of
            if want.of and want.end is not None and others.any():
                unclear[rows] |= self._beside(want.end - want.start, start[rows], end[rows], others)
        return unclear

    def _beside(self, own: complex, start: Array, end: Array, others: Array) -> Array:
        """Leaders that end close to some arrows, but for parallel ones on the other side of their own."""
        first, along = self.start[others], self.end[others] - self.start[others]
        off = end[:, None] - first
        part = np.clip((off * along.conj()).real / (along * along.conj()).real, 0.0, 1.0)
        off -= part * along  # from the near place of each
        apart, side = np.abs(off), ((start - end) * own.conjugate()).imag[:, None] * (off * own.conjugate()).imag
        parallel = np.abs((along * own.conjugate()).imag) < _PARALLEL * np.abs(along) * abs(own)
        return np.asarray(((apart < _OWN) & ~(parallel & (apart > _ASIDE) & (side > 0))).any(axis=1))

    def _apart(self, low: Array, high: Array) -> Array:
        """Distance of boxes (m, 1, 2) from the arrows (n,): (m, n); 0 where they meet."""
        (left, top), (right, bottom) = np.moveaxis(low, -1, 0), np.moveaxis(high, -1, 0)
        along = self.end - self.start
        distances = []
        for corner in (x + 1j * y for x in (left, right) for y in (top, bottom)):
            off = corner - self.start
            part = np.clip((off * along.conj()).real / (along * along.conj()).real, 0.0, 1.0)
            distances.append(np.abs(off - part * along))
        for end in (self.start, self.end):
            across = np.maximum(np.maximum(left - end.real, end.real - right), 0.0)
            distances.append(np.hypot(across, np.maximum(np.maximum(top - end.imag, end.imag - bottom), 0.0)))
        return np.asarray(np.minimum.reduce(distances))
