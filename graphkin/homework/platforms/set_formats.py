"""The formats of problem sets by name, and their files: each beside, then renamed."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework.platforms import csv_set, moodle_set, qti, xuexitong
from graphkin.homework.platforms.alternatives import refuse
from graphkin.homework.platforms.archive import ZIP_MARKS, pack
from graphkin.homework.platforms.cells import write_lines
from graphkin.homework.platforms.question import ProblemSet
from graphkin.outputs.files import beside
from graphkin.say.catalogue import LANGUAGES

Writer = Callable[[Path, ProblemSet, Lang], None]


@frozen
class SetFormat:
    """How a set is written: the file's suffix, and what writes it; by `marks` graphkin knows a file of its own."""

    suffix: str
    write: Writer
    marks: tuple[bytes, ...]


def _packed(members: Callable[[ProblemSet, Lang], Iterator[tuple[str, bytes]]]) -> Writer:
    return lambda path, problems, lang: pack(path, members(problems, lang))


def _whole(made: Callable[[ProblemSet, Lang], bytes]) -> Writer:
    def write(path: Path, problems: ProblemSet, lang: Lang) -> None:
        path.write_bytes(made(problems, lang))

    return write


SETS: Mapping[str, SetFormat] = {
    "moodle": SetFormat(".xml", _whole(moodle_set.cloze), (b"$course$/graphkin/",)),
    "moodle-numerical": SetFormat(".xml", _whole(moodle_set.numerical), (b"$course$/graphkin/",)),
    "qti": SetFormat(".zip", _packed(qti.members), ZIP_MARKS),
    "csv": SetFormat(
        ".csv", lambda path, problems, lang: write_lines(path, csv_set.lines(problems, lang)),
        tuple(csv_set.head(lang).encode() for lang in LANGUAGES),
    ),
    "xuexitong": SetFormat(".docx", _packed(xuexitong.members), ZIP_MARKS),
}  # fmt: skip
"""By name, as `graphkin problems --format` has them."""


def write_set(path: Path, problems: ProblemSet, kind: str, lang: Lang = "en", force: bool = False) -> None:
    """A set into a file. Raises NoRightNumber, NotForPlatform, FileInTheWay, NoFolder, CannotWrite."""
    for question in problems.questions:
        for part in question.parts:
            refuse(question, part)
    how = SETS[kind]
    with beside(path, force, how.marks) as draft:
        how.write(draft, problems, lang)
