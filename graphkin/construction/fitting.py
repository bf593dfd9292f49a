"""Links tried until they fit: positions that no ruler and compass gives, found by Newton's method."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from copy import copy

import numpy as np

from graphkin.base.geometry import Real, Value
from graphkin.construction.kinds import Closure, Fit
from graphkin.construction.linear import in_step, least, sense, solved, unknowns_of
from graphkin.construction.plot import Plot, length, slide_key
from graphkin.construction.terms import Arm

ROUNDS = 30
FITTED = 1e-8  # the last step at most [rad, of the group's size]; what it leaves is of the order of its square
ROUNDING, ROUNDED = 1e-5, 0.8
"""Steps so short that become no shorter than by this factor come of rounding: the links are all but free to move."""
GAP = 1e-10  # the gap that is left at most, in units of the group's size
Entry = tuple[int, int, Value]  # row, column and value of an entry of a matrix
Sliding = tuple[int, int, int | None, Value]
"""Closure, displacement, the base link that turns its line, None where that is known, and the line's direction."""


def fit(step: Fit, plot: Plot, rounds: int = ROUNDS) -> None:
    """Newton's method on the closures and contacts of a group, for all positions at once, and for the others alone as
    soon as most of them fit."""
    gaps, before = Gaps(step, plot, reach(step, plot)), np.inf
    x = np.empty((*gaps.shape, len(step.angles) + len(step.slides)))
    for k, name in enumerate(unknowns_of(step)):
        x[..., k] = plot.near[name]
    some = gaps
    left: tuple[np.ndarray, ...] | None = None  # the positions that do not fit yet, if not all
    for _ in range(rounds):
        gap, slope = some.at(x if left is None else x[left])
        change = solved(slope, gap)
        moved = np.abs(change).max(axis=-1)  # the whole step in units; half a unit at most is gone
        way = change * gaps.units / np.maximum(1.0, moved / 0.5)[..., None]
        x[... if left is None else left] -= way
        farthest = np.max(moved, where=np.isfinite(moved), initial=0.0)
        if farthest <= FITTED or ROUNDED * before < farthest < ROUNDING:
            break
        before, going = farthest, moved > FITTED
        if 2 * going.sum() < going.size:
            places = np.argwhere(going) if left is None else np.transpose(left)[going]
            left = tuple(places.T)
            some = gaps.of(left)
    # the positions at which the group closes; NaN at the others, and by how much it misses there
    gap, slope = gaps.at(x)
    widest = np.abs(gap).max(axis=-1)
    fits = widest < GAP
    settle_all(step, plot, np.moveaxis(np.where(fits[..., None], x, np.nan), -1, 0))
    plot.senses[step.name] = sense(slope)
    plot.sines["position", step.name] = np.where(fits, least(slope), np.nan)[()]
    plot.misses[step.name] = np.where(fits, 0.0, widest * gaps.size)[()]


def reach(step: Fit, plot: Plot) -> float:
    """The longest arm of a group, by which its gaps are measured [m]."""
    shapes = plot.facts.shapes
    parts = (part for closure in step.closures for part in closure.parts if isinstance(part, Arm))
    arms = [shapes[arm.link][arm.head] - shapes[arm.link][arm.tail] for arm in parts]
    radii = [radius for contact in step.contacts for _, radius in contact.angles]
    return max((float(np.max(length(arm))) for arm in (*arms, *radii)), default=0.0) or 1.0


def sense_and_sine(step: Fit, plot: Plot) -> tuple[Real, Real]:
    """The side of its change points on which a group lies in a plot, and the sine at which its links fit."""
    values = (*(plot.theta[base] for base in step.angles), *(plot.s[slide] for slide in step.slides))
    gaps = Gaps(step, plot, reach(step, plot))
    x = np.stack(np.broadcast_arrays(*values, np.empty(gaps.shape))[:-1], axis=-1)
    slope = gaps.at(x)[1]
    return sense(slope), least(slope)[()]


def settle_all(step: Fit, plot: Plot, x: Iterable[Value]) -> None:
    """The unknowns, in their order, as angles and displacements of the plot."""
    values = [(value[()] if isinstance(value, np.ndarray) else value).real for value in x]
    for base, value in zip(step.angles, values):
        plot.settle("theta", base, value, counted=True)
    plot.s.update(zip(step.slides, values[len(step.angles) :], strict=True))


# --- gaps of a group --------------------------------------------------------------------------


class Gaps:
    """Gaps of closures and contacts, in units of the group's size; unknowns: angles first, then displacements.

    A closure is known + sum of arm * e^(i angle) + sum of displacement * direction * e^(i angle): all that is known is
    worked out once.
    """

    def __init__(self, step: Fit, plot: Plot, size: float) -> None:
        self.plot, self.size = plot, size
        self.bases = {base: k for k, base in enumerate(step.angles)}
        self.slides = {slide: k for k, slide in enumerate(step.slides)}
        self.units = np.array([1.0] * len(self.bases) + [size] * len(self.slides))
        self.sliding: list[Sliding] = []
        self.turning: list[Entry] = []
        known = [(0, k, self._closed(k, closure)) for k, closure in enumerate(step.closures)]
        self.known = _filled((1, len(known)), known)[..., 0, :] / size
        self.arms = _filled((len(self.bases), len(known)), self.turning) / size
        self.rolled: tuple[np.ndarray, np.ndarray] | None = None  # what is known of contacts, and what unknowns add
        if step.contacts:
            names = [*self.bases, *map(slide_key, self.slides)]
            rows = [in_step(contact, plot, "position", {*self.bases}, {*self.slides}) for contact in step.contacts]
            entries = [(k, names.index(name), value) for k, (_, of) in enumerate(rows) for name, value in of.items()]
            by_each = _filled((len(rows), len(names)), entries).real
            first = _filled((1, len(rows)), [(0, k, value) for k, (value, _) in enumerate(rows)]).real[..., 0, :]
            self.rolled = first, by_each

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the positions; where nothing differs so far but the group's own links or lines, over these."""
        tables = (self.plot.position, self.plot.theta, self.plot.s, self.plot.near)
        shapes = {value.shape for table in tables for value in table.values() if isinstance(value, np.ndarray)}
        rolled = () if self.rolled is None else (self.rolled[0].shape[:-1], self.rolled[1].shape[:-2])
        lines = (np.shape(direction) for *_, direction in self.sliding)
        return np.broadcast_shapes(self.known.shape[:-1], self.arms.shape[:-2], *rolled, *lines, *shapes)

    def of(self, some: tuple[np.ndarray, ...]) -> Gaps:
        """The gaps at some of the positions alone, by their numbers along each axis."""
        shape = self.shape

        def taken(values: Value, own: int) -> np.ndarray:
            """Of values whose last `own` axes are not of positions."""
            inner = np.shape(values)[np.ndim(values) - own :]
            return np.asarray(np.broadcast_to(values, (*shape, *inner))[some])

        found = copy(self)
        found.known, found.arms = taken(self.known, 1), taken(self.arms, 2)
        found.sliding = [(closure, slide, base, taken(line, 0)) for closure, slide, base, line in self.sliding]
        if self.rolled is not None:
            found.rolled = taken(self.rolled[0], 1), taken(self.rolled[1], 2)
        return found

    def at(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Gaps (.., m) and their slopes by each unknown in its unit (.., m, n), for unknowns x (.., n).

        Closures along x and y by turns, as complex numbers lie in memory; then contacts.
        """
        angles = len(self.bases)
        turned = np.exp(1j * x[..., :angles])
        arrows = self.arms * turned[..., None]
        slope = np.zeros((*x.shape, self.known.shape[-1]), dtype=complex)
        straight = np.zeros((*x.shape[:-1], self.known.shape[-1]), dtype=complex)
        for closure, slide, base, direction in self.sliding:
            line = direction if base is None else direction * turned[..., base]
            slope[..., angles + slide, closure] = line
            into = straight if base is None else arrows[..., base, :]
            into[..., closure] += x[..., angles + slide] / self.size * line
        np.multiply(arrows, 1j, out=slope[..., :angles, :])
        gap = self.known + straight + arrows.sum(axis=-2)
        gaps, slopes = gap.view(float), slope.view(float).swapaxes(-1, -2)
        if self.rolled is None:
            return gaps, slopes
        known, by_each = self.rolled  # contacts are linear as they are
        gap = (known + (by_each * x[..., None, :]).sum(axis=-1)) / self.size
        slope = np.broadcast_to(by_each * (self.units / self.size), (*x.shape[:-1], *by_each.shape[-2:]))
        return np.concatenate([gaps, gap], axis=-1), np.concatenate([slopes, slope], axis=-2)

    def _closed(self, number: int, closure: Closure) -> Value:
        """Enters the parts of a closure that an unknown turns or pushes; gives the sum of the others [m]."""
        position = self.plot.position
        known = 0j if closure.floats else position[closure.start] - position[closure.end]
        for part in closure.parts:
            if isinstance(part, Arm):
                shape = self.plot.facts.shapes[part.link]
                known = known + self._turned(number, part.link, shape[part.head] - shape[part.tail])
                continue
            guide, _, direction = self.plot.facts.lines[part.slide]
            slide, line = self.slides.get(part.slide), part.sign * direction
            if slide is None:
                known = known + self._turned(number, guide, self.plot.s[part.slide] * line)
            else:
                base = self.bases.get(self.plot.facts.turns[guide].base)
                angle = self.plot.theta[guide] if base is None else self.plot.facts.relative_angle(guide)
                self.sliding.append((number, slide, base, line * np.exp(1j * angle)))
        return known

    def _turned(self, number: int, link: str, arm: Value) -> Value:
        """An arm that an unknown turns is entered with 0 left; else as it lies."""
        facts = self.plot.facts
        base = self.bases.get(facts.turns[link].base)
        if base is None:
            return arm * np.exp(1j * self.plot.theta[link])
        self.turning.append((base, number, arm * np.exp(1j * facts.relative_angle(link))))
        return 0.0


def _filled(size: tuple[int, int], entries: Sequence[Entry]) -> np.ndarray:
    """Entries added up, over the positions of those that are not the same at all."""
    shape = np.broadcast_shapes(*(np.shape(value) for *_, value in entries))
    matrix = np.zeros((*shape, *size), dtype=complex)
    for row, column, value in entries:
        matrix[..., row, column] += value
    return matrix
