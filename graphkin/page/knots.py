"""The knots of a page: so many along each driver that what is drawn between them is near enough.

Of one driver more knots are taken where a position halfway is not drawn as it should be; of several, along all of one.
Between knots there are Lagrange's polynomials through eight of them, or as many as are in a row, as in `tracks.js`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from itertools import product

import numpy as np

from graphkin.base.value import bulky, frozen
from graphkin.construction import Plane, Plot
from graphkin.page.figures import PageFigures
from graphkin.page.reach import Reach
from graphkin.page.rows import MarkTrack, rows
from graphkin.page.tracks import OF_GRID
from graphkin.sheet.window import PLANES, Figure

NEAR = 0.007  # what is drawn between knots lies so near to where it belongs [mm]
_EVEN, _SPREAD = 90, 60  # knots of a turn to begin with; positions that tell how large figures are
_OF_ONE, _OF_SEVERAL = 700, 34_000  # knots at most; of several drivers places of points, where the mechanism gets to
_OF_GRID, _TRIED, _FINER, _ORDER = (10, 24), 30, (1.05, 1.8), 1 / 7
"""Knots of a turn to begin with, of three drivers and of two; places at which a grid is tried; so many more then, as
what is off goes with the seventh power of their number."""
_MOST_OF_ALL, _DOUBT = 0.8, 0.01
"""This part of a grid is as near as it should be; where polynomials of fewer knots differ by more [mm], as at its rim
where dead points are, the middle of a cell is looked at, and the cell is not shown if that is not near."""
_HALVED = 5  # so often a cell is halved at most
_BESIDE_END = 0.3  # knots are not nearer to each other [of their distance]
Places = tuple[float, ...]
Drawn = dict[Plane, dict[float, Figure]]


@bulky
class PageKnots:
    """The knots along each driver, and what is drawn there: positions (None where the mechanism does not get) of the
    whole grid, the last driver's first; known: figures at places of one driver that are drawn already."""

    reach: Reach
    figures: PageFigures
    axes: tuple[Knots, ...]
    plots: Sequence[Plot | None]
    known: Drawn = field(default_factory=dict)

    def drawn(self, plane: Plane) -> list[Figure]:
        """A plane's figure at each knot, without its letters."""
        if known := self.known.get(plane):
            return [known[float(u)] for u in self.axes[0].u]
        return [self.figures.figure(plane, plot) for plot in self.plots]

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(len(axis.u) for axis in self.axes)

    @cached_property
    def places(self) -> list[Places]:
        return [tuple(map(float, us)) for us in product(*(axis.u for axis in self.axes))]

    @cached_property
    def shown(self) -> dict[Plane, np.ndarray]:
        """By plane True at the knots at which it is drawn."""
        return {plane: np.array([plot is not None and figure.fits(plot) for plot in self.plots])
                for plane, figure in self.figures.motion.items()}  # fmt: skip

    @cached_property
    def _between(self) -> dict[Places, Plot | None]:
        return {}

    def plot(self, us: Sequence[float]) -> Plot | None:
        """The position between knots, which is asked for with each plane."""
        if (at := tuple(us)) not in self._between:
            self._between[at] = self.reach.plot(us)
        return self._between[at]

    def within(self, at: Sequence[int], parts: Sequence[float]) -> list[float]:
        """The place so far on the way through a cell, beside change points."""
        every = enumerate(zip(at, parts, self.axes, strict=True))
        return [float(self.reach.clear(n, [axis.within(k, part)])[0]) for n, (k, part, axis) in every]

    @cached_property
    def names(self) -> dict[Plane, list[str]]:
        """The points of each plane."""
        plot = next(plot for plot in self.plots if plot is not None)
        return {plane: [*plot.points(plane)] for plane in PLANES}

    @cached_property
    def points(self) -> dict[Plane, np.ndarray]:
        """By plane the places of its points at all knots [SI]."""
        return {plane: np.array([[np.nan if plot is None else complex(plot.points(plane)[name]) for name in names]
                                 for plot in self.plots]) for plane, names in self.names.items()}  # fmt: skip


def page_knots(reach: Reach) -> PageKnots:
    """The knots of a method's page."""
    return _of_one(reach) if len(reach.axes) == 1 else _of_several(reach)


def knots_along(reach: Reach, driver: int, count: int) -> Knots:
    """So many knots along a driver, of several one where the drawn position is; none where polygons are 0/0."""
    axis = reach.axes[driver]
    knots = Knots(axis.even(count), axis.span[1] - axis.span[0] if axis.round else 0.0)
    if len(reach.axes) > 1:
        knots = _with_drawn(knots, reach.drawn[driver])
    return Knots(reach.clear(driver, knots.u), knots.period)


def _with_drawn(knots: Knots, u: float) -> Knots:
    """The nearest knot lies where the drawn position is, which is shown whatever is near it; unless an end is."""
    step = float(knots.u[1] - knots.u[0])
    if knots.period:
        return Knots(knots.u + (u - knots.u[0]) % step, knots.period)
    if min(u - knots.u[0], knots.u[-1] - u) > _BESIDE_END * step:
        knots.u[np.clip(np.abs(knots.u - u).argmin(), 1, len(knots.u) - 2)] = u
    return knots


def _figures(reach: Reach, plots: Sequence[Plot | None]) -> PageFigures:
    every = [plot for plot in plots if plot is not None]
    return PageFigures(reach.method, every[:: max(1, len(every) // _SPREAD)])


# --- one driver -------------------------------------------------------------------------------------------------------


def _of_one(reach: Reach) -> PageKnots:
    (axis,) = reach.axes
    count = max(24, round(_EVEN * min(2.0, axis.turns)))
    knots = knots_along(reach, 0, count + (not axis.round))
    plots = {float(u): reach.plot([float(u)]) for u in knots.u}
    figures = _figures(reach, [*plots.values()])
    tried, cells = dict[float, Plot | None](), {*map(float, knots.u)}
    drawn: Drawn = {plane: {} for plane in PLANES}
    for _ in range(_HALVED):
        middles = _middles(reach, knots, cells)
        tried |= {u: reach.plot([u]) for u in middles if u not in tried}
        failed = _failures(figures, knots, plots, {u: tried[u] for u in middles}, drawn)
        if not failed or len(plots) + len(failed) > _OF_ONE:
            break
        before = knots
        plots |= {u: tried[u] for u in failed}
        knots = Knots(np.array(sorted(plots)), knots.period)
        cells = {*failed, *(float(before.u[before.cell(u)]) for u in failed)}
    return PageKnots(reach, figures, (knots,), [plots[float(u)] for u in knots.u], drawn)


def _middles(reach: Reach, knots: Knots, cells: set[float]) -> list[float]:
    """The middle of each cell that begins at one of these knots; none of one so small that it is all at a change."""
    ends = [*knots.u[1:], *([knots.u[0] + knots.period] if knots.period else [])]
    of = [(float(u), float(end)) for u, end in zip(knots.u, ends, strict=False) if float(u) in cells]
    middles = reach.clear(0, [(u + end) / 2 for u, end in of])
    return [float(middle) for middle, (u, end) in zip(middles, of, strict=True) if u < middle < end]


def _failures(
    figures: PageFigures, knots: Knots, plots: Mapping[float, Plot | None], tried: Mapping[float, Plot | None],
    drawn: Drawn,
) -> list[float]:  # fmt: skip
    """The places at which something is not drawn where it belongs; drawn: figures, which are kept there."""
    every = sorted([*plots, *tried])
    is_knot = np.array([u in plots for u in every])
    failed = set[float]()
    for plane in PLANES:
        known = drawn[plane]
        known |= {u: figures.figure(plane, plots[u] if u in plots else tried[u]) for u in every if u not in known}
        frames = [known[u].marks for u in every]
        groups: dict[bytes, list[MarkTrack]] = {}
        for row in (row for row in rows(frames) if row.is_known):
            groups.setdefault(row.there.tobytes(), []).append(row)
        for group in groups.values():
            there, table = group[0].there, np.concatenate([row.numbers for row in group], axis=1)
            held = np.nan_to_num(table[is_knot])
            for k in (k for k, u in enumerate(every) if u in tried and there[k]):
                how = stencil([knots], [every[k]], there[is_knot])
                if how is None or np.abs(how[1] @ held[how[0]] - table[k]).max() > NEAR:
                    failed.add(every[k])
    return sorted(failed)


# --- several drivers --------------------------------------------------------------------------------------------------


def _of_several(reach: Reach) -> PageKnots:
    """A grid, refined along each driver as what is drawn between knots is off, while there is room for more."""
    usual = _OF_GRID[len(reach.axes) == 2] if len(reach.axes) <= 3 else 6
    counts = np.array([max(7, round(usual * min(1.5, axis.turns))) for axis in reach.axes])
    while True:
        axes = tuple(knots_along(reach, k, int(count)) for k, count in enumerate(counts))
        plots = [reach.plot(us) for us in product(*(map(float, axis.u) for axis in axes))]
        knots = PageKnots(reach, _figures(reach, plots), axes, plots)
        off = np.array([_off_along(knots, k) for k in range(len(axes))])
        times = np.clip((off / NEAR) ** _ORDER, *_FINER)
        room = max(1.0, _OF_SEVERAL / sum(map(len, knots.names.values())) / sum(plot is not None for plot in plots))
        times **= min(1.0, float(np.log(room) / np.log(times.prod())))
        finer = np.round(times * counts).astype(int)
        if off.max() <= NEAR or (finer == counts).all():
            return knots
        counts = finer


def _off_along(knots: PageKnots, driver: int) -> float:
    """The distance by which most of what is drawn halfway between knots of one driver is off [mm]."""
    axis, off = knots.axes[driver], list[float]()
    numbers = np.linspace(0, len(knots.plots) - 1, _TRIED).astype(int)
    for number in (int(k) for k in numbers if knots.plots[k] is not None):
        us = list(knots.places[number])
        at = int(np.unravel_index(number, knots.shape)[driver])
        if not axis.period and at == len(axis.u) - 1:
            continue
        us[driver] = float(knots.reach.clear(driver, [axis.within(at, 0.5)])[0])
        plot = knots.reach.plot(us)
        if plot is None:
            continue
        off.append(max(_off(knots, us, plane, plot) for plane in PLANES[1:]))
    return float(np.quantile(off, _MOST_OF_ALL)) if off else 0.0


def _off(knots: PageKnots, us: Sequence[float], plane: Plane, plot: Plot) -> float:
    """The distance by which what is drawn is off [mm], rounding at the knots included."""
    shown = knots.shown[plane]
    how = stencil(knots.axes, us, shown.reshape(knots.shape)) if knots.figures.motion[plane].fits(plot) else None
    if how is None:
        return 0.0
    places = np.array([complex(plot.points(plane)[name]) for name in knots.names[plane]])
    numbers, weights = how
    off = np.abs(weights @ knots.points[plane][numbers] - places).max() / knots.figures.window(plane).scale
    return float(off + np.abs(weights).sum() * OF_GRID)


def cells_shown(knots: PageKnots, plane: Plane) -> np.ndarray:
    """True at the first knot of each cell of a grid in which a plane is shown."""
    shown, last = knots.shown[plane].reshape(knots.shape), [len(axis.u) - 1 for axis in knots.axes]
    cells = np.zeros(knots.shape, dtype=bool)
    for at in np.ndindex(*knots.shape):
        steps = [(k, k + 1) for k in at]
        if all(k < end or axis.period for k, end, axis in zip(at, last, knots.axes, strict=True)):
            corners = np.ix_(*(np.array(step) % len(axis.u) for step, axis in zip(steps, knots.axes, strict=True)))
            cells[at] = shown[corners].all() and _is_near(knots, plane, shown, at)
    return cells.ravel()


def _is_near(knots: PageKnots, plane: Plane, shown: np.ndarray, at: Sequence[int]) -> bool:
    """True of a cell in whose middle, at a rim in its quarters too, what is drawn is near to where it belongs."""
    axes, fits = knots.axes, knots.figures.motion[plane].fits
    around = [[k + n if axis.period else min(max(k + n, 0), len(axis.u) - 1) for n in range(-2, 4)]
              for k, axis in zip(at, axes, strict=True)]  # fmt: skip
    inside = shown[np.ix_(*(np.array(own) % len(axis.u) for own, axis in zip(around, axes, strict=True)))].all()
    parts = [(0.5,) * len(axes), *(() if inside else product((0.25, 0.75), repeat=len(axes)))]
    places = [knots.within(at, own) for own in parts]
    if inside and _is_sure(knots, plane, shown, places[0]):
        return True
    plots = [(us, knots.plot(us)) for us in places]
    there = all(plot is not None and fits(plot) for _, plot in plots)
    return there and all(plot is None or _off(knots, us, plane, plot) <= NEAR for us, plot in plots)


def _is_sure(knots: PageKnots, plane: Plane, shown: np.ndarray, us: Sequence[float]) -> bool:
    """True where polynomials of fewer knots, about the place and aside of it, are nearly the same."""
    every = [each for fewer in range(3) if (each := stencil(knots.axes, us, shown, fewer)) is not None]
    if len({numbers.size for numbers, _ in every}) < 3:  # the same, which says nothing
        return False
    one, *others = (weights @ knots.points[plane][numbers] for numbers, weights in every)
    off = max(np.abs(one - other).max() for other in others) / knots.figures.window(plane).scale
    return bool(off + np.abs(every[0][1]).sum() * OF_GRID <= _DOUBT)


# --- values between knots ---------------------------------------------------------------------------------------------

MOST = 8
Mask = np.ndarray  # True at the knots that count, in the shape of the grid


@frozen
class Knots:
    """Places along one driver, u (n,) growing; period: after which the first comes again, 0 if never."""

    u: np.ndarray
    period: float = 0.0

    def within(self, number: int, part: float) -> float:
        """The place so far on the way from a knot to the next."""
        size = len(self.u)
        following = self.u[(number + 1) % size] + self.period * ((number + 1) // size)
        return float(self.u[number] + part * (following - self.u[number]))

    def cell(self, u: float) -> int:
        """The last knot that is not beyond u."""
        k = int(np.searchsorted(self.u, u, "right")) - 1
        return k if self.period else min(max(k, 0), len(self.u) - 2)

    def windows(self, u: float, count: int) -> Iterator[tuple[int, ...]]:
        """Runs of so many knots with one that is beside a place, the best centred first; counted on beyond the last,
        round and round."""
        middle, size = self.cell(u) - count // 2 + 1, len(self.u)
        for shift in sorted(range(-(count // 2), count // 2 + 1), key=lambda shift: (abs(shift), shift)):
            first = middle + shift
            if self.period or 0 <= first <= size - count:
                yield tuple(range(first, first + count))

    def weights(self, u: float, window: Sequence[int]) -> np.ndarray:
        size = len(self.u)
        at = np.array([self.u[k % size] + self.period * (k // size) for k in window])
        gaps = at[:, None] - at[None, :]
        np.fill_diagonal(gaps, 1.0)
        ahead = np.broadcast_to(u - at, gaps.shape).copy()
        np.fill_diagonal(ahead, 1.0)
        return np.asarray((ahead / gaps).prod(axis=1))


def stencil(
    knots: Sequence[Knots], us: Sequence[float], mask: Mask, fewer: int = 0
) -> tuple[np.ndarray, np.ndarray] | None:
    """The numbers (m,) of the knots that give the value at a place of a grid, and their weights; None: none give it;
    fewer: than usual along each driver."""
    for count in range(MOST - fewer, 0, -2):
        counts = [min(count, len(axis.u)) for axis in knots]
        for windows in product(*(axis.windows(u, few) for axis, u, few in zip(knots, us, counts, strict=True))):
            places = np.ix_(*(np.array(window) % len(axis.u) for axis, window in zip(knots, windows, strict=True)))
            if mask[places].all():
                weights = np.ones(())
                for axis, u, window in zip(knots, us, windows, strict=True):
                    weights = np.multiply.outer(weights, axis.weights(u, window))
                numbers = np.arange(mask.size).reshape(mask.shape)[places]
                return numbers.ravel(), weights.ravel()
    return None
