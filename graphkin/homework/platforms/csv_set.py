"""A problem set as a table: a row an answer, with its share of the points and what is said to it."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.errors import Lang
from graphkin.homework.platforms.alternatives import alternatives, sentence
from graphkin.homework.platforms.cells import BOM, line
from graphkin.homework.platforms.numbers import points
from graphkin.homework.platforms.question import ProblemSet
from graphkin.say.catalogue import say

HEADERS = ("student", "text", "quantity", "unit", "points", "percent", "number", "tolerance", "mistakes", "sentence")


def head(lang: Lang) -> str:
    """The names of the columns."""
    return BOM + line(say(f"platforms.column {name}", lang) for name in HEADERS)


def lines(problems: ProblemSet, lang: Lang) -> Iterator[str]:
    """The table, row by row."""
    yield head(lang)
    for question in problems.questions:
        for part in question.parts:
            for one in alternatives(question, part):
                yield line((
                    question.id, question.text[lang], part.name, part.unit, points(part.points), one.percent,
                    one.number, one.tolerance, " ".join(one.ids), sentence(one, lang),
                ))  # fmt: skip
