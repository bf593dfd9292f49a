"""The point in which wheels touch without sliding: there both have one velocity, by which a rotation is measured."""

from __future__ import annotations

from graphkin.construction import Measure
from graphkin.mechanism import FRAME
from graphkin.planning.equivalent import Contact
from graphkin.planning.position import touching
from graphkin.say import names
from graphkin.say.plane import Polygon
from graphkin.value import frozen


@frozen
class Contacted:
    """A wheel whose rotation is measured between points of which one is, or both are, contacts.

    name   what the arrow between them is called
    """

    name: str
    contacts: tuple[tuple[str, Contact, str], ...]
    """Each with its letter and the polygon's point there."""


def contacted(polygon: Polygon, step: Measure) -> Contacted | None:
    """The contacts at which the rotation of a wheel is measured in the velocity polygon."""
    if polygon.plane != "velocity":
        return None
    reading = polygon.reading
    letters = dict(touching(reading.method.structure))
    nodes = zip(step.lever, (step.tail, step.head), strict=True)
    found = tuple((p, letters[p], node) for p, node in nodes if p in letters and step.of in letters[p].wheels)
    if not found:
        return None
    (tail, from_node), (head, _) = zip(step.lever, (step.tail, step.head), strict=True)
    of = reading.numbered(head, step.of)
    if tail in letters:
        seen_from = reading.numbered(tail, step.of)
    else:
        seen_from = "" if from_node == polygon.construction.pole else polygon.of(from_node)
    return Contacted(polygon.seen(of, seen_from), found)


def same_velocity(polygon: Polygon, wheel: str, letter: str, contact: Contact, node: str) -> str:
    """Pure rolling: the two points at a contact move alike."""
    reading = polygon.reading
    other = next(link for link in contact.wheels if link != wheel)
    of, same = (polygon.seen(reading.numbered(letter, link), "") for link in (wheel, other))
    key = "contacts.no velocity" if other == FRAME else "contacts.same velocity"
    words = {"first": reading.link(wheel), "second": reading.link(other), "point": letter}
    return reading.say(key, of=of, other=same, node=names.point(node), **words)
