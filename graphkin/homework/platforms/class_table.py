"""The class as a table: a row a submission, in the order of the results; what CSV and XLSX write."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from decimal import Decimal

from graphkin.errors import Lang
from graphkin.homework.platforms.cells import Cell
from graphkin.homework.platforms.feedback import habit, suspected
from graphkin.homework.platforms.overrides import Overrides
from graphkin.homework.platforms.result import Result, ResultLine, texts_in
from graphkin.say.catalogue import say
from graphkin.say.marks import verdict

_FRONT = ("student", "file", "status", "earned", "most", "override", "total", "score percent")
_BACK = ("diagnosis", "reason")


def quantities(results: Iterable[Result]) -> tuple[str, ...]:
    """All that is asked anywhere, as it is met first, and what is wrong on the way."""
    met: dict[str, bool] = {}
    for line in (line for result in results for line in result.lines):
        met[line.name] = met.get(line.name, False) or bool(line.most) or line.verdict == "wrong"
    return tuple(name for name, told in met.items() if told)


def rows(
    results: Iterable[Result], names: tuple[str, ...], lang: Lang, several: bool = False
) -> Iterator[list[Cell]]:
    """The table with its head; with a last column, where this is one of several problems, for what shows in them."""
    yield [*_head(names, lang), *([say("platforms.column habits", lang)] if several else [])]
    for result in results:
        yield [*_row(result, names, lang), *([_habits(result, lang)] if several else [])]


def absent(overrides: Overrides, names: tuple[str, ...]) -> Iterator[list[Cell]]:
    """Overrides of those who are not among the results gone through so far; they keep a row each."""
    for each in overrides.rest():
        yield [each.student, each.file, "", None, None, each.points, *[None] * (2 + 2 * len(names) + len(_BACK))]


def _head(names: tuple[str, ...], lang: Lang) -> list[Cell]:
    front = [say(f"platforms.column {key}", lang) for key in _FRONT]
    middle = [text for name in names for text in (name, say("platforms.column part earned", lang, name=name))]
    return [*front, *middle, *(say(f"platforms.column {key}", lang) for key in _BACK)]


def _row(result: Result, names: tuple[str, ...], lang: Lang) -> list[Cell]:
    marked = result.status == "marked"
    front: list[Cell] = [
        result.student, result.file, say(f"verdicts.status {result.status}", lang),
        result.earned if marked else None, result.most, result.override, result.total, _percent(result.score),
    ]  # fmt: skip
    by_name = {line.name: line for line in result.lines}
    middle = [cell for name in names for cell in _cells(by_name.get(name), lang)]
    return [*front, *middle, _diagnosis(result, lang), texts_in([result.reason], lang)[0]]


def _percent(score: Decimal | None) -> Decimal | None:
    return None if score is None else (score * 100).quantize(Decimal("0.01"))


def _cells(line: ResultLine | None, lang: Lang) -> tuple[Cell, Cell]:
    return ("", None) if line is None else (verdict(line, lang), line.points)


def _habits(result: Result, lang: Lang) -> str:
    """With the evidence of all problems together."""
    told = (
        say("platforms.habit", lang, shown=one.shown, of=one.of, mistake=habit(one, lang), evidence=f"{one.weight:.1f}")
        for one in result.habits
    )
    return say("common.semicolon", lang).join(told)


def _diagnosis(result: Result, lang: Lang) -> str:
    return suspected(result.suspicions[0], lang) if result.suspicions else ""
