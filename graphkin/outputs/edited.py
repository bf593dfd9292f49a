"""A drawing that somebody worked on since it was drawn: it is not replaced unasked."""

from __future__ import annotations

from pathlib import Path
from typing import ClassVar

from graphkin.errors import BadDrawing, GraphkinError, Lang

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
