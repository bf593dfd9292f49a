"""Marks as JSON: the line that programs read, one a submission, the whole record, and a file of all records.

Version 1; SI units, radians.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from graphkin.base.plain import Plain, built, plain
from graphkin.construction import Plane
from graphkin.errors import NOWHERE, Lang, UnsureDrawing
from graphkin.marking.records import Graded, Judged, Marked
from graphkin.outputs.files import beside
from graphkin.photo.sheets import Unsure
from graphkin.submissions.board import work_data
from graphkin.submissions.submission import MeasuredDrawing

FORMAT = 1
KIND = "graphkin marks"
MARKS = [KIND.encode()]
HEAD = f'{{"kind": "{KIND}", "format": {FORMAT},\n"results": ['
END = "]}"
Json = dict[str, Plain]
Record = Mapping[str, Any]  # a record as it is read
_LINE = ("format", "student", "file", "status", "reason", "score", "departure", "equations", "step", "remarks",
         "measured", "measured at", "error", "unsure")  # fmt: skip
_QUANTITY = ("given", "right", "carried", "tolerance", "verdict", "sense")
_RARE: Json = {"measured": False, "written": "", "of_mistake": False, "reversed": False, "other": ""}
"""Of a quantity what few have, with what all others have."""
_MISTAKE = ("ids", "probability", "margin", "explains")
NAME = ("id", "way", "of", "form")  # the parts of a mistake's name


def line(graded: Graded, lang: Lang = "en") -> Json:
    """The data that programs get of one submission; one that was not marked has a `reason` and no score."""
    return line_of(record(graded, lang))


def record(graded: Graded, lang: Lang = "en") -> Json:
    """All of one submission: the line's, with the arithmetic, the mistakes' places, and what was passed over."""
    marked = graded.marked
    whole: Json = {"format": FORMAT, "student": graded.student, "file": graded.file}
    if marked is None:
        reason = "" if graded.reason is None else graded.reason.message(lang)
        whole |= {"status": "not marked", "reason": reason, "score": None}
    else:
        whole |= {"status": "marked", "score": None if marked.score is None else _rounded(marked.score)}
    quantities: Json = {one.text: _quantity(one) for one in (() if marked is None else marked.judged)}
    mistakes: list[Plain] = []
    for each in () if marked is None else marked.diagnosis.explanations:
        sites = [[dict(zip(NAME, plain(name), strict=True)) for name in names] for names in each.names]
        mistakes.append({
            "ids": list(each.ids), "probability": _rounded(each.probability), "margin": _rounded(each.margin),
            "explains": list(each.explains), "names": sites,
        })  # fmt: skip
    notes = [note.message(lang) for note in graded.notes]
    whole |= {"quantities": quantities, "mistakes": mistakes, "place": graded.place, "notes": notes}
    if graded.remarks:
        remarks = [{"id": str(getattr(one, "id", "")), "text": one.message(lang)} for one in graded.remarks]
        whole["remarks"] = [*remarks]
    if marked is not None and marked.departure is not None:
        text, left, right = marked.departure.text, marked.departure.left, marked.departure.right
        whole["departure"] = {"quantity": text, "left": list(left), "right": list(right)}
    if marked is not None:
        whole |= _of_board(graded, marked)
        whole["evidence"] = {id: _rounded(weight) for id, weight in marked.diagnosis.evidence.items()}
    if marked is not None and graded.drawn:
        whole["drawn"] = {
            plane: {name: [_rounded(at.real), _rounded(at.imag)] for name, at in points.items()}
            for plane, points in graded.drawn.items()
        }
    if graded.measured is not None:
        whole |= measured_data(graded.measured)
    return whole | ({"fingerprints": list(graded.prints)} if graded.prints else {})


def _quantity(one: Judged) -> Json:
    """All of one quantity; of what few have, only what is so."""
    return {
        **{name: getattr(one, name) for name in _QUANTITY},
        "unit": one.unit, "unit_right": one.unit_right, "own": dict(one.own), "refused": list(one.refused),
        "points": one.points, "credit": one.credit,
        **{name: value for name in _RARE if (value := getattr(one, name))},
    }  # fmt: skip


def judged_of(record: Record) -> list[Judged]:
    """The quantities of a record. Raises KeyError, TypeError, ValueError where it does not hold any."""
    every = record["quantities"].items()
    lines: list[Judged] = [built(Judged, {**_RARE, **each, "text": text}) for text, each in every]
    for one in lines:
        if one.points < 0 or not 0 <= one.credit <= 1:
            raise ValueError(f"{one.text}: points {one.points}, credit {one.credit}")
    return lines


def measured_data(measured: MeasuredDrawing) -> Json:
    """All that was measured on photographs [mm from the pole, y up], at which scales, by how much it is off, what is
    unsure."""
    planes: dict[str, dict[str, Plain]] = {}
    for (plane, letter), place in measured.points.items():
        planes.setdefault(plane, {})[letter] = plain(place)
    unsure: list[Plain] = [{"plane": each.plane, "reason": each.reason, "letters": list(each.letters),
                            "off": _rounded(each.off)}
                           for each in measured.unsure]  # fmt: skip
    scales: Json = dict(measured.scales.items())
    shifts: list[Plain] = [[[plane, letter, plain(by)] for (plane, letter), by in shift.items()]
                           for shift in measured.shifts]  # fmt: skip
    known: Json = {"error": _rounded(measured.error), "unsure": unsure, "shifts": shifts}
    return {"measured": planes, "measured at": scales, **known}


def measured_of(record: Record) -> MeasuredDrawing | None:
    """The same of a record; None where there is none. Raises TypeError, ValueError, AttributeError, KeyError."""
    if "measured" not in record:
        return None
    planes = built(Mapping[Plane, Mapping[str, complex]], record["measured"])
    points = {(plane, letter): place for plane, own in planes.items() for letter, place in own.items()}
    unsure = ((built(Plane, each["plane"]), built(Unsure, each)) for each in record["unsure"])
    doubts = tuple(UnsureDrawing(NOWHERE, plane, each.reason, each.letters, each.off) for plane, each in unsure)
    scales = built(Mapping[Plane, float], record.get("measured at", {}))
    shifts = built(tuple[tuple[tuple[Plane, str, complex], ...], ...], record.get("shifts", ()))
    moves = tuple({(plane, letter): by for plane, letter, by in one} for one in shifts)
    return MeasuredDrawing(points, scales, error=built(float, record["error"]), unsure=doubts, shifts=moves)


def _of_board(graded: Graded, marked: Marked) -> Json:
    """All that there is of a drawing board: choices that are not right, the first wrong step, the board itself."""
    own: Json = {}
    if marked.faults:
        own["equations"] = plain(marked.faults)
    if marked.step is not None:
        own["step"] = plain(marked.step)
    return own | ({} if graded.board is None else {"board": work_data(graded.board)})


def _rounded(number: float) -> float:
    return float(f"{number:.6g}") + 0.0


def line_of(record: Record) -> Json:
    """The line's part of a record."""
    kept = {key: record[key] for key in _LINE if key in record}
    quantities = {
        text: {key: one[key] for key in (*_QUANTITY, "written") if key in one}
        for text, one in record["quantities"].items()
    }
    mistakes = [{key: one[key] for key in _MISTAKE} for one in record["mistakes"]]
    return {**kept, "quantities": quantities, "mistakes": mistakes}


def drawn_of(record: Record) -> dict[Plane, dict[str, complex]]:
    """The points of a drawing in a record. Raises TypeError, ValueError, AttributeError where they are none."""
    planes: dict[Plane, dict[str, complex]] = built(Mapping[Plane, Mapping[str, complex]], record.get("drawn", {}))
    return planes


def write(path: Path, lines: Iterable[str], force: bool = False) -> None:
    """The lines of records. Raises FileInTheWay, NoFolder, CannotWrite."""
    with beside(path, force, MARKS) as draft, draft.open("w", encoding="utf-8") as file:
        file.write(HEAD)
        for k, line in enumerate(lines):
            file.write((",\n" if k else "\n") + line)
        file.write(f"\n{END}\n")


def text(value: object) -> str:
    """A record as it stands in its line, in a journal and then among all."""
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def records_in(path: Path, errors: str = "strict") -> Iterator[tuple[int, Record | None]]:
    """The records of a file, each with the number of its line; None where a line is none any more.

    errors   how bytes that are no UTF-8 are read, as `open` has it
    """
    with path.open(encoding="utf-8", errors=errors) as file:
        for number, line in enumerate(file, 1):
            if line.startswith('{"format"'):
                yield number, record_of(line)


def is_marked(line: str) -> bool:
    """True of a record's line where the submission was marked: no text in it has plain quotes."""
    return '"status": "marked"' in line


def record_of(line: str) -> Record | None:
    """The record in a line; None where there is none."""
    try:
        record = json.loads(line.strip().removesuffix(","))
    except (ValueError, RecursionError):
        return None
    return record if isinstance(record, dict) else None
