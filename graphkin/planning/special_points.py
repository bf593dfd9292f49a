"""The special point of a ternary link (特殊点法): where the lines of two of its legs meet.

Each leg carries the ternary link from known to a point of it, with one unknown of its own. Of a bar, that
unknown moves its end at right angles to the bar; of a sliding pair, along the guide. A point of the ternary link
on the bar's line, or on the line at right angles to the guide, moves relative to that end in the same direction,
so both unknown arrows of a leg lie on one line. Where two such lines meet, two equations suffice (Assur).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import combinations, count

from graphkin.base.geometry import cross, number, place
from graphkin.base.value import frozen
from graphkin.construction import Construction, Direction, Meet, Node, Plot, Ray, Site
from graphkin.construction.terms import Across, AcrossGuide, Along, AlongGuide
from graphkin.model.mechanism import FRAME
from graphkin.planning.loop_terms import Hop, LinkArm, Slip, outward, way_round
from graphkin.planning.stages import Group, Stage
from graphkin.planning.structure import Topology

APART = 0.1  # least sine of the angle under which two legs' lines may meet, where another pair is better


@frozen
class Leg:
    """From a known site over hops, one of them unknown, to `end`, a point as part of the ternary link. The special
    point lies on a `line` through it; `way` is the direction in which the leg's unknown moves the special point."""

    start: Site
    hops: tuple[Hop, ...]
    end: Site
    line: Direction
    way: Direction

    @property
    def unknown(self) -> Hop:
        return next(hop for hop in self.hops if not hop.known)


@frozen
class Ternary:
    """A ternary link with its legs: the special point is taken on the first two."""

    link: str
    name: str
    legs: tuple[Leg, Leg, Leg]


def special_points(structure: Topology, order: tuple[Stage, ...], plot: Plot) -> dict[Group, Ternary]:
    """The special point of each Class III group, with a letter of its own."""
    every = (letter + "'" * primes for primes in count() for letter in "STUVWXYZ")
    letters = (letter for letter in every if letter not in structure.owners)
    groups = (stage for stage in order if isinstance(stage, Group))
    points = ((stage, _ternary(structure, stage, plot, next(letters))) for stage in groups)
    return {stage: point for stage, point in points if point is not None}


def with_special_points(construction: Construction, ternaries: Mapping[Group, Ternary]) -> Construction:
    """The mechanism with the lines of two legs, which meet in the special point."""
    if not ternaries:
        return construction
    parts, nodes = list(construction.parts), dict(construction.nodes)
    for one in ternaries.values():
        first, second = (Ray(leg.end.point, leg.line) for leg in one.legs[:2])
        parts += [first, second, Meet(first, second, one.name)]
        nodes[one.name] = Node(one.name, one.name, Site(one.name, one.link))
    return replace(construction, parts=tuple(parts), nodes=nodes)


def _ternary(structure: Topology, group: Group, plot: Plot, name: str) -> Ternary | None:
    """The ternary link of a Class III group, with the best pair of legs first; None for any other group."""
    if group.contacts or len(group.loops) != 2 or group.floating:
        return None
    common = set(group.loops[0].bodies) & set(group.loops[1].bodies)
    for link in sorted(common, key=lambda body: structure.order[body]):
        legs = _legs(structure, group, link) if structure.base(link) in group.angles else None
        if legs is not None:
            worth = {pair: _worth(pair, legs, plot) for pair in combinations(legs, 2)}
            best = max(worth, key=lambda pair: worth[pair])
            if worth[best] <= 0:
                return None
            return Ternary(best[0].end.link, name, (*best, next(leg for leg in legs if leg not in best)))
    return None


def _legs(structure: Topology, group: Group, link: str) -> list[Leg] | None:
    """Three legs that start at three known places and end on this link, if it is the ternary one."""
    legs: dict[tuple[Site, Hop], Leg] = {}
    for loop in group.loops:
        start, hops, end = way_round(structure, loop, link)
        levers = [k for k, hop in enumerate(hops) if isinstance(hop, LinkArm) and hop.of.link == link]
        if len(levers) != 1:
            return None
        at = levers[0]
        halves = (start, hops[:at], hops[at].seen_from), (end, outward(hops[at + 1 :]), hops[at].of)
        for site, half, last in halves:
            unknown = [hop for hop in half if not hop.known]
            if len(unknown) != 1:
                return None
            if isinstance(hop := unknown[0], LinkArm):
                arm = hop.seen_from.point, hop.of.point
                leg = Leg(site, half, last, Along(*arm), Across(*arm))
            elif isinstance(hop, Slip):
                leg = Leg(site, half, last, AcrossGuide(hop.slide), AlongGuide(hop.slide))
            else:
                return None
            legs.setdefault((site, hop), leg)
    return [*legs.values()] if len(legs) == 3 and len({leg.end.link for leg in legs.values()}) == 1 else None


def _worth(pair: tuple[Leg, Leg], legs: list[Leg], plot: Plot) -> float:
    """The worth of two legs as their lines meet; legs on the frame first, never where the third leg ends."""
    first, second = (place(plot.direction(leg.line)) for leg in pair)
    sine = abs(number(cross(first, second)))
    if sine < 0.01:
        return 0.0
    ends = {leg: place(plot.position[leg.end.point]) for leg in legs}
    at, other = ends[pair[0]], ends[pair[1]]
    along = number(cross(other - at, second)) / number(cross(first, second))
    meeting = at + along * first
    rest = next(leg for leg in legs if leg not in pair)
    span = max(abs(end - at) for end in ends.values()) or 1.0
    if abs(meeting - ends[rest]) / span < 0.05:
        return 0.0
    grounded = sum(leg.start.link == FRAME for leg in pair)
    return grounded * (1.0 if sine > APART and abs(meeting - at) < 20 * span else 0.1) + 0.05 * sine
