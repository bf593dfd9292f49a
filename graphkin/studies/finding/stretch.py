"""A stretch: the part of a course between two ends, and quantities there, closely enough to miss nothing.

Whatever `ask` can name is read at any place t. Sizes of vectors count as they are; for a point that a guide of the
frame leads they count along that guide, and may be negative. Where the drawing itself tells how fast a quantity
changes, a greatest value is the zero of another quantity, to the last digit: theta changes by omega, omega by alpha, a
displacement by its rate, a place by its velocity, a velocity by its acceleration. On a path every driver keeps its
speed, so the part of the drivers' own accelerations is taken off.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cached_property
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Array, Real, Value, dot, number
from graphkin.base.value import frozen
from graphkin.errors import UnknownQuantity, Where
from graphkin.model import quantities as kinds
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import Seen
from graphkin.running.path import stride
from graphkin.running.tracing import trace
from graphkin.studies.finding.answers import Kind, Position
from graphkin.studies.finding.conditions import WHERE
from graphkin.studies.finding.search import Function, differences
from graphkin.studies.sweeps import Course, Road, Series
from graphkin.studies.sweeps.course import TURN
from graphkin.studies.sweeps.roads import moving
from graphkin.studies.sweeps.sweep import Turns, series

LEAST, MOST = 1441, 40_001
"""Places at which a stretch is read, at least and at most."""
FINE_DEG, FINE_PART = 0.25, 0.001
"""They are at most so far apart [deg, of the mechanism's size]."""
HALVINGS = 24  # before a dead point they lie each half as far from it as the one before
ROUNDING = 1e-11  # values below this part of others of their kind are rounding
SECOND = 100.0  # accelerations, read off a second polygon, have so much more of it beside a change point
BEYOND = 4  # places beyond an end, so that an extreme right at the end is seen


# --- quantities -------------------------------------------------------------------------------


def checked(mechanism: Mechanism, names: Sequence[str], where: Where = WHERE) -> tuple[Series, ...]:
    """The quantities at the drawn position.

    Raises UnknownQuantity, UnknownLink, UnknownPoint, UnknownSlide for names that mean nothing.
    """
    from graphkin.analytic import motion

    still = motion(mechanism)
    return tuple(series(name, quantity_of(mechanism, name, where), still, 1) for name in names)


def quantity_of(mechanism: Mechanism, name: str, where: Where = WHERE) -> kinds.Quantity:
    """A quantity that has a size: places have none, `x E` and `y E` have. Raises what `quantities.named` raises."""
    quantity = kinds.named(mechanism, name, where)
    if quantity.is_place:
        raise UnknownQuantity(where, name, tuple(f"{axis} {quantity.of}" for axis in ("x", "y") if quantity.sites))
    return quantity


class Reader:
    """Reads quantities at places t of a course; angles that are followed go on beyond a full turn."""

    def __init__(self, course: Course, names: Sequence[str], by: Road) -> None:
        self.course, self.by, self.turns = course, by, Turns()
        self.quantities = [(name, quantity_of(course.method.mechanism, name)) for name in names]

    def motions(self, t: np.ndarray) -> Motions:
        return moving(self.course.method, self.course.path, t, self.by)

    def read(self, t: np.ndarray, motions: Motions | None = None) -> list[Series]:
        """Every quantity at places t (n,), from the motions there where these are known."""
        if not t.size:
            one = self.read(np.zeros(1))
            return [replace(entry, values=t, vectors=None if entry.vectors is None else t + 0j) for entry in one]
        motions = motions or self.motions(t)
        return [self.turns.on(series(*entry, motions, t.size), t) for entry in self.quantities]


# --- rates of change --------------------------------------------------------------------------


@frozen
class Pace:
    """The passing of time on a path: t changes by `speed` a second [1/s].

    growth  ratio of all drivers' accelerations to their speeds [1/s]; None where they differ
    """

    speed: float
    growth: float | None


def pace_of(course: Course) -> Pace | None:
    """The pace of a path on which the drivers go as they do in the file; None for any other path."""
    drivers, path = course.method.drivers, course.path
    speed = drivers[course.swept].rate / path.pace[course.swept]
    together = all(
        abs(driver.rate - speed * pace) <= 1e-12 * abs(speed * path.pace[course.swept])
        for driver, pace in zip(drivers, path.pace, strict=True)
    )
    if not speed or not together:
        return None
    growth = drivers[course.swept].acceleration / drivers[course.swept].rate
    same = all(abs(d.acceleration - growth * d.rate) <= 1e-12 * abs(growth * d.rate) for d in drivers)
    return Pace(speed, growth if same else None)


def rate(motions: Motions, entry: Series, pace: Pace) -> Real | None:
    """The change of a quantity with t; None where the drawing does not tell it."""
    match entry.quantity:
        case kinds.Rotation(word="theta", link=link):
            return motions.omega[link] / pace.speed
        case kinds.Rotation(word="omega", link=link) if pace.growth is not None:
            return (motions.alpha[link] - pace.growth * motions.omega[link]) / pace.speed
        case kinds.Displacement(slide=slide):
            return motions.s_rate[slide] / pace.speed
        case kinds.Place(axis=axis, site=site):
            velocity = motions.velocity_at(site.point, site.link) / pace.speed
            return velocity.real if axis == "x" else velocity.imag
        case kinds.Moving(letter="v") | kinds.Component(letter="v") if pace.growth is not None:
            changes = [_velocity_change(motions, site) for site in entry.quantity.sites]
            change = changes[0] - (changes[1] if len(changes) > 1 else 0)
            return (dot(_direction(entry), change) - pace.growth * entry.signed) / pace.speed
        case (
            kinds.Rotation() | kinds.Moving() | kinds.Component() | kinds.Track() | kinds.Centre() | kinds.Quotient()
        ):
            return None
        case _:
            assert_never(entry.quantity)


def _direction(entry: Series) -> Value:
    """The direction along which a change of a velocity changes its size or its part."""
    if isinstance(entry.quantity, kinds.Component):
        return 1 if entry.quantity.axis == "x" else 1j
    if entry.along is not None:
        return entry.along
    assert entry.vectors is not None
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(entry.vectors == 0, 0, entry.vectors / np.abs(entry.vectors))


def _velocity_change(motions: Motions, site: Seen) -> Value:
    """Change of the velocity of the point of a link that lies under a point: another one where that moves on it."""
    acceleration = motions.acceleration_at(site.point, site.link)
    owners = motions.mechanism.owners[site.point]
    if site.link in owners or site.link == FRAME:
        return acceleration
    slip = motions.velocity_at(site.point, owners[0]) - motions.velocity_at(site.point, site.link)
    return acceleration + 1j * motions.omega[site.link] * slip


# --- the stretch ------------------------------------------------------------------------------


@frozen
class CourseStretch:
    """A part of a course.

    low, high   its ends; stopped: whether each is a dead point, which is not reached itself
    """

    course: Course
    by: Road
    names: tuple[str, ...]
    low: float
    high: float
    stopped: tuple[bool, bool]

    @cached_property
    def step(self) -> float:
        fine = stride(self.course.method, self.course.path.pace, FINE_DEG, FINE_PART)
        return (self.high - self.low) / (min(max(LEAST, math.ceil((self.high - self.low) / fine)), MOST) - 1)

    @cached_property
    def places(self) -> np.ndarray:
        """First places: evenly, ever closer towards a dead point, a little beyond other ends."""
        even = np.linspace(self.low, self.high, round((self.high - self.low) / self.step) + 1)
        closer = self.step * 0.5 ** np.arange(1, HALVINGS + 1)
        beyond = self.step * np.arange(1, BEYOND + 1)
        begin, end = (even[1:] if self.stopped[0] else even), (-1 if self.stopped[1] else None)
        low = self.low + closer if self.stopped[0] else self.low - beyond
        high = self.high - closer if self.stopped[1] else self.high + beyond
        t, path = np.concatenate([low, begin[:end], high]), self.course.path
        t = np.unique(t[(t >= path.low) & (t <= path.high)])
        return np.asarray(t[np.broadcast_to(path.leads_to(t), t.shape)])

    @cached_property
    def reader(self) -> Reader:
        """Reads the quantities; angles are followed all along."""
        reader = Reader(self.course, self.names, self.by)
        start = self.low + self.step if self.stopped[0] else self.low
        reader.turns.follow(reader.read(self.places), self.places, start)
        return reader

    def read(self, t: np.ndarray) -> list[Series]:
        return self.reader.read(t)

    def values(self, number: int = 0, *, size: bool = False) -> Function:
        """One quantity as a function of t; `size`: whatever its sense."""

        def function(t: np.ndarray) -> np.ndarray:
            entry = self.read(t)[number]
            return np.abs(entry.signed) if size else entry.signed

        return function

    def slope(self, number: int = 0, *, size: bool = False) -> Function:
        """Change of one quantity with t: read off the drawing where it tells it, else by differences."""
        pace = pace_of(self.course)

        def exact(t: np.ndarray) -> np.ndarray | None:
            motions = self.reader.motions(t)
            entry = self.reader.read(t, motions)[number]
            assert pace is not None
            change = rate(motions, entry, pace)
            if change is None:
                return None
            return np.asarray(np.broadcast_to(change, t.shape) * (np.sign(entry.signed) if size else 1.0))

        if pace is None or exact(self.places[:1]) is None:
            return differences(self.values(number, size=size), self.step / 2)

        def slope(t: np.ndarray) -> np.ndarray:
            change = exact(t) if t.size else t
            assert change is not None
            return change

        return slope

    def position(self, t: float, kind: Kind, values: tuple[float, ...] | None = None) -> Position:
        drivers = tuple(number(value) for value in self.course.path.values(t))
        if values is None:
            values = tuple(float(entry.signed[0]) for entry in self.read(np.array([t])))
        return Position(float(t), drivers, values, kind)

    @cached_property
    def _usual(self) -> dict[str, float]:
        """Usual sizes of quantities of each unit in this mechanism: of the fastest, of the longest."""
        motions, drivers = self.reader.motions(self.places), self.course.method.drivers
        length = self.course.method.size
        turning = _greatest([*motions.omega.values(), *(d.rate for d in drivers if d.kind != "slide")])
        slides = [driver for driver in drivers if driver.kind == "slide"]
        speed = max(turning * length, *(abs(driver.rate) for driver in slides), _greatest(motions.s_rate.values()))
        alphas = [*motions.alpha.values(), *(driver.acceleration for driver in drivers if driver.kind != "slide")]
        quick = max(_greatest(alphas), turning**2)
        pull = max(quick * length, speed**2 / length, *(abs(driver.acceleration) for driver in slides))
        return {"rad": 1.0, "1": 1.0, "m": length, "rad/s": turning, "rad/s^2": quick, "m/s": speed, "m/s^2": pull}

    def noise(self, unit: str) -> float:
        """The size that a quantity of this unit may have by rounding alone, though it is zero."""
        return ROUNDING * (SECOND if unit.endswith("s^2") else 1.0) * self._usual.get(unit, 0.0)

    @cached_property
    def closed(self) -> bool:
        """True if both ends are one and the same position, a turn apart."""
        if not self.course.angular or any(self.stopped) or abs(self.high - self.low - TURN) > 1e-9:
            return False
        position = self.reader.motions(np.array([self.low, self.high])).position
        points = [point for point in self.course.method.mechanism.points if point in position]
        both: list[Array] = [np.broadcast_to(position[point], (2,)) for point in points]
        return all(abs(place[0] - place[1]) <= 1e-7 * self.course.method.size for place in both)

    def within(self, t: np.ndarray) -> np.ndarray:
        """Those between the ends, in their order, each once: a turn's end is its beginning."""
        margin = 1e-9 * (self.high - self.low)
        inside = np.sort(np.clip(t[(t >= self.low - margin) & (t <= self.high + margin)], self.low, self.high))
        if inside.size > 1:
            inside = inside[np.concatenate([[True], np.diff(inside) > 1e-8 * (self.high - self.low)])]
        if inside.size > 1 and self.closed and inside[-1] - inside[0] > TURN - 1e-7:
            inside = inside[:-1]
        return inside


def _greatest(values: Iterable[Real]) -> float:
    """The greatest size that three quarters of the places stay below: beside a stop speeds grow without bound."""
    sizes = (np.abs(np.ravel(np.asarray(value, dtype=float))) for value in values)
    finite = (size[np.isfinite(size)] for size in sizes)
    return max((float(np.percentile(size, 75)) for size in finite if size.size), default=0.0)


def stretch(course: Course, ranges: tuple[str, ...], names: tuple[str, ...], by: Road) -> CourseStretch:
    """The stretch of a course: from the first to the last position, and on to a dead point that is close behind."""
    t = np.unique(course.t)
    low, high, path = float(t[0]), float(t[-1]), course.path
    if not path.low <= low or not high <= path.high:  # traced on as far as the positions lie
        farther = trace(course.method, path.pace, min(path.low, low), max(path.high, high), (path, 0.0))
        course = replace(course, path=farther)
    gap = float(np.max(np.diff(t))) * 1.5 if t.size > 1 else math.inf
    before, after = False, False
    if course.dropped.size or not ranges:
        for stop in course.path.stops:
            if stop.at > high and stop.at - high <= gap:
                high, after = stop.at, True
            elif stop.at < low and low - stop.at <= gap:
                low, before = stop.at, True
    turn = course.angular and not course.path.stops and sum(map(bool, course.path.pace)) == 1
    if turn and not course.method.structure.contacts and high - low > TURN:
        high = low + TURN
    return CourseStretch(course, by, names, low, high, (before, after))
