"""One condition, looked for over all positions that are asked for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import assert_never

import numpy as np

from graphkin.errors import BadCondition, NegativeSize, Where
from graphkin.model.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.studies.finding import conditions
from graphkin.studies.finding.answers import Findings, Position
from graphkin.studies.finding.comparing import difference, holding, intervals, nearest
from graphkin.studies.finding.conditions import WHERE, Comparison, Extreme, Scaling, Slowest
from graphkin.studies.finding.extremes import Extremes, extremes, stroke
from graphkin.studies.finding.factors import with_factors
from graphkin.studies.finding.points import line_of, scaled, slowest, spots
from graphkin.studies.finding.quantities import checked
from graphkin.studies.finding.stretch import Stretch, stretch
from graphkin.studies.sweeps import Course, Road, Series, course, prove


def find(method: Method, condition: str, ranges: Sequence[str] = (), by: Road = "construction") -> Findings:
    """All positions with a property.

    condition  `v C = 0`, `theta 5 = 30`, `omega 2 = omega 3`, `a E > 3 g`, `max v E`, `min ..`, `range theta 3`,
               `stroke s ram`, `slowest BC`, `v E = 0.5 by omega 1`
    ranges     as `studies.sweeps.course` takes them: where to look; a full turn or all that is reached where left
               out. `slowest` and `by` are asked at the drawn position, or at those of `ranges`
    by         which road tells the quantities

    Raises BadCondition, UnknownQuantity, UnknownPoint, UnknownLink, UnknownSlide, OtherUnits, NegativeSize,
    NoLineOf, NoSuchDriver, NotScaled, CannotScale, BadRange, NoPosition, RoadsDiffer, and what a wrong unit raises.
    """
    wanted = conditions.read(method.mechanism, condition)
    match wanted:
        case Comparison():
            drawn = checked(method.mechanism, wanted.quantities)
            return _compared(method, wanted, drawn, _over(method, ranges, wanted.quantities, by))
        case Extreme():
            drawn = checked(method.mechanism, wanted.quantities)
            over = _over(method, ranges, wanted.quantities, by)
            if wanted.which == "stroke" and drawn[0].unit not in ("rad", "m"):
                raise BadCondition(WHERE, condition)
            return _extreme(method, wanted, drawn, over)
        case Slowest():
            line_of(method.mechanism, wanted.of)
            at = spots(method, ranges, by)
            return replace(_blank(method, wanted, at.swept, (), ()), slow=slowest(method, wanted, at))
        case Scaling():
            drawn = checked(method.mechanism, (wanted.quantity,))
            at = spots(method, ranges, by)
            blank = _blank(method, wanted, at.swept, (wanted.quantity,), drawn)
            return replace(blank, speeds=scaled(method, wanted, at))
        case _:
            assert_never(wanted)


def _over(method: Method, ranges: Sequence[str], names: tuple[str, ...], by: Road) -> Stretch:
    """Where it is looked: only where the two roads agree."""
    moved = course(method, ranges)
    prove(moved)
    return stretch(moved, tuple(ranges), names, by)


def limit(moved: Course, text: str, ranges: Sequence[str] = (), by: Road = "construction") -> Findings:
    """Where the size of a quantity passes a limit: `a E 3 g`, `omega 3 5 rad/s`. Its `intervals` say where."""
    wanted = conditions.limit(text)
    where = Where("--limit")
    drawn = checked(moved.method.mechanism, wanted.quantities, where)
    return _compared(moved.method, wanted, drawn, stretch(moved, tuple(ranges), wanted.quantities, by), where)


def check_limit(mechanism: Mechanism, text: str) -> None:
    """Raises what is wrong with a limit, before anything is done for it."""
    wanted = conditions.limit(text)
    where = Where("--limit")
    target = conditions.value(wanted.other, checked(mechanism, wanted.quantities, where)[0].unit, where)
    if target < 0:
        raise NegativeSize(where, wanted.quantity, wanted.other)


def _blank(
    method: Method, wanted: conditions.Condition, swept: int, names: tuple[str, ...], drawn: tuple[Series, ...]
) -> Findings:
    """Nothing found yet."""
    units, guided = tuple(entry.unit for entry in drawn), tuple(entry.along is not None for entry in drawn)
    return Findings(wanted, method.mechanism, method.drivers, swept, None, False, (False, False), names, units, guided)


def _looked(method: Method, wanted: conditions.Condition, drawn: tuple[Series, ...], over: Stretch) -> Findings:
    """Nothing found yet on a stretch."""
    swept = over.course.swept
    blank = _blank(method, wanted, swept, over.names, drawn)
    ends = float(over.course.value(over.low)), float(over.course.value(over.high))
    return replace(blank, looked=ends, turn=over.closed, stopped=over.stopped)


def _compared(
    method: Method, wanted: Comparison, drawn: tuple[Series, ...], over: Stretch, where: Where = WHERE
) -> Findings:
    two_sides = difference(over, wanted, drawn, where)
    blank = _looked(method, wanted, drawn, over)
    if two_sides.everywhere:
        return replace(blank, everywhere=wanted.sign == "=", zero=two_sides.target == 0)
    if wanted.sign != "=":
        parts = intervals(two_sides, wanted.sign)
        return replace(blank, intervals=parts, nearest=None if parts else nearest(two_sides))
    positions = holding(two_sides)
    if two_sides.target == 0:
        positions = with_factors(over, positions)
    return replace(blank, positions=positions, nearest=None if positions else nearest(two_sides))


def _extreme(method: Method, wanted: Extreme, drawn: tuple[Series, ...], over: Stretch) -> Findings:
    found, blank = extremes(over), _looked(method, wanted, drawn, over)
    if found.level:
        zero = float(np.nanmax(np.abs(found.curve.values), initial=0.0)) <= over.noise(drawn[0].unit)
        place = (over.low + over.high) / 2 if over.stopped[0] else over.low  # at a dead point nothing can be drawn
        here = over.position(place, "here", (0.0, *(0.0 for _ in over.names[1:])) if zero else None)
        return replace(blank, everywhere=True, zero=zero, positions=(here,))
    if wanted.which == "max":
        return replace(blank, positions=found.highest + _larger(over, found, drawn[0]))
    if wanted.which == "min":
        return replace(blank, positions=found.lowest)
    blank = replace(blank, positions=found.lowest + found.highest, swing=found.swing)
    if wanted.which == "range":
        return blank
    there_and_back, notes = stroke(over, found)
    return replace(blank, stroke=there_and_back, notes=notes)


def _larger(over: Stretch, found: Extremes, drawn: Series) -> tuple[Position, ...]:
    """Where a point on a guide is faster the other way than its greatest value."""
    if drawn.along is None or not found.highest or not found.lowest:
        return ()
    if -found.lowest[0].values[0] <= found.highest[0].values[0] * (1 + 1e-9):
        return ()
    return tuple(replace(position, kind="largest") for position in found.lowest if position.kind != "pole")
