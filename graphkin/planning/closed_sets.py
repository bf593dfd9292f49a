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
    sets = (_needed(k, names, takers) for k in kept)
    return min((chosen for chosen in sets if chosen), key=lambda chosen: (len(chosen), chosen), default=None)


def _take(part: int, names: list[frozenset[str]], count: int, takers: dict[str, int]) -> bool:
    """Give a part so many unknowns, others changing theirs where they can; nothing if there are not enough."""
    before = dict(takers)
    for _ in range(count):
        if not _one_more(part, names, takers, set()):
            takers.clear()
            takers.update(before)
            return False
    return True


def _one_more(part: int, names: list[frozenset[str]], takers: dict[str, int], seen: set[str]) -> bool:
    for name in sorted(names[part] - seen):
        if takers.get(name) == part or name in seen:
            continue
        seen.add(name)
        if name not in takers or _one_more(takers[name], names, takers, seen):
            takers[name] = part
            return True
    return False


def _needed(part: int, names: list[frozenset[str]], takers: dict[str, int]) -> tuple[int, ...]:
    """The parts without which this one leaves an unknown open, itself among them; none if one remains open."""
    found, waiting = {part}, [part]
    for one in waiting:
        for name in names[one]:
            if name not in takers:
                return ()
            if takers[name] not in found:
                found.add(takers[name])
                waiting.append(takers[name])
    return tuple(sorted(found))
