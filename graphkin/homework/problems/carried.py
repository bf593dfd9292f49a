"""One assembly for a whole class: that of the problem in the middle of a template's ranges, as its sketch means it.

A sketch is right near one position. Where numbers take the mechanism elsewhere it may be nearer to another assembly, so
each problem's is carried over: along the drivers as in a sweep, then to the other lengths on the same crossings.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress

from graphkin.base.cache import kept
from graphkin.base.geometry import number, place
from graphkin.base.tolerances import ROUNDED
from graphkin.construction import Meet, Plot, Swing
from graphkin.errors import GraphkinError
from graphkin.files import MechanismFile
from graphkin.homework.problems.template import Template
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.planning import Method, plan
from graphkin.planning.refusals import key_of
from graphkin.running import replay_all
from graphkin.running.other_positions import reached
from graphkin.running.path import along

_TRIED = 60  # problems that are looked at for one that can be put together
_DIGITS = 2  # of a sketched place [mm]: it only picks the assembly
_Places = Mapping[str, complex]


@kept(4)
def middle(template: Template) -> Method | None:
    """The problem nearest to the middle of all ranges that can be put together, of some; None where there is none."""
    halves = tuple((each.count - 1) / 2 for each in template.ranges)

    def off(numbers: Sequence[int]) -> float:
        return max(abs(number - half) / (half or 1.0) for number, half in zip(numbers, halves, strict=True))

    drawn = (template.numbers("", "", attempt) for attempt in range(_TRIED))
    for numbers in (tuple(int(half) for half in halves), *sorted(drawn, key=off)):
        with suppress(GraphkinError):
            return plan(template.mechanism(numbers))
    return None


def carried(template: Template, numbers: Sequence[int]) -> MechanismFile | None:
    """The problem with these numbers in the assembly of the middle one; its sketch is another one only where its own
    means another. None where that assembly does not come so far. Raises what loading raises, and what planning one
    raises that cannot be put together at all."""
    own, pattern = template.mechanism(numbers), middle(template)
    if pattern is None:
        return own
    with suppress(GraphkinError):
        places, sides = _led_to(pattern, own)
        method = plan(_sketched(own, places, places))
        here = _crossings(method, {})
        if here == sides or here.keys() != sides.keys():  # other keys: with these lengths it is drawn in another way
            places = _moving(method, replay_all(method))
            few = [point for point in places if point in own.sketch]
            ways = (_sketched(own, places, points) if points else own for points in ((), few, places))
            return next((each for each in ways if _stands(each, places, method.size)), None)
    plan(own)
    return None


def sketched_anew(template: Template, numbers: Sequence[int], mechanism: Mechanism) -> bool:
    """True where a problem's sketch is not the template's, which means another assembly there."""
    return mechanism.sketch != template.mechanism(numbers).sketch


def _led_to(pattern: Method, own: MechanismFile) -> tuple[_Places, dict[str, int]]:
    """The pattern's points and crossings with its drivers as in a problem. Raises NotReached."""
    values = [begin if driver.value is None else driver.value
              for driver, begin in zip(own.drivers, pattern.facts().values, strict=True)]  # fmt: skip
    path, t = reached(pattern, values)
    sides = {choice: int(number(side)) for choice, side in path.crossings(t).items()}
    return _moving(pattern, along(pattern, path, t)), _crossings(pattern, sides)


def _moving(method: Method, plot: Plot) -> dict[str, complex]:
    """Places of the moving points that people named [m]."""
    fixed = {*method.mechanism.links[FRAME].points, *method.mechanism.unnamed}
    return {name: place(z) for name in method.mechanism.points
            if name not in fixed and (z := plot.position.get(name)) is not None}  # fmt: skip


def _crossings(method: Method, sides: Mapping[int, int]) -> dict[str, int]:
    """The crossing of each choice by what it draws, as planned where `sides` has no other."""
    steps = (step for step in method.position.steps if isinstance(step, Meet | Swing))
    return {key_of(step): sides.get(step.choice, step.side) for step in steps if step.choice is not None}


def _sketched(mechanism: MechanismFile, places: _Places, points: Iterable[str]) -> MechanismFile:
    """The mechanism with these points at these places in its sketch."""
    shown = {point: [round(1000 * part, _DIGITS) for part in (places[point].real, places[point].imag)]
             for point in points}  # fmt: skip
    return mechanism.with_({f"sketch.{point}": xy for point, xy in shown.items()})


def _stands(mechanism: MechanismFile, places: _Places, size: float) -> bool:
    """True where its own sketch puts a mechanism together at these places."""
    try:
        there = _moving(method := plan(mechanism), replay_all(method))
    except GraphkinError:
        return False
    return all(abs(there[point] - place) < ROUNDED * size for point, place in places.items())
