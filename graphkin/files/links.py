"""`[frame]` and `[links.X]`: fixed points, lengths and angles by keys that are names, and where a link's points are."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence

from graphkin import errors
from graphkin.base.value import Lazy
from graphkin.errors import NOWHERE, GraphkinError, Where
from graphkin.files.draft import Draft
from graphkin.files.schema import File, LinkTable
from graphkin.files.shapes import AngleMeasure, Length, Measure, ShapeMeasures, check_round, own_axes, solve_shape
from graphkin.files.toml import Document
from graphkin.files.values import POINT, above_zero, shown_value, si_quantity, split_points, tidy
from graphkin.model.mechanism import FRAME, KeyPath, Link, Mechanism

OWN_KEYS = ("points", "ccw", "shape")  # the keys of a link that are not measures

Placing = Callable[..., Where]


def frame_problems(frame: object, where: Placing) -> Iterator[GraphkinError]:
    """Keys of `[frame]` that are no points."""
    if not isinstance(frame, dict):
        return
    yield from _same_but_for_primes(frame, where, "frame")
    for key in frame:
        if key != "name" and POINT.fullmatch(tidy(key)) is None:
            yield errors.BadName(where("frame", key), "point", key)


def read_measures(links: object, where: Placing) -> tuple[dict[str, list[Measure]], list[GraphkinError]]:
    """The measures of each link in SI, and what is wrong with others."""
    measures: dict[str, list[Measure]] = {}
    problems: list[GraphkinError] = []
    if not isinstance(links, dict):
        return measures, problems
    problems.extend(_same_but_for_primes(links, where, "links"))
    for link, table in links.items():
        of_link = measures.setdefault(tidy(link), [])
        keys_by_points: dict[object, str] = {}
        for key in (key for key in table if key not in OWN_KEYS) if isinstance(table, dict) else ():
            try:
                measure = _measure(key, table[key])
                same = min(measure.points, measure.points[::-1])  # `AB` and `BA` are the same length
                if (first := keys_by_points.setdefault(same, measure.key)) != measure.key:
                    raise errors.KeyClash(NOWHERE, first, measure.key)
            except GraphkinError as problem:
                problems.append(problem.at(where("links", link, key)))
            else:
                of_link.append(measure)
    return measures, problems


def stated_measures(mechanism: Mechanism, link: str) -> dict[KeyPath, Measure]:
    """The lengths and angles by which its file gives a link, by place; none of one whose shape is another by now."""
    table = {place: given for place, given in mechanism.given.items() if place[:2] == ("links", link)}
    stated: dict[KeyPath, Measure] = {}
    for place, given in table.items():
        if len(place) == 3 and given.si is not None:
            stated[place] = _measure(str(place[2]), given.written)
    noise, points = mechanism.usual.least("m"), mechanism.links[link].points
    return stated if all(abs(measure.miss(points)) <= noise for measure in stated.values()) else {}


def link_points(table: Mapping[str, object]) -> tuple[str, ...]:
    """The points a link's keys name, in the order of the file; `ccw` names none."""
    points: dict[str, None] = {}
    for key, value in table.items():
        if key in ("points", "shape") and isinstance(value, list | dict):
            points.update(dict.fromkeys(tidy(str(name)) for name in value))
        elif key != "ccw":
            points.update(dict.fromkeys(split_points(tidy(key))))
    return tuple(points)


def _measure(key: str, value: object) -> Measure:
    """`AB = 24` or `BDE = 90`; raises without a place."""
    match split_points(tidy(key)):
        case (a, b) if a != b:
            return Length(key, (a, b), above_zero(si_quantity(value, "length")))
        case (a, b, c) if len({a, b, c}) == 3:
            angle = si_quantity(value, "angle")
            if not 0 <= angle <= math.pi:
                raise errors.AngleRange(NOWHERE, math.degrees(angle))
            return AngleMeasure(key, (a, b, c), angle)
    if key[:1].islower():
        raise errors.UnknownKey(NOWHERE, shown_value(key), (*OWN_KEYS, "AB", "BDE"))
    raise errors.BadName(NOWHERE, "measure", shown_value(key))


def _same_but_for_primes(table: Mapping[str, object], where: Placing, above: str) -> Iterator[GraphkinError]:
    """Keys that read the same once their primes are tidied."""
    names: set[str] = set()
    for key in table:
        if tidy(key) in names:
            yield errors.DuplicateName(where(above, key), tidy(key))
        names.add(tidy(key))


def read_links(draft: Draft, file: File, raw: Document, measures: Mapping[str, Sequence[Measure]]) -> None:
    """Put the frame and all links into the draft. `raw` is the file's own data: it keeps the order of the keys."""
    if not file.links:
        draft.problems.append(errors.MissingKey(draft.where("links"), "[links.NAME]"))
    draft.frame = file.frame.name
    draft.frame_points = {tidy(point): complex(*place) for point, place in file.frame.points.items()}
    draft.links[FRAME] = Link(FRAME, draft.frame_points)
    tables: dict[str, Mapping[str, object]] = {tidy(name): table for name, table in raw["links"].items()}
    for name in file.links:
        points = link_points(tables[name])
        draft.links[name] = Link(name, {point: complex(n, n * n) for n, point in enumerate(points)})
    for name, table in file.links.items():
        with draft.noting():
            shape = _shape(draft, name, table, tuple(draft.links[name].points), measures[name])
            draft.links[name] = Link(name, shape)


def _shape(
    draft: Draft, name: str, table: LinkTable, points: tuple[str, ...], measures: Sequence[Measure]
) -> dict[str, complex]:
    """The link's points in its own axes."""
    if name in (FRAME, draft.frame):
        raise errors.FrameNameTaken(draft.where("links", name), name)
    if not points:
        raise errors.NoPoints(draft.where("links", name), name)
    # all that is known of the shape, each with its place
    ccw = table.ccw or []
    paths: dict[str, KeyPath] = {"": ("links", name)}
    paths |= {measure.key: ("links", name, measure.key) for measure in measures}
    for number, triple in enumerate(ccw):
        path = ("links", name, "ccw", number)
        paths[f"ccw {number}"] = path[: 3 if len(ccw) == 1 else 4]
        for point in triple:
            draft.point(name, point, *path[:3])
    triples = tuple((a, b, c) for a, b, c in ccw)
    shape = ShapeMeasures(name, points, tuple(measures), triples, Lazy(paths, lambda key: draft.where(*paths[key])))
    if table.shape is None:
        return solve_shape(shape)
    if measures:
        raise errors.ShapeAndMeasures(draft.where("links", name, measures[0].key), name, measures[0].key)
    places = {tidy(point): complex(*place) for point, place in table.shape.items()}
    if missing := tuple(point for point in points if point not in places):
        raise errors.TooFewMeasures(shape.where, name, missing)
    check_round(shape, places)
    return own_axes(places, shape)
