"""What is read off a finished drawing: motions of links, points and slides, and answers to questions.

`Readings` takes everything from the replayed construction. `Motions` is what a reading needs, so that the
same questions can be put to the analytic solution.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import cached_property
from typing import Protocol

import numpy as np

from graphkin.construction import Plane, Plot
from graphkin.geometry import Value, dot
from graphkin.mechanism import FRAME, Mechanism
from graphkin.naming import Seen, common_link, pair, seen
from graphkin.planning import Method
from graphkin.value import frozen

__all__ = ["Answer", "Motions", "Readings", "answer", "relative"]


class Motions(Protocol):
    """Positions, velocities and accelerations, SI; every value a scalar or an array over positions."""

    @property
    def theta(self) -> Mapping[str, Value]: ...
    @property
    def omega(self) -> Mapping[str, Value]: ...
    @property
    def alpha(self) -> Mapping[str, Value]: ...
    @property
    def s(self) -> Mapping[str, Value]: ...
    @property
    def s_rate(self) -> Mapping[str, Value]: ...
    @property
    def s_acceleration(self) -> Mapping[str, Value]: ...
    @property
    def position(self) -> Mapping[str, Value]: ...
    def velocity_at(self, point: str, link: str) -> Value: ...
    def acceleration_at(self, point: str, link: str) -> Value: ...


@frozen
class Readings:
    """A finished drawing, read."""

    method: Method
    plot: Plot

    @property
    def theta(self) -> Mapping[str, Value]:
        return {link: np.mod(value, 2 * np.pi) for link, value in self.plot.theta.items() if self._moves(link)}

    @property
    def omega(self) -> Mapping[str, Value]:
        return {link: value for link, value in self.plot.omega.items() if self._moves(link)}

    @property
    def alpha(self) -> Mapping[str, Value]:
        return {link: value for link, value in self.plot.alpha.items() if self._moves(link)}

    @property
    def s(self) -> Mapping[str, Value]:
        return self._told(self.plot.s)

    @property
    def s_rate(self) -> Mapping[str, Value]:
        return self._told(self.plot.s_rate)

    @property
    def s_acceleration(self) -> Mapping[str, Value]:
        return self._told(self.plot.s_acceleration)

    @property
    def position(self) -> Mapping[str, Value]:
        return self.plot.position

    def _told(self, table: Mapping[str, Value]) -> Mapping[str, Value]:
        """Sliding pairs and rolling wheels of the file, without the slots that stand for cams."""
        mechanism = self.method.mechanism
        names = {pair.name for pair in mechanism.slides} | {roll.name for roll in mechanism.rolls}
        return {name: value for name, value in table.items() if name in names}

    def _moves(self, link: str) -> bool:
        return link in self.method.mechanism.moving

    @cached_property
    def _nodes(self) -> dict[str, list[tuple[str, str]]]:
        """By link: its points that the polygons show, with the polygon's point."""
        found: dict[str, list[tuple[str, str]]] = {}
        owners = self.method.mechanism.owners
        for node in self.method.velocity.nodes.values():
            if node.site is not None and node.site.point in owners:
                links = owners[node.site.point] if node.site.link in owners[node.site.point] else (node.site.link,)
                for link in links:
                    found.setdefault(link, []).append((node.site.point, node.name))
        return found

    def velocity_at(self, point: str, link: str) -> Value:
        """Velocity of the point of `link` under `point` [m/s]: of the polygon, or by image."""
        start, node = self._nearest(point, link)
        return self.plot.velocity[node] + 1j * self._rate("omega", link) * self.plot.arm(start, point)

    def acceleration_at(self, point: str, link: str) -> Value:
        """Acceleration of the point of `link` under `point` [m/s^2]."""
        start, node = self._nearest(point, link)
        prime = "" if node == self.method.velocity.pole else "'"
        turn = 1j * self._rate("alpha", link) - self._rate("omega", link) ** 2
        return self.plot.acceleration[node + prime] + turn * self.plot.arm(start, point)

    def _nearest(self, point: str, link: str) -> tuple[str, str]:
        nodes = self._nodes[link]
        return next((entry for entry in nodes if entry[0] == point), nodes[0])

    def _rate(self, quantity: str, link: str) -> Value:
        table: Mapping[str, Value] = getattr(self.plot, quantity)
        return 0.0 if link == FRAME else table[link]


@frozen
class Answer:
    """The answer to a question: a scalar with its unit, and the vector it is the length of."""

    value: Value
    unit: str
    vector: Value | None = None


UNITS = {
    "theta": "rad", "omega": "rad/s", "alpha": "rad/s^2", "s": "m",
    "v": "m/s", "a": "m/s^2", "a_n": "m/s^2", "a_t": "m/s^2", "a_k": "m/s^2", "a_r": "m/s^2",
    "x": "m", "y": "m", "v_x": "m/s", "v_y": "m/s", "a_x": "m/s^2", "a_y": "m/s^2",
}  # fmt: skip
COMPONENTS = ("x", "y")
"""Places and vectors along the frame's axes: `x C`, `v_y C`, `a_x CB`."""


def answer(mechanism: Mechanism, motions: Motions, question: str) -> Answer | None:
    """The answer to one line of `ask`; None for a text that is only to be shown."""
    top, slash, bottom = question.partition("/")
    if slash:
        first, second = answer(mechanism, motions, top.strip()), answer(mechanism, motions, bottom.strip())
        if first is None or second is None or first.unit != second.unit:
            return None
        return Answer(_quotient(first.value, second.value), "1")
    words = re.fullmatch(r"(\w+) +(\S+)", question.strip())
    if words is None or words[1] not in UNITS:
        return None
    return _answer(mechanism, motions, words[1], words[2])


def _quotient(top: Value, bottom: Value) -> Value:
    """top / bottom; a bottom that is 0 but for rounding counts as 0."""
    sizes = [float(np.max(np.abs(value), initial=0.0, where=np.isfinite(value))) for value in (top, bottom)]
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.divide(top, np.where(np.abs(bottom) <= 1e-12 * max(sizes), 0.0, bottom))[()]


def _answer(mechanism: Mechanism, motions: Motions, quantity: str, of: str) -> Answer | None:
    unit = UNITS[quantity]
    if quantity in ("theta", "omega", "alpha"):
        table: Mapping[str, Value] = getattr(motions, quantity)
        return Answer(table[of], unit) if of in table else None
    if quantity == "s":
        return Answer(motions.s[of], unit) if of in motions.s else None
    vector_name, _, axis = quantity.rpartition("_")
    if axis in COMPONENTS:
        whole = _place(mechanism, motions, of) if not vector_name else _vector(mechanism, motions, vector_name, of)
        return None if whole is None else Answer(np.real(whole) if axis == "x" else np.imag(whole), unit)
    vector = _vector(mechanism, motions, quantity, of)
    return None if vector is None else Answer(np.abs(vector), unit, vector)


def _place(mechanism: Mechanism, motions: Motions, of: str) -> Value | None:
    site = seen(mechanism, of)
    return None if site is None else motions.position[site.point]


def _vector(mechanism: Mechanism, motions: Motions, quantity: str, of: str) -> Value | None:
    plane: Plane = "velocity" if quantity == "v" else "acceleration"
    if (site := seen(mechanism, of)) is not None:
        return _absolute(motions, plane, site) if quantity in ("v", "a") else None
    if (sites := pair(mechanism, of)) is None:
        return None
    return relative(mechanism, motions, plane, quantity.partition("_")[2], *sites)


def _absolute(motions: Motions, plane: Plane, site: Seen) -> Value:
    at: Callable[[str, str], Value] = motions.velocity_at if plane == "velocity" else motions.acceleration_at
    return at(site.point, site.link)


def relative(
    mechanism: Mechanism, motions: Motions, plane: Plane, part: str, of: Seen, seen_from: Seen
) -> Value | None:
    """The motion of one site seen from another, or its part n, t, k, r, rn or rt; None where there is no such part.

    The Coriolis part takes the rotation of the link of `seen_from`.
    """
    whole = _absolute(motions, plane, of) - _absolute(motions, plane, seen_from)
    if part == "":
        return whole
    arm = motions.position[of.point] - motions.position[seen_from.point]
    if part in ("n", "t"):
        link = common_link(mechanism, of, seen_from)
        if link is not None:
            return -(motions.omega[link] ** 2) * arm if part == "n" else 1j * motions.alpha[link] * arm
        return _between_centres(motions, part, of, seen_from, whole) if mechanism.cams or mechanism.rolls else None
    if of.point != seen_from.point:
        return None
    return _coincident(mechanism, motions, part, of, seen_from, whole)


def _between_centres(motions: Motions, part: str, of: Seen, seen_from: Seen, whole: Value) -> Value:
    """Of two centres that profiles keep apart, as by a link: the acceleration along their line and across it."""
    arm = motions.position[of.point] - motions.position[seen_from.point]
    along = arm * dot(arm, whole) / np.abs(arm) ** 2
    return along if part == "n" else whole - along


def _coincident(
    mechanism: Mechanism, motions: Motions, part: str, of: Seen, seen_from: Seen, whole: Value
) -> Value | None:
    velocity = _absolute(motions, "velocity", of) - _absolute(motions, "velocity", seen_from)
    coriolis = 2j * _rate(motions.omega, seen_from.link) * velocity
    if part == "k":
        return coriolis
    if part == "r":
        return whole - coriolis
    pivot = next(
        (p for p in mechanism.points if {of.link, seen_from.link} <= set(mechanism.owners[p])), None
    )
    if pivot is None:
        return None
    arm = motions.position[of.point] - motions.position[pivot]
    if part == "rn":
        return -((_rate(motions.omega, of.link) - _rate(motions.omega, seen_from.link)) ** 2) * arm
    return 1j * (_rate(motions.alpha, of.link) - _rate(motions.alpha, seen_from.link)) * arm


def _rate(table: Mapping[str, Value], link: str) -> Value:
    return 0.0 if link == FRAME else table[link]
