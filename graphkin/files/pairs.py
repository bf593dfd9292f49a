"""The tables of pairs, in the order in which a mechanism lists them; `READERS` has one reader a kind of table."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from graphkin.files.contacts import read_cam, read_gear, read_roll
from graphkin.files.draft import Draft
from graphkin.files.positions import Path
from graphkin.files.schema import File
from graphkin.files.slides import read_slide
from graphkin.model.pairs import Pair

READERS: Mapping[str, Callable[[Draft, Any, Path, Sequence[Pair]], Pair]] = {
    "slide": read_slide,
    "gear": read_gear,
    "roll": read_roll,
    "cam": read_cam,
}


def read_pairs(draft: Draft, file: File) -> tuple[Pair, ...]:
    """The pairs of a file, kind by kind; each reader is told its place in the file and the pairs before."""
    tables = {name: getattr(file, name) for name in READERS}
    draft.given = {name for given in tables.values() for each in given if (name := getattr(each, "name", None))}
    draft.slides = file.slide
    pairs: list[Pair] = []
    for name, read in READERS.items():
        for number, table in enumerate(tables[name]):
            with draft.noting():
                pairs.append(read(draft, table, (name, number), pairs))
    return tuple(pairs)
