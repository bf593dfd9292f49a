"""One grid for sheets of several figures: a field of cells over the strip for tables, sentences and title.

    paper, tables, sentences --> SheetGrid (field, strip)       pictures and cells --panels_in--> Panels --> Page
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import SupportsFloat

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism
from graphkin.sheet.layout import divided
from graphkin.sheet.marks import Mark
from graphkin.sheet.page import Page, Panel
from graphkin.sheet.paper import Paper, Room
from graphkin.sheet.single_figure import Picture
from graphkin.sheet.titleblock import Strip, Table, strip_height


@frozen
class SheetGrid:
    """A paper divided: the field for figures and, on a sheet with a title block, the strip under it."""

    paper: Paper
    field: Room
    strip: Strip | None = None

    @classmethod
    def over(
        cls, paper: Paper, tables: Sequence[Table] = (), told: Sequence[str] = (), least: float = 0.0
    ) -> SheetGrid:
        """Over a strip as high as its tables and sentences need; least: at least so high [mm]."""
        field, foot = divided(paper, max(least, strip_height(paper, tables, told=told)))
        return cls(paper, field, Strip(foot, tables, told=told))

    def page(
        self, panels: Sequence[Panel], machine: Mechanism, lang: Lang, *, base: Sequence[Mark] = (), title: str = "",
        drivers: Sequence[SupportsFloat] | None = None,
    ) -> Page:  # fmt: skip
        """The page with these panels; drivers: their values, the file's where left out."""
        values = [driver.value or 0.0 for driver in machine.drivers] if drivers is None else drivers
        return Page(self.paper, panels, machine, values, lang, self.strip, base, title)


def panels_in(pictures: Sequence[Picture], cells: Sequence[Room], scale: float | None = None) -> Iterator[Panel]:
    """Each picture in its cell, at one scale [m/mm], or each at its own."""
    for picture, cell in zip(pictures, cells, strict=True):
        yield picture.panel(cell, picture.scale(cell) if scale is None else scale)
