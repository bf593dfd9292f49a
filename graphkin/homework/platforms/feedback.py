"""What a student is told about a submission, in stages: hint, mistake, answer."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework.platforms.marked_up import one_line
from graphkin.homework.platforms.numbers import exponentless
from graphkin.homework.platforms.result import Result, ResultLine, ResultPicture, Suspicion, texts_in
from graphkin.marking.diagnosis import Habit
from graphkin.marking.scene import MISTAKES
from graphkin.model.quantities import EDGE
from graphkin.model.quantities.typed import rewritten
from graphkin.say.catalogue import say
from graphkin.say.mistakes import hint, kind, once, together
from graphkin.say.names import asked
from graphkin.say.numbers import number
from graphkin.say.verdicts import verdict

Reveal = Literal["hint", "mistake", "answer"]
"""How much is told: the verdicts, and where to look again; what the numbers are consistent with; the right values."""
SETS = 4
"""So many mistakes that cannot be told apart are written out; of more the number is said."""


@frozen
class Feedback:
    """What a student is told, and in which language; with pictures, where what it is written as shows any."""

    result: Result
    lang: Lang
    reveal: Reveal
    pictures: Sequence[ResultPicture] = ()


def title(told: Feedback) -> str:
    return say("feedback.title for", told.lang, student=one_line(told.result.student))


def table(told: Feedback) -> Iterator[tuple[str, ...]]:
    """Quantities in columns, under their heads; the first column and the last but one are words, the others numbers."""
    names = ["marks.column quantity", "feedback.column given", "marks.column verdict", "platforms.column points"]
    if told.reveal == "answer":
        names[2:2] = ["marks.column right value", "verdicts.tolerance"]
    yield tuple(say(name, told.lang) for name in names)
    for line in told.result.lines:
        numbers = [line.given, *([line.right, line.tolerance] if told.reveal == "answer" else [])]
        values = ("" if x is None else shown(x, line.unit) for x in numbers)
        yield (_in_signs(told.result, line.name), *values, verdict(line, told.lang), _points(line, told.lang))


def _in_signs(result: Result, text: str) -> str:
    """A text with the quantities of the problem as the sheets write them: ω3, aᵏ_B3B2."""
    known = {name for line in result.lines for name in (line.name, line.name.split(" #")[0].split(" @")[0])}
    turning = ("theta ", "omega ", "alpha ")
    return rewritten(text, lambda typed: asked(typed) if typed in known or typed.startswith(turning) else typed)


def _points(line: ResultLine, lang: Lang) -> str:
    if not line.most:
        return ""
    return say("feedback.of", lang, points=exponentless(line.points), most=exponentless(line.most))


def under_table(told: Feedback) -> Iterator[str]:
    """The arithmetic, and what the numbers are consistent with."""
    result, lang = told.result, told.lang
    for line in result.lines:
        for text in arithmetic(result, line, lang, told.reveal):
            name = _in_signs(result, line.name)
            yield say("feedback.stop", lang, text=say("feedback.line", lang, name=name, verdict=text))
    if any(line.verdict == "carried" for line in result.lines):
        yield say("verdicts.carried means", lang)
    yield from diagnosis(result, lang, told.reveal)


def at_the_end(told: Feedback) -> Iterator[str]:
    """What was passed over, and the points that count; of what was not marked, why."""
    result, lang = told.result, told.lang
    if result.status == "not marked":
        yield reason(result, lang)
    yield from (say("feedback.note", lang, note=note) for note in result.notes)
    if text := override(result, lang):
        yield text
    if result.total is not None:
        yield total(result, lang)


def lines(result: Result, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """All of it, a sentence a line."""
    if result.status == "not marked":
        yield reason(result, lang)
    for each in result.lines:
        yield say("feedback.stop", lang, text=quantity(result, each, lang, reveal))
    yield from diagnosis(result, lang, reveal)
    yield from (say("feedback.note", lang, note=note) for note in result.notes)
    if told := override(result, lang):
        yield told
    if result.total is not None:
        yield total(result, lang)


def reason(result: Result, lang: Lang) -> str:
    """Why it was not marked."""
    told = texts_in([result.reason], lang)[0] or say("feedback.no reason", lang)
    return say("feedback.not marked why", lang, reason=told)


def quantity(result: Result, line: ResultLine, lang: Lang, reveal: Reveal) -> str:
    """One quantity: verdict, what was handed in, what it should be where that is told, points."""
    told = [say("feedback.line", lang, name=_in_signs(result, line.name), verdict=verdict(line, lang))]
    told += _numbers(result, line, lang, reveal)
    if line.most:
        told.append(say("feedback.points of", lang, points=exponentless(line.points), most=exponentless(line.most)))
    return say("common.semicolon", lang).join(told)


def _numbers(result: Result, line: ResultLine, lang: Lang, reveal: Reveal) -> Iterator[str]:
    if line.given is not None:
        yield say("feedback.given", lang, value=shown(line.given, line.unit))
    yield from arithmetic(result, line, lang, reveal)
    if reveal == "answer":
        right, tolerance = shown(line.right, line.unit), shown(line.tolerance, line.unit)
        yield say("feedback.answer", lang, value=right, tolerance=tolerance)


def arithmetic(result: Result, line: ResultLine, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """What follows from the student's own values, where it is judged by these and that may be told."""
    if line.carried is not None and (reveal == "answer" or (reveal == "mistake" and line.verdict == "carried")):
        yield _carried(result, line, line.carried, lang)


def _carried(result: Result, line: ResultLine, value: float, lang: Lang) -> str:
    """`judged with your omega 3 = 5.65 rad/s: it should be 3.63 m/s^2: yes`."""
    units = {other.name: other.unit for other in result.lines}
    given = (f"{_in_signs(result, name)} = {shown(x, units.get(name, ''))}" for name, x in line.own.items())
    own = say("common.list", lang).join(given)
    agrees = say("feedback.yes" if line.verdict == "carried" else "feedback.no", lang)
    return say("feedback.carried", lang, own=own, value=shown(value, line.unit), agrees=agrees)


def shown(value: float, unit: str) -> str:
    """In four digits, as a drawing has hardly more."""
    if unit not in EDGE:
        return f"{number(value)} {unit}".rstrip()
    return f"{number(value * EDGE[unit].factor)}{EDGE[unit].after}"


def diagnosis(result: Result, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """What the numbers are consistent with, or, as a hint, where to look again; then what shows in several problems."""
    for one in result.suspicions:
        if reveal == "hint":
            yield from _hints(one, lang)
        else:
            explained = say("common.list", lang).join(one.explains)
            told = say("feedback.consistent", lang, explains=explained, mistake=suspected(one, lang))
            yield _in_signs(result, say("feedback.stop", lang, text=told))
    yield from habits(result, lang, reveal)


def habits(result: Result, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """What shows in several problems of the student, or, as a hint, where to look again."""
    for one in result.habits:
        whole = say("feedback.stop", lang, text=habit(one, lang))
        told = " ".join(_hints(one, lang)) if reveal == "hint" else whole
        yield say("feedback.habit", lang, shown=one.shown, of=one.of, told=told)


def habit(one: Habit, lang: Lang) -> str:
    """The mistakes in words, whatever they were made with."""
    return joined([kind(id, lang) for id in one.ids], lang)


def _hints(one: Suspicion | Habit, lang: Lang) -> list[str]:
    topics = dict.fromkeys(MISTAKES[id].topic for id in one.ids if id in MISTAKES)
    return [hint(topic, lang) for topic in topics]


def suspected(one: Suspicion, lang: Lang) -> str:
    """The mistakes in words, or by their ids."""
    told = [together(names, lang) for names in one.names]
    return joined(told or list(one.ids), lang)


def joined(told: list[str], lang: Lang) -> str:
    """What cannot be told apart, as one."""
    each = once(text.strip().rstrip(".。") for text in told)
    if len(each) == 1:
        return each[0]
    more = [say("marks.more", lang, count=len(each) - SETS)] if len(each) > SETS else []
    return say("feedback.one of", lang, mistakes=say("feedback.or", lang).join([*each[:SETS], *more]))


def override(result: Result, lang: Lang) -> str:
    """That the teacher gave the points; nothing where not."""
    if result.override is None:
        return ""
    return say("feedback.override", lang, points=exponentless(result.override), most=exponentless(result.most))


def total(result: Result, lang: Lang) -> str:
    """The points that count. Only of a result that has some."""
    assert result.total is not None
    return say("feedback.total", lang, points=exponentless(result.total), most=exponentless(result.most))
