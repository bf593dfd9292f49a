"""Which assembly each of many mechanisms of one topology is, by its own sketch: all are drawn, the nearest is taken."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from itertools import product

import numpy as np

from graphkin.construction import Facts, Fit, Meet, Plot, Swing, replay, slide_key, unknowns_of
from graphkin.geometry import Value
from graphkin.mechanism import FRAME
from graphkin.planning.assembly import DEAD_SINE
from graphkin.planning.branch_search import BETWEEN
from graphkin.planning.branches import Branches
from graphkin.planning.method import Method
from graphkin.planning.starts import Starts
from graphkin.planning.structure import Structure
from graphkin.stacking import count_of
from graphkin.value import frozen

EXACT = 1e-3
"""A sketch this near, as part of how far a group that is fitted is from its dead points, has no other as near."""
CHOICES = 6
"""Crossings of circles of which every combination is drawn."""


def few_ways(method: Method) -> bool:
    return not method.doubtful and len(choices_of(method)) <= CHOICES and bool(list(method.position.steps))


def choices_of(method: Method) -> list[int]:
    steps = method.position.steps
    return [step.choice for step in steps if isinstance(step, Meet | Swing) and step.choice is not None]


@frozen
class Assemblies:
    """As `Assembly`, of many mechanisms: sides by choice, angles and displacements, (n,) each; which are sure."""

    sides: Mapping[int, np.ndarray]
    near: Mapping[str, Value]
    sure: np.ndarray


def assembled_by_sketch(
    method: Method, facts: Facts, sketch: Mapping[str, Value], told: Told | None = None
) -> Assemblies:
    """Every combination of crossings drawn, and for each mechanism the nearest to its sketch taken.

    Sure is what closes, lies well off its dead points, and has no other assembly that the sketch may mean. Groups that
    are fitted start as `told`, and are sure where the sketch is all but exact.
    """
    choices = choices_of(method)
    ways = np.array([*product((1, -1), repeat=len(choices))], dtype=float).reshape(2 ** len(choices), len(choices))
    start = Plot(facts, {} if told is None else told.near)
    plot = replay(method.position, start, {choice: ways[:, [k]] for k, choice in enumerate(choices)})
    count = np.broadcast_shapes((1,), *map(np.shape, (*sketch.values(), *plot.position.values())))[-1:]
    every = (len(ways), *count)
    points = {point: np.broadcast_to(z, every) for point, z in plot.position.items()}
    shown = [point for point in sketch if point in points]
    far = sum((np.abs(points[point] - sketch[point]) ** 2 for point in shown), np.zeros(every))
    far = np.where(_closed(method, plot, points), far, np.inf)
    best, row = np.argmin(far, axis=0), np.arange(every[1])
    sines = [np.broadcast_to(sine, every)[best, row] for (plane, _), sine in plot.sines.items() if plane == "position"]
    nearest = far[best, row]
    sure = np.isfinite(nearest) & (np.min([np.ones(every[1]), *np.nan_to_num(sines)], axis=0) >= DEAD_SINE)
    slides = [np.broadcast_to(s, every) for s in plot.s.values()]
    places = np.array([*points.values()])
    size = np.abs(places - places[0])[:, best, row].max(axis=0)
    for other in range(len(ways)):
        with np.errstate(invalid="ignore"):
            same = np.all([np.abs(z[other] - z[best, row]) <= 1e-9 * size for z in (*points.values(), *slides)], axis=0)
            apart = sum((np.abs(points[p][other] - points[p][best, row]) ** 2 for p in shown), np.zeros(every[1]))
            doubt = (apart <= (1e-9 * size) ** 2) | (far[other] - nearest < BETWEEN * apart)
        sure &= same | ~np.isfinite(far[other]) | ~doubt
    if told is not None:
        sure &= told.certain(plot, best, every, nearest)
    turned = [base for base in method.structure.bases if base in plot.theta]
    near = {base: np.broadcast_to(plot.theta[base], every)[best, row] for base in turned}
    near |= {slide_key(slide): np.broadcast_to(s, every)[best, row] for slide, s in plot.s.items()}
    return Assemblies({choice: ways[best, k] for k, choice in enumerate(choices)}, near, sure)


@frozen
class Told:
    """What sketches tell of the groups that are fitted, (n,) each."""

    starts: Starts
    near: Mapping[str, Value]
    steps: tuple[Fit, ...]

    @classmethod
    def by_sketch(cls, method: Method, structure: Structure, facts: Facts) -> Told | None:
        """None where nothing is fitted."""
        steps = tuple(step for step in method.position.steps if isinstance(step, Fit))
        if not steps:
            return None
        mechanism, starts = structure.mechanism, Starts(structure)
        plot = Plot(facts, position={**mechanism.links[FRAME].points, **mechanism.sketch}, theta={FRAME: 0.0})
        for base in structure.bases:
            if base not in plot.theta and (angle := starts.angle(plot, base)) is not None:
                plot.theta[base] = angle
        here = Branches(plot, np.zeros((count_of(mechanism), 0), dtype=int))
        near = {name: x for step in steps for name, x in zip(unknowns_of(step), starts.told(here, step), strict=True)}
        return cls(starts, near, steps)

    @classmethod
    def known(cls, method: Method, structure: Structure, drawn: Mapping[str, Value]) -> Told:
        """Where everything is known already."""
        return cls(Starts(structure), drawn, tuple(step for step in method.position.steps if isinstance(step, Fit)))

    def certain(self, plot: Plot, best: np.ndarray, every: tuple[int, ...], away: np.ndarray) -> np.ndarray:
        """Where all groups of the `best` assemblies, by squared distance `away` from the sketch, are as sketched."""
        all_of_them = (self._certain(step, plot, best, every, away) for step in self.steps)
        return reduce(np.logical_and, all_of_them, np.ones(every[1], dtype=bool))

    def _certain(
        self, step: Fit, plot: Plot, best: np.ndarray, every: tuple[int, ...], away: np.ndarray
    ) -> np.ndarray:
        row, told = np.arange(every[1]), np.array([self.near[name] for name in unknowns_of(step)])
        found = [*(plot.theta[base] for base in step.angles), *(plot.s[slide] for slide in step.slides)]
        x = np.array([np.broadcast_to(value, every)[best, row] for value in found])
        sine = np.nan_to_num(np.broadcast_to(plot.sines["position", step.name], every)[best, row])
        exact = away < (EXACT * sine * self.starts.size(step)) ** 2
        return np.asarray(self.starts.certain(x, told, step, sine) & exact)


def _closed(method: Method, plot: Plot, points: Mapping[str, np.ndarray]) -> np.ndarray:
    """Where every point has a place, and cylinders are drawn out, not turned round."""
    closed = np.all([np.isfinite(places) for places in points.values()], axis=0)
    for name, slide in method.structure.slides.items():
        if slide.guide != FRAME and len(method.structure.bodies[slide.guide]) == 1 and slide.line.on_axis:
            closed = closed & (plot.s[name] > 0)
    return np.asarray(closed)
