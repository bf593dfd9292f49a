"""A straight line of a link: the path of a slide, the track of a wheel, the flat face of a cam follower."""

from __future__ import annotations

import cmath
from collections.abc import Sequence

from graphkin.errors import KeyClash, MissingKey, NeedsDirection, NoLine, NoMeaning, UnknownPoint
from graphkin.files.draft import Draft
from graphkin.files.positions import Path
from graphkin.files.schema import LineTable
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Line


def has_line(table: LineTable) -> bool:
    """Whether any key of a line is there."""
    return any(value is not None for value in (table.through, table.toward, table.from_, table.angle))


def read_line(draft: Draft, table: LineTable, link: str, own_point: str, path: Path) -> Line:
    """The line of `link`; one of the frame given by coordinates goes through a new point called `own_point`."""
    if link != FRAME and len(draft.links[link].points) == 1:
        return _own_line(draft, table, link, path)
    origin = _origin(draft, table, link, own_point, path)
    base = (origin, table.toward) if table.toward is not None else table.from_
    return Line(link, origin, _direction(draft, table, link, origin, path), origin not in draft.starts, base)


def _own_line(draft: Draft, table: LineTable, link: str, path: Path) -> Line:
    """A link of one point is its own line; one that slides, and so cannot turn against its guide, may have another."""
    (point,) = draft.links[link].points
    if table.toward is not None:
        raise NoMeaning(draft.where(*path, "toward"), "toward", "own line")
    if table.through is not None:
        _point_of(draft, link, table.through, path)
    if table.from_ is None and table.angle is None:
        return Line(link, point, 1 + 0j)
    guide, way = _slid_along(draft, link)
    if guide is None:
        for key, value in (("from", table.from_), ("angle", table.angle)):
            if value:
                raise NoMeaning(draft.where(*path, key), key, "own line")
        return Line(link, point, 1 + 0j)
    return Line(link, point, _unit(table.angle or 0.0) * _base(draft, table, guide, path) / way, base=table.from_)


def _slid_along(draft: Draft, link: str) -> tuple[str | None, complex]:
    """The guide of a link of one point, and the way it slides in the guide's axes: that is the link's own axis."""
    found = next(((k, slide) for k, slide in enumerate(draft.slides) if slide.block == link), None)
    if found is None or found[1].guide in (link, *draft.tracing):
        return None, 1 + 0j
    number, slide = found
    draft.tracing.append(link)
    try:
        guide = draft.link(slide.guide, "slide", number, "guide")
        return guide, read_line(draft, slide, guide, f"s{number}", ("slide", number)).direction
    finally:
        draft.tracing.pop()


def _base(draft: Draft, table: LineTable, guide: str, path: Path) -> complex:
    """The direction from which the angle of such a line is measured, in the guide's axes: `from`, else +x."""
    if table.from_ is not None:
        tail, head = (draft.point(guide, point, *path, "from") for point in table.from_)
        return _arm(draft, guide, tail, head, (*path, "from"))
    if guide == FRAME:
        return 1 + 0j
    beyond, way = _slid_along(draft, guide) if len(draft.links[guide].points) == 1 else (None, 1 + 0j)
    if beyond is None:
        raise NeedsDirection(draft.where(*path), guide)
    return _base(draft, table, beyond, path) / way


def _origin(draft: Draft, table: LineTable, link: str, own_point: str, path: Path) -> str:
    """The point the line goes through."""
    if table.through is None:
        raise MissingKey(draft.where(*path), "through")
    if link != FRAME or isinstance(table.through, str):
        return _point_of(draft, link, table.through, path)
    draft.frame_points[own_point], draft.starts[own_point] = complex(*table.through), path
    return own_point


def _point_of(draft: Draft, link: str, through: str | Sequence[float], path: Path) -> str:
    if isinstance(through, str):
        return draft.point(link, through, *path, "through")
    raise UnknownPoint(draft.where(*path, "through"), "[x, y]", draft.named(link))


def _direction(draft: Draft, table: LineTable, link: str, origin: str, path: Path) -> complex:
    """Unit vector in the link's axes."""
    if table.toward is not None:
        for key, value in (("from", table.from_), ("angle", table.angle)):
            if value is not None:
                raise KeyClash(draft.where(*path, key), "toward", key)
        return _arm(draft, link, origin, draft.point(link, table.toward, *path, "toward"), (*path, "toward"))
    turn = _unit(table.angle or 0.0)
    if table.from_ is not None:
        tail, head = (draft.point(link, point, *path, "from") for point in table.from_)
        return _arm(draft, link, tail, head, (*path, "from")) * turn
    if link != FRAME:
        raise NeedsDirection(draft.where(*path), link)
    return turn


def _arm(draft: Draft, link: str, tail: str, head: str, path: Path) -> complex:
    arm = draft.links[link].arm(tail, head)
    if abs(arm) < 1e-12:
        raise NoLine(draft.where(*path), tail, head)
    return arm / abs(arm)


def _unit(angle: float) -> complex:
    """Along an angle; quarter turns exactly."""
    turn = cmath.rect(1, angle)
    return complex(*(0.0 if abs(part) < 1e-15 else part for part in (turn.real, turn.imag)))
