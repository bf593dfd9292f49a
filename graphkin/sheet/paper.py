"""Paper, pens, letters and scales, after ISO 216 (paper), ISO 128 (lines), ISO 3098 (lettering), ISO 5455 (scales).

Sizes are in millimetres. A scale is what one millimetre on paper stands for: mu_l in m/mm, mu_v in (m/s)/mm, mu_a in
(m/s²)/mm; it is chosen from the series of scales (`base.scales`), or given and then kept.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Literal

from graphkin.base.rooms import Room
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import UnknownPaper
from graphkin.sheet.lettering import Label, quantity_label, valued

_A4 = 210.0 * 297.0  # [mm^2]
_READ = 1.1  # letters of A3 are so much larger: at the size of A4 labels are 1.8 mm high, the least of ISO 3098


@frozen
class Paper:
    """A sheet of paper with a drawing frame `margin` inside its edge, `filing` where it is filed [mm].

    A paper without margin has no frame.
    times  a sheet is composed on a paper so many times smaller, then enlarged
    """

    name: str
    width: float
    height: float
    margin: float = 10.0
    filing: float = 20.0
    times: float = 1.0

    @property
    def area(self) -> float:
        """[mm^2]"""
        return self.width * self.height

    @property
    def lying(self) -> bool:
        return self.width > self.height

    @property
    def reduced(self) -> Paper:
        """The paper on which its sheets are composed: one larger than A4 may be printed as A4."""
        times = _READ if self.area > 1.1 * _A4 else 1.0
        return self._sized(1 / times, times)

    @property
    def enlarged(self) -> Paper:
        """The paper as it is sold."""
        return self._sized(self.times, 1.0)

    def _sized(self, by: float, times: float) -> Paper:
        width, height, margin, filing = (round(by * s, 9) for s in (self.width, self.height, self.margin, self.filing))
        return Paper(self.name, width, height, margin, filing, times)

    @property
    def frame(self) -> Room:
        """The room within the drawing frame."""
        left = self.filing if self.margin else 0.0
        return Room(left, self.margin, self.width - self.margin, self.height - self.margin)

    def divided(self, height: float) -> tuple[Room, Room]:
        """The field for figures, and under it a strip of that height [mm]."""
        edge = self.frame.bottom - height
        return replace(self.frame, bottom=edge), replace(self.frame, top=edge)


PAPERS: Mapping[str, Paper] = {
    name: Paper(name, wide, high)
    for name, wide, high in (
        ("A4", 210.0, 297.0), ("A4-landscape", 297.0, 210.0), ("A3-landscape", 420.0, 297.0), ("A3", 297.0, 420.0),
        ("letter", 215.9, 279.4), ("letter-landscape", 279.4, 215.9),
    )
}  # fmt: skip
USUAL = tuple(PAPERS.values())[:4]
"""In the order in which they are tried: the smallest that fits is taken. Letter paper has to be asked for."""

PenName = Literal[
    "visible", "outline", "asked", "vector", "laid", "thin", "hatch", "dashed", "centre", "construction", "measured",
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
    "asked": Pen(0.5),  # arrows that the problem asks for
    "vector": Pen(0.35),  # those that the construction finds
    "laid": Pen(0.18),  # those that are laid off, where others stand out
    "thin": Pen(0.18),  # images, tables
    "hatch": Pen(0.18),
    "dashed": Pen(0.18, (2.0, 1.0)),
    "centre": Pen(0.18, (6.0, 1.0, 0.6, 1.0)),
    "construction": Pen(0.13),
    "measured": Pen(0.13, (3.0, 1.2)),  # lengths of the mechanism that the solution uses
    "leader": Pen(0.13),  # in half the colour of its plane
}

LETTERS: dict[Plane, str] = {"position": "l", "velocity": "v", "acceleration": "a"}
UNITS: dict[Plane, str] = {"position": "m/mm", "velocity": "(m/s)/mm", "acceleration": "(m/s²)/mm"}
KEYS: dict[Plane, str] = {"position": "length", "velocity": "velocity", "acceleration": "acceleration"}
"""Key of a plane's scale in the mechanism file."""
LARGEST: dict[Plane, complex] = {"position": 140 + 190j, "velocity": 151 + 111j, "acceleration": 151 + 111j}
"""The largest figures of a sheet, but for given scales and papers: a handout's page has room for them [mm]."""


def papers_for(name: str | None) -> list[Paper]:
    """The paper asked for, or the usual ones."""
    if name is not None and name not in PAPERS:
        raise UnknownPaper(name, ", ".join(PAPERS))
    return [PAPERS[name]] if name is not None else list(USUAL)


def written(plane: Plane, scale: float) -> Label:
    """`μ_l = 0.001 m/mm`."""
    return valued(quantity_label("μ", LETTERS[plane]), scale, f" {UNITS[plane]}")
