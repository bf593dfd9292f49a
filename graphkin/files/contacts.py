"""`[[gear]]`, `[[roll]]` and `[[cam]]`: pairs whose links touch."""

from __future__ import annotations

from collections.abc import Sequence

from graphkin.errors import CircleOrLine, LineOnLine, MissingKey, NoMeaning, PointOnPoint, SameCircles, SameTwice
from graphkin.files.draft import Draft
from graphkin.files.lines import has_line, read_line
from graphkin.files.positions import Path
from graphkin.files.schema import CamTable, GearTable, ProfileTable, RollTable
from graphkin.model.pairs import Cam, Gear, Pair, Profile, RollingContact


def _two_links(draft: Draft, given: Sequence[str], path: Path) -> tuple[str, str]:
    first, second = (draft.link(name, *path, "links", n) for n, name in enumerate(given))
    if first == second:
        raise SameTwice(draft.where(*path, "links"), given[0])
    return first, second


def read_gear(draft: Draft, table: GearTable, path: Path, before: Sequence[Pair]) -> Gear:
    links = _two_links(draft, table.links, path)
    first, second = (
        draft.point(link, centre, *path, "centres", n) for n, (link, centre) in enumerate(zip(links, table.centres))
    )
    if first == second:
        raise SameTwice(draft.where(*path, "centres"), first)
    one, other = table.radii
    if table.internal and one == other:
        raise SameCircles(draft.where(*path, "radii"))
    return Gear(draft.name(None, f"g{path[1]}", *path), links, (first, second), (one, other), table.internal)


def read_roll(draft: Draft, table: RollTable, path: Path, before: Sequence[Pair]) -> RollingContact:
    """A wheel on a line if any key of a line is there, on a circle if any of a circle is."""
    own, on_line = f"r{path[1]}", table.on_centre is None and table.on_radius is None
    name = draft.name(table.name, own, *path) if on_line else own
    if on_line:
        draft.unnamed.add(name)
    wheel = draft.link(table.wheel, *path, "wheel")
    track = draft.link(table.on, *path, "on")
    if wheel == track:
        raise SameTwice(draft.where(*path, "on"), table.wheel)
    centre = draft.point(wheel, table.centre, *path, "centre")
    if not on_line:
        on_centre, on_radius = _track_circle(draft, table, track, path)
        internal = bool(table.internal)
        return RollingContact(
            own, False, wheel, centre, table.radius, track, None, True, on_centre, on_radius, internal
        )
    if table.internal is not None:
        raise NoMeaning(draft.where(*path, "internal"), "internal", "line")
    line = read_line(draft, table, track, own, path)
    left, named = table.side != "right", table.name is not None
    return RollingContact(name, named, wheel, centre, table.radius, track, line, left, None, 0.0, False)


def _track_circle(draft: Draft, table: RollTable, track: str, path: Path) -> tuple[str, float]:
    """Centre and radius of the circle a wheel rolls on."""
    if has_line(table):
        raise CircleOrLine(draft.where(*path), "on_centre, on_radius", "through, toward, from, angle")
    for key, value in (("name", table.name), ("side", table.side)):
        if value is not None:
            raise NoMeaning(draft.where(*path, key), key, "circle")
    if table.on_centre is None or table.on_radius is None:
        raise MissingKey(draft.where(*path), "on_radius" if table.on_radius is None else "on_centre")
    centre = draft.point(track, table.on_centre, *path, "on_centre")
    if centre == table.centre:
        raise SameTwice(draft.where(*path, "on_centre"), centre)
    if table.internal and table.radius == table.on_radius:
        raise SameCircles(draft.where(*path, "on_radius"))
    return centre, table.on_radius


def read_cam(draft: Draft, table: CamTable, path: Path, before: Sequence[Pair]) -> Cam:
    links = _two_links(draft, table.links, path)
    first, second = (
        _profile(draft, profile, link, n, (*path, "profiles", n))
        for n, (link, profile) in enumerate(zip(links, table.profiles))
    )
    if first.line is not None and second.line is not None:
        raise LineOnLine(draft.where(*path, "profiles"))
    if table.internal and (first.line is not None or second.line is not None):
        raise NoMeaning(draft.where(*path, "internal"), "internal", "line")
    circles = first.line is None and second.line is None
    if circles and first.radius == second.radius == 0:
        raise PointOnPoint(draft.where(*path, "profiles"))
    if table.internal and first.radius == second.radius:
        raise SameCircles(draft.where(*path, "profiles"))
    return Cam(draft.numbered("c"), links, (first, second), table.internal)


def _profile(draft: Draft, table: ProfileTable, link: str, number: int, path: Path) -> Profile:
    """A circle has `centre` and `radius`, a line the keys of a line."""
    circle = table.centre is not None or table.radius is not None
    if circle == has_line(table):
        raise CircleOrLine(draft.where(*path), "centre, radius", "through, toward, from, angle")
    if not circle:
        line = read_line(draft, table, link, f"c{path[1]}_{number}", path)
        return Profile(None, 0.0, line, table.side != "right")
    if table.centre is None or table.radius is None:
        raise MissingKey(draft.where(*path), "radius" if table.radius is None else "centre")
    if table.side is not None:
        raise NoMeaning(draft.where(*path, "side"), "side", "circle")
    return Profile(draft.point(link, table.centre, *path, "centre"), table.radius, None, True)
