"""A problem set as a Word file for 学习通 (Chaoxing): `1.【填空题】题干`, then `答案：1.25`; a question a number.

The layout is that of an exporter, not an official one. It has no tolerance: the text says how exact a number is to be.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from decimal import ROUND_HALF_UP, Decimal

from graphkin.errors import Lang
from graphkin.homework.platforms.alternatives import alternatives
from graphkin.homework.platforms.marked_up import element, one_line, xml
from graphkin.homework.platforms.numbers import exponentless, printed
from graphkin.homework.platforms.question import Part, ProblemSet, Question
from graphkin.say.catalogue import say

_WORD = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"
_TYPES = "http://schemas.openxmlformats.org/package/2006/content-types"
_LINKS = "http://schemas.openxmlformats.org/package/2006/relationships"
_MAIN = "application/vnd.openxmlformats-officedocument.wordprocessingml.document.main+xml"
_DOCUMENT = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument"


def members(problems: ProblemSet, lang: Lang) -> Iterator[tuple[str, bytes]]:
    """The files of the .docx."""
    kinds = (("rels", "application/vnd.openxmlformats-package.relationships+xml"), ("xml", "application/xml"))
    types = element("Types", *(element("Default", Extension=end, ContentType=kind) for end, kind in kinds),
                    element("Override", PartName="/word/document.xml", ContentType=_MAIN), xmlns=_TYPES)  # fmt: skip
    link = element("Relationship", Id="rId1", Type=_DOCUMENT, Target="word/document.xml")
    yield "[Content_Types].xml", xml(types)
    yield "_rels/.rels", xml(element("Relationships", link, xmlns=_LINKS))
    yield "word/document.xml", xml(_document(paragraphs(problems, lang)))


def paragraphs(problems: ProblemSet, lang: Lang) -> Iterator[str]:
    """The lines of the file: a question, its answer, and so on."""
    number = 0
    for question in problems.questions:
        title = say("platforms.problem title", lang, set=problems.name, id=question.id)
        for part in question.parts:
            number += 1
            asked = f"{part.heading} = ____ (±{_off(question, part)})"
            yield one_line(f"{number}.【填空题】{title}  {question.text[lang]} {asked}")
            yield f"答案：{_answer(question, part)}"


def _off(question: Question, part: Part) -> str:
    return printed(alternatives(question, part)[0].tolerance)


def _answer(question: Question, part: Part) -> str:
    """The right number to a tenth of its tolerance, as one would write it."""
    right = alternatives(question, part)[0]
    if not right.tolerance:
        return exponentless(right.number)
    step = Decimal(1).scaleb(right.tolerance.adjusted() - 1)
    return exponentless(right.number.quantize(step, ROUND_HALF_UP))


def _document(lines: Iterator[str]) -> ET.Element:
    body = element("w:body", *(_paragraph(line) for line in lines))
    return element("w:document", body, **{"xmlns:w": _WORD})


def _paragraph(line: str) -> ET.Element:
    return element("w:p", element("w:r", element("w:t", line, **{"xml:space": "preserve"})))
