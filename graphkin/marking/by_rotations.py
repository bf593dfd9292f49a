"""Rotations of wheels that follow from own rotations at their contacts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plot, TurnOf
from graphkin.model.quantities import Quantity, Rotation
from graphkin.planning import Method
from graphkin.planning.stages import Group, Mesh

Turn = tuple[str, tuple[tuple[int, int], ...]]
"""The link on whose angle that of others hangs, and the drivers that turn these against it; the others keep their angle
to one another."""
Rate = tuple[str, Turn]  # omega or alpha, and of which links


@frozen
class OffRate:
    """By how much a rotation is off for students (students,), NaN where it is not; and the own values it comes from."""

    off: np.ndarray
    sources: frozenset[int]


@frozen
class OwnRotations:
    """The rotations that students have of their own, and those of wheels that follow from these at their contacts.

    rates   by how much they are off, own ones before those that follow
    wheels  those that follow, by how much they are off
    """

    rates: Mapping[Rate, OffRate]
    wheels: Mapping[Rate, OffRate]


def own_rotations(
    method: Method, plot: Plot, quantities: Sequence[Quantity], right: np.ndarray,
    given: np.ndarray, used: np.ndarray, agree: np.ndarray, backwards: bool = False,
) -> OwnRotations:  # fmt: skip
    """Of given values that are used (students, quantities); right ones (quantities,). Those that agree with the right
    ones (students, quantities) follow from none. backwards: by the last of several contacts first."""
    turns = plot.facts.turns
    rates: dict[Rate, OffRate] = {}
    stays: dict[Rate, np.ndarray] = {}
    for k, rate in rotations_of(plot, quantities):
        stays[rate] = stays.get(rate, False) | agree[:, k]
        if used[:, k].any():
            own = OffRate(np.where(used[:, k], given[:, k] - right[k], np.nan), frozenset({k}))
            rates[rate] = _either(rates.get(rate), own)
    wheels: dict[Rate, OffRate] = {}
    contacts = [*_contacts(method, turns)] if rates else []
    for *others, (wheel, radius) in reversed(contacts) if backwards else contacts:  # one after another
        for word in ("omega", "alpha"):
            each = ((_rate_of(rates, (word, turn)), r) for turn, r in others)
            parts = [(rate, r) for rate, r in each if rate is not None]
            if parts:
                some = np.any([np.isfinite(rate.off) for rate, _ in parts], axis=0)
                off = -np.sum([r * np.nan_to_num(rate.off) for rate, r in parts], axis=0) / radius
                sources = frozenset[int]().union(*(rate.sources for rate, _ in parts))
                follows = OffRate(np.where(some & ~stays.get((word, wheel), np.False_), off, np.nan), sources)
                wheels[word, wheel] = _either(wheels.get((word, wheel)), follows)
                rates[word, wheel] = _either(rates.get((word, wheel)), follows)
    return OwnRotations(rates, wheels)


def by_contacts(
    plot: Plot, quantities: Sequence[Quantity], right: np.ndarray, own: OwnRotations
) -> Iterator[tuple[int, np.ndarray, frozenset[int]]]:
    """The rotations of wheels that follow: the number of the quantity, the values (students,), NaN where none follows,
    and the numbers of the own rotations."""
    for k, rate in rotations_of(plot, quantities):
        if (follows := _rate_of(own.wheels, rate)) is not None:
            yield k, right[k] + follows.off, follows.sources


def rotations_of(plot: Plot, quantities: Sequence[Quantity]) -> Iterator[tuple[int, Rate]]:
    """The quantities that are omega or alpha, by their numbers."""
    turns = plot.facts.turns
    for k, quantity in enumerate(quantities):
        if isinstance(quantity, Rotation) and quantity.word != "theta" and quantity.link in turns:
            yield k, (quantity.word, (turns[quantity.link].base, turns[quantity.link].drivers))


def _rate_of(rates: Mapping[Rate, OffRate], rate: Rate) -> OffRate | None:
    """The rate of some links: their own, or that of the nearest against which drivers turn them."""
    (word, (base, drivers)), found = rate, None
    for count in range(len(drivers), -1, -1):
        if (nearer := rates.get((word, (base, drivers[:count])))) is not None:
            found = _either(found, nearer)
    return found


def _either(first: OffRate | None, second: OffRate) -> OffRate:
    """The first of two, where there is one."""
    if first is None:
        return second
    return OffRate(np.where(np.isfinite(first.off), first.off, second.off), first.sources | second.sources)


def _contacts(method: Method, turns: Mapping[str, TurnOf]) -> Iterator[list[tuple[Turn, float]]]:
    """Coefficients of each rolling contact that gives the rotation of a wheel, which comes last."""
    for stage in method.stages:
        if not isinstance(stage, Mesh | Group):
            continue
        names = [stage.angle] if isinstance(stage, Mesh) else stage.angles
        unknown = {turns[name].base for name in names if name}
        for contact in (stage.contact,) if isinstance(stage, Mesh) else stage.contacts:
            angles: dict[Turn, float] = {}
            for link, coefficient in contact.angles:
                turn = turns[link].base, turns[link].drivers
                angles[turn] = angles.get(turn, 0.0) + coefficient
            for wheel in dict.fromkeys(base for base, _ in angles if base in unknown):
                if radius := sum(c for (base, _), c in angles.items() if base == wheel):
                    yield [*((turn, c) for turn, c in angles.items() if turn[0] != wheel), ((wheel, ()), radius)]
