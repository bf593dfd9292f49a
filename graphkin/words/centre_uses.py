"""What the instant centres give, with figures: the drivers' motion, then every velocity that is asked for."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from graphkin.mechanism import FRAME, Driver
from graphkin.naming import Seen, common_link
from graphkin.quantities import Moving, Quantity, Rotation, parts
from graphkin.words import names
from graphkin.words.centre_drivers import start
from graphkin.words.centre_levers import Levers, Turning, printed
from graphkin.words.centre_steps import CentreReader
from graphkin.words.entries import Calculation, Entry, Heading, Sentence
from graphkin.words.figures import degrees, number

__all__ = ["uses"]

_RATES = ("alpha", "a", "a_n", "a_t", "a_k", "a_r")


def uses(reader: CentreReader, scale: float) -> Iterator[Entry]:
    """The velocities that the file asks for, or all rotations where it asks for none.

    scale  of the drawing from which lengths are taken [m/mm]
    """
    yield Heading(reader.say("using"))
    driver = next((driver for driver in reader.mechanism.drivers if driver.rate), None)
    if driver is None:
        yield Sentence(reader.say("resting"))
        return
    yield Sentence(reader.say("scale", scale=names.SCALE["position"], value=number(scale)))
    levers = Levers(reader, scale)
    yield from start(levers, driver)
    yield from _answers(levers, driver)


def _answers(levers: Levers, driver: Driver) -> Iterator[Entry]:
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
        yield Sentence(reader.say("no accelerations", names=names.listed(rates, reader.lang)))


def _answer(levers: Levers, *wanted: Quantity) -> Iterator[Entry]:
    for quantity in wanted:
        if isinstance(quantity, Rotation) and quantity.word == "omega":
            yield from _rotation(levers, quantity.link)
        elif isinstance(quantity, Moving) and quantity.word == "v":
            yield from _velocity(levers, quantity)


def _missing(levers: Levers, name: str) -> Entry:
    return Sentence(levers.reader.say("not told", name=name))


def _rotation(levers: Levers, link: str) -> Iterator[Entry]:
    path = levers.reach(link)
    if path is None:
        yield _missing(levers, levers.rate(link))
        return
    yield from path
    motion = levers.known[link]
    if not isinstance(motion, Turning):
        yield Calculation(levers.rate(link), (), "", 0.0, "rad/s")


def _velocity(levers: Levers, wanted: Moving) -> Iterator[Entry]:
    """`v C` of a point, `v B3B2` or `v CB` of one against another."""
    if wanted.seen_from is None:
        yield from _of_site(levers, wanted.of, wanted.site)
    else:
        yield from _relative(levers, wanted.of, wanted.site, wanted.seen_from)


def _of_site(levers: Levers, text: str, site: Seen) -> Iterator[Entry]:
    link = site.link if site.explicit else _nearest(levers, site)
    if link is None or (path := levers.reach(link)) is None:
        yield _missing(levers, f"v_{names.point(text)}")
        return
    yield from path
    yield levers.of_point(f"v_{names.point(text)}", site.point, link)


def _nearest(levers: Levers, site: Seen) -> str | None:
    """Of the links that have a point, the frame, then one with known motion, then one that can be reached."""
    owners = levers.reader.mechanism.owners[site.point]
    links = sorted(owners, key=lambda link: (link != FRAME, link not in levers.known))
    return next((link for link in links if levers.reach(link) is not None), None)


def _relative(levers: Levers, text: str, of: Seen, seen_from: Seen) -> Iterator[Entry]:
    """Both velocities, and the difference of the two; on one link omega times the distance."""
    name = f"v_{names.point(text)}"
    link = common_link(levers.reader.mechanism, of, seen_from)
    position = levers.reader.found.plot.position
    if link is not None and of.point != seen_from.point:
        if (path := levers.reach(link)) is None:
            yield _missing(levers, name)
            return
        yield from path
        motion, scale = levers.known[link], printed(levers.scale)
        omega = motion.omega if isinstance(motion, Turning) else 0.0
        arm = complex(position[of.point] - position[seen_from.point])
        length = levers.length(arm, 0j)
        formula = f"{levers.rate(link)} {names.pair(seen_from.point, of.point)} {names.SCALE['position']}"
        figures = f"{number(abs(omega))} × {number(length)} × {number(scale)}"
        note = levers.reader.say("at", angle=degrees(1j * omega * arm)) if omega else ""
        yield Calculation(name, (formula,), figures, printed(abs(omega) * length * scale), "m/s", note)
        return
    paths = [levers.reach(site.link) for site in (of, seen_from)]
    if None in paths:
        yield _missing(levers, name)
        return
    for path in paths:
        yield from path or ()
    yield from _difference(levers, name, of, seen_from)


def _difference(levers: Levers, name: str, of: Seen, seen_from: Seen) -> Iterator[Entry]:
    """The third side of the triangle of two velocities."""
    sides = [(levers.reader.link(site.link), site) for site in (of, seen_from)]
    velocities = []
    for label, site in sides:
        entry = levers.of_point(f"v_{names.point(site.point)}{label}", site.point, site.link)
        velocities.append(levers.velocity(site.point, site.link))
        yield entry
    difference = velocities[0] - velocities[1]
    largest = hypot(*(abs(velocity) for velocity in velocities))
    difference = difference if abs(difference) > 1e-6 * largest else 0j
    note = levers.reader.say("triangle")
    yield Calculation(name, (), "", printed(abs(difference)), "m/s", note if difference else "")


def _quotient(levers: Levers, top: Quantity, bottom: Quantity) -> Iterator[Entry]:
    """omega_i / omega_j = P1jPij / P1iPij, or of what has been worked out."""
    entries = [list(_answer(levers, half)) for half in (top, bottom)]
    for answer in entries:
        yield from answer
    values = [_value(levers, half, answer) for half, answer in zip((top, bottom), entries, strict=True)]
    if values[0] is None or values[1] is None or values[1][1] == 0:
        return
    (one, first), (other, second) = values[0], values[1]
    figures = f"{number(abs(first))} / {number(abs(second))}"
    turning = top.word == "omega"
    note = levers.reader.say("same" if first * second > 0 else "opposite") if turning and first else ""
    yield Calculation(f"{one} / {other}", (), figures, printed(abs(first / second)), "", note)


def _value(levers: Levers, half: Quantity, answer: list[Entry]) -> tuple[str, float] | None:
    """The name and the value of an answer; of a rotation with its sign."""
    if isinstance(half, Rotation) and half.word == "omega" and half.link in levers.known:
        motion = levers.known[half.link]
        return levers.rate(half.link), motion.omega if isinstance(motion, Turning) else 0.0
    last = answer[-1] if answer else None
    return (last.name, last.value) if isinstance(last, Calculation) else None
