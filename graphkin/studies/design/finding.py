"""A on the circle of crank centres: by each further condition, as pencil steps, on either circle."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from graphkin.construction.drafting import (
    Bisector,
    CircleAbout,
    CircleThrough,
    DraftMeet,
    MarkOn,
    Parallel,
    Perpendicular,
    Reckon,
    Slanted,
    Stage,
    Step,
    Through,
)
from graphkin.studies.design.arcs import Chord, found_at
from graphkin.studies.design.model import Family, Reason

Found = tuple[float, tuple[Stage, ...]]


def circle_stages(side: float) -> tuple[Stage, ...]:
    """P and the circle through C1, C2, P, on the near side of C1C2 (1) or beyond it (-1)."""
    corner = (
        Through("C1C2", "C1", "C2"), Reckon("rest", "complement", ("theta",)),
        Slanted("C1P", "C1", "C2", "rest", -side), Perpendicular("C2P", "C2", "C1C2"), DraftMeet("P", "C1P", "C2P"),
    )  # fmt: skip
    return (
        Stage("corner" if side > 0 else "corner beyond", corner),
        Stage("circle" if side > 0 else "circle beyond", (CircleThrough("locus", ("C1", "C2", "P"), "O"),)),
    )


def on_circle(
    chord: Chord, families: tuple[Family, ...], name: str, *, gamma_wanted: float | None = None
) -> Iterator[Found]:
    """Every place the pencil can put A: the side of the circle, and the stages up to A.

    name   "frame", "crank", "coupler", "ac1", "offset", "gamma_min", or "" for the best of all
    """
    if name == "gamma_min" and gamma_wanted is not None:
        for one, turn in found_at(chord, families, lambda at: chord.gamma(at) - gamma_wanted):
            yield one.side, (*circle_stages(one.side), *_by_trial(turn, "A by gamma"))
    elif not name:
        best = max((one for one in families if math.isfinite(one.best[1])), key=lambda one: one.best[1], default=None)
        if best is not None:
            yield best.side, (*circle_stages(best.side), *_by_trial(best.best[0], "A at best"))
    else:
        for one in families:
            for stage in _ways(name, one.side):
                yield one.side, (*circle_stages(one.side), stage)


def _by_trial(turn: float, say: str) -> tuple[Stage, ...]:
    """A tried along the circle until the condition holds; no ruler gives where it ends."""
    return (Stage(say, (MarkOn("A", "locus", turn),)),)


def _ways(name: str, side: float) -> Iterator[Stage]:
    """The pencil's ways to A for a condition; its mirror image in the axis of C1C2 gives the same linkage."""
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


_VALUES = {"frame": 2, "crank": 0, "coupler": 1, "rod": 1, "offset": 3}


def ranged(name: str, families: tuple[Family, ...], chord: Chord) -> tuple[Reason, ...]:
    """Within what bounds the condition can be met, circle by circle."""
    found: list[Reason] = []
    for one in families:
        if len(one.angle):
            low, high = _bounds(name, one, chord)
            key = "range angle" if name == "gamma_min" else "range"
            found.append(Reason(key, (("name", name), ("low", low), ("high", high))))
    return tuple(found) or (Reason("no arc"),)


def _bounds(name: str, one: Family, chord: Chord) -> tuple[float, float]:
    """Least and greatest value on the admissible arcs, their ends included: values go one way along each."""
    if name == "gamma_min":
        return 0.0, one.best[1]
    ends = [turn for arc in one.arcs if arc.name == "admissible" for turn in (arc.start, arc.end)]
    values = [_value(name, one, chord, turn) for turn in ends]
    values += [float(value) for value in _along(name, one, chord)]
    return min(values), max(values)


def _value(name: str, one: Family, chord: Chord, turn: float) -> float:
    at = one.centre + one.radius * complex(math.cos(turn), math.sin(turn))
    return float(abs(at - chord.first) if name == "ac1" else chord.lengths(at)[_VALUES[name]])


def _along(name: str, one: Family, chord: Chord) -> Any:
    return abs(one.at - chord.first) if name == "ac1" else chord.lengths(one.at)[_VALUES[name]]
