"""Figures in cells of the paper, each in the middle of its own with a caption under it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.sheet.fit import Extent
from graphkin.sheet.formula import formula
from graphkin.sheet.lettering import width
from graphkin.sheet.marks import Text
from graphkin.sheet.page import Panel
from graphkin.sheet.paper import BODY, Room
from graphkin.sheet.titleblock import broken
from graphkin.sheet.window import Figure, Window


@frozen
class Caption:
    """Lines in the middle under a figure.

    height  of the room for them; first: from its top to the first base line; pitch: from line to line
    sides   what stays free beside them [mm]
    """

    texts: tuple[str, ...]
    height: float
    first: float = 5.0
    pitch: float = 1.35 * BODY
    sides: float = 3.0

    def drawn(self, cell: Room) -> Iterator[Text]:
        pen = cell.bottom - self.height + self.first
        for text in self.texts:
            for line in broken(text, BODY, cell.size.real - 2 * self.sides):
                label = formula(line)
                yield Text(label, complex((cell.left + cell.right - width(label, BODY)) / 2, pen), BODY)
                pen += self.pitch


@frozen
class Picture:
    """A figure that wants a cell: how large it is, how it is drawn through a window, what is said under it."""

    extent: Extent
    draw: Callable[[Window], Figure]
    caption: Caption

    def captioned(self, start: str) -> Picture:
        """With a word before what is said under it."""
        first, *others = self.caption.texts
        return replace(self, caption=replace(self.caption, texts=(start + first, *others)))

    def scale(self, cell: Room) -> float:
        """At which it fits a cell [m/mm]."""
        return self.extent.scale(self._over(cell))

    def panel(self, cell: Room, scale: float) -> Panel:
        """On paper."""
        window = self.extent.window(self._over(cell), scale)
        room = cell.inset(1, 1, self.caption.height)
        return Panel(self.draw(window), window, room, after=tuple(self.caption.drawn(cell)))

    def _over(self, cell: Room) -> Room:
        """What the caption leaves of a cell."""
        return cell.inset(0, 0, self.caption.height)
