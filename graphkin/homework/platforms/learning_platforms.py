"""Results as learning platforms read them back: Moodle, Canvas, Gradescope, PrairieLearn.

Who a file is from stands in the name that Moodle or Canvas gave it in a download; the same name takes feedback back.
Moodle: `First Last_123_assignsubmission_file_/a.svg`, or all in one name. Canvas: `lastfirst_3143_207797_a.svg`: of the
pieces between underscores, the first two that are numbers are the student and the file.
"""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from decimal import Decimal
from pathlib import PurePosixPath
from typing import TypeVar

from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework.platforms.feedback import (
    Reveal,
    as_on_sheets,
    diagnosis,
    lines,
    points_that_count,
    quantity,
    reason,
)  # fmt: skip
from graphkin.homework.platforms.markup import clean, in_html, inside
from graphkin.homework.platforms.pages import KINDS, Page
from graphkin.homework.platforms.result import FORMAT, Result, ResultPicture, most_of, points_of
from graphkin.homework.platforms.tables import line
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


def named(results: Iterable[Result], of: Callable[[str], Named | None]) -> Iterator[tuple[Named, Result]]:
    """Results that have a name of the platform."""
    return ((name, result) for result in results if (name := of(result.file)) is not None)


def moodle_grades(results: Iterable[Result], lang: Lang, reveal: Reveal) -> Iterator[str]:
    """The grading worksheet, row by row, without files that Moodle has not named; an empty grade stays as it is."""
    yield line(HEADERS)
    for name, result in named(results, moodle):
        comment = "<br>".join(in_html(text) for text in lines(result, lang, reveal))
        yield line((f"Participant {name.id}", name.who, "", result.total, result.most, "", comment))


def canvas_grades(results: Iterable[Result], assignment: str, most: Decimal) -> Iterator[str]:
    """The gradebook, row by row, without files that Canvas has not named."""
    yield line((*_CANVAS_FRONT, assignment))
    yield line(("    Points Possible", "", "", "", "", most))
    yield from (line((name.who, name.id, "", "", "", result.total)) for name, result in named(results, canvas))


def canvas_page(name: str) -> Page | None:
    """The writer of feedback of the kind of a file, as Canvas shows it under the name that was handed in; None where
    there is none."""
    return KINDS.get(PurePosixPath(name).suffix.lower())


# --- Gradescope and PrairieLearn: a file `results.json` a submission --------------------------------------------------


def gradescope_json(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """The file of a Gradescope autograder: every test has its `status`. What was not marked has no score, so that
    Gradescope shows a failed run and no zero."""
    tests: list[Plain] = []
    for each in result.lines:
        good = each.verdict not in ("wrong", "missing", "not read") and points_of(each) >= most_of(each)
        name = as_on_sheets(result, each.text)
        test = _gradescope_test(name, quantity(result, each, lang, reveal), "passed" if good else "failed")
        worth = {"score": float(points_of(each)), "max_score": float(most_of(each))}
        tests.append({**test, **worth} if each.points else test)
    if text := " ".join(diagnosis(result, lang, reveal)):
        tests.append(_gradescope_test(say("feedback.diagnosis", lang), text, "failed"))
    if result.status == "not marked":
        tests.append(_gradescope_test(say("verdicts.status not marked", lang), reason(result, lang), "failed"))
    output = reason(result, lang) if result.total is None else "\n".join(points_that_count(result, lang))
    mark: dict[str, Plain] = {"platform": "gradescope", "format": FORMAT}
    mark |= {"student": result.student, "status": result.status}
    file: dict[str, Plain] = {
        "output": clean(output), "output_format": "text", "visibility": "visible", "tests": tests,
        "extra_data": {"graphkin": mark},
    }  # fmt: skip
    if result.total is not None:
        file["score"] = float(result.total)
    return (json.dumps(file, ensure_ascii=True, allow_nan=False, indent=1) + "\n").encode()


def _gradescope_test(name: str, output: str, status: str) -> dict[str, Plain]:
    shown = {"output": clean(output), "output_format": "text", "visibility": "visible"}
    return {"name": clean(name), "status": status, **shown}


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


def _prairielearn(result: Result, lang: Lang, reveal: Reveal, pictures: Sequence[ResultPicture]) -> dict[str, object]:
    mark = {"graphkin": {"platform": "prairielearn", "format": FORMAT, "status": result.status}}
    if result.score is None:
        return {"gradable": False, "format_errors": [clean(reason(result, lang))], **mark}
    texts = [*points_that_count(result, lang)]
    tests = [
        _prairielearn_test(
            as_on_sheets(result, one.text), float(points_of(one)), float(most_of(one)),
            quantity(result, one, lang, reveal),
        ) for one in result.lines
    ]  # fmt: skip
    if text := " ".join(diagnosis(result, lang, reveal)):
        tests.append(_prairielearn_test(say("feedback.diagnosis", lang), 0.0, 0.0, text))
    return {
        "gradable": True, "score": float(result.score), "message": clean(texts[-1]), "output": clean("\n".join(texts)),
        "images": [
            {"label": clean(each.label), "url": f"data:{each.kind};base64,{base64.b64encode(each.data).decode()}"}
            for each in pictures if each.data
        ],
        "tests": tests, **mark,
    }  # fmt: skip


def _prairielearn_test(name: str, earned: float, most: float, message: str) -> dict[str, object]:
    return {"name": clean(name), "points": earned, "max_points": most, "message": clean(message), "images": []}


def _bytes(file: dict[str, object]) -> bytes:
    return (json.dumps(file, ensure_ascii=True, allow_nan=False) + "\n").encode()


def _shortened(value: T, most: int) -> T:
    """The same with every text cut."""
    if isinstance(value, str):
        return value if len(value) <= most else type(value)(value[: most - 2] + "..")
    if isinstance(value, dict):
        return type(value)({key: _shortened(each, most) for key, each in value.items()})
    return type(value)([_shortened(each, most) for each in value]) if isinstance(value, list) else value
