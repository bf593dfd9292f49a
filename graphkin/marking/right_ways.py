"""Other right ways: what quantities with other names are, so that right work that takes them is not called wrong."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.errors import GraphkinError
from graphkin.marking.asked import arrows_of, asked
from graphkin.marking.redrawing import redraw
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import Seen
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
from graphkin.model.quantities.kinds import Answer
from graphkin.model.quantities.reading import read
from graphkin.planning import Method, plan


@frozen
class OtherWay:
    """A right answer of another name, or the same one given otherwise.

    kind      "reversed": the motion seen the other way round (B2B3 for B3B2, -k for k); "coincident": at another
              coincident point of the same two links; "size": a rotation without its sign, its sense said in words;
              "centre": the instant centre about which a point moves
    """

    kind: str
    quantity: Quantity
    answer: Answer


def other_ways(method: Method, plot: Plot, quantity: Quantity) -> tuple[OtherWay, ...]:
    """Every other way to give a quantity, with what it is at the positions of a right plot."""
    right, arrows = redraw(method, plot), arrows_of(method)

    def answered(kind: str, other: Quantity) -> OtherWay:
        return OtherWay(kind, other, asked(method, right, other, arrows))

    match quantity:
        case Rotation(word="omega" | "alpha"):
            value = asked(method, right, quantity, arrows).value
            return (OtherWay("size", quantity, Answer(np.abs(value), quantity.unit)),)
        case Moving(seen_from=None):
            return tuple(answered("centre", centre) for centre in _centres(method.mechanism, quantity))
        case Moving():
            found = [answered("reversed", other) for other in _named(method.mechanism, quantity, *_turned(quantity))]
            return (*found, *(answered("coincident", other) for other in _elsewhere(method.mechanism, quantity)))
        case Rotation() | Displacement() | Place() | Track() | Component() | Centre() | Quotient():
            return ()
        case _:
            assert_never(quantity)


def other_methods(method: Method) -> Iterator[Method]:
    """The mechanism planned with each other coincident point that its sliding pairs allow."""
    plans = [method]
    for point in method.mechanism.points:
        try:
            other = plan(method.mechanism, point)
        except GraphkinError:
            continue
        if all(other.velocity != known.velocity for known in plans):
            plans.append(other)
            yield other


def _turned(quantity: Moving) -> tuple[Seen, Seen]:
    assert quantity.seen_from is not None
    return quantity.seen_from, quantity.site


def _elsewhere(mechanism: Mechanism, quantity: Moving) -> Iterator[Quantity]:
    """A motion of coincident points at every other named point of either link."""
    of, seen_from = quantity.site, quantity.seen_from
    if seen_from is None or of.point != seen_from.point:
        return
    named = dict.fromkeys((*mechanism.named(of.link), *mechanism.named(seen_from.link)))
    for point in (name for name in named if name != of.point):
        yield from _named(mechanism, quantity, Seen(point, of.link, True), Seen(point, seen_from.link, True))


def _named(mechanism: Mechanism, quantity: Quantity, of: Seen, seen_from: Seen) -> Iterator[Quantity]:
    """The quantity of two sites as it is read from text; nothing where no text says it."""
    for text in (_written(mechanism, of) + _written(mechanism, seen_from),
                 ",".join(f"{site.point}@{mechanism.called(site.link)}" for site in (of, seen_from))):  # fmt: skip
        try:
            found = read(mechanism, f"{quantity.word} {text}")
        except GraphkinError:
            continue
        if isinstance(found, Moving) and _same(found, of, seen_from):
            yield found
            return


def _same(found: Moving, of: Seen, seen_from: Seen) -> bool:
    sites = (found.site, found.seen_from)
    return all(site is not None and (site.point, site.link) == (wanted.point, wanted.link)
               for site, wanted in zip(sites, (of, seen_from), strict=True))  # fmt: skip


def _written(mechanism: Mechanism, site: Seen) -> str:
    return site.point + (mechanism.called(site.link) if site.explicit else "")


def _centres(mechanism: Mechanism, quantity: Moving) -> Iterator[Quantity]:
    """Of the links of a point, each against the frame; of velocities."""
    if quantity.letter != "v":
        return
    site = quantity.site
    for link in (site.link,) if site.explicit else mechanism.owners.get(site.point, ()):
        if link != FRAME:
            yield Centre("P", f"{mechanism.called(link)},{mechanism.frame}", (link, FRAME))
