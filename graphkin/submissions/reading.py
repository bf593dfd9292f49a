"""One hand-in read, and all of them: whatever is in it, one `Submission` comes out, and nothing is raised."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path, PurePosixPath

from graphkin.errors import (
    BrokenSubmission,
    GraphkinError,
    NoAnswers,
    NotMarkable,
    OwnFault,
    SeveralStudents,
    TooMuch,
    TwoNames,
    UnknownStudent,
    Where,
)
from graphkin.model.mechanism import Mechanism
from graphkin.submissions import archives
from graphkin.submissions.answers import Answers, answers_at, named_at, of_file
from graphkin.submissions.archives import decoded
from graphkin.submissions.documents import (
    StudentDocument,
    TableRow,
    csv_cells,
    read_json,
    read_lines,
    read_toml,
    rows_of,
    xlsx_cells,
)
from graphkin.submissions.handed import FirstOnes, Handed, called, handed_in
from graphkin.submissions.numbers import short
from graphkin.submissions.pool import limited
from graphkin.submissions.questions import Questions
from graphkin.submissions.submission import (
    DRAWINGS,
    HandedValue,
    Limits,
    MeasuredDrawing,
    ReadableProblem,
    Submission,
    tidy_id,
)

Key = ReadableProblem | Callable[[str], ReadableProblem | None]
"""One problem for all, or each student's own by id; None for a student there is not."""

USUAL = Limits()
_DOCUMENTS = {".toml": read_toml, ".json": read_json, ".txt": read_lines, ".md": read_lines}
_INNER = 50
"""Files in an archive that a student hands in."""


def read(paths: Iterable[str | Path], asked: Key, limits: Limits = USUAL) -> Iterator[Submission]:
    """Every submission in these files, archives and folders, in order; a second one of a student says so."""
    paths = [*paths]
    seen = FirstOnes(paths)
    for handed in handed_in(paths, limits):
        one = read_one(handed, asked, limits)
        second = seen.reason(one.student, one.file, one.place) if one.reason is None else None
        yield one if second is None else _refused(handed, one.student, second)


def read_one(handed: Handed, asked: Key, limits: Limits = USUAL) -> Submission:
    """What was handed in, read within its time. It never raises: an error of graphkin's own is a reason, too."""
    where = Where(handed.file)
    student = handed.owner.student
    try:
        with limited(limits.seconds, where):
            if handed.reason is not None:
                raise handed.reason
            documents, drawings, notes = _sorted_out(handed, limits)
            stated = next((document.student for document in documents if document.student), "")
            student = tidy_id(stated) or student
            student, key = _key(handed, stated, asked, where)
            return _read(handed, student, key, documents, drawings, notes, limits)
    except GraphkinError as reason:
        return _refused(handed, student, reason)
    except (Exception, RecursionError) as problem:
        return _refused(handed, student, OwnFault(where, type(problem).__name__))


def _refused(handed: Handed, student: str, reason: GraphkinError) -> Submission:
    return Submission(called(student, reason), handed.file, reason=reason, place=handed.place)


def _key(handed: Handed, stated: str, asked: Key, where: Where) -> tuple[str, ReadableProblem]:
    """The problem of a student: by what the platform calls them, which no file can claim; else by the id it states,
    unless the file is named after another student."""
    owner, own = handed.owner, [tidy_id(stated)] if tidy_id(stated) else []
    names = [owner.student, *owner.others, *own] if owner.others else own or [owner.student]
    if isinstance(asked, ReadableProblem):
        return names[0], asked
    if names == own != [owner.student] and asked(owner.student) is not None and asked(own[0]) is not None:
        raise TwoNames(where, owner.student, own[0])
    for name in names:
        if (found := asked(name)) is not None:
            return name, found
    raise UnknownStudent(where, names[0])


# --- what kind of file it is ------------------------------------------------------------------

_Sorted = tuple[list[StudentDocument], list[tuple[str, bytes]], list[GraphkinError]]


def _sorted_out(handed: Handed, limits: Limits) -> _Sorted:
    """The documents in a hand-in, its drawings, and why the rest is passed over; where that is all, it is raised."""
    if handed.row is not None:
        return [_of_row(handed.row, Where(handed.file))], [], []
    documents: list[StudentDocument] = []
    drawings: list[tuple[str, bytes]] = []
    notes: list[GraphkinError] = []
    for name, content in _unpacked(handed, limits, notes):
        where = _where(handed, name)
        try:
            if PurePosixPath(name).suffix.lower() in DRAWINGS:
                drawings.append((name, content))
            else:
                documents.append(_document(name, content, where, limits))
        except GraphkinError as problem:
            notes.append(problem)
    if not documents and not drawings:
        raise notes[0] if notes else NoAnswers(Where(handed.file))
    return documents, drawings, notes


def _where(handed: Handed, name: str) -> Where:
    """The file itself; in a hand-in of several, that one of them."""
    return Where(handed.file if len(handed.files) == 1 else handed.file.removesuffix(handed.place) + name)


def _unpacked(handed: Handed, limits: Limits, notes: list[GraphkinError]) -> Iterator[tuple[str, bytes]]:
    """The files, those of an archive within one level too."""
    for name, content in handed.files:
        if PurePosixPath(name).suffix.lower() != ".zip":
            yield name, content
            continue
        where = _where(handed, name)
        try:
            with archives.opened(content, where) as archive:
                few = dataclasses.replace(limits, members=_INNER, archive_bytes=4 * limits.bytes)
                for info in archives.members(archive, where, few):
                    yield archives.member_name(info), archives.read_member(archive, info, where, few)
        except GraphkinError as problem:
            notes.append(problem)


def _document(name: str, content: bytes, where: Where, limits: Limits) -> StudentDocument:
    suffix = PurePosixPath(name).suffix.lower()
    if not content.strip(b"\0 \r\n\t"):
        raise NoAnswers(where)
    if len(content) > limits.bytes:
        raise TooMuch(where, "bytes", limits.bytes)
    if suffix in _DOCUMENTS:
        return _DOCUMENTS[suffix](decoded(content, where), where, limits)
    if suffix in (".csv", ".tsv"):
        import io

        return _table(rows_of(csv_cells(io.BytesIO(content), where), where, limits), where)
    if suffix in (".xlsx", ".xlsm"):
        return _table(rows_of(xlsx_cells(content, where, limits), where, limits), where)
    raise NotMarkable(where, suffix or name[:40])


def _table(rows: Iterator[TableRow], where: Where) -> StudentDocument:
    row = next(rows, None)
    if row is None:
        raise NoAnswers(where)
    other = next((other.student for other in rows if other.student not in ("", row.student)), None)
    if other is not None:
        raise SeveralStudents(where, tidy_id(row.student), tidy_id(other))
    return _of_row(row, where)


def _of_row(row: TableRow, where: Where) -> StudentDocument:
    places = ((name, value, Where(where.file, line, short(name))) for name, value, line in row.entries)
    return StudentDocument(row.student, tuple(places))


# --- reading it -------------------------------------------------------------------------------


def _read(
    handed: Handed,
    student: str,
    key: ReadableProblem,
    documents: list[StudentDocument],
    drawings: list[tuple[str, bytes]],
    notes: list[GraphkinError],
    limits: Limits,
) -> Submission:
    told = answers_at((entry for document in documents for entry in document.entries), key, _questions, limits)
    values, drawn, more = dict(told.values), dict[int, MeasuredDrawing](), [*notes, *told.notes]
    for name, content in drawings:
        try:
            asked, at = of_file(name, key)
            measured, drawn[at], others = _measured(name, content, _where(handed, name), asked, told, limits)
            values = {**named_at(measured, at), **values}
            more += others
        except GraphkinError as problem:
            more.append(problem)
    if not values:
        raise more[0] if len(more) == 1 and not isinstance(more[0], BrokenSubmission) else _worst(more, handed)
    return Submission(student, handed.file, values, None, tuple(more), handed.place, drawn)


def _worst(notes: list[GraphkinError], handed: Handed) -> GraphkinError:
    """Why there is nothing to mark: what stopped a file as a whole, else that no answer was found."""
    from graphkin.errors import NotAQuestion

    whole = [note for note in notes if not isinstance(note, NotAQuestion)]
    return whole[0] if whole else NoAnswers(Where(handed.file))


def _measured(
    name: str, content: bytes, where: Where, asked: ReadableProblem, told: Answers, limits: Limits
) -> tuple[dict[str, HandedValue], MeasuredDrawing, list[GraphkinError]]:
    from graphkin.submissions.drawings import measured

    return measured(name, content, where, asked, told.scales, _questions(asked), limits)


_REMEMBERED: list[tuple[ReadableProblem, Questions]] = []
"""The last few problems' readers of questions: a class asks the same over and over."""


def _questions(key: ReadableProblem) -> Questions:
    for asked, questions in _REMEMBERED:
        if asked is key or (asked.questions == key.questions and _same(asked.mechanism, key.mechanism)):
            return questions
    found = Questions(key.mechanism, key.questions)
    _REMEMBERED.append((key, found))
    del _REMEMBERED[:-8]
    return found


def _same(one: Mechanism, other: Mechanism) -> bool:
    """Between processes mechanisms are copies; their text is what they are."""
    return one is other or bool(one.text and one.text == other.text)
