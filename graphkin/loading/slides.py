"""`[[slide]]`: prismatic pairs, and pins in slots."""

from __future__ import annotations

from collections.abc import Sequence

from graphkin.errors import BlockOrPin, KeyClash, MissingKey, NeedsTilt, NoMeaning, RigidlyJoined, SlidesOnItself
from graphkin.loading.draft import Draft
from graphkin.loading.lines import read_line
from graphkin.loading.positions import Path
from graphkin.loading.schema import SlideTable
from graphkin.mechanism import FRAME
from graphkin.pairs import Pair, Slide


def read_slide(draft: Draft, table: SlideTable, path: Path, before: Sequence[Pair]) -> Slide:
    name = draft.name(table.name, f"s{path[1]}", *path)
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
