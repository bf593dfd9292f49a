"""How to find some instant centres with as few others as may be: of all lines on which a centre lies, the nearest two.

`search` finds all centres in the order of the circle diagram; whoever wants one of them draws fewer lines.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from itertools import combinations

import numpy as np

from graphkin.construction.drafting import Drafting, DraftMeet, LineStep, Stage, drawn_through, ruled
from graphkin.construction.drafting.board import product
from graphkin.studies.centres.instant_centres import Centres
from graphkin.studies.centres.search import WELL_APART, Centring, lines_to

_DRAWN, _FROM_VELOCITIES = 10, 1000
"""What a centre counts for that is found by two lines, and one that waits for the velocities."""


def shortest(found: Centres, wanted: Collection[str]) -> Centring:
    """The centring with no more stages than lead to some centres, in their order."""
    stages = _ways(found)
    hangs = _hanging(stages)
    needed = {name for one in wanted if one in stages for name in (one, *hangs[one])}
    asked_first = [*found.centring.links]
    order = sorted(needed, key=lambda name: (len(hangs[name]), asked_first.index(name)))
    return replace(found.centring, construction=Drafting({}, tuple(stages[name] for name in order)))


def _ways(found: Centres) -> dict[str, Stage]:
    """By centre the stage that gives it: those by definition, then better and better ones until there are none."""
    stages = {stage.last.name: stage for stage in found.centring.stages}
    direct = {name for name, stage in stages.items() if not isinstance(stage.last, DraftMeet)}
    weights = {name: _FROM_VELOCITIES if stages[name].say == "velocities" else 1 for name in direct}
    crossings = {name: [*_crossings(found, name)] for name in stages if name not in direct}
    hangs = _hanging(stages)
    for _ in stages:
        before = dict(stages)
        for name, others in crossings.items():
            for stage in others:
                needs = _needs(stage, hangs)
                if name not in needs and _cost(needs, weights) < _cost(hangs[name], weights):
                    stages[name] = stage
                    hangs = _hanging(stages)
        if stages == before:
            break
    return stages


def _hanging(stages: Mapping[str, Stage]) -> dict[str, frozenset[str]]:
    """By centre all those without which it is not found."""
    found: dict[str, frozenset[str]] = {}
    waiting = dict(stages)
    while waiting:
        for name, stage in [*waiting.items()]:
            if _ends(stage) <= found.keys():
                found[name] = _needs(waiting.pop(name), found)
    return found


def _ends(stage: Stage) -> set[str]:
    lines = stage.lines if isinstance(stage.last, DraftMeet) else ()
    return {end for line in lines for end in drawn_through(line)}


def _needs(stage: Stage, hangs: Mapping[str, frozenset[str]]) -> frozenset[str]:
    """All centres on which a stage hangs."""
    ends = _ends(stage)
    return frozenset(ends).union(*(hangs[end] for end in ends))


def _cost(needs: Collection[str], weights: Mapping[str, int]) -> int:
    """Those by definition count little: there is nothing to draw for them."""
    return sum(weights.get(name, _DRAWN) for name in needs)


def _crossings(found: Centres, name: str) -> Iterator[Stage]:
    """Every two lines that give a centre and lie well apart."""
    known = {frozenset(pair): each for each, pair in found.centring.links.items()}
    lines = [*_placed(found, name, known)]
    for (one, first), (other, second) in combinations(lines, 2):
        if float(np.linalg.norm(product(first, second))) > WELL_APART:
            yield Stage("two lines", (one, other, DraftMeet(name, one.name, other.name)))


def _placed(
    found: Centres, name: str, known: Mapping[frozenset[str], str]
) -> Iterator[tuple[LineStep, np.ndarray]]:  # fmt: skip
    for line in lines_to(found.method.mechanism, known, found.centring.links[name]):
        place = np.asarray(ruled(line, found.board))
        if np.isfinite(place).all():
            yield line, place
