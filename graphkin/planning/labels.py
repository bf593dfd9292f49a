"""How sites are written in equations and polygons, and where they need the number of a link."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

from graphkin.construction import Site
from graphkin.mechanism import FRAME
from graphkin.planning.hops import Slip, Twist, way_round
from graphkin.planning.position import touching
from graphkin.planning.stages import Carry, Group, Loop, Stage
from graphkin.planning.structure import Sliding, Structure
from graphkin.value import filled


@filled
class Labels:
    """How sites are written: `C`; `B3` where links slide past each other; `B@guide` where that would mislead."""

    structure: Structure
    coincident: Mapping[str, str]
    """Points at which links slide past each other, with the link whose point the hinge itself is."""

    def label(self, site: Site) -> str:
        point = site.point
        owners = self.structure.owners.get(point, ())
        owned = site.link in owners or (site.link == FRAME and bool(owners))
        if owned:
            if point not in self.coincident:
                return point
            link = self.coincident[point]
        elif self.structure.is_pin(site.link):
            return f"{point}@{self.structure.pins[site.link].name}"  # a pin in a slot is a body beside its link
        else:
            link = self.structure.home(site.link)
        return self.numbered(point, link)

    def numbered(self, point: str, link: str) -> str:
        called = self.structure.mechanism.called(link)
        clear = called.isdigit() and not point[-1].isdigit() and (plain := point + called) not in self.structure.owners
        return plain if clear else f"{point}@{called}"

    @cached_property
    def reserved(self) -> frozenset[str]:
        """What points need in polygons, without the primes: free for no corner between."""
        return frozenset(label[0].lower() + label[1:] for label in self._written())

    @cached_property
    def initials(self) -> frozenset[str]:
        """With which letters points begin in polygons."""
        return frozenset(name[0] for name in self.reserved)

    def _written(self) -> Iterator[str]:
        """Every point as it may be written: with links' numbers those at which links roll or slide on each other."""
        structure = self.structure
        yield from structure.owners
        yield from (self.numbered(point, link) for point in self.coincident for link in structure.mechanism.links)
        yield from (self.numbered(letter, link) for letter, each in touching(structure) for link in each.wheels)


def coincident_points(structure: Structure, order: tuple[Stage, ...]) -> dict[str, str]:
    """Points at which links move past a moving link, with the link of which the hinge there is a point."""
    found: dict[str, str] = {}
    for stage in order:
        for hop in _jumps(structure, stage):
            if FRAME not in (hop.seen_from.link, hop.of.link) or isinstance(hop, Twist):
                owners = structure.owners[hop.of.point]
                homes = [site.link for site in (hop.of, hop.seen_from) if site.link in owners]
                if homes:
                    found.setdefault(hop.of.point, structure.home(homes[0]))
    return found


def _jumps(structure: Structure, stage: Stage) -> list[Slip | Twist]:
    """The coincident points of one stage."""
    if isinstance(stage, Loop):
        return [hop for hop in way_round(structure, stage)[1] if isinstance(hop, Slip | Twist)]
    if isinstance(stage, Group):
        ways = [way_round(structure, loop)[1] for loop in stage.loops]
        return [hop for way in ways for hop in way if isinstance(hop, Slip | Twist)]
    if isinstance(stage, Carry) and isinstance(stage.by, Sliding):
        pair = structure.slides[stage.by.slide]
        ends = (Site(pair.point, pair.guide), Site(pair.point, structure.block(pair)))
        return [Slip(ends[0], ends[1], True, pair.name)]
    return []
