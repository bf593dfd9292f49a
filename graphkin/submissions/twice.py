"""Who has handed in already: of each student the first submission counts."""

from __future__ import annotations

from graphkin.errors import HandedTwice, Where


class FirstOnes:
    """The first submission of each student, as far as they have gone by; some hundred bytes of each are held."""

    def __init__(self) -> None:
        self._files: list[str] = []
        self._seen: dict[int, int] = {}

    def reason(self, student: str, file: str, place: str) -> HandedTwice | None:
        """Why this submission is not marked, being a further one; None where it is the student's first."""
        line = min(int(place), _LINES - 1) if place.isdecimal() else 0
        name = hash(student)
        if name in self._seen:
            return HandedTwice(_where(file, line), student, str(self._first(name)))
        if not self._files or self._files[-1] != file:
            self._files.append(file)
        self._seen[name] = (len(self._files) - 1) * _LINES + line
        return None

    def _first(self, name: int) -> Where:
        number, line = divmod(self._seen[name], _LINES)
        return _where(self._files[number], line)


_LINES = 1 << 32


def _where(file: str, line: int) -> Where:
    return Where(file, line or None)
