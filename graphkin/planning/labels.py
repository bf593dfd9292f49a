"""The writing of sites in equations and polygons, with the number of a link where they need it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property

from graphkin.base.value import filled
from graphkin.construction import Site
from graphkin.model.mechanism import FRAME
from graphkin.planning.loop_terms import Hop, Slip, Twist, way_round
from graphkin.planning.position import touching
from graphkin.planning.stages import Carry, Group, Loop, Stage
from graphkin.planning.structure import Sliding, Topology


@filled
class Labels:
    """Labels of sites: `C`; `B3` where links slide past each other; `B@guide` where that would mislead."""

    structure: Topology
    coincident: Mapping[str, str]
    """Points at which links slide past each other, with the link whose point the hinge itself is."""
    _known: dict[Site, str] = field(default_factory=dict)

    def label(self, site: Site) -> str:
        if (label := self._known.get(site)) is not None:
            return label
        point, owners = site.point, self.structure.owners.get(site.point, ())
        if site.link in owners or (site.link == FRAME and owners):
            label = self.numbered(point, self.coincident[point]) if point in self.coincident else point
        elif self.structure.is_pin(site.link):  # a pin in a slot is a body beside its link
            label = f"{point}@{self.structure.pins[site.link].name}"
        else:
            label = self.numbered(point, self.structure.home(site.link))
        self._known[site] = label
        return label

    def numbered(self, point: str, link: str) -> str:
        called = self.structure.mechanism.called(link)
        clear = called.isdigit() and not point[-1].isdigit() and (plain := point + called) not in self.structure.owners
        return plain if clear else f"{point}@{called}"

    def reserves(self, name: str) -> bool:
        """True if a point may need a name in polygons, without the primes: it is free for no corner between. Such are
        the points, and those at which links slide past each other, with a link after k letters."""
        mechanism = self.structure.mechanism
        for k in range(1, len(name)):
            point, link = name[0].upper() + name[1:k], name[k:].removeprefix("@")
            link = FRAME if link == mechanism.frame else link
            if point in self.coincident and link in mechanism.links and _as_begun(self.numbered(point, link)) == name:
                return True
        return name in self._needed

    @cached_property
    def _needed(self) -> frozenset[str]:
        """The points, and those at which links roll on each other with the links' numbers."""
        contacts = touching(self.structure)
        rolling = (self.numbered(letter, link) for letter, contact in contacts for link in contact.wheels)
        return frozenset(map(_as_begun, (*self.structure.owners, *rolling)))

    @cached_property
    def initials(self) -> frozenset[str]:
        """With which letters points begin in polygons."""
        return frozenset(name[0] for name in self._needed)


def _as_begun(label: str) -> str:
    """As in a polygon, without the primes."""
    return label[0].lower() + label[1:]


def coincident_points(structure: Topology, order: tuple[Stage, ...]) -> dict[str, str]:
    """Points at which links move past a moving link, with the link of which the hinge there is a point."""
    points: dict[str, str] = {}
    for stage in order:
        hops: list[Hop] = []
        if isinstance(stage, Carry) and isinstance(stage.by, Sliding):
            pair = structure.slides[stage.by.slide]
            hops.append(Slip(Site(pair.point, pair.guide), Site(pair.point, structure.block(pair)), True, pair.name))
        for loop in (stage,) if isinstance(stage, Loop) else stage.loops if isinstance(stage, Group) else ():
            hops += way_round(structure, loop)[1]
        for hop in hops:
            past = isinstance(hop, Slip) and FRAME not in (hop.seen_from.link, hop.of.link)
            if past or isinstance(hop, Twist):
                owners = structure.owners[hop.of.point]
                homes = [site.link for site in (hop.of, hop.seen_from) if site.link in owners]
                if homes:
                    points.setdefault(hop.of.point, structure.home(homes[0]))
    return points
