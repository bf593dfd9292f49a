"""The assemblies of a mechanism that matter, found block by block, so that their number does not grow with its length.

A block is what one crossing of circles, or one group that is fitted, decides. Partial drawings stand side by side as
arrays over branches. After each block those that do not close are left out, and those that the sketch rules out:

1. a first assembly is looked for along the branches nearest to the sketch; more of them are kept where that fails;
2. then every branch is followed that may still be nearer to the sketch than that assembly, or as near to it that the
   sketch lies between the two. What the points still to be drawn can at most make good is known beforehand.

Where the first search met no other branch that may be meant, there is nothing more to follow. Only where more branches
than `WIDEST` remain are the farthest given up.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Construction, Facts, Fit, Measure, Meet, Plot, Step, Swing, unknowns_of
from graphkin.construction.pencil import begin, draw
from graphkin.model.mechanism import FRAME
from graphkin.planning.fit_starts import Branches, GroupFitter
from graphkin.planning.structure import Topology

WIDTHS = (1, 8, 64)  # branches kept while a first assembly is looked for
WIDEST = 1024  # branches kept at most; the same before a group is fitted, which is tried from many starts for each
WIDEST_FITTED = 128
BETWEEN = 0.04
"""A sketch lies between two assemblies if their squared distances from it differ by less than this part of the square
of the distance between them."""


class DeadEnd(Exception):
    """No branch closes: the plot so far, with every branch of the block at which the last of them ended."""

    def __init__(self, plot: Plot) -> None:
        self.plot = plot


def branches(structure: Topology, construction: Construction, facts: Facts, known: Mapping[str, float]) -> Branches:
    """Every assembly that the sketch may mean, one at least; `known`: angles and displacements where the drawn position
    has them already. Raises DeadEnd."""
    search = _BranchSearch(structure, construction, facts, known)
    assemblies, nearest = search.first(), np.inf
    if search.alone(assemblies):
        return assemblies
    while (away := search.away(assemblies)).min() < nearest:
        nearest = float(away.min())
        try:
            assemblies = search.run(WIDEST, search.bound(assemblies, int(np.argmin(away))))
        except DeadEnd:  # too many branches lay nearer to the sketch for a while, and none of them closed
            break
    return assemblies


@frozen
class _Bound:
    """The measure of branches: an assembly's points as drawn, and what each may make good while it is not [m²]."""

    places: Mapping[str, complex]
    spare: Mapping[str, float]
    rounding: float


class _BranchSearch:
    def __init__(
        self, structure: Topology, construction: Construction, facts: Facts, known: Mapping[str, float]
    ) -> None:
        self.structure, self.facts, self.known = structure, facts, known
        self.sketch = structure.mechanism.sketch
        self.cylinders = cylinders(structure)
        self.blocks: list[tuple[Meet | Swing | Fit | None, list[Step]]] = [(None, [])]
        """A step that leaves several possibilities, none before the first of them, and all that follows from it."""
        for step in construction.steps:
            if isinstance(step, Fit) or (isinstance(step, Meet | Swing) and step.choice is not None):
                self.blocks.append((step, []))
            else:
                self.blocks[-1][1].append(step)
        self.late: list[Measure] = []  # displacements that a construction measures at its very end
        rest = self.blocks[-1][1]
        while rest and isinstance(last := rest[-1], Measure) and last.quantity == "s":
            rest.pop()
            self.late.insert(0, last)
        self.fitter = GroupFitter(structure)
        self.left: list[Branches] = []

    def first(self) -> Branches:
        """The assembly nearest to the sketch as far as can be seen block by block."""
        for width in WIDTHS:
            self.left = []
            try:
                return self.run(width, None)
            except DeadEnd:
                continue
        return self.run(WIDEST, None)

    def run(self, width: int, bound: _Bound | None) -> Branches:
        """All blocks, with so many branches kept at most."""
        here = Branches(Plot(self.facts, dict(self.known)), np.zeros((1, 0), dtype=int))
        begin(here.plot, "position")
        waiting, before = list(self.late), (0, 0)
        with np.errstate(divide="ignore", invalid="ignore"):
            for opening, rest in self.blocks:
                if isinstance(opening, Fit):
                    here = self._thinned(here, min(width, WIDEST_FITTED), None)
                here = self._opened(here, opening, self._spare(here, bound))
                draw(rest, here.plot, "position", {})
                seen, lines = here.plot.position.keys(), here.plot.facts.lines
                ready = [step for step in waiting  # measured as soon as both ends are drawn
                         if {step.tail, step.head} <= seen and lines[step.of][0] in here.plot.theta]  # fmt: skip
                waiting = [step for step in waiting if step not in ready]
                draw(ready, here.plot, "position", {})
                closed = np.ones(here.count, dtype=bool)
                for point in [*here.plot.position][before[0] :]:
                    closed &= np.isfinite(here.plot.position[point])
                for name in [*here.plot.s][before[1] :]:  # cylinders keep the positive displacement of the drawing
                    closed &= np.logical_or(name not in self.cylinders, here.plot.s[name] > 0)
                before = len(here.plot.position), len(here.plot.s)
                if not closed.any():
                    raise DeadEnd(here.plot)
                if not closed.all():
                    here = here.taken(np.flatnonzero(closed))
                here = self._thinned(here, width, bound)
        return here

    def alone(self, assemblies: Branches) -> bool:
        """True if the first assembly is the only one that the sketch may mean: of the branches from which it was chosen
        the others would be left out by its bound, too."""
        if assemblies.count > 1 or any(isinstance(opening, Fit) for opening, _ in self.blocks):
            return False
        bound = self.bound(assemblies, 0)
        return all(np.count_nonzero(self._open(here, bound)) == 1 for here in self.left)

    def _opened(self, here: Branches, opening: Meet | Swing | Fit | None, spare: float) -> Branches:
        """Both ways on at a crossing; of a group every assembly that fits."""
        match opening:
            case None:
                return here
            case Fit():
                if not all(name in self.known for name in unknowns_of(opening)):
                    fitting = partial(draw, [opening], plane="position", sides={})
                    return self.fitter.fitted(here, opening, fitting, spare)
                draw([opening], here.plot, "position", {})
                return here
            case step:
                both = np.array((1, -1) * here.count)
                here = here.taken(np.arange(2 * here.count) // 2)
                here.sides = np.hstack([here.sides, both[:, None]])
                assert step.choice is not None
                draw([step], here.plot, "position", {step.choice: both})
                return here

    def _thinned(self, here: Branches, width: int, bound: _Bound | None) -> Branches:
        """The branches that may still be meant; where they are too many those nearest to the sketch, then those with
        more positive displacements; in order."""
        if here.count == 1:
            return here
        if bound is not None:
            here = here.taken(np.flatnonzero(self._open(here, bound)))
        if here.count <= width:
            return here
        self.left.append(here)
        away = self.away(here)
        steps = np.round(away / max(1e-9 * float(away.max()), np.finfo(float).tiny))
        displacements = (here.plot.s.get(name, 0.0) for name in slides_of_file(self.structure))
        forward = sum(map(np.sign, displacements), np.zeros(here.count))
        return here.taken(np.sort(np.lexsort((-forward, steps))[:width]))

    def away(self, here: Branches) -> np.ndarray:
        """Squared distance of all points drawn so far from their places in the sketch [m²]: (w,)."""
        alike, away = 0.0, np.zeros(here.count)
        for point, target in self.sketch.items():
            place = here.plot.position.get(point, target)
            if isinstance(place, np.ndarray):
                away += np.abs(place - target) ** 2
            else:
                alike += abs(place - target) ** 2
        return away + alike

    def bound(self, here: Branches, k: int) -> _Bound:
        """To follow every branch that may come nearer to the sketch than branch k, or lies with it about the sketch."""
        places = {p: at(here.plot.position[p], k) for p in self.sketch if p in here.plot.position}
        spare = {p: abs(self.sketch[p] - place) ** 2 / (1 - BETWEEN) for p, place in places.items()}
        reach = max((abs(z) for z in places.values()), default=1.0)
        return _Bound(places, spare, (1e-8 * reach) ** 2)

    def _open(self, here: Branches, bound: _Bound) -> np.ndarray:
        """True where no more distance is lost, by `BETWEEN`, than the points still to be drawn can make good: (w,)."""
        lost, sketch, drawn = np.zeros(here.count), self.sketch, here.plot.position
        for point, place in bound.places.items():
            if point in drawn and (isinstance(now := drawn[point], np.ndarray) or now != place):
                apart = now - place
                lost += (1 - BETWEEN) * np.abs(apart) ** 2 - 2 * (np.conj(apart) * (sketch[point] - place)).real
        return np.asarray(lost <= self._spare(here, bound))

    def _spare(self, here: Branches, bound: _Bound | None) -> float:
        """The distance that points still to be drawn can make good at most [m²]."""
        if bound is None:
            return 0.0
        drawn = here.plot.position
        return bound.rounding + sum(spare for point, spare in bound.spare.items() if point not in drawn)


def at(value: Value, k: int) -> complex:
    """A value on one of the branches."""
    return complex(value[k] if isinstance(value, np.ndarray) and value.ndim else value)


def slides_of_file(structure: Topology) -> list[str]:
    """Slides that the file speaks of, not those of an equivalent."""
    return [name for name, pair in structure.slides.items() if pair.stands_for is None]


def cylinders(structure: Topology) -> set[str]:
    """Slides whose guide is a moving link of one point, which is its own line: they are drawn out, not turned round."""
    return {name for name, slide in structure.slides.items()
            if slide.guide != FRAME and len(structure.bodies[slide.guide]) == 1 and slide.line.on_axis}  # fmt: skip
