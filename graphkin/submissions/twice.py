"""Who has handed in already: of each student the first submission counts."""

from __future__ import annotations

from graphkin.errors import HandedTwice, Where


class FirstOnes:
    """The first submission of each student, as far as they have gone by."""

    def __init__(self) -> None:
        self._seen: dict[str, Where] = {}

    def reason(self, student: str, file: str, place: str) -> HandedTwice | None:
        """Why this submission is not marked, being a further one; None where it is the student's first."""
        here = Where(file, int(place) if place.isdecimal() else None)
        first = self._seen.setdefault(student, here)
        return None if first is here else HandedTwice(here, student, str(first))
