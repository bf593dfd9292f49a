"""The choice of one of the possible assemblies.

Every crossing of circles leaves two possibilities. `branches` draws all combinations that the sketch may mean; the
nearest is the one. A sketch that says nothing of a choice leaves it to custom: displacements count as positive.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from graphkin.base.tolerances import ROUNDED
from graphkin.construction import Construction, Equation, Facts, Meet, Plot, Step, Swing, slide_key
from graphkin.errors import AmbiguousDirection, AmbiguousSketch
from graphkin.planning.branch_search import BETWEEN, DeadEnd, at, branches, slides_of_file
from graphkin.planning.fit_starts import Branches
from graphkin.planning.refusals import dead_end
from graphkin.planning.structure import Topology

TOUCHING = 1e-6  # two assemblies nearer to each other are one, at a dead point


Assembly = tuple[tuple[int, ...], Mapping[str, float]]
"""The crossing of each choice, +1 or -1, and angles by base link and displacements by `slide_key` as drawn."""


def assemble(
    structure: Topology, construction: Construction, choices: int, facts: Facts, known: Mapping[str, float]
) -> Assembly:
    """The assembly that the sketch means; `known`: angles and displacements that the drawn position has already."""
    try:
        assemblies = branches(structure, construction, facts, known)
    except DeadEnd as dead:
        raise dead_end(structure, construction, dead.plot) from None
    best = _nearest(structure, assemblies)
    plot = assemblies.plot
    near = {base: at(plot.theta[base], best).real for base in structure.bases if base in plot.theta}
    near |= {slide_key(slide): at(value, best).real for slide, value in plot.s.items()}
    return tuple(int(side) for side in assemblies.sides[best]), near


def _nearest(structure: Topology, assemblies: Branches) -> int:
    """The assembly nearest to the sketch; raises where the sketch lies between two."""
    if assemblies.count == 1:
        return 0
    plot, sketch, count = assemblies.plot, structure.mechanism.sketch, assemblies.count
    target = np.array([sketch[p] for p in sketch if p in plot.position])
    sketched = np.array([np.broadcast_to(plot.position[p], count) for p in sketch if p in plot.position])
    sketched = sketched.reshape(len(target), count)
    far = (np.abs(sketched - target[:, None]) ** 2).sum(axis=0)
    best = int(np.argmin(far))
    same = _same(plot, best, count)
    for other in map(int, np.argsort(far, kind="stable")):
        if same[other]:
            continue
        apart = float((np.abs(sketched[:, best] - sketched[:, other]) ** 2).sum())
        if apart <= (1e-9 * _size(plot, best)) ** 2:
            # assemblies that the sketch cannot tell apart: more positive displacements win, of the file's own slides
            displacements = [plot.s[name] for name in slides_of_file(structure)]
            score = [sum(float(np.sign(at(value, k).real)) for value in displacements) for k in (best, other)]
            if score[0] == score[1]:
                raise _ambiguous(structure, plot, best, other)
            best = best if score[0] > score[1] else other
            same = _same(plot, best, count)
        elif far[other] - far[best] < BETWEEN * apart:
            raise _ambiguous(structure, plot, best, other)
    return best


def _same(plot: Plot, best: int, count: int) -> np.ndarray:
    """True for branches that are the same assembly as one of them, but for rounding at a dead point: (w,)."""
    size, same = _size(plot, best), np.ones(count, dtype=bool)
    for value in (*plot.position.values(), *plot.s.values()):
        same &= np.abs(value - at(value, best)) <= TOUCHING * size
    return same


def _size(plot: Plot, k: int) -> float:
    values = [at(value, k) for value in plot.position.values()]
    return max(abs(value - values[0]) for value in values) or 1.0


def _ambiguous(structure: Topology, plot: Plot, first: int, second: int) -> AmbiguousSketch | AmbiguousDirection:
    """The points that would tell the two assemblies apart, each with its two places; else the link."""
    mechanism, size = structure.mechanism, _size(plot, first)
    places = {point: (at(value, first), at(value, second)) for point, value in plot.position.items()
              if point in mechanism.points and abs(at(value, first) - at(value, second)) > 1e-9 * size}  # fmt: skip
    if not places:
        turned = {link: abs(np.exp(1j * at(value, first)) - np.exp(1j * at(value, second)))
                  for link, value in plot.theta.items() if link in mechanism.links}  # fmt: skip
        link = max(turned, key=turned.__getitem__)
        return AmbiguousDirection(mechanism.where("links", link), link)
    point, (one, two) = next(iter(places.items()))
    where = mechanism.where("sketch", point)
    return AmbiguousSketch(where, tuple(places), point, _millimetres(one, size), _millimetres(two, size))


def _millimetres(place: complex, size: float) -> str:
    """The text of a point in the sketch: as closely as figures in files go."""
    x, y = (1000 * part if abs(part) > ROUNDED * size else 0.0 for part in (place.real, place.imag))
    return f"[{x:.6g}, {y:.6g}]"


def with_sides(construction: Construction, sides: tuple[int, ...]) -> Construction:
    """The construction with the crossings that the sketch asks for."""
    if not sides:
        return construction
    parts: list[Step | Equation] = []
    for part in construction.parts:
        if not isinstance(part, Equation):
            parts.append(_on_side(part, sides))
        elif any(isinstance(step, Meet | Swing) and step.choice is not None for step in part.steps):
            parts.append(replace(part, steps=tuple(_on_side(step, sides) for step in part.steps)))
        else:
            parts.append(part)
    return replace(construction, parts=tuple(parts))


def _on_side(step: Step, sides: tuple[int, ...]) -> Step:
    if isinstance(step, Meet | Swing) and step.choice is not None:
        return replace(step, side=sides[step.choice])
    return step
