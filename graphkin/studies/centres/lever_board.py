"""A board over the centres on which motions of links are worked out: numbers, each with its sense, got by steps.

On paper lengths are read in millimetres at its scale; without paper the same steps take them as they are.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from math import copysign, nan
from typing import Literal

from graphkin.base.geometry import Value, number, unit
from graphkin.base.value import Lazy, frozen
from graphkin.construction.drafting import Board, DraftMeasure, MeasureAngle, Pricked, Reckon, Stage, Step, draw
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.studies.centres.instant_centres import Centres

NEAR = 1e-6  # lengths below this part of the mechanism's size are none on paper
SCALE = "scale"


@frozen
class BoardNumber:
    """The quantity of which a number on the board is the size.

    kind   "omega" of a link, "against": of a link that turns against another, "speed" of a link that does not turn,
           "velocity" of a point, or of one against another, "slide": the speed of a driven slide, "length" on paper
           [mm], "scale" [m/mm]
    """

    kind: Literal["omega", "against", "speed", "velocity", "slide", "length", "scale"]
    of: str = ""
    other: str = ""


@frozen
class Lever:
    """A stage that gives one number, and the links it leads from and to.

    A stage says "together", "against", "about", "levered", "alike", "pushed", "turned", "triangle", "glides", "point",
    "pair", or "none": there is no lever.
    """

    stage: Stage
    base: str
    link: str

    @property
    def sum(self) -> Reckon | None:
        """The sum, the last of its steps; None where there is nothing to be worked out."""
        step = self.stage.steps[-1] if self.stage.steps else None
        return step if isinstance(step, Reckon) and self.stage.say != "together" else None


@frozen
class Sense:
    """A sense is that of a number, kept or turned round as angles tell: one between two rays, or two of a triangle."""

    of: str
    angles: tuple[str, ...] = ()

    def step(self, name: str) -> Reckon:
        """The step that gives the sense of a number."""
        rule = ("same", "sense", "sense of sines")[len(self.angles)]
        return Reckon(_sense(name), rule, (_sense(self.of), *self.angles))


def _sense(name: str) -> str:
    """The number that is another's sense."""
    return f"sense of {name}"


@dataclass
class LeverBoard:
    """Motions of links known so far, as numbers on a board over the centres: sizes, each with its sense beside it.

    A sense is 1 or -1: counter-clockwise or clockwise; of a link that does not turn, whether it moves a quarter turn
    left or right of the direction in which its centre lies.

    scale    of the drawing from which lengths are taken [m/mm]; 0 without paper: lengths [m]
    turning  links with known motion; whether each turns
    meant    the quantity behind each number
    letters  points of the mechanism by their names on the board
    stages   all that was done
    """

    found: Centres
    scale: float = 0.0
    turning: dict[str, bool] = field(default_factory=dict)
    meant: dict[str, BoardNumber] = field(default_factory=dict)
    letters: dict[str, str] = field(default_factory=dict)
    stages: list[Stage] = field(default_factory=list)
    _steps: list[Step] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.know(SCALE, BoardNumber("scale"), self.scale or 1.0)
        for link in (FRAME, *self.mechanism.moving):
            if self.found.together(FRAME, link):
                self.move(link, False, 0.0)

    @property
    def mechanism(self) -> Mechanism:
        return self.found.method.mechanism

    @cached_property
    def board(self) -> Board:
        """The centres' board; a ruler reads millimetres of paper on it, and nothing for what is only rounding."""
        base = self.found.board
        board = Board(base.origin, base.size, base.underlay, dict(base.points))

        def read(length: Value) -> float:
            return number(length) / self.scale if number(length) > NEAR * self.size else 0.0

        return replace(board, read=read) if self.scale else board

    @cached_property
    def size(self) -> float:
        places = [complex(place) for place in self.found.plot.position.values()]
        return max(abs(place - places[0]) for place in places) or 1.0

    def rate(self, link: str) -> str:
        """The number that is known of a link: its angular velocity, or its speed."""
        return f"{'omega' if self.turning[link] else 'speed'} {link}"

    def value(self, link: str) -> float:
        return number(self.board.numbers[self.rate(link)])

    def omega(self, link: str) -> float:
        """Angular velocity with its sense [rad/s]; 0 for a link that does not turn, NaN for one that is not known."""
        if link not in self.turning:
            return nan
        return self._with_sense(self.rate(link)) if self.turning[link] else 0.0

    def turned(self, rate: BoardNumber) -> float:
        """The same of a link, or of one against another."""
        return self._with_sense(f"{rate.kind} {rate.of} {rate.other}".rstrip())

    def _with_sense(self, name: str) -> float:
        size = number(self.board.numbers[name])
        return copysign(size, number(self.board.numbers[_sense(name)])) if size else 0.0

    def way(self, link: str) -> complex:
        """The direction in which a link moves that does not turn (unit vector)."""
        return complex(unit(self._along(link)))

    def _along(self, link: str) -> complex:
        """The velocity of a link that does not turn [m/s]."""
        speed = self._with_sense(self.rate(link))
        return complex(1j * speed * self.board.away(self.found.name(FRAME, link))) if speed else 0j

    @property
    def motions(self) -> Motions:
        """Velocities of links: v_E = omega P1E, at right angles to P1E in the sense of omega; NaN where not known."""
        moving, position = self.mechanism.moving, self.found.plot.position
        velocities = Lazy(moving, lambda link: Lazy(position, lambda point: self._velocity(point, link)))
        omega = {link: self.omega(link) for link in moving}
        return Motions(self.mechanism, {}, omega, {}, {}, {}, {}, position, velocities, {})

    def _velocity(self, point: str, link: str) -> complex:
        if not self.turning.get(link, True):
            return self._along(link)
        return complex(1j * self.omega(link) * (self.found.plot.position[point] - self.found.place(FRAME, link)))

    def moved(self, velocity: BoardNumber, link: str) -> complex:
        """Velocity of a point of a link [m/s], or of one point against another."""
        motions = self.motions
        first = motions.velocity_at(velocity.of, link)
        return complex(first - motions.velocity_at(velocity.other, link) if velocity.other else first)

    def velocity(self, point: str, link: str) -> complex:
        """Velocity of a point of a link [m/s], of the length that was worked out by `of_point`."""
        size = number(self.board.numbers[f"velocity {point} {link}"])
        return complex(size * unit(self._velocity(point, link))) if size else 0j

    def know(self, name: str, meant: BoardNumber, value: float) -> str:
        """Put a given number on the board; returns its name."""
        self.board.numbers |= {name: abs(value), _sense(name): copysign(1.0, value)}
        self.meant[name] = meant
        return name

    def move(self, link: str, turns: bool, value: float) -> None:
        """Put the given motion of a link on the board."""
        name = self.becomes(link, turns)
        self.know(name, self.meant[name], value)

    def stands(self, link: str) -> bool:
        """True for a link that is at rest for good: nothing can be carried on from it."""
        return not self.turning[link] and self.value(link) == 0.0

    def do(self, step: Step) -> str:
        """Add a step towards the next sum; returns the name of what it makes."""
        self._steps.append(step)
        return step.name

    def length(self, first: str, second: str) -> str:
        """The ruler between two points of the board."""
        name = f"{first} to {second}"
        self.meant[name] = BoardNumber("length", first, second)
        return self.do(DraftMeasure(name, first, second))

    def angle(self, at: str, toward: str, to: str) -> str:
        """The protractor between two rays from a point of the board."""
        return self.do(MeasureAngle(f"{toward} {at} {to}", at, toward, to))

    def pricked(self, point: str) -> str:
        """A point of the mechanism on the board, where a centre may have its name."""
        name = f"point {point}"
        self.letters[name] = point
        return self.do(Pricked(name, point))

    def between(self, first: str, second: str) -> str:
        """The protractor between the directions of two points at infinity."""
        return self.angle(self.pricked(next(iter(self.found.plot.position))), first, second)

    def centres(self, link: str, other: str) -> tuple[str, str, str]:
        """The absolute centres of two links, and their common one."""
        name = self.found.name
        return name(FRAME, link), name(FRAME, other), name(link, other)

    def becomes(self, link: str, turns: bool = True) -> str:
        """The number that the motion of a link is about to be."""
        self.turning[link] = turns
        self.meant[self.rate(link)] = BoardNumber("omega" if turns else "speed", link)
        return self.rate(link)

    def summed(
        self, say: str, base: str, link: str, name: str, rule: str, *of: str, sense: Sense | None = None
    ) -> Lever:
        """Do a sum, after the steps that lead to it and the sense of what it gives."""
        senses = (sense.step(name),) if sense else ()
        stage = Stage(say, (*self._steps, *senses, Reckon(name, rule, of)))
        self._steps.clear()
        self.stages.append(stage)
        draw(stage, self.board)
        return Lever(stage, base, link)
