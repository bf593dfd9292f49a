"""The slider-crank in closed form: what turns, stroke, transmission angle, dead points.

The pressure angle lies between the rod and the guide; gamma is 90 deg less that. It is least not at the limits but
where the crank stands at right angles to the guide on the side away from it. Driven at the slider, gamma is the
angle between rod and crank.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace

from graphkin.linkages.model import EVEN, SliderCrank, even
from graphkin.linkages.parts import Position, Range, Turn, folded, whole

__all__ = [
    "critical", "dead", "driven", "driver_range", "kind", "labels", "limits", "output_range",
    "position_at", "ratio",
    "stroke", "sums", "turns",
]  # fmt: skip


def labels(slider: SliderCrank) -> tuple[str, str, str]:
    """What crank, rod and slider are called: AB, BC, C."""
    a, b, c = slider.names
    return a + b, b + c, c


def sums(slider: SliderCrank) -> tuple[tuple[str, str], tuple[str, str], float, float]:
    """Shorter link and offset, the longer link, and both sums [m]: one turns where the first is not greater."""
    sizes = dict(zip(labels(slider), (slider.crank, slider.coupler)))
    short, long = sorted(sizes, key=lambda link: sizes[link])
    return (short, "e"), (long, ""), sizes[short] + abs(slider.offset), sizes[long]


def kind(slider: SliderCrank) -> tuple[str, str]:
    """The kind, and what is special about it."""
    _, _, short, long = sums(slider)
    gap = even(short - long, short + long)
    line = "in-line" if even(slider.offset, short + long) == 0 else "offset"
    if gap == 0:
        return "change-point", "isosceles" if line == "in-line" else "slider-crank"
    if gap > 0:
        return "rocker-slider", "no full turn"
    return ("slider-crank", line) if slider.crank < slider.coupler else ("rocker-slider", "turning rod")


def turns(slider: SliderCrank) -> tuple[Turn, ...]:
    """Three hinges, then crank against slider and rod against the guide's link."""
    crank, rod, block = labels(slider)
    first, second = _turns_fully(slider.crank, slider), _turns_fully(slider.coupler, slider)
    name = "frame"
    return (
        Turn(crank, name, first, True), Turn(crank, rod, first or second, True), Turn(rod, block, second, True),
        Turn(crank, block, first, False), Turn(rod, name, second, False),
    )  # fmt: skip


def _turns_fully(length: float, slider: SliderCrank) -> bool:
    """Whether a link of this length turns against the guide; the other link is the rest."""
    other = slider.crank + slider.coupler - length
    return even(length + abs(slider.offset) - other, length + other) <= 0


# --- ranges and positions ------------------------------------------------------------------------


def driver_range(slider: SliderCrank) -> Range:
    """What the crank goes through [rad], or the slider [m, as its scale counts]."""
    if slider.driver == "slider":
        ends = sorted(_slid(slider, along) for along in _reach(slider))
        return Range(ends[0], ends[1])
    found = _range(slider)
    return Range(slider.way + found.low, slider.way + found.high, found.full)


def output_range(slider: SliderCrank) -> Range:
    """What the slider goes through [m], or the crank where the slider drives it [rad]."""
    if slider.driver == "slider":
        return driver_range(replace(slider, driver="crank"))
    ends = sorted(_reach(slider))
    return Range(ends[0], ends[1])


def _own(slider: SliderCrank) -> tuple[complex, ...]:
    """Drawn places in axes with A as origin and x along the guide."""
    return tuple((place - slider.places[0]) * cmath.rect(1, -slider.way) for place in slider.places)


def _range(slider: SliderCrank) -> Range:
    """Angles of AB against the guide: B may be no farther than BC from it."""
    r, rod, e = slider.crank, slider.coupler, slider.offset
    size = r + rod + abs(e)
    over, under = even(e + rod - r, size) < 0, even(rod - e - r, size) < 0
    high, low = math.asin(max(-1.0, min(1.0, (e + rod) / r))), math.asin(max(-1.0, min(1.0, (e - rod) / r)))
    if over and under:
        left = _own(slider)[1].real < 0
        return Range(math.pi - high, math.pi - low) if left else Range(low, high)
    if over:
        return Range(math.pi - high, math.tau + high)
    if under:
        return Range(low, math.pi - low)
    return Range(0.0, math.tau, True)


def _reach(slider: SliderCrank) -> tuple[float, float]:
    """How far along the guide, from the foot of A, the slider goes: its stretched end first."""
    e, sum_, gap = slider.offset, slider.crank + slider.coupler, abs(slider.crank - slider.coupler)
    far = math.sqrt((sum_ - e) * (sum_ + e))
    if even(gap - abs(e), sum_) <= 0:
        return far, -far
    side = 1.0 if _own(slider)[2].real >= 0 else -1.0
    return side * far, side * math.sqrt((gap - e) * (gap + e))


def stroke(slider: SliderCrank) -> float:
    """How far the slider goes from end to end [m]."""
    first, second = _reach(slider)
    return abs(first - second)


def limits(slider: SliderCrank) -> tuple[Position, ...]:
    """The two ends of the output's way: of the slider, or of the crank where the slider drives."""
    if slider.driver == "slider":
        found = _range(slider)
        if found.full:
            return ()
        ends = [_at(slider, angle, 0.0, "end") for angle in (found.low, found.high)]
        return tuple(replace(end, output=whole(cmath.phase(end.places[1] - end.places[0]))) for end in ends)
    return tuple(_limit(slider, along) for along in _reach(slider))


def _limit(slider: SliderCrank, along: float) -> Position:
    """The slider at an end: AB and BC in line."""
    c = complex(along, slider.offset)
    far = slider.crank + slider.coupler
    stretched = abs(abs(c) - far) < abs(abs(c) - abs(slider.crank - slider.coupler))
    sense = 1.0 if stretched or slider.crank > slider.coupler else -1.0
    b = sense * slider.crank * c / abs(c) if abs(c) > EVEN * far else slider.crank * 1j
    return _position(slider, b, c, "stretched" if stretched else "folded")


def _position(slider: SliderCrank, b: complex, c: complex, how: str) -> Position:
    """From the axes of the guide to the drawing's."""
    turn = cmath.rect(1, slider.way)
    a = slider.places[0]
    angle, slid = whole(cmath.phase(b * turn)), _slid(slider, c.real)
    if slider.driver == "slider":
        return Position((a, a + b * turn, a + c * turn), slider.way, slid, angle, folded(b, c - b), how)
    gamma = None if slider.driver == "coupler" else folded(c - b, 1j)
    value = angle if slider.scale is None else whole(slider.scale(angle))
    return Position((a, a + b * turn, a + c * turn), slider.way, value, c.real, gamma, how)


def _slid(slider: SliderCrank, along: float) -> float:
    """The slider's place as a driver counts it."""
    return slider.scale(along) if slider.scale is not None and slider.driver == "slider" else along


def critical(slider: SliderCrank) -> tuple[Position, ...]:
    """Where the transmission angle can be least."""
    if slider.driver == "slider":
        return tuple(_limit(slider, along) for along in _reach(slider))
    return tuple(_critical(slider))


def _critical(slider: SliderCrank) -> Iterator[Position]:
    """The crank at right angles to the guide, and its own ends."""
    found = _range(slider)
    side = 1.0 if _own(slider)[2].real >= _own(slider)[1].real else -1.0
    away = -1.0 if slider.offset > 0 else 1.0
    for sine, how in ((away, "far"), (-away, "near")):
        if abs(slider.offset - slider.crank * sine) <= slider.coupler * (1 + EVEN):
            yield _at(slider, sine * math.pi / 2, side, how)
    if not found.full:
        for angle in (found.low, found.high):
            yield _at(slider, angle, 0.0, "end")


def _at(slider: SliderCrank, angle: float, side: float, how: str) -> Position:
    """The crank at an angle against the guide, the slider ahead of B (side 1), behind it (-1), or level with it (0)."""
    b = cmath.rect(slider.crank, angle)
    high = abs(slider.offset - b.imag)
    gap = even(slider.coupler - high, slider.coupler)
    along = side * math.sqrt(max(0.0, gap * (slider.coupler + high)))
    return _position(slider, b, complex(b.real + along, slider.offset), how)


def dead(slider: SliderCrank) -> dict[str, tuple[float, ...]]:
    """Where a driver at the crank [rad], and one at the slider [m], cannot move the others."""
    crank, _, block = labels(slider)
    mine = {"crank": crank, "slider": block}.get(slider.driver, "")
    found: dict[str, tuple[float, ...]] = {}
    for name, driver in ((crank, "crank"), (block, "slider")):
        seen = slider if name == mine else replace(slider, driver=driver, scale=None)
        found[name] = tuple(sorted({end.driver for end in critical(seen) if end.gamma == 0}))
    return found


# --- many positions at once ------------------------------------------------------------------------


def position_at(slider: SliderCrank, turned: float) -> Position:
    """The position with the crank at a direction [rad], assembled as drawn; for a linkage driven at the crank."""
    own = _own(slider)
    return _at(slider, turned - slider.way, 1.0 if own[2].real >= own[1].real else -1.0, "")


def driven(slider: SliderCrank, turned: float) -> tuple[complex, ...]:
    """A, B, C with the crank at a direction [rad], assembled as drawn."""
    return position_at(replace(slider, driver="crank", scale=None), turned).places


def ratio(slider: SliderCrank, places: tuple[complex, ...]) -> float:
    """The slider's velocity along the guide over the crank's angular velocity [m/rad]."""
    a, b, c = places
    rod = c - b
    given = (rod.conjugate() * (1j * (b - a))).real
    taken = (rod.conjugate() * cmath.rect(1, slider.way)).real
    return given / taken if taken else math.inf
