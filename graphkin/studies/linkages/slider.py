"""The slider-crank in closed form: what turns, stroke, transmission angle, dead points.

The pressure angle lies between the rod and the guide; gamma is 90 deg less that. It is least not at the limits but
where the crank stands at right angles to the guide on the side away from it. Driven at the slider, gamma is the
angle between rod and crank.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.pairs import Slide
from graphkin.studies.linkages.assembled import Places, assembled, drawn_line, free_names, pushing, turning
from graphkin.studies.linkages.equal import EVEN, even
from graphkin.studies.linkages.first_position import TURNS, sine, well_drawn
from graphkin.studies.linkages.lengths import check_closing, check_driver, check_links, check_offset
from graphkin.studies.linkages.linkage import DriverScale, LinkagePosition, MotionRange, Sums, TransmissionAngle, Turn
from graphkin.studies.linkages.triangles import folded, limited, passes, phase, whole


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
    scale    how the driver is counted; left out: the angle of AB to +x, or C's way along the guide from the foot of A

    Raises NotALength, CannotDriveBy, OnlyStretched, CannotClose.
    """

    word: ClassVar[str] = "slider"
    drivers: ClassVar[tuple[str, ...]] = ("crank", "coupler", "slider")

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
        check_links({crank: self.crank, rod: self.coupler})
        check_offset(self.offset)
        check_driver(self.driver, self.drivers)
        check_closing("e", abs(self.offset), [crank, rod], self.crank + self.coupler)
        object.__setattr__(self, "places", self.places or _start(self))

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
        _, b, c = _own(self)
        return _position(self, b, c, "")

    @property
    def stroke(self) -> float | None:
        first, second = _reach(self)
        return abs(first - second)

    @property
    def arm(self) -> tuple[int, int]:
        return 0, 1

    def sums(self) -> Sums:
        return Sums.beside_offset(self.sizes)

    def kind(self) -> tuple[str, str]:
        """The kind, and what is special about it."""
        gap = self.sums().gap
        line = "in-line" if even(self.offset, self.crank + self.coupler + abs(self.offset)) == 0 else "offset"
        if gap == 0:
            return "change-point", "isosceles" if line == "in-line" else "slider-crank"
        if gap > 0:
            return "rocker-slider", "no full turn"
        return ("slider-crank", line) if self.crank < self.coupler else ("rocker-slider", "turning rod")

    def turns(self) -> tuple[Turn, ...]:
        """Three hinges, then crank against slider and rod against the guide's link."""
        crank, rod, block = self.called.values()
        first, second = passes(self.crank, self.coupler, self.offset), passes(self.coupler, self.crank, self.offset)
        return (
            Turn(crank, FRAME, first, True), Turn(crank, rod, first or second, True), Turn(rod, block, second, True),
            Turn(crank, block, first, False), Turn(rod, FRAME, second, False),
        )  # fmt: skip

    def driver_range(self) -> MotionRange:
        if self.driver == "slider":
            ends = sorted(_slid(self, along) for along in _reach(self))
            return MotionRange(ends[0], ends[1])
        return _range(self).turned(self.way)

    def output_range(self) -> MotionRange:
        if self.driver == "slider":
            return _range(self).turned(self.way)
        ends = sorted(_reach(self))
        return MotionRange(ends[0], ends[1])

    def limits(self) -> tuple[LinkagePosition, ...]:
        """The two ends of the slider's way, or of the crank's where the slider drives."""
        if self.driver != "slider":
            return tuple(_limit(self, along) for along in _reach(self))
        found = _range(self)
        return () if found.full else tuple(_at(self, angle, 0.0, "end") for angle in (found.low, found.high))

    def critical(self) -> tuple[LinkagePosition, ...]:
        """The crank at right angles to the guide, and its own ends; driven at the slider, its two ends."""
        if self.driver == "slider":
            return tuple(_limit(self, along) for along in _reach(self))
        return tuple(_critical(self))

    def direction(self, position: LinkagePosition) -> float:
        return cmath.phase(position.places[1] - position.places[0])

    def position_at(self, direction: float) -> LinkagePosition:
        """Of the crank."""
        _, b, c = _own(self)
        return _at(self, direction - self.way, 1.0 if c.real >= b.real else -1.0, "")

    def driver_at(self, direction: float) -> float:
        return math.nan

    def ratio(self, direction: float) -> float:
        """Of the slider along the guide [m/rad]."""
        a, b, c = self.position_at(direction).places
        rod = c - b
        given = (rod.conjugate() * (1j * (b - a))).real
        taken = (rod.conjugate() * cmath.rect(1, self.way)).real
        return given / taken if taken else math.inf

    def seen(self, position: LinkagePosition) -> TransmissionAngle:
        """Between rod and crank where the slider drives, else as pressure angle between rod and guide."""
        a, b, c = position.places
        if self.driver == "slider":
            return TransmissionAngle(b, b - a, c - b)
        along = cmath.rect(1, self.way)
        toward = along if (along.conjugate() * (b - c)).real > 0 else -along
        return TransmissionAngle(c, toward, b - c, self.driver == "crank")

    def mechanism(self, omega: float = 10.0) -> Mechanism:
        """The slider on a guide of the frame; or a bar through a block that stands on the frame, at the foot of A."""
        return _fixed_block(self, omega) if self.block else _fixed_guide(self, omega)


# --- ranges and positions ------------------------------------------------------------------------


def _start(slider: SliderCrank) -> tuple[complex, ...]:
    """The crank at 60 deg or near, as far as it gets, the slider on the right."""
    r, rod, e = slider.crank, slider.coupler, slider.offset
    low, high = limited((e - rod) / r), limited((e + rod) / r)
    drawn = []
    for turn in (*(turn for turn in TURNS if low < math.sin(turn) < high), (math.asin(low) + math.asin(high)) / 2):
        b = cmath.rect(r, turn)
        drawn.append((0j, b, complex(b.real + math.sqrt(max(0.0, rod * rod - (e - b.imag) ** 2)), e)))
    drawn = [places for places in drawn if places[2].real > 0] or drawn
    if slider.driver == "slider":
        return well_drawn(drawn, lambda a, b, c: sine(b - a, c - b))
    return well_drawn(drawn, lambda a, b, c: sine(c - b, 1j))


def _own(slider: SliderCrank) -> tuple[complex, ...]:
    """Drawn places in axes with A as origin and x along the guide."""
    return tuple((place - slider.places[0]) * cmath.rect(1, -slider.way) for place in slider.places)


def _range(slider: SliderCrank) -> MotionRange:
    """Angles of AB against the guide: B may be no farther than BC from it."""
    r, rod, e = slider.crank, slider.coupler, slider.offset
    size = r + rod + abs(e)
    over, under = even(e + rod - r, size) < 0, even(rod - e - r, size) < 0
    high, low = math.asin(limited((e + rod) / r)), math.asin(limited((e - rod) / r))
    if over and under:
        left = _own(slider)[1].real < 0
        return MotionRange(math.pi - high, math.pi - low) if left else MotionRange(low, high)
    if over:
        return MotionRange(math.pi - high, math.tau + high)
    if under:
        return MotionRange(low, math.pi - low)
    return MotionRange(0.0, math.tau, True)


def _reach(slider: SliderCrank) -> tuple[float, float]:
    """How far along the guide, from the foot of A, the slider goes: its stretched end first."""
    e, sum_, gap = slider.offset, slider.crank + slider.coupler, abs(slider.crank - slider.coupler)
    far = math.sqrt((sum_ - e) * (sum_ + e))
    if even(gap - abs(e), sum_) <= 0:
        return far, -far
    side = 1.0 if _own(slider)[2].real >= 0 else -1.0
    return side * far, side * math.sqrt((gap - e) * (gap + e))


def _limit(slider: SliderCrank, along: float) -> LinkagePosition:
    """The slider at an end: AB and BC in line."""
    c = complex(along, slider.offset)
    far = slider.crank + slider.coupler
    stretched = abs(abs(c) - far) < abs(abs(c) - abs(slider.crank - slider.coupler))
    sense = 1.0 if stretched or slider.crank > slider.coupler else -1.0
    b = sense * slider.crank * c / abs(c) if abs(c) > EVEN * far else slider.crank * 1j
    return _position(slider, b, c, "stretched" if stretched else "folded")


def _position(slider: SliderCrank, b: complex, c: complex, how: str) -> LinkagePosition:
    """From the axes of the guide to the drawing's."""
    turn = cmath.rect(1, slider.way)
    a = slider.places[0]
    places = (a, a + b * turn, a + c * turn)
    angle = phase(b * turn)
    if slider.driver == "slider":
        return LinkagePosition(places, slider.way, _slid(slider, c.real), angle, folded(b, c - b), how)
    gamma = None if slider.driver == "coupler" else folded(c - b, 1j)
    value = angle if slider.scale is None else whole(slider.scale(angle))
    return LinkagePosition(places, slider.way, value, c.real, gamma, how)


def _slid(slider: SliderCrank, along: float) -> float:
    """The slider's place as a driver counts it."""
    return along if slider.scale is None else slider.scale(along)


def _critical(slider: SliderCrank) -> Iterator[LinkagePosition]:
    found = _range(slider)
    _, b, c = _own(slider)
    side = 1.0 if c.real >= b.real else -1.0
    away = -1.0 if slider.offset > 0 else 1.0
    for sense, how in ((away, "far"), (-away, "near")):
        if abs(slider.offset - slider.crank * sense) <= slider.coupler * (1 + EVEN):
            yield _at(slider, sense * math.pi / 2, side, how)
    if not found.full:
        for angle in (found.low, found.high):
            yield _at(slider, angle, 0.0, "end")


def _at(slider: SliderCrank, angle: float, side: float, how: str) -> LinkagePosition:
    """The crank at an angle against the guide, the slider ahead of B (side 1), behind it (-1), or level with it (0)."""
    b = cmath.rect(slider.crank, angle)
    high = abs(slider.offset - b.imag)
    gap = even(slider.coupler - high, slider.coupler)
    along = side * math.sqrt(max(0.0, gap * (slider.coupler + high)))
    return _position(slider, b, complex(b.real + along, slider.offset), how)


# --- as a mechanism ------------------------------------------------------------------------------


def _fixed_guide(slider: SliderCrank, omega: float) -> Mechanism:
    (a, _, c), (pa, _, pc) = slider.names, slider.places
    along, foot = _guide(slider)
    links = {FRAME: {a: pa, "s0": foot}, **_cranks(slider), "3": {c: pc}}
    slide = Slide("s", True, drawn_line(links, FRAME, "s0", along, named=False), c, "3", 0.0)
    return assembled("4", links, (slide,), (_driver(slider, ((pc - foot) * along.conjugate()).real, omega),))


def _fixed_block(slider: SliderCrank, omega: float) -> Mechanism:
    (a, _, c), (pa, _, pc) = slider.names, slider.places
    along, foot = _guide(slider)
    p, q = free_names(slider.names, 2)
    own = ((foot - pc) * along.conjugate()).real
    ahead = along if own >= 0 else -along
    tip = pc + ahead * (abs(own) + 0.4 * (slider.crank + slider.coupler))
    fixed = {a: pa} if slider.offset == 0 else {a: pa, p: foot}
    links = {FRAME: fixed, **_cranks(slider), "3": {c: pc, q: tip}}
    slide = Slide("s", True, drawn_line(links, "3", c, ahead), list(fixed)[-1], FRAME, -cmath.phase(ahead))
    return assembled("4", links, (slide,), (_driver(slider, abs(own), omega),))


def _guide(slider: SliderCrank) -> tuple[complex, complex]:
    """Its direction, and its foot under A."""
    along = cmath.rect(1, slider.way)
    return along, slider.places[0] + 1j * along * slider.offset


def _cranks(slider: SliderCrank) -> dict[str, Places]:
    """Crank and rod."""
    (a, b, c), (pa, pb, pc) = slider.names, slider.places
    return {"1": {a: pa, b: pb}, "2": {b: pb, c: pc}}


def _driver(slider: SliderCrank, at: float, omega: float) -> Driver:
    """at: the displacement of the mechanism's slide [m]."""
    (a, b, c), (pa, pb, pc) = slider.names, slider.places
    if slider.driver == "slider":
        return pushing(at)
    return turning("2", (b, c), pc - pb, omega) if slider.driver == "coupler" else turning("1", (a, b), pb - pa, omega)
