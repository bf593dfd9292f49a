"""One hand-in read, and all of them: whatever is in it, one `Submission` comes out, and nothing is raised."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import PurePosixPath

from graphkin import errors
from graphkin.base.value import frozen
from graphkin.errors import GraphkinError, Where
from graphkin.submissions import archives, documents
from graphkin.submissions.answers import answers_at, named_at, of_file
from graphkin.submissions.archives import decoded
from graphkin.submissions.documents import StudentDocument
from graphkin.submissions.handed import Handed, called
from graphkin.submissions.pool import limited
from graphkin.submissions.questions import Questions
from graphkin.submissions.submission import DRAWINGS, Limits, MeasuredDrawing, ReadableProblem, Submission, tidy_id

Key = ReadableProblem | Callable[[str], ReadableProblem | None]
"""One problem for all, or each student's own by id; None for a student there is not."""

USUAL = Limits()
_DOCUMENTS = {
    ".toml": documents.read_toml, ".json": documents.read_json, ".txt": documents.read_lines,
    ".md": documents.read_lines,
}  # fmt: skip
_INNER = 50  # files in an archive that a student hands in


def read_one(handed: Handed, asked: Key, limits: Limits = USUAL) -> Submission:
    """A hand-in, read within its time. It never raises: an error of graphkin's own is a reason, too."""
    where = Where(handed.file)
    student = handed.owner.student
    try:
        with limited(limits.seconds, where):
            if handed.reason is not None:
                raise handed.reason
            contents = _contents(handed, limits)
            stated = next((document.student for document in contents.documents if document.student), "")
            student = tidy_id(stated) or student
            student, key = _key(handed, stated, asked, where)
            return _read(handed, student, key, contents, limits)
    except GraphkinError as reason:
        return _refused(handed, student, reason)
    except (Exception, RecursionError) as problem:
        return _refused(handed, student, errors.OwnFault(where, type(problem).__name__))


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
        raise errors.TwoNames(where, owner.student, own[0])
    for name in names:
        if (problem := asked(name)) is not None:
            return name, problem
    raise errors.UnknownStudent(where, names[0])


@frozen
class _Contents:
    """The documents in a hand-in, its drawings by name, and why the rest is passed over."""

    documents: tuple[StudentDocument, ...]
    drawings: tuple[tuple[str, bytes], ...]
    notes: tuple[GraphkinError, ...]


def _contents(handed: Handed, limits: Limits) -> _Contents:
    """The files sorted by kind. Raises the first note where there is nothing else."""
    if handed.row is not None:
        return _Contents((handed.row,), (), ())
    texts: list[StudentDocument] = []
    drawings: list[tuple[str, bytes]] = []
    notes: list[GraphkinError] = []
    for name, content in _unpacked(handed, limits, notes):
        try:
            if PurePosixPath(name).suffix.lower() in DRAWINGS:
                drawings.append((name, content))
            else:
                texts.append(_document(name, content, _where(handed, name), limits))
        except GraphkinError as problem:
            notes.append(problem)
    if not texts and not drawings:
        raise notes[0] if notes else errors.NoAnswers(Where(handed.file))
    return _Contents(tuple(texts), tuple(drawings), tuple(notes))


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
                few = replace(limits, members=_INNER, archive_bytes=4 * limits.bytes)
                for info in archives.members(archive, where, few):
                    yield archives.member_name(info), archives.read_member(archive, info, where, few)
        except GraphkinError as problem:
            notes.append(problem)


def _document(name: str, content: bytes, where: Where, limits: Limits) -> StudentDocument:
    suffix = PurePosixPath(name).suffix.lower()
    if not content.strip(b"\0 \r\n\t"):
        raise errors.NoAnswers(where)
    limits.check(where, "bytes", len(content))
    if suffix in _DOCUMENTS:
        return _DOCUMENTS[suffix](decoded(content, where), where, limits)
    if suffix not in (*documents.PLAIN_TABLES, *documents.SHEETS):
        raise errors.NotMarkable(where, suffix or name[:40])
    rows = documents.rows_of(documents.cells_of(name, content, where, limits), where, limits)
    row = next(rows, None)
    if row is None:
        raise errors.NoAnswers(where)
    other = next((other.student for other in rows if other.student not in ("", row.student)), None)
    if other is not None:
        raise errors.SeveralStudents(where, tidy_id(row.student), tidy_id(other))
    return row


def _read(handed: Handed, student: str, key: ReadableProblem, contents: _Contents, limits: Limits) -> Submission:
    from graphkin.submissions.drawings import measured

    entries = (entry for document in contents.documents for entry in document.entries)
    written = answers_at(entries, key, _questions, limits)
    values, drawn, notes = dict(written.values), dict[int, MeasuredDrawing](), [*contents.notes, *written.notes]
    for name, content in contents.drawings:
        try:
            asked, at = of_file(name, key)
            where, scales = _where(handed, name), written.scales
            vectors, drawn[at], others = measured(name, content, where, asked, scales, _questions(asked), limits)
            values = {**named_at(vectors, at), **values}
            notes += others
        except GraphkinError as problem:
            notes.append(problem)
    if not values:
        if len(notes) == 1 and not isinstance(notes[0], errors.BrokenSubmission):
            raise notes[0]
        whole = (note for note in notes if not isinstance(note, errors.NotAQuestion))  # what stopped a file as a whole
        raise next(whole, errors.NoAnswers(Where(handed.file)))
    return Submission(student, handed.file, values, None, tuple(notes), handed.place, drawn)


_REMEMBERED: list[tuple[ReadableProblem, Questions]] = []
"""The last few problems' readers of questions: a class asks the same over and over."""


def _questions(key: ReadableProblem) -> Questions:
    for asked, questions in _REMEMBERED:
        one, other = asked.mechanism, key.mechanism  # between processes copies: their text is what they are
        same = one is other or bool(one.text and one.text == other.text)
        if asked is key or (asked.questions == key.questions and same):
            return questions
    questions = Questions(key.mechanism, key.questions)
    _REMEMBERED.append((key, questions))
    del _REMEMBERED[:-8]
    return questions
