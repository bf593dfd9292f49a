"""Marks as JSON: the line that programs read, one a submission, and the whole record. Version 1; SI units, radians."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from typing import Any, get_args

from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.marking.diagnosis import Explanation
from graphkin.marking.records import Graded, Judged, Marked

FORMAT = 1
Json = dict[str, Any]


def line(graded: Graded, lang: Lang = "en") -> Json:
    """What programs get of one submission; a `reason` only where it was not marked, which has no score."""
    start: Json = {"format": FORMAT, "student": graded.student, "file": graded.file}
    if graded.marked is None:
        reason = "" if graded.reason is None else graded.reason.message(lang)
        return {**start, "status": "not marked", "reason": reason, "score": None, "quantities": {}, "mistakes": []}
    return {
        **start,
        "status": "marked",
        "score": None if graded.marked.score is None else _rounded(graded.marked.score),
        "quantities": {one.text: _quantity(one) for one in graded.marked.judged},
        "mistakes": [_explanation(one) for one in graded.marked.diagnosis.explanations],
    }


def record(graded: Graded, lang: Lang = "en") -> Json:
    """All of one submission: the line's, with the arithmetic, the mistakes' places, and what was passed over."""
    whole: Json = {**line(graded, lang), "place": graded.place, "notes": [note.message(lang) for note in graded.notes]}
    prints = {"fingerprints": list(graded.prints)} if graded.prints else {}
    if graded.marked is None:
        return {**whole, **prints}
    for one in graded.marked.judged:
        whole["quantities"][one.text] |= {
            "unit": one.unit, "unit_right": one.unit_right, "own": dict(one.own), "refused": list(one.refused),
            "points": one.points, "credit": one.credit, **({"measured": True} if one.measured else {}),
        }  # fmt: skip
    for data, explanation in zip(whole["mistakes"], graded.marked.diagnosis.explanations, strict=True):
        data["names"] = [[_name(name) for name in names] for names in explanation.names]
    return {**whole, "evidence": _evidence(graded.marked), **_drawn(graded), **prints}


def line_of(record: Mapping[str, Any]) -> Json:
    """The line's part of a record."""
    told = {key: record[key] for key in _LINE if key in record}
    quantities = {text: {key: one[key] for key in _QUANTITY} for text, one in record["quantities"].items()}
    mistakes = [{key: one[key] for key in _MISTAKE} for one in record["mistakes"]]
    return {**told, "quantities": quantities, "mistakes": mistakes}


_LINE = ("format", "student", "file", "status", "reason", "score")
_QUANTITY = ("given", "right", "carried", "tolerance", "verdict", "sense")
_MISTAKE = ("ids", "probability", "margin", "explains")


def drawn_of(record: Mapping[str, Any]) -> dict[Plane, dict[str, complex]]:
    """The points of a drawing in a record. Raises TypeError, ValueError, AttributeError where they are none."""
    found: dict[Plane, dict[str, complex]] = {}
    for plane, points in record.get("drawn", {}).items():
        if plane not in get_args(Plane):
            raise ValueError(f"{plane!r} is no plane")
        found[plane] = {str(name): complex(float(x), float(y)) for name, (x, y) in points.items()}
        if not all(map(cmath.isfinite, found[plane].values())):
            raise ValueError(f"drawn: {plane}")
    return found


def _drawn(graded: Graded) -> Json:
    """Only where a drawing was handed in."""
    planes = {
        plane: {name: [_rounded(at.real), _rounded(at.imag)] for name, at in points.items()}
        for plane, points in graded.drawn.items()
    }
    return {"drawn": planes} if planes else {}


def _quantity(one: Judged) -> Json:
    return {
        "given": one.given, "right": one.right, "carried": one.carried, "tolerance": one.tolerance,
        "verdict": one.verdict, "sense": one.sense,
    }  # fmt: skip


def _explanation(one: Explanation) -> Json:
    return {
        "ids": list(one.ids),
        "probability": _rounded(one.probability),
        "margin": _rounded(one.margin),
        "explains": list(one.explains),
    }


def _name(name: tuple[str, str, str, str]) -> Mapping[str, str]:
    return dict(zip(("id", "way", "of", "form"), name, strict=True))


def _evidence(marked: Marked) -> dict[str, float]:
    return {id: _rounded(weight) for id, weight in marked.diagnosis.evidence.items()}


def _rounded(number: float) -> float:
    return float(f"{number:.6g}") + 0.0
