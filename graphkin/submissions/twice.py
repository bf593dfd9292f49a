"""Students who have handed in already: of each the first submission counts, and none that another's name stands in."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from pathlib import Path

from graphkin.errors import GraphkinError, HandedTwice, TwoNames, Where
from graphkin.submissions.class_names import owner
from graphkin.submissions.handed import named_in


class FirstOnes:
    """The first submission of each student, as far as they have gone by.

    paths   all that is handed in: what a file, or a platform's folder, is named after goes before a line inside
    """

    def __init__(self, paths: Iterable[str | Path] = ()) -> None:
        self._paths = paths
        self._seen: dict[str, Where] = {}

    @cached_property
    def _named(self) -> frozenset[str]:
        """The names of students that files bear; looked for where a line inside says another."""
        return frozenset(name for who in named_in(self._paths) for name in (who.student, *who.others))

    def reason(self, student: str, file: str, place: str) -> HandedTwice | TwoNames | None:
        """Why this submission is not marked, being another's or a further one; None where it is the student's first."""
        if not place.isdecimal():
            name = place or Path(file).name
            own = owner(name), owner(name, alone=True)
            if not any(student in (who.student, *who.others) for who in own) and student in self._named:
                return TwoNames(Where(file), own[0].student, student)
        here = Where(file, int(place) if place.isdecimal() else None)
        first = self._seen.setdefault(student, here)
        return None if first is here else HandedTwice(here, student, str(first))


def called(student: str, reason: GraphkinError) -> str:
    """Whose a submission is that is not marked: nobody's is another's."""
    return reason.named if isinstance(reason, TwoNames) else student
