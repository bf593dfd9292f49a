"""The velocity and the acceleration polygon: one vector equation for each loop, images for further points.

Methods of Sun Huan, 机械原理, section 3-2.1: two points of one link, equations (3-1) and (3-2); coincident
points of a sliding pair, (3-3) and (3-4); velocity and acceleration image.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import combinations

from graphkin.mechanism import FRAME
from graphkin.methods.closing import close, known_sum
from graphkin.methods.equivalent import Contact
from graphkin.methods.hops import Hop, Lever, Slip, Twist, halves, way_round
from graphkin.methods.position import in_step, touching
from graphkin.methods.special import Leg, Ternary
from graphkin.methods.stages import Bridge, Carry, Group, Loop, Mesh, Stage
from graphkin.methods.structure import Hinge, Structure
from graphkin.steps import (
    Across,
    AcrossGuide,
    Along,
    AlongGuide,
    Chain,
    Construction,
    Coriolis,
    Direction,
    Drawn,
    Driven,
    Equation,
    Given,
    Image,
    LayOff,
    Measure,
    Node,
    Normal,
    Plane,
    Quarter,
    Relative,
    Roll,
    Simultaneous,
    Site,
    Size,
    Step,
    Tangential,
    Term,
    Turning,
    Unknown,
)

__all__ = ["Labels", "motion"]


@dataclass
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
        else:
            link = self.structure.home(site.link)
        return self.numbered(point, link)

    def numbered(self, point: str, link: str) -> str:
        plain = point + self.structure.mechanism.called(link)
        numbered = self.structure.mechanism.called(link).isdigit() and not point[-1].isdigit()
        clear = numbered and plain not in self.structure.owners
        return plain if clear else f"{point}@{self.structure.mechanism.called(link)}"


@dataclass
class _Polygon:
    structure: Structure
    labels: Labels
    plane: Plane
    pole: str
    velocity: Callable[[Site], str]
    parts: list[Step | Equation] = field(default_factory=list)
    nodes: dict[str, Node] = field(default_factory=dict)
    at: dict[Site, str] = field(default_factory=dict)
    reserved: set[str] = field(default_factory=set)
    unknown: dict[Hop, Term] = field(default_factory=dict)
    apart: set[frozenset[Site]] = field(default_factory=set)
    asides: int = 0

    # --- names --------------------------------------------------------------------------------

    @property
    def prime(self) -> str:
        return "'" if self.plane == "acceleration" else ""

    def key(self, site: Site) -> Site:
        """A hinge moves as one point, whichever of its links it is seen as part of."""
        owners = self.structure.owners.get(site.point, ())
        return Site(site.point, owners[0]) if site.link in owners else site

    def name(self, site: Site) -> str:
        """The polygon's point of a site, known or to be found; points of the frame sit on the pole."""
        key = self.key(site)
        if key.link == FRAME:
            return self.pole
        if key not in self.at:
            label = self.labels.label(key)
            self.at[key] = self.new(label[0].lower() + label[1:] + self.prime, label, key)
        return self.at[key]

    def new(self, name: str, of: str, site: Site | None = None) -> str:
        assert name not in self.nodes, name
        self.nodes[name] = Node(name, of, site)
        return name

    def fixed(self, point: str) -> str:
        """A fixed point has a name of its own on the pole."""
        site = Site(point, FRAME)
        label = self.labels.label(site)
        return self.new(label[0].lower() + label[1:] + self.prime, label, site)

    def aside(self) -> str:
        self.asides += 1
        return self.new(f"*{self.asides}", "")

    def between(self, letter: str, link: str, of: str) -> str:
        """A corner of the polygon that is no point of the mechanism: n3', k'."""
        stem = letter if letter == "k" else letter + self.structure.mechanism.called(link)
        for more in ("", *(str(k) for k in range(1, 1000))):
            dot = "_" if more and stem[-1].isdigit() else ""
            name = f"{stem}{dot}{more}'"
            if name not in self.nodes and name not in self.reserved:
                return self.new(name, of)
        raise AssertionError("a thousand corners of one name")

    def known(self, site: Site) -> bool:
        key = self.key(site)
        return key.link == FRAME or key in self.at

    # --- terms --------------------------------------------------------------------------------

    def absolute(self, site: Site) -> tuple[Term, ...]:
        """The known end of a side; nothing where it is at rest."""
        node = self.name(site)
        if node == self.pole:
            return ()
        return (Term(self.labels.label(site), "", "", Drawn(self.pole, node), None, self.pole, node),)

    def rest(self, site: Site) -> Term:
        """A point at rest where a side has nothing else."""
        return Term(self.labels.label(site), "", "", Drawn(self.pole, self.pole), None, self.pole, self.pole)

    def terms(self, hop: Hop, last: bool) -> list[Term]:
        """The arrows of one hop from `seen_from` outward to `of`.

        last  whether known arrows come after the unknown one, so that they lie at the far end
        """
        pieces = self.pieces(hop)
        if last:
            pieces.reverse()
        tail, terms = self.name(hop.seen_from), []
        of, seen_from = self.labels.label(hop.of), self.labels.label(hop.seen_from)
        if isinstance(hop, Slip) and hop.seen_from.link == FRAME:
            seen_from = ""
        if isinstance(hop, Lever) and self.plane == "velocity" and tail == self.pole:
            seen_from = ""
        for k, (part, size, direction) in enumerate(pieces):
            if k == len(pieces) - 1:
                head = self.name(hop.of)
            else:
                letter = "k" if "k" in (part, pieces[k + 1][0]) else part[-1]
                head = self.between(letter, self.structure.home(hop.of.link), f"a^{part}_{of}{seen_from}")
            terms.append(Term(of, seen_from, part, size, direction, tail, head))
            if size is None:
                self.unknown[hop] = terms[-1]
            tail = head
        return terms

    def pieces(self, hop: Hop) -> list[tuple[str, Size | None, Direction | None]]:
        match hop:
            case Lever():
                return self.lever(hop)
            case Slip():
                return self.slip(hop)
            case Twist():
                return self.twist(hop)

    def lever(self, hop: Lever) -> list[tuple[str, Size | None, Direction | None]]:
        link, tail, head = hop.of.link, hop.seen_from.point, hop.of.point
        across = Across(tail, head)
        if self.plane == "velocity":
            return [("", Turning(link, tail, head) if hop.known else None, across)]
        swing = Tangential(link, tail, head) if hop.known else None
        return [("n", Normal(link, tail, head), Along(head, tail)), ("t", swing, across)]

    def slip(self, hop: Slip) -> list[tuple[str, Size | None, Direction | None]]:
        line = AlongGuide(hop.slide)
        block = self.structure.block(self.structure.slides[hop.slide])
        size = Driven(hop.slide, 1 if hop.of.link == block else -1) if hop.known else None
        if self.plane == "velocity" or hop.seen_from.link == FRAME:
            return [("", size, line)]
        tail, head = self.velocity(hop.seen_from), self.velocity(hop.of)
        link = self.structure.home(hop.seen_from.link)
        return [("k", Coriolis(link, tail, head), Quarter(link, tail, head)), ("r", size, line)]

    def twist(self, hop: Twist) -> list[tuple[str, Size | None, Direction | None]]:
        link, other, pivot, point = hop.of.link, hop.seen_from.link, hop.pivot, hop.of.point
        across = Across(pivot, point)
        if self.plane == "velocity":
            return [("", Relative(link, other, pivot, point), across)]
        tail, head = self.velocity(hop.seen_from), self.velocity(hop.of)
        return [
            ("k", Coriolis(other, tail, head), Quarter(other, tail, head)),
            ("rn", Relative(link, other, pivot, point, "n"), Along(point, pivot)),
            ("rt", Relative(link, other, pivot, point, "t"), across),
        ]

    # --- stages -------------------------------------------------------------------------------

    def loop(self, stage: Loop) -> None:
        hops = way_round(self.structure, stage)[1]
        if sum(not hop.known for hop in hops) > 2:
            chain = self._chain(stage)
            self.parts.append(Simultaneous(stage.angles, stage.slides, (chain,), ()))
            self.walk(stage)
            return
        start, left_hops, end, right_hops = halves(self.structure, stage)
        self.reach(start)
        self.reach(end)
        left, right = self.side(start, left_hops), self.side(end, right_hops)
        if self._swap(left, right):
            left, right = right, left
        of = left_hops[-1].of if left_hops else start
        free = not any(isinstance(part, Equation | LayOff) for part in self.parts)
        pole = self.pole if free and self.plane == "velocity" else ""
        equation = close(self.labels.label(of), left, right, {}, self.aside, _no_choice, pole)
        self.parts.append(equation)
        for hop in left_hops + right_hops:
            if not hop.known:
                self.measure(hop, self.unknown[hop])
        for body in stage.bodies:
            self.fill(body)

    def _swap(self, left: tuple[Term, ...], right: tuple[Term, ...]) -> bool:
        """A textbook puts the side that starts at rest first, and of two such the shorter one."""
        resting = [side[0].head == self.pole or not isinstance(side[0].size, Drawn) for side in (left, right)]
        if resting[0] != resting[1]:
            return resting[1]
        return resting[0] and len(right) < len(left)

    def side(self, start: Site, hops: tuple[Hop, ...]) -> tuple[Term, ...]:
        terms = list(self.absolute(start))
        if not terms and hops and isinstance(hops[0], Slip) and hops[0].seen_from.link != FRAME:
            terms = [self.rest(start)]
        unknown = [hop for hop in hops if not hop.known]
        for hop in hops:
            terms += self.terms(hop, last=len(unknown) == 2 and hop is unknown[1])
        return tuple(terms) or (self.rest(start),)

    def measure(self, hop: Hop, term: Term) -> None:
        if isinstance(hop, Lever):
            quantity = "omega" if self.plane == "velocity" else "alpha"
            lever = (hop.seen_from.point, hop.of.point)
            self.apart.add(frozenset((self.key(hop.seen_from), self.key(hop.of))))
            self.parts.append(Measure(quantity, hop.of.link, term.tail, term.head, lever))
        elif isinstance(hop, Slip):
            self.measure_slip(hop, term)

    def measure_slip(self, hop: Slip, term: Term) -> None:
        block = self.structure.block(self.structure.slides[hop.slide])
        quantity = "s_rate" if self.plane == "velocity" else "s_acceleration"
        sign = 1 if hop.of.link == block else -1
        self.parts.append(Measure(quantity, hop.slide, term.tail, term.head, sign=sign))

    def mesh(self, stage: Mesh) -> None:
        """Pure rolling gives the contact of the one wheel the velocity of the other's; a rack follows its pinion."""
        letter = next(one for one, contact in touching(self.structure) if contact == stage.contact)
        wheel = self._turned_by(stage)
        if wheel is None or not self.known(wheel):
            self.parts.append(Roll(in_step(stage.contact), stage.angle, stage.slide))
            return
        other = next(w for w in stage.contact.wheels if w != wheel.link)
        of, at = Site(letter, wheel.link), Site(letter, other)
        self.reach(at)
        if self.plane == "velocity":
            self.at[self.key(of)] = self.name(at)
            self.parts.append(Measure("omega", wheel.link, self.name(wheel), self.name(of), (wheel.point, letter)))
        else:
            self.roll_acceleration(stage.contact, wheel, of, at)
        self.apart.add(frozenset((self.key(wheel), self.key(of))))

    def _turned_by(self, stage: Mesh) -> Site | None:
        """The centre of the wheel whose turning the contact gives, where it is one of the two wheels."""
        for wheel, centre in zip(stage.contact.wheels, stage.contact.centres, strict=True):
            if stage.angle and self.structure.base(wheel) == stage.angle and centre:
                return Site(centre, wheel)
        return None

    def roll_acceleration(self, contact: Contact, centre: Site, of: Site, at: Site) -> None:
        """The contacts of two wheels differ in acceleration along their common normal only."""
        lever = Lever(centre, of, False)
        left = self.side(centre, (lever,))
        normal: Direction = AcrossGuide(contact.slide) if contact.slide else Along(*contact.centres)
        label, other = self.labels.label(of), self.labels.label(at)
        start = self.absolute(at)
        tail = start[-1].head if start else self.pole
        sliding = Term(label, other, "", None, normal, tail, self.name(of))
        equation = close(label, left, (*start, sliding), {}, self.aside, _no_choice)
        self.parts.append(equation)
        self.measure(lever, self.unknown[lever])

    def train(self, stage: Group) -> bool:
        """A planet between two wheels of known motion: both its contacts are known, and so is all of it."""
        if self.plane != "velocity" or stage.loops or len(stage.contacts) != 2:
            return False
        planets = set(stage.contacts[0].wheels) & set(stage.contacts[-1].wheels)
        arm = stage.contacts[0].arm
        if len(planets) != 1:
            return False
        planet = planets.pop()
        letters = {contact: letter for letter, contact in touching(self.structure)}
        sites = []
        for contact in stage.contacts:
            other = next(wheel for wheel in contact.wheels if wheel != planet)
            if self.structure.base(other) in stage.angles or contact.arm != arm or not self.base_of(other):
                return False
            sites.append((Site(letters[contact], planet), Site(letters[contact], other)))
        for of, at in sites:
            self.reach(at)
            self.at[self.key(of)] = self.name(at)
        (first, _), (second, _) = sites
        self.parts.append(
            Measure("omega", planet, self.name(first), self.name(second), (first.point, second.point))
        )
        self.apart.add(frozenset((self.key(first), self.key(second))))
        self.arm(arm, planet, stage.contacts[0])
        return True

    def arm(self, arm: str, planet: str, contact: Contact) -> None:
        """The arm's turning from the planet's centre."""
        centre = contact.centres[contact.wheels.index(planet)]
        self.reach(Site(centre, planet))
        pivot = next(site for site in self.base_of(arm) if site.point != centre)
        nodes = self.name(pivot), self.name(Site(centre, arm))
        self.parts.append(Measure("omega", arm, *nodes, (pivot.point, centre)))

    # --- groups -------------------------------------------------------------------------------

    def group(self, stage: Group, found: Ternary | None) -> None:
        if found is None:
            if not self.train(stage):
                self.together(stage)
        else:
            self.special(found)
        waiting = list(stage.bodies)
        while waiting:
            body = next(b for b in waiting if self.base_of(b) or self._slid_from(b))
            waiting.remove(body)
            if not self.base_of(body):
                self.driven(self._slid_from(body), body)
            self.fill(body)

    def _slid_from(self, body: str) -> str:
        """A slide whose other link is drawn."""
        for name, pair in self.structure.slides.items():
            ends = pair.guide, self.structure.block(pair)
            if body in ends:
                other = ends[0] if body == ends[1] else ends[1]
                if other == FRAME or self.base_of(other):
                    return name
        return ""

    def special(self, found: Ternary) -> None:
        """Two equations by way of the special point, then what each leg turns or slides."""
        first, second, third = found.legs
        point = Site(found.name, found.link)
        for leg in found.legs:
            self.reach(leg.start)
        grounded = first.start.link == second.start.link == FRAME
        if self.structure.centres and grounded and self.plane == "velocity":
            self.at[self.key(point)] = self.pole
        else:
            sides = [self.leg(leg, point) for leg in (first, second)]
            self.parts.append(close(self.labels.label(point), sides[0], sides[1], {}, self.aside, _no_choice))
        lever = Lever(point, third.end, False)
        left, right = self.side(point, (lever,)), self.side(third.start, third.hops)
        if self._swap(left, right):
            left, right = right, left
        self.parts.append(close(self.labels.label(third.end), left, right, {}, self.aside, _no_choice))
        self.measure(lever, self.unknown[lever])
        self.measure(third.unknown, self.unknown[third.unknown])
        for leg in (first, second):
            self.reach(leg.end)
            self.measure_leg(leg)

    def leg(self, leg: Leg, point: Site) -> tuple[Term, ...]:
        """Known arrows first, then the two unknown ones that lie on one line."""
        terms = list(self.absolute(leg.start))
        pieces: list[tuple[str, str, str, Size]] = []
        over = self.labels.label(leg.end)
        for hop in leg.hops:
            seen_from, of = self.labels.label(hop.seen_from), self.labels.label(hop.of)
            pieces += [(of, seen_from, part, size) for part, size, _ in self.pieces(hop) if size is not None]
        final = Lever(leg.end, point, True)
        label = self.labels.label(point)
        if self.plane == "acceleration":
            part, size, _ = self.pieces(final)[0]
            assert size is not None
            pieces.append((label, over, part, size))
        tail = terms[-1].head if terms else self.name(leg.start)
        for of, seen_from, part, size in pieces:
            letter, link = "k" if part == "k" else "n", self.structure.home(leg.end.link)
            head = self.between(letter, link, f"a^{part}_{of}{seen_from}")
            direction = self._direction_of(size, leg, point)
            terms.append(Term(of, seen_from, part, size, direction, tail, head))
            tail = head
        unknown = leg.unknown
        seen_from = self.labels.label(unknown.seen_from)
        if unknown.seen_from.link == FRAME and (self.plane == "velocity" or isinstance(unknown, Slip)):
            seen_from = ""
        part = "" if self.plane == "velocity" else ("t" if isinstance(unknown, Lever) else "r")
        if isinstance(unknown, Slip) and unknown.seen_from.link == FRAME:
            part = ""
        terms.append(Term(label, seen_from, part, None, leg.way, tail, self.name(point), over))
        return tuple(terms)

    def _direction_of(self, size: Size, leg: Leg, point: Site) -> Direction:
        match size:
            case Normal(_, tail, head):
                return Along(head, tail)
            case Coriolis(link, tail, head):
                return Quarter(link, tail, head)
            case Driven(slide, _):
                return AlongGuide(slide)
            case Turning(_, tail, head) | Tangential(_, tail, head):
                return Across(tail, head)
            case _:
                return leg.way

    def measure_leg(self, leg: Leg) -> None:
        """With the ternary link known, its end's arrow gives what the leg itself does."""
        hop = leg.unknown
        for later in reversed(leg.hops[leg.hops.index(hop) + 1 :]):
            for term in reversed(self.terms(later, last=False)):
                self.parts.append(LayOff(term, term.head, term.tail, backwards=True))
        tail, head = self.name(hop.seen_from), self.name(hop.of)
        if isinstance(hop, Lever):
            quantity = "omega" if self.plane == "velocity" else "alpha"
            self.parts.append(Measure(quantity, hop.of.link, tail, head, (hop.seen_from.point, hop.of.point)))
        elif isinstance(hop, Slip):
            quantity = "s_rate" if self.plane == "velocity" else "s_acceleration"
            self.parts.append(Measure(quantity, hop.slide, tail, head, sign=self._sense(hop)))

    def walk(self, stage: Loop) -> None:
        """Draw every site of a loop whose unknowns have been found, hop by hop."""
        for hop in way_round(self.structure, stage)[1]:
            if isinstance(hop, Lever):
                self.reach(hop.of)
            elif isinstance(hop, Slip) and not self.known(hop.of):
                self.sum(hop.of, self.side(hop.seen_from, (Slip(hop.seen_from, hop.of, True, hop.slide),)))
        for body in stage.bodies:
            self.fill(body)

    def together(self, stage: Group) -> None:
        """All chains at once, by calculation."""
        chains = tuple(self._chain(loop) for loop in stage.loops)
        contacts = tuple(in_step(contact) for contact in stage.contacts)
        self.parts.append(Simultaneous(stage.angles, stage.slides, chains, contacts))

    def _chain(self, loop: Loop) -> Chain:
        start, hops, end = way_round(self.structure, loop)
        self.reach(start)
        self.reach(end)
        known: list[tuple[Size, int]] = [(Drawn(self.name(end), self.name(start)), 1)]
        unknown: list[Unknown] = []
        for hop in hops:
            for _, size, _ in self.pieces(hop):
                if size is not None:
                    known.append((size, 1))
                elif isinstance(hop, Slip):
                    unknown.append(Unknown("", hop.slide, "", "", self._sense(hop)))
                else:
                    unknown.append(Unknown(hop.of.link, "", hop.seen_from.point, hop.of.point, 1))
        return Chain(tuple(known), tuple(unknown))

    def _sense(self, hop: Slip) -> int:
        """Whether the block is seen from its guide."""
        return 1 if hop.of.link == self.structure.block(self.structure.slides[hop.slide]) else -1

    def carry(self, stage: Carry) -> None:
        if not isinstance(stage.by, Hinge):
            self.driven(stage.by.slide, stage.body)
        self.fill(stage.body)

    def driven(self, slide: str, body: str) -> None:
        """A body that a driver moves along a known one."""
        pair = self.structure.slides[slide]
        other = pair.guide if body != pair.guide else self.structure.block(pair)
        seen_from, of = Site(pair.point, other), Site(pair.point, body)
        if self.known(of):
            return
        self.reach(seen_from)
        right = self.side(seen_from, (Slip(seen_from, of, True, slide),))
        self.sum(of, right)

    def sum(self, of: Site, right: tuple[Term, ...]) -> None:
        label, node = self.labels.label(of), self.name(of)
        if len(right) == 1:
            self.parts.append(LayOff(right[0], right[0].tail, right[0].head))
        else:
            self.parts.append(known_sum(label, Term(label, "", "", None, None, self.pole, node), right))

    def bridge(self, stage: Bridge) -> None:
        tail, head = stage.points
        quantity = "omega" if self.plane == "velocity" else "alpha"
        self.bridge_measure(quantity, stage.body, tail, head)
        self.fill(stage.body)

    def bridge_measure(self, quantity: str, body: str, tail: str, head: str) -> None:
        """In the acceleration plane the normal part has no moment about the tail, so the whole arrow serves."""
        nodes = self.name(Site(tail, body)), self.name(Site(head, body))
        self.parts.append(Measure(quantity, body, *nodes, (tail, head)))

    # --- further points -----------------------------------------------------------------------

    def fill(self, body: str) -> None:
        for point in self.structure.bodies[body]:
            if point[0].isupper():
                self.reach(Site(point, body))

    def reach(self, site: Site) -> None:
        """Draw a site of a link whose motion is known: by image on two known points, else from one."""
        if self.known(site):
            return
        base = self.base_of(site.link)
        if len(base) > 1:
            first, second = base[:2]
            corners = (first.point, second.point, site.point)
            nodes = (self.name(first), self.name(second))
            self.parts.append(Image(site.link, corners, nodes, self.name(site)))
        else:
            self.levered(base[0], site)

    def base_of(self, body: str) -> list[Site]:
        """Known sites of a body that lie apart, its own points first."""
        own = [Site(point, body) for point in self.structure.bodies[body] if point[0].isupper()]
        more = [key for key in self.at if key.link == body and key not in own]
        known = [site for site in own + more if self.known(site)]
        pairs = combinations(known, 2)
        return next(([*pair] for pair in pairs if self._apart(body, *pair)), known[:1])

    def _apart(self, body: str, first: Site, second: Site) -> bool:
        """Points of one link are apart by their shape; a coincident point may come to lie on another,
        but not on the one whose lever has just been measured.
        """
        if frozenset((self.key(first), self.key(second))) in self.apart:
            return True
        points = self.structure.bodies[body]
        if first.point in points and second.point in points and not self.structure.is_pin(body):
            shape = self.structure.shapes[body]
            return abs(shape[second.point] - shape[first.point]) > 0
        return False

    def levered(self, start: Site, site: Site) -> None:
        """From one known point by the link's known rotation."""
        hop = Lever(Site(start.point, site.link), site, True)
        right = self.absolute(start) + tuple(self.terms(hop, last=False))
        if self.plane == "acceleration" and self.structure.steady(site.link):
            right = self._without_tangential(right)
        self.sum(site, right)

    def _without_tangential(self, right: tuple[Term, ...]) -> tuple[Term, ...]:
        normal, tangential = right[-2:]
        self.nodes.pop(normal.head)
        absolute = normal.tail == self.pole
        only = Term(
            normal.of,
            "" if absolute else normal.seen_from,
            "" if absolute else "n",
            normal.size,
            normal.direction,
            normal.tail,
            tangential.head,
        )
        return (*right[:-2], only)


def motion(
    structure: Structure,
    order: tuple[Stage, ...],
    labels: Labels,
    plane: Plane,
    pole: str,
    velocity: Callable[[Site], str],
    ternaries: Mapping[Group, Ternary],
) -> tuple[Construction, Callable[[Site], str]]:
    """One polygon, and the name in it of each site; the acceleration polygon asks the velocity polygon's."""
    prime = "'" if plane == "acceleration" else ""
    polygon = _Polygon(structure, labels, plane, pole + prime, velocity)
    polygon.new(polygon.pole, "pole")
    polygon.reserved = {point[0].lower() + point[1:] + prime for point in structure.owners}
    fixed = tuple(point for point in structure.bodies[FRAME] if point[0].isupper())
    names = tuple(polygon.fixed(point) for point in fixed)
    polygon.parts.append(Given(polygon.pole, names))
    for stage in order:
        match stage:
            case Carry():
                polygon.carry(stage)
            case Bridge():
                polygon.bridge(stage)
            case Mesh():
                polygon.mesh(stage)
            case Loop():
                polygon.loop(stage)
            case Group():
                polygon.group(stage, ternaries.get(stage))
    return Construction(plane, tuple(polygon.parts), polygon.nodes, polygon.pole), polygon.name


def _no_choice() -> int:
    raise AssertionError("direction lines cross once")
