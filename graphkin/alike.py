"""Mechanisms of one topology, proved together: one method draws them all, and the analysis solves them all, as arrays.

Methods are kept by topology, so that whoever solves mechanisms in batches plans each topology once. What arrays do not
settle beyond doubt (see `running.variants`, `analytic.variants`), and what has no like, is left to the caller.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from typing import TypeVar

import numpy as np

from graphkin.agreement import AGREE, Proved, apart_each, compare
from graphkin.analytic.variants import Many, motions
from graphkin.errors import GraphkinError
from graphkin.mechanism import Mechanism
from graphkin.planning import Method, plan
from graphkin.planning.equivalent import lower_pairs
from graphkin.planning.planner import with_other_points
from graphkin.planning.special import special_points
from graphkin.planning.stages import Group
from graphkin.readings import readings
from graphkin.running import replay_all
from graphkin.running.at_once import AtOnce, at_once, goes_together
from graphkin.stacking import topology

__all__ = ["planned_together", "proved_together"]

FEWEST = 3
"""Mechanisms of one topology from which arrays are quicker."""
MOST = 64
"""Topologies whose methods are kept."""
_METHODS: dict[Hashable, Method] = {}
_Done = TypeVar("_Done")
_Work = Callable[[Method | None, Sequence[Mechanism]], Iterable[_Done | None]]


def proved_together(mechanisms: Sequence[Mechanism]) -> list[tuple[Method, Proved] | None]:
    """Each mechanism's own method and its drawn position by both roads; None where it is to be planned by itself."""
    return _together(mechanisms, _proved)


def planned_together(mechanisms: Sequence[Mechanism]) -> list[Method | None]:
    """Each mechanism's own method; None where it is to be planned by itself."""
    return _together(mechanisms, _planned)


def _together(mechanisms: Sequence[Mechanism], work: _Work[_Done]) -> list[_Done | None]:
    found: list[_Done | None] = [None] * len(mechanisms)
    for rows in _alike(mechanisms):
        some = [mechanisms[row] for row in rows]
        if len(some) < FEWEST or (method := _method(some)) is None:
            continue
        for own, part in _parts(method, some):
            for k, one in zip(part, work(own, [some[k] for k in part]), strict=True):
                found[rows[k]] = one
    return found


def _alike(mechanisms: Sequence[Mechanism]) -> Iterable[list[int]]:
    """The numbers of mechanisms that one method may draw."""
    groups: dict[Hashable, list[int]] = {}
    for row, mechanism in enumerate(mechanisms):
        groups.setdefault(_kind(mechanism), []).append(row)
    return groups.values()


def _kind(mechanism: Mechanism) -> Hashable:
    """All that decides which steps draw a mechanism, but the points that happen to lie in one place."""
    own, even = topology(mechanism), tuple(driver.acceleration == 0 for driver in mechanism.drivers)
    return own if mechanism.slides == mechanism.pairs else (own, topology(lower_pairs(mechanism))), even


def _method(mechanisms: Sequence[Mechanism]) -> Method | None:
    """The method of a kind of mechanisms; None where none of a few can be planned."""
    kind = _kind(mechanisms[0])
    if (method := _METHODS.pop(kind, None)) is None:
        for mechanism in mechanisms[:FEWEST]:
            try:
                method = plan(mechanism)
                break
            except GraphkinError:
                continue
    if method is None:
        return None
    _METHODS[kind] = method
    for oldest in [*_METHODS][:-MOST]:
        _METHODS.pop(oldest, None)
    return method


def _parts(method: Method, mechanisms: Sequence[Mechanism]) -> list[tuple[Method | None, list[int]]]:
    """The numbers of mechanisms that one method draws together; without a method each is planned by itself."""
    return [*_by_special_points(method, mechanisms)] if goes_together(method) else [(None, [*range(len(mechanisms))])]


def _by_special_points(method: Method, mechanisms: Sequence[Mechanism]) -> list[tuple[Method | None, list[int]]]:
    """The mechanisms, by their numbers, that go by one method: special points are where they lie well in each."""
    if not any(isinstance(stage, Group) for stage in method.stages):
        return [(method, [*range(len(mechanisms))])]
    if (drawn := at_once(method, mechanisms)) is None:
        return [(None, [*range(len(mechanisms))])]
    found = [(method, list[int]())]
    for row in map(int, np.flatnonzero(drawn.sure)):
        own = drawn.method(method, row, mechanisms[row])
        plot = drawn.drawing(own, row)
        points = special_points(own.structure, own.stages, plot)
        like = next((part for other, part in found if other.ternaries == points), None)
        if like is None:
            found.append((with_other_points(own, plot), like := []))
        like.append(row)
    return [(own, part) for own, part in found if part]


def _proved(method: Method | None, mechanisms: Sequence[Mechanism]) -> Iterable[tuple[Method, Proved] | None]:
    """Of each what both roads give, where both are sure and agree; without a `method` each is planned by itself."""
    if (exact := motions(mechanisms)) is None:
        return [None] * len(mechanisms)
    if method is None:
        return (_planned_alone(one, exact, row) for row, one in enumerate(mechanisms))
    return _both(method, mechanisms, exact)


def _planned_alone(mechanism: Mechanism, exact: Many, row: int) -> tuple[Method, Proved] | None:
    """A mechanism planned by itself, against an analysis of many."""
    if not exact.sure[row]:
        return None
    try:
        method = plan(mechanism)
        plot = replay_all(method)
    except GraphkinError:
        return None
    own = exact.of(row, mechanism)
    worst = compare(method, plot, own)
    return (method, Proved(plot, own, worst)) if worst < AGREE and not method.doubtful else None


def _both(
    method: Method, mechanisms: Sequence[Mechanism], exact: Many
) -> Iterable[tuple[Method, Proved] | None]:
    if (drawn := at_once(method, mechanisms)) is None:
        return (_planned_alone(one, exact, row) for row, one in enumerate(mechanisms))
    return _compared(method, mechanisms, drawn, exact)


def _compared(
    method: Method, mechanisms: Sequence[Mechanism], drawn: AtOnce, exact: Many
) -> Iterable[tuple[Method, Proved] | None]:
    worst = apart_each(method.mechanism, readings(method, drawn.plot), exact.motion)
    for row, mechanism in enumerate(mechanisms):
        if drawn.sure[row] and exact.sure[row] and worst[row] < AGREE:
            own = drawn.method(method, row, mechanism)
            yield own, Proved(drawn.drawing(own, row), exact.of(row, mechanism), float(worst[row]))
        else:
            yield None


def _planned(method: Method | None, mechanisms: Sequence[Mechanism]) -> Iterable[Method | None]:
    """Of each the method, where its assembly is sure."""
    drawn = None if method is None else at_once(method, mechanisms)
    if method is None or drawn is None:
        yield from [None] * len(mechanisms)
        return
    for row, mechanism in enumerate(mechanisms):
        yield drawn.method(method, row, mechanism) if drawn.sure[row] else None
