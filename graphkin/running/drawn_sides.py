"""The sides on which points lie in the assembly in which a mechanism is drawn, as a reader of the figure sees them.

Where a construction has two crossings to choose from, something lies on another side in the other assembly: that is
looked for in both drawings, among the points that people named, and the plainest is taken.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations, product

from graphkin.base.geometry import cross, dot, number, place
from graphkin.base.scales import round_step
from graphkin.base.value import frozen
from graphkin.construction import Arc, Fit, Meet, Plot, Swing, replay
from graphkin.planning import Method

_PLAIN = 0.02  # a point that lies by a smaller part of its distance to one side is not seen to lie there
_SAME = 1e-6
Places = dict[str, complex]


@frozen
class PointSide:
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
        """True if it lies there in another drawing, as far as one drawing can say."""
        across = self.to if len(self.line) == 1 else 1j * plot.arm(*self.line) * self.left
        return self.by_distance or number(dot(across, plot.arm(self.line[0], self.point))) > 0


@frozen
class DrawnSides:
    """lies: a side for each choice that can be seen; near: where points are, roughly, of links fitted by trial [m]."""

    lies: tuple[PointSide, ...] = ()
    near: tuple[tuple[str, complex], ...] = ()


def drawn_sides(method: Method, plot: Plot) -> DrawnSides:
    """The sides at the position of a plot."""
    steps = tuple(method.position.steps)
    choices = (step for step in steps if isinstance(step, Meet | Swing) and step.choice is not None)
    sides = tuple(side for step in choices if (side := _side(method, plot, step)) is not None)
    fitted = any(isinstance(step, Fit) for step in steps)
    places = _named_places(method, plot)
    if not fitted or (size := _size(places)) <= 0:
        return DrawnSides(sides)
    # points that the file has in its sketch, to a twentieth of the mechanism's size
    step = round_step(size / 20)
    sketched = ((name, places[name]) for name in method.mechanism.sketch if name in places)
    near = ((name, complex(round(z.real / step) * step, round(z.imag / step) * step)) for name, z in sketched)
    return DrawnSides(sides, tuple(near))


def _named_places(method: Method, plot: Plot) -> Places:
    """Places of the mechanism's own points, as far as they are anywhere."""
    places = {name: place(plot.position[name]) for name in method.mechanism.points if name in plot.position}
    return {name: z for name, z in places.items() if math.isfinite(z.real) and math.isfinite(z.imag)}


def _size(places: Places) -> float:
    return max((abs(p - q) for p, q in combinations(places.values(), 2)), default=0.0)


def _side(method: Method, plot: Plot, step: Meet | Swing) -> PointSide | None:
    """The side of a point that lies elsewhere with the other crossing; None where there is none, or nothing plain."""
    assert step.choice is not None
    other_crossing = replay(method.position, Plot(plot.facts, method.near), {step.choice: -step.side})
    here, there = _named_places(method, plot), _named_places(method, other_crossing)
    here = {name: z for name, z in here.items() if name in there}
    size = _size(here)
    moved = [name for name in here if abs(here[name] - there[name]) > _SAME * size]
    still = [name for name in here if name not in moved]
    if isinstance(step, Swing):
        own = {step.pivot, step.through}
    else:
        own = {step.point, *(locus.about for locus in (step.first, step.second) if isinstance(locus, Arc))}
    sides = [*_across(here, there, moved, still), *_beyond(here, there, moved, still)]
    if not sides:  # points at another distance from a point that stays
        for other, point in product(still, moved):
            one, two = (abs(places[point] - places[other]) for places in (here, there))
            if (plain := abs(one - two) / max(one, two)) > _PLAIN:
                farther = math.copysign(1.0, one - two)
                sides.append((plain, PointSide(point, (other,), farther, by_distance=True)))
    # of what the step itself joins, else of what is plainest
    best = max(sides, key=lambda entry: (len(own & {entry[1].point, *entry[1].line}), entry[0]), default=None)
    return None if best is None else best[1]


def _across(here: Places, there: Places, moved: list[str], still: list[str]) -> Iterator[tuple[float, PointSide]]:
    """Points on the other side of a line that stays."""
    for (first, second), point in product(combinations(still, 2), moved):
        sides = list[float]()  # distances from the line, beside the longer of line and distance; positive to the left
        for places in (here, there):
            base, arm = places[second] - places[first], places[point] - places[first]
            size = abs(base) * max(abs(base), abs(arm))
            sides.append(number(cross(base, arm)) / size if size else 0.0)
        if sides[0] * sides[1] < 0 and (plain := min(map(abs, sides))) > _PLAIN:
            line = here[second] - here[first]
            across = 1j * line / abs(line) * math.copysign(1.0, sides[0])
            yield plain + 1.0, PointSide(point, (first, second), across, 1 if sides[0] > 0 else -1)


def _beyond(here: Places, there: Places, moved: list[str], still: list[str]) -> Iterator[tuple[float, PointSide]]:
    """Points on the other side of a point that stays, along x or y."""
    for other, point, unit in product(still, moved, (1 + 0j, 1j)):
        arms = [places[point] - places[other] for places in (here, there)]
        parts = [(arm * unit.conjugate()).real / abs(arm) if arm else 0.0 for arm in arms]
        if parts[0] * parts[1] < 0 and (plain := min(map(abs, parts))) > _PLAIN:
            yield plain, PointSide(point, (other,), unit * math.copysign(1.0, parts[0]))
