"""A polygon under construction: the names of its points, and the arrows of each hop of a way round."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field, replace
from itertools import chain, count

from graphkin.base.value import filled
from graphkin.construction import Direction, Equation, LayOff, Measure, Node, Plane, Site, Size, Step, Term, terms
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import image_name, primes
from graphkin.planning.closing import close, known_first, pole_is_last
from graphkin.planning.labels import Labels
from graphkin.planning.loop_terms import Hop, LinkArm, Slip, Twist
from graphkin.planning.structure import Topology

Piece = tuple[str, Size | None, Direction | None]
"""The part (`n`, `t`, `k`, `r`), size and direction of one arrow of a hop."""
TIPS = {"n": "nmuw", "t": "tyxw", "k": "kgjx", "r": "rqsz"}
"""Letters for the tips of normal, tangential, Coriolis and relative arrows; the first that no point has."""


@filled
class PolygonPlan:
    """The steps so far, and where the sites drawn by them are.

    velocity  the velocity polygon's name of a site, for Coriolis terms
    at        the polygon's point of each site that is drawn or to be found; of_link: these sites, by link
    letters   those of tips, once they are chosen
    unknown   the arrow of each hop whose size is sought
    apart     pairs of sites of one link that are known to lie apart
    """

    structure: Topology
    labels: Labels
    plane: Plane
    pole: str
    velocity: Callable[[Site], str]
    parts: list[Step | Equation] = field(default_factory=list)
    nodes: dict[str, Node] = field(default_factory=dict)
    at: dict[Site, str] = field(default_factory=dict)
    of_link: dict[str, dict[Site, None]] = field(default_factory=dict)
    letters: dict[str, str] = field(default_factory=dict)
    unknown: dict[Hop, Term] = field(default_factory=dict)
    apart: set[frozenset[Site]] = field(default_factory=set)

    def key(self, site: Site) -> Site:
        """A hinge moves as one point, whichever of its links it is seen as part of."""
        return self.structure.seen_as.get(site, site)

    def name(self, site: Site) -> str:
        """The polygon's point of a site, known or to be found; points of the frame sit on the pole."""
        key = self.key(site)
        if key.link == FRAME:
            return self.pole
        if (name := self.at.get(key)) is None:
            name = self.put(key, self._image(key))
        return name

    def put(self, key: Site, name: str) -> str:
        """A site lies at a point of the polygon."""
        self.at[key] = name
        self.of_link.setdefault(key.link, {})[key] = None
        return name

    def new(self, name: str, of: str, site: Site | None = None) -> str:
        assert name not in self.nodes, name
        self.nodes[name] = Node(name, of, site)
        return name

    def fixed(self, point: str) -> str:
        """A fixed point has a name of its own on the pole."""
        return self._image(Site(point, FRAME))

    def _image(self, site: Site) -> str:
        label = self.labels.label(site)
        return self.new(image_name(self.structure.mechanism, self.plane, label), label, site)

    def between(self, letter: str, link: str, of: str) -> str:
        """A corner of the polygon that is no point of the mechanism: n3', n_arm', k'; by a letter that no point has."""
        if letter not in self.letters:
            initials = self.labels.initials | {self.pole[0]}
            self.letters[letter] = next((other for other in TIPS[letter] if other not in initials), letter)
        called = self.structure.mechanism.called(link)
        worded = self.structure.is_link(link) and not called[0].isdigit()
        stem = self.letters[letter] + ("" if letter == "k" else ("_" if worded else "") + called)
        prime, reserves = primes(self.structure.mechanism, self.plane), self.labels.reserves
        stems = chain([stem], (f"{stem}{'' if letter == 'k' else '_'}{k}" for k in count(1)))
        return self.new(next(s + prime for s in stems if s + prime not in self.nodes and not reserves(s)), of)

    def known(self, site: Site) -> bool:
        key = self.key(site)
        return key.link == FRAME or key in self.at

    def absolute(self, site: Site) -> tuple[Term, ...]:
        """The known end of a side; nothing where it is at rest."""
        node = self.name(site)
        return () if node == self.pole else (self._from_pole(site, node),)

    def _from_pole(self, site: Site, node: str) -> Term:
        return Term(self.labels.label(site), "", "", terms.Drawn(self.pole, node), None, self.pole, node, sites=(site,))

    def terms(self, hop: Hop) -> list[Term]:
        """The arrows of one hop from `seen_from` outward to `of`, an unknown one last."""
        pieces = self.pieces(hop)
        tail, arrows, sites = self.name(hop.seen_from), list[Term](), (hop.of, hop.seen_from)
        of, seen_from = self.labels.label(hop.of), self.seen_from(hop)
        for k, (part, size, direction) in enumerate(pieces):
            if k == len(pieces) - 1:
                head = self.name(hop.of)
            else:
                head = self.between(part[-1], self.structure.home(hop.of.link), f"a^{part}_{of}{seen_from}")
            arrows.append(Term(of, seen_from, part, size, direction, tail, head, sites=sites))
            if size is None:
                self.unknown[hop] = arrows[-1]
            tail = head
        return arrows

    def seen_from(self, hop: Hop) -> str:
        """The second site in the name of a hop's arrows; none where the motion is an absolute one."""
        sliding_on_frame = isinstance(hop, Slip) and hop.seen_from.link == FRAME
        about_fixed = isinstance(hop, LinkArm) and self.plane == "velocity" and self.name(hop.seen_from) == self.pole
        return "" if sliding_on_frame or about_fixed else self.labels.label(hop.seen_from)

    def pieces(self, hop: Hop) -> list[Piece]:
        """The arrows of one hop, an unknown one last."""
        link, tail, head, in_velocity = hop.of.link, hop.seen_from.point, hop.of.point, self.plane == "velocity"
        match hop:
            case LinkArm(known=known):
                across = terms.Across(tail, head)
                if in_velocity:
                    return [("", terms.Turning(link, tail, head) if known else None, across)]
                swing = terms.Tangential(link, tail, head) if known else None
                return [("n", terms.Normal(link, tail, head), terms.Along(head, tail)), ("t", swing, across)]
            case Slip(seen_from, slide=slide):
                size, line = terms.Driven(slide, self.sense(hop)) if hop.known else None, terms.AlongGuide(slide)
                if in_velocity or seen_from.link == FRAME:
                    return [("", size, line)]
                pin = self.structure.is_pin(seen_from.link)  # it turns with its slot
                turning = self.structure.slides[slide].guide if pin else seen_from.link
                return [self._coriolis(hop, turning), ("r", size, line)]
            case Twist(seen_from, pivot=pivot):
                other, across = seen_from.link, terms.Across(pivot, head)
                if in_velocity:
                    return [("", terms.Relative(link, other, pivot, head), across)]
                normal, tangent = (terms.Relative(link, other, pivot, head, part) for part in ("n", "t"))
                return [self._coriolis(hop, other), ("rn", normal, terms.Along(head, pivot)), ("rt", tangent, across)]

    def _coriolis(self, hop: Hop, link: str) -> Piece:
        """By the turning of a link, and the arrow between the hop's sites in the velocity polygon."""
        tail, head = self.velocity(hop.seen_from), self.velocity(hop.of)
        return "k", terms.Coriolis(link, tail, head), terms.Quarter(link, tail, head)

    def side(self, start: Site, hops: tuple[Hop, ...]) -> tuple[Term, ...]:
        arrows = list(self.absolute(start))
        if not arrows and hops and isinstance(hops[0], Slip) and hops[0].seen_from.link != FRAME:
            arrows = [self._from_pole(start, self.pole)]
        for hop in hops:
            arrows += self.terms(hop)
        return tuple(arrows) or (self._from_pole(start, self.pole),)  # at rest

    def equate(self, of: Site, left: tuple[Term, ...], right: tuple[Term, ...], pole: str = "") -> None:
        """Both sides of one vector equation, what is known first, drawn until they meet."""
        carried = list[LayOff]()
        if not pole_is_last(left, right, pole):
            (left, first, one), (right, second, other) = (known_first(side, self.corner) for side in (left, right))
            carried += (*first, *second)
            for before, after in filter(None, (one, other)):
                self.unknown = {hop: after if term is before else term for hop, term in self.unknown.items()}
        drawn = close(self.labels.label(of), left, right, {}, pole=pole)
        self.parts.append(replace(drawn, steps=(*drawn.steps, *carried)) if carried else drawn)

    def corner(self, term: Term) -> str | None:
        """A new corner for a known arrow that has moved and led to a point of a link."""
        if self.nodes[term.head].site is None:
            return None
        return self.between(term.part[-1:] or "r", self.structure.home(term.sites[0].link), term.name(self.plane))

    def in_order(self, first: tuple[Term, ...], second: tuple[Term, ...]) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
        """A textbook puts the side that starts at rest first, and of two such the shorter one."""
        resting = [side[0].head == self.pole or not isinstance(side[0].size, terms.Drawn) for side in (first, second)]
        swapped = resting[1] if resting[0] != resting[1] else resting[0] and len(second) < len(first)
        return (second, first) if swapped else (first, second)

    @property
    def turning(self) -> str:
        """The quantity of a link that this plane gives."""
        return "omega" if self.plane == "velocity" else "alpha"

    @property
    def sliding(self) -> str:
        """The quantity of a slide that this plane gives."""
        return "s_rate" if self.plane == "velocity" else "s_acceleration"

    def measure_unknown(self, hop: Hop) -> None:
        """Read off the arrow that an equation has given."""
        term = self.unknown[hop]
        self.measure(hop, term.tail, term.head)
        if isinstance(hop, LinkArm):
            self.lies_apart(hop.seen_from, hop.of)

    def measure(self, hop: Hop, tail: str, head: str) -> None:
        """Read off an arrow the motion of the link that turns, or of the slide."""
        if isinstance(hop, LinkArm):
            lever = (hop.seen_from.point, hop.of.point)
            self.parts.append(Measure(self.turning, hop.of.link, tail, head, lever))
        elif isinstance(hop, Slip):
            self.parts.append(Measure(self.sliding, hop.slide, tail, head, sign=self.sense(hop)))

    def sense(self, hop: Slip) -> int:
        """1 where the block is seen from its guide, -1 the other way round."""
        return 1 if hop.of.link == self.structure.block(self.structure.slides[hop.slide]) else -1

    def lies_apart(self, first: Site, second: Site) -> None:
        self.apart.add(frozenset((self.key(first), self.key(second))))
