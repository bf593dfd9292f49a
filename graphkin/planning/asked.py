"""The parts of a method that lead to what a file asks for."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import Literal, assert_never

from graphkin.construction import Given, Plane
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import Quantity
from graphkin.model.quantities.kinds import Centre, Component, Displacement, Moving, Place, Quotient, Rotation, Track
from graphkin.model.quantities.reading import read
from graphkin.planning.method import Method
from graphkin.planning.needed import Fact, Part, aids, needed, turning

PLANES: tuple[Plane, ...] = ("position", "velocity", "acceleration")


def asked_parts(
    method: Method, quantities: Collection[Quantity], steady: frozenset[Fact], planes: tuple[Plane, ...] = PLANES[1:]
) -> dict[Plane, tuple[Part, ...]]:
    """By polygon what leads to some quantities; none where they need no motion. A polygon is there if something is
    drawn in it, or if it is asked for and needs no step, as a driven rotation does. `steady`: facts that are nothing.
    """
    facts = {fact for one in quantities for fact in facts_of(method, one)}
    led, shown = needed(method, {*facts}, steady) if facts else {}, dict[Plane, tuple[Part, ...]]()
    for plane in planes if led else ():
        kinds = ("omega" if plane == "velocity" else "alpha", plane)
        direct = any(kind.removeprefix("driven ") in kinds for kind, _ in facts)
        if direct or any(not isinstance(part, Given) for part in led[plane]):
            shown[plane] = led[plane]
    return shown


def all_motions(mechanism: Mechanism, planes: Sequence[Plane]) -> tuple[Quantity, ...]:
    """Questions where a file asks for nothing: the rotation of each link that is neither driven nor idle, the motion of
    each point that is no aid."""
    links = [link for link in mechanism.moving if link not in (*mechanism.driven, *mechanism.idle)]
    words: dict[Plane, Literal["omega", "alpha"]] = {"velocity": "omega", "acceleration": "alpha"}
    rotations = [Rotation(words[plane], mechanism.called(link), link) for plane in planes for link in links]
    unasked = aids(mechanism)
    moving = [point for point in mechanism.points if FRAME not in mechanism.owners[point] and point not in unasked]
    motions = (read(mechanism, f"{plane[0]} {point}") for plane in planes for point in moving)
    return (*rotations, *(motion for motion in motions if motion is not None))


def plane_of(quantity: Quantity) -> Plane:
    """The plane in which a quantity is found."""
    if isinstance(quantity, Centre):
        return "velocity"
    unit = max(quantity.halves, key=lambda half: half.unit.endswith("^2")).unit
    if unit in ("rad/s^2", "m/s^2"):
        return "acceleration"
    return "velocity" if unit in ("rad/s", "m/s") else "position"


def facts_of(method: Method, quantity: Quantity) -> Iterator[Fact]:
    """The facts that a quantity of motion takes from a construction; a place and a centre need no polygon."""
    match quantity:
        case Rotation(word=word, link=link):
            yield from (turning(method, word, link),) if word != "theta" else ()
        case Moving() | Component():
            owners, plane = method.mechanism.owners, plane_of(quantity)
            construction = method.velocity if plane == "velocity" else method.acceleration
            nodes = {node.name: node.site for node in construction.nodes.values() if node.site is not None}
            for point, link in ((site.point, site.link) for site in quantity.sites):
                holding = [link, *(owners.get(point, ()) if link in owners.get(point, ()) else ())]
                there = [name for name, site in nodes.items() if site.point == point and site.link in holding]
                if not there and link != FRAME:  # the polygon does not show it: what moves its link
                    yield turning(method, "omega", link)
                    yield from (turning(method, "alpha", link),) if plane == "acceleration" else ()
                    there = [name for name, site in nodes.items() if link in (site.link, *owners.get(site.point, ()))]
                yield from ((plane, name) for name in there[:1])
        case Quotient():
            for half in quantity.halves:
                yield from facts_of(method, half)
        case Displacement() | Place() | Track() | Centre():
            pass
        case _:
            assert_never(quantity)
