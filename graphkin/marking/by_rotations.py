"""Rotations of wheels that follow from own rotations at their contacts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plot, TurnOf
from graphkin.model.quantities import Quantity, Rotation
from graphkin.planning import Method
from graphkin.planning.stages import Group, Mesh

Rate = tuple[str, str]
"""omega or alpha, and the link whose angle it is of, for all that keep theirs to it."""


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
            parts = [(rates[word, base], r) for base, r in others if (word, base) in rates]
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
        if rate in own.wheels:
            yield k, right[k] + own.wheels[rate].off, own.wheels[rate].sources


def rotations_of(plot: Plot, quantities: Sequence[Quantity]) -> Iterator[tuple[int, Rate]]:
    """The quantities that are omega or alpha, by their numbers."""
    turns = plot.facts.turns
    for k, quantity in enumerate(quantities):
        if isinstance(quantity, Rotation) and quantity.word != "theta" and quantity.link in turns:
            yield k, (quantity.word, turns[quantity.link].base)


def _either(first: OffRate | None, second: OffRate) -> OffRate:
    """The first of two, where there is one."""
    if first is None:
        return second
    return OffRate(np.where(np.isfinite(first.off), first.off, second.off), first.sources | second.sources)


def _contacts(method: Method, turns: Mapping[str, TurnOf]) -> Iterator[list[tuple[str, float]]]:
    """Bases and coefficients of each rolling contact that gives the rotation of a wheel, which comes last."""
    for stage in method.stages:
        if not isinstance(stage, Mesh | Group):
            continue
        names = [stage.angle] if isinstance(stage, Mesh) else stage.angles
        unknown = {turns[name].base for name in names if name}
        for contact in (stage.contact,) if isinstance(stage, Mesh) else stage.contacts:
            angles: dict[str, float] = {}
            for link, coefficient in contact.angles:
                angles[turns[link].base] = angles.get(turns[link].base, 0.0) + coefficient
            for wheel in (base for base in angles if base in unknown and angles[base]):
                yield [*((base, c) for base, c in angles.items() if base != wheel), (wheel, angles[wheel])]
