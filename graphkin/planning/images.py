"""Further points of a link whose motion is known: by image on two points, from one by its rotation; gears as circles.

Displacements of sliding pairs that join nothing, as they repeat what other pairs hold, are measured like any other.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations

from graphkin.construction import Image, LayOff, Measure, Roll, Simultaneous, Site, Term
from graphkin.model.mechanism import FRAME
from graphkin.model.wheels import Wheel, wheels_of
from graphkin.planning.closing import known_sum
from graphkin.planning.loop_terms import LinkArm, Slip
from graphkin.planning.method import Method
from graphkin.planning.polygon import PolygonPlan


def fill(polygon: PolygonPlan, body: str) -> None:
    """Every named point of a link."""
    for point in polygon.structure.named(body):
        reach(polygon, Site(point, body))


def reach(polygon: PolygonPlan, site: Site) -> None:
    """Draw a site of a link whose motion is known: by image on two known points, else from one. A place on a driven
    link that is no point of its own is drawn from the fixed point about which the link turns."""
    if polygon.known(site):
        return
    base, structure = base_of(polygon, site.link), polygon.structure
    driven = structure.base(site.link) == FRAME != site.link and site.point not in structure.bodies[site.link]
    pivot = next((one for one in base if driven and polygon.key(one).link == FRAME), None)
    if pivot is None and len(base) > 1:
        first, second = base[:2]
        corners = (first.point, second.point, site.point)
        polygon.parts.append(Image(site.link, corners, (polygon.name(first), polygon.name(second)), polygon.name(site)))
    else:
        # from one known point by the link's known rotation; of one that turns steadily only the normal arrow is left
        start = pivot or base[0]
        right = polygon.absolute(start) + tuple(polygon.terms(LinkArm(Site(start.point, site.link), site, True)))
        if polygon.plane == "acceleration" and polygon.structure.steady(site.link):
            normal, tangential = right[-2:]
            polygon.nodes.pop(normal.head)
            seen_from, part = ("", "") if normal.tail == polygon.pole else (normal.seen_from, "n")
            size, direction, ends = normal.size, normal.direction, (normal.tail, tangential.head)
            right = (*right[:-2], Term(normal.of, seen_from, part, size, direction, *ends, sites=normal.sites))
        add_up(polygon, site, right)


def base_of(polygon: PolygonPlan, body: str) -> list[Site]:
    """Known sites of a body that lie apart, its own points first."""
    own = [Site(point, body) for point in polygon.structure.named(body)]
    more = [key for key in polygon.of_link.get(body, ()) if key not in own]
    known = [site for site in own if polygon.known(site)] + more
    pairs = combinations(known, 2)
    return next(([*pair] for pair in pairs if _apart(polygon, body, *pair)), known[:1])


def _apart(polygon: PolygonPlan, body: str, first: Site, second: Site) -> bool:
    """Points of one link are apart by their shape; a coincident point is not on the end of a measured lever."""
    if frozenset((polygon.key(first), polygon.key(second))) in polygon.apart:
        return True
    points = polygon.structure.bodies[body]
    if first.point in points and second.point in points and not polygon.structure.is_pin(body):
        shape = polygon.structure.shapes[body]
        return abs(shape[second.point] - shape[first.point]) > 0
    return False


def drive(polygon: PolygonPlan, slide: str, body: str) -> None:
    """A body that a driver moves along a known one."""
    pair = polygon.structure.slides[slide]
    other = pair.guide if body != pair.guide else polygon.structure.block(pair)
    seen_from, of = Site(pair.point, other), Site(pair.point, body)
    if polygon.known(of):
        return
    reach(polygon, seen_from)
    right = polygon.side(seen_from, (Slip(seen_from, of, True, slide),))
    add_up(polygon, of, right)


def add_up(polygon: PolygonPlan, of: Site, right: tuple[Term, ...]) -> None:
    """The motion of a site as the sum of known arrows."""
    label, node = polygon.labels.label(of), polygon.name(of)
    if len(right) == 1:
        polygon.parts.append(LayOff(right[0], right[0].tail, right[0].head))
    else:
        polygon.parts.append(known_sum(label, Term(label, "", "", None, None, polygon.pole, node, sites=(of,)), right))


def measure_slides(polygon: PolygonPlan, names: Iterable[str]) -> None:
    """Those of some sliding pairs and wheels on lines whose motion along their line no step has given yet."""
    # the slides whose motion is known: driven, measured or calculated
    given = set(polygon.structure.slides_driven)
    for part in polygon.parts:
        if isinstance(part, Measure) and part.quantity == polygon.sliding:
            given.add(part.of)
        elif isinstance(part, Roll):
            given |= {part.slide} - {""}
        elif isinstance(part, Simultaneous):
            given.update(part.slides)
    for name in names:
        if name in given:
            continue
        # the point seen from the guide under it; of the acceleration what the Coriolis term leaves
        pair, owners = polygon.structure.slides[name], polygon.structure.owners
        of = Site(pair.point, next(body for body in owners[pair.point] if body != pair.guide))
        seen_from = Site(pair.point, pair.guide)
        reach(polygon, of)
        if pair.guide == FRAME:
            polygon.parts.append(Measure(polygon.sliding, name, polygon.pole, polygon.name(of)))
            continue
        reach(polygon, seen_from)
        *known, along = polygon.terms(Slip(seen_from, of, False, name))
        polygon.parts += [LayOff(term, term.tail, term.head) for term in known]
        polygon.parts.append(Measure(polygon.sliding, name, along.tail, along.head))


def imaged_gears(method: Method) -> Iterator[tuple[Wheel, str, str]]:
    """Every gear once, with its circle's name, and the polygon's point of its centre; wheels that only roll have none.
    `g3'` is the second of a double wheel, as `r3'` is its radius. `g` is another letter where the mechanism has a point
    G."""
    letter = next((c for c in "gwzu" if c.upper() not in method.mechanism.points), "g")
    for wheel in wheels_of(method.mechanism):
        if wheel.gear and (centre := _gear_centre(method, wheel)) is not None:
            called = method.mechanism.called(wheel.link)
            primes = "'" * radius_number(method, wheel.link, wheel.radius)
            yield wheel, letter + ("" if called.isdigit() else "@") + called + primes, centre


def radius_number(method: Method, link: str, size: float) -> int:
    """The number of a radius among those with which a link rolls, from 0, in the order of the contacts."""
    pairs = ((wheel, abs(radius)) for contact in method.structure.contacts
             for wheel, radius in zip(contact.wheels, contact.radii, strict=True))  # fmt: skip
    sizes = dict.fromkeys(round(radius, 12) for wheel, radius in pairs if wheel == link and radius)
    return [*sizes, round(abs(size), 12)].index(round(abs(size), 12))


def _gear_centre(method: Method, wheel: Wheel) -> str | None:
    """The polygon's point of a gear's centre; those of fixed points are the pole's."""
    owners = method.mechanism.owners.get(wheel.centre, ())
    if FRAME in owners or wheel.link == FRAME:
        return method.velocity.pole
    nodes = method.velocity.nodes.items()
    at_centre = [(name, node.site) for name, node in nodes if node.site and node.site.point == wheel.centre]
    at_centre.sort(key=lambda entry: entry[1].link != wheel.link)
    return next((name for name, site in at_centre if site.link in owners), None)
