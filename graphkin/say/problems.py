"""A problem in words: the data of the student's own mechanism file, what is asked, and how to hand it in."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import assert_never

from graphkin.errors import Lang
from graphkin.files.values import split_points
from graphkin.marking.answers import asked_of
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Quantity
from graphkin.model.quantities.kinds import Centre, Component, Displacement, Moving, Place, Quotient, Rotation, Track
from graphkin.model.quantities.reading import at_position, read
from graphkin.model.units import EDGE
from graphkin.running.drawn_sides import DrawnSides
from graphkin.say import names
from graphkin.say.catalogue import is_phrase, say

MADE = "-- graphkin problems"  # the last line of a text that this program wrote


def problem(
    mechanism: Mechanism, student: str, others: Sequence[str], lang: Lang, drawn: DrawnSides | None = None,
    figure: str = "", there: bool = True,
) -> str:  # fmt: skip
    """The text of one student's problem.

    others  what else the student is called
    drawn   in which assembly; figure: the file that shows it, `there` or in another position
    """
    called = " ".join((student, *others))
    lines = [say("problems.student", lang, student=called), *statement(mechanism, lang, drawn)]
    lines += [say(f"problems.figure {'drawn' if there else 'elsewhere'}", lang, file=figure)] if figure else []
    lines += ["", say("problems.find", lang)]
    marked = asked_of(mechanism)
    for question in mechanism.ask:
        quantity, worth, credit = read(mechanism, question), "", mechanism.worth.get(question, 1.0)
        if question in marked:
            worth = say("problems.points one" if credit == 1 else "problems.points many", lang, points=credit)
        halves = () if quantity is None else quantity.halves
        thetas = [half for half in halves if isinstance(half, Rotation) and half.word == "theta"]
        angles = "".join(dict.fromkeys(_angle_line(mechanism, theta, lang) for theta in thetas))
        sign = "" if quantity is None else EDGE[quantity.unit].sign
        name = question if quantity is None else _symbol(quantity) + (f" [{sign}]" if sign else "")
        lines.append(f"  {name}{worth}{angles}")
    lines += ["", say("problems.hand in", lang), "", f"  student = {_quoted(student)}", "  [answers]"]
    count = 1 + positions(mechanism)
    lines += [f"  {_quoted(at_position(question, at))} = " for at in range(1, count + 1) for question in marked]
    lines += ["", say("problems.drawing of position", lang)] if count > 1 else []
    return "\n".join(lines) + f"\n\n{MADE}\n"


def statement(mechanism: Mechanism, lang: Lang, drawn: DrawnSides | None = None) -> Iterator[str]:
    """The mechanism and its data, in lines; with the assembly it is drawn in."""
    yield from (mechanism.headline(lang), "", say("problems.given", lang))
    yield from (f"  {line}" for line in _data(mechanism, lang))
    if drawn is not None and (sentence := assembly_sentence(drawn, lang)):
        yield f"  {sentence}"
    further = positions(mechanism)
    yield from ("", say("problems.positions", lang)) if further else ()
    for at in range(further + 1) if further else ():
        shown = []  # `AB = 120°`, `ram = 25 mm`
        for driver in mechanism.drivers:
            value = driver.also[at - 1] if 0 < at <= len(driver.also) else driver.value
            if value is not None:
                size = f"{value * 1000:.6g} mm" if driver.kind == "slide" else f"{math.degrees(value):.6g}°"
                shown.append(f"{names.point(driver.name)} = {size}")
        shown = shown or [say("problems.as given", lang)]
        yield f"  #{at + 1}{say('common.colon', lang)}{say('common.list', lang).join(shown)}"


def positions(mechanism: Mechanism) -> int:
    """The number of further positions that are asked for."""
    return max((len(driver.also) for driver in mechanism.drivers), default=0)


def remark(shared: Sequence[str], lang: Lang) -> str:
    """That students have problems much alike."""
    few = say("common.and", lang).join(shared[:10]) + (" .." if len(shared) > 10 else "")
    return say("problems.shared", lang, count=len(shared), students=few)


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


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


def _angle_line(mechanism: Mechanism, angle: Rotation, lang: Lang) -> str:
    """The line along which a link's angle is measured: from its first point to the next; of one point, its guide."""
    symbol = _symbol(angle)
    if (axis := mechanism.links[angle.link].axis) is not None:
        tail, head = map(names.point, axis)
        return say("problems.angle", lang, angle=symbol, tail=tail, head=head)
    slide = next((slide for slide in mechanism.slides if angle.link in (slide.block, slide.guide)), None)
    if slide is None:
        return ""
    return say("problems.angle of guide", lang, angle=symbol, guide=mechanism.called(slide.guide))


def _data(mechanism: Mechanism, lang: Lang) -> Iterator[str]:
    """A line a link, pair and driver, in the file's order."""
    for (table, *inner), stated in mechanism.given.items():
        if inner or not is_phrase(f"problems.table {table}"):
            continue
        content = stated.written
        if table == "links" and isinstance(content, dict):
            rows = [*content.items()]
        else:
            rows = [("", row) for row in (content if isinstance(content, list) else [content])]
        for name, row in rows:
            head = say(f"problems.table {table}", lang) + (f" {name}" if name else "")
            # with what a sliding pair is called behind its name, in this language
            title, rest = row.get("title"), {key: value for key, value in row.items() if key != "title"}
            called = title.get(lang) or next(iter(title.values()), "") if isinstance(title, dict) else title
            if called and called != row.get("name"):
                named = "name" in row
                rest = {**rest, "name": f"{row['name']} ({called})"} if named else {"name": called, **rest}
            entries = (_entry(key, value, lang) for key, value in rest.items())
            yield f"{head}{say('common.colon', lang)}{say('common.and', lang).join(entries)}"


def _entry(key: str, value: object, lang: Lang) -> str:
    if is_phrase(f"problems.key {key}"):
        return f"{say(f'problems.key {key}', lang)} = {_value(value, lang)}"
    angle = "∠" if len(split_points(key)) == len(("tail", "corner", "head")) else ""
    return f"{angle}{names.point(key)} = {_value(value, lang)}"


def _value(value: object, lang: Lang) -> str:
    match value:
        case bool():
            return str(value).lower()
        case dict():
            return "(" + say("common.and", lang).join(_entry(key, inner, lang) for key, inner in value.items()) + ")"
        case list():
            return "(" + ", ".join(_value(inner, lang) for inner in value) + ")"
        case "frame":
            return say("problems.the frame", lang)
        case _:
            return str(value)


def assembly_sentence(sides: DrawnSides, lang: Lang) -> str:
    """`Assembly: C above BD.`, one side after another; nothing where there is no choice."""
    choices = []
    for lies in sides.lies:
        line = "".join(map(names.point, lies.line))
        if lies.by_distance:
            side = "far" if lies.to.real > 0 else "near"
        elif abs(lies.to.imag) >= abs(lies.to.real):
            side = "above" if lies.to.imag > 0 else "below"
        else:
            side = "right" if lies.to.real > 0 else "left"
        choices.append(say(f"assembly.side {side}", lang, point=names.point(lies.point), line=line))
    for point, place in sides.near:
        x, y = (f"{1000 * part + 0.0:.4g}" for part in (place.real, place.imag))
        choices.append(say("assembly.near", lang, point=names.point(point), x=x, y=y))
    joined = say("common.and", lang).join(dict.fromkeys(choices))
    return joined and say("assembly.drawn", lang, told=joined)
