"""What was handed in, marked: its values, the arithmetic, and what the wrong ones are consistent with."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from graphkin.errors import Lang
from graphkin.marking.diagnosis import Explanation
from graphkin.marking.records import Graded, Judged, Marked
from graphkin.model.quantities import EDGE
from graphkin.say.catalogue import say
from graphkin.say.mistakes import once, together
from graphkin.say.numbers import number
from graphkin.say.text_table import aligned
from graphkin.say.verdicts import verdict

_SETS = 4
"""Mistakes of one set that are written out; of more the number is said."""


def grade_lines(graded: Graded, lang: Lang) -> Iterator[str]:
    """One submission: its marks, its values, and what the wrong ones are consistent with."""
    marked = graded.marked
    if marked is None:
        reason = "" if graded.reason is None else graded.reason.message(lang)
        yield say("marks.not marked", lang, student=graded.student, file=graded.file, reason=reason)
        return
    score = "–" if marked.score is None else f"{marked.score:.2f}"
    yield say("marks.student", lang, student=graded.student, file=graded.file, score=score)
    yield from (f"  {row}" for row in table([_header(lang), *(_row(one, lang) for one in marked.judged)]))
    yield from (f"  {line}" for line in _arithmetic(marked, lang))
    yield from (f"  {line}" for line in _mistakes(marked, lang))
    yield from (f"  {say('marks.note', lang, note=note.message(lang))}" for note in graded.notes)


def interrupted(path: Path, lang: Lang) -> str:
    """That a marking that was broken off can be gone on with."""
    return say("marks.interrupted", lang, path=path)


def table(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """Columns side by side, the first and the last to the left."""
    return (line.rstrip() for line in aligned(rows, "<" + ">" * (len(rows[0]) - 2) + "<"))


def shown(value: float, unit: str) -> str:
    """A value in its unit at the edge, in four digits."""
    return number(value * EDGE[unit].factor)


def _header(lang: Lang) -> list[str]:
    names = [
        "marks.column quantity", "marks.column given", "marks.column right value", "verdicts.tolerance",
        "marks.column unit", "marks.column verdict",
    ]  # fmt: skip
    return [say(name, lang) for name in names]


def _row(one: Judged, lang: Lang) -> list[str]:
    given = "" if one.given is None else shown(one.given, one.unit)
    untold = one.verdict in ("dead point", "too small")
    right, tolerance = shown(one.right, one.unit), "–" if untold else f"±{shown(one.tolerance, one.unit)}"
    return [one.text, given, right, tolerance, EDGE[one.unit].sign, verdict(one, lang)]


def _arithmetic(marked: Marked, lang: Lang) -> Iterator[str]:
    """What was judged with what."""
    units = {one.text: one.unit for one in marked.judged}
    for one in marked.judged:
        if one.own and one.carried is not None:
            values = (f"{text} = {shown(value, units[text])}" for text, value in one.own.items())
            yes = "yes" if one.verdict == "carried" else "no"
            yield say(f"marks.judged with {yes}", lang, own=say("common.list", lang).join(values), quantity=one.text,
                      value=shown(one.carried, one.unit))  # fmt: skip
    refused = dict.fromkeys(text for one in marked.judged if one.verdict == "wrong" for text in one.refused)
    if refused:
        yield say("marks.not carried", lang, own=say("common.list", lang).join(refused))


def _mistakes(marked: Marked, lang: Lang) -> Iterator[str]:
    """Of numbers; a unit that alone is wrong has been told."""
    if not any(one.verdict in ("wrong", "carried") and one.unit_right for one in marked.judged):
        return
    if not marked.diagnosis.explanations:
        yield say("marks.none fits", lang)
    for explanation in marked.diagnosis.explanations:
        told = "marks.consistent" if len(explanation.names) == 1 else "marks.cannot tell"
        yield say(
            told, lang, what=_set(explanation, lang),
            probability=f"{explanation.probability:.0%}", explains=say("common.list", lang).join(explanation.explains),
        )  # fmt: skip


def _set(explanation: Explanation, lang: Lang) -> str:
    texts = once(together(names, lang) for names in explanation.names)
    more = [say("marks.more", lang, count=len(texts) - _SETS)] if len(texts) > _SETS else []
    return say("marks.or", lang).join([*texts[:_SETS], *more])
