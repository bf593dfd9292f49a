"""From SI to paper: where a plane's points lie on the sheet."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field, replace

from graphkin.base.value import filled, frozen
from graphkin.construction import Construction, Plane
from graphkin.planning import Method
from graphkin.sheet.marks import Mark, Place
from graphkin.sheet.wanted import LabelRequest

Entry = Mark | LabelRequest
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
    wanted: list[LabelRequest] = field(default_factory=list)

    @classmethod
    def of(cls, entries: Iterable[Entry]) -> Figure:
        """Marks and labels in any order."""
        figure = cls()
        for entry in entries:
            if isinstance(entry, LabelRequest):
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
