"""A drawing file measured, for people: what is off, what is at fault, what was not judged."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphkin.check import RulerReport
from graphkin.errors import Lang
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.text_table import table


def check_lines(report: RulerReport, tolerance_mm: float, lang: Lang) -> Iterator[str]:
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
