"""The drawing under the board on which centres are found: the mechanism at its position, or at many at once.

Its points are pricked through: hinges, contacts, and the poles of links whose velocities are known. Its lines are
traced: guides, and the common normals of profiles that touch.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.tolerances import STILL
from graphkin.base.value import frozen
from graphkin.construction import AcrossGuide, Along, Plot, Ray, Touch
from graphkin.construction.drafting import Board, Homogeneous, Underlay
from graphkin.construction.drafting.board import balanced
from graphkin.construction.pencil import touch
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Pair, Rod, Slot
from graphkin.planning import Method
from graphkin.planning.equivalent import Contact


def contact_name(contact: Contact) -> str:
    """The board's name of the point in which wheels touch; no point of a mechanism has a name of two words."""
    return f"contact {contact.name}"


def pole_name(first: str, second: str) -> str:
    """The board's name of the pole of two links that is taken from velocities."""
    return f"pole {first} {second}"


@frozen
class CommonNormal:
    """The common normal of two links that touch and slide in a pair, by its name on the board."""

    name: str
    pair: Pair
    links: frozenset[str]
    line: Ray


def board_over(method: Method, plot: Plot) -> Board:
    """An empty board over a plot; its coordinates are counted from a fixed point, in the mechanism's longest reach."""
    shapes, frame = plot.facts.shapes, plot.facts.frame
    fixed = next(iter(shapes[frame].values()), 0j)
    reaches = [abs(place - fixed) for place in shapes[frame].values()]
    reaches += [abs(place) for link, shape in shapes.items() if link != frame for place in shape.values()]
    board = Board(fixed, max(reaches) or 1.0)
    points = {name: board.seen(place) for name, place in plot.position.items()}
    for contact in method.structure.contacts:
        first, second = contact.centres
        if contact.slide:
            touching = Touch("", second, slide=contact.slide, offset=-contact.radii[1])
        else:
            touching = Touch("", first, second, contact.radii[0] / sum(contact.radii))
        points[contact_name(contact)] = board.seen(touch(touching, plot))
    lines = {name: board.sloping(board.origin, plot.guide_direction(name)) for name in plot.facts.lines}
    for one in normals(method.mechanism):
        lines[one.name] = board.sloping(plot.position[one.line.through], plot.direction(one.line.direction))
    board.underlay = Underlay(points, lines)
    return board


def normals(mechanism: Mechanism) -> Iterator[CommonNormal]:
    """The common normals of profiles that touch and slide: of cams, and of pins in slots."""
    lines: list[tuple[Pair, tuple[str, str], Ray]] = []
    for pair in mechanism.pairs:
        match pair.slipping:
            case None:
                pass
            case Rod(_, (first, second)):
                owners = product(mechanism.owners[first], mechanism.owners[second])
                lines += [(pair, two, Ray(first, Along(first, second))) for two in owners if two[0] != two[1]]
            case Slot(guide, point):
                across = Ray(point, AcrossGuide(pair.name))
                lines += [(pair, (guide.link, link), across) for link in mechanism.owners[point]]
    for k, (pair, links, line) in enumerate(lines):
        yield CommonNormal(f"normal {k}", pair, frozenset(links), line)


def from_velocities(board: Board, motions: Motions, first: str, second: str) -> Homogeneous:
    """The place where two links have one velocity, homogeneous; NaN where they do not move against each other.

    Each position is judged by its own pace: one that is broken does not spoil the others.
    Source: theoretical mechanics, x_P = x_O - v_y / omega, y_P = y_O + v_x / omega of the relative motion.
    """
    (one, turn), (other, other_turn) = (_motion(board, motions, link) for link in (first, second))
    moving, turning = one - other, turn - other_turn
    rates = [np.abs(value) for value in motions.omega.values()]
    pace = np.max(np.broadcast_arrays(*rates), axis=0) + np.abs(moving)
    turning = np.where(np.abs(turning) <= STILL * pace, 0.0, turning)
    across = 1j * np.where((np.abs(moving) <= STILL * pace) & (turning == 0), 0.0, moving)
    return balanced(np.array(np.broadcast_arrays(np.real(across), np.imag(across), turning)))


def _motion(board: Board, motions: Motions, link: str) -> tuple[Value, Value]:
    """Velocity of the link's place at the origin of coordinates, in units of size, and its rotation."""
    if link == FRAME:
        return 0j, 0.0
    point = next(name for name in motions.mechanism.links[link].points if name in motions.position)
    omega = motions.omega[link]
    velocity = motions.velocity_at(point, link) + 1j * omega * (board.origin - motions.position[point])
    return velocity / board.size, omega
