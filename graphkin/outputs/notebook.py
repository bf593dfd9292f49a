"""A sheet as a notebook shows it."""

from __future__ import annotations

from graphkin.outputs.svg import svg
from graphkin.sheet import Sheet


class NotebookSheet(Sheet):
    """A sheet that a notebook shows as its SVG."""

    def _repr_svg_(self) -> str:
        return svg(self)


def shown(sheet: Sheet) -> NotebookSheet:
    return NotebookSheet(**vars(sheet))
