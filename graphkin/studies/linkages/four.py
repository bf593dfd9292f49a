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
from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.studies.linkages.assembled import assembled, turning
from graphkin.studies.linkages.equal import even
from graphkin.studies.linkages.first_position import TURNS, sine, well_drawn
from graphkin.studies.linkages.lengths import check_closing, check_driver, check_links
from graphkin.studies.linkages.linkage import DriverScale, LinkagePosition, MotionRange, Sums, TransmissionAngle, Turn
from graphkin.studies.linkages.triangles import angles, apex, folded, phase, spanned, whole


@frozen
class FourBar:
    """Frame AD, crank AB, coupler BC, rocker DC: four revolute pairs.

    crank, coupler, rocker, frame   AB, BC, CD, AD [m]; "crank" is only the first link on the frame
    driver    "crank", "coupler", "rocker": which link is driven
    names     what A, B, C, D are called
    places    A, B, C, D at the drawn position; left out: A at the origin, D on +x, C to the left of BD
    scale     how the driver's angle is counted; left out: the angle of AB (or DC) to +x

    Raises NotALength, CannotDriveBy, OnlyStretched, CannotClose.
    """

    word: ClassVar[str] = "fourbar"
    drivers: ClassVar[tuple[str, ...]] = ("crank", "coupler", "rocker")

    crank: float
    coupler: float
    rocker: float
    frame: float
    driver: str = "crank"
    names: tuple[str, ...] = ("A", "B", "C", "D")
    places: tuple[complex, ...] = ()
    scale: DriverScale | None = None

    def __post_init__(self) -> None:
        sizes = self.sizes
        check_links(sizes)
        check_driver(self.driver, self.drivers)
        long = max(sizes, key=lambda link: sizes[link])
        others = [link for link in sizes if link != long]
        check_closing(long, sizes[long], others, sum(self.lengths) - sizes[long])
        object.__setattr__(self, "places", self.places or _start(self))

    @property
    def lengths(self) -> tuple[float, float, float, float]:
        """Round about, the frame last [m]."""
        return self.crank, self.coupler, self.rocker, self.frame

    @property
    def called(self) -> dict[str, str]:
        a, b, c, d = self.names
        return {"crank": a + b, "coupler": b + c, "rocker": c + d, "frame": a + d}

    @property
    def sizes(self) -> dict[str, float]:
        return dict(zip(self.called.values(), self.lengths))

    @property
    def output(self) -> str:
        return "crank" if self.driver == "rocker" else "rocker"

    @property
    def block(self) -> bool:
        return False

    @property
    def drawn(self) -> LinkagePosition:
        bar = _from_driver(self)
        return _lettered(self, [_position(bar, bar.places, "")])[0]

    @property
    def stroke(self) -> float | None:
        return None

    @property
    def arm(self) -> tuple[int, int]:
        return (0, 1) if self.output == "crank" else (3, 2)

    def sums(self) -> Sums:
        """Grashof's: shortest and longest link, and the two others."""
        sizes = self.sizes
        order = sorted(sizes, key=lambda link: sizes[link])
        ends, middle = (order[0], order[3]), (order[1], order[2])
        return Sums(ends, middle, sizes[ends[0]] + sizes[ends[1]], sizes[middle[0]] + sizes[middle[1]])

    def kind(self) -> tuple[str, str]:
        """The kind, and for a change point its family."""
        gap = self.sums().gap
        if gap > 0:
            return "triple-rocker", ""
        return ("change-point", _family(self)) if gap == 0 else (_by_shortest(self), "")

    def turns(self) -> tuple[Turn, ...]:
        """The four hinges, then the two pairs of opposite links."""
        names = tuple(self.called.values())
        hinges = [_turns_fully(self.lengths, k) for k in range(4)]
        found = [Turn(names[k], names[(k + 1) % 4], hinges[k], True) for k in range(4)]
        together = self.kind()[1] in ("parallelogram", "rhombus")
        for k in (0, 1):
            one, other = hinges[k], hinges[k + 1]
            full = one != other or (one and not together)
            found.append(Turn(names[k], names[k + 2], full, False))
        return tuple(found)

    def driver_range(self) -> MotionRange:
        bar = _from_driver(self)
        return _range(bar).turned(_base(bar))

    def output_range(self) -> MotionRange:
        bar = _swapped(_from_driver(self))
        return _range(bar).turned(_base(bar))

    def limits(self) -> tuple[LinkagePosition, ...]:
        """The two ends of the output link's swing, the stretched one first; none where it turns fully."""
        seen = _from_driver(self)
        other = _swapped(seen)
        found = _range(other)
        if found.full:
            return ()
        ends = [_limit(seen, other, angle) for angle in (found.low, found.high)]
        return _lettered(self, sorted(ends, key=lambda end: end.how != "stretched"))

    def critical(self) -> tuple[LinkagePosition, ...]:
        """The driver in line with the frame, and its own ends."""
        return _lettered(self, _critical(_from_driver(self)))

    def direction(self, position: LinkagePosition) -> float:
        a, b, c, d = position.places
        return cmath.phase(c - d if self.driver == "rocker" else b - a)

    def position_at(self, direction: float) -> LinkagePosition:
        """Of AB, for one driven there, and of DC, for one driven there."""
        bar = _from_driver(self)
        return _lettered(self, [_at(bar, direction - _base(bar), _side(bar), "")])[0]

    def driver_at(self, direction: float) -> float:
        other = _swapped(_from_driver(self))
        _, _, b, a = _at(other, direction - _base(other), _side(other), "").places
        return cmath.phase(b - a)

    def ratio(self, direction: float) -> float:
        """Both ends of the coupler have the same speed along it."""
        bar = _from_driver(self)
        a, b, c, d = bar.position_at(direction).places
        along = c - b
        given, taken = (along.conjugate() * (b - a)).imag, (along.conjugate() * (c - d)).imag
        return given / taken if taken else math.inf

    def seen(self, position: LinkagePosition) -> TransmissionAngle:
        """Between the coupler and the output link."""
        a, b, c, d = position.places
        return TransmissionAngle(b, b - c, a - b) if self.driver == "rocker" else TransmissionAngle(c, c - b, d - c)

    def mechanism(self, omega: float = 10.0) -> Mechanism:
        (a, b, c, d), (pa, pb, pc, pd) = self.names, self.places
        link, vector, along = {
            "crank": ("1", (a, b), pb - pa), "coupler": ("2", (b, c), pc - pb), "rocker": ("3", (d, c), pc - pd),
        }[self.driver]  # fmt: skip
        links = {FRAME: {a: pa, d: pd}, "1": {a: pa, b: pb}, "2": {b: pb, c: pc}, "3": {d: pd, c: pc}}
        return assembled("4", links, (), (turning(link, vector, along, omega),))


# --- kinds ----------------------------------------------------------------------------------------


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
    a, b, c, d = bar.places
    return abs((b - a) - (c - d)) < 1e-6 * (bar.crank + bar.rocker)


def _turns_fully(sizes: tuple[float, ...], k: int) -> bool:
    one, other, far, farther = (sizes[(k + step) % 4] for step in range(4))
    return angles(one, other, far, farther) == (0.0, math.pi)


# --- ranges and positions ------------------------------------------------------------------------


def _start(bar: FourBar) -> tuple[complex, ...]:
    """The crank at 60 deg or near, as far as it gets, C on the left of BD."""
    low, high = angles(bar.crank, bar.frame, bar.coupler, bar.rocker)
    drawn = []
    for turn in (*(turn for turn in TURNS if low + 0.02 < turn < high - 0.02), (low + high) / 2):
        b, d = cmath.rect(bar.crank, turn), complex(bar.frame)
        drawn.append((0j, b, apex(b, d, bar.coupler, bar.rocker, 1.0), d))
    if bar.driver == "rocker":
        return well_drawn(drawn, lambda a, b, c, d: sine(b - a, c - b))
    return well_drawn(drawn, lambda a, b, c, d: sine(b - c, d - c))


def _from_driver(bar: FourBar) -> FourBar:
    """The same linkage with the driven link in the place of the crank."""
    return _swapped(bar) if bar.driver == "rocker" else bar


def _swapped(bar: FourBar) -> FourBar:
    """Lettered from the other end: the same places, D for A."""
    return replace(
        bar, crank=bar.rocker, rocker=bar.crank, names=bar.names[::-1], places=bar.places[::-1],
        driver="crank", scale=bar.scale if bar.driver == "rocker" else None,
    )  # fmt: skip


def _base(bar: FourBar) -> float:
    """Direction of the frame, A to D."""
    return cmath.phase(bar.places[3] - bar.places[0])


def _range(bar: FourBar) -> MotionRange:
    """Angles of AB against AD."""
    a, b, _, d = bar.places
    return spanned(*angles(bar.crank, bar.frame, bar.coupler, bar.rocker), cmath.phase((b - a) / (d - a)))


def _lettered(bar: FourBar, ends: Iterable[LinkagePosition]) -> tuple[LinkagePosition, ...]:
    """Places in the order of the linkage's own names."""
    if bar.driver != "rocker":
        return tuple(ends)
    return tuple(replace(end, places=end.places[::-1]) for end in ends)


def _limit(bar: FourBar, other: FourBar, angle: float) -> LinkagePosition:
    """The output at an angle against D -> A at which AB and BC lie in line."""
    a, d = bar.places[0], bar.places[3]
    c = d + cmath.rect(bar.rocker, _base(other) + angle)
    stretched = abs(abs(c - a) - bar.crank - bar.coupler) < abs(abs(c - a) - abs(bar.crank - bar.coupler))
    sense = 1.0 if stretched or bar.crank > bar.coupler else -1.0
    b = a + sense * bar.crank * (c - a) / abs(c - a)
    return _position(bar, (a, b, c, d), "stretched" if stretched else "folded")


def _position(bar: FourBar, places: tuple[complex, ...], how: str) -> LinkagePosition:
    a, b, c, d = places
    turned = phase(b - a)
    value = turned if bar.scale is None else whole(bar.scale(turned))
    gamma = None if bar.driver == "coupler" else folded(b - c, d - c)
    return LinkagePosition(places, 0.0, value, phase(c - d), gamma, how)


def _critical(bar: FourBar) -> Iterator[LinkagePosition]:
    found, side = _range(bar), _side(bar)
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


def _at(bar: FourBar, angle: float, side: float, how: str) -> LinkagePosition:
    a, d = bar.places[0], bar.places[3]
    b = a + cmath.rect(bar.crank, _base(bar) + angle)
    if abs(d - b) < 1e-9 * bar.frame:
        return _over_pivot(bar, b, how)
    return _position(bar, (a, b, apex(b, d, bar.coupler, bar.rocker, side), d), how)


def _over_pivot(bar: FourBar, b: complex, how: str) -> LinkagePosition:
    """AB lies on AD, BC on DC, the two of one length each: C may be anywhere about D."""
    return replace(_position(bar, (bar.places[0], b, bar.places[2], bar.places[3]), how), gamma=0.0)
