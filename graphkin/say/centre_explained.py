"""The instant centres in words: how each is found, what they give, and all of them in a table."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import degrees
from typing import Any

from graphkin.errors import Lang
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.centre_steps import CentreReader
from graphkin.say.centre_velocities import uses
from graphkin.say.entry import Entry, Heading
from graphkin.say.layout import lines
from graphkin.say.numbers import exact, number
from graphkin.studies.centres import Centres, advantages, as_json

Json = Mapping[str, Any]


def explain_centres(found: Centres, lang: Lang, scale: float | None = None) -> list[str]:
    """All centres with the lines that give them, and the velocities asked for with their figures, line by line.

    found  at one position
    scale  of the drawing from which lengths are taken [m/mm]; the file's own, or 0.001, where left out
    """
    return list(lines(centre_entries(found, lang, scale), lang))


def centre_entries(found: Centres, lang: Lang, scale: float | None = None) -> Iterator[Entry]:
    """The same as data."""
    reader = CentreReader(found, lang)
    yield Heading(found.method.mechanism.headline(lang))
    yield from reader.entries(found.centring.stages, found.centring.together)
    yield from uses(reader, scale or found.method.mechanism.scales.get("length", 0.001))


# --- a table ----------------------------------------------------------------------------------


def rows(found: Centres, lang: Lang) -> Iterator[list[str]]:
    """The table's rows, the heading first."""
    yield [say(f"centres.column {key}", lang) for key in ("centre", "links", "place", "by")]
    for name, entry in as_json(found)["centres"].items():
        yield [name, ", ".join(entry["links"]), place(entry, lang), _way(entry["by"], lang)]


def place(entry: Json, lang: Lang) -> str:
    """`(66.404, 182.442)` in mm, or `at infinity, 90°`."""
    if "at" in entry:
        x, y = (exact(value * 1000) if abs(value) > 1e-12 else "0" for value in entry["at"])
        return f"({x}, {y})"
    if "direction" in entry:
        return say("centres.place at infinity", lang, angle=exact(round(degrees(entry["direction"]), 9)))
    return "-"


def _way(by: str | list[list[str]], lang: Lang) -> str:
    if isinstance(by, str):
        return say(f"centres.by {by}", lang)
    return " × ".join(say("centres.by normal", lang) if line == ["normal"] else "".join(line) for line in by)


def advantage_lines(found: Centres, lang: Lang) -> Iterator[str]:
    """How many times the driver's torque a link gives, by the ratios of the centres' distances."""
    mechanism = found.method.mechanism
    driver = next((d for d in mechanism.drivers if d.rate), mechanism.drivers[0])
    for link, value in advantages(found).items():
        senses = say("centres.same", lang) if value > 0 else say("centres.opposite", lang)
        out, drives = (mechanism.called(one) for one in (link, driver.link))
        words = {"out": names.point(out), "driver": names.point(drives), "senses": senses}
        ratio = f"{names.of_link('ω', drives)}/{names.of_link('ω', out)}"
        yield "  " + say("centres.advantage", lang, value=number(abs(value)), ratio=ratio, **words)
