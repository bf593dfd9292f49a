"""Feedback to a student about a submission, in stages: hint, mistake, answer."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import Literal

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework.platforms.markup import one_line
from graphkin.homework.platforms.question import in_letters
from graphkin.homework.platforms.result import Result, ResultPicture, most_of, points_of
from graphkin.homework.platforms.tables import exponentless
from graphkin.marking.diagnosis import SLIP, Explanation, Habit
from graphkin.marking.mistakes.conversions import PLACES
from graphkin.marking.records import Judged
from graphkin.marking.scene import MISTAKES
from graphkin.model.quantities import EDGE
from graphkin.say.boards import fault_lines, line_name, step_line
from graphkin.say.catalogue import say
from graphkin.say.marks import departs, how_sure, joined, mistake_kind, mistakes_together, verdict
from graphkin.say.numbers import number

_NAMED = 4  # of what is to be done again not more quantities are named
Reveal = Literal["hint", "mistake", "answer"]
"""A hint: the verdicts, and where to look again; a mistake: what the numbers are consistent with; the right values."""


@frozen
class Feedback:
    """The feedback on a result in a language; with pictures, where what it is written as shows any.

    names    of the students by id, as far as a list of the class has them
    problem  its figure, under its title
    """

    result: Result
    lang: Lang
    reveal: Reveal
    pictures: Sequence[ResultPicture] = ()
    names: Mapping[str, str] = field(default_factory=dict)
    problem: ResultPicture | None = None


def title(page: Feedback) -> str:
    """The title of a student's page."""
    return say("feedback.title for", page.lang, student=called(page.result.student, page.names, page.lang))


def called(student: str, names: Mapping[str, str], lang: Lang) -> str:
    """A student by name, as far as it is known by the id, and id."""
    name = names.get(student, student) or student
    return one_line(student if name == student else say("feedback.student", lang, name=name, student=student))


def table(page: Feedback) -> Iterator[tuple[str, ...]]:
    """Quantities in columns, under their heads; the first column and the last but one are words, the others numbers."""
    right = [say("feedback.column right", page.lang)] if page.reveal == "answer" else []
    first = [say(name, page.lang) for name in ("marks.column quantity", "feedback.column given")]
    yield (*first, *right, *(say(name, page.lang) for name in ("marks.column verdict", "platforms.column points")))
    for line in page.result.lines:
        values = [one_line(line.written) if line.given is None else shown(line.given, line.unit)]
        if line.of_equations and line.given is not None:
            values = [say("feedback.count", page.lang, right=number(line.given), count=number(line.right))]
        values += [right_value(line)] if right else []
        points, most = exponentless(points_of(line)), exponentless(most_of(line))
        points = "–" if line.written else points  # until the teacher has looked
        worth = say("feedback.of", page.lang, points=points, most=most) if line.points else ""
        yield (as_on_sheets(page.result, line_name(line.text, page.lang)), *values, verdict(line, page.lang), worth)


def right_value(line: Judged) -> str:
    """`62.22 ± 3.1 rad/s²`."""
    edge = EDGE.get(line.unit)
    factor, unit = (1.0, f" {line.unit}".rstrip()) if edge is None else (edge.factor, edge.after)
    if line.of_equations:
        return number(line.right)
    return f"{number(line.right * factor)} ± {number(line.tolerance * factor, digits=2)}{unit}"


def as_on_sheets(result: Result, text: str) -> str:
    """A text with the quantities and the arrows of the problem as the sheets write them: ω3, aᵏ_B3B2."""
    return in_letters(text, (line.text for line in result.lines))


def under_table(page: Feedback) -> Iterator[str]:
    """The arithmetic, and what carried means."""
    result, lang = page.result, page.lang
    sentences: dict[str, list[str]] = {}  # one for all quantities of which the same is said
    for line in result.lines:
        for text in arithmetic(result, line, lang, page.reveal):
            sentences.setdefault(text, []).append(as_on_sheets(result, line.text))
    for text, names in sentences.items():
        name = say("common.list", lang).join(names)
        yield say("feedback.stop", lang, text=say("feedback.line", lang, name=name, verdict=text))
    if any(line.verdict == "carried" for line in result.lines):
        yield say("verdicts.carried means", lang)


def praise(result: Result, lang: Lang) -> str:
    """A word to good work; nothing where there is none."""
    every = [line for line in result.lines if line.points or line.written] or result.lines
    carried = sum(line.verdict == "carried" for line in every)
    right = sum(line.verdict not in ("wrong", "missing", "not read", "carried") for line in every)
    if carried:
        return say("feedback.praise carried", lang, right=right, count=len(every), carried=carried, which=carried > 1)
    if not right:
        return ""
    whole = not any(line.verdict == "wrong" or line.written for line in result.lines)
    if right == len(every):
        return say("feedback.praise all" if whole else "feedback.praise asked", lang)
    much = "most" if 3 * right >= 2 * len(every) else "some"
    return say(f"feedback.praise {much}", lang, right=right, count=len(every))


def next_step(page: Feedback) -> str:
    """The one thing to do next; nothing where all is right."""
    result, lang = page.result, page.lang
    if page.reveal == "hint" and result.suspicions:
        return _look(result.suspicions[0], lang)
    for kind, names in _to_do(result):
        if names:
            asked = [line.text for line in result.lines if line.points and line.text in names] or names
            listed = as_on_sheets(result, say("common.list", lang).join(asked[:_NAMED]))
            look = _look(result.suspicions[0], lang) if kind == "mistake" else ""
            return say(f"feedback.next {kind}", lang, look=look, names=listed)
    return ""


def _to_do(result: Result) -> Iterator[tuple[str, list[str]]]:
    """All that there may be to do, the most useful first, with the quantities."""
    wrong = [line for line in result.lines if line.verdict == "wrong" and not line.of_equations]
    turned = [line.text for line in wrong if line.reversed]
    sense = [line.text for line in wrong if line.credit and line.sense == "wrong" and not line.reversed]
    yield "unread", [line.text for line in result.lines if line.written]
    yield "reversed", turned if len(wrong) == 1 else []
    yield "sense", sense if len(wrong) == 1 else []
    yield "step", [str(result.step.step)] if result.step is not None else []
    if result.suspicions:
        yield "mistake", [*result.suspicions[0].explains]
    yield "unit", [line.text for line in wrong if not line.unit_right]
    left = [result.departure.text] if result.departure is not None else []
    if not left or left[0] in (*sense, *turned):  # else another value leaves the right way before these
        yield "reversed", turned
        yield "sense", sorted(sense, key=lambda text: text not in left)
    yield "point", [line.text for line in wrong if line.text in left and shifted_point(line)]
    yield "departure", left
    yield "wrong", [line.text for line in wrong][:1]
    yield "equation", [str(one.term) for one in result.faults]
    yield "missing", [line.text for line in result.lines if line.verdict == "missing" and line.points]


_PLACE = re.compile(r"^[^\n]*?\.\w{1,5}(?:![^\n]*?)?(?::\d+)?(?:, (?P<key>[^:：\n]{1,80}))?[:：] ?(?=\S)")
_FOLDERS = re.compile(r"(?:[^\s/\\'\"：，]*[/\\])+([^/\\\s:：]+\.\w{1,5})(?::\d+)?")


def without_place(text: str, lang: Lang) -> str:
    """A sentence about a file without its path, which is of the teacher's machine; the key in the file is kept."""
    match = _PLACE.match(text)
    rest = text if match is None else text[match.end() :]
    key = "" if match is None else (match["key"] or "").removeprefix("answers.")
    return (key and key + say("common.colon", lang)) + _FOLDERS.sub(r"\1", rest)


def at_the_end(page: Feedback) -> Iterator[str]:
    """Notes on what was passed over; of what was not marked, why."""
    if page.result.status == "not marked":
        yield reason(page.result, page.lang)
    yield from (say("feedback.note", page.lang, note=as_on_sheets(page.result, without_place(note, page.lang)))
                for note in page.result.notes)  # fmt: skip


def lines(result: Result, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """All of it, a sentence a line."""
    for each in result.lines:
        yield say("feedback.stop", lang, text=quantity(result, each, lang, reveal))
    yield from diagnosis(result, lang, reveal)
    page = Feedback(result, lang, reveal)
    yield from filter(None, (praise(result, lang), "" if reveal == "hint" else next_step(page)))
    yield from at_the_end(page)
    yield from points_that_count(result, lang)


def reason(result: Result, lang: Lang) -> str:
    """The reason why it was not marked."""
    unread = [one_line(line.written) for line in result.lines if line.written]
    without = "feedback.waits" if unread else "feedback.no reason"
    why = result.reason or say(without, lang, written=say("common.list", lang).join(unread))
    return say("feedback.not marked why", lang, reason=without_place(why, lang))


def quantity(result: Result, line: Judged, lang: Lang, reveal: Reveal) -> str:
    """One quantity: verdict, the number that was handed in, the right one where that is told, points."""
    name = as_on_sheets(result, line_name(line.text, lang))
    texts = [say("feedback.line", lang, name=name, verdict=verdict(line, lang))]
    if line.given is not None:
        texts.append(say("feedback.given", lang, value=shown(line.given, line.unit)))
    elif line.written:
        texts.append(say("feedback.given", lang, value=one_line(line.written)))
    texts += arithmetic(result, line, lang, reveal)
    if reveal == "answer":
        texts.append(say("feedback.answer", lang, value=right_value(line)))
    if line.points and not line.written:
        earned, most = exponentless(points_of(line)), exponentless(most_of(line))
        texts.append(say("feedback.points of", lang, points=earned, most=most))
    return say("common.semicolon", lang).join(texts)


def arithmetic(result: Result, line: Judged, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """`judged with your omega 3 = 5.65 rad/s: it should be 3.63 m/s^2: yes`, where that may be told."""
    shows = reveal == "answer" or (reveal == "mistake" and line.verdict == "carried")
    useful = line.verdict == "carried" or not any(line.text in one.explains for one in result.suspicions)
    if line.of_mistake:
        gives = "" if line.carried is None else say("common.note", lang, note=shown(line.carried, line.unit))
        yield from [] if reveal == "hint" else [say("feedback.follows", lang, value=gives)]
    elif line.carried is not None and line.own and shows and useful:
        units = {other.text: other.unit for other in result.lines}
        values = (f"{as_on_sheets(result, name)} = {shown(x, units.get(name, ''))}" for name, x in line.own.items())
        own = say("common.list", lang).join(values)
        agrees = say("feedback.yes" if line.verdict == "carried" else "feedback.no", lang)
        yield say("feedback.carried", lang, own=own, value=shown(line.carried, line.unit), agrees=agrees)
    if line.reversed and reveal != "hint":
        yield say("feedback.reversed", lang)
    if useful and reveal != "hint" and (form := shifted_point(line)):
        yield say(f"feedback.point {form}", lang)


def shifted_point(line: Judged) -> str:
    """The factor of a value that is wrong by its decimal point alone, `10` or `1/10`; "" of another."""
    if line.verdict != "wrong" or line.given is None or not line.unit_right or line.of_equations:
        return ""
    meant = [line.right, *([] if line.carried is None else [line.carried])]
    given = line.given
    return next((form for form, factor in PLACES.items() for value in meant
                 if value and abs(given / factor - value) <= line.tolerance), "")  # fmt: skip


def shown(value: float, unit: str) -> str:
    """In four digits, as a drawing has hardly more."""
    if unit not in EDGE:
        return f"{number(value)} {unit}".rstrip()
    return f"{number(value * EDGE[unit].factor)}{EDGE[unit].after}"


def diagnosis(result: Result, lang: Lang, reveal: Reveal) -> Iterator[str]:
    """The mistakes of the numbers, or, as a hint, where to look again; of numbers that no mistake explains, where they
    leave the right way; then mistakes that show in several problems."""
    plain = [line.text for line in result.lines if line.reversed or shifted_point(line)]  # their lines say how
    if result.departure is not None and not result.suspicions and result.departure.text not in plain:
        text = say("feedback.stop", lang, text=departs(result.departure, lang, in_full=reveal != "hint"))
        yield as_on_sheets(result, text)
    steps = [] if result.step is None else [step_line(result.step, lang, in_full=reveal != "hint")]
    for line in (*fault_lines(result.faults, lang, in_full=reveal == "answer"), *steps):
        yield as_on_sheets(result, say("feedback.stop", lang, text=line))
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
    """A wrong sense by instant centres is looked for as one that was read off."""
    ways = [(id, "") for id in one.ids] if isinstance(one, Habit) else [name[:2] for each in one.names for name in each]
    ids = ["omega-sense" if name == ("centre-ratio", "sense") else name[0] for name in ways]
    topics = dict.fromkeys(SLIP if id == SLIP else MISTAKES[id].topic for id in ids if id in (SLIP, *MISTAKES))
    return [say(f"mistakes.look {topic}", lang) for topic in topics]


def _look(one: Explanation, lang: Lang) -> str:
    """The places to look at again: those all explanations share; of some that the values do not tell apart none."""
    every, between = _hints(one, lang), say("feedback.between", lang)
    each = [_hints(replace(one, names=(names,)), lang) for names in one.names]
    shared = [hint for hint in every if all(hint in hints for hints in each)]
    places = between.join(hint for hint in every if hint not in shared)
    one_of = [say("feedback.next one of", lang, places=places)] if len(every) > len(shared) + 1 else []
    return between.join((*shared, *one_of))


def suspected(one: Explanation, lang: Lang) -> str:
    """The mistakes in words."""
    return joined(_in_words(one, lang), lang)


def _in_words(one: Explanation, lang: Lang) -> list[str]:
    return [mistakes_together(names, lang) for names in one.names]


def points_that_count(result: Result, lang: Lang) -> Iterator[str]:
    """The points that count, and that the teacher gave them, or what they wait for; and what the teacher writes."""
    most = exponentless(result.most)
    if result.override is not None:
        yield say("feedback.override", lang, points=exponentless(result.override), most=most)
    if result.total is not None:
        yield say("feedback.total", lang, points=exponentless(result.total), most=most)
    elif result.status == "marked":
        names = say("common.list", lang).join(line.text for line in result.lines if line.written)
        yield as_on_sheets(result, say("feedback.no total", lang, names=names))
    if result.comment:
        yield say("feedback.comment", lang, comment=one_line(result.comment))
