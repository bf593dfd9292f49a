"""A sweep for people: its tables, how far the driver gets and why, change points, greatest values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

import numpy as np

from graphkin.errors import Lang, listed
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import EDGE, IN_GRAVITY
from graphkin.model.quantities.kinds import Centre, Component, Displacement, Moving, Place, Quotient, Rotation, Track
from graphkin.running.path import Event
from graphkin.say.catalogue import say, say_close
from graphkin.say.names import in_signs, relative
from graphkin.say.numbers import at_edge, exact, number
from graphkin.say.sizes import files_unit, in_files_unit
from graphkin.say.text_table import table, unbraced
from graphkin.studies.sweeps import Course, Series, Sweep
from graphkin.studies.sweeps.course import SEEN, TURN

CONSTANT = 1e-9  # beside the value itself, less than this is no change
_BOOK_UNITS = ("rad", "m", "rad/s", "m/s", "rad/s^2", "m/s^2", "1")


def _at(course: Course, t: float, lang: Lang) -> str:
    """`AB = 41.2°`, by where on the path."""
    return _named(course, float(course.value(t).real), lang)


def _named(course: Course, value: float, lang: Lang) -> str:
    """`AB = 41.2°`, by the driver's value."""
    return f"{course.method.mechanism.driver_title(course.driver, lang)} = {_in_both_units(course, value)}"


def _in_both_units(course: Course, value: float) -> str:
    """`41.2°`, `60.96 mm`; of a file in inches in these, too: `60.96 mm (2.4 in)`."""
    own = in_files_unit(course.method.mechanism, value, course.unit) if value else ""
    return at_edge(value, course.unit) + (f" ({own})" if own else "")


def why(event: Event, lang: Lang) -> str:
    """The reason why a path stops, or what happens at a change point."""
    if event.kind == "right angle" and len(event.links) > 2:  # the slide's two links stand before the bar
        block, guide, *bars = event.links
        which = int(len(bars) > 1)
        return say("sweeps.event bar", lang, which=which, bar=listed(bars, lang), block=block, guide=guide)
    return say(f"sweeps.event {event.kind}", lang, links=listed(event.links, lang))


def stop_line(course: Course, stop: Event, lang: Lang) -> str:
    """Where a path ends, and why."""
    reason = why(stop, lang)
    if stop.kind not in ("tangent", "parallel"):
        reason = say("sweeps.dead", lang, why=reason)
    return say_close("sweeps.stop", lang, at=_at(course, stop.at, lang), why=reason)


def change_line(course: Course, change: Event, lang: Lang) -> str:
    """Where a change point is, and why."""
    return say_close("sweeps.change", lang, at=_at(course, change.at, lang), why=why(change, lang))


def one_of_several(course: Course, driver: str, lang: Lang) -> Iterator[str]:
    """That positions of one turn are not all there are, where the mechanism is elsewhere after it."""
    if course.full_turn and np.ptp(course.t) <= TURN + 1e-9 and (turns := course.turns()) != 1:
        yield say_close("sweeps.one turn", lang, driver=driver, which=not turns, count=turns or SEEN)


def remarks(course: Course, lang: Lang) -> Iterator[str]:
    """The range of the driver, and what it passes through."""
    driver = course.method.mechanism.driver_title(course.driver, lang)
    if not course.full_turn:
        low, high = (_in_both_units(course, value) for value in course.reach)
        yield say_close("sweeps.range", lang, driver=driver, low=low, high=high)
        yield from (stop_line(course, stop, lang) for stop in course.stops)
        if link := _driven_through(course):
            yield say("sweeps.driven through", lang, link=link)
        stops = [stop.at for stop in course.path.stops]
        for end, side in ((course.path.low, -1), (course.path.high, 1)):
            if not any(stop * side > 0 for stop in stops):  # nothing stops it there but that no one looked farther
                yield say_close("sweeps.open", lang, at=_at(course, end, lang))
    yield from one_of_several(course, driver, lang)
    yield from (change_line(course, change, lang) for change in course.changes)
    if course.dropped.size:
        yield say("sweeps.dropped", lang, count=course.dropped.size)
    if sum(map(bool, course.path.pace)) > 1:
        yield say("sweeps.together", lang)
    if any(driver.acceleration for driver in course.method.mechanism.drivers):
        yield say("sweeps.as stated", lang)


def _driven_through(course: Course) -> str:
    """A link that would take the mechanism through the dead points of its only driver; "" where there is none."""
    mechanism = course.method.mechanism
    dead = all(stop.kind in ("in line", "right angle") for stop in course.stops)
    if len(mechanism.drivers) > 1 or not course.stops or not dead:
        return ""
    driver = course.driver
    pair = mechanism.pair(driver.link) if driver.kind == "slide" else None
    own = {driver.link, driver.from_link, FRAME} if pair is None else {*pair.joins, FRAME}
    called = {mechanism.called(link) for link in own}
    stop = course.stops[0]
    bars = [link for link in stop.links[2 if stop.kind == "right angle" else 0 :] if link not in called]
    hinged = {mechanism.called(link) for hinge in mechanism.hinges if FRAME in hinge.links for link in hinge.links}
    return min(bars, key=lambda link: link not in hinged, default="")


def left_out(course: Course, undefined: np.ndarray, lang: Lang) -> Iterator[str]:
    """That positions were left out, by the driver's values there."""
    if undefined.size:
        yield say("sweeps.undefined", lang, count=undefined.size, at=_named(course, float(undefined[0]), lang))


def extremes(sweep: Sweep, lang: Lang) -> Iterator[str]:
    """The greatest and the least value of each quantity among the positions of a sweep; accelerations in g, too."""
    for entry in sweep.series:
        values, name = entry.signed, unbraced(in_signs(entry.name))
        if entry.is_place or not np.isfinite(values).any():
            continue
        if np.nanmax(values) - np.nanmin(values) <= CONSTANT * np.nanmax(np.abs(values)):
            value = in_signs(_value(sweep, entry, float(values[np.flatnonzero(np.isfinite(values))[0]])))
            yield say("sweeps.constant", lang, name=name, value=value)
            continue
        for which, k in enumerate((_first_greatest(values), _first_greatest(-values))):
            place = _named(sweep.course, float(sweep.driven[k]), lang)
            value = in_signs(_value(sweep, entry, float(values[k])))
            yield say("sweeps.extreme", lang, which=which, name=name, value=value, at=place)


def sweep_notes(sweep: Sweep, lang: Lang) -> Iterator[str]:
    """Where it ends and why, positions that are left out, extremes."""
    yield from remarks(sweep.course, lang)
    yield from left_out(sweep.course, sweep.undefined, lang)
    yield from extremes(sweep, lang)


def told(sweep: Sweep, lang: Lang) -> Iterator[str]:
    """Its table, and all that is said of it."""
    yield from sweep_lines(sweep, lang)
    yield from sweep_notes(sweep, lang)


def _first_greatest(values: np.ndarray) -> int:
    """The first row with the greatest value (n,), as far as rounding lets one tell."""
    most = np.nanmax(values)
    return int(np.argmax(values >= most - CONSTANT * np.nanmax(np.abs(values))))


def _value(sweep: Sweep, entry: Series, value: float) -> str:
    text = in_files_unit(sweep.mechanism, value, entry.unit) or at_edge(value, entry.unit)
    return text + (f" ({number(value * IN_GRAVITY.factor, 1e-9)} {IN_GRAVITY.name})" if entry.unit == "m/s^2" else "")


def sweep_lines(sweep: Sweep, lang: Lang) -> Iterator[str]:
    """A row for each position, in mm or the file's own unit, and deg; of an instant centre x and y."""
    first = files_unit(sweep.mechanism, sweep.course.unit)
    heads, values = [[sweep.course.driver.name, first.name]], [sweep.driven * first.factor]
    for entry in sweep.series:
        unit = files_unit(sweep.mechanism, entry.unit)
        heads += [[f"{entry.name}{part}", unit.name or "1"] for part in ((" x", " y") if entry.is_place else ("",))]
        at = entry.vectors if entry.is_place else None
        values += [part * unit.factor for part in ((entry.signed,) if at is None else (at.real, at.imag))]
    rows = [[exact(float(column[k])) for column in values] for k in range(sweep.t.size)]
    names, units = ([in_signs(head[k]) for head in heads] for k in (0, 1))
    yield from table([names, [f"[{unit}]" for unit in units], *rows])


def book_lines(sweep: Sweep) -> Iterator[str]:
    """As Sun Huan's table 3-1: positions, velocities, accelerations; deg and m, five decimals."""
    plain = [entry for entry in sweep.series if not entry.is_place]
    columns = [
        (_symbol(entry), unit, np.degrees(entry.signed) if unit == "rad" else entry.signed)
        for unit in _BOOK_UNITS for entry in plain if entry.unit == unit
    ]  # fmt: skip
    for entry in sweep.series:
        if entry.is_place and entry.vectors is not None:
            columns += [(f"{entry.name}_x", "m", entry.vectors.real), (f"{entry.name}_y", "m", entry.vectors.imag)]
    heads, units, values = zip(*columns) if columns else ((), (), ())
    first = np.degrees(sweep.driven) if sweep.course.unit == "rad" else sweep.driven
    shown = [[f"{v if abs(v) >= 5e-6 else 0.0:.5f}".replace("-", "−") for v in column] for column in values]
    rows = [[exact(round(float(first[k]), 9)), *(column[k] for column in shown)] for k in range(sweep.t.size)]
    driver, called = sweep.course.driver, sweep.mechanism.called
    link = called(driver.link)
    symbol = f"θ{link}" if link.isdigit() else f"θ_{link}"
    if driver.kind == "slide":
        symbol = f"s_{driver.link}"
    elif driver.from_link != FRAME:
        symbol = relative("φ", link, called(driver.from_link))
    signs = [unit if unit == "m" else EDGE[unit].sign for unit in (sweep.course.unit, *units)]
    shown_units = [f"/({sign})" if "°" in sign or "/" in sign else f"/{sign}" if sign else "" for sign in signs]
    yield from table([[symbol, *heads], shown_units, *rows])


def _symbol(entry: Series) -> str:
    quantity = entry.quantity
    match quantity:
        case Centre() | Quotient():
            return entry.name
        case Rotation():
            return f"{quantity.letter}{'' if quantity.of.isdigit() else '_'}{quantity.of}"
        case Displacement() | Place() | Track() | Moving() | Component():
            return f"{quantity.word}_{quantity.of}"
        case _:
            assert_never(quantity)
