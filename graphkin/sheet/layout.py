"""Which paper, where the three figures stand on it, and at which scales.

A figure is as large as its points at the scale, plus what its signs and letters reach beyond them (`Extent.reach`).
Ways to divide the paper are tried; the one with the largest figures is taken.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from graphkin.errors import NOWHERE
from graphkin.sheet.labels import Room
from graphkin.sheet.paper import PAPERS, Paper
from graphkin.sheet.scales import KEYS, UNITS, TooLargeForPaper, UnknownPaper, finer, finest
from graphkin.steps import Plane

__all__ = ["HEAD", "Extent", "Layout", "lay_out", "papers_for"]

HEAD = 7.5
"""Height of a figure's heading [mm]."""
HEAD_WIDTH = 76.0
"""Width of a heading with its scale [mm]."""
_MECHANISM = 1.3
"""How much more the mechanism counts: its signs keep their size and need room between them."""
_IN_ORDER = 0.12
"""What it is worth that the figures follow one another as they are drawn."""


@dataclass(frozen=True, slots=True)
class Extent:
    """How large a figure is: its points in SI units, and what signs and labels reach beyond them [mm].

    left, top, right, bottom  the reaches; given  its scale where the file gives one
    labels  how much is lettered in it
    """

    size: complex
    left: float
    top: float
    right: float
    bottom: float
    given: float | None = None
    labels: int = 10

    @property
    def reach(self) -> complex:
        return complex(self.left + self.right, self.top + self.bottom)

    def scale_in(self, room: complex) -> float | None:
        """The scale at which it fits a room [mm]; None where it does not fit."""
        inner = room - self.reach
        if inner.real <= 5 or inner.imag <= 5 or room.real < HEAD_WIDTH:
            return None
        if self.given is None:
            return finest(self.size, inner)
        whole = self.size / self.given
        return self.given if whole.real <= inner.real and whole.imag <= inner.imag else None


@dataclass(frozen=True, slots=True)
class Layout:
    """A paper divided: a room and a scale for each plane, and the strip for tables and title."""

    paper: Paper
    rooms: Mapping[Plane, Room]
    scales: Mapping[Plane, float]
    strip: Room


def papers_for(name: str | None) -> list[Paper]:
    """The paper asked for, or all."""
    if name is not None and name not in PAPERS:
        raise UnknownPaper(name, ", ".join(PAPERS))
    return [PAPERS[name]] if name is not None else list(PAPERS.values())


def lay_out(extents: Mapping[Plane, Extent], strip_height: Mapping[str, float], candidates: Sequence[Paper]) -> Layout:
    """The smallest of the papers that holds all.

    strip_height  what the tables and the title need on each paper [mm]
    Raises TooLargeForPaper where a given scale is too fine for every paper.
    """
    for size in dict.fromkeys(p.width * p.height for p in candidates):
        best = _best([p for p in candidates if p.width * p.height == size], extents, strip_height)
        if best is not None:
            return best
    raise _too_large(extents, strip_height, candidates)


def _best(papers: Sequence[Paper], extents: Mapping[Plane, Extent], strip_height: Mapping[str, float]) -> Layout | None:
    best: tuple[float, Layout] | None = None
    for paper in papers:
        inner = Room(paper.margin, paper.margin, paper.width - paper.margin, paper.height - paper.margin)
        strip = Room(inner.left, inner.bottom - strip_height[paper.name], inner.right, inner.bottom)
        field = Room(inner.left, inner.top, inner.right, strip.top)
        for rooms in _divisions(field, tuple(extents)):
            scales = {plane: _scale(extents[plane], rooms[plane]) for plane in extents}
            fitting = {plane: scale for plane, scale in scales.items() if scale is not None}
            if len(fitting) < len(extents):
                continue
            score = _score(extents, fitting, rooms)
            if best is None or score > best[0] + 1e-9:
                best = score, Layout(paper, rooms, fitting, strip)
    return best[1] if best is not None else None


def _scale(extent: Extent, room: Room) -> float | None:
    return extent.scale_in(complex(room.right - room.left, room.bottom - room.top - HEAD))


def _score(extents: Mapping[Plane, Extent], scales: Mapping[Plane, float], rooms: Mapping[Plane, Room]) -> float:
    """Large figures count, and a little that none is squeezed into its room."""
    total = 0.0
    for plane, extent in extents.items():
        room = rooms[plane]
        whole = extent.size / scales[plane]
        total += _worth(plane, max(whole.real, whole.imag), extent.labels)
        spare_x = room.right - room.left - whole.real - extent.reach.real
        spare_y = room.bottom - room.top - HEAD - whole.imag - extent.reach.imag
        total += 0.15 * math.log(1 + min(spare_x, spare_y))
    corners = [(rooms[plane].top + 0.3 * rooms[plane].left) for plane in extents]
    return total + (_IN_ORDER if corners == sorted(corners) else 0.0)


def _worth(plane: Plane, large: float, labels: int) -> float:
    """What the size of a figure is worth: it grows slowly once its letters have room, then not at all."""
    if large <= 0:
        return 0.0
    easy = 90.0 if plane == "position" else 30.0 + 2.2 * labels
    weight = math.sqrt(labels / 10) * (_MECHANISM if plane == "position" else 1)
    more = max(1.0, min(large, 1.8 * easy) / easy)
    return weight * (math.log(max(1.0, min(large, easy))) + 0.4 * math.log(more))


def _too_large(
    extents: Mapping[Plane, Extent], strip_height: Mapping[str, float], papers: Sequence[Paper]
) -> TooLargeForPaper:
    """The given scale that does not fit, and the finest one that would."""
    given = [plane for plane, extent in extents.items() if extent.given is not None]
    area = max(paper.width * paper.height for paper in papers)
    large = [paper for paper in papers if paper.width * paper.height == area]
    for freed in (*([plane] for plane in given), given):
        loose = {plane: replace(e, given=None) if plane in freed else e for plane, e in extents.items()}
        found = _best(large, loose, strip_height)
        if found is not None:
            plane = freed[0]
            scale, fits = extents[plane].given, found.scales[plane]
            while _best(large, loose | {plane: replace(loose[plane], given=finer(fits))}, strip_height):
                fits = finer(fits)
            assert scale is not None
            return TooLargeForPaper(NOWHERE, KEYS[plane], scale, fits, large[0].name[:2], UNITS[plane])
    raise AssertionError("free scales fit every paper")


# --- ways to divide a field -------------------------------------------------------------------

_SHARES = tuple(k / 32 for k in range(8, 25))


def _divisions(field: Room, planes: tuple[Plane, ...]) -> Iterator[dict[Plane, Room]]:
    """Rooms for one, two or three figures."""
    if len(planes) == 1:
        yield {planes[0]: field}
    elif len(planes) == 2:
        for share in _SHARES:
            for across in (True, False):
                first, second = _cut(field, share, across)
                yield {planes[0]: first, planes[1]: second}
    else:
        for share, other in _pairs():
            for across in (True, False):
                for alone in planes if not across else (planes[0], planes[2]):
                    yield _three(field, planes, alone, share, other, across)


@cache
def _pairs() -> tuple[tuple[float, float], ...]:
    return tuple((a, b) for a in _SHARES for b in _SHARES)


def _three(
    field: Room, planes: tuple[Plane, ...], alone: Plane, share: float, other: float, across: bool
) -> dict[Plane, Room]:
    """One figure has a whole row (or column, `across`), the other two share the rest."""
    big, rest = _cut(field, share, across)
    if alone != planes[0]:
        rest, big = _cut(field, 1 - share, across)
    left = [plane for plane in planes if plane != alone]
    one, two = _cut(rest, other, not across)
    return {alone: big, left[0]: one, left[1]: two}


def _cut(room: Room, share: float, across: bool) -> tuple[Room, Room]:
    """Two parts beside each other (`across`) or one above the other."""
    if across:
        x = room.left + share * (room.right - room.left)
        return Room(room.left, room.top, x, room.bottom), Room(x, room.top, room.right, room.bottom)
    y = room.top + share * (room.bottom - room.top)
    return Room(room.left, room.top, room.right, y), Room(room.left, y, room.right, room.bottom)
