"""Mechanisms of the library as they are drawn: many tests look at one drawing, which each process makes once; and
where those of other textbooks are."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

from graphkin import Drawing
from graphkin.construction import Plot
from graphkin.errors import Lang
from graphkin.files import library, load
from graphkin.homework.grading.keys import USUAL, Pencils
from graphkin.homework.grading.keys import key_for as made_key
from graphkin.marking.key import Key
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Quantity
from graphkin.planning import Method
from graphkin.sheet import Sheet, Style
from graphkin.sheet.lettering import Label

TEXTBOOK = Path(__file__).parent / "cases" / "textbook"


loaded = cache(library.load)
"""The same object each time, of which what was worked out is kept."""


def key_for(mechanism: Mechanism, pencils: Pencils = USUAL, quantities: Sequence[Quantity] = ()) -> Key:
    """The key of such an object is made once for each pencil."""
    place = mechanism.name, repr(pencils)
    if quantities or mechanism.name not in library.names() or mechanism is not loaded(mechanism.name):
        return made_key(mechanism, pencils, quantities)
    if place not in _KEYS:
        _KEYS[place] = made_key(mechanism, pencils)
    return _KEYS[place]


_KEYS: dict[tuple[str, str], Key] = {}


@cache
def drawing(name: str) -> Drawing:
    return Drawing.of(loaded(name))


def plain_text(label: Label) -> str:
    return "".join(run.text for run in label)


def solved(name: str) -> tuple[Method, Plot]:
    return drawing(name).method, drawing(name).plot


@cache
def _sheet(name: str, style: Style, lang: Lang) -> Sheet:
    return drawing(name).sheet(style=style, lang=lang)


def library_sheet(name: str, style: Style = "construction", lang: Lang = "en") -> Sheet:
    return _sheet(name, style, lang)


@cache
def textbook_sheet(name: str, lang: Lang = "en", paper: str | None = None) -> Sheet:
    """Of a mechanism of other textbooks."""
    return Drawing.of(load(TEXTBOOK / f"{name}.toml")).sheet(lang=lang, paper=paper)
