"""Which parts of a mechanism can be solved together: as many unknowns as equations, and as few parts as can be."""

from __future__ import annotations

from itertools import combinations

_FEW = 8
"""Loops and contacts of which every set is looked at for a group."""


def fewest_closed(names: list[frozenset[str]], equations: list[int]) -> tuple[int, ...] | None:
    """The fewest parts that together have as many unknowns as equations; the first of those in order.

    Each equation takes an unknown for itself (a matching). A part then needs the parts that have taken its other
    unknowns, they need others, and so on; where an unknown is left that nobody took, no such set holds the part.
    """
    if len(names) <= _FEW:
        return next(
            (chosen for count in range(1, len(names) + 1) for chosen in combinations(range(len(names)), count)
             if len(frozenset[str]().union(*(names[k] for k in chosen))) == sum(equations[k] for k in chosen)), None,
        )  # fmt: skip
    takers: dict[str, int] = {}
    kept = [k for k in range(len(names)) if _take(k, names, equations[k], takers)]
    most = 1
    while most < 2 * len(kept):  # sets of a few first: what a part needs may go on through the whole mechanism
        sets = [chosen for k in kept if (chosen := _needed(k, names, takers, most))]
        if sets:
            return min(sets, key=lambda chosen: (len(chosen), chosen))
        most *= 2
    return None


def _take(part: int, names: list[frozenset[str]], count: int, takers: dict[str, int]) -> bool:
    """Give a part so many unknowns, others changing theirs where they can; nothing if there are not enough."""
    for _ in range(count):
        if not _one_more(part, names, takers):
            for name in names[part]:
                if takers.get(name) == part:
                    del takers[name]
            return False
    return True


def _one_more(part: int, names: list[frozenset[str]], takers: dict[str, int]) -> bool:
    """Give a part an unknown that is free; or one that another has, which takes a further one, and so on."""
    for name in names[part]:
        if name not in takers:
            takers[name] = part
            return True
    asked: dict[str, int] = {}
    """Who would like to have each unknown."""
    gives: dict[int, str] = {part: ""}
    """The unknown that each part is asked for."""
    for one in (waiting := [part]):
        for name in names[one]:
            if name in asked:
                continue
            asked[name] = one
            if name not in takers:
                _hand_on(name, asked, gives, takers)
                return True
            if takers[name] not in gives:
                gives[takers[name]] = name
                waiting.append(takers[name])
    return False


def _hand_on(name: str, asked: dict[str, int], gives: dict[int, str], takers: dict[str, int]) -> None:
    """Who asks for a free unknown takes it, and gives its own to the one that asks for that."""
    while name:
        takers[name] = asked[name]
        name = gives[asked[name]]


def _needed(part: int, names: list[frozenset[str]], takers: dict[str, int], most: int) -> tuple[int, ...]:
    """The parts without which this one leaves an unknown open, itself among them; none if one remains open, or if they
    are more than so many."""
    found, waiting = {part}, [part]
    for one in waiting:
        for name in names[one]:
            if name not in takers:
                return ()
            if takers[name] not in found:
                if len(found) == most:
                    return ()
                found.add(takers[name])
                waiting.append(takers[name])
    return tuple(sorted(found))
