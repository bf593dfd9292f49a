"""The keys of a problem set: one for each student, read when they are needed."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from graphkin.errors import BadKey, Where
from graphkin.grading.keys import key_file
from graphkin.marking.marker import Marker
from graphkin.submissions import Asked

KIND = "graphkin keys"
FORMAT = 1
_KEPT = 32
"""Keys that are held ready."""


class Judge:
    """Who marks a student's work: whichever key is theirs."""

    def marker(self, student: str) -> Marker | None:
        raise NotImplementedError

    def __call__(self, student: str) -> Asked | None:
        """What the student is asked; None for one who is not of this class."""
        marker = self.marker(student)
        if marker is None:
            return None
        return Asked(marker.method.mechanism, tuple(entry.text for entry in marker.key.entries))


class OneKey(Judge):
    """One key for all."""

    def __init__(self, marker: Marker) -> None:
        self._marker = marker

    def marker(self, student: str) -> Marker:
        return self._marker


class KeySet(Judge):
    """The keys of a set, by student; `files` are beside the set's own file."""

    def __init__(self, folder: Path, files: Mapping[str, str]) -> None:
        self.folder, self.files = folder, dict(files)
        self._ready: dict[str, Marker] = {}

    def marker(self, student: str) -> Marker | None:
        if student not in self.files:
            return None
        if student not in self._ready:
            if len(self._ready) >= _KEPT:
                self._ready.pop(next(iter(self._ready)))
            self._ready[student] = Marker(key_file(self.folder / self.files[student]))
        return self._ready[student]

    def __getstate__(self) -> dict[str, Any]:
        """To other processes without what is held ready."""
        return {"folder": self.folder, "files": self.files, "_ready": {}}

    @classmethod
    def read(cls, path: Path, data: Mapping[str, Any]) -> KeySet:
        """Raises BadKey."""
        students = data.get("students")
        if data.get("format") != FORMAT or not isinstance(students, dict):
            raise BadKey(Where(str(path)), "students")
        for student, name in students.items():
            if not isinstance(name, str) or Path(name).name != name:
                raise BadKey(Where(str(path)), f"students: {student}")
        return cls(path.parent, students)


def set_text(files: Mapping[str, str]) -> str:
    """The set's own file: whose key is which."""
    data = {"kind": KIND, "format": FORMAT, "students": dict(files)}
    return json.dumps(data, ensure_ascii=False, indent=1) + "\n"
