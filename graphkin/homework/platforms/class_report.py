"""The report of a class, as data: the steps that fail, the mistakes that explain its numbers, the spread of scores."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field, replace
from decimal import Decimal
from typing import get_args

from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework.platforms.feedback import habit, suspected
from graphkin.homework.platforms.result import Result, Suspicion
from graphkin.homework.platforms.tables import exponentless
from graphkin.marking.diagnosis import Habit
from graphkin.marking.records import Verdict
from graphkin.say.catalogue import say

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
    unread       answers that were not read: student, quantity, text; and how many there are
    unexplained  how many are wrong somewhere and consistent with no known mistake
    ranges       how many scores in each tenth, the lowest first; the last holds 100 %
    remarks      what the teacher should look at: student, file, remark
    mean, ..     of the scores, from 0 to 1; None where there are none
    """

    marked: int
    unmarked: int
    overridden: int
    steps: tuple[ReportStep, ...]
    mistakes: tuple[tuple[Suspicion, int], ...]
    unexplained: int
    ranges: tuple[int, ...]
    habits: tuple[tuple[Habit, int], ...] = ()
    unread: tuple[tuple[str, str, str], ...] = ()
    not_read: int = 0
    remarks: tuple[tuple[str, str, str], ...] = ()
    mean: Decimal | None = None
    median: Decimal | None = None
    lowest: Decimal | None = None
    highest: Decimal | None = None


def class_report(results: Iterable[Result]) -> ClassReport:
    """The report of a class, gone through once; what is held does not grow with it."""
    count = _Count()
    for result in results:
        count.add(result)
    return count.report()


@frozen
class _Count:
    """The counts while a class goes by."""

    status: Counter[str] = field(default_factory=Counter)
    verdicts: dict[str, Counter[str]] = field(default_factory=dict)
    first: Counter[str] = field(default_factory=Counter)
    points: dict[str, tuple[Decimal, Decimal]] = field(default_factory=dict)
    mistakes: dict[tuple[str, ...], tuple[Suspicion, int]] = field(default_factory=dict)
    scores: Counter[Decimal] = field(default_factory=Counter)
    habits: Counter[Habit] = field(default_factory=Counter)
    unread: list[tuple[str, str, str]] = field(default_factory=list)
    remarks: list[tuple[str, str, str]] = field(default_factory=list)

    def add(self, result: Result) -> None:
        self.status[result.status] += 1
        self.status["overridden"] += result.override is not None
        self.remarks.extend((result.student, result.file, remark) for remark in result.remarks)
        if result.score is not None:
            self.scores[result.score] += 1
        if result.status != "marked":
            return
        for line in result.lines:
            self.verdicts.setdefault(line.name, Counter())[line.verdict] += 1
            earned, most = self.points.get(line.name, (Decimal(0), Decimal(0)))
            self.points[line.name] = earned + line.points, most + line.most
            self.status["not read"] += bool(line.written)
            if line.written and len(self.unread) < UNREAD:
                self.unread.append((result.student, line.name, line.written))
        failed = [line.name for verdict in _FAILED for line in result.lines if line.verdict == verdict]
        self.first.update(failed[:1])
        self.habits.update(replace(one, weight=0.0) for one in result.habits)
        if result.suspicions:
            best = result.suspicions[0]
            same = tuple(sorted(best.ids))  # a set is one, whichever of it is likelier to one student
            kept, count = self.mistakes.get(same, (best, 0))
            self.mistakes[same] = kept, count + 1
        elif any(line.verdict == "wrong" and line.unit_right for line in result.lines):
            self.status["unexplained"] += 1

    def report(self) -> ClassReport:
        counts = self.verdicts.items()
        every = (ReportStep(name, dict(each), self.first[name], *self.points[name]) for name, each in counts)
        shown = (*_FAILED, "not read")
        steps = tuple(step for step in every if step.most or any(step.verdicts.get(verdict) for verdict in shown))
        mistakes = sorted(self.mistakes.values(), key=lambda pair: (-pair[1], pair[0].ids))
        ranges = [0] * RANGES
        for score, count in self.scores.items():
            ranges[min(int(score * RANGES), RANGES - 1)] += count
        status, spread = self.status, list[Decimal]()  # mean, median, lowest, highest; nothing of nothing
        if self.scores:
            order, number = sorted(self.scores.elements()), self.scores.total()
            mean = sum((score * count for score, count in self.scores.items()), Decimal(0)) / number
            spread = [mean, (order[(number - 1) // 2] + order[number // 2]) / 2, order[0], order[-1]]
        return ClassReport(
            status["marked"], status["not marked"], status["overridden"], steps, tuple(mistakes),
            status["unexplained"], tuple(ranges), tuple(self.habits.most_common()), tuple(self.unread),
            status["not read"], tuple(self.remarks), *spread,
        )  # fmt: skip


def report_text(report: ClassReport, lang: Lang) -> Iterator[str]:
    """The report in lines."""
    yield say("class_report.marked", lang, marked=report.marked, unmarked=report.unmarked, overridden=report.overridden)
    spread = {key: getattr(report, key) for key in ("mean", "median", "lowest", "highest")}
    if report.mean is not None:
        percent = {key: exponentless((value * 100).quantize(Decimal("0.1"))) for key, value in spread.items()}
        yield say("class_report.scores", lang, **percent)
    mistakes = [say("class_report.mistake", lang, mistake=suspected(one, lang), count=n) for one, n in report.mistakes]
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
        verdicts = say("common.list", lang).join(counts)
        steps.append(say("class_report.step", lang, name=step.name, verdicts=verdicts, first=step.first))
    unread = [say("class_report.unread", lang, student=student, name=name, written=text)
              for student, name, text in report.unread]  # fmt: skip
    if report.not_read > len(unread):
        unread.append(say("marks.more", lang, count=report.not_read - len(unread)))
    remarks = [say("class_report.remark", lang, student=student, file=file, remark=remark)
               for student, file, remark in report.remarks]  # fmt: skip
    parts = {"remarks": remarks, "unread": unread, "steps": steps, "mistakes": mistakes, "habits": habits,
             "distribution": distribution}  # fmt: skip
    for title, texts in parts.items():
        if texts:
            yield from ("", say(f"class_report.part {title}", lang))
            yield from (f"  {text}" for text in texts)


def report_record(report: ClassReport) -> dict[str, Plain]:
    """The report as a JSON object."""
    spread = {key: getattr(report, key) for key in ("mean", "median", "lowest", "highest")}
    return {
        "kind": "graphkin", "format": 1, "marked": report.marked, "not_marked": report.unmarked,
        "overridden": report.overridden,
        **{key: None if value is None else round(float(value), 6) for key, value in spread.items()},
        "steps": [
            {"quantity": step.name, "verdicts": dict(step.verdicts), "first_to_fail": step.first,
             "points": float(step.points), "max_points": float(step.most)}
            for step in report.steps
        ],
        "mistakes": [{"ids": list(one.ids), "count": count} for one, count in report.mistakes],
        "not_read": [dict(zip(("student", "quantity", "written"), one)) for one in report.unread],
        "unexplained": report.unexplained, "ranges": list(report.ranges),
        "habits": [
            {"ids": list(one.ids), "in_problems": one.shown, "of_problems": one.of, "count": count}
            for one, count in report.habits
        ],
        "remarks": [{"student": who, "file": file, "remark": remark} for who, file, remark in report.remarks],
    }  # fmt: skip
