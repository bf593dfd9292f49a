"""Chains of arrows closed at once: rates that no order of ruler and triangle reaches."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from graphkin.base.geometry import Value
from graphkin.construction.fitting import unknowns_of
from graphkin.construction.kinds import Chain, Simultaneous, UnknownScalar
from graphkin.construction.linear import Row, solved, system, two
from graphkin.construction.plot import Plot, slide_key
from graphkin.construction.rolling import displacements, in_step, order_of
from graphkin.construction.terms import Plane


def solve_together(step: Simultaneous, plot: Plot, plane: Plane) -> None:
    """The unknown rates of a group, from all its chains of arrows at once."""
    known, matrix = system(chains(step, plot, plane), unknowns_of(step), _shape(plot))
    settle_rates(step, plot, plane, (value[()] for value in np.moveaxis(solved(matrix, -known), -1, 0)))


def settle_rates(step: Simultaneous, plot: Plot, plane: Plane, found: Iterable[Value]) -> None:
    """The unknowns, in their order, as rates of the plot."""
    rates = [*found]
    for base, value in zip(step.angles, rates):
        plot.settle("omega" if plane == "velocity" else "alpha", base, value)
    displacements(plot, plane).update(zip(step.slides, rates[len(step.angles) :], strict=True))


def chains(step: Simultaneous, plot: Plot, plane: Plane) -> list[Row]:
    """What the known arrows of each chain add up to, and what each unknown adds."""
    rows = [row for chain in step.chains for row in two(*_chain(chain, plot, plane))]
    rows += [in_step(contact, plot, plane, set(step.angles), set(step.slides)) for contact in step.contacts]
    return rows


def _shape(plot: Plot) -> tuple[int, ...]:
    """Of the positions."""
    return np.broadcast_shapes(*(np.shape(value) for value in (*plot.position.values(), *plot.theta.values())))


def _chain(chain: Chain, plot: Plot, plane: Plane) -> Row:
    """The known arrows of a chain end to end, and the arrow of each unknown at 1."""
    known: Value = sum((sign * plot.arrow(size, plane) for size, sign in chain.known), 0j)
    arrows: dict[str, Value] = {}
    for unknown in chain.unknown:
        name, arrow, more = _unknown(unknown, plot, plane)
        known = known + more
        arrows[name] = arrows.get(name, 0.0) + arrow
    return known, arrows


def _unknown(unknown: UnknownScalar, plot: Plot, plane: Plane) -> tuple[str, Value, Value]:
    """The `slide_key` or base link, its arrow at 1, and what the link turns against its base link, as an arrow."""
    if unknown.slide:
        return slide_key(unknown.slide), unknown.sign * plot.guide_direction(unknown.slide), 0.0
    arrow = unknown.sign * 1j * plot.arm(unknown.tail, unknown.head)
    more = arrow * plot.facts.relative_rate(unknown.link, order_of(plane))
    return plot.facts.turns[unknown.link].base, arrow, more
