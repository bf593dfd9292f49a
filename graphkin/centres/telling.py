"""Instant centres as data and as a table for the terminal."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from graphkin.centres.advantages import advantages
from graphkin.centres.instant_centres import Centres
from graphkin.centres.search import Centring
from graphkin.drafting import LineStep, Stage, drawn_through
from graphkin.errors import Lang

__all__ = ["advantage_lines", "as_json", "found_by", "place", "rows", "told"]

Json = dict[str, Any]


def as_json(found: Centres) -> Json:
    """One object: of each centre its links, its place [m] or direction [rad], and how it is found.

    `by` is "hinge", "contact" (wheels that roll on each other), "slide", "velocities", or the two lines: each two
    centres that it joins, or ["normal"]. Links that do not move against each other have "by": "together" and no place.
    """
    mechanism = found.method.mechanism
    stages = {stage.last.name: stage for stage in found.centring.stages}
    centres: dict[str, Json] = {}
    for first, second in found.pairs:
        name = found.name(first, second)
        entry: Json = {"links": [mechanism.called(first), mechanism.called(second)]}
        if name in stages:
            entry |= place(found, first, second) | {"by": found_by(found.centring, stages[name])}
        else:
            entry |= {"by": "together"}
        centres[name] = entry
    return {"format": 1, "name": mechanism.name, "centres": centres}


def place(found: Centres, first: str, second: str) -> Json:
    """`at` [m], `direction` [rad] for a centre at infinity, nothing where there is none."""
    if found.together(first, second):
        return {}
    at = complex(found.place(first, second))
    if np.isfinite(at):
        return {"at": [at.real + 0.0, at.imag + 0.0]}
    return {"direction": float(found.direction(first, second)) + 0.0}


def found_by(centring: Centring, stage: Stage) -> str | list[list[str]]:
    """A rule's name, or the two lines on which a centre lies."""
    return [_line(centring, line) for line in stage.lines] if stage.say == "two lines" else stage.say


def _line(centring: Centring, line: LineStep) -> list[str]:
    return ["normal"] if line.name in centring.normals else [*drawn_through(line)]


WORDS: dict[str, dict[Lang, str]] = {
    "hinge": {"en": "hinge", "zh": "转动副"},
    "contact": {"en": "rolling contact", "zh": "纯滚动接触点"},
    "slide": {"en": "sliding pair", "zh": "移动副"},
    "velocities": {"en": "velocities", "zh": "由速度求得"},
    "normal": {"en": "common normal", "zh": "公法线"},
    "together": {"en": "no motion against each other", "zh": "无相对运动"},
    "infinity": {"en": "at infinity, {angle}°", "zh": "无穷远，{angle}°"},
    "advantage": {
        "en": "Mechanical advantage without losses, torque on link {out} by torque on link {driver}: "
        "ω{driver}/ω{out} = {value}",
        "zh": "不计损耗时的机械增益：构件 {out} 与构件 {driver} 的力矩之比 ω{driver}/ω{out} = {value}",
    },
    "centre": {"en": "centre", "zh": "瞬心"},
    "links": {"en": "links", "zh": "构件"},
    "place": {"en": "place [mm]", "zh": "位置 [mm]"},
    "by": {"en": "found by", "zh": "求法"},
}


def rows(found: Centres, lang: Lang) -> Iterator[list[str]]:
    """The table's rows, the heading first."""
    yield [WORDS[key][lang] for key in ("centre", "links", "place", "by")]
    for name, entry in as_json(found)["centres"].items():
        yield [name, ", ".join(entry["links"]), told(entry, lang), _way(entry["by"], lang)]


def told(entry: Json, lang: Lang) -> str:
    """`(66.404, 182.442)` in mm, or `at infinity, 90°`."""
    if "at" in entry:
        x, y = (f"{value * 1000:.6g}" if abs(value) > 1e-12 else "0" for value in entry["at"])
        return f"({x}, {y})"
    if "direction" in entry:
        return WORDS["infinity"][lang].format(angle=f"{np.degrees(entry['direction']):.6g}")
    return "-"


def _way(by: str | list[list[str]], lang: Lang) -> str:
    if isinstance(by, str):
        return WORDS[by][lang]
    return " × ".join(WORDS["normal"][lang] if line == ["normal"] else "".join(line) for line in by)


def advantage_lines(found: Centres, lang: Lang) -> Iterator[str]:
    """How many times the driver's torque a link gives, by the ratios of the centres' distances."""
    mechanism = found.method.mechanism
    driver = next((d for d in mechanism.drivers if d.rate), mechanism.drivers[0])
    for link, value in advantages(found).items():
        names = {"out": mechanism.called(link), "driver": mechanism.called(driver.link)}
        yield "  " + WORDS["advantage"][lang].format(value=f"{value:.4g}", **names)
