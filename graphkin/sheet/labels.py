"""Labels find their places: none lies on a line, a vector or another label where there is room.

Each label has candidate places around its point or along its vector. All are held against everything drawn
at once; then the label with the fewest free places left chooses first, and takes the one
nearest to what it names. The same marks give the same places. Where nothing near is free, a thin leader
goes to a place farther off. In a crowd that leaves no place at all, leaders go much farther (`far`), labels
make way for one another, and at last those that say nothing new are left out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphkin.sheet.label_candidates import FARTHEST, LED, MANY, NEAR, LabelScene
from graphkin.sheet.label_places import Places
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import Disc, Mark, Place, Stroke
from graphkin.sheet.wanted import LabelRequest

_DOT = 0.3
"""Where a leader meets an arrow is a dot of this radius, so that it is plain which of two it means [mm]."""
_ROUNDS = 30
"""How often some are left out, to give others a place."""
_NEIGHBOUR = 15.0
"""So near to a label without a place, others that say nothing new are left out [mm]."""


class Settled(NamedTuple):
    """Labels and leaders at their places.

    clashing  which labels lie on something, or their leaders on labels
    crowd     they had to go far off
    led       which labels stand on leaders
    """

    marks: list[Mark]
    clashing: Sequence[int]
    crowd: bool = False
    led: Sequence[int] = ()

    @property
    def clashes(self) -> int:
        return len(self.clashing)


def settle(scene: LabelScene, far: bool = False) -> Settled:
    """The labels (and their leaders) at their places among what is drawn; `far`: farther off rather than on it."""
    if not scene.wanted:
        return Settled([], ())
    places = Places(scene, NEAR if scene.hopeless else LED if len(scene.wanted) > MANY or not far else FARTHEST)
    clashing = places.clashing()
    for _ in range(_ROUNDS if far else 0):
        if not (out := _left_out(scene.wanted, places.stands, clashing)):
            break
        places.leave_out(out)
        clashing = places.clashing()
    led = np.flatnonzero(places.stands & places.boxes.led)
    return Settled([*_lettered(scene.wanted, places)], clashing, far, [*map(int, led)])


def _lettered(wanted: Sequence[LabelRequest], places: Places) -> Iterator[Mark]:
    """Letters where they stand, with their leaders."""
    for label in map(int, np.flatnonzero(places.stands)):
        want, (low, high, _, anchor) = wanted[label], places.boxes.places[..., label]
        wide, up, down = box(want.label, want.size)
        middle, at = complex(*(low + high) / 2), complex(*anchor)
        yield from want.texts(middle + complex(-wide / 2, (up - down) / 2))
        if places.boxes.led[label]:
            yield _leader(middle, at, complex(wide, up + down) / 2, want)
            if want.of:
                yield Disc(at, _DOT, "leader", "ink", step=want.step)


def _left_out(wanted: Sequence[LabelRequest], stands: Any, clashing: Sequence[int]) -> list[int]:
    """The spare ones of labels without a place, else the spare ones next to them; not two that are close together, of
    which one may find a place without the other, unless very many have none."""
    places = [want.place for want in wanted]

    def close(label: int, others: Sequence[int]) -> bool:
        return any(abs(places[label] - places[other]) < _NEIGHBOUR for other in others)

    spare = [k for k, want in enumerate(wanted) if want.spare and stands[k]]
    found: list[int] = []
    if len(clashing) > MANY:
        return [k for k in spare if k in clashing]
    for label in [k for k in spare if k in clashing] or [k for k in spare if close(k, clashing)]:
        if not close(label, found):
            found.append(label)
    return found


def _leader(middle: Place, anchor: Place, half: complex, want: LabelRequest) -> Mark:
    """A thin line from the near side of a label's box to what it names."""
    off = anchor - middle
    edge = complex(max(-half.real, min(half.real, off.real)), max(-half.imag, min(half.imag, off.imag)))
    way = off - edge
    begin = middle + edge + way / abs(way) * 0.3 if abs(way) > 1 else middle + edge
    return Stroke((begin, anchor), "leader", step=want.step)
