"""Ways from known to known through unknown bodies, looked for again only where something on them is new."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from heapq import heappop, heappush

from graphkin.planning.known import Known
from graphkin.planning.structure import Hinge, Joint, Sliding

Way = tuple[tuple[str, ...], tuple[Joint, ...], tuple[str, ...], tuple[str, ...]]
"""Bodies, the joints before, between and after them; the unknown angles, by their bases, and displacements."""
_Entry = tuple[tuple[bool, int, list[int], list[int]], int, int, int, int, Way]
"""A way after its rank: whether it floats, how long, its bodies in order and as they come. Of equals that from the body
which is first in the file, as found. Then what tells whether it still holds, and the ends of its bodies as a row of
bits."""


def floats(known: Known, joints: tuple[Joint, ...]) -> bool:
    """A way from an unknown hinge: it gives angles and displacements, but no place."""
    return isinstance(joints[0], Hinge) and joints[0].point not in known.points


class Ways:
    """Every way with two unknown scalars; or each that goes on as long as it keeps to `most`.

    floating  also those that only lead back to the hinge of unknown links in which they begin, after the others
    """

    def __init__(self, known: Known, most: int, floating: bool = False) -> None:
        self.known, self.most, self.floating = known, most, floating
        self._entries: list[_Entry] = []
        self._passed: dict[str, set[str]] = {}
        """By body, the bodies from which ways come by."""
        self._stale = dict.fromkeys(known.unknown)
        self._times: dict[str, int] = {}
        self._bits: dict[tuple[Joint, str], int] = {}

    def first(self) -> Way | None:
        """The shortest, of those the first in the order of the file."""
        self._look()
        while self._entries and not self._holds(self._entries[0]):
            heappop(self._entries)
        return self._entries[0][-1] if self._entries else None

    def independent(self) -> list[Way]:
        """Those that are no sum of ones before them, as sets of ends of bodies: the shortest first."""
        self._look()
        self._entries = sorted(entry for entry in self._entries if self._holds(entry))
        rows: dict[int, int] = {}
        chosen, heads = list[Way](), 0
        for *_, row, way in self._entries:
            while common := row & heads:
                row ^= rows[common & -common]
            if row:
                rows[head := row & -row] = row
                heads |= head
                chosen.append(way)
        return chosen

    def near(self, bodies: Iterable[str]) -> None:
        """Something of these bodies, or next to them, has become known."""
        for body in bodies:
            self._stale[body] = None
            self._stale.update(dict.fromkeys(self._passed.get(body, ())))

    def _holds(self, entry: _Entry) -> bool:
        return self._times[entry[-1][0][0]] == entry[3]

    def _look(self) -> None:
        order, bits = self.known.structure.order, self._bits
        for body in self._stale:
            time = self._times[body] = self._times.get(body, 0) + 1
            for k, way in enumerate(self._from(body)):
                bodies = [order[each] for each in way[0]]
                ends = [*zip(way[1], way[0]), *zip(way[1][1:], way[0])]
                row = sum(bits.setdefault(end, 1 << len(bits)) for end in ends)
                rank = floats(self.known, way[1]), len(bodies), sorted(bodies), bodies
                heappush(self._entries, (rank, order[body], k, time, row, way))
        self._stale.clear()

    def _from(self, body: str) -> Iterator[Way]:
        known, structure = self.known, self.known.structure
        if body in known.bodies or body in structure.followers:
            return
        for joint, others in structure.joints(body):
            if known.joint(joint, others) or (self.floating and isinstance(joint, Hinge)):
                yield from self._on((body,), (joint,), self._angles((), body), self._slides((), joint))

    def _on(
        self, bodies: tuple[str, ...], joints: tuple[Joint, ...], angles: tuple[str, ...], slides: tuple[str, ...]
    ) -> Iterator[Way]:
        """Every way on from here that keeps to so many unknown scalars."""
        known, followers = self.known, self.known.structure.followers
        self._passed.setdefault(bodies[-1], set()).add(bodies[0])
        if len(angles) + len(slides) > self.most:
            return
        for joint, others in known.structure.joints(bodies[-1]):
            back = joint == joints[0] and isinstance(joint, Hinge) and len(bodies) > 2
            if joint in joints and not back:
                continue
            more = self._slides(slides, joint)
            if back or known.joint(joint, others):
                if not back and floats(known, joints):
                    continue
                if self.most > 2 or (len(angles) + len(more) == 2 and self._together(bodies)):
                    yield bodies, (*joints, joint), angles, more
                continue
            for other in others:
                if other not in bodies and other not in known.bodies and other not in followers:
                    yield from self._on((*bodies, other), (*joints, joint), self._angles(angles, other), more)

    def _angles(self, before: tuple[str, ...], body: str) -> tuple[str, ...]:
        base = self.known.structure.base(body)
        return before if base in self.known.angles or base in before else (*before, base)

    def _slides(self, before: tuple[str, ...], joint: Joint) -> tuple[str, ...]:
        if not isinstance(joint, Sliding) or joint.slide in self.known.slides or joint.slide in before:
            return before
        return (*before, joint.slide)

    def _together(self, bodies: tuple[str, ...]) -> bool:
        """Bodies of one unknown group must follow one another, so that they count as one lever."""
        bases = [self.known.structure.base(body) for body in bodies]
        runs = [base for k, base in enumerate(bases) if k == 0 or bases[k - 1] != base]
        unknown = [base for base in runs if base not in self.known.angles]
        return len(unknown) == len(set(unknown))
