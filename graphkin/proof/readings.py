"""What is read off a finished drawing: motions of links, points and slides."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import assert_never

from graphkin.base.cache import kept
from graphkin.base.geometry import Value
from graphkin.base.value import Lazy
from graphkin.construction import Plot
from graphkin.errors import Where
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import primes
from graphkin.model.quantities import Quantity, named
from graphkin.model.quantities.kinds import Centre, Component, Displacement, Moving, Place, Quotient, Rotation, Track
from graphkin.planning import Method

__all__ = ["places", "readings"]


class DrawnPlaces(dict[str, tuple[str, str, str]]):
    """By text where a finished drawing holds a quantity as it is: the table, the name there, and the unit.

    The table is empty where a quantity is calculated.
    """

    def __init__(self, method: Method) -> None:
        super().__init__()
        self.method, self.prime = method, primes(method.mechanism, "acceleration")

    def __missing__(self, text: str) -> tuple[str, str, str]:
        quantity = named(self.method.mechanism, text, Where("quantity"))
        self[text] = (*self._place(quantity), quantity.unit)
        return self[text]

    def _place(self, quantity: Quantity) -> tuple[str, str]:
        match quantity:
            case Rotation():
                return ("turn" if quantity.word == "theta" else quantity.word), quantity.link
            case Displacement():
                return "s", quantity.slide
            case Track():
                return "position", quantity.site.point
            case Moving():
                node = self.method.nodes_of_links.get(quantity.site.link, {}).get(quantity.site.point)
                if quantity.seen_from is None and node is not None and quantity.site.link != FRAME:
                    return ("velocity", node) if quantity.letter == "v" else ("acceleration", node + self.prime)
                return "", ""
            case Centre() | Component() | Place() | Quotient():
                return "", ""
            case _:
                assert_never(quantity)


@kept(4)
def places(method: Method) -> DrawnPlaces:
    """The same for all plots of a method."""
    return DrawnPlaces(method)


def readings(method: Method, plot: Plot) -> Motions:
    """Motions read off a finished drawing. Sliding pairs and rolling wheels of the file, without the slots that stand
    for cams; angles between 0 and a full turn."""
    mechanism = method.mechanism
    slides = {pair.name for pair in mechanism.pairs if pair.path is not None}
    links, nodes = set(mechanism.moving), method.nodes_of_links
    prime = primes(mechanism, "acceleration")
    return Motions(
        mechanism, _of(plot.turn, links), _of(plot.omega, links), _of(plot.alpha, links),
        _of(plot.s, slides), _of(plot.s_rate, slides), _of(plot.s_acceleration, slides),
        plot.position, _of_nodes(plot.velocity, nodes, ""), _of_nodes(plot.acceleration, nodes, prime),
    )  # fmt: skip


def _of(table: Mapping[str, Value], names: Collection[str]) -> Mapping[str, Value]:
    return Lazy((name for name in table if name in names), table.__getitem__)


def _of_nodes(
    polygon: Mapping[str, Value], nodes: Mapping[str, Mapping[str, str]], prime: str
) -> Mapping[str, Mapping[str, Value]]:
    """By link and point what a polygon shows of it; `prime` is what its points have after the name."""

    def of_link(link: str) -> Mapping[str, Value]:
        return Lazy(nodes[link], lambda point: polygon[nodes[link][point] + prime])

    return Lazy(nodes, of_link)
