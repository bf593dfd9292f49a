"""Guide bars in closed form: rotating and oscillating guide bar, oscillating block, oscillating cylinder.

The bar's line stays at a distance e from C and passes B. At the ends of its swing it touches the crank's circle:
the crank stands at right angles to it. Between block and bar the force is normal to the bar's line, and the bar's
point there moves at right angles to CB: with e = 0 the crank drives it at gamma = 90 deg throughout.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Slide
from graphkin.studies.linkages.assembled import assembled, drawn_line, free_names, pushing, turning
from graphkin.studies.linkages.equal import EVEN, even
from graphkin.studies.linkages.first_position import TURNS, sine, well_drawn
from graphkin.studies.linkages.lengths import check_closing, check_driver, check_links, check_offset
from graphkin.studies.linkages.linkage import DriverScale, LinkagePosition, MotionRange, Sums, Turn
from graphkin.studies.linkages.triangles import folded, limited, passes, phase, spanned, whole


@frozen
class GuideBar:
    """Crank AB, frame AC, a bar hinged at C on whose line a block hinged at B slides.

    A crank of length r, a rod l and an offset e are one chain: fix its crank or its rod, and it is a guide bar.

    crank, frame   AB, AC [m]
    offset   B's line lies so far to the left of C, looking along the bar [m]
    driver   "crank", "bar", "slide" (the block along the bar: a cylinder)
    names    what A, B, C are called
    places   A, B, C at the drawn position; left out: A at the origin, C on +x, B ahead of C on the bar
    turn     direction of the bar at the drawn position [rad]
    block    the frame carries the block at C and the bar slides through it (an oscillating block)
    scale    how the driver is counted; left out: the angle of AB, or of the bar, to +x; B's way along the bar from C

    Raises NotALength, CannotDriveBy, OnlyStretched, CannotClose.
    """

    word: ClassVar[str] = "guide"
    drivers: ClassVar[tuple[str, ...]] = ("crank", "bar", "slide")

    crank: float
    frame: float
    offset: float = 0.0
    driver: str = "crank"
    names: tuple[str, ...] = ("A", "B", "C")
    places: tuple[complex, ...] = ()
    turn: float = 0.0
    block: bool = False
    scale: DriverScale | None = None

    def __post_init__(self) -> None:
        crank, frame = _crank_and_frame(self)
        check_links({crank: self.crank, frame: self.frame})
        check_offset(self.offset)
        check_driver(self.driver, self.drivers)
        check_closing("e", abs(self.offset), [crank, frame], self.crank + self.frame)
        if not self.places:
            places, turn = _start(self)
            object.__setattr__(self, "places", places)
            object.__setattr__(self, "turn", turn)

    @property
    def called(self) -> dict[str, str]:
        a, b, c = self.names
        slide = self.scale.name if self.driver == "slide" and self.scale is not None else "s"
        return {"crank": a + b, "bar": c + b, "frame": a + c, "slide": slide}

    @property
    def sizes(self) -> dict[str, float]:
        crank, frame = _crank_and_frame(self)
        return {crank: self.crank, frame: self.frame, "e": self.offset}

    @property
    def output(self) -> str:
        return "bar" if self.driver == "crank" else "crank"

    @property
    def drawn(self) -> LinkagePosition:
        b, c = ((place - self.places[0]) * cmath.rect(1, -_base(self)) for place in self.places[1:])
        return _position(self, b, c, cmath.rect(1, self.turn - _base(self)), "")

    @property
    def stroke(self) -> float | None:
        return None

    @property
    def arm(self) -> tuple[int, int]:
        return (2, 1) if self.output == "bar" else (0, 1)

    def sums(self) -> Sums:
        return Sums.beside_offset(self.sizes)

    def kind(self) -> tuple[str, str]:
        """The kind, and whether bar or block stands on the frame."""
        gap = self.sums().gap
        pivoted = "block" if self.block else "bar"
        if gap == 0:
            return "change-point", pivoted
        if gap > 0:
            return "rocking guide bar", pivoted
        return ("rotating guide bar" if self.crank > self.frame else "oscillating guide bar"), pivoted

    def turns(self) -> tuple[Turn, ...]:
        """Three hinges (the block turns with the bar), then crank against bar, frame against block."""
        crank, bar, frame, _ = self.called.values()
        short, other = passes(self.crank, self.frame, self.offset), passes(self.frame, self.crank, self.offset)
        return (
            Turn(crank, frame, short or other, True), Turn(bar, frame, other, True), Turn(crank, bar, short, True),
        )  # fmt: skip

    def driver_range(self) -> MotionRange:
        if self.driver == "slide":
            low, high = sorted(along if self.scale is None else self.scale(along) for along in _slid_range(self))
            return MotionRange(low, high)
        return _turned(self, self.driver)

    def output_range(self) -> MotionRange:
        return _turned(self, self.output)

    def limits(self) -> tuple[LinkagePosition, ...]:
        """The ends of the output's swing: of the bar where the crank drives it, else of the crank."""
        if self.output == "bar":
            found = _normal_range(self)
            return () if found.full else tuple(_tangent(self, angle, "across") for angle in (found.low, found.high))
        found = _crank_range(self)
        return () if found.full else tuple(_at(self, angle, "end") for angle in (found.low, found.high))

    def critical(self) -> tuple[LinkagePosition, ...]:
        return tuple(_by_bar(self) if self.driver == "bar" else _by_crank(self))

    def direction(self, position: LinkagePosition) -> float:
        return position.turn if self.driver == "bar" else cmath.phase(position.places[1] - position.places[0])

    def position_at(self, direction: float) -> LinkagePosition:
        """Of the bar where it drives, else of the crank."""
        if self.driver == "bar":
            return _tangent(self, direction + math.pi / 2 - _base(self), "")
        return _at(self, direction - _base(self), "")

    def driver_at(self, direction: float) -> float:
        a, b, _ = _tangent(self, direction + math.pi / 2 - _base(self), "").places
        return cmath.phase(b - a)

    def ratio(self, direction: float) -> float:
        """The bar's over the crank's; the bar's direction follows from where B is ahead of C."""
        a, b, c = self.position_at(direction).places
        arm = b - c
        along = math.sqrt(max(0.0, abs(arm) ** 2 - self.offset**2))
        if along == 0:
            return math.inf
        line = arm / complex(_ahead(self) * along, self.offset)
        normal = 1j * line / abs(line)
        return (normal.conjugate() * 1j * (b - a)).real / ((normal.conjugate() * 1j * arm).real)

    def seen(self, position: LinkagePosition) -> None:
        return None

    def mechanism(self, omega: float = 10.0) -> Mechanism:
        """The bar is hinged at C, or at B where it slides through a block at C; its line ends in a point."""
        (a, b, c), (pa, pb, pc) = self.names, self.places
        bar, block = ("2", "3") if self.block else ("3", "2")
        (hinge, start), (other, there) = ((b, pb), (c, pc)) if self.block else ((c, pc), (b, pb))
        along = cmath.rect(1, self.turn)
        foot = start + (-1j if self.block else 1j) * along * self.offset
        ahead = 1.0 if ((there - foot) * along.conjugate()).real >= 0 else -1.0
        p, q = free_names(self.names, 2)
        tip = foot + ahead * along * 1.15 * (self.crank + self.frame)
        points = {hinge: start} | ({} if self.offset == 0 else {p: foot}) | {q: tip}
        origin = hinge if self.offset == 0 else p
        links = {FRAME: {a: pa, c: pc}, "1": {a: pa, b: pb}, "2": {}, "3": {}} | {bar: points, block: {other: there}}
        slide = Slide("s", True, drawn_line(links, bar, origin, ahead * along), other, block, 0.0)
        driver = {
            "crank": turning("1", (a, b), pb - pa, omega), "bar": turning(bar, (origin, q), ahead * along, omega),
            "slide": pushing(((there - foot) * ahead * along.conjugate()).real),
        }[self.driver]  # fmt: skip
        return assembled("4", links, (slide,), (driver,))


def _crank_and_frame(bar: GuideBar) -> tuple[str, str]:
    """What they are called."""
    return bar.called["crank"], bar.called["frame"]


# --- ranges and positions ------------------------------------------------------------------------


def _start(bar: GuideBar) -> tuple[tuple[complex, ...], float]:
    """The crank at 60 deg or near, farther out where B would come too near to C."""
    r, d, e = bar.crank, bar.frame, bar.offset
    low = math.acos(limited((r * r + d * d - e * e) / (2 * r * d))) if abs(d - r) < abs(e) else 0.0
    turns = (*(turn for turn in TURNS if turn > low + 0.02), (low + math.pi) / 2)
    drawn = [(0j, cmath.rect(r, turn), complex(d)) for turn in turns]

    def line(b: complex, c: complex) -> complex:
        return (b - c) / complex(math.sqrt(max(0.0, abs(b - c) ** 2 - e * e)), e)

    sines: dict[str, Callable[..., float]] = {
        "crank": lambda a, b, c: sine(b - c, 1j * line(b, c)), "bar": lambda a, b, c: sine(b - a, 1j * line(b, c)),
        "slide": lambda a, b, c: sine(b - a, b - c),
    }  # fmt: skip
    places = well_drawn(drawn, sines[bar.driver])
    return places, cmath.phase(line(places[1], places[2]))


def _base(bar: GuideBar) -> float:
    """Direction of the frame, A to C."""
    return cmath.phase(bar.places[2] - bar.places[0])


def _ahead(bar: GuideBar) -> float:
    """1 where B is ahead of C on the bar, else -1."""
    _, b, c = bar.places
    return 1.0 if ((b - c) * cmath.rect(1, -bar.turn)).real >= 0 else -1.0


def _crank_range(bar: GuideBar) -> MotionRange:
    """Angles of AB against AC: B may not come nearer to C than the offset."""
    r, d, e = bar.crank, bar.frame, abs(bar.offset)
    if even(abs(d - r) - e, d + r) >= 0:
        return MotionRange(0.0, math.tau, True)
    least = math.acos(limited((r * r + d * d - e * e) / (2 * r * d)))
    return MotionRange(least, math.tau - least)


def _normal_range(bar: GuideBar) -> MotionRange:
    """Angles of the bar's left normal against AC: the bar's line may not pass A at more than the crank's length."""
    r, d, e = bar.crank, bar.frame, bar.offset
    over, under = even(r - e - d, r + d) < 0, even(r + e - d, r + d) < 0
    least = math.acos(limited((r - e) / d)) if over else 0.0
    greatest = math.acos(limited((-r - e) / d)) if under else math.pi
    return spanned(least, greatest, bar.turn + math.pi / 2 - _base(bar))


def _slid_range(bar: GuideBar) -> tuple[float, float]:
    """B's way along the bar from the foot of C: farthest end first."""
    r, d, e = bar.crank, bar.frame, abs(bar.offset)
    far, near = math.sqrt((d + r - e) * (d + r + e)), abs(d - r)
    if even(near - e, d + r) <= 0:
        return far, -far
    return _ahead(bar) * far, _ahead(bar) * math.sqrt((near - e) * (near + e))


def _turned(bar: GuideBar, link: str) -> MotionRange:
    """What crank or bar goes through: their directions on the drawing."""
    base = _base(bar)
    return _crank_range(bar).turned(base) if link == "crank" else _normal_range(bar).turned(base - math.pi / 2)


def _tangent(bar: GuideBar, normal: float, how: str) -> LinkagePosition:
    """The bar's left normal at an angle against AC, and B on the bar where the crank reaches it, on the side drawn."""
    d = complex(bar.frame)
    n = cmath.rect(1, normal)
    high = bar.offset + bar.frame * n.real
    gap = even(bar.crank - abs(high), bar.crank)
    along = _ahead(bar) * math.sqrt(max(0.0, gap * (bar.crank + abs(high))))
    return _position(bar, n * complex(high, -along), d, -1j * n, how)


def _at(bar: GuideBar, angle: float, how: str) -> LinkagePosition:
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


def _position(bar: GuideBar, b: complex, c: complex, along: complex, how: str) -> LinkagePosition:
    """From the axes of the frame to the drawing's."""
    turn, a = cmath.rect(1, _base(bar)), bar.places[0]
    crank, direction = phase(b * turn), phase(along * turn)
    slid = ((b - c) * along.conjugate()).real
    value = {"crank": crank, "bar": direction, "slide": slid}[bar.driver]
    if bar.scale is not None:
        value = bar.scale(value) if bar.driver == "slide" else whole(bar.scale(value))
    output = direction if bar.output == "bar" else crank
    return LinkagePosition((a, a + b * turn, a + c * turn), direction, value, output, _gamma(bar, b, c, along), how)


def _gamma(bar: GuideBar, b: complex, c: complex, along: complex) -> float:
    """Angle between what pushes and the arm it pushes at; 90 deg - it lies between force and velocity.

    0 with B on C: a crank as long as the frame cannot turn the bar there.
    """
    if bar.driver == "crank":
        arm = complex(((b - c) * along.conjugate()).real, bar.offset)
        return folded(1j, arm) if abs(arm) > EVEN * bar.frame else 0.0
    if bar.driver == "bar":
        return folded(1j * along, b)
    return folded(b - c, b)


def _by_crank(bar: GuideBar) -> Iterator[LinkagePosition]:
    """The crank in line with the frame, and its own ends (for a cylinder those are no dead points)."""
    found = _crank_range(bar)
    for angle, how in ((0.0, "inner"), (math.pi, "outer")):
        if found.full or found.low < angle < found.high:
            yield _at(bar, angle, how)
    if not found.full and bar.driver == "crank":
        for angle in (found.low, found.high):
            yield _at(bar, angle, "end")


def _by_bar(bar: GuideBar) -> Iterator[LinkagePosition]:
    """The bar at right angles to the frame, and its own ends."""
    found = _normal_range(bar)
    angles = ((0.0, "square"), (math.pi, "square")) if found.full else ((found.low, "across"), (found.high, "across"))
    for angle, how in angles:
        yield _tangent(bar, angle, how)
