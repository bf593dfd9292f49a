"""The key of each student: one for all, or one for each, read when it is needed; whose numbers are another student's;
and the problems that are to be marked.

A judge goes to other processes: one key as it is, a set by the place of its files, which they must reach; each process
makes it ready once.
"""

from __future__ import annotations

import json
import math
import os
import pickle
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property, lru_cache
from pathlib import Path

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import AnotherStudent, BadKey, GraphkinError, NoFile, NoSuchProblem, Where
from graphkin.homework import opening
from graphkin.homework.grading.keys import USUAL, Pencils, key_file, key_from, remade, text_of
from graphkin.marking.key import KeyEntry, columns, columns_of, differences
from graphkin.marking.marker import Marker
from graphkin.marking.records import Marked
from graphkin.marking.tolerances import Untold, untold
from graphkin.model.quantities import at_position
from graphkin.submissions import Limits, Roster, Student, students_in
from graphkin.submissions.documents import cells_of, shown_cell
from graphkin.submissions.submission import ReadableProblem, fingerprint

KIND = "graphkin keys"
FORMAT = 1
TEACHER = "teacher"  # the folder of a set with what is not handed out
_KEY, _SET = ".key.json", "key.json"
_KEPT = 64  # keys that are held ready: of all that are read, and then marked, at once


class SetMarker:
    """The markers of a class, by student; its students, None where anybody may hand in."""

    roster: Roster | None = None

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


@lru_cache(maxsize=1)  # a class has one key, or each student's own, once
def asked_by(marker: Marker) -> ReadableProblem:
    """The problem that a key asks, at all its positions."""
    first, *further = (
        ReadableProblem(each.method.mechanism, tuple(entry.text for entry in each.key.entries))
        for each in marker.positions
    )
    return replace(first, further=tuple(further))


class OneKey(SetMarker):
    """One key for all, or for those of a list."""

    def __init__(self, marker: Marker, listed: Path | None = None) -> None:
        self._marker, self._listed = marker, listed
        self.roster = None if listed is None else Roster(class_list(listed))

    def marker(self, student: str) -> Marker:
        return self._marker

    def untold(self) -> Untold:
        """The answers that paper does not tell, of all positions; a set of problems asks for none."""
        each = ((at, untold(one.key, one.method)) for at, one in enumerate(self._marker.positions, 1))
        return {at_position(text, at): part for at, parts in each for text, part in parts.items()}

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
        return _one_key, (self._packed, self._listed)


@lru_cache(maxsize=_KEPT)
def _one_key(packed: bytes, listed: Path | None) -> SetMarker:
    return OneKey(Marker(pickle.loads(packed)), listed)


class KeySet(SetMarker):
    """The keys of a set, by student; `files` are beside the set's own file, `path`, and hold but for `pencils`. What
    the students are called is in the set's own file and in the class list."""

    def __init__(
        self, path: Path, files: Mapping[str, str], pencils: Pencils = USUAL, listed: Path | None = None,
        students: Sequence[Student] = (),
    ) -> None:  # fmt: skip
        self.path, self.files, self.pencils, self._listed = path, dict(files), pencils, listed
        own = Roster(students or map(Student, files))
        self.roster: Roster = own if listed is None else own.joined(class_list(listed))
        self._ready = lru_cache(maxsize=_KEPT)(self._made)

    def marker(self, student: str) -> Marker | None:
        return self._ready(student) if student in self.files else None

    def _made(self, student: str) -> Marker:
        return Marker(remade(key_file(self.path.parent / self.files[student]), self.pencils))

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
        students = [*self.roster.students.values()]
        return fingerprint(json.dumps(self.files), repr(self.pencils), repr(students))

    def key_print(self, student: str) -> str:
        """Of the key's file; of one who is not of the class, of the list of the class."""
        try:
            return fingerprint((self.path.parent / self.files[student]).read_bytes(), repr(self.pencils))
        except (KeyError, OSError):
            return self._print

    def __reduce__(self) -> tuple[Callable[..., SetMarker], tuple[object, ...]]:
        return _key_set, (str(self.path), self._print, self.pencils, self._listed)

    @classmethod
    def read(
        cls, path: Path, data: Mapping[str, object], pencils: Pencils = USUAL, listed: Path | None = None
    ) -> KeySet:
        """Raises BadKey, and what reading the class list raises."""
        students, names = data.get("students"), data.get("names", {})
        if data.get("format") != FORMAT or not isinstance(students, dict) or not isinstance(names, dict):
            raise BadKey(Where(str(path)), "students")
        for student, name in students.items():
            if not isinstance(name, str) or Path(name).name != name:
                raise BadKey(Where(str(path)), f"students: {student}")
        cells = {id: own.items() for id, own in names.items() if isinstance(own, dict)}
        own = [Student(id, tuple((h, str(text)) for h, text in cells.get(id, ()))) for id in students]
        return cls(path, students, pencils, listed, own)


@lru_cache(maxsize=_KEPT)
def _key_set(path: str, name: str, pencils: Pencils, listed: Path | None) -> SetMarker:
    """`name`: the fingerprint of its list, so that one that was written anew is read."""
    return KeySet.read(Path(path), json.loads(text_of(Path(path))), pencils, listed)


def set_text(files: Mapping[str, str], students: Iterable[Student] = ()) -> str:
    """The set's own file: whose key is which, and what else the students are called."""
    data: dict[str, object] = {"kind": KIND, "format": FORMAT, "students": dict(files)}
    names = {student.id: dict(student.names) for student in students if student.names}
    return json.dumps({**data, **({"names": names} if names else {})}, ensure_ascii=False, indent=1) + "\n"


def class_list(path: Path) -> tuple[Student, ...]:
    """The students of a class list, CSV or XLSX, under heads in any order, of Moodle, Canvas, Gradescope or 学习通.

    Raises NoFile, Unreadable, BrokenSubmission, WantsExtra, StudentTwice, StudentWithoutId, NoStudents.
    """
    where = Where(str(path))
    with opening(path):
        cells = cells_of(path.name, path.read_bytes(), where, Limits())
        return students_in(([shown_cell(cell) for cell in row] for _, row in cells), where)


def judge_from(source: str, pencils: Pencils = USUAL, listed: Path | None = None) -> SetMarker:
    """Of a key.json, a mechanism file, a library mechanism, or a folder with a set of problems; for those of a class
    list.

    Raises what loading and planning and the list raise, BadKey, NothingToMark.
    """
    path = Path(source)
    path = _set_of(path) or path / _SET if os.path.isdir(path) else path
    if path.suffix.lower() == ".json":
        try:
            data = json.loads(text_of(path))
        except (ValueError, RecursionError):
            data = None  # the reader of one key says what is wrong
        if isinstance(data, dict) and data.get("kind") == KIND:
            return KeySet.read(path, data, pencils, listed)
    return OneKey(Marker(key_from(str(path) if path.suffix else source, pencils)), listed)


# --- another student's numbers ----------------------------------------------------------------------------------------

_FEWEST, _PART = 3, 0.8  # so many numbers, and this part of them, agree with one other problem
_CHANCE = 0.01  # a hit that random numbers make more often, on some problem of the set, is no hint
_READ = ("unit", "sort", "right", "scatter", "tolerance")  # of a key's quantities
_THIRD = 0.005  # of a right value
_NEAREST = 0.1  # closer than this, in standard deviations, is no better


class Neighbours:
    """The right values of a set's keys (students, quantities); one that cannot be read is no neighbour."""

    def __init__(self, files: Mapping[str, Path]) -> None:
        keys: dict[str, dict[str, KeyEntry]] = {}
        for student, path in files.items():
            with suppress(OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
                data = json.loads(path.read_text("utf-8-sig"))
                parts = enumerate((data, *data.get("positions", ())), 1)
                each = [(at_position(one["text"], at), one) for at, part in parts for one in part["quantities"]]
                keys[student] = {text: KeyEntry(text, *(one[key] for key in _READ)) for text, one in each}
        every = {text: entry for entries in keys.values() for text, entry in entries.items()}
        self.students, self._columns = (*keys,), {text: k for k, text in enumerate(every)}
        self._table, shape = columns([*every.values()]), (len(keys), len(every))
        self._right, self._scatter, self._tolerance = (
            np.array([getattr(some.get(text), name, np.nan) for some in keys.values() for text in every]).reshape(shape)
            for name in ("right", "scatter", "tolerance")
        )

    def agreeing(self, marked: Marked) -> AnotherStudent | None:
        """The other student whose right values most of these numbers are, where those are not the own right ones.

        Numbers that are right by both problems say nothing. Of a large class one problem is always near: what random
        numbers, between the least and the largest of the class, meet as nearly is no hint.
        """
        some = [one for one in marked.judged if one.given is not None and one.unit_right and one.text in self._columns]
        which = np.array([self._columns[one.text] for one in some], dtype=int)
        given = np.array([[one.given for one in some]], dtype=float)
        off = np.abs(differences(columns_of(self._table, which), given, self._right[:, which]))
        agrees = off <= self._tolerance[:, which]
        own = np.array([one.verdict == "right" for one in some], dtype=bool)
        new = agrees & ~own
        enough = new.sum(axis=1) >= np.maximum(_FEWEST, _PART * (~(agrees & own)).sum(axis=1))
        others = [k for k in np.flatnonzero(enough) if self.students[k] != marked.student]
        if not others:
            return None
        z = np.where(new, np.maximum(off / self._scatter[:, which], _NEAREST), 0.0)
        best = min(others, key=lambda k: (-new[k].sum(), np.sum(z[k] ** 2)))
        every, n = np.concatenate([self._right[:, which], given])[:, new[best]], int(new[best].sum())
        cells = self._scatter[best, which][new[best]] / (np.nanmax(every, axis=0) - np.nanmin(every, axis=0))
        ball = (np.pi * np.sum(z[best] ** 2)) ** (n / 2) / math.gamma(n / 2 + 1)
        if len(self.students) * ball * np.prod(cells) > _CHANCE:
            return None
        closely = off[best] <= _THIRD * np.abs(self._right[best, which])  # half a unit of the third digit, at most
        return AnotherStudent(
            self.students[best], int(agrees[best].sum()), len(some), bool((closely | ~agrees[best]).all())
        )


# --- the problems that are to be marked -------------------------------------------------------------------------------


@frozen
class Problem:
    """The name of a problem, "" where there is only one, its key, as `judge_from` takes it, and what was handed in."""

    name: str
    key: str
    paths: tuple[str, ...]


def problems_of(key: str, submissions: Sequence[str]) -> tuple[Problem, ...]:
    """One, or those of a folder of keys for which something was handed in.

    In a folder of keys each problem is a NAME.key.json, a mechanism NAME.toml, or a folder NAME with a set of problems;
    what was handed in for it is NAME with any ending (a class table, an archive, a folder), among `submissions` or in
    folders of these. Raises NoSuchProblem, and NoFile where no submission is there.
    """
    if submissions and not any(map(os.path.exists, submissions)):  # written wrongly; one among several is a row
        raise NoFile(Where(submissions[0]), Path(submissions[0]).name, ())
    keys = _keys(Path(key))
    if not keys:
        return (Problem("", key, tuple(submissions)),)
    paths: dict[str, list[str]] = {name: [] for name in keys}
    handed_in: list[Path] = []
    for path in map(Path, submissions):
        folder = path.is_dir() and path.name not in keys
        handed_in += sorted(one for one in path.iterdir() if not one.name.startswith(".")) if folder else [path]
    for path in handed_in:
        name = next((name for name in (path.name, path.stem) if name in keys), None)
        if name is None:
            raise NoSuchProblem(Where(str(path)), path.stem, tuple(keys))
        paths[name].append(str(path))
    if not any(paths.values()):
        raise NoSuchProblem(Where(submissions[0]), Path(submissions[0]).name, tuple(keys))
    return tuple(Problem(name, str(keys[name]), tuple(own)) for name, own in paths.items() if own)


def _keys(folder: Path) -> Mapping[str, Path]:
    """The problems of a folder by name; none of one that is itself a set of problems, or that is no folder."""
    if not folder.is_dir() or _set_of(folder) is not None:
        return {}
    keys: dict[str, Path] = {}
    for path in sorted(folder.iterdir()):
        if path.name.endswith(_KEY):
            keys[path.name.removesuffix(_KEY)] = path
        elif _set_of(path) is not None:
            keys.setdefault(path.name, path)
        elif path.suffix == ".toml":
            keys.setdefault(path.stem, path)
    return keys


def _set_of(folder: Path) -> Path | None:
    """The file of the set that a folder holds: in its teacher's folder, or, of an older one, beside the problems."""
    return next((path for path in (folder / TEACHER / _SET, folder / _SET) if path.is_file()), None)
