"""The four-bar in closed form: what turns, limits, transmission angle, dead points.

Everything follows from two triangles: ABD and BCD at the driver's side, ADC and ABC at the output's. A link's
angle against the frame is stopped where the two links opposite lie in line; that is a dead point of a driver
there, and a limit of an output. Source: 孙桓《机械原理》铰链四杆机构; Grashof 1883.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from dataclasses import replace
from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.studies.linkages import triangles
from graphkin.studies.linkages.assembled import assembled, turning
from graphkin.studies.linkages.linkage import DriverScale, LinkagePosition, Sums, TransmissionAngle, Turn


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
    block: ClassVar[bool] = False
    stroke: ClassVar[float | None] = None

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
        triangles.check_parts(sizes, self.driver, self.drivers)
        long = max(sizes, key=lambda link: sizes[link])
        others = [link for link in sizes if link != long]
        triangles.check_closing(long, sizes[long], others, sum(self.lengths) - sizes[long])
        object.__setattr__(self, "places", self.places or self._first_places())

    def _first_places(self) -> tuple[complex, ...]:
        """The crank at 60 deg or near, as far as it gets, C on the left of BD."""
        low, high = triangles.angles(self.crank, self.frame, self.coupler, self.rocker)
        positions = []
        for turn in (*(turn for turn in triangles.TURNS if low + 0.02 < turn < high - 0.02), (low + high) / 2):
            b, d = cmath.rect(self.crank, turn), complex(self.frame)
            positions.append((0j, b, triangles.apex(b, d, self.coupler, self.rocker, 1.0), d))
        if self.driver == "rocker":
            return triangles.well_drawn(positions, lambda a, b, c, d: triangles.sine(b - a, c - b))
        return triangles.well_drawn(positions, lambda a, b, c, d: triangles.sine(b - c, d - c))

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
    def drawn(self) -> LinkagePosition:
        bar = self._from_driver()
        return self._lettered([bar._position(bar.places, "")])[0]

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
        return ("change-point", self._family()) if gap == 0 else (self._by_shortest(), "")

    def _by_shortest(self) -> str:
        shortest = min(range(4), key=lambda k: self.lengths[k])
        if shortest in (1, 3):
            return "double-rocker" if shortest == 1 else "double-crank"
        return "crank-rocker" if (shortest == 0) != (self.driver == "rocker") else "rocker-crank"

    def _family(self) -> str:
        def same(one: float, other: float) -> bool:
            return triangles.even(one - other, sum(self.lengths)) == 0

        a, b, c, d = self.lengths
        pa, pb, pc, pd = self.places
        parallel = abs((pb - pa) - (pc - pd)) < 1e-6 * (a + c)
        if same(a, b) and same(b, c) and same(c, d):
            return "rhombus" if parallel else "folded rhombus"
        if same(a, c) and same(b, d):
            return "parallelogram" if parallel else "antiparallelogram"
        kite = (same(a, b) and same(c, d)) or (same(a, d) and same(b, c))
        return "kite" if kite else self._by_shortest()

    def turns(self) -> tuple[Turn, ...]:
        """The four hinges, then the two pairs of opposite links."""
        names, sizes = tuple(self.called.values()), self.lengths
        hinges = [triangles.angles(*(sizes[(k + step) % 4] for step in range(4))) == (0.0, math.pi) for k in range(4)]
        turns = [Turn(names[k], names[(k + 1) % 4], hinges[k]) for k in range(4)]
        parallel = self.kind()[1] in ("parallelogram", "rhombus")
        for k in (0, 1):
            one, other = hinges[k], hinges[k + 1]
            turns.append(Turn(names[k], names[k + 2], one != other or (one and not parallel)))
        return tuple(turns)

    def driver_range(self) -> triangles.MotionRange:
        bar = self._from_driver()
        return bar._range().turned(bar._base)

    def output_range(self) -> triangles.MotionRange:
        bar = self._from_driver()._swapped()
        return bar._range().turned(bar._base)

    def limits(self) -> tuple[LinkagePosition, ...]:
        """The two ends of the output link's swing, the stretched one first; none where it turns fully."""
        bar = self._from_driver()
        other, a, d, ends = bar._swapped(), bar.places[0], bar.places[3], []
        span, crank, coupler = other._range(), bar.crank, bar.coupler
        for angle in () if span.full else (span.low, span.high):  # DC there, AB and BC in line
            c = d + cmath.rect(bar.rocker, other._base + angle)
            stretched = abs(abs(c - a) - crank - coupler) < abs(abs(c - a) - abs(crank - coupler))
            sense = 1.0 if stretched or crank > coupler else -1.0
            b = a + sense * crank * (c - a) / abs(c - a)
            ends.append(bar._position((a, b, c, d), "stretched" if stretched else "folded"))
        return self._lettered(sorted(ends, key=lambda end: end.how != "stretched"))

    def critical(self) -> tuple[LinkagePosition, ...]:
        """The driver in line with the frame, and its own ends."""
        bar = self._from_driver()
        span, side = bar._range(), bar._side
        lines = ((0.0, "inner"), (math.pi, "outer"))
        ends = [bar._at(angle, side, how) for angle, how in lines if span.full or span.low < angle < span.high]
        ends += [] if span.full else [bar._at(angle, 0.0, "end") for angle in (span.low, span.high)]
        return self._lettered(ends)

    def direction(self, position: LinkagePosition) -> float:
        a, b, c, d = position.places
        return cmath.phase(c - d if self.driver == "rocker" else b - a)

    def position_at(self, direction: float) -> LinkagePosition:
        """The position with AB, or a driving DC, at a direction."""
        bar = self._from_driver()
        return self._lettered([bar._at(direction - bar._base, bar._side, "")])[0]

    def driver_at(self, direction: float) -> float:
        bar = self._from_driver()._swapped()
        _, _, b, a = bar._at(direction - bar._base, bar._side, "").places
        return cmath.phase(b - a)

    def ratio(self, direction: float) -> float:
        """Both ends of the coupler have the same speed along it."""
        a, b, c, d = self._from_driver().position_at(direction).places
        along = c - b
        driving, driven = (along.conjugate() * (b - a)).imag, (along.conjugate() * (c - d)).imag
        return driving / driven if driven else math.inf

    def seen(self, position: LinkagePosition) -> TransmissionAngle:
        """Between the coupler and the output link."""
        a, b, c, d = position.places
        return TransmissionAngle(b, b - c, a - b) if self.driver == "rocker" else TransmissionAngle(c, c - b, d - c)

    def _from_driver(self) -> FourBar:
        """The same linkage with the driven link in the place of the crank."""
        return self._swapped() if self.driver == "rocker" else self

    def _swapped(self) -> FourBar:
        """Lettered from the other end: the same places, D for A."""
        return replace(
            self, crank=self.rocker, rocker=self.crank, names=self.names[::-1], places=self.places[::-1],
            driver="crank", scale=self.scale if self.driver == "rocker" else None,
        )  # fmt: skip

    def _lettered(self, ends: Iterable[LinkagePosition]) -> tuple[LinkagePosition, ...]:
        """Places in the order of the linkage's own names."""
        turned = self.driver == "rocker"
        return tuple(replace(end, places=end.places[::-1]) if turned else end for end in ends)

    @property
    def _base(self) -> float:
        """Direction of the frame, A to D."""
        return cmath.phase(self.places[3] - self.places[0])

    @property
    def _side(self) -> float:
        """1 where C lies to the left of B -> D, else -1."""
        _, b, c, d = self.places
        return 1.0 if ((d - b).conjugate() * (c - b)).imag >= 0 else -1.0

    def _range(self) -> triangles.MotionRange:
        """Angles of AB against AD."""
        a, b, _, d = self.places
        least, greatest = triangles.angles(self.crank, self.frame, self.coupler, self.rocker)
        return triangles.spanned(least, greatest, cmath.phase((b - a) / (d - a)))

    def _at(self, angle: float, side: float, how: str) -> LinkagePosition:
        """AB at an angle against AD, C to the left of BD (side 1), to the right (-1), or on it (0)."""
        a, _, c, d = self.places
        b = a + cmath.rect(self.crank, self._base + angle)
        if abs(d - b) < 1e-9 * self.frame:  # AB lies on AD, BC on DC: C may be anywhere about D
            return replace(self._position((a, b, c, d), how), gamma=0.0)
        return self._position((a, b, triangles.apex(b, d, self.coupler, self.rocker, side), d), how)

    def _position(self, places: tuple[complex, ...], how: str) -> LinkagePosition:
        a, b, c, d = places
        turned = triangles.phase(b - a)
        value = turned if self.scale is None else triangles.whole(self.scale(turned))
        gamma = None if self.driver == "coupler" else triangles.folded(b - c, d - c)
        return LinkagePosition(places, 0.0, value, triangles.phase(c - d), gamma, how)

    def mechanism(self, omega: float = 10.0) -> Mechanism:
        (a, b, c, d), (pa, pb, pc, pd) = self.names, self.places
        link, vector, along = {
            "crank": ("1", (a, b), pb - pa), "coupler": ("2", (b, c), pc - pb), "rocker": ("3", (d, c), pc - pd),
        }[self.driver]  # fmt: skip
        links = {FRAME: {a: pa, d: pd}, "1": {a: pa, b: pb}, "2": {b: pb, c: pc}, "3": {d: pd, c: pc}}
        return assembled("4", links, (), (turning(link, vector, along, omega),))
