"""The keys that are names themselves: fixed points of `[frame]`, lengths and angles of `[links.X]`."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from graphkin.errors import NOWHERE, AngleRange, BadName, DuplicateName, GraphkinError, KeyClash, UnknownKey, Where
from graphkin.files.curves import AngleMeasure, Length, Measure
from graphkin.files.names import POINT, split_points, tidy
from graphkin.files.values import above_zero, quantity, shown

OWN_KEYS = ("points", "ccw", "shape")
"""The keys of a link that are not measures."""

Placing = Callable[..., Where]


def frame_problems(frame: object, where: Placing) -> Iterator[GraphkinError]:
    """Keys of `[frame]` that are no points."""
    if not isinstance(frame, dict):
        return
    yield from _same_but_for_primes(frame, where, "frame")
    for key in frame:
        if key != "name" and POINT.fullmatch(tidy(key)) is None:
            yield BadName(where("frame", key), "point", key)


def read_measures(links: object, where: Placing) -> tuple[dict[str, list[Measure]], list[GraphkinError]]:
    """The measures of each link in SI, and what is wrong with others."""
    measures: dict[str, list[Measure]] = {}
    problems: list[GraphkinError] = []
    if not isinstance(links, dict):
        return measures, problems
    problems.extend(_same_but_for_primes(links, where, "links"))
    for link, table in links.items():
        found = measures.setdefault(tidy(link), [])
        seen: dict[object, str] = {}
        for key in (key for key in table if key not in OWN_KEYS) if isinstance(table, dict) else ():
            try:
                measure = _measure(key, table[key])
                _refuse_twice(measure, seen)
            except GraphkinError as problem:
                problems.append(problem.at(where("links", link, key)))
            else:
                found.append(measure)
    return measures, problems


def link_points(table: Mapping[str, Any]) -> tuple[str, ...]:
    """The points a link's keys name, in the order of the file; `ccw` names none."""
    found: dict[str, None] = {}
    for key, value in table.items():
        names = value if key in ("points", "shape") else split_points(tidy(key))
        found.update(dict.fromkeys(tidy(name) for name in names if key != "ccw"))
    return tuple(found)


def _measure(key: str, value: object) -> Measure:
    """`AB = 24` or `BDE = 90`; raises without a place."""
    match split_points(tidy(key)):
        case (a, b) if a != b:
            return Length(key, (a, b), above_zero(quantity(value, "length")))
        case (a, b, c) if len({a, b, c}) == 3:
            angle = quantity(value, "angle")
            if not 0 <= angle <= math.pi:
                raise AngleRange(NOWHERE, math.degrees(angle))
            return AngleMeasure(key, (a, b, c), angle)
    if key[:1].islower():
        raise UnknownKey(NOWHERE, shown(key), (*OWN_KEYS, "AB", "BDE"))
    raise BadName(NOWHERE, "measure", shown(key))


def _refuse_twice(measure: Measure, seen: dict[object, str]) -> None:
    """`AB` and `BA` are the same length."""
    same = min(measure.points, measure.points[::-1])
    if (first := seen.setdefault(same, measure.key)) != measure.key:
        raise KeyClash(NOWHERE, first, measure.key)


def _same_but_for_primes(table: Mapping[str, Any], where: Placing, above: str) -> Iterator[GraphkinError]:
    """Keys that read the same once their primes are tidied."""
    seen: set[str] = set()
    for key in table:
        if tidy(key) in seen:
            yield DuplicateName(where(above, key), tidy(key))
        seen.add(tidy(key))
