"""All there is to read, one hand-in after another: files, folders, students of an archive, rows of a class table.

Nothing of a student's is parsed here but the cells of a class table; that is `read_one`'s. Of each student the first
submission counts, and none that another's name stands in.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from pathlib import Path, PurePosixPath

from graphkin import errors
from graphkin.base.value import frozen
from graphkin.errors import GraphkinError, Where
from graphkin.model.quantities import position_of
from graphkin.submissions import archives
from graphkin.submissions.documents import PLAIN_TABLES, SHEETS, StudentDocument, cells_of, csv_cells, listed, rows_of
from graphkin.submissions.pool import limited
from graphkin.submissions.submission import Limits, Owner, fingerprint, owner, tidy_id

LIMITS = Limits()


@frozen
class Handed:
    """The files of one student, unread.

    owner    who it seems to be; a file may state an id itself
    file     as results call it; place: line of the class table, or the member's name
    row      of a class table, instead of files by their names; reason: why there is nothing to read
    """

    owner: Owner
    file: str
    place: str = ""
    files: tuple[tuple[str, bytes], ...] = ()
    row: StudentDocument | None = None
    reason: GraphkinError | None = None

    @property
    def digest(self) -> str:
        """Of all that it holds, by which a broken-off marking knows it again."""
        files = (part for name, content in self.files for part in (name, content))
        return fingerprint(repr((self.owner.student, self.file, self.row)), *files)


def handed_in(paths: Iterable[str | Path], limits: Limits) -> Iterator[Handed]:
    """Everything in these files, archives and folders, in order; what cannot be opened comes with its reason."""
    for path in map(Path, paths):
        where = Where(str(path))
        try:
            yield from _of_path(path, where, limits)
        except GraphkinError as reason:
            yield Handed(owner(path.name), str(path), reason=reason)
        except OSError as problem:
            unreadable = errors.Unreadable(where, problem.strerror or str(problem))
            yield Handed(owner(path.name), str(path), reason=unreadable)


def _of_path(path: Path, where: Where, limits: Limits) -> Iterator[Handed]:
    if path.is_dir():
        names = sorted(_walked(path))  # as an archive that was unpacked; links out of it are not followed
        if not names:
            raise errors.NoAnswers(where)
        if _is_class_table(names):
            yield from _of_path(path / names[0], Where(f"{path}/{names[0]}"), limits)
        else:
            limits.check(where, "members", len(names))
            yield from _of_students(names, f"{path}/", lambda k, inner: _content(path / names[k], inner, limits))
    elif not path.exists():
        raise errors.NoFile(where, path.name, ())
    elif not path.is_file():
        raise errors.Unreadable(where, "not a file")
    elif path.suffix.lower() == ".zip":
        yield from _of_archive(path, where, limits)
    elif path.suffix.lower() in PLAIN_TABLES:
        with path.open("rb") as stream:
            yield from _of_table(rows_of(csv_cells(stream, where), where, limits), owner(path.name), where, limits)
    elif path.suffix.lower() in SHEETS:
        cells = cells_of(path.name, _content(path, where, limits), where, limits)
        yield from _of_table(rows_of(cells, where, limits), owner(path.name), where, limits)
    else:
        content, students = _content(path, where, limits), None
        if path.suffix.lower() == ".json" and content.lstrip(b"\xef\xbb\xbf \r\n\t")[:1] == b"[":
            students = listed(archives.decoded(content, where), where, limits)
        for student in students or ():
            yield _of_row(student, owner(path.name), str(path))
        if not students:
            yield Handed(owner(path.name), str(path), files=((path.name, content),))


def _content(path: Path, where: Where, limits: Limits) -> bytes:
    with path.open("rb") as stream:
        content = stream.read(limits.bytes + 1)
    limits.check(where, "bytes", len(content))
    return content


def _of_table(rows: Iterator[StudentDocument], by_file: Owner, where: Where, limits: Limits) -> Iterator[Handed]:
    """Each row read within the time of a submission; what breaks off in the middle keeps the rows before it."""
    file, line, named = str(where.file), 0, False
    try:
        while True:
            with limited(limits.seconds, where):
                row = next(rows, None)
            if row is None:
                return
            line, nobody = row.line, named and not row.student.strip()
            named = named or bool(row.student.strip())
            handed = _of_row(row, by_file, file)
            yield replace(handed, row=None, reason=errors.NamesNobody(Where(file, line))) if nobody else handed
    except GraphkinError as reason:
        yield Handed(by_file, file, place=str(line + 1) if line else "", reason=reason.at(where))


def _of_row(row: StudentDocument, by_file: Owner, file: str) -> Handed:
    student = Owner(tidy_id(row.student), (), str(row.line)) if row.student.strip() else by_file
    return Handed(student, file, str(row.line), row=row)


def _of_archive(path: Path, where: Where, limits: Limits) -> Iterator[Handed]:
    with archives.opened(path, where) as archive:
        infos = list(archives.members(archive, where, limits))
        names = [archives.member_name(info) for info in infos]
        if not infos:
            raise errors.BrokenSubmission(where, "ZIP")
        if _is_class_table(names):
            member = Where(f"{path}!{names[0]}")
            cells = cells_of(names[0], archives.read_member(archive, infos[0], member, limits), member, limits)
            yield from _of_table(rows_of(cells, member, limits), owner(names[0], _root(names)), member, limits)
            return

        def read(k: int, member: Where) -> bytes:
            return archives.read_member(archive, infos[k], member, limits)

        yield from _of_students(names, f"{path}!", read)


def _of_students(names: list[str], before: str, read: Callable[[int, Where], bytes]) -> Iterator[Handed]:
    """The files of each student, read by their numbers; a reason only where none of them can be read."""
    for who, numbers in _grouped(names):
        files, reason = list[tuple[str, bytes]](), None
        for k in numbers:
            where = Where(before + names[k])
            try:
                files.append((names[k], read(k, where)))
            except GraphkinError as problem:
                reason = problem
            except OSError as problem:
                reason = errors.Unreadable(where, problem.strerror or str(problem))
        first = names[numbers[0]]
        yield Handed(who, before + first, first, tuple(files), reason=None if files else reason)


def _walked(path: Path) -> Iterator[str]:
    """The files in a folder, by their places in it."""
    for folder, below, files in os.walk(path):
        below.sort()
        for name in files:
            inside = Path(folder, name)
            if not name.startswith(".") and inside.is_file() and not inside.is_symlink():
                yield inside.relative_to(path).as_posix()


def _is_class_table(names: list[str]) -> bool:
    """True where all there is is a table, which bears no student's name as platforms give them."""
    name = PurePosixPath(names[0])
    is_table = len(names) == 1 and name.suffix.lower() in (*PLAIN_TABLES, *SHEETS)
    return is_table and owner(names[0], _root(names)).student == tidy_id(name.stem)


def _grouped(names: list[str]) -> Iterator[tuple[Owner, list[int]]]:
    """The files of each hand-in, in the order of the first of each."""
    root, shared, kinds = _root(names), set[int](), set[int]()
    for name in names:  # a folder with several files of one kind is a class's; a student's has answers and a drawing
        file, folder = PurePosixPath(name), name.rpartition("/")[0]
        kind = hash((folder, file.suffix.lower(), position_of(file.stem)[1]))
        shared |= {hash(folder)} if kind in kinds else set()
        kinds.add(kind)

    def of(k: int) -> Owner:
        return owner(names[k], root, alone=hash(names[k].rpartition("/")[0]) in shared)

    groups: dict[str, list[int]] = {}
    for k in range(len(names)):
        groups.setdefault(of(k).group, []).append(k)
    yield from ((of(numbers[0]), numbers) for numbers in groups.values())


def _root(names: list[str]) -> str:
    """The folder about everything, where it is nobody's own: `homework 3/` of an archive that holds only that."""
    folder, slash, _ = names[0].partition("/") if names else ("", "", "")
    shared = slash and all(name.startswith(f"{folder}/") for name in names)
    if not shared or "_assignsubmission_" in folder:
        return ""
    below = names[0][len(folder) + 1 :].partition("/")[0]
    several = any(name[len(folder) + 1 :].partition("/")[0] != below for name in names)
    if several or len(names) == 1:
        return f"{folder}/"
    return f"{folder}/" + _root([name[len(folder) + 1 :] for name in names])


class FirstOnes:
    """The first submission of each student, as far as they have gone by.

    paths   all that is handed in: what a file, or a platform's folder, is named after goes before a line inside
    """

    def __init__(self, paths: Iterable[str | Path] = ()) -> None:
        self._paths = paths
        self._seen: dict[str, Where] = {}

    @cached_property
    def _named(self) -> frozenset[str]:
        """The names of students that files, folders and members of archives bear."""
        students: set[str] = set()
        for path in map(Path, self._paths):
            with suppress(GraphkinError, OSError):
                names = [path.name]
                if path.is_dir():
                    names = sorted(_walked(path))
                elif path.suffix.lower() == ".zip":
                    with archives.opened(path, where := Where(str(path))) as archive:
                        names = [*map(archives.member_name, archives.members(archive, where, LIMITS))]
                students.update(name for who, _ in _grouped(names) for name in (who.student, *who.others))
        return frozenset(students)

    def reason(self, student: str, file: str, place: str) -> errors.HandedTwice | errors.TwoNames | None:
        """Why this submission is not marked, being another's or a further one; None where it is the student's first."""
        if not place.isdecimal():
            name = place or Path(file).name
            own = owner(name), owner(name, alone=True)
            if not any(student in (who.student, *who.others) for who in own) and student in self._named:
                return errors.TwoNames(Where(file), own[0].student, student)
        here = Where(file, int(place) if place.isdecimal() else None)
        first = self._seen.setdefault(student, here)
        return None if first is here else errors.HandedTwice(here, student, str(first))


def called(student: str, reason: GraphkinError) -> str:
    """The student whose submission is not marked; of one that is another's, nobody."""
    return reason.named if isinstance(reason, errors.TwoNames) else student
