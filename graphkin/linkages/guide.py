"""Guide bars in closed form: rotating and oscillating guide bar, oscillating block, oscillating cylinder.

The bar's line stays at a distance e from C and passes B. At the ends of its swing it touches the crank's circle:
the crank stands at right angles to it. Between block and bar the force is normal to the bar's line, and the bar's
point there moves at right angles to CB: with e = 0 the crank drives it at gamma = 90 deg throughout.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace

from graphkin.linkages.model import EVEN, GuideBar, even
from graphkin.linkages.parts import Position, Range, Turn, folded, spanned, whole

__all__ = [
    "critical", "dead", "driven", "driver_at", "driver_range", "kind", "labels", "limits", "output_range",
    "position_at", "ratio",
    "sums", "turns",
]  # fmt: skip


def labels(bar: GuideBar) -> tuple[str, str, str]:
    """What crank, bar and frame are called: AB, CB, AC."""
    a, b, c = bar.names
    return a + b, c + b, a + c


def sums(bar: GuideBar) -> tuple[tuple[str, str], tuple[str, str], float, float]:
    """Shorter of crank and frame with the offset, the longer, and both sides [m]."""
    crank, _, frame = labels(bar)
    sizes = {crank: bar.crank, frame: bar.frame}
    short, long = sorted(sizes, key=lambda link: sizes[link])
    return (short, "e"), (long, ""), sizes[short] + abs(bar.offset), sizes[long]


def kind(bar: GuideBar) -> tuple[str, str]:
    """The kind, and whether bar or block stands on the frame."""
    _, _, short, long = sums(bar)
    gap = even(short - long, short + long)
    pivoted = "block" if bar.block else "bar"
    if gap == 0:
        return "change-point", pivoted
    if gap > 0:
        return "rocking guide bar", pivoted
    return ("rotating guide bar" if bar.crank > bar.frame else "oscillating guide bar"), pivoted


def turns(bar: GuideBar) -> tuple[Turn, ...]:
    """Three hinges (the block turns with the bar), then crank against bar, frame against block."""
    crank, name, frame = labels(bar)
    short, other = _turns_fully(bar.crank, bar), _turns_fully(bar.frame, bar)
    return (
        Turn(crank, frame, short or other, True), Turn(name, frame, other, True), Turn(crank, name, short, True),
    )  # fmt: skip


def _turns_fully(length: float, bar: GuideBar) -> bool:
    """Whether the link of this length, and so the frame or the crank, turns fully against the bar."""
    other = bar.crank + bar.frame - length
    return even(length + abs(bar.offset) - other, length + other) <= 0


# --- ranges and positions ------------------------------------------------------------------------


def _base(bar: GuideBar) -> float:
    """Direction of the frame, A to C."""
    return cmath.phase(bar.places[2] - bar.places[0])


def _ahead(bar: GuideBar) -> float:
    """1 where B is ahead of C on the bar, else -1."""
    _, b, c = bar.places
    return 1.0 if ((b - c) * cmath.rect(1, -bar.turn)).real >= 0 else -1.0


def _crank_range(bar: GuideBar) -> Range:
    """Angles of AB against AC: B may not come nearer to C than the offset."""
    r, d, e = bar.crank, bar.frame, abs(bar.offset)
    if even(abs(d - r) - e, d + r) >= 0:
        return Range(0.0, math.tau, True)
    least = math.acos(max(-1.0, min(1.0, (r * r + d * d - e * e) / (2 * r * d))))
    return Range(least, math.tau - least)


def _normal_range(bar: GuideBar) -> Range:
    """Angles of the bar's left normal against AC: the bar's line may not pass A at more than the crank's length."""
    r, d, e = bar.crank, bar.frame, bar.offset
    over, under = even(r - e - d, r + d) < 0, even(r + e - d, r + d) < 0
    least = math.acos(max(-1.0, min(1.0, (r - e) / d))) if over else 0.0
    greatest = math.acos(max(-1.0, min(1.0, (-r - e) / d))) if under else math.pi
    return spanned(least, greatest, bar.turn + math.pi / 2 - _base(bar))


def _slid_range(bar: GuideBar) -> tuple[float, float]:
    """B's way along the bar from the foot of C: farthest end first."""
    r, d, e = bar.crank, bar.frame, abs(bar.offset)
    far, near = math.sqrt((d + r - e) * (d + r + e)), abs(d - r)
    if even(near - e, d + r) <= 0:
        return far, -far
    return _ahead(bar) * far, _ahead(bar) * math.sqrt((near - e) * (near + e))


def driver_range(bar: GuideBar) -> Range:
    """What the crank or the bar goes through [rad], or the block along the bar [m, as its scale counts]."""
    if bar.driver == "slide":
        ends = sorted(_counted(bar, along) for along in _slid_range(bar))
        return Range(ends[0], ends[1])
    return _turned(bar, "bar" if bar.driver == "bar" else "crank")


def output_range(bar: GuideBar) -> Range:
    """What the bar goes through where the crank drives it, else the crank [rad]."""
    return _turned(bar, "bar" if bar.driver == "crank" else "crank")


def _turned(bar: GuideBar, link: str) -> Range:
    """What crank or bar goes through: their directions on the drawing."""
    found, zero = (_crank_range(bar), 0.0) if link == "crank" else (_normal_range(bar), -math.pi / 2)
    base = _base(bar) + zero
    return Range(base + found.low, base + found.high, found.full)


def limits(bar: GuideBar) -> tuple[Position, ...]:
    """The ends of the output's swing: of the bar where the crank drives it, else of the crank."""
    if bar.driver == "crank":
        found = _normal_range(bar)
        return () if found.full else tuple(_tangent(bar, angle, "across") for angle in (found.low, found.high))
    turning = _crank_range(bar)
    return () if turning.full else tuple(_at(bar, angle, "end") for angle in (turning.low, turning.high))


def _tangent(bar: GuideBar, normal: float, how: str) -> Position:
    """The bar's left normal at an angle against AC, and B on the bar where the crank reaches it, on the side drawn."""
    d = complex(bar.frame)
    n = cmath.rect(1, normal)
    high = bar.offset + bar.frame * n.real
    gap = even(bar.crank - abs(high), bar.crank)
    along = _ahead(bar) * math.sqrt(max(0.0, gap * (bar.crank + abs(high))))
    return _position(bar, n * complex(high, -along), d, -1j * n, how)


def _at(bar: GuideBar, angle: float, how: str) -> Position:
    """The crank at an angle against AC."""
    b, c = cmath.rect(bar.crank, angle), complex(bar.frame)
    far, e = abs(b - c), abs(bar.offset)
    gap = even(far - e, bar.crank + bar.frame)
    along = _ahead(bar) * math.sqrt(max(0.0, gap * (far + e)))
    arm = complex(along, bar.offset)
    if abs(arm) < EVEN * bar.frame:
        return _position(bar, b, c, -1j * b / abs(b), how)
    along_bar = (b - c) / arm
    return _position(bar, b, c, along_bar / abs(along_bar), how)


def _position(bar: GuideBar, b: complex, c: complex, along: complex, how: str) -> Position:
    """From the axes of the frame to the drawing's."""
    turn, a = cmath.rect(1, _base(bar)), bar.places[0]
    crank, direction = whole(cmath.phase(b * turn)), whole(cmath.phase(along * turn))
    slid = ((b - c) * along.conjugate()).real
    value = {"crank": crank, "bar": direction, "slide": slid}[bar.driver]
    if bar.scale is not None:
        value = bar.scale(value) if bar.driver == "slide" else whole(bar.scale(value))
    output = direction if bar.driver == "crank" else crank
    return Position((a, a + b * turn, a + c * turn), direction, value, output, _gamma(bar, b, c, along), how)


def _gamma(bar: GuideBar, b: complex, c: complex, along: complex) -> float:
    """Angle between what pushes and the arm it pushes at; 90 deg - it lies between force and velocity."""
    if bar.driver == "crank":
        arm = complex(((b - c) * along.conjugate()).real, bar.offset)
        return folded(1j, arm) if abs(arm) > EVEN * bar.frame else math.pi / 2
    if bar.driver == "bar":
        return folded(1j * along, b)
    return folded(b - c, b)


def _counted(bar: GuideBar, along: float) -> float:
    return along if bar.scale is None else bar.scale(along)


def critical(bar: GuideBar) -> tuple[Position, ...]:
    """Where the transmission angle can be least."""
    return tuple(_by_bar(bar) if bar.driver == "bar" else _by_crank(bar))


def _by_crank(bar: GuideBar) -> Iterator[Position]:
    """The crank in line with the frame, and its own ends (for a cylinder those are no dead points)."""
    found = _crank_range(bar)
    for angle, how in ((0.0, "inner"), (math.pi, "outer")):
        if found.full or found.low < angle < found.high:
            yield _at(bar, angle, how)
    if not found.full and bar.driver == "crank":
        for angle in (found.low, found.high):
            yield _at(bar, angle, "end")


def _by_bar(bar: GuideBar) -> Iterator[Position]:
    """The bar at right angles to the frame, and its own ends."""
    found = _normal_range(bar)
    if found.full:
        for angle in (0.0, math.pi):
            yield _tangent(bar, angle, "square")
    else:
        for angle in (found.low, found.high):
            yield _tangent(bar, angle, "across")


def dead(bar: GuideBar) -> dict[str, tuple[float, ...]]:
    """Where a driver at the crank, at the bar [rad], or at the block along the bar [m] cannot move the others."""
    crank, name, _ = labels(bar)
    found: dict[str, tuple[float, ...]] = {}
    slide = bar.scale.name if bar.driver == "slide" and bar.scale is not None else "s"
    for label, driver in ((crank, "crank"), (name, "bar"), (slide, "slide")):
        seen = bar if driver == bar.driver else replace(bar, driver=driver, scale=None)
        found[label] = tuple(sorted({end.driver for end in critical(seen) if end.gamma == 0}))
    return found


# --- many positions at once ------------------------------------------------------------------------


def position_at(bar: GuideBar, turned: float) -> Position:
    """The position with the driven crank or bar at a direction [rad], assembled as drawn."""
    if bar.driver == "bar":
        return _tangent(bar, turned + math.pi / 2 - _base(bar), "")
    return _at(bar, turned - _base(bar), "")


def driver_at(bar: GuideBar, turned: float) -> float:
    """Direction of the crank where the bar has a direction [rad], assembled as drawn."""
    a, b, _ = _tangent(bar, turned + math.pi / 2 - _base(bar), "").places
    return cmath.phase(b - a)


def driven(bar: GuideBar, turned: float) -> tuple[complex, ...]:
    """A, B, C with the crank at a direction [rad], assembled as drawn."""
    return _at(replace(bar, driver="crank", scale=None), turned - _base(bar), "").places


def ratio(bar: GuideBar, places: tuple[complex, ...]) -> float:
    """The bar's over the crank's angular velocity; the bar's direction follows from where B is ahead of C."""
    a, b, c = places
    arm = b - c
    along = math.sqrt(max(0.0, abs(arm) ** 2 - bar.offset**2))
    if along == 0:
        return math.inf
    line = arm / complex(_ahead(bar) * along, bar.offset)
    normal = 1j * line / abs(line)
    return (normal.conjugate() * 1j * (b - a)).real / ((normal.conjugate() * 1j * arm).real)
