"""Sets for 学习通 (Chaoxing), a question a number: a Word file with figures, or its table for Excel without.

In the Word file `1.【填空题】题干`, then `答案：1.25`, then what is allowed as its explanation, for that layout, an
exporter's and no official one, has no tolerance. In the table the answer to the one blank is also its first option.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Iterator
from decimal import ROUND_HALF_UP, Decimal

from graphkin.errors import Lang
from graphkin.homework.platforms.markup import OFFICE, element, office_link, office_package, one_line, xml
from graphkin.homework.platforms.question import Part, ProblemSet, Question, alternatives
from graphkin.homework.platforms.tables import exponentless, printed, workbook_files
from graphkin.outputs.letters import lettered
from graphkin.outputs.paged import raster
from graphkin.say.catalogue import say
from graphkin.sheet.lettering import Run

_WORD = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"
_DRAWN, _WORD_DPI = "http://schemas.openxmlformats.org/drawingml/2006", 150
_MAIN = "application/vnd.openxmlformats-officedocument.wordprocessingml.document.main+xml"
_HEADS = ("目录", "题目类型", "大题题干", "小题题型", "小题题干", "正确答案", "答案解析", "难易度", "知识点", "标签",
          "选项数", "选项A")  # fmt: skip


def word_files(problems: ProblemSet, lang: Lang) -> Iterator[tuple[str, bytes]]:
    """The files of the .docx."""
    yield from office_package([("/word/document.xml", _MAIN)], "word/document.xml")
    pictures = [question for question in problems.questions if question.figure]
    body = element("w:body")
    numbers = {question.id: number for number, question in enumerate(pictures, 1)}
    for text, of in word_paragraphs(problems, lang):
        paragraph = element("w:p", *map(_word_run, lettered(text, of.points if of is not None else ())))
        if of is not None and of.id in numbers:
            paragraph.append(_word_picture(of, numbers[of.id]))
        body.append(paragraph)
    spaces = {"xmlns:w": _WORD, "xmlns:r": OFFICE, "xmlns:wp": f"{_DRAWN}/wordprocessingDrawing",
              "xmlns:a": f"{_DRAWN}/main", "xmlns:pic": f"{_DRAWN}/picture"}  # fmt: skip
    yield "word/document.xml", xml(element("w:document", body, **spaces))
    if pictures:
        yield "word/_rels/document.xml.rels", office_link("image", *(f"media/{k}.png" for k in numbers.values()))
    for question in pictures:
        yield f"word/media/{numbers[question.id]}.png", raster(question.figure.decode(), _WORD_DPI)


def _word_run(run: Run) -> ET.Element:
    """Letters in one style."""
    style = element("w:rPr", *([element("w:i")] if run.italic else []))
    if run.place != "base":
        style.append(element("w:vertAlign", **{"w:val": "superscript" if run.place == "sup" else "subscript"}))
    return element("w:r", style, element("w:t", run.text, **{"xml:space": "preserve"}))


def _word_picture(question: Question, number: int) -> ET.Element:
    """The figure in true size, by the width and height that its file states."""
    stated = dict(re.findall(r' (width|height)="([0-9.]+)mm"', question.figure[:1000].decode()))
    size = {side: str(round(36000 * float(stated[name]))) for side, name in (("cx", "width"), ("cy", "height"))}
    name = {"id": str(number), "name": f"{number}.png"}
    picture = element(
        "pic:pic", element("pic:nvPicPr", element("pic:cNvPr", **name), element("pic:cNvPicPr")),
        element("pic:blipFill", element("a:blip", **{"r:embed": f"rId{number}"}),
                element("a:stretch", element("a:fillRect"))),
        element("pic:spPr", element("a:xfrm", element("a:off", x="0", y="0"), element("a:ext", **size)),
                element("a:prstGeom", element("a:avLst"), prst="rect")),
    )  # fmt: skip
    graphic = element("a:graphic", element("a:graphicData", picture, uri=f"{_DRAWN}/picture"))
    shown = element("wp:docPr", descr=one_line(question.shows), **name)
    return element("w:r", element("w:drawing", element("wp:inline", element("wp:extent", **size), shown, graphic)))


def word_paragraphs(problems: ProblemSet, lang: Lang) -> Iterator[tuple[str, Question | None]]:
    """The lines of the file: a question, with whose figure stands in it, its answer, and so on."""
    for number, (question, _, asked, answer, allowed) in enumerate(_blanks(problems, lang), 1):
        yield f"{number}.【填空题】{asked}", question
        yield f"答案：{answer}", None
        yield f"答案解析：{allowed}", None


def excel_files(problems: ProblemSet, lang: Lang) -> Iterator[tuple[str, bytes | Iterable[bytes]]]:
    """The files of the .xlsx."""
    folder = "/" + one_line(problems.name).replace("/", "-")
    rows = ((folder, "填空题", asked, "", "", answer, allowed, "中", part.shown, question.id, 1, answer)
            for question, part, asked, answer, allowed in _blanks(problems, lang))  # fmt: skip
    return workbook_files({"课程题库": (_HEADS, *rows)})


def _blanks(problems: ProblemSet, lang: Lang) -> Iterator[tuple[Question, Part, str, str, str]]:
    """Of each number that is asked for its text with a blank, its value as one would write it, and what is allowed."""
    for question in problems.questions:
        title = say("platforms.problem title", lang, set=problems.name, id=question.id)
        for part in question.parts:
            right = alternatives(question, part)[0]
            answer = right.number
            if right.tolerance:
                answer = answer.quantize(Decimal(1).scaleb(right.tolerance.adjusted() - 1), ROUND_HALF_UP)
            asked = one_line(f"{title}  {question.text[lang]} {part.heading} = ____")
            yield question, part, asked, exponentless(answer), f"±{printed(right.tolerance)}"
