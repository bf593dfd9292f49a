"""The formats of problem sets by name, and their files: each beside, then renamed.

Moodle XML, with the mistakes as alternatives, so that Moodle names them by itself. `cloze`: a question a student, all
numbers in it; its weights are whole, so points are multiplied until they are. `numerical`: a question a number. Rules:
Moodle's qtype_multianswer and qtype_numerical; feedback in braces is decoded once from HTML, then `\\}` and `\\#` are
undone; `~` has no such escape and is written as an entity. The figure is a file of each question.

QTI 1.2 in a zip, as Canvas and Brightspace take it in: one bank of questions (`objectbank`) with all students, a
`numerical_question` a number, figures beside it. Canvas gives all points for any answer that an item lists, so only
right numbers are listed: no halves, no mistakes. It rounds answers below 0.0001 to 0.

As a table there is a row an answer, with its share of the points and what is said to it.
"""

from __future__ import annotations

import base64
import hashlib
import html
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from math import gcd
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import Lang, NotForPlatform
from graphkin.homework.platforms.markup import ZIP_MARKS, broken, element, in_html, one_line, write_file, xml
from graphkin.homework.platforms.question import Part, ProblemSet, Question, alternatives, refuse, sentence
from graphkin.homework.platforms.tables import BOM, exponentless, line, points, printed
from graphkin.homework.platforms.xuexitong import excel_files, word_files
from graphkin.outputs.letters import lettered
from graphkin.outputs.typesetting import html_words
from graphkin.say.catalogue import LANGUAGES, say

_FIGURE = "figure.svg"
_BRACES = str.maketrans({"{": "&#123;", "}": "&#125;"})
_SIGNS = str.maketrans({"#": "\\#", "}": "\\}", "~": "&#126;", "\\": "&#92;", "{": "&#123;"})
"""Signs of cloze in a feedback; made after HTML has its entities, whose `#` is escaped with the others."""


def cloze(problems: ProblemSet, lang: Lang) -> bytes:
    """One `cloze` question for each student."""
    return _quiz(problems, [_cloze(problems, question, lang) for question in problems.questions])


def numerical(problems: ProblemSet, lang: Lang) -> bytes:
    """One `numerical` question for each number of each student."""
    return _quiz(problems, [_numerical(problems, one, part, lang) for one in problems.questions for part in one.parts])


def weights(parts: Sequence[Part]) -> tuple[int, ...]:
    """Points as the smallest whole numbers in the same ratio that are not below them."""
    hundredths = [int(points(part.points) * 100) for part in parts]
    whole = gcd(100, *hundredths)
    return tuple(each // whole for each in hundredths)


def _quiz(problems: ProblemSet, questions: Sequence[ET.Element]) -> bytes:
    folder = "$course$/graphkin/" + one_line(problems.name).replace("/", "//")
    category = element("question", element("category", element("text", folder)), type="category")
    return xml(element("quiz", category, *questions))


def _question(kind: str, name: str, question: Question, text: str) -> ET.Element:
    body = element("questiontext", element("text", text), format="html")
    if question.figure:
        data = base64.b64encode(question.figure).decode()
        body.append(element("file", data, name=_FIGURE, path="/", encoding="base64"))
    return element("question", element("name", element("text", one_line(name))), body, type=kind)


def _words(text: str, points: Sequence[str]) -> str:
    """Lines whose quantities, and points of the mechanism, are set as the sheets set them."""
    return "<br>".join(html_words(lettered(line, points)) for line in broken(text))


def _posed(question: Question, lang: Lang, figure: str) -> str:
    """The text with its figure; figure: the file as the platform finds it."""
    shows = html.escape(one_line(question.shows))
    picture = f'<p><img src="{figure}" alt="{shows}"></p>' if question.figure else ""
    return f"<p>{_words(question.text[lang], question.points)}</p>{picture}"


def _cloze(problems: ProblemSet, question: Question, lang: Lang) -> ET.Element:
    lines = [_posed(question, lang, f"@@PLUGINFILE@@/{_FIGURE}").translate(_BRACES)]  # no brace of it opens a field
    for part, weight in zip(question.parts, weights(question.parts), strict=True):
        fields = []  # `%50%-1.25:0.0625#Close`
        for one in alternatives(question, part):
            share = "=" if one.percent == 100 else f"%{one.percent}%"
            said = html.escape(in_html(one_line(sentence(one, lang))), quote=False).translate(_SIGNS)
            fields.append(f"{share}{printed(one.number)}:{printed(one.tolerance)}#{said}")
        answers = "~".join(fields)
        lines.append(f"<p>{_words(part.heading, ()).translate(_BRACES)} = {{{weight}:NUMERICAL:{answers}}}</p>")
    name = say("platforms.problem title", lang, set=problems.name, id=question.id)
    return _question("cloze", name, question, "\n".join(lines))


def _numerical(problems: ProblemSet, question: Question, part: Part, lang: Lang) -> ET.Element:
    title = say("platforms.problem title", lang, set=problems.name, id=question.id)
    text = f"{_posed(question, lang, f'@@PLUGINFILE@@/{_FIGURE}')}\n<p>{_words(part.heading, ())} = ?</p>"
    whole = _question("numerical", f"{title}, {part.shown}", question, text)
    whole.append(element("defaultgrade", exponentless(points(part.points))))
    for one in alternatives(question, part):
        said = in_html(one_line(sentence(one, lang)))
        whole.append(element(
            "answer", element("text", printed(one.number)), element("tolerance", printed(one.tolerance)),
            element("feedback", element("text", said), format="html"),
            fraction=str(one.percent), format="moodle_auto_format",
        ))  # fmt: skip
    whole.extend((element("unitgradingtype", "0"), element("unitpenalty", "0"), element("showunits", "3")))
    return whole


# --- QTI --------------------------------------------------------------------------------------------------------------

SMALLEST = Decimal("0.0001")
_PACKAGE = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1"
_ITEMS = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"


def qti(problems: ProblemSet, lang: Lang) -> Iterator[tuple[str, bytes]]:
    """The files of the zip. Raises NotForPlatform where a right number would be rounded to 0."""
    names = ["g" + _digest(problems.name, question.id, "") for question in problems.questions]
    bank = "b" + _digest(problems.name, *names)
    figures = {f"images/{name}.svg": question.figure
               for name, question in zip(names, problems.questions, strict=True) if question.figure}  # fmt: skip
    yield "imsmanifest.xml", xml(_manifest(bank, figures))
    items = [_item(name, problems, question, part, lang)
             for name, question in zip(names, problems.questions, strict=True) for part in question.parts]  # fmt: skip
    title = element("qtimetadata", _field("bank_title", one_line(problems.name)))
    yield f"{bank}/{bank}.xml", xml(element(
        "questestinterop", element("objectbank", title, *items, ident=bank), xmlns=_ITEMS,
    ))  # fmt: skip
    yield from figures.items()


def _digest(*texts: str) -> str:
    """Letters that XML and folders take, whatever the names are."""
    return hashlib.sha256("\0".join(texts).encode("utf-8", "surrogatepass")).hexdigest()[:31]


def _manifest(bank: str, figures: Iterable[str]) -> ET.Element:
    about = element("metadata", element("schema", "IMS Content"), element("schemaversion", "1.1.3"))
    resources = element("resources")
    kinds = {f"{bank}/{bank}.xml": (bank, "imsqti_xmlv1p2"), **dict.fromkeys(figures, ("", "webcontent"))}
    for href, (ident, kind) in kinds.items():
        one = element("resource", element("file", href=href), identifier=ident or f"f{_digest(href)}", type=kind)
        resources.append(one)
        one.attrib |= {} if ident else {"href": href}
    return element("manifest", about, element("organizations"), resources, identifier=f"m{bank}", xmlns=_PACKAGE)


def _field(label: str, entry: str) -> ET.Element:
    return element("qtimetadatafield", element("fieldlabel", label), element("fieldentry", entry))


def _item(name: str, problems: ProblemSet, question: Question, part: Part, lang: Lang) -> ET.Element:
    about = element("itemmetadata", element(
        "qtimetadata", _field("question_type", "numerical_question"),
        _field("points_possible", exponentless(points(part.points))),
    ))  # fmt: skip
    posed = _posed(question, lang, f"%24IMS-CC-FILEBASE%24/images/{name}.svg")
    text = f"<div>{posed}<p>{_words(part.heading, ())} = ?</p></div>"
    blank = element("render_fib", element("response_label", ident="answer1"), fibtype="Decimal")
    presentation = element(
        "presentation", element("material", element("mattext", text, texttype="text/html")),
        element("response_str", blank, ident="response1", rcardinality="Single"),
    )  # fmt: skip
    score = element("decvar", maxvalue="100", minvalue="0", varname="SCORE", vartype="Decimal")
    judged = element("resprocessing", element("outcomes", score))
    for one in alternatives(question, part):
        if one.percent == 100 and not one.ids:
            if 0 < abs(one.number) < SMALLEST:
                raise NotForPlatform("Canvas", question.id, part.name, printed(one.number))
            low, high = one.number - one.tolerance, one.number + one.tolerance
            bounds = {"vargte": low, "varlte": high, "varequal": one.number}
            least, largest, right = (element(k, exponentless(n), respident="response1") for k, n in bounds.items())
            either = element("or", right, element("and", least, largest))
            full = element("setvar", "100", action="Set", varname="SCORE")
            judged.append(element("respcondition", element("conditionvar", either), full, _continue="No"))
    ident = f"{name}q{question.parts.index(part) + 1}"
    title = say("platforms.problem title", lang, set=problems.name, id=question.id)
    return element("item", about, presentation, judged, ident=ident, title=one_line(f"{title}, {part.shown}"))


# --- tables; all formats --------------------------------------------------------------------------------------------

CSV_HEADERS = (
    "student", "text", "quantity", "unit", "points", "percent", "number", "tolerance", "mistakes", "sentence",
)  # fmt: skip


def csv_head(lang: Lang) -> str:
    """The names of the columns."""
    return BOM + line(say(f"platforms.column {name}", lang) for name in CSV_HEADERS)


def table(problems: ProblemSet, lang: Lang) -> bytes:
    """All answers to all numbers, a row each."""
    rows = (
        (question.id, question.text[lang], part.shown, part.unit, points(part.points), one.percent, one.number,
         one.tolerance, " ".join(one.ids), sentence(one, lang))
        for question in problems.questions for part in question.parts for one in alternatives(question, part)
    )  # fmt: skip
    return "".join((csv_head(lang), *map(line, rows))).encode()


@frozen
class SetFormat:
    """A file's suffix; what makes the whole of it, or the members of an archive; by `marks` graphkin knows its own."""

    suffix: str
    made: Callable[[ProblemSet, Lang], bytes | Iterator[tuple[str, bytes | Iterable[bytes]]]]
    marks: tuple[bytes, ...]


SETS: Mapping[str, SetFormat] = {
    "moodle": SetFormat(".xml", cloze, (b"$course$/graphkin/",)),
    "moodle-numerical": SetFormat(".xml", numerical, (b"$course$/graphkin/",)),
    "qti": SetFormat(".zip", qti, ZIP_MARKS),
    "csv": SetFormat(".csv", table, tuple(csv_head(lang).encode() for lang in LANGUAGES)),
    "xuexitong": SetFormat(".docx", word_files, ZIP_MARKS),
    "xuexitong-xlsx": SetFormat(".xlsx", excel_files, ZIP_MARKS),
}
"""By name, as `graphkin problems --format` has them."""


def write_set(path: Path, problems: ProblemSet, kind: str, lang: Lang = "en", force: bool = False) -> None:
    """A set into a file. Raises NoRightNumber, NotForPlatform, FileInTheWay, NoFolder, CannotWrite."""
    for question in problems.questions:
        for part in question.parts:
            refuse(question, part)
    write_file(path, SETS[kind].made(problems, lang), force, SETS[kind].marks)
