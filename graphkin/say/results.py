"""Everything that `solve` finds, for people: drawn beside analysed, and what was asked."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from graphkin.base.geometry import dot
from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import EDGE, Unit, driven, read
from graphkin.say.catalogue import say
from graphkin.say.centre_steps import centre_place
from graphkin.say.names import in_signs, of_slide
from graphkin.say.numbers import exact
from graphkin.say.text_table import table

Json = Mapping[str, Any]

_SLIDING = (("s", "s", EDGE["m"]), ("v", "ṡ", EDGE["m/s"]), ("a", "s̈", EDGE["m/s^2"]))
"""A displacement and its rates: in the data, in print, their units."""


def solve_lines(mechanism: Mechanism, results: Json, lang: Lang) -> Iterator[str]:
    """A table of each position, with the answers under it."""
    colon = say("common.colon", lang)
    yield "  ".join(dict.fromkeys((results["name"], results["title"])))
    for position in results["positions"]:
        yield ""
        drivers = []  # `AB = 60 deg, ram = 90 mm`
        for driver, value in zip(mechanism.drivers, position["drivers"], strict=True):
            unit = EDGE[driven(driver.kind == "slide")]
            drivers.append(f"{driver.name} = {exact(value * unit.factor)} {unit.name}")
        yield f"{say('results.position', lang)}{colon}{in_signs(say('common.and', lang).join(drivers), lang)}"
        heads = ("quantity", "graphical", "analytic", "difference", "unit")
        rows = [[say(f"results.{head}", lang) for head in heads], *_rows(mechanism, position)]
        yield from table([[in_signs(cell, lang) for cell in row] for row in rows])
        if position["ask"]:
            yield f"{say('results.asked', lang)}{colon}".rstrip()
        for question, entry in position["ask"].items():
            name = in_signs(question, lang)
            if "at" in entry or "direction" in entry:
                yield f"  {name} = {centre_place(entry, lang)}" + (" mm" if "at" in entry else "")
            elif entry["value"] is None:
                yield f"  {name}{colon}{say('results.not answered', lang)}"
            else:
                unit = EDGE[entry["unit"]]
                value = f"{exact(entry['value'] * unit.factor)} {in_signs(unit.name, lang)}".rstrip()
                vector = f"  ({', '.join(map(exact, entry['vector']))})" if "vector" in entry else ""
                yield f"  {name} = {value}{vector}"
        yield f"{say('results.worst', lang)}{colon}{position['worst']:.1e}"


def _rows(mechanism: Mechanism, position: Json) -> Iterator[list[str]]:
    analytic = position["analytic"]
    for link, motion in position["links"].items():
        theta, right = math.degrees(motion["theta"]), math.degrees(analytic["links"][link]["theta"])
        turned = (theta - right + 180) % 360 - 180
        yield _row(f"theta {link}", theta, right, EDGE["rad"], turned)
        for key, unit in (("omega", "rad/s"), ("alpha", "rad/s^2")):
            yield _row(f"{key} {link}", motion[key], analytic["links"][link][key], EDGE[unit])
    for point, motion in position["points"].items():
        for key, unit in (("v", "m/s"), ("a", "m/s^2")):
            arrow, other = complex(*motion[key]), complex(*analytic["points"][point][key])
            quantity = read(mechanism, f"{key} {point}")
            along = None if quantity is None else quantity.along  # a guide of the frame gives a size its sign
            drawn, right = (abs(each) if along is None else float(dot(along, each)) for each in (arrow, other))
            yield _row(f"{key} {point}", drawn, right, EDGE[unit], abs(arrow - other))
    for slide, motion in position["slides"].items():
        if not mechanism.pair(slide).given:
            continue  # how far one point is along a line that has no name: its motion stands with the points
        for key, symbol, shown in _SLIDING:
            name = f"s {slide}" if key == "s" else of_slide(symbol, slide)
            right = analytic["slides"][slide][key] * shown.factor
            yield _row(name, motion[key] * shown.factor, right, shown)


def _row(name: str, drawn: float, right: float, unit: Unit, off: float | None = None) -> list[str]:
    off = drawn - right if off is None else off
    return [name, exact(drawn), exact(right), f"{off:.1e}", unit.name]
