"""What is read off a finished drawing: motions of links, points and slides, and answers to questions.

The same questions can be put to the analytic solution: it gives `Motions`, too.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping

import numpy as np

from graphkin.geometry import Value, dot
from graphkin.mechanism import Mechanism
from graphkin.methods import Method
from graphkin.motions import Motions
from graphkin.naming import Seen, common_link, pair, seen
from graphkin.steps import Plane, Plot
from graphkin.value import Lazy, frozen

__all__ = ["Answer", "answer", "readings", "relative"]


def readings(method: Method, plot: Plot) -> Motions:
    """Motions read off a finished drawing. Sliding pairs and rolling wheels of the file, without the slots that stand
    for cams; angles between 0 and a full turn."""
    mechanism = method.mechanism
    slides = {pair.name for pair in mechanism.slides} | {roll.name for roll in mechanism.rolls}
    links, nodes = set(mechanism.moving), _nodes(method)
    theta = Lazy((link for link in plot.theta if link in links), lambda link: np.mod(plot.theta[link], 2 * np.pi))
    return Motions(
        mechanism, theta, _of(plot.omega, links), _of(plot.alpha, links),
        _of(plot.s, slides), _of(plot.s_rate, slides), _of(plot.s_acceleration, slides),
        plot.position, _of_nodes(plot.velocity, nodes, ""), _of_nodes(plot.acceleration, nodes, "'"),
    )  # fmt: skip


def _of(table: Mapping[str, Value], names: Collection[str]) -> Mapping[str, Value]:
    return {name: value for name, value in table.items() if name in names}


def _of_nodes(
    polygon: Mapping[str, Value], nodes: Mapping[str, Mapping[str, str]], prime: str
) -> Mapping[str, Mapping[str, Value]]:
    """By link and point what a polygon shows of it; `prime` is what its points have after the name."""

    def of_link(link: str) -> Mapping[str, Value]:
        return Lazy(nodes[link], lambda point: polygon[nodes[link][point] + prime])

    return Lazy(nodes, of_link)


def _nodes(method: Method) -> dict[str, dict[str, str]]:
    """By moving link: its points that the polygons show, with the velocity polygon's point."""
    found: dict[str, dict[str, str]] = {}
    owners = method.mechanism.owners
    for node in method.velocity.nodes.values():
        if node.site is not None and node.site.point in owners:
            links = owners[node.site.point] if node.site.link in owners[node.site.point] else (node.site.link,)
            for link in links:
                found.setdefault(link, {}).setdefault(node.site.point, node.name)
    return found


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
    coriolis = 2j * motions.turning(seen_from.link) * velocity
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
        return -((motions.turning(of.link) - motions.turning(seen_from.link)) ** 2) * arm
    return 1j * (motions.swing(of.link) - motions.swing(seen_from.link)) * arm
