"""What a mistake is looked for in: a method with its drawing, and its arrows."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import field
from functools import cached_property
from typing import TypeVar

from graphkin.construction import Construction, LayOff, Measure, Plane, Plot, Simultaneous, Size, Step
from graphkin.marking.asked import Arrows, arrows_of
from graphkin.marking.rewrite import Rewrite
from graphkin.planning import Method
from graphkin.quantities import Quantity
from graphkin.value import frozen

__all__ = ["MISTAKES", "Mistake", "Scene", "mistake"]

Known = TypeVar("Known", bound=Size)


@frozen
class Scene:
    """A method at its drawing, and what is asked of it.

    scales  of the paper, where they are known: "length" [m/mm], "velocity" [(m/s)/mm], "acceleration" [(m/s^2)/mm]
    """

    method: Method
    plot: Plot
    quantities: tuple[Quantity, ...] = ()
    scales: Mapping[str, float] = field(default_factory=dict)

    @cached_property
    def arrows(self) -> Arrows:
        return arrows_of(self.method)

    @property
    def polygons(self) -> tuple[Construction, Construction]:
        return self.method.velocity, self.method.acceleration

    def construction(self, plane: Plane) -> Construction:
        return self.method.velocity if plane == "velocity" else self.method.acceleration

    def steps(self, plane: Plane) -> Iterator[tuple[int, Step]]:
        """Every step with its number."""
        return enumerate(self.construction(plane).steps)

    def measures(self, plane: Plane) -> Iterator[Measure]:
        return (step for _, step in self.steps(plane) if isinstance(step, Measure))

    def sized(self, plane: Plane, kind: type[Known]) -> dict[Known, str]:
        """Known sizes of a kind, with the name of the arrow: those laid off, then those solved together."""
        found: dict[Known, str] = {}
        for _, step in self.steps(plane):
            if isinstance(step, LayOff) and isinstance(step.term.size, kind):
                found.setdefault(step.term.size, step.term.name(plane))
        for _, step in self.steps(plane):
            if isinstance(step, Simultaneous):
                for chain in step.chains:
                    found = {size: "" for size, _ in chain.known if isinstance(size, kind)} | found
        return found


Finder = Callable[[Scene], Iterator[Rewrite]]


@frozen
class Mistake:
    """A mistake there is: where it can be made in a scene.

    rule  the source's rule that it breaks, by section and equation of Sun Huan, 机械原理
    """

    id: str
    rule: str
    find: Finder


MISTAKES: dict[str, Mistake] = {}
"""Every mistake by its id."""


def mistake(id: str, rule: str) -> Callable[[Finder], Finder]:
    """Enters a mistake's function under its id."""

    def enter(find: Finder) -> Finder:
        MISTAKES[id] = Mistake(id, rule, find)
        return find

    return enter
