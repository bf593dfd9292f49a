"""Another link as frame: the same links and pairs at the same position, seen from another of them; as a file, too.

The same pair stays driven. Where it does not lie at the new frame, the motor rides on a moving link and the
driver's angle is counted from that link.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from graphkin.analytic import Motion, motion
from graphkin.base.geometry import number
from graphkin.base.geometry import place as place_of
from graphkin.errors import NoFixing
from graphkin.files.toml import toml
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.pairs import Slide
from graphkin.studies.linkages.assembled import ahead_on, assembled, drawn_line, free_names


def inverted(mechanism: Mechanism, link: str) -> Mechanism:
    """The mechanism, without a title, with another link (as people call it) held fast.

    Positions stay where they are drawn; the old frame becomes a moving link of its own name. Mechanisms with gears,
    rolling or cams are not inverted. Raises NoFixing.
    """
    possible = mechanism.moving if len(mechanism.slides) == len(mechanism.pairs) else ()
    if link not in possible:
        raise NoFixing(mechanism.where("links"), link, possible)
    return _Inversion(mechanism, link).machine()


class _Inversion:
    """Gathers the new mechanism: links by their names there, at their drawn places."""

    def __init__(self, mechanism: Mechanism, fixed: str) -> None:
        self.old, self.fixed = mechanism, fixed
        self.now: Motion = motion(mechanism)
        self.names = self._renamed()
        self.points = {
            name: {self.names[p]: self._place(p, name) for p in link.points} for name, link in mechanism.links.items()
        }
        places = (z for link in mechanism.links.values() for z in link.points.values())
        self.reach = max(map(abs, places), default=0.0) or 0.05

    def _renamed(self) -> dict[str, str]:
        """Points of lines, which had no name of their own, get one: that of a point of the link at the same place."""
        names = {point: point for point in self.old.owners}
        nameless = [(p, link) for link in self.old.links.values() for p in link.points if p in self.old.unnamed]
        for (point, link), fresh in zip(nameless, free_names(self.old.owners, len(nameless))):
            size = max(abs(z) for z in link.points.values()) or 1.0
            same = (p for p in self.old.named(link.name) if abs(link.points[p] - link.points[point]) < 1e-12 * size)
            names[point] = next(same, fresh)
        return names

    def _place(self, point: str, link: str) -> complex:
        """The place of a point of a link, points of lines included [m]."""
        if point in self.now.position:
            return place_of(self.now.position[point])
        points = self.old.links[link].points
        base = next((p for p in points if p in self.now.position), None)
        if link == FRAME or base is None:
            return points[point]
        turn = cmath.rect(1, number(self.now.theta[link]))
        return place_of(self.now.position[base]) + (points[point] - points[base]) * turn

    def called(self, link: str) -> str:
        """A link's name in the new mechanism."""
        return FRAME if link == self.fixed else self.old.called(link)

    def machine(self) -> Mechanism:
        for slide in self.old.slides:  # a line of a moving link goes towards a point of it: one is added for none
            points, origin, along = self.points[slide.guide], self.names[slide.line.origin], self.now.along(slide.line)
            if slide.guide != self.fixed and not ahead_on(points, origin, along):
                ahead = ((place_of(self.now.position[slide.point]) - points[origin]) * along.conjugate()).real
                self._added(slide.guide, points[origin] + along * max(ahead, 0.25 * self.reach))
        drivers = tuple(self._driver(driver) for driver in self.old.drivers)
        order = sorted(self.points, key=lambda name: (name != self.fixed, name == FRAME))
        links = {self.called(name): self.points[name] for name in order}
        slides = []
        for slide in self.old.slides:
            guide, block = self.called(slide.guide), None if slide.block is None else self.called(slide.block)
            line = drawn_line(links, guide, self.names[slide.line.origin], self.now.along(slide.line))
            tilt, point = self._tilt(slide), self.names[slide.point]
            slides.append(replace(slide, line=line, point=point, block=block, tilt=tilt))
        return assembled(self.fixed, links, tuple(slides), drivers, self.old.scales.get("length"))

    def _added(self, link: str, place: complex) -> str:
        """The name of a point that a link gets at a place."""
        name = free_names({point for points in self.points.values() for point in points} | set(self.old.owners), 1)[0]
        self.points[link][name] = place
        return name

    def _tilt(self, slide: Slide) -> float:
        """Angle from the line to the block's own direction; a block of one point has that of its first line."""
        if slide.block is None:
            return 0.0
        line = cmath.phase(self.now.along(slide.line))
        if slide.block == self.fixed:
            return _wrapped(-line)
        places = list(self.points[slide.block].values())
        if len(places) > 1:
            return _wrapped(cmath.phase(places[1] - places[0]) - line)
        first = next(other for other in self.old.slides if other.block == slide.block)
        return _wrapped(cmath.phase(self.now.along(first.line)) - line)

    def _driver(self, driver: Driver) -> Driver:
        if driver.kind == "slide":
            at = self.now.values[self.old.drivers.index(driver)]
            return replace(driver, value=number(at), also=())
        one, other, sense = driver.link, driver.from_link, 1.0
        if one == self.fixed:
            one, other, sense = other, one, -1.0
        vector = self._vector(one, driver.vector if one == driver.link else driver.from_vector)
        turned, start = self._direction(one, vector), None
        if other != self.fixed:
            start = self._vector(other, driver.from_vector if other == driver.from_link else driver.vector)
            turned -= self._direction(other, start)
        return Driver(
            "angle", self.called(one), vector, self.called(other), start, _wrapped(turned), sense * driver.rate,
            sense * driver.acceleration,
        )  # fmt: skip

    def _vector(self, link: str, vector: tuple[str, str] | None) -> tuple[str, str]:
        """Two points of a link; one is added where it has no two."""
        if vector is not None:
            return vector
        points = self.points[link]
        if not points:
            self._added(link, 0j)
        first = next(iter(points))
        apart = (point for point, place in points.items() if abs(place - points[first]) > 1e-6 * self.reach)
        second = next(apart, "") or self._added(link, points[first] + self.reach)
        return first, second

    def _direction(self, link: str, vector: tuple[str, str]) -> float:
        tail, head = (self.points[link][self.names.get(p, p)] for p in vector)
        return cmath.phase(head - tail)


def _wrapped(angle: float) -> float:
    return math.remainder(angle, math.tau)


# --- a mechanism of links, slides and drivers as a file ---------------------------------------------------------------


def filed(machine: Mechanism, notes: Sequence[str] = ()) -> Mechanism:
    """The mechanism with its file as its text; notes: lines at the head of the file."""
    return replace(machine, text="".join(f"# {note}\n" for note in notes) + toml(_document(machine)))


def _document(machine: Mechanism) -> dict[str, object]:
    named, fixed = set(machine.points), machine.links[FRAME].points
    document: dict[str, object] = {
        "title": machine.title,
        "frame": {"name": machine.frame, **{point: _mm(place) for point, place in fixed.items() if point in named}},
        "links": {link: _link(machine.links[link].points) for link in machine.moving},
        "slide": [_slide(machine, slide) for slide in machine.slides],
        "driver": [_driver(driver) for driver in machine.drivers],
        "sketch": {point: _mm(place) for point, place in machine.sketch.items()},
        "scales": {"length": _plain(machine.scales["length"], 6)} if "length" in machine.scales else None,
    }
    return {name: table for name, table in document.items() if table}


def _link(points: Mapping[str, complex]) -> dict[str, object]:
    """One point is listed, two have a distance, more have coordinates in the link's axes."""
    names = list(points)
    if len(names) < 2:
        return {"points": names}
    if len(names) == 2:
        return {names[0] + names[1]: _mm(abs(points[names[1]] - points[names[0]]))}
    return {"shape": {name: _mm(place) for name, place in points.items()}}


def _slide(machine: Mechanism, slide: Slide) -> dict[str, object]:
    """A line of the frame has an angle to +x, one of another link goes towards a point of it."""
    table: dict[str, object] = {"name": slide.name} if slide.named else {}
    table |= {"pin": slide.point} if slide.block is None else {"block": slide.block, "point": slide.point}
    points, origin, along = machine.links[slide.guide].points, slide.line.origin, slide.line.direction
    table |= {"guide": slide.guide, "through": origin if origin in machine.points else _mm(points[origin])}
    if slide.guide == FRAME:
        table["angle"] = _degrees(math.atan2(along.imag, along.real))
    else:
        table["toward"] = ahead_on(points, origin, along)
    if slide.block is not None:
        first = next(other for other in machine.slides if other.block == slide.block)
        if slide.block == FRAME or len(machine.links[slide.block].points) > 1 or first is not slide:
            table["tilt"] = _degrees(slide.tilt)  # the block has a direction of its own
    return table


def _driver(driver: Driver) -> dict[str, object]:
    value, rate, more = driver.value or 0.0, _plain(driver.rate, 12), _plain(driver.acceleration, 12)
    if driver.vector is None:
        table: dict[str, object] = {"slide": driver.link, "at": _mm(value), "velocity": rate}
        return table | ({"acceleration": more} if more else {})
    start = {} if driver.from_vector is None else {"from": "".join(driver.from_vector)}
    table = {"vector": "".join(driver.vector), **start, "angle": _degrees(value), "omega": rate}
    return table | ({"alpha": more} if more else {})


def _mm(length: complex) -> object:
    """A length, or a place [x, y]."""
    return [_mm(length.real), _mm(length.imag)] if isinstance(length, complex) else _plain(length * 1e3, 13)


def _degrees(angle: float) -> float:
    return _plain(math.degrees(angle), 14)


def _plain(value: float, digits: int) -> float:
    """Of so many digits; a whole number without a point."""
    rounded = float(f"{value:.{digits}g}")
    return int(rounded) if rounded.is_integer() else rounded
