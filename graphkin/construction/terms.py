"""Arrows of a vector equation: where they point, how long they are, and the terms made of both."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple

from graphkin.base.value import frozen

Plane = Literal["position", "velocity", "acceleration"]
SCALES: Mapping[Plane, Literal["length", "velocity", "acceleration"]] = {
    "position": "length", "velocity": "velocity", "acceleration": "acceleration",
}  # fmt: skip
"""The scale of a plane's drawing, as files name it."""
LETTER: Mapping[Plane, str] = {"position": "r", "velocity": "v", "acceleration": "a"}


# --- where things point -----------------------------------------------------------------------


@frozen
class Along:
    """From the point `tail` of the mechanism to its point `head`."""

    tail: str
    head: str


@frozen
class Across:
    """At right angles to tail -> head, counter-clockwise of it: where `head` goes when it turns so about `tail`."""

    tail: str
    head: str


@frozen
class AlongGuide:
    """Along the line of a slide, as s counts."""

    slide: str


@frozen
class Quarter:
    """A relative velocity turned by 90 deg with the rotation of `link`: the direction of a Coriolis term."""

    link: str
    tail: str
    head: str


@frozen
class AcrossGuide:
    """At right angles to the line of a slide."""

    slide: str


Direction = Along | Across | AlongGuide | AcrossGuide | Quarter


# --- how long they are ------------------------------------------------------------------------


@frozen
class Drawn:
    """Already in this plane, from point `tail` to point `head`."""

    tail: str
    head: str


@frozen
class Turning:
    """omega l of `link`, for its points tail -> head."""

    link: str
    tail: str
    head: str


@frozen
class Normal:
    """omega^2 l of `link`, from head towards tail."""

    link: str
    tail: str
    head: str


@frozen
class Tangential:
    """alpha l of `link`, for its points tail -> head."""

    link: str
    tail: str
    head: str


@frozen
class Coriolis:
    """2 omega v_r: omega of `link`, v_r from `tail` to `head` in the velocity polygon."""

    link: str
    tail: str
    head: str


@frozen
class Driven:
    """The driven sliding speed of a slide (in the acceleration plane: its rate of change).

    sign  -1 where the guide is seen from the block
    """

    slide: str
    sign: int = 1


@frozen
class Relative:
    """A driven relative rotation: the motion of `link`'s point `head` about `tail` as seen from `seen_from`.

    part  "" in the velocity plane (omega_r l), "n" (omega_r^2 l) or "t" (alpha_r l) in the acceleration plane
    """

    link: str
    seen_from: str
    tail: str
    head: str
    part: str = ""


@frozen
class Arm:
    """The vector tail -> head of one link."""

    link: str
    tail: str
    head: str


@frozen
class Slid:
    """The displacement s of a slide, along its line; `sign` -1 from the sliding point back to the origin."""

    slide: str
    sign: int = 1


@frozen
class Span:
    """Arms and displacements end to end, of links that hold their angles to one another."""

    parts: tuple[Arm | Slid, ...]


Size = Drawn | Turning | Normal | Tangential | Coriolis | Driven | Relative | Span


# --- terms and equations ----------------------------------------------------------------------


class Site(NamedTuple):
    """A point of the mechanism as part of a link; what polygons are looked up by most."""

    point: str
    link: str


@frozen
class Term:
    """One arrow of a vector equation: the motion of `of` as seen from `seen_from`.

    of, seen_from   sites as they are written (`B3`, `C`); seen_from "" for an absolute motion
    part            "", "n" (normal), "t" (tangential), "k" (Coriolis), "r" (relative), "rn", "rt"
    size            what its length is made of, None while unknown
    direction       where it points, None while unknown
    tail, head      the points of the plane between which it lies
    over            a point between: two arrows on one line, of `over` and of `of` seen from `over`, drawn as one
    onto            the point from which the second of these is seen, where known arrows lie between it and `over`
    sites           of, seen_from (and over, onto) as points of links: what they are, however they are written
    """

    of: str
    seen_from: str
    part: str
    size: Size | None
    direction: Direction | None
    tail: str
    head: str
    over: str = ""
    onto: str = ""
    sites: tuple[Site, ...] = ()

    def name(self, plane: Plane) -> str:
        """`v_CB`, `a^n_CB`, `a^k_B3B2`; `v_DG+v_S4D` where two lie on one line."""
        if self.over:
            turned = "t" if plane == "acceleration" else ""
            halves = (
                Term(self.over, self.seen_from, self.part, None, None, "", ""),
                Term(self.of, self.onto or self.over, turned, None, None, "", ""),
            )
            return "+".join(half.name(plane) for half in halves)
        part = f"^{self.part}" if self.part else ""
        comma = "," if "@" in self.of + self.seen_from and self.seen_from else ""
        return f"{LETTER[plane]}{part}_{self.of}{comma}{self.seen_from}"

    @property
    def unknowns(self) -> int:
        """The number of unknowns among its size and its direction; a drawn arrow has both."""
        return (self.size is None) + (self.direction is None and not isinstance(self.size, Drawn))
