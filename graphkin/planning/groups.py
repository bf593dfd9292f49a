"""Groups of more than two unknowns, and rolling contacts, in the polygons.

A group is solved by way of a special point, as a planetary train between wheels of known motion, or all at once.
"""

from __future__ import annotations

from dataclasses import replace

from graphkin.construction import Site, kinds, terms
from graphkin.model.mechanism import FRAME
from graphkin.planning.images import add_up, base_of, drive, fill, measure_slides, reach
from graphkin.planning.loop_terms import Hop, LinkArm, Slip, outward, way_round
from graphkin.planning.polygon import PolygonPlan
from graphkin.planning.position import contact_letters, in_step
from graphkin.planning.special_points import Leg, Ternary
from graphkin.planning.stages import Group, Loop, Mesh


def group(polygon: PolygonPlan, stage: Group, special: Ternary | None) -> None:
    """All unknowns of a group, then the points of its links, each from what is drawn by then."""
    if special is not None:
        _by_special_point(polygon, special)
    elif not _train(polygon, stage) and not _by_contact(polygon, stage):
        chains = tuple(chain(polygon, loop) for loop in stage.loops)
        contacts = tuple(in_step(contact) for contact in stage.contacts)
        polygon.parts.append(kinds.Simultaneous(stage.angles, stage.slides, chains, contacts))
    waiting = list(stage.bodies)
    while waiting:
        body = next(b for b in waiting if base_of(polygon, b) or _slide_from_drawn(polygon, b))
        waiting.remove(body)
        if not base_of(polygon, body):
            drive(polygon, _slide_from_drawn(polygon, body), body)
        fill(polygon, body)
    if special is None:
        for loop in stage.loops:
            if loop not in stage.floating:
                coincide(polygon, loop)


def coincide(polygon: PolygonPlan, loop: Loop) -> None:
    """Both points at which links move past a moving one: the acceleration's Coriolis term is read between them."""
    for hop in way_round(polygon.structure, loop)[1]:
        if not isinstance(hop, LinkArm) and FRAME not in (hop.seen_from.link, hop.of.link):
            reach(polygon, hop.seen_from)
            reach(polygon, hop.of)


def _slide_from_drawn(polygon: PolygonPlan, body: str) -> str:
    """A slide whose other link is drawn."""
    for name, pair in polygon.structure.slides.items():
        ends = pair.guide, polygon.structure.block(pair)
        if body in ends:
            other = ends[0] if body == ends[1] else ends[1]
            if other == FRAME or base_of(polygon, other):
                return name
    return ""


def chain(polygon: PolygonPlan, loop: Loop) -> kinds.Chain:
    """A loop as arrows of known size and unknown scalars."""
    start, hops, end = way_round(polygon.structure, loop)
    known: list[tuple[terms.Size, int]] = []
    unknown: list[kinds.UnknownScalar] = []
    if loop.joints[0] != loop.joints[-1]:
        reach(polygon, start)
        reach(polygon, end)
        known.append((terms.Drawn(polygon.name(end), polygon.name(start)), 1))
    for hop in hops:
        for _, size, _ in polygon.pieces(hop):
            if size is not None:
                known.append((size, 1))
            elif isinstance(hop, Slip):
                unknown.append(kinds.UnknownScalar("", hop.slide, "", "", polygon.sense(hop)))
            else:
                unknown.append(kinds.UnknownScalar(hop.of.link, "", hop.seen_from.point, hop.of.point, 1))
    return kinds.Chain(tuple(known), tuple(unknown))


def walk(polygon: PolygonPlan, stage: Loop) -> None:
    """Draw every site of a loop whose unknowns have been found, hop by hop."""
    for hop in way_round(polygon.structure, stage)[1]:
        if isinstance(hop, LinkArm):
            reach(polygon, hop.of)
        elif not polygon.known(hop.of):
            add_up(polygon, hop.of, polygon.side(hop.seen_from, (replace(hop, known=True),)))
    for body in stage.bodies:
        fill(polygon, body)


def _by_special_point(polygon: PolygonPlan, special: Ternary) -> None:
    """Two equations by way of the special point, then what each leg turns or slides."""
    first, second, third = special.legs
    point = Site(special.name, special.link)
    for leg in special.legs:
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
        # with the ternary link known, its end's arrow gives what the leg itself does
        hop = leg.unknown
        for earlier in leg.hops[: leg.hops.index(hop)]:
            if not polygon.known(earlier.of):
                add_up(polygon, earlier.of, polygon.side(earlier.seen_from, (earlier,)))
        for later in reversed(leg.hops[leg.hops.index(hop) + 1 :]):
            for term in reversed(polygon.terms(later)):
                polygon.parts.append(kinds.LayOff(term, term.head, term.tail, backwards=True))
        polygon.measure(hop, polygon.name(hop.seen_from), polygon.name(hop.of))


def _leg(polygon: PolygonPlan, leg: Leg, point: Site) -> tuple[terms.Term, ...]:
    """Known arrows first, then the two unknown ones that lie on one line."""
    arrows = list(polygon.absolute(leg.start))
    tail = arrows[-1].head if arrows else polygon.name(leg.start)
    link, label = polygon.structure.home(leg.end.link), polygon.labels.label
    # each known arrow of the leg, and the normal one from its end to the point
    hops: list[tuple[Hop, slice]] = [(hop, slice(None)) for hop in leg.hops]
    if polygon.plane == "acceleration":
        hops.append((LinkArm(leg.end, point, True), slice(1)))
    known = [(each, *piece) for each, some in hops for piece in polygon.pieces(each)[some]]
    for each, part, size, direction in known:
        if size is None:
            continue
        of, seen_from = label(each.of), label(each.seen_from)
        turning = polygon.structure.home(size.link) if isinstance(size, terms.Normal | terms.Relative) else link
        head = polygon.between("k" if part == "k" else "n", turning, f"a^{part}_{of}{seen_from}")
        arrows.append(terms.Term(of, seen_from, part, size, direction, tail, head, sites=(each.of, each.seen_from)))
        tail = head
    hop = leg.unknown
    in_velocity, sliding = polygon.plane == "velocity", isinstance(hop, Slip)
    absolute = polygon.key(hop.seen_from).link == FRAME if in_velocity else sliding and hop.seen_from.link == FRAME
    part = "" if in_velocity or absolute else ("r" if sliding else "t")
    seen_from = "" if absolute else label(hop.seen_from)
    over, onto = label(hop.of), label(leg.end)
    ends, sites = (tail, polygon.name(point)), (point, hop.seen_from, hop.of, leg.end)
    onto = "" if onto == over else onto
    arrows.append(terms.Term(label(point), seen_from, part, None, leg.way, *ends, over, onto, sites))
    return tuple(arrows)


def mesh(polygon: PolygonPlan, stage: Mesh) -> None:
    """Pure rolling gives the contact of the one wheel the velocity of the other's; a rack follows its pinion."""
    if stage.contact.slide in polygon.structure.aside.slides and not stage.contact.way:
        measure_slides(polygon, [stage.contact.slide])
    turned = [body for body, _ in stage.contact.angles if polygon.structure.base(body) == stage.angle]
    centres = zip(stage.contact.wheels, stage.contact.centres, strict=True)
    wheel = next((Site(centre, link) for link, centre in centres if turned == [link] and centre), None)
    if wheel is None or not polygon.known(wheel) or _by_ratio(polygon, stage):  # or no contact gives it alone
        polygon.parts.append(kinds.Roll(in_step(stage.contact), stage.angle, stage.slide))
        return
    letter = contact_letters(polygon.structure)[stage.contact.name]
    of, at = Site(letter, wheel.link), Site(letter, next(w for w in stage.contact.wheels if w != wheel.link))
    reach(polygon, at)
    if polygon.plane == "velocity":
        polygon.put(polygon.key(of), polygon.name(at))
        _read_omega(polygon, wheel.link, wheel, of)
    else:
        # the contacts of two wheels differ in acceleration along their common normal only
        contact = stage.contact
        lever = LinkArm(wheel, of, False)
        left = polygon.side(wheel, (lever,))
        normal: terms.Direction = terms.AcrossGuide(contact.slide) if contact.slide else terms.Along(*contact.centres)
        label, other = polygon.labels.label(of), polygon.labels.label(at)
        start = polygon.absolute(at)
        tail = start[-1].head if start else polygon.pole
        sliding = terms.Term(label, other, "", None, normal, tail, polygon.name(of), sites=(of, at))
        polygon.equate(of, left, (*start, sliding))
        polygon.measure_unknown(lever)
    polygon.lies_apart(wheel, of)


def _by_ratio(polygon: PolygonPlan, stage: Mesh) -> bool:
    """True of a gear whose angular acceleration constant ratios give from those of drivers: no arrow is as exact."""
    turning = {polygon.structure.base(body) for body, _ in stage.contact.angles}
    return polygon.plane == "acceleration" and not stage.contact.slide and turning <= polygon.structure.calculated


def _train(polygon: PolygonPlan, stage: Group) -> bool:
    """A planet between two wheels of known motion, or a wheel between two plates: both contacts are known, so is it."""
    if polygon.plane != "velocity" or stage.loops or len(stage.contacts) != 2:
        return False
    planets = set(stage.contacts[0].wheels) & set(stage.contacts[1].wheels)
    if len(planets) != 1:
        return False
    planet = planets.pop()
    letters, sites = contact_letters(polygon.structure), []
    for contact in stage.contacts:  # as a point of the planet and of the other wheel, which must move as known
        other = next(wheel for wheel in contact.wheels if wheel != planet)
        known = polygon.structure.base(other) not in stage.angles and (other == FRAME or base_of(polygon, other))
        if not known or contact.arm != stage.contacts[0].arm:
            return False
        sites.append((Site(letters[contact.name], planet), Site(letters[contact.name], other)))
    for of, at in sites:
        reach(polygon, at)
        polygon.put(polygon.key(of), polygon.name(at))
    (first, _), (second, _) = sites
    _read_omega(polygon, planet, first, second)
    polygon.lies_apart(first, second)
    if arm := stage.contacts[0].arm:
        centre = stage.contacts[0].centres[stage.contacts[0].wheels.index(planet)]
        reach(polygon, Site(centre, planet))
        pivot = next(site for site in base_of(polygon, arm) if site.point != centre)
        _read_omega(polygon, arm, pivot, Site(centre, arm))
    measure_slides(polygon, stage.slides)
    return True


def _read_omega(polygon: PolygonPlan, link: str, tail: Site, head: Site) -> None:
    """The turning of a link from two of its points."""
    nodes = polygon.name(tail), polygon.name(head)
    polygon.parts.append(kinds.Measure("omega", link, *nodes, (tail.point, head.point)))


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
    measure_slides(polygon, [contact.slide])
    return True
