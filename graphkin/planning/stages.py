"""The order of solution: which bodies become known after which, from topology alone.

Kinds of stage. `Carry`: a body whose angle is known hangs on a known point or a known displacement.
`Bridge`: a body joins two known points (it repeats a constraint that others keep). `Mesh`: wheels that roll
on each other leave one angle or displacement to be found. `Loop`: a way round through unknown bodies, from
known to known, with exactly two unknown scalars (the angle of a group of links, the displacement of a
slide): the Assur dyads RRR, RRP, RPR, PRP, RPP in every order, and longer ways whose further terms are
driven. Two unknowns are what one vector equation gives, so the same loop is closed in all three planes.
`Group`: the fewest loops and rolling contacts that only together have as many unknowns as equations: an
Assur group of Class III or higher, or a gear train whose planets and arm hang on each other.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field

from graphkin.construction import slide_key
from graphkin.mechanism import FRAME
from graphkin.planning.closed_sets import fewest_closed
from graphkin.planning.equivalent import Contact
from graphkin.planning.structure import Hinge, Joint, Sliding, Structure
from graphkin.value import filled, frozen

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
    """From known over `joints[0]`, `bodies[0]`, `joints[1]`, .. back to known.

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
    """Loops and contacts whose unknown scalars can only be found together."""

    bodies: tuple[str, ...]
    loops: tuple[Loop, ...]
    contacts: tuple[Contact, ...]
    angles: tuple[str, ...]
    slides: tuple[str, ...]


Stage = Carry | Bridge | Mesh | Loop | Group


@filled
class _Known:
    """What is known so far, and the bodies that are not."""

    structure: Structure
    bodies: set[str] = field(default_factory=lambda: {FRAME})
    angles: set[str] = field(default_factory=lambda: {FRAME})
    slides: set[str] = field(default_factory=set)
    unknown: list[str] = field(default_factory=list)

    def point(self, point: str) -> bool:
        return any(body in self.bodies for body in self.structure.owners[point])

    def angle(self, body: str) -> bool:
        return self.structure.base(body) in self.angles

    def joint(self, joint: Joint, others: tuple[str, ...]) -> bool:
        """Whether a joint's far side is known."""
        return self.point(joint.point) if isinstance(joint, Hinge) else others[0] in self.bodies

    def learn(self, stage: Stage) -> None:
        """What a stage gives; displacements between bodies that are known by then, too."""
        match stage:
            case Carry() | Bridge():
                self.bodies.add(stage.body)
                self.angles.add(self.structure.base(stage.body))
            case Mesh():
                self.angles |= {stage.angle} - {""}
                self.slides |= {stage.slide} - {""}
            case Loop() | Group():
                self.bodies.update(stage.bodies)
                self.angles.update(stage.angles)
                self.slides.update(stage.slides)
        for name, slide in self.structure.slides.items():
            aside = name in self.structure.aside.slides and self.point(slide.point)
            if slide.guide in self.bodies and (aside or self.structure.block(slide) in self.bodies):
                self.slides.add(name)
        self.unknown = [body for body in self.unknown if body not in self.bodies]


def stages(structure: Structure) -> tuple[tuple[Stage, ...], tuple[str, ...]]:
    """The stages in the order a textbook takes them, and the bodies that no stage reaches."""
    bodies, found = [body for body in structure.bodies if body != FRAME], list[Stage]()
    known = _Known(structure, slides=set(structure.slides_driven), unknown=bodies)
    while known.unknown:
        stage = _carried(known) or _bridged(known) or _meshed(known) or _loop(known) or _group(known)
        if stage is None:
            break
        found.append(stage)
        known.learn(stage)
    return tuple(found), tuple(known.unknown)


def _carried(known: _Known) -> Stage | None:
    for body in known.unknown:
        if not known.angle(body):
            continue
        for joint, others in known.structure.joints(body):
            held = isinstance(joint, Hinge) or joint.slide in known.slides
            if held and known.joint(joint, others):
                return Carry(body, joint)
    return None


def _bridged(known: _Known) -> Stage | None:
    for body in known.unknown:
        points = [point for point in known.structure.bodies[body] if known.point(point)]
        if len(points) > 1 and not known.structure.is_pin(body):
            return Bridge(body, (points[0], points[1]))
    return None


def _meshed(known: _Known) -> Mesh | None:
    for contact in known.structure.tying:
        angles, slides = _open(known, contact)
        if len(angles) + len(slides) == 1:
            return Mesh(contact, next(iter(angles), ""), next(iter(slides), ""))
    return None


def _open(known: _Known, contact: Contact) -> tuple[dict[str, None], dict[str, None]]:
    """What is unknown of a rolling contact."""
    bases = (known.structure.base(body) for body, _ in contact.angles)
    angles = dict.fromkeys(base for base in bases if base not in known.angles)
    ways = contact.way if contact.slide not in known.slides else ()
    needed = [slide for slide, _ in ways] or [contact.slide]
    slides = dict.fromkeys(slide for slide in needed if slide and slide not in known.slides)
    return angles, slides


def _loop(known: _Known) -> Loop | None:
    """The shortest loop with two unknowns, first in the order of the file."""
    return min(_loops(known, 2), key=lambda loop: _rank(known, loop), default=None)


def _rank(known: _Known, loop: Loop) -> tuple[int, list[int], list[int]]:
    way = [known.structure.order[body] for body in loop.bodies]
    return len(way), sorted(way), way


def _group(known: _Known) -> Group | None:
    """The smallest set of loops and contacts with as many unknowns as equations."""
    loops = _bases(sorted(_loops(known, MOST), key=lambda loop: _rank(known, loop)))
    parts: list[tuple[Loop | Contact, frozenset[str], int]] = [
        (loop, _keys(loop.angles, loop.slides), 2) for loop in loops
    ]
    for contact in known.structure.tying:
        angles, slides = _open(known, contact)
        if angles or slides:
            parts.append((contact, _keys(angles, slides), 1))
    chosen = fewest_closed([names for _, names, _ in parts], [equations for *_, equations in parts])
    if chosen is None:
        return None
    unknown = frozenset[str]().union(*(parts[k][1] for k in chosen))
    return _as_group(known, [parts[k][0] for k in chosen], unknown)


def _keys(angles: Iterable[str], slides: Iterable[str]) -> frozenset[str]:
    """Unknown scalars in one set, though a file may call a link and a slide alike."""
    return frozenset([*angles, *map(slide_key, slides)])


def _bases(loops: list[Loop]) -> list[Loop]:
    """Loops that are no sum of shorter ones: independent as sets of joints."""
    chosen: list[Loop] = []
    rows: list[tuple[Joint, set[Joint]]] = []
    for loop in loops:
        row: set[Joint] = set(loop.joints)
        for head, pivot in rows:
            if head in row:
                row = row ^ pivot
        if row:
            rows.append((min(row, key=str), row))
            chosen.append(loop)
    return chosen


def _as_group(known: _Known, parts: list[Loop | Contact], unknown: frozenset[str]) -> Group:
    loops = tuple(part for part in parts if isinstance(part, Loop))
    contacts = tuple(part for part in parts if isinstance(part, Contact))
    structure = known.structure
    bodies = tuple(dict.fromkeys(body for loop in loops for body in loop.bodies))
    slides = tuple(name for name in structure.slides if slide_key(name) in unknown)
    angles = tuple(body for body in structure.bodies if body in unknown)
    return Group(bodies, loops, contacts, angles, slides)


def _loops(known: _Known, most: int) -> Iterator[Loop]:
    """Every way from known to known with two unknown scalars, or with up to `most`."""
    for body in known.unknown:
        if body in known.structure.followers:
            continue
        for joint, others in known.structure.joints(body):
            if known.joint(joint, others):
                yield from _walk(known, (body,), (joint,), most)


def _walk(
    known: _Known, bodies: tuple[str, ...], joints: tuple[Joint, ...], most: int
) -> Iterator[Loop]:
    """Every way on from here that keeps to so many unknown scalars."""
    angles, slides = _unknowns(known, bodies, joints)
    if len(angles) + len(slides) > most:
        return
    for joint, others in known.structure.joints(bodies[-1]):
        if joint in joints:
            continue
        if known.joint(joint, others):
            slid = (joint.slide,) if isinstance(joint, Sliding) and joint.slide not in known.slides else ()
            found = (*slides, *slid)
            if most > 2 or (len(angles) + len(found) == 2 and _together(known, bodies)):
                yield Loop(bodies, (*joints, joint), angles, found)
            continue
        for other in others:
            if other not in bodies and other not in known.bodies and other not in known.structure.followers:
                yield from _walk(known, (*bodies, other), (*joints, joint), most)


def _unknowns(
    known: _Known, bodies: tuple[str, ...], joints: tuple[Joint, ...]
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    structure = known.structure
    angles = dict.fromkeys(structure.base(body) for body in bodies if not known.angle(body))
    slides = dict.fromkeys(
        joint.slide
        for joint in joints
        if isinstance(joint, Sliding) and joint.slide not in known.slides
    )
    return tuple(angles), tuple(slides)


def _together(known: _Known, bodies: tuple[str, ...]) -> bool:
    """Bodies of one unknown group must follow one another, so that they count as one lever."""
    bases = [known.structure.base(body) for body in bodies]
    runs = [base for k, base in enumerate(bases) if k == 0 or bases[k - 1] != base]
    unknown = [base for base in runs if base not in known.angles]
    return len(unknown) == len(set(unknown))
