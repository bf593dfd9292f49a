"""A mechanism built in Python, table by table, as its file is written."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, Generic, Self, TypeVar

from graphkin.base.value import frozen
from graphkin.files.names import split_points
from graphkin.files.toml import toml

Made = TypeVar("Made")
"""What is built: whatever reads the tables says."""
Number = float | str
"""mm, deg, rad/s as in the file; or a text with a unit."""
Point = tuple[float, float]


@frozen
class Builder(Generic[Made]):
    """What is written so far. Every method gives a new one, so that mechanisms can share a beginning.

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
    document: Mapping[str, Any]
    read: Callable[..., Made]

    def titled(self, en: str = "", zh: str = "", source: str = "") -> Self:
        """What it is called, and where it is from."""
        title = {lang: text for lang, text in (("en", en), ("zh", zh)) if text}
        return self._with({**({"title": title} if title else {}), **({"source": source} if source else {})})

    def fix(self, name: str | int | None = None, /, **points: Point) -> Self:
        """Fixed points (x, y) of the frame, and the frame's own name."""
        named = {} if name is None else {"name": str(name)}
        return self._with({"frame": {**self.document.get("frame", {}), **named, **points}})

    def link(
        self, name: str | int, /, points: str | Sequence[str] | None = None, shape: Mapping[str, Point] | None = None,
        ccw: Sequence[Any] | str | None = None, **measures: Number,
    ) -> Self:  # fmt: skip
        """A link by lengths and angles (`AB=24`, `BDE=90`, `ccw="BDE"`), by coordinates, or by its points alone."""
        table = {"points": _names(points), "shape": shape, **measures, "ccw": _names(ccw)}
        return self._with({"links": {**self.document.get("links", {}), str(name): _there(table)}})

    def slide(self, **keys: Any) -> Self:
        """A sliding pair: `block` and `point`, or `pin`, on a line of the `guide`."""
        return self._more("slide", keys)

    def gear(self, **keys: Any) -> Self:
        """Two `links` in mesh: `centres`, pitch `radii`, `internal`."""
        return self._more("gear", keys)

    def roll(self, **keys: Any) -> Self:
        """A `wheel` rolling `on` a line or a circle of a link."""
        return self._more("roll", keys)

    def cam(self, **keys: Any) -> Self:
        """Two `links` that touch, with a profile each."""
        return self._more("cam", keys)

    def pose(self, **keys: Any) -> Self:
        """What stands how at the drawn position only."""
        return self._more("pose", keys)

    def drive(self, vector: str | None = None, **keys: Any) -> Self:
        """A driver: a vector such as `"AB"` with `angle` and `omega`, or a wheel `link=`, or a `slide=` with `at=`."""
        return self._more("driver", {"vector": vector, **keys})

    def sketch(self, **points: Point) -> Self:
        """Roughly where moving points are [mm]: it picks the assembly."""
        return self._with({"sketch": {**self.document.get("sketch", {}), **points}})

    def scales(self, **scales: float) -> Self:
        """Scales of the paper: `length` [m/mm], `velocity` [(m/s)/mm], `acceleration` [(m/s²)/mm]."""
        return self._with({"scales": {**self.document.get("scales", {}), **scales}})

    def asking(self, *quantities: str) -> Self:
        """What the problem wants."""
        return self._with({"ask": [*self.document.get("ask", []), *quantities]})

    def to_toml(self) -> str:
        """The file so far."""
        return toml(self.document)

    def done(self) -> Made:
        """The mechanism. Raises what reading such a file raises; lines are those of `to_toml`."""
        return self.read(self.document, name=self.name)

    def _with(self, tables: Mapping[str, Any]) -> Self:
        return replace(self, document={**self.document, **tables})

    def _more(self, table: str, keys: Mapping[str, Any]) -> Self:
        """One more table of a kind that there may be many of."""
        given = {key.rstrip("_"): _named(key, value) for key, value in keys.items() if value is not None}
        return self._with({table: [*self.document.get(table, []), given]})


_ONE_LINK = ("block", "guide", "wheel", "on", "link")


def _named(key: str, value: Any) -> Any:
    """Links may be named by plain numbers, as people write them: `guide=3`."""
    if key in _ONE_LINK and isinstance(value, int):
        return str(value)
    return [str(link) for link in value] if key == "links" else value


def _there(table: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in table.items() if value is not None}


def _names(points: str | Sequence[Any] | None) -> Any:
    """`"BDE"` or `["B", "D", "E"]`: the names of points."""
    return list(split_points(points)) or [points] if isinstance(points, str) else points
