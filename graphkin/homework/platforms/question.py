"""A problem as a platform asks it, made of a key: text, and numbers in the units that a student types them in; and the
answers to a number, in the order in which they are tried: the one value that every format of a set writes.

The first alternative within its tolerance counts, as in Moodle: right ones first, then half of the points for the right
one with the other sense, as `grade` gives, then mistakes, the narrowest first. A mistake that cannot be told from the
right value is left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import Lang, NoRightNumber
from graphkin.homework.platforms.tables import rounded, tolerated
from graphkin.marking.key import Key, KeyEntry
from graphkin.model.quantities import EDGE, at_position
from graphkin.say.catalogue import LANGUAGES, say
from graphkin.say.marks import joined, mistake
from graphkin.say.names import in_signs, symbols

Text = Mapping[Lang, str]  # a text in each language


def texts_in(texts: Sequence[Text], lang: Lang) -> list[str]:
    """Texts in a language, or in the other where that is all there is; each once."""
    return list(dict.fromkeys(text.get(lang) or next(iter(text.values()), "") for text in texts))


@frozen
class Wrong:
    """A number that follows from a known mistake.

    ids      of mistakes that all give it; mistake: in words, to stand after `is consistent with`
    form     what was taken instead: mistakes of one id and form that give one number cannot be told apart by it
    """

    ids: tuple[str, ...]
    number: float
    tolerance: float
    mistake: Text
    form: str = ""


@frozen
class Part:
    """One quantity that is asked for.

    name    as it is read: "omega 3"; `label`: as the sheets write it
    number  the right one, in `unit`; `also`: others that are as right, such as an angle and a turn more
    points  for a right number; has_sense: half of them for its opposite
    """

    name: str
    number: float
    tolerance: float
    unit: str
    points: float = 1.0
    wrongs: tuple[Wrong, ...] = ()
    also: tuple[float, ...] = ()
    label: str = ""
    has_sense: bool = False

    @property
    def shown(self) -> str:
        """`ω3`."""
        return self.label or self.name

    @property
    def heading(self) -> str:
        """`ω3 (rad/s)`."""
        return self.shown + (f" ({self.unit})" if self.unit else "")


@frozen
class Question:
    """One student's problem.

    id      the student's or the variant's
    text    in lines, its quantities in the letters of the field
    figure  as SVG, `shows` in words; empty where there is none
    points  the letters of the mechanism's points
    """

    id: str
    text: Text
    parts: tuple[Part, ...]
    figure: bytes = b""
    shows: str = ""
    points: Sequence[str] = ()


@frozen
class ProblemSet:
    """The problems of a class."""

    name: str
    questions: Sequence[Question]


def question_of(
    id: str, key: Key, text: Text, figure: bytes = b"", shows: str = "", points: Sequence[str] = ()
) -> Question:
    """The questions of a key; the rest as Question has it."""
    parts = []
    for at, here in enumerate(key.positions, 1):
        for column, entry in enumerate(here.entries):
            if not entry.points:
                continue
            name, unit = at_position(entry.text, at), EDGE[entry.unit]
            # an angle is as right with a turn more or less, a size with a minus
            others = {"angle": entry.right - math.copysign(math.tau, entry.right), "size": -entry.right}
            also = (others[entry.sort],) if entry.sort in others else ()
            parts.append(Part(
                name, entry.right * unit.factor, entry.allowed * unit.factor, unit.sign, entry.points,
                tuple(_wrongs(here, column, entry)), tuple(number * unit.factor for number in also),
                at_position(symbols(entry.text), at),
                has_sense=entry.sort == "sense" and entry.doubt in ("", "steep") and abs(entry.right) > entry.tolerance,
            ))  # fmt: skip
    return Question(id, text, tuple(parts), figure, shows, points)


def in_letters(text: str, names: Iterable[str]) -> str:
    """A text with these quantities, with rotations and arrows as the sheets write them."""
    return in_signs(text, {name for whole in names for name in (whole, whole.split(" #")[0].split(" @")[0])})


def _wrongs(key: Key, column: int, entry: KeyEntry) -> Iterator[Wrong]:
    """The number that each mistake gives for this quantity, as far as it gives one."""
    factor, mistakes, asked = EDGE[entry.unit].factor, key.singles, [one.text for one in key.entries]
    columns = zip(mistakes.names, mistakes.values[:, column], mistakes.scatters[:, column], strict=True)
    for names, value, scatter in columns:
        if np.isfinite(value) and np.isfinite(scatter):
            number = abs(float(value)) if entry.sort == "size" else float(value)
            words = {lang: in_letters(mistake(names[0], lang), asked) for lang in LANGUAGES}
            yield Wrong((names[0][0],), number * factor, key.marking.sigmas * float(scatter) * factor, words,
                        form=names[0][3])  # fmt: skip


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
