"""Labels find their places: none lies on a line, a vector or another label where there is room.

Each label has candidate places around its point or along its vector. All are held against everything drawn at once;
then the label with the fewest free places left chooses first, and takes the one nearest to what it names. The same
marks give the same places. Where nothing near is free, a thin leader goes to a place a little farther off. In a crowd
that leaves no place at all, labels make way for one another, and at last those that say nothing new are left out.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from copy import copy
from typing import NamedTuple

import numpy as np

from graphkin.base.boxes import overlap
from graphkin.base.geometry import Array
from graphkin.sheet.label_candidates import FAR, LED, MANY, NEAR, STRANGE, LabelScene
from graphkin.sheet.label_costs import LabelPlaces, LabelTable, together, under
from graphkin.sheet.label_requests import LEAST, LabelRequest
from graphkin.sheet.marks import Mark, Stroke

_TOUCH = 0.05  # closer than this to a box's edge is not yet on it [mm]
_MOST, _LEAST, _ALL = 80, 16, 8000
"""So many places of a label are kept in mind, fewer of each of many labels, and of all together."""
_FEW = 8  # for so many labels without a good place others make way
_PATIENCE, _WORK = 6, 900
"""A label may claim a place so often; less often in a crowd, of which so many labels are asked at most."""
_YIELDING = 0.002  # the cost of others that make way
_CHEAPER = 1.0  # a label moves where that saves more


class LabelPlacing:
    """Labels taking their places; stands: those that have one; _table: the choice; _spot: the one that each takes."""

    def __init__(self, scene: LabelScene, last: int) -> None:
        """last: the farthest tier in which labels look for places."""
        count = len(scene.wanted)
        self.scene, self._last = scene, last
        self.stands, self._spot = np.zeros(count, dtype=bool), np.zeros(count, dtype=np.intp)
        self._patience = min(_PATIENCE, _WORK // count)
        self._many = max(_LEAST, min(_MOST, _ALL // count))
        self._table = LabelTable(count, self._many)
        self._look(range(count))
        if last != NEAR:
            self._move()
            self.look_farther(last)

    def copy(self) -> LabelPlacing:
        other = copy(self)
        other._table, other.stands, other._spot = self._table.copy(), self.stands.copy(), self._spot.copy()
        return other

    def look_farther(self, last: int) -> None:
        """All move to better places, or look farther, as far as a tier; for the last few others make way."""
        self._last = last
        self._look_again(np.flatnonzero(self._now() > LEAST[0]))
        self._relieve()

    def _look(self, labels: Sequence[int]) -> None:
        """Labels look for places at what they name, then farther and farther off, where these cost less than that."""
        for tier, enough in enumerate([*LEAST[: self._last], np.inf]):
            others, offered = self.standing(), self.scene.places(labels, tier)
            for label, places in zip(labels, offered, strict=True):
                self._table.write(label, places.among(others).cheapest(self._many))
            if not (labels := self._greedy(labels, enough)):
                break

    def standing(self, labels: Array | None = None) -> LabelPlaces:
        """The places of all that have one, or of some of them."""
        labels = np.flatnonzero(self.stands) if labels is None else labels
        return self._table.taken(labels, self._spot[labels])

    def _put(self, label: int, spot: int | None = None) -> None:
        """A label takes one of its places, the cheapest."""
        self._spot[label] = int(np.argmin(self._table.cost[label])) if spot is None else spot
        self.stands[label] = True
        self._table.burden(label, self._spot[label], 1)

    def _lift(self, label: int) -> None:
        self._table.burden(label, self._spot[label], -1)
        self.stands[label] = False

    def _greedy(self, labels: Sequence[int], enough: float) -> list[int]:
        """The label with the least freedom takes its best place first; one that finds none for so little waits."""
        waiting, put_off = np.array(labels, dtype=np.intp), []
        while len(waiting):
            left = np.count_nonzero(self._table.free[waiting], axis=1)
            best = self._table.cost[waiting].min(axis=1)
            next_ = int(np.lexsort((-best, left))[0])
            label = int(waiting[next_])
            waiting = waiting[waiting != label]
            if best[next_] > enough:
                put_off.append(label)
            else:
                self._put(label)
        return sorted(put_off)

    def _relieve(self) -> None:
        """Others make way for the last few labels without a good place, one after the other, as long as that helps."""
        before: tuple[int, float] | None = None
        while before is None or self._badness() < before:
            before, bad = self._badness(), np.flatnonzero(self._bad())
            for label in map(int, bad if len(bad) <= _FEW else ()):
                if self._bad()[label] and self._patience:
                    self._patience -= 1
                    self._claim(label)

    def _bad(self) -> Array:
        return self._now() >= STRANGE

    def _badness(self) -> tuple[int, float]:
        """The number of labels without a good place, and the cost of all."""
        return int(np.sum(self._bad())), float(self._now().sum())

    def _claim(self, label: int) -> None:
        """A label takes the place that is its best if others make way, and these look for new ones; if that helps."""
        before, kept = self._badness(), (self._table.copy(), self.stands.copy(), self._spot.copy())
        self._lift(label)
        [places] = self.scene.places([label], self._last)
        among = places.among(self.standing())
        liking = places.cost + _YIELDING * (among.cost - places.cost)
        liked = np.sort(np.argsort(liking)[: self._many])
        self._table.write(label, among.taken(liked))
        self._put(label, int(np.argmin(liking[liked])))
        others = np.flatnonzero(self.stands & (np.arange(len(self.stands)) != label))
        more, _ = together(self.standing(others), self.standing(np.array([label])))
        self._look_again(others[more >= STRANGE])
        if self._badness() >= before:
            self._table, self.stands, self._spot = kept

    def _look_again(self, labels: Array) -> None:
        """Some labels leave their places and look for others; then all move to better ones."""
        for label in labels.tolist():
            self._lift(label)
        self._look(labels.tolist())
        self._move()

    def _now(self) -> Array:
        return np.where(self.stands, self._table.cost[np.arange(len(self._spot)), self._spot], 0.0)

    def _move(self) -> None:
        """Whoever gains most by it takes a better place, until none gains much: all together cost less each time."""
        while True:
            gain = self._now() - self._table.cost.min(axis=1)
            label = int(np.argmax(np.where(self.stands, gain, 0.0)))
            if not self.stands[label] or gain[label] < _CHEAPER:
                break
            self._lift(label)
            self._put(label)

    def leave_out(self, labels: Collection[int]) -> None:
        """Some labels are not lettered; those without a good place, and all others, may stand where they would have."""
        for label in labels:
            self._lift(label)
        self._move()
        self._relieve()

    def unclear(self) -> list[int]:
        """Labels that do not tell what they name: on leaders, or beyond another line."""
        labels, arrows, wanted = np.flatnonzero(self.stands & self._bad()), self.scene.arrows, self.scene.wanted
        places, strange = self.standing(labels), np.zeros(len(labels), dtype=bool)
        start, end = places.places[2:, :, places.led].swapaxes(1, 2)
        strange[places.led] = arrows.unclear(wanted, labels[places.led], start, end) >= 1
        low, high = places.places[:2, :, ~places.led].swapaxes(1, 2)
        strange[~places.led] = arrows.strange(wanted, labels[~places.led], low, high)
        return [int(label) for label in labels[strange]]

    def clashing(self) -> list[int]:
        """Labels that lie on another or on something drawn, out of their room, or under a leader."""
        places = self.standing()
        low, high = places.low, places.high
        bad = ~self.scene.inside(low, high) | self.scene.known.touched(low + _TOUCH, high - _TOUCH)
        least, most = places.reach
        near = overlap(least[:, :, None], most[:, :, None], least[:, None], most[:, None])
        np.fill_diagonal(near, False)
        pair = one, other = np.nonzero(near)
        upper, lower = places.taken(one), places.taken(other)
        over = overlap(upper.low, upper.high, lower.low + _TOUCH, lower.high - _TOUCH) | under(upper, lower, 0.0)
        bad[np.concatenate(pair)[np.concatenate([over, over])]] = True
        return [int(label) for label in np.flatnonzero(self.stands)[bad]]


UNCLEAR, _MORE, _EASY = 3.0, 1.5, 4
"""The burden of a label without a good place, where one on a good leader is 1; of each beyond so many, in addition."""
_ROUNDS = 30  # some are left out so often, to give others a place
_NEIGHBOUR = 15.0  # so near to a label without a place, others that say nothing new are left out [mm]


class Settled(NamedTuple):
    """Labels and leaders at their places; clashing: labels that lie on something, or their leaders on labels; led: on
    leaders; unclear: those that do not tell what they name, or are long; places: from which to look farther."""

    marks: list[Mark]
    clashing: Sequence[int]
    led: Sequence[int] = ()
    unclear: Sequence[int] = ()
    places: LabelPlacing | None = None

    def burdens(self, wanted: Sequence[LabelRequest]) -> Array:
        """The burden of each label on the eye; one that says nothing new can be left out."""
        burdens = np.zeros(len(wanted))
        led, every = {*self.led} & {*self.unclear}, (*self.unclear, *self.clashing)
        for labels, weight in ((self.led, 1.0), (every, UNCLEAR / 2), ((*led, *self.clashing), UNCLEAR / 2)):
            burdens[[*labels]] += weight
        return np.minimum(burdens, [1.0 if want.spare == 1 else np.inf for want in wanted])


def burden(each: Array) -> float:
    """The burden of labels together: more than a few are heavier."""
    return float(each.sum() + _MORE * max(0, int(np.count_nonzero(each)) - _EASY))


def settle(scene: LabelScene, near: Settled | None = None) -> Settled:
    """The labels (and their leaders) at their places among what is drawn; near: as they stand where that is a crowd:
    now on nothing else at any price, and those that say nothing new left out for that."""
    if not scene.wanted:
        return Settled([], ())
    many = len(scene.wanted) > MANY  # of which no care helps those that have no room
    start = near and near.places
    places = start.copy() if start else LabelPlacing(scene, NEAR if many and scene.crammed else LED)
    if near and not many:
        places.look_farther(FAR)
    clashing, unclear = places.clashing(), places.unclear()
    for most in (1, 2) * _ROUNDS if near else ():
        bad = unclear if most == 1 else {*unclear} & {*_led(places)}  # on what is no leader it is near at least
        if out := _left_out(scene.wanted, places.stands, clashing, bad, most):
            places.leave_out(out)
            clashing, unclear = places.clashing(), places.unclear()
    return Settled([*_lettered(scene.wanted, places)], clashing, _led(places), unclear, places)


def _led(places: LabelPlacing) -> list[int]:
    """The labels on leaders."""
    return [int(label) for label in np.flatnonzero(places.stands)[places.standing().led]]


def _lettered(wanted: Sequence[LabelRequest], places: LabelPlacing) -> Iterator[Mark]:
    standing = places.standing()
    for label, (low, high, begin, anchor), led in zip(
        np.flatnonzero(places.stands).tolist(), np.moveaxis(standing.places, 2, 0), standing.led, strict=True
    ):
        want = wanted[label]
        yield from want.about(complex(*(low + high) / 2))
        if led:
            edge, at = complex(*begin), complex(*anchor)
            apart = abs(at - edge)
            yield Stroke((edge + (at - edge) * 0.3 / apart if apart > 1 else edge, at), "leader", step=want.step)


def _left_out(
    wanted: Sequence[LabelRequest], stands: Array, clashing: Sequence[int], unclear: Collection[int], most: int
) -> list[int]:
    """The spare ones, so far at most, of labels without a clear place, else those beside them; none close together."""
    places = [want.place for want in wanted]

    def close(label: int, others: Sequence[int]) -> bool:
        return any(abs(places[label] - places[other]) < _NEIGHBOUR for other in others)

    spare = [k for k, want in enumerate(wanted) if 0 < want.spare <= most and stands[k]]
    chosen: list[int] = []
    if len(clashing) > MANY:
        return [k for k in spare if k in clashing]
    bad = {*clashing, *unclear}
    for label in [k for k in spare if k in bad] or [k for k in spare if close(k, clashing)]:
        if not close(label, chosen):
            chosen.append(label)
    return chosen
