"""Where the letters of a PDF come from: a file that is named, what the environment names, or the system's fonts."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import NoChineseLetters, NoFont

VARIABLE = "GRAPHKIN_FONT"
LATIN = ("Times New Roman", "Liberation Serif", "Tinos", "Libertinus Serif")


@frozen
class Fonts:
    """Families in the order in which they are tried, and folders to look in beside the system's."""

    families: tuple[str, ...]
    folders: tuple[str, ...] = ()


def fonts(named: Path | None, chinese: bool) -> Fonts:
    """Raises NoFont, NoChineseLetters."""
    from graphkin.outputs.diagram.fonts import chinese_font

    path = named or (Path(os.environ[VARIABLE]) if os.environ.get(VARIABLE) else None)
    own = tuple(_families(path)) if path is not None else ()
    folders = (str(path.parent),) if path is not None else ()
    if not chinese:
        return Fonts((*own, *LATIN), folders)
    found = own or ((name,) if (name := chinese_font()) is not None else ())
    if not found:
        raise NoChineseLetters()
    return Fonts((*LATIN, *found), folders)


def _families(path: Path) -> Iterator[str]:
    from matplotlib.ft2font import FT2Font

    try:
        yield FT2Font(str(path)).family_name
    except (OSError, RuntimeError):
        raise NoFont(str(path)) from None
