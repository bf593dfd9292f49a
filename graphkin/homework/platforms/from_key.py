"""A platform's question, made of a key: numbers as a student types them, and every single mistake's number."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from graphkin.homework.platforms.question import Part, Question, Text, Wrong
from graphkin.marking.key import Key, KeyEntry
from graphkin.model.quantities import EDGE, at_position
from graphkin.say.catalogue import LANGUAGES
from graphkin.say.marks import mistake

_TURN = 2 * math.pi


def question_of(id: str, key: Key, text: Text) -> Question:
    """What a key asks for. id: the student's or the variant's; text: the problem as it is told."""
    parts = (_part(each, at, n) for at, each in enumerate(key.positions, 1) for n in range(len(each.entries)))
    return Question(id, text, tuple(part for part in parts if part.points))


def _part(key: Key, at: int, column: int) -> Part:
    """A quantity at a position."""
    entry = key.entries[column]
    unit = EDGE[entry.unit]
    return Part(
        at_position(entry.text, at), entry.right * unit.factor, entry.allowed * unit.factor, unit.sign, entry.points,
        tuple(_wrongs(key, column, entry)), tuple(number * unit.factor for number in _also(entry)),
    )  # fmt: skip


def _also(entry: KeyEntry) -> tuple[float, ...]:
    """An angle is as right with a turn more or less."""
    if entry.sort != "angle":
        return ()
    return (entry.right - math.copysign(_TURN, entry.right),)


def _wrongs(key: Key, column: int, entry: KeyEntry) -> Iterator[Wrong]:
    """What each mistake gives for this quantity, as far as it says anything of it."""
    factor, mistakes = EDGE[entry.unit].factor, key.singles
    for names, value, scatter in zip(
        mistakes.names, mistakes.values[:, column], mistakes.scatters[:, column], strict=True
    ):
        if np.isfinite(value) and np.isfinite(scatter):
            number = abs(float(value)) if entry.sort == "size" else float(value)
            words = {lang: mistake(names[0], lang) for lang in LANGUAGES}
            yield Wrong((names[0][0],), number * factor, key.marking.sigmas * float(scatter) * factor, words,
                        form=names[0][3])  # fmt: skip
