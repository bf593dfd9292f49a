"""Bobillier's construction: from two guided points of a link, the centre of curvature of any third point's path.

The pole tangent makes with one ray of the pole the angle that the other ray makes with the collineation axis. So the
axis of two other points is the known one turned as their rays are turned: an angle is carried over, and lines cross.
A guided point whose centre lies at infinity (a slider) is no exception. A wheel that rolls on the frame shows pole
and pole tangent itself, where it touches its track: one guided point is enough, and the angle is that of the tangent.
Source: theory of machines, Euler-Savary and Bobillier.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from itertools import permutations

import numpy as np

from graphkin.base.geometry import cross, number
from graphkin.base.plain import Plain
from graphkin.base.value import bulky, frozen
from graphkin.construction import drafting
from graphkin.construction.drafting import INFINITE, Board, Drafting, DraftMeet, Far, Pricked, Stage, Through, replay
from graphkin.errors.studies import NoBobillier
from graphkin.model.mechanism import FRAME
from graphkin.studies.centres.about import About, about_json
from graphkin.studies.centres.search import CLEAR


@frozen
class Guided:
    """A point of the link whose path's centre of curvature is known: a pivot, or at infinity across a guide.

    centre  homogeneous (3,) [m]; written  the centre's letter
    measured  the centre is that of velocity and acceleration, nothing guides the point itself
    pivoted  the centre is a point of the mechanism
    """

    point: str
    written: str
    place: complex
    centre: tuple[float, float, float]
    measured: bool = False
    pivoted: bool = False


@bulky
class Bobillier:
    """The construction on a link about its pole, and the letters of its points.

    guides   the two points it starts from; one of a wheel that rolls on the frame
    point, answer  the point and its centre of curvature; pole, crossings: the letters of P, and of Q, if any, and the
             second Q
    """

    seen: About
    construction: Drafting
    guides: tuple[Guided, ...]
    point: str
    pole: str
    crossings: tuple[str, ...]
    answer: str

    @cached_property
    def board(self) -> Board:
        """Every point and line."""
        return replay(self.construction)


def guided(seen: About) -> list[Guided]:
    """Points of the link that a pivoted link, a fixed guide or a wheel on a fixed track leads; then measured ones."""
    led = {entry.point: entry for entry in _led(seen)}
    machine, points = seen.found.method.mechanism, dict(led)
    for point in machine.links[seen.link].points:
        if point not in led and point in seen.plot.position:
            carried = seen.carried(complex(seen.plot.position[point]))
            centre = _infinite(1j * carried.velocity) if np.isinf(carried.centre) else _finite(carried.centre)
            points[point] = Guided(point, f"{point}0", carried.place, centre, measured=True)
    return sorted(points.values(), key=lambda entry: entry.measured)


def _finite(place: complex) -> tuple[float, float, float]:
    return place.real, place.imag, 1.0


def _infinite(direction: complex) -> tuple[float, float, float]:
    return direction.real, direction.imag, 0.0


def _led(seen: About) -> Iterator[Guided]:
    """Points on links that turn about a fixed point or slide along a fixed line, and those on fixed guides."""
    machine, plot, centring = seen.found.method.mechanism, seen.plot, seen.found.centring
    own, position = machine.links[seen.link].points, plot.position
    for stage in centring.stages:
        step, links, written = stage.last, centring.links[stage.last.name], ""
        if FRAME not in links or seen.link in links:
            continue
        if isinstance(step, Pricked) and stage.say == "hinge" and step.point in position:
            written, centre = step.point, _finite(complex(position[step.point]))
        elif isinstance(step, Far):
            centre = _infinite(1j * complex(plot.guide_direction(step.line)))
        else:
            continue
        for link in links:
            for point in machine.links[link].points if link != FRAME else ():
                if point in own and point in position:
                    yield Guided(point, written or f"{point}0", complex(position[point]), centre, pivoted=bool(written))
    for slide in machine.slides:
        if slide.guide == FRAME and slide.point in own:
            centre = _infinite(1j * complex(plot.guide_direction(slide.name)))
            yield Guided(slide.point, f"{slide.point}0", complex(position[slide.point]), centre)


def bobillier(seen: About, point: str | complex) -> Bobillier:
    """The construction for a point of the mechanism, or for a place [m] of the link's plane.

    Raises NoBobillier where the pole is a fixed point or at infinity, where the link is at rest or the point at the
    pole, where the guided points lie on one ray, and where only the point's own path shows its centre.
    """
    owners = seen.found.method.mechanism.owners

    def free(letter: str) -> str:
        """The letter, with primes where a point of the mechanism has it."""
        while letter in owners:
            letter += "'"
        return letter

    def lettered(entry: Guided) -> Guided:
        """A guided point; a pivot keeps its own letter."""
        return entry if entry.pivoted else replace(entry, written=free(entry.written))

    place = complex(seen.plot.position[point]) if isinstance(point, str) else complex(point)
    letter = point if isinstance(point, str) else free("C")
    reason = ""
    if seen.diameter is None:
        reason = "translation" if seen.moves else "rest"
    elif not seen.diameter:
        reason = "pivot"
    elif abs(place - seen.pole) <= INFINITE * seen.size:
        reason = "cusp"
    if reason:
        raise NoBobillier(seen.found.method.mechanism.where("links", seen.link), seen.called, reason)
    guides = tuple(map(lettered, _clearest(seen, place)))
    points = {entry.point: _finite(entry.place) for entry in guides} | {letter: _finite(place)}
    points |= {entry.written: entry.centre for entry in guides}
    pole, q, qc, answer = (free(name) for name in ("P", "Q", f"Q_{letter}", f"K_{letter}"))
    first, *others = guides
    begun = _of_two(first, others[0], letter, pole, q) if others else _of_wheel(first, letter, pole, seen.pole)
    stages, crossings = (*begun, *_ended(first, letter, qc, answer)), (q, qc) if others else (qc,)
    return Bobillier(seen, Drafting({}, stages, points), guides, letter, pole, crossings, answer)


def _rolls(seen: About) -> bool:
    """True where the link is a wheel that rolls on the frame."""
    every = (pair.rolling for pair in seen.found.method.mechanism.pairs)
    return any({*rolling.wheels} == {seen.link, FRAME} for rolling in every if rolling is not None)


def _clearest(seen: About, place: complex) -> tuple[Guided, ...]:
    """Two guided points on different rays, the first on another ray than the point; guides before measured ones. The
    point itself is none that is measured: its centre is what is looked for. One guide of a wheel on the frame may do.

    Rays are far from being one, and the first point far from the pole, where its lines would say nothing.
    """
    near = INFINITE * seen.size
    able = [entry for entry in guided(seen)
            if not entry.measured or min(abs(entry.place - seen.pole), abs(entry.place - place)) > near]  # fmt: skip
    out = (place - seen.pole) / abs(place - seen.pole)
    alone = [(entry,) for entry in able if not entry.measured] if _rolls(seen) else []
    best: tuple[tuple[bool, float], tuple[Guided, ...]] | None = None
    for first, *others in (*permutations(able, 2), *alone):
        ray = _ray(first)
        rays = (abs(number(cross(ray, along))) for along in (out, *map(_ray, others)))
        clear = min(*rays, abs(first.place - seen.pole) / seen.size)
        worth = not any(entry.measured for entry in (first, *others)), round(min(clear, 0.3), 6)
        if clear > CLEAR and (best is None or worth > best[0]):
            best = worth, (first, *others)
    if best is None:
        reason = "line" if len(able) > 1 else "alone"
        raise NoBobillier(seen.found.method.mechanism.where("links", seen.link), seen.called, reason)
    return best[1]


def _ray(entry: Guided) -> complex:
    """The direction of the ray through a guided point and its centre."""
    x, y, w = entry.centre
    along = complex(x, y) - w * entry.place
    return along / abs(along)


def _of_two(first: Guided, second: Guided, c: str, pole: str, q: str) -> Iterator[Stage]:
    """From the rays of two points to the axis of the first and the point."""
    a, b, a0, b0 = first.point, second.point, first.written, second.written
    yield Stage("P", (Through("ray a", a, a0), Through("ray b", b, b0), DraftMeet(pole, "ray a", "ray b")))
    yield Stage("Q", (Through("line ab", a, b), Through("line a0b0", a0, b0), DraftMeet(q, "line ab", "line a0b0")))
    yield Stage("axis", (Through("axis", pole, q),))
    yield Stage("ray c", (Through("ray c", pole, c),))
    yield Stage("axis c", (drafting.CarriedAngle("axis c", pole, "axis", "ray b", "ray c"),))


def _of_wheel(guide: Guided, c: str, pole: str, touching: complex) -> Iterator[Stage]:
    """The same from where a wheel touches its track [m] and the common tangent there."""
    yield Stage("P rolling", (Through("ray a", guide.point, guide.written), drafting.ChosenPoint(pole, touching)))
    yield Stage("tangent", (drafting.Perpendicular("tangent", pole, "ray a"),))
    yield Stage("ray c", (Through("ray c", pole, c),))
    yield Stage("axis c rolling", (drafting.CarriedAngle("axis c", pole, "ray a", "tangent", "ray c"),))


def _ended(first: Guided, c: str, qc: str, answer: str) -> Iterator[Stage]:
    yield Stage("Qc", (Through("line ac", first.point, c), DraftMeet(qc, "line ac", "axis c")))
    yield Stage("K", (Through("line a0qc", first.written, qc), DraftMeet(answer, "line a0qc", "ray c")))


def bobillier_json(solution: Bobillier) -> dict[str, Plain]:
    """The link about its pole, with the centre of curvature of the point's path in it."""
    return about_json(solution.seen)
