"""All there is to read, one hand-in after another: files, folders, students of an archive, rows of a class table.

Nothing of a student's is parsed here but the cells of a class table; that is `read_one`'s.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath

from graphkin import errors
from graphkin.base.value import frozen
from graphkin.errors import GraphkinError, Where
from graphkin.model.quantities import position_of
from graphkin.submissions import archives
from graphkin.submissions.documents import PLAIN_TABLES, SHEETS, StudentDocument, cells_of, csv_cells, listed, rows_of
from graphkin.submissions.pool import limited
from graphkin.submissions.students import GRADESCOPE, Owner, Roster, owner, submitters
from graphkin.submissions.submission import Limits, MeasuredDrawing, fingerprint, tidy_id


@frozen
class Handed:
    """The files of one student, unread.

    owner    who it seems to be; a file may state an id itself
    file     as results call it; place: line of the class table, or the member's name
    row      of a class table, instead of files by their names; reason: why there is nothing to read
    drawing  what was measured on photographs of it, beside the files or alone
    """

    owner: Owner
    file: str
    place: str = ""
    files: tuple[tuple[str, bytes], ...] = ()
    row: StudentDocument | None = None
    reason: GraphkinError | None = None
    drawing: MeasuredDrawing | None = None

    @property
    def digest(self) -> str:
        """Of all that it holds, by which a broken-off marking knows it again."""
        files = (part for name, content in self.files for part in (name, content))
        measured = (repr(self.drawing),) if self.drawing is not None else ()
        return fingerprint(repr((self.owner.student, self.file, self.row)), *measured, *files)


def handed_in(paths: Iterable[str | Path], limits: Limits, roster: Roster | None = None) -> Iterator[Handed]:
    """Everything in these files, archives and folders, in order; what cannot be opened comes with its reason."""
    for path in map(Path, paths):
        where = Where(str(path))
        try:
            yield from _of_path(path, where, limits, roster)
        except GraphkinError as reason:
            yield Handed(_own(path), str(path), reason=reason)
        except OSError as problem:
            yield Handed(_own(path), str(path), reason=errors.Unreadable(where, problem.strerror or str(problem)))


def _own(path: Path, roster: Roster | None = None) -> Owner:
    """By the name of a file, in a folder of Moodle's by that."""
    folder = path.parent.name
    return owner(f"{folder}/{path.name}" if "_assignsubmission_" in folder else path.name, roster=roster)


def _of_path(path: Path, where: Where, limits: Limits, roster: Roster | None) -> Iterator[Handed]:
    if path.is_dir():
        names = sorted(_walked(path))  # as an archive that was unpacked; links out of it are not followed
        if not names:
            raise errors.NoAnswers(where)
        if _is_class_table(names):
            yield from _of_path(path / names[0], Where(f"{path}/{names[0]}"), limits, roster)
        else:
            limits.check(where, "members", len(names))
            yield from _of_students(names, f"{path}/", lambda k, at: _content(path / names[k], at, limits), roster)
    elif not path.exists():
        raise errors.NoFile(where, path.name, ())
    elif not path.is_file():
        raise errors.Unreadable(where, "not a file")
    elif path.suffix.lower() == ".zip" and _own(path, roster).by_file:  # one student's, as 学习通 packs them
        yield Handed(_own(path, roster), str(path), files=((path.name, _content(path, where, limits)),))
    elif path.suffix.lower() == ".zip":
        yield from _of_archive(path, where, limits, roster)
    elif path.suffix.lower() in PLAIN_TABLES:
        with path.open("rb") as stream:
            yield from _of_table(rows_of(csv_cells(stream, where), where, limits), _own(path, roster), where, limits)
    elif path.suffix.lower() in SHEETS:
        cells = cells_of(path.name, _content(path, where, limits), where, limits)
        yield from _of_table(rows_of(cells, where, limits), _own(path, roster), where, limits)
    else:
        content, students = _content(path, where, limits), None
        if path.suffix.lower() == ".json" and content.lstrip(b"\xef\xbb\xbf \r\n\t")[:1] == b"[":
            students = listed(archives.decoded(content, where), where, limits)
        for student in students or ():
            yield _of_row(student, _own(path, roster), str(path))
        if not students:
            yield Handed(_own(path, roster), str(path), files=((path.name, content),))


def _content(path: Path, where: Where, limits: Limits) -> bytes:
    with path.open("rb") as stream:
        return archives.content(stream, path.name, where, limits)


def _of_table(rows: Iterator[StudentDocument], by_file: Owner, where: Where, limits: Limits) -> Iterator[Handed]:
    """Each row read within the time of a submission; what breaks off in the middle keeps the rows before it."""
    file, line, named = str(where.file), 0, False
    try:
        while True:
            with limited(limits.seconds, where):
                row = next(rows, None)
            if row is None and not line:
                raise errors.NoRows(where)
            if row is None:
                return
            line, nobody = row.line, named and not row.student.strip()
            named = named or bool(row.student.strip())
            handed = _of_row(row, by_file, file)
            yield replace(handed, row=None, reason=errors.NamesNobody(Where(file, line))) if nobody else handed
    except GraphkinError as reason:
        yield Handed(by_file, file, place=str(line + 1) if line else "", reason=reason.at(where))


def _of_row(row: StudentDocument, by_file: Owner, file: str) -> Handed:
    student = Owner(tidy_id(row.student), str(row.line)) if row.student.strip() else by_file
    return Handed(student, file, str(row.line), row=row)


def _of_archive(path: Path, where: Where, limits: Limits, roster: Roster | None) -> Iterator[Handed]:
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
        yield from _of_students(
            names, f"{path}!", lambda k, at: archives.read_member(archive, infos[k], at, limits), roster
        )


def _of_students(
    names: list[str], before: str, read: Callable[[int, Where], bytes], roster: Roster | None
) -> Iterator[Handed]:
    """The files of each student, read by their numbers; a reason only where none of them can be read."""
    by_folder: Mapping[str, Owner] = {}
    lists = [k for k, name in enumerate(names) if name.rpartition("/")[2] == GRADESCOPE]
    for k in lists:
        where = Where(before + names[k])
        by_folder = {**by_folder, **submitters(archives.decoded(read(k, where), where))}
    for who, numbers in _grouped(names, roster, by_folder):
        files, reason = list[tuple[str, bytes]](), None
        if numbers[0] in lists:
            continue
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


def _grouped(
    names: list[str], roster: Roster | None, by_folder: Mapping[str, Owner]
) -> Iterator[tuple[Owner, list[int]]]:
    """The files of each hand-in, in order; a student's answers and drawing are one, a second of a kind is another."""
    root, shared, kinds = _root(names), set[int](), set[int]()
    for name in names:  # a folder with several files of one kind is a class's; a student's has answers and a drawing
        file, folder = PurePosixPath(name), name.rpartition("/")[0]
        kind = hash((folder, file.suffix.lower(), position_of(file.stem)[1]))
        shared |= {hash(folder)} if kind in kinds else set()
        kinds.add(kind)

    def of(k: int) -> Owner:
        parts = names[k].removeprefix(root).split("/")
        if (own := by_folder.get(parts[0])) is not None:
            return own
        return owner(names[k], root, hash(names[k].rpartition("/")[0]) in shared, roster)

    groups: dict[tuple[str, int], list[int]] = {}
    times = Counter[tuple[str, str, int]]()
    for k, name in enumerate(names):
        by, file = of(k), PurePosixPath(name)
        sort = (by.group, file.suffix.lower(), position_of(file.stem)[1])
        groups.setdefault((by.group, times[sort]), []).append(k)
        times[sort] += by.by_file
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
