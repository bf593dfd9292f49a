"""A figure of a linkage true to scale in the middle of its room, its caption under it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property

from graphkin.linkages.linkage import LinkagePosition
from graphkin.sheet.labels import Room, settle
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.linkage_figure import values
from graphkin.sheet.marks import Mark, Text
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import BODY
from graphkin.sheet.scales import finest
from graphkin.sheet.titleblock import broken
from graphkin.sheet.window import Figure, Window
from graphkin.value import frozen

_LETTERS = 6.5
"""What labels need around a figure [mm]."""
_TRIAL = 80.0
"""Size of a figure when it is drawn to see how far its signs reach [mm]."""
_LEADING = 1.35


@frozen
class Panel:
    """One figure.

    positions   what it shows; draw: how, through a window
    caption     what stands under it, broken into lines; foot: the room for it [mm]
    """

    positions: tuple[LinkagePosition, ...]
    draw: Callable[[Window], Figure]
    caption: tuple[str, ...]
    foot: float

    @cached_property
    def _corners(self) -> tuple[complex, complex]:
        places = values(self.positions)
        low = complex(min(z.real for z in places), min(z.imag for z in places))
        return low, complex(max(z.real for z in places), max(z.imag for z in places))

    @cached_property
    def _reach(self) -> Room:
        """How far signs go beyond the points on each side [mm]."""
        low, high = self._corners
        scale = finest(high - low, complex(_TRIAL, _TRIAL))
        left, top, right, bottom = bounds(self.draw(Window(0j, scale)).marks)
        return Room(
            max(0.0, low.real / scale - left) + _LETTERS, max(0.0, -high.imag / scale - top) + _LETTERS,
            max(0.0, right - high.real / scale) + _LETTERS, max(0.0, bottom + low.imag / scale) + _LETTERS,
        )  # fmt: skip

    def scale(self, cell: Room) -> float:
        """The finest at which it fits a room [m/mm]."""
        (low, high), reach = self._corners, self._reach
        wide = cell.right - cell.left - reach.left - reach.right
        tall = cell.bottom - cell.top - reach.top - reach.bottom - self.foot
        return finest(high - low, complex(max(wide, 1.0), max(tall, 1.0)))

    def window(self, cell: Room, scale: float) -> Window:
        """The figure in the middle of its room."""
        (low, high), reach = self._corners, self._reach
        size = (high - low) / scale
        x = (cell.left + cell.right - size.real - reach.left - reach.right) / 2 + reach.left
        y = (cell.top + cell.bottom - self.foot - size.imag - reach.top - reach.bottom) / 2 + reach.top + size.imag
        return Window(complex(x, y) - low.conjugate() / scale, scale)

    def drawn(self, cell: Room, scale: float) -> list[Mark]:
        """Figure, labels and caption."""
        figure = self.draw(self.window(cell, scale))
        inner = Room(cell.left + 1, cell.top + 1, cell.right - 1, cell.bottom - self.foot)
        settled = settle(figure.wanted, figure.marks, inner)
        if settled.clashes:
            settled = settle(figure.wanted, figure.marks, inner, far=True)
        return [*figure.marks, *settled.marks, *self._captioned(cell)]

    def _captioned(self, cell: Room) -> Iterator[Mark]:
        """Lines in the middle under the figure."""
        pen = cell.bottom - self.foot + 5.0
        for text in self.caption:
            for line in broken(text, BODY, cell.right - cell.left - 6):
                label = plain(line)
                yield Text(label, complex((cell.left + cell.right - width(label, BODY)) / 2, pen), BODY)
                pen += _LEADING * BODY
