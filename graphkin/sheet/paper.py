"""Paper, pens and letters: sizes in millimetres, after ISO 216 (paper), ISO 128 (lines), ISO 3098 (lettering)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from graphkin.base.value import frozen


@frozen
class Room:
    """A rectangle of the paper [mm, y down]."""

    left: float
    top: float
    right: float
    bottom: float

    @property
    def size(self) -> complex:
        """Width and height."""
        return complex(self.right - self.left, self.bottom - self.top)

    @property
    def middle(self) -> complex:
        return complex(self.left + self.right, self.top + self.bottom) / 2

    def inset(self, sides: float, top: float, foot: float) -> Room:
        """The same without a margin at each side, at the top and at the foot."""
        return Room(self.left + sides, self.top + top, self.right - sides, self.bottom - foot)

    def holds(self, place: complex) -> bool:
        return self.left <= place.real <= self.right and self.top <= place.imag <= self.bottom

    def cells(self, count: int, columns: int) -> list[Room]:
        """Equal cells, row by row."""
        wide, high = self.size.real / columns, self.size.imag / -(-count // columns)
        corners = ((self.left + k % columns * wide, self.top + k // columns * high) for k in range(count))
        return [Room(left, top, left + wide, top + high) for left, top in corners]


@frozen
class Paper:
    """A sheet of paper with a drawing frame `margin` inside its edge, `filing` where it is filed [mm].

    A paper without margin has no frame.
    """

    name: str
    width: float
    height: float
    margin: float = 10.0
    filing: float = 20.0

    @property
    def landscape(self) -> bool:
        return self.width > self.height

    @property
    def frame(self) -> Room:
        """What the drawing frame holds."""
        left = self.filing if self.margin else 0.0
        return Room(left, self.margin, self.width - self.margin, self.height - self.margin)


PAPERS: Mapping[str, Paper] = {
    paper.name: paper
    for paper in (
        Paper("A4", 210.0, 297.0),
        Paper("A4-landscape", 297.0, 210.0),
        Paper("A3-landscape", 420.0, 297.0),
        Paper("A3", 297.0, 420.0),
        Paper("letter", 215.9, 279.4),
        Paper("letter-landscape", 279.4, 215.9),
    )
}
USUAL = tuple(PAPERS.values())[:4]
"""In the order in which they are tried: the smallest that fits is taken. Letter paper has to be asked for."""
LARGE = (PAPERS["A3-landscape"], PAPERS["A3"])
"""Tried, too, where a smaller one holds all but leaves it little room."""

PenName = Literal[
    "visible", "outline", "vector", "laid", "thin", "hatch", "dashed", "centre", "construction", "measured",
    "leader",
]  # fmt: skip


@frozen
class Pen:
    """A kind of line: its width and its dashes [mm]; no dashes for a full line."""

    width: float
    dashes: tuple[float, ...] = ()


PENS: Mapping[PenName, Pen] = {
    "visible": Pen(0.7),  # links, the drawing frame
    "outline": Pen(0.35),  # blocks, hinges, pivots
    "vector": Pen(0.35),
    "laid": Pen(0.18),  # arrows that are laid off, where those that the construction finds stand out
    "thin": Pen(0.18),  # images, tables
    "hatch": Pen(0.18),
    "dashed": Pen(0.18, (2.0, 1.0)),
    "centre": Pen(0.18, (6.0, 1.0, 0.6, 1.0)),
    "construction": Pen(0.18),
    "measured": Pen(0.18, (3.0, 1.2)),  # lengths of the mechanism that the solution uses
    "leader": Pen(0.18),
}

TITLE = 4.5
"""Size of the title's letters [mm]: the em of the font."""
LABEL = 3.8
"""Labels of points, vectors and links, and headings [mm]."""
BODY = 3.2
"""Tables and the title block [mm]."""
LEAST = 2.5
"""Nothing is lettered smaller [mm]."""
