"""Which paper, where the three figures stand on it, and at which scales.

A figure is as large as its points at the scale, plus what its signs and letters reach beyond them (`Extent.reach`).
Ways to divide the paper are tried, all shares at once (a `Room`'s sides are arrays then); the one with the
largest figures is taken.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import accumulate, pairwise
from typing import Any

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import NOWHERE
from graphkin.sheet.page import HEAD_WIDTH
from graphkin.sheet.paper import KEYS, LARGE, PAPERS, UNITS, USUAL, Paper, Room, TooLargeForPaper, UnknownPaper, finer
from graphkin.sheet.window import Extent, Over, Window, height_over

HEAD = 7.5
"""Height of a figure's heading [mm]."""
HEAD_LEFT = 3.0
"""From the side of a room to its heading [mm]."""
_SECOND = 5.5
"""How much higher it is where the scale stands under it, in a narrow room [mm]."""
_NARROWEST = 46.0
"""A heading wants at least so much [mm]."""
_MECHANISM = 1.3
"""How much more the mechanism counts: its signs keep their size and need room between them."""
_INK = 2.0
"""What it is worth that the paper is used."""
_LARGE_ENOUGH = 130.0
"""A figure of this size alone on its paper needs no larger one [mm]."""


Height = Callable[[Paper], float]
"""What the tables and the title need on a paper [mm]."""
Divisions = Callable[[Room, tuple[Plane, ...]], Iterator[dict[Plane, Room]]]
"""Ways to divide a field, each with all its shares."""


@frozen
class Layout:
    """A paper divided: a room and a scale for each plane, and the strip for tables and title.

    headed  the planes over whose figures there is room for their equations
    """

    paper: Paper
    rooms: Mapping[Plane, Room]
    scales: Mapping[Plane, float]
    strip: Room
    headed: tuple[Plane, ...] = ()

    def window(self, plane: Plane, extent: Extent) -> Window:
        """The figure with all its signs in the middle of its room, under its heading."""
        return extent.window(under_heading(self.rooms[plane], extent.over), self.scales[plane])


def under_heading(room: Room, over: Over | None = None) -> Room:
    """What the heading, and what stands under that over the figure, leave of a room, or of many."""
    wide = room.right - room.left
    head: Any = np.where(wide < HEAD_WIDTH, HEAD + _SECOND, HEAD)
    if over is not None:
        head = head + height_over(over, np.asarray(wide - 2 * HEAD_LEFT))
    return Room(room.left, room.top + (head if head.ndim else float(head)), room.right, room.bottom)


def papers_for(name: str | None) -> list[Paper]:
    """The paper asked for, or the usual ones."""
    if name is not None and name not in PAPERS:
        raise UnknownPaper(name, ", ".join(PAPERS))
    return [PAPERS[name]] if name is not None else list(USUAL)


def divided(paper: Paper, height: float) -> tuple[Room, Room]:
    """The field for figures, and under it a strip of that height [mm]."""
    whole = paper.frame
    edge = whole.bottom - height
    return Room(whole.left, whole.top, whole.right, edge), Room(whole.left, edge, whole.right, whole.bottom)


def alone(extent: Extent, strip_height: Height, paper: str | None) -> Layout:
    """One figure alone; a given scale that is too fine is not kept. Raises UnknownPaper."""
    layout = _freely(extent, strip_height, papers_for(paper))
    if paper is None and extent.longest / layout.scales["position"] < _LARGE_ENOUGH:
        return min(layout, _freely(extent, strip_height, LARGE), key=lambda found: found.scales["position"])
    return layout


def _freely(extent: Extent, strip_height: Height, papers: Sequence[Paper]) -> Layout:
    """A given scale is kept where it fits."""
    try:
        return lay_out({"position": extent}, strip_height, papers)
    except TooLargeForPaper:
        return lay_out({"position": replace(extent, given=None)}, strip_height, papers)


def cut_to(layout: Layout, plane: Plane, extent: Extent) -> Layout:
    """A paper with one figure, no higher than that figure and the strip need; without a frame, no wider either."""
    need, paper = extent.size / layout.scales[plane] + extent.reach, layout.paper
    strip = layout.strip.size.imag
    over = extent.over[1].real + 2 * HEAD_LEFT if extent.over is not None else 0.0
    wide = paper.width if paper.margin else min(paper.width, max(HEAD_WIDTH, math.ceil(over), math.ceil(need.real)))

    def high(wide: float) -> float:
        head = under_heading(Room(0.0, 0.0, replace(paper, width=wide).frame.size.real, 0.0), extent.over).top
        return 2.0 * paper.margin + strip + math.ceil(head + need.imag)

    wide = wide if high(wide) <= paper.height else paper.width  # in less width the heading may need more lines
    cut = replace(paper, width=wide, height=min(paper.height, high(wide)))
    field, foot = divided(cut, strip)
    return Layout(cut, {plane: field}, layout.scales, foot, layout.headed)


def lay_out(extents: Mapping[Plane, Extent], strip_height: Height, candidates: Sequence[Paper]) -> Layout:
    """The smallest of the papers that holds all.

    Raises TooLargeForPaper where a given scale is too fine for every paper.
    """
    for size in dict.fromkeys(p.width * p.height for p in candidates):
        papers = [p for p in candidates if p.width * p.height == size]
        for ways in (_divisions, _other_divisions):
            if (best := _best(papers, extents, strip_height, ways)) is not None:
                return best
    raise _too_large(extents, strip_height, candidates)


def headed(
    layout: Layout, extents: Mapping[Plane, Extent], strip_height: Height, papers: Sequence[Paper], coarser: float
) -> Layout:
    """As the layout, with what stands over figures for as many as have room for it: on paper of the same size, none
    drawn more than so much coarser."""
    over = [plane for plane, extent in extents.items() if extent.over is not None]
    area = layout.paper.width * layout.paper.height
    same = [paper for paper in papers if paper.width * paper.height == area]
    for planes in (over, *([plane] for plane in over if len(over) > 1)):
        wanted = {plane: e if plane in planes else replace(e, over=None) for plane, e in extents.items()}
        found = _best(same, wanted, strip_height, _divisions) if planes else None
        if found is not None and all(found.scales[p] <= layout.scales[p] * coarser for p in extents):
            return replace(found, headed=tuple(planes))
    return layout


def _best(
    papers: Sequence[Paper], extents: Mapping[Plane, Extent], strip_height: Height, divisions: Divisions
) -> Layout | None:
    """The first of the best divisions, None where nothing fits."""
    best, found = -math.inf, None
    for paper in papers:
        field, strip = divided(paper, strip_height(paper))
        rooms, ends = _rooms(divisions, field, tuple(extents))
        free = {plane: under_heading(room, extents[plane].over) for plane, room in rooms.items()}
        scales = {plane: _scales(extents[plane], rooms[plane], free[plane]) for plane in extents}
        score = _score(extents, scales, free, field.size.real * field.size.imag)
        score = np.where(np.isnan(score), -math.inf, score)
        for first, end in pairwise(ends):
            share = first + int(np.argmax(score[first:end]))
            if score[share] > best + 1e-9:
                best, found = float(score[share]), (paper, rooms, scales, strip, share)
    return _picked(*found) if found is not None else None


@lru_cache(16)
def _rooms(divisions: Divisions, field: Room, planes: tuple[Plane, ...]) -> tuple[dict[Plane, Room], list[int]]:
    """All ways to divide a field as one: many rooms of each plane, and where those of each way begin and end."""
    ways = [{plane: _sides(room) for plane, room in way.items()} for way in divisions(field, planes)]
    ends = [0, *accumulate(max(np.size(side) for each in way.values() for side in each) for way in ways)]
    sides = {plane: np.empty((4, ends[-1])) for plane in planes}
    for way, first, end in zip(ways, ends, ends[1:]):
        for plane in planes:
            for side, value in zip(sides[plane], way[plane]):
                side[first:end] = value
    return {plane: Room(*each) for plane, each in sides.items()}, ends


def _sides(room: Room) -> tuple[Any, Any, Any, Any]:
    return room.left, room.top, room.right, room.bottom


def _scales(extent: Extent, room: Room, free: Room) -> Any:
    """The scale at which a figure fits what each of many rooms has free under its heading; NaN where it does not."""
    return np.where(room.right - room.left >= _NARROWEST, extent.scales_in(free), math.nan)


def _picked(paper: Paper, rooms: Mapping[Plane, Room], scales: Mapping[Plane, Any], strip: Room, share: int) -> Layout:
    """One of many divisions."""
    each = {plane: Room(*(float(side[share]) for side in _sides(room))) for plane, room in rooms.items()}
    return Layout(paper, each, {plane: float(scale[share]) for plane, scale in scales.items()}, strip)


def _score(
    extents: Mapping[Plane, Extent], scales: Mapping[Plane, Any], free: Mapping[Plane, Room], area: float
) -> Any:
    """Large figures count, how much of the field they fill, and a little that none is squeezed. NaN: one has no room.

    free  what rooms have under their headings; area: of the whole field [mm^2]
    """
    total, inked = 0.0, 0.0  # type: Any, Any
    for plane, extent in extents.items():
        room = free[plane]
        wide, high = extent.size.real / scales[plane], extent.size.imag / scales[plane]
        total += _worth(plane, np.maximum(wide, high), extent.labels)
        wide, high = wide + extent.reach.real, high + extent.reach.imag
        total += 0.15 * np.log(1 + np.minimum(room.right - room.left - wide, room.bottom - room.top - high))
        inked += wide * high / area
    return total + _INK * np.log(inked)


def _worth(plane: Plane, large: Any, labels: int) -> Any:
    """What the size of a figure is worth: it grows slowly once its letters have room, then not at all."""
    easy = 90.0 if plane == "position" else 30.0 + 2.2 * labels
    weight = math.sqrt(labels / 10) * (_MECHANISM if plane == "position" else 1)
    more = np.clip(large / easy, 1.0, 1.8)
    return weight * (np.log(np.clip(large, 1.0, easy)) + 0.4 * np.log(more))


def _too_large(
    extents: Mapping[Plane, Extent], strip_height: Height, papers: Sequence[Paper]
) -> TooLargeForPaper:
    """The given scale that does not fit, and the finest one that would."""
    given = [plane for plane, extent in extents.items() if extent.given is not None]
    area = max(paper.width * paper.height for paper in papers)
    large = [paper for paper in papers if paper.width * paper.height == area]
    for freed in (*([plane] for plane in given), given):
        loose = {plane: replace(e, given=None) if plane in freed else e for plane, e in extents.items()}
        found = _best(large, loose, strip_height, _other_divisions)
        if found is not None:
            plane = freed[0]
            scale, fits = extents[plane].given, found.scales[plane]
            while _best(large, _with_scale(loose, plane, finer(fits)), strip_height, _other_divisions):
                fits = finer(fits)
            assert scale is not None
            return TooLargeForPaper(NOWHERE, KEYS[plane], scale, fits, large[0].name[:2], UNITS[plane])
    raise AssertionError("free scales fit every paper")


def _with_scale(extents: Mapping[Plane, Extent], plane: Plane, scale: float) -> Mapping[Plane, Extent]:
    return {**extents, plane: replace(extents[plane], given=scale)}


# --- ways to divide a field -------------------------------------------------------------------

_SHARES = np.arange(6, 27) / 32


def _divisions(field: Room, planes: tuple[Plane, ...]) -> Iterator[dict[Plane, Room]]:
    """Rooms in the order of drawing: one after the other, or the first beside or over the others."""
    if len(planes) == 1:
        yield {planes[0]: field}
        return
    share, other = np.repeat(_SHARES, len(_SHARES)), np.tile(_SHARES, len(_SHARES))
    for across in (True, False):
        if len(planes) == 2:
            yield dict(zip(planes, _cut(field, _SHARES, across), strict=True))
            continue
        yield _three(field, planes, planes[0], share, other, across)
        first, rest = _cut(field, share, across)
        yield dict(zip(planes, (first, *_cut(rest, other, across)), strict=True))


def _other_divisions(field: Room, planes: tuple[Plane, ...]) -> Iterator[dict[Plane, Room]]:
    """Those, and any of three figures beside or over the others: for given scales."""
    yield from _divisions(field, planes)
    share, other = np.repeat(_SHARES, len(_SHARES)), np.tile(_SHARES, len(_SHARES))
    if len(planes) == 3:
        for across in (True, False):
            for alone in planes[1:]:
                yield _three(field, planes, alone, share, other, across)


def _three(
    field: Room, planes: tuple[Plane, ...], alone: Plane, share: Any, other: Any, across: bool
) -> dict[Plane, Room]:
    """One figure has a whole row (or column, `across`), the other two share the rest."""
    big, rest = _cut(field, share, across)
    if alone != planes[0]:
        rest, big = _cut(field, 1 - share, across)
    left = [plane for plane in planes if plane != alone]
    one, two = _cut(rest, other, not across)
    return {alone: big, left[0]: one, left[1]: two}


def _cut(room: Room, share: Any, across: bool) -> tuple[Room, Room]:
    """Two parts beside each other (`across`) or one above the other."""
    if across:
        x = room.left + share * (room.right - room.left)
        return Room(room.left, room.top, x, room.bottom), Room(x, room.top, room.right, room.bottom)
    y = room.top + share * (room.bottom - room.top)
    return Room(room.left, room.top, room.right, y), Room(room.left, y, room.right, room.bottom)
