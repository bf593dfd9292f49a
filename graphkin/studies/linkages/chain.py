"""Linkages one behind another: the range of the second, and the timing of its output, where the first one moves it.

The rocker of a shaper's guide bar swings, so the ram it drives goes only as far as that swing takes it, and its K
is that of the swing. Behind a link that turns fully but unevenly (a rotating guide bar, a drag link) the second
linkage has its own limits, and K comes from the first one's crank at those limits.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from graphkin.studies.linkages.linkage import SLIDES, Linkage, LinkagePosition
from graphkin.studies.linkages.recognised import FoundLinkage
from graphkin.studies.linkages.report import Report, report, timed
from graphkin.studies.linkages.triangles import MotionRange, whole

_SAMPLES = 180


def reported(one: FoundLinkage) -> Report:
    """The report of a linkage as it moves in its mechanism."""
    alone = report(one.linkage)
    if one.before is None:
        return alone
    first = reported(one.before)
    return _timed(alone, first) if first.output_range.full else _restricted(alone, first)


def _restricted(alone: Report, first: Report) -> Report:
    """The report of a linkage whose driven link goes no farther than the swing of the first linkage's output.

    One link has the directions of both: those of the first output are counted on to the second's drawn direction.
    """
    linkage, swing, drawn = alone.linkage, first.output_range, first.linkage.drawn.output
    turns = round((drawn - (swing.low + swing.high) / 2) / math.tau)
    low = linkage.direction(linkage.drawn) + (swing.low + turns * math.tau) - drawn
    span = MotionRange(low, low + swing.width)
    ends = _end(linkage, span.low), _end(linkage, span.high)
    inner = [end for end in alone.critical if _reached(linkage, end, span)]
    stops = [end for end in alone.limits if _reached(linkage, end, span)]
    values = _unwound(linkage, span, [*ends, *stops])
    lowest, highest = min(values, key=lambda pair: pair[0]), max(values, key=lambda pair: pair[0])
    limits = (lowest[1], highest[1])
    restricted = replace(
        alone, driver_range=span, output_range=MotionRange(lowest[0], highest[0]), limits=limits,
        stroke=highest[0] - lowest[0] if alone.output_slides else None, theta=None, k=None, slow=None,
        critical=(*inner, *ends), dead=_dead(alone, first, span, limits), timed_by="",
    )  # fmt: skip
    return _as_first(restricted, first, ends)


def _end(linkage: Linkage, direction: float) -> LinkagePosition:
    """The position in which the first linkage stops the driven link."""
    return replace(linkage.position_at(direction), how="end")


def _reached(linkage: Linkage, end: LinkagePosition, span: MotionRange) -> bool:
    """True if a position lies within the driven link's range, in the assembly that is drawn."""
    direction = linkage.direction(end)
    if end.how == "end" or whole(direction - span.low) > span.width:
        return False
    same = linkage.position_at(direction)
    size = max(abs(a - b) for a in end.places for b in end.places)
    return all(abs(a - b) < 1e-6 * size for a, b in zip(same.places, end.places))


def _unwound(
    linkage: Linkage, span: MotionRange, ends: Sequence[LinkagePosition]
) -> list[tuple[float, LinkagePosition]]:
    """Each position's output counted on from the low end without jumps of a turn."""
    if linkage.output in SLIDES:
        return [(end.output, end) for end in ends]
    marks: list[tuple[float, LinkagePosition | None]] = [(0.0, ends[0]), (span.width, ends[1])]
    marks += [(whole(linkage.direction(end) - span.low), end) for end in ends[2:]]
    steps: list[tuple[float, LinkagePosition | None]] = [(span.width * k / _SAMPLES, None) for k in range(_SAMPLES + 1)]
    count: float | None = None
    counted = []
    for along, end in sorted([*marks, *steps], key=lambda pair: pair[0]):
        output = (linkage.position_at(span.low + along) if end is None else end).output
        count = output if count is None else count + math.remainder(output - count, math.tau)
        if end is not None:
            counted.append((count, end))
    return counted


def _dead(
    alone: Report, first: Report, span: MotionRange, limits: tuple[LinkagePosition, LinkagePosition]
) -> dict[str, tuple[float, ...]]:
    """Dead points of the driven link that it reaches; the output is dead at all its limits, if a crank makes them."""
    dead = dict(alone.dead)
    dead[alone.driver] = tuple(v for v in dead.get(alone.driver, ()) if whole(v - span.low) <= span.width)
    crank = first.driver_range.full or first.timed_by
    ends = limits if crank else [end for end in alone.limits if _reached(alone.linkage, end, span)]
    dead[alone.output] = tuple(sorted(end.output for end in ends))
    return dead


def _as_first(second: Report, first: Report, ends: tuple[LinkagePosition, LinkagePosition]) -> Report:
    """theta and K of the first linkage, where the output's limits are those of the first linkage's swing."""
    if first.k is None or first.theta is None or not all(end in ends for end in second.limits):
        return second
    slow = None
    if first.slow is not None:
        order = [end.output for end in first.limits]
        low_first = abs(math.remainder(order[0] - first.output_range.low, math.tau)) < 1e-6
        mine = [second.limits.index(end) for end in (ends if low_first else ends[::-1])]
        slow = (mine[first.slow[0]], mine[first.slow[1]])
    return replace(second, theta=first.theta, k=first.k, slow=slow, timed_by=first.timed_by or first.driver)


def _timed(alone: Report, first: Report) -> Report:
    """The report behind a link that turns fully: K from the directions of the first crank at the second's limits."""
    linkage, before = alone.linkage, first.linkage
    if alone.k is None or not first.driver_range.full or first.kind == "change-point" or before.driver != "crank":
        return replace(alone, theta=None, k=None, slow=None)
    off = before.drawn.output - linkage.direction(linkage.drawn)
    one, other = (before.driver_at(linkage.direction(end) + off) for end in alone.limits)
    theta, k, slow = timed(one, other)
    return replace(alone, theta=theta, k=k, slow=slow, timed_by=first.driver)
