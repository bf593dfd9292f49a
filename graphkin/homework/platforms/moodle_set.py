"""A problem set as Moodle XML, with the mistakes as alternatives, so that Moodle names them by itself.

`cloze`: a question a student, all numbers in it; its weights are whole, so points are multiplied until they are.
`numerical`: a question a number. Rules: Moodle's qtype_multianswer and qtype_numerical; feedback in braces is decoded
once from HTML, then `\\}` and `\\#` are undone; `~` has no such escape and is written as an entity.
"""

from __future__ import annotations

import html
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from math import gcd

from graphkin.errors import Lang
from graphkin.homework.platforms.markup import element, in_html, one_line, xml
from graphkin.homework.platforms.question import Part, ProblemSet, Question, alternatives, sentence
from graphkin.homework.platforms.tables import exponentless, points, printed
from graphkin.say.catalogue import say

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
