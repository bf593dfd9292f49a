"""The equations of pairs, drivers and poses for bodies that may lie anywhere, one row each, and the rank of such rows.

Each body has three coordinates, the place of its origin (in units of the mechanism's size) and its angle. Nothing
is drawn from these rows: they only tell which constraints repeat others, and by how much one contradicts them.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from graphkin.base.geometry import number, wrapped
from graphkin.base.tolerances import CLOSED, RANK
from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Driver
from graphkin.model.pairs import Slide
from graphkin.planning.equivalent import Contact
from graphkin.planning.structure import ConstraintRow, SetAside, Topology

Array = NDArray[np.float64]
Gradient = NDArray[np.complex128]
_DAMPED = 1e-12
_ROUNDS = 80
_STARTS = 12


@frozen
class ConstraintRows:
    """Equations at a place: what is left open (k,), and its slopes (k, 3n); lengths in units of size."""

    labels: tuple[ConstraintRow, ...]
    open: Array
    slopes: Array

    def only(self, labels: Sequence[ConstraintRow]) -> Array:
        """The slopes of some of them."""
        return self.slopes[[k for k, label in enumerate(self.labels) if label in labels]]

    def of_kind(self, kind: str) -> list[ConstraintRow]:
        return [label for label in self.labels if label.kind == kind]

    def without(self, labels: Sequence[ConstraintRow]) -> ConstraintRows:
        kept = [k for k, label in enumerate(self.labels) if label not in labels]
        return ConstraintRows(tuple(self.labels[k] for k in kept), self.open[kept], self.slopes[kept])

    @property
    def gap(self) -> float:
        """The widest gap."""
        return float(np.max(np.abs(self.open), initial=0.0))

    @property
    def rank(self) -> int:
        return int(np.linalg.matrix_rank(self.slopes, tol=RANK)) if self.slopes.size else 0

    @property
    def freedom(self) -> Array:
        """Directions (f, 3n) in which the equations let the bodies go."""
        return np.asarray(np.linalg.svd(self.slopes)[2][self.rank :])

    def distance_of(self, labels: Sequence[ConstraintRow]) -> float:
        """The distance of some equations from following from the others, 0 to 1."""
        others, own = self.without(labels).slopes, self.only(labels)
        back = np.linalg.pinv(others, rcond=RANK) @ others
        return float(np.max(np.linalg.norm(own - own @ back, axis=1) / np.linalg.norm(own, axis=1)))


def over(rows: ConstraintRows, candidates: Iterable[SetAside]) -> tuple[SetAside, ...]:
    """Those of which some equations are left that say nothing more than the other rows do; one after another."""
    left: list[SetAside] = []
    for each in candidates:
        inside = [row for row in each.rows if row in rows.labels]
        fewer = rows.without(inside)
        if each.part != "link" and inside and fewer.rank == rows.rank:
            rows = fewer
            left.append(each)
    return tuple(left)


@frozen
class Restraints:
    """The equations of a structure; `given` are the drivers and poses that hold at the drawn position."""

    structure: Topology
    given: tuple[Driver, ...]

    @cached_property
    def bodies(self) -> list[str]:
        return [body for body in self.structure.bodies if body != FRAME and not self.structure.is_pin(body)]

    @cached_property
    def size(self) -> float:
        """The longest arm of a link, or the widest radius [m]."""
        arms = [abs(a - b) for shape in self.structure.shapes.values() for a in shape.values() for b in shape.values()]
        radii = [abs(radius) for contact in self.structure.contacts for radius in contact.radii]
        return max([*arms, *radii], default=0.0) or 1.0

    def rows(self, q: Array, start: Array | None = None) -> ConstraintRows:
        """All equations at q (3n,); rolling counts from `start`, which is q itself where it is left out."""
        rows = [*self._rows(q, q if start is None else start)]
        slopes = np.array([slope for *_, slope in rows]).reshape(-1, len(self.bodies) * 3)
        return ConstraintRows(tuple(label for label, *_ in rows), np.array([gap for _, gap, _ in rows]), slopes)

    def _rows(self, q: Array, start: Array) -> Iterator[tuple[ConstraintRow, float, Array]]:
        yield from self._hinges(q)
        for slide in self.structure.mechanism.slides:
            across, slope = self.along(slide, q)
            yield ConstraintRow("line", slide.name), across.imag, slope.imag
            if slide.block is not None:
                gap, turn = self._angle(slide.block, q)
                back, turned = self._angle(slide.guide, q)
                yield ConstraintRow("angle", slide.name), number(wrapped(gap - back - slide.turn)), turn - turned
        for contact in self.structure.contacts:
            yield ConstraintRow("slip", contact.name), *self._slip(contact, q, start)
        for k, driver in enumerate(self.given):
            row, value = ConstraintRow("given", str(k)), driver.value or 0.0
            if driver.kind == "slide":
                now, slope = self.along(self.structure.slides[driver.link], q)
                yield row, now.real - value / self.size, slope.real
            else:
                (angle, turn), (back, turned) = self._angle(driver.link, q), self._angle(driver.from_link, q)
                offset = self.structure.driver_offset(driver)
                yield row, number(wrapped(angle - back - offset - value)), turn - turned

    def _hinges(self, q: Array) -> Iterator[tuple[ConstraintRow, float, Array]]:
        for point, owners in self.structure.owners.items():
            hub, *others = [body for body in owners if not self.structure.is_pin(body)]
            for body in others:
                (one, slope), (other, more) = self.place(hub, point, q), self.place(body, point, q)
                gap, slopes, row = one - other, slope - more, ConstraintRow("hinge", point, body)
                if body in self.structure.followers and point != next(iter(self.structure.bodies[body])):
                    # a line of centres points at its second centre, however far that is
                    angle, turn = self._angle(body, q)
                    back = cmath.rect(1.0, -angle)
                    yield row, (gap * back).imag, (slopes * back - 1j * gap * back * turn).imag
                    continue
                yield row, gap.real, slopes.real
                yield row, gap.imag, slopes.imag

    def place(self, body: str, point: str, q: Array) -> tuple[complex, Gradient]:
        """A point of a body, in units of size, and how it follows q."""
        slope = np.zeros(len(q), dtype=np.complex128)
        arm = self.structure.shapes[body][point] / self.size
        if body == FRAME:
            return arm, slope
        at = 3 * self.bodies.index(body)
        turned = arm * cmath.rect(1.0, q[at + 2])
        slope[at : at + 3] = 1.0, 1j, 1j * turned
        return complex(q[at], q[at + 1]) + turned, slope

    def _angle(self, body: str, q: Array) -> tuple[float, Array]:
        slope = np.zeros(len(q))
        if body == FRAME:
            return 0.0, slope
        at = 3 * self.bodies.index(body) + 2
        slope[at] = 1.0
        return float(q[at]), slope

    def along(self, slide: Slide, q: Array) -> tuple[complex, Gradient]:
        """The point of a slide as its line sees it: displacement, and 1j times how far it lies beside the line."""
        origin, first = self.place(slide.guide, slide.line.origin, q)
        point, second = self.place(self.carrier(slide), slide.point, q)
        angle, turn = self._angle(slide.guide, q)
        back = (slide.line.direction * cmath.rect(1.0, angle)).conjugate()
        arm = (point - origin) * back
        return arm, (second - first) * back - 1j * arm * turn

    def carrier(self, slide: Slide) -> str:
        """The block, or a link that carries the pin."""
        return slide.block or next(b for b in self.structure.mechanism.owners[slide.point] if b != slide.guide)

    def _slip(self, contact: Contact, q: Array, start: Array) -> tuple[float, Array]:
        gap, slope = 0.0, np.zeros(len(q))
        for body, coefficient in contact.angles:
            angle, turn = self._angle(body, q)
            gap += coefficient / self.size * (angle - self._angle(body, start)[0])
            slope += coefficient / self.size * turn
        if contact.slide:
            slide = self.structure.slides[contact.slide]
            (now, change), (before, _) = self.along(slide, q), self.along(slide, start)
            gap += contact.on_slide * (now - before).real
            slope += contact.on_slide * change.real
        return gap, slope

    def sketched(self, rng: np.random.Generator) -> Array:
        """The places where the sketch and the given values put the bodies (3n,); at random where they say nothing."""
        mechanism = self.structure.mechanism
        at = {p: z / self.size for p, z in (*mechanism.sketch.items(), *mechanism.links[FRAME].points.items())}
        reach = max((abs(z) for z in at.values()), default=1.0) + 1.0
        q = np.zeros(3 * len(self.bodies))
        for body in sorted(self.bodies, key=lambda body: -sum(p in at for p in self.structure.shapes[body])):
            shape = {p: z / self.size for p, z in self.structure.shapes[body].items()}
            known = [point for point in shape if point in at]
            angle = self._turned(body, shape, at, known, rng)
            turned = cmath.rect(1.0, angle)
            origin = complex(*rng.uniform(-reach, reach, 2))
            if known:
                origin = sum((at[p] - shape[p] * turned for p in known), 0j) / len(known)
            k = 3 * self.bodies.index(body)
            q[k : k + 3] = origin.real, origin.imag, angle
            at |= {point: origin + shape[point] * turned for point in shape if point not in at}
        return q

    def _turned(
        self, body: str, shape: dict[str, complex], at: dict[str, complex], known: list[str], rng: np.random.Generator
    ) -> float:
        """The angle of a body: as given, as its sliding pair with the frame has it, or as its known points show."""
        for driver in self.given:
            if driver.kind == "angle" and driver.link == body and driver.from_link == FRAME:
                return number((driver.value or 0.0) + self.structure.driver_offset(driver))
        for slide in self.structure.mechanism.slides:
            if slide.block == body and slide.guide == FRAME:
                return slide.turn
        middle, centre = (sum((z[p] for p in known), 0j) / max(1, len(known)) for z in (at, shape))
        turn = sum(((at[p] - middle) * (shape[p] - centre).conjugate() for p in known), 0j)
        return cmath.phase(turn) if abs(turn) > _DAMPED else float(rng.uniform(-np.pi, np.pi))

    def drawn_place(self, aside: Sequence[ConstraintRow] = ()) -> tuple[Array, ConstraintRows]:
        """The drawn position, as near to the sketch as it can be closed; nothing has rolled yet."""
        rng, places = np.random.default_rng(7), list[tuple[Array, ConstraintRows]]()
        for _ in range(_STARTS):
            q = self.sketched(rng)
            places.append(self.settled(q, [*self.rows(q).of_kind("slip"), *aside]))
            best = min(places, key=lambda place: float(np.sum(place[1].open ** 2)))
            if best[1].gap < CLOSED:
                break
        return best

    def settled(
        self, q: Array, aside: Sequence[ConstraintRow], start: Array | None = None
    ) -> tuple[Array, ConstraintRows]:
        """The place close to q where the equations hold but for those set aside, or hold best (Levenberg-Marquardt);
        rolling counts from `start`, if it is given."""
        damping, rows = 1e-3, self.rows(q, start).without(aside)
        for _ in range(_ROUNDS):
            if rows.gap < 1e-14:
                break
            normal = rows.slopes.T @ rows.slopes + damping * np.eye(len(q))
            change = -np.linalg.solve(normal, rows.slopes.T @ rows.open)
            moved = self.rows(q + change, start).without(aside)
            if np.sum(moved.open**2) < np.sum(rows.open**2):
                q, rows, damping = q + change, moved, max(damping / 10, 1e-13)
            else:
                damping *= 10
                if damping > 1e3:
                    break
        return q, rows
