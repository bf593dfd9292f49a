"""The drawn position: of all ways to put the mechanism together, the one nearest to the sketch.

The search starts from the sketch and from many other positions, so that every assembly within reach
is seen and the sketch only has to choose. The random starts are the same every time. A sketch that is
exact needs no choice.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, partial

import numpy as np

from graphkin.analytic.branching import SAME, BranchJudge, branched
from graphkin.analytic.loops import Loops, loops_of
from graphkin.analytic.newton import EquationSystem, close, search
from graphkin.analytic.rules import LinearRelation, driven, placing
from graphkin.analytic.sketch import guess
from graphkin.analytic.vectors import Complex, Real, applied
from graphkin.base.cache import kept
from graphkin.base.geometry import wrapped
from graphkin.base.tolerances import ROUNDED
from graphkin.base.value import frozen
from graphkin.errors import NoAssembly
from graphkin.model.mechanism import FRAME, Link, Mechanism

_STARTS = 128
_MANY = 32
"""Unknowns with which fewer starts are tried, all loops at once; an assembly is rarely found so, only the gap."""
_EXACT = 1e-6
"""An assembly this near its sketch has none nearer [size]."""

_APART, _OFF = 0.05, 0.02
"""Points of a guide that show where it lies; a displacement that is not 0 by rounding, or by the sketch's [size]."""
_FEW = 10
"""Steps of Newton's method that lead from an exact sketch to its assembly, at most."""
_AJAR = 1e-2
"""Loops open by more than this at the sketch are closed nowhere so near to it [size]."""


@frozen
class ChosenAssembly:
    """The chosen position q (n,), or None; then the smallest gap found [m]. The system that was closed."""

    q: Real | None
    gap: float
    closure: EquationSystem


@frozen
class DrawnPosition:
    """The drawn position: unknowns q (n,), and each driver's value there [rad or m]; the system that gave it."""

    loops: Loops
    q: Real
    values: tuple[float, ...]
    closure: EquationSystem


@kept(8)
def drawn(mechanism: Mechanism) -> DrawnPosition:
    """Find the drawn position. Raises NoAssembly."""
    loops = loops_of(mechanism)
    found = assemble(mechanism, loops)
    if found.q is None:
        raise NoAssembly(mechanism.where("driver"), found.gap * 1e3)
    return DrawnPosition(loops, found.q, driver_values(mechanism, loops, found.q), found.closure)


def driver_values(mechanism: Mechanism, loops: Loops, q: Real) -> tuple[float, ...]:
    """Each driver's value: as the file gives it, else as found [rad or m]."""
    values = []
    for driver in mechanism.drivers:
        if driver.value is not None:
            values.append(driver.value)
            continue
        relation = driven(mechanism, driver)
        value = applied(loops.weights([relation]), q)[..., 0] + relation.constant
        if driver.kind != "slide":
            value = wrapped(value)
        values.append(float(value))
    return tuple(values)


def held(loops: Loops, relations: Sequence[LinearRelation]) -> tuple[LinearRelation, ...]:
    """Angles that nothing shows stay at 0."""
    return tuple(LinearRelation({unknown: 1.0}) for unknown in loops.silent(relations))


def idle(mechanism: Mechanism, loops: Loops) -> tuple[str, ...]:
    """Links whose rotation nothing shows and nothing drives."""
    drivers = (driven(mechanism, driver) for driver in mechanism.drivers)
    return tuple(unknown.name for unknown in loops.silent((*loops.relations, *drivers)))


def assemble(mechanism: Mechanism, loops: Loops, driving: bool = True) -> ChosenAssembly:
    """Put the mechanism together, its drivers and poses at their values unless not `driving`."""
    relations, c = _standing(mechanism, loops, driving)
    closure = EquationSystem.of(loops, relations)
    seen = guess(mechanism, loops)
    ajar = loops.open_by(seen)
    if not ajar >= _AJAR:
        near = np.nan_to_num(seen)[None]
        first = _closed(closure, near, c)[0] if np.isnan(ajar) else _met(closure, near, c, _FEW)
        if len(first) and _as_sketched(mechanism, loops, first[0]):
            return ChosenAssembly(first[0], 0.0, closure)
    starts = cache(partial(_starts, seen, mechanism, loops))
    found = _met(closure, branched(closure, _judge(mechanism, loops), seen, starts, c), c)
    if not len(found):
        found, ends = _closed(closure, starts()[:: 1 + len(closure.known.free) // _MANY], c)
    if not len(found):
        return ChosenAssembly(None, _smallest_gap(closure, ends, c) * loops.size, closure)
    return ChosenAssembly(choose(mechanism, loops, _distinct(found)), 0.0, closure)


def _judge(mechanism: Mechanism, loops: Loops) -> BranchJudge:
    """What the sketch and custom say of positions that are found in part."""
    rows, places = _sketched(mechanism, loops)
    lengths, forwards = _drawn_lengths(mechanism, loops), _taken_forwards(mechanism)
    return BranchJudge(rows, places / loops.size, _columns(loops, lengths), _columns(loops, forwards))


def _closed(closure: EquationSystem, starts: Real, c: Real) -> tuple[Real, Real]:
    """The assemblies found from starts (b, n), one for each that led to one; and where the search ended (b, n)."""
    ends = search(closure, starts, c)
    return _met(closure, ends, c), ends


def _met(closure: EquationSystem, near: Real, c: Real, steps: int = 40) -> Real:
    """The assemblies to which Newton leads from positions (b, n), one for each that led to one."""
    closed = close(closure, near, c, steps)
    met = (closed.gap < ROUNDED) & (closed.step < ROUNDED) & (closure.known.mismatch(c) < ROUNDED)
    return closed.q[met]


def _as_sketched(mechanism: Mechanism, loops: Loops, q: Real) -> bool:
    """Whether `choose` would choose this assembly from any: at the sketch, and no displacement the wrong way."""
    away = _from_sketch(mechanism, loops, q[None])[0]
    if away >= _EXACT * loops.size:
        return False
    open_to_doubt = _taken_forwards(mechanism) - _shown(mechanism, loops, q)
    return not _negative(loops, q[None], _drawn_lengths(mechanism, loops) | open_to_doubt)[0]


def _shown(mechanism: Mechanism, loops: Loops, q: Real) -> set[str]:
    """Displacements of which an exact sketch leaves no sign open: well off 0, of a point that it shows, along a guide
    of which it shows two points well apart."""
    fixed, apart = mechanism.links[FRAME].points, _APART * loops.size
    guides = {FRAME} | {name for name, link in mechanism.links.items() if _spread(mechanism, link) > apart}
    far = {unknown.name for unknown, value in zip(loops.unknowns, q) if unknown.kind == "s" and abs(value) > _OFF}
    shown = {pair.name for pair in mechanism.slides
             if pair.guide in guides and (pair.point in mechanism.sketch or pair.point in fixed)}  # fmt: skip
    return shown & far


def _spread(mechanism: Mechanism, link: Link) -> float:
    """How far apart those points of a link lie that the sketch shows, or the frame [m]."""
    fixed = mechanism.links[FRAME].points
    arms = [arm for point, arm in link.points.items() if point in mechanism.sketch or point in fixed]
    return max((abs(arm - arms[0]) for arm in arms), default=0.0)


def _smallest_gap(closure: EquationSystem, ends: Real, c: Real) -> float:
    """How near the loops come to closing; a mismatch of angles counts at the mechanism's size."""
    best = np.argsort(closure.loops.open_by(ends))[:4]
    gap = closure.loops.open_by(search(closure, ends[best], c, steps=300))
    return max(float(gap.min()), closure.known.mismatch(c))


def _standing(mechanism: Mechanism, loops: Loops, driving: bool = True) -> tuple[tuple[LinearRelation, ...], Real]:
    """The relations that hold at the drawn position, with their right sides (k,)."""
    given = placing(mechanism) if driving else []
    known = [(relation, 0.0) for relation in loops.relations if relation.offset is not None]
    placed = [(driven(mechanism, each), value) for each, value in given]
    known += [(relation, 0.0) for relation in held(loops, [relation for relation, _ in known + placed])]
    known += placed
    sides = [value - relation.constant for relation, value in known]
    return tuple(relation for relation, _ in known), np.array(sides, dtype=np.float64)


def _starts(seen: Real, mechanism: Mechanism, loops: Loops) -> Real:
    """The sketch first (with angles not seen at 0), then the sketch shaken more and more, then anything: (b, n)."""
    rng = np.random.default_rng(1)
    reach = np.array([np.pi if unknown.kind == "theta" else 1.5 for unknown in loops.unknowns])
    anywhere = rng.uniform(-reach, reach, (_STARTS, len(reach)))
    anywhere[0, reach == np.pi] = 0.0
    cylinders = _columns(loops, _drawn_lengths(mechanism, loops))
    anywhere[:, cylinders] = abs(anywhere[:, cylinders])
    shaken = seen + rng.normal(0, 1, anywhere.shape) * np.linspace(0, 0.5, _STARTS)[:, None]
    sketched = (np.arange(_STARTS) < _STARTS // 2)[:, None] & ~np.isnan(seen)
    return np.where(sketched, shaken, anywhere)


def _distinct(found: Real) -> Real:
    """One of each assembly, in the order found: (a, n).

    Angles count modulo 2 pi; read as an angle too, a small difference of displacements stays what it is.
    """
    kept: list[Real] = []
    while len(found):
        kept.append(found[0])
        found = found[np.max(np.abs(np.exp(1j * (found - found[0])) - 1), axis=1, initial=0.0) >= SAME]
    return np.array(kept)


def choose(mechanism: Mechanism, loops: Loops, found: Real) -> Real:
    """The assembly people drew: cylinders the right way round, then nearest to the sketch.

    Where the sketch does not tell two apart, displacements are taken positive.
    """
    backwards = _negative(loops, found, _drawn_lengths(mechanism, loops))
    found = found[backwards == backwards.min()]
    distance = _from_sketch(mechanism, loops, found)
    found = found[distance <= distance.min() + SAME * loops.size]
    return np.asarray(found[int(np.argmin(_negative(loops, found, _taken_forwards(mechanism))))])


def _from_sketch(mechanism: Mechanism, loops: Loops, found: Real) -> Real:
    """Distance of all sketched points together from their places in the sketch [m]: (a,); found (a, n)."""
    rows, places = _sketched(mechanism, loops)
    away = applied(rows, loops.vectors.at(found)) * loops.size - places
    return np.asarray(np.sqrt((np.abs(away) ** 2).sum(axis=-1)))


def _sketched(mechanism: Mechanism, loops: Loops) -> tuple[Complex, Complex]:
    """The sketched points' rows (k, m), and their places in the sketch [m]: (k,)."""
    names = [name for name in mechanism.sketch if name in loops.points]
    rows = np.array([loops.points[name] for name in names]).reshape(len(names), len(loops.vectors.base))
    return rows, np.array([mechanism.sketch[name] for name in names], dtype=np.complex128)


def _negative(loops: Loops, found: Real, names: set[str]) -> Real:
    """How many of the named displacements are negative: (a,)."""
    return np.asarray((found[:, _columns(loops, names)] < 0).sum(axis=1))


def _columns(loops: Loops, names: set[str]) -> list[int]:
    """The columns of these displacements."""
    return [at for at, unknown in enumerate(loops.unknowns) if unknown.kind == "s" and unknown.name in names]


def _drawn_lengths(mechanism: Mechanism, loops: Loops) -> set[str]:
    """Displacements that are positive as drawn: along a moving link of one point, which is its own line
    (a cylinder), and along a line of centres. A rack that cannot turn may be passed either way.
    """
    links, slides = mechanism.links, {pair.name for pair in mechanism.slides if pair.line.on_axis}
    across = {pair.name for pair in mechanism.slides} - slides
    blocks = {pair.block for pair in mechanism.slides}
    own = (joint for joint in loops.joints if joint.tail not in links or len(links[joint.tail].points) == 1)
    kept = (joint for joint in own if joint.slide in slides or (joint.tail not in blocks and joint.slide not in across))
    return {joint.slide for joint in kept if joint.slide is not None and joint.tail != FRAME}


def _taken_forwards(mechanism: Mechanism) -> set[str]:
    """Displacements taken positive where the sketch leaves them open: all."""
    return {pair.name for pair in mechanism.slides}
