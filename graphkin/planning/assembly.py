"""Which of the possible assemblies is meant, and positions that are none.

Every crossing of circles leaves two possibilities. `branches` draws all combinations that the sketch may mean; the
nearest is the one. A sketch that says nothing of a choice leaves it to custom: displacements count as positive.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping

import numpy as np

from graphkin.base.geometry import Value, cross
from graphkin.base.tolerances import CLOSED, ROUNDED
from graphkin.base.value import frozen
from graphkin.construction import Arc, Arm, Construction, Facts, Fit, Meet, Plot, Ray, Span, Swing, slide_key
from graphkin.errors import AmbiguousSketch, CannotAssemble, DeadPoint
from graphkin.model.naming import spelled
from graphkin.planning.branch_search import BETWEEN, DeadEnd, branches, told_slides
from graphkin.planning.branches import Branches
from graphkin.planning.structure import Topology

DEAD_DEG = 0.5
"""Lines that meet under less than this give no usable drawing [deg]."""
DEAD_SINE = float(np.sin(np.radians(DEAD_DEG)))


@frozen
class Assembly:
    """The crossing of each choice, +1 or -1, and angles by base link and displacements by `slide_key` as drawn."""

    sides: tuple[int, ...]
    near: Mapping[str, float]


def assemble(
    structure: Topology, construction: Construction, choices: int, facts: Facts, known: Mapping[str, float]
) -> Assembly:
    """The assembly that the sketch means.

    known  angles and displacements where the drawn position has them already
    """
    try:
        found = branches(structure, construction, facts, known)
    except DeadEnd as dead:
        raise _refusal(structure, construction, dead.plot) from None
    best = _nearest(structure, found)
    plot, sides = found.plot, found.sides[best]
    drawn = {base: _at(plot.theta[base], best).real for base in structure.bases if base in plot.theta}
    drawn |= {slide_key(slide): _at(value, best).real for slide, value in plot.s.items()}
    return Assembly(tuple(int(side) for side in sides), drawn)


def _nearest(structure: Topology, found: Branches) -> int:
    """The assembly nearest to the sketch; raises where the sketch lies between two."""
    if found.count == 1:
        return 0
    plot, sketch, count = found.plot, structure.mechanism.sketch, found.count
    sketched = np.array([np.broadcast_to(plot.position[p], count) for p in sketch if p in plot.position])
    target = np.array([sketch[p] for p in sketch if p in plot.position])
    sketched = sketched.reshape(len(target), count)
    far = (np.abs(sketched - target[:, None]) ** 2).sum(axis=0)
    best = int(np.argmin(far))
    same = _same(plot, best, count)
    for other in map(int, np.argsort(far, kind="stable")):
        if same[other]:
            continue
        apart = float((np.abs(sketched[:, best] - sketched[:, other]) ** 2).sum())
        if apart <= (1e-9 * _size(plot, best)) ** 2:
            best = _by_custom(structure, plot, best, other)
            same = _same(plot, best, count)
        elif far[other] - far[best] < BETWEEN * apart:
            raise _ambiguous(structure, plot, best, other)
    return best


def _same(plot: Plot, best: int, count: int) -> np.ndarray:
    """Which branches are one and the same assembly as one of them, itself or another (at a dead point): (w,)."""
    size, same = _size(plot, best), np.ones(count, dtype=bool)
    for value in (*plot.position.values(), *plot.s.values()):
        same &= np.abs(value - _at(value, best)) <= 1e-9 * size
    return same


def _size(plot: Plot, k: int) -> float:
    values = [_at(value, k) for value in plot.position.values()]
    return max(abs(value - values[0]) for value in values) or 1.0


def _at(value: Value, k: int) -> complex:
    return complex(value[k] if np.ndim(value) else value)


def _by_custom(structure: Topology, plot: Plot, first: int, second: int) -> int:
    """Assemblies that the sketch cannot tell apart: more positive displacements win, of the file's own slides."""
    told = [plot.s[name] for name in told_slides(structure)]
    score = [sum(float(np.sign(_at(value, k).real)) for value in told) for k in (first, second)]
    if score[0] == score[1]:
        raise _ambiguous(structure, plot, first, second)
    return first if score[0] > score[1] else second


def _ambiguous(structure: Topology, plot: Plot, first: int, second: int) -> AmbiguousSketch:
    """The points that would tell the two assemblies apart, each with its two places."""
    mechanism, size = structure.mechanism, _size(plot, first)
    places = {
        point: (_at(value, first), _at(value, second))
        for point, value in plot.position.items()
        if point in mechanism.points and abs(_at(value, first) - _at(value, second)) > 1e-9 * size
    }
    point, (one, two) = next(iter(places.items()), ("", (0j, 0j)))
    return AmbiguousSketch(
        mechanism.where("sketch", point), tuple(places), point, _millimetres(one, size), _millimetres(two, size)
    )


def _millimetres(place: complex, size: float) -> str:
    """Where to put a point in the sketch: as closely as figures in files go."""
    x, y = (1000 * part if abs(part) > ROUNDED * size else 0.0 for part in (place.real, place.imag))
    return f"[{x:.6g}, {y:.6g}]"


# --- positions that are none ------------------------------------------------------------------


def refuse_bad_positions(structure: Topology, construction: Construction, plot: Plot) -> None:
    """A single position that does not close, or is a dead point, raises; arrays pass, with NaN in them."""
    if any(isinstance(value, np.ndarray) and value.ndim for value in plot.position.values()):
        return
    for step, key in _crossings(construction):
        sine = plot.sines["position", key]
        if not np.isfinite(sine) or sine < DEAD_SINE:
            raise _refusal_at(structure, step, key, plot)
    refuse_open(structure, plot, CLOSED)


def refuse_open(structure: Topology, plot: Plot, part: float) -> None:
    """A link that repeats a constraint must fit it to a part of the mechanism's size."""
    size = extent(plot)
    link, gap = _open_link(structure, plot, size)
    if gap > part * size:
        from graphkin.planning.far_sketch import cannot_assemble

        mechanism = structure.mechanism
        called = (spelled(mechanism.called(link)),)
        raise cannot_assemble(mechanism, mechanism.where("links", link), called, [link], gap * 1000)


def _crossings(construction: Construction) -> Iterator[tuple[Meet | Swing | Fit, str]]:
    """The steps that may fail, each with the name under which the plot keeps its angle."""
    for step in construction.steps:
        if isinstance(step, Meet):
            yield step, step.point
        elif isinstance(step, Swing):
            yield step, step.slide
        elif isinstance(step, Fit):
            yield step, step.name


def _refusal(structure: Topology, construction: Construction, plot: Plot) -> CannotAssemble | DeadPoint:
    """Of the crossing at which no branch is left; before all of them, of a cylinder driven back too far."""
    last = None
    for step, key in _crossings(construction):
        if ("position", key) in plot.sines:
            last = step, key
            if not np.isfinite(plot.sines["position", key]).any():
                break
    return _driven_back(structure, plot) if last is None else _refusal_at(structure, *last, plot)


def _driven_back(structure: Topology, plot: Plot) -> CannotAssemble:
    """The slide that is the least drawn out, of those drawn so far."""
    mechanism = structure.mechanism
    slide = structure.slides[min(plot.s, key=lambda name: float(np.min(plot.s[name])))]
    links = dict.fromkeys((slide.guide, structure.home(structure.block(slide))))
    called = tuple(spelled(mechanism.called(link)) for link in links)
    driver = next(k for k, driver in enumerate(mechanism.drivers) if driver.link == slide.name)
    return CannotAssemble(mechanism.where("driver", driver), called, abs(float(np.min(plot.s[slide.name]))) * 1000)


def _refusal_at(structure: Topology, step: Meet | Swing | Fit, key: str, plot: Plot) -> CannotAssemble | DeadPoint:
    mechanism, links = structure.mechanism, links_of(structure, step)
    where = mechanism.where("links", *[link for link in links if structure.is_link(link)][-1:])
    from graphkin.planning.far_sketch import cannot_assemble
    from graphkin.planning.own_axis import along_own_axis

    called = tuple(spelled(mechanism.called(link)) for link in links)
    gap = float(np.nanmin(plot.misses.get(key, np.array(0.0))))
    if gap > CLOSED * extent(plot):
        return cannot_assemble(mechanism, where, called, links, gap * 1000)
    sine = np.nan_to_num(np.asarray(plot.sines["position", key], dtype=float))
    angle = float(np.degrees(np.arcsin(min(1.0, float(np.max(sine))))))
    return along_own_axis(mechanism, links, angle) or DeadPoint(where, called, angle)


def extent(plot: Plot) -> float:
    """How far the placed points lie apart [m]."""
    values = [*plot.position.values()]
    if any(isinstance(value, np.ndarray) for value in values):
        values = np.concatenate([np.ravel(value) for value in values]).tolist()
    placed = [value for value in values if cmath.isfinite(value)]
    return max(float(abs(value - placed[0])) for value in placed) if placed else 1.0


def _open_link(structure: Topology, plot: Plot, size: float) -> tuple[str, float]:
    """The link whose points fit its shape least, and by how much [m], in a mechanism of this size.

    Only a link that repeats a constraint can fail so; every other has been drawn from its shape.
    """
    worst, size = ("", 0.0), extent(plot)
    for link in structure.mechanism.links.values():
        points = list(link.points)
        if link.name not in plot.theta or link.name in structure.followers:
            continue
        turned = np.exp(1j * plot.theta[link.name]) if len(points) > 1 else 1.0
        for point in points[1:]:
            gap = abs(plot.arm(points[0], point) - link.arm(points[0], point) * turned)
            if gap > worst[1]:
                worst = link.name, float(gap)
    for slide in structure.slides.values():
        arm = plot.arm(slide.line.origin, slide.point)
        gap = abs(cross(plot.guide_direction(slide.name), arm))
        if slide.block is not None:  # which may not turn on its guide
            leaning = plot.theta[slide.block] - plot.theta[slide.guide] - slide.turn
            gap = max(gap, abs(np.exp(1j * leaning) - 1) * size)
        if gap > worst[1]:
            worst = structure.home(structure.block(slide)), float(gap)
    return worst


def links_of(structure: Topology, step: Meet | Swing | Fit) -> list[str]:
    """The links whose reach, or whose guide, a crossing is about."""
    if isinstance(step, Swing):
        pair = structure.slides[step.slide]
        return list(dict.fromkeys((pair.guide, structure.home(structure.block(pair)))))
    if isinstance(step, Fit):
        arms = [part for closure in step.closures for part in closure.parts if isinstance(part, Arm)]
        return list(dict.fromkeys(structure.home(arm.link) for arm in arms))
    found: dict[str, None] = {}
    for locus in (step.first, step.second):
        if isinstance(locus, Arc):
            found |= dict.fromkeys(_of_span(structure, locus.reach))
        elif isinstance(locus, Ray) and (slide := getattr(locus.direction, "slide", None)):
            pair = structure.slides[slide]
            found |= dict.fromkeys((structure.home(structure.block(pair)), pair.guide))
    return list(found)


def _of_span(structure: Topology, span: Span) -> list[str]:
    return [part.link if isinstance(part, Arm) else structure.slides[part.slide].guide for part in span.parts]


