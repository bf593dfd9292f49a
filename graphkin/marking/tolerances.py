"""What accuracy paper allows: each quantity's scatter, and which step costs it most."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import (
    Construction,
    Coriolis,
    Driven,
    LayOff,
    Normal,
    Plane,
    Simultaneous,
    Size,
    Tangential,
    Term,
    Turning,
)
from graphkin.marking.handed import readable
from graphkin.marking.key import Key, KeyEntry
from graphkin.marking.making import DRAWINGS, drawings_of, pencil_of
from graphkin.marking.pencil import called
from graphkin.marking.scatter import Drawings, spread
from graphkin.marking.slips import Mark, Slips, seed_of
from graphkin.model.mechanism import ROUNDING
from graphkin.planning import Method

_FEWER = 500
_COUNTS = 1e-4
"""A step with a smaller part of the scatter is not told."""


@frozen
class Cost:
    """What one step costs: its part of each quantity's scatter (variance), by quantity; `name`: the arrow laid off."""

    mark: Mark
    name: str
    parts: Mapping[str, float]
    over_all: float


@frozen
class Tolerances:
    """Quantities with what they may be off, and steps, the costliest first.

    drawings  how often the construction was drawn
    failed    part of the drawings whose links did not meet
    """

    key: Key
    entries: tuple[KeyEntry, ...]
    costs: tuple[Cost, ...]
    drawings: int
    failed: float

    def worst(self, text: str) -> Cost | None:
        """The step that costs a quantity most."""
        some = [cost for cost in self.costs if cost.parts.get(text, 0.0) > 0]
        return max(some, key=lambda cost: cost.parts[text], default=None)


def tolerances(key: Key, method: Method) -> Tolerances:
    """The scatter of a key's quantities, taken apart: one error of the pencil at a time."""
    quantities = [q for entry in key.entries if (q := readable(method.mechanism, entry.text)) is not None]
    every = drawings_of(method, key.marking, DRAWINGS)
    values = every.values(quantities)[0]
    right, sorts = np.array([entry.right for entry in key.entries]), [entry.sort for entry in key.entries]
    whole = spread(values, right, sorts)
    names = _arrows(method)
    costs = []
    for mark in list(every.slips.seen):
        slips = Slips(seed_of(method.mechanism), _FEWER, lambda one, mark=mark: one == mark)  # type: ignore[misc]
        alone = spread(Drawings.of(method, pencil_of(key.marking), slips).values(quantities)[0], right, sorts)
        costs.append(_cost(mark, names, key, alone, whole))
    told = sorted((cost for cost in costs if max(cost.parts.values()) > _COUNTS), key=lambda cost: -cost.over_all)
    failed = every.failed + (1 - every.failed) * float(np.isnan(values).any(axis=1).mean())
    return Tolerances(key, key.entries, tuple(told), DRAWINGS, failed)


def _cost(mark: Mark, names: Mapping[tuple[str, ...], str], key: Key, alone: np.ndarray, whole: np.ndarray) -> Cost:
    with np.errstate(invalid="ignore", divide="ignore"):
        parts = np.nan_to_num((alone / whole) ** 2, nan=0.0, posinf=0.0)
    asked = [part for part, entry in zip(parts, key.entries, strict=True) if entry.points]
    parts = np.append(parts, np.mean(asked) if asked else 0.0)
    # both are sampled: of one step's scatter alone there may come out a little more
    *of_each, over_all = map(float, np.where(parts > ROUNDING, np.minimum(parts, 1.0), 0.0))
    by_text = {entry.text: part for entry, part in zip(key.entries, of_each, strict=True)}
    return Cost(mark, names.get(mark.of, ""), by_text, over_all)


def _arrows(method: Method) -> dict[tuple[str, ...], str]:
    """What marks call an arrow, with its name in the polygon."""
    found: dict[tuple[str, ...], str] = {}
    for construction in (method.velocity, method.acceleration):
        for step in construction.steps:
            if isinstance(step, LayOff) and step.term.size is not None:
                found.setdefault(called(step.term.size), step.term.name(construction.plane))
            elif isinstance(step, Simultaneous):
                for size in (size for chain in step.chains for size, _ in chain.known):
                    found.setdefault(called(size), _name(size, construction.plane, method.velocity))
    return found


def _name(size: Size, plane: Plane, velocity: Construction) -> str:
    """An arrow of equations that are solved together, by its kind and its points."""
    match size:
        case Driven(slide):
            return slide
        case Normal(_, tail, head) | Tangential(_, tail, head) | Turning(_, tail, head):
            part = {Normal: "n", Tangential: "t"}.get(type(size), "")
            return Term(head, tail, part, None, None, "", "").name(plane)
        case Coriolis(_, tail, head):
            at = next(node.site.point for node in (velocity.nodes[tail], velocity.nodes[head]) if node.site)
            of, seen_from = (at if node == velocity.pole else velocity.nodes[node].of for node in (head, tail))
            return Term(of, seen_from, "k", None, None, "", "").name(plane)
        case _:
            return ""
