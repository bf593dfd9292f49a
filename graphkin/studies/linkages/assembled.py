"""A linkage as a `Mechanism`: each link in axes of its own, each slide's line in its guide's; and its positions."""

from __future__ import annotations

import cmath
from collections.abc import Collection, Mapping
from typing import Protocol

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Driver, Link, Mechanism
from graphkin.model.pairs import Line, Slide
from graphkin.studies.linkages.linkage import LinkagePosition

Places = Mapping[str, complex]  # the points of a link as they are drawn [m]
_PUSH = 0.1  # the speed of a driven slide [m/s]


def assembled(
    frame: str, links: Mapping[str, Places], slides: tuple[Slide, ...], drivers: tuple[Driver, ...],
    length_scale: float | None = None,
) -> Mechanism:  # fmt: skip
    """The mechanism, without a title.

    frame          the name that people call the frame; among the links it is `FRAME`
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
    """The factor that turns a drawn link into its own axes; 1 for a link of one place."""
    places = list(points.values())
    axis = places[1] - places[0] if len(places) > 1 else 0j
    return abs(axis) / axis if axis else 1 + 0j


def drawn_line(links: Mapping[str, Places], link: str, origin: str, along: complex, named: bool = True) -> Line:
    """A line of a link through one of its points, drawn in the direction of a unit vector."""
    return Line(link, origin, along if link == FRAME else along * _turned_back(links[link]), named)


def turning(link: str, vector: tuple[str, str], drawn: complex, omega: float) -> Driver:
    """A driver that turns a link against the frame; `drawn`: the vector as it is drawn."""
    return Driver("angle", link, vector, value=cmath.phase(drawn), rate=omega)


def pushing(at: float) -> Driver:
    """A driver of the slide `s`, at a displacement [m]."""
    return Driver("slide", "s", value=at, rate=_PUSH)


def ahead_on(points: Places, origin: str, along: complex) -> str:
    """The first of a link's points that lies ahead of one of them in the direction of a unit vector; "" for none."""
    arms = {point: (place - points[origin]) * along.conjugate() for point, place in points.items()}
    reach = max(map(abs, arms.values()))
    ahead = (point for point, arm in arms.items() if arm.real > 1e-3 * reach and abs(arm.imag) < 1e-9 * reach)
    return next(ahead, "")


def free_names(names: Collection[str], count: int) -> list[str]:
    """Names of points that nobody has: P, Q, R, .., then P1, Q1, .."""
    letters = "PQRSTUVW"
    every = (f"{letter}{number or ''}" for number in range(len(names) + count) for letter in letters)
    return [name for name in every if name not in names][:count]


class AnyLinkage(Protocol):
    """A linkage of any kind, as far as `posed` asks it."""

    @property
    def names(self) -> tuple[str, ...]: ...
    @property
    def places(self) -> tuple[complex, ...]: ...
    @property
    def drawn(self) -> LinkagePosition: ...


@frozen
class Placement:
    """Points [m] and angles of links [rad] at one position; points that only end a line are left out."""

    position: Mapping[str, complex]
    theta: Mapping[str, float]


def posed(linkage: AnyLinkage, machine: Mechanism, position: LinkagePosition) -> Placement:
    """`machine`, which `linkage.mechanism` made, at a position; a dead point is one like any other."""
    drawn = {**machine.sketch, **dict(zip(linkage.names, linkage.places))}
    places = dict(zip(linkage.names, position.places))
    turned = position.turn - linkage.drawn.turn
    theta: dict[str, float] = {}
    for link in machine.moving:
        tail, *others = machine.links[link].points
        for head in others[:1]:
            if head in places:
                theta[link] = cmath.phase(places[head] - places[tail])
            else:
                theta[link] = cmath.phase(drawn[head] - drawn[tail]) + turned
    for line in (slide.line for slide in machine.slides if slide.guide != FRAME and slide.line.origin not in places):
        points = machine.links[line.link].points
        hinge = next(point for point in points if point in places)
        places[line.origin] = places[hinge] + (points[line.origin] - points[hinge]) * cmath.rect(1, theta[line.link])
    return Placement(places, theta)
