"""The vector from a fixed pivot to any point of a link, as in (3-18): l1 e^(iθ1) + a e^(iθ2) + b e^(i(θ2 + 90°))."""

from __future__ import annotations

import cmath
from dataclasses import replace

from graphkin.analytic import Motion
from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.equations.bodies import quarters
from graphkin.equations.expressions import Sum, Wave, one, phasor
from graphkin.equations.legend import LegendEntry, Reader, Unit
from graphkin.equations.model import Model
from graphkin.equations.polygons import way
from graphkin.equations.readers import place
from graphkin.equations.symbols import AngleSum, Symbol
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import parts
from graphkin.planning.structure import Hinge, Joint, Sliding
from graphkin.say.catalogue import meaning


@frozen
class PointChain:
    """From the fixed point `start` to the point `of`."""

    start: str
    of: str
    sum: Sum


def asked_points(model: Model) -> tuple[str, ...]:
    """The moving points whose velocity or acceleration the problem asks for, in its order."""
    mechanism, found = model.method.mechanism, dict[str, None]()
    for question in mechanism.ask:
        for quantity in parts(mechanism, question):
            if quantity.word in ("v", "a"):
                found |= dict.fromkeys(site.point for site in quantity.sites if not site.explicit)
    return tuple(point for point in found if FRAME not in mechanism.owners[point])


def chain(model: Model, point: str, low: str) -> PointChain:
    """The shortest way from the frame to a point; `low` is the subscript of its a and b."""
    structure = model.method.structure
    owners = [body for body in structure.owners[point] if not structure.is_pin(body)]
    bodies, joints = way(structure, structure.bodies, owners, (FRAME,))
    total = Sum()
    for k in range(len(joints) - 1, -1, -1):
        inner = bodies[k]
        if isinstance(joints[k], Sliding):
            total += _slid(model, joints[k], inner)
        goal = point if k == 0 else _at(model, joints[k - 1], inner)
        total += _arm(model, inner, _at(model, joints[k], inner), goal, low)
    return PointChain(_at(model, joints[-1], FRAME), point, _by_links(model, total))


def _by_links(model: Model, of: Sum) -> Sum:
    """With the links' own angles where these follow from several others: θ3 turns at ω3, not at ω1 + ω21 + ω32."""
    own = {angle.parts: (symbol, angle.quarters) for symbol, angle in model.alias.items() if len(angle.moving) > 1}

    def named(wave: Wave) -> Wave:
        if (found := own.get(wave.angle.parts)) is None:
            return wave
        symbol, quarters = found
        return replace(wave, angle=AngleSum.of(symbol, (wave.angle.quarters - quarters) % 4))

    return Sum.of(replace(term, waves=tuple(map(named, term.waves))) for term in of.terms)


def _at(model: Model, joint: Joint, body: str) -> str:
    return joint.point if isinstance(joint, Hinge) else model.method.structure.slide_point(joint.slide, body)


def _slid(model: Model, joint: Joint, inner: str) -> Sum:
    """The displacement, walked towards the inner body."""
    assert isinstance(joint, Sliding)
    arrow = model.arrows.sliding(joint.slide)
    return -arrow.sum if model.method.structure.slides[joint.slide].guide == inner else arrow.sum


def _arm(model: Model, body: str, start: str, end: str, low: str) -> Sum:
    """The vector between two points of a body: a known link vector, or a along the link and b across it."""
    arrows = model.arrows
    if (body, frozenset((start, end))) in arrows.arms or start == end:
        return Sum.of(term for arrow in arrows.along(body, start, end) for term in arrow.sum.terms)
    shape = model.method.structure.shapes[body]
    arm, called = shape[end] - shape[start], model.bodies.called(body)
    if quarters(cmath.phase(arm)) is not None:
        return Sum.of(term for arrow in arrows.along(body, start, end) for term in arrow.sum.terms)
    theta = model.bodies.angles[body]
    what = (
        meaning("equations.part along", ends=start + end, link=called),
        meaning("equations.part across", ends=start + end, link=called),
    )
    a = model.ledger.constant("a", low, what[0], "mm", arm.real)
    b = model.ledger.constant("b", low, what[1], "mm", arm.imag)
    return phasor(one(a), theta) + phasor(one(b), theta.turned(1))


def vectors(model: Model, of: PointChain) -> tuple[Symbol, Symbol, Symbol]:
    """Letters for the point's position from the chain's start, its velocity, its acceleration: complex numbers."""

    def position(motion: Motion) -> Value:
        return motion.position[of.of] - place(model.method.structure, of.start, FRAME, motion)

    readers: tuple[Reader, ...] = (position, lambda motion: motion.velocity[of.of], lambda m: m.acceleration[of.of])
    start = model.bodies.spot(of.start)
    what = (
        ("l", meaning("equations.point position", start=start, point=of.of)),
        ("v", meaning("equations.point velocity", point=of.of)),
        ("a", meaning("equations.point acceleration", point=of.of)),
    )
    units: tuple[Unit, ...] = ("mm", "m/s", "m/s^2")
    found = []
    for (letter, text), unit, read in zip(what, units, readers, strict=True):
        symbol = model.ledger.fresh(letter, of.of)
        model.ledger.entries[symbol] = LegendEntry(text, unit, read)
        found.append(symbol)
    return found[0], found[1], found[2]
