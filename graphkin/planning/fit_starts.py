"""Partial drawings side by side, and where a group that is found by fitting starts in each of them.

The sketch comes first. Where it shows the whole group, and so nearly that no other assembly of the group can be as
near, the assembly found from there is the one; else all that are found from many starts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from itertools import islice

import numpy as np

from graphkin.base.geometry import Real, Value, dot
from graphkin.base.value import filled
from graphkin.construction import Arm, Fit, Plot, unknowns_of
from graphkin.model.mechanism import FRAME
from graphkin.planning.structure import Topology

_TABLES = ("near", "position", "theta", "s", "sines", "misses", "senses")
STARTS = 96  # places where fitting starts, for each branch
AT_ONCE = 64  # branches fitted at once, to keep arrays short
NEAR = 0.05
"""A start this near to what fits, as part of how far the group is from its dead points, has no other as near."""
OTHERS = 0.1  # nearer than this, measured alike, there is surely no other assembly of the group
SAME = 1e-6  # assemblies of a group whose unknowns differ by less are one [rad, of its size]


@filled
class Branches:
    """Drawings side by side: values of the plot are scalar or (w,); sides (w, choices made). The first `alike` entries
    of each table are the same in every branch."""

    plot: Plot
    sides: np.ndarray
    alike: Mapping[str, int] = field(default_factory=dict)

    @property
    def count(self) -> int:
        return len(self.sides)

    def taken(self, which: np.ndarray) -> Branches:
        """Some of the branches, in any order and any number of times each: (v,)."""
        branches = Branches(Plot(self.plot.facts), self.sides[which], self.alike)
        for name in _TABLES:
            setattr(branches.plot, name, self._table(name, which))
        if branches.count == 1:  # with one branch left all is alike that has been drawn
            for name in _TABLES:
                setattr(branches.plot, name, branches._table(name, 0))
            branches.alike = {name: len(getattr(branches.plot, name)) for name in _TABLES if name != "near"}
        return branches

    def _table(self, name: str, which: np.ndarray | int) -> dict[object, Value]:
        """A table of the plot with some of the branches; only its last entries may be another in each of them."""
        table: dict[object, Value] = dict(getattr(self.plot, name))
        for key in [*islice(reversed(table), len(table) - self.alike.get(name, 0))]:
            if isinstance(value := table[key], np.ndarray) and value.ndim:
                table[key] = value[which]
        return table


@filled
class GroupFitter:
    """Fits the groups of a mechanism, whatever has been drawn of it."""

    structure: Topology

    def fitted(self, here: Branches, step: Fit, fit: Callable[[Plot], None], spare: float) -> Branches:
        """Each branch with every assembly of the group that fits; where none fits, how the last ones tried miss.
        `spare`: squared distance that points drawn later may make good [m²], where another assembly of this group may
        lead to better ones."""
        # the group's unknowns as the sketch, and what is drawn, show them: (n, w); nan where they do not
        angles = {base: self._angle(here.plot, base) for base in step.angles}
        values = [*angles.values(), *(self._displacement(here.plot, slide, angles) for slide in step.slides)]
        sketched = np.array([np.broadcast_to(np.nan if value is None else value, here.count) for value in values])
        there = here.taken(np.arange(here.count))
        x, fits = _fitted_from(there, step, np.nan_to_num(sketched), fit)
        sine = np.nan_to_num(np.broadcast_to(there.plot.sines["position", step.name], here.count))
        near = self._distance(x - sketched, step) < NEAR * sine
        sure = fits & near & (spare < (OTHERS * sine * self._size(step)) ** 2)
        if sure.all():
            return there
        parents, tables = [np.flatnonzero(sure)], [x[:, sure]]
        unsure = np.flatnonzero(~sure)
        for k in range(0, len(unsure), AT_ONCE):
            parent = np.repeat(unsure[k : k + AT_ONCE], STARTS)
            there = here.taken(parent)
            x, fits = _fitted_from(there, step, self._starts(sketched[:, parent], step), fit)
            kept = self._different(parent[fits], x[:, fits], step)
            parents.append(parent[fits][kept])
            tables.append(x[:, fits][:, kept])
        parent = np.concatenate(parents)
        if not parent.size:
            return there
        order = np.argsort(parent, kind="stable")
        there = here.taken(parent[order])
        _fitted_from(there, step, np.hstack(tables)[:, order], fit)
        return there

    def _starts(self, seen: np.ndarray, step: Fit) -> np.ndarray:
        """Starts (n, w) about what the sketch shows, closely or widely; the first of each branch right there."""
        rng = np.random.default_rng(20)
        spread = rng.uniform(-1, 1, seen.shape)
        turned = np.array([[True]] * len(step.angles) + [[False]] * len(step.slides))
        near = rng.choice((0.03, 0.3, 1.0), seen.shape)
        x = np.where(
            turned,
            np.nan_to_num(seen) + np.pi * spread * np.where(np.isnan(seen), 1.0, near),
            np.where(np.isnan(seen), 1.5 * self._reach() * spread, seen + self._reach() * near * spread),
        )
        x[:, ::STARTS] = np.nan_to_num(seen[:, ::STARTS])
        return np.asarray(x)

    def _distance(self, apart: np.ndarray, step: Fit) -> np.ndarray:
        """The largest of some differences of unknowns (n, w), angles modulo a turn [rad, group's size]: (w,)."""
        turned = len(step.angles)
        with np.errstate(invalid="ignore"):
            angles = np.abs(np.angle(np.exp(1j * apart[:turned])))
        return np.asarray(np.max(np.vstack([angles, np.abs(apart[turned:]) / self._size(step)]), axis=0))

    def _different(self, parent: np.ndarray, x: np.ndarray, step: Fit) -> np.ndarray:
        """The first of each assembly (n, w) of each branch (w,), in the order found."""
        left, kept = np.arange(parent.size), list[int]()
        while left.size:
            branch, first = np.unique(parent[left], return_index=True)
            heads = left[first]
            kept += heads.tolist()
            head = heads[np.searchsorted(branch, parent[left])]
            left = left[self._distance(x[:, left] - x[:, head], step) >= SAME]
        return np.array(sorted(kept), dtype=int)

    def _angle(self, plot: Plot, base: str) -> Real | None:
        """The angle of a base link by two points of one of its group whose places are seen."""
        for body in plot.facts.groups.get(base, ()):
            shape = self.structure.shapes[body]
            seen = ((point, self._place(plot, point)) for point in self.structure.bodies[body])
            places: dict[str, Value] = {point: place for point, place in seen if place is not None}
            if len(places) < 2:
                continue
            near = next(iter(places))
            far = max(places, key=lambda point: abs(shape[point] - shape[near]))
            if (arm := shape[far] - shape[near]) != 0:
                return np.angle((places[far] - places[near]) / arm) - plot.facts.relative_angle(body)
        return None

    def _displacement(self, plot: Plot, slide: str, angles: Mapping[str, Real | None]) -> Real | None:
        """The displacement of a slide whose line and point are seen."""
        guide, origin, direction = plot.facts.lines[slide]
        base = self.structure.base(guide)
        angle = plot.theta[base] if base in plot.theta else angles.get(base)
        ends = self._place(plot, origin), self._place(plot, self.structure.slides[slide].point)
        if angle is None or ends[0] is None or ends[1] is None:
            return None
        return dot(direction * np.exp(1j * (angle + plot.facts.relative_angle(guide))), ends[1] - ends[0])

    def _place(self, plot: Plot, point: str) -> Value | None:
        """The place where a point is drawn, else where the sketch has it."""
        return plot.position.get(point, self.structure.mechanism.sketch.get(point))

    def _size(self, step: Fit) -> float:
        """The longest arm of a group [m]."""
        arms = [part for closure in step.closures for part in closure.parts if isinstance(part, Arm)]
        shapes = self.structure.shapes
        return max((abs(shapes[a.link][a.head] - shapes[a.link][a.tail]) for a in arms), default=0.0) or self._reach()

    def _reach(self) -> float:
        """The extent of the sketched and the fixed points [m]."""
        mechanism = self.structure.mechanism
        places = [*mechanism.sketch.values(), *mechanism.links[FRAME].points.values()]
        return max((abs(a - places[0]) for a in places), default=0.0) or 1.0


def _fitted_from(
    here: Branches, step: Fit, x: np.ndarray, fit: Callable[[Plot], None]
) -> tuple[np.ndarray, np.ndarray]:
    """Fit each branch from its start (n, w), in place: the unknowns (n, w), and which fit (w,)."""
    plot = here.plot
    plot.near = {**plot.near, **dict(zip(unknowns_of(step), x, strict=True))}
    fit(plot)
    values = [*(plot.theta[base] for base in step.angles), *(plot.s[slide] for slide in step.slides)]
    table = np.array([np.broadcast_to(value, here.count) for value in values])
    return table, np.isfinite(table).all(axis=0)
