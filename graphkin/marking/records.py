"""Records of marking: numbers handed in, verdicts with their arithmetic, marks; of one position or of several."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from typing import Literal

from graphkin.base.value import bulky, frozen
from graphkin.construction import Plane
from graphkin.errors import GraphkinError
from graphkin.marking.diagnosis import SLIP, Diagnosis, Explanation, Trace, added
from graphkin.marking.key import Name
from graphkin.model.mechanism import EQUATIONS
from graphkin.model.quantities import at_position, position_of
from graphkin.submissions.submission import BoardWork, MeasuredDrawing

Verdict = Literal["right", "carried", "wrong", "missing", "dead point", "too small", "not read"]
"""The last three count nothing either way: values that paper cannot tell, and one that only the teacher can read."""


@frozen
class HandedNumber:
    """A handed-in value, SI.

    unit_right   its unit is of the quantity's kind, or none stands there
    points       of a vector that was drawn: whether it points as it should, where that is told by itself; follows: the
                 own values before it by which it does, where it does not point as the right one
    measured     on a drawing, or read off it, by us
    vector       with the direction that was written beside its size, in the mechanism's axes
    within       the angle within which that holds where it is in words; 0 where it is in numbers [rad]
    off          its standard deviation, where what it was measured on is not sure: unless that is small it takes part
                 in what is found out of mistakes alone
    reversed     whether `vector` points just the other way; worded: whether a sense is said in words
    """

    value: float
    unit_right: bool = True
    points: bool | None = None
    measured: bool = False
    vector: complex | None = None
    within: float = 0.0
    off: float = 0.0
    reversed: bool = False
    follows: tuple[str, ...] = ()
    worded: bool = False


@frozen
class StudentWork:
    """The work of one student: numbers by quantity, as quantities are read.

    unread  answers in which no number was found, as they were written
    board   the equations and the steps of a drawing board
    error   of what was measured on a photograph of paper [mm]
    """

    student: str
    numbers: Mapping[str, HandedNumber]
    unread: Mapping[str, str] = field(default_factory=dict)
    board: BoardWork | None = None
    error: float = 0.0


@frozen
class Judged:
    """The verdict on one quantity.

    right, tolerance   of the key
    carried   what follows from the student's own values before it, `own` by quantity; None where none enters it
    refused   own values that are not carried on: nought, a number of the problem, far off, or not drawable
    sense     whether it has the sense of the value it is judged by; None where there is none
    credit    from 0 to 1, of its `points`
    measured  as of the `HandedNumber`
    written   the answer as it was written, where it was not read
    of_mistake  whether what is carried follows from the mistake that was named, made before
    reversed  whether its arrow points just the other way; other: the motion that has this direction, of a relative one
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
    written: str = ""
    of_mistake: bool = False
    reversed: bool = False
    other: str = ""

    @property
    def of_equations(self) -> bool:
        """True of the choices in vector equations, which are counted."""
        return self.text in EQUATIONS.values()


@frozen
class EquationFault:
    """A choice in a vector equation that is not right.

    row      "direction" or "magnitude"
    written  the token that was chosen, "" where none was; right: one that is
    sense    the line is right, and its sense is wrong or is not said
    """

    plane: Plane
    equation: int
    term: str
    row: str
    written: str
    right: str
    sense: bool = False


@frozen
class StepDeparture:
    """The first step of a drawing that leaves the right way.

    step   its number; plane: where it was drawn
    kind   "through", "direction" or "line" of a line; "length", "reversed", "turned", "tail" or "ends" of an
           arrow; "tip", "crossing" or "image" of a point, "place" of one of the mechanism
    what   the arrow or the point it draws; of a line its direction as a token, of one drawn in another direction the
           point that it goes through
    drawn, right   what was taken, "" where that has no name, and what is right: a point, a direction as a token or an
                   angle [deg], a length [mm]
    line   of "line": the right direction as a token
    """

    step: int
    plane: Plane
    kind: str
    what: str
    drawn: str = ""
    right: str = ""
    line: str = ""


@frozen
class Departure:
    """The first wrong value in the order of the drawing, and the equation that gives it, as it is written: arrows of
    the left and of the right side; none where no equation gives it."""

    text: str
    left: tuple[str, ...] = ()
    right: tuple[str, ...] = ()


@frozen
class Marked:
    """A student's verdicts, and the mistakes behind the wrong values; where nothing explains them, where they leave
    the right way. Of a drawing board the choices that are not right, and the step that leaves the right way."""

    student: str
    judged: tuple[Judged, ...]
    diagnosis: Diagnosis
    departure: Departure | None = None
    faults: tuple[EquationFault, ...] = ()
    step: StepDeparture | None = None

    @property
    def score(self) -> float | None:
        """Marks from 0 to 1; None where paper can tell nothing that was handed in, or an answer was not read."""
        total = sum(one.points for one in self.judged)
        if any(one.verdict == "not read" and one.points for one in self.judged):
            return None
        return sum(one.points * one.credit for one in self.judged) / total if total else None


Drawn = Mapping[Plane, Mapping[str, complex]]  # points of a drawing by plane and letter, SI, from any of them


@bulky
class Graded:
    """The outcome of one submission.

    student, file, place   as it was handed in
    marked    verdicts and marks; None where it was not marked
    reason    why it was not, then
    notes     what was passed over in it: a text that is no quantity, a value that is no number
    drawn     points that were measured on a drawing, by plane and letter, SI, from any of them
    prints    fingerprints of what was handed in, of how it was read, of what was asked, and of the key; empty where it
              is to be tried again
    remarks   for the teacher alone: what should be looked at
    board     the equations and the steps of a drawing board
    measured  what was measured on photographs of paper, as it lies there
    """

    student: str
    file: str
    place: str
    marked: Marked | None
    reason: GraphkinError | None = None
    notes: tuple[GraphkinError, ...] = ()
    drawn: Drawn = field(default_factory=dict)
    prints: tuple[str, ...] = ()
    remarks: tuple[GraphkinError, ...] = ()
    board: BoardWork | None = None
    measured: MeasuredDrawing | None = None


def by_position(work: StudentWork, count: int) -> list[StudentWork]:
    """The numbers of each position, under the names they have there; of one that there is not, they are dropped. A
    board is of the first."""
    numbers_at: list[dict[str, HandedNumber]] = [{} for _ in range(count)]
    unread_at: list[dict[str, str]] = [{} for _ in range(count)]
    for text in (*work.numbers, *work.unread):
        bare, at = position_of(text)
        if at <= count and text in work.numbers:
            numbers_at[at - 1][bare] = work.numbers[text]
        elif at <= count:
            unread_at[at - 1][bare] = work.unread[text]
    boards = [work.board, *[None] * (count - 1)]
    return [replace(work, numbers=numbers, unread=unread, board=board)
            for numbers, unread, board in zip(numbers_at, unread_at, boards, strict=True)]  # fmt: skip


def _at(name: Name, at: int) -> Name:
    """A slip is one at its position; a mistake is the same at all of them."""
    id, way, of, form = name
    return (id, way, tuple(at_position(one, at) for one in of), form) if id == SLIP else name


def as_one(student: str, parts: Sequence[Marked]) -> Marked:
    """One record of all positions; a mistake that shows at several is told once. Evidence is added as over several
    problems, of positions where something was handed in."""
    judged = tuple(
        replace(
            one, text=at_position(one.text, at), own={at_position(text, at): x for text, x in one.own.items()},
            refused=tuple(at_position(text, at) for text in one.refused),
        )
        for at, part in enumerate(parts, 1) for one in part.judged
    )  # fmt: skip
    handed_in = [part for part in parts if any(one.given is not None for one in part.judged)]
    evidence = added(Trace((), part.diagnosis.evidence) for part in handed_in)
    explanations: list[Explanation] = []
    for at, part in enumerate(parts, 1):
        for each in part.diagnosis.explanations:
            explains = tuple(at_position(text, at) for text in each.explains)
            one = replace(each, names=tuple(tuple(_at(name, at) for name in names) for names in each.names))
            for k, other in enumerate(explanations):  # one that shares a mistake: as sure as the less sure of both
                if both := tuple(names for names in other.names if names in one.names):
                    probability, margin = min(one.probability, other.probability), min(one.margin, other.margin)
                    explanations[k] = Explanation(both, probability, margin, (*other.explains, *explains))
                    break
            else:
                explanations.append(replace(one, explains=explains))
    departures = (replace(part.departure, text=at_position(part.departure.text, at))
                  for at, part in enumerate(parts, 1) if part.departure is not None)  # fmt: skip
    diagnosis = Diagnosis(tuple(explanations), evidence)
    return Marked(student, judged, diagnosis, next(departures, None), parts[0].faults, parts[0].step)
