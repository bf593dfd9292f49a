"""The tables of pairs, `[[slide]]`, `[[gear]]`, `[[roll]]`, `[[cam]]`, by a reader each in `READERS`; `[[driver]]` and
`[[pose]]`: what moves the mechanism, and what fixes its drawn position."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import count

from graphkin import errors
from graphkin.files.draft import Draft
from graphkin.files.lines import has_line, read_line
from graphkin.files.schema import CamTable, DriverTable, File, GearTable, PoseTable, ProfileTable, RollTable, SlideTable
from graphkin.model.mechanism import FRAME, Driver, KeyPath, Pose
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
    if isinstance(table.centre, str):
        centre = draft.point(guide, table.centre, *path, "centre")
    elif guide != FRAME:
        raise errors.UnknownPoint(draft.where(*path, "centre"), "[x, y]", draft.named(guide))
    else:  # a place of the frame that has no point gets one: O, O', ..
        place = complex(*table.centre)
        there = (point for point in draft.named(FRAME) if draft.frame_points[point] == place)
        free = (name for primes in count() if not draft.owners(name := "O" + "'" * primes))
        centre = next(there, None) or next(free)
        draft.frame_points[centre] = place
    return CircularSlot(draft.next_slot(), guide, centre, table.radius, draft.owners(point)[0], point)


def _slide(draft: Draft, table: SlideTable, path: KeyPath, before: Sequence[Pair]) -> Slide | CircularSlot:
    """A block or a pin on a line, or a pin on a circle if any key of a circle is there."""
    if table.centre is not None or table.radius is not None:
        return _circular(draft, table, path)
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
        first = next((pair for pair in before if isinstance(pair, Slide) and pair.block == block), None)
        points = draft.named(block)
        own = "+x" if block == FRAME else "→".join(points[:2]) if len(points) > 1 else ""
        if table.tilt is None and own:
            raise errors.NeedsTilt(draft.where(*path), block, own)
        if table.tilt is None and first is not None:
            other = draft.frame if first.guide == FRAME else first.guide
            raise errors.NeedsSecondTilt(draft.where(*path), block, other)
        if table.tilt and not (own or first):
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
    name = draft.name(None, draft.numbered("g", path[1]), *path)
    return Gear(name, links, (first, second), (one, other), table.internal)


def _roll(draft: Draft, table: RollTable, path: KeyPath, before: Sequence[Pair]) -> RollingContact:
    """A wheel on a line if any key of a line is there, on a circle if any of a circle is."""
    own, on_line = draft.numbered("r", path[1]), table.on_centre is None and table.on_radius is None
    name = draft.name(table.name, own, *path) if on_line else own
    if on_line:
        draft.unnamed.add(name)
    wheel = draft.link(table.wheel, *path, "wheel")
    track = draft.link(table.on, *path, "on")
    if wheel == track:
        raise errors.SameTwice(draft.where(*path, "on"), table.wheel)
    centre = draft.point(wheel, table.centre, *path, "centre")
    if not on_line:
        if has_line(table):
            raise errors.CircleOrLine(draft.where(*path), "on_centre, on_radius", _LINE_KEYS)
        for key, value in (("name", table.name), ("side", table.side)):
            if value is not None:
                raise errors.NoMeaning(draft.where(*path, key), key, "circle")
        if table.on_centre is None or table.on_radius is None:
            raise errors.MissingKey(draft.where(*path), "on_radius" if table.on_radius is None else "on_centre")
        rim, internal = draft.point(track, table.on_centre, *path, "on_centre"), bool(table.internal)
        if rim == table.centre:
            raise errors.SameTwice(draft.where(*path, "on_centre"), rim)
        if internal and table.radius == table.on_radius:
            raise errors.SameCircles(draft.where(*path, "on_radius"))
        circle = (rim, table.on_radius, internal)
        return RollingContact(own, False, wheel, centre, table.radius, track, None, True, *circle)
    if table.internal is not None:
        raise errors.NoMeaning(draft.where(*path, "internal"), "internal", "line")
    line = read_line(draft, table, track, own, path)
    left, named = table.side != "right", table.name is not None
    return RollingContact(name, named, wheel, centre, table.radius, track, line, left, None, 0.0, False)


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
    return Cam(draft.next_slot(), links, (first, second), table.internal)


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


READERS: Mapping[str, Callable[..., Pair]] = {
    "slide": _slide, "gear": _gear, "roll": _roll, "cam": _cam,
}  # fmt: skip
"""By table, in the order in which a mechanism lists its pairs; each reader has the place in the file and the pairs
before."""


def read_drivers(draft: Draft, tables: Sequence[DriverTable], poses: int) -> tuple[Driver, ...]:
    """The drivers; as many may leave their value out as there are poses."""
    drivers: list[Driver] = []
    freedoms: set[tuple[str, str]] = set()  # a slide's displacement, or the turning of one link against another
    for number, table in enumerate(tables):
        with draft.noting():
            driver = _driver(draft, table, ("driver", number))
            freedom = ("slide", driver.link) if driver.kind == "slide" else (driver.link, driver.from_link)
            if freedom in freedoms:
                raise errors.DrivenTwice(draft.where("driver", number), driver.name)
            freedoms.add(freedom)
            if driver.value is None and driver.kind != "spin":
                poses -= 1
                if poses < 0:
                    raise errors.SayValue(draft.where("driver", number), "at" if driver.kind == "slide" else "angle")
            drivers.append(driver)
    return tuple(drivers)


def read_poses(draft: Draft, tables: Sequence[PoseTable]) -> tuple[Pose, ...]:
    """The poses of a file."""
    poses = []
    for number, table in enumerate(tables):
        with draft.noting():
            path = ("pose", number)
            if _only(draft, {"vector": table.vector, "slide": table.slide}, path) == "slide":
                slide = _meant_slide(draft, table, path)
                if table.at is None:
                    raise errors.MissingKey(draft.where(*path), "at")
                poses.append(Pose("slide", slide, table.at))
                continue
            link, vector, from_link = _turning(draft, table, path)
            if table.angle is None:
                raise errors.MissingKey(draft.where(*path), "angle")
            poses.append(Pose("angle", link, table.angle, vector, from_link, table.from_))
    return tuple(poses)


def _driver(draft: Draft, table: DriverTable, path: KeyPath) -> Driver:
    match _only(draft, {"vector": table.vector, "link": table.link, "slide": table.slide}, path):
        case "vector":
            link, vector, from_link = _turning(draft, table, path)
            length = abs(draft.links[link].arm(*vector))
            rates = (("omega", table.omega, "velocity", table.velocity),
                     ("alpha", table.alpha, "acceleration", table.acceleration))  # fmt: skip
            for key, turning, other, tip in rates:
                if turning is not None and tip is not None:
                    raise errors.KeyClash(draft.where(*path, other), key, other)
            rate, acceleration = (turning or (tip or 0.0) / length for _, turning, _, tip in rates)
            also = tuple(table.also)
            return Driver("angle", link, vector, from_link, table.from_, table.angle, rate, acceleration, also)
        case "link":
            # a wheel whose own direction does not matter
            assert table.link is not None
            others = {"angle": table.angle, "from": table.from_, "at": table.at, "also": table.also or None}
            _refuse(draft, others | {"velocity": table.velocity, "acceleration": table.acceleration}, "spin", path)
            link = draft.link(table.link, *path, "link")
            if link == FRAME:
                raise errors.DrivenFrame(draft.where(*path, "link"), table.link)
            return Driver("spin", link, rate=table.omega or 0.0, acceleration=table.alpha or 0.0)
        case _:
            _refuse(draft, {"omega": table.omega, "alpha": table.alpha}, "slide", path)
            rate, acceleration = table.velocity or 0.0, table.acceleration or 0.0
            slide, also = _meant_slide(draft, table, path), tuple(table.also)
            return Driver("slide", slide, value=table.at, rate=rate, acceleration=acceleration, also=also)


def _only(draft: Draft, subjects: Mapping[str, object], path: KeyPath) -> str:
    """The one of these keys that is there."""
    stated = [key for key, value in subjects.items() if value is not None]
    if not stated:
        raise errors.WhatIsDriven(draft.where(*path), tuple(subjects))
    if len(stated) > 1:
        raise errors.KeyClash(draft.where(*path, stated[1]), stated[0], stated[1])
    return stated[0]


def _turning(draft: Draft, table: PoseTable, path: KeyPath) -> tuple[str, tuple[str, str], str]:
    """The link a vector belongs to, the vector, and the link it is measured from."""
    assert table.vector is not None
    if table.at is not None:
        raise errors.NoMeaning(draft.where(*path, "at"), "at", "vector")
    owners = _owners(draft, table.vector, (*path, "vector"))
    if owners[0] == FRAME:
        raise errors.DrivenFrame(draft.where(*path, "vector"), "".join(table.vector))
    if table.from_ is None:
        return owners[0], table.vector, FRAME
    others = [link for link in _owners(draft, table.from_, (*path, "from")) if link != owners[0]]
    if not others:
        raise errors.SameLink(draft.where(*path, "from"), owners[0])
    return owners[0], table.vector, others[0]


def _owners(draft: Draft, vector: tuple[str, str], path: KeyPath) -> list[str]:
    """The links that have both points at different places, moving ones first."""
    for point in vector:
        draft.known(point, *path)
    owners = [link for link in draft.owners(*vector) if abs(draft.links[link].arm(*vector)) > 1e-12]
    if not owners:
        links = (link for link in draft.links if link != FRAME or path[-1] == "from")  # the frame is not driven
        arms = ("".join(draft.named(link)[:2]) for link in links if len(draft.named(link)) > 1)
        raise errors.NoVector(draft.where(*path), "".join(vector), tuple(arms))
    return owners


def _meant_slide(draft: Draft, table: PoseTable, path: KeyPath) -> str:
    """The name of a pair whose displacement is meant."""
    assert table.slide is not None
    _refuse(draft, {"angle": table.angle, "from": table.from_}, "slide", path)
    if table.slide not in draft.used_names | draft.unnamed:
        raise errors.UnknownSlide(draft.where(*path, "slide"), table.slide, tuple(sorted(draft.used_names)))
    return table.slide


def _refuse(draft: Draft, keys: Mapping[str, object], why: str, path: KeyPath) -> None:
    for key, value in keys.items():
        if value is not None:
            raise errors.NoMeaning(draft.where(*path, key), key, why)
