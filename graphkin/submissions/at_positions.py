"""Which of a problem's positions an answer, or a drawing, is for.

`omega 3 #2` in any table or file is omega 3 at the second position, and so is `omega 3 @ 120` where the driver stands
at 120 there; of the drawn position, which is the first, nothing need be said. A drawing is for the drawn position, or
for the one at the end of its file's name: `drawing #2.svg`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from pathlib import PurePosixPath

from graphkin.errors import NotAQuestion
from graphkin.model.mechanism import Driver
from graphkin.model.quantities import at_position, position_of
from graphkin.submissions import scales
from graphkin.submissions.answers import Answers, Entry, answers
from graphkin.submissions.questions import Questions
from graphkin.submissions.spelling import plain, short
from graphkin.submissions.submission import HandedValue, Limits, ReadableProblem

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
        if scales.plane_named(name) is not None:
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
