"""Answers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import PurePosixPath

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import (
    NOWHERE,
    AnsweredTwice,
    GraphkinError,
    NoPaperScale,
    NotAnAnswer,
    NotAQuestion,
    OutOfRange,
    TooMuch,
    Where,
    WrongType,
)
from graphkin.model.mechanism import Driver
from graphkin.model.quantities import Centre, Moving, Quantity, at_position, position_of
from graphkin.submissions import numbers
from graphkin.submissions.numbers import given, plain, short
from graphkin.submissions.questions import Questions
from graphkin.submissions.submission import HandedValue, Limits, ReadableProblem

Entry = tuple[str, object, Where]
"""What an answer is called, what is given, and where it stands."""

_NOTHING = {"", "-", "--", "---", "/", "\\", "?", "n/a", "na", "none", "null", "无", "空", "未答", "未作答"}


@frozen
class Answers:
    """The values by question, the scales stated beside them, and what was passed over."""

    values: Mapping[str, HandedValue]
    scales: Mapping[Plane, float]
    notes: tuple[GraphkinError, ...]


def answers(entries: Iterable[Entry], questions: Questions, limits: Limits) -> Answers:
    """Raises TooMuch; whatever is wrong with one answer is in that answer or in the notes."""
    found: dict[str, HandedValue] = {}
    notes: list[GraphkinError] = []
    stated: dict[Plane, float] = {}
    rest: list[Entry] = []
    for count, (name, raw, where) in enumerate(entries):
        if count >= limits.answers:
            raise TooMuch(Where(where.file), "answers", limits.answers)
        if (plane := numbers.plane_named(name)) is None:
            rest.append((name, raw, where))
        elif not _nothing(raw):
            _state(stated, notes, plane, raw, where)
    known = numbers.stated_by(questions.mechanism) | stated
    for name, raw, where in rest:
        if _nothing(raw):
            continue
        if (read := questions.read(name)) is None:
            notes.append(NotAQuestion(where, short(name), tuple(questions.asked.values())))
            continue
        question, quantity, unit = read
        value = _placed(_value(raw, quantity, unit, known), where)
        found[question] = _joined(found[question], value, question) if question in found else value
    return Answers(found, stated, tuple(notes))


def _state(
    stated: dict[Plane, float], notes: list[GraphkinError], plane: Plane, raw: object, where: Where
) -> None:
    try:
        stated[plane] = numbers.scale(raw, plane)
    except GraphkinError as fault:
        notes.append(fault.at(where))


def _nothing(raw: object) -> bool:
    return raw is None or (isinstance(raw, str) and plain(raw).lower() in _NOTHING)


def _placed(value: HandedValue, where: Where) -> HandedValue:
    return replace(value, where=where, fault=value.fault and value.fault.at(where))


def _joined(first: HandedValue, second: HandedValue, question: str) -> HandedValue:
    """Two answers to one question: one where they say the same, else none."""
    if first.value is None or second.value is None:
        return first if second.value is None else second
    if math.isclose(first.value, second.value, rel_tol=1e-9) and first.sense in (None, second.sense):
        return second
    fault = AnsweredTwice(second.where, question, first.text[:60], second.text[:60])
    return replace(first, value=None, vector=None, fault=fault)


# --- one value --------------------------------------------------------------------------------


def _value(raw: object, quantity: Quantity, unit: str, stated: Mapping[Plane, float]) -> HandedValue:
    match raw:
        case bool():
            return HandedValue(str(raw).lower(), None, fault=NotAnAnswer(NOWHERE, str(raw).lower()))
        case int() | float():
            return _number(raw, quantity, unit)
        case str():
            return _text(raw, quantity, unit, stated)
        case {"value": inner, **more} if not isinstance(inner, dict | list):
            parts = [str(part) for part in (inner, more.get("unit", ""), more.get("sense", "")) if part is not None]
            return _text(" ".join(parts), quantity, unit, stated)
        case [x, y]:
            return _pair(x, y, quantity, unit)
        case _:
            return HandedValue("", None, fault=WrongType(NOWHERE, "quantity", type(raw).__name__))


def _number(raw: float, quantity: Quantity, unit: str) -> HandedValue:
    """A bare number; one too long to be printed is none."""
    try:
        shown = repr(float(raw)) if isinstance(raw, float) else str(raw) if abs(raw) < 10**30 else "1e999"
    except OverflowError:
        shown = "1e999"
    if not math.isfinite(float(shown)):
        return HandedValue(shown, None, fault=OutOfRange(NOWHERE, shown))
    return replace(given(shown, quantity.unit, unit), text=shown)


def _text(raw: str, quantity: Quantity, unit: str, stated: Mapping[Plane, float]) -> HandedValue:
    text = raw.strip()[:400]
    if isinstance(quantity, Centre | Moving) and (pair := _two(text)) is not None:
        return replace(_pair(*pair, quantity, unit), text=text)
    found = given(text, quantity.unit, unit)
    plane = numbers.plane_of(quantity.unit)
    if plane is None or found.unit not in numbers.PAPER or found.value is None:
        return found
    mm = found.value * numbers.PAPER[found.unit]
    if plane not in stated:
        fault = NoPaperScale(NOWHERE, text[:60], plane)
        return HandedValue(text, None, None, found.unit, fault, paper_mm=mm)
    return HandedValue(text, mm * stated[plane], None, found.unit, paper_mm=mm)


def _two(text: str) -> tuple[str, str] | None:
    """`(12.3, 40.5) mm`: two numbers in brackets; `;` between decimal commas."""
    made = plain(text)
    if not made.startswith(("(", "[")):
        return None
    inner, close, unit = made[1:].partition(")" if made[0] == "(" else "]")
    parts = inner.split(";") if ";" in inner else inner.split(",")
    return (f"{parts[0]} {unit}", f"{parts[1]} {unit}") if close and len(parts) == 2 else None


def _pair(x: object, y: object, quantity: Quantity, unit: str) -> HandedValue:
    """A place or a vector by its components."""
    if not isinstance(quantity, Centre | Moving):
        return HandedValue(f"{x}, {y}"[:60], None, fault=WrongType(NOWHERE, "quantity", "[ .. ]"))
    halves = [given(str(half), quantity.unit, unit) for half in (x, y)]
    text = ", ".join(half.text[:60] for half in halves)
    if (fault := next((half.fault for half in halves if half.value is None), None)) is not None:
        return HandedValue(text, None, fault=fault)
    vector = complex(*(half.value or 0.0 for half in halves))
    return HandedValue(text, abs(vector), None, halves[0].unit, halves[0].fault, vector=vector)


_VALUE = re.compile(r"(?<=\s)@\s*(-?[0-9]+(?:[.,][0-9]+)?) ?(?:deg|°|mm)?(?![\w.])")
_NEAR = 0.05
"""A driver's value that is typed may be off by so much [deg, mm]."""


def answers_at(
    entries: Iterable[Entry], asked: ReadableProblem, questions: Callable[[ReadableProblem], Questions], limits: Limits
) -> Answers:
    """The values of every position under its names; scales hold at all of them. Raises TooMuch."""
    if not asked.further:
        return answers(entries, questions(asked), limits)
    shared, sorted_out, strange = _sorted(entries, asked)
    each = zip(asked.positions, sorted_out, strict=True)
    parts = [answers([*shared, *some], questions(one), limits) for one, some in each]
    values = {name: given for at, part in enumerate(parts, 1) for name, given in named_at(part.values, at).items()}
    notes = {note.message("en"): note for part in parts for note in part.notes}
    lost = (NotAQuestion(where, short(name), tuple(asked.questions)) for name, _, where in strange)
    return Answers(values, parts[0].scales, (*notes.values(), *lost))


def named_at(values: Mapping[str, HandedValue], at: int) -> dict[str, HandedValue]:
    """Under the names that they have among those of all positions."""
    return {at_position(name, at): given for name, given in values.items()}


def of_file(name: str, asked: ReadableProblem) -> tuple[ReadableProblem, int]:
    """What a drawing shows, and the number of the position, by the name of its file."""
    at = position_of(PurePosixPath(name).stem)[1]
    return (asked.positions[at - 1], at) if at <= len(asked.positions) else (asked, 1)


def _sorted(entries: Iterable[Entry], asked: ReadableProblem) -> tuple[list[Entry], list[list[Entry]], list[Entry]]:
    """Scales, the answers of each position under their bare names, and those of no position."""
    shared: list[Entry] = []
    found: list[list[Entry]] = [[] for _ in asked.positions]
    strange: list[Entry] = []
    for name, raw, where in entries:
        if numbers.plane_named(name) is not None:
            shared.append((name, raw, where))
            continue
        bare, at = _position(name, asked)
        if 0 < at <= len(found):
            found[at - 1].append((bare, raw, where))
        else:
            strange.append((name, raw, where))
    return shared, found, strange


def _position(name: str, asked: ReadableProblem) -> tuple[str, int]:
    """The bare name and the number of the position; 0 for one that there is not."""
    text = plain(name[:200])
    if (value := _VALUE.search(text)) is None:
        return position_of(name)
    bare = f"{text[: value.start()].rstrip()} {text[value.end() :].lstrip()}".strip()
    return bare, _at_value(float(value[1].replace(",", ".")), asked)


def _at_value(typed: float, asked: ReadableProblem) -> int:
    """The position at which a driver that is moved on stands so; 0 where none does."""
    for driver in asked.mechanism.drivers:
        if driver.also:
            for number, value in enumerate((driver.value, *driver.also), 1):
                if value is not None and _off(driver, value, typed) <= _NEAR:
                    return number
    return 0


def _off(driver: Driver, value: float, typed: float) -> float:
    """In deg, but for whole turns, or mm."""
    if driver.kind == "slide":
        return abs(value * 1000 - typed)
    return abs(math.remainder(math.degrees(value) - typed, 360.0))
