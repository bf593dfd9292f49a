"""The one speaker: whatever graphkin says, but its errors, is said here, in either language.

    catalogue       phrases by name, `subject.key`; their texts in `phrases`, a file a subject, imported when needed
    numbers, names  how figures, points, vectors and links are written; `text_table`: text in columns
    explained       a method and its plot -> entries (headings, sentences, calculations, vector equations), data for
                    any output; `layout` makes lines of them. `reading` is the mechanism's side, `plane` a polygon's;
                    a reader each: `given`, `position`, `equivalents`, `sizes`, `equations`, `rotation`, `rolling`,
                    `together`, `polygons`; `asked` what of it is told, `asked_centres`, `answers`, and `deviation`
                    of what was read by hand; `given_sizes` what a file gives, for sentences and for sheets
    structure, redundancy, results, checks, sweeps, finding, design, linkages, centre_*    a reader a subject
    problems, marks, mistakes, tolerances    homework

Every figure is taken from the data; nothing here solves anything. A new step kind fails the type check in each
reader of steps until it has its words; a new size, in `sizes`; a new direction, in `plane`.

How to add a phrase:
1. `phrases/SUBJECT.py`: a key, the English and the Chinese text, with the same placeholders in both.
2. Ask for it where the subject is read: `say("subject.key", lang, word=..)`; in a reading, `reading.say(..)`.
3. A choice by data is a family, a word before what is open: `say(f"subject.kind {found.kind}", lang)`.
4. Figures come from `numbers`, names from `names`, signs between from `common`; data carries `meaning(..)`.
5. `pytest tests/test_catalogue.py`: a phrase that nobody asks for fails, as does one that is asked for and not there.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

_WHERE = dict.fromkeys(("TermRow", "Calculation", "Entry", "Heading", "Sentence", "VectorEquation"), "entry")
_WHERE |= dict.fromkeys(("derivation", "explain", "vector_equations"), "explained")
_WHERE |= {"say": "catalogue"}

__all__ = [
    "Calculation",
    "Entry",
    "Heading",
    "Sentence",
    "TermRow",
    "VectorEquation",
    "derivation",
    "explain",
    "say",
    "vector_equations",
]  # fmt: skip

if TYPE_CHECKING:
    from graphkin.say.catalogue import say
    from graphkin.say.entry import Calculation, Entry, Heading, Sentence, TermRow, VectorEquation
    from graphkin.say.explained import derivation, explain, vector_equations


def __getattr__(name: str) -> object:
    """Public names are imported when first used: who speaks of one subject loads no other."""
    if name not in _WHERE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_WHERE[name]}"), name)
