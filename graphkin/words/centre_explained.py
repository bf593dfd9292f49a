"""The instant centres in words: how each is found, and what they give."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.centres import Centres
from graphkin.errors import Lang
from graphkin.words.centre_steps import CentreReader
from graphkin.words.centre_uses import uses
from graphkin.words.entries import Entry, Heading
from graphkin.words.layout import lines

__all__ = ["centre_entries", "explain_centres"]


def explain_centres(found: Centres, lang: Lang, scale: float | None = None) -> list[str]:
    """All centres with the lines that give them, and the velocities asked for with their figures, line by line.

    found  at one position
    scale  of the drawing from which lengths are taken [m/mm]; the file's own, or 0.001, where left out
    """
    return list(lines(centre_entries(found, lang, scale), lang))


def centre_entries(found: Centres, lang: Lang, scale: float | None = None) -> Iterator[Entry]:
    """The same as data."""
    reader = CentreReader(found, lang)
    yield Heading(found.method.mechanism.headline(lang))
    yield from reader.entries()
    yield from uses(reader, scale or found.method.mechanism.scales.get("length", 0.001))
