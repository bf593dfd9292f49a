"""What `solve` found, for people: drawn beside analysed, and what was asked."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from graphkin.base.geometry import dot
from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import EDGE, Unit, driven, read
from graphkin.say.catalogue import say
from graphkin.say.centre_explained import place
from graphkin.say.names import in_signs, of_slide
from graphkin.say.numbers import exact
from graphkin.say.text_table import table

Json = Mapping[str, Any]

_SLIDING = (("s", "s", EDGE["m"]), ("v", "ṡ", EDGE["m/s"]), ("a", "s̈", EDGE["m/s^2"]))
"""A displacement and its rates: in the data, in print, their units."""


def given_values(mechanism: Mechanism, values: Sequence[float], lang: Lang) -> str:
    """`AB = 60 deg, ram = 90 mm`."""
    shown = []
    for driver, value in zip(mechanism.drivers, values, strict=True):
        unit = EDGE[driven(driver.kind == "slide")]
        shown.append(f"{driver.name} = {exact(value * unit.factor)} {unit.name}")
    return in_signs(say("common.and", lang).join(shown), lang)


def solve_lines(mechanism: Mechanism, found: Json, lang: Lang) -> Iterator[str]:
    """Everything `results` found, for people."""
    yield "  ".join(dict.fromkeys((found["name"], found["title"])))
    for position in found["positions"]:
        yield ""
        colon = say("common.colon", lang)
        yield f"{say('results.position', lang)}{colon}{given_values(mechanism, position['drivers'], lang)}"
        heads = ("quantity", "graphical", "analytic", "difference", "unit")
        rows = [[say(f"results.{head}", lang) for head in heads], *_rows(mechanism, position)]
        rows = [[in_signs(cell, lang) for cell in row] for row in rows]
        yield from table(rows)
        yield from _answers(position["ask"], lang)
        yield f"{say('results.worst', lang)}{colon}{position['worst']:.1e}"


def _rows(mechanism: Mechanism, position: Json) -> Iterator[list[str]]:
    exact = position["analytic"]
    for link, motion in position["links"].items():
        theta, right = math.degrees(motion["theta"]), math.degrees(exact["links"][link]["theta"])
        turned = (theta - right + 180) % 360 - 180
        yield _row(f"theta {link}", theta, right, EDGE["rad"], turned)
        for key, unit in (("omega", "rad/s"), ("alpha", "rad/s^2")):
            yield _row(f"{key} {link}", motion[key], exact["links"][link][key], EDGE[unit])
    for point, motion in position["points"].items():
        for key, unit in (("v", "m/s"), ("a", "m/s^2")):
            arrow, other = complex(*motion[key]), complex(*exact["points"][point][key])
            along = _along(mechanism, f"{key} {point}")
            drawn, right = (abs(each) if along is None else float(dot(along, each)) for each in (arrow, other))
            yield _row(f"{key} {point}", drawn, right, EDGE[unit], abs(arrow - other))
    for slide, motion in position["slides"].items():
        if not mechanism.pair(slide).given:
            continue  # how far one point is along a line that has no name: its motion stands with the points
        for key, symbol, shown in _SLIDING:
            name = f"s {slide}" if key == "s" else of_slide(symbol, slide)
            yield _row(name, motion[key] * shown.factor, exact["slides"][slide][key] * shown.factor, shown)


def _along(mechanism: Mechanism, question: str) -> complex | None:
    """Along which direction a size has a sign: of a point that a guide of the frame leads."""
    quantity = read(mechanism, question)
    return None if quantity is None else quantity.along


def _row(name: str, drawn: float, right: float, unit: Unit, off: float | None = None) -> list[str]:
    off = drawn - right if off is None else off
    return [name, exact(drawn), exact(right), f"{off:.1e}", unit.name]


def _answers(asked: Json, lang: Lang) -> Iterator[str]:
    if asked:
        yield f"{say('results.asked', lang)}{say('common.colon', lang)}".rstrip()
    for question, entry in asked.items():
        name = in_signs(question, lang)
        if "at" in entry or "direction" in entry:
            yield f"  {name} = {place(entry, lang)}" + (" mm" if "at" in entry else "")
            continue
        if entry["value"] is None:
            yield f"  {name}{say('common.colon', lang)}{say('results.not answered', lang)}"
            continue
        unit = EDGE[entry["unit"]]
        value = f"{exact(entry['value'] * unit.factor)} {in_signs(unit.name, lang)}".rstrip()
        yield f"  {name} = {value}{_components(entry)}"


def _components(entry: Json) -> str:
    if "vector" not in entry:
        return ""
    x, y = entry["vector"]
    return f"  ({exact(x)}, {exact(y)})"
