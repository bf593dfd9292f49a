"""Centrodes: the curves that an instant centre draws on its two links, which roll on each other as the links move.

Positions are added where a curve bends, and it is cut where it runs to infinity. They come in cells, each with its
middle, so that a length can be found from chords and half chords (Richardson).

Source: Sun Huan, 机械原理, section 3-2.2, figure 3-6 (fixed and moving centrode), figure 3-10 (path of a centre).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Protocol

import numpy as np

from graphkin.base.geometry import Array, Value
from graphkin.base.plain import Plain
from graphkin.base.value import bulky, frozen
from graphkin.errors import Where
from graphkin.errors.studies import NoCentrode, UnknownCentre
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import centre_of
from graphkin.running.path import DriverPath, along
from graphkin.studies.centres.about import link_of
from graphkin.studies.centres.instant_centres import Centres, carried_to, over

FAR = 25.0  # a centre is followed so many times the mechanism's size away
MARGIN = 1e-6  # the curves end so far inside a dead point, as part of the path
CLOSE = 1e-8  # places closer than this part of the size are one
WHERE = Where("--centrodes")
FIRST, DEEPEST = 90, 9
"""Cells to begin with, and the number of times a cell may be halved."""
BEND, FLAT = 0.08, 2e-4
"""A cell is halved while its half chords make a greater angle [rad], or its middle stands off more [of the size]."""
LEAST = 1e-5  # nothing smaller is looked at [of the size]


class Coursed(Protocol):
    """The side of a course that is read here: path, positions t on it, True if the driver goes all round."""

    @property
    def path(self) -> DriverPath: ...
    @property
    def t(self) -> np.ndarray: ...
    @property
    def full_turn(self) -> bool: ...


@frozen
class Sample:
    """Curves at positions: t (n,), the centre in each of k axes (k, n) [m], and homogeneous (3, n)."""

    t: np.ndarray
    places: np.ndarray
    homogeneous: np.ndarray


@frozen
class CentrodePiece:
    """An unbroken part of the curves: t (n,) and the places in each axes (k, n) [m]; each second t is a middle."""

    t: np.ndarray
    places: np.ndarray
    closed: bool = False


@bulky
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
        places = np.concatenate([piece.places for piece in self.pieces], axis=1)
        return bool(np.all(np.abs(places - places[:, :1]) <= CLOSE * self.found.board.size))

    def standing(self, link: str, t: Value) -> tuple[Value, Value]:
        """The axes of a link at t, scalar or (n,): origin [m] and unit vector of the x axis."""
        plot = along(self.found.method, self.path, np.atleast_1d(np.asarray(t, dtype=float)))
        shape, count = np.shape(t), np.atleast_1d(t).shape
        origin, turn = (np.broadcast_to(axes, count).reshape(shape)[()] for axes in carried_to(plot, link))
        return origin, turn


def whole(course: Coursed) -> tuple[float, float]:
    """The t between which the mechanism moves: a full turn, or all that is reached."""
    if course.full_turn:
        return float(course.t.min()), float(course.t.min()) + 2 * np.pi
    return course.path.first, course.path.last


def centrodes(
    centres: Centres, first: str, second: str, course: Coursed, span: tuple[float, float] | None = None
) -> Centrodes:
    """The fixed centrode, on `second`, and the moving one, on `first`, which rolls on it.

    centres at the drawn position; first, second  links, as people call them
    course  of the mechanism; span: the first and last t, all positions of the course where left out

    Raises UnknownLink; NoCentrode where the links never turn against each other.
    """
    one, other = (link_of(centres, name, WHERE) for name in (first, second))
    return _traced(centres, one, other, (other, one), course, span)


def path(
    centres: Centres, name: str | tuple[str, str], course: Coursed, span: tuple[float, float] | None = None
) -> Centrodes:
    """The path of a centre over a motion, in the frame (figure 3-10). name: `P13`, or its two links.

    Raises UnknownCentre, UnknownLink, NoCentrode as `centrodes` does.
    """
    links = centre_of(centres.method.mechanism, name) if isinstance(name, str) else name
    if links is None:
        raise UnknownCentre(Where("--path"), str(name), tuple(centres.names))
    one, other = (link_of(centres, link, WHERE) for link in links)
    return _traced(centres, one, other, (FRAME,), course, span)


def _traced(
    centres: Centres, first: str, second: str, axes: tuple[str, ...], course: Coursed, span: tuple[float, float] | None
) -> Centrodes:
    low, high = (float(course.t.min()), float(course.t.max())) if span is None else span
    margin, stops = MARGIN * (course.path.last - course.path.first), [stop.at for stop in course.path.stops]
    low = max(low, course.path.first + margin) if any(at < 0 for at in stops) else low
    high = min(high, course.path.last - margin) if any(at > 0 for at in stops) else high
    name, origin, size = centres.name(first, second), centres.board.origin, centres.board.size

    def sample(t: np.ndarray) -> Sample:
        there = over(centres, course.path, t)
        seen = np.broadcast_to(there.board.points.get(name, np.full((3, 1), np.nan)).reshape(3, -1), (3, t.size))
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            places = origin + size * (seen[0] + 1j * seen[1]) / seen[2]
            curves = [(places - foot) / turn for foot, turn in (carried_to(there.plot, link) for link in axes)]
        return Sample(t, np.array(curves), seen)

    parts = pieces(sample, low, high, size, FAR * size) if first != second else []
    if not parts:
        machine = centres.method.mechanism
        raise NoCentrode(WHERE, machine.called(first), machine.called(second))
    parts = joined(parts, high - low, CLOSE * size) if course.full_turn else parts
    return Centrodes(centres, course.path, first, second, axes, tuple(parts), (low, high))


# --- curves drawn fine ------------------------------------------------------------------------


def pieces(at: Callable[[np.ndarray], Sample], low: float, high: float, size: float, far: float) -> list[CentrodePiece]:
    """The curves from t = low to high, as far as the centre lies within `far` [m] of the fixed point."""
    sample = at(np.linspace(low, high, 2 * FIRST + 1))
    for _ in range(DEEPEST):
        coarse = _coarse(sample, size, far)
        if not coarse.any():
            break
        begin, middle, end = _cells(sample.t)  # both halves of a coarse cell become cells with middles of their own
        more = at(np.concatenate([(begin + middle)[coarse] / 2, (middle + end)[coarse] / 2]))
        t = np.concatenate([sample.t, more.t])
        places = np.concatenate([sample.places, more.places], axis=1)
        homogeneous = np.concatenate([sample.homogeneous, more.homogeneous], axis=1)
        order = np.argsort(t, kind="stable")
        sample = Sample(t[order], places[:, order], homogeneous[:, order])
    return _cut(sample, far)


def _cells(values: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """First, middle and last of each cell."""
    return values[..., :-2:2], values[..., 1::2], values[..., 2::2]


def _coarse(sample: Sample, size: float, far: float) -> Array:
    """Cells that bend too much, or that leave the paper."""
    begin, middle, end = _cells(sample.places)
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        one, two = middle - begin, end - middle
        chord = np.abs(end - begin)
        bend = np.abs(np.angle(two * np.conj(one)))
        off = np.abs(middle - (begin + end) / 2)
        uneven = (off > FLAT * size) | (bend > BEND)
        bent = (uneven & ((np.abs(one) > LEAST * size) | (np.abs(two) > LEAST * size))).any(axis=0)
        long = (chord > size / 20).any(axis=0)
        inside = _inside(sample, far)
    first, mid, last = _cells(inside)
    some, all_of_it = first | mid | last, first & mid & last
    return np.asarray(some & (bent | long | ~all_of_it))


def _inside(sample: Sample, far: float) -> Array:
    with np.errstate(invalid="ignore"):
        return np.asarray((np.isfinite(sample.places) & (np.abs(sample.places) <= far)).all(axis=0))


def _cut(sample: Sample, far: float) -> list[CentrodePiece]:
    """Runs of cells that lie inside, cut between positions on two sides of infinity: w changes its sign there."""
    first, mid, last = _cells(_inside(sample, far))
    before, after = sample.homogeneous[:, :-1], sample.homogeneous[:, 1:]
    with np.errstate(invalid="ignore"):
        through = before[2] * after[2] * np.sign(np.sum(before * after, axis=0)) < 0
    good = first & mid & last & ~through[::2] & ~through[1::2]
    edges = np.flatnonzero(np.diff(np.concatenate([[0], good.astype(int), [0]])))
    return [
        CentrodePiece(sample.t[2 * a : 2 * b + 1], sample.places[:, 2 * a : 2 * b + 1])
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]


def joined(parts: Sequence[CentrodePiece], turn: float, near: float) -> list[CentrodePiece]:
    """The pieces of a motion that comes back to its beginning: the last goes on into the first.

    A single piece that meets itself is closed.
    turn  the extent of t; near  places closer than this are one [m]
    """
    first, last = parts[0], parts[-1]
    if np.abs(first.places[:, 0] - last.places[:, -1]).max() > near:
        return list(parts)
    if len(parts) == 1:
        return [CentrodePiece(first.t, first.places, closed=True)]
    t = np.concatenate([last.t, first.t[1:] + turn])
    places = np.concatenate([last.places, first.places[:, 1:]], axis=1)
    return [CentrodePiece(t, places), *parts[1:-1]]


def centrodes_json(curves: Centrodes) -> dict[str, Plain]:
    """One object: of each piece of the curves the drivers' values [rad, m] and the places [m] in each link's axes."""
    machine = curves.found.method.mechanism
    return {
        "format": 1, "name": machine.name, "centre": curves.name, "axes": [*map(machine.called, curves.axes)],
        "drivers": [driver.name for driver in machine.drivers],
        "pieces": [
            {
                "closed": piece.closed,
                "drivers": [np.broadcast_to(value, piece.t.shape).tolist() for value in curves.path.values(piece.t)],
                "curves": [[[z.real, z.imag] for z in places.tolist()] for places in piece.places],
            }
            for piece in curves.pieces
        ],
    }  # fmt: skip
