"""The students of a class, and the one matcher of what is handed in with them: folders, names of files, lines inside.

    class list (CSV, XLSX; of Moodle, Canvas, Gradescope, 学习通) --students_in--> Students --> Roster
    what a platform's folder says, then what files are called, then lines inside --Roster.whose--> the one student

What stands higher goes before what stands lower, and one that names nobody says nothing. Where two of them name
different students, or a name alone is that of two, nobody is named.
"""

from __future__ import annotations

import difflib
import re
import unicodedata
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache
from itertools import islice
from pathlib import PurePosixPath
from typing import Literal

from graphkin.base.value import frozen
from graphkin.errors import NoStudents, SameName, StudentTwice, StudentWithoutId, TwoNames, UnknownStudent, Where
from graphkin.model.quantities import position_of
from graphkin.submissions.submission import DRAWINGS, tidy_id

Field = Literal["id", "login", "number", "email", "name", "given", "family"]
_HEADS: Mapping[Field, tuple[str, ...]] = {
    "id": ("student", "student id", "studentid", "student number", "student no", "学号", "id", "id number", "学生学号",
           "考号", "学号/工号", "工号", "编号", "sid", "sis user id"),
    "login": ("sis login id", "username", "user name", "用户名", "user", "login", "账号", "登录名"),
    "number": ("identifier", "participant", "标识符", "标识号", "参与者"),
    "email": ("email", "email address", "e-mail", "邮箱", "电子邮件", "电子邮件地址", "电子邮箱", "邮箱地址",
              "email地址"),
    "name": ("学生", "name", "full name", "姓名", "学生姓名", "全名"),
    "given": ("first name", "given name", "名", "名字"),
    "family": ("last name", "surname", "family name", "姓", "姓氏"),
}  # fmt: skip
"""Heads of columns, and words before a colon, the most telling first."""
FIELDS: Mapping[str, Field] = {head: field for field, heads in _HEADS.items() for head in heads}
_IN_CANVAS = {"student": "name", "id": "identifier"}  # its gradebook calls the student's name so, and its own number
_NUMBER, _DIGIT = re.compile(r"^(?:participant|参与者|参加者|标识符)\s*([0-9]+)$"), re.compile(r"\d")
_CJK = "\u3040-\u30ff\u3400-\u9fff\uac00-\ud7af"
_PIECE = re.compile(rf"[{_CJK}]+|[^\W_{_CJK}]+")
_HARD = re.compile(r"[^\s.,'’·]")  # between words that are not of one name
_WORDS = re.compile(
    r"\b(?:hw|homework|assignment|answers?|work|problem|report|submission|final|draft|copy|new|of|by)\b"
    r"|第[一二三四五六七八九十]+[次章题]|大?作业|答案|答题[表卡]?|终稿|初稿|最终版?|修改版?|补[充交]|机械原理|机构"
    r"|运动简?图|加?速度图?|多边形|矢量图?|实验|报告|提交|姓名|学号"
)
"""Words in names of files, that are none of a student's."""
_MOST, _PIECES, _RUN = 1000, 40, 8  # letters of a text, pieces of it; in a row that are an id or a name
_DECIMALS = 4  # a shorter number in the midst of a name may be anything
_OF_A_SCHOOL = 8  # so long a number is no platform's, but an id
_LARGE = 5000  # in larger classes nobody is looked for who is nearly called so
_BEFORE_HEAD = 10  # lines of titles


@frozen
class Student:
    """`names`: other cells of the student's row by their heading, such as the name."""

    id: str
    names: tuple[tuple[str, str], ...] = ()

    @property
    def called(self) -> str:
        """The id and the name, as a page for all eyes has them: an address of e-mail stands there only for want of a
        name, and logins and a platform's numbers never."""
        name = next((text for text, field in stated_in(self.names).items() if field == "name"), "")
        return " ".join(filter(None, ("" if name and "@" in self.id else self.id, name)))


def field_of(head: str) -> Field | None:
    """The kind of what stands under a head, or after a word and a colon: `姓名：`; None of any other."""
    return FIELDS.get(_head(head))


def folded(text: str) -> str:
    """One writing of what people write in several: wide letters, capitals, accents."""
    bare = unicodedata.normalize("NFKD", unicodedata.normalize("NFKC", text)).casefold()
    return " ".join(unicodedata.normalize("NFC", "".join(c for c in bare if not unicodedata.combining(c))).split())


def students_in(rows: Iterable[Sequence[str]], where: Where) -> tuple[Student, ...]:
    """By the column of ids that a header names, else the first column of all rows, names in the second.

    Raises StudentTwice, StudentWithoutId, NoStudents."""
    filled = [row for row in rows if any(cell.strip() for cell in row)]
    begins = next((k for k, row in enumerate(filled[:_BEFORE_HEAD]) if id_column(row) is not None), -1)
    head, rest = [*filled[begins]] if begins >= 0 else ["id", ""], filled[begins + 1 :]
    if canvas := any(folded(cell).startswith("sis ") for cell in head):  # it has a row of points
        head = [_IN_CANVAS.get(folded(cell), cell) for cell in head]
    if begins < 0 and not any(_DIGIT.search("".join(row[1:2])) for row in rest):
        head = ["id", "name"]
    used = [name if any("".join(row[k : k + 1]).strip() for row in rest) else "" for k, name in enumerate(head)]
    at = id_column(used) or 0
    students: dict[str, Student] = {}
    for row in rest:
        id, cells = tidy_id("".join(row[at : at + 1])), enumerate(zip(used, row))
        if id in students:
            raise StudentTwice(where, id)
        names = tuple((tidy_id(name), tidy_id(cell)) for k, (name, cell) in cells if k != at and field_of(name))
        if id:
            students[id] = Student(id, names)
        elif not canvas and (nameless := next((cell for _, cell in names if cell), "")):
            raise StudentWithoutId(where, nameless)
    if not students:
        raise NoStudents(where)
    return tuple(students.values())


@lru_cache(256)
def _head(text: str) -> str:
    return folded(text[:60]).replace("_", " ").strip(" :")


def id_column(head: Sequence[str]) -> int | None:
    """The column that tells students apart best; None where no head stands for one."""
    known = [*map(_head, head)]
    return next((known.index(name) for name, field in FIELDS.items() if name in known and field not in _PARTS), None)


def stated_in(cells: Iterable[tuple[str, str]]) -> dict[str, Field]:
    """The words under heads, or after words and a colon, that say who a student is, by its kind: the id first, and a
    name in two parts as one."""
    known = [(text.strip()[:200], field) for head, text in cells if text.strip() and (field := field_of(head))]
    parts = " ".join(text for text, field in known if field in _PARTS)
    whole = [cell for cell in (*known, (parts, "name")) if cell[0] and cell[1] not in _PARTS]
    return dict(sorted(whole, key=lambda cell: [*_HEADS].index(cell[1])))


_PARTS = ("given", "family")  # of a name


class Roster:
    """The students of a class by all they are called."""

    def __init__(self, students: Iterable[Student]) -> None:
        self.students = {student.id: student for student in students}
        self._ids, self._numbers, self._names = (dict[str, set[str]]() for _ in range(3))
        for student in self.students.values():
            for text, field in _called(student).items():
                if field == "number" or _number(text) != folded(text):
                    self._numbers.setdefault(_number(text), set()).add(student.id)
                if field == "name":
                    for name in _orders(_PIECE.findall(folded(text))):
                        self._names.setdefault(name, set()).add(student.id)
                elif field != "number":
                    self._ids.setdefault(folded(text), set()).add(student.id)
        self.named = lru_cache(maxsize=4096)(self._named)

    def __reduce__(self) -> tuple[Callable[..., Roster], tuple[object, ...]]:
        return Roster, (tuple(self.students.values()),)

    def joined(self, others: Iterable[Student]) -> Roster:
        """With what another list says of the same students, under the ids that they have here; and with its others."""
        own, new = dict(self.students), list[Student]()
        for other in others:
            ids = (text for text, field in _called(other).items() if field in ("id", "login", "email"))
            same = self.numbered(other.id).union(*(self._ids.get(folded(text), ()) for text in ids))
            if len(same) == 1:
                id = min(same)
                own[id] = Student(id, (*own[id].names, ("id", other.id), *other.names))
            else:
                new.append(other)
        return Roster([*own.values(), *new])

    @cached_property
    def called(self) -> dict[str, str]:
        """The students by id with their names, as far as the list has them."""
        each = ((id, _called(student).items()) for id, student in self.students.items())
        return {id: next((text for text, field in texts if field == "name"), "") for id, texts in each}

    def numbered(self, text: str) -> frozenset[str]:
        """Those whom a platform gives this number: `4460`, `Participant 4460`."""
        own = self._ids.get(folded(text), ()) if len(text) >= _OF_A_SCHOOL else ()
        return frozenset(self._numbers.get(_number(text), own))

    def _named(self, text: str) -> tuple[frozenset[str], ...]:
        """The students that a text names: of each id and each name in it the students who have it. A name is all
        that stands there between ids, numbers and words that are in many files' names: 李明华 is not 李明."""
        whole = folded(text[:_MOST])
        if text in self.students or whole in self._ids:
            return (frozenset({text} if text in self.students else self._ids[whole]),)
        pieces = [*islice(_PIECE.finditer(_WORDS.sub(lambda word: " " * len(word[0]), whole)), _PIECES)]
        called, runs, k = list[frozenset[str]](), [list[re.Match[str]]()], 0
        while k < len(pieces):
            count, some = self._id_at(whole, pieces[k : k + _RUN])
            called += [some] if some else []
            if some or _DIGIT.search(pieces[k].group()):
                runs.append([])
            else:
                runs[-1].append(pieces[k])
            k += count
        for run in runs:
            some = self._by_name([piece.group() for piece in run], alone=len(run) == len(pieces))
            called += [some] if some else self._of_parts(whole, run)
        return tuple(called)

    def _id_at(self, whole: str, pieces: Sequence[re.Match[str]]) -> tuple[int, frozenset[str]]:
        """Those whose id the first of some pieces of a text are, the most that are one, and how many these are."""
        for count in range(len(pieces), 0, -1):
            text = whole[pieces[0].start() : pieces[count - 1].end()]
            if text in self._ids and len(text) >= (_DECIMALS if text.isdecimal() else 2):
                return count, frozenset(self._ids[text])
        return 1, frozenset()

    def _of_parts(self, whole: str, run: Sequence[re.Match[str]]) -> Iterator[frozenset[str]]:
        """Those who are named by what stands between hyphens and the like, or in letters of one kind."""
        parts: list[list[str]] = []
        for before, piece in zip((None, *run), run):
            one = before is not None and (before.group() + piece.group()).isascii()
            if before is None or not one or _HARD.search(whole[before.end() : piece.start()]):
                parts.append([])
            parts[-1].append(piece.group())
        return filter(None, map(self._by_name, parts))

    def _by_name(self, words: Sequence[str], alone: bool = False) -> frozenset[str]:
        """Those of a name; one word in Latin letters may be any word, where it does not stand `alone`."""
        telling = alone or len(words) > 1 or not "".join(words).isascii()
        return frozenset().union(*(self._names.get(name, ()) for name in _orders(words[:_RUN]) if telling))

    def whose(self, by: Owner, files: Sequence[str], lines: Sequence[str], where: Where) -> str:
        """The id of the one student whose this is: by a folder, then by what files are called, then by lines inside.

        Raises UnknownStudent, TwoNames, SameName."""
        may, first = frozenset[str](), ""
        ranks = [(by.number, (self.numbered(by.number),)), *((text, self.named(text)) for text in (by.folder, *files))]
        # of a list without a platform's numbers, or names in its letters, its folders tell nothing
        telling = self._numbers or any(name.isascii() == folded(by.folder).isascii() for name in self._names)
        if by.number and telling and not any(some for _, each in ranks[:2] for some in each):
            raise UnknownStudent(where, by.folder or by.number, self.nearest(by.folder))
        for text, each in (*ranks, *((text, self.named(text)) for text in lines)):
            for some in filter(None, each):
                if may and not may & some:
                    known = len(may) == 1 and tidy_id(text) != first
                    raise TwoNames(where, min(may) if known else first, ", ".join(map(self.label, sorted(some))))
                may, first = (may & some, first) if may else (some, tidy_id(text))
        if len(may) == 1:
            return min(may)
        if may:
            raise SameName(where, first, tuple(map(self.label, sorted(may))))
        called = next((text for text in (*lines, by.folder, *files, by.student) if text.strip()), "")
        raise UnknownStudent(where, tidy_id(called), self.nearest(called))

    def label(self, id: str) -> str:
        """The id, and the name where it is known."""
        return " ".join(filter(None, (id, self.called[id])))

    def nearest(self, text: str) -> tuple[str, ...]:
        """Those who are called nearly so."""
        tables = (self._names, self._ids) if len(self.students) <= _LARGE else ()
        every = {text: min(ids) for table in tables for text, ids in table.items()}
        words = _PIECE.findall(folded(text))
        near = [one for word in dict.fromkeys(("".join(words), *words))
                for one in difflib.get_close_matches(word, every, 3, 0.6)]  # fmt: skip
        return tuple(dict.fromkeys(self.label(every[one]) for one in near))[:3]


def _called(student: Student) -> dict[str, Field]:
    """All that a student is called, by its kind; the id of a list that has nothing else may be a name."""
    called, id = stated_in((("id", student.id), *student.names)), student.id
    own: Field = "id" if "name" in called.values() or (id.isascii() and " " not in id) else "name"
    return called if own == "id" or _DIGIT.search(id) else {**called, id: own}


def _number(text: str) -> str:
    """Of `Participant 4460` the number; any other text as it is."""
    return _NUMBER.sub(r"\1", folded(text))


def _orders(words: Sequence[str]) -> list[str]:
    """Words of a name as one, the given name first or the family's."""
    return ["".join((*words[k:], *words[:k])) for k in range(len(words))]


# --- folders of platforms, names of files -----------------------------------------------------------------------------

MOODLE = re.compile(r"(?P<name>[^/]{0,200}?)_(?P<id>[0-9]{1,18})_assignsubmission_[a-z]+(?:_|/|$)")
CANVAS = re.compile(r"(?P<name>[^/]{1,200}?)(?:_LATE)?_(?P<id>[0-9]{1,18})_(?P<sub>[0-9]{1,18})_(?P<file>[^/]*)$")


@frozen
class Owner:
    """The one who handed in, as far as a place in an archive or a folder says: `student` where there is no class list;
    what a platform or a `folder` calls them, and the platform's `number`. By `group` the files of one hand-in are
    known, `by_file` where it is the student whom the file's own name names."""

    student: str
    group: str
    folder: str = ""
    number: str = ""
    by_file: bool = False


def owner(path: str, root: str = "", alone: bool = False, roster: Roster | None = None) -> Owner:
    """Of a file or of a member of an archive; `root` is the folder that all members share.

    alone  a folder is no student's: each name in it is one
    """
    inner = path.removeprefix(root)
    if (moodle := MOODLE.search(inner)) is not None:
        return Owner(tidy_id(moodle["id"]), inner[: moodle.end()], tidy_id(moodle["name"]), tidy_id(moodle["id"]))
    whole = PurePosixPath(inner)
    if (canvas := CANVAS.search(inner)) is not None:
        number = tidy_id(canvas["id"])
        return Owner(number, inner[: canvas.start("sub")], tidy_id(canvas["name"]), number)
    for k, part in enumerate(whole.parts[:-1] if roster is not None else ()):
        if roster is not None and roster.named(part):
            return Owner(tidy_id(part), "/".join(whole.parts[: k + 1]), part)
    stem = position_of(whole.stem)[0].rstrip() if whole.suffix.lower() in DRAWINGS else whole.stem
    if roster is not None and len(some := roster.named(stem)) and len(one := some[0].intersection(*some)) == 1:
        return Owner(tidy_id(stem), min(one), by_file=True)
    if alone or "/" not in inner:
        return Owner(tidy_id(stem), str(whole.parent / (stem or whole.stem)))
    return Owner(tidy_id(whole.parent.name), str(whole.parent), whole.parent.name)


def file_text(path: str, by: Owner) -> str:
    """The name of a file, without what a platform puts before it."""
    name = path.rpartition("/")[2]
    for pattern in (MOODLE, CANVAS) if by.number else ():
        if (match := pattern.search(name)) is not None:
            name = match.groupdict().get("file") or name[match.end() :]
    return position_of(PurePosixPath(name).stem)[0]


_SUBMISSION = re.compile(r"^(\S[^:\n]*):\s*$", re.M)
_SUBMITTER = re.compile(r"^\s*(?:- )?:(?:name|sid|email):[ \t]*(.*)$", re.M)
GRADESCOPE = "submission_metadata.yml"


def submitters(text: str) -> dict[str, Owner]:
    """Of Gradescope's export: by folder (or file) of each submission those who handed it in."""
    whose: dict[str, Owner] = {}
    begins = [*_SUBMISSION.finditer(text)]
    for match, end in zip(begins, [*(each.start() for each in begins[1:]), len(text)]):
        cells = [cell.strip(" '\"\r") for cell in _SUBMITTER.findall(text, match.end(), end)]
        if names := [*filter(None, cells)]:
            whose[match[1]] = Owner(tidy_id(names[min(1, len(names) - 1)]), match[1], "; ".join(names), names[0])
    return whose
