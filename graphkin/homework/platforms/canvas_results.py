"""Results for Canvas: a gradebook CSV, and a zip of feedback under the very names of the download.

Canvas shows a file of feedback under the name of the one that was handed in, so it must be of the same kind.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from decimal import Decimal
from pathlib import PurePosixPath

from graphkin.homework.platforms.cells import line
from graphkin.homework.platforms.feedback import Feedback
from graphkin.homework.platforms.pages import KINDS, Page
from graphkin.homework.platforms.platform_names import canvas
from graphkin.homework.platforms.result import Result

_FRONT = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")


def grades(results: Iterable[Result], assignment: str, most: Decimal) -> Iterator[str]:
    """The gradebook, row by row; those whose files are not named as Canvas does are not in it."""
    yield line((*_FRONT, assignment))
    yield line(("    Points Possible", "", "", "", "", most))
    for result in results:
        if (named := canvas(result.file)) is not None:
            yield line((named.who, named.id, "", "", "", result.total))


def feedback(results: Iterable[Result], told: Callable[[Result], Feedback]) -> Iterator[tuple[str, bytes]]:
    """The files of the zip."""
    for result in results:
        named = canvas(result.file)
        if named is not None and (made := kind(named.name)) is not None:
            yield named.name, made(told(result))


def kind(name: str) -> Page | None:
    """What writes feedback of the kind of a file; None where nothing does."""
    return KINDS.get(PurePosixPath(name).suffix.lower())
