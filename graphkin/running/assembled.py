"""In which of its assemblies a mechanism is drawn, as a reader of the figure sees it.

Where a construction has two crossings to choose from, something lies on another side in the other assembly: that is
looked for in both drawings, among the points that people named, and the plainest is taken.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations

from graphkin.base.geometry import cross, dot
from graphkin.base.value import frozen
from graphkin.construction import Arc, Fit, Meet, Plot, Swing, replay
from graphkin.planning import Method

_PLAIN = 0.02
"""What lies by a smaller part of its distance to one side is not seen to lie there."""
_SAME = 1e-6


@frozen
class Lies:
    """A point on one side of the line through two others, or of one other: `line` has two points, or one.

    to     unit vector to that side, across the line or along +-x, +-y; where no side tells, 1 or -1 for which of two
           places it has, the one farther from the other point or the nearer
    left   1 where that is to the left of the line, else -1; 0 where there is no line
    """

    point: str
    line: tuple[str, ...]
    to: complex
    left: int = 0
    by_distance: bool = False

    def holds(self, plot: Plot) -> bool:
        """Whether it lies there in another drawing, as far as one drawing can say."""
        arm = complex(plot.position[self.point] - plot.position[self.line[0]])
        across = self.to
        if len(self.line) > 1:
            line = complex(plot.position[self.line[1]] - plot.position[self.line[0]])
            across = 1j * line * self.left
        return self.by_distance or bool(dot(across, arm) > 0)


@frozen
class DrawnSides:
    """lies: a side for each choice that can be seen; near: where points are, roughly, of links fitted by trial [m]."""

    lies: tuple[Lies, ...] = ()
    near: tuple[tuple[str, complex], ...] = ()


def assembled(method: Method, plot: Plot) -> DrawnSides:
    """At the position of a plot."""
    steps = tuple(method.position.steps)
    found = (_seen(method, plot, step) for step in steps if isinstance(step, Meet | Swing) and step.choice is not None)
    fitted = any(isinstance(step, Fit) for step in steps)
    return DrawnSides(tuple(lies for lies in found if lies is not None), tuple(_about(method, plot)) if fitted else ())


def _about(method: Method, plot: Plot) -> Iterator[tuple[str, complex]]:
    """Points that the file has in its sketch, to a twentieth of the mechanism's size."""
    places = _named(method, plot)
    size = max((abs(p - q) for p, q in combinations(places.values(), 2)), default=0.0)
    if size > 0:
        power = 10.0 ** math.floor(math.log10(size / 20))
        step = power * max(k for k in (1, 2, 5) if k * power <= size / 20)
        for name in method.mechanism.sketch:
            if name in places:
                yield name, complex(round(places[name].real / step) * step, round(places[name].imag / step) * step)


def _seen(method: Method, plot: Plot, step: Meet | Swing) -> Lies | None:
    """What lies elsewhere with the other crossing; None where there is none, or nothing plain."""
    assert step.choice is not None
    other = replay(method.position, Plot(plot.facts, method.near), {step.choice: -step.side})
    here, there = _named(method, plot), _named(method, other)
    both = [name for name in here if name in there]
    size = max((abs(here[p] - here[q]) for p, q in combinations(both, 2)), default=0.0)
    moved = [name for name in both if abs(here[name] - there[name]) > _SAME * size]
    still = [name for name in both if name not in moved]
    own = _own(step)
    ways = [*_across(here, there, moved, still), *_beyond(here, there, moved, still)]
    ways = ways or list(_farther(here, there, moved, still))
    # of what the step itself joins, else of what is plainest
    best = max(ways, key=lambda way: (len(own & {way[1].point, *way[1].line}), way[0]), default=None)
    return None if best is None else best[1]


def _own(step: Meet | Swing) -> set[str]:
    if isinstance(step, Swing):
        return {step.pivot, step.through}
    return {step.point, *(locus.about for locus in (step.first, step.second) if isinstance(locus, Arc))}


def _named(method: Method, plot: Plot) -> dict[str, complex]:
    """Where the mechanism's own points are, as far as they are anywhere."""
    own = method.mechanism.points
    places = {name: complex(plot.position[name]) for name in own if name in plot.position}
    return {name: place for name, place in places.items() if math.isfinite(place.real) and math.isfinite(place.imag)}


def _across(
    here: dict[str, complex], there: dict[str, complex], moved: list[str], still: list[str]
) -> Iterator[tuple[float, Lies]]:
    """Points on the other side of a line that stays."""
    for first, second in combinations(still, 2):
        for point in moved:
            sides = [_sine(places, first, second, point) for places in (here, there)]
            if sides[0] * sides[1] < 0 and (plain := min(map(abs, sides))) > _PLAIN:
                line = here[second] - here[first]
                across = 1j * line / abs(line) * math.copysign(1.0, sides[0])
                yield plain + 1.0, Lies(point, (first, second), across, 1 if sides[0] > 0 else -1)


def _sine(places: dict[str, complex], first: str, second: str, point: str) -> float:
    """How far a point is off a line, beside the longer of line and distance; positive to the left."""
    line, arm = places[second] - places[first], places[point] - places[first]
    size = abs(line) * max(abs(line), abs(arm))
    return float(cross(line, arm)) / size if size else 0.0


def _beyond(
    here: dict[str, complex], there: dict[str, complex], moved: list[str], still: list[str]
) -> Iterator[tuple[float, Lies]]:
    """Points on the other side of a point that stays, along x or y."""
    for other in still:
        for point in moved:
            arms = [places[point] - places[other] for places in (here, there)]
            for unit in (1 + 0j, 1j):
                parts = [(arm * unit.conjugate()).real / abs(arm) if arm else 0.0 for arm in arms]
                if parts[0] * parts[1] < 0 and (plain := min(map(abs, parts))) > _PLAIN:
                    yield plain, Lies(point, (other,), unit * math.copysign(1.0, parts[0]))


def _farther(
    here: dict[str, complex], there: dict[str, complex], moved: list[str], still: list[str]
) -> Iterator[tuple[float, Lies]]:
    """Points at another distance from a point that stays."""
    for other in still:
        for point in moved:
            one, two = (abs(places[point] - places[other]) for places in (here, there))
            if (plain := abs(one - two) / max(one, two)) > _PLAIN:
                yield plain, Lies(point, (other,), math.copysign(1.0, one - two), by_distance=True)
