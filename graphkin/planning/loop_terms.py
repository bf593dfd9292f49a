"""A loop as relative motions: from known to known over levers, slides and driven rotations.

Where links of one group follow one another (a block and its guide, a motor's two sides), all their motions
are taken at one point, the coincident point: one link carries the lever from the far hinge to it, the others
differ from that link there by a relative motion.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from graphkin.base.cache import kept
from graphkin.base.value import frozen
from graphkin.construction import Site
from graphkin.model.mechanism import FRAME
from graphkin.planning.stages import Loop
from graphkin.planning.structure import Hinge, Joint, Sliding, Topology


@frozen
class LinkArm:
    """Two points of one link."""

    seen_from: Site
    of: Site
    known: bool


@frozen
class Slip:
    """Coincident points of a sliding pair."""

    seen_from: Site
    of: Site
    known: bool
    slide: str


@frozen
class Twist:
    """Coincident points of two links that a driver turns against each other about `pivot`."""

    seen_from: Site
    of: Site
    known: bool
    pivot: str


Hop = LinkArm | Slip | Twist


def halves(structure: Topology, loop: Loop) -> tuple[Site, tuple[Hop, ...], Site, tuple[Hop, ...]]:
    """Both sides of the loop's equation: each a known site and the hops from it outward to the site sought. They meet
    between the unknown hops, so that each side ends in one; a driven sliding between them stands on the side from which
    the block is seen from its guide."""
    start, hops, end = way_round(structure, loop)
    first, middle = (k for k, hop in enumerate(hops) if not hop.known)
    for k, hop in enumerate(hops[first:middle], first):
        if isinstance(hop, Slip) and hop.known and FRAME not in (hop.seen_from.link, hop.of.link):
            seen_from_guide = hop.of.link == structure.block(structure.slides[hop.slide])
            middle = middle if seen_from_guide else k
            break
    return start, hops[:middle], end, outward(hops[middle:])


@kept(256, objects=2)
def way_round(structure: Topology, loop: Loop, lever: str = "") -> tuple[Site, tuple[Hop, ...], Site]:
    """The whole loop in one direction, from a known site over all hops to a known site; `lever`: the body of its group
    that shall carry the lever, where this is to be chosen."""
    places = _places(structure, loop, lever)
    start = Site(places[0], _beyond(structure, loop.joints[0], loop.bodies[0]))
    end = Site(places[-1], _beyond(structure, loop.joints[-1], loop.bodies[-1]))
    hops: list[Hop] = []
    for k, joint in enumerate(loop.joints):
        before = loop.bodies[k - 1] if k > 0 else _beyond(structure, joint, loop.bodies[0])
        after = loop.bodies[k] if k < len(loop.bodies) else _beyond(structure, joint, loop.bodies[-1])
        place, bases = places[k], (structure.base(before), structure.base(after))
        if isinstance(joint, Sliding):
            driven = joint.slide not in loop.slides
            hops.append(Slip(Site(place, before), Site(place, after), driven, joint.slide))
        elif 0 < k < len(loop.bodies) and bases[0] == bases[1] and bases[0] in loop.angles:
            hops.append(Twist(Site(place, before), Site(place, after), True, joint.point))
        if k < len(loop.bodies) and places[k + 1] != place:
            hops.append(LinkArm(Site(place, after), Site(places[k + 1], after), bases[1] not in loop.angles))
    return start, tuple(hops), end


def outward(hops: tuple[Hop, ...]) -> tuple[Hop, ...]:
    """The same hops walked from the other end."""
    return tuple(replace(hop, seen_from=hop.of, of=hop.seen_from) for hop in reversed(hops))


def _places(structure: Topology, loop: Loop, lever: str) -> list[str]:
    """The point at which each joint is looked at: the hinge itself; for slides the coincident point."""
    places = [joint.point if isinstance(joint, Hinge) else "" for joint in loop.joints]
    bases = [structure.base(body) for body in loop.bodies]
    starts = [k for k in range(len(bases)) if k == 0 or bases[k] != bases[k - 1]]
    for first, last in ((first, end - 1) for first, end in pairwise([*starts, len(bases)])):
        if first == last or bases[first] not in loop.angles:
            continue  # no two bodies that follow one another in one unknown group
        inner, bodies = range(first + 1, last + 1), loop.bodies[first : last + 1]
        if lever in bodies:
            at = loop.bodies.index(lever)
            for k in inner:
                places[k] = places[first] if k <= at else places[last + 1]
            continue
        place = structure.coincident
        chosen = place in (places[first], places[last + 1]) or any(place in structure.bodies[body] for body in bodies)
        if not chosen:
            slides = (joint for joint in loop.joints[first + 1 : last + 1] if isinstance(joint, Sliding))
            from_block = (loop.bodies[loop.joints.index(joint) - 1] == structure.block(structure.slides[joint.slide])
                          for joint in slides)  # fmt: skip
            place = places[first] if next(from_block, False) else places[last + 1]
        for k in inner:
            places[k] = place
    while waiting := [k for k, joint in enumerate(loop.joints) if isinstance(joint, Sliding) and not places[k]]:
        near = ((k, place) for k in waiting if (place := _near_hinge(structure, loop, places, k)))
        k, place = next(near, (-1, ""))
        if k < 0:  # no hinge beside any of them: a pin's own point first, as the circle's centre at a flat face
            own = [(k, structure.slides[joint.slide]) for k in waiting if isinstance(joint := loop.joints[k], Sliding)]
            k, slide = min(own, key=lambda entry: entry[1].block is not None)
            place = slide.point
        places[k] = place
    return places


def _near_hinge(structure: Topology, loop: Loop, places: list[str], k: int) -> str:
    """A hinge beside the slide spares a lever: the block's first, then the guide's, then a slide's place."""
    joint = loop.joints[k]
    assert isinstance(joint, Sliding)
    before = places[k - 1] if k > 0 else ""
    after = places[k + 1] if k + 1 < len(places) else ""
    block = structure.block(structure.slides[joint.slide])
    block_after = k < len(loop.bodies) and loop.bodies[k] == block
    return (after or before) if block_after else (before or after)


def _beyond(structure: Topology, joint: Joint, body: str) -> str:
    """The known body on the far side of the loop's end joint."""
    if isinstance(joint, Hinge):
        return next(other for other in structure.owners[joint.point] if other != body)
    pair = structure.slides[joint.slide]
    return pair.guide if body != pair.guide else structure.block(pair)
