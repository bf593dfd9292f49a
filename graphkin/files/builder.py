"""A mechanism built in Python, table by table, as its file is written."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Generic, Self, TypeVar

from graphkin.base.value import frozen
from graphkin.files.toml import toml
from graphkin.files.values import split_points

Made = TypeVar("Made")  # the type of what is built, given by whatever reads the tables
Number = float | str  # mm, deg, rad/s as in the file; or a text with a unit
Point = tuple[float, float]

_ONE_LINK = ("block", "guide", "wheel", "on", "link")


@frozen
class Builder(Generic[Made]):
    """The tables written so far. Every method gives a new one, so that mechanisms can share a beginning.

    The methods are the tables of the file, their keywords its keys; `from_` is `from`, and names with a prime go as
    `**{"DE'": 40}`. `done()` reads it all and says what is wrong.

    >>> import graphkin
    >>> four_bar = (
    ...     graphkin.Mechanism.new("four-bar")
    ...     .fix(A=(0, 0), D=(60, 0))
    ...     .link(1, AB=20).link(2, BC=50).link(3, DC=40)
    ...     .drive("AB", angle=60, omega=10)
    ...     .sketch(C=(45, 38))
    ...     .asking("omega 3", "v C")
    ...     .done()
    ... )
    >>> graphkin.Drawing.of(four_bar).omega["3"]
    2.91596 rad/s
    """

    name: str
    document: Mapping[str, object]
    read: Callable[..., Made]

    def titled(self, en: str = "", zh: str = "", source: str = "") -> Self:
        """Its title in both languages, and its source."""
        title = {lang: text for lang, text in (("en", en), ("zh", zh)) if text}
        return self._with({**({"title": title} if title else {}), **({"source": source} if source else {})})

    def fix(self, name: str | int | None = None, /, **points: Point) -> Self:
        """Fixed points (x, y) of the frame, and the frame's own name."""
        return self._extended("frame", {**({} if name is None else {"name": str(name)}), **points})

    def link(
        self, name: str | int, /, points: str | Sequence[str] | None = None, shape: Mapping[str, Point] | None = None,
        ccw: Sequence[str | Sequence[str]] | str | None = None, **measures: Number,
    ) -> Self:  # fmt: skip
        """A link by lengths and angles (`AB=24`, `BDE=90`, `ccw="BDE"`), by coordinates, or by its points alone."""
        table = {"points": _names(points), "shape": shape, **measures, "ccw": _names(ccw)}
        return self._extended("links", {str(name): {key: value for key, value in table.items() if value is not None}})

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
        before = self.document.get(table, {})
        return self._with({table: {**(before if isinstance(before, Mapping) else {}), **keys}})

    def _listed(self, name: str) -> list[object]:
        before = self.document.get(name, [])
        return before if isinstance(before, list) else []

    def _more(self, table: str, keys: Mapping[str, object]) -> Self:
        """One more table of a kind that there may be many of."""
        entry = {key.rstrip("_"): _with_link_names(key, value) for key, value in keys.items() if value is not None}
        return self._with({table: [*self._listed(table), entry]})


def _with_link_names(key: str, value: object) -> object:
    """A key's value; links may be named by plain numbers, as people write them: `guide=3`."""
    if key in _ONE_LINK and isinstance(value, int):
        return str(value)
    return [str(link) for link in value] if key == "links" and isinstance(value, Iterable) else value


def _names(points: str | Sequence[object] | None) -> object:
    """`"BDE"` or `["B", "D", "E"]`: the names of points."""
    return list(split_points(points)) or [points] if isinstance(points, str) else points
