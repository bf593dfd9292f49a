"""What is to be said of a sweep beside its numbers: how far the driver gets and why, change points, greatest values."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.errors import Lang, listed
from graphkin.quantities import EDGE, IN_GRAVITY
from graphkin.running.path import Event
from graphkin.sweeps.course import Course
from graphkin.sweeps.quantities import Series
from graphkin.sweeps.sweep import Sweep

__all__ = ["extremes", "left_out", "named", "remarks", "shown", "told"]

WORDS: dict[str, dict[Lang, str]] = {
    "range": {
        "en": "{driver} moves from {low} to {high}.",
        "zh": "{driver} 的运动范围为 {low} 至 {high}。",
    },
    "stop": {"en": "It stops at {at}: {why}.", "zh": "在 {at} 处停止：{why}。"},
    "dead": {"en": "dead point, {why}", "zh": "死点，{why}"},
    "open": {"en": "Looked at as far as {at}; it may go on.", "zh": "只考察到 {at}，其后可能仍可运动。"},
    "change": {
        "en": "Change point at {at}: {why}. The motion goes through it smoothly; a real mechanism needs a guide there.",
        "zh": "{at} 处为变点（运动不确定位置）：{why}。计算按运动平滑通过；实际机构须有防止反转的措施。",
    },
    "dropped": {
        "en": "{count} of the positions asked for are not reached and left out.",
        "zh": "所要求的位置中有 {count} 个不能到达，已略去。",
    },
    "undefined": {
        "en": "{count} of the positions are left out: the mechanism has no definite motion there, as at {at}.",
        "zh": "已略去 {count} 个位置：机构在该处运动不确定，如 {at}。",
    },
    "together": {
        "en": "The other drivers move with it, in proportion to their speeds.",
        "zh": "其余原动件按各自速度的比例同时运动。",
    },
    "in line": {"en": "links {links} lie in line there", "zh": "构件 {links} 共线"},
    "right angle": {
        "en": "links {links}: the link stands at right angles to the guide there",
        "zh": "构件 {links}：连杆垂直于导路",
    },
    "tangent": {"en": "links {links}: the guide reaches no farther", "zh": "构件 {links}：导路已到极限位置"},
    "parallel": {"en": "links {links}: their lines become parallel there", "zh": "构件 {links} 的作图线趋于平行"},
    "fit": {
        "en": "the group of links {links} cannot be moved farther",
        "zh": "构件 {links} 所成的杆组到达极限位置",
    },
    "two ways": {
        "en": "the group of links {links} could move in two ways from there",
        "zh": "构件 {links} 所成的杆组由此可有两种运动",
    },
    "greatest": {
        "en": "greatest of the rows: {name} = {value} at {at}",
        "zh": "表中最大值：{name} = {value}，在 {at} 处",
    },
    "least": {"en": "least of the rows: {name} = {value} at {at}", "zh": "表中最小值：{name} = {value}，在 {at} 处"},
}  # fmt: skip


def shown(value: float, unit: str) -> str:
    """A value at the edge: `41.2°`, `20 mm`, `0.36 m/s`."""
    name = "°" if unit == "rad" else f" {EDGE[unit].name}".rstrip()
    size = value * EDGE[unit].factor
    return f"{size:.6g}{name}" if abs(size) > 1e-9 else f"0{name}"


def at(course: Course, t: float) -> str:
    """`AB = 41.2°`, by where on the path."""
    return named(course, float(course.value(t)))


def named(course: Course, value: float) -> str:
    """`AB = 41.2°`, by the driver's value."""
    return f"{course.driver.name} = {shown(value, course.unit)}"


def told(event: Event, lang: Lang) -> str:
    """Why a path stops, or what happens at a change point."""
    return WORDS[event.kind][lang].format(links=listed(event.links, lang))


def remarks(course: Course, lang: Lang) -> Iterator[str]:
    """How far the driver gets, and through what."""
    unit = course.unit
    if not course.full_turn:
        low, high = (shown(value, unit) for value in course.reach)
        yield WORDS["range"][lang].format(driver=course.driver.name, low=low, high=high)
        for stop in course.stops:
            why = told(stop, lang)
            if stop.kind not in ("tangent", "parallel"):
                why = WORDS["dead"][lang].format(why=why)
            yield WORDS["stop"][lang].format(at=at(course, stop.at), why=why)
        yield from _open_ends(course, lang)
    for change in course.changes:
        yield WORDS["change"][lang].format(at=at(course, change.at), why=told(change, lang))
    if course.dropped.size:
        yield WORDS["dropped"][lang].format(count=course.dropped.size)
    if sum(map(bool, course.path.pace)) > 1:
        yield WORDS["together"][lang]


def left_out(course: Course, undefined: np.ndarray, lang: Lang) -> Iterator[str]:
    """That positions were left out, by the driver's values there."""
    if undefined.size:
        yield WORDS["undefined"][lang].format(count=undefined.size, at=named(course, float(undefined[0])))


def _open_ends(course: Course, lang: Lang) -> Iterator[str]:
    """Ends of the path at which nothing stops it but that no one looked farther."""
    stops = [stop.at for stop in course.path.stops]
    for end, side in ((course.path.low, -1), (course.path.high, 1)):
        if not any(stop * side > 0 for stop in stops):
            yield WORDS["open"][lang].format(at=at(course, end))


def extremes(sweep: Sweep, lang: Lang) -> Iterator[str]:
    """The greatest and the least value of each quantity among the positions of a sweep; accelerations in g, too."""
    for entry in sweep.series:
        values = entry.signed
        if entry.is_place or not np.isfinite(values).any():
            continue
        for key, k in (("greatest", int(np.nanargmax(values))), ("least", int(np.nanargmin(values)))):
            place = named(sweep.course, float(sweep.values[k]))
            yield WORDS[key][lang].format(name=entry.name, value=_valued(entry, float(values[k])), at=place)


def _valued(entry: Series, value: float) -> str:
    text = shown(value, entry.unit)
    return text + (f" ({value * IN_GRAVITY.factor:.4g} {IN_GRAVITY.name})" if entry.unit == "m/s^2" else "")
