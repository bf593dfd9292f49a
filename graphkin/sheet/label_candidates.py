"""The candidate places of a figure's labels, and what lies about each; rated only where they are asked for.

Most labels stand where they would like to. So the places at what they name come first, for all labels at once; those
on a leader only for labels that find none there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from functools import cached_property
from itertools import chain, pairwise

import numpy as np

from graphkin.base.boxes import cross_some, off_boxes, off_lines, xy
from graphkin.base.geometry import Array
from graphkin.base.rooms import Room
from graphkin.base.segments import Segments
from graphkin.base.value import filled
from graphkin.sheet.label_costs import LabelPlaces
from graphkin.sheet.label_requests import CRAMMED, LONGEST, SIGN, LabelCandidates, LabelRequest, lettering
from graphkin.sheet.marks import Mark, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.obstacles import obstacles
from graphkin.sheet.symbols import HINGE

_NEARER = 0.3  # by so much, to the eye [mm]
_OFF = 3.0  # letters farther off a point are not beside it [mm]
_SHORTEST = 0.1  # shorter arrows are points [mm]
_OWN, _SAME = 2.0, 0.15
"""A leader ends so far from what is not its own at least; closer than the second, points are one [mm]."""
_ASIDE, _PARALLEL = 0.9, 0.05  # so far apart arrows on one line are told apart [mm]; the sine of their angle

NEAR, LED, FAR = range(3)
"""Places at what a label names, on a leader about that, and on a longer one."""
MANY = 150  # more labels than this are a crowd that no care relieves
_KEPT = 240  # so many places of a label are kept at most, the cheapest
_CLEAR, _EASY, _WHOLE = 0.45, 1.3, 0.8
"""The distance of a label from lines at least, the one it likes, and that from a line that else gives way [mm]."""
_AIR, _ROW = 2.0, 2.0
"""From rows of equations and tables to labels, which would read as one more if nearer; no row is lower [mm]."""
STRANGE = 100.0  # the cost of standing beyond another line or nearer to another arrow, or on an unclear leader
_OVER = 0.4  # so much of that is the cost of a leader that is unclear only since it goes over another arrow
_ON, _LINE, _OUTSIDE, _CLOSE = 5, 400.0, 5000.0, 0.45
"""Of lying on so many lines at most, of each; out of the room; close to a line."""
_COVERED, _LETTERED, _CROSSED = 5.0, 250.0, 1.5
"""Of lying on a line that gives way to letters; of a leader through letters, and over each line."""


@filled
class LabelScene:
    """Labels that want a place, and all that is drawn where they want it; giving_way: lines that are drawn only where
    letters have left room; beside: equations and tables, and their rooms."""

    wanted: Sequence[LabelRequest]
    drawn: Sequence[Mark]
    room: Room
    giving_way: Sequence[Mark] = ()
    beside: Sequence[tuple[Room, Sequence[Mark]]] = ()
    _seen: dict[tuple[int, int], LabelPlaces] = field(default_factory=dict)

    @property
    def crammed(self) -> bool:
        """True where so much is to be lettered that some labels will lie on others."""
        size = self.room.size
        return lettering(self.wanted) > CRAMMED * size.real * size.imag

    @cached_property
    def known(self) -> Segments:
        return obstacles([*self.drawn, *self.rows])

    @cached_property
    def letters(self) -> Segments:
        """Obstacles that let no leader through."""
        every = chain(self.drawn, *(marks for _, marks in self.beside))
        return obstacles((mark for mark in every if isinstance(mark, Text)), hollow=True)

    @property
    def taken(self) -> list[Room]:
        """Rooms where letters stand already."""
        return [room for room, marks in self.beside if marks]

    @cached_property
    def rows(self) -> list[Mark]:
        """Lines through all that is taken, and about it, for its letters."""
        return [Stroke(room.inset(-_AIR, -_AIR / 2, -_AIR).meander(_ROW)) for room in self.taken]

    @cached_property
    def arrows(self) -> Arrows:
        return Arrows(self.drawn)

    def places(self, labels: Sequence[int], tier: int) -> list[LabelPlaces]:
        """Those of some labels up to a tier, as if they were alone; rated only once."""
        new = [label for label in labels if (label, tier) not in self._seen]
        if new:
            nearer = [[places] for places in self.places(new, tier - 1)] if tier else [[] for _ in new]
            for label, own, before in zip(new, self._rated(new, tier), nearer, strict=True):
                self._seen[label, tier] = LabelPlaces.joined([*before, own]).cheapest(_KEPT)
        return [self._seen[label, tier] for label in labels]

    def _rated(self, labels: Sequence[int], tier: int) -> list[LabelPlaces]:
        """The places of one tier, for many labels at once: those in the room, or anywhere for one that has none."""
        near, wanted = tier == NEAR, [self.wanted[label] for label in labels]
        every = [want.near(want.half, wide=True) if near else want.led(tier == FAR) for want in wanted]
        counts, spots = [len(each.cost) for each in every], LabelCandidates.joined(every)
        owner, half = np.repeat(labels, counts), xy(np.repeat([want.half for want in wanted], counts))
        middle = xy(spots.middle)
        low, high, anchor = middle - half, middle + half, xy(np.where(spots.led, spots.anchor, spots.middle))
        places, inside = np.array([low, high, np.clip(anchor, low, high), anchor]), self.inside(low, high)
        rows = np.flatnonzero(inside | ~np.isin(owner, owner[inside]))
        owner, places, inside, cost = owner[rows], places.take(rows, axis=2), inside[rows], spots.cost[rows]
        (low, high), leader = places[:2], places[2:]
        close, hits = self.known.around(low, high, (_EASY, _CLEAR))
        cost = cost + _CLOSE * np.minimum(close, _ON + 1) + _LINE * np.minimum(hits, _ON) + _OUTSIDE * ~inside
        if self.giving_way:
            cost += _COVERED * np.minimum(self._covered.around(low, high, (_WHOLE,))[0], 2)
        free = inside & (hits == 0)
        rows = np.flatnonzero(free)
        if near:
            strange = self.arrows.strange(self.wanted, owner[rows], low[:, rows].T, high[:, rows].T)
        else:
            start, end = leader.take(rows, axis=2)
            strange = self.arrows.unclear(self.wanted, owner[rows], start.T, end.T)
            cost[rows] += _CROSSED * self.known.crossed(start, end) + _LETTERED * (self.letters.crossed(start, end) > 0)
        cost[rows] += STRANGE * strange
        free[rows] &= strange == 0
        all_ = LabelPlaces(places, np.full(len(cost), not near), cost, free)
        return [all_.taken(np.flatnonzero(owner == label)) for label in labels]

    @cached_property
    def _covered(self) -> Segments:
        return obstacles(self.giving_way)

    def inside(self, low: Array, high: Array) -> Array:
        """Those of the boxes low..high (2, n) that lie in the room."""
        room = self.room
        below = (high[0] <= room.right) & (high[1] <= room.bottom)
        return np.asarray((low[0] >= room.left) & (low[1] >= room.top) & below)


class Arrows:
    """The arrows of a figure, and sides of images: a label is to be nearer to its own than to others, none between."""

    def __init__(self, drawn: Sequence[Mark]) -> None:
        lines = [(mark.name, mark.start, mark.end) for mark in drawn
                 if isinstance(mark, VectorMark) and mark.length > _SHORTEST]  # fmt: skip
        bars = [(mark.shows.plane, mark) for mark in drawn
                if isinstance(mark, Stroke) and mark.shows and mark.shows.form == "bar"]  # fmt: skip
        lines += [("", mark.places[0], mark.places[1]) for plane, mark in bars if plane != "position"]
        sides = [side for plane, mark in bars if plane == "position" for side in pairwise(mark.outline)]
        self.points = np.array([mark.at for mark in drawn if isinstance(mark, PointMark)], dtype=complex)
        self.names = np.array([name for name, *_ in lines])
        self.start, self.end = np.array([ends for _, *ends in lines], dtype=complex).reshape(-1, 2).T
        self.bars = np.array(sides, dtype=complex).reshape(-1, 2).T

    def hold(self, want: LabelRequest) -> Array:
        """The arrows on which all that a label names lies."""
        places = np.array([[want.start], [want.place]])
        return np.asarray((abs(off_lines(places, self.start, self.end)) < _SHORTEST).all(axis=0))

    def strange(self, wanted: Sequence[LabelRequest], owner: Array, low: Array, high: Array) -> Array:
        """Boxes low..high of labels that stand beyond another line than their owner's, or nearer to another arrow; or
        farther off its point and nearer to another one."""
        strange = np.zeros(len(owner), dtype=bool)
        for k in sorted(set(owner.tolist())):
            want, rows = wanted[k], np.flatnonzero(owner == k)
            own, middle = self.names == want.of, (low[rows] + high[rows]) @ (0.5, 0.5j)
            if want.of and own.any():
                own |= self.hold(want)  # arrows that lie on one another are one line
                apart = off_boxes(low[rows, None], high[rows, None], self.start, self.end)
                strange[rows] = apart[:, own].min(axis=1) > apart[:, ~own].min(axis=1, initial=np.inf) - _NEARER
                off = off_lines(middle, want.start, 2 * want.place - want.start)
                strange[rows] |= cross_some(middle, middle - off, self.start[~own], self.end[~own])
            elif want.end is None:
                places = np.array([want.start, *self.points[np.abs(self.points - want.start) > _SAME]])
                off = np.maximum(low[rows, None] - xy(places).T, xy(places).T - high[rows, None])
                apart = np.hypot(*np.maximum(off, 0.0).transpose(2, 0, 1))
                least = apart[:, 1:].min(axis=1, initial=np.inf) - _NEARER
                strange[rows] = (apart[:, 0] > want.gap + _OFF) & (apart[:, 0] > least)
                own[:] = want.gap >= SIGN  # a circle is about many lines
                lines = np.array([self.start, self.end])[:, ~own]
                if want.between or 0 < want.gap <= HINGE:  # it is not beyond a bar either
                    lines = np.concatenate([lines, self.bars], axis=1)
                strange[rows] |= cross_some(middle, np.full(len(rows), want.start), *lines)
        return strange

    def unclear(self, wanted: Sequence[LabelRequest], owner: Array, start: Array, end: Array) -> Array:
        """1 of leaders start..end (n, 2) that are long or end at what is not their owner's, less of those over it."""
        start, end = (places @ (1, 1j) for places in (start, end))
        unclear, over = np.abs(end - start) > LONGEST, np.zeros(len(owner))
        for k in sorted(set(owner.tolist())):
            rows, want = np.flatnonzero(owner == k), wanted[k]
            points = np.abs(end[rows, None] - self.points)
            unclear[rows] |= ((points < _OWN) & ((points > _SAME) | (want.end is not None))).any(axis=1)
            others = self.names != want.of
            over[rows] = cross_some(start[rows], end[rows], self.start[others], self.end[others])
            if want.of and want.end is not None and others.any():
                unclear[rows] |= self._beside(want.end - want.start, start[rows], end[rows], others)
        return np.maximum(unclear, _OVER * over)

    def _beside(self, own: complex, start: Array, end: Array, others: Array) -> Array:
        """Leaders that end close to some arrows, but for parallel ones on the other side of their own."""
        first, last = self.start[others], self.end[others]
        along, off = last - first, off_lines(end[:, None], first, last)
        apart, side = np.abs(off), ((start - end) * own.conjugate()).imag[:, None] * (off * own.conjugate()).imag
        parallel = np.abs((along * own.conjugate()).imag) < _PARALLEL * np.abs(along) * abs(own)
        return np.asarray(((apart < _OWN) & ~(parallel & (apart > _ASIDE) & (side > 0))).any(axis=1))
