"""Submissions marked: values, verdicts, the arithmetic, and the mistakes that wrong values are consistent with."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence

from graphkin.errors import Lang
from graphkin.marking.key import Name
from graphkin.marking.records import Departure, Graded, Judged, Marked
from graphkin.model.quantities import EDGE
from graphkin.say.boards import fault_lines, line_name, step_line
from graphkin.say.catalogue import close, in_list, is_phrase, say
from graphkin.say.names import in_signs
from graphkin.say.numbers import number
from graphkin.say.reading import capitalized
from graphkin.say.text_table import aligned, unbraced

_SETS = 3  # mistakes of one set that are written out; of more the number is said


def grade_lines(graded: Graded, lang: Lang) -> Iterator[str]:
    """One submission: its marks, its values, and what the wrong ones are consistent with."""
    marked = graded.marked
    if marked is None:
        reason = "" if graded.reason is None else graded.reason.message(lang)
        yield say("marks.not marked", lang, student=graded.student, file=graded.file, reason=reason)
        yield from _remarks(graded, lang)
        return
    score = "–" if marked.score is None else f"{marked.score:.2f}"
    yield say("marks.student", lang, student=graded.student, file=graded.file, score=score)
    heads = ("marks.column quantity", "marks.column given", "marks.column right value", "verdicts.tolerance",
             "marks.column unit", "marks.column verdict")  # fmt: skip
    rows = [[say(name, lang) for name in heads]]
    for one in marked.judged:
        given = one.written if one.given is None else edge_value(one.given, one.unit)
        tolerance = f"±{edge_value(one.tolerance, one.unit)}"
        tolerance = "–" if one.verdict in ("dead point", "too small") or one.of_equations else tolerance
        sizes = [given, edge_value(one.right, one.unit), tolerance, EDGE[one.unit].sign]
        rows.append([in_signs(line_name(one.text, lang)), *sizes, verdict(one, lang)])
    yield from (f"  {row}" for row in marks_table(rows))
    known = {one.text for one in marked.judged}
    lines = [in_signs(line, known) for line in (*_carried(marked, lang), *_explanations(marked, lang))]
    lines += [*fault_lines(marked.faults, lang), *([step_line(marked.step, lang)] if marked.step is not None else [])]
    yield from (f"  {unbraced(line)}" for line in lines)
    yield from (f"  {say('marks.note', lang, note=note.message(lang))}" for note in graded.notes)
    yield from _remarks(graded, lang)


def _remarks(graded: Graded, lang: Lang) -> Iterator[str]:
    """Said to the teacher alone."""
    return (f"  {say('marks.look', lang, remark=remark.message(lang))}" for remark in graded.remarks)


def _carried(marked: Marked, lang: Lang) -> Iterator[str]:
    """Values judged by the student's own earlier ones, those not carried on, and what follows from a mistake."""
    units, between = {one.text: one.unit for one in marked.judged}, say("common.list", lang)
    explained = {text for one in marked.diagnosis.explanations for text in one.explains}
    for one in marked.judged:
        useful = one.verdict == "carried" or one.text not in explained
        if one.own and one.carried is not None and useful and not one.of_mistake:
            own = between.join(f"{text} = {edge_value(value, units[text])}" for text, value in one.own.items())
            wrong, follows = one.verdict != "carried", edge_value(one.carried, one.unit)
            yield say("marks.judged with", lang, which=wrong, own=own, quantity=one.text, value=follows)
    unused = {one.text: one.refused for one in marked.judged if one.verdict == "wrong"}
    refused = dict.fromkeys(text for texts in unused.values() for text in texts if text in unused)
    if refused:
        yield say("marks.not carried", lang, own=between.join(refused))
    if followed := [one.text + ("" if one.carried is None else f" = {edge_value(one.carried, one.unit)}")
                    for one in marked.judged if one.of_mistake]:  # fmt: skip
        yield say("marks.follows", lang, quantity=between.join(followed))


def kept_lines(kept: int, replaced: Sequence[tuple[str, str, str]], lang: Lang) -> Iterator[str]:
    """The records that were there before: how many stay, and which work is another now."""
    if kept:
        yield say("marks.kept", lang, count=kept)
    for student, old, latest in replaced:
        yield say("marks.replaced", lang, student=student, old=old, latest=latest)


def marks_table(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """Columns side by side, the first and the last to the left."""
    return (line.rstrip() for line in aligned(rows, "<" + ">" * (len(rows[0]) - 2) + "<"))


def edge_value(value: float, unit: str) -> str:
    """A value in its unit at the edge, in four digits."""
    return number(value * EDGE[unit].factor)


def _explanations(marked: Marked, lang: Lang) -> Iterator[str]:
    """Of wrong numbers; a unit that alone is wrong stands in its verdict."""
    numbers = [one for one in marked.judged if not one.of_equations]
    if not any(one.verdict in ("wrong", "carried") and one.unit_right for one in numbers):
        return
    reversed_ones = [one.text for one in numbers if one.reversed and one.credit]  # their verdict says so
    departure = marked.departure
    if not marked.diagnosis.explanations and departure is not None and departure.text not in reversed_ones:
        yield departs(departure, lang)
    for one in marked.diagnosis.explanations:
        texts = [mistakes_together(names, lang) for names in one.names]
        what, sure = joined(texts, lang), how_sure(one.probability, texts, lang)
        explains = say("common.list", lang).join(one.explains)
        yield say("marks.consistent", lang, what=what, sure=sure, explains=explains)


_CERTAIN, _PROBABLE = 0.99, 0.9
"""Explanations are told apart by a factor of 20, which alone is 0.95: a hundredth is left to all mistakes that are in
no list."""


def how_sure(probability: float, mistakes: Iterable[str], lang: Lang) -> str:
    """In words. Of several mistakes that cannot be told apart none is certain."""
    if probability >= _CERTAIN and len(distinct_mistakes(mistakes)) == 1:
        return say("marks.sure certainly", lang)
    return say(f"marks.sure {'probably' if probability >= _PROBABLE else 'possibly'}", lang)


def departs(one: Departure, lang: Lang, in_full: bool = True) -> str:
    """The first value that leaves the right way, where no mistake explains them all; in full with its equation."""
    if not (in_full and one.left and one.right):
        return say("marks.departs", lang, quantity=one.text)
    equation = " = ".join(" + ".join(side) for side in (one.left, one.right))
    return say("marks.departs there", lang, quantity=one.text, equation=equation)


def verdict(one: Judged, lang: Lang) -> str:
    """A verdict, the same everywhere, with what is wrong where that is the unit or the sense alone."""
    if one.verdict != "wrong":
        return say(f"verdicts.verdict {one.verdict}", lang)
    if not one.unit_right:
        return say("verdicts.verdict wrong unit", lang)
    if one.of_equations and one.credit:
        return say("verdicts.verdict partly right", lang)
    if not (one.credit > 0 and one.sense == "wrong"):
        return say("verdicts.verdict wrong", lang)
    if one.reversed:
        return say("verdicts.verdict wrong reversed", lang, which=bool(one.other), other=in_signs(one.other))
    return say(f"verdicts.verdict wrong {'direction' if one.unit in ('m/s', 'm/s^2') else 'sense'}", lang)


def mistake(name: Name, lang: Lang) -> str:
    """A mistake as it was made, a noun phrase; one that is not known here by its id."""
    id, way, places, other = name
    *others, last = places or ("",)
    several, of = len(others) > 0, say("common.last", lang).join(filter(None, (in_list(others, lang), last)))
    form = say(f"mistakes.image {other}", lang) if id.startswith("image-") else other
    if is_phrase(own := f"mistakes.made {id} {way}".rstrip()):
        return say(own, lang, of=of, form=form, which=several)
    made = f"mistakes.made {_LIKE.get(id, id)}"
    text = say(made, lang, of=of, form=form, which=several) if is_phrase(made) else id
    return say(f"mistakes.way {way}", lang, made=text) if is_phrase(f"mistakes.way {way}") else text


def mistake_in_signs(name: Name, texts: Collection[str], lang: Lang) -> str:
    """The same as a sentence begins, quantities as they are written; texts: of those that are handed in."""
    raised = in_signs(mistake(name, lang), texts)
    return capitalized(raised) if raised[1:2].isascii() and raised[1:2].isalpha() else raised


_LIKE = {"tangential-along": "velocity-along-link"}
"""Mistakes that are said as others are."""


def mistakes_together(names: tuple[Name, ...], lang: Lang) -> str:
    """Mistakes that were made together."""
    return say("marks.together", lang).join(mistake(name, lang) for name in names)


def distinct_mistakes(texts: Iterable[str]) -> list[str]:
    """Each once, and not again with more behind it, as `.., and carried on`: these cannot be told apart."""
    each = list(dict.fromkeys(texts))
    return [text for text in each if not any(text.startswith((f"{other}, ", f"{other}，")) for other in each)]


def joined(texts: Iterable[str], lang: Lang) -> str:
    """Mistakes that cannot be told apart, as one."""
    each = distinct_mistakes(text.strip().rstrip(".。") for text in texts)
    if len(each) == 1:
        return each[0]
    more = [say("marks.more", lang, count=len(each) - _SETS)] if len(each) > _SETS else []
    shown = [say("marks.each", lang, number=k, mistake=text) for k, text in enumerate(each[:_SETS], 1)]
    return say("marks.one of", lang, mistakes=say("common.semicolon", lang).join([*shown, *more]))


def mistake_kind(id: str, lang: Lang) -> str:
    """A mistake by itself, whatever it was made with."""
    if is_phrase(f"mistakes.kind {id}"):
        return say(f"mistakes.kind {id}", lang)
    made = " ".join(mistake((id, "", (), ""), lang).split())  # as it was made, without the names
    return close(made) if lang == "zh" else made
