"""Who a file is from, by the name that Moodle or Canvas gave it in a download; the same name takes feedback back.

Moodle: `First Last_123_assignsubmission_file_/a.svg`, or all in one name. Canvas: `lastfirst_3143_207797_a.svg`: of the
pieces between underscores, the first two that are numbers are the student and the file.
"""

from __future__ import annotations

import re

from graphkin.base.value import frozen
from graphkin.homework.platforms.archive import inside

_MOODLE = re.compile(r"(?P<who>[^_/]*)_(?P<id>[0-9]{1,18})_(?P<plugin>assignsubmission_[a-z]+).*", re.S)
_ARCHIVE = re.compile(r"^.*?\.zip!", re.S | re.I)


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
    parts = _member(file).split("/")
    for k, part in enumerate(parts):
        if found := _MOODLE.fullmatch(part):
            return _safe(Named(_beside("/".join(parts[k:])), found["id"], found["who"]))
    return None


def canvas(file: str) -> Named | None:
    """The member of a Canvas download; None where it is not named so."""
    name = _member(file).rpartition("/")[2]
    pieces = name.split("_")
    numbers = [k for k, piece in enumerate(pieces) if re.fullmatch("[0-9]{1,18}", piece)]
    if len(numbers) < 2 or not numbers[0]:
        return None
    who = "_".join(piece for piece in pieces[: numbers[0]] if piece != "LATE")
    return _safe(Named(name, pieces[numbers[0]], who))


def _member(file: str) -> str:
    """The name inside the archive, where it is the member of one: `class.zip!name`."""
    return _ARCHIVE.sub("", file, count=1)


def _beside(name: str) -> str:
    """The page of feedback that goes with a file: in its folder, or with its beginning."""
    folder, slash, last = name.rpartition("/")
    stem = last.rpartition(".")[0] or last
    return f"{folder}{slash}{stem}.html"


def _safe(named: Named) -> Named | None:
    return named if inside(named.name) else None
