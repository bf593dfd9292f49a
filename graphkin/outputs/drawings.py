"""Drawings."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.errors import BadDrawing, GraphkinError, Lang
from graphkin.outputs.files import beside
from graphkin.outputs.files import refuse as refuse_file
from graphkin.outputs.paint import Ink
from graphkin.outputs.svg import NAMESPACE
from graphkin.planning import Method
from graphkin.sheet import Sheet


@frozen
class DrawingSource:
    """What a format is made of: the sheet; for a GeoGebra file, what the sheet shows."""

    sheet: Sheet
    method: Method
    plot: Plot
    lang: Lang
    dpi: float = 200.0
    ink: Ink = "accent"


def _svg(picture: DrawingSource) -> bytes:
    from graphkin.outputs.svg import svg

    return svg(picture.sheet, picture.ink).encode()


def _pdf(picture: DrawingSource) -> bytes:
    from graphkin.outputs.paged import pdf

    return pdf(picture.sheet, picture.lang, picture.ink)


def _png(picture: DrawingSource) -> bytes:
    from graphkin.outputs.paged import png

    return png(picture.sheet, picture.dpi, picture.ink)


def _dxf(picture: DrawingSource) -> bytes:
    from graphkin.outputs.dxf import dxf

    return dxf(picture.sheet)


def _tikz(picture: DrawingSource) -> bytes:
    from graphkin.outputs.tikz import tikz

    return tikz(picture.sheet, picture.ink).encode()


def _ggb(picture: DrawingSource) -> bytes:
    from graphkin.outputs.geogebra import ggb

    return ggb(picture.method, picture.plot, picture.sheet.scales, picture.lang)


def _moving_svg(sheets: Sequence[Sheet], dpi: float, ink: Ink) -> bytes:
    from graphkin.outputs.animation import animation

    return animation(sheets, ink=ink).encode()


def _moving_png(sheets: Sequence[Sheet], dpi: float, ink: Ink) -> bytes:
    from graphkin.outputs.animation import SECONDS
    from graphkin.outputs.paged import moving_png

    return moving_png(sheets, dpi, SECONDS, ink)


WRITERS: Mapping[str, Callable[[DrawingSource], bytes]] = {
    ".svg": _svg, ".pdf": _pdf, ".png": _png, ".dxf": _dxf, ".ggb": _ggb, ".tex": _tikz,
}  # fmt: skip
"""By the file's ending."""
MOVING: Mapping[str, Callable[[Sequence[Sheet], float, Ink], bytes]] = {".svg": _moving_svg, ".png": _moving_png}
"""Sheets of several positions as one file, by its ending."""
_MARKS = (NAMESPACE.encode(), b"graphkin sheet")


def refuse(path: Path, force: bool) -> None:
    """Whether a drawing may be written there; several are all asked before the first is written.

    Raises FileInTheWay, NoFolder, CannotWrite.
    """
    refuse_file(path, force, _MARKS)


def write(path: Path, content: bytes | str, force: bool) -> None:
    """Beside, then renamed; a text as UTF-8. Raises FileInTheWay, NoFolder, CannotWrite."""
    with beside(path, force, _MARKS) as draft:
        draft.write_bytes(content.encode() if isinstance(content, str) else content)


_ADDED = ("other", "words")
"""Notes of the ruler on signs and letters that are more or fewer than were drawn."""


class EditedByHand(GraphkinError):
    """A drawing of graphkin's that no longer is as it was drawn."""

    path: str

    text: ClassVar[dict[Lang, str]] = {
        "en": "{path} was changed by hand since graphkin drew it (`graphkin check` tells where). Choose another name, "
        "or replace it with --force.",
        "zh": "{path} 在 graphkin 绘制之后被手工修改过（`graphkin check` 可查看何处）。"
        "请换文件名，或用 --force 覆盖。",
    }


def refuse_edited(path: Path, force: bool) -> None:
    """Whether an SVG may be drawn over what is there. Raises EditedByHand."""
    if not force and path.suffix.lower() == ".svg" and path.is_file() and path.stat().st_size and edited(path):
        raise EditedByHand(str(path))


def edited(path: Path) -> bool:
    """Whether a drawing of graphkin's no longer measures, or has other signs and letters than it was drawn with.

    What cannot be measured (a problem without answers, a drawing that moves, one of an older version) counts as it was
    drawn.
    """
    if b"<animate" in path.read_bytes():
        return False
    from graphkin.check import measure

    try:
        report = measure(path)
    except BadDrawing as error:
        return error.reason in ("shown", "xml")
    except GraphkinError:
        return False
    return not report.passed(0.01) or any(note.kind in _ADDED for note in report.notes)
