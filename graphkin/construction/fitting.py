"""What is found by calculation: rolling contacts, links tried until they fit, chains of arrows closed at once.

A `Row` is one linear condition: known + sum of coefficient * unknown = 0, by base link or `slide_key`. A complex row
stands for two.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from operator import attrgetter

import numpy as np

from graphkin.construction.kinds import Chain, Closure, Fit, InStep, Roll, Simultaneous, Unknown
from graphkin.construction.plot import Plot, slide_key
from graphkin.construction.terms import Arm, Plane, Slid
from graphkin.geometry import Value

Row = tuple[Value, Mapping[str, Value]]

ROUNDS = 30
FITTED = 1e-8
"""The last step at most [rad, of the group's size]; what it leaves is of the order of its square."""
ROUNDING, ROUNDED = 1e-5, 0.8
"""Steps so short that become no shorter than by this factor come of rounding: the links are all but free to move."""


# --- rolling contacts -------------------------------------------------------------------------


def roll(step: Roll, plot: Plot, plane: Plane) -> None:
    """The one unknown of a contact: coefficients times turns add up to nothing."""
    known, coefficients = _in_step(step.contact, plot, plane, {step.angle} - {""}, {step.slide} - {""})
    value = -known / sum(coefficients.values())
    if step.angle:
        plot.settle(("theta", "omega", "alpha")[_order(plane)], step.angle, value, counted=True)
    else:
        _displacements(plot, plane)[step.slide] = value


def _order(plane: Plane) -> int:
    return ("position", "velocity", "acceleration").index(plane)


def _displacements(plot: Plot, plane: Plane) -> dict[str, Value]:
    """s of each slide, or its rate, or the rate of that."""
    return (plot.s, plot.s_rate, plot.s_acceleration)[_order(plane)]


def _in_step(contact: InStep, plot: Plot, plane: Plane, angles: set[str], slides: set[str]) -> Row:
    """A contact's coefficient for each unknown, by base link or `slide_key`, and the sum of the rest."""
    coefficients: dict[str, Value] = {}
    known: Value = 0.0
    for link, coefficient in contact.angles:
        base = plot.facts.turns[link].base
        if base in angles:
            coefficients[base] = coefficients.get(base, 0.0) + coefficient
        known = known + coefficient * _turned(link, plot, plane, base in angles)
    for slide, share in contact.way or ((contact.slide, 1.0),) * bool(contact.slide):
        coefficient = contact.on_slide * share
        drawn = plot.facts.drawn[slide_key(slide)] if plane == "position" else 0.0
        if slide in slides:
            coefficients[slide_key(slide)] = coefficients.get(slide_key(slide), 0.0) + coefficient
            known = known - coefficient * drawn
        else:
            known = known + coefficient * (_displacements(plot, plane)[slide] - drawn)
    return known, coefficients


def _turned(link: str, plot: Plot, plane: Plane, beside_base: bool) -> Value:
    """What a link has turned since the drawn position, or its rate; `beside_base`: what its base link leaves."""
    order, facts = _order(plane), plot.facts
    drawn = facts.drawn.get(link, 0.0) if order == 0 else 0.0
    if not beside_base:
        return (plot.theta, plot.omega, plot.alpha)[order][link] - drawn
    return (facts.relative_angle(link) if order == 0 else facts.relative_rate(link, order)) - drawn


# --- links tried until they fit ---------------------------------------------------------------


def fit(step: Fit, plot: Plot) -> None:
    """Newton's method on the closures and contacts of a group, for all positions at once."""
    x, size = _first_trial(step, plot), reach(step, plot)
    units = np.expand_dims(units_of(step, size), tuple(range(1, x.ndim)))
    before = np.inf
    for _ in range(ROUNDS):
        x, moved = _next_trial(step, plot, x, size, units)
        farthest = np.max(moved, where=np.isfinite(moved), initial=0.0)
        if farthest <= FITTED or ROUNDED * before < farthest < ROUNDING:
            break
        before = farthest
    _keep_what_fits(step, plot, x, size, units)


def unknowns_of(step: Fit | Simultaneous) -> tuple[str, ...]:
    """What is to be found, as rows name it."""
    return step.angles + tuple(map(slide_key, step.slides))


def _first_trial(step: Fit, plot: Plot) -> np.ndarray:
    """The unknowns at the position close by (n,), over positions."""
    known = (*plot.position.values(), *plot.theta.values(), *plot.s.values(), *plot.near.values())
    shape = np.broadcast_shapes(*(np.shape(value) for value in known))
    return np.array([np.broadcast_to(plot.near[name], shape) for name in unknowns_of(step)], dtype=float)


def reach(step: Fit, plot: Plot) -> float:
    """The longest arm of a group: what its gaps are measured by [m]."""
    arms = [part for closure in step.closures for part in closure.parts if isinstance(part, Arm)]
    shapes = plot.facts.shapes
    lengths = [float(np.max(np.abs(shapes[a.link][a.head] - shapes[a.link][a.tail]))) for a in arms]
    return max([*lengths, *(float(np.max(np.abs(c))) for contact in step.contacts for _, c in contact.angles)]) or 1.0


def units_of(step: Fit, size: float) -> list[float]:
    """What each unknown is counted in: 1 rad, or the group's size [m]."""
    return [1.0] * len(step.angles) + [size] * len(step.slides)


def _next_trial(step: Fit, plot: Plot, x: np.ndarray, size: float, units: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """One step of Newton's method, of half a unit at most, and how long the whole step would be in units."""
    settle_all(step, plot, x)
    gap, slope = _gaps(step, plot, x.shape[1:], size)
    change = _solve(slope * units, gap) * units
    moved = np.max(np.abs(change) / units, axis=0)
    return x - change / np.maximum(1.0, moved / 0.5), moved


def _keep_what_fits(step: Fit, plot: Plot, x: np.ndarray, size: float, units: np.ndarray) -> None:
    """The positions at which the group closes; NaN at the others, and by how much it misses there."""
    settle_all(step, plot, x)
    gap, slope = _gaps(step, plot, x.shape[1:], size)
    widest = np.max(np.abs(gap), axis=0)
    fits = widest < 1e-10
    settle_all(step, plot, np.where(fits, x, np.nan))
    plot.senses[step.name] = _sense(slope)
    plot.sines["position", step.name] = np.where(fits, _least(slope * units), np.nan)[()]
    plot.misses[step.name] = np.where(fits, 0.0, widest * size)[()]


def sense_and_sine(step: Fit, plot: Plot) -> tuple[Value, Value]:
    """The same of a group that is found, where somebody wants to know."""
    size, shape = reach(step, plot), _shape(plot)
    slope = _gaps(step, plot, shape, size)[1]
    units = np.expand_dims(units_of(step, size), tuple(range(1, 1 + len(shape))))
    return _sense(slope), _least(slope * units)[()]


def settle_all(step: Fit, plot: Plot, x: Iterable[Value]) -> None:
    """The unknowns, in their order, as angles and displacements of the plot."""
    found = [value[()] if isinstance(value, np.ndarray) else value for value in x]
    for base, value in zip(step.angles, found):
        plot.settle("theta", base, value, counted=True)
    plot.s.update(zip(step.slides, found[len(step.angles) :], strict=True))


def _gaps(step: Fit, plot: Plot, shape: tuple[int, ...], size: float) -> tuple[np.ndarray, np.ndarray]:
    """Gaps (m,) and their slopes (m, n), over positions; in units of the group's size."""
    known, slope = _system(gaps(step, plot), unknowns_of(step), shape)
    return known / size, slope / size


def gaps(step: Fit, plot: Plot) -> list[Row]:
    """What closures and contacts leave open, and what each unknown does to it."""
    rows = [row for closure in step.closures for row in _two(*_closure(closure, plot))]
    for contact in step.contacts:
        gap, _ = _in_step(contact, plot, "position", set(), set())
        rows.append((gap, _in_step(contact, plot, "position", set(step.angles), set(step.slides))[1]))
    return rows


def _closure(closure: Closure, plot: Plot) -> Row:
    """What is left open of a way round, and what each unknown does to it [m]."""
    gap = plot.position[closure.start] - plot.position[closure.end]
    slopes: dict[str, Value] = {}
    for part in closure.parts:
        base, arrow = _stretch(part, plot)
        gap = gap + arrow
        slopes[base] = slopes.get(base, 0.0) + 1j * arrow
        if isinstance(part, Slid):
            slopes[slide_key(part.slide)] = part.sign * plot.guide_direction(part.slide)
    return gap, slopes


def _stretch(part: Arm | Slid, plot: Plot) -> tuple[str, Value]:
    """One part of a closure as it lies now, with the base link that turns it [m]."""
    if isinstance(part, Arm):
        shape = plot.facts.shapes[part.link]
        arrow = (shape[part.head] - shape[part.tail]) * np.exp(1j * plot.theta[part.link])
        return plot.facts.turns[part.link].base, arrow
    guide = plot.facts.lines[part.slide][0]
    return plot.facts.turns[guide].base, part.sign * plot.s[part.slide] * plot.guide_direction(part.slide)


# --- chains of arrows closed at once ----------------------------------------------------------


def solve_together(step: Simultaneous, plot: Plot, plane: Plane) -> None:
    """The unknown rates of a group, from all its chains of arrows at once."""
    known, matrix = _system(chains(step, plot, plane), unknowns_of(step), _shape(plot))
    settle_rates(step, plot, plane, (value[()] for value in _solve(matrix, -known)))


def settle_rates(step: Simultaneous, plot: Plot, plane: Plane, found: Iterable[Value]) -> None:
    """The unknowns, in their order, as rates of the plot."""
    rates = [*found]
    for base, value in zip(step.angles, rates):
        plot.settle("omega" if plane == "velocity" else "alpha", base, value)
    _displacements(plot, plane).update(zip(step.slides, rates[len(step.angles) :], strict=True))


def chains(step: Simultaneous, plot: Plot, plane: Plane) -> list[Row]:
    """What the known arrows of each chain add up to, and what each unknown adds."""
    rows = [row for chain in step.chains for row in _two(*_chain(chain, plot, plane))]
    rows += [_in_step(contact, plot, plane, set(step.angles), set(step.slides)) for contact in step.contacts]
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


def _unknown(unknown: Unknown, plot: Plot, plane: Plane) -> tuple[str, Value, Value]:
    """The `slide_key` or base link, its arrow at 1, and what the link turns against its base link, as an arrow."""
    if unknown.slide:
        return slide_key(unknown.slide), unknown.sign * plot.guide_direction(unknown.slide), 0.0
    arrow = unknown.sign * 1j * plot.arm(unknown.tail, unknown.head)
    more = arrow * plot.facts.relative_rate(unknown.link, _order(plane))
    return plot.facts.turns[unknown.link].base, arrow, more


# --- linear equations over positions ----------------------------------------------------------


def _two(known: Value, coefficients: Mapping[str, Value]) -> Iterator[Row]:
    """A complex row along x and along y."""
    for along in (attrgetter("real"), attrgetter("imag")):
        yield along(known), {name: along(value) for name, value in coefficients.items()}


def _system(rows: Sequence[Row], names: Sequence[str], shape: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
    """Known parts (m,) and coefficients (m, n) of rows, over positions of a shape."""
    known, matrix = np.zeros((len(rows), *shape)), np.zeros((len(rows), len(names), *shape))
    for k, (value, coefficients) in enumerate(rows):
        known[k] = value
        for j, name in enumerate(names):
            matrix[k, j] = coefficients.get(name, 0.0)
    return known, matrix


def _solve(slope: np.ndarray, gap: np.ndarray) -> np.ndarray:
    """Linear equations (m, n, ...) x = (m, ...) for every position; least squares where singular."""
    matrix, right = np.moveaxis(slope, (0, 1), (-2, -1)), np.moveaxis(gap, 0, -1)[..., None]
    finite = np.isfinite(matrix).all(axis=(-2, -1)) & np.isfinite(right).all(axis=(-2, -1))
    matrix = np.where(finite[..., None, None], matrix, np.eye(*matrix.shape[-2:]))
    try:
        found = np.linalg.solve(matrix, right)
    except np.linalg.LinAlgError:
        found = np.linalg.pinv(matrix) @ right
    found = np.where(finite[..., None, None], found, np.nan)
    return np.moveaxis(found[..., 0], -1, 0)


def _sense(slope: np.ndarray) -> Value:
    """The sign of a system's determinant: another assembly close by has the other one."""
    if slope.shape[0] != slope.shape[1]:
        return 1.0
    return np.linalg.slogdet(np.nan_to_num(np.moveaxis(slope, (0, 1), (-2, -1))))[0]


def _least(slope: np.ndarray) -> Value:
    """How far a system is from singular: least singular value, columns of length 1. Like the sine of an angle."""
    matrix = np.moveaxis(slope, (0, 1), (-2, -1))
    lengths = np.linalg.norm(matrix, axis=-2, keepdims=True)
    matrix = np.nan_to_num(matrix / np.where(lengths > 0, lengths, 1.0))
    return np.linalg.svd(matrix, compute_uv=False)[..., -1]
