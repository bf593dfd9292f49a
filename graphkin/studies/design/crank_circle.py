"""The circle of crank centres: every A on it sees C1C2 under theta, and so gives K; and the pencil's steps to A.

Two circles pass through C1 and C2 for one theta, mirrored in the line C1C2. Of each, only the arc that sees C1C2 under
theta itself serves, and of that not the part between F and G, where C1 and C2 would be reached on different
assemblies: the lines C1D and C2D cut it off for a rocker (at right angles to the guide for a slider).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise

import numpy as np

from graphkin.base.geometry import Array, Real, Value, number
from graphkin.base.value import frozen
from graphkin.construction.drafting import Bisector, CircleAbout, CircleThrough, DraftMeet
from graphkin.construction.drafting.steps import MarkOn, Parallel, Perpendicular, Reckon, Slanted, Stage, Step, Through
from graphkin.studies.design.model import CentreArc, Family, Reason
from graphkin.studies.linkages.triangles import greatest_between

_COUNT = 721  # directions looked at on an arc
_HALVINGS = 80
_LENGTHS = {"frame": "d", "crank": "a", "coupler": "b", "rod": "b", "offset": "e", "ac1": "ac1"}
"""Of each condition the length that it is put on, by its key in `Chord.lengths`."""


@frozen
class Chord:
    """C1, C2 and what makes an A good; all functions take one place or an array.

    theta   the angle under which A sees C1C2 [rad]
    corners a point and a direction each of the two lines that cut off F and G
    parted  true for an A by which C1 and C2 lie on different assemblies
    lengths of the linkage with its crank centre at A by letter, "ac1" the distance of A and C1 [m]
    gamma   its least transmission angle [rad]
    """

    first: complex
    second: complex
    theta: float
    corners: tuple[tuple[complex, complex], ...]
    parted: Callable[[Value], bool | Array]
    lengths: Callable[[Value], Mapping[str, Real]]
    gamma: Callable[[Value], Real]

    def circle(self, side: float) -> tuple[complex, float]:
        """Centre and radius; side 1: to the right of the direction from C1 to C2."""
        half = (self.second - self.first) / 2
        return self.first + half - 1j * side * half / math.tan(self.theta), abs(half) / math.sin(self.theta)


def family(chord: Chord, side: float) -> Family:
    """Everything on one circle."""
    centre, radius = chord.circle(side)
    arcs = tuple(_arcs(chord, side))
    good = [arc for arc in arcs if arc.name == "admissible"]
    angle = np.concatenate([_inside(arc) for arc in good]) if good else np.zeros(0)
    at = centre + radius * np.exp(1j * angle)
    lengths = {name: np.asarray(length) for name, length in chord.lengths(at).items()}

    def least(turn: Real) -> Real:
        return chord.gamma(centre + radius * np.exp(1j * turn))

    tops = [_highest(least, arc) for arc in good if _left(chord, arc)]
    best = max(tops, key=lambda top: top[1], default=(math.nan, math.nan))
    return Family(
        side, centre, radius, arcs, angle, at, lengths["a"], lengths["b"], lengths.get("d"), lengths.get("e"),
        np.asarray(chord.gamma(at)), best,
    )  # fmt: skip


def _left(chord: Chord, arc: CentreArc) -> bool:
    """True where A is nearer to C1 than to C2; the other half mirrors it."""
    middle = cmath.rect(1, (arc.start + arc.end) / 2)
    return ((chord.second - chord.first).conjugate() * middle).real < 0


def _inside(arc: CentreArc) -> Array:
    """Directions inside an arc, denser towards its ends [rad]."""
    part = (1 - np.cos(np.linspace(0, math.pi, _COUNT + 2)[1:-1])) / 2
    return arc.start + (arc.end - arc.start) * part


def _arcs(chord: Chord, side: float) -> Iterator[CentreArc]:
    """The circle from C2 all around, cut at C1, C2, F and G. The axis of C1C2 passes between F and G."""
    centre, radius = chord.circle(side)
    cuts = [chord.first, chord.second]
    for at, along in chord.corners:  # F and G: where the lines meet the circle again
        cuts.append(at + along * 2 * ((centre - at) * along.conjugate()).real / abs(along) ** 2)
    start = cmath.phase(chord.second - centre)
    turns = sorted({round((cmath.phase(cut - centre) - start) % math.tau, 15) % math.tau for cut in cuts})
    for low, high in pairwise([*turns, math.tau]):
        if high - low > 1e-9:
            name = worth_of(chord, side, centre + cmath.rect(radius, start + (low + high) / 2))
            yield CentreArc(start + low, start + high, name)


def worth_of(chord: Chord, side: float, at: complex) -> str:
    """The worth of a point of the circle, as `CentreArc.name` has it."""
    along = chord.second - chord.first
    if not -side * (along.conjugate() * (at - chord.first)).imag > 0:
        return "minor"
    return "FG" if chord.parted(at) else "admissible"


def _highest(size: Callable[[Real], Real], arc: CentreArc) -> tuple[float, float]:
    """The direction on an arc at which a function is largest, and its value: by steps, then by golden section."""
    turns = [arc.start, *_inside(arc).tolist(), arc.end]
    k = 1 + int(np.argmax(size(np.array(turns[1:-1]))))
    top = greatest_between(lambda turn: number(size(turn)), turns[k - 1], turns[k + 1], _HALVINGS)
    return top, number(size(top))


def _roots(size: Callable[[Real], Real], arc: CentreArc) -> list[float]:
    """Directions on an arc at which a function is 0: between steps of different sign, halved until nothing is left."""
    turns, roots = sorted([*_inside(arc).tolist(), _highest(size, arc)[0]]), []
    below = np.asarray(size(np.array(turns))) < 0
    for (low, first), (high, last) in pairwise(zip(turns, below.tolist())):
        if first == last:
            continue
        while low < (middle := (low + high) / 2) < high or high < middle < low:
            low, high = (middle, high) if (number(size(middle)) < 0) == first else (low, middle)
        roots.append((low + high) / 2)
    return roots


def steps_to_centre(
    chord: Chord, families: tuple[Family, ...], name: str, gamma_min: float | None = None
) -> Iterator[tuple[float, tuple[Stage, ...]]]:
    """Every place the pencil can put A: the side of the circle, and the stages up to A.

    name   "frame", "crank", "coupler", "ac1", "offset", "gamma_min", or "" for the best of all
    """
    if name == "gamma_min" and gamma_min is not None:
        for one in families:
            def excess(turn: Real, one: Family = one) -> Real:
                return chord.gamma(one.centre + one.radius * np.exp(1j * turn)) - gamma_min

            for arc in one.arcs:
                if arc.name == "admissible" and _left(chord, arc):
                    for turn in _roots(excess, arc):
                        yield one.side, (*_circle_stages(one.side), _by_trial(turn, "A by gamma"))
    elif not name:
        best = max((one for one in families if math.isfinite(one.best[1])), key=lambda one: one.best[1], default=None)
        if best is not None:
            yield best.side, (*_circle_stages(best.side), _by_trial(best.best[0], "A at best"))
    else:
        for one in families:
            for stage in _by_ruler(name, one.side):
                yield one.side, (*_circle_stages(one.side), stage)


def _circle_stages(side: float) -> tuple[Stage, ...]:
    """P and the circle through C1, C2, P, on the near side of C1C2 (1) or beyond it (-1)."""
    corner = (
        Through("C1C2", "C1", "C2"), Reckon("rest", "complement", ("theta",)),
        Slanted("C1P", "C1", "C2", "rest", -side), Perpendicular("C2P", "C2", "C1C2"), DraftMeet("P", "C1P", "C2P"),
    )  # fmt: skip
    return (
        Stage("corner" if side > 0 else "corner beyond", corner),
        Stage("circle" if side > 0 else "circle beyond", (CircleThrough("locus", ("C1", "C2", "P"), "O"),)),
    )


def _by_trial(turn: float, say: str) -> Stage:
    """A tried along the circle until the condition holds; no ruler gives where it ends."""
    return Stage(say, (MarkOn("A", "locus", turn),))


def _by_ruler(name: str, side: float) -> Iterator[Stage]:
    """The pencil's steps to A for a condition; its mirror image in the axis of C1C2 gives the same linkage."""
    if name == "frame":
        yield Stage("A by frame", (CircleAbout("reach", "D", "frame"), DraftMeet("A", "locus", "reach", near="C1")))
    elif name == "offset":
        level = Parallel("level", "C1C2", "offset", -side)
        yield Stage("A by offset", (level, DraftMeet("A", "level", "locus", near="C1")))
    elif name == "ac1":
        for near, far in (("", "C2"), ("C2", "")):
            steps = (CircleAbout("reach", "C1", "ac1"), DraftMeet("A", "locus", "reach", near=near, far=far))
            yield Stage("A by AC1", steps)
    elif name == "crank":
        yield Stage("A by crank", _by_length("crank", "P"))
    else:
        yield Stage("A by coupler", _by_length(name, ""))


def _by_length(name: str, high: str) -> tuple[Step, ...]:
    """2a or 2b laid off from C2: E sees C1C2 under 90 deg + theta/2, or theta/2, from about a middle N of the arc.

    high   the point that N is farther from, and E nearer to: P for the crank; for the coupler N is the other middle
    """
    middle = DraftMeet("N", "axis", "locus", far="P") if high else DraftMeet("N", "axis", "locus", near="P")
    return (
        Bisector("axis", "C1", "C2"), middle, CircleAbout("arc", "N", through="C1"), Reckon("twice", "double", (name,)),
        CircleAbout("span", "C2", "twice"), DraftMeet("E", "arc", "span", near=high or "C1"),
        Through("C2E", "C2", "E"), DraftMeet("A", "C2E", "locus", far="C2"),
    )  # fmt: skip


def bounds(name: str, families: tuple[Family, ...], chord: Chord) -> tuple[Reason, ...]:
    """The bounds within which a condition can be met, circle by circle.

    Values go one way along each admissible arc: the least and the greatest, the ends of the arcs included.
    """
    reasons: list[Reason] = []
    for one in families:
        if not len(one.angle):
            continue
        if name == "gamma_min":
            reasons.append(Reason("range angle", (("name", name), ("low", 0.0), ("high", one.best[1]))))
            continue
        ends = [turn for arc in one.arcs if arc.name == "admissible" for turn in (arc.start, arc.end)]
        places = [one.centre + one.radius * complex(math.cos(turn), math.sin(turn)) for turn in ends]
        values = [number(chord.lengths(at)[_LENGTHS[name]]) for at in places]
        values += np.asarray(chord.lengths(one.at)[_LENGTHS[name]]).tolist()
        reasons.append(Reason("range", (("name", name), ("low", min(values)), ("high", max(values)))))
    return tuple(reasons) or (Reason("no arc"),)
