"""Who handed a file in, by the names that platforms give to files; and a file's name for any id."""

from __future__ import annotations

import hashlib
import re
from pathlib import PurePosixPath

from graphkin.base.value import frozen
from graphkin.errors import steers
from graphkin.model.quantities import position_of

_MOODLE = re.compile(r"(?P<name>[^/]+)_(?P<id>[0-9]+)_assignsubmission_[a-z]+(?:_|/|$)")
_CANVAS = re.compile(r"(?P<name>[^_/]+)(?:_LATE)?_(?P<id>[0-9]+)_(?P<sub>[0-9]+)_(?P<file>[^/]+)$")
_RESERVED = {"con", "prn", "aux", "nul", *(f"{port}{k}" for port in ("com", "lpt") for k in range(10))}
LONGEST_ID = 200
DRAWINGS = (".svg", ".ggb", ".dxf")
"""Kinds of files that may show one position of several, whose number ends their name."""


@frozen
class Owner:
    """Who handed in: what results are called by, and other names under which a key may know the student.

    group  what the files of one hand-in have in common
    """

    student: str
    others: tuple[str, ...]
    group: str


def owner(path: str, root: str = "", alone: bool = False) -> Owner:
    """Of a file or of a member of an archive; `root` is the folder that all members share.

    alone  a folder is no student's: each name in it is one
    """
    inner = path.removeprefix(root)
    if (moodle := _MOODLE.search(inner)) is not None:
        number = moodle["id"]
        return Owner(tidy_id(number), (f"Participant {number}", tidy_id(moodle["name"])), inner[: moodle.end()])
    if (canvas := _CANVAS.search(inner)) is not None:
        return Owner(tidy_id(canvas["id"]), (tidy_id(canvas["name"]),), inner[: canvas.start("sub")])
    whole = PurePosixPath(inner)
    if alone or "/" not in inner:
        stem = position_of(whole.stem)[0].rstrip() if whole.suffix.lower() in DRAWINGS else whole.stem
        return Owner(tidy_id(stem), (), str(whole.with_name(stem or whole.stem)))
    return Owner(tidy_id(whole.parent.name), (), str(whole.parent))


def tidy_id(text: str) -> str:
    """An id as it is shown: without blanks about it, and nothing in it that steers a screen."""
    return "".join(letter for letter in " ".join(text.split()) if not steers(letter))[:LONGEST_ID]


def safe_name(student: str) -> str:
    """A file's name for an id: its plain letters, and a mark of the whole id wherever that is not all of it.

    >>> safe_name("s1"), safe_name("../../etc")
    ('s1', 'etc-74ccf3c5b4c1')
    """
    kept = "".join(letter if letter.isalnum() or letter in "_-" else "-" for letter in student[:60]).strip("-_")
    plain = bool(kept) and kept == student and kept.isascii() and kept == kept.lower() and kept not in _RESERVED
    if plain:
        return kept
    mark = hashlib.sha256(student.encode("utf-8", "surrogatepass")).hexdigest()[:12]
    return f"{kept}-{mark}" if kept else mark
