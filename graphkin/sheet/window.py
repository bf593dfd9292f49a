"""From SI to paper: the window through which a figure is seen, the room it wants, and its scale there."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import field, replace
from itertools import product

import numpy as np

from graphkin.base.rooms import Room, corners
from graphkin.base.scales import finest
from graphkin.base.value import filled, frozen
from graphkin.construction import Plane
from graphkin.sheet.label_requests import LabelRequest, lettering
from graphkin.sheet.marks import Mark, Place, PointMark
from graphkin.sheet.obstacles import bounds, places

Entry = Mark | LabelRequest
PLANES: tuple[Plane, ...] = ("position", "velocity", "acceleration")


@frozen
class Window:
    """A plane on paper: its origin [mm, y down] and its scale [SI unit per mm]. The one place where y turns. times: the
    finished drawing is enlarged so many times."""

    origin: Place
    scale: float
    times: float = 1.0

    def __call__(self, value: complex) -> Place:
        return self.origin + complex(value).conjugate() / self.scale

    @property
    def printed(self) -> float:
        """The scale of the finished drawing."""
        return self.scale / self.times

    def value(self, place: Place) -> complex:
        """The value that is drawn at a place [SI]."""
        return ((place - self.origin) * self.scale).conjugate()

    def magnified(self, part: Place, shown: Place, times: float) -> Window:
        """The window through which what lies at one place of the paper is seen at another, so many times as large."""
        return Window(shown + (self.origin - part) * times, self.scale / times, self.times)

    @staticmethod
    def turned(direction: complex) -> complex:
        """A direction of the plane, on paper."""
        return complex(direction).conjugate()


@filled
class Figure:
    """A figure on paper: marks in the order of painting, and labels that want a place."""

    marks: list[Mark] = field(default_factory=list)
    wanted: list[LabelRequest] = field(default_factory=list)

    @classmethod
    def of(cls, entries: Iterable[Entry]) -> Figure:
        """Marks and labels in any order."""
        every = [*entries]
        marks = [entry for entry in every if not isinstance(entry, LabelRequest)]
        return cls(marks, [entry for entry in every if isinstance(entry, LabelRequest)])

    @property
    def pole(self) -> set[int]:
        """The numbers of the labels at its pole."""
        at = {mark.at for mark in self.marks if isinstance(mark, PointMark) and mark.of == "pole"}
        return {k for k, want in enumerate(self.wanted) if want.start in at and not want.of}

    def __add__(self, other: Figure) -> Figure:
        """The other painted over this one."""
        return Figure(self.marks + other.marks, self.wanted + other.wanted)

    def numbered(self, step: int | None) -> Figure:
        """All of it in one step of the construction, or in none."""
        return Figure([replace(mark, step=step) for mark in self.marks], [replace(w, step=step) for w in self.wanted])


_TRIAL, _WALL = 100.0, 2000.0
"""Size of a figure when it is drawn to see how far its signs reach; larger than a wall none is tried [mm]."""
_LETTERS = 6.5  # room for labels around a figure [mm]
CLOSE = 1 + 1e-9  # a figure that is too large by rounding alone still fits
Stairs = tuple[tuple[tuple[int, int], tuple[tuple[float, float], ...]], ...]
_STEPS = (0.0, 0.25, 0.5, 0.75, 1.1)  # so much of a figure's width lies over or under a block, not beside it


@frozen
class Extent:
    """The extent of a figure: its places in SI units, and the reach of signs and labels beyond them [mm].

    low, high  lower left and upper right corner of its places
    left, top, right, bottom  the reaches
    given   its scale where the file gives one; least: no finer one is chosen
    labels  their number; lettering: the room that they take [mm^2]
    stairs  how its outline goes down to each corner
    blocks  of what stands in corners beside it: the sizes of all its shapes [mm], and True where it is for the foot
    """

    low: complex
    high: complex
    left: float
    top: float
    right: float
    bottom: float
    given: float | None = None
    labels: int = 10
    lettering: float = 0.0
    stairs: Stairs = ()
    blocks: tuple[tuple[tuple[complex, ...], bool], ...] = ()
    least: float = 0.0

    @classmethod
    def of(
        cls, points: Sequence[complex], draw: Callable[[Window], Figure], given: float | None = None,
        letters: float = _LETTERS,
    ) -> Extent:  # fmt: skip
        """Drawn once to see how far it reaches, at its scale or as large as a trial; letters: room about it [mm]."""
        low, high = corners(points)
        window = trial_window(points, given)
        figure, scale = draw(window), window.scale
        left, top, right, bottom = bounds(figure.marks)
        return cls(
            low, high, max(0.0, low.real / scale - left) + letters, max(0.0, -high.imag / scale - top) + letters,
            max(0.0, right - high.real / scale) + letters, max(0.0, bottom + low.imag / scale) + letters,
            given, len(figure.wanted), lettering(figure.wanted), _stairs(figure.marks, low, high, scale),
        )  # fmt: skip

    @property
    def size(self) -> complex:
        """Of its places, in SI units."""
        return self.high - self.low

    @property
    def longest(self) -> float:
        """The larger side of its places, in SI units."""
        return max(self.size.real, self.size.imag)

    @property
    def reach(self) -> complex:
        return complex(self.left + self.right, self.top + self.bottom)

    def reduced(self, times: float) -> Extent:
        """On a paper so many times smaller: its places are drawn smaller, its signs are not."""
        return replace(self, low=self.low / times, high=self.high / times)

    def scale(self, room: Room) -> float:
        """The given scale where it fits one room at that, else the finest at which it does."""
        inner = room.size - self.reach
        whole = self.size / (self.given or 1.0)
        if self.given and whole.real <= inner.real * CLOSE and whole.imag <= inner.imag * CLOSE:
            return self.given
        return finest(self.size, complex(max(inner.real, 1.0), max(inner.imag, 1.0)))

    def cut_out(self, scale: float) -> Room:
        """The whole of it on a paper cut to it."""
        whole = self.size / scale + self.reach
        return Room(0.0, 0.0, whole.real, whole.imag)

    def window(self, room: Room, scale: float) -> Window:
        """The window through which it is in the middle of a room with all its signs."""
        spare = (room.size - self.size / scale - self.reach) / 2
        return self.at(complex(room.left + self.left, room.top + self.top) + spare, scale)

    def at(self, corner: Place, scale: float, times: float = 1.0) -> Window:
        """The window through which the upper left corner of its places is there; times: as it is reduced."""
        return Window(corner - complex(self.low.real, -self.high.imag) / scale, scale * times, times)


def trial_window(points: Sequence[complex], given: float | None = None) -> Window:
    """The window through which places are seen to learn how they lie, at a given scale or as large as a trial [mm]."""
    low, high = corners(points)
    trial = finest(high - low, complex(_TRIAL, _TRIAL))
    return Window(0j, given if given and given > trial * _TRIAL / _WALL else trial)


def _stairs(marks: Sequence[Mark], low: complex, high: complex, scale: float) -> Stairs:
    """For each corner (0 left or above, 1 right or below), and each part of the width next to it: where what is farther
    begins across, and what is in that part, down, as parts of the whole; infinite where there is nothing."""
    (x, y), _ = places(marks)
    size = [max(side / scale, 1e-9) for side in ((high - low).real, (high - low).imag)]
    whole = ((x - low.real / scale) / size[0], (y + high.imag / scale) / size[1])
    whole = np.round(np.clip(whole, 0, 1), 9)  # what lies on a step lies there, whatever rounding says
    stairs = list[tuple[tuple[int, int], tuple[tuple[float, float], ...]]]()
    for corner in product((0, 1), (0, 1)):
        across, down = (1 - part if side else part for side, part in zip(corner, whole, strict=True))
        parts = [(across[across >= step], down[across < step]) for step in _STEPS]
        stairs.append((corner, tuple((float(x.min(initial=np.inf)), float(y.min(initial=np.inf))) for x, y in parts)))
    return tuple(stairs)
