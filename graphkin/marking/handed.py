"""The quantities that may be handed in: what is asked, and what is met on the way."""

from __future__ import annotations

from typing import assert_never

from graphkin.construction import Image, Term
from graphkin.errors import GraphkinError
from graphkin.marking.key import Sort
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import (
    Centre,
    Component,
    Displacement,
    Moving,
    Place,
    Quantity,
    Quotient,
    Rotation,
    Track,
)
from graphkin.model.quantities.reading import read
from graphkin.planning import Method


def asked_of(mechanism: Mechanism) -> dict[str, Quantity]:
    """What the file asks for, in its words, as far as the answer is a number."""
    found = ((question, readable(mechanism, question)) for question in mechanism.ask)
    return {question: quantity for question, quantity in found if quantity is not None}


def on_the_way(method: Method) -> tuple[Quantity, ...]:
    """Rotations of the links that no driver gives, arrows and images of both polygons, in the order they are found."""
    mechanism = method.mechanism
    driven = {driver.link for driver in mechanism.drivers if driver.kind != "slide"}
    links = [link for link in mechanism.moving if link not in driven]
    found: dict[str, Quantity] = {}
    for construction, word in ((method.velocity, "omega"), (method.acceleration, "alpha")):
        letter = word.replace("omega", "v").replace("alpha", "a")
        texts = [_text(letter, term) for term in construction.vectors().values() if not term.over]
        images = [step.point for step in construction.steps if isinstance(step, Image)]
        points = [f"{letter} {construction.nodes[point].of}" for point in images if point in construction.nodes]
        for text in (*texts, *points, *(f"{word} {link}" for link in links)):
            if (quantity := readable(mechanism, text)) is not None:
                found.setdefault(quantity.text, quantity)
    return tuple(found.values())


def readable(mechanism: Mechanism, text: str) -> Quantity | None:
    """The quantity a text names, where its answer is a number."""
    try:
        quantity = read(mechanism, text)
    except GraphkinError:
        return None
    return None if quantity is not None and quantity.is_place else quantity


def sort_of(quantity: Quantity) -> Sort:
    """Whether a quantity's sign is its sense."""
    match quantity:
        case Moving():
            return "size"
        case Rotation(word="theta"):
            return "angle"
        case Rotation() | Displacement() | Place() | Track() | Component() | Centre() | Quotient():
            return "sense"
        case _:
            assert_never(quantity)


def _text(letter: str, term: Term) -> str:
    """`a_k B3B2` of the arrow a^k_B3B2."""
    comma = "," if "@" in term.of + term.seen_from and term.seen_from else ""
    return f"{letter}{'_' if term.part else ''}{term.part} {term.of}{comma}{term.seen_from}"
