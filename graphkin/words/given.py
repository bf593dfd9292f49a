"""The head of a derivation: title, drivers, scales."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from graphkin.mechanism import FRAME, Driver
from graphkin.words import names
from graphkin.words.entries import Entry, Heading, Sentence
from graphkin.words.figures import number
from graphkin.words.reading import Reading

__all__ = ["given"]


def given(reading: Reading) -> Iterator[Entry]:
    """Title, what is given, and the paper's scales."""
    drivers = [_driver(reading, k, driver) for k, driver in enumerate(reading.mechanism.drivers)]
    yield Heading(reading.mechanism.headline(reading.lang))
    between = reading.say("between drivers")
    frame = reading.mechanism.called(FRAME)
    yield Sentence(reading.say("given", drivers=between.join(drivers), frame=names.point(frame)))
    yield Sentence(reading.say("scales", scales=reading.say("and").join(_scales(reading))))


def _scales(reading: Reading) -> Iterator[str]:
    yield f"{names.SCALE['position']} = {number(reading.scales['length'])} m/mm"
    yield f"{names.SCALE['velocity']} = {number(reading.scales['velocity'])} (m/s)/mm"
    yield f"{names.SCALE['acceleration']} = {number(reading.scales['acceleration'])} (m/s²)/mm"


def _driver(reading: Reading, k: int, driver: Driver) -> str:
    facts = reading.plot.facts
    value, rate, more = (float(table[k]) for table in (facts.values, facts.rates, facts.accelerations))
    if driver.kind == "slide":
        return _slide(reading, driver, value, rate, more)
    return reading.say("and").join(
        [
            _angle(reading, driver, value),
            sensed(reading, reading.against(driver, "ω"), rate, "rad/s"),
            sensed(reading, reading.against(driver, "α"), more, "rad/s²"),
        ]
    )


def _slide(reading: Reading, driver: Driver, value: float, rate: float, more: float) -> str:
    position, speed, change = (names.of_slide(symbol, driver.link) for symbol in ("s", "ṡ", "s̈"))
    place = f"{position} = {number(value * 1000)} mm"
    return reading.say("and").join(
        [
            reading.say("driven slide", slide=driver.link, place=place),
            f"{speed} = {number(rate)} m/s" if rate else f"{speed} = 0",
            f"{change} = {number(more)} m/s²" if more else f"{change} = 0",
        ]
    )


def _angle(reading: Reading, driver: Driver, value: float) -> str:
    assert driver.vector is not None
    angle = f"{reading.against(driver, 'φ')} = {number(degrees(value))}°"
    line, link = "".join(names.point(p) for p in driver.vector), reading.link(driver.link)
    if driver.from_vector is None:
        return reading.say("driven link", line=line, link=link, angle=angle)
    other = "".join(names.point(p) for p in driver.from_vector)
    seen_from = reading.link(driver.from_link)
    return reading.say("driven joint", line=line, link=link, angle=angle, other=other, seen_from=seen_from)


def sensed(reading: Reading, name: str, value: float, unit: str) -> str:
    """`ω1 = 10 rad/s (counter-clockwise)`; nothing has no sense."""
    if value == 0:
        return f"{name} = 0"
    note = reading.say("note", note=reading.say("ccw" if value > 0 else "cw"))
    return f"{name} = {number(abs(value))} {unit}{note}"
