"""A mechanism with other values: its text stays in step, with comments and layout."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TypeVar

from graphkin.errors import NoSuchValue, Where
from graphkin.files.source import Deferred, key_lines, stated_in
from graphkin.files.toml import replaced_values
from graphkin.files.values import POINT, read_quantity, split_points, tidy
from graphkin.model.mechanism import Driver, KeyPath, Mechanism, Pose
from graphkin.model.naming import driver_number

_M = TypeVar("_M", bound=Mechanism)

_PLAIN_TABLES = ("frame", "links", "sketch", "scales")
_TABLES_OF_MANY = ("slide", "gear", "roll", "cam", "driver", "pose")
_DRIVER_VALUES = ("angle", "at", "omega", "alpha", "velocity", "acceleration", "also")
_DIGITS = 12  # of mm and deg in the text of a mechanism at another position


def changed_text(mechanism: Mechanism, values: Mapping[str, object]) -> str:
    """The mechanism's file with other values, each named as `Mechanism.with_` says. Raises NoSuchValue for a name that
    means nothing in this file, or more than one thing."""
    changes = {_path(mechanism, tidy(name.strip())): value for name, value in values.items()}
    return replaced_values(mechanism.text, changes)


def reposed(mechanism: _M, drivers: Sequence[float], poses: Sequence[float], sketch: Mapping[str, complex]) -> _M:
    """The mechanism with another position as its drawn one, on the same assembly; its text has it, and is not read.

    drivers, poses  the value of each there [rad, m]; one that the file leaves open, or a wheel's, stays out of it
    sketch          where the moving points are there [m]
    """
    changes: dict[KeyPath, object] = {}
    driven = enumerate(zip(mechanism.drivers, drivers, strict=True))
    moved = [_moved(driver, value, ("driver", number), changes) for number, (driver, value) in driven]
    posed = enumerate(zip(mechanism.poses, poses, strict=True))
    held = [_moved(pose, value, ("pose", number), changes) for number, (pose, value) in posed]
    places = {**mechanism.sketch}
    for point, place in sketch.items():
        x, y = (round(part * 1000, _DIGITS) for part in (place.real, place.imag))
        changes["sketch", point] = [x, y]
        places[point] = complex(read_quantity(x, "length"), read_quantity(y, "length"))
    text = replaced_values(mechanism.text, changes)
    return replace(
        mechanism, drivers=tuple(moved), poses=tuple(held), sketch=places, text=text,
        lines=Deferred(partial(key_lines, text, mechanism.file)), given=Deferred(partial(stated_in, text)),
    )  # fmt: skip


_Set = TypeVar("_Set", Driver, Pose)


def _moved(entry: _Set, value: float, path: KeyPath, changes: dict[KeyPath, object]) -> _Set:
    """A driver or pose at another value, as a file would give it: `changes` has that in mm or deg."""
    if entry.value is None or entry.kind == "spin":
        return entry
    slides = entry.kind == "slide"
    written = round(value * 1000 if slides else math.degrees(value), _DIGITS)
    changes[*path, "at" if slides else "angle"] = written
    return replace(entry, value=read_quantity(written, "length" if slides else "angle"))


def _path(mechanism: Mechanism, name: str) -> KeyPath:
    """The place that a name means. Raises NoSuchValue."""
    paths = list(dict.fromkeys(_paths(mechanism, name)))
    if len(paths) == 1:
        return paths[0]
    possible = [".".join(map(str, path)) for path in paths] or list(_possible_names(mechanism))
    raise NoSuchValue(Where(mechanism.file), name, tuple(possible))


def _paths(mechanism: Mechanism, name: str) -> Iterator[KeyPath]:
    """All places that a name may mean."""
    if "." in name:
        yield from _dotted(mechanism, name.split("."))
    elif POINT.fullmatch(name):
        yield from _coordinates(mechanism, name)
    elif points := split_points(name):
        yield from (path for path in _measures(mechanism) if split_points(str(path[-1])) in (points, points[::-1]))
    else:
        yield from _of_item(mechanism, *name.partition(" ")[::2])


def _measures(mechanism: Mechanism) -> Iterator[KeyPath]:
    """The lengths and angles of links."""
    for path in mechanism.given:
        if len(path) == 3 and path[0] == "links" and len(split_points(str(path[2]))) > 1:
            yield path


def _coordinates(mechanism: Mechanism, point: str) -> Iterator[KeyPath]:
    """The coordinates of a point in the frame, in a link's shape, or in the sketch."""
    if ("frame", point) in mechanism.given:
        yield "frame", point
        return
    yield from (path for path in mechanism.given if path[:1] == ("links",) and path[2:] == ("shape", point))
    if point in mechanism.points:
        yield "sketch", point


def _of_item(mechanism: Mechanism, key: str, of: str) -> Iterator[KeyPath]:
    """`omega AB`, `at ram`, `angle ram`; of the only driver also `omega` alone."""
    if not of and key in _DRIVER_VALUES and len(_entries(mechanism, "driver")) == 1:
        yield "driver", 0, key
    if of and (number := driver_number(mechanism, of.strip())) is not None and key in _DRIVER_VALUES:
        yield "driver", number, key
        return
    for table in ("slide", "roll", "pose") if of else ():
        for number, entry in enumerate(_entries(mechanism, table)):
            named = of.strip() in (entry.get("name"), entry.get("vector"), entry.get("slide"))
            if named and (table, number, key) in mechanism.given:
                yield table, number, key


def _entries(mechanism: Mechanism, table: str) -> list[dict[str, object]]:
    """The tables of a kind that there may be many of, as the file has them."""
    given = mechanism.given.get((table,))
    listed = given.written if given is not None else []
    return [entry for entry in listed if isinstance(entry, dict)] if isinstance(listed, list) else []


def _dotted(mechanism: Mechanism, parts: list[str]) -> Iterator[KeyPath]:
    """`links.1.AB`, `slide.ram.angle`, `driver.0.omega`, `gear.0.radii.1`, `sketch.C`."""
    table = parts[0]
    if table in _PLAIN_TABLES and (len(parts) > 2 or table != "links"):
        path: KeyPath = tuple(parts)
        if table in ("sketch", "scales") or path in mechanism.given:
            yield path
    elif table in _TABLES_OF_MANY and len(parts) > 2:
        entries = _entries(mechanism, table)
        names = [entry.get("name") or entry.get("vector") or entry.get("slide") for entry in entries]
        number = names.index(parts[1]) if parts[1] in names else int(parts[1]) if parts[1].isdecimal() else -1
        if 0 <= number < len(entries):
            yield (table, number, *(int(part) if part.isdecimal() else part for part in parts[2:]))


def _possible_names(mechanism: Mechanism) -> Iterator[str]:
    """The values there are, as people would name them."""
    yield from (str(path[-1]) for path in _measures(mechanism))
    for driver, entry in zip(mechanism.drivers, _entries(mechanism, "driver")):
        yield from (f"{key} {driver.name}" for key in _DRIVER_VALUES if key in entry)
    fixed = (str(path[1]) for path in mechanism.given if len(path) == 2 and path[0] == "frame")
    yield from (point for point in fixed if POINT.fullmatch(point))
    slides = _entries(mechanism, "slide")
    for slide in slides:
        yield from (f"{key} {slide['name']}" for key in ("angle", "tilt", "radius") if key in slide and "name" in slide)
    yield from (f"slide.{k}.angle" for k, slide in enumerate(slides) if "angle" in slide)
