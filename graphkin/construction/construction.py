"""Steps put together: those of a vector equation, and the construction of a plane."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from itertools import pairwise

from graphkin.base.value import frozen
from graphkin.construction.kinds import LayOff, Step
from graphkin.construction.terms import Plane, Site, Term


class BrokenChain(ValueError):
    """Two sides of a vector equation that do not start and end at the same points."""


class NotClosable(ValueError):
    """A vector equation with more or fewer than two unknown scalars."""


def span_of(chain: tuple[Term, ...]) -> tuple[str, str]:
    """Start and end of a chain of arrows; refuses one whose arrows do not join tail to head."""
    for before, after in pairwise(chain):
        if before.head != after.tail:
            raise BrokenChain(f"{before.head} is not {after.tail}")
    return chain[0].tail, chain[-1].head


@frozen
class Equation:
    """left = right, with the steps that draw it. Paper closes it when exactly two scalars are unknown.

    of  the site whose motion both sides give
    """

    of: str
    left: tuple[Term, ...]
    right: tuple[Term, ...]
    steps: tuple[Step, ...]

    def __post_init__(self) -> None:
        if (left := span_of(self.left)) != (right := span_of(self.right)):
            raise BrokenChain(f"{left} is not {right}")
        if (unknowns := sum(term.unknowns for term in self.left + self.right)) != 2:
            raise NotClosable(f"{unknowns} unknown scalars, not 2")

    @property
    def sides(self) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
        """Both sides as they are written: one that is the motion sought itself stands first."""
        swapped = self.is_sought(self.right) and not self.is_sought(self.left)
        return (self.right, self.left) if swapped else (self.left, self.right)

    def is_sought(self, side: tuple[Term, ...]) -> bool:
        """True of a side that is nothing but the motion sought."""
        return len(side) == 1 and side[0].of == self.of and not (side[0].seen_from or side[0].over)


@frozen
class Node:
    """A point of a plane: its name, what it belongs to as written (`B3`, `pole`, `a^n_CB`), and its site."""

    name: str
    of: str
    site: Site | None = None


@frozen
class Construction:
    """The steps of one plane in order; those of one vector equation are grouped in it."""

    plane: Plane
    parts: tuple[Step | Equation, ...]
    nodes: Mapping[str, Node]
    pole: str = ""

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """Every step, one after another."""
        return tuple(step for part in self.parts for step in (part.steps if isinstance(part, Equation) else (part,)))

    @property
    def equations(self) -> tuple[Equation, ...]:
        return tuple(part for part in self.parts if isinstance(part, Equation))

    def vectors(self) -> Mapping[str, Term]:
        """Every arrow of the finished polygon by name: absolute motions of known points, then the equations' terms."""
        return self._vectors

    @cached_property
    def _vectors(self) -> dict[str, Term]:
        vectors: dict[str, Term] = {}
        for part in self.parts:
            alone = (part.term,) if isinstance(part, LayOff) else ()
            for term in part.left + part.right if isinstance(part, Equation) else alone:
                vectors.setdefault(term.name(self.plane), term)
        return vectors
