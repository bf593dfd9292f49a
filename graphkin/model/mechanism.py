"""The machine as data: links, pairs, drivers. Frozen, in SI units, and without a position.

A link's axes have their origin in its first point and their x axis towards its second (as the file
writes them), so the angle of a link, `theta`, is the direction of its first two points. A block of one
point takes its axis from its guide's line, a guide of one point is its own line where no angle is said.
The frame's axes are the world's.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cached_property
from typing import Literal, TypeAlias, TypeVar

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.errors import Lang, Where
from graphkin.model.pairs import Pair, Revolute, Slide, Slot, start_name

KeyPath: TypeAlias = tuple[str | int, ...]
"""The place of a key in a mechanism file, from the top: `("slide", 0, "angle")`; primes in names are typed ones."""

Dimension = Literal["length", "angle", "angular velocity", "angular acceleration", "velocity", "acceleration"]

FRAME = "frame"  # the fixed link's own name in every mapping by link; `Mechanism.frame` is what people call it
EQUATIONS: Mapping[Literal["velocity", "acceleration"], str] = {
    "velocity": "equations velocity", "acceleration": "equations acceleration",
}  # fmt: skip
"""Names of a plane's vector equations where points are given for them."""

_Kind = TypeVar("_Kind", bound=Pair)


@frozen
class Link:
    """A rigid body: where its points are in its own axes [m].

    stands_for  the pair that it replaces, in a lower-pair equivalent
    """

    name: str
    points: Mapping[str, complex]
    stands_for: Pair | None = None

    def arm(self, tail: str, head: str) -> complex:
        """The vector tail -> head in the link's axes [m]."""
        return self.points[head] - self.points[tail]

    @property
    def axis(self) -> tuple[str, str] | None:
        """The first point, and the next that is elsewhere: between them the link's angle is measured."""
        first = next(iter(self.points), "")
        size = max((abs(self.arm(first, point)) for point in self.points), default=0.0)
        return next(((first, point) for point in self.points if abs(self.arm(first, point)) > 1e-9 * size), None)


@frozen
class Driver:
    """One `[[driver]]`.

    kind    "angle": the direction `vector` of `link` (against `from_vector` of `from_link`, else +x) is `value`;
            "spin": a wheel `link` whose direction does not matter; "slide": displacement of the slide `link`
    value   at the drawn position [rad or m]; None where the file leaves it to a pose
    rate, acceleration   [rad/s, rad/s^2 or m/s, m/s^2]
    also    further values the problem asks for [rad or m]
    """

    kind: str
    link: str
    vector: tuple[str, str] | None = None
    from_link: str = FRAME
    from_vector: tuple[str, str] | None = None
    value: float | None = None
    rate: float = 0.0
    acceleration: float = 0.0
    also: tuple[float, ...] = ()

    @property
    def name(self) -> str:
        """Its name: `AB`, `BC/BA`, or the slide's or the wheel's name."""
        if self.vector is None:
            return self.link
        tail = "" if self.from_vector is None else "/" + "".join(self.from_vector)
        return "".join(self.vector) + tail


@frozen
class Pose:
    """One `[[pose]]`: holds at the drawn position only; read like a driver's value."""

    kind: str
    link: str
    value: float
    vector: tuple[str, str] | None = None
    from_link: str = FRAME
    from_vector: tuple[str, str] | None = None


@frozen
class GivenValue:
    """One value that a mechanism's file states.

    path       its place, as `with_` names it with dots between: ("links", "2", "AB"), ("driver", 0, "angle")
    written    the value as the file has it: a number, a text, a list, a table
    dimension  what a number, or a text with a unit, measures there; None where it is no quantity
    si         the quantity in SI [m, rad, rad/s, ..]
    """

    path: KeyPath
    written: object
    dimension: Dimension | None = None
    si: float | None = None


ROUNDING = 1e-7
"""Sizes below this part of what is usual of their kind are rounding noise: an angle typed to five decimals of a degree,
or a length to a hundred thousandth of a millimetre, says no more."""

Rates = Sequence[tuple[float, float]]  # of drivers: velocity and acceleration


@frozen
class Usual:
    """Sizes that are usual in a mechanism, by what its drivers do: length [m], omega [rad/s], alpha [rad/s^2]."""

    length: float
    omega: float
    alpha: float

    @classmethod
    def of(cls, length: float, turning: Rates, sliding: Rates) -> Usual:
        rates = [*turning, *((speed / length, more / length) for speed, more in sliding)]
        omega = max((abs(rate) for rate, _ in rates), default=0.0)
        return cls(length, omega, max([omega**2, *(abs(more) for _, more in rates)]))

    def size(self, unit: str) -> float:
        """Of quantities of an SI unit; 1 of angles and plain numbers."""
        speed, more = self.omega * self.length, self.alpha * self.length
        kinds = {"m": self.length, "m/s": speed, "m/s^2": more, "rad/s": self.omega, "rad/s^2": self.alpha}
        return kinds.get(unit, 1.0)

    def least(self, unit: str) -> float:
        """Sizes up to this are rounding noise [SI]."""
        return ROUNDING * self.size(unit)

    def rate(self, value: Value, plane: str) -> Value:
        """omega or alpha, as the plane has it, without noise."""
        return self.cut(value, "rad/s" if plane == "velocity" else "rad/s^2")

    def motion(self, value: Value, plane: str) -> Value:
        """A velocity or an acceleration, as the plane has it, without noise."""
        return self.cut(value, "m/s" if plane == "velocity" else "m/s^2")

    def cut(self, value: Value, unit: str) -> Value:
        """A value [SI]; 0 where it is but rounding noise, of a vector in each part."""
        clean = np.array(value, dtype=complex if np.iscomplexobj(value) else float, ndmin=1)
        parts = clean.view(float)
        parts[np.abs(parts) <= self.least(unit)] = 0.0
        return clean.reshape(np.shape(value)) if np.ndim(value) else clean.item()


@frozen
class Mechanism:
    """A planar mechanism.

    links     by name; `FRAME` comes first, then as in the file
    pairs     those of the file's tables, kind by kind as in `PAIRS`; hinges are shared points and stand in `hinges`
    sketch    roughly where moving points are [m]
    slide_titles  what sliding pairs are called in sentences, by name
    replaced  the pairs of the file for which others stand, in a lower-pair equivalent
    scales    given paper scales: "length" [m/mm], "velocity" [(m/s)/mm], "acceleration" [(m/s^2)/mm]
    text      the file, to be put into drawings and shown; `lines` gives the line of each of its keys
    given     what the file states, by place and in its order: tables and lists, each followed by what is in it
    worth     points of an answer, by question; follows: the part of them where it follows rightly from a wrong one
    stories   the words of a problem that stand before what is given
    """

    name: str
    frame: str
    links: Mapping[str, Link]
    pairs: tuple[Pair, ...] = ()
    drivers: tuple[Driver, ...] = ()
    poses: tuple[Pose, ...] = ()
    sketch: Mapping[str, complex] = field(default_factory=dict)
    scales: Mapping[str, float] = field(default_factory=dict)
    title: Mapping[Lang, str] = field(default_factory=dict)
    source: Mapping[Lang, str] = field(default_factory=dict)
    ask: tuple[str, ...] = ()
    text: str = ""
    file: str = ""
    lines: Mapping[KeyPath, int] = field(default_factory=dict)
    replaced: tuple[Pair, ...] = ()
    slide_titles: Mapping[str, Mapping[Lang, str]] = field(default_factory=dict)
    given: Mapping[KeyPath, GivenValue] = field(default_factory=dict)
    worth: Mapping[str, float] = field(default_factory=dict)
    follows: float = 1.0
    stories: Mapping[Lang, str] = field(default_factory=dict)

    @cached_property
    def owners(self) -> dict[str, tuple[str, ...]]:
        """The links each point belongs to, in the order of the links (pseudo-points of lines included)."""
        owners: dict[str, tuple[str, ...]] = {}
        for link in self.links.values():
            for point in link.points:
                owners[point] = (*owners.get(point, ()), link.name)
        return owners

    @cached_property
    def unnamed(self) -> frozenset[str]:
        """The points that nobody named: where lines of the frame begin that are given by coordinates, or slots that
        stand for a contact."""
        pairs = (*self.pairs, *self.replaced)
        starts = {start_name(pair) for pair in pairs if isinstance(pair.equivalent, Slot)}
        return frozenset(line.origin for pair in pairs for line in pair.lines if not line.named) | starts

    @cached_property
    def points(self) -> tuple[str, ...]:
        """The points people named, fixed ones first."""
        return tuple(point for point in self.owners if point not in self.unnamed)

    @cached_property
    def most_primes(self) -> int:
        """The number of primes of the point that has most."""
        return max((len(point) - len(point.rstrip("'")) for point in self.points), default=0)

    def named(self, link: str) -> tuple[str, ...]:
        """The points of a link that people named."""
        return tuple(point for point in self.links[link].points if point not in self.unnamed)

    @cached_property
    def hinges(self) -> tuple[Revolute, ...]:
        return tuple(Revolute(point, links) for point, links in self.owners.items() if len(links) > 1)

    @cached_property
    def slides(self) -> tuple[Slide, ...]:
        return self.of(Slide)

    def of(self, kind: type[_Kind]) -> tuple[_Kind, ...]:
        """The pairs of one kind."""
        return tuple(pair for pair in self.pairs if isinstance(pair, kind))

    @cached_property
    def moving(self) -> tuple[str, ...]:
        """Every link but the frame."""
        return tuple(name for name in self.links if name != FRAME)

    @cached_property
    def idle(self) -> tuple[str, ...]:
        """Links of one point that may turn without moving anything (局部自由度): rollers."""
        pairs = (*self.pairs, *self.replaced)
        tied = {line.link for pair in pairs for line in pair.lines} | {slide.block for slide in self.slides}
        tied |= {wheel for pair in pairs if pair.rolling is not None for wheel in pair.rolling.wheels}
        tied |= {name for driver in self.drivers for name in (driver.link, driver.from_link)}
        return tuple(name for name in self.moving if len(self.links[name].points) == 1 and name not in tied)

    @cached_property
    def usual(self) -> Usual:
        """The usual sizes of its quantities."""
        arms = (link.arm(next(iter(link.points)), point) for link in self.links.values() for point in link.points)
        reach = max(map(abs, arms), default=0.0)
        turning, sliding = ([(d.rate, d.acceleration) for d in self.drivers if (d.kind == "slide") is slides]
                            for slides in (False, True))  # fmt: skip
        return Usual.of(reach or 1.0, turning, sliding)

    def called(self, link: str) -> str:
        """The name people use for a link: the frame has a number of its own."""
        return self.frame if link == FRAME else link

    def headline(self, lang: Lang) -> str:
        """The title in this language, else in the other, else the name."""
        return _spoken(self.title, lang) or self.name

    def credit(self, lang: Lang) -> str:
        """Its source, in this language, else in the other."""
        return _spoken(self.source, lang)

    def story(self, lang: Lang) -> str:
        """The text before the data, in this language, else in the other."""
        return _spoken(self.stories, lang)

    @cached_property
    def driven(self) -> frozenset[str]:
        """The links that drivers turn against the frame."""
        return frozenset(driver.link for driver in self.drivers if driver.kind == "angle" and driver.from_link == FRAME)

    @property
    def pushed(self) -> tuple[tuple[str, str], ...]:
        """A driven link and one that it pushes in sliding contact, or by its roller, where both are joined to the
        frame."""
        joined = {link for owners in self.owners.values() if FRAME in owners for link in owners}
        joined |= {slide.block for slide in self.slides if slide.guide == FRAME and slide.block is not None}
        cams = (tuple(map(self._bearer, pair.joins)) for pair in self.pairs if pair.table == "cam")
        pairs = (ends for links in cams for ends in (links, links[::-1]))
        return tuple((one, other) for one, other in pairs if one in self.driven and {one, other} <= joined)

    def _bearer(self, link: str) -> str:
        """The link on which an idle roller turns; any other is its own."""
        points = self.links[link].points if link in self.idle else ()
        return next((other for point in points for other in self.owners[point] if other != link), link)

    def slide_title(self, name: str, lang: Lang) -> str:
        """The title of a sliding pair, in this language, else its name."""
        return _spoken(self.slide_titles.get(name, {}), lang) or name

    def driver_title(self, driver: Driver, lang: Lang) -> str:
        """The name of a driver for people: `AB`, a wheel's name, the title of a slide."""
        return self.slide_title(driver.link, lang) if driver.kind == "slide" else driver.name

    def pair(self, name: str) -> Pair:
        return next(pair for pair in self.pairs if pair.name == name)

    def path(self, pair: Pair) -> tuple[str, int]:
        """The place of a pair in the file: its table, and its number there."""
        return pair.table, [other.name for other in self.pairs if other.table == pair.table].index(pair.name)

    def where(self, *path: str | int) -> Where:
        """The place of a key in the file, or of the nearest key above it that the file has."""
        key = ".".join(str(part) for part in path)
        for end in range(len(path), 0, -1):
            if path[:end] in self.lines:
                return Where(self.file, self.lines[path[:end]], key)
        return Where(self.file, None, key)


def _spoken(texts: Mapping[Lang, str], lang: Lang) -> str:
    """The text in this language, else in the other, if there is one."""
    return texts.get(lang) or next(iter(texts.values()), "")
