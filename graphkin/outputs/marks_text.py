"""Marks as plain text for a terminal, in both languages."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphkin.errors import Lang
from graphkin.marking.diagnosis import Explanation
from graphkin.marking.graded import Graded
from graphkin.marking.key import Name
from graphkin.marking.marked import Judged, Marked
from graphkin.marking.phrases import SENTENCES
from graphkin.marking.phrases import key as sentence_key
from graphkin.outputs.marks_phrases import say
from graphkin.quantities import EDGE
from graphkin.words.figures import number
from graphkin.words.layout import width

__all__ = ["grade_lines", "mistake_text", "shown", "table"]

_SETS = 4
"""Mistakes of one set that are written out; of more the number is said."""


def grade_lines(graded: Graded, lang: Lang) -> Iterator[str]:
    """One submission: its marks, its values, and what the wrong ones are consistent with."""
    marked = graded.marked
    if marked is None:
        reason = "" if graded.reason is None else graded.reason.message(lang)
        yield say("not marked", lang, student=graded.student, file=graded.file, reason=reason)
        return
    yield say("student", lang, student=graded.student, file=graded.file, score=f"{marked.score:.2f}")
    yield from (f"  {row}" for row in table([_header(lang), *(_row(one, lang) for one in marked.judged)]))
    yield from (f"  {line}" for line in _arithmetic(marked, lang))
    yield from (f"  {line}" for line in _mistakes(marked, lang))
    yield from (f"  {say('note', lang, note=note.message(lang))}" for note in graded.notes)


def table(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """Columns side by side, the first and the last to the left."""
    widths = [max(map(width, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        cells = []
        for k, (cell, room) in enumerate(zip(row, widths, strict=True)):
            spare = " " * (room - width(cell))
            cells.append(cell + spare if k in (0, len(row) - 1) else spare + cell)
        yield "  ".join(cells).rstrip()


def shown(value: float, unit: str) -> str:
    """A value in its unit at the edge, in four digits."""
    return number(value * EDGE[unit].factor)


def _header(lang: Lang) -> list[str]:
    return [say(key, lang) for key in ("quantity", "given", "right value", "tolerance", "unit", "verdict")]


def _row(one: Judged, lang: Lang) -> list[str]:
    verdict = say(one.verdict, lang)
    if one.verdict == "wrong" and one.credit and one.sense == "wrong":
        verdict = say("sense wrong", lang)
    if not one.unit_right:
        verdict = say("unit wrong", lang)
    given = "" if one.given is None else shown(one.given, one.unit)
    right, tolerance = shown(one.right, one.unit), f"±{shown(one.tolerance, one.unit)}"
    return [one.text, given, right, tolerance, EDGE[one.unit].sign, verdict]


def _arithmetic(marked: Marked, lang: Lang) -> Iterator[str]:
    """What was judged with what."""
    units = {one.text: one.unit for one in marked.judged}
    for one in marked.judged:
        if one.own and one.carried is not None:
            own = say("comma", lang).join(f"{text} = {shown(value, units[text])}" for text, value in one.own.items())
            yes = "yes" if one.verdict == "carried" else "no"
            yield say(f"judged with {yes}", lang, own=own, quantity=one.text, value=shown(one.carried, one.unit))
    refused = dict.fromkeys(text for one in marked.judged if one.verdict == "wrong" for text in one.refused)
    if refused:
        yield say("not carried", lang, own=say("comma", lang).join(refused))


def _mistakes(marked: Marked, lang: Lang) -> Iterator[str]:
    if not any(one.verdict in ("wrong", "carried") for one in marked.judged):
        return
    if not marked.diagnosis.explanations:
        yield say("none fits", lang)
    for explanation in marked.diagnosis.explanations:
        yield say(
            "consistent" if len(explanation.names) == 1 else "cannot tell", lang, what=_set(explanation, lang),
            probability=f"{explanation.probability:.0%}", explains=say("comma", lang).join(explanation.explains),
        )  # fmt: skip


def _set(explanation: Explanation, lang: Lang) -> str:
    texts = list(dict.fromkeys(_together(names, lang) for names in explanation.names))
    more = [say("more", lang, count=len(texts) - _SETS)] if len(texts) > _SETS else []
    return say("or", lang).join([*texts[:_SETS], *more])


def _together(names: tuple[Name, ...], lang: Lang) -> str:
    return say("and", lang).join(mistake_text(name, lang) for name in names)


def mistake_text(name: Name, lang: Lang) -> str:
    """A mistake in words, as it was made."""
    id, way, of, form = name
    sentence = SENTENCES.get(sentence_key(id, way)) or SENTENCES.get(id) or {"en": id, "zh": id}
    return sentence[lang].format(of=of, form=form)
