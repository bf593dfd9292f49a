"""Feedback to a student about a submission, in stages: hint, mistake, answer."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Literal

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework.platforms.markup import one_line
from graphkin.homework.platforms.question import texts_in
from graphkin.homework.platforms.result import Result, ResultPicture, most_of, points_of
from graphkin.homework.platforms.tables import exponentless
from graphkin.marking.diagnosis import SLIP, Explanation, Habit
from graphkin.marking.records import Judged
from graphkin.marking.scene import MISTAKES
from graphkin.model.quantities import EDGE
from graphkin.model.quantities.reading import respelled
from graphkin.say.catalogue import say
from graphkin.say.marks import departs, how_sure, joined, mistake_hint, mistake_kind, mistakes_together, verdict
from graphkin.say.names import symbols, vector
from graphkin.say.numbers import number

Reveal = Literal["hint", "mistake", "answer"]
"""A hint: the verdicts, and where to look again; a mistake: what the numbers are consistent with; the right values."""


@frozen
class Feedback:
    """The feedback on a result in a language; with pictures, where what it is written as shows any."""

    result: Result
    lang: Lang
    reveal: Reveal
    pictures: Sequence[ResultPicture] = ()


def title(page: Feedback) -> str:
    """The title of a student's page."""
    return say("feedback.title for", page.lang, student=one_line(page.result.student))


def table(page: Feedback) -> Iterator[tuple[str, ...]]:
    """Quantities in columns, under their heads; the first column and the last but one are words, the others numbers."""
    names = ["marks.column quantity", "feedback.column given", "marks.column verdict", "platforms.column points"]
    if page.reveal == "answer":
        names[2:2] = ["marks.column right value", "verdicts.tolerance"]
    yield tuple(say(name, page.lang) for name in names)
    for line in page.result.lines:
        numbers = [line.given, *([line.right, line.tolerance] if page.reveal == "answer" else [])]
        values = ["" if x is None else shown(x, line.unit) for x in numbers]
        values[0] = values[0] or one_line(line.written)
        points, most = exponentless(points_of(line)), exponentless(most_of(line))
        worth = say("feedback.of", page.lang, points=points, most=most) if most_of(line) else ""
        yield (as_on_sheets(page.result, line.text), *values, verdict(line, page.lang), worth)


def as_on_sheets(result: Result, text: str) -> str:
    """A text with the quantities and the arrows of the problem as the sheets write them: ω3, aᵏ_B3B2."""
    known = {name for line in result.lines for name in (line.text, line.text.split(" #")[0].split(" @")[0])}
    turning = ("theta ", "omega ", "alpha ")
    typed = respelled(text, lambda typed: symbols(typed) if typed in known or typed.startswith(turning) else typed)
    return re.sub(r"\b[va]\^[nktr]_[\w@]+", lambda arrow: vector(arrow[0]), typed)


def under_table(page: Feedback) -> Iterator[str]:
    """The arithmetic, and what the numbers are consistent with."""
    result, lang = page.result, page.lang
    for line in result.lines:
        for text in arithmetic(result, line, lang, page.reveal):
            name = as_on_sheets(result, line.text)
            yield say("feedback.stop", lang, text=say("feedback.line", lang, name=name, verdict=text))
    if any(line.verdict == "carried" for line in result.lines):
        yield say("verdicts.carried means", lang)
    yield from diagnosis(result, lang, page.reveal)


def at_the_end(page: Feedback) -> Iterator[str]:
    """Notes on what was passed over, and the points that count; of what was not marked, why."""
    if page.result.status == "not marked":
        yield reason(page.result, page.lang)
    yield from (say("feedback.note", page.lang, note=as_on_sheets(page.result, note)) for note in page.result.notes)
    yield from points_that_count(page.result, page.lang)


def lines(result: Result, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """All of it, a sentence a line."""
    for each in result.lines:
        yield say("feedback.stop", lang, text=quantity(result, each, lang, reveal))
    yield from diagnosis(result, lang, reveal)
    yield from at_the_end(Feedback(result, lang, reveal))


def reason(result: Result, lang: Lang) -> str:
    """Why it was not marked."""
    why = texts_in([result.reason], lang)[0] or say("feedback.no reason", lang)
    return say("feedback.not marked why", lang, reason=why)


def quantity(result: Result, line: Judged, lang: Lang, reveal: Reveal) -> str:
    """One quantity: verdict, the number that was handed in, the right one where that is told, points."""
    texts = [say("feedback.line", lang, name=as_on_sheets(result, line.text), verdict=verdict(line, lang))]
    if line.given is not None:
        texts.append(say("feedback.given", lang, value=shown(line.given, line.unit)))
    elif line.written:
        texts.append(say("feedback.given", lang, value=one_line(line.written)))
    texts += arithmetic(result, line, lang, reveal)
    if reveal == "answer":
        right, tolerance = shown(line.right, line.unit), shown(line.tolerance, line.unit)
        texts.append(say("feedback.answer", lang, value=right, tolerance=tolerance))
    if most := most_of(line):
        earned = exponentless(points_of(line))
        texts.append(say("feedback.points of", lang, points=earned, most=exponentless(most)))
    return say("common.semicolon", lang).join(texts)


def arithmetic(result: Result, line: Judged, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """`judged with your omega 3 = 5.65 rad/s: it should be 3.63 m/s^2: yes`, where that may be told."""
    shows = reveal == "answer" or (reveal == "mistake" and line.verdict == "carried")
    useful = line.verdict == "carried" or not any(line.text in one.explains for one in result.suspicions)
    if line.of_mistake:
        yield from [] if reveal == "hint" else [say("feedback.follows", lang)]
    elif line.carried is not None and line.own and shows and useful:
        units = {other.text: other.unit for other in result.lines}
        values = (f"{as_on_sheets(result, name)} = {shown(x, units.get(name, ''))}" for name, x in line.own.items())
        own = say("common.list", lang).join(values)
        agrees = say("feedback.yes" if line.verdict == "carried" else "feedback.no", lang)
        yield say("feedback.carried", lang, own=own, value=shown(line.carried, line.unit), agrees=agrees)


def shown(value: float, unit: str) -> str:
    """In four digits, as a drawing has hardly more."""
    if unit not in EDGE:
        return f"{number(value)} {unit}".rstrip()
    return f"{number(value * EDGE[unit].factor)}{EDGE[unit].after}"


def diagnosis(result: Result, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """The mistakes of the numbers, or, as a hint, where to look again; of numbers that no mistake explains, where they
    leave the right way; then mistakes that show in several problems."""
    if result.departure is not None and not result.suspicions:
        text = say("feedback.stop", lang, text=departs(result.departure, lang, in_full=reveal != "hint"))
        yield as_on_sheets(result, text)
    for one in result.suspicions:
        if reveal == "hint":
            yield from _hints(one, lang)
        else:
            explained = say("common.list", lang).join(one.explains)
            sure, mistake = how_sure(one.probability, _in_words(one, lang), lang), suspected(one, lang)
            text = say("feedback.consistent", lang, explains=explained, mistake=mistake, sure=sure)
            yield as_on_sheets(result, say("feedback.stop", lang, text=text))
    for shared in result.habits:
        whole = say("feedback.stop", lang, text=habit(shared, lang))
        text = " ".join(_hints(shared, lang)) if reveal == "hint" else whole
        yield say("feedback.habit", lang, shown=shared.shown, of=shared.of, told=text)


def habit(one: Habit, lang: Lang) -> str:
    """The mistakes in words, whatever they were made with."""
    return joined([mistake_kind(id, lang) for id in one.ids], lang)


def _hints(one: Explanation | Habit, lang: Lang) -> list[str]:
    topics = dict.fromkeys(SLIP if id == SLIP else MISTAKES[id].topic for id in one.ids if id in (SLIP, *MISTAKES))
    return [mistake_hint(topic, lang) for topic in topics]


def suspected(one: Explanation, lang: Lang) -> str:
    """The mistakes in words."""
    return joined(_in_words(one, lang), lang)


def _in_words(one: Explanation, lang: Lang) -> list[str]:
    return [mistakes_together(names, lang) for names in one.names]


def points_that_count(result: Result, lang: Lang) -> Iterator[str]:
    """That the teacher gave them, and the points that count; nothing where there are none."""
    most = exponentless(result.most)
    if result.override is not None:
        yield say("feedback.override", lang, points=exponentless(result.override), most=most)
    if result.total is not None:
        yield say("feedback.total", lang, points=exponentless(result.total), most=most)
