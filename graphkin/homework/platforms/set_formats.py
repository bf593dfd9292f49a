"""The formats of problem sets by name, and their files: each beside, then renamed.

Moodle XML, with the mistakes as alternatives, so that Moodle names them by itself. `cloze`: a question a student, all
numbers in it; its weights are whole, so points are multiplied until they are. `numerical`: a question a number. Rules:
Moodle's qtype_multianswer and qtype_numerical; feedback in braces is decoded once from HTML, then `\\}` and `\\#` are
undone; `~` has no such escape and is written as an entity.

QTI 1.2 in a zip, as Canvas takes it in; PrairieLearn and Brightspace read the same. An assessment a student, a
`numerical_question` a number. Canvas gives all points for any answer that an item lists, so only right numbers are
listed: no halves, no mistakes. It rounds answers below 0.0001 to 0.

As a table there is a row an answer, with its share of the points and what is said to it. As a Word file for 学习通
(Chaoxing) a question a number: `1.【填空题】题干`, then `答案：1.25`; the layout is that of an exporter, not an
official one, and has no tolerance: the text says how exact a number is to be.
"""

from __future__ import annotations

import hashlib
import html
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import ROUND_HALF_UP, Decimal
from math import gcd
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import Lang, NotForPlatform
from graphkin.homework.platforms.markup import ZIP_MARKS, element, in_html, office_package, one_line, pack, xml
from graphkin.homework.platforms.question import Part, ProblemSet, Question, alternatives, most, refuse, sentence
from graphkin.homework.platforms.tables import BOM, exponentless, line, points, printed, write_lines
from graphkin.outputs.files import beside
from graphkin.say.catalogue import LANGUAGES, say

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


def _question(kind: str, name: str, text: str) -> ET.Element:
    return element(
        "question", element("name", element("text", one_line(name))),
        element("questiontext", element("text", text), format="html"), type=kind,
    )  # fmt: skip


def _cloze(problems: ProblemSet, question: Question, lang: Lang) -> ET.Element:
    lines = [f"<p>{in_html(question.text[lang]).translate(_BRACES)}</p>"]  # no brace of the text opens a field
    for part, weight in zip(question.parts, weights(question.parts), strict=True):
        fields = []  # `%50%-1.25:0.0625#Close`
        for one in alternatives(question, part):
            share = "=" if one.percent == 100 else f"%{one.percent}%"
            said = html.escape(in_html(one_line(sentence(one, lang))), quote=False).translate(_SIGNS)
            fields.append(f"{share}{printed(one.number)}:{printed(one.tolerance)}#{said}")
        answers = "~".join(fields)
        lines.append(f"<p>{in_html(part.heading).translate(_BRACES)} = {{{weight}:NUMERICAL:{answers}}}</p>")
    name = say("platforms.problem title", lang, set=problems.name, id=question.id)
    return _question("cloze", name, "\n".join(lines))


def _numerical(problems: ProblemSet, question: Question, part: Part, lang: Lang) -> ET.Element:
    title = say("platforms.problem title", lang, set=problems.name, id=question.id)
    text = f"<p>{in_html(question.text[lang])}</p>\n<p>{in_html(part.heading)} = ?</p>"
    whole = _question("numerical", f"{title}, {part.name}", text)
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
_CANVAS = "http://canvas.instructure.com/xsd/cccv1p0"
_META = "associatedcontent/imscc_xmlv1p1/learning-application-resource"


def qti(problems: ProblemSet, lang: Lang) -> Iterator[tuple[str, bytes]]:
    """The files of the zip. Raises NotForPlatform where a right number would be rounded to 0."""
    names = ["g" + _digest(problems.name, question.id, "") for question in problems.questions]
    yield "imsmanifest.xml", xml(_manifest(problems, names))
    for name, question in zip(names, problems.questions, strict=True):
        title = one_line(say("platforms.problem title", lang, set=problems.name, id=question.id))
        limits = element("qtimetadata", _field("cc_maxattempts", "1"))
        items = [_item(name, question, part, lang) for part in question.parts]
        section = element("section", *items, ident="root_section")
        assessment = element("assessment", limits, section, ident=name, title=title)
        yield f"{name}/{name}.xml", xml(element("questestinterop", assessment, xmlns=_ITEMS))
        yield f"{name}/assessment_meta.xml", xml(element(
            "quiz", element("title", title), element("description"), element("quiz_type", "assignment"),
            element("points_possible", exponentless(most(question))), element("allowed_attempts", "1"),
            identifier=name, xmlns=_CANVAS,
        ))  # fmt: skip


def _digest(*texts: str) -> str:
    """Letters that XML and folders take, whatever the names are."""
    return hashlib.sha256("\0".join(texts).encode("utf-8", "surrogatepass")).hexdigest()[:31]


def _manifest(problems: ProblemSet, names: list[str]) -> ET.Element:
    about = element("metadata", element("schema", "IMS Content"), element("schemaversion", "1.1.3"))
    resources = element("resources")
    for name in names:
        resources.append(element(
            "resource", element("file", href=f"{name}/{name}.xml"), element("dependency", identifierref=f"{name}m"),
            identifier=name, type="imsqti_xmlv1p2",
        ))  # fmt: skip
        meta = f"{name}/assessment_meta.xml"
        resources.append(element("resource", element("file", href=meta), identifier=f"{name}m", type=_META, href=meta))
    ident = f"m{_digest(problems.name, *names)}"
    return element("manifest", about, element("organizations"), resources, identifier=ident, xmlns=_PACKAGE)


def _field(label: str, entry: str) -> ET.Element:
    return element("qtimetadatafield", element("fieldlabel", label), element("fieldentry", entry))


def _item(name: str, question: Question, part: Part, lang: Lang) -> ET.Element:
    about = element("itemmetadata", element(
        "qtimetadata", _field("question_type", "numerical_question"),
        _field("points_possible", exponentless(points(part.points))),
    ))  # fmt: skip
    text = f"<div><p>{in_html(question.text[lang])}</p><p>{in_html(part.heading)} = ?</p></div>"
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
    return element("item", about, presentation, judged, ident=ident, title=one_line(part.name))


# --- tables and Word files; all formats -------------------------------------------------------------------------------

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
    "moodle": SetFormat(".xml", _whole(cloze), (b"$course$/graphkin/",)),
    "moodle-numerical": SetFormat(".xml", _whole(numerical), (b"$course$/graphkin/",)),
    "qti": SetFormat(".zip", _packed(qti), ZIP_MARKS),
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
