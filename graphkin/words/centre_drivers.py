"""What is given, and the first motions that it gives: of a driven link, or of one driven against another."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.mechanism import FRAME, Driver
from graphkin.words import names
from graphkin.words.centre_levers import Gliding, Levers, Turning, printed
from graphkin.words.entries import Calculation, Entry, Sentence
from graphkin.words.figures import number
from graphkin.words.phrases import say

__all__ = ["start"]


def start(levers: Levers, driver: Driver) -> Iterator[Entry]:
    """What is given of one driver, and the motion of its link."""
    if driver.kind == "slide":
        yield from _slid(levers, driver)
    elif driver.from_link == FRAME:
        yield from _turned(levers, driver)
    else:
        called = levers.reader.mechanism.called
        yield _given(levers, names.relative("ω", called(driver.link), called(driver.from_link)), driver.rate)
        yield from _against(levers, driver.rate, driver.link, driver.from_link)


def _turned(levers: Levers, driver: Driver) -> Iterator[Entry]:
    yield _given(levers, levers.rate(driver.link), driver.rate)
    if (centre := levers.place(FRAME, driver.link)) is not None:
        levers.known[driver.link] = Turning(printed(driver.rate), centre)


def _given(levers: Levers, name: str, rate: float) -> Entry:
    sense = say("note", levers.reader.lang, note=levers.sense(rate))
    return Sentence(levers.reader.say("given", what=f"{name} = {number(abs(rate))} rad/s{sense}"))


def _against(levers: Levers, relative: float, link: str, other: str) -> Iterator[Entry]:
    """omega_i = omega_ij P1jPij / P1iP1j: a link that turns at a given rate against another that moves."""
    called = levers.reader.mechanism.called
    name, own = names.relative("ω", called(link), called(other)), levers.place(FRAME, link)
    seat, common = levers.place(FRAME, other), levers.place(link, other)
    if own is None:
        levers.known[other] = Turning(printed(-relative), seat or 0j)
        note = levers.sense(-relative)
        yield Calculation(levers.rate(other), (name,), "", abs(printed(relative)), "rad/s", note)
        return
    if seat is None or common is None:
        levers.known[link] = Turning(printed(relative), own)
        yield Calculation(levers.rate(link), (name,), "", abs(printed(relative)), "rad/s", levers.sense(relative))
        return
    lever, base = levers.length(seat, common), levers.length(own, seat)
    if base == 0:
        yield Sentence(levers.reader.say("not told", name=levers.rate(link)))
        return
    value = printed(abs(printed(relative)) * lever / base)
    same = ((common - seat).conjugate() * (own - seat)).real > 0
    levers.known[link] = Turning(value * (1 if relative > 0 else -1) * (1 if same else -1), own)
    ends = [levers.name(FRAME, other), levers.name(link, other), levers.name(FRAME, link)]
    formula = f"{name} {levers.stretch(*ends[:2])} / {levers.stretch(ends[2], ends[0])}"
    figures = f"{number(abs(relative))} × {number(lever)} / {number(base)}"
    motion = levers.known[link]
    note = levers.sense(motion.omega) if isinstance(motion, Turning) and value else ""
    yield Calculation(levers.rate(link), (formula,), figures, value, "rad/s", note)


# --- driven slides --------------------------------------------------------------------------------


def _slid(levers: Levers, driver: Driver) -> Iterator[Entry]:
    """A point driven along a fixed guide, or along one that moves."""
    point, link, guide = _driven_point(levers, driver)
    plot = levers.reader.found.plot
    way = complex(plot.guide_direction(driver.link)) * (1 if driver.rate > 0 else -1)
    speed = printed(abs(driver.rate))
    if guide != FRAME:
        what = f"{names.of_slide('ṡ', driver.link)} = {number(driver.rate)} m/s"
        yield Sentence(levers.reader.say("given", what=what))
        yield from _relative(levers, speed * way, point, link, guide)
        return
    yield Sentence(levers.reader.say("given", what=f"v_{names.point(point)} = {number(speed)} m/s"))
    own = levers.place(FRAME, link)
    if own is None:
        levers.known[link] = Gliding(speed, way)
        yield Calculation(levers.speed(link), (f"v_{names.point(point)}",), "", speed, "m/s")
        return
    yield from _about(levers, speed * way, complex(plot.position[point]), point, link, own)


def _driven_point(levers: Levers, driver: Driver) -> tuple[str, str, str]:
    """The point, the link it is driven with, and the link that carries its way."""
    machine = levers.reader.mechanism
    for slide in machine.slides:
        if slide.name == driver.link:
            owners = (name for name in machine.owners[slide.point] if name != slide.guide)
            return slide.point, slide.block or next(owners), slide.guide
    roll = next(roll for roll in machine.rolls if roll.name == driver.link)
    return roll.centre, roll.wheel, roll.track


def _about(
    levers: Levers, velocity: complex, at: complex, point: str, link: str, own: complex
) -> Iterator[Entry]:
    """omega = v_C / (P1jC mu_l)."""
    lever, scale = levers.length(at, own), printed(levers.scale)
    value = printed(abs(velocity) / (lever * scale))
    sign = 1 if ((1j * (at - own)).conjugate() * velocity).real > 0 else -1
    levers.known[link] = Turning(sign * value, own)
    stretch = levers.stretch(levers.name(FRAME, link), point)
    formula = f"v_{names.point(point)} / ({stretch} {names.SCALE['position']})"
    figures = f"{number(abs(velocity))} / ({number(lever)} × {number(scale)})"
    yield Calculation(levers.rate(link), (formula,), figures, value, "rad/s", levers.sense(sign))


def _relative(levers: Levers, velocity: complex, point: str, link: str, guide: str) -> Iterator[Entry]:
    """A given sliding speed on a moving guide: omega = s' / (P1iP1j mu_l) of a block, which turns with its guide."""
    own, seat, common = levers.place(FRAME, link), levers.place(FRAME, guide), levers.place(link, guide)
    scale = printed(levers.scale)
    if common is not None:
        at = complex(levers.reader.found.plot.position[point])
        lever = levers.length(at, common)
        turning = (velocity / (1j * (at - common))).real
        value = printed(abs(velocity) / (lever * scale))
        called = levers.reader.mechanism.called
        name = names.relative("ω", called(link), called(guide))
        formula = f"ṡ / ({levers.stretch(levers.name(link, guide), point)} {names.SCALE['position']})"
        figures = f"{number(abs(velocity))} / ({number(lever)} × {number(scale)})"
        yield Calculation(name, (formula,), figures, value, "rad/s", levers.sense(turning))
        yield from _against(levers, value if turning > 0 else -value, link, guide)
    elif own is not None and seat is not None:
        base = levers.length(own, seat)
        turning = (velocity / (1j * (seat - own))).real
        value = printed(abs(velocity) / (base * scale))
        levers.known[link] = Turning(value if turning > 0 else -value, own)
        stretch = levers.stretch(levers.name(FRAME, link), levers.name(FRAME, guide))
        formula = f"ṡ / ({stretch} {names.SCALE['position']})"
        figures = f"{number(abs(velocity))} / ({number(base)} × {number(scale)})"
        yield Calculation(levers.rate(link), (formula,), figures, value, "rad/s", levers.sense(turning))
    else:
        levers.known[link] = Gliding(abs(velocity), velocity / abs(velocity))
        yield Calculation(levers.speed(link), ("ṡ",), "", abs(velocity), "m/s")
