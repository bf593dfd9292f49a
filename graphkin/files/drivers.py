"""`[[driver]]` and `[[pose]]`: what moves the mechanism, and what fixes its drawn position."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from graphkin import errors
from graphkin.files.draft import Draft
from graphkin.files.schema import DriverTable, PoseTable
from graphkin.model.mechanism import FRAME, Driver, KeyPath, Pose

Vector = tuple[str, str]


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
                slide = _slide(draft, table, path)
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
            slide, also = _slide(draft, table, path), tuple(table.also)
            return Driver("slide", slide, value=table.at, rate=rate, acceleration=acceleration, also=also)


def _only(draft: Draft, subjects: Mapping[str, object], path: KeyPath) -> str:
    """The one of these keys that is there."""
    stated = [key for key, value in subjects.items() if value is not None]
    if not stated:
        raise errors.WhatIsDriven(draft.where(*path), tuple(subjects))
    if len(stated) > 1:
        raise errors.KeyClash(draft.where(*path, stated[1]), stated[0], stated[1])
    return stated[0]


def _turning(draft: Draft, table: PoseTable, path: KeyPath) -> tuple[str, Vector, str]:
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


def _owners(draft: Draft, vector: Vector, path: KeyPath) -> list[str]:
    """The links that have both points at different places, moving ones first."""
    for point in vector:
        draft.known(point, *path)
    owners = [link for link in draft.owners(*vector) if abs(draft.links[link].arm(*vector)) > 1e-12]
    if not owners:
        arms = ("".join(draft.named(link)[:2]) for link in draft.links if len(draft.named(link)) > 1)
        raise errors.NoVector(draft.where(*path), "".join(vector), tuple(arms))
    return owners


def _slide(draft: Draft, table: PoseTable, path: KeyPath) -> str:
    """The name of a pair whose displacement is meant."""
    assert table.slide is not None
    _refuse(draft, {"angle": table.angle, "from": table.from_}, "slide", path)
    if not draft.can_be_driven(table.slide):
        raise errors.UnknownSlide(draft.where(*path, "slide"), table.slide, draft.pair_names)
    return table.slide


def _refuse(draft: Draft, keys: Mapping[str, object], why: str, path: KeyPath) -> None:
    for key, value in keys.items():
        if value is not None:
            raise errors.NoMeaning(draft.where(*path, key), key, why)
