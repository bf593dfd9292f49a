"""The drawn position: of all ways to put the mechanism together, the one nearest to the sketch.

The search starts from what the sketch and the drivers show of the unknowns, and from many other positions, so that
every assembly within reach is seen and the sketch only has to choose. The random starts are the same every time. A
sketch that is exact needs no choice.
"""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import field
from functools import cache, partial
from itertools import pairwise

import numpy as np

from graphkin.analytic.branching import SAME, BranchJudge, branched
from graphkin.analytic.loops import Complex, Loops, Reals, applied, loops_of
from graphkin.analytic.newton import EquationSystem, close, search
from graphkin.analytic.rules import Joint, LinearRelation, Unknown, driven, placing, theta
from graphkin.base.cache import kept
from graphkin.base.geometry import number, wrapped
from graphkin.base.tolerances import ROUNDED
from graphkin.base.value import filled, frozen
from graphkin.errors import NoAssembly
from graphkin.model.mechanism import FRAME, Link, Mechanism

_STARTS = 128
_MANY = 32
"""Unknowns with which fewer starts are tried, all loops at once; an assembly is rarely found so, only the gap."""
_EXACT = 1e-6  # an assembly this near its sketch has none nearer [size]
_APART, _OFF = 0.05, 0.02
"""Points of a guide that show where it lies; a displacement that is not 0 by rounding, or by the sketch's [size]."""
_FEW = 10  # steps of Newton's method that lead from an exact sketch to its assembly, at most
_AJAR = 1e-2  # loops open by more than this at the sketch are closed nowhere so near to it [size]


@frozen
class ChosenAssembly:
    """The chosen position q (n,), or None; then the smallest gap found [m]. The system that was closed."""

    q: Reals | None
    gap: float
    closure: EquationSystem


@frozen
class DrawnPosition:
    """The drawn position: unknowns q (n,), and each driver's value there [rad or m]; the system that gave it."""

    loops: Loops
    q: Reals
    values: tuple[float, ...]
    closure: EquationSystem


@kept(8)
def drawn(mechanism: Mechanism) -> DrawnPosition:
    """Find the drawn position. Raises NoAssembly."""
    loops = loops_of(mechanism)
    chosen = assemble(mechanism, loops)
    if chosen.q is None:
        raise NoAssembly(mechanism.where("driver"), chosen.gap * 1e3)
    return DrawnPosition(loops, chosen.q, driver_values(mechanism, loops, chosen.q), chosen.closure)


def driver_values(mechanism: Mechanism, loops: Loops, q: Reals) -> tuple[float, ...]:
    """Each driver's value: as the file gives it, else as found [rad or m]."""
    values = []
    for driver in mechanism.drivers:
        if (value := driver.value) is None:
            relation = driven(mechanism, driver)
            value = float(applied(loops.weights([relation]), q)[..., 0] + relation.constant)
            value = value if driver.kind == "slide" else number(wrapped(value))
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
    # the relations that hold at the drawn position, with their right sides (k,)
    known = [(relation, 0.0) for relation in loops.relations if relation.offset is not None]
    placed = [(driven(mechanism, each), value) for each, value in (placing(mechanism) if driving else [])]
    known += [(relation, 0.0) for relation in held(loops, [relation for relation, _ in known + placed])]
    known += placed
    sides = [value - relation.constant for relation, value in known]
    relations, c = tuple(relation for relation, _ in known), np.array(sides, dtype=np.float64)
    closure = EquationSystem.of(loops, relations)
    seen = guess(mechanism, loops)
    ajar = loops.open_by(seen)
    if not ajar >= _AJAR:
        near = np.nan_to_num(seen)[None]
        first = _met(closure, search(closure, near, c), c) if np.isnan(ajar) else _met(closure, near, c, _FEW)
        if len(first) and _as_sketched(mechanism, loops, first[0]):
            return ChosenAssembly(first[0], 0.0, closure)
    starts = cache(partial(_starts, seen, mechanism, loops))
    rows, places = _sketched(mechanism, loops)
    columns = (_columns(loops, names) for names in (_drawn_lengths(mechanism, loops), _taken_forwards(mechanism)))
    judge = BranchJudge(rows, places / loops.size, *columns)
    assemblies = _met(closure, branched(closure, judge, seen, starts, c), c)
    if not len(assemblies):
        ends = search(closure, starts()[:: 1 + len(closure.known.free) // _MANY], c)
        assemblies = _met(closure, ends, c)
    if not len(assemblies):
        # the smallest gap to which the loops come; a mismatch of angles counts at the mechanism's size
        best = np.argsort(closure.loops.open_by(ends))[:4]
        gap = closure.loops.open_by(search(closure, ends[best], c, steps=300))
        return ChosenAssembly(None, max(float(gap.min()), closure.known.mismatch(c)) * loops.size, closure)
    distinct: list[Reals] = []  # one of each; angles count modulo 2 pi, small displacements stay as they are if so read
    while len(assemblies):
        distinct.append(assemblies[0])
        apart = np.max(np.abs(np.exp(1j * (assemblies - assemblies[0])) - 1), axis=1, initial=0.0)
        assemblies = assemblies[apart >= SAME]
    return ChosenAssembly(choose(mechanism, loops, np.array(distinct)), 0.0, closure)


def _met(closure: EquationSystem, near: Reals, c: Reals, steps: int = 40) -> Reals:
    """The assemblies to which Newton leads from positions (b, n), one for each that led to one."""
    closed = close(closure, near, c, steps)
    met = (closed.gap < ROUNDED) & (closed.step < ROUNDED) & (closure.known.mismatch(c) < ROUNDED)
    return closed.q[met]


def _as_sketched(mechanism: Mechanism, loops: Loops, q: Reals) -> bool:
    """True if `choose` would choose this assembly from any: at the sketch, and no displacement the wrong way."""
    away = _from_sketch(mechanism, loops, q[None])[0]
    if away >= _EXACT * loops.size:
        return False
    # an exact sketch leaves no sign open of displacements well off 0, of a point that it shows, along a guide of which
    # it shows two points well apart
    seen, guides = {*mechanism.links[FRAME].points, *mechanism.sketch}, {FRAME}
    for name, link in mechanism.links.items():
        arms = [arm for point, arm in link.points.items() if point in seen]
        if max((abs(arm - arms[0]) for arm in arms), default=0.0) > _APART * loops.size:
            guides.add(name)
    far = {unknown.name for unknown, value in zip(loops.unknowns, q) if unknown.kind == "s" and abs(value) > _OFF}
    shown = far & {pair.name for pair in mechanism.slides if pair.guide in guides and pair.point in seen}
    in_doubt = _taken_forwards(mechanism) - shown
    return not _negative(loops, q[None], _drawn_lengths(mechanism, loops) | in_doubt)[0]


def _starts(seen: Reals, mechanism: Mechanism, loops: Loops) -> Reals:
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


def choose(mechanism: Mechanism, loops: Loops, assemblies: Reals) -> Reals:
    """The assembly people drew: cylinders the right way round, then nearest to the sketch. Where the sketch does not
    tell two apart, displacements are taken positive."""
    backwards = _negative(loops, assemblies, _drawn_lengths(mechanism, loops))
    assemblies = assemblies[backwards == backwards.min()]
    distance = _from_sketch(mechanism, loops, assemblies)
    assemblies = assemblies[distance <= distance.min() + SAME * loops.size]
    return np.asarray(assemblies[int(np.argmin(_negative(loops, assemblies, _taken_forwards(mechanism))))])


def _from_sketch(mechanism: Mechanism, loops: Loops, assemblies: Reals) -> Reals:
    """Distance of all sketched points together from their places in the sketch [m]: (a,), of assemblies (a, n)."""
    rows, places = _sketched(mechanism, loops)
    away = applied(rows, loops.vectors.at(assemblies)) * loops.size - places
    return np.asarray(np.sqrt((np.abs(away) ** 2).sum(axis=-1)))


def _sketched(mechanism: Mechanism, loops: Loops) -> tuple[Complex, Complex]:
    """The sketched points' rows (k, m), and their places in the sketch [m]: (k,)."""
    names = [name for name in mechanism.sketch if name in loops.points]
    rows = np.array([loops.points[name] for name in names]).reshape(len(names), len(loops.vectors.base))
    return rows, np.array([mechanism.sketch[name] for name in names], dtype=np.complex128)


def _negative(loops: Loops, assemblies: Reals, names: set[str]) -> Reals:
    """The number of named displacements that are negative: (a,)."""
    return np.asarray((assemblies[:, _columns(loops, names)] < 0).sum(axis=1))


def _columns(loops: Loops, names: set[str]) -> list[int]:
    """The columns of these displacements."""
    return [at for at, unknown in enumerate(loops.unknowns) if unknown.kind == "s" and unknown.name in names]


def _drawn_lengths(mechanism: Mechanism, loops: Loops) -> set[str]:
    """Displacements that are positive as drawn: of cylinders, and along lines of centres; a rack may be passed."""
    links, slides = mechanism.links, {pair.name for pair in mechanism.slides if pair.line.on_axis}
    across = {pair.name for pair in mechanism.slides} - slides
    blocks = {pair.block for pair in mechanism.slides}
    own = (joint for joint in loops.joints if joint.tail not in links or len(links[joint.tail].points) == 1)
    kept = (joint for joint in own if joint.slide in slides or (joint.tail not in blocks and joint.slide not in across))
    return {joint.slide for joint in kept if joint.slide is not None and joint.tail != FRAME}


def _taken_forwards(mechanism: Mechanism) -> set[str]:
    """Displacements taken positive where the sketch leaves them open: all."""
    return {pair.name for pair in mechanism.slides}


def guess(mechanism: Mechanism, loops: Loops) -> Reals:
    """The unknowns (n,) as far as the sketch and the drivers show them, in internal units; nan elsewhere."""
    seen = _Located(mechanism, loops.joints)
    while seen.look():
        pass
    seen.join_centres()
    values = {theta(link): angle for link, angle in seen.angles.items()}
    for joint in loops.joints:
        if joint.slide is not None:
            values[Unknown("s", joint.slide)] = seen.displacement(joint)
    table = [values.get(unknown, np.nan) for unknown in loops.unknowns]
    return np.asarray(np.array(table, dtype=np.float64) / loops.unit)


@filled
class _Located:
    """Located points [m] and angles of links [rad]; `look` adds what follows from them."""

    mechanism: Mechanism
    joints: tuple[Joint, ...]
    points: dict[str, complex] = field(default_factory=dict)
    angles: dict[str, float] = field(default_factory=lambda: {FRAME: 0.0})

    def __post_init__(self) -> None:
        self.points = {**self.mechanism.sketch, **self.mechanism.links[FRAME].points}

    def look(self) -> bool:
        """Add what follows from what is seen; whether anything did."""
        before = len(self.points), len(self.angles)
        for given, value in placing(self.mechanism):
            if given.kind == "angle":
                if given.from_link in self.angles and given.vector is not None:
                    links, back = self.mechanism.links, given.from_vector
                    start = 0.0 if back is None else cmath.phase(links[given.from_link].arm(*back))
                    angle = self.angles[given.from_link] + start + value
                    self.angles.setdefault(given.link, angle - cmath.phase(links[given.link].arm(*given.vector)))
            elif given.kind == "slide":
                joint = next(joint for joint in self.joints if joint.slide == given.link)
                origin = self._place(joint.tail, joint.tail_arm)
                if joint.tail in self.angles and origin is not None:
                    place = origin + value * joint.direction * cmath.rect(1, self.angles[joint.tail])
                    for name, arm in self.mechanism.links[joint.head].points.items():
                        if arm == joint.head_arm:
                            self.points.setdefault(name, place)
        for link in self.mechanism.links.values():
            self._fitted(link)
        for pair in self.mechanism.slides:
            # a block turns with its guide; two located points on a line give its direction
            if pair.block is not None and pair.guide in self.angles:
                self.angles.setdefault(pair.block, self.angles[pair.guide] + pair.turn)
            if pair.block is not None and pair.block in self.angles:
                self.angles.setdefault(pair.guide, self.angles[pair.block] - pair.turn)
            ends = self.points.get(pair.line.origin), self.points.get(pair.point)
            if ends[0] is not None and ends[1] is not None:
                self.angles.setdefault(pair.guide, cmath.phase((ends[1] - ends[0]) / pair.line.direction))
        return before != (len(self.points), len(self.angles))

    def _fitted(self, link: Link) -> None:
        """Two located points give the link's angle; the angle and one point give all its points."""
        if link.name in self.angles and all(name in self.points for name in link.points):
            return
        at = [(self.points[name], arm) for name, arm in link.points.items() if name in self.points]
        if not at:
            return
        place, arm = (sum(column) / len(at) for column in zip(*at, strict=True))
        turn = sum((here - place) * (there - arm).conjugate() for here, there in at)
        if abs(turn) > 0:
            self.angles.setdefault(link.name, cmath.phase(turn))
        if link.name in self.angles:
            unit = cmath.rect(1, self.angles[link.name])
            for name, there in link.points.items():
                self.points.setdefault(name, place + (there - arm) * unit)

    def join_centres(self) -> None:
        """Lines of centres, links of a pair's own making: from one centre to the other."""
        for near, far in pairwise(self.joints):
            if near.head == far.tail and near.head not in self.mechanism.links:
                start, end = self._place(near.tail, near.tail_arm), self._place(far.head, far.head_arm)
                if start is not None and end is not None:
                    self.points[near.head] = start
                    self.angles[near.head] = cmath.phase(end - start)

    def displacement(self, joint: Joint) -> float:
        """s as seen, nan where it is not [m]."""
        origin, point = self._place(joint.tail, joint.tail_arm), self._place(joint.head, joint.head_arm)
        if origin is None or point is None or joint.tail not in self.angles:
            return float("nan")
        along = joint.direction * cmath.rect(1, self.angles[joint.tail])
        return ((point - origin) / along).real

    def _place(self, name: str, arm: complex) -> complex | None:
        """The place where an arm of a link ends, None if that is not seen."""
        link = self.mechanism.links.get(name, Link(name, {name: 0}))
        seen = [(abs(arm - base), self.points[point], arm - base) for point, base in link.points.items()
                if point in self.points]  # fmt: skip
        if name == FRAME:
            return arm
        away, base, rest = min(seen, key=lambda each: each[0], default=(np.inf, 0j, 0j))
        if name in self.angles and seen:
            return base + rest * cmath.rect(1, self.angles[name])
        return base if away == 0 else None
