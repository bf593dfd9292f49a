"""Work at several positions of one problem: each position is marked by its own key, and all are told as one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from graphkin.marking.diagnosis import Diagnosis, Explanation
from graphkin.marking.habits import Trace, added
from graphkin.marking.marked import HandedNumber, Judged, Marked, StudentWork
from graphkin.model.quantities import at_position, position_of


def parted(work: StudentWork, count: int) -> list[StudentWork]:
    """The numbers of each position, under the names they have there; of one that there is not, they are dropped."""
    found: list[dict[str, HandedNumber]] = [{} for _ in range(count)]
    for text, number in work.numbers.items():
        bare, at = position_of(text)
        if at <= count:
            found[at - 1][bare] = number
    return [replace(work, numbers=numbers) for numbers in found]


def joined(student: str, parts: Sequence[Marked]) -> Marked:
    """One record of all positions; a mistake that shows at several is told once."""
    judged = tuple(_named(one, at) for at, part in enumerate(parts, 1) for one in part.judged)
    return Marked(student, judged, _diagnosis(parts))


def _named(one: Judged, at: int) -> Judged:
    return replace(
        one, text=at_position(one.text, at), own={at_position(text, at): x for text, x in one.own.items()},
        refused=tuple(at_position(text, at) for text in one.refused),
    )  # fmt: skip


def _diagnosis(parts: Sequence[Marked]) -> Diagnosis:
    """Evidence is added as over several problems, of positions where something was handed in."""
    there = [part for part in parts if any(one.given is not None for one in part.judged)]
    evidence = added(Trace((), part.diagnosis.evidence) for part in there)
    found: list[Explanation] = []
    for at, part in enumerate(parts, 1):
        for one in part.diagnosis.explanations:
            _join(found, replace(one, explains=tuple(at_position(text, at) for text in one.explains)))
    return Diagnosis(tuple(found), evidence)


def _join(found: list[Explanation], one: Explanation) -> None:
    """To the one that shares a mistake with it: what both may be explains both, as surely as the less sure."""
    for k, other in enumerate(found):
        if both := tuple(names for names in other.names if names in one.names):
            found[k] = Explanation(
                both, min(one.probability, other.probability), min(one.margin, other.margin),
                (*other.explains, *one.explains),
            )  # fmt: skip
            return
    found.append(one)
