"""Positions with a property: lines for the terminal, captions for the sheet, and a table of one row a value."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from math import degrees
from typing import assert_never

from graphkin.errors import Lang, Where
from graphkin.model.mechanism import Driver
from graphkin.model.quantities import EDGE, driven
from graphkin.model.quantities.reading import named, respelled
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.figures import Operand, written
from graphkin.say.numbers import degrees as direction
from graphkin.say.numbers import exact, heading, in_print, number, quantity
from graphkin.say.text_table import table, unbraced
from graphkin.studies.finding.answers import Findings, Interval, Position
from graphkin.studies.finding.conditions import Comparison, Condition, Extreme, Scaling, Slowest
from graphkin.studies.finding.varying import VaryingTable

_SIGNS = "φ", "s"  # of what a driver turns, and of what it slides
_DIGITS = 6  # of what is computed
_MARKED = re.compile("\0([^\0]+)\0")  # a driver's name where it stands for its value


def _driver_value(driver: Driver, value: float) -> str:
    return quantity(value, driven(driver.kind == "slide"))


def _swept(findings: Findings, position: Position) -> str:
    """The value of the driver by which positions are named."""
    return _driver_value(findings.drivers[findings.swept], position.drivers[findings.swept])


def _rate(driver: Driver, value: float) -> str:
    return quantity(value, "m/s" if driver.kind == "slide" else "rad/s")


def _rate_name(driver: Driver) -> str:
    """The symbol of a driver's speed as it is typed: `omega AB`, `v ram`."""
    return f"{'v' if driver.kind == 'slide' else 'omega'} {driver.name}"


def _at(findings: Findings, position: Position) -> str:
    """`AB = 26.38 deg, ram = 90 mm`: the driver by which positions are named first."""
    order = sorted(range(len(findings.drivers)), key=lambda k: k != findings.swept)
    drivers = [(findings.drivers[k], position.drivers[k]) for k in order]
    return ", ".join(f"\0{driver.name}\0 = {_driver_value(driver, value)}" for driver, value in drivers)


def _values(findings: Findings, position: Position, called: Callable[[str], str] = str) -> str:
    """`v_C = 0.4 m/s, ..`; accelerations in g, too, where the condition itself speaks of g."""
    comparison = findings.condition if isinstance(findings.condition, Comparison) else None
    size = comparison is not None and comparison.size
    gravity = comparison is not None and (comparison.size or comparison.other.rstrip().endswith("g"))
    values = map(abs, position.values) if size else position.values
    entries = zip(findings.quantities, findings.units, values)
    return ", ".join(f"{called(name)} = {quantity(value, unit, gravity=gravity)}" for name, unit, value in entries)


def lines(findings: Findings, lang: Lang = "en") -> Iterator[str]:
    """Everything found, nothing twice: in signs in either language, drivers with the letter of their value."""
    named = {driver.name: f"{_SIGNS[driver.kind == 'slide']}_{driver.name}" for driver in findings.drivers}
    factors = [name for position in findings.positions for name in position.factors]
    rates = [name for d in findings.drivers for name in (_rate_name(d), f"omega {d.link}")]
    typed = {name: names.symbols(name) for name in (*findings.quantities, *factors, *rates)}
    signs = re.compile("|".join(map(re.escape, sorted(typed, key=len, reverse=True))))
    for line in dict.fromkeys(_lines(findings, lang)):
        signed = in_print(_MARKED.sub(lambda met: named[met[1]], signs.sub(lambda met: typed[met[0]], line)))
        yield signed.replace(", ", say("common.and", lang))


def plain_lines(findings: Findings, lang: Lang = "en") -> Iterator[str]:
    """The same for a terminal."""
    return (unbraced(line) for line in lines(findings, lang))


def caption(findings: Findings, position: Position) -> str:
    """The text under a position on the sheet: `φ_AB = 26.38°: v_C = 0 m/s`."""
    driver = findings.drivers[findings.swept]
    at = f"{_SIGNS[driver.kind == 'slide']}_{driver.name} = {_swept(findings, position)}"
    values = _values(findings, position, names.symbols)
    return in_print(f"{at}: {values}" if values else at)


def _heading(condition: Condition, lang: Lang) -> str:
    """The property that is looked for, in the words of the language."""
    match condition:
        case Extreme():
            return say(f"finding.asked {condition.which}", lang, of=condition.quantity)
        case Slowest():
            return say("finding.asked slowest", lang, of=condition.of)
        case Scaling():
            wanted, by = condition.text.rsplit(" by ", 1)
            return say("finding.asked speed", lang, by=by, wanted=wanted)
        case Comparison():
            return condition.text
        case _:
            assert_never(condition)


def _lines(findings: Findings, lang: Lang) -> Iterator[str]:
    condition, searched = findings.condition, ""
    if findings.looked is not None:  # the driver's range that was searched, and why it ends there
        driver = findings.drivers[findings.swept]
        low, high = (_driver_value(driver, end) for end in findings.looked)
        searched = say("finding.looked", lang, driver=f"\0{driver.name}\0", low=low, high=high)
        ends = [say("finding.low end", lang, value=end) for end, stop in zip((low, high), findings.stopped) if stop]
        if ends:
            searched += say("finding.stopped", lang, ends=say("common.list", lang).join(ends))
        elif findings.turn:
            searched += say("finding.turn", lang)
    yield _heading(condition, lang) + _note(searched, lang)
    if isinstance(condition, Comparison) and not condition.size:
        yield from (f"  {line}" for line in _counted(findings, condition, lang))
    if isinstance(condition, Slowest):
        for entry in findings.slow:
            first, second = entry.points
            data = {"at": _at(findings, entry.position), "line": first + second, "speed": quantity(entry.speed, "m/s")}
            if entry.along is None:
                yield "  " + say("finding.alike", lang, **data)
                continue
            where = 2 if entry.along < 0 else int(entry.along > entry.length)
            data |= {"first": first, "second": second, "along": quantity(abs(entry.along), "m")}
            yield "  " + say("finding.slow", lang, which=where, **data)
    elif isinstance(condition, Scaling):
        yield from (f"  {line}" for line in _scaling(findings, condition, lang))
    else:
        yield from (f"  {line}" for line in _results(findings, lang))


def _counted(findings: Findings, condition: Comparison, lang: Lang) -> Iterator[str]:
    """The way in which what a guide leads counts as positive, where its sign matters."""
    nothing = condition.sign == "=" and condition.other.split()[:1] == ["0"]
    for text in condition.quantities if not nothing else ():
        if (along := named(findings.mechanism, text, Where(text)).along) is not None:
            yield say("finding.along", lang, name=text, way=heading(direction(along), lang))


def _note(text: str, lang: Lang) -> str:
    return say("common.note", lang, note=text) if text else ""


def _results(findings: Findings, lang: Lang) -> Iterator[str]:
    if findings.everywhere:  # a condition met everywhere, or a quantity that never changes
        if findings.zero:
            yield say("finding.nothing", lang)
        elif isinstance(findings.condition, Comparison):
            yield say("finding.everywhere", lang)
        else:
            yield say("finding.level", lang, values=_values(findings, findings.positions[0]))
        return
    for position in findings.positions:
        line = f"{_at(findings, position)}{say('common.colon', lang)}{_values(findings, position)}"
        if position.factors:
            zero = say("common.and", lang).join(f"{name} = 0" for name in position.factors)
            yield line + say("finding.because", lang, zero=zero)
        else:
            yield line + _note(say(f"finding.kind {position.kind}", lang), lang)
    for interval in findings.intervals:
        yield _interval(findings, interval, lang)
    if findings.nearest is not None:
        at, values = _at(findings, findings.nearest), _values(findings, findings.nearest)
        limit = isinstance(findings.condition, Comparison) and findings.condition.size
        missed = say("finding.not passed" if limit else "finding.none", lang) + say("common.semicolon", lang)
        yield missed + say("finding.nearest", lang, at=at, values=values)
    elif not findings.positions and not findings.intervals:
        yield say("finding.none", lang)
    if findings.swing is not None and "goes round" not in findings.notes:
        key = "finding.stroke" if findings.condition.text.startswith("stroke") else "finding.swing"
        yield say(key, lang, value=quantity(findings.swing, findings.units[0]))
        yield from _stroke(findings, lang)
    yield from (say(f"finding.note {note}", lang) for note in findings.notes)


def _interval(findings: Findings, part: Interval, lang: Lang) -> str:
    driver, ends = f"\0{findings.drivers[findings.swept].name}\0", []
    for position in (part.begin, part.end):
        kind = say("finding.kind end", lang) if position.kind == "end" else ""
        ends.append(_swept(findings, position) + _note(kind, lang))
    span = f"{driver} " + say("finding.interval", lang, begin=ends[0], end=ends[1])
    at = f"{driver} = {_swept(findings, part.peak)}"
    peak = {"what": say(f"finding.kind {part.peak.kind}", lang), "values": _values(findings, part.peak), "at": at}
    return f"{span}{say('common.colon', lang)}" + say("finding.peak", lang, **peak)


def _stroke(findings: Findings, lang: Lang) -> Iterator[str]:
    """The stroke there, the stroke back, and the ratio of both."""
    if (stroke := findings.stroke) is None:
        return
    driver, unit = findings.drivers[findings.swept].name, f"{findings.units[0]}/s"
    for name, phase in (("advance", stroke.advance), ("retreat", stroke.retreat)):
        called = say(f"finding.phase {name}", lang, way=say("finding.up" if phase.up else "finding.down", lang))
        text = say("finding.phase", lang, name=called, driver=driver, angle=quantity(phase.angle, "rad"))
        if phase.time is not None and phase.mean is not None:
            text += say("finding.time", lang, time=exact(phase.time), mean=quantity(phase.mean, unit))
        yield text
    angles = Operand(degrees(stroke.advance.angle)) / Operand(degrees(stroke.retreat.angle))
    ratio = f"{written(angles, stroke.ratio, _DIGITS)} = {number(stroke.ratio, digits=_DIGITS)}"
    yield say("finding.ratio", lang, value=ratio)


def _scaling(findings: Findings, scaling: Scaling, lang: Lang) -> Iterator[str]:
    order = sorted(range(len(findings.drivers)), key=lambda k: k != scaling.driver)
    name, unit = findings.quantities[0], findings.units[0]
    for entry in findings.speeds:
        drivers = [(findings.drivers[k], entry.rates[k]) for k in order]
        rates = ", ".join(f"{_rate_name(driver)} = {_rate(driver, rate)}" for driver, rate in drivers)
        value, now = quantity(entry.position.values[0], unit), quantity(entry.value, unit)
        text = say("finding.speeds", lang, at=_at(findings, entry.position), quantity=name, value=value, rates=rates)
        yield text + say("finding.factor", lang, factor=exact(entry.factor), quantity=name, now=now)
    if sum(bool(driver.rate) for driver in findings.drivers) > 1:
        yield say("finding.together", lang)
    if accelerated := [driver for driver in findings.drivers if driver.acceleration]:
        for entry in findings.speeds:
            units = ["m/s^2" if driver.kind == "slide" else "rad/s^2" for driver in accelerated]
            sizes = [quantity(d.acceleration * entry.factor**2, unit) for d, unit in zip(accelerated, units)]
            accelerations = ", ".join(f"{driver.name}: {size}" for driver, size in zip(accelerated, sizes))
            yield say("finding.square", lang, accelerations=accelerations)


def finding_table(varying: VaryingTable, lang: Lang = "en") -> Iterator[str]:
    """A row for each value."""
    shown = [entry.found for entry in varying.rows if entry.found is not None]
    heading = respelled(_heading(shown[0].condition, lang), names.symbols) if shown else varying.condition
    yield unbraced(heading)
    unit = EDGE[{"length": "m", "angle": "rad"}.get(varying.place.kind, "1")]
    name = f"{varying.name} [{unit.name}]" if unit.name else varying.name
    heads = [name, *(_columns(shown[0], lang) if shown else [])]
    rows = [heads]
    for row in varying.rows:
        cells = _cells(row.found) if row.found is not None else ["-"] * (len(heads) - 1)
        rows.append([exact(row.value * unit.factor), *cells])
    head, *printed = table([[in_print(cell) for cell in row] for row in rows])
    yield head
    for row, line in zip(varying.rows, printed):
        yield line if row.error is None else f"{line}  {row.error.message(lang)}"


def _columns(findings: Findings, lang: Lang) -> list[str]:
    """Names of the columns."""
    at = say("finding.column at", lang, driver=findings.drivers[findings.swept].name)
    match findings.condition:
        case Extreme(which="stroke"):
            return [*(say(f"finding.column {key}", lang) for key in ("min", "max", "stroke")), "K"]
        case Extreme(which="range"):
            return [say(f"finding.column {key}", lang) for key in ("min", "max", "swing")]
        case Extreme(which=which):
            return [say(f"finding.column {which}", lang), at]
        case Comparison():
            return [at]
        case Scaling():
            return [driver.name for driver in findings.drivers]
        case Slowest():
            first = findings.slow[0].points[0] if findings.slow else ""
            return [say("finding.column along", lang, first=first), say("finding.column speed", lang)]
        case _:
            assert_never(findings.condition)


def _cells(findings: Findings) -> list[str]:
    """The cells of one row; `-` for what is not there."""
    match findings.condition:
        case Extreme(which="max" | "min"):
            chosen = [p for p in findings.positions if p.kind != "largest"]
            value = quantity(chosen[0].values[0], findings.units[0]) if chosen else "-"
            return [value, ", ".join(_swept(findings, p) for p in chosen) or "-"]
        case Extreme(which=which):
            ends = [p.values[0] for p in findings.positions] or [0.0]
            swing = 0.0 if findings.everywhere else findings.swing
            sizes = [min(ends), max(ends), swing]
            cells = ["-" if size is None else quantity(size, findings.units[0]) for size in sizes]
            return cells if which == "range" else [*cells, exact(findings.stroke.ratio) if findings.stroke else "-"]
        case Comparison():
            places = [_swept(findings, p) for p in findings.positions]
            places += [f"{_swept(findings, part.begin)} .. {_swept(findings, part.end)}" for part in findings.intervals]
            return ["=" if findings.everywhere else ", ".join(places) or "-"]
        case Scaling():
            rates = findings.speeds[0].rates if findings.speeds else ()
            return [_rate(driver, rate) for driver, rate in zip(findings.drivers, rates)]
        case Slowest():
            first = findings.slow[0]
            return ["-" if first.along is None else quantity(first.along, "m"), quantity(first.speed, "m/s")]
        case _:
            assert_never(findings.condition)
