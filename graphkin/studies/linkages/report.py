"""The report of a linkage of four links as one value, by itself or behind another, and as plain data.

`report(FourBar(0.015, 0.048, 0.055, 0.045))`: kind and Grashof's sums, who turns fully against whom, limits with
swing or stroke, theta and K, the least transmission angle over the whole turn, dead points for either driver.
Closed forms throughout; only the least mechanical advantage, which has none, is searched.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property

from graphkin.base.plain import Plain
from graphkin.base.value import bulky, frozen
from graphkin.model.mechanism import FRAME
from graphkin.studies.linkages.family import Linkage
from graphkin.studies.linkages.linkage import CRANKS, SLIDES, LinkagePosition, Sums, Turn
from graphkin.studies.linkages.recognised import FoundLinkage
from graphkin.studies.linkages.triangles import MotionRange, even, greatest_between, whole

_SAME = 1e-9  # transmission angles nearer than this are both the least [rad]
_STEPS, _SAMPLES = 720, 180
"""Steps over a full turn in which the least advantage is searched; over the range of a linkage behind another."""


@frozen
class Advantage:
    """Output over input without friction: torque over torque, force over torque [1/m].

    least   its smallest size over the driver's range, and the driver's value there
    endless the driver's values at which it grows without limit: the output is at its limits
    """

    least: float
    at: float
    endless: tuple[float, ...]


@bulky
class Report:
    """Kind, ranges, limits and angles of a linkage. Angles [rad], lengths [m]; None where a quantity does not exist.

    kind, family    "crank-rocker", "change-point" with "parallelogram", ..
    grashof         some link turns fully: shortest + longest <= the rest
    sums            Grashof's two sums
    driver, output  the parts: AB, CD, or C for a slider; driver_range, output_range: what they go through
    limits          the output's two ends (of its swing or stroke); none where it turns fully
    theta, k        between the crank positions at the limits; time ratio
    slow            the limits (from, to) between which the output takes longer while the driver's value grows
    critical        positions at which the transmission angle can be least; `least`: those of them at which it is
    dead            by driver: its values at which it moves nothing; empty where there are none
    timed_by        the crank to which theta, K and `slow` belong, where it is not this linkage's driver
    found           where it is one of a mechanism: its links there
    """

    linkage: Linkage
    kind: str
    family: str
    grashof: bool
    sums: Sums
    turns: tuple[Turn, ...]
    driver: str
    output: str
    driver_range: MotionRange
    output_range: MotionRange
    limits: tuple[LinkagePosition, ...]
    stroke: float | None
    theta: float | None
    k: float | None
    slow: tuple[int, int] | None
    critical: tuple[LinkagePosition, ...]
    dead: Mapping[str, tuple[float, ...]]
    timed_by: str = ""
    found: FoundLinkage | None = None

    @property
    def slide(self) -> str:
        """The name of its sliding part: C, or the name of a slide; empty where nothing slides."""
        return next((name for part, name in self.linkage.called.items() if part in SLIDES), "")

    @property
    def driver_slides(self) -> bool:
        """True if the driver's values are displacements [m]."""
        return self.linkage.driver in SLIDES

    @property
    def output_slides(self) -> bool:
        """True if the output's are."""
        return self.linkage.output in SLIDES

    @property
    def driver_span(self) -> MotionRange:
        """The driver's range, as its scale counts."""
        scale = self.linkage.scale
        return self.driver_range if scale is None or self.driver_slides else self.driver_range.turned(scale.zero)

    @property
    def swing(self) -> float | None:
        """The output link's swing; None where it turns fully or slides."""
        return None if self.output_slides or self.output_range.full else self.output_range.width

    @property
    def guided(self) -> list[complex]:
        """The places on a fixed guide at its limits and extreme transmission angles [m]."""
        names = {slide.point for slide in self.linkage.mechanism().slides if slide.guide == FRAME}
        ends = (zip(self.linkage.names, end.places, strict=True) for end in (*self.limits, *self.critical))
        return [place for end in ends for name, place in end if name in names]

    @property
    def gamma_min(self) -> float | None:
        """Least transmission angle over everything the driver reaches."""
        return min((end.gamma for end in self.critical if end.gamma is not None), default=None)

    @property
    def least(self) -> tuple[LinkagePosition, ...]:
        """The positions at which it is least; none where it is the same everywhere."""
        least = self.gamma_min
        if least is None or self.level:
            return ()
        return tuple(end for end in self.critical if end.gamma is not None and end.gamma - least < _SAME)

    @property
    def level(self) -> bool:
        """True if the transmission angle is 90 deg throughout: a guide bar without offset, driven by its crank."""
        return (self.gamma_min or 0.0) > math.pi / 2 - _SAME

    @property
    def alpha_max(self) -> float | None:
        """Largest pressure angle."""
        return None if self.gamma_min is None else math.pi / 2 - self.gamma_min

    @cached_property
    def advantage(self) -> Advantage | None:
        """The least mechanical advantage over a full turn of the crank; None for other drivers and at change points."""
        return advantage(self)


def report(linkage: Linkage) -> Report:
    """The report of a linkage by itself.

    >>> from graphkin.studies.linkages import from_lengths
    >>> bar = report(from_lengths("fourbar", 0.015, 0.048, 0.055, 0.045))
    >>> bar.kind, round(math.degrees(bar.theta), 3), round(bar.k, 4)
    ('crank-rocker', 29.859, 1.3977)
    """
    (kind, family), limits, span = linkage.kind(), linkage.limits(), linkage.driver_range()
    theta, k, slow = None, None, None
    if linkage.driver in CRANKS and span.full and len(limits) == 2 and kind != "change-point":
        theta, k, slow = timed(limits[0].driver, limits[1].driver)
    dead: dict[str, tuple[float, ...]] = {}
    for part in linkage.drivers:  # that have a transmission angle where they drive
        ends = (linkage if part == linkage.driver else replace(linkage, driver=part, scale=None)).critical()
        if all(end.gamma is not None for end in ends):
            dead[linkage.called[part]] = tuple(sorted({end.driver for end in ends if end.gamma == 0}))
    grashof = kind not in ("triple-rocker", "rocking guide bar") and family != "no full turn"
    return Report(
        linkage, kind, family, grashof, linkage.sums(), linkage.turns(), linkage.called[linkage.driver],
        linkage.called[linkage.output], span, linkage.output_range(), limits, linkage.stroke, theta, k, slow,
        linkage.critical(), dead,
    )  # fmt: skip


def timed(first: float, second: float) -> tuple[float, float, tuple[int, int] | None]:
    """theta, K and `Report.slow` from the crank's directions at both limits [rad]."""
    turned = whole(second - first)
    theta = abs(turned - math.pi)
    theta = 0.0 if theta < 1e-12 else theta
    slow = None if theta == 0 else (0, 1) if turned > math.pi else (1, 0)
    return theta, (math.pi + theta) / (math.pi - theta), slow


def advantage(whole_report: Report) -> Advantage | None:
    """Searched over a full turn in steps of half a degree, then narrowed down by golden section."""
    linkage, span = whole_report.linkage, whole_report.driver_range
    if not span.full or linkage.driver not in CRANKS or whole_report.kind == "change-point":
        return None

    def size(turned: float) -> float:
        return abs(linkage.ratio(turned))

    step = math.tau / _STEPS
    best = max(range(_STEPS), key=lambda k: size(span.low + k * math.tau / _STEPS))
    at = greatest_between(size, span.low + (best - 1) * step, span.low + (best + 1) * step, 60)
    greatest = size(at)
    least = 0.0 if math.isinf(greatest) or greatest > 1e12 else 1 / greatest
    value = at if linkage.scale is None else linkage.scale(at)
    return Advantage(least, whole(value), tuple(end.driver for end in whole_report.limits))


# --- behind another linkage -------------------------------------------------------------------


def reported(one: FoundLinkage) -> Report:
    """The report of a linkage as it moves in its mechanism.

    The rocker of a shaper's guide bar swings, so the ram it drives goes only as far as that swing takes it, and its K
    is that of the swing. Behind a link that turns fully but unevenly (a rotating guide bar, a drag link) the second
    linkage has its own limits, and K comes from the first one's crank at those limits.
    """
    alone = replace(report(one.linkage), found=one)
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
    # in which the first linkage stops the driven link
    ends = replace(linkage.position_at(span.low), how="end"), replace(linkage.position_at(span.high), how="end")
    inner = [end for end in alone.critical if _reached(linkage, end, span)]
    stops = [end for end in alone.limits if _reached(linkage, end, span)]
    values = _unwound(linkage, span, [*ends, *stops])
    lowest, highest = min(values, key=lambda pair: pair[0]), max(values, key=lambda pair: pair[0])
    limits = (lowest[1], highest[1])
    # dead points of the driven link that it reaches; the output is dead at all its limits, if a crank makes them
    dead = dict(alone.dead)
    dead[alone.driver] = tuple(v for v in dead.get(alone.driver, ()) if whole(v - span.low) <= span.width)
    outer = limits if first.driver_range.full or first.timed_by else stops
    dead[alone.output] = tuple(sorted(end.output for end in outer))
    restricted = replace(
        alone, driver_range=span, output_range=MotionRange(lowest[0], highest[0]), limits=limits,
        stroke=highest[0] - lowest[0] if alone.output_slides else None, theta=None, k=None, slow=None,
        critical=(*inner, *ends), dead=dead, timed_by="",
    )  # fmt: skip
    return _as_first(restricted, first, ends)


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


def as_json(report: Report) -> dict[str, Plain]:
    """`{"format": 1, "kind": .., "grashof": .., ..}`: angles in rad, lengths in m.

    Driver angles are directions to +x, counted as the file's driver counts them; those of a link that is not driven
    go from its fixed to its moving hinge; a slider's place is its displacement [m]. `driver_range` is null where it
    turns round and round; `slow`: from which to which of `limits` (0, 1) the output goes slowly.
    """
    least, advantage, span = report.least, report.advantage, report.driver_span
    at = least[0].driver if least else None
    return {
        "format": 1, "kind": report.kind, "family": report.family or None, "grashof": report.grashof,
        "lengths": dict(report.linkage.sizes), "driver": report.driver, "output": report.output,
        "driver_range": None if span.full else [span.low, span.high],
        "full_turns": [[turn.first, turn.second] for turn in report.turns if turn.full],
        "swing": report.swing, "stroke": report.stroke, "limits": [_position(report, end) for end in report.limits],
        "theta": report.theta, "K": report.k, "slow": None if report.slow is None else list(report.slow),
        "gamma_min": report.gamma_min, "gamma_min_at": at, "alpha_max": report.alpha_max, "alpha_max_at": at,
        "critical": [_position(report, end) for end in report.critical],
        "dead_points": {driver: list(values) for driver, values in report.dead.items()},
        "advantage_min": None if advantage is None else advantage.least,
        "advantage_min_at": None if advantage is None else advantage.at,
    }  # fmt: skip


def _position(report: Report, end: LinkagePosition) -> dict[str, Plain]:
    size = min(1.0, sum(abs(length) for length in report.linkage.sizes.values()))
    driver, output, gamma = (None if x is None else even(x, size) for x in (end.driver, end.output, end.gamma))
    return {"how": end.how, "driver": driver, "output": output, "gamma": gamma}
