"""Guide bars in closed form: rotating and oscillating guide bar, oscillating block, oscillating cylinder.

The bar's line stays at a distance e from C and passes B. At the ends of its swing it touches the crank's circle:
the crank stands at right angles to it. Between block and bar the force is normal to the bar's line, and the bar's
point there moves at right angles to CB: with e = 0 the crank drives it at gamma = 90 deg throughout.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Slide
from graphkin.studies.linkages import triangles
from graphkin.studies.linkages.assembled import assembled, drawn_line, free_names, pushing, turning
from graphkin.studies.linkages.linkage import DriverScale, LinkagePosition, Sums, TransmissionAngle, Turn


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
    scale    how the driver is counted; left out: the angle of AB, or of the bar, to +x; B along the bar from C

    Raises NotALength, CannotDriveBy, OnlyStretched, CannotClose.
    """

    word: ClassVar[str] = "guide"
    drivers: ClassVar[tuple[str, ...]] = ("crank", "bar", "slide")
    stroke: ClassVar[float | None] = None

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
        crank, frame, _ = self.sizes
        triangles.check_parts({crank: self.crank, frame: self.frame}, self.driver, self.drivers, self.offset)
        triangles.check_closing("e", abs(self.offset), [crank, frame], self.crank + self.frame)
        if not self.places:
            places, turn = self._first_places()
            object.__setattr__(self, "places", places)
            object.__setattr__(self, "turn", turn)

    def _first_places(self) -> tuple[tuple[complex, ...], float]:
        """The crank at 60 deg or near, farther out where B would come too near to C; and the bar's direction."""
        r, d, e = self.crank, self.frame, self.offset
        low = self._nearest if abs(d - r) < abs(e) else 0.0
        turns = (*(turn for turn in triangles.TURNS if turn > low + 0.02), (low + math.pi) / 2)
        positions = [(0j, cmath.rect(r, turn), complex(d)) for turn in turns]

        def line(b: complex, c: complex) -> complex:
            return (b - c) / complex(math.sqrt(max(0.0, abs(b - c) ** 2 - e * e)), e)

        sines: dict[str, Callable[..., float]] = {
            "crank": lambda a, b, c: triangles.sine(b - c, 1j * line(b, c)),
            "bar": lambda a, b, c: triangles.sine(b - a, 1j * line(b, c)),
            "slide": lambda a, b, c: triangles.sine(b - a, b - c),
        }
        places = triangles.well_drawn(positions, sines[self.driver])
        return places, cmath.phase(line(places[1], places[2]))

    @property
    def called(self) -> dict[str, str]:
        a, b, c = self.names
        slide = self.scale.name if self.driver == "slide" and self.scale is not None else "s"
        return {"crank": a + b, "bar": c + b, "frame": a + c, "slide": slide}

    @property
    def sizes(self) -> dict[str, float]:
        names = self.called
        return {names["crank"]: self.crank, names["frame"]: self.frame, "e": self.offset}

    @property
    def output(self) -> str:
        return "bar" if self.driver == "crank" else "crank"

    @property
    def drawn(self) -> LinkagePosition:
        b, c = ((place - self.places[0]) * cmath.rect(1, -self._base) for place in self.places[1:])
        return self._position(b, c, cmath.rect(1, self.turn - self._base), "")

    @property
    def arm(self) -> tuple[int, int]:
        return (2, 1) if self.output == "bar" else (0, 1)

    def sums(self) -> Sums:
        return Sums.beside_offset(self.sizes)

    def kind(self) -> tuple[str, str]:
        """The kind, and the part that stands on the frame: bar or block."""
        gap, pivoted = self.sums().gap, "block" if self.block else "bar"
        if gap == 0:
            return "change-point", pivoted
        if gap > 0:
            return "rocking guide bar", pivoted
        return ("rotating guide bar" if self.crank > self.frame else "oscillating guide bar"), pivoted

    def turns(self) -> tuple[Turn, ...]:
        """Three hinges (the block turns with the bar), then crank against bar, frame against block."""
        crank, bar, frame, _ = self.called.values()
        short = triangles.passes(self.crank, self.frame, self.offset)
        other = triangles.passes(self.frame, self.crank, self.offset)
        return Turn(crank, frame, short or other), Turn(bar, frame, other), Turn(crank, bar, short)

    def driver_range(self) -> triangles.MotionRange:
        if self.driver == "slide":
            r, d, e = self.crank, self.frame, abs(self.offset)
            far, near = math.sqrt((d + r - e) * (d + r + e)), abs(d - r)  # of B along the bar from the foot of C
            last = -far if triangles.even(near - e, d + r) <= 0 else math.sqrt((near - e) * (near + e))
            ends = self._ahead * far, self._ahead * last
            low, high = sorted(along if self.scale is None else self.scale(along) for along in ends)
            return triangles.MotionRange(low, high)
        return self._directions(self.driver)

    def output_range(self) -> triangles.MotionRange:
        return self._directions(self.output)

    def _directions(self, link: str) -> triangles.MotionRange:
        """The directions of crank or bar on the drawing."""
        if link == "crank":
            return self._crank_range().turned(self._base)
        return self._normal_range().turned(self._base - math.pi / 2)

    def limits(self) -> tuple[LinkagePosition, ...]:
        """The ends of the output's swing: of the bar where the crank drives it, else of the crank."""
        if self.output == "bar":
            span = self._normal_range()
            return () if span.full else tuple(self._tangent(angle, "across") for angle in (span.low, span.high))
        return self._crank_ends()

    def _crank_ends(self) -> tuple[LinkagePosition, ...]:
        """The ends of the crank's swing; none where it turns fully."""
        span = self._crank_range()
        return () if span.full else tuple(self._at(angle, "end") for angle in (span.low, span.high))

    def critical(self) -> tuple[LinkagePosition, ...]:
        """The bar at right angles to the frame, or the crank in line with it, and their own ends.

        For a cylinder the crank's ends are no dead points.
        """
        if self.driver == "bar":
            span = self._normal_range()
            angles, how = ((0.0, math.pi), "square") if span.full else ((span.low, span.high), "across")
            return tuple(self._tangent(angle, how) for angle in angles)
        span, lines = self._crank_range(), ((0.0, "inner"), (math.pi, "outer"))
        in_line = [self._at(angle, how) for angle, how in lines if span.full or span.low < angle < span.high]
        return (*in_line, *(self._crank_ends() if self.driver == "crank" else ()))

    def direction(self, position: LinkagePosition) -> float:
        return position.turn if self.driver == "bar" else cmath.phase(position.places[1] - position.places[0])

    def position_at(self, direction: float) -> LinkagePosition:
        """The position with a driving bar, else the crank, at a direction."""
        if self.driver == "bar":
            return self._tangent(direction + math.pi / 2 - self._base, "")
        return self._at(direction - self._base, "")

    def driver_at(self, direction: float) -> float:
        a, b, _ = self._tangent(direction + math.pi / 2 - self._base, "").places
        return cmath.phase(b - a)

    def ratio(self, direction: float) -> float:
        """The bar's over the crank's; the bar's direction follows from where B is ahead of C."""
        a, b, c = self.position_at(direction).places
        arm = b - c
        along = math.sqrt(max(0.0, abs(arm) ** 2 - self.offset**2))
        if along == 0:
            return math.inf
        line = arm / complex(self._ahead * along, self.offset)
        normal = 1j * line / abs(line)
        return (normal.conjugate() * 1j * (b - a)).real / ((normal.conjugate() * 1j * arm).real)

    def seen(self, position: LinkagePosition) -> TransmissionAngle:
        """At B, between what pushes there and the arm it pushes at: the bar's normal, or the cylinder, and CB or AB."""
        a, b, c = position.places
        pushing = c - b if self.driver == "slide" else 1j * cmath.rect(1, position.turn)
        return TransmissionAngle(b, pushing, c - b if self.driver == "crank" else a - b)

    @property
    def _base(self) -> float:
        """Direction of the frame, A to C."""
        return cmath.phase(self.places[2] - self.places[0])

    @property
    def _ahead(self) -> float:
        """1 where B is ahead of C on the bar, else -1."""
        _, b, c = self.places
        return 1.0 if ((b - c) * cmath.rect(1, -self.turn)).real >= 0 else -1.0

    @property
    def _nearest(self) -> float:
        """The angle of AB against AC at which B is as near to C as the offset."""
        r, d, e = self.crank, self.frame, self.offset
        return math.acos(triangles.limited((r * r + d * d - e * e) / (2 * r * d)))

    def _crank_range(self) -> triangles.MotionRange:
        """Angles of AB against AC: B may not come nearer to C than the offset."""
        if triangles.even(abs(self.frame - self.crank) - abs(self.offset), self.frame + self.crank) >= 0:
            return triangles.MotionRange(0.0, math.tau, True)
        return triangles.MotionRange(self._nearest, math.tau - self._nearest)

    def _normal_range(self) -> triangles.MotionRange:
        """Angles of the bar's left normal against AC: the bar's line may not pass A at more than the crank's length."""
        r, d, e = self.crank, self.frame, self.offset
        over, under = triangles.even(r - e - d, r + d) < 0, triangles.even(r + e - d, r + d) < 0
        least = math.acos(triangles.limited((r - e) / d)) if over else 0.0
        greatest = math.acos(triangles.limited((-r - e) / d)) if under else math.pi
        return triangles.spanned(least, greatest, self.turn + math.pi / 2 - self._base)

    def _tangent(self, normal: float, how: str) -> LinkagePosition:
        """The bar's left normal at an angle against AC, and B on it where the crank reaches it, on the side drawn."""
        n = cmath.rect(1, normal)
        high = self.offset + self.frame * n.real
        gap = triangles.even(self.crank - abs(high), self.crank)
        along = self._ahead * math.sqrt(max(0.0, gap * (self.crank + abs(high))))
        return self._position(n * complex(high, -along), complex(self.frame), -1j * n, how)

    def _at(self, angle: float, how: str) -> LinkagePosition:
        """The crank at an angle against AC."""
        b, c = cmath.rect(self.crank, angle), complex(self.frame)
        far, e = abs(b - c), abs(self.offset)
        gap = triangles.even(far - e, self.crank + self.frame)
        arm = complex(self._ahead * math.sqrt(max(0.0, gap * (far + e))), self.offset)
        along = -1j * b if abs(arm) < triangles.EVEN * self.frame else (b - c) / arm
        return self._position(b, c, along / abs(along), how)

    def _position(self, b: complex, c: complex, along: complex, how: str) -> LinkagePosition:
        """From the axes of the frame to the drawing's."""
        turn, a = cmath.rect(1, self._base), self.places[0]
        crank, direction = triangles.phase(b * turn), triangles.phase(along * turn)
        value = {"crank": crank, "bar": direction, "slide": ((b - c) * along.conjugate()).real}[self.driver]
        if self.scale is not None:
            value = self.scale(value) if self.driver == "slide" else triangles.whole(self.scale(value))
        output, gamma = direction if self.output == "bar" else crank, self._gamma(b, c, along)
        return LinkagePosition((a, a + b * turn, a + c * turn), direction, value, output, gamma, how)

    def _gamma(self, b: complex, c: complex, along: complex) -> float:
        """Angle between what pushes and the arm it pushes at; 90 deg - it lies between force and velocity.

        0 with B on C: a crank as long as the frame cannot turn the bar there.
        """
        if self.driver == "crank":
            arm = complex(((b - c) * along.conjugate()).real, self.offset)
            return triangles.folded(1j, arm) if abs(arm) > triangles.EVEN * self.frame else 0.0
        return triangles.folded(1j * along, b) if self.driver == "bar" else triangles.folded(b - c, b)

    def mechanism(self, omega: float = 10.0) -> Mechanism:
        """The bar is hinged at C, or at B where it slides through a block at C; its line ends in a point."""
        (a, b, c), (pa, pb, pc) = self.names, self.places
        bar, block = ("2", "3") if self.block else ("3", "2")
        (hinge, start), (other, block_place) = ((b, pb), (c, pc)) if self.block else ((c, pc), (b, pb))
        along = cmath.rect(1, self.turn)
        foot = start + (-1j if self.block else 1j) * along * self.offset
        ahead = 1.0 if ((block_place - foot) * along.conjugate()).real >= 0 else -1.0
        p, q = free_names(self.names, 2)
        tip = foot + ahead * along * 1.15 * (self.crank + self.frame)
        points = {hinge: start} | ({} if self.offset == 0 else {p: foot}) | {q: tip}
        origin = hinge if self.offset == 0 else p
        links = {FRAME: {a: pa, c: pc}, "1": {a: pa, b: pb}, "2": {}, "3": {}}
        links |= {bar: points, block: {other: block_place}}
        slide = Slide("s", True, drawn_line(links, bar, origin, ahead * along), other, block, 0.0)
        driver = {
            "crank": turning("1", (a, b), pb - pa, omega), "bar": turning(bar, (origin, q), ahead * along, omega),
            "slide": pushing(((block_place - foot) * ahead * along.conjugate()).real),
        }[self.driver]  # fmt: skip
        return assembled("4", links, (slide,), (driver,))
