"""The class report as a figure: verdicts at each step, mistakes, and scores, below one another."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from graphkin.errors import Lang
from graphkin.homework.platforms.class_report import RANGES, ClassReport
from graphkin.homework.platforms.feedback import suspected
from graphkin.outputs import diagram
from graphkin.outputs.diagram.fonts import NoChineseFont, chinese_font, writable
from graphkin.outputs.files import beside
from graphkin.say.catalogue import say

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

_MM = 1 / 25.4
_WIDTH, _LEFT, _RIGHT = 180.0, 62.0, 8.0
_TOP, _BETWEEN, _ROW, _SCORES = 12.0, 20.0, 6.0, 45.0
_MOST = 25  # mistakes and steps that are shown; tables have the rest
_LONGEST = 44
_VERDICTS = (
    ("right", "#ffffff", ""), ("carried", "#dddddd", "////"), ("wrong", "#555555", ""), ("missing", "#ffffff", "...."),
    ("dead point", "#ffffff", "xxxx"), ("too small", "#ffffff", "xxxx"), ("not read", "#bbbbbb", "oo"),
)  # fmt: skip
"""Fill and hatching: told apart in print without colours."""


def write_class_figure(path: Path, report: ClassReport, lang: Lang = "en", force: bool = False) -> NoChineseFont | None:
    """The figure as SVG, PNG or PDF, after the file's ending. Returns a remark where there are no Chinese letters.
    Raises NotADiagram, FileInTheWay, NoFolder, CannotWrite."""
    kind = path.suffix.lower()
    if kind not in diagram.FORMATS:
        raise diagram.NotADiagram(str(path))
    spoken: Lang = lang if chinese_font() is not None else "en"
    with beside(path, force, (diagram.MARK.encode(),)) as draft, diagram.settings():
        about = diagram.metadata(kind, say("class_report.part steps", spoken))
        class_figure(report, spoken).savefig(draft, format=kind[1:], dpi=200, metadata=about)
    return NoChineseFont() if lang != spoken else None


def class_figure(report: ClassReport, lang: Lang) -> Figure:
    """The figure; to be drawn within `outputs.diagram.settings`."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    rows = [max(1, min(_MOST, len(report.steps))), max(1, min(_MOST, len(report.mistakes)))]
    heights = [_ROW * (count + 1) for count in rows] + [_SCORES]
    total = _TOP + sum(heights) + _BETWEEN * len(heights)
    page = Figure(figsize=(_WIDTH * _MM, total * _MM), dpi=200)
    FigureCanvasAgg(page)
    level = total - _TOP
    for draw, height in zip((_steps, _mistakes, _scores), heights, strict=True):
        place = (_LEFT / _WIDTH, (level - height) / total, 1 - (_LEFT + _RIGHT) / _WIDTH, height / total)
        draw(page.add_axes(place), report, lang)
        level -= height + _BETWEEN
    return page


def _steps(axes: Axes, report: ClassReport, lang: Lang) -> None:
    steps = report.steps[:_MOST]
    _title(axes, say("class_report.part steps", lang))
    if not steps:
        _write_instead(axes, say("class_report.nobody marked", lang))
        return
    starts = [0] * len(steps)
    for k, (name, colour, hatch) in enumerate(_VERDICTS):
        counts = [step.verdicts.get(name, 0) for step in steps]
        if k > 3 and not any(counts):
            continue
        axes.barh(range(len(steps)), counts, left=starts, color=colour, hatch=hatch, edgecolor="black", linewidth=0.6,
                  label=say(f"verdicts.verdict {name}", lang))  # fmt: skip
        starts = [start + count for start, count in zip(starts, counts, strict=True)]
    _name_rows(axes, [step.name for step in steps], lang)
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=len(_VERDICTS), frameon=False, fontsize=8,
                borderaxespad=0.2, handlelength=1.4, columnspacing=1.0)  # fmt: skip


def _mistakes(axes: Axes, report: ClassReport, lang: Lang) -> None:
    mistakes = report.mistakes[:_MOST]
    _title(axes, say("class_report.part mistakes", lang))
    if not mistakes:
        texts = [say("class_report.unexplained", lang, count=report.unexplained)] if report.unexplained else []
        _write_instead(axes, say("class_report.nothing diagnosed", lang), *texts)
        return
    axes.barh(range(len(mistakes)), [count for _, count in mistakes], color="#bbbbbb", edgecolor="black", linewidth=0.6)
    _name_rows(axes, [" / ".join(one.ids) or suspected(one, lang) for one, _ in mistakes], lang)


def _scores(axes: Axes, report: ClassReport, lang: Lang) -> None:
    width = 100 / RANGES
    _title(axes, say("class_report.part distribution", lang))
    if not any(report.ranges):
        _write_instead(axes, say("class_report.nobody marked", lang))
        return
    starts = [k * width for k in range(RANGES)]
    axes.bar(starts, report.ranges, width=width, align="edge", color="#bbbbbb", edgecolor="black", linewidth=0.6)
    axes.set_xlim(0, 100)
    axes.set_xlabel(say("platforms.column score percent", lang), fontsize=8)
    axes.set_ylabel(say("class_report.students", lang), fontsize=8)
    _count_in_wholes(axes.yaxis)


def _write_instead(axes: Axes, *texts: str) -> None:
    """Words in place of a diagram of nothing."""
    axes.set_axis_off()
    axes.text(0.0, 1.0, "\n".join(texts), fontsize=8, va="top", parse_math=False, transform=axes.transAxes)


def _title(axes: Axes, title: str) -> None:
    """On the left of the page, where there is room beside the legend."""
    axes.set_title(title, loc="left", fontsize=9, x=-(_LEFT - 4) / (_WIDTH - _LEFT - _RIGHT))


def _name_rows(axes: Axes, names: list[str], lang: Lang) -> None:
    """Names beside the bars, the first above; in plain letters, whatever they are."""
    texts = [name if len(name) <= _LONGEST else name[: _LONGEST - 2] + ".." for name in map(writable, names)]
    axes.set_yticks(range(len(names)), texts, fontsize=8, parse_math=False)
    axes.set_ylim(max(len(names), 1) - 0.4, -0.6)
    axes.set_xlabel(say("class_report.students", lang), fontsize=8)
    _count_in_wholes(axes.xaxis)


def _count_in_wholes(axis: Axis) -> None:
    """Whole numbers alone: students are counted."""
    from matplotlib.ticker import MaxNLocator

    axis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
