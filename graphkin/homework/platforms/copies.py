"""Numbers that two students have digit by digit and that nobody reads off alike: for the teacher alone."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from graphkin.errors import Lang, SameNumbers
from graphkin.homework.platforms.result import Result
from graphkin.marking.records import Judged

_FEWEST, _PART = 3, 0.6  # so many telling numbers are the same, and this part of what both have handed in
_MANY = 5  # a telling number that more have is a common mistake's, calculated
_EXACT = 0.005  # nearer than this part to a right value is that value in three digits, which many calculate


def with_copies(results: Sequence[Result], lang: Lang) -> tuple[Result, ...]:
    """The results with remarks on the same numbers; of one student with several submissions none of these."""
    marked = [k for k, result in enumerate(results) if result.status == "marked"]
    handed = {k: {line.text: line for line in results[k].lines if line.given and not line.of_equations} for k in marked}
    having: dict[tuple[str, str], list[int]] = {}
    for k, lines in handed.items():
        for line in lines.values():
            having.setdefault((line.text, f"{line.given:.6g}"), []).append(k)
    telling, wrong = (Counter[tuple[int, int]]() for _ in range(2))
    for (name, _), some in having.items():
        by_whom = {k for k in some if _tells(handed[k][name])}
        if len(by_whom) <= _MANY:
            for pair in {(min(k, other), max(k, other)) for k in by_whom for other in some if other != k}:
                telling[pair] += 1
                wrong[pair] += any(handed[k][name].verdict == "wrong" for k in pair)
    remarks: dict[int, list[str]] = {}
    for pair, count in telling.items():
        one, other = (handed[k] for k in pair)
        both = one.keys() & other.keys()
        same = sum(f"{one[name].given:.6g}" == f"{other[name].given:.6g}" for name in both)
        alike = count >= _FEWEST and wrong[pair] and same >= _PART * len(both)
        for k, from_whom in (pair, pair[::-1]) if alike else ():
            student = results[from_whom].student
            if student != results[k].student and not any(student in remark for remark in results[k].remarks):
                remarks.setdefault(k, []).append(SameNumbers(student, same, len(both)).message(lang))
    return tuple(replace(each, remarks=(*each.remarks, *remarks.get(k, ()))) for k, each in enumerate(results))


def _tells(line: Judged) -> bool:
    """True for a number that is not simply the right one, or what follows rightly from earlier ones."""
    if line.given is None or line.verdict in ("dead point", "too small"):
        return False
    values = (value for value in (line.right, line.carried) if value is not None)
    return all(abs(abs(line.given) - abs(value)) > _EXACT * abs(value) for value in values)
