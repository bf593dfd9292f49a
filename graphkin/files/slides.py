"""`[[slide]]`: prismatic pairs, and pins in slots, straight or circular."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count

from graphkin.errors import (
    BlockOrPin,
    CircleOrLine,
    KeyClash,
    MissingKey,
    NeedsTilt,
    NoMeaning,
    PinInCircle,
    RigidlyJoined,
    SlidesOnItself,
    UnknownPoint,
)
from graphkin.files.draft import Draft
from graphkin.files.lines import has_line, read_line
from graphkin.files.positions import Path
from graphkin.files.schema import SlideTable
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import CircularSlot, Pair, Slide


def read_slide(draft: Draft, table: SlideTable, path: Path, before: Sequence[Pair]) -> Slide | CircularSlot:
    """On a line, or on a circle if any key of a circle is there."""
    on_circle = table.centre is not None or table.radius is not None
    return read_circular(draft, table, path) if on_circle else _on_line(draft, table, path, before)


def read_circular(draft: Draft, table: SlideTable, path: Path) -> CircularSlot:
    """A pin in a circular slot. A block there would turn about the slot's centre: that is a hinge."""
    guide = draft.link(table.guide, *path, "guide")
    if has_line(table):
        raise CircleOrLine(draft.where(*path), "centre, radius", "through, toward, from, angle")
    if table.name is not None:
        raise NoMeaning(draft.where(*path, "name"), "name", "circle")
    if table.block is not None or table.pin is None:
        raise PinInCircle(draft.where(*path, "block"))
    if table.centre is None or table.radius is None:
        raise MissingKey(draft.where(*path), "radius" if table.radius is None else "centre")
    point = _pin(draft, table, table.pin, guide, path)
    if guide in draft.owners(point):
        raise SlidesOnItself(draft.where(*path, "pin"), guide)
    centre = _centre(draft, table.centre, guide, path)
    return CircularSlot(draft.numbered("c"), guide, centre, table.radius, draft.owners(point)[0], point)


def _centre(draft: Draft, given: str | Sequence[float], guide: str, path: Path) -> str:
    """The point of the guide; a place of the frame that has no point gets one: O, O', .."""
    if isinstance(given, str):
        return draft.point(guide, given, *path, "centre")
    if guide != FRAME:
        raise UnknownPoint(draft.where(*path, "centre"), "[x, y]", draft.named(guide))
    place = complex(*given)
    there = (point for point in draft.named(FRAME) if draft.frame_points[point] == place)
    free = (name for primes in count() if not draft.owners(name := "O" + "'" * primes))
    centre = next(there, None) or next(free)
    draft.frame_points[centre] = place
    return centre


def _on_line(draft: Draft, table: SlideTable, path: Path, before: Sequence[Pair]) -> Slide:
    name = draft.name(table.name, f"s{path[1]}", *path)
    draft.unnamed.add(name)
    guide = draft.link(table.guide, *path, "guide")
    if table.pin is not None:
        block, point, tilt = None, _pin(draft, table, table.pin, guide, path), 0.0
    else:
        block, point = _block(draft, table, guide, path)
        tilt = _tilt(draft, table, block, before, path)
    line = read_line(draft, table, guide, f"s{path[1]}", path)
    return Slide(name, table.name is not None, line, point, block, tilt)


def _pin(draft: Draft, table: SlideTable, pin: str, guide: str, path: Path) -> str:
    """The point of a pin in a slot: any point of another link than the guide."""
    for key, value in (("block", table.block), ("point", table.point)):
        if value is not None:
            raise KeyClash(draft.where(*path, key), "pin", key)
    if table.tilt is not None:
        raise NoMeaning(draft.where(*path, "tilt"), "tilt", "pin")
    draft.known(pin, *path, "pin")
    if set(draft.owners(pin)) == {guide}:
        raise SlidesOnItself(draft.where(*path, "pin"), guide)
    return pin


def _block(draft: Draft, table: SlideTable, guide: str, path: Path) -> tuple[str, str]:
    """The block and its point that stays on the line."""
    if table.block is None:
        raise BlockOrPin(draft.where(*path)) if table.point is None else MissingKey(draft.where(*path), "block")
    block = draft.link(table.block, *path, "block")
    if block == guide:
        raise SlidesOnItself(draft.where(*path, "block"), block)
    if table.point is None:
        raise MissingKey(draft.where(*path), "point")
    point = draft.point(block, table.point, *path, "point")
    shared = tuple(point for point in draft.named(block) if point in draft.links[guide].points)
    if shared:
        raise RigidlyJoined(draft.where(*path), guide, block, shared)
    return block, point


def _tilt(draft: Draft, table: SlideTable, block: str, before: Sequence[Pair], path: Path) -> float:
    """Angle from the line to the block's own direction. A block of one point takes its direction from its
    first slide's line; in a second slide, as the frame and a block of more points, it has one already."""
    slid_before = any(isinstance(pair, Slide) and pair.block == block for pair in before)
    has_direction = block == FRAME or len(draft.links[block].points) > 1 or slid_before
    if has_direction and table.tilt is None:
        raise NeedsTilt(draft.where(*path), block)
    if table.tilt and not has_direction:
        raise NoMeaning(draft.where(*path, "tilt"), "tilt", "tilt")
    return table.tilt or 0.0
