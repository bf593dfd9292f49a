"""The head of a derivation: title, drivers, scales."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from graphkin.model.mechanism import Driver, Pose
from graphkin.say import names
from graphkin.say.entry import Entry, Heading, Sentence
from graphkin.say.given_dimensions import dimensions
from graphkin.say.given_sizes import Size, driven
from graphkin.say.numbers import given as given_figure
from graphkin.say.numbers import number
from graphkin.say.reading import Reading
from graphkin.say.redundancy import redundant_constraints
from graphkin.say.senses import sensed


def given(reading: Reading) -> Iterator[Entry]:
    """The title, and what is given: links, pairs, drivers, the drawn position."""
    between = reading.say("common.semicolon")
    yield Heading(reading.mechanism.headline(reading.lang))
    yield Heading(reading.say("solution.given"))
    for sentence in dimensions(reading):
        yield Sentence(sentence)
    drivers = [_driver(reading, k, driver) for k, driver in enumerate(reading.mechanism.drivers)]
    yield Sentence(reading.say("derivation.given", drivers=between.join(drivers)))
    if reading.mechanism.poses:
        poses = [_pose(reading, pose) for pose in reading.mechanism.poses]
        yield Sentence(reading.say("derivation.posed", poses=between.join(poses)))


def solving(reading: Reading, leaves_out: bool) -> Iterator[Entry]:
    """The head of the solution itself: what plays no part in it, and the paper's scales.

    leaves_out  whether steps of the drawing are not told
    """
    yield Heading(reading.say("solution.solution"))
    if idle := reading.method.structure.idle:
        yield Sentence(reading.say("derivation.idle", links=reading.listed([reading.link(link) for link in idle])))
    for line in redundant_constraints(reading.method, reading.lang):
        yield Sentence(reading.say("derivation.redundant", line=line))
    yield Sentence(reading.say("derivation.scales", scales=reading.say("common.and").join(_scales(reading))))
    yield Sentence(reading.say("derivation.by hand" if reading.ruler else "derivation.exactly"))
    if leaves_out:
        yield Sentence(reading.say("derivation.numbers left out"))


def _scales(reading: Reading) -> Iterator[str]:
    yield f"{names.SCALE['position']} = {number(reading.scales['length'])} m/mm"
    yield f"{names.SCALE['velocity']} = {number(reading.scales['velocity'])} (m/s)/mm"
    yield f"{names.SCALE['acceleration']} = {number(reading.scales['acceleration'])} (m/s²)/mm"


def _pose(reading: Reading, pose: Pose) -> str:
    """What held when the mechanism was drawn."""
    if pose.vector is None:
        place = f"{names.of_slide('s', pose.link)} = {given_figure(pose.value * 1000)} mm"
        kind, slide = _kind(reading, pose.link), reading.slide_name(pose.link)
        return reading.say(f"derivation.driven {kind}", slide=slide, place=place)
    angle, line = f"{given_figure(degrees(pose.value))}°", "".join(names.point(p) for p in pose.vector)
    link = reading.link(pose.link)
    if pose.from_vector is None:
        return reading.say("derivation.pose line", line=line, link=link, angle=angle)
    other, seen_from = "".join(names.point(p) for p in pose.from_vector), reading.link(pose.from_link)
    return reading.say("derivation.pose joint", line=line, link=link, angle=angle, other=other, seen_from=seen_from)


def _driver(reading: Reading, k: int, driver: Driver) -> str:
    place, rate, more = driven(reading, k, driver)
    now, drawn = (float(facts.values[k]) for facts in (reading.plot.facts, reading.method.facts()))
    shown = None if driver.value is None and abs(now - drawn) < 1e-12 else place
    rates: Iterator[str]
    if driver.kind == "slide":
        start = _slide(reading, driver, shown)
        rates = (size.text if size.value else f"{size.symbol} = 0" for size in (rate, more))
    else:
        start = _angle(reading, driver, shown)
        rates = (sensed(size.symbol, size.value, size.unit, reading.lang) for size in (rate, more))
    return reading.say("common.and").join([start, *rates])


def _kind(reading: Reading, slide: str) -> str:
    """A sliding pair or a rolling contact."""
    return "roll" if slide in reading.contact_slides else "slide"


def _slide(reading: Reading, driver: Driver, place: Size | None) -> str:
    """Where the slide stands; nothing of one that a pose has fixed."""
    kind, slide = _kind(reading, driver.link), reading.slide_name(driver.link)
    if place is None:
        return reading.say(f"derivation.driven {kind} free", slide=slide)
    return reading.say(f"derivation.driven {kind}", slide=slide, place=place.text)


def _angle(reading: Reading, driver: Driver, place: Size | None) -> str:
    """Where the driven line stands; nothing of a wheel, or of one that a pose has fixed."""
    link = reading.link(driver.link)
    if driver.vector is None:
        return reading.say("derivation.driven wheel", link=link)
    line = "".join(names.point(p) for p in driver.vector)
    if place is None:
        return reading.say("derivation.driven line free", line=line, link=link)
    angle = place.text
    if driver.from_vector is None:
        return reading.say("derivation.driven link", line=line, link=link, angle=angle)
    other = "".join(names.point(p) for p in driver.from_vector)
    seen_from = reading.link(driver.from_link)
    return reading.say("derivation.driven joint", line=line, link=link, angle=angle, other=other, seen_from=seen_from)
