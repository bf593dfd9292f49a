"""Another link as frame: the same links and pairs at the same position, seen from another of them.

The same pair stays driven. Where it does not lie at the new frame, the motor rides on a moving link and the
driver's angle is counted from that link.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

from graphkin.analytic import Motion, motion
from graphkin.errors import Lang, NoFixing
from graphkin.linkages.writing import Draft, degrees, free_names, quoted
from graphkin.mechanism import FRAME, Driver, Mechanism
from graphkin.pairs import Slide

__all__ = ["inverted"]


def inverted(mechanism: Mechanism, link: str) -> str:
    """The file of the mechanism with another link (as people call it) held fast.

    Positions stay where they are drawn; the old frame becomes a moving link of its own name. Mechanisms with gears,
    rolling or cams are not inverted. Raises NoFixing.
    """
    possible = () if mechanism.gears or mechanism.rolls or mechanism.cams else mechanism.moving
    if link not in possible:
        raise NoFixing(mechanism.where("links"), link, possible)
    return _Inversion(mechanism, link).draft().text


class _Inversion:
    """Gathers the parts of the new file."""

    def __init__(self, mechanism: Mechanism, fixed: str) -> None:
        self.machine, self.fixed = mechanism, fixed
        self.now: Motion = motion(mechanism)
        self.names = self._renamed()
        self.points = {name: self._points(name) for name in mechanism.links}
        reach = max((abs(z) for link in mechanism.links.values() for z in link.points.values()), default=0.0)
        self.reach = reach or 0.05

    def _renamed(self) -> dict[str, str]:
        """Points of lines, which had no name of their own, get one: that of a point of the link at the same place."""
        found = {point: point for point in self.machine.owners}
        nameless = [(p, link) for link in self.machine.links.values() for p in link.points if not p[0].isupper()]
        for (point, link), fresh in zip(nameless, free_names(self.machine.owners, len(nameless))):
            size = max(abs(z) for z in link.points.values()) or 1.0
            there = (p for p, z in link.points.items() if p[0].isupper() and abs(z - link.points[point]) < 1e-12 * size)
            found[point] = next(there, fresh)
        return found

    def _points(self, link: str) -> dict[str, complex]:
        """A link's points where they are drawn [m]."""
        return {self.names[p]: self._place(p, link) for p in self.machine.links[link].points}

    def _place(self, point: str, link: str) -> complex:
        """Where a point of a link is, points of lines included."""
        if point in self.now.position:
            return complex(self.now.position[point])
        points = self.machine.links[link].points
        base = next((p for p in points if p in self.now.position), None)
        if link == FRAME or base is None:
            return points[point]
        turn = cmath.rect(1, float(self.now.theta[link]))
        return complex(self.now.position[base]) + (points[point] - points[base]) * turn

    def called(self, link: str) -> str:
        """A link's name in the new file."""
        return "frame" if link == self.fixed else self.machine.called(link)

    def draft(self) -> Draft:
        slides = tuple(self._slide(slide) for slide in self.machine.slides)
        told = [self._driver(driver) for driver in self.machine.drivers]
        order = sorted((name for name in self.points if name != self.fixed), key=lambda name: name == FRAME)
        links = {self.machine.called(name): self.points[name] for name in order}
        return Draft(
            self._title(), tuple(note for _, note in told), self.fixed, self.points[self.fixed], links, slides,
            tuple(table for table, _ in told), self.machine.scales.get("length"),
        )  # fmt: skip

    def _title(self) -> Mapping[Lang, str]:
        return {
            "en": f"{self.machine.headline('en')}, link {self.fixed} fixed",
            "zh": f"{self.machine.headline('zh')}（以构件 {self.fixed} 为机架）",
        }

    # --- slides ----------------------------------------------------------------------------------

    def _along(self, slide: Slide) -> complex:
        return slide.line.direction * cmath.rect(1, float(self.now.theta[slide.guide]))

    def _slide(self, slide: Slide) -> dict[str, str]:
        table = {"name": quoted(slide.name)} if slide.named else {}
        if slide.block is None:
            table["pin"] = quoted(self.names[slide.point])
        else:
            table |= {"block": quoted(self.called(slide.block)), "point": quoted(self.names[slide.point])}
        table["guide"] = quoted(self.called(slide.guide))
        table |= self._line(slide)
        if (tilt := self._tilt(slide)) is not None:
            table["tilt"] = degrees(tilt)
        return table

    def _line(self, slide: Slide) -> dict[str, str]:
        """Through a point of the guide: at an angle to +x on the new frame, else towards another of its points."""
        origin, along = self.names[slide.line.origin], self._along(slide)
        if slide.guide == self.fixed:
            return {"through": quoted(origin), "angle": degrees(cmath.phase(along))}
        points = self.points[slide.guide]
        foot = points[origin]
        for point, place in points.items():
            ahead = (place - foot) * along.conjugate()
            if ahead.real > 1e-3 * self.reach and abs(ahead.imag) < 1e-9 * self.reach:
                return {"through": quoted(origin), "toward": quoted(point)}
        far = self._added(slide.guide, foot + along * self._length(slide, foot, along))
        return {"through": quoted(origin), "toward": quoted(far)}

    def _length(self, slide: Slide, foot: complex, along: complex) -> float:
        """A line is drawn as far as what slides on it."""
        there = complex(self.now.position[slide.point])
        return max(((there - foot) * along.conjugate()).real, 0.25 * self.reach)

    def _added(self, link: str, place: complex) -> str:
        taken = {point for points in self.points.values() for point in points} | set(self.machine.owners)
        name = free_names(taken, 1)[0]
        self.points[link][name] = place
        return name

    def _tilt(self, slide: Slide) -> float | None:
        """Angle from the line to the block's own direction, for a block that has one."""
        if slide.block is None:
            return None
        line = cmath.phase(self._along(slide))
        if slide.block == self.fixed:
            return _wrapped(-line)
        places = list(self.points[slide.block].values())
        if len(places) > 1:
            return _wrapped(cmath.phase(places[1] - places[0]) - line)
        first = next(other for other in self.machine.slides if other.block == slide.block)
        return None if first is slide else _wrapped(cmath.phase(self._along(first)) - line)

    # --- drivers ----------------------------------------------------------------------------------

    def _driver(self, driver: Driver) -> tuple[dict[str, str], str]:
        """The table, and what is said of it."""
        if driver.kind == "slide":
            at = self.now.values[self.machine.drivers.index(driver)]
            rates = {"velocity": f"{driver.rate:.12g}"}
            rates |= {"acceleration": f"{driver.acceleration:.12g}"} if driver.acceleration else {}
            note = f"The slide {driver.link} stays driven. 移动副 {driver.link} 仍为主动副。"
            return {"slide": quoted(driver.link), "at": f"{float(at) * 1e3:.13g}", **rates}, note
        one, other, sense = driver.link, driver.from_link, 1.0
        if one == self.fixed:
            one, other, sense = other, one, -1.0
        vector = self._vector(one, driver.vector if one == driver.link else driver.from_vector)
        turned = self._direction(one, vector)
        table = {"vector": quoted("".join(vector))}
        if other != self.fixed:
            start = self._vector(other, driver.from_vector if other == driver.from_link else driver.vector)
            table["from"] = quoted("".join(start))
            turned -= self._direction(other, start)
        table |= {"angle": degrees(_wrapped(turned)), "omega": f"{sense * driver.rate + 0.0:.12g}"}
        table |= {"alpha": f"{sense * driver.acceleration:.12g}"} if driver.acceleration else {}
        return table, self._note(driver, other)

    def _vector(self, link: str, given: tuple[str, str] | None) -> tuple[str, str]:
        """Two points of a link; one is added where it has no two."""
        if given is not None:
            return given
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

    def _note(self, driver: Driver, other: str) -> str:
        one, two = self.machine.called(driver.link), self.machine.called(driver.from_link)
        if other == self.fixed:
            return f"The same pair is driven: links {one} and {two}. 主动副不变：构件 {one} 与 {two}。"
        return (
            f"The same pair is driven, links {one} and {two}: the angle is counted from the moving link {two}. "
            f"主动副不变（构件 {one} 与 {two}），转角相对于活动构件 {two} 度量。"
        )


def _wrapped(angle: float) -> float:
    return math.remainder(angle, math.tau)
