"""A problem in words: what is given, off the student's own mechanism file, what is asked, and how to hand it in."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, assert_never

from graphkin.errors import Lang
from graphkin.files.names import split_points
from graphkin.marking.answers import asked_of
from graphkin.model.mechanism import Driver, Mechanism
from graphkin.model.quantities import (
    Centre,
    Component,
    Displacement,
    Moving,
    Place,
    Quantity,
    Quotient,
    Rotation,
    Track,
)
from graphkin.model.quantities.at_position import at_position
from graphkin.model.quantities.reading import read
from graphkin.model.quantities.units import EDGE
from graphkin.running.assembled import DrawnSides
from graphkin.say import names
from graphkin.say.assembly import assembly
from graphkin.say.catalogue import is_phrase, say


def problem(
    mechanism: Mechanism, student: str, others: Sequence[str], points: Mapping[str, float], lang: Lang,
    drawn: DrawnSides | None = None, figure: str = "", there: bool = True,
) -> str:  # fmt: skip
    """The text of one student's problem.

    others  what else the student is called; points: by question, else 1
    drawn   in which assembly; figure: the file that shows it, `there` or in another position
    """
    called = " ".join((student, *others))
    lines = [say("problems.student", lang, student=called), *statement(mechanism, lang, drawn)]
    lines += [say(f"problems.figure {'drawn' if there else 'elsewhere'}", lang, file=figure)] if figure else []
    lines += ["", say("problems.find", lang)]
    marked = asked_of(mechanism)
    for question in mechanism.ask:
        worth = _worth(points.get(question, 1.0), lang) if question in marked else ""
        quantity = read(mechanism, question)
        lines.append(f"  {_asked(question, quantity)}{worth}{_measured(mechanism, quantity, lang)}")
    lines += ["", say("problems.hand in", lang), "", f"  student = {_quoted(student)}", "  [answers]"]
    count = 1 + positions(mechanism)
    lines += [f"  {_quoted(at_position(question, at))} = " for at in range(1, count + 1) for question in marked]
    lines += ["", say("problems.drawing of position", lang)] if count > 1 else []
    return "\n".join(lines) + f"\n\n{MADE}\n"


def statement(mechanism: Mechanism, lang: Lang, drawn: DrawnSides | None = None) -> Iterator[str]:
    """The mechanism and what is given of it, in lines; with the assembly it is drawn in."""
    yield from (mechanism.headline(lang), "", say("problems.given", lang))
    yield from (f"  {line}" for line in _given(tomllib.loads(mechanism.text), lang))
    if drawn is not None and (told := assembly(drawn, lang)):
        yield f"  {told}"
    yield from _positions(mechanism, lang)


def positions(mechanism: Mechanism) -> int:
    """How many further ones are asked for."""
    return max((len(driver.also) for driver in mechanism.drivers), default=0)


def _positions(mechanism: Mechanism, lang: Lang) -> Iterator[str]:
    """Where the drivers stand at each, by its number."""
    if not positions(mechanism):
        return
    yield ""
    yield say("problems.positions", lang)
    for at in range(positions(mechanism) + 1):
        values = ((driver, _value_at(driver, at)) for driver in mechanism.drivers)
        told = [f"{names.point(driver.name)} = {_driven(driver, x)}" for driver, x in values if x is not None]
        told = told or [say("problems.as given", lang)]
        yield f"  #{at + 1}{say('common.colon', lang)}{say('common.list', lang).join(told)}"


def _value_at(driver: Driver, at: int) -> float | None:
    return driver.also[at - 1] if 0 < at <= len(driver.also) else driver.value


def _driven(driver: Driver, value: float) -> str:
    """`120°`, `25 mm`."""
    return f"{value * 1000:.6g} mm" if driver.kind == "slide" else f"{math.degrees(value):.6g}°"


def remark(shared: Sequence[str], lang: Lang) -> str:
    """That students have problems much alike."""
    few = say("common.and", lang).join(shared[:10]) + (" .." if len(shared) > 10 else "")
    return say("problems.shared", lang, count=len(shared), students=few)


MADE = "-- graphkin problems"
"""The last line of a text that this program wrote."""


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _worth(points: float, lang: Lang) -> str:
    return say("problems.points one" if points == 1 else "problems.points many", lang, points=points)


def _asked(question: str, quantity: Quantity | None) -> str:
    """`ω3 [rad/s]`, `aᵏ_B3B2 [m/s²]`."""
    if quantity is None:
        return question
    sign = EDGE[quantity.unit].sign
    unit = f" [{sign}]" if sign else ""
    return _symbol(quantity) + unit


def _symbol(quantity: Quantity) -> str:
    """`ω3`, `aᵏ_B3B2`, `v_E,y`, `P13`."""
    match quantity:
        case Centre():
            return quantity.text
        case Component():
            return f"{_symbol(quantity.whole)},{quantity.axis}"
        case Quotient():
            return f"{_symbol(quantity.top)} / {_symbol(quantity.bottom)}"
        case Rotation() | Displacement():
            return names.of_link(quantity.letter, quantity.of)
        case Moving() | Place() | Track():
            part = f"^{quantity.part}" if quantity.part else ""
            return names.vector(f"{quantity.letter}{part}_{quantity.of}")
        case _:
            assert_never(quantity)


def _measured(mechanism: Mechanism, quantity: Quantity | None, lang: Lang) -> str:
    """Along which line of its link an angle is measured, of all in what is asked."""
    parts = () if quantity is None else quantity.halves
    told = (_line(mechanism, part, lang) for part in parts if isinstance(part, Rotation) and part.word == "theta")
    return "".join(dict.fromkeys(told))


def _line(mechanism: Mechanism, angle: Rotation, lang: Lang) -> str:
    """From the link's first point to its next; of a block or a cylinder, which has one, along its guide."""
    symbol = _symbol(angle)
    if (axis := mechanism.links[angle.link].axis) is not None:
        tail, head = map(names.point, axis)
        return say("problems.angle", lang, angle=symbol, tail=tail, head=head)
    slide = next((slide for slide in mechanism.slides if angle.link in (slide.block, slide.guide)), None)
    if slide is None:
        return ""
    return say("problems.angle of guide", lang, angle=symbol, guide=mechanism.called(slide.guide))


# --- what is given ----------------------------------------------------------------------------


def _given(document: dict[str, Any], lang: Lang) -> Iterator[str]:
    """A line a link, pair and driver, in the file's order."""
    for table, content in document.items():
        if not is_phrase(f"problems.table {table}"):
            continue
        rows = content.items() if table == "links" else [("", row) for row in _rows(content)]
        for name, row in rows:
            head = say(f"problems.table {table}", lang) + (f" {name}" if name else "")
            told = say("common.and", lang).join(_told(key, value, lang) for key, value in _named(row, lang).items())
            yield f"{head}{say('common.colon', lang)}{told}"


def _named(row: dict[str, Any], lang: Lang) -> dict[str, Any]:
    """With what a sliding pair is called behind its name, in this language."""
    title, rest = row.get("title"), {key: value for key, value in row.items() if key != "title"}
    called = title.get(lang) or next(iter(title.values()), "") if isinstance(title, dict) else title
    if not called or called == row.get("name"):
        return rest
    return {**rest, "name": f"{row['name']} ({called})"} if "name" in row else {"name": called, **rest}


def _rows(content: Any) -> list[Any]:
    return content if isinstance(content, list) else [content]


def _told(key: str, value: object, lang: Lang) -> str:
    if is_phrase(f"problems.key {key}"):
        return f"{say(f'problems.key {key}', lang)} = {_shown(value, lang)}"
    angle = "∠" if len(split_points(key)) == len(("tail", "corner", "head")) else ""
    return f"{angle}{names.point(key)} = {_shown(value, lang)}"


def _shown(value: object, lang: Lang) -> str:
    match value:
        case bool():
            return str(value).lower()
        case dict():
            return "(" + say("common.and", lang).join(_told(key, inner, lang) for key, inner in value.items()) + ")"
        case list():
            return "(" + ", ".join(_shown(inner, lang) for inner in value) + ")"
        case "frame":
            return say("problems.the frame", lang)
        case _:
            return str(value)
