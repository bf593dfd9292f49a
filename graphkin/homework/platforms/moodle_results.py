"""Results for a Moodle assignment: the grading worksheet, and a zip of feedback files under Moodle's names.

Moodle finds students by the number in `Identifier`; a grade that is left empty stays as it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from graphkin.errors import Lang
from graphkin.homework.platforms.cells import line
from graphkin.homework.platforms.feedback import Feedback, Reveal, lines
from graphkin.homework.platforms.marked_up import in_html
from graphkin.homework.platforms.platform_names import moodle
from graphkin.homework.platforms.result import Result
from graphkin.homework.platforms.web_page import html

HEADERS = (
    "Identifier", "Full name", "Status", "Grade", "Maximum grade", "Last modified (grade)", "Feedback comments",
)  # fmt: skip
"""As an English Moodle reads them."""


def grades(results: Iterable[Result], lang: Lang, reveal: Reveal) -> Iterator[str]:
    """The worksheet, row by row; those whose files are not named as Moodle does are not in it."""
    yield line(HEADERS)
    for result in results:
        if (named := moodle(result.file)) is not None:
            comment = "<br>".join(in_html(text) for text in lines(result, lang, reveal))
            yield line((f"Participant {named.id}", named.who, "", result.total, result.most, "", comment))


def feedback(results: Iterable[Result], told: Callable[[Result], Feedback]) -> Iterator[tuple[str, bytes]]:
    """The pages of the zip."""
    for result in results:
        if (named := moodle(result.file)) is not None:
            yield named.name, html(told(result))
