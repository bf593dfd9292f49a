"""Points and links that stand still in the polygons because the drivers on which it hangs do (rate and acceleration 0).

The points that such drivers hold are written as what they are: fixed points, on the pole. The steps of a polygon stay
as they were planned, for drivers that move.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.tolerances import RANK
from graphkin.base.value import frozen
from graphkin.construction import Construction, Drawn, Equation, Facts, Plane, Step, Term, kinds
from graphkin.model.mechanism import FRAME
from graphkin.planning.method import Method
from graphkin.planning.needed import Fact, Part, PartsReader, turnings


@kept(2, objects=2)  # every reading of a position asks for them
def at_rest(method: Method, facts: Facts) -> frozenset[Fact]:
    """The facts that rest in both polygons."""
    rates = zip(facts.rates, facts.accelerations, strict=True)
    still = {k for k, (rate, more) in enumerate(rates) if rate == more == 0}
    held = [link if turn.base == FRAME else f"{link}/{turn.base}"
            for link, turn in facts.turns.items() if all(k in still for k, _ in turn.drivers)]  # fmt: skip
    slides = [slide for slide, k in facts.slides_driven.items() if k in still]
    rested = {(f"driven {quantity}", link) for quantity in ("omega", "alpha") for link in held}
    rested |= {(quantity, slide) for quantity in ("s_rate", "s_acceleration") for slide in slides}
    planes = [_resting(method, method.velocity, rested)]
    planes.append(_resting(method, method.acceleration, rested | planes[0]))
    links = [link for link in method.structure.bodies if link != FRAME]
    turns = [(turnings(method, "omega", link), turnings(method, "alpha", link)) for link in links]
    # what a polygon that is cut to what is needed does not measure or draw rests with the velocities
    reader = PartsReader(method, method.acceleration)
    away = {fact for _, alpha in turns for fact in alpha if fact[0] == "alpha"}
    planes[1] |= away.difference(*(reader.gives(part) for part in method.acceleration.parts))
    drawn = {node.site for node in method.acceleration.nodes.values()}
    both = {fact for omega, alpha in turns if {*omega} <= planes[0] and {*alpha} <= planes[1] for fact in omega + alpha}
    sites = [{c.nodes[name].site: (c.plane, name) for plane, name in one if plane == c.plane}
             for c, one in zip((method.velocity, method.acceleration), planes, strict=True)]  # fmt: skip
    rest = {site for site in sites[0] if site is not None and (site in sites[1] or site not in drawn)}
    return frozenset(both | {one[site] for site in rest for one in sites if site in one})


def _resting(method: Method, construction: Construction, rested: set[Fact]) -> set[Fact]:
    """The same with all that is found from nothing else by the parts of a polygon, its pole among them."""
    reader, resting = PartsReader(method, construction), set(rested)
    for step in construction.steps:
        if isinstance(step, kinds.Given) and step.also:
            resting |= set(reader.gives(step))
    resting.add((construction.plane, construction.pole))
    for part in construction.parts:
        needs = {fact for fact in reader.needs(part) if fact[0] not in ("position", "theta", "driven theta", "s")}
        if not isinstance(part, kinds.Given) and needs <= resting:
            resting |= set(reader.gives(part))
    return resting


def steady_turnings(method: Method, facts: Facts) -> frozenset[Fact]:
    """The angular accelerations that are nothing because wheels roll on what drivers move at steady rates."""
    steady = {k for k, more in enumerate(facts.accelerations) if np.all(more == 0)}
    bases = sorted({turn.base for turn in facts.turns.values()} - {FRAME})
    rows = []
    for contact in method.structure.contacts:
        turns = [(facts.turns[link], share) for link, share in contact.angles]
        slides = [slide for slide, _ in contact.way] or ([contact.slide] if contact.slide else [])
        drivers = {k for turn, _ in turns for k, _ in turn.drivers}
        if drivers | {facts.slides_driven.get(slide, -1) for slide in slides} <= steady:
            rows.append([sum(share for turn, share in turns if turn.base == base) for base in bases])
    if not (rows and bases):
        return frozenset()
    # turnings that the relations alone give: those that no motion which the relations allow has
    _, sizes, ways = np.linalg.svd(np.array(rows))
    free = ways[np.count_nonzero(sizes > RANK * max(sizes, default=0.0)) :]
    return frozenset(("alpha", base) for k, base in enumerate(bases) if np.all(abs(free[:, k]) < RANK))


def held_labels(method: Method, plane: Plane, rested: frozenset[Fact]) -> dict[str, str]:
    """The points of the mechanism that drivers at rest hold, by how they are written in the polygon, `D7`."""
    return {of: point for point, of in _held(method.construction(plane), rested).values()}


def moving_parts(method: Method, plane: Plane, parts: tuple[Part, ...], rested: frozenset[Fact]) -> tuple[Part, ...]:
    """The parts that find something that moves, with the pole for every point that does not."""
    construction = method.construction(plane)
    nodes, reader = _held(construction, rested), PartsReader(method, construction)
    writer = _PartsWriter(plane, construction.pole, nodes, {of: point for point, of in nodes.values()})
    sites = {name for name, node in construction.nodes.items() if node.site is not None}
    moving = list[Part]()
    for part in parts:
        facts = [] if isinstance(part, kinds.Given) else [*reader.gives(part)]
        facts = [(kind, name) for kind, name in facts if kind != plane or name in sites]  # corners do not count
        if not facts or not all(fact in rested for fact in facts):
            moving.append(writer.part(part))
    return tuple(moving)


def _held(construction: Construction, rested: frozenset[Fact]) -> dict[str, tuple[str, str]]:
    """By node of the polygon, its point and how it is written there; fixed points are on the pole anyway."""
    resting = ((name, node) for name, node in construction.nodes.items() if (construction.plane, name) in rested)
    return {name: (node.site.point, node.of) for name, node in resting if node.site and node.site.link != FRAME}


@frozen
class _PartsWriter:
    """Writes parts anew: `nodes` become the pole, `labels` the letters of their points."""

    plane: Plane
    pole: str
    nodes: Mapping[str, tuple[str, str]]
    labels: Mapping[str, str]

    def part(self, part: Part) -> Part:
        if not self.nodes:
            return part
        if isinstance(part, Equation):
            steps = tuple(self.step(step) for step in part.steps)
            return replace(part, left=self.side(part.left), right=self.side(part.right), steps=steps)
        return self.step(part)

    def step(self, step: Step) -> Step:
        if isinstance(step, kinds.LayOff):
            return replace(step, term=self.term(step.term), start=self.node(step.start), tip=self.node(step.tip))
        if isinstance(step, kinds.Ray):
            return replace(step, through=self.node(step.through))
        if isinstance(step, kinds.Meet):
            return replace(step, first=self.ray(step.first), second=self.ray(step.second))
        if isinstance(step, kinds.Image):
            return replace(step, base=(self.node(step.base[0]), self.node(step.base[1])))
        if isinstance(step, kinds.Measure):
            return replace(step, tail=self.node(step.tail), head=self.node(step.head))
        return step

    def ray(self, locus: kinds.Ray | kinds.Arc) -> kinds.Ray | kinds.Arc:
        return replace(locus, through=self.node(locus.through)) if isinstance(locus, kinds.Ray) else locus

    def side(self, terms: tuple[Term, ...]) -> tuple[Term, ...]:
        """A side of an equation without the motion of a point that has none, where anything is left."""
        held = isinstance(terms[0].size, Drawn) and terms[0].head in self.nodes
        return tuple(self.term(term) for term in (terms[1:] if held and len(terms) > 1 else terms))

    def term(self, term: Term) -> Term:
        return replace(relabelled(term, self.plane, self.labels), tail=self.node(term.tail), head=self.node(term.head))

    def node(self, name: str) -> str:
        return self.pole if name in self.nodes else name


def relabelled(term: Term, plane: Plane, labels: Mapping[str, str]) -> Term:
    """With the letters of fixed points; seen from one, a velocity is an absolute one."""
    absolute = plane == "velocity" and term.seen_from in labels
    seen_from = "" if absolute else labels.get(term.seen_from, term.seen_from)
    return replace(term, of=labels.get(term.of, term.of), seen_from=seen_from)
