"""The contract of every kind of linkage of four links, and the values it answers with.

A kind is one class in one file (`four`, `slider`, `guide`), a frozen value of its lengths and of the position it is
drawn at. Whoever has a linkage asks it; nobody asks which kind it is. Lengths [m], angles [rad], places complex [m].

    word, drivers     its key in `family.KINDS` and its option on the command line; the parts that can drive
    names, places     of its points A, B, C (and D); at the drawn position
    called, sizes     the name of each part, {"crank": "AB", ..}; lengths by these names, an offset as "e"
    driver, output    the part that drives, that is driven; `scale`: how the file counts the driver, None as we do
    block             the frame carries the block, and the guide slides in it
    drawn             the drawn position
    stroke            from end to end of its slider's motion; None where no part slides on the frame
    arm               numbers of two places: fixed pivot and moving hinge of the output, of a sliding one of the crank
    kind(), sums()    the kind and its special case, "change-point" and "kite"; the lengths that decide it
    turns()           every two links, and whether they turn fully against each other
    driver_range(), output_range()   directions, or displacements (of the driver as its scale counts)
    limits()          the two ends of the output's motion; none where it turns round and round
    critical()        positions at which the transmission angle can be least, over the driver's range
    direction(at)     of the driven link at a position; of the crank where the coupler or a slide drives
    position_at(direction)   the position with that link at a direction, assembled as drawn: of the two mirrored
                      assemblies the one that `places` shows. Beyond what it reaches the other links lie in line
    driver_at(direction)     of a crank that drives, with the output at a direction: one of two where the output
                      swings, NaN where it slides
    ratio(direction)  output's over driver's velocity with the driven crank at a direction; infinite at a dead point
    seen(at)          the transmission angle as it is seen at a position
    mechanism(omega)  at its drawn position: links 1, 2, 3, frame 4, driven at `omega` [rad/s] or 0.1 m/s

A direction of a link is that from its fixed to its moving hinge, against +x. A new kind is a file with its class, its
entry in `family.KINDS` and `Linkage`, its loop in `recognised`, its words in `graphkin.say.linkages`.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.base.value import frozen
from graphkin.studies.linkages.triangles import even

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

    @property
    def is_flat(self) -> bool:
        """True where all its points are on one line."""
        places = np.array(self.places) - self.places[0]
        along = places[np.abs(places).argmax()]
        return bool((np.abs((places / along).imag) < 1e-6).all())


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
