"""Pure rolling in words: how far wheels have turned, where they touch, and what the contact gives."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.construction import InStep, Measure, Roll, Simultaneous, Touch, slide_key
from graphkin.mechanism import FRAME
from graphkin.planning.equivalent import Contact
from graphkin.planning.position import touching
from graphkin.say import names
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.plane import Polygon
from graphkin.say.reading import Reading
from graphkin.say.rolling_relation import path_name, relation_of, turned

# --- position -----------------------------------------------------------------------------------


def rolled(reading: Reading, step: Roll) -> Iterator[Entry]:
    """How far a wheel has turned since the drawn position."""
    relation = turned(reading, step.contact)
    contact, moved = relation.contact, relation.slid_value
    wheels = reading.listed([reading.link(link) for link in contact.wheels])
    yield Sentence(reading.say("contacts.rolled", wheels=wheels, relation=relation.text))
    link = _unknown(reading, step)
    if not link:
        way = float(reading.plot.s[step.slide]) - reading.plot.facts.drawn[slide_key(step.slide)]
        yield Calculation(path_name(reading, "Δs", step.slide), (), "", way * 1000, "mm")
        return
    name, value = reading.rate("Δθ", link), relation.value(link)
    yield Sentence(reading.say("contacts.turned by", link=reading.link(link), name=name))
    if contact.slide:
        yield Calculation(relation.slid, (), "", moved * 1000, "mm")
    yield relation.solved(link, value, "°", reading.signed(value))


def _unknown(reading: Reading, step: Roll) -> str:
    """The wheel whose turning a contact gives; "" for a displacement."""
    turns = reading.plot.facts.turns
    members = [link for link, _ in step.contact.angles if step.angle and turns[link].base == step.angle]
    return members[0] if members else ""


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


def rolling(polygon: Polygon, step: Roll) -> Iterator[Entry]:
    """The last unknown of a contact from the relation of its wheels."""
    reading = polygon.reading
    relation = relation_of(polygon, step.contact)
    wheels = reading.listed([reading.link(link) for link in relation.contact.wheels])
    yield Sentence(reading.say("contacts.rolling relation", wheels=wheels, relation=relation.text))
    link = _unknown(reading, step)
    if link:
        yield relation.solved(link, relation.value(link), polygon.rate_unit, reading.signed(relation.value(link)))
    else:
        slide, table = names.SLIDING[polygon.plane], polygon.reading.plot
        value = float((table.s_rate if polygon.plane == "velocity" else table.s_acceleration)[step.slide])
        value = reading.usual.motion(value, polygon.plane)
        formula, numbers = relation.slid_by(step.slide, polygon)
        yield Calculation(path_name(reading, slide, step.slide), formula, numbers, value, names.UNIT[polygon.plane])


def checked(polygon: Polygon, contact: Contact) -> str:
    """The rolling relation of two wheels with the figures found.

    "" of a wheel on a line, where it says nothing new, and where some rotation in it is not told.
    """
    turning = [link for link, _ in contact.angles if not _rate_told(polygon, link)]
    if contact.slide or turning:
        return ""
    relation = relation_of(polygon, InStep(contact.name, contact.angles))
    return polygon.reading.say("contacts.check relation", relation=relation.text, figures=relation.figures)


def _rate_told(polygon: Polygon, link: str) -> bool:
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
