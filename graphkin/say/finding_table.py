"""What was found, in a table: a row for each value; how many columns depends on the condition alone."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.errors import Lang
from graphkin.model.quantities import EDGE
from graphkin.model.quantities.typed import rewritten
from graphkin.say.catalogue import say
from graphkin.say.finding import heading
from graphkin.say.names import asked
from graphkin.say.numbers import exact, in_print, quantity
from graphkin.say.text_table import table
from graphkin.studies.finding.answers import Findings
from graphkin.studies.finding.conditions import Comparison, Extreme, Scaling, Slowest
from graphkin.studies.finding.varying import DimensionPlace, VaryingTable


def table_lines(found: VaryingTable, lang: Lang = "en") -> Iterator[str]:
    """A row for each value."""
    unit = {"length": "mm", "angle": "deg"}.get(found.place.kind)
    shown = [entry.found for entry in found.rows if entry.found is not None]
    yield rewritten(heading(shown[0].condition, lang), asked) if shown else found.condition
    heads = [f"{found.name} [{unit}]" if unit else found.name, *(header(shown[0], lang) if shown else [])]
    rows = [heads]
    for row in found.rows:
        cells = summary(row.found) if row.found is not None else ["-"] * (len(heads) - 1)
        rows.append([_shown(row.value, found.place), *cells])
    lines = table([[in_print(cell) for cell in row] for row in rows])
    yield lines[0]
    for row, line in zip(found.rows, lines[1:]):
        yield line if row.error is None else f"{line}  {row.error.message(lang)}"


def _shown(value: float, place: DimensionPlace) -> str:
    unit = {"length": "m", "angle": "rad"}.get(place.kind, "1")
    return exact(value * EDGE[unit].factor)


def header(found: Findings, lang: Lang) -> list[str]:
    """Names of the columns."""
    at = say("finding.column at", lang, driver=found.drivers[found.swept].name)
    match found.condition:
        case Extreme(which="stroke"):
            return [*(say(f"finding.column {key}", lang) for key in ("min", "max", "stroke")), "K"]
        case Extreme(which="range"):
            return [say(f"finding.column {key}", lang) for key in ("min", "max", "swing")]
        case Extreme(which=which):
            return [say(f"finding.column {which}", lang), at]
        case Comparison():
            return [at]
        case Scaling():
            return [driver.name for driver in found.drivers]
        case Slowest():
            first = found.slow[0].points[0] if found.slow else ""
            return [say("finding.column along", lang, first=first), say("finding.column speed", lang)]


def summary(found: Findings) -> list[str]:
    """The cells of one row; `-` for what is not there."""
    match found.condition:
        case Extreme(which=which):
            return _extreme(found, which)
        case Comparison():
            return [_places(found)]
        case Scaling():
            kinds = [driver.kind for driver in found.drivers]
            rates = found.speeds[0].rates if found.speeds else ()
            return [quantity(rate, "m/s" if kind == "slide" else "rad/s") for kind, rate in zip(kinds, rates)]
        case Slowest():
            first = found.slow[0]
            return ["-" if first.along is None else quantity(first.along, "m"), quantity(first.speed, "m/s")]


def _driven(found: Findings, value: float) -> str:
    return quantity(value, "m" if found.drivers[found.swept].kind == "slide" else "rad")


def _extreme(found: Findings, which: str) -> list[str]:
    unit = found.units[0]
    if which in ("max", "min"):
        chosen = [p for p in found.positions if p.kind != "largest"]
        value = quantity(chosen[0].values[0], unit) if chosen else "-"
        return [value, ", ".join(_driven(found, p.drivers[found.swept]) for p in chosen) or "-"]
    ends = [p.values[0] for p in found.positions] or [0.0]
    cells = [quantity(min(ends), unit), quantity(max(ends), unit)]
    swing = 0.0 if found.everywhere else found.swing
    cells.append("-" if swing is None else quantity(swing, unit))
    return cells if which == "range" else [*cells, exact(found.stroke.ratio) if found.stroke else "-"]


def _places(found: Findings) -> str:
    if found.everywhere:
        return "="
    told = [_driven(found, p.drivers[found.swept]) for p in found.positions]
    ends = [(part.begin, part.end) for part in found.intervals]
    told += [" .. ".join(_driven(found, p.drivers[found.swept]) for p in pair) for pair in ends]
    return ", ".join(told) or "-"
