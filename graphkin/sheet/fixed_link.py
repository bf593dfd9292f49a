"""The fixed link: pivots on hatched ground, fixed guides, fixed slots."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphkin.base.value import filled
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Slide
from graphkin.sheet import symbols
from graphkin.sheet.cams import follower
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import link_label
from graphkin.sheet.marks import Mark, Place, Shows
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Figure

_REACH, _AWAY, _STUB = 13.0, 18.0, 6.5
"""How far a fixed guide is drawn to each side of its block; away from a bar over it, and under it [mm]."""
_OVER = math.cos(math.radians(12))
"""A bar lies over a guide that leaves its block under a smaller angle."""


def grounds(skeleton: Skeleton, *others: Skeleton) -> Figure:
    """Everything that stands still, and the frame's number beside one sign of it.

    others   the same mechanism at further positions drawn over the first
    """
    figure = Figure()
    spots: list[Place] = []
    for run in _runs(skeleton, *others):
        figure.marks += run.marks()
        spots.append(run.end(run.high) + run.side * 2)
    figure.marks += _under_blocks(skeleton, *others)
    for point in skeleton.points:
        owners = skeleton.mechanism.owners[point]
        if FRAME in owners and len(owners) > 1:
            down = ground_way(point, skeleton, *others)
            figure.marks += symbols.pivot(skeleton.at(point), down, skeleton.step(point))
            spots.insert(0, skeleton.at(point) + (symbols.PIVOT_DEPTH + 1) * down)
    if spots:
        label = link_label(skeleton.mechanism.frame)
        figure.wanted.append(LabelRequest(label, spots[0], gap=2.0, away=1 + 0.3j, step=1))
    return figure


def ground_way(point: str, *skeletons: Skeleton) -> complex:
    """The side on which a pivot's ground lies: down, unless links leave that way."""
    ways = [way for skeleton in skeletons for way in skeleton.directions(point)]

    def badness(down: complex) -> float:
        nearest = max(((way * down.conjugate()).real for way in ways), default=-1.0)
        return max(0.0, nearest - 0.35) + {1j: 0.0, -1j: 0.2}.get(down, 0.12)

    return min((1j, -1 + 0j, 1 + 0j, -1j), key=badness)


# --- fixed guides -----------------------------------------------------------------------------


@filled
class _Run:
    """A stretch of a fixed line, with what slides on it."""

    foot: Place
    along: complex
    low: float
    high: float
    side: complex
    pins: bool
    step: int | None
    line: str
    points: tuple[str, ...]

    def end(self, t: float) -> Place:
        return self.foot + self.along * t

    def marks(self) -> list[Mark]:
        start, end = self.end(self.low), self.end(self.high)
        shows = Shows(FRAME, "slot" if self.pins else "guide", self.points, self.line)
        if not self.pins:
            return symbols.guide(start, end, self.side, self.step, shows)
        wall = self.side * 1.75
        return [
            *symbols.slot(start, end, shows, "outline", self.step),
            *symbols.hatch(start + wall, end + wall, self.side, self.step),
        ]


def _under_blocks(skeleton: Skeleton, *others: Skeleton) -> list[Mark]:
    """The ground under a block that the frame carries; on a pivot it stands on the pivot's."""
    marks: list[Mark] = []
    for slide in skeleton.mechanism.slides:
        if slide.block == FRAME and len(skeleton.mechanism.owners[slide.point]) == 1:
            at, along = skeleton.at(slide.point), skeleton.along(slide)
            side = _ground_side(at, along, skeleton, *others)
            foot, half = at + side * symbols.BLOCK.imag / 2, 0.7 * symbols.BLOCK.real * along
            marks += symbols.guide(foot - half, foot + half, side, skeleton.step(slide.point))
    return marks


def _runs(skeleton: Skeleton, *others: Skeleton) -> list[_Run]:
    """Fixed guides; stretches of one line that touch are one."""
    runs: list[_Run] = []
    for slide in skeleton.guides(FRAME):
        if follower(skeleton, slide) is not None:
            continue
        fresh = _run(slide, skeleton, *others)
        for run in runs:
            if _touch(run, fresh):
                t = (run.along.conjugate() * (fresh.foot - run.foot)).real
                run.low, run.high = min(run.low, t + fresh.low), max(run.high, t + fresh.high)
                run.points += fresh.points
                break
        else:
            runs.append(fresh)
    return runs


def _touch(run: _Run, other: _Run) -> bool:
    off = other.foot - run.foot
    if run.pins != other.pins or abs((run.along.conjugate() * other.along).imag) > 1e-3:
        return False
    if abs((run.along.conjugate() * off).imag) > 0.1:
        return False
    t = (run.along.conjugate() * off).real
    return run.low - 1 < t + other.high and t + other.low < run.high + 1


def _run(slide: Slide, skeleton: Skeleton, *others: Skeleton) -> _Run:
    """Under what slides at every position."""
    at, along = skeleton.at(slide.point), skeleton.along(slide)
    if along.real < -1e-9 or (abs(along.real) < 1e-9 and along.imag < 0):
        along = -along
    stops = [0.0, *((along.conjugate() * (other.at(slide.point) - at)).real for other in others)]
    side = _ground_side(at, along, skeleton, *others)
    step = skeleton.step(slide.line.origin)
    low, high = _reaches(along, [way for one in (skeleton, *others) for way in _bars(one, one.at(slide.point))])
    low, high = min(stops) - low, max(stops) + high
    return _Run(at, along, low, high, side, slide.block is None, step, slide.name, (slide.point,))


def _reaches(along: complex, ways: list[complex]) -> tuple[float, float]:
    """How far a guide goes back and on from its block: little where a bar hides it."""
    turned = [(way * along.conjugate()).real for way in ways]
    back, on = any(t < -_OVER for t in turned), any(t > _OVER for t in turned)
    if back == on:
        return _REACH, _REACH
    return (_STUB, _AWAY) if back else (_AWAY, _STUB)


def _bars(skeleton: Skeleton, at: Place) -> Iterator[complex]:
    """Where bars leave a place to."""
    for ends in skeleton.segments():
        for here, there in (ends, ends[::-1]):
            if abs(here - at) < 0.1 < abs(there - at):
                yield (there - at) / abs(there - at)


def _ground_side(at: Place, along: complex, *skeletons: Skeleton) -> complex:
    return away_from(at, along, [skeleton.at(point) for skeleton in skeletons for point in skeleton.points])


def away_from(at: Place, along: complex, places: list[Place]) -> complex:
    """The side of a fixed line away from the mechanism's points; below where that does not decide."""
    normal = along * 1j
    weight = sum((normal.conjugate() * (place - at)).real for place in places)
    below = normal if (normal.imag, normal.real) > (0, 0) else -normal
    if abs(weight) < 5:
        return below
    return -normal if weight > 0 else normal
