"""Cam pair: two profiles touch and slide. Each is a circle (radius 0: a knife edge) or a straight line."""

from __future__ import annotations

from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.pairs.pair import Circle, Line, Pair, Rod, Slot, centre_distance


@frozen
class Profile:
    """A circle about `centre` with `radius` [m], or a `line` (`left`: the other profile lies left of it)."""

    centre: str | None
    radius: float
    line: Line | None
    left: bool


@frozen
class Cam(Pair):
    """One `[[cam]]`: two links and their profiles; circles touch outside unless `internal`."""

    table: ClassVar[str] = "cam"

    name: str
    links: tuple[str, str]
    profiles: tuple[Profile, Profile]
    internal: bool

    @property
    def joins(self) -> tuple[str, ...]:
        return self.links

    @property
    def equivalent(self) -> Rod | Slot:
        """Two circles keep the distance of their centres, a circle's centre its distance from a line. Profiles are
        circles and straight lines, so this holds for the whole motion. Source: Sun Huan, Theory of Machines, section
        2-6 (replacement of higher pairs)."""
        (_, centre, radius), *others = self.circles
        for face in self.profiles:
            if face.line is not None:
                return Slot(face.line, centre, radius if face.left else -radius)
        ((_, other, more),) = others
        return Rod(self.links, (centre, other), centre_distance((radius, more), self.internal))

    @property
    def circles(self) -> tuple[Circle, ...]:
        both = zip(self.links, self.profiles, strict=True)
        return tuple((link, each.centre, each.radius) for link, each in both if each.centre is not None)

    @property
    def lines(self) -> tuple[Line, ...]:
        return tuple(profile.line for profile in self.profiles if profile.line is not None)
