"""The report of a class, as data: the steps that fail, the mistakes that explain its numbers, the spread of scores;
and as a figure."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from decimal import Decimal
from functools import partial
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, get_args

from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework.platforms.feedback import called, habit, suspected, without_place
from graphkin.homework.platforms.markup import in_html
from graphkin.homework.platforms.pages import document, figure_element, typeset
from graphkin.homework.platforms.question import in_letters
from graphkin.homework.platforms.result import Result, ResultPicture, most_of, points_of
from graphkin.homework.platforms.tables import exponentless
from graphkin.marking.diagnosis import Explanation, Habit
from graphkin.marking.records import Judged, Verdict
from graphkin.outputs import diagram
from graphkin.outputs.diagram.fonts import NoChineseFont, chinese_font, pieces, writable
from graphkin.outputs.files import UnknownEnding, write
from graphkin.say.boards import line_name
from graphkin.say.catalogue import say
from graphkin.sheet.lettering import is_wide
from graphkin.submissions.office import Seen

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis

    from graphkin.outputs.diagram.page import DiagramPage

UNREAD = 200  # so many answers that were not read are written out; of more the number is said
RANGES = 10  # scores are counted in so many ranges of the same width
_FAILED: tuple[Verdict, ...] = ("wrong", "missing")
_ALWAYS: tuple[Verdict, ...] = ("right", "carried", *_FAILED)
"""Wrong lines come before those that are left out, which is normal on the way."""


@frozen
class ReportStep:
    """One quantity in the whole class, in the order of the problem.

    verdicts  how often each; first  for how many it is the first that is wrong, or missing where nothing is wrong
    points    earned by all, of `most`
    """

    name: str
    verdicts: Mapping[str, int]
    first: int
    points: Decimal
    most: Decimal


@frozen
class ClassReport:
    """A class.

    mistakes     the best explanation of each, the most frequent first, with how many
    habits       mistakes that show in several problems of a student, with how many students
    unread       answers that were not read: student, quantity, text
    unexplained  how many are wrong somewhere and consistent with no known mistake
    ranges       how many scores in each tenth, the lowest first; the last holds 100 %
    remarks      what the teacher should look at: student, file, remark
    spread       mean, median, lowest and highest of the scores, from 0 to 1; empty where there are none
    """

    marked: int
    unmarked: int
    overridden: int
    steps: tuple[ReportStep, ...]
    mistakes: tuple[tuple[Explanation, int], ...]
    unexplained: int
    ranges: tuple[int, ...]
    habits: tuple[tuple[Habit, int], ...] = ()
    unread: tuple[tuple[str, str, str], ...] = ()
    remarks: tuple[tuple[str, str, str], ...] = ()
    spread: Mapping[str, Decimal] = field(default_factory=dict)


def class_report(results: Iterable[Result]) -> ClassReport:
    """The report of a class."""
    every = [*results]
    marked = [one for one in every if one.status == "marked"]
    lines, first = dict[str, list[Judged]](), Counter[str]()
    by_set: dict[tuple[str, ...], list[Explanation]] = {}  # a set is one, whichever of it is likelier to one student
    for result in marked:
        for line in result.lines:
            lines.setdefault(line.text, []).append(line)
        failed = [line.text for verdict in _FAILED for line in result.lines if line.verdict == verdict]
        left = [] if result.departure is None else [result.departure.text]  # in the order of the drawing
        first.update([*left, *failed][:1])
        for best in result.suspicions[:1]:
            by_set.setdefault(tuple(sorted(best.ids)), []).append(best)
    steps = (_step(name, some, first[name]) for name, some in lines.items())
    failing = [one for one in marked if any(line.verdict == "wrong" and line.unit_right for line in one.lines)]
    scores = sorted(one.score for one in every if one.score is not None)
    ranges = Counter(min(int(score * RANGES), RANGES - 1) for score in scores)
    return ClassReport(
        len(marked), len(every) - len(marked), sum(one.override is not None for one in every),
        tuple(step for step in steps if step.most or {*_FAILED, "not read"} & step.verdicts.keys()),
        tuple(sorted(((some[0], len(some)) for some in by_set.values()), key=lambda pair: (-pair[1], pair[0].ids))),
        sum(not one.suspicions for one in failing), tuple(ranges[k] for k in range(RANGES)),
        tuple(Counter(replace(habit, weight=0.0) for one in marked for habit in one.habits).most_common()),
        tuple((one.student, line.text, line.written) for one in marked for line in one.lines if line.written),
        tuple((one.student, one.file, text) for one in every
              for text in (*one.remarks, *([] if one.status == "marked" else [one.reason]))),
        _spread(scores) if scores else {},
    )  # fmt: skip


def _step(name: str, some: Sequence[Judged], first: int) -> ReportStep:
    """One quantity by its lines in the whole class."""
    earned, most = (sum(map(points, some), Decimal(0)) for points in (points_of, most_of))
    return ReportStep(name, Counter(line.verdict for line in some), first, earned, most)


def _spread(order: Sequence[Decimal]) -> dict[str, Decimal]:
    """Of scores in their order."""
    median = (order[(len(order) - 1) // 2] + order[len(order) // 2]) / 2
    mean = sum(order, Decimal(0)) / len(order)
    return {"mean": mean, "median": median, "lowest": order[0], "highest": order[-1]}


def report_text(report: ClassReport, lang: Lang, names: Mapping[str, str] | None = None) -> Iterator[str]:
    """The report in lines; names: of students by id, as far as they are known."""
    yield say("class_report.marked", lang, marked=report.marked, unmarked=report.unmarked, overridden=report.overridden)
    if report.spread:
        percent = {key: exponentless((value * 100).quantize(Decimal("0.1"))) for key, value in report.spread.items()}
        yield say("class_report.scores", lang, **percent)
    mistakes = [say("class_report.mistake", lang, mistake=text, count=n) for text, n in mistake_counts(report, lang)]
    if report.unexplained:
        mistakes.append(say("class_report.unexplained", lang, count=report.unexplained))
    habits = [say("class_report.habit", lang, shown=one.shown, of=one.of, mistake=habit(one, lang), count=count)
              for one, count in report.habits]  # fmt: skip
    width = 100 // RANGES
    distribution = [
        say("class_report.range", lang, low=k * width, high=(k + 1) * width, count=count)
        for k, count in enumerate(report.ranges)
    ]
    steps = []
    for step in report.steps:
        shown = [name for name in get_args(Verdict) if name in _ALWAYS or step.verdicts.get(name)]
        counts = (f"{say(f'verdicts.verdict {name}', lang)} {step.verdicts.get(name, 0)}" for name in shown)
        verdicts, name = say("common.list", lang).join(counts), in_letters(line_name(step.name, lang), [step.name])
        steps.append(say("class_report.step", lang, name=name, verdicts=verdicts, first=step.first))
    who = partial(called, names=names or {}, lang=lang)
    unread = [say("class_report.unread", lang, student=who(student), name=in_letters(name, [name]), written=text)
              for student, name, text in report.unread[:UNREAD]]  # fmt: skip
    if len(report.unread) > UNREAD:
        unread.append(say("marks.more", lang, count=len(report.unread) - UNREAD))
    remarks = [say("class_report.remark", lang, student=who(student), file=file, remark=without_place(remark, lang))
               for student, file, remark in report.remarks]  # fmt: skip
    parts = {"remarks": remarks, "unread": unread, "steps": steps, "mistakes": mistakes, "habits": habits,
             "distribution": distribution}  # fmt: skip
    for title, texts in parts.items():
        if texts:
            yield from ("", say(f"class_report.part {title}", lang))
            yield from (f"  {text}" for text in texts)


def mistake_counts(report: ClassReport, lang: Lang) -> list[tuple[str, int]]:
    """The mistakes in words, in the letters of the sheets, with how many students."""
    names = [step.name for step in report.steps]
    return [(in_letters(suspected(one, lang), names), count) for one, count in report.mistakes]


def report_page(
    report: ClassReport, lang: Lang, names: Mapping[str, str], figure: str, problem: str, seen: Mapping[str, Seen]
) -> bytes:
    """The report on a problem as a page like those of the students, over the figure, an SVG element; with what is to
    be seen in files that were not read."""
    title, drawn = say("class_report.title", lang), say("class_report.part distribution", lang)
    plain, unread = (say(f"class_report.part {part}", lang) for part in ("remarks", "unread"))  # with students' words
    head, *parts = ("\n".join(report_text(report, lang, names))).split("\n\n")
    who = f'<p class="who">{in_html(title)}</p>' if problem else ""
    body = [f"<header>{who}<h1>{in_html(problem or title)}</h1></header><p>{in_html(head)}</p>"]
    for part, *lines in (part.split("\n  ") for part in parts):
        if part != drawn:
            cut = ((line, "", "") if part != unread else line.partition(say("common.colon", lang)) for line in lines)
            own = in_html if part == plain else typeset
            items = "".join(f"<li>{own(name)}{in_html(colon + words)}</li>" for name, colon, words in cut)
            body.append(f"<h2>{in_html(part)}</h2><ul>{items}</ul>")
        if part == plain:
            there = ((who, seen[file]) for who, file, _ in report.remarks if file in seen)
            shown = (figure_element(ResultPicture(called(who, names, lang), *picture)) for who, picture in there)
            body.append(f'<div class="pictures">{"".join(shown)}</div>')
    figure = f'<figure role="img" aria-label="{escape(drawn)}">{figure}</figure>'
    return document(f"{title}{say('common.colon', lang)}{problem}", "\n".join([*body, figure]), lang)


def report_record(report: ClassReport) -> dict[str, Plain]:
    """The report as a JSON object."""
    spread = {key: round(float(value), 6) for key, value in report.spread.items()}
    return {
        "kind": "graphkin", "format": 1, "marked": report.marked, "not_marked": report.unmarked,
        "overridden": report.overridden,
        **{key: spread.get(key) for key in ("mean", "median", "lowest", "highest")},
        "steps": [
            {"quantity": step.name, "verdicts": dict(step.verdicts), "first_to_fail": step.first,
             "points": float(step.points), "max_points": float(step.most)}
            for step in report.steps
        ],
        "mistakes": [{"ids": list(one.ids), "count": count} for one, count in report.mistakes],
        "not_read": [dict(zip(("student", "quantity", "written"), one)) for one in report.unread[:UNREAD]],
        "unexplained": report.unexplained, "ranges": list(report.ranges),
        "habits": [
            {"ids": list(one.ids), "in_problems": one.shown, "of_problems": one.of, "count": count}
            for one, count in report.habits
        ],
        "remarks": [{"student": who, "file": file, "remark": remark} for who, file, remark in report.remarks],
    }  # fmt: skip


# --- the report as a figure -------------------------------------------------------------------------------------------

_MM = 1 / 25.4
_WIDTH, _LEFT, _RIGHT = 180.0, 62.0, 8.0
_TOP, _BETWEEN, _ROW, _SCORES = 12.0, 20.0, 8.0, 45.0
_MOST = 25  # mistakes and steps that are shown; tables have the rest
_LONGEST = 38
_OFF, _SPACE = 6.0, 2.0  # of names from their rows, and between their lines [pt]
_VERDICTS = (
    ("right", "#ffffff", ""), ("carried", "#dddddd", "////"), ("wrong", "#555555", ""), ("missing", "#ffffff", "...."),
    ("dead point", "#ffffff", "xxxx"), ("too small", "#ffffff", "xxxx"), ("not read", "#bbbbbb", "oo"),
)  # fmt: skip
"""Fill and hatching: told apart in print without colours."""


def write_class_figure(path: Path, report: ClassReport, lang: Lang = "en", force: bool = False) -> NoChineseFont | None:
    """The figure as SVG, PNG or PDF, after the file's ending. Returns a remark where there are no Chinese letters.
    Raises UnknownEnding, FileInTheWay, NoFolder, CannotWrite."""
    kind = path.suffix.lower()
    if kind not in diagram.FORMATS:
        raise UnknownEnding(str(path), diagram.FORMATS)
    spoken: Lang = lang if chinese_font() is not None else "en"
    write(path, class_figure(report, spoken).content(kind), force, (diagram.MARK.encode(),))
    return NoChineseFont() if lang != spoken else None


def class_figure(report: ClassReport, lang: Lang) -> DiagramPage:
    """The figure, with the outlines of its letters."""
    from graphkin.outputs.diagram.page import DiagramPage, settings

    rows = [max(1, min(_MOST, len(report.steps))), max(1, min(_MOST, len(report.mistakes)))]
    heights = [_ROW * (count + 1) for count in rows] + [_SCORES]
    total = _TOP + sum(heights) + _BETWEEN * len(heights)
    parts = {"steps": _steps, "mistakes": _mistakes, "distribution": _scores}
    with settings(outlines=True):
        page = DiagramPage(say("class_report.part steps", lang), _WIDTH * _MM, total * _MM, outlines=True)
        level = total - _TOP
        for (part, draw), height in zip(parts.items(), heights, strict=True):
            place = (_LEFT / _WIDTH, (level - height) / total, 1 - (_LEFT + _RIGHT) / _WIDTH, height / total)
            axes, title = page.add_axes(place), say(f"class_report.part {part}", lang)
            # on the left of the page, where there is room beside the legend
            axes.set_title(title, loc="left", fontsize=9, x=-(_LEFT - 4) / (_WIDTH - _LEFT - _RIGHT))
            draw(axes, report, lang)
            level -= height + _BETWEEN
    return page


def _steps(axes: Axes, report: ClassReport, lang: Lang) -> None:
    steps = report.steps[:_MOST]
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
    _name_rows(axes, [in_letters(line_name(step.name, lang), [step.name]) for step in steps])
    _count_students(axes, lang)
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=len(_VERDICTS), frameon=False, fontsize=8,
                borderaxespad=0.2, handlelength=1.4, columnspacing=1.0)  # fmt: skip


def _mistakes(axes: Axes, report: ClassReport, lang: Lang) -> None:
    mistakes = report.mistakes[:_MOST]
    if not mistakes:
        texts = [say("class_report.unexplained", lang, count=report.unexplained)] if report.unexplained else []
        _write_instead(axes, say("class_report.nothing diagnosed", lang), *texts)
        return
    axes.barh(range(len(mistakes)), [count for _, count in mistakes], color="#bbbbbb", edgecolor="black", linewidth=0.6)
    likeliest = replace(report, mistakes=tuple((replace(one, names=one.names[:1]), n) for one, n in mistakes))
    more = ["" if len(one.names) == 1 else " / .." for one, _ in mistakes]
    _name_rows(axes, [text + end for (text, _), end in zip(mistake_counts(likeliest, lang), more, strict=True)])
    _count_students(axes, lang)


def _scores(axes: Axes, report: ClassReport, lang: Lang) -> None:
    width = 100 / RANGES
    if not any(report.ranges):
        _write_instead(axes, say("class_report.nobody marked", lang))
        return
    starts = [k * width for k in range(RANGES)]
    axes.bar(starts, report.ranges, width=width, align="edge", color="#bbbbbb", edgecolor="black", linewidth=0.6)
    axes.set_xlim(0, 100)
    axes.set_xlabel(say("platforms.column score percent", lang), fontsize=8)
    axes.set_ylabel(say("class_report.students", lang), fontsize=8)
    _count_in_wholes(axes.yaxis)


def _count_students(axes: Axes, lang: Lang) -> None:
    axes.set_xlabel(say("class_report.students", lang), fontsize=8)
    _count_in_wholes(axes.xaxis)


def _write_instead(axes: Axes, *texts: str) -> None:
    """Words in place of a diagram of nothing."""
    axes.set_axis_off()
    axes.text(0.0, 1.0, "\n".join(texts), fontsize=8, va="top", parse_math=False, transform=axes.transAxes)


def _name_rows(axes: Axes, names: list[str]) -> None:
    """Names beside the bars, the first above, their symbols as formulas."""
    from matplotlib.offsetbox import AnnotationBbox, HPacker, VPacker

    axes.set_yticks(range(len(names)), [""] * len(names))
    for row, name in enumerate(names):
        lines = _shortened(writable(name)).split("\n")
        packed: list[Artist] = [HPacker(children=[*pieces(line, 8)], align="baseline", pad=0, sep=0) for line in lines]
        box = VPacker(children=packed, align="right", pad=0, sep=_SPACE)
        axes.add_artist(AnnotationBbox(box, (0, row), (-_OFF, 0), ("axes fraction", "data"), "offset points",
                                       box_alignment=(1.0, 0.5), frameon=False, pad=0))  # fmt: skip
    axes.set_ylim(max(len(names), 1) - 0.4, -0.6)


def _shortened(name: str) -> str:
    """As much of a name as there is room for beside a row, in two lines."""
    lines, wide = [""], 0
    for letter in name:
        wide += 2 if is_wide(letter) else 1
        if wide > _LONGEST:
            if len(lines) > 1:
                return "\n".join(lines)[:-2] + ".."
            whole, space, rest = lines[0].rpartition(" ")
            space = "" if any(map(is_wide, rest)) else space
            lines, wide = ([whole, rest] if space else [lines[0], ""]), len(rest) if space else 0
        lines[-1] += letter
    return "\n".join(lines)


def _count_in_wholes(axis: Axis) -> None:
    """Whole numbers alone: students are counted."""
    from matplotlib.ticker import MaxNLocator

    axis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
