"""The work of ruler, compass and protractor as data: the kinds of steps by what they make, stages, a drafting of them.

Every step has a `name`, that of the point, line, circle or number which it makes; its other names are those of what is
there before. An angle is a number [rad], counted with a `sense`: 1 counter-clockwise, -1 clockwise.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field
from functools import cached_property
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction.drafting.board import Homogeneous

# --- points -----------------------------------------------------------------------------------


@frozen
class ChosenPoint:
    """A point that is given, or freely chosen [m]."""

    name: str
    at: complex


@frozen
class Pricked:
    """A point of the drawing underneath, pricked through."""

    name: str
    point: str


@frozen
class Far:
    """The point at infinity at right angles to a line."""

    name: str
    line: str


@frozen
class DraftLayOff:
    """A point at a length from `about`, at an angle from the direction to `toward` (+x where that is "").

    angle   "": straight toward
    """

    name: str
    about: str
    length: str
    toward: str = ""
    angle: str = ""
    sense: float = 1.0


@frozen
class MarkOn:
    """A point of a circle found by trial: in a direction from its centre [rad] that no ruler gives."""

    name: str
    circle: str
    turn: float


@frozen
class DraftTurn:
    """A point turned about another by an angle (the method of inversion)."""

    name: str
    of: str
    about: str
    angle: str


@frozen
class DraftMeet:
    """The point where two lines or circles meet: of two crossings the one nearest to, or farthest from, a point."""

    name: str
    first: str
    second: str
    near: str = ""
    far: str = ""


# --- lines ------------------------------------------------------------------------------------


@frozen
class Traced:
    """A line of the drawing underneath, traced."""

    name: str
    line: str


@frozen
class Through:
    """A line through two points; a parallel, if one of them is at infinity."""

    name: str
    first: str
    second: str


@frozen
class Slanted:
    """A line through a point, at an angle from the direction to another point (from +x where that is "")."""

    name: str
    at: str
    toward: str
    angle: str
    sense: float = 1.0


@frozen
class Perpendicular:
    """A line through a point at right angles to a line."""

    name: str
    at: str
    to: str


@frozen
class Parallel:
    """A line beside another at a distance, to its left (side 1) or right (-1)."""

    name: str
    to: str
    distance: str
    side: float = 1.0


@frozen
class Bisector:
    """The perpendicular bisector of two points."""

    name: str
    first: str
    second: str


@frozen
class CarriedAngle:
    """An angle carried over: the line through a point that makes with `line` the angle of `end` with `start`."""

    name: str
    at: str
    line: str
    start: str
    end: str


# --- circles ----------------------------------------------------------------------------------


@frozen
class CircleThrough:
    """The circle through three points; its centre is a point too."""

    name: str
    points: tuple[str, str, str]
    centre: str


@frozen
class CircleAbout:
    """A circle about a point: a radius [m], or through a point."""

    name: str
    centre: str
    radius: str = ""
    through: str = ""


# --- numbers ----------------------------------------------------------------------------------


@frozen
class Reckon:
    """A number from others, by a rule of `RULES`: theta = 180 deg (K - 1)/(K + 1)."""

    name: str
    rule: str
    of: tuple[str, ...]


@frozen
class DraftMeasure:
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


PointStep = ChosenPoint | Pricked | Far | DraftLayOff | MarkOn | DraftTurn | DraftMeet
LineStep = Traced | Through | Slanted | Perpendicular | Parallel | Bisector | CarriedAngle
CircleStep = CircleThrough | CircleAbout
NumberStep = Reckon | DraftMeasure | MeasureAngle
Step = PointStep | LineStep | CircleStep | NumberStep


def drawn_through(step: LineStep) -> tuple[str, ...]:
    """The points that a line is drawn through."""
    match step:
        case Slanted(at=at) | Perpendicular(at=at) | CarriedAngle(at=at):
            return (at,)
        case Through(_, first, second):
            return first, second
        case Traced() | Parallel() | Bisector():
            return ()
        case _:
            assert_never(step)


@frozen
class Stage:
    """The steps that one sentence speaks of; `say` is its key among the sentences."""

    say: str
    steps: tuple[Step, ...]

    @property
    def lines(self) -> tuple[LineStep, ...]:
        """The lines that it draws."""
        return tuple(step for step in self.steps if isinstance(step, LineStep))

    @property
    def last(self) -> Step:
        """The step that makes what the stage is for."""
        return self.steps[-1]


@frozen
class Drafting:
    """Stages, and what is on the board before the first: numbers [m, rad], points (homogeneous [m])."""

    given: Mapping[str, float]
    stages: tuple[Stage, ...]
    points: Mapping[str, Homogeneous | tuple[float, float, float]] = field(default_factory=dict)

    @property
    def steps(self) -> Iterator[Step]:
        """Every step, one after another."""
        for stage in self.stages:
            yield from stage.steps

    @cached_property
    def made_by(self) -> Mapping[str, Step]:
        """The step that makes a thing, by its name."""
        return {step.name: step for step in self.steps}

    def met_on(self, name: str) -> list[str]:
        """Points found on a line or a circle."""
        return [step.name for step in self.steps if isinstance(step, DraftMeet) and name in (step.first, step.second)]

    def born(self, point: str) -> int:
        """The number of the stage, from 1, that makes a point; that of the last where none does."""
        for number, stage in enumerate(self.stages, start=1):
            for step in stage.steps:
                if step.name == point or (isinstance(step, CircleThrough) and step.centre == point):
                    return number
        return len(self.stages)
