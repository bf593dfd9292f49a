"""Many mechanisms that differ in the numbers of their file: arrays where the file has a number.

What hangs on these numbers (links, lines of slides, drivers, the sketch) is worked out with arrays, table by table.
On some more hangs, and some mechanisms are on the verge of being refused: these are read one by one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial
from itertools import combinations
from typing import Generic, TypeVar, cast

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import Array
from graphkin.base.value import filled
from graphkin.errors import GraphkinError, UnevenArrays, Where
from graphkin.files.links import OWN_KEYS
from graphkin.files.schema import File, read_tables
from graphkin.files.toml import parsed, replaced_values
from graphkin.files.values import LARGEST, LARGEST_ANGLE, SMALLEST_LENGTH, UNITS, split_points, tidy
from graphkin.model.mechanism import FRAME, Driver, KeyPath, Link, Mechanism
from graphkin.model.pairs import Slide

Made = TypeVar("Made", bound=Mechanism)
_Used = TypeVar("_Used")
Built = Callable[[Sequence[Array]], tuple[Mechanism, Callable[[], Array]]]
"""Of numbers, arrays or what calculates as they do, the mechanism, and what tells where it is sure to be one."""
MUCH = 1e3  # lengths so many times longer or shorter than those of the pattern are looked at one by one
FLAT = 1e-6  # so are triangles flatter than this
TRIED = 20  # mechanisms that are read until one does as a pattern


class OneByOne(Exception):
    """More hangs on a number than is worked out with arrays: each mechanism is made by itself."""


@filled
class Variants(Generic[Made]):
    """Mechanisms of one file with other numbers in it, as `Mechanism.variants` makes them: `variants[k]` is one of
    them. `replay`, `motion`, `sweep`, `sweep_many` and `solve_many` take all of them at once.

    >>> import graphkin
    >>> graphkin.replay(graphkin.load("ex3-1").variants(AB=[20, 24, 28])).omega["3"].round(3)
    array([-3.273, -3.919, -4.514])
    """

    mechanism: Made
    parts: Mapping[KeyPath, list[tuple[KeyPath, object]]]
    count: int
    read: Callable[..., Made]

    @classmethod
    def of(cls, mechanism: Made, values: Mapping[KeyPath, object], read: Callable[..., Made]) -> Variants[Made]:
        """Arrays (n,), or one value for all, by place. Raises UnevenArrays."""
        parts = {path: parts_of(mechanism, path, value) for path, value in values.items()}
        each = (part for value in parts.values() for _, part in value)
        counts = {len(part) for part in each if isinstance(part, np.ndarray)} or {1}
        if len(counts) > 1 or counts == {0}:
            raise UnevenArrays(Where(mechanism.file), tuple(sorted(counts)))
        return cls(mechanism, parts, counts.pop(), read)

    def __len__(self) -> int:
        return self.count

    def reader(self, row: int) -> partial[Made]:
        """Reads one of them when it is called."""
        if not -self.count <= row < self.count:
            raise IndexError(row)
        values = {path: _at(parts[0][1], row) if parts[0][0] == path else [_at(part, row) for _, part in parts]
                  for path, parts in self.parts.items()}  # fmt: skip
        text = replaced_values(self.mechanism.text, values)
        return partial(self.read, text, name=self.mechanism.name, file=self.mechanism.file)

    def __getitem__(self, row: int) -> Made:
        return self.reader(row)()

    def __iter__(self) -> Iterator[Made]:
        return (self[row] for row in range(self.count))

    def __repr__(self) -> str:
        names = ", ".join(".".join(map(str, path)) for path in self.parts)
        return f"<Variants of {self.mechanism.name}: {self.count} mechanisms, other {names}>"

    def first(self, use: Callable[[Made], _Used]) -> _Used:
        """The outcome of a use for the first that it does not refuse. Raises its refusal of the very first."""
        problem: GraphkinError | None = None
        for row in range(min(self.count, TRIED)):
            try:
                return use(self[row])
            except GraphkinError as error:
                problem = problem or error
        assert problem is not None
        raise problem

    @cached_property
    def pattern(self) -> Made:
        """The first that can be read, of some. Raises what is wrong with the very first."""
        return self.first(lambda made: made)

    @cached_property
    def columns(self) -> dict[KeyPath, Array]:
        """The numbers that differ (n,) each [SI], by their places: one that no file has where more hangs on them."""
        each = (part for parts in self.parts.values() for part in parts)
        try:
            return {place: in_si(self.pattern, place, part) for place, part in each if isinstance(part, np.ndarray)}
        except OneByOne:
            return {("",): np.empty(0)}

    @cached_property
    def built(self) -> Built:
        """Of one number for each column the mechanism; raises OneByOne."""
        return partial(built, self.pattern, [*self.columns])


def built(base: Mechanism, places: Sequence[KeyPath], values: Sequence[Array]) -> tuple[Mechanism, Callable[[], Array]]:
    """A mechanism with other numbers at places of its file, and what tells where that is sure to be one: the classes of
    a mechanism declare numbers, and arrays stand in their place. Raises OneByOne."""
    file = _WithNumbers(base, places, values)
    with np.errstate(all="ignore"):
        mechanism = file.mechanism()
    return mechanism, partial(file.sure, mechanism)


def in_si(mechanism: Mechanism, place: KeyPath, value: object) -> Array:
    """Numbers of a file in SI. Raises OneByOne for what is no number there."""
    given, numbers = mechanism.given.get(place), np.asarray(value)
    if given is None or given.dimension is None or numbers.dtype.kind not in "fiu":
        raise OneByOne
    times, divided = next(iter(UNITS[given.dimension].values()))
    return numbers.astype(float) * times / divided


def within(mechanism: Mechanism, place: KeyPath, values: Array) -> Array:
    """True of numbers [SI] that the file may have there; a length is not to be much longer or shorter than it is."""
    dimension, own = mechanism.given[place].dimension, mechanism.given[place].si or 0.0
    low, high = -LARGEST, LARGEST
    if dimension == "angle":
        low, high = (0.0, np.pi) if place[0] == "links" else (-LARGEST_ANGLE, LARGEST_ANGLE)
    elif place[0] == "links" and len(place) == 3:
        low, high = max(own / MUCH, SMALLEST_LENGTH), own * MUCH
    elif dimension == "length":
        low, high = -MUCH * mechanism.usual.length, MUCH * mechanism.usual.length
    return (low <= values) & (values <= high)


def parts_of(mechanism: Mechanism, path: KeyPath, value: object) -> list[tuple[KeyPath, object]]:
    """Each an array (n,) or a single value; of a list in the file, as of a place (x, y), one after another."""
    given = mechanism.given.get(path)
    place = (path[0] in ("frame", "sketch") and len(path) == 2) or (path[2:3] == ("shape",) and len(path) == 4)
    if not place and not isinstance(getattr(given, "written", None), list):
        return [(path, _array(value))]
    if isinstance(value, complex | np.ndarray) and np.iscomplexobj(value):
        value = (value.real, value.imag)
    columns = np.moveaxis(value, -1, 0) if isinstance(value, np.ndarray) else value
    if not isinstance(columns, list | tuple | np.ndarray):
        return [(path, value)]
    return [((*path, k), _array(column)) for k, column in enumerate(columns)]


def _array(value: object) -> object:
    if isinstance(value, str) or not np.ndim(value):  # type: ignore[arg-type]
        return value[()] if isinstance(value, np.ndarray) else value
    return np.asarray(value)


def _at(part: object, row: int) -> object:
    return part[row] if isinstance(part, np.ndarray) else part


@kept(8)
def _tables(base: Mechanism) -> File:
    return read_tables(parsed(base.text))


class _WithNumbers:
    """The tables of a mechanism's file with other numbers. Raises OneByOne where more hangs on them."""

    def __init__(self, base: Mechanism, places: Sequence[KeyPath], values: Sequence[Array]) -> None:
        self.base, self.numbers, self.file = base, dict(zip(places, values)), _tables(base)
        self.touched = {path[:n] for path in places for n in range(len(path) + 1)}
        tables = {path[0] for path in places} <= {"frame", "links", "slide", "driver", "sketch"}
        plain = all(type(pair) is Slide for pair in base.pairs) and not base.poses
        if not tables or not plain or not self.numbers.keys() <= base.given.keys():
            raise OneByOne

    def mechanism(self) -> Mechanism:
        """All of it but its text."""
        links = {name: Link(name, self._points(name)) for name in self.base.links}
        pairs = tuple(self._slide(k, pair, links) for k, pair in enumerate(self.base.slides))
        drivers = tuple(self._driver(k, driver, links) for k, driver in enumerate(self.base.drivers))
        sketch = {point: self._place(z, "sketch", point) for point, z in self.base.sketch.items()}
        return replace(self.base, links=links, pairs=pairs, drivers=drivers, sketch=sketch)

    def sure(self, mechanism: Mechanism) -> Array:
        """True where every number is one that the file may have, links run the right way round, and all is finite."""
        sure = [within(self.base, *number) for number in self.numbers.items()]
        for name, table in self.file.links.items():
            for triple in (table.ccw or ()) if ("links", tidy(name)) in self.touched else ():
                a, b, c = (mechanism.links[tidy(name)].points[tidy(point)] for point in triple)
                sure.append(np.asarray(((b - a).conjugate() * (c - a)).imag > FLAT * np.abs(b - a) * np.abs(c - a)))
        made: list[complex] = [z for link in mechanism.links.values() for z in link.points.values()]
        made += [slide.line.direction for slide in mechanism.slides]
        made += [rate for driver in mechanism.drivers for rate in (driver.rate, driver.acceleration)]
        return np.asarray(np.logical_and.reduce(np.broadcast_arrays(*sure, *map(np.isfinite, made))))

    def _number(self, *path: str | int) -> Array | None:
        """The number at a place [SI]; None where the file has none."""
        given = self.base.given.get(path)
        return self.numbers[path] if path in self.numbers else cast(Array | None, given and given.si)

    def _place(self, z: complex, *path: str | int) -> complex:
        """The place of a point [m]."""
        return self._coordinates(*path) if path in self.touched else z

    def _coordinates(self, *path: str | int) -> complex:
        x, y = self._number(*path, 0), self._number(*path, 1)
        if x is None or y is None:
            raise OneByOne
        return cast(complex, x + 1j * y)

    def _points(self, name: str) -> dict[str, complex]:
        """The points of a link in its own axes."""
        base = self.base.links[name].points
        if name == FRAME:
            starts = {pair.line.origin: ("slide", k, "through") for k, pair in enumerate(self.base.slides)}
            paths = {p: starts[p] if p in self.base.unnamed else (name, p) for p in base}
            return {p: self._place(z, *paths[p]) for p, z in base.items()}
        if ("links", name) not in self.touched:
            return dict(base)
        if ("links", name, "shape") in self.touched:
            return _in_own_axes({p: self._coordinates("links", name, "shape", p) for p in base}, base)
        keys = [path for path in self.base.given if path[:2] == ("links", name) and len(path) == 3]
        ends = {path: split_points(str(path[2])) for path in keys if path[2] not in OWN_KEYS}
        return _laid_out(base, {points: cast(Array, self._number(*path)) for path, points in ends.items()})

    def _slide(self, k: int, pair: Slide, links: Mapping[str, Link]) -> Slide:
        """A slide with its direction in its guide's axes, and its tilt."""
        table, line, guide = self.file.slide[k], pair.line, links[pair.line.link]
        path, direction, tilt = ("slide", k), line.direction, self._number("slide", k, "tilt")
        if line.link != FRAME and len(guide.points) == 1:
            if table.from_ is not None or table.angle is not None:
                raise OneByOne
        elif self.touched & {path, ("links", line.link), ("frame",)}:
            angle = self._number(*path, "angle")
            turn = 1 + 0j if angle is None else np.exp(1j * angle)
            along = (line.origin, table.toward) if table.toward is not None else table.from_
            direction = cast(complex, turn if along is None else _along(guide.arm(*along)) * turn)
        return replace(pair, line=replace(line, direction=direction), tilt=0.0 if tilt is None else cast(float, tilt))

    def _driver(self, k: int, driver: Driver, links: Mapping[str, Link]) -> Driver:
        """A driver with its value and its rates, of a vector by the length of that."""
        value, rates = self._number("driver", k, "at" if driver.kind == "slide" else "angle"), []
        for turning, moving in (("omega", "velocity"), ("alpha", "acceleration")):
            rate, tip = self._number("driver", k, turning), self._number("driver", k, moving)
            if rate is None and tip is not None:
                rate = tip if driver.vector is None else tip / np.abs(links[driver.link].arm(*driver.vector))
            rates.append(cast(float, 0.0 if rate is None else rate))
        return replace(driver, value=cast(float | None, value), rate=rates[0], acceleration=rates[1])


def _laid_out(base: Mapping[str, complex], measures: Mapping[tuple[str, ...], Array]) -> dict[str, complex]:
    """Points of a link by lengths, and angles between two of them: each at its distances from two others. Raises
    OneByOne for what other angles give, or more measures than these."""
    lengths = {frozenset(points): value for points, value in measures.items() if len(points) == 2}
    for (one, vertex, other), angle in ((points, value) for points, value in measures.items() if len(points) == 3):
        arms = frozenset((one, vertex)), frozenset((vertex, other))
        if not lengths.keys() >= {*arms} or frozenset((one, other)) in lengths:
            raise OneByOne
        near, far = (lengths[arm] for arm in arms)
        lengths[frozenset((one, other))] = np.sqrt(near * near + far * far - 2 * near * far * np.exp(1j * angle).real)
    first, second, *waiting = base
    apart = lengths.get(frozenset((first, second)))
    if apart is None or len(measures) != 2 * len(base) - 3:
        raise OneByOne
    points = {first: apart * 0j, second: apart + 0j}
    while waiting:
        found = ((third, one, other) for third in waiting for one, other in combinations(points, 2)
                 if lengths.keys() >= {frozenset((one, third)), frozenset((other, third))})  # fmt: skip
        third, one, other = next(found, ("",) * 3)
        if not third:
            raise OneByOne
        arm = (base[third] - base[one]) / (base[other] - base[one])
        if abs(arm.imag) < FLAT * abs(arm):
            raise OneByOne
        off = points[other] - points[one]
        along, far, near = np.abs(off), lengths[frozenset((one, third))], lengths[frozenset((other, third))]
        x = (along * along + far * far - near * near) / (2 * along)
        points[third] = points[one] + off / along * (x + np.sign(arm.imag) * 1j * np.sqrt((far - x) * (far + x)))
        waiting.remove(third)
    return cast(dict[str, complex], {point: points[point] for point in base})


def _in_own_axes(places: Mapping[str, complex], base: Mapping[str, complex]) -> dict[str, complex]:
    """The same figure with its first point in the origin, and on +x the point that lies there in the pattern."""
    first = next(iter(base))
    axis = next((point for point in base if abs(base[point]) > FLAT * max(map(abs, base.values()))), first)
    arms = {point: places[point] - places[first] for point in base}
    turn = _along(arms[axis]).conjugate()
    return {point: np.abs(arm) + 0j if point == axis else arm * turn for point, arm in arms.items()}


def _along(arm: complex) -> complex:
    """The unit vector of a direction: exactly 1 of one along +x, as that of a single number is."""
    length = np.abs(arm)
    return cast(complex, arm.real / length + 1j * (arm.imag / length))
