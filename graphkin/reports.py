"""Text for the terminal: results as tables, drawings measured, in both languages."""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from graphkin.centres import told
from graphkin.check import Measured, RulerReport
from graphkin.errors import Lang
from graphkin.mechanism import Mechanism
from graphkin.quantities import EDGE, Centre, Quotient, Rotation, Unit, driven
from graphkin.sweeps import Series, Sweep

__all__ = ["book_lines", "check_lines", "given_values", "solve_lines", "sweep_lines", "table"]

Json = Mapping[str, Any]

WORDS: dict[str, dict[Lang, str]] = {
    "quantity": {"en": "quantity", "zh": "量"},
    "graphical": {"en": "graphical", "zh": "图解"},
    "analytic": {"en": "analytic", "zh": "解析"},
    "difference": {"en": "difference", "zh": "差"},
    "unit": {"en": "unit", "zh": "单位"},
    "position": {"en": "position", "zh": "位置"},
    "asked": {"en": "asked", "zh": "所求"},
    "not answered": {"en": "not answered by this command", "zh": "本命令不作答"},
    "worst": {"en": "worst relative difference", "zh": "最大相对误差"},
    "drawn": {"en": "drawn [mm]", "zh": "图上 [mm]"},
    "exact": {"en": "exact [mm]", "zh": "精确 [mm]"},
    "off": {"en": "off [mm]", "zh": "差 [mm]"},
    "value": {"en": "off, in unit", "zh": "差（实际单位）"},
    "name": {"en": "name", "zh": "名称"},
    "good": {"en": "good: every vector and point within {tolerance:g} mm", "zh": "合格：全部矢量和点的误差不超过 {tolerance:g} mm"},
    "bad": {"en": "NOT GOOD: {count} wrong (tolerance {tolerance:g} mm)", "zh": "不合格：{count} 处有误（允许误差 {tolerance:g} mm）"},
    "fault": {"en": "fault", "zh": "缺陷"},
    "note": {"en": "not judged", "zh": "未判断"},
}

FAULTS: dict[str, dict[Lang, str]] = {
    "changed": {"en": "the mechanism, the drivers or the scales in the file were changed after drawing", "zh": "图中的机构、原动件或比例尺数据在作图后被改动"},
    "scale": {"en": "the printed scale {what} is not the one drawn with", "zh": "图上标注的比例尺 {what} 与作图所用的不符"},
    "missing": {"en": "{what} is missing", "zh": "缺少 {what}"},
    "unscaled": {"en": "the scale {what} is not printed", "zh": "图上没有标注比例尺 {what}"},
    "title": {"en": "the printed title is not that of the mechanism in the file: {what}", "zh": "图上的标题不是文件中机构的标题：{what}"},
    "letters": {"en": "these letters were changed, hidden or taken away: {what}", "zh": "图上的文字被改动、遮盖或删去：{what}"},
    "head": {"en": "the arrow head of {what} is missing, turned or at the wrong end", "zh": "{what} 的箭头缺失、方向不对或画在另一端"},
    "arrow": {"en": "an arrow at {what} mm bears no name, so it cannot be measured", "zh": "{what} mm 处的箭头没有名称，无法测量"},
    "hidden": {"en": "{what} cannot be seen", "zh": "{what} 看不见"},
    "covered": {"en": "something is drawn over {what}", "zh": "{what} 被别的图形盖住"},
    "name": {"en": "the point {what} is not called as what it shows", "zh": "点 {what} 的名称与其所指不符"},
    "loose": {"en": "the end of {what} has no point", "zh": "{what} 的端点不存在"},
    "end": {"en": "a vector does not end at its point: {what}", "zh": "矢量端点与点不重合：{what}"},
}

NOTES: dict[str, dict[Lang, str]] = {
    "signs": {"en": "{what} lines and signs that show no length, and where letters stand", "zh": "{what} 个不表示长度的线条和符号，以及文字的位置"},
    "other": {"en": "lines and signs added or taken away: there were {what}", "zh": "增添或删去的线条和符号：原有 {what} 个"},
    "words": {"en": "{what} texts that graphkin did not write", "zh": "{what} 处不是 graphkin 写的文字"},
    "blank": {"en": 'what viewers make of the size "{what}", with a blank in it', "zh": "看图程序如何理解带空格的尺寸“{what}”"},
    "nothing": {"en": "anything: there is no point to measure from yet", "zh": "整张图：还没有可供测量的点"},
    "unknown": {"en": "the point {what}, which graphkin does not know", "zh": "点 {what}：不是 graphkin 所知的点"},
}


def say(key: str, lang: Lang) -> str:
    return WORDS[key][lang]


def width(text: str) -> int:
    """Columns of a terminal that a text takes."""
    return sum(2 if unicodedata.east_asian_width(letter) in "WF" else 1 for letter in text)


def table(rows: Sequence[Sequence[str]]) -> list[str]:
    """Rows with their columns aligned: the first to the left, the others to the right."""
    widths = [max(width(row[k]) for row in rows) for k in range(len(rows[0]))]
    lines = []
    for row in rows:
        cells = [row[0] + " " * (widths[0] - width(row[0]))]
        cells += [" " * (w - width(cell)) + cell for cell, w in zip(row[1:], widths[1:], strict=True)]
        lines.append("  ".join(cells).rstrip())
    return lines


def number(value: float | None) -> str:
    """Six significant digits, zero without a sign."""
    if value is None:
        return "-"
    return f"{value:.6g}" if abs(value) > 1e-12 else "0"


# --- solve ------------------------------------------------------------------------------------


def given_values(mechanism: Mechanism, values: Sequence[float]) -> str:
    """`AB = 60 deg, ram = 90 mm`."""
    shown = []
    for driver, value in zip(mechanism.drivers, values, strict=True):
        unit = EDGE[driven(driver.kind == "slide")]
        shown.append(f"{driver.name} = {number(value * unit.factor)} {unit.name}")
    return ", ".join(shown)


def solve_lines(mechanism: Mechanism, found: Json, lang: Lang) -> Iterator[str]:
    """Everything `results` found, for people."""
    yield f"{found['name']}  {found['title']}"
    for position in found["positions"]:
        yield ""
        yield f"{say('position', lang)}: {given_values(mechanism, position['drivers'])}"
        heads = ("quantity", "graphical", "analytic", "difference", "unit")
        rows = [[say(head, lang) for head in heads], *_rows(position)]
        yield from table(rows)
        yield from _answers(position["ask"], lang)
        yield f"{say('worst', lang)}: {position['worst']:.1e}"


def _rows(position: Json) -> Iterator[list[str]]:
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
            yield _row(f"{key} {point}", abs(arrow), abs(other), EDGE[unit], abs(arrow - other))
    for slide, motion in position["slides"].items():
        for key, shown in (("s", EDGE["m"]), ("v", EDGE["m/s"]), ("a", EDGE["m/s^2"])):
            yield _row(f"{key} {slide}", motion[key] * shown.factor, exact["slides"][slide][key] * shown.factor, shown)


def _row(name: str, drawn: float, right: float, unit: Unit, off: float | None = None) -> list[str]:
    off = drawn - right if off is None else off
    return [name, number(drawn), number(right), f"{off:.1e}", unit.name]


def _answers(asked: Json, lang: Lang) -> Iterator[str]:
    if asked:
        yield f"{say('asked', lang)}:"
    for question, entry in asked.items():
        if "at" in entry or "direction" in entry:
            yield f"  {question} = {told(entry, lang)}" + (" mm" if "at" in entry else "")
            continue
        if entry["value"] is None:
            yield f"  {question}: {say('not answered', lang)}"
            continue
        unit = EDGE[entry["unit"]]
        yield f"  {question} = {number(entry['value'] * unit.factor)} {unit.name}".rstrip() + _components(entry)


def _components(entry: Json) -> str:
    if "vector" not in entry:
        return ""
    x, y = entry["vector"]
    return f"  ({number(x)}, {number(y)})"


# --- sweep ------------------------------------------------------------------------------------


def sweep_lines(sweep: Sweep) -> Iterator[str]:
    """A row for each position, in mm and deg; of an instant centre x and y."""
    first = EDGE[sweep.course.unit]
    heads, values = [[sweep.course.driver.name, first.name]], [sweep.values * first.factor]
    for entry in sweep.series:
        unit = EDGE[entry.unit]
        heads += [[f"{entry.name}{part}", unit.name or "1"] for part in ((" x", " y") if entry.is_place else ("",))]
        parts = (entry.vectors.real, entry.vectors.imag) if entry.is_place and entry.vectors is not None else (entry.signed,)
        values += [part * unit.factor for part in parts]
    rows = [[number(float(column[k])) for column in values] for k in range(sweep.t.size)]
    yield from table([[head[0] for head in heads], [f"[{head[1]}]" for head in heads], *rows])


PLANES = ("rad m", "rad/s m/s", "rad/s^2 m/s^2", "1")


def book_lines(sweep: Sweep) -> Iterator[str]:
    """As Sun Huan's table 3-1: positions, velocities, accelerations; deg and m, five decimals."""
    entries = [e for plane in PLANES for unit in plane.split() for e in sweep.series if e.unit == unit and not e.is_place]
    heads = [_driver_symbol(sweep), *(_symbol(entry) for entry in entries)]
    units = [_book_unit(unit) for unit in (sweep.course.unit, *(entry.unit for entry in entries))]
    values = [_book(entry.signed, entry.unit) for entry in entries]
    first = _book(sweep.values, sweep.course.unit)
    for entry in sweep.series:
        if not entry.is_place or entry.vectors is None:
            continue
        heads += [f"{entry.name}_x", f"{entry.name}_y"]
        units += [_book_unit("m")] * 2
        values += [entry.vectors.real, entry.vectors.imag]
    rows = [[number(round(float(first[k]), 9)), *(_fixed(float(v[k])) for v in values)] for k in range(sweep.t.size)]
    yield from table([heads, units, *rows])


def _book(values: Any, unit: str) -> Any:
    """Degrees, but metres."""
    return values * EDGE[unit].factor if unit == "rad" else values


def _book_unit(unit: str) -> str:
    sign = unit if unit == "m" else EDGE[unit].sign
    return f"/({sign})" if any(mark in sign for mark in "°/") else f"/{sign}" if sign else ""


def _fixed(value: float) -> str:
    return f"{value + 0.0:.5f}" if abs(value) >= 5e-6 else "0.00000"


def _symbol(entry: Series) -> str:
    quantity = entry.quantity
    if isinstance(quantity, Centre | Quotient):
        return entry.name
    if isinstance(quantity, Rotation):
        return f"{quantity.letter}{'' if quantity.of.isdigit() else '_'}{quantity.of}"
    return f"{quantity.word}_{quantity.of}"


def _driver_symbol(sweep: Sweep) -> str:
    driver = sweep.course.driver
    link = sweep.mechanism.called(driver.link)
    if driver.kind == "slide":
        return f"s_{driver.link}"
    return f"θ{link}" if link.isdigit() else f"θ_{link}"


# --- check ------------------------------------------------------------------------------------


def check_lines(report: RulerReport, tolerance_mm: float, lang: Lang) -> Iterator[str]:
    """Each vector and point as drawn, as it should be, and the difference on paper and in its unit."""
    yield report.file
    heads = ("name", "drawn", "exact", "off", "value", "unit")
    rows = [[say(head, lang) for head in heads]]
    for entry in report.measured:
        mark = "" if entry.off_mm <= tolerance_mm else "  <--"
        rows.append([*_measured(entry), entry.unit + mark])
    yield from table(rows)
    for fault in report.faults:
        yield f"{say('fault', lang)}: {FAULTS[fault.kind][lang].format(what=fault.what)}"
    for note in report.notes:
        yield f"{say('note', lang)}: {NOTES[note.kind][lang].format(what=note.what)}"
    wrong = report.wrong(tolerance_mm)
    yield say("bad" if wrong else "good", lang).format(count=wrong, tolerance=tolerance_mm)


def _measured(entry: Measured) -> list[str]:
    name = entry.name if entry.kind == "vector" else f"{entry.name} ({entry.plane})"
    if entry.kind == "vector":
        drawn, exact = f"{abs(entry.drawn):.4f}", f"{abs(entry.exact):.4f}"
    else:
        drawn, exact = _place(entry.drawn), _place(entry.exact)
    return [name, drawn, exact, f"{entry.off_mm:.4f}", f"{entry.off_mm * entry.unit_per_mm:.2e}"]


def _place(place: complex) -> str:
    return f"({place.real + 0.0:.3f}, {place.imag + 0.0:.3f})"
