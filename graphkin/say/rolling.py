"""Pure rolling in words: how far wheels have turned, where they touch, and what the contact gives."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.construction import InStep, Measure, Roll, Simultaneous, Touch, slide_key
from graphkin.model.mechanism import FRAME
from graphkin.planning.equivalent import Contact
from graphkin.planning.position import touching
from graphkin.say import names
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.plane import PolygonReading
from graphkin.say.reading import Reading
from graphkin.say.rolling_relation import RollingRelation, path_name, relation_of, turned

# --- position -----------------------------------------------------------------------------------


def rolled(reading: Reading, step: Roll) -> Iterator[Entry]:
    """How far a wheel has turned since the drawn position."""
    relation = turned(reading, step.contact)
    contact, moved = relation.contact, relation.slid_value
    wheels = reading.listed([reading.link(link) for link in contact.wheels])
    yield Sentence(reading.say("contacts.rolled", wheels=wheels, relation=relation.text))
    links = _unknown(reading, step)
    if not links:
        way = float(reading.plot.s[step.slide]) - reading.plot.facts.drawn[slide_key(step.slide)]
        yield Calculation(path_name(reading, "Δs", step.slide), (), "", way * 1000, "mm")
        return
    if len(links) > 1:
        yield from _rotated(relation, links, reading.rotations(links, "Δθ", "Δφ"), "°")
        return
    link = links[0]
    name, value = reading.rate("Δθ", link), relation.value(link)
    yield Sentence(reading.say("contacts.turned by", link=reading.link(link), name=name))
    if contact.slide:
        yield Calculation(relation.slid, (), "", moved * 1000, "mm")
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
    """Where two wheels, or a wheel and its track, touch."""
    contact = next(c for letter, c in touching(reading.method.structure) if letter == step.point)
    first, second = (reading.link(link) for link in contact.wheels)
    reach = reading.distance(step.centre, step.point)
    length = f"{names.pair(step.centre, step.point)} = {reading.on_paper(reach)} mm"
    words = {"point": step.point, "centre": names.point(step.centre), "length": length}
    if contact.slide:
        return reading.say("contacts.touch line", first=second, second=first, **words)
    line = names.pair(*contact.centres)
    return reading.say("contacts.touch wheels", first=first, second=second, line=line, **words)


# --- polygons -----------------------------------------------------------------------------------


def rolling(polygon: PolygonReading, step: Roll) -> Iterator[Entry]:
    """The last unknown of a contact from the relation of its wheels."""
    reading = polygon.reading
    relation = relation_of(polygon, step.contact)
    wheels = reading.listed([reading.link(link) for link in relation.contact.wheels])
    yield Sentence(reading.say("contacts.rolling relation", wheels=wheels, relation=relation.text))
    links = _unknown(reading, step)
    if len(links) > 1:
        yield from _rotated(relation, links, reading.rotations(links, names.RATE[polygon.plane]), polygon.rate_unit)
    elif links:
        value = relation.value(links[0])
        yield relation.solved(links[0], value, polygon.rate_unit, reading.signed(value))
    else:
        slide, table = names.SLIDING[polygon.plane], polygon.reading.plot
        value = float((table.s_rate if polygon.plane == "velocity" else table.s_acceleration)[step.slide])
        value = reading.usual.motion(value, polygon.plane)
        formula, numbers = relation.slid_by(step.slide, polygon)
        yield Calculation(path_name(reading, slide, step.slide), formula, numbers, value, names.UNIT[polygon.plane])


def checked(polygon: PolygonReading, contact: Contact) -> str:
    """The rolling relation of two wheels with the figures found.

    "" of a wheel on a line, where it says nothing new, and where some rotation in it is not told.
    """
    turning = [link for link, _ in contact.angles if not _rate_told(polygon, link)]
    if contact.slide or turning:
        return ""
    relation = relation_of(polygon, InStep(contact.name, contact.angles))
    return polygon.reading.say("contacts.check relation", relation=relation.text, figures=relation.figures)


def _rate_told(polygon: PolygonReading, link: str) -> bool:
    """Whether a link's rotation is told, or given."""
    turns = polygon.reading.plot.facts.turns
    if turns[link].base == FRAME:
        return True
    found: set[str] = set()
    for part in polygon.parts:
        if isinstance(part, Measure) and part.quantity in ("omega", "alpha"):
            found.add(turns[part.of].base)
        elif isinstance(part, Roll) and part.angle:
            found.add(part.angle)
        elif isinstance(part, Simultaneous):
            found.update(part.angles)
    return turns[link].base in found
