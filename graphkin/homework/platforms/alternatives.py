"""The answers to a number, in the order in which they are tried: the one value that every format of a set writes.

The first alternative within its tolerance counts, as in Moodle: right ones first, then half of the points for the right
one with the other sense, as `grade` gives, then mistakes, the narrowest first. A mistake that cannot be told from the
right value is left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from decimal import Decimal

from graphkin.base.value import frozen
from graphkin.errors import Lang, NoRightNumber
from graphkin.homework.platforms.question import Part, Question, Text, Wrong
from graphkin.homework.platforms.result import texts_in
from graphkin.homework.platforms.tables import points, rounded, tolerated
from graphkin.say.catalogue import say
from graphkin.say.marks import joined


@frozen
class Alternative:
    """A number, its tolerance, and its share of the points.

    mistakes  in words, where it is one; more than one cannot be told apart at this number
    """

    number: Decimal
    tolerance: Decimal
    percent: int
    ids: tuple[str, ...] = ()
    mistakes: tuple[Text, ...] = ()

    def holds(self, number: Decimal) -> bool:
        """True where a number counts as this one."""
        return abs(number - self.number) <= self.tolerance


def alternatives(question: Question, part: Part) -> tuple[Alternative, ...]:
    """All that a number can be, in order. Raises NoRightNumber where the key has no right number."""
    refuse(question, part)
    tolerance = tolerated(part.tolerance)
    right = [Alternative(rounded(number, part.tolerance), tolerance, 100) for number in (part.number, *part.also)]
    wrongs = _told_apart(right, _mistakes(part.wrongs))
    if not part.has_sense:
        return (*right, *wrongs)
    other = Alternative(-right[0].number, tolerance, 50)
    alike = [one for one in wrongs if other.holds(one.number)]
    ids = tuple(dict.fromkeys(id for one in alike for id in one.ids))
    return (*right, replace(other, ids=ids, mistakes=tuple(text for one in alike for text in one.mistakes)), *wrongs)


def most(question: Question) -> Decimal:
    """The points of a question."""
    return sum((points(part.points) for part in question.parts), Decimal(0))


def sentence(alternative: Alternative, lang: Lang) -> str:
    """The answer to a number, in words."""
    if not alternative.ids:
        return say("feedback.right" if alternative.percent == 100 else "feedback.other sense", lang)
    mistake = joined(texts_in(alternative.mistakes, lang), lang)
    return say("feedback.stop", lang, text=say("feedback.number consistent", lang, mistake=mistake))


def refuse(question: Question, part: Part) -> None:
    """Raises NoRightNumber where a part has no right number, no tolerance or no points."""
    finite = all(map(math.isfinite, (part.number, part.tolerance, part.points, *part.also)))
    if not finite or part.tolerance < 0 or part.points < 0:
        raise NoRightNumber(question.id, part.name)


def _mistakes(wrongs: Iterable[Wrong]) -> list[Alternative]:
    """Mistakes as alternatives, by rising tolerance; those that give no number are not there. A factor of one value, of
    all that follows, and of all values of its unit is the same for one number: it is told once, in the fewest words."""
    mistakes: dict[tuple[object, ...], Alternative] = {}
    for k, wrong in enumerate(wrongs):
        if math.isfinite(wrong.number) and math.isfinite(wrong.tolerance) and wrong.tolerance >= 0:
            number, tolerance = rounded(wrong.number, wrong.tolerance), tolerated(wrong.tolerance)
            one = Alternative(number, tolerance, 0, wrong.ids, (wrong.mistake,))
            same = (wrong.ids, wrong.form, f"{wrong.number:.9g}") if wrong.form else (k,)
            if same not in mistakes or _length(one) < _length(mistakes[same]):
                mistakes[same] = one
    return sorted(mistakes.values(), key=lambda one: one.tolerance)


def _length(one: Alternative) -> int:
    return sum(len(words) for text in one.mistakes for words in text.values())


def _told_apart(right: Sequence[Alternative], mistakes: Sequence[Alternative]) -> tuple[Alternative, ...]:
    """Mistakes that do not touch the right value; one that holds another's number names that one, too."""
    apart: list[Alternative] = []
    near: list[Alternative] = []
    for one in mistakes:
        touching = any(abs(one.number - good.number) <= one.tolerance + good.tolerance for good in right)
        (near if touching else apart).append(one)
    answers: list[Alternative] = []
    for k, one in enumerate(apart):
        alike = [other for other in (*apart[k:], *near) if one.holds(other.number)]
        if not any(before.number == one.number and before.tolerance == one.tolerance for before in answers):
            ids = tuple(dict.fromkeys(name for other in alike for name in other.ids))
            texts = tuple(text for other in alike for text in other.mistakes)
            answers.append(Alternative(one.number, one.tolerance, 0, ids, texts))
    return tuple(answers)
