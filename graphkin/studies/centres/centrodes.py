"""Centrodes: the curves that an instant centre draws on its two links, which roll on each other as the links move.

Source: Sun Huan, 机械原理, section 3-2.2, figure 3-6 (fixed and moving centrode), figure 3-10 (path of a centre).
"""

from __future__ import annotations

from functools import cached_property
from typing import Protocol

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.errors import Where
from graphkin.errors.centring import NoCentrode, UnknownCentre
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import centre_of
from graphkin.running.path import DriverPath, along
from graphkin.studies.centres.about import link_of
from graphkin.studies.centres.centrode_sampling import CentrodePiece, Sample, arc_length, joined, pieces
from graphkin.studies.centres.instant_centres import Centres, carried_to, over

FAR = 25.0
"""A centre is followed so many times the mechanism's size away."""
MARGIN = 1e-6
"""The curves end so far inside a dead point, as part of the path."""
CLOSE = 1e-8
"""Places closer than this part of the size are one."""
WHERE = Where("--centrodes")


class Coursed(Protocol):
    """The side of a course that is read here: path, positions t on it, True if the driver goes all round."""

    @property
    def path(self) -> DriverPath: ...
    @property
    def t(self) -> np.ndarray: ...
    @property
    def full_turn(self) -> bool: ...


@frozen
class Centrodes:
    """The curves of the centre of two links.

    axes    in whose axes the curves are: (second, first), that is fixed and moving; of a path the frame alone
    pieces  unbroken parts, in the order of the motion: t (n,), places (len(axes), n) [m] in each axes
    span    the t between which the links were moved
    """

    found: Centres
    path: DriverPath
    first: str
    second: str
    axes: tuple[str, ...]
    pieces: tuple[CentrodePiece, ...]
    span: tuple[float, float]

    @property
    def name(self) -> str:
        """`P13`."""
        return self.found.name(self.first, self.second)

    @property
    def fixed(self) -> list[np.ndarray]:
        """The curve in the axes of `second`, piece by piece (n,) [m]; of a path, the path."""
        return [piece.places[0] for piece in self.pieces]

    @property
    def moving(self) -> list[np.ndarray]:
        """The curve in the axes of `first`, piece by piece (n,) [m]."""
        return [piece.places[-1] for piece in self.pieces]

    @cached_property
    def is_point(self) -> bool:
        """True if the centre stays at one place of each link, as on a hinge."""
        small = CLOSE * self.found.board.size
        places = np.concatenate([piece.places for piece in self.pieces], axis=1)
        return bool(np.all(np.abs(places - places[:, :1]) <= small))

    def standing(self, link: str, t: Value) -> tuple[Value, Value]:
        """The axes of a link at t, scalar or (n,): origin [m] and unit vector of the x axis."""
        plot = along(self.found.method, self.path, np.atleast_1d(np.asarray(t, dtype=float)))
        origin, turn = carried_to(plot, link)
        shape = np.shape(t)
        count = np.atleast_1d(t).shape
        return np.broadcast_to(origin, count).reshape(shape)[()], np.broadcast_to(turn, count).reshape(shape)[()]

    def lengths(self, piece: int) -> tuple[np.ndarray, np.ndarray]:
        """Lengths of the fixed and of the moving curve from a piece's first place to the end of each cell [m]."""
        one = self.pieces[piece]
        return arc_length(one, 0), arc_length(one, len(self.axes) - 1)


def whole(course: Coursed) -> tuple[float, float]:
    """The t between which the mechanism moves: a full turn, or all that is reached."""
    if course.full_turn:
        return float(course.t.min()), float(course.t.min()) + 2 * np.pi
    return course.path.first, course.path.last


def centrodes(
    found: Centres, first: str, second: str, course: Coursed, span: tuple[float, float] | None = None
) -> Centrodes:
    """The fixed centrode, on `second`, and the moving one, on `first`, which rolls on it.

    found   the centres at the drawn position; first, second  links, as people call them
    course  of the mechanism; span: the first and last t, all positions of the course where left out

    Raises UnknownLink; NoCentrode where the links never turn against each other.
    """
    one, other = (link_of(found, name, WHERE) for name in (first, second))
    return _traced(found, one, other, (other, one), course, span)


def path(
    found: Centres, name: str | tuple[str, str], course: Coursed, span: tuple[float, float] | None = None
) -> Centrodes:
    """The path of a centre over a motion, in the frame (figure 3-10). name: `P13`, or its two links.

    Raises UnknownCentre, UnknownLink, NoCentrode as `centrodes` does.
    """
    links = centre_of(found.method.mechanism, name) if isinstance(name, str) else name
    if links is None:
        raise UnknownCentre(WHERE, str(name), tuple(found.names))
    one, other = (link_of(found, link, WHERE) for link in links)
    return _traced(found, one, other, (FRAME,), course, span)


def _traced(
    found: Centres, first: str, second: str, axes: tuple[str, ...], course: Coursed, span: tuple[float, float] | None
) -> Centrodes:
    low, high = _inside(course, span)
    name, origin, size = found.name(first, second), found.board.origin, found.board.size

    def sample(t: np.ndarray) -> Sample:
        there = over(found, course.path, t)
        seen = np.broadcast_to(there.board.points.get(name, np.full((3, 1), np.nan)).reshape(3, -1), (3, t.size))
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            places = origin + size * (seen[0] + 1j * seen[1]) / seen[2]
            curves = [(places - foot) / turn for foot, turn in (carried_to(there.plot, link) for link in axes)]
        return Sample(t, np.array(curves), seen)

    parts = pieces(sample, low, high, size, FAR * size) if first != second else []
    if not parts:
        machine = found.method.mechanism
        raise NoCentrode(WHERE, machine.called(first), machine.called(second))
    parts = joined(parts, high - low, CLOSE * size) if course.full_turn else parts
    return Centrodes(found, course.path, first, second, axes, tuple(parts), (low, high))


def _inside(course: Coursed, span: tuple[float, float] | None) -> tuple[float, float]:
    """The first and the last t, a little inside of dead points."""
    low, high = (float(course.t.min()), float(course.t.max())) if span is None else span
    path = course.path
    margin = MARGIN * (path.last - path.first)
    stops = [stop.at for stop in path.stops]
    first = path.first + margin if any(at < 0 for at in stops) else -np.inf
    last = path.last - margin if any(at > 0 for at in stops) else np.inf
    return max(low, first), min(high, last)


def centrodes_json(curves: Centrodes) -> dict[str, Plain]:
    """One object: of each piece of the curves the drivers' values [rad, m] and the places [m] in each link's axes."""
    machine = curves.found.method.mechanism
    return {
        "format": 1,
        "name": machine.name,
        "centre": curves.name,
        "axes": [machine.called(link) for link in curves.axes],
        "drivers": [driver.name for driver in machine.drivers],
        "pieces": [
            {
                "closed": piece.closed,
                "drivers": [np.broadcast_to(value, piece.t.shape).tolist() for value in curves.path.values(piece.t)],
                "curves": [[[z.real, z.imag] for z in places.tolist()] for places in piece.places],
            }
            for piece in curves.pieces
        ],
    }
