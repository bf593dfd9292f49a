"""What the instant centres give, with figures: the drivers' motion, then every velocity that is asked for."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from graphkin.errors import listed
from graphkin.model.mechanism import FRAME, Driver
from graphkin.model.naming import Seen, common_link
from graphkin.model.quantities import Moving, Quantity, Rotation, parts
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.centre_levers import LeverReader
from graphkin.say.centre_steps import CentreReader
from graphkin.say.entry import Calculation, Entry, Heading, Sentence
from graphkin.say.figures import Operand
from graphkin.say.numbers import number
from graphkin.studies.centres.levers import Levers, driven_point

_RATES = ("alpha", "a", "a_n", "a_t", "a_k", "a_r")


def uses(reader: CentreReader, scale: float) -> Iterator[Entry]:
    """The velocities that the file asks for, or all rotations where it asks for none.

    scale  of the drawing from which lengths are taken [m/mm]
    """
    yield Heading(reader.say("centres.using"))
    driver = next((driver for driver in reader.mechanism.drivers if driver.rate), None)
    if driver is None:
        yield Sentence(reader.say("centres.resting"))
        return
    yield Sentence(reader.say("centres.scale", scale=names.SCALE["position"], value=number(scale)))
    levers = LeverReader(reader, Levers(reader.found, scale))
    yield _given(levers, driver)
    yield from levers.entries(levers.levers.start(driver))
    yield from _answers(levers, driver)


def _given(levers: LeverReader, driver: Driver) -> Entry:
    """What is given of one driver."""
    called, lang = levers.reader.mechanism.called, levers.reader.lang
    if driver.kind == "slide":
        point, _, guide = driven_point(levers.reader.mechanism, driver)
        name, rate = names.of_slide("ṡ", driver.link), driver.rate
        if guide == FRAME:
            name, rate = f"v_{names.point(point)}", abs(rate)
        return Sentence(levers.reader.say("centres.given", what=f"{name} = {number(rate)} m/s"))
    if driver.from_link == FRAME:
        name = levers.rate(driver.link)
    else:
        name = names.relative("ω", called(driver.link), called(driver.from_link))
    sense = say("common.note", lang, note=levers.sense(driver.rate))
    return Sentence(levers.reader.say("centres.given", what=f"{name} = {number(abs(driver.rate))} rad/s{sense}"))


def _answers(levers: LeverReader, driver: Driver) -> Iterator[Entry]:
    reader = levers.reader
    told: set[str] = set()
    wanted = {text.strip(): parts(reader.mechanism, text) for text in reader.mechanism.ask}
    if not any(halves and halves[0].word in ("omega", "v") for halves in wanted.values()):
        links = [link for link in reader.mechanism.moving if link != driver.link]
        wanted |= {f"omega {link}": (Rotation("omega", link, link),) for link in links}
    for halves in wanted.values():
        for entry in _quotient(levers, *halves) if len(halves) == 2 else _answer(levers, *halves):
            line = entry.text if isinstance(entry, Calculation | Sentence) else ""
            if line not in told:
                told.add(line)
                yield entry
    rates = [text for text, halves in wanted.items() if halves and halves[0].word in _RATES]
    if rates:
        yield Sentence(reader.say("centres.no accelerations", names=listed(map(names.asked, rates), reader.lang)))


def _answer(levers: LeverReader, *wanted: Quantity) -> Iterator[Entry]:
    for quantity in wanted:
        if isinstance(quantity, Rotation) and quantity.word == "omega":
            yield from _rotation(levers, quantity.link)
        elif isinstance(quantity, Moving) and quantity.word == "v":
            yield from _velocity(levers, quantity)


def _missing(levers: LeverReader, name: str) -> Entry:
    return Sentence(levers.reader.say("centres.not told", name=name))


def _rotation(levers: LeverReader, link: str) -> Iterator[Entry]:
    path = levers.levers.path(link)
    if path is None:
        yield _missing(levers, levers.rate(link))
        return
    yield from levers.entries(levers.levers.along(path))
    if not levers.levers.turning[link]:
        yield Calculation(levers.rate(link), (), "", 0.0, "rad/s")


def _velocity(levers: LeverReader, wanted: Moving) -> Iterator[Entry]:
    """`v C` of a point, `v B3B2` or `v CB` of one against another."""
    if wanted.seen_from is None:
        yield from _of_site(levers, wanted.of, wanted.site)
    else:
        yield from _relative(levers, wanted.of, wanted.site, wanted.seen_from)


def _of_site(levers: LeverReader, text: str, site: Seen) -> Iterator[Entry]:
    link, name = site.link if site.explicit else _nearest(levers, site), f"v_{names.point(text)}"
    if link is None or (path := levers.levers.path(link)) is None:
        yield _missing(levers, name)
        return
    yield from levers.entries(levers.levers.along(path))
    yield levers.entry(levers.levers.of_point(site.point, link), name)


def _nearest(levers: LeverReader, site: Seen) -> str | None:
    """Of the links that have a point, the frame, then one with known motion, then one that can be reached."""
    owners = levers.reader.mechanism.owners[site.point]
    links = sorted(owners, key=lambda link: (link != FRAME, link not in levers.levers.turning))
    return next((link for link in links if levers.levers.path(link) is not None), None)


def _relative(levers: LeverReader, text: str, of: Seen, seen_from: Seen) -> Iterator[Entry]:
    """Both velocities, and the difference of the two; on one link omega times the distance."""
    name, link = f"v_{names.point(text)}", common_link(levers.reader.mechanism, of, seen_from)
    on_one = link is not None and of.point != seen_from.point
    links = [link] if link is not None and on_one else [of.link, seen_from.link]
    paths = [path for one in links if (path := levers.levers.path(one)) is not None]
    if len(paths) < len(links):
        yield _missing(levers, name)
        return
    for path in paths:
        yield from levers.entries(levers.levers.along(path))
    if link is not None and on_one:
        yield levers.entry(levers.levers.of_pair(of.point, seen_from.point, link), name)
    else:
        yield from _difference(levers, name, of, seen_from)


def _difference(levers: LeverReader, name: str, of: Seen, seen_from: Seen) -> Iterator[Entry]:
    """The third side of the triangle of two velocities."""
    velocities = []
    for site in (of, seen_from):
        label = f"v_{names.point(site.point)}{levers.reader.link(site.link)}"
        yield levers.entry(levers.levers.of_point(site.point, site.link), label)
        velocities.append(levers.levers.velocity(site.point, site.link))
    difference = velocities[0] - velocities[1]
    largest = hypot(*(abs(velocity) for velocity in velocities))
    difference = difference if abs(difference) > 1e-6 * largest else 0j
    note = levers.reader.say("centres.triangle")
    yield Calculation(name, (), "", abs(difference), "m/s", note if difference else "")


def _quotient(levers: LeverReader, top: Quantity, bottom: Quantity) -> Iterator[Entry]:
    """omega_i / omega_j = P1jPij / P1iPij, or of what has been worked out."""
    entries = [list(_answer(levers, half)) for half in (top, bottom)]
    for answer in entries:
        yield from answer
    values = [_value(levers, half, answer) for half, answer in zip((top, bottom), entries, strict=True)]
    if values[0] is None or values[1] is None or values[1][1] == 0:
        return
    (one, first), (other, second) = values[0], values[1]
    figures = Operand(abs(first)) / Operand(abs(second))
    turning = top.word == "omega"
    note = levers.reader.say("centres.same" if first * second > 0 else "centres.opposite") if turning and first else ""
    yield Calculation(f"{one}/{other}", (), figures, abs(first / second), "", note)


def _value(levers: LeverReader, half: Quantity, answer: list[Entry]) -> tuple[str, float] | None:
    """The name and the value of an answer; of a rotation with its sign."""
    if isinstance(half, Rotation) and half.word == "omega" and half.link in levers.levers.turning:
        return levers.rate(half.link), levers.levers.omega(half.link)
    last = answer[-1] if answer else None
    return (last.name, last.value) if isinstance(last, Calculation) else None
