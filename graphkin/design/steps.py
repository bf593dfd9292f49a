"""What ruler, triangle and compass do when a linkage is designed: steps as data.

A construction is a list of stages; a stage is one numbered sentence of the solution and the steps it speaks of. A
step names what it makes: a point, a line, a circle, or a number. `board.replay` does them.
"""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.value import frozen

__all__ = [
    "Bisector", "CircleAbout", "CircleThrough", "Construction", "LayOff", "MarkOn", "Measure", "MeasureAngle", "Meet",
    "Normal", "Parallel", "Place", "Reckon", "Slanted", "Stage", "Step", "Through", "Turned",
]  # fmt: skip


@frozen
class Place:
    """A point that is given, or freely chosen [m]."""

    point: str
    at: complex


@frozen
class Reckon:
    """A number from others, by a rule of `RULES`: theta = 180 deg (K - 1)/(K + 1)."""

    name: str
    rule: str
    of: tuple[str, ...]


@frozen
class LayOff:
    """A point at a length from `about`, at an angle from the direction to `toward` (+x where that is "").

    angle   name of a number; "": straight toward. sense   1 counter-clockwise, -1 clockwise
    """

    point: str
    about: str
    length: str
    toward: str = ""
    angle: str = ""
    sense: float = 1.0


@frozen
class Slanted:
    """A line through a point, at an angle from the direction to another point (from +x where that is "")."""

    line: str
    at: str
    toward: str
    angle: str
    sense: float = 1.0


@frozen
class Through:
    """A line through two points."""

    line: str
    first: str
    second: str


@frozen
class Normal:
    """A line through a point at right angles to a line."""

    line: str
    at: str
    to: str


@frozen
class Parallel:
    """A line beside another at a distance, to its left (side 1) or right (-1)."""

    line: str
    to: str
    distance: str
    side: float = 1.0


@frozen
class Bisector:
    """The perpendicular bisector of two points."""

    line: str
    first: str
    second: str


@frozen
class CircleThrough:
    """The circle through three points; its centre is a point too."""

    circle: str
    points: tuple[str, str, str]
    centre: str


@frozen
class CircleAbout:
    """A circle about a point: a radius [m], or through a point."""

    circle: str
    centre: str
    radius: str = ""
    through: str = ""


@frozen
class Meet:
    """Where two lines or circles meet: of two crossings the one nearest to, or farthest from, a point."""

    point: str
    first: str
    second: str
    near: str = ""
    far: str = ""


@frozen
class MarkOn:
    """A point of a circle found by trial: in a direction from its centre [rad] that no ruler gives."""

    point: str
    circle: str
    turn: float


@frozen
class Turned:
    """A point turned about another by an angle (the method of inversion)."""

    point: str
    of: str
    about: str
    angle: str


@frozen
class Measure:
    """The ruler: the distance of two points."""

    name: str
    first: str
    second: str


@frozen
class MeasureAngle:
    """The protractor: the angle from the direction at -> toward (+x where that is "") to at -> to, -pi to pi."""

    name: str
    at: str
    toward: str
    to: str


Step = (
    Place | Reckon | LayOff | Slanted | Through | Normal | Parallel | Bisector | CircleThrough | CircleAbout | Meet
    | MarkOn | Turned | Measure | MeasureAngle
)  # fmt: skip


@frozen
class Stage:
    """One numbered sentence (a key of `SENTENCES`) and its steps."""

    say: str
    steps: tuple[Step, ...]


@frozen
class Construction:
    """Stages, and the numbers that are wanted of the linkage [m, rad]."""

    given: Mapping[str, float]
    stages: tuple[Stage, ...]
