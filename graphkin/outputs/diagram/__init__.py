"""Motion diagrams (运动线图): position, velocity and acceleration over a turn, or as far as the driver gets.

As in figs. 3-14 to 3-16 of the textbook: panels below one another over one x axis. matplotlib draws them, without
pyplot and without a trace in its settings; the same input gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from threading import RLock
from typing import TYPE_CHECKING

from graphkin.errors import GraphkinError, Lang
from graphkin.model.quantities import centre_of
from graphkin.outputs import files
from graphkin.outputs.diagram.curves import curves
from graphkin.outputs.diagram.fonts import NoChineseFont, chinese_font, has_chinese, letters
from graphkin.studies.sweeps import Course, Road

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["FORMATS", "MARK", "NotADiagram", "NothingToDraw", "figure", "metadata", "refuse", "settings", "write"]

FORMATS = (".svg", ".png", ".pdf")
MARK = "https://graphkin.invalid/diagram/1"  # by this graphkin knows a diagram of its own, whatever the format
DPI = 200
_ALONE = RLock()
"""matplotlib's settings, and what it writes formulas by, are one for all threads: diagrams are made one at a time."""


class NotADiagram(GraphkinError):
    path: str
    en = "{path}: a diagram is written as .svg, .png or .pdf. Let the file's name end in one of these."
    zh = "{path}：线图只能写成 .svg、.png 或 .pdf 文件，请用其中之一作扩展名。"


class NothingToDraw(GraphkinError):
    names: str
    en = (
        "{names}: the place of an instant centre has no motion diagram. Write .csv, or draw its path: "
        "`graphkin centres --path`."
    )
    zh = "{names}：瞬心的位置没有运动线图。请写成 .csv，或用 `graphkin centres --path` 画其轨迹。"


def figure(course: Course, names: Sequence[str], lang: Lang = "en", by: Road = "construction") -> Figure:
    """The diagram of quantities over a course, for a notebook or to be saved with `savefig`.

    names  as `sweeps.asked` gives them: `theta 3`, `v E`, `omega 3/omega 2`; instant centres are left out
    lang   where no Chinese font is found, Chinese falls back to English (`write` says so)
    """
    from graphkin.outputs.diagram.draw import draw

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
    diagram that needs Chinese letters where there are none. Raises NotADiagram, FileInTheWay, NoFolder, CannotWrite."""
    kind, title = path.suffix.lower(), course.method.mechanism.headline(lang)
    if kind not in FORMATS:
        raise NotADiagram(str(path))
    refuse(path, force)
    drawing = figure(course, names, lang, by)
    with files.beside(path, force, (MARK.encode(),)) as draft, settings():
        drawing.savefig(draft, format=kind[1:], dpi=DPI, metadata=metadata(kind, title))
    chinese = lang == "zh" or any(map(has_chinese, (title, *names)))
    return NoChineseFont() if chinese and chinese_font() is None else None


def refuse(path: Path, force: bool) -> None:
    """Raises FileInTheWay, NoFolder, CannotWrite where a diagram may not be written."""
    files.refuse(path, force, (MARK.encode(),))


def metadata(kind: str, title: str) -> dict[str, str | None]:
    """The title, the program, and no time."""
    if kind == ".png":
        return {"Software": f"graphkin {MARK}"}
    if kind == ".svg":
        return {"Title": title, "Creator": f"graphkin {MARK}", "Date": None}
    return {"Creator": f"graphkin {MARK}", "Producer": None, "CreationDate": None}


@contextmanager
def settings(outlines: bool = False) -> Iterator[None]:
    """matplotlib as it comes, with our letters, or their outlines, which are as wide in any viewer; what the user has
    set is there again afterwards."""
    import matplotlib

    with _ALONE, matplotlib.rc_context():
        matplotlib.rcdefaults()
        # PDF fonts as outlines (3): as 42, letters of OpenType Chinese fonts are not seen
        matplotlib.rcParams.update({
            "font.family": letters(), "font.size": 9.0, "mathtext.fontset": "stix", "mathtext.fallback": None,
            "svg.hashsalt": "graphkin", "svg.fonttype": "path" if outlines else "none", "pdf.fonttype": 3,
            "text.hinting": "no_hinting", "path.simplify": False,
        })  # fmt: skip
        yield
