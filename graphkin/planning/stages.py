"""The order of solution: which bodies become known after which, from topology alone.

Kinds of stage. `Carry`: a body whose angle is known hangs on a known point or a known displacement.
`Bridge`: a body joins two known points (it repeats a constraint that others keep). `Mesh`: wheels that roll
on each other leave one angle or displacement to be found. `Loop`: a way round through unknown bodies, from
known to known, with exactly two unknown scalars (the angle of a group of links, the displacement of a
slide): the Assur dyads RRR, RRP, RPR, PRP, RPP in every order, and longer ways whose further terms are
driven. Two unknowns are what one vector equation gives, so the same loop is closed in all three planes.
`Group`: the fewest loops and rolling contacts that only together have as many unknowns as equations: an
Assur group of Class III or higher, or a gear train whose planets and arm hang on each other. Links that are closed in
themselves give their angles before any of them has a place: such a loop floats, from an unknown hinge back to it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from itertools import combinations

from graphkin.base.value import frozen
from graphkin.base.worklist import Waiting
from graphkin.construction import slide_key
from graphkin.planning.equivalent import Contact
from graphkin.planning.loop_search import KnownMotion, LoopPaths
from graphkin.planning.structure import Hinge, Joint, Topology

MOST = 8  # unknown scalars of one loop of a group
_FEW = 8  # loops and contacts of which every set is tried as a group


@frozen
class Carry:
    """`body` becomes known by its known angle and the joint `by`."""

    body: str
    by: Joint


@frozen
class Bridge:
    """`body` becomes known by two known points."""

    body: str
    points: tuple[str, str]


@frozen
class Loop:
    """From known over `joints[0]`, `bodies[0]`, `joints[1]`, .. back to known; in a group also from a hinge back to it.
    Two unknown scalars in all: `angles` of bases of groups of links, and `slides`."""

    bodies: tuple[str, ...]
    joints: tuple[Joint, ...]
    angles: tuple[str, ...]
    slides: tuple[str, ...]


@frozen
class Mesh:
    """One rolling contact gives the last unknown of its wheels: the angle of a group of links, or a displacement."""

    contact: Contact
    angle: str = ""
    slide: str = ""


@frozen
class Group:
    """Loops and contacts whose unknown scalars can only be found together; `bodies` have their places then: those of
    all loops but the floating ones."""

    bodies: tuple[str, ...]
    loops: tuple[Loop, ...]
    contacts: tuple[Contact, ...]
    angles: tuple[str, ...]
    slides: tuple[str, ...]

    @property
    def floating(self) -> tuple[Loop, ...]:
        """The loops whose links have no place yet."""
        return tuple(loop for loop in self.loops if not {*loop.bodies} <= {*self.bodies})


Stage = Carry | Bridge | Mesh | Loop | Group


def stages(structure: Topology) -> tuple[tuple[Stage, ...], tuple[str, ...]]:
    """The stages in the order a textbook takes them, and the bodies that no stage reaches."""
    search, order = _StageSearch(structure), list[Stage]()
    left = len(search.bodies) - len(search.known.bodies)
    while left and (stage := search.next()) is not None:
        order.append(stage)
        before = len(search.known.bodies)
        search.learn(stage)
        left -= len(search.known.bodies) - before
    return tuple(order), tuple(body for body in search.bodies if body not in search.known.bodies)


class _StageSearch:
    """The search for the next stage, close to what has just become known."""

    def __init__(self, structure: Topology) -> None:
        self.structure = structure
        self.known = KnownMotion(structure, slides=set(structure.slides_driven))
        self.bodies = tuple(structure.bodies)
        self.contacts = tuple(structure.tying)
        self.to_carry, self.to_bridge = Waiting(len(self.bodies)), Waiting(len(self.bodies))
        self.to_mesh = Waiting(len(self.contacts))
        self.open = {k: self._open(contact) for k, contact in enumerate(self.contacts)}
        """The unknowns of each rolling contact, as long as it has any."""
        self.loops = LoopPaths(self.known, 2)
        self.rare_loops: dict[tuple[int, bool], LoopPaths] = {}

    def next(self) -> Stage | None:
        body = self.to_carry.first(self._carry) or self.to_bridge.first(self._bridge)
        if (stage := body or self.to_mesh.first(self._mesh)) is not None:
            return stage
        if (path := self.loops.first()) is not None:
            return Loop(*path)
        if (path := self._rare(2, True).first()) is not None:  # of links that are closed in themselves
            loop = Loop(*path)
            return self._as_group([loop], _keys(loop.angles, loop.slides))
        return self._group(False) or self._group(True)

    def learn(self, stage: Stage) -> None:
        match stage:
            case Carry() | Bridge():
                news = self.known.learn((stage.body,), (self.structure.base(stage.body),), ())
            case Mesh():
                news = self.known.learn((), {stage.angle} - {""}, {stage.slide} - {""})
            case Loop() | Group():
                news = self.known.learn(stage.bodies, stage.angles, stage.slides)
        order = [self.structure.order[body] for body in news.close]
        self.to_carry.call(order)
        self.to_bridge.call(order)
        names = _keys(news.angles, news.slides)
        tied = {k for name in names for k in self._tied.get(name, ()) if k in self.open}
        self.to_mesh.call(tied)
        for k in tied:
            self.open[k] = self._open(self.contacts[k])
            if not any(self.open[k]):
                del self.open[k]
        for paths in (self.loops, *self.rare_loops.values()):
            paths.call(news.close)

    @cached_property
    def _tied(self) -> dict[str, list[int]]:
        """The contacts in which each angle, by its base, and each displacement counts."""
        tied: dict[str, list[int]] = {}
        for k, contact in enumerate(self.contacts):
            bases = (self.structure.base(body) for body, _ in contact.angles)
            for name in _keys(bases, [contact.slide, *(slide for slide, _ in contact.way)]):
                tied.setdefault(name, []).append(k)
        return tied

    def _carry(self, number: int) -> Carry | None:
        body, known = self.bodies[number], self.known
        if body in known.bodies or self.structure.base(body) not in known.angles:
            return None
        for joint, others in self.structure.joints(body):
            if (isinstance(joint, Hinge) or joint.slide in known.slides) and known.joint(joint, others):
                return Carry(body, joint)
        return None

    def _bridge(self, number: int) -> Bridge | None:
        body = self.bodies[number]
        if body in self.known.bodies or self.structure.is_pin(body):
            return None
        points = [point for point in self.structure.bodies[body] if point in self.known.points]
        return Bridge(body, (points[0], points[1])) if len(points) > 1 else None

    def _mesh(self, number: int) -> Mesh | None:
        angles, slides = self.open.get(number, ({}, {}))
        if len(angles) + len(slides) != 1:
            return None
        return Mesh(self.contacts[number], next(iter(angles), ""), next(iter(slides), ""))

    def _open(self, contact: Contact) -> tuple[dict[str, None], dict[str, None]]:
        bases = (self.structure.base(body) for body, _ in contact.angles)
        angles = dict.fromkeys(base for base in bases if base not in self.known.angles)
        shares = contact.way if contact.slide not in self.known.slides else ()
        needed = [slide for slide, _ in shares] or [contact.slide]
        slides = dict.fromkeys(slide for slide in needed if slide and slide not in self.known.slides)
        return angles, slides

    def _rare(self, most: int, floating: bool) -> LoopPaths:
        """Paths that few mechanisms need."""
        if (most, floating) not in self.rare_loops:
            self.rare_loops[most, floating] = LoopPaths(self.known, most, floating)
        return self.rare_loops[most, floating]

    def _group(self, floating: bool) -> Group | None:
        """The smallest set of loops and contacts with as many unknowns as equations."""
        loops = [Loop(*path) for path in self._rare(MOST, floating).independent()]
        members: list[tuple[Loop | Contact, frozenset[str], int]] = [
            (loop, _keys(loop.angles, loop.slides), 2) for loop in loops
        ]
        members += [(self.contacts[k], _keys(angles, slides), 1) for k, (angles, slides) in self.open.items()]
        chosen = fewest_closed([names for _, names, _ in members], [equations for *_, equations in members])
        if chosen is None:
            return None
        unknown = frozenset[str]().union(*(members[k][1] for k in chosen))
        return self._as_group([members[k][0] for k in chosen], unknown)

    def _as_group(self, members: Sequence[Loop | Contact], unknown: frozenset[str]) -> Group:
        loops = tuple(member for member in members if isinstance(member, Loop))
        contacts = tuple(member for member in members if isinstance(member, Contact))
        hanging = (loop for loop in loops if not self.known.floats(loop.joints))
        bodies = tuple(dict.fromkeys(body for loop in hanging for body in loop.bodies))
        slides = tuple(name for name in self.structure.slides if slide_key(name) in unknown)
        angles = tuple(body for body in self.structure.bodies if body in unknown)
        return Group(bodies, loops, contacts, angles, slides)


def _keys(angles: Iterable[str], slides: Iterable[str]) -> frozenset[str]:
    """Unknown scalars in one set, though a file may call a link and a slide alike."""
    return frozenset([*angles, *map(slide_key, slides)])


def fewest_closed(names: list[frozenset[str]], equations: list[int]) -> tuple[int, ...] | None:
    """The fewest parts that together have as many unknowns as equations; the first of those in order. Each equation
    takes an unknown for itself (a matching). A part then needs the parts that have taken its other unknowns, they need
    others, and so on; where an unknown is left that nobody took, no such set holds the part."""
    if len(names) <= _FEW:
        return next(
            (chosen for count in range(1, len(names) + 1) for chosen in combinations(range(len(names)), count)
             if len(frozenset[str]().union(*(names[k] for k in chosen))) == sum(equations[k] for k in chosen)), None,
        )  # fmt: skip
    takers: dict[str, int] = {}
    kept = []
    for k in range(len(names)):
        if all(_one_more(k, names, takers) for _ in range(equations[k])):
            kept.append(k)
        else:  # it goes without
            takers = {name: part for name, part in takers.items() if part != k}
    most = 1
    while most < 2 * len(kept):  # sets of a few first: what a part needs may go on through the whole mechanism
        sets = [chosen for k in kept if (chosen := _needed(k, names, takers, most))]
        if sets:
            return min(sets, key=lambda chosen: (len(chosen), chosen))
        most *= 2
    return None


def _one_more(part: int, names: list[frozenset[str]], takers: dict[str, int]) -> bool:
    """Give a part an unknown that is free; or one that another has, which takes a further one, and so on."""
    for name in names[part]:
        if name not in takers:
            takers[name] = part
            return True
    claims: dict[str, int] = {}  # by unknown, the part that would take it
    offers: dict[int, str] = {part: ""}  # by part, the unknown that it would give up
    for one in (queue := [part]):
        for name in names[one]:
            if name in claims:
                continue
            claims[name] = one
            if name not in takers:
                while name:  # who claims it takes it, and gives its own to the one that claims that
                    takers[name] = claims[name]
                    name = offers[claims[name]]
                return True
            if takers[name] not in offers:
                offers[takers[name]] = name
                queue.append(takers[name])
    return False


def _needed(part: int, names: list[frozenset[str]], takers: dict[str, int], most: int) -> tuple[int, ...]:
    """The parts without which this one leaves an unknown open, itself among them; none if that, or if too many."""
    chosen, queue = {part}, [part]
    for one in queue:
        for name in names[one]:
            if name not in takers:
                return ()
            if takers[name] not in chosen:
                if len(chosen) == most:
                    return ()
                chosen.add(takers[name])
                queue.append(takers[name])
    return tuple(sorted(chosen))
