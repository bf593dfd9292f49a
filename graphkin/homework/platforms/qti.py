"""A problem set as QTI 1.2 in a zip, as Canvas takes it in; PrairieLearn and Brightspace read the same.

An assessment a student, a `numerical_question` a number. Canvas gives all points for any answer that an item lists, so
only right numbers are listed: no halves, no mistakes. It rounds answers below 0.0001 to 0.
"""

from __future__ import annotations

import hashlib
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from decimal import Decimal

from graphkin.errors import Lang, NotForPlatform
from graphkin.homework.platforms.markup import element, in_html, one_line, xml
from graphkin.homework.platforms.question import Part, ProblemSet, Question, alternatives, most
from graphkin.homework.platforms.tables import exponentless, points, printed
from graphkin.say.catalogue import say

SMALLEST = Decimal("0.0001")
_PACKAGE = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1"
_ITEMS = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
_CANVAS = "http://canvas.instructure.com/xsd/cccv1p0"
_META = "associatedcontent/imscc_xmlv1p1/learning-application-resource"


def members(problems: ProblemSet, lang: Lang) -> Iterator[tuple[str, bytes]]:
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
