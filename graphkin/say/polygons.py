"""The velocity and the acceleration polygon in words: the pole, equations, rotations and slidings read off, images."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import assert_never

from graphkin.base.geometry import cross, dot
from graphkin.construction import Equation, Plane, Step, kinds
from graphkin.model.mechanism import FRAME
from graphkin.planning.at_rest import held_labels, moving_parts
from graphkin.say import names
from graphkin.say.entry import Calculation, Entry, Heading, Sentence
from graphkin.say.equations import equation, known_arrow
from graphkin.say.figures import Operand, figures, joined_sum
from graphkin.say.numbers import number
from graphkin.say.plane import PolygonReading
from graphkin.say.reading import Reading, aside, only_translates
from graphkin.say.rolling import checked, contacted, gear_circles, rolling, same_velocities, steady
from graphkin.say.simultaneous import solved_together


def polygon_entries(reading: Reading, plane: Plane, parts: tuple[Step | Equation, ...], number: int) -> Iterator[Entry]:
    """Pole, known motions, equations, and what is read off each, in the order of the construction."""
    polygon = PolygonReading(reading, plane, moving_parts(reading.method, plane, parts, reading.rested))
    yield Heading(reading.say(f"derivation.plane {plane}", number=number), plane)
    for part in polygon.parts:
        match part:
            case Equation():
                yield from equation(polygon, part)
            case kinds.Given():
                yield from _renamed(polygon)
                yield from _pole(polygon, part)
                yield from _driven_groups(polygon)
                yield from steady(polygon)
            case kinds.LayOff():
                yield from known_arrow(polygon, part)
            case kinds.Image():
                yield from _image(polygon, part)
            case kinds.Measure("omega" | "alpha"):
                yield from _rotation(polygon, part)
            case kinds.Measure():
                yield from _sliding(polygon, part)
            case kinds.Roll():
                yield from rolling(polygon, part)
            case kinds.Simultaneous():
                yield from solved_together(polygon, part)
            case kinds.Fit() | kinds.Touch():
                raise AssertionError("the mechanism itself is drawn before")
            case kinds.Ray() | kinds.Arc() | kinds.Meet() | kinds.Swing():
                raise AssertionError("lines cross inside an equation")
            case _:
                assert_never(part)
    yield from gear_circles(polygon) if plane == "velocity" else ()


def _renamed(polygon: PolygonReading) -> Iterator[Entry]:
    """Letters that are taken: beside a point P the pole has another one; said once, in the first polygon."""
    reading, pole, nodes = polygon.reading, polygon.construction.pole, polygon.construction.nodes
    if polygon.plane == "velocity" and pole != "p":
        yield Sentence(reading.say("derivation.renamed pole", letter="P", pole=names.point(pole)))
    tips: dict[str, str] = {}  # of normal and Coriolis components: the first of each that ends at a corner of its own
    for part in polygon.parts:
        for step in part.steps if isinstance(part, Equation) else (part,):
            if isinstance(step, kinds.LayOff) and step.term.part in ("n", "k") and nodes[step.tip].site is None:
                tips.setdefault(step.term.part, step.tip)
    letters = {point[0] for point in reading.mechanism.points}
    for kind, tip in tips.items():
        if kind.upper() in letters and not tip.startswith(kind):
            words = {"letter": kind.upper(), "part": reading.say(f"derivation.tips {kind}"), "tip": tip[0]}
            yield Sentence(reading.say("derivation.renamed tips", **words))


def _pole(polygon: PolygonReading, step: kinds.Given) -> Iterator[Entry]:
    """The pole with the fixed points; then the links that drivers at rest hold still: their points are fixed, too."""
    reading, pole, owners = polygon.reading, names.point(step.point), polygon.reading.mechanism.owners
    first = next((part for part in polygon.parts if isinstance(part, Equation)), None)
    if first is not None and any(isinstance(other, kinds.Given) for other in first.steps):
        yield Sentence(reading.say("derivation.pole last", pole=pole))
    elif not step.also:
        yield Sentence(reading.say("derivation.pole", pole=pole))
    else:
        nodes = reading.listed([names.point(node) for node in step.also])
        fixed = reading.listed([_fixed_point(polygon, node) for node in step.also])
        several = len(step.also) > 1
        yield Sentence(reading.say("derivation.pole fixed", which=several, pole=pole, points=fixed, nodes=nodes))
    links = [link for link in reading.mechanism.moving if reading.stands(link)]
    if links:
        held = dict.fromkeys(held_labels(reading.method, polygon.plane, reading.rested).values())
        points = [names.point(p) for p in held if not all(map(reading.stands, owners.get(p, ())))]
        words = {"points": reading.listed(points), "pole": names.point(polygon.construction.pole)}
        words = {"fixed": reading.say("derivation.as fixed", which=len(points) > 1, **words)}
        words["links"] = reading.links(links)
        yield Sentence(reading.say("derivation.held still", which=len(links) > 1, **words))


def _fixed_point(polygon: PolygonReading, node: str) -> str:
    """`D`; `D4 (at D)` where points of several links lie there."""
    of, site, reading = polygon.of(node), polygon.construction.nodes[node].site, polygon.reading
    if site is None or of == site.point:
        return names.point(of)
    return names.point(of) + reading.note(reading.say("derivation.at point", point=names.point(site.point)))


def _rotation(polygon: PolygonReading, step: kinds.Measure) -> Iterator[Entry]:
    """omega or alpha of a link, then of those that keep their angle to it."""
    reading, plane, ends = polygon.reading, polygon.plane, (step.tail, step.head)
    if polygon.plane == "acceleration" and not polygon.written(*ends):
        # both ends are known from elsewhere: only the part across the lever turns the link
        across = float(reading.usual.motion(abs(_across_lever(polygon, step)), plane).real)
        across = float(reading.ruler.read(across, plane).real) if reading.ruler else across
        length_mm, tail = across / polygon.scale, _own_node(polygon, step.tail, step.lever[0])
        name = polygon.seen(polygon.of(step.head), polygon.of(tail), "t")
        numbers = Operand(polygon.scale) * Operand(length_mm)
        words = {"tangential": Calculation(name, (), numbers, across, names.UNIT[plane]).text}
        words |= {"ends": names.stretch(*ends), "line": names.pair(*step.lever)}
        yield Sentence(reading.say("derivation.tangential part", **words))
        yield _rate(polygon, step, name, length_mm)
    else:
        name, contacts = contacted(polygon, step)
        name = name or polygon.name(*ends)
        if contacts:
            yield from same_velocities(polygon, step)
        yield _rate(polygon, step, name, polygon.length_mm(*ends), direct=True)
        if len(contacts) == 1 and (check := checked(polygon, contacts[0])):
            yield Sentence(check)
        if polygon.plane == "velocity" and not polygon.arrow(*ends):
            rests = step.tail == polygon.construction.pole
            which = 1 if rests else 2 * only_translates(reading.method, reading.plot, step.of)
            yield Sentence(reading.say("derivation.rest now", which=which, name=name, link=reading.link(step.of)))
    others = reading.group(step.of)
    held = [other for other in others if not _driven_between(polygon, other, step.of)]
    if held and polygon.plane == "velocity":
        yield _held(reading, (*held, step.of))
    for other in others:
        yield _kept_angle(polygon, other, step.of)


def _rate(polygon: PolygonReading, step: kinds.Measure, name: str, length: float, direct: bool = False) -> Calculation:
    """`ω3 = v_B3/l_BD = μ_v·pb3/(μ_l·BD) = 0.01 × 27.12/(0.001 × 69.2) = 3.919 rad/s (clockwise)`; length in mm."""
    reading, line = polygon.reading, names.pair(*step.lever)
    lever, scale = reading.distance(*step.lever), reading.scales["length"]
    measured = f"{names.SCALE[polygon.plane]}·{names.stretch(step.tail, step.head)}/(μ_l·{line})"
    formulas = (f"{name}/l_{line}", measured) if direct else (f"{name}/l_{line}",)
    numbers = Operand(polygon.scale) * Operand(length) / (Operand(scale) * Operand(lever / scale))
    value, note = length * polygon.scale / lever, ""
    if length:
        note = reading.say("common.ccw" if _across_lever(polygon, step) > 0 else "common.cw")
    if length and step == polygon.first_lever:  # also how it is found
        tail, head = (names.point(p) for p in step.lever)
        words = {"stretch": names.stretch(step.tail, step.head), "rate": polygon.rate(step.of)}
        note = reading.say("derivation.sense rule", sense=note, head=head, tail=tail, **words)
    return Calculation(polygon.rate(step.of), formulas, numbers, value, polygon.rate_unit, note)


def _across_lever(polygon: PolygonReading, step: kinds.Measure) -> float:
    """Speed across the lever, positive where it turns it counter-clockwise."""
    arm = polygon.reading.arm(*step.lever)
    return float(cross(arm, polygon.arrow(step.tail, step.head))) / abs(arm)


def _driven_groups(polygon: PolygonReading) -> Iterator[Entry]:
    """Before the first equation: links that cannot turn, and those that turn with the driven ones."""
    reading, turns = polygon.reading, polygon.reading.plot.facts.turns
    still = [link for link in reading.mechanism.moving if reading.translates(link)]
    if still and polygon.plane == "velocity":
        zero = [" = ".join([*(reading.rate(symbol, link) for link in still), "0"]) for symbol in ("ω", "α")]
        words = {"links": reading.links(still), "rates": reading.joined(zero)}
        yield Sentence(reading.say("derivation.never turn", which=len(still) > 1, **words))
    driven = dict.fromkeys(d.link for d in reading.mechanism.drivers if d.kind != "slide" and d.from_link == FRAME)
    for link in reading.mechanism.moving:
        if turns[link].base == FRAME and turns[link].drivers and link not in driven:
            like = [other for other in driven if turns[other].drivers == turns[link].drivers]
            if like and polygon.plane == "velocity":
                yield _held(reading, (link, *like))
            yield _kept_angle(polygon, link, FRAME)


def _held(reading: Reading, links: Sequence[str]) -> Sentence:
    """Links that sliding pairs keep from turning against each other: two by one, or several in a row."""
    pairs = [{slide.block, slide.line.link} for slide in reading.method.structure.slides.values()]
    return Sentence(reading.say("derivation.held", which={*links} not in pairs, links=reading.links(links)))


def _kept_angle(polygon: PolygonReading, link: str, other: str) -> Calculation:
    """`ω2 = ω3`, or `ω2 = ω1 + ω21` with a driven rotation between them; the frame adds nothing."""
    reading, plane = polygon.reading, polygon.plane
    value, driven = reading.turning(link, plane), _driven_between(polygon, link, other)
    parts = [] if other == FRAME else [(1, polygon.rate(other), reading.turning(reading.body(other), plane))]
    for k, sign, rate in driven:
        symbol = reading.against(reading.mechanism.drivers[k], names.RATE[plane])
        parts.append((sign, symbol, float(reading.usual.rate(rate, plane).real)))
    (sign, first, _), *more = parts
    formula = ("−" if sign < 0 else "") + first + "".join(f" {'−' if s < 0 else '+'} {text}" for s, text, _ in more)
    if not driven or (not more and sign > 0):
        return Calculation(polygon.rate(link), (formula,), "", abs(value), polygon.rate_unit, reading.sense(value))
    note = reading.signed(value)
    numbers = joined_sum([(sign, Operand(rate)) for sign, _, rate in parts]) if more else ""
    return Calculation(polygon.rate(link), (formula,), numbers, value, polygon.rate_unit, note, relation=bool(more))


def _driven_between(polygon: PolygonReading, link: str, other: str) -> list[tuple[int, int, float]]:
    """Drivers that turn `link` against `other`, each with its sign and its rate."""
    facts = polygon.reading.plot.facts
    rates = facts.rates if polygon.plane == "velocity" else facts.accelerations
    count: dict[int, int] = {}
    for member, way in ((link, 1), (other, -1)):
        for k, sign in facts.turns[member].drivers:
            count[k] = count.get(k, 0) + way * sign
    return [(k, sign, float(rates[k])) for k, sign in count.items() if sign]


def _sliding(polygon: PolygonReading, step: kinds.Measure) -> Iterator[Entry]:
    """The speed at which a named displacement grows; of others, which distance grows or shrinks."""
    reading, plane = polygon.reading, polygon.plane
    pair = reading.method.structure.slides[step.of]
    table = reading.plot.s_rate if plane == "velocity" else reading.plot.s_acceleration
    value, size = float(table[step.of]), polygon.read(step.tail, step.head)
    name = polygon.name(step.tail, step.head)
    if pair.named:
        formula = f"−{name}" if size and value <= 0 else name
        symbol = names.of_slide(names.SLIDING[plane], step.of)
        yield Calculation(symbol, (formula,), "", value if size else 0.0, names.UNIT[plane])
    elif plane == "velocity" and size and pair.guide != FRAME and pair.line.named:
        stretch = names.pair(pair.line.origin, pair.point)
        shrinks = value * float(reading.plot.s[step.of]) <= 0
        yield Sentence(reading.say("derivation.grows", which=shrinks, stretch=stretch, size=number(size)))


def _image(polygon: PolygonReading, step: kinds.Image) -> Iterator[Entry]:
    """A further point of a link by the figure similar to it, then its motion."""
    reading = polygon.reading
    first, second, third = step.corners
    corners = [_own_node(polygon, node, corner) for node, corner in zip(step.base, step.corners, strict=False)]
    words = {"image": reading.say(f"derivation.image {polygon.plane}"), "link": reading.link(step.link)}
    words |= {"point": names.point(step.point), "corner": names.point(third)}
    words |= {"small": names.stretch(*corners), "large": names.point(first) + names.point(second)}
    one, other = (reading.arm(p, third) for p in (first, second))
    row = f"{names.triangle(*corners, step.point)} ∽ {names.triangle(*step.corners)}"
    if not polygon.arrow(*step.base):
        known = polygon.seen(polygon.of(base), "") if (base := step.base[0]) != polygon.construction.pole else "0"
        row = f"{polygon.seen(polygon.of(step.point), '')} = {known}"
        sentence = reading.say("derivation.image point", **words)
    elif aside(one, other) <= reading.noise * max(abs(one), abs(other)):
        lengths = [reading.distance(first, p) for p in (third, second)]  # `dc = db3 · CD/BD = .. = 18.81 mm`
        small, figured = polygon.length_mm(*step.base), figures(*(each / reading.scales["length"] for each in lengths))
        formula = f"{words['small']} × {names.pair(first, third)}/{names.pair(first, second)}"
        name, numbers = names.stretch(corners[0], step.point), Operand(small) * figured[0] / figured[1]
        row = f"{name} = {formula}"
        ratio = Calculation(name, (formula,), numbers, small * lengths[0] / lengths[1], "mm").text
        along = float(dot(one, reading.arm(first, second))) / abs(reading.arm(first, second)) ** 2
        key = "between" if 0 <= along <= 1 else "beyond" if along > 1 else "before"
        ends = {"base": names.point(corners[0]), "end": names.point(corners[1])}
        words["side"] = reading.say(f"derivation.image {key}", small=words["small"], **ends)
        sentence = reading.say("derivation.image line", ratio=ratio, **words)
    else:
        words |= {"small": names.triangle(*corners, step.point), "large": names.triangle(*step.corners)}
        ccw = float(cross(reading.arm(first, second), one)) > 0
        sentence = reading.say("derivation.image triangle", sense=reading.sense(1 if ccw else -1), **words)
    yield polygon.sentence(step, sentence, row)
    motion, arm = polygon.measured_absolute(step.point), _crank_arm(polygon, step)
    yield replace(motion, formulas=(f"{polygon.rate(step.link)} l_{arm}", *motion.formulas)) if arm else motion


def _crank_arm(polygon: PolygonReading, step: kinds.Image) -> str:
    """The arm from a driven link's pivot on the frame to a further point of it, `AC` of v_C = ω2 l_AC; "" of others."""
    reading, facts = polygon.reading, polygon.reading.plot.facts
    turn, owners = facts.turns[step.link], reading.mechanism.owners
    if polygon.plane != "velocity" or turn.base != facts.turns[facts.frame].base or not turn.drivers:
        return ""
    ends = zip(step.base, step.corners, strict=False)
    pivots = (corner for node, corner in ends if node == polygon.construction.pole and FRAME in owners.get(corner, ()))
    pivot, moves = next(pivots, ""), polygon.size(polygon.construction.pole, step.point)
    return names.pair(pivot, step.corners[2]) if pivot and moves else ""


def _own_node(polygon: PolygonReading, node: str, corner: str) -> str:
    """A fixed point's own letter rather than the pole's."""
    if node != polygon.construction.pole:
        return node
    nodes = polygon.construction.nodes.values()
    fixed = (n.name for n in nodes if n.site is not None and (n.site.point, n.site.link) == (corner, FRAME))
    return next(fixed, node)
