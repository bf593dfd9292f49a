"""Rolling contacts in the polygons: the contact points of two wheels, and planets between two of them."""

from __future__ import annotations

from graphkin.construction import AcrossGuide, Along, Direction, Measure, Roll, Site, Term
from graphkin.model.mechanism import FRAME
from graphkin.planning.equivalent import Contact
from graphkin.planning.images import base_of, reach
from graphkin.planning.loop_terms import LinkArm
from graphkin.planning.polygon import PolygonPlan
from graphkin.planning.position import contact_letters, in_step
from graphkin.planning.repeating import measure_slide
from graphkin.planning.stages import Group, Mesh


def mesh(polygon: PolygonPlan, stage: Mesh) -> None:
    """Pure rolling gives the contact of the one wheel the velocity of the other's; a rack follows its pinion."""
    if stage.contact.slide in polygon.structure.aside.slides and not stage.contact.way:
        measure_slide(polygon, stage.contact.slide)
    letter = contact_letters(polygon.structure)[stage.contact.name]
    wheel = _turned_by(polygon, stage)
    if wheel is None or not polygon.known(wheel):
        polygon.parts.append(Roll(in_step(stage.contact), stage.angle, stage.slide))
        return
    other = next(w for w in stage.contact.wheels if w != wheel.link)
    of, at = Site(letter, wheel.link), Site(letter, other)
    reach(polygon, at)
    if polygon.plane == "velocity":
        polygon.put(polygon.key(of), polygon.name(at))
        polygon.parts.append(Measure("omega", wheel.link, polygon.name(wheel), polygon.name(of), (wheel.point, letter)))
    else:
        _roll_acceleration(polygon, stage.contact, wheel, of, at)
    polygon.lies_apart(wheel, of)


def _turned_by(polygon: PolygonPlan, stage: Mesh) -> Site | None:
    """The centre of the wheel whose turning alone the contact gives."""
    turned = [body for body, _ in stage.contact.angles if polygon.structure.base(body) == stage.angle]
    for wheel, centre in zip(stage.contact.wheels, stage.contact.centres, strict=True):
        if turned == [wheel] and centre:
            return Site(centre, wheel)
    return None


def _roll_acceleration(polygon: PolygonPlan, contact: Contact, centre: Site, of: Site, at: Site) -> None:
    """The contacts of two wheels differ in acceleration along their common normal only."""
    lever = LinkArm(centre, of, False)
    left = polygon.side(centre, (lever,))
    normal: Direction = AcrossGuide(contact.slide) if contact.slide else Along(*contact.centres)
    label, other = polygon.labels.label(of), polygon.labels.label(at)
    start = polygon.absolute(at)
    tail = start[-1].head if start else polygon.pole
    sliding = Term(label, other, "", None, normal, tail, polygon.name(of), sites=(of, at))
    polygon.equate(of, left, (*start, sliding))
    polygon.measure_unknown(lever)


def train(polygon: PolygonPlan, stage: Group) -> bool:
    """A planet between two wheels of known motion, or a wheel between two plates: both contacts are known, so is it."""
    if polygon.plane != "velocity" or stage.loops or len(stage.contacts) != 2:
        return False
    planets = set(stage.contacts[0].wheels) & set(stage.contacts[1].wheels)
    if len(planets) != 1:
        return False
    planet = planets.pop()
    sites = _contacts_with_known(polygon, stage, planet)
    if not sites:
        return False
    for of, at in sites:
        reach(polygon, at)
        polygon.put(polygon.key(of), polygon.name(at))
    (first, _), (second, _) = sites
    nodes = polygon.name(first), polygon.name(second)
    polygon.parts.append(Measure("omega", planet, *nodes, (first.point, second.point)))
    polygon.lies_apart(first, second)
    if stage.contacts[0].arm:
        _turn_arm(polygon, planet, stage.contacts[0])
    for slide in stage.slides:
        measure_slide(polygon, slide)
    return True


def _contacts_with_known(polygon: PolygonPlan, stage: Group, planet: str) -> list[tuple[Site, Site]]:
    """Each contact as a point of the planet and of the other wheel; none unless both others move as known."""
    letters = contact_letters(polygon.structure)
    sites = []
    for contact in stage.contacts:
        other = next(wheel for wheel in contact.wheels if wheel != planet)
        known = polygon.structure.base(other) not in stage.angles and (other == FRAME or base_of(polygon, other))
        if not known or contact.arm != stage.contacts[0].arm:
            return []
        sites.append((Site(letters[contact.name], planet), Site(letters[contact.name], other)))
    return sites


def _turn_arm(polygon: PolygonPlan, planet: str, contact: Contact) -> None:
    """The arm's turning from the planet's centre."""
    arm, centre = contact.arm, contact.centres[contact.wheels.index(planet)]
    reach(polygon, Site(centre, planet))
    pivot = next(site for site in base_of(polygon, arm) if site.point != centre)
    nodes = polygon.name(pivot), polygon.name(Site(centre, arm))
    polygon.parts.append(Measure("omega", arm, *nodes, (pivot.point, centre)))
