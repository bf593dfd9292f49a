"""A problem as a platform asks it: text, and numbers in the units that a student types them in."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from graphkin.base.value import frozen
from graphkin.errors import Lang

Text = Mapping[Lang, str]
"""A text in each language."""


@frozen
class Wrong:
    """A number that follows from a known mistake.

    ids      of mistakes that all give it; mistake: in words, to stand after `is consistent with`
    percent  of the points that it is still worth
    form     what was taken instead: mistakes of one id and form that give one number cannot be told apart by it
    """

    ids: tuple[str, ...]
    number: float
    tolerance: float
    mistake: Text
    percent: int = 0
    form: str = ""


@frozen
class Part:
    """One quantity that is asked for.

    name    as it is read: "omega 3"; `label`: as it is printed
    number  the right one, in `unit`; `also`: others that are as right, such as an angle and a turn more
    points  for a right number
    """

    name: str
    number: float
    tolerance: float
    unit: str
    points: float = 1.0
    wrongs: tuple[Wrong, ...] = ()
    also: tuple[float, ...] = ()
    label: str = ""

    @property
    def heading(self) -> str:
        """`ω3 (rad/s)`."""
        return (self.label or self.name) + (f" ({self.unit})" if self.unit else "")


@frozen
class Question:
    """One student's problem. id: the student's or the variant's."""

    id: str
    text: Text
    parts: tuple[Part, ...]


@frozen
class ProblemSet:
    """The problems of a class."""

    name: str
    questions: Sequence[Question]
