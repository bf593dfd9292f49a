"""What is read off a finished drawing: motions of links, points and slides."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from functools import partial

from graphkin.construction import Plot
from graphkin.construction.plot import within_a_turn
from graphkin.geometry import Value
from graphkin.motions import Motions
from graphkin.naming import primes
from graphkin.planning import Method
from graphkin.running.program import Table
from graphkin.value import Lazy

__all__ = ["readings"]


def readings(method: Method, plot: Plot) -> Motions:
    """Motions read off a finished drawing. Sliding pairs and rolling wheels of the file, without the slots that stand
    for cams; angles between 0 and a full turn."""
    mechanism = method.mechanism
    slides = {pair.name for pair in mechanism.pairs if pair.path is not None}
    links, nodes = set(mechanism.moving), method.nodes_of_links
    prime = primes(mechanism, "acceleration")
    theta = Lazy((link for link in plot.theta if link in links), partial(_turn, plot))
    return Motions(
        mechanism, theta, _of(plot.omega, links), _of(plot.alpha, links),
        _of(plot.s, slides), _of(plot.s_rate, slides), _of(plot.s_acceleration, slides),
        plot.position, _of_nodes(plot.velocity, nodes, ""), _of_nodes(plot.acceleration, nodes, prime),
    )  # fmt: skip


def _turn(plot: Plot, link: str) -> Value:
    """A link's angle between 0 and a full turn; a program has it beside the angle."""
    return plot.theta.results.read("turn", link) if isinstance(plot.theta, Table) else within_a_turn(plot.theta[link])


def _of(table: Mapping[str, Value], names: Collection[str]) -> Mapping[str, Value]:
    return Lazy((name for name in table if name in names), table.__getitem__)


def _of_nodes(
    polygon: Mapping[str, Value], nodes: Mapping[str, Mapping[str, str]], prime: str
) -> Mapping[str, Mapping[str, Value]]:
    """By link and point what a polygon shows of it; `prime` is what its points have after the name."""

    def of_link(link: str) -> Mapping[str, Value]:
        return Lazy(nodes[link], lambda point: polygon[nodes[link][point] + prime])

    return Lazy(nodes, of_link)
