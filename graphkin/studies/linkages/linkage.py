"""The contract of every kind of linkage of four links, and the values it answers with.

A kind is one class in one file (`four`, `slider`, `guide`) that fulfils `Linkage`, and one entry in `family.KINDS`.
Whoever has a linkage asks it; nobody asks which kind it is. Lengths [m], angles [rad], places complex [m].

A new kind is a file with its class, its entry in `family.KINDS`, its loop in `recognised`, its words in
`graphkin.say.linkages`; the type checker holds the class to the contract.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import Field
from typing import ClassVar, Protocol

from graphkin.base.value import frozen
from graphkin.model.mechanism import Mechanism
from graphkin.studies.linkages.triangles import MotionRange, even

SLIDES = ("slider", "slide")  # the parts whose motion is a displacement [m]; all others turn [rad]
CRANKS = ("crank", "rocker")  # the drivers that can turn round and round and have an output with two ends


@frozen
class DriverScale:
    """The count of a driver in a file: value = zero + sense * ours [rad or m]."""

    name: str
    zero: float = 0.0
    sense: float = 1.0

    def __call__(self, ours: float) -> float:
        return self.zero + self.sense * ours


@frozen
class LinkagePosition:
    """The linkage at one position.

    places   of its points, in the order of its names [m]
    turn     direction of the guide or of the bar [rad]; 0 for a four-bar
    driver   the driver's value, as its scale counts it [rad or m]
    output   the output link's direction or the slider's place [rad or m]
    gamma    transmission angle [rad], 0 to pi/2; None for a driver that has none
    how      "stretched", "folded": driven link and coupler in line; "inner", "outer": driven link in line with the
             frame, towards it or away; "far", "near", "across", "square": see the linkages; "end": the driver's own end
    """

    places: tuple[complex, ...]
    turn: float
    driver: float
    output: float
    gamma: float | None
    how: str


@frozen
class Turn:
    """Two links; full: they can make a full turn against each other."""

    first: str
    second: str
    full: bool


@frozen
class Sums:
    """Two sums of lengths: some link turns fully where the first is not greater.

    ends, middle           the links of the first and of the second by name, "e" the offset, "" none
    sum_ends, sum_middle   the sums [m]
    """

    ends: tuple[str, str]
    middle: tuple[str, str]
    sum_ends: float
    sum_middle: float

    @property
    def gap(self) -> float:
        """The first less the second, 0 where it is 0 but for rounding: a change point [m]."""
        return even(self.sum_ends - self.sum_middle, self.sum_ends + self.sum_middle)

    @classmethod
    def beside_offset(cls, sizes: Mapping[str, float]) -> Sums:
        """Of two links and an offset: the shorter with the offset against the longer."""
        short, long = sorted((link for link in sizes if link != "e"), key=lambda link: sizes[link])
        return cls((short, "e"), (long, ""), sizes[short] + abs(sizes["e"]), sizes[long])


@frozen
class TransmissionAngle:
    """A transmission angle as it is seen: between two lines through a point.

    at, one, other   the point and a vector along each line [m]
    pressure         it is the pressure angle that is seen there, 90 deg less the transmission angle
    """

    at: complex
    one: complex
    other: complex
    pressure: bool = False


class Linkage(Protocol):
    """The contract of a kind of linkage: a frozen value of its lengths and of the position it is drawn at.

    A direction of a link is that from its fixed to its moving hinge, against +x [rad]; "assembled as drawn" is the one
    of the two mirrored assemblies that `places` shows.
    """

    __dataclass_fields__: ClassVar[dict[str, Field[object]]]
    """It is a frozen dataclass: `replace` gives the same linkage with another driver."""
    word: ClassVar[str]
    """Its key in `kinds.KINDS`, and its option on the command line."""
    drivers: ClassVar[tuple[str, ...]]
    """The parts that can drive."""

    @property
    def names(self) -> tuple[str, ...]:
        """The names of its points A, B, C (and D)."""

    @property
    def places(self) -> tuple[complex, ...]:
        """Its points at the drawn position [m]."""

    @property
    def driver(self) -> str:
        """The part that drives, one of `called`."""

    @property
    def output(self) -> str:
        """The part that is driven, one of `called`."""

    @property
    def scale(self) -> DriverScale | None:
        """The count of the driver in the file; None: by its direction, a slide from its own zero."""

    @property
    def block(self) -> bool:
        """True if the frame carries the block, and the guide slides in it."""

    @property
    def called(self) -> Mapping[str, str]:
        """The name of each part: {"crank": "AB", ..}."""

    @property
    def sizes(self) -> Mapping[str, float]:
        """Lengths by the names of the links, the offset of a kind that slides as "e" [m]."""

    @property
    def drawn(self) -> LinkagePosition:
        """The drawn position."""

    @property
    def stroke(self) -> float | None:
        """The length from end to end of its slider's motion [m]; None where no part slides on the frame."""

    @property
    def arm(self) -> tuple[int, int]:
        """The numbers of two places: fixed pivot and moving hinge of the turning output (the crank, if it slides)."""

    def kind(self) -> tuple[str, str]:
        """The kind, and its special case: "change-point" and "kite", "slider-crank" and "offset"."""

    def sums(self) -> Sums:
        """The lengths that decide the kind."""

    def turns(self) -> tuple[Turn, ...]:
        """Every two links, and whether they turn fully against each other."""

    def driver_range(self) -> MotionRange:
        """The range of the driver: directions [rad], or displacements as its scale counts [m]."""

    def output_range(self) -> MotionRange:
        """The range of the output: directions [rad], or the slider's places along its guide [m]."""

    def limits(self) -> tuple[LinkagePosition, ...]:
        """The two ends of the output's motion; none where it turns round and round."""

    def critical(self) -> tuple[LinkagePosition, ...]:
        """Positions at which the transmission angle can be least, over the driver's range."""

    def direction(self, position: LinkagePosition) -> float:
        """Direction of the driven link at a position [rad]; of the crank where the coupler or a slide drives."""

    def position_at(self, direction: float) -> LinkagePosition:
        """The position with the link of `direction` at a direction [rad], assembled as drawn.

        Beyond what it reaches the other links lie in line, and no longer meet.
        """

    def driver_at(self, direction: float) -> float:
        """Direction of a crank that drives, with the output at a direction [rad]: one of two where the output swings.

        NaN where it slides.
        """

    def ratio(self, direction: float) -> float:
        """Output's over driver's velocity with the driven crank at a direction [rad/rad or m/rad].

        Infinite at a dead point.
        """

    def seen(self, position: LinkagePosition) -> TransmissionAngle:
        """The transmission angle as it is seen."""

    def mechanism(self, omega: float = 10.0) -> Mechanism:
        """It as a mechanism at its drawn position: links 1, 2, 3, frame 4, driven at `omega` [rad/s] or 0.1 m/s."""
