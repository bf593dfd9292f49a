"""The order of solution: which bodies become known after which, from topology alone.

Three kinds of stage. `Carry`: a body whose angle is known hangs on a known point or a driven slide.
`Bridge`: a body joins two known points (it repeats a constraint that others keep). `Loop`: a way round
through unknown bodies, from known to known, with exactly two unknown scalars (the angle of a group of
links, the displacement of a slide): the Assur dyads RRR, RRP, RPR, PRP, RPP in every order, and longer
ways whose further terms are driven. Two unknowns are what one vector equation gives, so the same loop is
closed in all three planes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from graphkin.mechanism import FRAME
from graphkin.methods.structure import Hinge, Joint, Sliding, Structure

__all__ = ["Bridge", "Carry", "Loop", "Stage", "stages"]


@dataclass(frozen=True)
class Carry:
    """`body` becomes known by its known angle and the joint `by`."""

    body: str
    by: Joint


@dataclass(frozen=True)
class Bridge:
    """`body` becomes known by two known points."""

    body: str
    points: tuple[str, str]


@dataclass(frozen=True)
class Loop:
    """From known over `joints[0]`, `bodies[0]`, `joints[1]`, .. back to known.

    angles, slides  the unknown scalars: bases of groups of links, slides; two in all
    """

    bodies: tuple[str, ...]
    joints: tuple[Joint, ...]
    angles: tuple[str, ...]
    slides: tuple[str, ...]


Stage = Carry | Bridge | Loop


@dataclass
class _Known:
    """What is known so far."""

    structure: Structure
    bodies: set[str] = field(default_factory=lambda: {FRAME})
    angles: set[str] = field(default_factory=lambda: {FRAME})

    @property
    def unknown(self) -> list[str]:
        return [body for body in self.structure.bodies if body not in self.bodies]

    def point(self, point: str) -> bool:
        return any(body in self.bodies for body in self.structure.owners[point])

    def angle(self, body: str) -> bool:
        return self.structure.base(body) in self.angles

    def joint(self, joint: Joint, others: tuple[str, ...]) -> bool:
        """Whether a joint's far side is known."""
        return self.point(joint.point) if isinstance(joint, Hinge) else others[0] in self.bodies

    def learn(self, stage: Stage) -> None:
        bodies = stage.bodies if isinstance(stage, Loop) else (stage.body,)
        self.bodies.update(bodies)
        self.angles.update(self.structure.base(body) for body in bodies)


def stages(structure: Structure) -> tuple[tuple[Stage, ...], tuple[str, ...]]:
    """The stages in the order a textbook takes them, and the bodies that no stage reaches."""
    known, found = _Known(structure), list[Stage]()
    while known.unknown:
        stage = _carried(known) or _bridged(known) or _loop(known)
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
            held = isinstance(joint, Hinge) or joint.slide in known.structure.slides_driven
            if held and known.joint(joint, others):
                return Carry(body, joint)
    return None


def _bridged(known: _Known) -> Stage | None:
    for body in known.unknown:
        points = [point for point in known.structure.bodies[body] if known.point(point)]
        if len(points) > 1 and not known.structure.is_pin(body):
            return Bridge(body, (points[0], points[1]))
    return None


def _loop(known: _Known) -> Loop | None:
    order = known.structure.order

    def rank(loop: Loop) -> tuple[int, list[int], list[int]]:
        way = [order[body] for body in loop.bodies]
        return len(way), sorted(way), way

    return min(_loops(known), key=rank, default=None)


def _loops(known: _Known) -> Iterator[Loop]:
    for body in known.unknown:
        for joint, others in known.structure.joints(body):
            if known.joint(joint, others):
                yield from _walk(known, (body,), (joint,))


def _walk(known: _Known, bodies: tuple[str, ...], joints: tuple[Joint, ...]) -> Iterator[Loop]:
    """Every way on from here that keeps to two unknown scalars."""
    angles, slides = _unknowns(known, bodies, joints)
    if len(angles) + len(slides) > 2:
        return
    for joint, others in known.structure.joints(bodies[-1]):
        if joint in joints:
            continue
        if known.joint(joint, others):
            angles, slides = _unknowns(known, bodies, (*joints, joint))
            if len(angles) + len(slides) == 2 and _together(known, bodies):
                yield Loop(bodies, (*joints, joint), angles, slides)
            continue
        for other in others:
            if other not in bodies and other not in known.bodies:
                yield from _walk(known, (*bodies, other), (*joints, joint))


def _unknowns(
    known: _Known, bodies: tuple[str, ...], joints: tuple[Joint, ...]
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    structure = known.structure
    angles = dict.fromkeys(structure.base(body) for body in bodies if not known.angle(body))
    slides = dict.fromkeys(
        joint.slide
        for joint in joints
        if isinstance(joint, Sliding) and joint.slide not in structure.slides_driven
    )
    return tuple(angles), tuple(slides)


def _together(known: _Known, bodies: tuple[str, ...]) -> bool:
    """Bodies of one unknown group must follow one another, so that they count as one lever."""
    bases = [known.structure.base(body) for body in bodies]
    runs = [base for k, base in enumerate(bases) if k == 0 or bases[k - 1] != base]
    unknown = [base for base in runs if base not in known.angles]
    return len(unknown) == len(set(unknown))
