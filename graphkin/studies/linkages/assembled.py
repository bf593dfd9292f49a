"""From links at their drawn places to a `Mechanism`: each link in axes of its own, each slide's line in its guide's."""

from __future__ import annotations

import cmath
from collections.abc import Collection, Mapping

from graphkin.model.mechanism import FRAME, Driver, Link, Mechanism
from graphkin.model.pairs import Line, Slide

Places = Mapping[str, complex]
"""The points of a link where they are drawn [m]."""
_PUSH = 0.1
"""How fast a slide is driven [m/s]."""


def assembled(
    frame: str, links: Mapping[str, Places], slides: tuple[Slide, ...], drivers: tuple[Driver, ...],
    length_scale: float | None = None,
) -> Mechanism:  # fmt: skip
    """The mechanism, without a title.

    frame          what people call the frame; among the links it is `FRAME`
    length_scale   [m/mm], or None
    """
    shapes = {name: Link(name, dict(points) if name == FRAME else _own_axes(points)) for name, points in links.items()}
    moving = {p: z for name, points in links.items() if name != FRAME for p, z in points.items()}
    return Mechanism(
        "linkage", frame, shapes, slides, drivers,
        sketch={p: z for p, z in moving.items() if p not in links[FRAME]},
        scales={} if length_scale is None else {"length": length_scale}, file="linkage.toml",
    )  # fmt: skip


def _own_axes(points: Places) -> dict[str, complex]:
    """The origin in the first point, x towards the second."""
    first, *others = points
    if len(others) == 1:
        return {first: 0j, others[0]: complex(abs(points[others[0]] - points[first]))}
    turn = _turned_back(points)
    return {name: (place - points[first]) * turn for name, place in points.items()}


def _turned_back(points: Places) -> complex:
    """What turns a link from where it is drawn into its own axes; 1 for a link of one place."""
    places = list(points.values())
    axis = places[1] - places[0] if len(places) > 1 else 0j
    return abs(axis) / axis if axis else 1 + 0j


def drawn_line(links: Mapping[str, Places], link: str, origin: str, along: complex, named: bool = True) -> Line:
    """A line of a link through one of its points, drawn in the direction of a unit vector."""
    return Line(link, origin, along if link == FRAME else along * _turned_back(links[link]), named)


def turning(link: str, vector: tuple[str, str], drawn: complex, omega: float) -> Driver:
    """A driver that turns a link against the frame; `drawn`: the vector where it is drawn."""
    return Driver("angle", link, vector, value=cmath.phase(drawn), rate=omega)


def pushing(at: float) -> Driver:
    """A driver of the slide `s`, at a displacement [m]."""
    return Driver("slide", "s", value=at, rate=_PUSH)


def ahead_on(points: Places, origin: str, along: complex) -> str:
    """The first of a link's points that lies ahead of one of them in the direction of a unit vector; "" for none."""
    ways = {point: (place - points[origin]) * along.conjugate() for point, place in points.items()}
    reach = max(map(abs, ways.values()))
    there = (point for point, way in ways.items() if way.real > 1e-3 * reach and abs(way.imag) < 1e-9 * reach)
    return next(there, "")


def free_names(taken: Collection[str], count: int) -> list[str]:
    """Names of points that nobody has: P, Q, R, .., then P1, Q1, .."""
    letters = "PQRSTUVW"
    every = (f"{letter}{number or ''}" for number in range(len(taken) + count) for letter in letters)
    return [name for name in every if name not in taken][:count]
