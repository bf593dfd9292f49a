"""A linkage's mechanism at one of its positions: where its points and its links are."""

from __future__ import annotations

import cmath
from collections.abc import Mapping

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.studies.linkages.linkage import Linkage, LinkagePosition


@frozen
class Placement:
    """Points [m] and angles of links [rad] at one position; points that only end a line are left out."""

    position: Mapping[str, complex]
    theta: Mapping[str, float]


def posed(linkage: Linkage, machine: Mechanism, position: LinkagePosition) -> Placement:
    """`machine`, which `linkage.mechanism` made, at a position; a dead point is one like any other."""
    drawn = {**machine.sketch, **dict(zip(linkage.names, linkage.places))}
    there = dict(zip(linkage.names, position.places))
    turned = position.turn - linkage.drawn.turn
    theta: dict[str, float] = {}
    for link in machine.moving:
        tail, *others = machine.links[link].points
        for head in others[:1]:
            known = head in there
            theta[link] = cmath.phase(there[head] - there[tail] if known else drawn[head] - drawn[tail])
            theta[link] += 0.0 if known else turned
    for line in (slide.line for slide in machine.slides if slide.guide != FRAME and slide.line.origin not in there):
        points = machine.links[line.link].points
        hinge = next(point for point in points if point in there)
        there[line.origin] = there[hinge] + (points[line.origin] - points[hinge]) * cmath.rect(1, theta[line.link])
    return Placement(there, theta)
