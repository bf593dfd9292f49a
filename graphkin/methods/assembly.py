"""Which of the possible assemblies is meant, and positions that are none.

Every crossing of circles leaves two possibilities. All combinations are drawn at once, as arrays; the sketch
picks the nearest. A sketch that says nothing of a choice leaves it to custom: displacements count as positive.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping

import numpy as np

from graphkin.errors import AmbiguousSketch, CannotAssemble, DeadPoint
from graphkin.geometry import Value, cross
from graphkin.mechanism import FRAME
from graphkin.methods.structure import Structure
from graphkin.steps import Arc, Arm, Construction, Facts, Fit, Meet, Plot, Ray, Span, Swing, replay, slide_key
from graphkin.value import frozen

__all__ = ["DEAD_SINE", "Assembly", "assemble", "extent", "links_of", "refuse_bad_positions", "refuse_open"]

DEAD_DEG = 0.5
"""Lines that meet under less than this give no usable drawing [deg]."""
DEAD_SINE = float(np.sin(np.radians(DEAD_DEG)))
CLOSED = 1e-9
"""A gap of less than this part of the mechanism's size is none."""


STARTS = 96
"""Assemblies tried from as many places where a group is found by fitting."""


@frozen
class Assembly:
    """The crossing of each choice, +1 or -1, and angles by base link and displacements by `slide_key` as drawn."""

    sides: tuple[int, ...]
    near: Mapping[str, float]


def assemble(
    structure: Structure, construction: Construction, choices: int, facts: Facts, known: Mapping[str, float]
) -> Assembly:
    """The assembly that the sketch means.

    known  angles and displacements where the drawn position has them already
    """
    fits = [step for step in construction.steps if isinstance(step, Fit)]
    combinations = np.array(list(itertools.product((1, -1), repeat=choices)), dtype=int).reshape(2**choices, choices)
    near: dict[str, Value] = {}
    if fits:
        combinations = np.repeat(combinations, STARTS, axis=0)
        near = _starts(structure, fits, len(combinations))
        near |= {name: np.full(len(combinations), known[name]) for name in near if name in known}
    sides = {k: combinations[:, k] for k in range(choices)}
    plot = replay(construction, Plot(facts, {**known, **near}), sides)
    possible = _possible(structure, plot, len(combinations))
    if not possible.any():
        raise _refusal(structure, construction, plot)
    best = _nearest(structure, plot, possible)
    drawn = {base: _at(plot.theta[base], best).real for base in structure.bases if base in plot.theta}
    drawn |= {slide_key(slide): _at(value, best).real for slide, value in plot.s.items()}
    return Assembly(tuple(int(side) for side in combinations[best]), drawn)


def _starts(structure: Structure, fits: list[Fit], count: int) -> dict[str, Value]:
    """Where fitting starts: angles and displacements as in the sketch where it tells them, else at random."""
    rng = np.random.default_rng(20)
    near: dict[str, Value] = {}
    for fit in fits:
        for base in fit.angles:
            hint = _sketched_angle(structure, base)
            spread = rng.uniform(-np.pi, np.pi, count) * (1.0 if hint is None else rng.choice((0.03, 0.3, 1.0), count))
            near[base] = (hint or 0.0) + spread
        size = _sketch_size(structure)
        for slide in fit.slides:
            near[slide_key(slide)] = rng.uniform(-1.5, 1.5, count) * size
    return near


def _sketched_angle(structure: Structure, base: str) -> float | None:
    """The angle of a base link by two places of one of its group that the sketch, or the frame, tells."""
    mechanism = structure.mechanism
    places = {**mechanism.sketch, **mechanism.links[FRAME].points}
    for body, turn in structure.turns.items():
        told = [p for p in structure.bodies[body] if p in places]
        if turn.base == base and len(told) > 1 and not turn.drivers:
            shape = structure.shapes[body]
            far = max(told, key=lambda point: abs(shape[point] - shape[told[0]]))
            arm, drawn = shape[far] - shape[told[0]], places[far] - places[told[0]]
            if abs(arm) > 0:
                return float(np.angle(drawn / arm)) - turn.constant
    return None


def _sketch_size(structure: Structure) -> float:
    mechanism = structure.mechanism
    places = [*mechanism.sketch.values(), *mechanism.links[FRAME].points.values()]
    return max((abs(a - places[0]) for a in places), default=1.0) or 1.0


def _possible(structure: Structure, plot: Plot, count: int) -> np.ndarray:
    """Combinations that close, with cylinders at the positive displacement they were drawn with."""
    possible = np.ones(count, dtype=bool)
    for value in plot.position.values():
        possible &= np.isfinite(np.broadcast_to(value, count))
    for name, slide in structure.slides.items():
        if name in plot.s and slide.guide != FRAME and _bare(structure, slide.guide):
            possible &= np.broadcast_to(plot.s[name], count) > 0
    return possible


def _bare(structure: Structure, guide: str) -> bool:
    """Whether a guide is a cylinder: a link of one point, with no direction but its line."""
    return len(structure.bodies[guide]) == 1


def _nearest(structure: Structure, plot: Plot, possible: np.ndarray) -> int:
    """The combination nearest to the sketch; raises where the sketch lies between two."""
    sketch = structure.mechanism.sketch
    count = len(possible)
    sketched = np.array([np.broadcast_to(plot.position[p], count) for p in sketch if p in plot.position])
    target = np.array([sketch[p] for p in sketch if p in plot.position])
    sketched = sketched.reshape(len(target), count)
    far = np.where(possible, (np.abs(sketched - target[:, None]) ** 2).sum(axis=0), np.inf)
    best = int(np.argmin(far))
    for other in np.argsort(far, kind="stable"):
        if other == best or not possible[other] or _same(plot, best, other):
            continue
        apart = float((np.abs(sketched[:, best] - sketched[:, other]) ** 2).sum())
        if apart <= (1e-9 * _size(plot, best)) ** 2:
            best = _by_custom(structure, plot, best, int(other))
        elif far[other] - far[best] < 0.04 * apart:
            raise _ambiguous(structure, plot, best, int(other))
    return best


def _same(plot: Plot, first: int, second: int) -> bool:
    """Whether two combinations are one and the same assembly (at a dead point)."""
    size = _size(plot, first)
    return all(
        abs(_at(value, first) - _at(value, second)) <= 1e-9 * size for value in plot.position.values()
    ) and all(abs(_at(value, first) - _at(value, second)) <= 1e-9 * size for value in plot.s.values())


def _size(plot: Plot, k: int) -> float:
    values = [_at(value, k) for value in plot.position.values()]
    return max(abs(value - values[0]) for value in values) or 1.0


def _at(value: Value, k: int) -> complex:
    return complex(np.broadcast_to(value, (k + 1,) if np.ndim(value) == 0 else np.shape(value))[k])


def _by_custom(structure: Structure, plot: Plot, first: int, second: int) -> int:
    """Assemblies that the sketch cannot tell apart: more positive displacements win, of the file's own slides."""
    told = [plot.s[name] for name, pair in structure.slides.items() if not pair.line.origin.endswith(" origin")]
    score = [sum(float(np.sign(_at(value, k).real)) for value in told) for k in (first, second)]
    if score[0] == score[1]:
        raise _ambiguous(structure, plot, first, second)
    return first if score[0] > score[1] else second


def _ambiguous(structure: Structure, plot: Plot, first: int, second: int) -> AmbiguousSketch:
    """The points that would tell the two assemblies apart, each with its two places."""
    mechanism, size = structure.mechanism, _size(plot, first)
    places = {
        point: (_at(value, first), _at(value, second))
        for point, value in plot.position.items()
        if point[0].isupper() and abs(_at(value, first) - _at(value, second)) > 1e-9 * size
    }
    point, (one, two) = next(iter(places.items()), ("", (0j, 0j)))
    return AmbiguousSketch(
        mechanism.where("sketch", point), tuple(places), point, _millimetres(one), _millimetres(two)
    )


def _millimetres(place: complex) -> str:
    return f"[{place.real * 1000:.6g}, {place.imag * 1000:.6g}]"


# --- positions that are none ------------------------------------------------------------------


def refuse_bad_positions(structure: Structure, construction: Construction, plot: Plot) -> None:
    """A single position that does not close, or is a dead point, raises; arrays pass, with NaN in them."""
    if any(np.ndim(value) for value in plot.position.values()):
        return
    for step, key in _crossings(construction):
        sine = plot.sines["position", key]
        if not np.isfinite(sine) or sine < DEAD_SINE:
            raise _refusal_at(structure, step, key, plot)
    refuse_open(structure, plot, CLOSED)


def refuse_open(structure: Structure, plot: Plot, part: float) -> None:
    """A link that repeats a constraint must fit it to a part of the mechanism's size."""
    link, gap = _open_link(structure, plot)
    if gap > part * extent(plot):
        mechanism = structure.mechanism
        raise CannotAssemble(mechanism.where("links", link), (mechanism.called(link),), gap * 1000)


def _crossings(construction: Construction) -> Iterator[tuple[Meet | Swing | Fit, str]]:
    """The steps that may fail, each with the name under which the plot keeps its angle."""
    for step in construction.steps:
        if isinstance(step, Meet):
            yield step, step.point
        elif isinstance(step, Swing):
            yield step, step.slide
        elif isinstance(step, Fit):
            yield step, step.name


def _refusal(structure: Structure, construction: Construction, plot: Plot) -> CannotAssemble | DeadPoint:
    """Of the first crossing at which no combination is left."""
    for step, key in _crossings(construction):
        if not np.isfinite(plot.sines["position", key]).any():
            return _refusal_at(structure, step, key, plot)
    return _refusal_at(structure, step, key, plot)


def _refusal_at(structure: Structure, step: Meet | Swing | Fit, key: str, plot: Plot) -> CannotAssemble | DeadPoint:
    mechanism, links = structure.mechanism, links_of(structure, step)
    where = mechanism.where("links", links[-1]) if links else mechanism.where("links")
    called = tuple(mechanism.called(link) for link in links)
    gap = float(np.nanmin(plot.misses.get(key, np.array(0.0))))
    if gap > CLOSED * extent(plot):
        return CannotAssemble(where, called, gap * 1000)
    sine = np.nan_to_num(np.asarray(plot.sines["position", key], dtype=float))
    return DeadPoint(where, called, float(np.degrees(np.arcsin(min(1.0, float(np.max(sine)))))))


def extent(plot: Plot) -> float:
    """How far the placed points lie apart [m]."""
    values = np.concatenate([np.ravel(value) for value in plot.position.values()])
    placed = values[np.isfinite(values)]
    return float(np.max(np.abs(placed - placed[0]))) if placed.size else 1.0


def _open_link(structure: Structure, plot: Plot) -> tuple[str, float]:
    """The link whose points fit its shape least, and by how much [m].

    Only a link that repeats a constraint can fail so; every other has been drawn from its shape.
    """
    worst = ("", 0.0)
    for link in structure.mechanism.links.values():
        points = list(link.points)
        if link.name not in plot.theta or link.name in structure.followers:
            continue
        turned = np.exp(1j * plot.theta[link.name])
        for point in points[1:]:
            gap = abs(plot.arm(points[0], point) - link.arm(points[0], point) * turned)
            worst = max(worst, (link.name, float(gap)), key=lambda entry: entry[1])
    for slide in structure.slides.values():
        arm = plot.arm(slide.line.origin, slide.point)
        gap = abs(cross(plot.guide_direction(slide.name), arm))
        if slide.block is not None:  # which may not turn on its guide
            leaning = plot.theta[slide.block] - plot.theta[slide.guide] - slide.turn
            gap = max(gap, abs(np.exp(1j * leaning) - 1) * extent(plot))
        worst = max(worst, (structure.home(structure.block(slide)), float(gap)), key=lambda entry: entry[1])
    return worst


def links_of(structure: Structure, step: Meet | Swing | Fit) -> list[str]:
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


def _of_span(structure: Structure, span: Span) -> list[str]:
    return [part.link if isinstance(part, Arm) else structure.slides[part.slide].guide for part in span.parts]


