"""A mechanism built in Python, table by table as its file is written, or given other values: its text stays in step."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, Generic, Self, TypeVar

from graphkin.base.value import frozen
from graphkin.errors import NoSuchValue, Where
from graphkin.files.source import Deferred, key_lines, stated_in
from graphkin.files.toml import replaced_values, toml
from graphkin.files.values import POINT, read_quantity, split_points, tidy
from graphkin.model.mechanism import Driver, KeyPath, Mechanism, Pose
from graphkin.model.naming import driver_number

Made = TypeVar("Made")  # the type of what is built, given by whatever reads the tables
Number = float | str  # mm, deg, rad/s as in the file; or a text with a unit
Point = tuple[float, float]

_M = TypeVar("_M", bound=Mechanism)
_Value = TypeVar("_Value")

_PLAIN_TABLES = ("frame", "links", "sketch", "scales")
_TABLES_OF_MANY = ("slide", "gear", "roll", "cam", "driver", "pose")
_DRIVER_VALUES = ("angle", "at", "omega", "alpha", "velocity", "acceleration", "also")
_DIGITS = 12  # of mm and deg in the text of a mechanism at another position

_ONE_LINK = ("block", "guide", "wheel", "on", "link")


@frozen
class Builder(Generic[Made]):
    """The tables written so far. Every method gives a new one, so that mechanisms can share a beginning.

    The methods are the tables of the file, their keywords its keys; `from_` is `from`, and names with a prime go as
    `**{"DE'": 40}`. A table that is there gets further keys. `done()` reads it all and says what is wrong.

    >>> import graphkin
    >>> four_bar = (
    ...     graphkin.Mechanism.new("four-bar")
    ...     .fix(A=(0, 0), D=(60, 0))
    ...     .link(1, AB=20).link(3, DC=40)
    ...     .link(2, BC=50, BE=30, CBE=40, ccw="BCE")  # seen from above B, C, E run counter-clockwise
    ...     .drive("AB", angle=60, omega=10)
    ...     .sketch(C=(45, 38))
    ...     .asking("omega 3", "v E")
    ...     .done()
    ... )
    >>> graphkin.Drawing.of(four_bar).omega["3"]
    2.91596 rad/s
    """

    name: str
    document: Mapping[str, object]
    read: Callable[..., Made]

    def __repr__(self) -> str:
        return f"<Builder of {self.name}: {', '.join(self.document)}>"

    if not TYPE_CHECKING:  # which tells by itself

        def __getattr__(self, name: str) -> object:
            raise AttributeError(f"a builder has no {name!r}; `done()` gives the mechanism")

    def titled(self, en: str = "", zh: str = "", source: str = "") -> Self:
        """Its title in both languages, and its source."""
        title = {lang: text for lang, text in (("en", en), ("zh", zh)) if text}
        titled = self._extended("title", title) if title else self
        return titled._with({"source": source} if source else {})

    def fix(self, name: str | int | None = None, /, **points: Point) -> Self:
        """Fixed points (x, y) of the frame, and the frame's own name."""
        return self._extended("frame", {**({} if name is None else {"name": str(name)}), **points})

    def link(
        self, name: str | int, /, points: str | Sequence[str] | None = None, shape: Mapping[str, Point] | None = None,
        ccw: Sequence[str | Sequence[str]] | str | None = None, **measures: Number,
    ) -> Self:  # fmt: skip
        """A link by lengths and angles (`AB=24`, `BDE=90`, `ccw="BDE"`), by coordinates, or by its points alone."""
        table = {"points": _names(points), "shape": shape, **measures, "ccw": _names(ccw)}
        keys = {key: value for key, value in table.items() if value is not None}
        return self._extended("links", {str(name): {**_begun(_begun(self.document, "links"), str(name)), **keys}})

    def slide(self, **keys: object) -> Self:
        """A sliding pair: `block` and `point`, or `pin`, on a line of the `guide`."""
        return self._more("slide", keys)

    def gear(self, **keys: object) -> Self:
        """Two `links` in mesh: `centres`, pitch `radii`, `internal`."""
        return self._more("gear", keys)

    def roll(self, **keys: object) -> Self:
        """A `wheel` rolling `on` a line or a circle of a link."""
        return self._more("roll", keys)

    def cam(self, **keys: object) -> Self:
        """Two `links` that touch, with a profile each."""
        return self._more("cam", keys)

    def pose(self, **keys: object) -> Self:
        """A value that holds at the drawn position only."""
        return self._more("pose", keys)

    def drive(self, vector: str | None = None, **keys: object) -> Self:
        """A driver: a vector such as `"AB"` with `angle` and `omega`, or a wheel `link=`, or a `slide=` with `at=`."""
        return self._more("driver", {"vector": vector, **keys})

    def sketch(self, **points: Point) -> Self:
        """Roughly where moving points are [mm]: it picks the assembly."""
        return self._extended("sketch", points)

    def scales(self, **scales: float) -> Self:
        """Scales of the paper: `length` [m/mm], `velocity` [(m/s)/mm], `acceleration` [(m/s²)/mm]."""
        return self._extended("scales", scales)

    def asking(self, *quantities: str) -> Self:
        """The quantities that the problem asks for."""
        return self._with({"ask": [*self._listed("ask"), *quantities]})

    def to_toml(self) -> str:
        """The file so far."""
        return toml(self.document)

    def done(self) -> Made:
        """The mechanism. Raises what reading such a file raises; lines are those of `to_toml`."""
        return self.read(self.document, name=self.name)

    def _with(self, tables: Mapping[str, object]) -> Self:
        return replace(self, document={**self.document, **tables})

    def _extended(self, table: str, keys: Mapping[str, object]) -> Self:
        """More keys of a table that there is one of."""
        return self._with({table: {**_begun(self.document, table), **keys}})

    def _listed(self, name: str) -> list[object]:
        before = self.document.get(name, [])
        return before if isinstance(before, list) else []

    def _more(self, table: str, keys: Mapping[str, object]) -> Self:
        """One more table of a kind that there may be many of; links may be named by plain numbers: `guide=3`."""
        entry = {key.rstrip("_"): value for key, value in keys.items() if value is not None}
        entry |= {key: str(entry[key]) for key in _ONE_LINK if isinstance(entry.get(key), int)}
        if isinstance(links := entry.get("links"), Iterable):
            entry["links"] = [str(link) for link in links]
        if isinstance(centres := entry.get("centres"), str):
            entry["centres"] = _names(centres)
        return self._with({table: [*self._listed(table), entry]})


def _begun(tables: Mapping[str, object], name: str) -> Mapping[str, Any]:
    """The values that a table holds so far."""
    table = tables.get(name)
    return table if isinstance(table, Mapping) else {}


def _names(points: str | Sequence[object] | None) -> object:
    """`"BDE"` or `["B", "D", "E"]`: the names of points."""
    return list(split_points(points)) or [points] if isinstance(points, str) else points


def changed_text(mechanism: Mechanism, values: Mapping[str, object]) -> str:
    """The mechanism's file with other values, each named as `Mechanism.with_` says. Raises NoSuchValue for a name that
    means nothing in this file, or more than one thing."""
    return replaced_values(mechanism.text, places_of(mechanism, values))


def places_of(mechanism: Mechanism, values: Mapping[str, _Value]) -> dict[KeyPath, _Value]:
    """The values by their places in the file. Raises NoSuchValue."""
    return {_path(mechanism, tidy(str(name).strip())): value for name, value in values.items()}


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
        # its coordinates in the frame, in a link's shape, or in the sketch
        if ("frame", name) in mechanism.given:
            yield "frame", name
            return
        shapes = [path for path in mechanism.given if path[:1] == ("links",) and path[2:] == ("shape", name)]
        yield from shapes
        if ("sketch", name) in mechanism.given or (name in mechanism.points and not shapes):
            yield "sketch", name
    elif points := split_points(name):
        yield from (path for path in _measures(mechanism) if split_points(str(path[-1])) in (points, points[::-1]))
    else:
        yield from _of_item(mechanism, *name.partition(" ")[::2])


def _measures(mechanism: Mechanism) -> Iterator[KeyPath]:
    """The lengths and angles of links."""
    for path in mechanism.given:
        if len(path) == 3 and path[0] == "links" and len(split_points(str(path[2]))) > 1:
            yield path


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
