"""One hand-in read, and all of them: whatever is in it, one `Submission` comes out, and nothing is raised."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import field, replace
from functools import cached_property
from itertools import chain
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from graphkin import errors
from graphkin.base.cache import kept
from graphkin.base.value import frozen
from graphkin.errors import NOWHERE, GraphkinError, Where
from graphkin.submissions import archives, documents, office
from graphkin.submissions.answers import answers_at, named_at, of_file
from graphkin.submissions.archives import decoded
from graphkin.submissions.board import HandedBoard, board_in
from graphkin.submissions.documents import StudentDocument
from graphkin.submissions.handed import Handed, handed_in
from graphkin.submissions.pool import limited
from graphkin.submissions.questions import Questions
from graphkin.submissions.students import Owner, Roster, file_text, owner
from graphkin.submissions.submission import DRAWINGS, Limits, MeasuredDrawing, ReadableProblem, Submission, tidy_id

if TYPE_CHECKING:
    from graphkin.submissions.letters import PaperPolygon

Key = ReadableProblem | Callable[[str], ReadableProblem | None]
"""One problem for all, or each student's own by id; None for a student there is not."""

USUAL = Limits()
_DOCUMENTS = {
    ".toml": documents.read_toml, ".json": documents.read_json, ".txt": documents.read_lines,
    ".md": documents.read_lines,
}  # fmt: skip
_PICTURES = (".jpg", ".jpeg", ".png", ".heic", ".heif")
_INNER, _WITHIN = 50, 2  # files in an archive that a student hands in; archives within each other


def read_one(handed: Handed, asked: Key, limits: Limits = USUAL, roster: Roster | None = None) -> Submission:
    """A hand-in, read within its time. It never raises: an error of graphkin's own is a reason, too."""
    where = Where(handed.file)
    student = handed.owner.student
    try:
        with limited(limits.seconds, where):
            try:
                contents = _contents(handed, limits)
            except Exception:  # of what cannot be read folders and names tell whose it is
                with suppress(GraphkinError):
                    if roster is not None and handed.row is None:
                        student = whose(handed, (), roster, where)
                raise
            lines = _lines(contents)
            if not handed.owner.number:
                student = tidy_id(next((line for line in lines if line), "")) or student
            student = whose(handed, lines, roster, where)
            key = asked if isinstance(asked, ReadableProblem) else asked(student)
            if key is None:
                raise errors.UnknownStudent(where, student)
            return _read(handed, student, key, contents, limits)
    except GraphkinError as reason:
        return _refused(handed, student, reason)
    except (Exception, RecursionError) as problem:
        return _refused(handed, student, errors.OwnFault(where, type(problem).__name__))


def student_of(handed: Handed, limits: Limits, roster: Roster | None) -> str:
    """The student whom a hand-in names, as `read_one` takes it; "" where it names none."""
    try:
        with limited(limits.seconds, Where(handed.file)):
            return whose(handed, _lines(_contents(handed, limits)), roster, Where(handed.file))
    except GraphkinError:
        return ""


def files_of(handed: Handed, limits: Limits) -> Iterator[tuple[str, bytes]]:
    """The files of a hand-in, those of archives with them; what cannot be opened is left out."""
    for file in handed.files:
        yield from _unpacked(*file, where_of(handed, file[0]), limits, [])


def _refused(handed: Handed, student: str, reason: GraphkinError) -> Submission:
    return Submission(called(student, reason), handed.file, reason=reason, place=handed.place)


def called(student: str, reason: GraphkinError) -> str:
    """The student whose submission is not marked; of one that is another's, nobody."""
    return reason.named if isinstance(reason, errors.TwoNames | errors.SameName) else student


def _lines(contents: _Contents) -> list[str]:
    """The lines inside that say whose it is."""
    return [line for document in contents.documents for line in document.called]


def whose(handed: Handed, lines: Sequence[str], roster: Roster | None, where: Where) -> str:
    """The student, by the class list. Without one by what the platform calls them, which no line can claim; else by a
    line inside, or by the name of the file. Raises UnknownStudent, TwoNames, SameName."""
    by = handed.owner
    if roster is not None:
        if handed.row is not None and lines:  # of a class table: who it is from tells nothing
            return roster.whose(Owner("", ""), (), lines, where)
        return roster.whose(by, [file_text(name, by) for name, _ in handed.files] or [by.student], lines, where)
    return by.student if by.number else tidy_id(next((line for line in lines if line), "")) or by.student


class FirstOnes:
    """The first submission of each student, as far as they have gone by.

    paths   all that is handed in: what a file, or a platform's folder, is named after goes before a line inside
    """

    def __init__(self, paths: Iterable[str | Path] = (), roster: Roster | None = None) -> None:
        self._paths, self._roster = paths, roster
        self._seen: dict[str, Where] = {}

    @cached_property
    def _named(self) -> Mapping[str, tuple[set[str], set[str]]]:
        """Of each student the folders and files that bear their name, or in which a line says so."""
        named: dict[str, tuple[set[str], set[str]]] = {}
        for handed in handed_in(self._paths, USUAL, self._roster):
            if handed.row is not None:
                continue
            with suppress(GraphkinError):
                own, at = _by_names(handed.owner, [name for name, _ in handed.files], self._roster), 0
                if not own and handed.owner.number:
                    own, at = {whose(handed, _lines(_contents(handed, USUAL)), self._roster, NOWHERE)}, 1
                for student in own:
                    named.setdefault(student, (set(), set()))[at].add(handed.file)
        return named

    def reason(self, student: str, file: str, place: str) -> errors.HandedTwice | errors.TwoNames | None:
        """The reason not to mark a submission, another's or a further one; None where it is the student's first."""
        if not place.isdecimal():
            name = place or Path(file).name
            own = owner(name, roster=self._roster), owner(name, alone=True)
            if not any(student in _by_names(by, [name], self._roster) for by in own):
                by_name, by_line = self._named.get(student, (set(), set()))
                if file not in by_name and (by_name or by_line - {file}):
                    return errors.TwoNames(Where(file), own[0].folder or own[0].student, student)
        here = Where(file, int(place) if place.isdecimal() else None)
        first = self._seen.setdefault(student, here)
        return None if first is here else errors.HandedTwice(here, student, str(first))


def _by_names(by: Owner, names: Sequence[str], roster: Roster | None) -> set[str]:
    """The students whom a folder or names of files name, or what would stand for one."""
    if roster is None:
        return {by.student, by.folder} - {""}
    texts = (by.folder, *(file_text(name, by) for name in names if not by.number))
    return {*roster.numbered(by.number)}.union(*(some for text in texts for some in roster.named(text)))


@frozen
class _Contents:
    """The documents, the drawings, those of them that are boards, and why the rest is passed over."""

    documents: tuple[StudentDocument, ...]
    drawings: tuple[tuple[str, bytes], ...]
    notes: tuple[GraphkinError, ...]
    boards: Mapping[str, HandedBoard] = field(default_factory=dict)


def _contents(handed: Handed, limits: Limits) -> _Contents:
    """The files sorted by kind. Raises why it was not taken, or the first note where there is nothing else."""
    if handed.reason is not None:
        raise handed.reason
    if handed.row is not None:
        return _Contents((handed.row,), (), ())
    texts: list[StudentDocument] = []
    drawings: list[tuple[str, bytes]] = []
    notes: list[GraphkinError] = []
    boards: dict[str, HandedBoard] = {}
    unpacked = (_unpacked(*file, where_of(handed, file[0]), limits, notes) for file in handed.files)
    for name, content in chain.from_iterable(unpacked):
        try:
            if PurePosixPath(name).suffix.lower() in DRAWINGS:
                if (board := board_in(content, where_of(handed, name), limits)) is not None:
                    boards[name] = board
                    texts.append(board.document)
                drawings.append((name, content))
            else:
                texts.append(_document(name, content, where_of(handed, name), limits))
        except GraphkinError as problem:
            notes.append(problem)
    if not texts and not drawings and handed.drawing is None:
        raise notes[0] if notes else errors.NoAnswers(Where(handed.file))
    return _Contents(tuple(texts), tuple(drawings), tuple(notes), boards)


def where_of(handed: Handed, name: str) -> Where:
    """The file itself; in a hand-in of several, that one of them."""
    return Where(handed.file if len(handed.files) == 1 else handed.file.removesuffix(handed.place) + name)


def _unpacked(
    name: str, content: bytes, where: Where, limits: Limits, notes: list[GraphkinError], within: int = 0
) -> Iterator[tuple[str, bytes]]:
    """A file, or those of an archive; a platform packs the archive that a student hands in once more."""
    if PurePosixPath(name).suffix.lower() != ".zip" or within == _WITHIN:
        yield name, content
        return
    few = replace(limits, members=_INNER, archive_bytes=4 * limits.bytes)
    try:
        with archives.opened(content, where) as archive:
            for info in archives.members(archive, where, few):
                inner = archives.member_name(info), archives.read_member(archive, info, where, few)
                yield from _unpacked(*inner, where, limits, notes, within + 1)
    except GraphkinError as problem:
        notes.append(problem)


def _document(name: str, content: bytes, where: Where, limits: Limits) -> StudentDocument:
    suffix = PurePosixPath(name).suffix.lower()
    if not content.strip(b"\0 \r\n\t"):
        raise errors.NoAnswers(where)
    limits.check(where, "bytes", len(content))
    if suffix in _DOCUMENTS:
        document = _DOCUMENTS[suffix](decoded(content, where), where, limits)
        if not document.entries:
            raise errors.NoAnswers(where)
        return document
    if suffix in office.READERS:
        return office.READERS[suffix](content, where, limits)
    if suffix in _PICTURES:
        raise errors.NoSheetsKnown(where)
    if suffix not in (*documents.PLAIN_TABLES, *documents.SHEETS):
        raise errors.NotMarkable(where, suffix or name[:40])
    return documents.of_one(documents.cells_of(name, content, where, limits), where, limits)


def pictures_of(files: Set[str], limits: Limits = USUAL) -> dict[str, office.Seen]:
    """The first picture in each of these hand-ins, as results call them, that has one."""
    paths = dict.fromkeys(file.partition("!")[0] for file in sorted(files))
    parts = ((one.file, part) for one in handed_in(paths, limits) if one.file in files for _, part in one.files)
    inside = ((file, office.picture_in(content, Where(file), limits)) for file, content in parts)
    return {file: seen for file, seen in inside if seen is not None}


def _read(handed: Handed, student: str, key: ReadableProblem, contents: _Contents, limits: Limits) -> Submission:
    from graphkin.submissions.drawings import drawn_values, lettered_vectors, measured

    entries = (entry for document in contents.documents for entry in document.entries)
    written = answers_at(entries, key, _questions, limits)
    values, drawn, notes = dict(written.values), dict[int, MeasuredDrawing](), [*contents.notes, *written.notes]
    for name, board in contents.boards.items():
        board.refuse_foreign(key.mechanism, where_of(handed, name))
    work = next((board.work for name, board in contents.boards.items() if of_file(name, key)[1] == 1), None)
    for name, content in contents.drawings:
        try:
            asked, at = of_file(name, key)
            where, own = where_of(handed, name), contents.boards.get(name)
            scales = written.scales if own is None else {**written.scales, **own.work.scales}
            vectors, drawn[at], others = measured(name, content, where, asked, scales, _questions(asked), limits)
            if own is not None:  # its pencil is as exact as a sheet's
                remarks = (remark for remark in drawn[at].remarks if not isinstance(remark, errors.OwnSheet))
                drawn[at] = replace(drawn[at], remarks=tuple(remarks))
            values = {**named_at(vectors, at), **values}
            notes += others
        except GraphkinError as problem:
            notes.append(problem)
    if handed.drawing is not None and 1 not in drawn:
        drawn[1] = replace(handed.drawing, points=handed.drawing.sure)
        values = {**drawn_values(lettered_vectors(drawn[1], paper_polygons(key))), **values}
    if not values and work is None and not any(one.unsure for one in drawn.values()):
        if len(notes) == 1 and not isinstance(notes[0], errors.BrokenSubmission):
            raise notes[0]
        whole = (note for note in notes if not isinstance(note, errors.NotAQuestion))  # what stopped a file as a whole
        raise next(whole, errors.NoAnswers(Where(handed.file)))
    return Submission(student, handed.file, values, None, tuple(notes), handed.place, drawn, work)


def paper_polygons(key: ReadableProblem) -> tuple[PaperPolygon, ...]:
    """The polygons that a drawing on paper has letters of."""
    from graphkin.submissions.letters import polygons

    return polygons(key.mechanism, _questions(key))


@kept(8)  # a class asks the same over and over
def _questions(key: ReadableProblem) -> Questions:
    """The reader of a problem's questions."""
    return Questions(key.mechanism, key.questions)
