"""Groups of more than two unknowns: by way of a special point, as a planetary train, or all at once."""

from __future__ import annotations

from dataclasses import replace

from graphkin.construction import (
    Chain,
    Direction,
    Drawn,
    LayOff,
    Normal,
    Relative,
    Simultaneous,
    Site,
    Size,
    Term,
    UnknownScalar,
)
from graphkin.model.mechanism import FRAME
from graphkin.planning.images import add_up, base_of, drive, fill, reach
from graphkin.planning.loop_terms import Hop, LinkArm, Slip, outward, way_round
from graphkin.planning.polygon import PolygonPlan
from graphkin.planning.position import contact_letters, in_step
from graphkin.planning.repeating import measure_slide
from graphkin.planning.rolling import train
from graphkin.planning.special import Leg, Ternary
from graphkin.planning.stages import Group, Loop

Known = tuple[tuple[Site, ...], str, Size, Direction | None]
"""A known arrow: the sites it lies between, its part, its size, its direction."""


def group(polygon: PolygonPlan, stage: Group, found: Ternary | None) -> None:
    """All unknowns of a group, then the points of its links, each from what is drawn by then."""
    if found is None:
        if not train(polygon, stage) and not _by_contact(polygon, stage):
            _together(polygon, stage)
    else:
        _special(polygon, found)
    waiting = list(stage.bodies)
    while waiting:
        body = next(b for b in waiting if base_of(polygon, b) or _slid_from(polygon, b))
        waiting.remove(body)
        if not base_of(polygon, body):
            drive(polygon, _slid_from(polygon, body), body)
        fill(polygon, body)
    if found is None:
        for loop in stage.loops:
            if loop not in stage.floating:
                coincide(polygon, loop)


def coincide(polygon: PolygonPlan, loop: Loop) -> None:
    """Both points at which links move past a moving one: the acceleration's Coriolis term is read between them."""
    for hop in way_round(polygon.structure, loop)[1]:
        if not isinstance(hop, LinkArm) and FRAME not in (hop.seen_from.link, hop.of.link):
            reach(polygon, hop.seen_from)
            reach(polygon, hop.of)


def _slid_from(polygon: PolygonPlan, body: str) -> str:
    """A slide whose other link is drawn."""
    for name, pair in polygon.structure.slides.items():
        ends = pair.guide, polygon.structure.block(pair)
        if body in ends:
            other = ends[0] if body == ends[1] else ends[1]
            if other == FRAME or base_of(polygon, other):
                return name
    return ""


def _special(polygon: PolygonPlan, found: Ternary) -> None:
    """Two equations by way of the special point, then what each leg turns or slides."""
    first, second, third = found.legs
    point = Site(found.name, found.link)
    for leg in found.legs:
        reach(polygon, leg.start)
    grounded = first.start.link == second.start.link == FRAME
    if polygon.structure.centres and grounded and polygon.plane == "velocity":
        polygon.put(polygon.key(point), polygon.pole)
    else:
        polygon.equate(point, _leg(polygon, first, point), _leg(polygon, second, point))
    lever = LinkArm(point, third.end, False)
    sides = polygon.in_order(polygon.side(point, (lever,)), polygon.side(third.start, third.hops))
    polygon.equate(third.end, *sides)
    polygon.measure_unknown(lever)
    polygon.measure_unknown(third.unknown)
    for leg in (first, second):
        reach(polygon, leg.end)
        _measure_leg(polygon, leg)


def _leg(polygon: PolygonPlan, leg: Leg, point: Site) -> tuple[Term, ...]:
    """Known arrows first, then the two unknown ones that lie on one line."""
    terms = list(polygon.absolute(leg.start))
    tail = terms[-1].head if terms else polygon.name(leg.start)
    link = polygon.structure.home(leg.end.link)
    label = polygon.labels.label
    for sites, part, size, way in _known_of(polygon, leg, point):
        of, seen_from = map(label, sites)
        turning = polygon.structure.home(size.link) if isinstance(size, Normal | Relative) else link
        head = polygon.between("k" if part == "k" else "n", turning, f"a^{part}_{of}{seen_from}")
        terms.append(Term(of, seen_from, part, size, way, tail, head, sites=sites))
        tail = head
    seen_from, part = _unknown_of(polygon, leg.unknown)
    sites = (point, leg.unknown.seen_from, leg.unknown.of, leg.end)
    over, onto = label(leg.unknown.of), label(leg.end)
    onto = "" if onto == over else onto
    terms.append(Term(label(point), seen_from, part, None, leg.way, tail, polygon.name(point), over, onto, sites))
    return tuple(terms)


def _known_of(polygon: PolygonPlan, leg: Leg, point: Site) -> list[Known]:
    """Each known arrow of a leg, and the normal one from its end to the point."""
    known: list[Known] = [
        ((hop.of, hop.seen_from), part, size, way)
        for hop in leg.hops
        for part, size, way in polygon.pieces(hop)
        if size is not None
    ]
    if polygon.plane == "acceleration":
        part, size, way = polygon.pieces(LinkArm(leg.end, point, True))[0]
        assert size is not None
        known.append(((point, leg.end), part, size, way))
    return known


def _unknown_of(polygon: PolygonPlan, hop: Hop) -> tuple[str, str]:
    """What the unknown arrow of a leg is seen from, and its part."""
    in_velocity, sliding = polygon.plane == "velocity", isinstance(hop, Slip)
    absolute = hop.seen_from.link == FRAME and (in_velocity or sliding)
    part = "" if in_velocity or absolute else ("r" if sliding else "t")
    return "" if absolute else polygon.labels.label(hop.seen_from), part


def _measure_leg(polygon: PolygonPlan, leg: Leg) -> None:
    """With the ternary link known, its end's arrow gives what the leg itself does."""
    hop = leg.unknown
    for earlier in leg.hops[: leg.hops.index(hop)]:
        if not polygon.known(earlier.of):
            add_up(polygon, earlier.of, polygon.side(earlier.seen_from, (earlier,)))
    for later in reversed(leg.hops[leg.hops.index(hop) + 1 :]):
        for term in reversed(polygon.terms(later)):
            polygon.parts.append(LayOff(term, term.head, term.tail, backwards=True))
    polygon.measure(hop, polygon.name(hop.seen_from), polygon.name(hop.of))


def _by_contact(polygon: PolygonPlan, stage: Group) -> bool:
    """Velocities of a track on which a wheel of known motion rolls: its point of contact has that of the wheel's."""
    if polygon.plane != "velocity" or len(stage.loops) != 1 or len(stage.contacts) != 1:
        return False
    contact, (start, hops, end) = stage.contacts[0], way_round(polygon.structure, stage.loops[0])
    if not contact.slide or contact.way or contact.slide not in stage.slides:
        return False
    if isinstance(hops[-1], Slip) and hops[-1].slide == contact.slide:
        hops, end = outward(hops), start
    track, wheel = contact.wheels
    unknown = [hop for hop in hops[1:] if not hop.known]
    rolls = isinstance(hops[0], Slip) and hops[0].slide == contact.slide and base_of(polygon, wheel)
    if not rolls or len(unknown) != 2 or unknown[0] != hops[1] or unknown[0].of.link != track:
        return False
    letter = contact_letters(polygon.structure)[contact.name]
    of, at = Site(letter, track), Site(letter, wheel)
    reach(polygon, at)
    polygon.put(polygon.key(of), polygon.name(at))
    swing, middle = LinkArm(of, hops[1].of, False), hops.index(unknown[1])
    left, right = (swing, *hops[2:middle]), outward(hops[middle:])
    polygon.equate(left[-1].of, *polygon.in_order(polygon.side(of, left), polygon.side(end, right)))
    for hop in (swing, right[-1]):
        polygon.measure_unknown(hop)
    measure_slide(polygon, contact.slide)
    return True


def _together(polygon: PolygonPlan, stage: Group) -> None:
    """All chains at once, by calculation."""
    chains = tuple(chain(polygon, loop) for loop in stage.loops)
    contacts = tuple(in_step(contact) for contact in stage.contacts)
    polygon.parts.append(Simultaneous(stage.angles, stage.slides, chains, contacts))


def chain(polygon: PolygonPlan, loop: Loop) -> Chain:
    """A loop as arrows of known size and unknown scalars."""
    start, hops, end = way_round(polygon.structure, loop)
    known: list[tuple[Size, int]] = []
    unknown: list[UnknownScalar] = []
    if loop.joints[0] != loop.joints[-1]:
        reach(polygon, start)
        reach(polygon, end)
        known.append((Drawn(polygon.name(end), polygon.name(start)), 1))
    for hop in hops:
        for _, size, _ in polygon.pieces(hop):
            if size is not None:
                known.append((size, 1))
            elif isinstance(hop, Slip):
                unknown.append(UnknownScalar("", hop.slide, "", "", polygon.sense(hop)))
            else:
                unknown.append(UnknownScalar(hop.of.link, "", hop.seen_from.point, hop.of.point, 1))
    return Chain(tuple(known), tuple(unknown))


def walk(polygon: PolygonPlan, stage: Loop) -> None:
    """Draw every site of a loop whose unknowns have been found, hop by hop."""
    for hop in way_round(polygon.structure, stage)[1]:
        if isinstance(hop, LinkArm):
            reach(polygon, hop.of)
        elif not polygon.known(hop.of):
            add_up(polygon, hop.of, polygon.side(hop.seen_from, (replace(hop, known=True),)))
    for body in stage.bodies:
        fill(polygon, body)
