"""What is to be said of a sweep beside its numbers: how far the driver gets and why, change points, greatest values."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.errors import Lang, listed
from graphkin.quantities import EDGE, IN_GRAVITY
from graphkin.running.path import Event
from graphkin.sweeps import Course, Series, Sweep
from graphkin.words.catalogue import say

__all__ = ["extremes", "left_out", "named", "remarks", "shown", "told"]


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
    return say(f"sweeps.event {event.kind}", lang, links=listed(event.links, lang))


def remarks(course: Course, lang: Lang) -> Iterator[str]:
    """How far the driver gets, and through what."""
    unit = course.unit
    if not course.full_turn:
        low, high = (shown(value, unit) for value in course.reach)
        yield say("sweeps.range", lang, driver=course.driver.name, low=low, high=high)
        for stop in course.stops:
            why = told(stop, lang)
            if stop.kind not in ("tangent", "parallel"):
                why = say("sweeps.dead", lang, why=why)
            yield say("sweeps.stop", lang, at=at(course, stop.at), why=why)
        yield from _open_ends(course, lang)
    for change in course.changes:
        yield say("sweeps.change", lang, at=at(course, change.at), why=told(change, lang))
    if course.dropped.size:
        yield say("sweeps.dropped", lang, count=course.dropped.size)
    if sum(map(bool, course.path.pace)) > 1:
        yield say("sweeps.together", lang)


def left_out(course: Course, undefined: np.ndarray, lang: Lang) -> Iterator[str]:
    """That positions were left out, by the driver's values there."""
    if undefined.size:
        yield say("sweeps.undefined", lang, count=undefined.size, at=named(course, float(undefined[0])))


def _open_ends(course: Course, lang: Lang) -> Iterator[str]:
    """Ends of the path at which nothing stops it but that no one looked farther."""
    stops = [stop.at for stop in course.path.stops]
    for end, side in ((course.path.low, -1), (course.path.high, 1)):
        if not any(stop * side > 0 for stop in stops):
            yield say("sweeps.open", lang, at=at(course, end))


def extremes(sweep: Sweep, lang: Lang) -> Iterator[str]:
    """The greatest and the least value of each quantity among the positions of a sweep; accelerations in g, too."""
    for entry in sweep.series:
        values = entry.signed
        if entry.is_place or not np.isfinite(values).any():
            continue
        for key, k in (("greatest", int(np.nanargmax(values))), ("least", int(np.nanargmin(values)))):
            place = named(sweep.course, float(sweep.values[k]))
            yield say(f"sweeps.{key}", lang, name=entry.name, value=_valued(entry, float(values[k])), at=place)


def _valued(entry: Series, value: float) -> str:
    text = shown(value, entry.unit)
    return text + (f" ({value * IN_GRAVITY.factor:.4g} {IN_GRAVITY.name})" if entry.unit == "m/s^2" else "")
