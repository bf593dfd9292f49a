"""The known part of a mechanism so far, and the paths from known to known through unknown bodies.

Paths are searched for again only close to what has just become known: a link of a long chain costs no more than one of
a short chain.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field
from functools import cached_property
from heapq import heappop, heappush

from graphkin.base.value import filled, frozen
from graphkin.construction.plot import grouped
from graphkin.model.mechanism import FRAME
from graphkin.planning.structure import Hinge, Joint, Sliding, Topology


@frozen
class NewlyKnown:
    """Angles and displacements that have just become known, and every body with a newly known joint or angle."""

    angles: frozenset[str]
    slides: frozenset[str]
    close: frozenset[str]


@filled
class KnownMotion:
    """Bodies with their points, angles of groups of links by their bases, displacements of slides."""

    structure: Topology
    bodies: set[str] = field(default_factory=lambda: {FRAME})
    angles: set[str] = field(default_factory=lambda: {FRAME})
    slides: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self.points = set(self.structure.bodies[FRAME])
        self._by_base = grouped(self.structure.turns)

    def joint(self, joint: Joint, others: tuple[str, ...]) -> bool:
        """True if a joint's far side is known."""
        return joint.point in self.points if isinstance(joint, Hinge) else others[0] in self.bodies

    def learn(self, bodies: Iterable[str], angles: Iterable[str], slides: Iterable[str]) -> NewlyKnown:
        """Add bodies with their points; a displacement is known, too, with both links of its slide, or with the guide
        and its point where the slide is set aside."""
        structure, placed = self.structure, list[str]()
        fresh = [body for body in bodies if body not in self.bodies]
        reached = {point for body in fresh for point in structure.bodies[body]} - self.points
        self.bodies.update(fresh)
        self.points |= reached
        for name in (name for body in fresh for name in self._slides_at.get(body, ())):
            slide = structure.slides[name]
            on_line = name in structure.aside.slides and slide.point in self.points
            if slide.guide in self.bodies and (on_line or structure.block(slide) in self.bodies):
                placed.append(name)
        moved, turned = frozenset([*slides, *placed]) - self.slides, frozenset(angles) - self.angles
        self.slides |= moved
        self.angles |= turned
        owners = (body for point in reached for body in structure.owners[point])
        return NewlyKnown(turned, moved, frozenset([*owners, *self._close(fresh, turned, moved)]))

    def _close(self, bodies: Iterable[str], angles: Iterable[str], slides: Iterable[str]) -> Iterator[str]:
        for body in bodies:
            yield body
            for joint, others in self.structure.joints(body):
                yield from () if isinstance(joint, Hinge) else others
        for base in angles:
            yield from self._by_base.get(base, ())
        for slide in (self.structure.slides[name] for name in slides if name not in self.structure.aside.slides):
            yield from (slide.guide, self.structure.block(slide))

    @cached_property
    def _slides_at(self) -> dict[str, list[str]]:
        """The slides of each body, and those whose point it has."""
        slides: dict[str, list[str]] = {}
        for name, slide in self.structure.slides.items():
            for body in {slide.guide, self.structure.block(slide), *self.structure.owners.get(slide.point, ())}:
                slides.setdefault(body, []).append(name)
        return slides

    def floats(self, joints: tuple[Joint, ...]) -> bool:
        """True if a path begins at an unknown hinge: it gives angles and displacements, but no place."""
        return isinstance(joints[0], Hinge) and joints[0].point not in self.points


LoopPath = tuple[tuple[str, ...], tuple[Joint, ...], tuple[str, ...], tuple[str, ...]]
"""Bodies, the joints before, between and after them; the unknown angles, by their bases, and displacements."""
_RankedPath = tuple[tuple[bool, int, list[int], list[int]], int, int, int, int, LoopPath]
"""A path after its rank: whether it floats, how long, its bodies in order and as they come. Of equals that from the
body which is first in the file. Then what tells whether it still holds, and the ends of its bodies as a row of bits."""


class LoopPaths:
    """Every path with two unknown scalars, or each that goes on as long as it keeps to `most`; if `floating` also those
    that only lead back to the hinge of unknown links in which they begin, after the others."""

    def __init__(self, known: KnownMotion, most: int, floating: bool = False) -> None:
        self.known, self.most, self.floating = known, most, floating
        self._ranked: list[_RankedPath] = []
        self._passed: dict[str, set[str]] = {}  # by body, the bodies from which paths come by
        self._stale = dict.fromkeys(body for body in known.structure.bodies if body not in known.bodies)
        self._times: dict[str, int] = {}
        self._bits: dict[tuple[Joint, str], int] = {}

    def first(self) -> LoopPath | None:
        """The shortest, of those the first in the order of the file."""
        self._search()
        while self._ranked and not self._holds(self._ranked[0]):
            heappop(self._ranked)
        return self._ranked[0][-1] if self._ranked else None

    def independent(self) -> list[LoopPath]:
        """Those that are no sum of ones before them, as sets of ends of bodies: the shortest first."""
        self._search()
        self._ranked = sorted(entry for entry in self._ranked if self._holds(entry))
        rows: dict[int, int] = {}
        chosen, heads = list[LoopPath](), 0
        for *_, row, path in self._ranked:
            while common := row & heads:
                row ^= rows[common & -common]
            if row:
                rows[head := row & -row] = row
                heads |= head
                chosen.append(path)
        return chosen

    def call(self, bodies: Iterable[str]) -> None:
        """Something of these bodies, or next to them, has become known."""
        for body in bodies:
            self._stale[body] = None
            self._stale.update(dict.fromkeys(self._passed.get(body, ())))

    def _holds(self, entry: _RankedPath) -> bool:
        return self._times[entry[-1][0][0]] == entry[3]

    def _search(self) -> None:
        order, bits = self.known.structure.order, self._bits
        for body in self._stale:
            time = self._times[body] = self._times.get(body, 0) + 1
            for k, path in enumerate(self._from(body)):
                bodies = [order[each] for each in path[0]]
                ends = [*zip(path[1], path[0]), *zip(path[1][1:], path[0])]
                row = sum(bits.setdefault(end, 1 << len(bits)) for end in ends)
                rank = self.known.floats(path[1]), len(bodies), sorted(bodies), bodies
                heappush(self._ranked, (rank, order[body], k, time, row, path))
        self._stale.clear()

    def _from(self, body: str) -> Iterator[LoopPath]:
        known, structure = self.known, self.known.structure
        if body in known.bodies or body in structure.followers:
            return
        for joint, others in structure.joints(body):
            if known.joint(joint, others) or (self.floating and isinstance(joint, Hinge)):
                yield from self._onward((body,), (joint,), self._angles((), body), self._slides((), joint))

    def _onward(
        self, bodies: tuple[str, ...], joints: tuple[Joint, ...], angles: tuple[str, ...], slides: tuple[str, ...]
    ) -> Iterator[LoopPath]:
        """Every path on from here that keeps to so many unknown scalars."""
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
                if not back and known.floats(joints):
                    continue
                if self.most > 2 or (len(angles) + len(more) == 2 and self._is_lever(bodies)):
                    yield bodies, (*joints, joint), angles, more
                continue
            for other in others:
                if other not in bodies and other not in known.bodies and other not in followers:
                    yield from self._onward((*bodies, other), (*joints, joint), self._angles(angles, other), more)

    def _angles(self, before: tuple[str, ...], body: str) -> tuple[str, ...]:
        base = self.known.structure.base(body)
        return before if base in self.known.angles or base in before else (*before, base)

    def _slides(self, before: tuple[str, ...], joint: Joint) -> tuple[str, ...]:
        if not isinstance(joint, Sliding) or joint.slide in self.known.slides or joint.slide in before:
            return before
        return (*before, joint.slide)

    def _is_lever(self, bodies: tuple[str, ...]) -> bool:
        """True if bodies of one unknown group follow one another, so that they count as one lever."""
        bases = [self.known.structure.base(body) for body in bodies]
        runs = [base for k, base in enumerate(bases) if k == 0 or bases[k - 1] != base]
        unknown = [base for base in runs if base not in self.known.angles]
        return len(unknown) == len(set(unknown))
