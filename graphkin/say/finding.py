"""What was found, for people: lines for the terminal, captions for the sheet."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from math import degrees
from typing import assert_never

from graphkin.errors import Lang
from graphkin.model.mechanism import Driver
from graphkin.model.quantities import driven
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.figures import Operand, written
from graphkin.say.numbers import exact, in_print, number, quantity
from graphkin.studies.finding.answers import Findings, Interval, OutputStroke, Phase, Position, SlowPoint, Speeds
from graphkin.studies.finding.conditions import Comparison, Condition, Extreme, Scaling, Slowest

_SIGNS = "φ", "s"
"""Of what a driver turns, and of what it slides."""
_DIGITS = 6
"""Of what is computed."""
_MARKED = re.compile("\0([^\0]+)\0")
"""A driver's name where it stands for its value."""


def _marked(driver: Driver) -> str:
    return f"\0{driver.name}\0"


# --- values -----------------------------------------------------------------------------------


def _driven(driver: Driver, value: float) -> str:
    return quantity(value, driven(driver.kind == "slide"))


def _rate(driver: Driver, value: float) -> str:
    return quantity(value, "m/s" if driver.kind == "slide" else "rad/s")


def _at(found: Findings, position: Position) -> str:
    """`AB = 26.38 deg, ram = 90 mm`: the driver by which positions are named first."""
    order = sorted(range(len(found.drivers)), key=lambda k: k != found.swept)
    return ", ".join(f"{_marked(found.drivers[k])} = {_driven(found.drivers[k], position.drivers[k])}" for k in order)


def _gravity(found: Findings) -> bool:
    """Whether the condition itself speaks of g."""
    wanted = found.condition
    return isinstance(wanted, Comparison) and (wanted.size or wanted.other.rstrip().endswith("g"))


def _values(found: Findings, position: Position, called: Callable[[str], str] = str) -> str:
    size = isinstance(found.condition, Comparison) and found.condition.size
    values = map(abs, position.values) if size else position.values
    entries = zip(found.quantities, found.units, values)
    shown = ((called(name), quantity(value, unit, gravity=_gravity(found))) for name, unit, value in entries)
    return ", ".join(f"{name} = {value}" for name, value in shown)


# --- lines ------------------------------------------------------------------------------------


def lines(found: Findings, lang: Lang = "en") -> Iterator[str]:
    """Everything found, nothing twice: in signs in either language, drivers with the letter of their value."""
    named = {driver.name: f"{_SIGNS[driver.kind == 'slide']}_{driver.name}" for driver in found.drivers}
    factors = [name for position in found.positions for name in position.factors]
    rates = [name for d in found.drivers for name in (_letter(d), f"omega {d.link}")]
    typed = {name: names.asked(name) for name in (*found.quantities, *factors, *rates)}
    signs = re.compile("|".join(map(re.escape, sorted(typed, key=len, reverse=True))))
    for line in dict.fromkeys(_lines(found, lang)):
        signed = in_print(_MARKED.sub(lambda met: named[met[1]], signs.sub(lambda met: typed[met[0]], line)))
        yield signed.replace(", ", say("common.and", lang))


def heading(condition: Condition, lang: Lang) -> str:
    """What is looked for, in the words of the language."""
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


def _lines(found: Findings, lang: Lang) -> Iterator[str]:
    wanted = found.condition
    looked = say("common.note", lang, note=_looked(found, lang)) if found.looked else ""
    yield heading(wanted, lang) + looked
    if isinstance(wanted, Slowest):
        yield from (f"  {_slow(found, entry, lang)}" for entry in found.slow)
    elif isinstance(wanted, Scaling):
        yield from (f"  {line}" for line in _scaling(found, wanted, lang))
    else:
        yield from (f"  {line}" for line in _results(found, lang))


def _looked(found: Findings, lang: Lang) -> str:
    assert found.looked is not None
    driver = found.drivers[found.swept]
    low, high = (_driven(driver, end) for end in found.looked)
    text = say("finding.looked", lang, driver=_marked(driver), low=low, high=high)
    ends = [say("finding.low end", lang, value=end) for end, stop in zip((low, high), found.stopped) if stop]
    if ends:
        return text + say("finding.stopped", lang, ends=say("common.list", lang).join(ends))
    return text + (say("finding.turn", lang) if found.turn else "")


def _results(found: Findings, lang: Lang) -> Iterator[str]:
    if found.everywhere:
        yield _level(found, lang)
        return
    for position in found.positions:
        yield _line(found, position, lang)
    for interval in found.intervals:
        yield _interval(found, interval, lang)
    if found.nearest is not None:
        at, values = _at(found, found.nearest), _values(found, found.nearest)
        limit = isinstance(found.condition, Comparison) and found.condition.size
        missed = say("finding.not passed" if limit else "finding.none", lang) + say("common.semicolon", lang)
        yield missed + say("finding.nearest", lang, at=at, values=values)
    elif not found.positions and not found.intervals:
        yield say("finding.none", lang)
    yield from _swing(found, lang)
    yield from (say(f"finding.note {note}", lang) for note in found.notes)


def _level(found: Findings, lang: Lang) -> str:
    """A condition met everywhere, or a quantity that never changes."""
    if found.zero:
        return say("finding.nothing", lang)
    if isinstance(found.condition, Comparison):
        return say("finding.everywhere", lang)
    return say("finding.level", lang, values=_values(found, found.positions[0]))


def _line(found: Findings, position: Position, lang: Lang) -> str:
    said = say(f"finding.kind {position.kind}", lang)
    line = f"{_at(found, position)}{say('common.colon', lang)}{_values(found, position)}"
    if position.factors:
        zero = say("common.and", lang).join(f"{name} = 0" for name in position.factors)
        return line + say("finding.because", lang, zero=zero)
    return line + (say("common.note", lang, note=said) if said else "")


def _interval(found: Findings, part: Interval, lang: Lang) -> str:
    driver = found.drivers[found.swept]
    ends = []
    for position in (part.begin, part.end):
        said = say("finding.kind end", lang) if position.kind == "end" else ""
        noted = say("common.note", lang, note=said) if said else ""
        ends.append(_driven(driver, position.drivers[found.swept]) + noted)
    span = f"{_marked(driver)} " + say("finding.interval", lang, begin=ends[0], end=ends[1])
    at = f"{_marked(driver)} = {_driven(driver, part.peak.drivers[found.swept])}"
    peak = {"what": say(f"finding.kind {part.peak.kind}", lang), "values": _values(found, part.peak), "at": at}
    return f"{span}{say('common.colon', lang)}" + say("finding.peak", lang, **peak)


def _swing(found: Findings, lang: Lang) -> Iterator[str]:
    if found.swing is None or "goes round" in found.notes:
        return
    key = "finding.stroke" if found.condition.text.startswith("stroke") else "finding.swing"
    yield say(key, lang, value=quantity(found.swing, found.units[0]))
    if found.stroke is not None:
        yield _phase(found, "advance", found.stroke.advance, lang)
        yield _phase(found, "retreat", found.stroke.retreat, lang)
        yield say("finding.ratio", lang, value=_ratio(found.stroke))


def _ratio(stroke: OutputStroke) -> str:
    """`234.071/125.929 = 1.85876`: the driver's angles over advance and return."""
    figures = Operand(degrees(stroke.advance.angle)) / Operand(degrees(stroke.retreat.angle))
    return f"{written(figures, stroke.ratio, _DIGITS)} = {number(stroke.ratio, digits=_DIGITS)}"


def _phase(found: Findings, name: str, phase: Phase, lang: Lang) -> str:
    called = say(f"finding.phase {name}", lang, way=say("finding.up" if phase.up else "finding.down", lang))
    driver, angle = found.drivers[found.swept].name, quantity(phase.angle, "rad")
    text = say("finding.phase", lang, name=called, driver=driver, angle=angle)
    if phase.time is None or phase.mean is None:
        return text
    return text + say("finding.time", lang, time=exact(phase.time), mean=quantity(phase.mean, f"{found.units[0]}/s"))


def _slow(found: Findings, entry: SlowPoint, lang: Lang) -> str:
    first, second = entry.points
    data = {"at": _at(found, entry.position), "line": first + second, "speed": quantity(entry.speed, "m/s")}
    if entry.along is None:
        return say("finding.alike", lang, **data)
    key = "behind" if entry.along < 0 else "beyond" if entry.along > entry.length else "between"
    along = quantity(abs(entry.along), "m")
    return say(f"finding.slow {key}", lang, first=first, second=second, along=along, **data)


def _scaling(found: Findings, wanted: Scaling, lang: Lang) -> Iterator[str]:
    order = sorted(range(len(found.drivers)), key=lambda k: k != wanted.driver)
    for entry in found.speeds:
        yield _speeds(found, entry, order, lang)
    if sum(bool(driver.rate) for driver in found.drivers) > 1:
        yield say("finding.together", lang)
    if any(driver.acceleration for driver in found.drivers):
        for entry in found.speeds:
            yield say("finding.square", lang, accelerations=_accelerations(found, entry))


def _speeds(found: Findings, entry: Speeds, order: list[int], lang: Lang) -> str:
    names = [f"{_letter(found.drivers[k])} = {_rate(found.drivers[k], entry.rates[k])}" for k in order]
    name, unit = found.quantities[0], found.units[0]
    value, now = quantity(entry.position.values[0], unit), quantity(entry.value, unit)
    at, rates = _at(found, entry.position), ", ".join(names)
    text = say("finding.speeds", lang, at=at, quantity=name, value=value, rates=rates)
    return text + say("finding.factor", lang, factor=exact(entry.factor), quantity=name, now=now)


def _letter(driver: Driver) -> str:
    """What a driver's speed is called: `omega AB`, `v ram`."""
    return f"{'v' if driver.kind == 'slide' else 'omega'} {driver.name}"


def _accelerations(found: Findings, entry: Speeds) -> str:
    pairs = [(driver, driver.acceleration * entry.factor**2) for driver in found.drivers if driver.acceleration]
    units = {"slide": "m/s^2"}
    return ", ".join(f"{driver.name}: {quantity(a, units.get(driver.kind, 'rad/s^2'))}" for driver, a in pairs)


def caption(found: Findings, position: Position) -> str:
    """What stands under a position on the sheet: `φ_AB = 26.38°: v_C = 0 m/s`."""
    driver, value = found.drivers[found.swept], position.drivers[found.swept]
    at = f"{_SIGNS[driver.kind == 'slide']}_{driver.name} = {_driven(driver, value)}"
    values = _values(found, position, names.asked)
    return in_print(f"{at}: {values}" if values else at)
