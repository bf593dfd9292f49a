"""The one speaker: whatever graphkin says, but its errors, is said here, in either language.

    catalogue       phrases by full name, `subject.key`; their texts in `phrases`, imported when needed
    numbers, figures, names, text_table    figures, formulas, points and links in print; text in columns
    entry           headings, sentences, calculations, vector equations: data for any output; their lines
    reading, plane  a mechanism at one position, and one of its polygons: names and plain numbers of all they hold
    explained       a method and its plot -> entries, by a reader each: `problem_data`, `solution_goal`, `position`
                    (`tangents`, `equivalents`), `polygons` (`equations`, `rolling`, `simultaneous`); the answers
    dimensions      the numbers that a file gives, for sentences and for sheets
    structure, results, sweeps, finding, design, linkages, centre_*, file_help    a reader a subject
    problems, marks, tolerances    homework

Every figure is taken from the data; nothing here solves anything. A new step kind fails the type check in each
reader of steps until it has its words; a new size or direction, in `plane`.

How to add a phrase:
1. `phrases/SUBJECT.py`: its full name, the English and the Chinese text, with the same placeholders in both.
2. Ask for it where the subject is read: `say("subject.key", lang, word=..)`; in a reading, `reading.say(..)`.
3. A choice by data is a family, a word before what is open: `say(f"subject.kind {pair.kind}", lang)`.
4. Figures come from `numbers`, names from `names`, signs between from `common`; data carries `meaning(..)`.
5. `pytest tests/say/test_catalogue.py`: a phrase that nobody uses fails, as does one that is not there.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

_WHERE = dict.fromkeys(("TermRow", "Calculation", "Entry", "Heading", "Sentence", "VectorEquation"), "entry")
_WHERE |= dict.fromkeys(("derivation", "explain", "vector_equations"), "explained")
_WHERE |= {"say": "catalogue"}

__all__ = [
    "Calculation", "Entry", "Heading", "Sentence", "TermRow", "VectorEquation", "derivation", "explain", "say",
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
