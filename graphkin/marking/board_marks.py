"""A drawing board marked beside its numbers: vector equations term by term, and the first wrong step of the drawing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.marking.answers import ArrowPlaces, readable
from graphkin.marking.board_steps import first_wrong_step
from graphkin.marking.equation_choices import EquationChoices, TermChoices, equation_choices
from graphkin.marking.records import EquationFault, Judged, StepDeparture, StudentWork, Verdict
from graphkin.model.mechanism import EQUATIONS
from graphkin.model.quantities import Quantity, Rotation
from graphkin.planning import Method
from graphkin.submissions.submission import FilledTerm

_HALF = 0.5  # what a direction on the right line is worth whose sense is wrong or is not said


@frozen
class BoardMarks:
    """Lines for the equations of each plane, choices that are not right, the first wrong step."""

    lines: tuple[Judged, ...] = ()
    faults: tuple[EquationFault, ...] = ()
    step: StepDeparture | None = None


def board_marks(method: Method, plot: Plot, arrows: ArrowPlaces, work: StudentWork) -> BoardMarks:
    """The marks of a board. Equations that the file gives points for are missed where there is none."""
    worth, board = method.mechanism.worth, work.board
    if board is None and worth.keys().isdisjoint(EQUATIONS.values()):
        return BoardMarks()
    choices, lines, faults = equation_choices(method, plot), list[Judged](), list[EquationFault]()
    for plane, text in EQUATIONS.items():
        every = [one for one in choices if one.plane == plane]
        filled = [] if board is None else [one for one in board.equations if one.plane == plane]
        count = 2 * sum(len(one.terms) for one in every)
        wrong = [*_faults(every, filled)]
        points = worth.get(text, 0.0 if board is None else 1.0)
        if not count or (board is None and not points):
            continue
        right = count - sum(1 - one.sense * _HALF for one in wrong)
        there = any(any(_tokens(one)) for one in filled)
        verdict: Verdict = "missing" if not there else "wrong" if wrong else "right"
        given, credit = (right, right / count) if there else (None, 0.0)
        lines.append(Judged(text, "1", given, float(count), 0.0, verdict, credit=credit, points=points))
        faults += wrong if there else []
    if board is None:
        return BoardMarks(tuple(lines))
    numbers = {readable(method.mechanism, text): one.value for text, one in work.numbers.items() if not one.measured}
    written: dict[Quantity, float] = {q: value for q, value in numbers.items() if isinstance(q, Rotation)}
    return BoardMarks(tuple(lines), tuple(faults), first_wrong_step(method, plot, arrows, board, written, choices))


def _tokens(term: FilledTerm) -> tuple[str, str]:
    return term.direction, term.magnitude


def _faults(choices: Sequence[EquationChoices], filled: Sequence[FilledTerm]) -> Iterator[EquationFault]:
    """The choices of a plane that are not right, term by term."""
    by_term = {(one.equation, one.term): _tokens(one) for one in filled}
    for equation in choices:
        for term in equation.terms:
            direction, magnitude = by_term.get((equation.number, term.name), ("", ""))
            name = (equation.plane, equation.number, term.name)
            if not _points(term, direction):
                yield EquationFault(*name, "direction", direction, term.directions[0], direction in term.senseless)
            if magnitude not in term.magnitudes:
                yield EquationFault(*name, "magnitude", magnitude, term.magnitudes[0])


def _points(term: TermChoices, direction: str) -> bool:
    """True of a right direction; of a term that is nothing any is."""
    return direction in term.directions or (term.nothing and bool(direction))
