"""The contract of a pair kind, and the plain data in which it states its constraints.

Both roads read these data and make of them what is theirs: `graphkin.planning` bodies and joints of a construction,
`graphkin.analytic` terms of closed vector loops. Nothing here is solved.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from graphkin.base.value import frozen


@frozen
class Line:
    """A directed line of `link`, through its point `origin`.

    origin     a point of the link; lines of the frame given by coordinates have a point of their own there, whose
               name starts with a small letter (`s0`, `r1`), so that no user's point can clash
    direction  unit complex number in the link's own axes
    named      whether people named the origin
    base       the two points from whose direction the file measures it, if from any
    """

    link: str
    origin: str
    direction: complex
    named: bool = True
    base: tuple[str, str] | None = None

    @property
    def on_axis(self) -> bool:
        """True of its link's own axis, as the line of a link of one point where nothing else is said."""
        return bool(np.all(np.equal(self.direction, 1)))  # of many mechanisms at once, an array


@frozen
class Rod:
    """Two points of two links at a constant distance, as a bar with a hinge at each holds them.

    length   [m]
    carried  whether a link that has both points is such a bar already
    follows  whether it keeps no distance itself (others do), and only turns with the two points
    """

    links: tuple[str, str]
    points: tuple[str, str]
    length: float
    carried: bool = False
    follows: bool = False


@frozen
class Slot:
    """A point that stays on a line of a link moved sideways, as a pin in a slot does; the point may turn there.

    offset  how far to the left of the line [m]
    """

    line: Line
    point: str
    offset: float = 0.0


@frozen
class Rolling:
    """Two circles that roll on each other without slip: links, centres and radii [m]; of a rack, the line it has.

    internal  one rim encloses the other
    left      the wheel's centre lies left of the line, on which the first link is the track
    """

    wheels: tuple[str, str]
    centres: tuple[str, str]
    radii: tuple[float, float]
    internal: bool = False
    line: Line | None = None
    left: bool = True


Circle = tuple[str, str, float]  # link, centre, radius [m]


class Pair:
    """The contract: all that a kind of pair says of itself; what a kind does not have is empty here.

    table  name of its table in the mechanism file; empty where the file has none (a hinge is a shared point)
    name   no other pair has it: as the file gives it, else a small letter and a number
    """

    table: ClassVar[str]
    name: str

    @property
    def joins(self) -> tuple[str, ...]:
        """The links it joins."""
        raise NotImplementedError

    @property
    def given(self) -> str:
        """The name the file gives it, if it does."""
        return ""

    @property
    def known_by(self) -> tuple[str, str] | None:
        """Its kind in messages and the point that names it, where that is not the links it joins."""
        return None

    @property
    def pin(self) -> str:
        """The point that is a pin in its slot."""
        return ""

    @property
    def lower(self) -> bool:
        """True of a pair that takes two freedoms; a higher pair takes one."""
        return False

    @property
    def equivalent(self) -> Rod | Slot | None:
        """The lower pairs that do the same (高副低代); None for a pair that is one."""
        return None

    @property
    def rolling(self) -> Rolling | None:
        """The circles or the line that roll on each other, where nothing slips."""
        return None

    @property
    def path(self) -> Slot | None:
        """The slot along which its displacement s is measured, where that may be asked for and driven."""
        return None

    @property
    def slipping(self) -> Rod | Slot | None:
        """The contact at which its links slide: their common normal is the rod's line, or stands across the slot."""
        return None if self.rolling is not None else self.equivalent

    @property
    def circles(self) -> tuple[Circle, ...]:
        """The circles of its links that touch."""
        return ()

    @property
    def lines(self) -> tuple[Line, ...]:
        """The straight lines of its links along which something slides or rolls."""
        return ()


def rod_name(pair: Pair) -> str:
    """The name of the link of an equivalent that holds two points apart; no name of a file has two words."""
    return f"e {pair.name}"


def pin_name(pair: Pair) -> str:
    """The name of the body that stands for a pin in a slot: a block without mass of its own."""
    return f"pin {pair.name}"


def start_name(pair: Pair) -> str:
    """The name of the point where the slot of an equivalent begins."""
    return f"{pair.name} origin"


def centre_distance(radii: tuple[float, float], internal: bool) -> float:
    """Distance of the centres of two circles that touch [m]."""
    return abs(radii[0] - radii[1]) if internal else radii[0] + radii[1]
