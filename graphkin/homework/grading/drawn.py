"""What drawings determine beside the vectors that are measured on them, added to what was handed in."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from graphkin.errors import GraphkinError, NoSenseDrawn, OffTheDrawing
from graphkin.homework.grading.sets import SetMarker
from graphkin.marking.marker import Marker
from graphkin.marking.records import HandedNumber, StudentWork
from graphkin.model.quantities import at_position, position_of
from graphkin.submissions import Submission

Found = tuple[StudentWork, list[GraphkinError]]


def with_drawings(work: StudentWork, one: Submission, judge: SetMarker) -> Found:
    """With rotations and the like that are asked for and stand nowhere in numbers, and which way known arrows point;
    with notes that say so."""
    marker = judge.marker(one.student) if one.drawings else None
    notes: list[GraphkinError] = []
    for at in one.drawings if marker is not None else ():
        assert marker is not None, "there is one"
        work, more = _at(work, one, at, marker)
        notes += more
    return work, notes


def _at(work: StudentWork, one: Submission, at: int, marker: Marker) -> Found:
    """By the drawing of one position."""
    vectors = {
        position_of(text)[0]: given.vector
        for text, given in one.values.items()
        if given.vector is not None and position_of(text)[1] == at
    }
    numbers = {position_of(text)[0]: n.value for text, n in work.numbers.items() if position_of(text)[1] == at}
    found, points = marker.positions[at - 1].off_drawing(one.drawings[at].in_si(), vectors, numbers)
    named = {at_position(text, at): value for text, value in found.values.items()}
    new = {text: HandedNumber(value, measured=True) for text, value in named.items() if text not in work.numbers}
    told = {text: replace(work.numbers[text], points=good) for text, good in _named(points, at).items()
            if text in work.numbers}  # fmt: skip
    lost = tuple(text for bare in found.no_sense if (text := at_position(bare, at)) not in work.numbers)
    where = one.drawings[at].where
    notes: list[GraphkinError] = [OffTheDrawing(where, tuple(new))] if new else []
    notes += [NoSenseDrawn(where, lost)] if lost else []
    return replace(work, numbers={**work.numbers, **new, **told}), notes


def _named(points: Mapping[str, bool], at: int) -> dict[str, bool]:
    return {at_position(text, at): good for text, good in points.items()}
