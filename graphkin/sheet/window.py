"""From SI to paper: where a plane's points lie on the sheet, and when in the drawing they come."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field, replace
from typing import assert_never

from graphkin.construction import (
    Arc,
    Construction,
    Fit,
    Given,
    Image,
    LayOff,
    Measure,
    Meet,
    Plane,
    Ray,
    Roll,
    Simultaneous,
    Step,
    Swing,
    Touch,
)
from graphkin.planning import Method
from graphkin.sheet.marks import Mark, Place
from graphkin.sheet.wanted import Wanted
from graphkin.value import filled, frozen

Entry = Mark | Wanted
PLANES: tuple[Plane, ...] = ("position", "velocity", "acceleration")


@frozen
class Window:
    """A plane on paper: its origin [mm, y down] and its scale [SI unit per mm]. The one place where y turns."""

    origin: Place
    scale: float

    def __call__(self, value: complex) -> Place:
        return self.origin + complex(value).conjugate() / self.scale

    @staticmethod
    def turned(direction: complex) -> complex:
        """A direction of the plane, on paper."""
        return complex(direction).conjugate()


@filled
class Figure:
    """What one plane puts on paper: marks in the order of painting, and labels that want a place."""

    marks: list[Mark] = field(default_factory=list)
    wanted: list[Wanted] = field(default_factory=list)

    @classmethod
    def of(cls, entries: Iterable[Entry]) -> Figure:
        """Marks and labels in any order."""
        figure = cls()
        for entry in entries:
            if isinstance(entry, Wanted):
                figure.wanted.append(entry)
            else:
                figure.marks.append(entry)
        return figure

    def __add__(self, other: Figure) -> Figure:
        """The other painted over this one."""
        return Figure(self.marks + other.marks, self.wanted + other.wanted)

    def numbered(self, step: int | None) -> Figure:
        """All of it in one step of the construction, or in none."""
        return Figure([replace(mark, step=step) for mark in self.marks], [replace(w, step=step) for w in self.wanted])


def constructions(method: Method) -> dict[Plane, Construction]:
    return {"position": method.position, "velocity": method.velocity, "acceleration": method.acceleration}


def first_steps(method: Method) -> dict[Plane, int]:
    """How many steps go before each plane's own: numbers run on through the three planes."""
    found: dict[Plane, int] = {}
    count = 0
    for plane, construction in constructions(method).items():
        found[plane] = count
        count += sum(1 for _ in construction.steps)
    return found


def step_count(method: Method) -> int:
    """Steps of all three planes together."""
    return sum(sum(1 for _ in construction.steps) for construction in constructions(method).values())


def births(construction: Construction, before: int) -> Mapping[str, int]:
    """The number of the step in which each point of a plane is found (the first step is 1)."""
    found: dict[str, int] = {}
    for number, step in enumerate(construction.steps, start=before + 1):
        for name in _made(step):
            found.setdefault(name, number)
    return found


def _made(step: Step) -> tuple[str, ...]:
    match step:
        case Given(point, also):
            return (point, *also)
        case LayOff(tip=tip):
            return (tip,)
        case Meet(point=point) | Image(point=point) | Touch(point=point):
            return (point,)
        case Ray() | Arc() | Swing() | Measure() | Roll() | Fit() | Simultaneous():
            return ()
        case _:
            assert_never(step)
