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

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

from graphkin.base.value import frozen
from graphkin.base.worklist import Waiting
from graphkin.construction import slide_key
from graphkin.planning.closed_sets import fewest_closed
from graphkin.planning.equivalent import Contact
from graphkin.planning.known import Known
from graphkin.planning.loop_search import Ways, floats
from graphkin.planning.structure import Hinge, Joint, Topology

MOST = 8
"""Unknown scalars of one loop of a group."""


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

    angles, slides  the unknown scalars: bases of groups of links, slides; two in all
    """

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
    """Loops and contacts whose unknown scalars can only be found together.

    bodies  those that have their places then: of all loops but the floating ones
    """

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
    search = _StageSearch(structure)
    found = list(search.found())
    return tuple(found), tuple(search.known.unknown)


class _StageSearch:
    """What comes next, looked for close to what has just become known: a link of a long chain costs no more than one of
    a short chain."""

    def __init__(self, structure: Topology) -> None:
        self.structure = structure
        self.known = Known(structure, slides=set(structure.slides_driven))
        self.bodies = tuple(structure.bodies)
        self.contacts = tuple(structure.tying)
        self.to_carry, self.to_bridge = Waiting(len(self.bodies)), Waiting(len(self.bodies))
        self.to_mesh = Waiting(len(self.contacts))
        self.open = {k: self._open(contact) for k, contact in enumerate(self.contacts)}
        """What is unknown of each rolling contact, as long as anything is."""
        self.loops = Ways(self.known, 2)
        self.more_ways: dict[tuple[int, bool], Ways] = {}

    def found(self) -> Iterator[Stage]:
        left = len(self.bodies) - len(self.known.bodies)
        while left and (stage := self._next()) is not None:
            yield stage
            before = len(self.known.bodies)
            self._learn(stage)
            left -= len(self.known.bodies) - before

    def _next(self) -> Stage | None:
        body = self.to_carry.first(self._carried) or self.to_bridge.first(self._bridged)
        return (
            body or self.to_mesh.first(self._meshed) or self._loop() or self._floating()
            or self._group(False) or self._group(True)
        )  # fmt: skip

    def _learn(self, stage: Stage) -> None:
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
        self._tell_contacts(_keys(news.angles, news.slides))
        for ways in (self.loops, *self.more_ways.values()):
            ways.near(news.close)

    def _tell_contacts(self, names: Iterable[str]) -> None:
        tied = {k for name in names for k in self._tied.get(name, ()) if k in self.open}
        self.to_mesh.call(tied)
        for k in tied:
            self.open[k] = self._open(self.contacts[k])
            if not any(self.open[k]):
                del self.open[k]

    @cached_property
    def _tied(self) -> dict[str, list[int]]:
        """The contacts in which each angle, by its base, and each displacement counts."""
        tied: dict[str, list[int]] = {}
        for k, contact in enumerate(self.contacts):
            bases = (self.structure.base(body) for body, _ in contact.angles)
            for name in _keys(bases, [contact.slide, *(slide for slide, _ in contact.way)]):
                tied.setdefault(name, []).append(k)
        return tied

    # --- one stage ----------------------------------------------------------------------------

    def _carried(self, number: int) -> Carry | None:
        body, known = self.bodies[number], self.known
        if body in known.bodies or not known.angle(body):
            return None
        for joint, others in self.structure.joints(body):
            held = isinstance(joint, Hinge) or joint.slide in known.slides
            if held and known.joint(joint, others):
                return Carry(body, joint)
        return None

    def _bridged(self, number: int) -> Bridge | None:
        body = self.bodies[number]
        if body in self.known.bodies or self.structure.is_pin(body):
            return None
        points = [point for point in self.structure.bodies[body] if point in self.known.points]
        return Bridge(body, (points[0], points[1])) if len(points) > 1 else None

    def _meshed(self, number: int) -> Mesh | None:
        angles, slides = self.open.get(number, ({}, {}))
        if len(angles) + len(slides) != 1:
            return None
        return Mesh(self.contacts[number], next(iter(angles), ""), next(iter(slides), ""))

    def _open(self, contact: Contact) -> tuple[dict[str, None], dict[str, None]]:
        bases = (self.structure.base(body) for body, _ in contact.angles)
        angles = dict.fromkeys(base for base in bases if base not in self.known.angles)
        ways = contact.way if contact.slide not in self.known.slides else ()
        needed = [slide for slide, _ in ways] or [contact.slide]
        slides = dict.fromkeys(slide for slide in needed if slide and slide not in self.known.slides)
        return angles, slides

    def _loop(self) -> Loop | None:
        """The shortest loop with two unknowns, first in the order of the file."""
        way = self.loops.first()
        return None if way is None else Loop(*way)

    def _ways(self, most: int, floating: bool) -> Ways:
        """Ways that few mechanisms need."""
        if (most, floating) not in self.more_ways:
            self.more_ways[most, floating] = Ways(self.known, most, floating)
        return self.more_ways[most, floating]

    def _floating(self) -> Group | None:
        """The shortest loop with two unknowns of links that are closed in themselves."""
        way = self._ways(2, True).first()
        return None if way is None else self._as_group([loop := Loop(*way)], _keys(loop.angles, loop.slides))

    def _group(self, floating: bool) -> Group | None:
        """The smallest set of loops and contacts with as many unknowns as equations."""
        loops = [Loop(*way) for way in self._ways(MOST, floating).independent()]
        parts: list[tuple[Loop | Contact, frozenset[str], int]] = [
            (loop, _keys(loop.angles, loop.slides), 2) for loop in loops
        ]
        parts += [(self.contacts[k], _keys(angles, slides), 1) for k, (angles, slides) in self.open.items()]
        chosen = fewest_closed([names for _, names, _ in parts], [equations for *_, equations in parts])
        if chosen is None:
            return None
        unknown = frozenset[str]().union(*(parts[k][1] for k in chosen))
        return self._as_group([parts[k][0] for k in chosen], unknown)

    def _as_group(self, parts: Sequence[Loop | Contact], unknown: frozenset[str]) -> Group:
        loops = tuple(part for part in parts if isinstance(part, Loop))
        contacts = tuple(part for part in parts if isinstance(part, Contact))
        hanging = (loop for loop in loops if not floats(self.known, loop.joints))
        bodies = tuple(dict.fromkeys(body for loop in hanging for body in loop.bodies))
        slides = tuple(name for name in self.structure.slides if slide_key(name) in unknown)
        angles = tuple(body for body in self.structure.bodies if body in unknown)
        return Group(bodies, loops, contacts, angles, slides)


def _keys(angles: Iterable[str], slides: Iterable[str]) -> frozenset[str]:
    """Unknown scalars in one set, though a file may call a link and a slide alike."""
    return frozenset([*angles, *map(slide_key, slides)])
