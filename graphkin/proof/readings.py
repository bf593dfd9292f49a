"""Motions of links, points and slides read off a finished drawing, and the mechanism's file at that position."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TypeVar, assert_never

from graphkin.base.cache import kept
from graphkin.base.geometry import Value, number, place
from graphkin.base.value import Lazy
from graphkin.construction import Plot
from graphkin.errors import Where
from graphkin.files.builder import reposed
from graphkin.model import quantities
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import primes
from graphkin.planning import Method
from graphkin.planning.drawn_position import value_of
from graphkin.running import replay_all

_Entry = TypeVar("_Entry")


class DrawnPlaces(dict[str, tuple[str, str, str]]):
    """By text where a finished drawing holds a quantity as it is: the table, the name there, and the unit. The table is
    empty where a quantity is calculated."""

    def __init__(self, method: Method) -> None:
        super().__init__()
        self.method, self.prime = method, primes(method.mechanism, "acceleration")

    def __missing__(self, text: str) -> tuple[str, str, str]:
        quantity = quantities.named(self.method.mechanism, text, Where("quantity"))
        self[text] = (*self._place(quantity), quantity.unit)
        return self[text]

    def _place(self, quantity: quantities.Quantity) -> tuple[str, str]:
        match quantity:
            case quantities.Rotation():
                return ("turn" if quantity.word == "theta" else quantity.word), quantity.link
            case quantities.Displacement():
                return "s", quantity.slide
            case quantities.Track():
                return "position", quantity.site.point
            case quantities.Moving():
                node = self.method.nodes_of_links.get(quantity.site.link, {}).get(quantity.site.point)
                if quantity.seen_from is None and node is not None and quantity.site.link != FRAME:
                    return ("velocity", node) if quantity.letter == "v" else ("acceleration", node + self.prime)
                return "", ""
            case quantities.Centre() | quantities.Component() | quantities.Place() | quantities.Quotient():
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


def _of(table: Mapping[str, _Entry], names: Collection[str]) -> Mapping[str, _Entry]:
    return Lazy((name for name in table if name in names), table.__getitem__)


def _of_nodes(
    polygon: Mapping[str, Value], nodes: Mapping[str, Mapping[str, str]], prime: str
) -> Mapping[str, Mapping[str, Value]]:
    """By link and point what a polygon shows of it; `prime` is what its points have after the name."""

    def of_link(link: str) -> Mapping[str, Value]:
        return Lazy(nodes[link], lambda point: polygon[nodes[link][point] + prime])

    return Lazy(nodes, of_link)


def mechanism_at(method: Method, values: Sequence[float]) -> Mechanism:
    """The mechanism where its drivers have these values [rad, m], reached from the drawn position on its branch.

    Its text has the drivers' values, the poses and the sketch of there. Raises NotReached.

    >>> import math
    >>> from graphkin import api
    >>> turned = mechanism_at(api.plan(api.load("ex3-1")), [math.radians(120)])
    >>> turned.drivers[0].value == math.radians(120), f"{turned.sketch['C'] * 1000:.4f}"
    (True, '71.5045+47.5585j')
    """
    machine, plot = method.mechanism, replay_all(method, values)
    poses = [number(value_of(plot, pose)) for pose in machine.poses]
    moving = {point for point in machine.points if point not in machine.links[FRAME].points}
    return reposed(machine, values, poses, {name: place(z) for name, z in plot.position.items() if name in moving})
