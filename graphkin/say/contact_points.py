"""The point in which wheels touch without sliding: there both have one velocity, by which a rotation is measured."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.base.value import frozen
from graphkin.construction import Drawn, Equation, Measure, Step
from graphkin.model.mechanism import FRAME
from graphkin.planning.equivalent import Contact
from graphkin.planning.position import touching
from graphkin.say import names
from graphkin.say.entry import Entry, Sentence
from graphkin.say.plane import PolygonReading


@frozen
class Contacted:
    """A wheel whose rotation is measured between points of which one is, or both are, contacts.

    name      what the arrow between them is called
    contacts  at its ends
    """

    name: str
    contacts: tuple[Contact, ...]


def contacted(polygon: PolygonReading, step: Measure) -> Contacted | None:
    """The contacts at which the rotation of a wheel is measured in the velocity polygon."""
    if polygon.plane != "velocity":
        return None
    reading = polygon.reading
    letters = dict(touching(reading.method.structure))
    found = tuple(letters[point] for point, _ in _touching(polygon, step))
    if not found:
        return None
    (tail, from_node), (head, onto) = zip(step.lever, (step.tail, step.head), strict=True)
    of = reading.numbered(head, step.of) if head in letters else polygon.of(onto)
    if tail in letters:
        seen_from = reading.numbered(tail, step.of)
    else:
        seen_from = "" if from_node == polygon.construction.pole else polygon.of(from_node)
    return Contacted(polygon.seen(of, seen_from), found)


def _touching(polygon: PolygonReading, part: Step | Equation) -> dict[tuple[str, str], str]:
    """The contacts of a wheel, by letter and wheel, that a rotation is measured at, or an equation starts from."""
    letters, found = dict(touching(polygon.reading.method.structure)), dict[tuple[str, str], str]()
    if isinstance(part, Measure):
        found = {(point, part.of): node for point, node in zip(part.lever, (part.tail, part.head), strict=True)}
    elif isinstance(part, Equation):
        drawn = (term for term in part.left + part.right if isinstance(term.size, Drawn) and term.sites)
        found = {(term.sites[0].point, term.sites[0].link): term.head for term in drawn}
    wheels = {(letter, wheel) for letter, contact in letters.items() for wheel in contact.wheels}
    return {place: node for place, node in found.items() if place in wheels}


def same_velocities(polygon: PolygonReading, part: Step | Equation) -> Iterator[Entry]:
    """Pure rolling at the contacts that a part of the velocity polygon is the first to use."""
    letters = dict(touching(polygon.reading.method.structure))
    for (letter, wheel), node in _touching(polygon, part).items() if polygon.plane == "velocity" else ():
        if next(other for other in polygon.parts if (letter, wheel) in _touching(polygon, other)) == part:
            yield Sentence(_same_velocity(polygon, wheel, letter, letters[letter], node))


def _same_velocity(polygon: PolygonReading, wheel: str, letter: str, contact: Contact, node: str) -> str:
    """Pure rolling: the two points at a contact move alike."""
    reading = polygon.reading
    other = next(link for link in contact.wheels if link != wheel)
    of, same = (polygon.seen(reading.numbered(letter, link), "") for link in (wheel, other))
    key = "contacts.no velocity" if other == FRAME else "contacts.same velocity"
    words = {"first": reading.link(wheel), "second": reading.link(other), "point": letter}
    return reading.say(key, of=of, other=same, node=names.point(node), **words)
