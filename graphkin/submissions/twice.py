"""Students who have handed in already: of each the first submission counts, and none that another's name stands in."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from pathlib import Path

from graphkin.errors import GraphkinError, HandedTwice, TwoNames, Where
from graphkin.submissions.class_names import owner
from graphkin.submissions.handed import named_in


class FirstOnes:
    """The first submission of each student, as far as they have gone by; some hundred bytes of each are held.

    paths   all that is handed in: what a file, or a platform's folder, is named after goes before a line inside
    """

    def __init__(self, paths: Iterable[str | Path] = ()) -> None:
        self._paths = paths
        self._files: list[str] = []
        self._seen: dict[int, int] = {}

    @cached_property
    def _named(self) -> frozenset[int]:
        """The names of students that files bear; looked for where a line inside says another."""
        return frozenset(hash(name) for who in named_in(self._paths) for name in (who.student, *who.others))

    def reason(self, student: str, file: str, place: str) -> HandedTwice | TwoNames | None:
        """Why this submission is not marked, being another's or a further one; None where it is the student's first."""
        if not place.isdecimal():
            name = place or Path(file).name
            own = owner(name), owner(name, alone=True)
            if not any(student in (who.student, *who.others) for who in own) and hash(student) in self._named:
                return TwoNames(Where(file), own[0].student, student)
        line = min(int(place), _LINES - 1) if place.isdecimal() else 0
        known = hash(student)
        if known in self._seen:
            return HandedTwice(_where(file, line), student, str(self._first(known)))
        if not self._files or self._files[-1] != file:
            self._files.append(file)
        self._seen[known] = (len(self._files) - 1) * _LINES + line
        return None

    def _first(self, name: int) -> Where:
        number, line = divmod(self._seen[name], _LINES)
        return _where(self._files[number], line)


def called(student: str, reason: GraphkinError) -> str:
    """Whose a submission is that is not marked: nobody's is another's."""
    return reason.named if isinstance(reason, TwoNames) else student


_LINES = 1 << 32


def _where(file: str, line: int) -> Where:
    return Where(file, line or None)
