"""Labels find their places: none lies on a line, a vector or another label where there is room.

Each label has candidate places around its point or along its vector. All are held against everything drawn at once;
then the label with the fewest free places left chooses first, and takes the one nearest to what it names. The same
marks give the same places. Where nothing near is free, a thin leader goes to a place a little farther off. In a crowd
that leaves no place at all, labels make way for one another, and at last those that say nothing new are left out.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphkin.base.geometry import Array
from graphkin.sheet.boxes import overlap
from graphkin.sheet.label_candidates import LED, MANY, NEAR, Boxes, LabelScene
from graphkin.sheet.label_costs import CROWDED, NEARBY, LabelChoice, LabelTable, Prices, under
from graphkin.sheet.label_requests import LEAST, LabelRequest
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import Mark, Stroke

_TOUCH = 0.05  # closer than this to a box's edge is not yet on it [mm]
_MOST, _LEAST, _ALL = 80, 16, 8000
"""So many places of a label are kept in mind, fewer of each of many labels, and of all together."""
_FEW = 8  # for so many labels without a good place others make way
_PATIENCE, _WORK = 24, 900
"""A label may claim a place so often; less often in a crowd, of which so many labels are asked at most."""
_CHAIN = 3  # so many labels may claim places one after the other
_YIELDING = 0.02  # the cost of others that make way
_CHEAPER = 0.5  # a label moves where that saves more


class LabelPlacing:
    """Labels taking their places.

    boxes   of each label; stands: those that have a place
    _table  the places they choose from; _spot: the one that each takes
    _tier   of the places that each looks at; _patience: how often one may still claim a place
    _liked  the places that each would choose from up to a tier were it alone
    """

    def __init__(self, scene: LabelScene, last: int, prices: Prices) -> None:
        """last: the farthest tier in which labels look for places."""
        count = len(scene.wanted)
        self.scene, self.prices, self._last = scene, prices, last
        self.boxes = Boxes(np.zeros((4, 2, count)), np.zeros(count, dtype=bool))
        self.stands = np.zeros(count, dtype=bool)
        self._spot, self._tier = np.zeros(count, dtype=np.intp), np.full(count, NEAR)
        self._patience = min(_PATIENCE, _WORK // count)
        self._many = max(_LEAST, min(_MOST, _ALL // count))
        self._liked: dict[tuple[int, int], LabelChoice] = {}
        self._table = LabelTable(self._offered(range(count), NEAR), self._many)
        self._look_on(self._greedy(range(count)))
        if last != NEAR:  # all move to better places, or look farther; for the last few others make way
            self._move()
            bad = self._bad() if self._bad().sum() <= 3 * _FEW else False
            self._look_again(np.flatnonzero((self._now() > self._enough()) | bad))
            self._relieve()

    def _offered(self, labels: Sequence[int], tier: int) -> list[LabelChoice]:
        """The candidates of labels up to a tier that cost least as the others stand."""
        choices = self._alone(labels, tier)
        if not self.stands.any():
            return choices if tier == NEAR else [choice.cheapest(self._many) for choice in choices]
        others = self.boxes.taken(np.flatnonzero(self.stands))
        beside = self.prices.beside_others([choice.boxes for choice in choices], others)
        return [
            choice._replace(cost=choice.cost + more, free=choice.free & ~clash).cheapest(self._many)
            for choice, (more, clash) in zip(choices, beside, strict=True)
        ]

    def _alone(self, labels: Sequence[int], tier: int) -> list[LabelChoice]:
        """The candidates of labels up to a tier that cost least were they alone; each is asked for once."""
        new = [label for label in labels if (label, tier) not in self._liked]
        for label, rated in zip(new, self.scene.rated(new, tier, lines=self.prices.through > 0), strict=True):
            choice = LabelChoice(rated.boxes, self.prices.alone(rated), rated.free)
            self._liked[label, tier] = choice.cheapest(3 * self._many)
        return [self._liked[label, tier] for label in labels]

    # --- farther and farther ----------------------------------------------------------------------

    def _enough(self) -> Array:
        """The cost of each label above which it looks for farther places."""
        return np.where(self._tier < self._last, LEAST, np.inf)

    def _look_on(self, waiting: Sequence[int]) -> None:
        """For those that have found no good place."""
        while waiting:
            self._tier[waiting] = np.minimum(self._tier[waiting] + 1, self._last)
            for tier in set(self._tier[waiting]):
                some = [label for label in waiting if self._tier[label] == tier]
                for label, choice in zip(some, self._offered(some, tier), strict=True):
                    self._table.write(label, choice)
            waiting = self._greedy(waiting)

    # --- one after the other ----------------------------------------------------------------------

    def _burden(self, label: int, sign: int) -> None:
        """Add the cost of a label that stands here to the places of all others."""
        one = self.boxes.taken([label])
        numbers, others = self._table.about(*self.prices.reach(one), label)
        more, clash = self.prices.together(others, one)
        self._table.cost.ravel()[numbers] += sign * more
        self._table.free.ravel()[numbers[clash]] = False

    def _put(self, label: int, spot: int | None = None) -> None:
        """A label takes one of its places, the cheapest."""
        self._spot[label] = spot = int(np.argmin(self._table.cost[label])) if spot is None else spot
        self.boxes.places[:, :, label], self.boxes.led[label] = self._table.place(label, spot)
        self.stands[label] = True
        self._burden(label, 1)

    def _lift(self, label: int) -> None:
        """A label leaves its place."""
        self._burden(label, -1)
        self.stands[label] = False

    def _greedy(self, labels: Sequence[int]) -> list[int]:
        """The label with the least freedom takes its best place first; one that finds none for so little waits."""
        waiting, put_off, enough = np.array(labels), [], self._enough()
        while len(waiting):
            left = np.count_nonzero(self._table.free[waiting], axis=1)
            best = self._table.cost[waiting].min(axis=1)
            next_ = int(np.lexsort((-best, left))[0])
            label = int(waiting[next_])
            waiting = waiting[waiting != label]
            if best[next_] > enough[label]:
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
                    self._claim_by_turns(label)

    def _claim_by_turns(self, label: int) -> None:
        """A label claims its place, and who loses its own by that does the same, if that leaves all better."""
        before, bad, table = self._badness(), self._bad(), self._table.copy()
        kept = [each.copy() for each in (*self.boxes, self.stands, self._spot, self._tier)]
        for _ in range(_CHAIN):
            self._claim(label)
            if self._badness() < before:
                return
            lost = np.where(self._bad() & ~bad, self._now(), 0.0)
            label = int(np.argmax(lost))
            if not lost[label]:
                break
        places, led, self.stands, self._spot, self._tier = kept
        self.boxes, self._table = Boxes(places, led), table

    def _bad(self) -> Array:
        """Labels that have no good place."""
        return self._now() > self.prices.strange

    def _badness(self) -> tuple[int, float]:
        """The number of labels without a good place, and the cost of all."""
        return int(np.sum(self._bad())), float(self._now().sum())

    def _claim(self, label: int) -> None:
        """A label takes the place that is its best if others make way; these look for new ones."""
        self._lift(label)
        self._tier[label] = self._last
        [choice] = self._alone([label], self._last)
        [(more, _)] = self.prices.beside_others([choice.boxes], self.boxes.taken(np.flatnonzero(self.stands)))
        liking = choice.cost + _YIELDING * more
        liked = np.sort(np.argsort(liking)[: self._many])
        self._table.write(label, choice._replace(cost=choice.cost + more).taken(liked))
        self._put(label, int(np.argmin(liking[liked])))
        others = np.flatnonzero(self.stands & (np.arange(len(self.stands)) != label))
        more, _ = self.prices.together(self.boxes.taken(others), self.boxes.taken([label]))
        self._look_again(others[more > self.prices.strange])

    def _look_again(self, labels: Array) -> None:
        """Some labels leave their places and look on from there; then all move to better ones."""
        for label in labels.tolist():
            self._lift(label)
        self._look_on(labels.tolist())
        self._move()

    def _now(self) -> Array:
        """The cost of each label where it stands."""
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
        """Labels on leaders that do not tell what they name."""
        led = np.flatnonzero(self.stands & self.boxes.led)
        start, end = self.boxes.taken(led).leader.swapaxes(1, 2)
        return [int(label) for label in led[self.scene.arrows.unclear(self.scene.wanted, led, start, end)]]

    # --- what has no place ------------------------------------------------------------------------

    def clashing(self) -> list[int]:
        """Labels that lie on another or on something drawn, out of their room, or under a leader."""
        rows = np.flatnonzero(self.stands)
        boxes = self.boxes.taken(rows)
        bad = ~self.scene.inside(boxes)
        bad[self.scene.touched(boxes.low.T + _TOUCH, boxes.high.T - _TOUCH)] = True
        low, high = boxes.reach
        near = overlap(low[:, :, None], high[:, :, None], low[:, None], high[:, None])
        np.fill_diagonal(near, False)
        pair = one, other = np.nonzero(near)
        upper, lower = boxes.taken(one), boxes.taken(other)
        over = overlap(upper.low, upper.high, lower.low + _TOUCH, lower.high - _TOUCH) | under(upper, lower, 0.0)
        bad[np.concatenate(pair)[np.concatenate([over, over])]] = True
        return [int(label) for label in rows[bad]]


_UNCLEAR, _MORE, _EASY = 4.0, 1.5, 4
"""The burden of a label without a good place, where one on a good leader is 1; of each beyond so many, in addition."""
_ROUNDS = 30  # some are left out so often, to give others a place
_NEIGHBOUR = 15.0  # so near to a label without a place, others that say nothing new are left out [mm]


class Settled(NamedTuple):
    """Labels and leaders at their places.

    clashing  which labels lie on something, or their leaders on labels
    crowd     some were left out
    led       which labels stand on leaders; unclear: on such as do not tell what they name, or are long
    """

    marks: list[Mark]
    clashing: Sequence[int]
    crowd: bool = False
    led: Sequence[int] = ()
    unclear: Sequence[int] = ()

    @property
    def clashes(self) -> int:
        return len(self.clashing)

    def burdens(self, count: int) -> Array:
        """The burden of each of so many labels on the eye."""
        burdens = np.zeros(count)
        for labels, weight in ((self.led, 1.0), (self.unclear, _UNCLEAR), (self.clashing, _UNCLEAR)):
            burdens[[*labels]] += weight
        return burdens


def burden(each: Array) -> float:
    """The burden of labels together: more than a few are heavier."""
    return float(each.sum() + _MORE * max(0, int(np.count_nonzero(each)) - _EASY))


def settle(scene: LabelScene, crowd: bool = False) -> Settled:
    """The labels (and their leaders) at their places among what is drawn; `crowd`: on nothing else at any price, and
    those that say nothing new left out for that."""
    if not scene.wanted:
        return Settled([], ())
    places = LabelPlacing(scene, NEAR if scene.beyond_help else LED, CROWDED if crowd else NEARBY)
    clashing, unclear = places.clashing(), places.unclear()
    for _ in range(_ROUNDS if crowd else 0):
        if not (out := _left_out(scene.wanted, places.stands, [*clashing, *unclear])):
            break
        places.leave_out(out)
        clashing, unclear = places.clashing(), places.unclear()
    led = np.flatnonzero(places.stands & places.boxes.led)
    return Settled([*_lettered(scene.wanted, places)], clashing, crowd, led.tolist(), unclear)


def _lettered(wanted: Sequence[LabelRequest], places: LabelPlacing) -> Iterator[Mark]:
    """Letters where they stand, with their leaders."""
    for label in map(int, np.flatnonzero(places.stands)):
        want, (low, high, _, anchor) = wanted[label], places.boxes.places[..., label]
        wide, up, down = box(want.label, want.size)
        middle, at = complex(*(low + high) / 2), complex(*anchor)
        yield from want.texts(middle + complex(-wide / 2, (up - down) / 2))
        if places.boxes.led[label]:
            half, off = complex(wide, up + down) / 2, at - middle  # from the near side of its box to what it names
            edge = complex(max(-half.real, min(half.real, off.real)), max(-half.imag, min(half.imag, off.imag)))
            rest = off - edge
            begin = middle + edge + rest / abs(rest) * 0.3 if abs(rest) > 1 else middle + edge
            yield Stroke((begin, at), "leader", step=want.step)


def _left_out(wanted: Sequence[LabelRequest], stands: Array, clashing: Sequence[int]) -> list[int]:
    """The spare ones of labels without a place, else the spare ones next to them; not two that are close together, of
    which one may find a place without the other, unless very many have none."""
    places = [want.place for want in wanted]

    def close(label: int, others: Sequence[int]) -> bool:
        return any(abs(places[label] - places[other]) < _NEIGHBOUR for other in others)

    spare = [k for k, want in enumerate(wanted) if want.spare and stands[k]]
    chosen: list[int] = []
    if len(clashing) > MANY:
        return [k for k in spare if k in clashing]
    for label in [k for k in spare if k in clashing] or [k for k in spare if close(k, clashing)]:
        if not close(label, chosen):
            chosen.append(label)
    return chosen
