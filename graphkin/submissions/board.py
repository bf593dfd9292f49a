"""The metadata of a drawing board's file: what was filled in, and every act of the pencil in its order."""

from __future__ import annotations

import cmath
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import cast, get_args
from xml.etree.ElementTree import Element

from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import BrokenBoard, ForeignBoard, GraphkinError, Where
from graphkin.files import loads
from graphkin.model.mechanism import Mechanism
from graphkin.submissions.documents import StudentDocument
from graphkin.submissions.submission import BoardStep, BoardWork, FilledTerm, Limits
from graphkin.submissions.svg import BOARD, xml_root

KIND, FORMAT = "graphkin board", 1
_STEPS, _TERMS, _LONGEST = 5_000, 1_000, 200  # so many at most, and letters in a name
_LARGEST = 1e6  # no paper is so large [mm]
_ANGLE = re.compile(r"[-−+]?\d{1,4}([.,]\d{0,9})?°?")


@frozen
class HandedBoard:
    """All that the metadata says; mechanism: the text of the file that the page was made of."""

    document: StudentDocument
    work: BoardWork
    mechanism: str

    def refuse_foreign(self, mechanism: Mechanism, where: Where) -> None:
        """Raises BrokenBoard, ForeignBoard of a board that another problem was drawn on."""
        try:
            own = loads(self.mechanism, name=mechanism.name)
        except GraphkinError as problem:
            raise BrokenBoard(where, f"problem: {problem.message('en')}"[:_LONGEST]) from None
        parts = ("links", "pairs", "drivers")
        if any(getattr(own, part) != getattr(mechanism, part) for part in parts):
            raise ForeignBoard(where)


def board_in(content: bytes, where: Where, limits: Limits) -> HandedBoard | None:
    """The board whose drawing an SVG file is; None of any other drawing. Raises BrokenSubmission, BrokenBoard."""
    if BOARD.encode() not in content:
        return None
    root = xml_root(content, where, "SVG", limits)
    element = next((each for each in root.iter() if each.attrib.get("id") == BOARD), None)
    if element is None:
        return None
    try:
        return _board(_data(element), where)
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError, RecursionError) as problem:
        raise BrokenBoard(where, f"{type(problem).__name__}: {problem}"[:_LONGEST]) from None


def _data(element: Element) -> Mapping[str, object]:
    data = json.loads("".join(element.itertext()))
    if not isinstance(data, dict) or data.get("kind") != KIND:
        raise ValueError("kind")
    if data.get("format") != FORMAT:
        raise ValueError(f"format {data.get('format')!r}, not {FORMAT}")
    return data


def work_data(work: BoardWork) -> dict[str, Plain]:
    """The work as plain data, in the words of the file."""
    equations: dict[tuple[str, int], list[Plain]] = {}
    for one in work.equations:
        term: Plain = {"term": one.term, "direction": one.direction, "magnitude": one.magnitude}
        equations.setdefault((one.plane, one.equation), []).append(term)
    steps: list[Plain] = []
    for step in work.steps:
        words = {key: text for key in ("name", "through", "line") if (text := getattr(step, key))}
        places: list[Plain] = [[at.real, at.imag] for at in step.at]
        steps.append({"step": step.number, "plane": step.plane, "tool": step.tool, "at": places, **words})
    filled: list[Plain] = [{"plane": plane, "equation": n, "terms": terms} for (plane, n), terms in equations.items()]
    return {"scales": {str(plane): scale for plane, scale in work.scales.items()}, "equations": filled, "steps": steps}


def work_of(data: Mapping[str, object]) -> BoardWork:
    """Plain data as the work it is. Raises KeyError, TypeError, ValueError where it is none."""
    scales = _mapping(data.get("scales", {}))
    sized = {_plane(key): float(cast(float, value)) for key, value in scales.items() if value is not None}
    if not all(1e-12 < value < 1e12 for value in sized.values()):
        raise ValueError("scales")
    return BoardWork(tuple(_filled(data)), tuple(_steps(data)), sized)


def _filled(data: Mapping[str, object]) -> Iterator[FilledTerm]:
    for equation in map(_mapping, _list(data.get("equations", []), _TERMS, "equations")):
        plane, number = _plane(equation["plane"]), int(cast(int, equation["equation"]))
        for term in map(_mapping, _list(equation["terms"], _TERMS, "terms")):
            name, *choices = (_text(term.get(key)) for key in ("term", "direction", "magnitude"))
            yield FilledTerm(plane, number, name, *choices)


def _steps(data: Mapping[str, object]) -> Iterator[BoardStep]:
    for count, step in enumerate(map(_mapping, _list(data.get("steps", []), _STEPS, "steps")), 1):
        places = tuple(complex(*map(float, cast(Sequence[float], at))) for at in _list(step.get("at", []), 10, "at"))
        if not all(cmath.isfinite(at) and abs(at) < _LARGEST for at in places):
            raise ValueError(f"step {count}: at")
        names = (_text(step.get(key)) for key in ("name", "through", "line"))
        yield BoardStep(count, _plane(step["plane"]), _text(step["tool"]), places, *names)


def _board(data: Mapping[str, object], where: Where) -> HandedBoard:
    """The metadata taken apart; whatever is not as it should be raises."""
    problem = _mapping(data["problem"])
    entries = []
    for name, answer in _mapping(data.get("answers", {})).items():
        parts = {"value": answer} if isinstance(answer, str) else _mapping(answer)
        if _text(parts.get("value")).strip():
            own: dict[str, object] = {key: _text(part) for key, part in parts.items()}
            sense = _text(parts.get("sense")).strip()
            if _ANGLE.fullmatch(sense):  # of a vector, to +x
                degrees = sense.rstrip("°").replace(",", ".").replace("−", "-")
                own |= {"sense": "", "direction": float(degrees)}
            entries.append((_text(name), own, Where(where.file, None, _text(name))))
    student = _text(problem.get("student")).strip()
    document = StudentDocument((student,) if student else (), tuple(entries))
    text = problem["mechanism"]
    if not isinstance(text, str):
        raise ValueError("problem: mechanism")
    return HandedBoard(document, work_of(data), text)


def _mapping(value: object) -> Mapping[str, object]:
    if not isinstance(value, dict):
        raise TypeError(f"{value!r}"[:60])
    return value


def _list(value: object, most: int, name: str) -> Sequence[object]:
    if not isinstance(value, list) or len(value) > most:
        raise ValueError(name)
    return value


def _text(value: object) -> str:
    if value is None:
        return ""
    if not isinstance(value, str | int | float) or isinstance(value, bool):
        raise TypeError(f"{value!r}"[:60])
    return str(value)[:_LONGEST]


def _plane(value: object) -> Plane:
    if value not in get_args(Plane):
        raise ValueError(f"plane {value!r}"[:60])
    return cast(Plane, value)
