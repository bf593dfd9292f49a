"""One condition answered: over all positions of a stretch, or at single positions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import assert_never

import numpy as np

from graphkin import errors
from graphkin.base.geometry import dot, number, place
from graphkin.base.value import frozen
from graphkin.errors import Where
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import common_link, pair
from graphkin.model.quantities import Moving
from graphkin.planning import Method
from graphkin.proof import roads as agreement
from graphkin.running.other_positions import reached
from graphkin.running.path import DriverPath
from graphkin.studies.finding import comparing, conditions
from graphkin.studies.finding.answers import Findings, Position, SlowPoint, Speeds
from graphkin.studies.finding.conditions import WHERE, Comparison, Condition, Extreme, Scaling, Slowest
from graphkin.studies.finding.stretch import CourseStretch, Reader, checked, quantity_of, stretch
from graphkin.studies.sweeps import Course, Road, Series, course, prove
from graphkin.studies.sweeps.roads import moving
from graphkin.studies.sweeps.sweep import series

_DEGREES = {"rad/s": 1, "m/s": 1, "rad/s^2": 2, "m/s^2": 2}
"""Velocities grow with the speeds, accelerations with their square."""
_SMALL = 1e-6  # a factor below this part of its largest size is none


def find(method: Method, condition: str, ranges: Sequence[str] = (), by: Road = "construction") -> Findings:
    """All positions with a property.

    condition  `v C = 0`, `theta 5 = 30`, `omega 2 = omega 3`, `a E > 3 g`, `max v E`, `min ..`, `range theta 3`,
               `stroke s ram`, `slowest BC`, `v E = 0.5 by omega 1`
    ranges     as `studies.sweeps.course` takes them: the stretch; a full turn or all that is reached where left
               out. `slowest` and `by` are answered at the drawn position, or at those of `ranges`
    by         the road by which quantities are read

    Raises BadCondition, UnknownQuantity, UnknownPoint, UnknownLink, UnknownSlide, OtherUnits, NegativeSize,
    NoLineOf, NoSuchDriver, NotScaled, CannotScale, BadRange, NoPosition, RoadsDiffer, and what a wrong unit raises.
    """
    parsed = conditions.read(method.mechanism, condition)
    match parsed:
        case Comparison():
            drawn = checked(method.mechanism, parsed.quantities)
            return _compared(parsed, drawn, _proved_stretch(method, ranges, parsed.quantities, by))
        case Extreme():
            drawn = checked(method.mechanism, parsed.quantities)
            over = _proved_stretch(method, ranges, parsed.quantities, by)
            if parsed.which == "stroke" and drawn[0].unit not in ("rad", "m"):
                raise errors.BadCondition(WHERE, condition)
            return _extreme(parsed, drawn, over)
        case Slowest():
            line_of(method.mechanism, parsed.of)
            at = _single_positions(method, ranges, by)
            return replace(_blank(method, parsed, at.swept, (), ()), slow=_slowest(method, parsed, at))
        case Scaling():
            drawn = checked(method.mechanism, (parsed.quantity,))
            at = _single_positions(method, ranges, by)
            blank = _blank(method, parsed, at.swept, (parsed.quantity,), drawn)
            return replace(blank, speeds=_scaled(method, parsed, at))
        case _:
            assert_never(parsed)


def limit(moved: Course, text: str, ranges: Sequence[str] = (), by: Road = "construction") -> Findings:
    """The `intervals` in which the size of a quantity passes a limit: `a E 3 g`, `omega 3 5 rad/s`."""
    parsed, where = conditions.limit(text), Where("--limit")
    drawn = checked(moved.method.mechanism, parsed.quantities, where)
    return _compared(parsed, drawn, stretch(moved, tuple(ranges), parsed.quantities, by), where)


def check_limit(mechanism: Mechanism, text: str) -> None:
    """Raises what is wrong with a limit, before anything is done for it."""
    parsed, where = conditions.limit(text), Where("--limit")
    target = conditions.value(parsed.other, checked(mechanism, parsed.quantities, where)[0].unit, where)
    if target < 0:
        raise errors.NegativeSize(where, parsed.quantity, parsed.other)


def _proved_stretch(method: Method, ranges: Sequence[str], names: tuple[str, ...], by: Road) -> CourseStretch:
    """The stretch of some ranges, on which the two roads agree."""
    prove(moved := course(method, ranges))
    return stretch(moved, tuple(ranges), names, by)


def _blank(
    method: Method, condition: Condition, swept: int, names: tuple[str, ...], drawn: tuple[Series, ...]
) -> Findings:
    """Findings without an answer."""
    units = tuple(entry.unit for entry in drawn)
    return Findings(condition, method, method.drivers, swept, None, False, (False, False), names, units)


def _blank_on(condition: Condition, drawn: tuple[Series, ...], over: CourseStretch) -> Findings:
    """Findings on a stretch, without an answer."""
    blank = _blank(over.course.method, condition, over.course.swept, over.names, drawn)
    ends = number(over.course.value(over.low)), number(over.course.value(over.high))
    return replace(blank, looked=ends, turn=over.closed, stopped=over.stopped)


def _compared(condition: Comparison, drawn: tuple[Series, ...], over: CourseStretch, where: Where = WHERE) -> Findings:
    sides = comparing.difference(over, condition, drawn, where)
    blank = _blank_on(condition, drawn, over)
    if sides.everywhere:
        return replace(blank, everywhere=condition.sign == "=", zero=sides.target == 0)
    if condition.sign != "=":
        parts = comparing.intervals(sides, condition.sign)
        return replace(blank, intervals=parts, nearest=None if parts else comparing.nearest(sides))
    positions = comparing.holding(sides)
    if sides.target == 0:
        positions = _with_factors(over, positions)
    return replace(blank, positions=positions, nearest=None if positions else comparing.nearest(sides))


def _with_factors(over: CourseStretch, positions: tuple[Position, ...]) -> tuple[Position, ...]:
    """Positions at which a Coriolis acceleration `a_k B3B2` is 0, each with the factors that are; others as they are.

    It is 0 because its link does not turn, or because nothing slides.
    """
    mechanism = over.course.method.mechanism
    quantity = quantity_of(mechanism, over.names[0])
    if not isinstance(quantity, Moving) or quantity.part != "k" or quantity.seen_from is None or not positions:
        return positions
    link = quantity.seen_from.link
    names = [f"omega {mechanism.called(link)}"] if link != FRAME else []
    names.append(f"v {over.names[0].split(' ', 1)[1]}")
    reader = Reader(over.course, names, over.by)
    largest = [float(np.nanmax(np.abs(each.signed))) for each in reader.read(over.places)]
    here = [np.abs(each.signed) for each in reader.read(np.array([position.t for position in positions]))]
    sizes = [*zip(names, here, largest, strict=True)]
    factors = [tuple(name for name, size, most in sizes if size[k] <= _SMALL * most) for k in range(len(positions))]
    return tuple(replace(each, factors=zeros) for each, zeros in zip(positions, factors, strict=True))


def _extreme(condition: Extreme, drawn: tuple[Series, ...], over: CourseStretch) -> Findings:
    ends, blank = comparing.extremes(over), _blank_on(condition, drawn, over)
    if ends.level:
        zero = float(np.nanmax(np.abs(ends.curve.values), initial=0.0)) <= over.noise(drawn[0].unit)
        t = (over.low + over.high) / 2 if over.stopped[0] else over.low  # at a dead point nothing can be drawn
        here = over.position(t, "here", (0.0, *(0.0 for _ in over.names[1:])) if zero else None)
        return replace(blank, everywhere=True, zero=zero, positions=(here,))
    if condition.which == "max":
        positions = ends.highest
        guided = drawn[0].along is not None and ends.highest and ends.lowest
        if guided and -ends.lowest[0].values[0] > ends.highest[0].values[0] * (1 + 1e-9):  # faster the other way
            positions += tuple(replace(each, kind="largest") for each in ends.lowest if each.kind != "pole")
        return replace(blank, positions=positions)
    if condition.which == "min":
        return replace(blank, positions=ends.lowest)
    blank = replace(blank, positions=ends.lowest + ends.highest, swing=ends.swing)
    if condition.which == "range":
        return blank
    strokes, notes = comparing.stroke(over, ends)
    return replace(blank, stroke=strokes, notes=notes)


@frozen
class SearchPoints:
    """Positions t (n,) on a path, and the motions there."""

    path: DriverPath
    swept: int
    t: np.ndarray
    motions: Motions

    def position(self, k: int, values: tuple[float, ...]) -> Position:
        drivers = tuple(number(value) for value in self.path.values(float(self.t[k])))
        return Position(float(self.t[k]), drivers, values, "here")


def _single_positions(method: Method, ranges: Sequence[str], by: Road) -> SearchPoints:
    """The drawn position; with `AB=30` (no steps) that one; with ranges all of theirs."""
    if any(":" in text for text in ranges):
        prove(moved := course(method, ranges))
        return SearchPoints(moved.path, moved.swept, moved.t, moving(method, moved.path, moved.t, by))
    values = _driver_values(method, ranges)
    agreement.proved(method, values)
    path, t = reached(method, values)
    at = np.array([t])
    return SearchPoints(path, 0, at, moving(method, path, at, by))


def _driver_values(method: Method, ranges: Sequence[str]) -> list[float]:
    """The drivers' values at the drawn position, with those of `AB=30` put in."""
    values = [float(value) for value in method.facts(None).values]
    names, where = [driver.name for driver in method.drivers], Where("--driver")
    changed: set[int] = set()
    for count, text in enumerate(ranges):
        name, equals, size = text.rpartition("=")
        if (equals and name.strip() not in names) or (not equals and count >= len(names)):
            raise errors.NoSuchDriver(where, name.strip() or text, tuple(names))
        at = names.index(name.strip()) if equals else count
        if at in changed:
            raise errors.GivenTwice(where, names[at])
        changed.add(at)
        values[at] = conditions.value(size.strip(), "m" if method.drivers[at].kind == "slide" else "rad", where)
    return values


def line_of(mechanism: Mechanism, of: str) -> tuple[str, str, str]:
    """The link and two of its points that `BC`, or a link's name, means. Raises NoLineOf."""
    if of in mechanism.moving:
        points = mechanism.named(of)
        if len(points) > 1:
            return of, points[0], points[1]
    elif (sites := pair(mechanism, of)) is not None and sites[0].point != sites[1].point:
        link = common_link(mechanism, *sites)
        if link is not None and {site.point for site in sites} <= set(mechanism.links[link].points):
            return link, sites[0].point, sites[1].point
    lines = [link for link in mechanism.moving if len(mechanism.named(link)) > 1]
    raise errors.NoLineOf(WHERE, of, tuple(lines))


def _slowest(method: Method, condition: Slowest, at: SearchPoints) -> tuple[SlowPoint, ...]:
    """The foot of the perpendicular from the instant centre: there the velocity lies along the line."""
    link, first, second = line_of(method.mechanism, condition.of)
    position, slow = at.motions.position, []
    rows = (position[first], position[second], at.motions.omega[link], at.motions.velocity_at(first, link))
    for k, (a, b, turning, v) in enumerate(zip(*(np.broadcast_to(row, at.t.shape) for row in rows), strict=True)):
        start, end, velocity, omega = place(a), place(b), place(v), number(turning)
        length = abs(end - start)
        line = (end - start) / length
        if abs(omega) * length <= 1e-12 * max(abs(velocity), 1e-300):
            point = SlowPoint(at.position(k, (abs(velocity),)), (first, second), None, length, start, abs(velocity))
        else:
            along, speed = -number(dot(1j * line, velocity)) / omega, abs(number(dot(line, velocity)))
            foot = start + along * line
            point = SlowPoint(at.position(k, (speed,)), (first, second), along, length, foot, speed)
        slow.append(point)
    return tuple(slow)


def _scaled(method: Method, condition: Scaling, at: SearchPoints) -> tuple[Speeds, ...]:
    """All drivers' speeds times one factor (their accelerations times its square), so that a quantity has a value.

    Raises NotScaled, NegativeSize, CannotScale.
    """
    name = condition.quantity
    entry = series(name, quantity_of(method.mechanism, name), at.motions, at.t.size)
    degree = _DEGREES.get(entry.unit)
    if degree is None:
        raise errors.NotScaled(WHERE, name)
    target = conditions.value(condition.value, entry.unit)
    if target < 0 and entry.vectors is not None and entry.along is None:
        raise errors.NegativeSize(WHERE, name, condition.value)
    speeds = []
    for k, now in enumerate(map(float, entry.signed)):
        factor: float | None = None
        if target == 0:
            factor = 0.0
        elif abs(now) > 1e-12 * abs(target) and math.isfinite(now):  # the sense changes only where it must
            ratio = target / now
            factor = ratio if degree == 1 else math.sqrt(ratio) if ratio > 0 else None
        if factor is None:
            shown = f"{now:.6g} {entry.unit}" if abs(now) > 1e-12 else f"0 {entry.unit}"
            raise errors.CannotScale(WHERE, name, shown, condition.value)
        rates = tuple(driver.rate * factor for driver in method.drivers)
        speeds.append(Speeds(at.position(k, (target,)), factor, rates, now))
    return tuple(speeds)
