"""Results as learning platforms read them back: Moodle, Canvas, Gradescope, PrairieLearn.

Who a file is from stands in the name that Moodle or Canvas gave it in a download; the same name takes feedback back.
Moodle: `First Last_123_assignsubmission_file_/a.svg`, or all in one name. Canvas: `lastfirst_3143_207797_a.svg`: of the
pieces between underscores, the first two that are numbers are the student and the file.
"""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from typing import TypeVar

from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework.platforms import feedback
from graphkin.homework.platforms.feedback import Reveal
from graphkin.homework.platforms.markup import clean, in_html, inside
from graphkin.homework.platforms.result import FORMAT, Result, ResultPicture, most_of, points_of
from graphkin.homework.platforms.tables import line
from graphkin.marking.records import Judged
from graphkin.say.catalogue import say
from graphkin.submissions.students import CANVAS, MOODLE

_ARCHIVE = re.compile(r"^.*?\.zip!", re.S | re.I)  # before the name of a member of an archive: `class.zip!name`
HEADERS = (
    "Identifier", "Full name", "Status", "Grade", "Maximum grade", "Last modified (grade)", "Feedback comments",
)  # fmt: skip
"""Of the worksheet, as an English Moodle reads them."""
_CANVAS_FRONT = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")
LARGEST = 1_000_000  # bytes of PrairieLearn's file at most
_SHORTER = (20_000, 2_000, 200, 20)
T = TypeVar("T")


@frozen
class Named:
    """A name of a platform.

    name  as it goes back
    id    of the participant or the user; `who`: as far as the platform's name says
    """

    name: str
    id: str
    who: str


NamedResult = tuple[Named, Result]


def moodle(file: str) -> Named | None:
    """The member of a Moodle download, feedback as HTML beside it; None where it is not named so."""
    inner = _ARCHIVE.sub("", file, count=1)
    if (match := MOODLE.search(inner)) is None:
        return None
    folder, slash, last = inner[match.start() :].rpartition("/")
    name = f"{folder}{slash}{last.rpartition('.')[0] or last}.html"
    return Named(name, match["id"], match["name"]) if inside(name) else None


def canvas(file: str) -> Named | None:
    """The member of a Canvas download; None where it is not named so."""
    name = _ARCHIVE.sub("", file, count=1).rpartition("/")[2]
    match = CANVAS.fullmatch(name)
    return None if match is None or not inside(name) else Named(name, match["id"], match["name"])


# --- Moodle and Canvas: a table of grades, and a zip of feedback under the names of the download ----------------------


def moodle_grades(named: Sequence[NamedResult], lang: Lang, reveal: Reveal) -> Iterator[str]:
    """The grading worksheet, row by row, without files that Moodle has not named; an empty grade stays as it is."""
    yield line(HEADERS)
    for name, result in named:
        comment = "<br>".join(in_html(text) for text in feedback.lines(result, lang, reveal))
        yield line((f"Participant {name.id}", name.who, "", result.total, result.most, "", comment))


def canvas_grades(named: Sequence[NamedResult], assignment: str, most: Decimal) -> Iterator[str]:
    """The gradebook, row by row, without files that Canvas has not named."""
    yield line((*_CANVAS_FRONT, assignment))
    yield line(("    Points Possible", "", "", "", "", most))
    yield from (line((name.who, name.id, "", "", "", result.total)) for name, result in named)


# --- Gradescope and PrairieLearn: a file `results.json` a submission --------------------------------------------------


def gradescope_json(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """The file of a Gradescope autograder: every test has its `status`. What was not marked has no score, so that
    Gradescope shows a failed run and no zero."""
    text = {"output_format": "text", "visibility": "visible"}
    tests: list[Plain] = []
    for name, output, each in _tests(result, lang, reveal):
        earned, most = _worth(each)
        good = each is not None and each.verdict not in ("wrong", "missing", "not read") and earned >= most
        test = {"name": name, "status": "passed" if good else "failed", "output": output, **text}
        tests.append({**test, "score": earned, "max_score": most} if each is not None and each.points else test)
    if result.status == "not marked":
        name, why = say("verdicts.status not marked", lang), feedback.reason(result, lang)
        tests.append({"name": clean(name), "status": "failed", "output": clean(why), **text})
    points = "\n".join(feedback.points_that_count(result, lang))
    mark: dict[str, Plain] = {"platform": "gradescope", "format": FORMAT}
    mark |= {"student": result.student, "status": result.status}
    file: dict[str, Plain] = {
        "output": clean(feedback.reason(result, lang) if result.total is None else points), **text, "tests": tests,
        "extra_data": {"graphkin": mark},
    }
    if result.total is not None:
        file["score"] = float(result.total)
    return _bytes(file, indent=1)


def _tests(result: Result, lang: Lang, reveal: Reveal) -> Iterator[tuple[str, str, Judged | None]]:
    """The words about each quantity under its name; then the diagnosis, which is of none."""
    for each in result.lines:
        name = feedback.as_on_sheets(result, each.text)
        yield clean(name), clean(feedback.quantity(result, each, lang, reveal)), each
    if text := " ".join(feedback.diagnosis(result, lang, reveal)):
        yield clean(say("feedback.diagnosis", lang)), clean(text), None


def _worth(each: Judged | None) -> tuple[float, float]:
    """The points earned, of those there are."""
    return (0.0, 0.0) if each is None else (float(points_of(each)), float(most_of(each)))


def prairielearn_json(result: Result, lang: Lang, reveal: Reveal, pictures: Sequence[ResultPicture] = ()) -> bytes:
    """The file of PrairieLearn's external grading, under 1 MB: without its last pictures, then with shorter texts.

    A file that could not be marked is not gradable: no points are lost, and no attempt. A test that is worth nothing
    (the diagnosis, a value on the way) is shown as information.
    """
    for count in range(len(pictures), -1, -1):
        if len(data := _bytes(_prairielearn(result, lang, reveal, pictures[:count]))) < LARGEST:
            return data
    for most in _SHORTER:
        shortened = _shortened(_prairielearn(result, lang, reveal, ()), most)
        if len(data := _bytes(shortened)) < LARGEST:
            return data
    return _bytes({**shortened, "tests": []})


def _prairielearn(result: Result, lang: Lang, reveal: Reveal, pictures: Sequence[ResultPicture]) -> dict[str, Plain]:
    mark: dict[str, Plain] = {"graphkin": {"platform": "prairielearn", "format": FORMAT, "status": result.status}}
    if result.score is None:
        return {"gradable": False, "format_errors": [clean(feedback.reason(result, lang))], **mark}
    texts = [*feedback.points_that_count(result, lang)]
    tests: list[Plain] = []
    for name, message, each in _tests(result, lang, reveal):
        earned, most = _worth(each)
        tests.append({"name": name, "points": earned, "max_points": most, "message": message, "images": []})
    return {
        "gradable": True, "score": float(result.score), "message": clean(texts[-1]), "output": clean("\n".join(texts)),
        "images": [
            {"label": clean(each.label), "url": f"data:{each.kind};base64,{base64.b64encode(each.data).decode()}"}
            for each in pictures if each.data
        ],
        "tests": tests, **mark,
    }  # fmt: skip


def _bytes(file: Mapping[str, Plain], indent: int | None = None) -> bytes:
    return (json.dumps(file, ensure_ascii=True, allow_nan=False, indent=indent) + "\n").encode()


def _shortened(value: T, most: int) -> T:
    """The same with every text cut."""
    if isinstance(value, str):
        return value if len(value) <= most else type(value)(value[: most - 2] + "..")
    if isinstance(value, dict):
        return type(value)({key: _shortened(each, most) for key, each in value.items()})
    return type(value)([_shortened(each, most) for each in value]) if isinstance(value, list) else value
