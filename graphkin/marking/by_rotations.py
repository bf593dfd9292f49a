"""Values that follow from own rotations without the polygon: v = omega l on a link, and the ratios of wheels."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.geometry import number, place
from graphkin.base.value import frozen
from graphkin.construction import Plot, TurnOf
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Moving, Quantity, Rotation
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
    method: Method, plot: Plot, quantities: Sequence[Quantity], right: np.ndarray, given: np.ndarray, used: np.ndarray
) -> OwnRotations:
    """Of given values that are used (students, quantities); right ones (quantities,)."""
    turns = plot.facts.turns
    rates: dict[Rate, OffRate] = {}
    for k, rate in _rotations(plot, quantities):
        if used[:, k].any():
            own = OffRate(np.where(used[:, k], given[:, k] - right[k], np.nan), frozenset({k}))
            rates[rate] = _either(rates.get(rate), own)
    wheels: dict[Rate, OffRate] = {}
    for *others, (wheel, radius) in _contacts(method, turns) if rates else ():  # one after another
        for word in ("omega", "alpha"):
            parts = [(rates[word, base], r) for base, r in others if (word, base) in rates]
            if parts:
                some = np.any([np.isfinite(rate.off) for rate, _ in parts], axis=0)
                off = -np.sum([r * np.nan_to_num(rate.off) for rate, r in parts], axis=0) / radius
                sources = frozenset[int]().union(*(rate.sources for rate, _ in parts))
                wheels[word, wheel] = OffRate(np.where(some, off, np.nan), sources)
                rates[word, wheel] = _either(rates.get((word, wheel)), wheels[word, wheel])
    return OwnRotations(rates, wheels)


def by_rotations(
    method: Method, plot: Plot, quantities: Sequence[Quantity], right: np.ndarray, own: OwnRotations
) -> Iterator[tuple[int, np.ndarray, frozenset[int]]]:
    """The quantities that follow from own rotations: the number, the value for each student (students,), NaN where none
    follows, and the numbers of the own rotations."""
    for k, rate in _rotations(plot, quantities):
        if rate in own.wheels:
            yield k, right[k] + own.wheels[rate].off, own.wheels[rate].sources
    for k, quantity in enumerate(quantities):
        if isinstance(quantity, Moving) and own.rates:
            yield from ((k, *outcome) for outcome in _of_point(method, plot, quantity, float(right[k]), own.rates))


def _rotations(plot: Plot, quantities: Sequence[Quantity]) -> Iterator[tuple[int, Rate]]:
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
            wheels = [base for base in angles if base in unknown and angles[base]]
            if len(wheels) == 1:
                yield [*((base, c) for base, c in angles.items() if base != wheels[0]), (wheels[0], angles[wheels[0]])]


def _of_point(
    method: Method, plot: Plot, quantity: Moving, right: float, rates: Mapping[Rate, OffRate]
) -> Iterator[tuple[np.ndarray, frozenset[int]]]:
    """Sizes that follow on each link that has the point, or both points: velocities, tangential accelerations, and
    accelerations about a fixed point."""
    owners, turns = method.mechanism.owners, plot.facts.turns
    links = [set(owners.get(site.point, ())) & set(turns) - {FRAME} for site in quantity.sites]
    for link in sorted(set.intersection(*links)):
        base = turns[link].base
        offs = [rates.get((word, base), OffRate(np.array(np.nan), frozenset())) for word in ("omega", "alpha")]
        sources = offs[0].sources | offs[1].sources
        if not sources:
            continue
        omega, alpha = (number(table[link]) for table in (plot.omega, plot.alpha))
        own_omega, own_alpha = omega + np.nan_to_num(offs[0].off), alpha + np.nan_to_num(offs[1].off)
        some = np.isfinite(offs[0].off) | np.isfinite(offs[1].off)
        with np.errstate(divide="ignore", invalid="ignore"):
            if quantity.letter == "v" and omega:
                yield np.where(some, right * np.abs(own_omega / omega), np.nan), sources
            elif quantity.part == "t" and alpha:
                yield np.where(some, right * np.abs(own_alpha / alpha), np.nan), sources
            elif quantity.letter == "a" and quantity.part == "":
                fixed = [point for point in method.structure.bodies[FRAME] if link in owners.get(point, ())]
                centres = [quantity.seen_from.point] if quantity.seen_from else fixed[:1]
                for centre in centres:
                    arm = abs(place(plot.arm(centre, quantity.site.point)))
                    yield np.where(some, arm * np.hypot(own_alpha, own_omega**2), np.nan), sources
