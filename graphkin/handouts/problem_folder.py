"""A problem set in a folder, each file whole or not there. What is handed out, `students`: each student's
problem as a page, what to hand in, a workbook to fill in. What is not, `teacher`: mechanisms, keys, the set's list,
the mistakes that it tells apart. The same set for a platform: each student's own key and problem.
"""

from __future__ import annotations

import contextlib
import json
import os
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from functools import partial
from itertools import chain
from pathlib import Path

import graphkin
from graphkin.base.value import frozen
from graphkin.base.worklist import ahead
from graphkin.errors import CannotWrite, GraphkinError, Lang, NotASet
from graphkin.handouts.markup import html
from graphkin.handouts.problem import drawn_problem
from graphkin.handouts.stages import figure_of, handout, scales_to_use
from graphkin.handouts.worksheet import hand_in_page, workbook_rows
from graphkin.homework.grading import SetMarker, key_for, set_text
from graphkin.homework.grading.keys import USUAL, Pencils
from graphkin.homework.grading.sets import TEACHER
from graphkin.homework.platforms.markup import ZIP_MARKS, pack
from graphkin.homework.platforms.question import ProblemSet, question_of
from graphkin.homework.platforms.set_formats import SETS
from graphkin.homework.platforms.tables import workbook_files
from graphkin.homework.problems import Template, Variant, drawn_variants
from graphkin.marking.discriminability import SetDiscriminability, set_discriminability
from graphkin.marking.marker import Marker
from graphkin.marking.power import alarms
from graphkin.outputs.files import beside, refuse
from graphkin.outputs.key_json import key_text
from graphkin.outputs.study_json import told_data
from graphkin.outputs.svg import inline
from graphkin.outputs.typesetting import signs
from graphkin.say.catalogue import LANGUAGES, say
from graphkin.say.entry import text_lines
from graphkin.say.problems import MADE
from graphkin.say.tolerances import discriminability_lines
from graphkin.submissions import Student
from graphkin.submissions.submission import fingerprint, safe_name

STUDENTS = "students"
MARK = "graphkin problems"  # by which graphkin knows files of its own, which it writes anew
PAGE, MECHANISM, KEY, BOARD = ".html", ".toml", ".key.json", ".board.html"  # each student's
HAND_IN, WORKBOOK = "_hand-in.html", "_answers.xlsx"  # no student's file begins so
TOLD = "set.mistakes.txt"
LIST = "set.json"  # no student's file has two dots in its name but a key
_BEGUN = "set.begun.jsonl"  # a line a student whose files are whole; gone when all are
_AT_ONCE = 8  # students whose files are being written
_TRIED = 3  # problems whose false alarms are counted
_MARKS = [MARK.encode(), b'"kind": "graphkin key', b"graphkin handout", b"graphkin page", *ZIP_MARKS]


@frozen
class SetOrder:
    """A set that is to be written: everything that its files hang on."""

    folder: Path
    template: Template
    students: tuple[Student, ...]
    seed: str
    lang: Lang
    pencils: Pencils = USUAL
    force: bool = False

    @property
    def names(self) -> dict[str, str]:
        """Of each student's files, alike on no disk."""
        return {student.id: safe_name(student.id) for student in self.students}

    @property
    def head(self) -> str:
        """Of a list of what is done of it: a fingerprint of what the files hang on, and of who writes them."""
        ids = sorted(f"{student}" for student in self.students)
        pieces = (*self.template.pieces, *map(str, self.template.ranges))
        print = fingerprint(graphkin.__version__, self.seed, self.lang, str(self.pencils), *pieces, *ids)
        return f"{MARK} {print}"

    def files(self, name: str) -> list[Path]:
        """A student's."""
        teacher = self.folder / TEACHER
        return [self.folder / STUDENTS / f"{name}{PAGE}", teacher / f"{name}{MECHANISM}", teacher / f"{name}{KEY}"]

    def board(self, student: Student) -> Path:
        """The page with a student's drawing board, where the set has any."""
        return self.folder / STUDENTS / f"{self.names[student.id]}{BOARD}"


@frozen
class _Whole:
    """A student whose files are whole: the numbers of the problem, and its false alarms where they were counted."""

    student: str
    numbers: tuple[int, ...]
    rates: tuple[float, ...] = ()

    def line(self) -> str:
        return json.dumps([self.student, self.numbers, self.rates])


def write_problems(order: SetOrder, executor: Executor | None = None) -> Iterator[Variant | Path]:
    """Each student's problem when its files are whole; then what all have in common: what to hand in, key.json,
    by which the set is marked, set.mistakes.txt, which mistakes its answers tell apart, and set.json. At last each file
    that was taken away, of a student who is on the list no more.

    One that was broken off is gone on with. Raises FileInTheWay before anything is written, CannotWrite.
    """
    teacher = order.folder / TEACHER
    common = [order.folder / STUDENTS / name for name in (HAND_IN, WORKBOOK)]
    common += [teacher / name for name in ("key.json", TOLD, LIST, _BEGUN)]
    for path in (*(path for name in order.names.values() for path in order.files(name)), *common):
        if path.exists():
            refuse(path, order.force, _MARKS)
    listed, whole, variants = _names_in(order.folder), _begun(order), dict[str, Variant]()
    begun = teacher / _BEGUN
    with contextlib.ExitStack() as stack:
        journal = None
        for variant, one in _written(order, whole, executor):
            new, whole[one.student] = one.student not in whole, one
            if journal is None:  # nothing is there before the first problem is
                _write(begun, "\n".join([order.head, *map(_Whole.line, whole.values()), ""]), order.force)
                journal = stack.enter_context(begun.open("a", encoding="utf-8"))
            elif new:
                journal.write(one.line() + "\n")
                journal.flush()
            variants[one.student] = variant
            yield variant
    _write_common(order, [variants[student.id] for student in order.students], whole)
    begun.unlink(missing_ok=True)
    left = sorted(listed - {*order.names.values()})
    gone = [path for name in left for path in (*order.files(name), order.folder / STUDENTS / f"{name}{BOARD}")]
    for path in filter(_is_own, gone):
        path.unlink()
        yield path


def _names_in(folder: Path) -> set[str]:
    """The names of students' files that are known to be graphkin's: of a set that was written, or begun."""
    names = set[str]()
    if is_set(folder):
        with contextlib.suppress(NotASet):
            names |= {path.stem for _, path in students_of(folder)[1]}
    with contextlib.suppress(OSError, ValueError, TypeError, IndexError):
        for line in (folder / TEACHER / _BEGUN).read_text("utf-8").splitlines()[1:]:
            names.add(safe_name(json.loads(line)[0]))
    return names


def _is_own(path: Path) -> bool:
    """True of a file that graphkin wrote."""
    with contextlib.suppress(GraphkinError):
        refuse(path, False, _MARKS)
        return path.is_file()
    return False


def _begun(order: SetOrder) -> dict[str, _Whole]:
    """The students whose files are whole, where this very set was broken off."""
    whole: dict[str, _Whole] = {}
    with contextlib.suppress(OSError, ValueError):
        head, *lines = (order.folder / TEACHER / _BEGUN).read_text("utf-8").splitlines()
        for line in lines if head == order.head else ():
            with contextlib.suppress(ValueError, TypeError):  # the last may have been broken off
                student, numbers, rates = json.loads(line)
                name = order.names.get(student)
                if name is not None and all(file.is_file() for file in order.files(name)):
                    whole[student] = _Whole(student, tuple(numbers), tuple(rates))
    return whole


def _written(
    order: SetOrder, whole: Mapping[str, _Whole], executor: Executor | None
) -> Iterator[tuple[Variant, _Whole]]:
    """Each student's variant, its files written."""
    given_out = {id: one.numbers for id, one in whole.items()}
    drawn = drawn_variants(order.template, order.students, order.seed, order.pencils, given_out, executor)
    work, passed = partial(_files_of, order, dict(whole)), deque[Variant]()

    def batches() -> Iterator[list[Variant]]:
        for variant in drawn:
            passed.append(variant)
            yield [variant]

    here = chain.from_iterable(map(work, batches()))
    for one in here if executor is None else ahead(executor, work, batches(), _AT_ONCE):
        yield passed.popleft(), one


def _files_of(order: SetOrder, whole: Mapping[str, _Whole], variants: Sequence[Variant]) -> list[_Whole]:
    """The files of some students, but of those that have them; of the first few with their false alarms."""
    done = []
    counted = {student.id for student in order.students[:_TRIED]}
    for variant in variants:
        own, mechanism = variant.student, variant.mechanism
        if (before := whole.get(own.id)) is not None:
            done.append(before)
            continue
        key, rates = key_for(mechanism, order.pencils), tuple[float, ...]()
        if own.id in counted:  # right work by pencil, what is asked handed in: parts judged wrong, and mistaken
            rates = alarms(Marker(key), [entry.text for entry in key.entries if entry.points])
        page = html(handout([mechanism], "problem", order.lang, whose=[own]))
        text = f"# {MARK}: {order.template.name}, {own.id}\n{mechanism.text}"
        for path, content in zip(order.files(order.names[own.id]), (page, text, key_text(key)), strict=True):
            _write(path, content, order.force)
        done.append(_Whole(own.id, variant.numbers, rates))
    return done


def _write_common(order: SetOrder, variants: Sequence[Variant], whole: Mapping[str, _Whole]) -> None:
    """Write what the students have in common."""
    teacher, students = order.folder / TEACHER, order.folder / STUDENTS
    langs = (order.lang, *(lang for lang in LANGUAGES if lang != order.lang))
    problems = [drawn_problem(variants[0].mechanism, lang) for lang in langs]
    _write(students / HAND_IN, html(hand_in_page(problems, WORKBOOK)), order.force)
    with beside(students / WORKBOOK, order.force, _MARKS) as draft:
        pack(draft, workbook_files({problems[0].title[:30]: workbook_rows(problems[0])}))
    rates = [(one.rates[0], one.rates[1]) for one in whole.values() if one.rates]
    power = set_discriminability(
        [variant.told for variant in variants], (order.pencils.length_mm, order.pencils.angle_deg), rates
    )
    _write(teacher / TOLD, "\n".join((*discriminability_lines(power, order.lang), "", MADE, "")), order.force)
    keys = {student: f"{name}{KEY}" for student, name in order.names.items()}
    _write(teacher / "key.json", set_text(keys, order.students), order.force)
    _write(teacher / LIST, _listed(order, variants, power), order.force)


def is_set(folder: Path) -> bool:
    """True where a problem set was written there."""
    return set_list(folder).is_file()


def set_list(folder: Path) -> Path:
    """The list of a set: in its teacher's folder; beside the problems, where an older one has no such folder."""
    apart = folder / TEACHER / LIST
    return apart if apart.is_file() else folder / LIST


def students_of(folder: Path) -> tuple[str, list[tuple[Student, Path]]]:
    """The seed of a written set, and each student with the mechanism file, in the order of the list. Raises NotASet."""
    listed = set_list(folder)
    try:
        whole = json.loads(listed.read_text("utf-8"))
        seed, students = str(whole["seed"]), whole["students"].items()
        files = [(Student(id, tuple((head, str(text)) for head, text in each["names"].items())), str(each["file"]))
                 for id, each in students]  # fmt: skip
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise NotASet(str(listed)) from None
    if any(Path(name).name != name or not listed.with_name(name).is_file() for _, name in files):
        raise NotASet(str(listed))
    return seed, [(who, listed.with_name(name)) for who, name in files]


def told_of(folder: Path) -> str:
    """The mistakes that a written set tells apart, in the words of its folder."""
    return set_list(folder).with_name(TOLD).read_text("utf-8").removesuffix(f"\n{MADE}\n").rstrip()


def problem_set(template: Template, variants: Iterable[Variant], judge: SetMarker, lang: Lang) -> ProblemSet:
    """The questions of a platform to each student, by the keys of the set. Raises what reading a key raises."""
    questions = []
    for variant in variants:
        marker = judge.marker(variant.student.id)
        assert marker is not None, "the set has a key for each of its students"
        problem = drawn_problem(variant.mechanism, lang, variant.student.called)
        picture = figure_of(problem)
        lines = [line.strip() for line in text_lines(problem.posed, lang)]
        lines += (picture.note,)
        scales = "".join(sign.plain for sign in signs(scales_to_use(problem)))
        lines += (scales, say("platforms.answers", lang))
        text, figure = "\n".join(filter(None, lines)), inline(picture.sheet).encode()
        shown = (figure, picture.words, problem.points)
        questions.append(question_of(variant.student.id, marker.key, {lang: text}, *shown))
    return ProblemSet(template.name, questions)


def file_of(folder: Path, kind: str) -> Path:
    """The file of a set of problems, which has the answers in it: `teacher/set-moodle.xml`, `teacher/set-qti.zip`."""
    return folder / TEACHER / f"set-{kind}{SETS[kind].suffix}"


def _write(path: Path, text: str, force: bool) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CannotWrite.by(path.parent, error) from None
    with beside(path, force, _MARKS) as draft, draft.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(text)
        stream.flush()
        with contextlib.suppress(OSError):
            os.fsync(stream.fileno())


def _listed(order: SetOrder, variants: Sequence[Variant], told: SetDiscriminability) -> str:
    """The list of the set: the numbers of each student."""
    students = {}
    for variant in variants:
        ranges = zip(order.template.ranges, variant.numbers, strict=True)
        values = {each.name: each.value(number).strip('"') for each, number in ranges}
        file, own = f"{order.names[variant.student.id]}{MECHANISM}", dict(variant.student.names)
        students[variant.student.id] = {"file": file, "names": own, "values": values, "shared": variant.shared}
    whole: dict[str, object] = {"format": 1, "program": MARK, "template": order.template.name, "seed": order.seed}
    whole |= {"points": dict(variants[0].mechanism.worth), "told": told_data(told), "students": students}
    return json.dumps(whole, ensure_ascii=False, indent=1, allow_nan=False) + "\n"
