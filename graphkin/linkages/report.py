"""Everything there is to say of a linkage of four links, as one value.

`report(FourBar(0.015, 0.048, 0.055, 0.045))`: kind and Grashof's sums, who turns fully against whom, limits with
swing or stroke, theta and K, the least transmission angle over the whole turn, dead points for either driver.
Closed forms throughout; only the least mechanical advantage, which has none, is looked for.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cached_property

from graphkin.errors import GraphkinError, Where
from graphkin.linkages import four, guide, slider
from graphkin.linkages.model import FourBar, GuideBar, Linkage, SliderCrank
from graphkin.linkages.parts import Position, Range, Turn, whole
from graphkin.value import frozen

__all__ = ["Advantage", "Report", "advantage", "from_lengths", "report", "timed"]

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
    driver_range: Range
    output_range: Range
    limits: tuple[Position, ...]
    stroke: float | None
    theta: float | None
    k: float | None
    slow: tuple[int, int] | None
    critical: tuple[Position, ...]
    dead: Mapping[str, tuple[float, ...]]
    timed_by: str = ""

    @property
    def driver_span(self) -> Range:
        """What the driver goes through, as its scale counts."""
        span, scale = self.driver_range, self.linkage.scale
        if scale is None or self.linkage.driver in ("slider", "slide"):
            return span
        return Range(span.low + scale.zero, span.high + scale.zero, span.full)

    @property
    def swing(self) -> float | None:
        """The output link's swing; None where it turns fully or slides."""
        slides = isinstance(self.linkage, SliderCrank) and self.linkage.driver != "slider"
        return None if slides or self.output_range.full else self.output_range.width

    @property
    def gamma_min(self) -> float | None:
        """Least transmission angle over everything the driver reaches."""
        found = [end.gamma for end in self.critical if end.gamma is not None]
        return min(found, default=None)

    @property
    def least(self) -> tuple[Position, ...]:
        """Where it is least; none where it is the same everywhere."""
        least = self.gamma_min
        return () if least is None or self.level else tuple(
            end for end in self.critical if end.gamma is not None and end.gamma - least < _SAME
        )  # fmt: skip

    @property
    def level(self) -> bool:
        """Whether the transmission angle is 90 deg throughout: a guide bar without offset, driven by its crank."""
        bar = self.linkage
        return isinstance(bar, GuideBar) and bar.driver == "crank" and (self.gamma_min or 0.0) > math.pi / 2 - _SAME

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

    >>> found = report(from_lengths("fourbar", 0.015, 0.048, 0.055, 0.045))
    >>> found.kind, round(math.degrees(found.theta), 3), round(found.k, 4)
    ('crank-rocker', 29.859, 1.3977)
    """
    match linkage:
        case FourBar():
            return _four_bar(linkage)
        case SliderCrank():
            return _slider_crank(linkage)
        case GuideBar():
            return _guide_bar(linkage)


def from_lengths(kind: str, *lengths: float, driver: str = "crank") -> Linkage:
    """A linkage by its lengths [m]: "fourbar" (crank, coupler, rocker, frame), "slider" (crank, rod, offset),
    "guide" (crank, frame, offset). Raises NotALength, CannotClose, OnlyStretched, CannotDriveBy."""
    made: dict[str, Callable[..., Linkage]] = {"fourbar": FourBar, "slider": SliderCrank, "guide": GuideBar}
    try:
        return made[kind](*lengths, driver=driver)
    except GraphkinError as error:
        raise error.at(Where(f"--{kind}")) from None


def _four_bar(bar: FourBar) -> Report:
    crank, coupler, rocker, _ = four.labels(bar)
    driver = {"crank": crank, "coupler": coupler, "rocker": rocker}[bar.driver]
    return _report(
        bar, four.kind(bar), four.sums(bar), four.turns(bar), driver, crank if bar.driver == "rocker" else rocker,
        four.driver_range(bar), four.output_range(bar), four.limits(bar), None, four.critical(bar), four.dead(bar),
    )  # fmt: skip


def _slider_crank(linkage: SliderCrank) -> Report:
    crank, rod, block = slider.labels(linkage)
    driver = {"crank": crank, "coupler": rod, "slider": block}[linkage.driver]
    return _report(
        linkage, slider.kind(linkage), slider.sums(linkage), slider.turns(linkage), driver,
        crank if linkage.driver == "slider" else block, slider.driver_range(linkage),
        slider.output_range(linkage), slider.limits(linkage), slider.stroke(linkage), slider.critical(linkage),
        slider.dead(linkage),
    )  # fmt: skip


def _guide_bar(bar: GuideBar) -> Report:
    crank, name, _ = guide.labels(bar)
    driver = {"crank": crank, "bar": name, "slide": bar.scale.name if bar.scale else "s"}[bar.driver]
    return _report(
        bar, guide.kind(bar), guide.sums(bar), guide.turns(bar), driver, name if bar.driver == "crank" else crank,
        guide.driver_range(bar), guide.output_range(bar), guide.limits(bar), None, guide.critical(bar), guide.dead(bar),
    )  # fmt: skip


def _report(
    linkage: Linkage, kind: tuple[str, str], sums: tuple[tuple[str, str], tuple[str, str], float, float],
    turns: tuple[Turn, ...], driver: str, output: str, driver_range: Range, output_range: Range,
    limits: tuple[Position, ...], stroke: float | None, critical: tuple[Position, ...],
    dead: Mapping[str, tuple[float, ...]],
) -> Report:  # fmt: skip
    theta, k, slow = _quick_return(linkage, kind[0], driver_range, limits)
    ends, middle, sum_ends, sum_middle = sums
    grashof = kind[0] not in ("triple-rocker", "rocking guide bar") and kind[1] != "no full turn"
    return Report(
        linkage, *kind, grashof, ends, middle, sum_ends, sum_middle, turns, driver, output, driver_range, output_range,
        limits, stroke, theta, k, slow, critical, dead,
    )  # fmt: skip


def _quick_return(
    linkage: Linkage, kind: str, driver_range: Range, limits: tuple[Position, ...]
) -> tuple[float | None, float | None, tuple[int, int] | None]:
    """theta, K and the slow way, for a driver that turns round and round while its output swings."""
    turning = linkage.driver == "crank" or (isinstance(linkage, FourBar) and linkage.driver == "rocker")
    if not turning or not driver_range.full or len(limits) != 2 or kind == "change-point":
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
    if not found.driver_range.full or linkage.driver in ("coupler", "slide", "bar") or found.kind == "change-point":
        return None
    zero = found.driver_range.low

    def size(turned: float) -> float:
        return abs(_ratio(linkage, turned))

    best = max(range(_STEPS), key=lambda k: size(zero + k * math.tau / _STEPS))
    step = math.tau / _STEPS
    at = _highest(size, zero + (best - 1) * step, zero + (best + 1) * step)
    greatest = size(at)
    least = 0.0 if math.isinf(greatest) or greatest > 1e12 else 1 / greatest
    value = at if linkage.scale is None else linkage.scale(at)
    return Advantage(least, whole(value), tuple(end.driver for end in found.limits))


def _ratio(linkage: Linkage, turned: float) -> float:
    match linkage:
        case FourBar():
            bar = four.seen_from_driver(linkage)
            return four.ratio(bar, four.driven(bar, turned))
        case SliderCrank():
            return slider.ratio(linkage, slider.driven(linkage, turned))
        case GuideBar():
            return guide.ratio(linkage, guide.driven(linkage, turned))


def _highest(size: Callable[[float], float], low: float, high: float) -> float:
    """Golden section."""
    part = (math.sqrt(5) - 1) / 2
    for _ in range(60):
        left, right = high - part * (high - low), low + part * (high - low)
        low, high = (low, right) if size(left) > size(right) else (left, high)
    return (low + high) / 2
