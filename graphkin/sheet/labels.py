"""Labels find their places: none lies on a line, a vector or another label where there is room.

Each label has candidate places around its point or along its vector. All are held against everything drawn
at once (shapely's tree); then the label with the fewest free places left chooses first, and takes the one
nearest to what it names. The same marks give the same places. Where nothing near is free, a thin leader
goes to a place farther off. In a crowd that leaves no place at all, leaders go much farther (`far`), labels
make way for one another, and at last those that say nothing new are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from graphkin.sheet.label_places import Table
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import Disc, Mark, Place, Stroke, Text
from graphkin.sheet.nearness import Arrows
from graphkin.sheet.obstacles import tree
from graphkin.sheet.paper import Room
from graphkin.sheet.wanted import Wanted

_DOT = 0.3
"""Where a leader meets an arrow is a dot of this radius, so that it is plain which of two it means [mm]."""
_MANY = 150
"""More labels than this are a crowd that far places do not relieve."""
_ROUNDS = 12
"""How often some are left out, to give others a place."""
_NEIGHBOUR = 15.0
"""So near to a label without a place, others that say nothing new are left out [mm]."""


class Settled(NamedTuple):
    """Labels and leaders at their places; how many labels lie on something, or their leaders on labels.

    crowd  they had to go far off
    eased  they keep off what is drawn last, too
    """

    marks: list[Mark]
    clashes: int
    crowd: bool = False
    eased: bool = False


def settle(wanted: Sequence[Wanted], drawn: Sequence[Mark], room: Room, far: bool = False) -> Settled:
    """The labels (and their leaders) at their places among what is drawn; `far`: farther off rather than on it."""
    if not wanted:
        return Settled([], 0)
    known, letters, arrows = tree(drawn), tree(mark for mark in drawn if isinstance(mark, Text)), Arrows(drawn)
    table = Table.of(wanted, known, letters, arrows, room)
    clashing = table.clashing(chosen := table.chosen())
    crowd = far and bool(clashing)
    if crowd and len(wanted) <= _MANY:
        table = Table.of(wanted, known, letters, arrows, room, far)
        clashing = table.clashing(chosen := table.chosen())
    for _ in range(_ROUNDS if crowd else 0):
        if not (out := _left_out(table.wanted, clashing)):
            break
        table = table.without(out)
        clashing = table.clashing(chosen := table.chosen())
    marks: list[Mark] = []
    for want, row in zip(table.wanted, chosen, strict=True):
        wide, up, down = box(want.label, want.size)
        middle, anchor = complex(table.candidates.middle[row]), complex(table.candidates.anchor[row])
        marks += want.texts(middle + complex(-wide / 2, (up - down) / 2))
        if table.led[row]:
            marks.append(_leader(middle, anchor, complex(wide, up + down) / 2, want))
            if want.of:
                marks.append(Disc(anchor, _DOT, "leader", "ink", step=want.step))
    return Settled(marks, len(clashing), crowd)


def _left_out(wanted: Sequence[Wanted], clashing: Sequence[int]) -> set[int]:
    """The spare ones of labels without a place, else the spare ones next to them."""
    own = {k for k in clashing if wanted[k].spare}
    places = [want.place for want in wanted]
    close = {
        k
        for k, want in enumerate(wanted)
        if want.spare and any(abs(places[k] - places[other]) < _NEIGHBOUR for other in clashing)
    }
    return own or close


def _leader(middle: Place, anchor: Place, half: complex, want: Wanted) -> Mark:
    """A thin line from the near side of a label's box to what it names."""
    off = anchor - middle
    edge = complex(max(-half.real, min(half.real, off.real)), max(-half.imag, min(half.imag, off.imag)))
    way = off - edge
    begin = middle + edge + way / abs(way) * 0.3 if abs(way) > 1 else middle + edge
    return Stroke((begin, anchor), "leader", step=want.step)
