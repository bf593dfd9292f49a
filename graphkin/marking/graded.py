"""One submission, marked or not: the record that every output is made of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import GraphkinError
from graphkin.marking.marked import Marked

Drawn = Mapping[Plane, Mapping[str, complex]]
"""Points of a drawing by plane and letter, SI, from any of them."""


@frozen
class Graded:
    """What came of one submission.

    student, file, place   as it was handed in
    marked    verdicts and marks; None where it was not marked
    reason    why it was not, then
    notes     what was passed over in it: a text that is no quantity, a value that is no number
    drawn     points that were measured on a drawing, by plane and letter, SI, from any of them
    prints    fingerprints of what was handed in, of how it was read, of what was asked, and of the key; empty where it
              is to be tried again
    """

    student: str
    file: str
    place: str
    marked: Marked | None
    reason: GraphkinError | None = None
    notes: tuple[GraphkinError, ...] = ()
    drawn: Drawn = field(default_factory=dict)
    prints: tuple[str, ...] = ()
