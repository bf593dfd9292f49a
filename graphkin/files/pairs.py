"""The tables of pairs: `[[slide]]`, `[[gear]]`, `[[roll]]`, `[[cam]]`; `READERS` has one reader a kind of table."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import count
from typing import Any

from graphkin import errors
from graphkin.files.draft import Draft
from graphkin.files.lines import has_line, read_line
from graphkin.files.schema import CamTable, File, GearTable, ProfileTable, RollTable, SlideTable
from graphkin.model.mechanism import FRAME, KeyPath
from graphkin.model.pairs import Cam, CircularSlot, Gear, Pair, Profile, RollingContact, Slide

_LINE_KEYS = "through, toward, from, angle"


def read_pairs(draft: Draft, file: File) -> tuple[Pair, ...]:
    """The pairs of a file, kind by kind."""
    named = (entry.name for entries in (file.slide, file.roll) for entry in entries)
    draft.given_names = {name for name in named if name}
    draft.slides = file.slide
    pairs: list[Pair] = []
    for name, read in READERS.items():
        for number, table in enumerate(getattr(file, name)):
            with draft.noting():
                pairs.append(read(draft, table, (name, number), pairs))
    return tuple(pairs)


def _slide(draft: Draft, table: SlideTable, path: KeyPath, before: Sequence[Pair]) -> Slide | CircularSlot:
    """A block or a pin on a line, or a pin on a circle if any key of a circle is there."""
    on_circle = table.centre is not None or table.radius is not None
    return _circular(draft, table, path) if on_circle else _straight(draft, table, before, path)


def _circular(draft: Draft, table: SlideTable, path: KeyPath) -> CircularSlot:
    """A pin in a circular slot. A block there would turn about the slot's centre: that is a hinge."""
    guide = draft.link(table.guide, *path, "guide")
    if has_line(table):
        raise errors.CircleOrLine(draft.where(*path), "centre, radius", _LINE_KEYS)
    if table.name is not None:
        raise errors.NoMeaning(draft.where(*path, "name"), "name", "circle")
    if table.block is not None or table.pin is None:
        raise errors.PinInCircle(draft.where(*path, "block"))
    if table.centre is None or table.radius is None:
        raise errors.MissingKey(draft.where(*path), "radius" if table.radius is None else "centre")
    point = _pin(draft, table, table.pin, guide, path)
    if guide in draft.owners(point):
        raise errors.SlidesOnItself(draft.where(*path, "pin"), guide)
    centre = _slot_centre(draft, table.centre, guide, path)
    return CircularSlot(draft.numbered("c"), guide, centre, table.radius, draft.owners(point)[0], point)


def _slot_centre(draft: Draft, centre: str | Sequence[float], guide: str, path: KeyPath) -> str:
    """The point of the guide; a place of the frame that has no point gets one: O, O', .."""
    if isinstance(centre, str):
        return draft.point(guide, centre, *path, "centre")
    if guide != FRAME:
        raise errors.UnknownPoint(draft.where(*path, "centre"), "[x, y]", draft.named(guide))
    place = complex(*centre)
    there = (point for point in draft.named(FRAME) if draft.frame_points[point] == place)
    free = (name for primes in count() if not draft.owners(name := "O" + "'" * primes))
    point = next(there, None) or next(free)
    draft.frame_points[point] = place
    return point


def _straight(draft: Draft, table: SlideTable, before: Sequence[Pair], path: KeyPath) -> Slide:
    name = draft.name(table.name, f"s{path[1]}", *path)
    draft.unnamed.add(name)
    guide = draft.link(table.guide, *path, "guide")
    if table.pin is not None:
        block, point, tilt = None, _pin(draft, table, table.pin, guide, path), 0.0
    else:
        # the block and its point that stays on the line
        if table.block is None:
            where = draft.where(*path)
            raise errors.BlockOrPin(where) if table.point is None else errors.MissingKey(where, "block")
        block = draft.link(table.block, *path, "block")
        if block == guide:
            raise errors.SlidesOnItself(draft.where(*path, "block"), block)
        if table.point is None:
            raise errors.MissingKey(draft.where(*path), "point")
        point = draft.point(block, table.point, *path, "point")
        shared = tuple(point for point in draft.named(block) if point in draft.links[guide].points)
        if shared:
            raise errors.RigidlyJoined(draft.where(*path), guide, block, shared)
        # angle from the line to the block's own direction. A block of one point takes its direction from its first
        # slide's line; in a second slide, as the frame and a block of more points, it has one already
        slid_before = any(isinstance(pair, Slide) and pair.block == block for pair in before)
        has_direction = block == FRAME or len(draft.links[block].points) > 1 or slid_before
        if has_direction and table.tilt is None:
            raise errors.NeedsTilt(draft.where(*path), block)
        if table.tilt and not has_direction:
            raise errors.NoMeaning(draft.where(*path, "tilt"), "tilt", "tilt")
        tilt = table.tilt or 0.0
    line = read_line(draft, table, guide, f"s{path[1]}", path)
    return Slide(name, table.name is not None, line, point, block, tilt)


def _pin(draft: Draft, table: SlideTable, pin: str, guide: str, path: KeyPath) -> str:
    """The point of a pin in a slot: any point of another link than the guide."""
    for key, value in (("block", table.block), ("point", table.point)):
        if value is not None:
            raise errors.KeyClash(draft.where(*path, key), "pin", key)
    if table.tilt is not None:
        raise errors.NoMeaning(draft.where(*path, "tilt"), "tilt", "pin")
    draft.known(pin, *path, "pin")
    if set(draft.owners(pin)) == {guide}:
        raise errors.SlidesOnItself(draft.where(*path, "pin"), guide)
    return pin


def _two_links(draft: Draft, names: Sequence[str], path: KeyPath) -> tuple[str, str]:
    first, second = (draft.link(name, *path, "links", n) for n, name in enumerate(names))
    if first == second:
        raise errors.SameTwice(draft.where(*path, "links"), names[0])
    return first, second


def _gear(draft: Draft, table: GearTable, path: KeyPath, before: Sequence[Pair]) -> Gear:
    """Pitch circles of two links in mesh."""
    links = _two_links(draft, table.links, path)
    first, second = (
        draft.point(link, centre, *path, "centres", n) for n, (link, centre) in enumerate(zip(links, table.centres))
    )
    if first == second:
        raise errors.SameTwice(draft.where(*path, "centres"), first)
    one, other = table.radii
    if table.internal and one == other:
        raise errors.SameCircles(draft.where(*path, "radii"))
    return Gear(draft.name(None, f"g{path[1]}", *path), links, (first, second), (one, other), table.internal)


def _roll(draft: Draft, table: RollTable, path: KeyPath, before: Sequence[Pair]) -> RollingContact:
    """A wheel on a line if any key of a line is there, on a circle if any of a circle is."""
    own, on_line = f"r{path[1]}", table.on_centre is None and table.on_radius is None
    name = draft.name(table.name, own, *path) if on_line else own
    if on_line:
        draft.unnamed.add(name)
    wheel = draft.link(table.wheel, *path, "wheel")
    track = draft.link(table.on, *path, "on")
    if wheel == track:
        raise errors.SameTwice(draft.where(*path, "on"), table.wheel)
    centre = draft.point(wheel, table.centre, *path, "centre")
    if not on_line:
        rim, internal = _track_circle(draft, table, track, path), bool(table.internal)
        return RollingContact(own, False, wheel, centre, table.radius, track, None, True, *rim, internal)
    if table.internal is not None:
        raise errors.NoMeaning(draft.where(*path, "internal"), "internal", "line")
    line = read_line(draft, table, track, own, path)
    left, named = table.side != "right", table.name is not None
    return RollingContact(name, named, wheel, centre, table.radius, track, line, left, None, 0.0, False)


def _track_circle(draft: Draft, table: RollTable, track: str, path: KeyPath) -> tuple[str, float]:
    """Centre and radius of the circle a wheel rolls on."""
    if has_line(table):
        raise errors.CircleOrLine(draft.where(*path), "on_centre, on_radius", _LINE_KEYS)
    for key, value in (("name", table.name), ("side", table.side)):
        if value is not None:
            raise errors.NoMeaning(draft.where(*path, key), key, "circle")
    if table.on_centre is None or table.on_radius is None:
        raise errors.MissingKey(draft.where(*path), "on_radius" if table.on_radius is None else "on_centre")
    centre = draft.point(track, table.on_centre, *path, "on_centre")
    if centre == table.centre:
        raise errors.SameTwice(draft.where(*path, "on_centre"), centre)
    if table.internal and table.radius == table.on_radius:
        raise errors.SameCircles(draft.where(*path, "on_radius"))
    return centre, table.on_radius


def _cam(draft: Draft, table: CamTable, path: KeyPath, before: Sequence[Pair]) -> Cam:
    """Two profiles that touch and slide."""
    links = _two_links(draft, table.links, path)
    first, second = (_profile(draft, profile, link, n, (*path, "profiles", n))
                     for n, (link, profile) in enumerate(zip(links, table.profiles)))  # fmt: skip
    if first.line is not None and second.line is not None:
        raise errors.LineOnLine(draft.where(*path, "profiles"))
    circles = first.line is None and second.line is None
    if table.internal and not circles:
        raise errors.NoMeaning(draft.where(*path, "internal"), "internal", "line")
    if circles and first.radius == second.radius == 0:
        raise errors.PointOnPoint(draft.where(*path, "profiles"))
    if table.internal and first.radius == second.radius:
        raise errors.SameCircles(draft.where(*path, "profiles"))
    return Cam(draft.numbered("c"), links, (first, second), table.internal)


def _profile(draft: Draft, table: ProfileTable, link: str, number: int, path: KeyPath) -> Profile:
    """A circle has `centre` and `radius`, a line the keys of a line."""
    circle = table.centre is not None or table.radius is not None
    if circle == has_line(table):
        raise errors.CircleOrLine(draft.where(*path), "centre, radius", _LINE_KEYS)
    if not circle:
        line = read_line(draft, table, link, f"c{path[1]}_{number}", path)
        return Profile(None, 0.0, line, table.side != "right")
    if table.centre is None or table.radius is None:
        raise errors.MissingKey(draft.where(*path), "radius" if table.radius is None else "centre")
    if table.side is not None:
        raise errors.NoMeaning(draft.where(*path, "side"), "side", "circle")
    return Profile(draft.point(link, table.centre, *path, "centre"), table.radius, None, True)


READERS: Mapping[str, Callable[[Draft, Any, KeyPath, Sequence[Pair]], Pair]] = {
    "slide": _slide, "gear": _gear, "roll": _roll, "cam": _cam,
}  # fmt: skip
"""By table, in the order in which a mechanism lists its pairs; each reader has the place in the file and the pairs
before."""
