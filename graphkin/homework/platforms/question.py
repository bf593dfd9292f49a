"""A problem as a platform asks it: text, and numbers in the units that a student types them in; made of a key."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.marking.key import Key, KeyEntry
from graphkin.model.quantities import EDGE, at_position
from graphkin.say.catalogue import LANGUAGES
from graphkin.say.marks import mistake

Text = Mapping[Lang, str]  # a text in each language


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

    name    as it is read: "omega 3"; `label`: as it is printed
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
    def heading(self) -> str:
        """`ω3 (rad/s)`."""
        return (self.label or self.name) + (f" ({self.unit})" if self.unit else "")


@frozen
class Question:
    """One student's problem. id: the student's or the variant's."""

    id: str
    text: Text
    parts: tuple[Part, ...]


@frozen
class ProblemSet:
    """The problems of a class."""

    name: str
    questions: Sequence[Question]


def question_of(id: str, key: Key, text: Text) -> Question:
    """The questions of a key. id: the student's or the variant's; text: the problem in words."""
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
                has_sense=entry.sort == "sense" and entry.doubt in ("", "steep") and abs(entry.right) > entry.tolerance,
            ))  # fmt: skip
    return Question(id, text, tuple(parts))


def _wrongs(key: Key, column: int, entry: KeyEntry) -> Iterator[Wrong]:
    """The number that each mistake gives for this quantity, as far as it gives one."""
    factor, mistakes = EDGE[entry.unit].factor, key.singles
    columns = zip(mistakes.names, mistakes.values[:, column], mistakes.scatters[:, column], strict=True)
    for names, value, scatter in columns:
        if np.isfinite(value) and np.isfinite(scatter):
            number = abs(float(value)) if entry.sort == "size" else float(value)
            words = {lang: mistake(names[0], lang) for lang in LANGUAGES}
            yield Wrong((names[0][0],), number * factor, key.marking.sigmas * float(scatter) * factor, words,
                        form=names[0][3])  # fmt: skip
