"""Pure rolling in words: how far wheels have turned, where they touch, and the relation between their motions."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import degrees

from graphkin.base.value import frozen
from graphkin.construction import Drawn, Equation, InStep, Measure, Plane, Roll, Simultaneous, Step, Touch, slide_key
from graphkin.model.mechanism import FRAME, Driver
from graphkin.planning.equivalent import Contact
from graphkin.planning.images import imaged_gears
from graphkin.planning.method import made
from graphkin.planning.position import touching
from graphkin.say import names
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.figures import Formula, Operand, joined_sum
from graphkin.say.numbers import DIGITS
from graphkin.say.plane import PolygonReading
from graphkin.say.reading import Reading

_CANCELLED = 1e-9  # the part of one side that is left of both where they cancel


@frozen
class RollingRelation:
    """`r1(ω1 − ω4) + r2(ω2 − ω4) = 0` of two wheels; `r3(ω3 − ω7) + ṡ_C = 0` of one on a line.

    symbol  how the turning of a link is written; value: its size; slid, slid_value: the same of the wheel's path
    radian  by what turnings are multiplied that are not given in radians
    """

    reading: Reading
    contact: Contact
    symbol: Callable[[str], str]
    value: Callable[[str], float]
    slid: str
    slid_value: float
    radian: float = 1.0

    @property
    def text(self) -> str:
        if self.contact.slide:
            (one, other), second = self.contact.wheels, self.radius(1)
            sign = "+" if self.contact.on_slide > 0 else "−"
            turning = f" {self.symbol(other)}" if one == FRAME else f"({self.symbol(other)} − {self.symbol(one)})"
            return f"{second}{turning} {sign} {self.slid} = 0"
        first, second = (self._half(k)[0] for k in self._order)
        still = [link for link in self.contact.wheels if link == FRAME != self.contact.arm]
        notes = "".join(self.reading.note(f"{self.symbol(link)} = 0") for link in still)
        return f"{first} {self._sign} {second} = 0{notes}"

    @property
    def figures(self) -> str:
        """`0.03 × 10 + 0.02 × (−15) = 0` of the two sides of a pair of wheels; ≈ where figures are cut off."""
        one, other = (self._half(k)[1] for k in self._order)
        both = one + other if self._sign == "+" else one - other
        return f"{both.text()} {'=' if abs(both.worth(DIGITS)) < _CANCELLED * abs(one.worth(DIGITS)) else '≈'} 0"

    @property
    def _order(self) -> tuple[int, int]:
        """The wheel whose radius counts positive first."""
        return (0, 1) if self.contact.radii[0] > 0 else (1, 0)

    @property
    def _sign(self) -> str:
        return "+" if self.contact.radii[0] * self.contact.radii[1] > 0 else "−"

    def _half(self, k: int) -> tuple[str, Formula]:
        """`r1(ω1 − ω4)`, `r1 ω1` about fixed centres; and the same in figures, `0.03 × (10 − 2)`."""
        wheel, arm = self.contact.wheels[k], self.contact.arm
        turn, figure, size = self.symbol(wheel), self._figure(wheel), Operand(abs(self.contact.radii[k]))
        if arm == FRAME:
            return f"{self.radius(k)} {turn}", size * figure
        return f"{self.radius(k)}({turn} − {self.symbol(arm)})", size * (figure - self._figure(arm))

    def radius(self, k: int) -> str:
        return self.reading.radius(self.contact.wheels[k], abs(self.contact.radii[k]))

    def _figure(self, link: str) -> Formula:
        return Operand(self.value(link))

    def solved(self, unknown: str, value: float, unit: str, note: str) -> Calculation:
        """The turning of `unknown` from that of the others, with its figures."""
        formula, numbers = self._solution(unknown)
        formulas = (formula,) if formula else ()
        return Calculation(self.symbol(unknown), formulas, numbers, value, unit, note)

    def _solution(self, unknown: str) -> tuple[str, Formula | str]:
        """`ω4 − r1(ω1 − ω4)/r2`, `ω1 − ṡ_C/r3` on a line, and in figures; nothing where more turnings are unknown."""
        contact = self.contact
        if unknown not in contact.wheels:
            return "", ""
        k = contact.wheels.index(unknown)
        if contact.slide:
            if not k:
                return "", ""
            base, minus, text, moved = contact.wheels[0], contact.on_slide > 0, self.slid, Operand(self.slid_value)
            turned = Operand(self.radian) * moved if self.radian != 1.0 else moved
        else:
            base, minus, (text, turned) = contact.arm, self._sign == "+", self._half(1 - k)
        formula, turned = f"{text}/{self.radius(k)}", turned / Operand(abs(contact.radii[k]))
        if base == FRAME:
            return (f"−{formula}", -turned) if minus else (formula, turned)
        start = self._figure(base)
        return f"{self.symbol(base)} {'−' if minus else '+'} {formula}", start - turned if minus else start + turned

    def slid_by(self, slide: str, plane: Plane) -> tuple[tuple[str, ...], Formula | str]:
        """`ṡ_A − r2(ω2 − ω1)`: one of the displacements that make up a wheel's way, by the others; r ω alone of one."""
        contact, reading = self.contact, self.reading
        shares = dict(contact.way or ((contact.slide, 1.0),))
        if slide not in shares:
            return (), ""
        (track, wheel), own = contact.wheels, shares[slide]
        terms: list[tuple[float, str, Formula]] = []
        for other, share in shares.items():
            if other != slide:
                name = reading.displacement(names.SLIDING[plane], other)
                terms.append((-share / own, name, Operand(reading.sliding(other, plane))))
        turning, turned = f" {self.symbol(wheel)}", self._figure(wheel)
        if track != FRAME and not reading.translates(track):
            turning, turned = f"({turning[1:]} − {self.symbol(track)})", turned - self._figure(track)
        size = Operand(abs(contact.radii[1]))
        terms.append((-contact.on_slide / own, f"{self.radius(1)}{turning}", size * turned))
        terms.sort(key=lambda term: term[0] < 0)
        text = _signed_names([(sign, name) for sign, name, _ in terms])
        return (text,), joined_sum([(sign, figure) for sign, _, figure in terms])


def _signed_names(terms: list[tuple[float, str]]) -> str:
    """`ṡ_A − r2 ω2`, `−r2 ω2`."""
    (sign, name), *more = terms
    return ("−" if sign < 0 else "") + name + "".join(f" {'−' if s < 0 else '+'} {other}" for s, other in more)


def rate_relation(polygon: PolygonReading, contact: InStep) -> RollingRelation:
    """The relation between angular velocities, or accelerations."""
    reading, plane = polygon.reading, polygon.plane
    moved = reading.sliding(contact.slide, plane) if contact.slide else 0.0
    slid = _slid(reading, names.SLIDING[plane], contact)
    kind = _contact(reading, contact.name)
    return RollingRelation(reading, kind, polygon.rate, lambda link: reading.turning(link, plane), slid, moved)


def turning_relation(reading: Reading, contact: InStep) -> RollingRelation:
    """The relation between the turns since the drawn position, in degrees."""
    plot, kind = reading.plot, _contact(reading, contact.name)
    drawn = plot.facts.drawn

    def value(link: str) -> float:
        return degrees(float(reading.usual.cut(float(plot.theta[link]) - drawn.get(link, 0.0), "rad").real))

    moved = float(plot.s[kind.slide]) - drawn[slide_key(kind.slide)] if kind.slide else 0.0
    moved = float(reading.usual.cut(moved, "m").real)
    slid = _slid(reading, "Δs", contact)
    return RollingRelation(reading, kind, lambda link: reading.rate("Δθ", link), value, slid, moved, degrees(1.0))


def _contact(reading: Reading, name: str) -> Contact:
    return next(contact for contact in reading.method.structure.contacts if contact.name == name)


def _slid(reading: Reading, symbol: str, contact: InStep) -> str:
    """`ṡ_ram`, or `ṡ_C` where only the centre has a name; `(ṡ_C − ṡ_ram)` where it is made up of others."""
    if not contact.slide:
        return ""
    if not contact.way:
        return reading.displacement(symbol, contact.slide)
    shares = sorted(contact.way, key=lambda part: part[1] < 0)
    text = _signed_names([(share, reading.displacement(symbol, slide)) for slide, share in shares])
    return f"({text})" if len(shares) > 1 or text.startswith("−") else text


def steady(polygon: PolygonReading) -> Iterator[Entry]:
    """The wheels that need no acceleration polygon: they turn at steady rates, by their relations."""
    reading, turns = polygon.reading, polygon.reading.plot.facts.turns
    links = [link for link in reading.mechanism.moving if ("alpha", turns[link].base) in reading.steady]
    if links and polygon.plane == "acceleration":
        velocity = PolygonReading(reading, "velocity")
        contacts = (c for c in reading.method.structure.contacts if {*links} & {link for link, _ in c.angles})
        steps = (InStep(c.name, c.angles, c.slide, c.on_slide, c.way) for c in contacts)
        relations = reading.listed([rate_relation(velocity, step).text for step in steps])
        rates = reading.listed([_driven_rate(reading, driver) for driver in reading.mechanism.drivers])
        zero = " = ".join([*(reading.rate("α", link) for link in links), "0"])
        yield Sentence(reading.say("contacts.steady", relations=relations, rates=rates, zero=zero))


def _driven_rate(reading: Reading, driver: Driver) -> str:
    return reading.displacement("ṡ", driver.link) if driver.kind == "slide" else reading.against(driver, "ω")


def rolled(reading: Reading, step: Roll) -> Iterator[Entry]:
    """The turn of a wheel since the drawn position."""
    relation = turning_relation(reading, step.contact)
    contact, links = relation.contact, _unknown(reading, step)
    yield Sentence(reading.say("contacts.rolled", wheels=reading.links(contact.wheels), relation=relation.text))
    if not links:
        way = float(reading.plot.s[step.slide]) - reading.plot.facts.drawn[slide_key(step.slide)]
        yield Calculation(reading.displacement("Δs", step.slide), (), "", way * 1000, "mm")
    elif len(links) > 1:
        yield from _rotated(relation, links, reading.rotations(links, "Δθ", "Δφ"), "°")
    else:
        link, value = links[0], relation.value(links[0])
        name = reading.rate("Δθ", link)
        yield Sentence(reading.say("contacts.turned by", link=reading.link(link), name=name))
        if contact.slide:
            yield Calculation(relation.slid, (), "", relation.slid_value * 1000, "mm")
        yield relation.solved(link, value, "°", reading.signed(value))


def _unknown(reading: Reading, step: Roll) -> list[str]:
    """The links whose turning a contact gives: one, or more that drivers turn against each other."""
    turns = reading.plot.facts.turns
    return [link for link, _ in step.contact.angles if step.angle and turns[link].base == step.angle]


def _rotated(relation: RollingRelation, links: list[str], sums: list[str], unit: str) -> Iterator[Entry]:
    """The turnings of links that a driver turns against each other, from the relation and their sums."""
    reading = relation.reading
    yield Sentence(reading.say("contacts.with rotations", sums=reading.listed(sums)))
    for link in links:
        value = relation.value(link)
        yield Calculation(relation.symbol(link), (), "", value, unit, reading.signed(value))


def touched(reading: Reading, step: Touch) -> str:
    """The point in which two wheels, or a wheel and its track, touch."""
    contact = next(c for letter, c in touching(reading.method.structure) if letter == step.point)
    first, second = (reading.link(link) for link in contact.wheels)
    reach = reading.distance(step.centre, step.point)
    length = f"{names.pair(step.centre, step.point)} = {reading.on_paper(reach)} mm"
    words = {"point": step.point, "centre": names.point(step.centre), "length": length}
    if contact.slide:
        return reading.say("contacts.touch line", first=second, second=first, **words)
    words |= {"first": first, "second": second, "line": names.pair(*contact.centres)}
    away = {centre: reading.distance(centre, step.point) for centre in contact.centres}
    if max(away.values()) < reading.distance(*contact.centres):
        return reading.say("contacts.touch wheels", **words)
    end = names.point(min(away, key=away.__getitem__))
    return reading.say("contacts.touch inside", end=end, **words)


def rolling(polygon: PolygonReading, step: Roll) -> Iterator[Entry]:
    """The last unknown of a contact from the relation of its wheels."""
    reading, plane = polygon.reading, polygon.plane
    relation, links = rate_relation(polygon, step.contact), _unknown(polygon.reading, step)
    wheels = reading.links(relation.contact.wheels)
    yield Sentence(reading.say("contacts.rolling relation", wheels=wheels, relation=relation.text))
    if len(links) > 1:
        yield from _rotated(relation, links, reading.rotations(links, names.RATE[plane]), polygon.rate_unit)
    elif links:
        value = relation.value(links[0])
        yield relation.solved(links[0], value, polygon.rate_unit, reading.signed(value))
    else:
        name, value = reading.displacement(names.SLIDING[plane], step.slide), reading.sliding(step.slide, plane)
        formula, numbers = relation.slid_by(step.slide, plane)
        yield Calculation(name, formula, numbers, value, names.UNIT[plane], relation=bool(formula))


def checked(polygon: PolygonReading, contact: Contact) -> str:
    """The relation of two wheels with its figures; "" on a line, where it says nothing new, or with one not told."""
    turns, bases = polygon.reading.plot.facts.turns, {FRAME}
    for part in polygon.parts:
        if isinstance(part, Measure) and part.quantity in ("omega", "alpha"):
            bases.add(turns[part.of].base)
        elif isinstance(part, Roll) and part.angle:
            bases.add(part.angle)
        elif isinstance(part, Simultaneous):
            bases.update(part.angles)
    if contact.slide or not all(turns[link].base in bases for link, _ in contact.angles):
        return ""
    relation = rate_relation(polygon, InStep(contact.name, contact.angles))
    return polygon.reading.say("contacts.check relation", relation=relation.text, figures=relation.figures)


def contacted(polygon: PolygonReading, step: Measure) -> tuple[str, list[Contact]]:
    """The contacts at which the rotation of a wheel is measured in the velocity polygon.

    Before them the name of the arrow between the points of which one is, or both are, contacts; "" of none.
    """
    letters = dict(touching(polygon.reading.method.structure))
    contacts = [letters[point] for point, _ in _touching(polygon, step)] if polygon.plane == "velocity" else []
    if not contacts:
        return "", []
    (tail, from_node), (head, onto) = zip(step.lever, (step.tail, step.head), strict=True)
    of = polygon.reading.numbered(head, step.of) if head in letters else polygon.of(onto)
    if tail in letters:
        seen_from = polygon.reading.numbered(tail, step.of)
    else:
        seen_from = "" if from_node == polygon.construction.pole else polygon.of(from_node)
    return polygon.seen(of, seen_from), contacts


def _touching(polygon: PolygonReading, part: Step | Equation) -> dict[tuple[str, str], str]:
    """The contacts of a wheel, by letter and wheel, that a rotation is measured at, or an equation starts from."""
    nodes = dict[tuple[str, str], str]()
    if isinstance(part, Measure):
        nodes = {(point, part.of): node for point, node in zip(part.lever, (part.tail, part.head), strict=True)}
    elif isinstance(part, Equation):
        drawn = (term for term in part.left + part.right if isinstance(term.size, Drawn) and term.sites)
        nodes = {(term.sites[0].point, term.sites[0].link): term.head for term in drawn}
    contacts = touching(polygon.reading.method.structure)
    wheels = {(letter, wheel) for letter, contact in contacts for wheel in contact.wheels}
    return {place: node for place, node in nodes.items() if place in wheels}


def same_velocities(polygon: PolygonReading, part: Step | Equation) -> Iterator[Entry]:
    """Pure rolling at the contacts that a part of the velocity polygon is the first to use."""
    reading = polygon.reading
    letters = dict(touching(reading.method.structure))
    for (letter, wheel), node in _touching(polygon, part).items() if polygon.plane == "velocity" else ():
        if next(other for other in polygon.parts if (letter, wheel) in _touching(polygon, other)) == part:
            other = next(link for link in letters[letter].wheels if link != wheel)
            of, same = (polygon.seen(reading.numbered(letter, link), "") for link in (wheel, other))
            key = "contacts.no velocity" if other == FRAME else "contacts.same velocity"
            words = {"first": reading.link(wheel), "second": reading.link(other), "point": letter}
            yield Sentence(reading.say(key, of=of, other=same, node=names.point(node), **words))


def gear_circles(polygon: PolygonReading) -> Iterator[Entry]:
    """The circles in a velocity polygon that are the images of gears, of those whose centres have been found; the point
    that is that of one at rest."""
    say, circles, pole = polygon.reading.say, list[str](), polygon.construction.pole
    parts = ((part.steps if isinstance(part, Equation) else (part,)) for part in polygon.parts)
    found = {pole, *(point for steps in parts for step in steps for point in made(step))}
    for wheel, name, node in (each for each in imaged_gears(polygon.reading.method) if each[2] in found):
        words = {"name": names.point(name), "centre": names.point(node)}
        if wheel.link == FRAME:
            yield Sentence(say("contacts.gear at rest", **words))
        else:
            circles.append(say("contacts.gear image", **words))
    if circles:
        which = int(len(circles) > 1)
        yield Sentence(say("contacts.gear images", circles=polygon.reading.listed(circles), which=which))
