"""From SI to paper: the window through which a figure is seen, the room it wants, and its scale there."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Sequence
from dataclasses import field, replace

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import filled, frozen
from graphkin.construction import Construction, Plane
from graphkin.planning import Method
from graphkin.sheet.label_requests import LabelRequest, lettering
from graphkin.sheet.marks import Mark, Place
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import Room, Rooms, finest, finest_each

Entry = Mark | LabelRequest
PLANES: tuple[Plane, ...] = ("position", "velocity", "acceleration")


@frozen
class Window:
    """A plane on paper: its origin [mm, y down] and its scale [SI unit per mm]. The one place where y turns.

    times  the finished drawing is enlarged so many times
    """

    origin: Place
    scale: float
    times: float = 1.0

    def __call__(self, value: complex) -> Place:
        return self.origin + complex(value).conjugate() / self.scale

    @property
    def printed(self) -> float:
        """The scale of the finished drawing."""
        return self.scale / self.times

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
        figure = cls()
        for entry in entries:
            if isinstance(entry, LabelRequest):
                figure.wanted.append(entry)
            else:
                figure.marks.append(entry)
        return figure

    def __add__(self, other: Figure) -> Figure:
        """The other painted over this one."""
        return Figure(self.marks + other.marks, self.wanted + other.wanted)

    def numbered(self, step: int | None) -> Figure:
        """All of it in one step of the construction, or in none."""
        return Figure([replace(mark, step=step) for mark in self.marks], [replace(w, step=step) for w in self.wanted])


def constructions(method: Method) -> dict[Plane, Construction]:
    """The three constructions of a method, by plane."""
    return {"position": method.position, "velocity": method.velocity, "acceleration": method.acceleration}


_TRIAL = 100.0  # size of a figure when it is drawn to see how far its signs reach [mm]
_LETTERS = 6.5  # room for labels around a figure [mm]
_LEAST = 5.0  # points in less room than this are no figure [mm]
_CLOSE = 1 + 1e-9  # a figure that is too large by rounding alone still fits

@frozen
class Extent:
    """The extent of a figure: its places in SI units, and the reach of signs and labels beyond them [mm].

    low, high  lower left and upper right corner of its places
    left, top, right, bottom  the reaches
    given   its scale where the file gives one
    labels  their number; lettering: the room that they take [mm^2]
    beside  the sizes of its equations and its detail, over it and on its left, in each of their shapes [mm]
    tables  the sizes in which its tables may stand under it [mm]
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
    beside: tuple[tuple[complex, complex], ...] = ()
    tables: tuple[complex, ...] = ()

    @classmethod
    def of(
        cls, places: Sequence[complex], draw: Callable[[Window], Figure], given: float | None = None,
        letters: float = _LETTERS, trial: float = _TRIAL,
    ) -> Extent:  # fmt: skip
        """Drawn once to see how far it reaches, at a given scale or as large as a trial is [mm].

        letters  what labels need around it [mm]
        """
        low, high = corners(places)
        scale = given or finest(high - low, complex(trial, trial))
        figure = draw(Window(0j, scale))
        left, top, right, bottom = bounds(figure.marks)
        return cls(
            low, high, max(0.0, low.real / scale - left) + letters, max(0.0, -high.imag / scale - top) + letters,
            max(0.0, right - high.real / scale) + letters, max(0.0, bottom + low.imag / scale) + letters,
            given, len(figure.wanted), lettering(figure.wanted),
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
        return self.given if self.given is not None and self.fits(self.given, room) else self.finest(room)

    def fits(self, scale: float, room: Room) -> bool:
        whole, inner = self.size / scale, room.size - self.reach
        return whole.real <= inner.real * _CLOSE and whole.imag <= inner.imag * _CLOSE

    def finest(self, room: Room) -> float:
        """The finest scale of the series at which it fits one room."""
        inner = room.size - self.reach
        return finest(self.size, complex(max(inner.real, 1.0), max(inner.imag, 1.0)))

    def scales_in(self, room: Rooms) -> Array:
        """The scale at which it fits each of many rooms, the given one if any; NaN where it does not fit."""
        wide, high = room.right - room.left - self.reach.real, room.bottom - room.top - self.reach.imag
        fits = (wide > _LEAST) & (high > _LEAST)
        if self.given is None:
            least = np.maximum(self.size.real / np.maximum(wide, _LEAST), self.size.imag / np.maximum(high, _LEAST))
            return np.where(fits, finest_each(least), np.nan)
        whole = self.size / self.given
        return np.where(fits & (whole.real <= wide) & (whole.imag <= high), self.given, np.nan)

    def window(self, room: Room, scale: float, times: float = 1.0) -> Window:
        """The window through which it is in the middle of a room with all its signs; times: as it is reduced."""
        whole = self.size / scale + self.reach
        x = (room.left + room.right - whole.real) / 2 + self.left
        y = (room.top + room.bottom - whole.imag) / 2 + self.top + self.size.imag / scale
        return Window(complex(x, y) - self.low.conjugate() / scale, scale * times, times)


def cut_out(draw: Callable[[Window], Figure], scale: float, margin: float) -> tuple[Window, Room]:
    """The window through which a figure fills a paper cut to its size, with a margin [mm]; and the whole of it."""
    left, top, right, bottom = bounds(draw(Window(0j, scale)).marks)
    whole = Room(0.0, 0.0, right - left + 2 * margin, bottom - top + 2 * margin)
    return Window(complex(margin - left, margin - top), scale), whole


def magnified(window: Window, part: Place, shown: Place, times: float) -> Window:
    """The window through which what lies at one place of the paper is seen at another, so many times as large."""
    return Window(shown + (window.origin - part) * times, window.scale / times, window.times)


def corners(places: Sequence[complex]) -> tuple[complex, complex]:
    """Lower left and upper right corner of what holds all these places."""
    xs, ys = [v.real for v in places] or [0.0], [v.imag for v in places] or [0.0]
    return complex(min(xs), min(ys)), complex(max(xs), max(ys))


def enlarged(places: Sequence[complex], more: Iterable[complex], factor: float) -> list[complex]:
    """The places, and of more, in their order, those that leave the figure at most `factor` times as large."""
    every, (low, high) = list(places), corners(places)
    most = factor * (abs(high - low) or 1.0)
    for place in more:
        low, high = corners([*every, place])
        if cmath.isfinite(place) and abs(high - low) <= most:
            every.append(place)
    return every
