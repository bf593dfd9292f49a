"""Values that vectors and points of a drawing should have, by the analytic solution, also at points that only a
construction has. A mark names its sites as `B@3`, the point and the link of which it is a part: no name is taken apart.
"""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.analytic import Motion
from graphkin.base.geometry import Real, Value, meet_lines, number, place
from graphkin.base.value import Lazy, frozen
from graphkin.check.drawing import DrawingFile
from graphkin.construction import LETTER, Meet, Plane, Ray, Site, Touch, terms
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.model.naming import image_name, seen
from graphkin.model.pairs import Line, Rod, Slot, pin_name, rod_name
from graphkin.planning import plan


@frozen
class Body:
    """A body that is no link: a pin turns with its slot, which is on the link `turns_with`; two centres that profiles
    keep apart are joined by a bar of the equivalent.
    """

    points: tuple[str, ...]
    turns_with: str = ""


@frozen
class Widened(Motions):
    """The analytic solution at every site of a drawing; bodies that are no links move among the links.

    bodies  those that are no links
    """

    bodies: Mapping[str, Body]

    def place(self, point: str) -> complex:
        return complex(self.position[point])

    def knows(self, site: Site) -> bool:
        known = site.link in self.mechanism.links or site.link in self.bodies
        return known and site.point in self.position

    def points_of(self, body: str) -> tuple[str, ...]:
        """Points that are a body's own; of a pin only the one that it is."""
        if body in self.mechanism.links:
            return tuple(self.mechanism.links[body].points)
        return self.bodies[body].points


def widened(mechanism: Mechanism, exact: Motion, drawing: DrawingFile) -> Widened:
    """The analytic solution, at every point of a drawing; pins and bars that stand for something else under the names
    that the planner gives them."""
    bodies: dict[str, Body] = {}
    for pair in mechanism.pairs:
        same = pair.equivalent or pair.slipping
        if isinstance(same, Rod):
            bodies[rod_name(pair)] = Body(same.points)
        elif isinstance(same, Slot):
            bodies[pin_name(pair)] = Body((same.point,), same.line.link)
    # places of the points that a construction adds, by the analytic solution; what they are, the planner says
    added: dict[str, complex] = {}
    named = {attributes.get("data-site", "").partition("@")[0] for attributes, _ in drawing.points}
    if not named <= {"", *mechanism.points}:
        method = plan(mechanism)
        for step in method.position.steps:
            if isinstance(step, Touch) or (isinstance(step, Meet) and step.point in method.special):
                added[step.point] = added_point(step, mechanism, exact)
    known = exact.velocities, exact.accelerations
    velocities, accelerations = (
        {**table, **{body: {(point := each.points[0]): vectors[point]} for body, each in bodies.items()}}
        for table, vectors in zip(known, (exact.velocity, exact.acceleration), strict=True)
    )
    return Widened(
        mechanism, exact.theta, _turning_of(exact, bodies, exact.omega, exact.velocity),
        _turning_of(exact, bodies, exact.alpha, exact.acceleration), exact.s, exact.s_rate, exact.s_acceleration,
        {**exact.position, **added}, velocities, accelerations, bodies,
    )  # fmt: skip


def _turning_of(
    exact: Motion, bodies: Mapping[str, Body], links: Mapping[str, Real], vectors: Mapping[str, Value]
) -> Mapping[str, Real]:
    """Angular velocities or accelerations of links and bodies, by the links' or by the vectors of two points."""

    def turning(body: str) -> Real:
        if body in links:
            return links[body]
        if guide := bodies[body].turns_with:
            return links[guide]
        point, other = bodies[body].points
        return ((vectors[other] - vectors[point]) / (exact.position[other] - exact.position[point])).imag

    return Lazy((*links, *bodies), turning)


def added_point(step: Touch | Meet, mechanism: Mechanism, exact: Motion) -> complex:
    """The special point or the rolling contact that a step gives, from positions of the analytic solution."""
    if isinstance(step, Touch):
        centre = place(exact.position[step.centre])
        if step.slide:
            return centre + 1j * step.offset * exact.along(lines_of(mechanism)[step.slide])
        return centre + step.ratio * (complex(exact.position[step.other]) - centre)
    rays = [ray for ray in (step.first, step.second) if isinstance(ray, Ray)]
    first, second = ((exact.position[ray.through], _line(ray.direction, mechanism, exact)) for ray in rays)
    return complex(meet_lines(*first, *second)[0])


def _line(direction: terms.Direction, mechanism: Mechanism, exact: Motion) -> complex:
    if isinstance(direction, terms.AcrossGuide | terms.AlongGuide):
        along = exact.along(lines_of(mechanism)[direction.slide])
        return 1j * along if isinstance(direction, terms.AcrossGuide) else along
    assert isinstance(direction, terms.Along | terms.Across)
    arm = complex(exact.position[direction.head] - exact.position[direction.tail])
    return arm / abs(arm) * (1j if isinstance(direction, terms.Across) else 1)


def lines_of(mechanism: Mechanism) -> dict[str, Line]:
    """The line of every sliding pair, track and flat face of a cam."""
    return {pair.name: line for pair in mechanism.pairs for line in pair.lines}


def vector_value(exact: Widened, plane: Plane, attributes: Mapping[str, str]) -> complex | None:
    """The motion of `data-of` seen from `data-seen-from`, or its part; with `data-over` that of it, and `data-of` seen
    from `data-onto`, end to end. None where the mark says nothing that can be known."""
    sites = [_site(attributes.get(f"data-{key}", "")) for key in ("of", "seen-from", "over", "onto")]
    of, seen_from, over, onto = sites
    if of is None or not all(exact.knows(site) for site in sites if site is not None):
        return None
    part = attributes.get("data-part", "")
    if over is None:
        return _part(exact, plane, part, of, seen_from)
    if seen_from is None:
        return None
    first = _part(exact, plane, part, over, seen_from)
    second = _part(exact, plane, "t" if plane == "acceleration" else "", of, onto or over)
    return None if first is None or second is None else first + second


def point_value(mechanism: Mechanism, exact: Widened, plane: Plane, attributes: Mapping[str, str]) -> complex | None:
    """The place of a point in its plane; None for corners between arrows, and for points of one's own."""
    if attributes.get("data-of") == "pole":
        return 0j
    site = _site(attributes.get("data-site", ""))
    if site is None and (known := seen(mechanism, attributes.get("data-of", ""))) is not None:
        site = Site(known.point, known.link)
    if site is None or not exact.knows(site):
        return None
    return exact.place(site.point) if plane == "position" else _moving(exact, plane, site)


def _site(text: str) -> Site | None:
    point, at, link = text.partition("@")
    return Site(point, link) if at else None


def _moving(exact: Widened, plane: Plane, site: Site) -> complex:
    at = exact.velocity_at if plane == "velocity" else exact.acceleration_at
    return complex(at(site.point, site.link))


def _part(exact: Widened, plane: Plane, part: str, of: Site, seen_from: Site | None) -> complex | None:
    """Of two points of one body the parts n and t, of coincident points k, r, rn and rt."""
    if seen_from is None:
        return None if part else _moving(exact, plane, of)
    whole = _moving(exact, plane, of) - _moving(exact, plane, seen_from)
    arm = exact.place(of.point) - exact.place(seen_from.point)
    if part == "":
        return whole
    if part in ("n", "t"):
        # the body on which both lie: a hinge may be written as a point of another link that has it
        owners = exact.mechanism.owners
        bodies = (site.link for site, other in ((of, seen_from), (seen_from, of))
                  if site.link == other.link or site.link in owners.get(other.point, ()))  # fmt: skip
        if (body := next(bodies, None)) is None:
            return None
        return -(number(exact.turning(body)) ** 2) * arm if part == "n" else 1j * number(exact.swing(body)) * arm
    slip = _moving(exact, "velocity", of) - _moving(exact, "velocity", seen_from)
    coriolis = 2j * number(exact.turning(seen_from.link)) * slip
    if part in ("k", "r"):
        return coriolis if part == "k" else whole - coriolis
    # the turning of one link against another about their hinge
    others = exact.points_of(seen_from.link)
    pivot = next((point for point in exact.points_of(of.link) if point in others), None)
    if pivot is None or part not in ("rn", "rt"):
        return None
    arm = exact.place(of.point) - exact.place(pivot)
    if part == "rn":
        return -((number(exact.turning(of.link)) - number(exact.turning(seen_from.link))) ** 2) * arm
    return 1j * (number(exact.swing(of.link)) - number(exact.swing(seen_from.link))) * arm


def is_called_so(exact: Widened, plane: Plane, attributes: Mapping[str, str]) -> bool:
    """True if the name of a vector, as people read it, is that of the sites it is measured by."""
    keys = ("of", "seen-from", "over", "onto")
    of, seen_from, over, onto = (_called(exact, attributes.get(f"data-{key}", "")) for key in keys)
    part, letter = attributes.get("data-part", ""), LETTER[plane]
    name = attributes.get("data-name", "")
    if over:
        first, _, second = name.partition("+")
        turned = "t" if plane == "acceleration" else ""
        return _reads(first, letter, part, over, seen_from) and _reads(second, letter, turned, of, onto or over)
    return _reads(name, letter, part, of, seen_from)


def is_named_so(exact: Widened, attributes: Mapping[str, str]) -> bool:
    """True if a point's name, as people read it, is that of its site: `B`, `b3`, `b3'`."""
    plane: Plane = "acceleration" if attributes.get("data-plane") == "acceleration" else "velocity"
    name, site = attributes.get("data-name", ""), attributes.get("data-site", "")
    if not site:
        return True
    if attributes.get("data-plane") == "position":
        return name == site.partition("@")[0]
    return name in {image_name(exact.mechanism, plane, written) for written in _called(exact, site)}


def _reads(name: str, letter: str, part: str, of: set[str], seen_from: set[str]) -> bool:
    head, _, sites = name.partition("_")
    pairs = {f"{one}{comma}{other}" for one in of for other in {"", *seen_from} for comma in ("", ",")}
    return head == letter + (f"^{part}" if part else "") and sites in pairs


def _called(exact: Widened, text: str) -> set[str]:
    """Every way in which a site may be written: `B`, `B3`, `B@guide`; by any of the links that have the point."""
    site = _site(text)
    if site is None:
        return set()
    owners = exact.mechanism.owners
    bodies = {site.link, *owners.get(site.point, ())}
    bodies |= {name for name, body in exact.bodies.items() if body.points[0] == site.point}
    slots = {pin_name(pair): pair.name for pair in exact.mechanism.pairs}
    names = {exact.mechanism.called(slots.get(body, body)) for body in bodies}
    carried = [exact.bodies[name].points[0] for name in bodies if name in exact.bodies]
    names |= {exact.mechanism.called(link) for point in carried for link in owners.get(point, ())}
    return {site.point} | {site.point + name for name in names} | {f"{site.point}@{name}" for name in names}
