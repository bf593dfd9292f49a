"""Motion diagrams (运动线图): position, velocity and acceleration over a turn, or as far as the driver gets.

As in figs. 3-14 to 3-16 of the textbook: panels below one another over one x axis. matplotlib draws them, without
pyplot and without a trace in its settings; the same input gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from graphkin.errors import GraphkinError, Lang
from graphkin.model.quantities import centre_of
from graphkin.outputs import files
from graphkin.outputs.diagram.curves import curves
from graphkin.outputs.diagram.fonts import MARK, NoChineseFont, chinese_font, has_chinese
from graphkin.studies.sweeps import Course, Road

if TYPE_CHECKING:
    from graphkin.outputs.diagram.page import DiagramPage

__all__ = ["FORMATS", "MARK", "NothingToDraw", "figure", "write"]

FORMATS = (".svg", ".png", ".pdf")


class NothingToDraw(GraphkinError):
    names: str
    en = (
        "{names}: the place of an instant centre has no motion diagram. Write .csv, or draw its path: "
        "`graphkin centres --path`."
    )
    zh = "{names}：瞬心的位置没有运动线图。请写成 .csv，或用 `graphkin centres --path` 画其轨迹。"


def figure(course: Course, names: Sequence[str], lang: Lang = "en", by: Road = "construction") -> DiagramPage:
    """The diagram of quantities over a course, for a notebook or to be changed.

    names  as `sweeps.asked` gives them: `theta 3`, `v E`, `omega 3/omega 2`; instant centres are left out
    lang   where no Chinese font is found, Chinese falls back to English (`write` says so)
    """
    from graphkin.outputs.diagram.draw import draw
    from graphkin.outputs.diagram.page import settings

    shown = [name for name in names if centre_of(course.method.mechanism, name) is None]
    if not shown:
        raise NothingToDraw(", ".join(names))
    numbers = curves(course, shown, by)
    with settings():
        return draw(numbers, lang if chinese_font() is not None else "en")


def write(
    path: Path, course: Course, names: Sequence[str], lang: Lang = "en", by: Road = "construction", force: bool = False
) -> NoChineseFont | None:
    """Write a diagram as SVG, PNG or PDF, after the file's ending; beside, then renamed. Returns the message for a
    diagram that needs Chinese letters where there are none. Raises what `files` raises."""
    kind, title = path.suffix.lower(), course.method.mechanism.headline(lang)
    if kind not in FORMATS:
        raise files.UnknownEnding(str(path), FORMATS)
    files.refuse(path, force, (MARK.encode(),))
    files.write(path, figure(course, names, lang, by).content(kind), force, (MARK.encode(),))
    chinese = lang == "zh" or any(map(has_chinese, (title, *names)))
    return NoChineseFont() if chinese and chinese_font() is None else None
