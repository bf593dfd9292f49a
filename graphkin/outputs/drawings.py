"""A drawing as a file, by the ending of its name; any drawing is written here, and replaces only one of graphkin's.

A drawing that somebody worked on since it was drawn is not replaced unasked. This module loads no format before one is
written, so that the commands can list them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from graphkin.base.value import frozen
from graphkin.errors import BadDrawing, GraphkinError, Lang
from graphkin.outputs import files

if TYPE_CHECKING:
    from graphkin.construction import Plot
    from graphkin.outputs.paint import Ink
    from graphkin.planning import Method
    from graphkin.sheet import Sheet

_MARKS = (files.NAMESPACE.encode(), b"graphkin sheet")
_ADDED = ("other", "words")  # notes of the ruler on signs and letters that are more or fewer than were drawn


@frozen
class DrawingSource:
    """A sheet to be written, and for a GeoGebra file the construction that the sheet shows."""

    sheet: Sheet
    method: Method
    plot: Plot
    lang: Lang
    dpi: float = 200.0
    ink: Ink = "accent"


def _content(ending: str, source: DrawingSource) -> bytes:
    """The file of a drawing; its format is loaded here."""
    match ending:
        case ".svg":
            from graphkin.outputs.svg import svg

            return svg(source.sheet, source.ink).encode()
        case ".pdf":
            from graphkin.outputs.paged import pdf

            return pdf(source.sheet, source.lang, source.ink)
        case ".png":
            from graphkin.outputs.paged import png

            return png(source.sheet, source.dpi, source.ink)
        case ".dxf":
            from graphkin.outputs.dxf import dxf

            return dxf(source.sheet)
        case ".ggb":
            from graphkin.outputs.geogebra import ggb

            return ggb(source.method, source.plot, source.sheet.scales, source.lang)
        case _:
            from graphkin.outputs.tikz import tikz

            return tikz(source.sheet, source.ink).encode()


def _moving(ending: str, sheets: Sequence[Sheet], dpi: float, ink: Ink) -> bytes:
    from graphkin.outputs import animation, paged

    if ending == ".svg":
        return animation.animation(sheets, ink=ink).encode()
    return paged.moving_png(sheets, dpi, animation.SECONDS, ink)


WRITERS: Mapping[str, Callable[[DrawingSource], bytes]] = {
    ending: partial(_content, ending) for ending in (".svg", ".pdf", ".png", ".dxf", ".ggb", ".tex")
}
"""By the file's ending."""
MOVING: Mapping[str, Callable[[Sequence[Sheet], float, Ink], bytes]] = {
    ending: partial(_moving, ending) for ending in (".svg", ".png")
}
"""Sheets of several positions as one file, by its ending."""


def refuse(path: Path, force: bool) -> None:
    """Raises FileInTheWay, NoFolder, CannotWrite; several files are all asked about before the first is written."""
    files.refuse(path, force, _MARKS)


def write(path: Path, content: bytes | str, force: bool) -> None:
    """Beside, then renamed; a text as UTF-8. Raises FileInTheWay, NoFolder, CannotWrite."""
    with files.beside(path, force, _MARKS) as draft:
        draft.write_bytes(content.encode() if isinstance(content, str) else content)


class EditedByHand(GraphkinError):
    path: str
    en = (
        "{path} was changed by hand since graphkin drew it (`graphkin check` tells where). Choose another name, "
        "or replace it with --force."
    )
    zh = "{path} 在 graphkin 绘制之后被手工修改过（`graphkin check` 可查看何处）。请换文件名，或用 --force 覆盖。"


def refuse_edited(path: Path, force: bool) -> None:
    """Raises EditedByHand for an SVG of graphkin's that no longer measures, or has other signs and letters than it was
    drawn with. One that cannot be measured (a problem without answers, a drawing that moves, one of an older version)
    counts as it was drawn."""
    if force or path.suffix.lower() != ".svg" or not path.is_file():
        return
    if not (content := path.read_bytes()) or b"<animate" in content:
        return
    from graphkin.check import measure

    try:
        report = measure(path)
        edited = not report.passed(0.01) or any(note.kind in _ADDED for note in report.notes)
    except BadDrawing as error:
        edited = error.reason in ("shown", "xml")
    except GraphkinError:
        edited = False
    if edited:
        raise EditedByHand(str(path))
