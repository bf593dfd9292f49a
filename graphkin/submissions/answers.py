"""From names and what stands beside them to values in SI: scales first, then every answer, at each position.

`omega 3 #2` in any table or file is omega 3 at the second position, and so is `omega 3 @ 120` where the driver stands
at 120 there; of the drawn position, which is the first, nothing need be said. A drawing is for the drawn position, or
for the one at the end of its file's name: `drawing #2.svg`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import PurePosixPath

from graphkin import errors
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import NOWHERE, GraphkinError, Where
from graphkin.files.values import short_number
from graphkin.model.quantities import Centre, Component, Moving, Quantity, at_position, position_of
from graphkin.submissions import numbers
from graphkin.submissions.grammar import parsed_value, simple
from graphkin.submissions.numbers import plain, short
from graphkin.submissions.questions import Questions
from graphkin.submissions.submission import HandedValue, Limits, ReadableProblem

Entry = tuple[str, object, Where]  # the name of an answer, its value as it stands there, and where

_NOTHING = {
    "", "/", "\\", "n/a", "na", "none", "null", "无", "空", "未答", "未作答",
    "不会", "不知道", "?", "idk", "i do not know", "i don't know", "don't know",
}  # fmt: skip
_DRIVER_VALUE = re.compile(r"(?<=\s)@\s*(-?[0-9]+(?:[.,][0-9]+)?) ?(?:deg|°|mm)?(?![\w.])")
_BRACKETS = re.compile(r"[(\[](?:([^;)\]]+);([^;)\]]+)|([^,;)\]]+),([^,;)\]]+))[)\]](.*)")
"""`(12.3, 40.5) mm`: a place; `;` between decimal commas."""
_NEAR = 0.05  # a driver's value that is typed may be off by so much [deg, mm]


@frozen
class Answers:
    """The values by question, the scales stated beside them, and what was passed over."""

    values: Mapping[str, HandedValue]
    scales: Mapping[Plane, float]
    notes: tuple[GraphkinError, ...]


def answers(entries: Iterable[Entry], questions: Questions, limits: Limits) -> Answers:
    """Raises TooMuch; whatever is wrong with one answer is in that answer or in the notes."""
    values: dict[str, HandedValue] = {}
    notes: list[GraphkinError] = []
    stated: dict[Plane, float] = {}
    rest: list[Entry] = []
    for count, (name, raw, where) in enumerate(entries):
        limits.check(Where(where.file), "answers", count + 1)
        if (plane := numbers.plane_named(name)) is None:
            rest.append((name, raw, where))
        elif not _is_nothing(raw):
            try:
                stated[plane] = numbers.scale(raw, plane)
            except GraphkinError as fault:
                notes.append(fault.at(where))
    scales = numbers.stated_by(questions.mechanism) | stated
    for name, raw, where in rest:
        if _is_nothing(raw):
            continue
        if (read := questions.read(name)) is None:
            notes.append(errors.NotAQuestion(where, short(name), tuple(questions.asked.values())))
            continue
        question, quantity, unit = read
        value = _value(raw, quantity, unit, scales)
        if value.fault is not None:
            of_kind = {"unit": quantity.unit} if isinstance(value.fault, errors.NotAnAnswer) else {}
            value = replace(value, fault=value.fault.at(where, **of_kind))
        first = values.get(question)
        if first is None or first.value is None:  # of two answers one where they say the same, else none
            values[question] = value if first is None or value.value is not None else first
        elif value.value is not None:
            same = math.isclose(first.value, value.value, rel_tol=1e-9) and first.sense in (None, value.sense)
            twice = errors.AnsweredTwice(where, question, first.text[:60], value.text[:60])
            both = f"{first.text}; {value.text}"
            values[question] = value if same else replace(first, text=both, value=None, vector=None, fault=twice)
    return Answers(values, stated, tuple(notes))


def _is_nothing(raw: object) -> bool:
    """Nothing, or a dash, a unit beside it or not, as in an answer table that was not filled in."""
    if not isinstance(raw, str):
        return raw is None
    if simple(raw) is not None:
        return False
    text = plain(raw).lower()
    bare = text.strip("-_. ")
    return bare in _NOTHING or (bare != text and numbers.is_unit(bare))


def _value(raw: object, quantity: Quantity, unit: str, scales: Mapping[Plane, float]) -> HandedValue:
    match raw:
        case bool():
            return HandedValue(str(raw).lower(), None, fault=errors.NotAnAnswer(NOWHERE, str(raw).lower()))
        case int() | float():
            shown = str(raw) if abs(raw) < 1e30 else short_number(raw)
            if not math.isfinite(float(shown)):
                return HandedValue(shown, None, fault=errors.OutOfRange(NOWHERE, shown))
            return parsed_value(shown, quantity.unit, unit)
        case str():
            return _text(raw, quantity, unit, scales)
        case {"value": inner, **more} if not isinstance(inner, dict | list):
            way = more.get("direction", "")
            beside = (more.get("unit", ""), more.get("sense", ""), f"∠ {way}" if isinstance(way, int | float) else way)
            parts = [str(part) for part in (inner, *beside) if part is not None]
            return _text(" ".join(parts), quantity, unit, scales)
        case [x, y]:
            return _pair(x, y, quantity, unit)
        case _:
            return HandedValue(str(raw)[:60], None, fault=errors.WrongType(NOWHERE, "quantity", type(raw).__name__))


def _text(raw: str, quantity: Quantity, unit: str, scales: Mapping[Plane, float]) -> HandedValue:
    text = raw.strip()[:400]
    if isinstance(quantity, Centre) and (pair := _BRACKETS.fullmatch(plain(text))) is not None:
        one, other, after = (part for part in pair.groups() if part is not None)
        return replace(_pair(f"{one} {after}", f"{other} {after}", quantity, unit), text=text)
    axis = quantity.axis if isinstance(quantity, Component) else ""
    value = parsed_value(text, quantity.unit, unit, bool(axis) or isinstance(quantity, Moving), axis)
    if isinstance(quantity, Component) and value.vector is not None:  # its sign in a word
        part = value.vector.real if quantity.axis == "x" else value.vector.imag
        along = math.isclose(abs(part), abs(value.value or 0.0), rel_tol=1e-9)
        doubt = None if along else errors.NotAnAnswer(NOWHERE, text)
        value = replace(value, value=part if along else None, vector=None, within=0.0, fault=value.fault or doubt)
    plane = numbers.PLANES.get(quantity.unit)
    if plane is None or value.unit not in numbers.PAPER or value.value is None:
        return value
    mm = value.value * numbers.PAPER[value.unit]
    if plane not in scales:
        return HandedValue(text, None, None, value.unit, errors.NoPaperScale(NOWHERE, text[:60], plane))
    vector = None if value.vector is None else value.vector / value.value * mm * scales[plane]
    return replace(value, value=mm * scales[plane], sense=None, fault=None, vector=vector)


def _pair(x: object, y: object, quantity: Quantity, unit: str) -> HandedValue:
    """A place or a vector by its components."""
    if not isinstance(quantity, Centre | Moving):
        return HandedValue(f"{x}, {y}"[:60], None, fault=errors.WrongType(NOWHERE, "quantity", "[ .. ]"))
    halves = [parsed_value(str(half), quantity.unit, unit, False) for half in (x, y)]
    text = ", ".join(half.text[:60] for half in halves)
    if (fault := next((half.fault for half in halves if half.value is None), None)) is not None:
        return HandedValue(text, None, fault=fault)
    vector = complex(*(half.value or 0.0 for half in halves))
    return HandedValue(text, abs(vector), None, halves[0].unit, halves[0].fault, vector=vector)


def answers_at(
    entries: Iterable[Entry], asked: ReadableProblem, questions: Callable[[ReadableProblem], Questions], limits: Limits
) -> Answers:
    """The values of every position under its names; scales hold at all of them. Raises TooMuch."""
    if not asked.further:
        return answers(entries, questions(asked), limits)
    shared: list[Entry] = []  # scales
    by_position: list[list[Entry]] = [[] for _ in asked.positions]
    strange: list[Entry] = []
    for entry in entries:
        if numbers.plane_named(entry[0]) is not None:
            shared.append(entry)
            continue
        bare, at = _position(entry[0], asked)
        if 0 < at <= len(by_position):
            by_position[at - 1].append((bare, *entry[1:]))
        else:
            strange.append(entry)
    each = zip(asked.positions, by_position, strict=True)
    parts = [answers([*shared, *some], questions(one), limits) for one, some in each]
    values = {name: value for at, part in enumerate(parts, 1) for name, value in named_at(part.values, at).items()}
    notes = {note.message("en"): note for part in parts for note in part.notes}
    lost = (errors.NotAQuestion(where, short(name), tuple(asked.questions)) for name, _, where in strange)
    return Answers(values, parts[0].scales, (*notes.values(), *lost))


def named_at(values: Mapping[str, HandedValue], at: int) -> dict[str, HandedValue]:
    """Under the names that they have among those of all positions."""
    return {at_position(name, at): value for name, value in values.items()}


def of_file(name: str, asked: ReadableProblem) -> tuple[ReadableProblem, int]:
    """The problem that a drawing shows, and the number of the position, by the name of its file."""
    at = position_of(PurePosixPath(name).stem)[1]
    return (asked.positions[at - 1], at) if at <= len(asked.positions) else (asked, 1)


def _position(name: str, asked: ReadableProblem) -> tuple[str, int]:
    """The bare name and the number of the position; 0 for one that there is not."""
    text = plain(name[:200])
    if (match := _DRIVER_VALUE.search(text)) is None:
        return position_of(name)
    bare = f"{text[: match.start()].rstrip()} {text[match.end() :].lstrip()}".strip()
    typed = float(match[1].replace(",", "."))
    for driver in asked.mechanism.drivers:
        for number, value in enumerate((driver.value, *driver.also) if driver.also else (), 1):
            if value is None:
                continue
            turn = driver.kind != "slide"  # of an angle whole turns do not count
            off = math.remainder(math.degrees(value) - typed, 360.0) if turn else value * 1000 - typed
            if abs(off) <= _NEAR:
                return bare, number
    return bare, 0
