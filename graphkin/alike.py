"""Mechanisms of one topology, proved together: one method draws them all, and the analysis solves them all, as arrays.

Methods are kept by topology, so that whoever solves mechanisms in batches plans each topology once. What arrays do not
settle beyond doubt (see `running.variants`, `analytic.variants`), and what has no like, is left to the caller.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from typing import TypeVar

from graphkin.agreement import AGREE, Proved, apart_each
from graphkin.analytic.variants import motions
from graphkin.errors import GraphkinError
from graphkin.mechanism import Mechanism
from graphkin.planning import Method, plan
from graphkin.planning.equivalent import lower_pairs
from graphkin.readings import readings
from graphkin.running.variants import at_once, goes_together
from graphkin.stacking import topology

__all__ = ["planned_together", "proved_together"]

FEWEST = 3
"""Mechanisms of one topology from which arrays are quicker."""
MOST = 64
"""Topologies whose methods are kept."""
_METHODS: dict[Hashable, Method] = {}
_Done = TypeVar("_Done")
_Work = Callable[[Method, Sequence[Mechanism]], Iterable[_Done | None]]


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
        if len(some) >= FEWEST and (method := _method(some)) is not None:
            for row, one in zip(rows, work(method, some), strict=True):
                found[row] = one
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
    """The method of a kind of mechanisms; None where arrays cannot draw them, or none of a few can be planned."""
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
    return method if goes_together(method) else None


def _proved(method: Method, mechanisms: Sequence[Mechanism]) -> Iterable[tuple[Method, Proved] | None]:
    """Of each what both roads give, where both are sure and agree."""
    drawn, exact = at_once(method, mechanisms), motions(mechanisms)
    worst = apart_each(method.mechanism, readings(method, drawn.plot), exact.motion)
    for row, mechanism in enumerate(mechanisms):
        if drawn.sure[row] and exact.sure[row] and worst[row] < AGREE:
            own = drawn.method(method, row, mechanism)
            yield own, Proved(drawn.drawing(own, row), exact.of(row, mechanism), float(worst[row]))
        else:
            yield None


def _planned(method: Method, mechanisms: Sequence[Mechanism]) -> Iterable[Method | None]:
    """Of each the method, where its assembly is sure."""
    drawn = at_once(method, mechanisms)
    for row, mechanism in enumerate(mechanisms):
        yield drawn.method(method, row, mechanism) if drawn.sure[row] else None
