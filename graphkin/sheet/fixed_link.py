"""The fixed link and what drives the mechanism: hatched ground, fixed guides and slots; arcs and arrows of drivers."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import chain, product

from graphkin.base.boxes import free_about
from graphkin.base.cache import kept
from graphkin.base.lines import away_from, crossing
from graphkin.base.value import filled
from graphkin.model.mechanism import FRAME, Driver
from graphkin.model.pairs import Pair, RollingContact, Slide
from graphkin.model.wheels import wheels_of
from graphkin.planning import Method
from graphkin.say.reading import driven_motions
from graphkin.sheet import symbols
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, between, joined, link_label, quantity_label, vector_label
from graphkin.sheet.marks import ArcMark, Mark, Place, Shows
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.wheels import follower
from graphkin.sheet.window import Figure

_REACH, _AWAY, _HIDDEN = 13.0, 18.0, 4.0
"""Reach of a fixed guide to each side of its block; away from a bar over it, and where it ends unseen under the block
[mm]."""
_OVER = math.cos(math.radians(12))  # a bar lies over a guide that leaves its block under a smaller angle
_CROSSING = (14, 22), (31, 40)  # where a crank's arc, which crosses it, begins before it [deg]
_ASIDE = 1.5 * symbols.SWEEP  # from the middle of an arc to that of another behind it
_APART, _OFF = 3.0, 2.0  # between two arcs about one point, or two arrows of one slide; of a head from lines [mm]
_SHORT = 6.0  # from a vector that is no longer its arc would lie apart [mm]
Ends = tuple[Place, Place]
_LONG, _WITHIN = 11.0, 10.0  # of the arrows of a driven slide; a larger wheel has room for them [mm]


def grounds(skeleton: Skeleton, *others: Skeleton) -> Figure:
    """Everything that stands still, and the frame's number; others: further positions, drawn over the first."""
    figure, spots = Figure(), list[Place]()
    for run in _runs(skeleton, *others):
        figure.marks += run.marks()
        spots.append(run.end(run.high) + run.side * 2)
    for slide in skeleton.mechanism.slides:  # a block that the frame carries; on a pivot it stands on the pivot's
        if slide.block == FRAME and len(skeleton.mechanism.owners[slide.point]) == 1:
            at, along = skeleton.at(slide.point), skeleton.direction(slide.line)
            side = _ground_side(at, along, skeleton, *others)
            foot, half = at + side * symbols.BLOCK.imag / 2, 0.7 * symbols.BLOCK.real * along
            figure.marks += symbols.guide(foot - half, foot + half, side, skeleton.step(slide.point))
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
    """The side on which a pivot's ground lies: down, unless links leave in that direction."""
    leaving = [along for skeleton in skeletons for along in skeleton.directions(point)]

    def badness(down: complex) -> float:
        nearest = max(((along * down.conjugate()).real for along in leaving), default=-1.0)
        return max(0.0, nearest - 0.35) + {1j: 0.0, -1j: 0.2}.get(down, 0.12)

    return min((1j, -1 + 0j, 1 + 0j, -1j), key=badness)


@filled
class _FixedStretch:
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

    def marks(self) -> Sequence[Mark]:
        start, end = self.end(self.low), self.end(self.high)
        shows = Shows(FRAME, "slot" if self.pins else "guide", self.points, self.line)
        if not self.pins:
            return symbols.guide(start, end, self.side, self.step, shows)
        off = self.side * symbols.SLOT
        wall = symbols.hatch(start + off, end + off, self.side, self.step)
        return symbols.slot((start, end), shows, self.step) + wall


def _runs(skeleton: Skeleton, *others: Skeleton) -> list[_FixedStretch]:
    """Fixed guides; stretches of one line that touch are one."""
    runs: list[_FixedStretch] = []
    for slide in skeleton.guides(FRAME):
        if follower(skeleton, slide) is not None:
            continue
        fresh = _run(slide, skeleton, *others)
        for run in runs:
            off, turn = fresh.foot - run.foot, run.along.conjugate()
            aside, t = abs((turn * off).imag), (turn * off).real
            alike = run.pins == fresh.pins and abs((turn * fresh.along).imag) <= 1e-3 and aside <= 0.1
            if alike and run.low - 1 < t + fresh.high and t + fresh.low < run.high + 1:
                run.low, run.high = min(run.low, t + fresh.low), max(run.high, t + fresh.high)
                run.points += fresh.points
                break
        else:
            runs.append(fresh)
    return runs


def _run(slide: Slide, skeleton: Skeleton, *others: Skeleton) -> _FixedStretch:
    """Under what slides at every position."""
    at, along = skeleton.at(slide.point), skeleton.direction(slide.line)
    if along.real < -1e-9 or (abs(along.real) < 1e-9 and along.imag < 0):
        along = -along
    stops = [0.0, *((along.conjugate() * (other.at(slide.point) - at)).real for other in others)]
    side, step = _ground_side(at, along, skeleton, *others), skeleton.step(slide.line.origin)
    turned: list[float] = []  # of the bars that leave what slides, how far each lies along the line
    for one in (skeleton, *others):
        block = one.at(slide.point)
        for here, there in chain.from_iterable((ends, ends[::-1]) for ends in one.segments):
            if abs(here - block) < 0.1 < abs(there - block):
                turned.append(((there - block) / abs(there - block) * along.conjugate()).real)
    back, on = any(t < -_OVER for t in turned), any(t > _OVER for t in turned)
    before, beyond = (_REACH, _REACH) if back == on else (_HIDDEN, _AWAY) if back else (_AWAY, _HIDDEN)
    ends = list[float]()  # before links that would cross it; under the block where little would be seen of it
    for way, stop, far in ((-1, -min(stops), before), (1, max(stops), beyond)):
        start, tip = at + along * way * (stop + _HIDDEN), at + along * way * (stop + far + 2)
        met = (crossing(start, tip, *bar) for each in (skeleton, *others) for bar in each.segments)
        most = min([far, *(abs(place - start) + _HIDDEN - 2 for place in met if place is not None)])
        ends.append(way * (stop + (most if most > symbols.BLOCK.real / 2 + 3 else _HIDDEN)))
    return _FixedStretch(at, along, ends[0], ends[1], side, slide.block is None, step, slide.name, (slide.point,))


def _ground_side(at: Place, along: complex, *skeletons: Skeleton) -> complex:
    return away_from(at, along, [skeleton.at(point) for skeleton in skeletons for point in skeleton.points])


def drives(skeleton: Skeleton, method: Method) -> Figure:
    """Arrows of all drivers that move."""
    figure = Figure()
    for driver in (driver for driver in skeleton.mechanism.drivers if driver.rate or driver.acceleration):
        if driver.kind == "slide":
            _slide_arrows(skeleton, driver, figure, method)
        elif driver.vector is not None:  # about the vector's tail, across the link
            at, tip = (skeleton.at(point) for point in driver.vector)
            arms = [tip - at, *(skeleton.at(point) - at for point in skeleton.named(driver.link))]
            arm = arms[0] if abs(arms[0]) > _SHORT else max(arms, key=abs)  # its arc crosses a bar of the link
            if abs(arm) >= 1:
                towards, radius = arm / abs(arm), min(9.0, max(6.0, 0.45 * abs(arm)))
                _arcs(skeleton, driver, figure, driver.vector, radius, towards, _CROSSING, 0.8 * abs(arm))
        elif driver.kind == "spin":  # in a wheel whose direction does not matter, about its centre
            for wheel in [each for each in wheels_of(skeleton.mechanism) if each.link == driver.link][:1]:
                radius = min(9.0, max(4.0, 0.6 * wheel.radius / skeleton.window.scale))
                _arcs(skeleton, driver, figure, (wheel.centre,), radius, 1, [range(0, 360, 45)])
    return figure


def _arcs(
    skeleton: Skeleton, driver: Driver, figure: Figure, on: tuple[str, ...], radius: float,
    towards: complex, turns: Sequence[Sequence[int]], reach: float = 0.0,
) -> None:  # fmt: skip
    """An arc about the first point, one for each sense; turns: where it may begin after `towards` [deg], the later ones
    if its head lies on something else; reach [mm]."""
    at, seen_from = skeleton.at(on[0]), driver.from_link if driver.from_link != FRAME else ""
    motions = ("ω", driver.rate), ("α", driver.acceleration)
    senses = {letter: math.copysign(1, value) for letter, value in motions if value}
    links = (link for link in (driver.link, driver.from_link) if link != FRAME)
    called, step = between([*map(skeleton.mechanism.called, links)]), skeleton.step(*on)
    radii = (radius, radius + _APART) if radius + _APART < reach else (radius,)
    for sense in dict.fromkeys(senses.values()):
        text = [letter for letter in senses if senses[letter] == sense]
        half = cmath.rect(1, -sense * symbols.SWEEP / 2)  # from the start of an arc to its middle
        starts = {towards * cmath.rect(1, sense * math.radians(turn)): -k for k, t in enumerate(turns) for turn in t}
        before = [arc for arc in figure.marks if isinstance(arc, ArcMark) and arc.centre == at]
        ways = [way for way in product(radii, starts) if _bare(way[0], way[1] * half, before)]
        beyond = max((arc.radius + _APART for arc in before), default=radius)
        free = {(r, start): [clearance(skeleton, at + r * start * half**k) for k in (2, 1)]
                for r, start in ways or product([beyond], starts)}  # fmt: skip
        radius, start = max(free, key=lambda way: (free[way][0] > _OFF, starts[way[1]], -way[0], free[way][1]))
        shows = Shows(driver.link, "omega" if "ω" in text else "alpha", on[:1], seen_from)
        figure.marks += symbols.spin(at, start * half, sense * symbols.SWEEP, radius, step, shows)
        # off the link, on the side where its angle is not; of two at its own head, which is not on the other's side
        at_head = len({*senses.values()}) > 1 or (sense > 0) == ((driver.value or 0.0) >= 0)
        off = start * half ** (1.5 if at_head else 0.0)
        label = joined([quantity_label(letter, called) for letter in text])
        figure.wanted.append(LabelRequest(label, at + off * radius, gap=0.3, away=off, step=step))


def _bare(radius: float, middle: complex, arcs: Sequence[ArcMark]) -> bool:
    """True for an arc about a point that lies beside none of others about it; middle: its direction."""
    beside = (cmath.phase(middle * cmath.rect(1, -arc.start - arc.sweep / 2)) for arc in arcs
              if abs(arc.radius - radius) < _APART)  # fmt: skip
    return all(abs(angle) > _ASIDE for angle in beside)


def clearance(skeleton: Skeleton, *places: Place, more: Sequence[Ends] = ()) -> float:
    """Distance of places from the nearest link, or of more lines, as far as it matters to the eye [mm]."""
    gaps = [5.0, *(abs(abs(place - at) - radius) for at, radius in skeleton.circles for place in places)]
    return float(free_about(places, [*skeleton.segments, *feet(skeleton), *more], min(gaps)).min())


@kept(2)
def feet(skeleton: Skeleton) -> list[Ends]:
    """Lines along the signs of pivots, and along the ground under them."""
    pivots = [point for point in skeleton.points if FRAME in skeleton.mechanism.owners[point]]
    ways = [(skeleton.at(point), symbols.PIVOT_DEPTH * ground_way(point, skeleton)) for point in pivots]
    return [each for at, way in ways for each in ((at, at + way), (at + (1 + 1j) * way, at + (1 - 1j) * way))]


def _slide_arrows(skeleton: Skeleton, driver: Driver, figure: Figure, method: Method) -> None:
    """Beside the block (or the centre of what rolls), in the directions of its velocity and of its acceleration."""
    pair = skeleton.mechanism.pair(driver.link)
    path, taken = pair.path, list[Ends]()
    assert path is not None
    for name, plane, value in driven_motions(method, driver, path.point):
        along, step = skeleton.direction(path.line) * math.copysign(1, value), skeleton.step(path.point)
        start, across = _beside(skeleton, pair, skeleton.at(path.point), along, taken)
        taken.append((start, start + _LONG * along))
        shows = Shows(path.line.link, "push" if plane == "velocity" else "thrust", line=driver.link)
        figure.marks += symbols.arrow(*taken[-1], shows=shows, step=step)
        figure.wanted.append(LabelRequest(vector_label(name), *taken[-1], away=across, step=step))


def _beside(skeleton: Skeleton, pair: Pair, at: Place, along: complex, taken: Sequence[Ends]) -> tuple[Place, complex]:
    """Where such an arrow starts that is clear of links and of those drawn before, and the side on which it lies."""
    sides = sorted((along * 1j, along * -1j), key=lambda side: side.imag)
    if isinstance(pair, Slide) and skeleton.is_cylinder(pair):
        foot = skeleton.at(pair.line.origin)
        at = foot + (1 + symbols.TUBE) / 2 * (at - foot) - 2 * along
    rim = max((radius for centre, radius in skeleton.circles if abs(centre - at) < 0.1), default=0.0)
    if isinstance(pair, RollingContact) and pair.line is not None and rim < _WITHIN:  # not in the ground under it
        sides = [skeleton.direction(pair.line) * (-1j if pair.left else 1j)]
    out = 5.2 if not 0 < rim < _WITHIN else 5.2 + rim - 1.5
    tries = [(at + side * off - along * 4, side) for off in (out, out + _APART + LABEL)[: 1 + len(taken)]
             for side in sides]  # fmt: skip
    return max(tries, key=lambda each: clearance(skeleton, *(each[0] + t * along for t in (1, 7, 10)), more=taken))
