"""`[frame]` and `[links.X]`: the rigid bodies and where their points are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from graphkin.base.value import Lazy
from graphkin.errors import FrameNameTaken, MissingKey, NoPoints, ShapeAndMeasures, TooFewMeasures
from graphkin.files.curves import Measure
from graphkin.files.draft import Draft
from graphkin.files.measures import link_points
from graphkin.files.names import tidy
from graphkin.files.schema import File, LinkTable
from graphkin.files.shapes import ShapeMeasures, check_round, own_axes, solve_shape
from graphkin.model.mechanism import FRAME, Link


def read_links(draft: Draft, file: File, raw: Mapping[str, Any], measures: Mapping[str, Sequence[Measure]]) -> None:
    """Put the frame and all links into the draft. `raw` is the file's own data: it keeps the order of the keys."""
    if not file.links:
        draft.problems.append(MissingKey(draft.where("links"), "[links.NAME]"))
    draft.frame = file.frame.name
    draft.frame_points = {tidy(point): complex(*place) for point, place in file.frame.points.items()}
    draft.links[FRAME] = Link(FRAME, draft.frame_points)
    tables = {tidy(name): table for name, table in raw["links"].items()}
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
        raise FrameNameTaken(draft.where("links", name), name)
    if not points:
        raise NoPoints(draft.where("links", name), name)
    given = _measures(draft, name, table, points, measures)
    if table.shape is None:
        return solve_shape(given)
    if measures:
        raise ShapeAndMeasures(draft.where("links", name, measures[0].key), name, measures[0].key)
    places = {tidy(point): complex(*place) for point, place in table.shape.items()}
    if missing := tuple(point for point in points if point not in places):
        raise TooFewMeasures(given.where, name, missing)
    check_round(given, places)
    return own_axes(places, given)


def _measures(
    draft: Draft, name: str, table: LinkTable, points: tuple[str, ...], measures: Sequence[Measure]
) -> ShapeMeasures:
    """All that is known of the shape, each with its place."""
    ccw = table.ccw or []
    places: dict[str, tuple[str | int, ...]] = {"": ("links", name)}
    places |= {measure.key: ("links", name, measure.key) for measure in measures}
    for number, triple in enumerate(ccw):
        place = ("links", name, "ccw", number)
        places[f"ccw {number}"] = place[: 3 if len(ccw) == 1 else 4]
        for point in triple:
            draft.point(name, point, *place[:3])
    triples = tuple((a, b, c) for a, b, c in ccw)
    return ShapeMeasures(name, points, tuple(measures), triples, Lazy(places, lambda key: draft.where(*places[key])))
