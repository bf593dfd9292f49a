"""The slider-crank in closed form: what turns, stroke, transmission angle, dead points.

The pressure angle lies between the rod and the guide; gamma is 90 deg less that. It is least not at the limits but
where the crank stands at right angles to the guide on the side away from it. Driven at the slider, gamma is the
angle between rod and crank.
"""

from __future__ import annotations

import cmath
import math
from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.pairs import Slide
from graphkin.studies.linkages import triangles
from graphkin.studies.linkages.assembled import assembled, drawn_line, free_names, pushing, turning
from graphkin.studies.linkages.linkage import DriverScale, LinkagePosition, Sums, TransmissionAngle, Turn


@frozen
class SliderCrank:
    """Crank AB, rod BC, slider C on a fixed guide that passes A at a distance e.

    crank, coupler   AB, BC [m]
    offset   the guide lies so far to the left of A, looking along `way` [m]
    driver   "crank", "coupler" (the rod), "slider"
    names    what A, B, C are called
    places   A, B, C at the drawn position; left out: A at the origin, the guide along +x, C to the right
    way      direction of the guide [rad]
    block    the fixed link is the block and the sliding link carries the guide (a hand pump)
    scale    how the driver is counted; left out: the angle of AB to +x, or C along the guide from the foot of A

    Raises NotALength, CannotDriveBy, OnlyStretched, CannotClose.
    """

    word: ClassVar[str] = "slider"
    drivers: ClassVar[tuple[str, ...]] = ("crank", "coupler", "slider")
    arm: ClassVar[tuple[int, int]] = (0, 1)

    crank: float
    coupler: float
    offset: float = 0.0
    driver: str = "crank"
    names: tuple[str, ...] = ("A", "B", "C")
    places: tuple[complex, ...] = ()
    way: float = 0.0
    block: bool = False
    scale: DriverScale | None = None

    def __post_init__(self) -> None:
        crank, rod, _ = self.called.values()
        triangles.check_parts({crank: self.crank, rod: self.coupler}, self.driver, self.drivers, self.offset)
        triangles.check_closing("e", abs(self.offset), [crank, rod], self.crank + self.coupler)
        object.__setattr__(self, "places", self.places or self._first_places())

    def _first_places(self) -> tuple[complex, ...]:
        """The crank at 60 deg or near, as far as it gets, the slider on the right."""
        r, rod, e = self.crank, self.coupler, self.offset
        low, high = triangles.limited((e - rod) / r), triangles.limited((e + rod) / r)
        positions = []
        turns = [turn for turn in triangles.TURNS if low < math.sin(turn) < high]
        for turn in (*turns, (math.asin(low) + math.asin(high)) / 2):
            b = cmath.rect(r, turn)
            positions.append((0j, b, complex(b.real + math.sqrt(max(0.0, rod * rod - (e - b.imag) ** 2)), e)))
        positions = [places for places in positions if places[2].real > 0] or positions
        if self.driver == "slider":
            return triangles.well_drawn(positions, lambda a, b, c: triangles.sine(b - a, c - b))
        return triangles.well_drawn(positions, lambda a, b, c: triangles.sine(c - b, 1j))

    @property
    def called(self) -> dict[str, str]:
        a, b, c = self.names
        return {"crank": a + b, "coupler": b + c, "slider": c}

    @property
    def sizes(self) -> dict[str, float]:
        crank, rod, _ = self.called.values()
        return {crank: self.crank, rod: self.coupler, "e": self.offset}

    @property
    def output(self) -> str:
        return "crank" if self.driver == "slider" else "slider"

    @property
    def drawn(self) -> LinkagePosition:
        b, c = self._drawn_places()
        return self._position(b, c, "")

    @property
    def stroke(self) -> float | None:
        first, second = self._reach()
        return abs(first - second)

    def sums(self) -> Sums:
        return Sums.beside_offset(self.sizes)

    def kind(self) -> tuple[str, str]:
        """The kind, and its special case."""
        gap = self.sums().gap
        line = "in-line" if triangles.even(self.offset, self.crank + self.coupler + abs(self.offset)) == 0 else "offset"
        if gap == 0:
            return "change-point", "isosceles" if line == "in-line" else "slider-crank"
        if gap > 0:
            return "rocker-slider", "no full turn"
        return ("slider-crank", line) if self.crank < self.coupler else ("rocker-slider", "turning rod")

    def turns(self) -> tuple[Turn, ...]:
        """Three hinges, then crank against slider and rod against the guide's link."""
        crank, rod, block = self.called.values()
        first = triangles.passes(self.crank, self.coupler, self.offset)
        second = triangles.passes(self.coupler, self.crank, self.offset)
        return (
            Turn(crank, FRAME, first), Turn(crank, rod, first or second), Turn(rod, block, second),
            Turn(crank, block, first), Turn(rod, FRAME, second),
        )  # fmt: skip

    def driver_range(self) -> triangles.MotionRange:
        if self.driver == "slider":
            low, high = sorted(self._counted(along) for along in self._reach())
            return triangles.MotionRange(low, high)
        return self._range().turned(self.way)

    def output_range(self) -> triangles.MotionRange:
        if self.driver == "slider":
            return self._range().turned(self.way)
        low, high = sorted(self._reach())
        return triangles.MotionRange(low, high)

    def limits(self) -> tuple[LinkagePosition, ...]:
        """The two ends of the slider's motion, or of the crank's where the slider drives."""
        return self._slider_ends() if self.driver != "slider" else self._crank_ends()

    def critical(self) -> tuple[LinkagePosition, ...]:
        """The crank at right angles to the guide, and its own ends; driven at the slider, its two ends."""
        if self.driver == "slider":
            return self._slider_ends()
        side, away, square = self._side, -1.0 if self.offset > 0 else 1.0, []
        for sense, how in ((away, "far"), (-away, "near")):
            if abs(self.offset - self.crank * sense) <= self.coupler * (1 + triangles.EVEN):
                square.append(self._at(sense * math.pi / 2, side, how))
        return (*square, *self._crank_ends())

    def _crank_ends(self) -> tuple[LinkagePosition, ...]:
        """The ends of the crank's swing; none where it turns fully."""
        span = self._range()
        return () if span.full else tuple(self._at(angle, 0.0, "end") for angle in (span.low, span.high))

    def _slider_ends(self) -> tuple[LinkagePosition, ...]:
        """The ends of the slider's motion: AB and BC in line."""
        ends, far = [], self.crank + self.coupler
        for along in self._reach():
            c = complex(along, self.offset)
            stretched = abs(abs(c) - far) < abs(abs(c) - abs(self.crank - self.coupler))
            sense = 1.0 if stretched or self.crank > self.coupler else -1.0
            b = sense * self.crank * c / abs(c) if abs(c) > triangles.EVEN * far else self.crank * 1j
            ends.append(self._position(b, c, "stretched" if stretched else "folded"))
        return tuple(ends)

    def direction(self, position: LinkagePosition) -> float:
        return cmath.phase(position.places[1] - position.places[0])

    def position_at(self, direction: float) -> LinkagePosition:
        """The position with the crank at a direction."""
        return self._at(direction - self.way, self._side, "")

    def driver_at(self, direction: float) -> float:
        return math.nan

    def ratio(self, direction: float) -> float:
        """The slider's velocity along the guide over the crank's [m/rad]."""
        a, b, c = self.position_at(direction).places
        rod = c - b
        driving = (rod.conjugate() * (1j * (b - a))).real
        driven = (rod.conjugate() * cmath.rect(1, self.way)).real
        return driving / driven if driven else math.inf

    def seen(self, position: LinkagePosition) -> TransmissionAngle:
        """Between rod and crank where the slider drives, else as pressure angle between rod and guide."""
        a, b, c = position.places
        if self.driver == "slider":
            return TransmissionAngle(b, b - a, c - b)
        along = cmath.rect(1, self.way)
        toward = along if (along.conjugate() * (b - c)).real > 0 else -along
        return TransmissionAngle(c, toward, b - c, self.driver == "crank")

    def _drawn_places(self) -> tuple[complex, complex]:
        """Drawn B and C in axes with A as origin and x along the guide."""
        a, b, c = self.places
        turn = cmath.rect(1, -self.way)
        return (b - a) * turn, (c - a) * turn

    @property
    def _side(self) -> float:
        """1 where the slider lies ahead of B on the guide, -1 behind it."""
        b, c = self._drawn_places()
        return 1.0 if c.real >= b.real else -1.0

    def _range(self) -> triangles.MotionRange:
        """Angles of AB against the guide: B may be no farther than BC from it."""
        r, rod, e = self.crank, self.coupler, self.offset
        size = r + rod + abs(e)
        over, under = triangles.even(e + rod - r, size) < 0, triangles.even(rod - e - r, size) < 0
        high, low = math.asin(triangles.limited((e + rod) / r)), math.asin(triangles.limited((e - rod) / r))
        if over and under:
            left = self._drawn_places()[0].real < 0
            return triangles.MotionRange(math.pi - high, math.pi - low) if left else triangles.MotionRange(low, high)
        if over:
            return triangles.MotionRange(math.pi - high, math.tau + high)
        if under:
            return triangles.MotionRange(low, math.pi - low)
        return triangles.MotionRange(0.0, math.tau, True)

    def _reach(self) -> tuple[float, float]:
        """The ends of the slider's motion along the guide, from the foot of A: its stretched end first."""
        e, far_arm, near_arm = self.offset, self.crank + self.coupler, abs(self.crank - self.coupler)
        far = math.sqrt((far_arm - e) * (far_arm + e))
        if triangles.even(near_arm - abs(e), far_arm) <= 0:
            return far, -far
        side = 1.0 if self._drawn_places()[1].real >= 0 else -1.0
        return side * far, side * math.sqrt((near_arm - e) * (near_arm + e))

    def _at(self, angle: float, side: float, how: str) -> LinkagePosition:
        """The crank at an angle against the guide, the slider ahead of B (side 1), behind it (-1), or level (0)."""
        b = cmath.rect(self.crank, angle)
        high = abs(self.offset - b.imag)
        gap = triangles.even(self.coupler - high, self.coupler)
        along = side * math.sqrt(max(0.0, gap * (self.coupler + high)))
        return self._position(b, complex(b.real + along, self.offset), how)

    def _position(self, b: complex, c: complex, how: str) -> LinkagePosition:
        """From the axes of the guide to the drawing's."""
        turn, a = cmath.rect(1, self.way), self.places[0]
        places, angle = (a, a + b * turn, a + c * turn), triangles.phase(b * turn)
        if self.driver == "slider":
            return LinkagePosition(places, self.way, self._counted(c.real), angle, triangles.folded(b, c - b), how)
        gamma = None if self.driver == "coupler" else triangles.folded(c - b, 1j)
        value = angle if self.scale is None else triangles.whole(self.scale(angle))
        return LinkagePosition(places, self.way, value, c.real, gamma, how)

    def _counted(self, along: float) -> float:
        """The slider's place as a driver counts it."""
        return along if self.scale is None else self.scale(along)

    def mechanism(self, omega: float = 10.0) -> Mechanism:
        """The slider on a guide of the frame; or a bar through a block that stands on the frame, at the foot of A."""
        (a, b, c), (pa, pb, pc) = self.names, self.places
        along = cmath.rect(1, self.way)
        foot = pa + 1j * along * self.offset
        cranks = {"1": {a: pa, b: pb}, "2": {b: pb, c: pc}}
        own = ((pc - foot) * along.conjugate()).real
        if not self.block:
            links = {FRAME: {a: pa, "s0": foot}, **cranks, "3": {c: pc}}
            slide = Slide("s", True, drawn_line(links, FRAME, "s0", along, named=False), c, "3", 0.0)
            return assembled("4", links, (slide,), (self._mechanism_driver(own, omega),))
        p, q = free_names(self.names, 2)
        ahead = along if own <= 0 else -along
        tip = pc + ahead * (abs(own) + 0.4 * (self.crank + self.coupler))
        fixed = {a: pa} if self.offset == 0 else {a: pa, p: foot}
        links = {FRAME: fixed, **cranks, "3": {c: pc, q: tip}}
        slide = Slide("s", True, drawn_line(links, "3", c, ahead), list(fixed)[-1], FRAME, -cmath.phase(ahead))
        return assembled("4", links, (slide,), (self._mechanism_driver(abs(own), omega),))

    def _mechanism_driver(self, at: float, omega: float) -> Driver:
        """at: the displacement of the mechanism's slide [m]."""
        (a, b, c), (pa, pb, pc) = self.names, self.places
        if self.driver == "slider":
            return pushing(at)
        if self.driver == "coupler":
            return turning("2", (b, c), pc - pb, omega)
        return turning("1", (a, b), pb - pa, omega)
