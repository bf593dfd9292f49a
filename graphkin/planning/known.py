"""What is known of a mechanism so far, and what lies close to that which has just become known."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field
from functools import cached_property

from graphkin.base.value import filled, frozen
from graphkin.construction.plot import grouped
from graphkin.model.mechanism import FRAME
from graphkin.planning.structure import Hinge, Joint, Topology


@frozen
class News:
    """What has just become known, and every body of which a joint or an angle is known now that was not before."""

    angles: frozenset[str]
    slides: frozenset[str]
    close: frozenset[str]


@filled
class Known:
    """Bodies with their points, angles of groups of links by their bases, displacements of slides."""

    structure: Topology
    bodies: set[str] = field(default_factory=lambda: {FRAME})
    angles: set[str] = field(default_factory=lambda: {FRAME})
    slides: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self.points = set(self.structure.bodies[FRAME])

    @property
    def unknown(self) -> list[str]:
        return [body for body in self.structure.bodies if body not in self.bodies]

    def angle(self, body: str) -> bool:
        return self.structure.base(body) in self.angles

    def joint(self, joint: Joint, others: tuple[str, ...]) -> bool:
        """Whether a joint's far side is known."""
        return joint.point in self.points if isinstance(joint, Hinge) else others[0] in self.bodies

    def learn(self, bodies: Iterable[str], angles: Iterable[str], slides: Iterable[str]) -> News:
        """Bodies with their points; with both ends of a slide its displacement is known, too."""
        fresh = [body for body in bodies if body not in self.bodies]
        reached = {point for body in fresh for point in self.structure.bodies[body]} - self.points
        self.bodies.update(fresh)
        self.points |= reached
        lying = (name for body in fresh for name in self._slides_at.get(body, ()) if self._lies(name))
        moved = frozenset([*slides, *lying]) - self.slides
        turned = frozenset(angles) - self.angles
        self.slides |= moved
        self.angles |= turned
        owners = (body for point in reached for body in self.structure.owners[point])
        return News(turned, moved, frozenset([*owners, *self._close(fresh, turned, moved)]))

    def _lies(self, name: str) -> bool:
        """Whether both links of a slide are known; of one set aside, its point on the guide."""
        slide = self.structure.slides[name]
        aside = name in self.structure.aside.slides and slide.point in self.points
        return slide.guide in self.bodies and (aside or self.structure.block(slide) in self.bodies)

    def _close(self, bodies: Iterable[str], angles: Iterable[str], slides: Iterable[str]) -> Iterator[str]:
        for body in bodies:
            yield body
            for joint, others in self.structure.joints(body):
                yield from () if isinstance(joint, Hinge) else others
        for base in angles:
            yield from self._turning_with.get(base, ())
        for slide in (self.structure.slides[name] for name in slides if name not in self.structure.aside.slides):
            yield from (slide.guide, self.structure.block(slide))

    @cached_property
    def _turning_with(self) -> dict[str, list[str]]:
        """The bodies of each group whose angles hang together."""
        return grouped(self.structure.turns)

    @cached_property
    def _slides_at(self) -> dict[str, list[str]]:
        """The slides of each body, and those whose point it has."""
        found: dict[str, list[str]] = {}
        for name, slide in self.structure.slides.items():
            for body in {slide.guide, self.structure.block(slide), *self.structure.owners.get(slide.point, ())}:
                found.setdefault(body, []).append(name)
        return found
