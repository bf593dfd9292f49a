"""The key of each student: one for all, or one for each, read when it is needed.

A judge goes to other processes: one key as it is, a set by the place of its files, which they must reach; each process
makes it ready once.
"""

from __future__ import annotations

import hashlib
import json
import pickle
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cached_property
from pathlib import Path

from graphkin.errors import BadKey, GraphkinError, Where
from graphkin.homework.grading.keys import USUAL, Pencils, key_file, key_from, remade, text_of
from graphkin.homework.grading.neighbours import Neighbours
from graphkin.marking.marker import Marker
from graphkin.marking.records import Marked
from graphkin.submissions import ReadableProblem

KIND = "graphkin keys"
FORMAT = 1
_KEPT = 32  # keys that are held ready


class SetMarker:
    """The markers of a class, by student."""

    def marker(self, student: str) -> Marker | None:
        raise NotImplementedError

    def __call__(self, student: str) -> ReadableProblem | None:
        """The problem of the student; None for one who is not of this class."""
        marker = self.marker(student)
        return None if marker is None else asked_by(marker)

    def key_print(self, student: str) -> str:
        """A fingerprint of the student's key."""
        raise NotImplementedError

    def remarks(self, marked: Marked) -> tuple[GraphkinError, ...]:
        """The remarks that other students' keys give on one student's numbers."""
        return ()


def asked_by(marker: Marker) -> ReadableProblem:
    """The problem that a key asks, at all its positions."""
    first, *further = (
        ReadableProblem(each.method.mechanism, tuple(entry.text for entry in each.key.entries))
        for each in marker.positions
    )
    return replace(first, further=tuple(further))


def fingerprint(*parts: bytes | str) -> str:
    """Of some texts, in a few letters.

    >>> fingerprint("a", "b") == fingerprint("a", b"b") != fingerprint("ab")
    True
    """
    whole = hashlib.sha256()
    for part in parts:
        data = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        whole.update(b"%d:" % len(data) + data)
    return whole.hexdigest()[:16]


_READY: dict[tuple[str, ...], SetMarker] = {}


def _ready(name: tuple[str, ...], made: Callable[[], SetMarker]) -> SetMarker:
    """The judge that was made ready here, or made now; the last few are kept."""
    judge = _READY.get(name)
    if judge is None:
        judge = _READY[name] = made()
        for old in list(_READY)[:-_KEPT]:
            _READY.pop(old, None)
    return judge


class OneKey(SetMarker):
    """One key for all."""

    def __init__(self, marker: Marker) -> None:
        self._marker = marker

    def marker(self, student: str) -> Marker:
        return self._marker

    @cached_property
    def asked(self) -> ReadableProblem:
        """The problem that all are asked."""
        return asked_by(self._marker)

    def __call__(self, student: str) -> ReadableProblem:
        return self.asked

    @cached_property
    def _print(self) -> str:
        from graphkin.outputs.key_json import key_text

        return fingerprint(key_text(self._marker.key))

    def key_print(self, student: str) -> str:
        return self._print

    @cached_property
    def _packed(self) -> bytes:
        return pickle.dumps(self._marker.key)

    def __reduce__(self) -> tuple[Callable[..., SetMarker], tuple[object, ...]]:
        return _one_key, (self._print, self._packed)


def _one_key(name: str, packed: bytes) -> SetMarker:
    return _ready((name,), lambda: OneKey(Marker(pickle.loads(packed))))


class KeySet(SetMarker):
    """The keys of a set, by student; `files` are beside the set's own file, `path`, and hold but for `pencils`."""

    def __init__(self, path: Path, files: Mapping[str, str], pencils: Pencils = USUAL) -> None:
        self.path, self.files, self.pencils = path, dict(files), pencils
        self._made: dict[str, Marker] = {}

    def marker(self, student: str) -> Marker | None:
        if student not in self.files:
            return None
        marker = self._made.get(student)
        if marker is None:
            key = remade(key_file(self.path.parent / self.files[student]), self.pencils)
            marker = self._made[student] = Marker(key)
            for old in list(self._made)[:-_KEPT]:
                self._made.pop(old, None)
        return marker

    @cached_property
    def _neighbours(self) -> Neighbours:
        return Neighbours({student: self.path.parent / name for student, name in self.files.items()})

    def remarks(self, marked: Marked) -> tuple[GraphkinError, ...]:
        """The other keys are read when the first has something wrong."""
        wrong = any(one.verdict in ("wrong", "carried") for one in marked.judged)
        remark = self._neighbours.agreeing(marked) if wrong else None
        return () if remark is None else (remark,)

    @cached_property
    def _print(self) -> str:
        return fingerprint(json.dumps(self.files), repr(self.pencils))

    def key_print(self, student: str) -> str:
        """Of the key's file; of one who is not of the class, of the list of the class."""
        try:
            return fingerprint((self.path.parent / self.files[student]).read_bytes(), repr(self.pencils))
        except (KeyError, OSError):
            return self._print

    def __reduce__(self) -> tuple[Callable[..., SetMarker], tuple[object, ...]]:
        return _key_set, (str(self.path), self._print, self.pencils)

    @classmethod
    def read(cls, path: Path, data: Mapping[str, object], pencils: Pencils = USUAL) -> KeySet:
        """Raises BadKey."""
        students = data.get("students")
        if data.get("format") != FORMAT or not isinstance(students, dict):
            raise BadKey(Where(str(path)), "students")
        for student, name in students.items():
            if not isinstance(name, str) or Path(name).name != name:
                raise BadKey(Where(str(path)), f"students: {student}")
        return cls(path, students, pencils)


def _key_set(path: str, name: str, pencils: Pencils) -> SetMarker:
    return _ready((path, name), lambda: KeySet.read(Path(path), json.loads(text_of(Path(path))), pencils))


def set_text(files: Mapping[str, str]) -> str:
    """The set's own file: whose key is which."""
    data = {"kind": KIND, "format": FORMAT, "students": dict(files)}
    return json.dumps(data, ensure_ascii=False, indent=1) + "\n"


def judge_from(source: str, pencils: Pencils = USUAL) -> SetMarker:
    """Of a key.json, a mechanism file, a library mechanism, or a folder with a set of problems.

    Raises what loading and planning raise, BadKey, NothingToMark.
    """
    path = Path(source)
    path = path / "key.json" if path.is_dir() else path
    if path.suffix.lower() == ".json":
        try:
            data = json.loads(text_of(path))
        except (ValueError, RecursionError):
            data = None  # the reader of one key says what is wrong
        if isinstance(data, dict) and data.get("kind") == KIND:
            return KeySet.read(path, data, pencils)
    return OneKey(Marker(key_from(str(path) if path.suffix else source, pencils)))
