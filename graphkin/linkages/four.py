"""The four-bar in closed form: what turns, limits, transmission angle, dead points.

Everything follows from two triangles: ABD and BCD at the driver's side, ADC and ABC at the output's. A link's
angle against the frame is stopped where the two links opposite lie in line; that is a dead point of a driver
there, and a limit of an output. Source: 孙桓《机械原理》铰链四杆机构; Grashof 1883.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

from graphkin.linkages.model import FourBar, angles, apex, even
from graphkin.linkages.parts import Position, Range, Turn, folded, spanned, whole

__all__ = [
    "critical", "dead", "driven", "driver_at", "driver_range", "kind", "labels", "limits", "output_range",
    "position_at", "ratio", "seen_from_driver", "sums", "turns",
]  # fmt: skip


def labels(bar: FourBar) -> tuple[str, str, str, str]:
    """What crank, coupler, rocker and frame are called: AB, BC, CD, AD."""
    a, b, c, d = bar.names
    return a + b, b + c, c + d, a + d


def sums(bar: FourBar) -> tuple[tuple[str, str], tuple[str, str], float, float]:
    """Shortest and longest link, the two others, both sums [m]: Grashof's law holds where the first is not greater."""
    sizes = dict(zip(labels(bar), bar.lengths))
    order = sorted(sizes, key=lambda link: sizes[link])
    ends, middle = (order[0], order[3]), (order[1], order[2])
    return ends, middle, sizes[ends[0]] + sizes[ends[1]], sizes[middle[0]] + sizes[middle[1]]


def kind(bar: FourBar) -> tuple[str, str]:
    """The kind, and for a change point its family."""
    _, _, ends, middle = sums(bar)
    gap = even(ends - middle, ends + middle)
    if gap > 0:
        return "triple-rocker", ""
    return ("change-point", _family(bar)) if gap == 0 else (_by_shortest(bar), "")


def _by_shortest(bar: FourBar) -> str:
    shortest = min(range(4), key=lambda k: bar.lengths[k])
    if shortest == 3:
        return "double-crank"
    if shortest == 1:
        return "double-rocker"
    driven_there = (shortest == 0) != (bar.driver == "rocker")
    return "crank-rocker" if driven_there else "rocker-crank"


def _family(bar: FourBar) -> str:
    a, b, c, d = bar.lengths

    def same(one: float, other: float) -> bool:
        return even(one - other, a + b + c + d) == 0

    if same(a, b) and same(b, c) and same(c, d):
        return "rhombus" if _parallel(bar) else "folded rhombus"
    if same(a, c) and same(b, d):
        return "parallelogram" if _parallel(bar) else "antiparallelogram"
    if (same(a, b) and same(c, d)) or (same(a, d) and same(b, c)):
        return "kite"
    return _by_shortest(bar)


def _parallel(bar: FourBar) -> bool:
    """Whether AB and DC point the same way at the drawn position."""
    a, b, c, d = bar.places
    return abs((b - a) - (c - d)) < 1e-6 * (bar.crank + bar.rocker)


def turns(bar: FourBar) -> tuple[Turn, ...]:
    """The four hinges, then the two pairs of opposite links."""
    names, sizes = labels(bar), bar.lengths
    hinges = [_turns_fully(sizes, k) for k in range(4)]
    found = [Turn(names[k], names[(k + 1) % 4], hinges[k], True) for k in range(4)]
    together = kind(bar)[1] in ("parallelogram", "rhombus")
    for k in (0, 1):
        one, other = hinges[k], hinges[k + 1]
        full = one != other or (one and not together)
        found.append(Turn(names[k], names[k + 2], full, False))
    return tuple(found)


def _turns_fully(sizes: tuple[float, ...], k: int) -> bool:
    one, other, far, farther = (sizes[(k + step) % 4] for step in range(4))
    return angles(one, other, far, farther) == (0.0, math.pi)


# --- ranges and positions ------------------------------------------------------------------------


def seen_from_driver(bar: FourBar) -> FourBar:
    """The same linkage with the driven link in the place of the crank."""
    return _swapped(bar) if bar.driver == "rocker" else bar


def _swapped(bar: FourBar) -> FourBar:
    """Lettered from the other end: the same places, D for A."""
    return replace(
        bar, crank=bar.rocker, rocker=bar.crank, names=bar.names[::-1], places=bar.places[::-1],
        driver="crank", scale=bar.scale if bar.driver == "rocker" else None,
    )  # fmt: skip


def driver_range(bar: FourBar) -> Range:
    """What the driven link goes through; directions from its fixed to its moving hinge [rad]."""
    bar = seen_from_driver(bar)
    found = _range(bar)
    base = _base(bar)
    return Range(base + found.low, base + found.high, found.full)


def output_range(bar: FourBar) -> Range:
    """What the output link goes through; directions from its fixed to its moving hinge [rad]."""
    other = _swapped(seen_from_driver(bar))
    found, base = _range(other), _base(other)
    return Range(base + found.low, base + found.high, found.full)


def _base(bar: FourBar) -> float:
    """Direction of the frame, A to D."""
    return cmath.phase(bar.places[3] - bar.places[0])


def _range(bar: FourBar) -> Range:
    """Angles of AB against AD."""
    a, b, _, d = bar.places
    return spanned(*angles(bar.crank, bar.frame, bar.coupler, bar.rocker), cmath.phase((b - a) / (d - a)))


def limits(bar: FourBar) -> tuple[Position, ...]:
    """The two ends of the output link's swing, the stretched one first; none where it turns fully."""
    seen = seen_from_driver(bar)
    other = _swapped(seen)
    found = _range(other)
    if found.full:
        return ()
    ends = [_limit(seen, other, angle) for angle in (found.low, found.high)]
    return _lettered(bar, sorted(ends, key=lambda end: end.how != "stretched"))


def _lettered(bar: FourBar, ends: Iterable[Position]) -> tuple[Position, ...]:
    """Places in the order of the linkage's own names."""
    if bar.driver != "rocker":
        return tuple(ends)
    return tuple(replace(end, places=end.places[::-1]) for end in ends)


def _limit(bar: FourBar, other: FourBar, angle: float) -> Position:
    """The output at an angle against D -> A at which AB and BC lie in line."""
    a, d = bar.places[0], bar.places[3]
    c = d + cmath.rect(bar.rocker, _base(other) + angle)
    stretched = abs(abs(c - a) - bar.crank - bar.coupler) < abs(abs(c - a) - abs(bar.crank - bar.coupler))
    sense = 1.0 if stretched or bar.crank > bar.coupler else -1.0
    b = a + sense * bar.crank * (c - a) / abs(c - a)
    return _position(bar, (a, b, c, d), "stretched" if stretched else "folded")


def _position(bar: FourBar, places: tuple[complex, ...], how: str) -> Position:
    a, b, c, d = places
    turned = whole(cmath.phase(b - a))
    value = turned if bar.scale is None else whole(bar.scale(turned))
    gamma = None if bar.driver == "coupler" else folded(b - c, d - c)
    return Position(places, 0.0, value, whole(cmath.phase(c - d)), gamma, how)


def critical(bar: FourBar) -> tuple[Position, ...]:
    """Where the transmission angle can be least: the driver in line with the frame, and its own ends."""
    return _lettered(bar, _critical(seen_from_driver(bar)))


def _critical(bar: FourBar) -> Iterator[Position]:
    found = _range(bar)
    side = _side(bar)
    for angle, how in ((0.0, "inner"), (math.pi, "outer")):
        if found.full or found.low < angle < found.high:
            yield _at(bar, angle, side, how)
    if not found.full:
        for angle in (found.low, found.high):
            yield _at(bar, angle, 0.0, "end")


def _side(bar: FourBar) -> float:
    """1 where C lies to the left of B -> D, else -1."""
    _, b, c, d = bar.places
    return 1.0 if ((d - b).conjugate() * (c - b)).imag >= 0 else -1.0


def _at(bar: FourBar, angle: float, side: float, how: str) -> Position:
    a, d = bar.places[0], bar.places[3]
    b = a + cmath.rect(bar.crank, _base(bar) + angle)
    if abs(d - b) < 1e-9 * bar.frame:
        return _over_pivot(bar, b, how)
    return _position(bar, (a, b, apex(b, d, bar.coupler, bar.rocker, side), d), how)


def _over_pivot(bar: FourBar, b: complex, how: str) -> Position:
    """AB lies on AD, BC on DC, the two of one length each: C may be anywhere about D."""
    c = bar.places[2] if bar.rocker > 0 else b
    return replace(_position(bar, (bar.places[0], b, c, bar.places[3]), how), gamma=0.0)


def dead(bar: FourBar) -> dict[str, tuple[float, ...]]:
    """Where a driver at AB, and one at CD, cannot move the others: directions of those links [rad]."""
    a, b, c, d = bar.names
    first = bar if bar.driver != "rocker" else replace(bar, driver="crank", scale=None)
    first = replace(first, driver="crank")
    second = bar if bar.driver == "rocker" else replace(bar, driver="rocker", scale=None)
    return {a + b: _dead(first), c + d: _dead(seen_from_driver(second))}


def _dead(bar: FourBar) -> tuple[float, ...]:
    return tuple(sorted({end.driver for end in _critical(bar) if end.gamma == 0}))


# --- many positions at once ------------------------------------------------------------------------


def position_at(bar: FourBar, turned: float) -> Position:
    """The position with AB at a direction [rad], assembled as drawn; for a linkage driven at AB."""
    return _at(bar, turned - _base(bar), _side(bar), "")


def driver_at(bar: FourBar, turned: float) -> float:
    """Direction of AB where the output DC has a direction [rad], assembled as drawn."""
    other = _swapped(bar)
    _, _, b, a = _at(other, turned - _base(other), _side(other), "").places
    return cmath.phase(b - a)


def driven(bar: FourBar, turned: float) -> tuple[complex, ...]:
    """A, B, C, D with the driven link at a direction [rad], assembled as drawn."""
    bar = seen_from_driver(bar)
    return _at(bar, turned - _base(bar), _side(bar), "").places


def ratio(bar: FourBar, places: tuple[complex, ...]) -> float:
    """Output's over driver's angular velocity, places as seen from the driver; infinite at a dead point.

    Both ends of the coupler have the same speed along it.
    """
    a, b, c, d = places
    along = c - b
    given = (along.conjugate() * (b - a)).imag
    taken = (along.conjugate() * (c - d)).imag
    return given / taken if taken else math.inf
