"""Rotations and slidings read off a polygon, and images of links, in words."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.base.geometry import cross
from graphkin.construction import Image, Measure
from graphkin.model.mechanism import FRAME
from graphkin.say import names
from graphkin.say.contact_points import contacted, same_velocities
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.figures import Operand, figures, signed_sum
from graphkin.say.numbers import number
from graphkin.say.plane import PolygonReading
from graphkin.say.rolling import checked

# --- rotations ----------------------------------------------------------------------------------


def rotation(polygon: PolygonReading, step: Measure) -> Iterator[Entry]:
    """omega or alpha of a link, then of those that keep their angle to it."""
    if polygon.plane == "acceleration" and not polygon.written(step.tail, step.head):
        yield from _resolved(polygon, step)
    else:
        touching = contacted(polygon, step)
        if touching is None:
            name = polygon.name(step.tail, step.head)
        else:
            name = touching.name
            yield from same_velocities(polygon, step)
        yield _rate(polygon, step, name, polygon.length_mm(step.tail, step.head), direct=True)
        if (
            touching is not None
            and len(touching.contacts) == 1
            and (check := checked(polygon, touching.contacts[0]))
        ):
            yield Sentence(check)
        if polygon.plane == "velocity" and not polygon.arrow(step.tail, step.head):
            resting = step.tail == polygon.construction.pole
            key = "derivation.rest now" if resting else "derivation.translation now"
            link = polygon.reading.link(step.of)
            yield Sentence(polygon.reading.say(key, name=name, link=link))
    yield from _group(polygon, step.of)


def _group(polygon: PolygonReading, link: str) -> Iterator[Entry]:
    """The links that keep their angle to one just measured."""
    reading, others = polygon.reading, polygon.reading.group(link)
    held = [other for other in others if not _driven_between(polygon, other, link)]
    if held and polygon.plane == "velocity":
        links = reading.listed([reading.link(member) for member in (*held, link)])
        yield Sentence(reading.say("derivation.held", links=links))
    for other in others:
        yield _tie(polygon, other, link)


def _rate(polygon: PolygonReading, step: Measure, name: str, length_mm: float, direct: bool = False) -> Calculation:
    """`ω3 = v_B3/l_BD = μ_v·pb3/(μ_l·BD) = 0.01 × 27.12/(0.001 × 69.2) = 3.919 rad/s (clockwise)`."""
    reading, line = polygon.reading, names.pair(*step.lever)
    lever, mu = reading.distance(*step.lever), names.SCALE[polygon.plane]
    measured = f"{mu}·{names.stretch(step.tail, step.head)}/(μ_l·{line})"
    below = Operand(reading.scales["length"]) * Operand(lever / reading.scales["length"])
    return Calculation(
        polygon.rate(step.of),
        (f"{name}/l_{line}", measured) if direct else (f"{name}/l_{line}",),
        Operand(polygon.scale) * Operand(length_mm) / below,
        length_mm * polygon.scale / lever,
        polygon.rate_unit,
        _sense_note(polygon, step) if length_mm else "",
    )


def _sense_note(polygon: PolygonReading, step: Measure) -> str:
    """The sense; the first time also how it is found."""
    reading = polygon.reading
    sense = _sense(polygon, _turning(polygon, step))
    if step != polygon.first_lever:
        return sense
    tail, head = (names.point(p) for p in step.lever)
    words = {"stretch": names.stretch(step.tail, step.head), "rate": polygon.rate(step.of)}
    return reading.say("derivation.sense rule", sense=sense, head=head, tail=tail, **words)


def _turning(polygon: PolygonReading, step: Measure) -> float:
    """Speed across the lever, positive where it turns it counter-clockwise."""
    arm = polygon.reading.plot.arm(*step.lever)
    return float(cross(arm, polygon.arrow(step.tail, step.head)) / abs(arm))


def _resolved(polygon: PolygonReading, step: Measure) -> Iterator[Entry]:
    """Both ends are known from elsewhere: only the part across the lever turns the link."""
    reading = polygon.reading
    across = reading.usual.motion(abs(_turning(polygon, step)), polygon.plane)
    across = float(reading.ruler.read(across, polygon.plane)) if reading.ruler else across
    length_mm = across / polygon.scale
    tail = _corner(polygon, step.tail, step.lever[0])
    name = polygon.seen(polygon.of(step.head), polygon.of(tail), "t")
    numbers = Operand(polygon.scale) * Operand(length_mm)
    tangential = Calculation(name, (), numbers, across, names.UNIT[polygon.plane]).text
    ends, line = names.stretch(step.tail, step.head), names.pair(*step.lever)
    yield Sentence(reading.say("derivation.tangential part", ends=ends, line=line, tangential=tangential))
    yield _rate(polygon, step, name, length_mm)


# --- links that keep their angles ---------------------------------------------------------------


def ties(polygon: PolygonReading) -> Iterator[Entry]:
    """Before the first equation: links that cannot turn, and those that turn with the driven ones."""
    reading = polygon.reading
    still = [link for link in reading.mechanism.moving if reading.translates(link)]
    if still and polygon.plane == "velocity":
        zero = [" = ".join([*(reading.rate(symbol, link) for link in still), "0"]) for symbol in ("ω", "α")]
        links = reading.listed([reading.link(link) for link in still])
        key = "derivation.never turn" if len(still) == 1 else "derivation.never turn, several"
        yield Sentence(reading.say(key, links=links, rates=reading.say("common.and").join(zero)))
    drivers, turns = reading.mechanism.drivers, reading.plot.facts.turns
    driven = dict.fromkeys(d.link for d in drivers if d.kind != "slide" and d.from_link == FRAME)
    for link in reading.mechanism.moving:
        if turns[link].base == FRAME and turns[link].drivers and link not in driven:
            like = [other for other in driven if turns[other].drivers == turns[link].drivers]
            if like and polygon.plane == "velocity":
                links = reading.listed([reading.link(member) for member in (link, *like)])
                yield Sentence(reading.say("derivation.held", links=links))
            yield _tie(polygon, link, FRAME)


def _tie(polygon: PolygonReading, link: str, other: str) -> Calculation:
    """`ω2 = ω3`, or `ω2 = ω1 + ω21` with a driven rotation between them; the frame adds nothing."""
    reading = polygon.reading
    table = reading.plot.omega if polygon.plane == "velocity" else reading.plot.alpha
    value = reading.usual.rate(float(table[link]), polygon.plane)
    symbol, drivers = names.RATE[polygon.plane], reading.mechanism.drivers
    parts = [] if other == FRAME else [(1, polygon.rate(other), float(table[reading.body(other)]))]
    driven = _driven_between(polygon, link, other)
    parts += [(sign, reading.against(drivers[k], symbol), rate) for k, sign, rate in driven]
    formula = _signed([(sign, name) for sign, name, _ in parts])
    if not driven or (len(parts) == 1 and parts[0][0] > 0):
        note = _sense(polygon, value) if value else ""
        return Calculation(polygon.rate(link), (formula,), "", abs(value), polygon.rate_unit, note)
    rates = [(sign, reading.usual.rate(rate, polygon.plane)) for sign, _, rate in parts]
    numbers = signed_sum(rates) if len(rates) > 1 else ""
    note = reading.signed(value)
    return Calculation(polygon.rate(link), (formula,), numbers, value, polygon.rate_unit, note)


def _sense(polygon: PolygonReading, value: float) -> str:
    return polygon.reading.say("common.ccw" if value > 0 else "common.cw")


def _driven_between(polygon: PolygonReading, link: str, other: str) -> list[tuple[int, int, float]]:
    """Drivers that turn `link` against `other`, each with its sign and its rate."""
    facts = polygon.reading.plot.facts
    given = facts.rates if polygon.plane == "velocity" else facts.accelerations
    count: dict[int, int] = {}
    for member, way in ((link, 1), (other, -1)):
        for k, sign in facts.turns[member].drivers:
            count[k] = count.get(k, 0) + way * sign
    return [(k, sign, float(given[k])) for k, sign in count.items() if sign]


def _signed(parts: list[tuple[int, str]]) -> str:
    """`ω1 + ω21`, `ω2 − ω21`."""
    first = ("−" if parts[0][0] < 0 else "") + parts[0][1]
    return first + "".join(f" {'−' if sign < 0 else '+'} {text}" for sign, text in parts[1:])


# --- slides -------------------------------------------------------------------------------------


def sliding(polygon: PolygonReading, step: Measure) -> Iterator[Entry]:
    """The speed at which a named displacement grows; of others, which distance grows or shrinks."""
    reading = polygon.reading
    pair = reading.method.structure.slides[step.of]
    table = reading.plot.s_rate if polygon.plane == "velocity" else reading.plot.s_acceleration
    value, size = float(table[step.of]), polygon.read(step.tail, step.head)
    name, unit = polygon.name(step.tail, step.head), names.UNIT[polygon.plane]
    if pair.named:
        symbol = names.of_slide(names.SLIDING[polygon.plane], step.of)
        formula = name if value > 0 else f"−{name}"
        yield Calculation(symbol, (formula if size else name,), "", value if size else 0.0, unit)
    elif polygon.plane == "velocity" and size and pair.guide != FRAME and pair.line.named:
        stretch = names.pair(pair.line.origin, pair.point)
        key = "derivation.grows" if value * float(reading.plot.s[step.of]) > 0 else "derivation.shrinks"
        yield Sentence(reading.say(key, stretch=stretch, size=number(size)))


# --- images -------------------------------------------------------------------------------------


def image(polygon: PolygonReading, step: Image) -> Iterator[Entry]:
    """A further point of a link by the figure similar to it, then its motion."""
    reading = polygon.reading
    first, second, third = step.corners
    corners = [_corner(polygon, node, corner) for node, corner in zip(step.base, step.corners, strict=False)]
    words = {
        "image": reading.say(f"derivation.image {polygon.plane}"),
        "link": reading.link(step.link),
        "point": names.point(step.point),
        "small": names.stretch(*corners),
        "large": names.point(first) + names.point(second),
        "corner": names.point(third),
    }
    one, other = (reading.plot.arm(p, third) for p in (first, second))
    if not polygon.arrow(*step.base):
        yield polygon.told(step, reading.say("derivation.image point", **words))
    elif abs(cross(one, other)) <= reading.noise * max(abs(one), abs(other)):
        yield polygon.told(step, reading.say("derivation.image line", ratio=_ratio(polygon, step, corners), **words))
    else:
        small, large = names.triangle(*corners, step.point), names.triangle(*step.corners)
        ccw = float(cross(reading.plot.arm(first, second), reading.plot.arm(first, third))) > 0
        words |= {"small": small, "large": large, "sense": reading.say("common.ccw" if ccw else "common.cw")}
        yield polygon.told(step, reading.say("derivation.image triangle", **words))
    yield polygon.measured_absolute(step.point)


def _corner(polygon: PolygonReading, node: str, corner: str) -> str:
    """A fixed point's own letter rather than the pole's."""
    if node != polygon.construction.pole:
        return node
    nodes = polygon.construction.nodes.values()
    fixed = (n.name for n in nodes if n.site is not None and (n.site.point, n.site.link) == (corner, FRAME))
    return next(fixed, node)


def _ratio(polygon: PolygonReading, step: Image, corners: list[str]) -> str:
    """`dc = db3 · CD/BD = 27.12 × 48/69.2 = 18.81 mm`."""
    first, second, third = step.corners
    lengths = [polygon.reading.distance(first, p) for p in (third, second)]
    small, scale = polygon.length_mm(*step.base), polygon.reading.scales["length"]
    one, other = figures(*(length / scale for length in lengths))
    numbers = Operand(small) * one / other
    formula = f"{names.stretch(*corners)} × {names.pair(first, third)}/{names.pair(first, second)}"
    name = names.stretch(corners[0], step.point)
    return Calculation(name, (formula,), numbers, small * lengths[0] / lengths[1], "mm").text
