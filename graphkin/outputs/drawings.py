"""A drawing as a file, by the ending of its name; any drawing is written here, and replaces only one of graphkin's.

A drawing that somebody worked on since it was drawn is not replaced unasked. This module loads no format before one is
written, so that the commands can list them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from graphkin.errors import BadDrawing, GraphkinError
from graphkin.outputs import files

if TYPE_CHECKING:
    from graphkin.construction import Plot
    from graphkin.outputs.paint import Ink
    from graphkin.planning import Method
    from graphkin.sheet import Sheet

_MARKS = (files.NAMESPACE.encode(), b"graphkin sheet")
_ADDED = ("other", "words")  # notes of the ruler on signs and letters that are more or fewer than were drawn


def content(path: Path, sheet: Sheet, drawing: tuple[Method, Plot] | None, dpi: float, ink: Ink) -> bytes:
    """The file of a drawing, by the ending of its name; its format is loaded here. A GeoGebra file is made of the
    method and the plot that are drawn. Raises UnknownEnding, NeedsExtra."""
    match path.suffix.lower():
        case ".svg":
            from graphkin.outputs.svg import svg

            return svg(sheet, ink).encode()
        case ".pdf":
            from graphkin.outputs.paged import pdf

            return pdf(sheet, sheet.lang, ink)
        case ".png":
            from graphkin.outputs.paged import png

            return png(sheet, dpi, ink)
        case ".dxf":
            from graphkin.outputs.dxf import dxf

            return dxf(sheet)
        case ".ggb" if drawing is not None:
            from graphkin.outputs.geogebra import ggb

            return ggb(*drawing, sheet.scales, sheet.lang)
        case ".tex":
            from graphkin.outputs.tikz import tikz

            return tikz(sheet, ink).encode()
        case _:
            raise files.UnknownEnding(str(path), tuple(kind for kind in DRAWN if kind != ".ggb" or drawing))


def _moving(ending: str, sheets: Sequence[Sheet], dpi: float, ink: Ink) -> bytes:
    from graphkin.outputs import animation, paged

    if ending == ".svg":
        return animation.animation(sheets, ink=ink).encode()
    return paged.moving_png(sheets, dpi, animation.SECONDS, ink)


DRAWN = (".svg", ".pdf", ".png", ".dxf", ".ggb", ".tex")
"""The endings of a position's files."""
MOVING: Mapping[str, Callable[[Sequence[Sheet], float, Ink], bytes]] = {
    ending: partial(_moving, ending) for ending in (".svg", ".png")
}
"""Sheets of several positions as one file, by its ending."""


def refuse(path: Path, force: bool) -> None:
    """Raises FileInTheWay, NoFolder, CannotWrite; several files are all asked about before the first is written."""
    files.refuse(path, force, _MARKS)


def write(path: Path, content: bytes | str, force: bool) -> None:
    """Beside, then renamed; a text as UTF-8. Raises FileInTheWay, NoFolder, CannotWrite."""
    files.write(path, content, force, _MARKS)


class EditedByHand(GraphkinError):
    path: str
    en = (
        "{path} was changed by hand since graphkin drew it (`graphkin check` tells where). Choose another name, "
        "or replace it with --force (in Python: force=True)."
    )
    zh = "{path} 在 graphkin 绘制之后被手工修改过（`graphkin check` 可查看何处）。请换文件名，或用 --force 覆盖。"


def refuse_edited(path: Path, force: bool) -> None:
    """Raises what `refuse` raises, and EditedByHand for an SVG of graphkin's that no longer measures, or has other
    signs and letters than were drawn. One that cannot be measured (a problem without answers, a drawing that moves, one
    of an older version) counts as it was drawn."""
    refuse(path, force)
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
