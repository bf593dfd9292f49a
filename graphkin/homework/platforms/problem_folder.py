"""A problem set in graphkin's own folder: each student's mechanism, problem, figure and key, all or nothing a file; and
the mistakes that the set tells apart. The same set for a platform: each student's own key and statement.
"""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Iterable, Iterator
from pathlib import Path

from graphkin.api import plan
from graphkin.errors import CannotWrite, GraphkinError, Lang
from graphkin.homework.grading import SetMarker, key_for, set_text
from graphkin.homework.grading.keys import USUAL, Pencils
from graphkin.homework.grading.sets import KeySet
from graphkin.homework.platforms.question import ProblemSet, question_of
from graphkin.homework.platforms.set_formats import SETS
from graphkin.homework.problems import Template, Variant
from graphkin.homework.problems.posed import shown_at
from graphkin.marking.discriminability import SetDiscriminability, set_discriminability
from graphkin.marking.marker import Marker
from graphkin.marking.power import alarms
from graphkin.outputs.files import beside, refuse
from graphkin.outputs.key_json import key_text
from graphkin.outputs.study_json import told_data
from graphkin.outputs.svg import inline
from graphkin.running import replay_all
from graphkin.say.catalogue import LANGUAGES
from graphkin.say.problems import MADE, problem, statement
from graphkin.say.tolerances import discriminability_lines
from graphkin.sheet.single_figure import problem_sheet
from graphkin.submissions import safe_name

MARK = "graphkin problems"  # by which graphkin knows files of its own, which it writes anew
KEY = ".key.json"
FIGURE = ".svg"
TOLD = "set.mistakes.txt"
LIST = "set.json"  # no student's file has two dots in its name but a key
_TRIED = 3  # problems whose false alarms are counted
_MARKS = [MARK.encode(), b'"kind": "graphkin key']


def write_problems(
    folder: Path, template: Template, variants: tuple[Variant, ...], seed: str, lang: Lang, force: bool = False,
    pencils: Pencils = USUAL,
) -> Iterator[Path]:  # fmt: skip
    """Writes NAME.toml, .txt, .svg and .key.json for each student, then key.json, by which the whole set is marked,
    set.mistakes.txt, which mistakes its answers tell apart, and set.json; gives each path when it is whole.

    Raises FileInTheWay before anything is written, CannotWrite.
    """
    names = {variant.student.id: safe_name(variant.student.id) for variant in variants}  # alike on no disk
    paths = [folder / f"{name}{suffix}" for name in names.values() for suffix in (".toml", ".txt", FIGURE, KEY)]
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CannotWrite.by(folder, error) from None
    for path in (*paths, folder / "key.json", folder / TOLD, folder / LIST):
        refuse(path, force, _MARKS)
    rates: list[tuple[float, float]] = []
    for variant in variants:
        name = names[variant.student.id]
        for suffix, text in _handed_out(template, variant, name, lang).items():
            yield _write(folder / f"{name}{suffix}", text, force)
        key = key_for(variant.mechanism, pencils)
        if len(rates) < _TRIED:  # right work by pencil, what is asked handed in: parts judged wrong, and mistaken
            rates.append(alarms(Marker(key), [entry.text for entry in key.entries if entry.points]))
        yield _write(folder / f"{name}{KEY}", key_text(key), force)
    power = set_discriminability([variant.told for variant in variants], (pencils.length_mm, pencils.angle_deg), rates)
    yield _write(folder / TOLD, "\n".join((*discriminability_lines(power, lang), "", MADE, "")), force)
    yield _write(folder / "key.json", set_text({student: f"{name}{KEY}" for student, name in names.items()}), force)
    yield _write(folder / LIST, _listed(template, variants, names, seed, power), force)


class NotASet(GraphkinError):
    """A folder whose list of students is not one of graphkin's, or names a file that is not there."""

    path: str

    en = (
        "{path}: this is no list of a problem set that graphkin wrote. Write the set again with "
        "`graphkin problems`, or name the mechanism files."
    )
    zh = "{path}：这不是 graphkin 生成的题组清单。请用 `graphkin problems` 重新生成题组，或直接给出机构文件。"


def is_set(folder: Path) -> bool:
    """True where a problem set was written there."""
    return (folder / LIST).is_file()


def students_of(folder: Path) -> tuple[str, list[tuple[str, Path]]]:
    """The seed of a written set, and each student with the mechanism file, in the order of the list: the id, and what
    else the roster called the student. Raises NotASet."""
    listed = folder / LIST
    try:
        whole = json.loads(listed.read_text("utf-8"))
        seed, students = str(whole["seed"]), whole["students"].items()
        files = [(" ".join((id, *map(str, each["names"].values()))), str(each["file"])) for id, each in students]
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise NotASet(str(listed)) from None
    if any(Path(name).name != name or not (folder / name).is_file() for _, name in files):
        raise NotASet(str(listed))
    return seed, [(who, folder / name) for who, name in files]


_NAMES = ("姓名", "学生姓名", "full name", "name", "学生", "student")  # of a column of names, the most telling first


def class_names(judge: SetMarker) -> dict[str, str]:
    """The students of a class by id, with their names as far as its list has them; none where it has no list."""
    if not isinstance(judge, KeySet):
        return {}
    listed: dict[str, dict[str, str]] = {student: {} for student in judge.files}
    with contextlib.suppress(OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        students = json.loads((judge.path.parent / LIST).read_text("utf-8"))["students"]
        listed |= {id: {str(head).lower(): str(cell) for head, cell in students[id]["names"].items()} for id in listed}
    return {id: next((own[head] for head in _NAMES if own.get(head)), "") for id, own in listed.items()}


def told_of(folder: Path) -> str:
    """The mistakes that a written set tells apart, in the words of its folder."""
    return (folder / TOLD).read_text("utf-8").removesuffix(f"\n{MADE}\n").rstrip()


def problem_set(template: Template, variants: Iterable[Variant], judge: SetMarker) -> ProblemSet:
    """The questions of a platform to each student, by the keys of the set. Raises what reading a key raises."""
    questions = []
    for variant in variants:
        marker = judge.marker(variant.student.id)
        assert marker is not None, "the set has a key for each of its students"
        text = {lang: "\n".join(statement(variant.mechanism, lang, variant.drawn)) for lang in LANGUAGES}
        questions.append(question_of(variant.student.id, marker.key, text))
    return ProblemSet(template.name, questions)


def file_of(folder: Path, kind: str) -> Path:
    """The file of a set of problems: `set-moodle.xml`, `set-qti.zip`."""
    return folder / f"set-{kind}{SETS[kind].suffix}"


def _handed_out(template: Template, variant: Variant, name: str, lang: Lang) -> dict[str, str]:
    """The files that the student gets, by suffix: mechanism, problem and figure."""
    head = f"# {MARK}: {template.name}, {variant.student.id}\n"
    own, method = variant.student, plan(variant.mechanism)
    shown = shown_at(method, replay_all(method))  # the mechanism, with nothing in the figure that is asked for
    drawing = {}
    if shown is not None:
        begin = f'<?xml version="1.0" encoding="utf-8"?>\n<!-- {MARK} -->\n'
        drawing[FIGURE] = begin + inline(problem_sheet(method, shown[0], lang)) + "\n"
    figure = ("", True) if shown is None else (f"{name}{FIGURE}", shown[1])
    others = [text for _, text in own.names]
    text = problem(variant.mechanism, own.id, others, lang, variant.drawn, *figure)
    return {".toml": head + variant.mechanism.text, ".txt": text, **drawing}


def _write(path: Path, text: str, force: bool) -> Path:
    with beside(path, force, _MARKS) as draft, draft.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(text)
        stream.flush()
        with contextlib.suppress(OSError):
            os.fsync(stream.fileno())
    return path


def _listed(
    template: Template, variants: tuple[Variant, ...], names: dict[str, str], seed: str, told: SetDiscriminability
) -> str:
    """The list of the set: the numbers of each student."""
    students = {}
    for variant in variants:
        ranges = zip(template.ranges, variant.numbers, strict=True)
        values = {each.name: each.value(number).strip('"') for each, number in ranges}
        file, own = f"{names[variant.student.id]}.toml", dict(variant.student.names)
        students[variant.student.id] = {"file": file, "names": own, "values": values, "shared": variant.shared}
    whole: dict[str, object] = {"format": 1, "program": MARK, "template": template.name, "seed": seed}
    points = dict(variants[0].mechanism.worth) if variants else {}
    whole |= {"points": points, "told": told_data(told), "students": students}
    return json.dumps(whole, ensure_ascii=False, indent=1, allow_nan=False) + "\n"
