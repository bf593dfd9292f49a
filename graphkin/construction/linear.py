"""Linear equations over positions: rolling contacts, chains of arrows closed at once, and how near these are to a dead
point.

A `Row` is one condition, known + sum of coefficient * unknown = 0, its unknowns by base link or `slide_key`; a complex
row stands for two.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from operator import attrgetter

import numpy as np

from graphkin.base.geometry import Real, Value
from graphkin.construction.kinds import Fit, InStep, Roll, Simultaneous
from graphkin.construction.plot import Plot, slide_key
from graphkin.construction.terms import Plane

Row = tuple[Value, Mapping[str, Value]]


def unknowns_of(step: Fit | Simultaneous) -> tuple[str, ...]:
    """The names of a step's unknowns in rows: angles first, then displacements."""
    return step.angles + tuple(map(slide_key, step.slides))


def two(known: Value, coefficients: Mapping[str, Value]) -> Iterator[Row]:
    """A complex row along x and along y."""
    for along in (attrgetter("real"), attrgetter("imag")):
        yield along(known), {name: along(value) for name, value in coefficients.items()}


def solved(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """x (..., n) of matrix (..., m, n) x = right (..., m) for every position; least squares where one is singular, NaN
    where something is not finite there."""
    try:
        return np.asarray(np.linalg.solve(matrix, right[..., None])[..., 0])
    except np.linalg.LinAlgError:
        finite = np.isfinite(matrix).all(axis=(-2, -1)) & np.isfinite(right).all(axis=-1)
        matrix = np.where(finite[..., None, None], matrix, np.eye(*matrix.shape[-2:]))
        return np.where(finite[..., None], (np.linalg.pinv(matrix) @ right[..., None])[..., 0], np.nan)


def sense(matrix: np.ndarray) -> Real:
    """The sign of a system's determinant: another assembly close by has the other one."""
    if matrix.shape[-2] != matrix.shape[-1]:
        return 1.0
    sign: Real = np.linalg.slogdet(_finite(matrix))[0]
    return sign


def least(matrix: np.ndarray) -> np.ndarray:
    """The distance of a system from a singular one, like a sine: least singular value, columns of length 1."""
    lengths = np.sqrt((matrix * matrix).sum(axis=-2, keepdims=True))
    lengths[lengths == 0] = 1.0
    return np.linalg.svd(_finite(matrix / lengths), compute_uv=False)[..., -1]


def _finite(matrix: np.ndarray) -> np.ndarray:
    return matrix if np.isfinite(matrix).all() else np.nan_to_num(matrix)


# --- rolling contacts -------------------------------------------------------------------------


def roll(step: Roll, plot: Plot, plane: Plane) -> None:
    """The one unknown of a contact: coefficients times turns add up to nothing."""
    known, coefficients = in_step(step.contact, plot, plane, {step.angle} - {""}, {step.slide} - {""})
    value = (-known / sum(coefficients.values())).real
    if step.angle:
        plot.settle(("theta", "omega", "alpha")[_order_of(plane)], step.angle, value, counted=True)
    else:
        _displacements(plot, plane)[step.slide] = value


_order_of = ("position", "velocity", "acceleration").index


def _displacements(plot: Plot, plane: Plane) -> dict[str, Real]:
    """s of each slide, or its rate, or the rate of that."""
    return (plot.s, plot.s_rate, plot.s_acceleration)[_order_of(plane)]


def in_step(contact: InStep, plot: Plot, plane: Plane, angles: set[str], slides: set[str]) -> Row:
    """A contact's coefficient for each unknown, by base link or `slide_key`, and the sum of the rest."""
    coefficients: dict[str, Value] = {}
    known: Value = 0.0
    order, facts = _order_of(plane), plot.facts
    for link, coefficient in contact.angles:
        base, turned = facts.turns[link].base, (plot.theta, plot.omega, plot.alpha)[order]
        if base in angles:  # known is what the link turns against its base link
            coefficients[base] = coefficients.get(base, 0.0) + coefficient
            turn = facts.relative_rate(link, order) if order else facts.relative_angle(link)
        else:
            turn = turned[link]
        known = known + coefficient * (turn - (0.0 if order else facts.drawn.get(link, 0.0)))
    for slide, share in contact.way or ((contact.slide, 1.0),) * bool(contact.slide):
        coefficient = contact.on_slide * share
        drawn = 0.0 if order else facts.drawn[slide_key(slide)]
        if slide in slides:
            coefficients[slide_key(slide)] = coefficients.get(slide_key(slide), 0.0) + coefficient
            known = known - coefficient * drawn
        else:
            known = known + coefficient * (_displacements(plot, plane)[slide] - drawn)
    return known, coefficients


# --- chains of arrows -------------------------------------------------------------------------


def solve_together(step: Simultaneous, plot: Plot, plane: Plane) -> None:
    """The unknown rates of a group, from all its chains of arrows at once."""
    shape = np.broadcast_shapes(*(np.shape(value) for value in (*plot.position.values(), *plot.theta.values())))
    rows, names = chains(step, plot, plane), unknowns_of(step)
    known, matrix = np.zeros((*shape, len(rows))), np.zeros((*shape, len(rows), len(names)))
    for k, (value, coefficients) in enumerate(rows):
        known[..., k] = value
        for j, name in enumerate(names):
            matrix[..., k, j] = coefficients.get(name, 0.0)
    settle_rates(step, plot, plane, (value[()] for value in np.moveaxis(solved(matrix, -known), -1, 0)))


def settle_rates(step: Simultaneous, plot: Plot, plane: Plane, solution: Iterable[Value]) -> None:
    """The unknowns, in their order, as rates of the plot."""
    rates = [value.real for value in solution]
    for base, value in zip(step.angles, rates):
        plot.settle("omega" if plane == "velocity" else "alpha", base, value)
    _displacements(plot, plane).update(zip(step.slides, rates[len(step.angles) :], strict=True))


def chains(step: Simultaneous, plot: Plot, plane: Plane) -> list[Row]:
    """The sum of the known arrows of each chain, and what each unknown adds to it."""
    rows, turns = list[Row](), plot.facts.turns
    for chain in step.chains:
        known: Value = sum((sign * plot.arrow(size, plane) for size, sign in chain.known), 0j)
        arrows: dict[str, Value] = {}  # of each unknown at 1
        for unknown in chain.unknown:
            if unknown.slide:
                name, arrow = slide_key(unknown.slide), unknown.sign * plot.guide_direction(unknown.slide)
            else:
                name, arrow = turns[unknown.link].base, unknown.sign * 1j * plot.arm(unknown.tail, unknown.head)
                # what the link turns against its base link
                known = known + arrow * plot.facts.relative_rate(unknown.link, _order_of(plane))
            arrows[name] = arrows.get(name, 0.0) + arrow
        rows += two(known, arrows)
    return rows + [in_step(contact, plot, plane, {*step.angles}, {*step.slides}) for contact in step.contacts]
