"""Acts of the pencil: what one sentence of a solution tells it to do, and the number that drawing and words give it.

An arrow is laid off, two lines are drawn to where they meet, a figure similar to a link gives a point: each is one
act. What leads to it (the pole, the two lines) and what is then measured belong to it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from typing import assert_never

from graphkin.base.value import frozen
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


@frozen
class Act:
    """What the pencil does in one go.

    number  counted from 1 through both polygons; in the mechanism's own plane apart
    page    counted from 1 through all three planes: the drawing of it among those of single steps
    steps   of the construction; `done` is the one that finishes it
    """

    plane: Plane
    number: int
    page: int
    steps: tuple[Step, ...]
    done: Step

    @property
    def numbered(self) -> bool:
        """Whether its number is written: the drawing of the mechanism itself needs none."""
        return self.plane != "position"


def acts(constructions: Iterable[Construction], unnamed: Collection[str]) -> tuple[Act, ...]:
    """All acts in the order in which they are drawn; `unnamed`: points that nobody named."""
    found: list[Act] = []
    for construction in constructions:
        before = 0 if construction.plane in ("position", "velocity") else sum(act.numbered for act in found)
        for number, (steps, done) in enumerate(_groups(construction, unnamed), start=before + 1):
            found.append(Act(construction.plane, number, len(found) + 1, steps, done))
    return tuple(found)


def _groups(construction: Construction, unnamed: Collection[str]) -> Iterator[tuple[tuple[Step, ...], Step]]:
    """Steps that go together, each group with the one that finishes it."""
    groups: list[tuple[list[Step], Step]] = []
    begun: list[Step] = []
    for step in construction.steps:
        if groups and not begun and (isinstance(step, Measure | Roll) or _nameless(step, unnamed)):
            groups[-1][0].append(step)
            continue
        begun.append(step)
        if _finishes(step, unnamed):
            groups.append((begun, step))
            begun = []
    if groups:
        groups[-1][0].extend(begun)
    return ((tuple(steps), done) for steps, done in groups)


def _nameless(step: Step, unnamed: Collection[str]) -> bool:
    """A point that nobody named, as where a guide's line begins: there with what it belongs to."""
    return isinstance(step, Image) and step.point in unnamed


def _finishes(step: Step, unnamed: Collection[str]) -> bool:
    """Whether a sentence of its own tells of it; a point without a name is told where it is needed."""
    match step:
        case Image():
            return not _nameless(step, unnamed)
        case LayOff() | Meet() | Swing() | Touch() | Fit():
            return True
        case Given() | Ray() | Arc() | Measure() | Roll() | Simultaneous():
            return False
        case _:
            assert_never(step)


def made(step: Step) -> tuple[str, ...]:
    """The points that a step finds."""
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
