"""The formats of problem sets by name, and their files: each beside, then renamed.

Here are two of them. As a table there is a row an answer, with its share of the points and what is said to it. As a
Word file for 学习通 (Chaoxing) a question a number: `1.【填空题】题干`, then `答案：1.25`; the layout is that of an
exporter, not an official one, and has no tolerance: the text says how exact a number is to be.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework.platforms import moodle_set, qti
from graphkin.homework.platforms.markup import ZIP_MARKS, element, office_package, one_line, pack, xml
from graphkin.homework.platforms.question import ProblemSet, alternatives, refuse, sentence
from graphkin.homework.platforms.tables import BOM, exponentless, line, points, printed, write_lines
from graphkin.outputs.files import beside
from graphkin.say.catalogue import LANGUAGES, say

CSV_HEADERS = (
    "student", "text", "quantity", "unit", "points", "percent", "number", "tolerance", "mistakes", "sentence",
)  # fmt: skip
_WORD = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"
_MAIN = "application/vnd.openxmlformats-officedocument.wordprocessingml.document.main+xml"


def csv_head(lang: Lang) -> str:
    """The names of the columns."""
    return BOM + line(say(f"platforms.column {name}", lang) for name in CSV_HEADERS)


def csv_lines(problems: ProblemSet, lang: Lang) -> Iterator[str]:
    """The table, row by row."""
    yield csv_head(lang)
    for question in problems.questions:
        for part in question.parts:
            for one in alternatives(question, part):
                yield line((
                    question.id, question.text[lang], part.name, part.unit, points(part.points), one.percent,
                    one.number, one.tolerance, " ".join(one.ids), sentence(one, lang),
                ))  # fmt: skip


def word_files(problems: ProblemSet, lang: Lang) -> Iterator[tuple[str, bytes]]:
    """The files of the .docx."""
    yield from office_package([("/word/document.xml", _MAIN)], "word/document.xml")
    texts = (element("w:t", text, **{"xml:space": "preserve"}) for text in word_paragraphs(problems, lang))
    body = element("w:body", *(element("w:p", element("w:r", text)) for text in texts))
    yield "word/document.xml", xml(element("w:document", body, **{"xmlns:w": _WORD}))


def word_paragraphs(problems: ProblemSet, lang: Lang) -> Iterator[str]:
    """The lines of the file: a question, its answer, and so on."""
    number = 0
    for question in problems.questions:
        title = say("platforms.problem title", lang, set=problems.name, id=question.id)
        for part in question.parts:
            number += 1
            right = alternatives(question, part)[0]
            blank = f"{part.heading} = ____ (±{printed(right.tolerance)})"
            yield one_line(f"{number}.【填空题】{title}  {question.text[lang]} {blank}")
            answer = right.number
            if right.tolerance:  # to a tenth of its tolerance, as one would write it
                answer = answer.quantize(Decimal(1).scaleb(right.tolerance.adjusted() - 1), ROUND_HALF_UP)
            yield f"答案：{exponentless(answer)}"


Writer = Callable[[Path, ProblemSet, Lang], None]


@frozen
class SetFormat:
    """The writer of a kind of set and the file's suffix; by `marks` graphkin knows a file of its own."""

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
        ".csv", lambda path, problems, lang: write_lines(path, csv_lines(problems, lang)),
        tuple(csv_head(lang).encode() for lang in LANGUAGES),
    ),
    "xuexitong": SetFormat(".docx", _packed(word_files), ZIP_MARKS),
}  # fmt: skip
"""By name, as `graphkin problems --format` has them."""


def write_set(path: Path, problems: ProblemSet, kind: str, lang: Lang = "en", force: bool = False) -> None:
    """A set into a file. Raises NoRightNumber, NotForPlatform, FileInTheWay, NoFolder, CannotWrite."""
    for question in problems.questions:
        for part in question.parts:
            refuse(question, part)
    with beside(path, force, SETS[kind].marks) as draft:
        SETS[kind].write(draft, problems, lang)
