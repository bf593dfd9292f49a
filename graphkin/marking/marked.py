"""What is handed in, and what becomes of it: numbers, verdicts with their arithmetic, marks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Literal

from graphkin.base.value import frozen
from graphkin.marking.diagnosis import Diagnosis

Verdict = Literal["right", "carried", "wrong", "missing", "dead point", "too small"]
"""The last two are of values that paper cannot tell: neither right nor wrong, and worth nothing either way."""


@frozen
class HandedNumber:
    """A handed-in value, SI.

    unit_right   its unit is of the quantity's kind, or none stands there
    points       of a vector that was drawn: whether it points as it should, where that is told by itself
    measured     on a drawing, or read off it, by us
    """

    value: float
    unit_right: bool = True
    points: bool | None = None
    measured: bool = False


@frozen
class StudentWork:
    """What one student hands in: numbers by quantity, as quantities are read."""

    student: str
    numbers: Mapping[str, HandedNumber]


@frozen
class Judged:
    """The verdict on one quantity.

    right, tolerance   of the key
    carried   what follows from the student's own values before it, `own` by quantity; None where none enters it
    refused   own values that are not carried on: nought, a number of the problem, far off, or not drawable
    sense     whether it has the sense of the value it is judged by; None where there is none
    credit    from 0 to 1, of its `points`
    measured  as of the `Number`
    """

    text: str
    unit: str
    given: float | None
    right: float
    tolerance: float
    verdict: Verdict
    sense: Literal["right", "wrong"] | None = None
    unit_right: bool = True
    carried: float | None = None
    own: Mapping[str, float] = field(default_factory=dict)
    refused: tuple[str, ...] = ()
    credit: float = 0.0
    points: float = 0.0
    measured: bool = False


@frozen
class Marked:
    """A student's verdicts, and what the wrong values come from."""

    student: str
    judged: tuple[Judged, ...]
    diagnosis: Diagnosis

    @property
    def score(self) -> float | None:
        """Marks from 0 to 1; None where paper can tell nothing that was handed in."""
        total = sum(one.points for one in self.judged)
        return sum(one.points * one.credit for one in self.judged) / total if total else None
