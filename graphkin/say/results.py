"""The findings of `solve` and `check`, for people: drawn beside analysed, with the answers; a drawing file measured."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from graphkin.check import RulerReport
from graphkin.errors import Lang
from graphkin.files.toml import Document
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import EDGE, Unit, driven, read
from graphkin.model.quantities.kinds import Moving, Rotation, turning_link
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.centre_steps import centre_place
from graphkin.say.names import in_signs, of_slide
from graphkin.say.numbers import degrees, exact, heading, sense
from graphkin.say.sizes import in_files_unit
from graphkin.say.text_table import table, unbraced

_SLIDING = (("s", "s", EDGE["m"]), ("v", "ṡ", EDGE["m/s"]), ("a", "s̈", EDGE["m/s^2"]))
"""A displacement and its rates: in the data, in print, their units."""


def solve_lines(mechanism: Mechanism, results: Mapping[str, object], lang: Lang) -> Iterator[str]:
    """A table of each position, with the answers under it."""
    data: Document = {**results}
    colon = say("common.colon", lang)
    yield "  ".join(dict.fromkeys((data["name"], data["title"])))
    for position in data["positions"]:
        yield ""
        drivers = []  # `AB = 60 deg, ram = 90 mm`
        for driver, value in zip(mechanism.drivers, position["drivers"], strict=True):
            unit = EDGE[driven(driver.kind == "slide")]
            drivers.append(f"{mechanism.driver_title(driver, lang)} = {exact(value * unit.factor)} {unit.name}")
        yield f"{say('results.position', lang)}{colon}{in_signs(say('common.and', lang).join(drivers))}"
        heads = ("quantity", "graphical", "analytic", "difference", "unit", "direction")
        rows = [[say(f"results.{head}", lang) for head in heads], *_rows(mechanism, position, lang)]
        yield from table([[in_signs(cell) for cell in row] for row in rows])
        if position["ask"]:
            yield f"{say('results.asked', lang)}{colon}".rstrip()
        for question, entry in position["ask"].items():
            name = unbraced(in_signs(question))
            if "at" in entry or "direction" in entry:
                yield f"  {name} = {centre_place(entry, lang)}" + (" mm" if "at" in entry else "")
            elif entry["value"] is None:
                yield f"  {name}{colon}{say('results.not answered', lang)}"
            else:
                unit = EDGE[entry["unit"]]
                size, note = entry.get("size", entry["value"]) * unit.factor, ""
                if "vector" in entry:
                    note = heading(degrees(complex(*entry["vector"])), lang) if size else ""
                    note = say("common.and", lang).join(filter(None, (note, _takes(mechanism, question, lang))))
                elif isinstance(read(mechanism, question), Rotation) and entry["unit"] != "rad":
                    note = sense(size, lang) if size else ""
                other = in_files_unit(mechanism, size / unit.factor, entry["unit"]) if size else ""
                note = say("common.and", lang).join(filter(None, (other, note)))
                value = f"{exact(size)} {in_signs(unit.name)}".rstrip().replace(" °", "°")
                yield f"  {name} = {value}" + (say("common.note", lang, note=note) if note else "")
        yield f"{say('results.worst', lang)}{colon}" + f"{position['worst']:.1e}".replace("-", "−")


def _takes(mechanism: Mechanism, question: str, lang: Lang) -> str:
    """Of parts seen from the link of a pin or a block whose path is straight in the other: whose rotation they take."""
    quantity = read(mechanism, question)
    if not isinstance(quantity, Moving) or quantity.seen_from is None or quantity.part not in ("k", "r"):
        return ""
    link = turning_link(mechanism, quantity.site, quantity.seen_from)
    if link == quantity.seen_from.link:
        return ""
    point, called = names.point(quantity.site.point), mechanism.called(link)
    return say("results.straight", lang, rate=names.of_link("ω", called), point=point, link=names.point(called))


def _rows(mechanism: Mechanism, position: Document, lang: Lang) -> Iterator[list[str]]:
    analytic = position["analytic"]
    for link, motion in ((link, motion) for link, motion in position["links"].items() if link not in mechanism.idle):
        theta, right = math.degrees(motion["theta"]), math.degrees(analytic["links"][link]["theta"])
        turned = (theta - right + 180) % 360 - 180
        yield _row(f"theta {link}", theta, right, EDGE["rad"], turned)
        for key, unit in (("omega", "rad/s"), ("alpha", "rad/s^2")):
            drawn, right = motion[key], analytic["links"][link][key]
            yield _row(f"{key} {link}", drawn, right, EDGE[unit], way=sense(drawn, lang) if drawn else "")
    for point, motion in position["points"].items():
        for key, unit in (("v", "m/s"), ("a", "m/s^2")):
            arrow, other = complex(*motion[key]), complex(*analytic["points"][point][key])
            way = degrees(arrow) if arrow else ""
            yield _row(f"{key} {point}", abs(arrow), abs(other), EDGE[unit], abs(arrow - other), way)
    for slide, motion in position["slides"].items():
        if not mechanism.pair(slide).given:
            continue  # how far one point is along a line that has no name: its motion stands with the points
        for key, symbol, shown in _SLIDING:
            name = f"s {slide}" if key == "s" else of_slide(symbol, slide)
            right = analytic["slides"][slide][key] * shown.factor
            yield _row(name, motion[key] * shown.factor, right, shown)


def _row(name: str, drawn: float, right: float, unit: Unit, off: float | None = None, way: str = "") -> list[str]:
    off = drawn - right if off is None else off
    return [name, exact(drawn), exact(right), f"{off:.1e}".replace("-", "−"), unit.name, way]


def check_lines(report: RulerReport, lang: Lang, tolerance_mm: float = 0.01) -> Iterator[str]:
    """Each vector and point as drawn, as it should be, and the difference on paper and in its unit."""
    yield report.file
    heads = ("name", "drawn", "exact", "off", "value", "unit")
    rows = [[say(f"checks.{head}", lang) for head in heads]]
    for entry in report.measured:
        mark = "" if entry.off_mm <= tolerance_mm else "  <--"
        in_polygon = entry.kind == "vector" and entry.plane != "centres"
        name = names.vector(entry.name) if in_polygon else names.point(entry.name)
        if entry.kind == "vector":
            drawn, exact = f"{abs(entry.drawn):.4f}", f"{abs(entry.exact):.4f}"
        else:
            name += say("common.note", lang, note=say(f"checks.plane {entry.plane}", lang))
            places = (f"({place.real + 0.0:.3f}, {place.imag + 0.0:.3f})" for place in (entry.drawn, entry.exact))
            drawn, exact = (place.replace("-", "−") for place in places)
        sizes = [drawn, exact, f"{entry.off_mm:.4f}", f"{entry.off_mm * entry.unit_per_mm:.2e}"]
        rows.append([name, *sizes, entry.unit.replace("^2", "²") + mark])
    yield from table(rows)
    colon, (faults, notes) = say("common.colon", lang), _remarks(report, lang)
    yield from (f"{say('checks.fault', lang)}{colon}{fault}" for fault in faults)
    yield from (f"{say('checks.note', lang)}{colon}{note}" for note in notes)
    wrong = report.wrong(tolerance_mm)
    yield say("checks.bad" if wrong else "checks.good", lang, count=wrong, tolerance=tolerance_mm)


def check_json(report: RulerReport, tolerance_mm: float, lang: Lang) -> dict[str, object]:
    """The same for programs: drawn and exact in mm on paper, [x, y]; faults and notes in words."""
    measured, (faults, notes) = [], _remarks(report, lang)
    for entry in report.measured:
        drawn, exact = ([place.real, place.imag] for place in (entry.drawn, entry.exact))
        off = entry.off_mm if math.isfinite(entry.off_mm) else None
        row = {"plane": entry.plane, "kind": entry.kind, "name": entry.name, "drawn": drawn, "exact": exact}
        measured.append(row | {"off": off, "unit_per_mm": entry.unit_per_mm, "unit": entry.unit})
    return {
        "format": 1, "file": report.file, "passed": report.passed(tolerance_mm), "tolerance": tolerance_mm,
        "measured": measured, "faults": faults, "notes": notes,
    }  # fmt: skip


def _remarks(report: RulerReport, lang: Lang) -> tuple[list[str], list[str]]:
    """The faults and the notes in words."""
    faults = [say(f"checks.fault {fault.kind}", lang, what=fault.what) for fault in report.faults]
    return faults, [say(f"checks.note {note.kind}", lang, what=note.what) for note in report.notes]
