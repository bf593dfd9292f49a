"""Everything there is to say of a linkage of four links, as one value.

`report(FourBar(0.015, 0.048, 0.055, 0.045))`: kind and Grashof's sums, who turns fully against whom, limits with
swing or stroke, theta and K, the least transmission angle over the whole turn, dead points for either driver.
Closed forms throughout; only the least mechanical advantage, which has none, is looked for.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property

from graphkin.base.value import frozen
from graphkin.studies.linkages.linkage import CRANKS, SLIDES, Linkage, LinkagePosition, MotionRange, Turn
from graphkin.studies.linkages.triangles import whole

_SAME = 1e-9
"""Transmission angles nearer than this are both the least [rad]."""


@frozen
class Advantage:
    """What the output gives for what the driver takes, without friction: torque over torque, force over torque [1/m].

    least   its smallest size over the driver's range, and the driver's value there
    endless the driver's values at which it grows without limit: the output is at its limits
    """

    least: float
    at: float
    endless: tuple[float, ...]


@frozen
class Report:
    """What a linkage is and does. Angles [rad], lengths [m]; None where a quantity does not exist.

    kind, family    "crank-rocker", "change-point" with "parallelogram", ..
    grashof         whether some link turns fully: shortest + longest <= the rest
    ends, middle, sum_ends, sum_middle   the links of Grashof's two sums, and the sums
    driver, output  what drives and what is driven: AB, CD, or C for a slider
    driver_range, output_range   what driver and output go through
    limits          the output's two ends (of its swing or stroke); none where it turns fully
    theta, k        between the crank positions at the limits; time ratio
    slow            which way the output takes longer while the driver's value grows: (from, to) as numbers of limits
    critical        where the transmission angle can be least; `least`: those of them where it is
    dead            by driver: its values at which it moves nothing; empty where there are none
    timed_by        the crank that theta, K and the slow way are told of, where it is not this linkage's driver
    """

    linkage: Linkage
    kind: str
    family: str
    grashof: bool
    ends: tuple[str, str]
    middle: tuple[str, str]
    sum_ends: float
    sum_middle: float
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

    @property
    def slide(self) -> str:
        """What its sliding part is called: C, or the name of a slide; empty where nothing slides."""
        return next((name for part, name in self.linkage.called.items() if part in SLIDES), "")

    @property
    def driver_slides(self) -> bool:
        """Whether the driver's values are displacements [m]."""
        return self.linkage.driver in SLIDES

    @property
    def output_slides(self) -> bool:
        """Whether the output's are."""
        return self.linkage.output in SLIDES

    @property
    def driver_span(self) -> MotionRange:
        """What the driver goes through, as its scale counts."""
        scale = self.linkage.scale
        return self.driver_range if scale is None or self.driver_slides else self.driver_range.turned(scale.zero)

    @property
    def swing(self) -> float | None:
        """The output link's swing; None where it turns fully or slides."""
        return None if self.output_slides or self.output_range.full else self.output_range.width

    @property
    def gamma_min(self) -> float | None:
        """Least transmission angle over everything the driver reaches."""
        found = [end.gamma for end in self.critical if end.gamma is not None]
        return min(found, default=None)

    @property
    def least(self) -> tuple[LinkagePosition, ...]:
        """Where it is least; none where it is the same everywhere."""
        least = self.gamma_min
        return () if least is None or self.level else tuple(
            end for end in self.critical if end.gamma is not None and end.gamma - least < _SAME
        )  # fmt: skip

    @property
    def level(self) -> bool:
        """Whether the transmission angle is 90 deg throughout: a guide bar without offset, driven by its crank."""
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
    """What a linkage is and does.

    >>> from graphkin.studies.linkages import from_lengths
    >>> found = report(from_lengths("fourbar", 0.015, 0.048, 0.055, 0.045))
    >>> found.kind, round(math.degrees(found.theta), 3), round(found.k, 4)
    ('crank-rocker', 29.859, 1.3977)
    """
    (kind, family), sums, limits, span = linkage.kind(), linkage.sums(), linkage.limits(), linkage.driver_range()
    theta, k, slow = _quick_return(linkage, kind, span, limits)
    grashof = kind not in ("triple-rocker", "rocking guide bar") and family != "no full turn"
    return Report(
        linkage, kind, family, grashof, sums.ends, sums.middle, sums.sum_ends, sums.sum_middle, linkage.turns(),
        linkage.called[linkage.driver], linkage.called[linkage.output], span, linkage.output_range(), limits,
        linkage.stroke, theta, k, slow, linkage.critical(), dict(_dead(linkage)),
    )  # fmt: skip


def _dead(linkage: Linkage) -> Iterator[tuple[str, tuple[float, ...]]]:
    """Every part that has a transmission angle where it drives, and where that is 0."""
    for part in linkage.drivers:
        seen = linkage if part == linkage.driver else replace(linkage, driver=part, scale=None)
        ends = seen.critical()
        if all(end.gamma is not None for end in ends):
            yield linkage.called[part], tuple(sorted({end.driver for end in ends if end.gamma == 0}))


def _quick_return(
    linkage: Linkage, kind: str, driver_range: MotionRange, limits: tuple[LinkagePosition, ...]
) -> tuple[float | None, float | None, tuple[int, int] | None]:
    """theta, K and the slow way, for a driver that turns round and round while its output swings."""
    if linkage.driver not in CRANKS or not driver_range.full or len(limits) != 2 or kind == "change-point":
        return None, None, None
    return timed(limits[0].driver, limits[1].driver)


def timed(first: float, second: float) -> tuple[float, float, tuple[int, int] | None]:
    """theta, K and the slow way from the crank's directions at both limits [rad]."""
    turned = whole(second - first)
    theta = abs(turned - math.pi)
    theta = 0.0 if theta < 1e-12 else theta
    slow = None if theta == 0 else (0, 1) if turned > math.pi else (1, 0)
    return theta, (math.pi + theta) / (math.pi - theta), slow


# --- mechanical advantage --------------------------------------------------------------------------

_STEPS = 720


def advantage(found: Report) -> Advantage | None:
    """Looked for over a full turn in steps of half a degree, then narrowed down."""
    linkage = found.linkage
    if not found.driver_range.full or linkage.driver not in CRANKS or found.kind == "change-point":
        return None
    zero = found.driver_range.low

    def size(turned: float) -> float:
        return abs(linkage.ratio(turned))

    best = max(range(_STEPS), key=lambda k: size(zero + k * math.tau / _STEPS))
    step = math.tau / _STEPS
    at = _highest(size, zero + (best - 1) * step, zero + (best + 1) * step)
    greatest = size(at)
    least = 0.0 if math.isinf(greatest) or greatest > 1e12 else 1 / greatest
    value = at if linkage.scale is None else linkage.scale(at)
    return Advantage(least, whole(value), tuple(end.driver for end in found.limits))


def _highest(size: Callable[[float], float], low: float, high: float) -> float:
    """Golden section."""
    part = (math.sqrt(5) - 1) / 2
    for _ in range(60):
        left, right = high - part * (high - low), low + part * (high - low)
        low, high = (low, right) if size(left) > size(right) else (left, high)
    return (low + high) / 2
