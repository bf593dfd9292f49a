"""What the pencil does, as data, and `replay`, which does it.

A construction is a list of steps. A step names points, links and slides; it holds no coordinates. Three
planes share the step kinds: `position` (the mechanism), `velocity` (pole p), `acceleration` (pole p').
A point of a plane is named by a text: in the position plane as the mechanism's own point (`B`), in the
polygons by the small letter (`b3`, `b3'`, `n3'`, `k'`).

A *site* is a point seen as part of one link: `B3` is the point of link 3 that lies under B now.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal, assert_never

import numpy as np

from graphkin.geometry import Value, cross, dot, meet_circles, meet_line_circle, meet_lines, root, unit
from graphkin.value import frozen

__all__ = [
    "Across",
    "Along",
    "AlongGuide",
    "Arc",
    "Arm",
    "BrokenChain",
    "Construction",
    "Coriolis",
    "Direction",
    "Drawn",
    "Driven",
    "Equation",
    "Facts",
    "Given",
    "Image",
    "LayOff",
    "Measure",
    "Meet",
    "Node",
    "Normal",
    "NotClosable",
    "Plane",
    "Plot",
    "Ray",
    "Relative",
    "Site",
    "Size",
    "Slid",
    "Span",
    "Step",
    "Swing",
    "Tangential",
    "Term",
    "TurnOf",
    "Turning",
    "replay",
]  # fmt: skip

Plane = Literal["position", "velocity", "acceleration"]
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


@frozen
class Term:
    """One arrow of a vector equation: the motion of `of` as seen from `seen_from`.

    of, seen_from   sites as they are written (`B3`, `C`); seen_from "" for an absolute motion
    part            "", "n" (normal), "t" (tangential), "k" (Coriolis), "r" (relative), "rn", "rt"
    size            what its length is made of, None while unknown
    direction       where it points, None while unknown
    tail, head      the points of the plane between which it lies
    over            a point between: two arrows on one line, of `over` and of `of` seen from `over`, drawn as one
    """

    of: str
    seen_from: str
    part: str
    size: Size | None
    direction: Direction | None
    tail: str
    head: str
    over: str = ""

    def name(self, plane: Plane) -> str:
        """`v_CB`, `a^n_CB`, `a^k_B3B2`; `v_DG+v_S4D` where two lie on one line."""
        if self.over:
            turned = "t" if plane == "acceleration" else ""
            halves = (
                Term(self.over, self.seen_from, self.part, None, None, "", ""),
                Term(self.of, self.over, turned, None, None, "", ""),
            )
            return "+".join(half.name(plane) for half in halves)
        part = f"^{self.part}" if self.part else ""
        comma = "," if "@" in self.of + self.seen_from and self.seen_from else ""
        return f"{LETTER[plane]}{part}_{self.of}{comma}{self.seen_from}"

    @property
    def unknowns(self) -> int:
        """How many of its size and its direction are unknown; a drawn arrow has both."""
        return (self.size is None) + (self.direction is None and not isinstance(self.size, Drawn))


class BrokenChain(ValueError):
    """Two sides of a vector equation that do not start and end at the same points."""


class NotClosable(ValueError):
    """A vector equation with more or fewer than two unknown scalars."""


def span_of(chain: tuple[Term, ...]) -> tuple[str, str]:
    """Start and end of a chain of arrows; refuses one whose arrows do not join tail to head."""
    for before, after in pairwise(chain):
        if before.head != after.tail:
            raise BrokenChain(f"{before.head} is not {after.tail}")
    return chain[0].tail, chain[-1].head


@frozen
class Equation:
    """left = right, with the steps that draw it. Paper closes it when exactly two scalars are unknown.

    of  the site whose motion both sides give
    """

    of: str
    left: tuple[Term, ...]
    right: tuple[Term, ...]
    steps: tuple[Step, ...]

    def __post_init__(self) -> None:
        if span_of(self.left) != span_of(self.right):
            raise BrokenChain(f"{span_of(self.left)} is not {span_of(self.right)}")
        if (found := sum(term.unknowns for term in self.left + self.right)) != 2:
            raise NotClosable(f"{found} unknown scalars, not 2")

    @property
    def double(self) -> bool:
        """Whether a textbook writes the motion sought before both sides: `v_E = v_C + v_EC = v_D + v_ED`."""
        return not (len(self.left) == 1 and self.left[0].of == self.of and not self.left[0].seen_from)


# --- steps ------------------------------------------------------------------------------------


@frozen
class Given:
    """A point to start from: a fixed pivot, or the pole; `also` are the fixed points that sit on the pole."""

    point: str
    also: tuple[str, ...] = ()


@frozen
class LayOff:
    """A known arrow from `start` to `tip`; `backwards`: the arrow ends at `start` and the pencil goes to its tail."""

    term: Term
    start: str
    tip: str
    backwards: bool = False


@frozen
class Ray:
    """The line through a point in a known direction: where the head of an unknown arrow must lie."""

    through: str
    direction: Direction


@frozen
class Arc:
    """The circle about a point with a known radius: where the end of a link must lie."""

    about: str
    reach: Span


@frozen
class Meet:
    """Two lines or circles cross at `point`.

    side   +1 or -1: which crossing, for a circle (see `geometry`); it stays the same along a sweep
    choice number of this choice among those of the construction, None where lines leave none
    """

    first: Ray | Arc
    second: Ray | Arc
    point: str
    side: int = 1
    choice: int | None = None


@frozen
class Swing:
    """A link with a guide line turns about its `pivot` until the line passes where it must for `through`.

    On paper: the tangent from `through` to the circle about `pivot` that the line touches; where the line
    runs through the pivot, simply the join of the two. `span` goes from pivot to `through` and holds one
    displacement, of `slide`, which this finds; side +1 where s is the greater of the two possible.
    """

    link: str
    pivot: str
    through: str
    slide: str
    span: Span
    side: int = 1
    choice: int | None = None


@frozen
class Image:
    """A further point of `link`: the figure similar to the link on its two known points.

    corners  the two known points and the new one, as points of the mechanism
    base     the two known ones in this plane
    """

    link: str
    corners: tuple[str, str, str]
    base: tuple[str, str]
    point: str


@frozen
class Measure:
    """Ruler and protractor: a quantity read off, with its sense.

    quantity  "theta", "omega", "alpha" of a link; "s", "s_rate", "s_acceleration" of a slide
    span      for an angle of the position plane: what lies between tail and head
    tail, head  the arrow measured, as points of this plane
    lever     for omega, alpha: the points of the mechanism whose distance divides
    sign      for slides: -1 where the arrow is seen the other way round
    """

    quantity: str
    of: str
    tail: str
    head: str
    lever: tuple[str, str] = ("", "")
    span: Span | None = None
    sign: int = 1


@frozen
class Closure:
    """A way round through a group: from the point `start` over the parts to the point `end`."""

    start: str
    parts: tuple[Arm | Slid, ...]
    end: str


@frozen
class InStep:
    """Wheels that roll on each other: sum of coefficient * turn + on_slide * displacement = 0 since the drawn position.

    name    of the gear pair or the rolling wheel
    angles  links with their coefficients [m]
    """

    name: str
    angles: tuple[tuple[str, float], ...]
    slide: str = ""
    on_slide: float = 0.0


@frozen
class Roll:
    """A rolling contact gives its last unknown: the angle (or its rate) of a group of links, or of a displacement."""

    contact: InStep
    angle: str = ""
    slide: str = ""


@frozen
class Fit:
    """Links tried until they fit (样板法): positions that ruler and compass do not give, found numerically.

    angles, slides      what is found: bases of groups of links, displacements
    closures, contacts  what must hold
    """

    name: str
    angles: tuple[str, ...]
    slides: tuple[str, ...]
    closures: tuple[Closure, ...]
    contacts: tuple[InStep, ...]


@frozen
class Touch:
    """Where two wheels touch, on the line of their centres; or a wheel and its track, at right angles to it.

    ratio   how far from `centre` towards `other`; for a track, 0 and `offset` [m] to its left
    """

    point: str
    centre: str
    other: str = ""
    ratio: float = 0.0
    slide: str = ""
    offset: float = 0.0


@frozen
class Unknown:
    """One unknown scalar in a closed chain of arrows: turning of `link` over an arm, or sliding with a `sign`."""

    link: str
    slide: str
    tail: str
    head: str
    sign: int


@frozen
class Chain:
    """A closed chain of arrows: known sizes with their signs, and unknown scalars."""

    known: tuple[tuple[Size, int], ...]
    unknown: tuple[Unknown, ...]


@frozen
class Simultaneous:
    """Several chains closed at once by calculation: no order of ruler and triangle reaches their unknowns."""

    angles: tuple[str, ...]
    slides: tuple[str, ...]
    chains: tuple[Chain, ...]
    contacts: tuple[InStep, ...]


Step = Given | LayOff | Ray | Arc | Meet | Swing | Image | Measure | Roll | Fit | Touch | Simultaneous


@frozen
class Site:
    """A point of the mechanism as part of a link."""

    point: str
    link: str


@frozen
class Node:
    """A point of a plane: its name, what it belongs to as written (`B3`, `pole`, `a^n_CB`), and its site."""

    name: str
    of: str
    site: Site | None = None


@frozen
class Construction:
    """The steps of one plane in order; those of one vector equation are grouped in it."""

    plane: Plane
    parts: tuple[Step | Equation, ...]
    nodes: Mapping[str, Node]
    pole: str = ""

    @property
    def steps(self) -> Iterator[Step]:
        """Every step, one after another."""
        for part in self.parts:
            if isinstance(part, Equation):
                yield from part.steps
            else:
                yield part

    @property
    def equations(self) -> tuple[Equation, ...]:
        return tuple(part for part in self.parts if isinstance(part, Equation))

    def vectors(self) -> dict[str, Term]:
        """Every arrow of the finished polygon by name: absolute motions of known points, then the equations' terms."""
        found: dict[str, Term] = {}
        for part in self.parts:
            terms: tuple[Term, ...] = ()
            if isinstance(part, Equation):
                terms = part.left + part.right
            elif isinstance(part, LayOff):
                terms = (part.term,)
            for term in terms:
                found.setdefault(term.name(self.plane), term)
        return found


# --- what a replay starts from and what it gives ----------------------------------------------


@frozen
class TurnOf:
    """How a link's angle hangs on another's: theta = theta(base) + constant + sum of sign * driver value."""

    base: str
    constant: float = 0.0
    drivers: tuple[tuple[int, int], ...] = ()


@frozen
class Facts:
    """What is known before the pencil moves: dimensions and drivers. SI units; drivers scalar or (n,) each.

    shapes  points of each link in its axes [m]; lines: guide, origin and direction (guide's axes) of each slide
    turns   each link's angle by that of its group's base link
    slides_driven  driver number by slide
    """

    frame: str
    shapes: Mapping[str, Mapping[str, complex]]
    lines: Mapping[str, tuple[str, str, complex]]
    turns: Mapping[str, TurnOf]
    slides_driven: Mapping[str, int]
    values: tuple[Value, ...]
    rates: tuple[Value, ...]
    accelerations: tuple[Value, ...]
    drawn: Mapping[str, float] = field(default_factory=dict)
    """Angles of links [rad] and displacements of slides [m] at the drawn position, where contacts count from them."""

    def relative_angle(self, link: str) -> Value:
        """Angle of a link against its base link [rad]."""
        turn = self.turns[link]
        return turn.constant + sum(sign * self.values[k] for k, sign in turn.drivers)

    def relative_rate(self, link: str, order: int) -> Value:
        """Angular velocity (order 1) or acceleration (order 2) of a link against its base link."""
        given = self.rates if order == 1 else self.accelerations
        return sum(sign * given[k] for k, sign in self.turns[link].drivers)


@dataclass
class Plot:
    """Named points and quantities of the finished drawing; every value a scalar or an array over positions.

    position     points of the mechanism [m]; velocity [m/s], acceleration [m/s^2]: points of the polygons,
                 measured from the pole
    theta, omega, alpha          by link [rad, rad/s, rad/s^2]
    s, s_rate, s_acceleration    by slide [m, m/s, m/s^2]
    sines        sine of the angle at which two lines or circles met, by plane and point
    misses       by how much two circles, or a line and a circle, miss each other [m]; 0 or less where they meet
    near         angles by base link and displacements by slide of a position close by: what is fitted starts
                 there, and angles are counted on from there
    """

    facts: Facts
    near: Mapping[str, Value] = field(default_factory=dict)
    position: dict[str, Value] = field(default_factory=dict)
    velocity: dict[str, Value] = field(default_factory=dict)
    acceleration: dict[str, Value] = field(default_factory=dict)
    theta: dict[str, Value] = field(default_factory=dict)
    omega: dict[str, Value] = field(default_factory=dict)
    alpha: dict[str, Value] = field(default_factory=dict)
    s: dict[str, Value] = field(default_factory=dict)
    s_rate: dict[str, Value] = field(default_factory=dict)
    s_acceleration: dict[str, Value] = field(default_factory=dict)
    sines: dict[tuple[Plane, str], Value] = field(default_factory=dict)
    misses: dict[str, Value] = field(default_factory=dict)

    def points(self, plane: Plane) -> dict[str, Value]:
        return {"position": self.position, "velocity": self.velocity, "acceleration": self.acceleration}[plane]

    def arm(self, tail: str, head: str) -> Value:
        """Vector between two points of the mechanism [m]."""
        return self.position[head] - self.position[tail]

    def guide_direction(self, slide: str) -> Value:
        """Unit vector of a slide's line."""
        guide, _, direction = self.facts.lines[slide]
        return direction * np.exp(1j * self.theta[guide])

    def span(self, span: Span) -> Value:
        """Sum of the parts, in the axes of their group's base link [m]."""
        total: Value = 0j
        for part in span.parts:
            if isinstance(part, Arm):
                shape = self.facts.shapes[part.link]
                turned = np.exp(1j * self.facts.relative_angle(part.link))
                total = total + (shape[part.head] - shape[part.tail]) * turned
            else:
                total = total + part.sign * self.s[part.slide] * self.slide_line(part.slide)
        return total

    def slide_line(self, slide: str) -> Value:
        """Unit vector of a slide's line, in the axes of its guide's base link."""
        guide, _, direction = self.facts.lines[slide]
        return direction * np.exp(1j * self.facts.relative_angle(guide))

    def direction(self, direction: Direction) -> Value:
        """Unit vector of a direction."""
        match direction:
            case Along(tail, head):
                return unit(self.arm(tail, head))
            case Across(tail, head):
                return 1j * unit(self.arm(tail, head))
            case AlongGuide(slide):
                return self.guide_direction(slide)
            case AcrossGuide(slide):
                return 1j * self.guide_direction(slide)
            case Quarter(link, tail, head):
                return 1j * np.sign(self.omega[link]) * unit(self.velocity[head] - self.velocity[tail])
            case _:
                assert_never(direction)

    def arrow(self, size: Size, plane: Plane) -> Value:
        """The vector of a known term, in the units of its plane."""
        match size:
            case Drawn(tail, head):
                points = self.points(plane)
                return points[head] - points[tail]
            case Span():
                return self.span(size) * np.exp(1j * self._base_angle(size))
            case Turning(link, tail, head):
                return 1j * self.omega[link] * self.arm(tail, head)
            case Normal(link, tail, head):
                return -(self.omega[link] ** 2) * self.arm(tail, head)
            case Tangential(link, tail, head):
                return 1j * self.alpha[link] * self.arm(tail, head)
            case Coriolis(link, tail, head):
                return 2j * self.omega[link] * (self.velocity[head] - self.velocity[tail])
            case Driven(slide, sign):
                known = self.s_rate if plane == "velocity" else self.s_acceleration
                return sign * known[slide] * self.guide_direction(slide)
            case Relative():
                return self._relative(size)
            case _:
                assert_never(size)

    def _relative(self, size: Relative) -> Value:
        arm = self.arm(size.tail, size.head)
        facts = self.facts
        if size.part == "t":
            return 1j * (facts.relative_rate(size.link, 2) - facts.relative_rate(size.seen_from, 2)) * arm
        rate = facts.relative_rate(size.link, 1) - facts.relative_rate(size.seen_from, 1)
        return -(rate**2) * arm if size.part == "n" else 1j * rate * arm

    def _base_angle(self, span: Span) -> Value:
        part = span.parts[0]
        link = part.link if isinstance(part, Arm) else self.facts.lines[part.slide][0]
        return self.theta[self.facts.turns[link].base]

    def settle(self, quantity: str, base: str, value: Value) -> None:
        """Give a whole group of links that hold their angles to one another its angle or its rate."""
        table: dict[str, Value] = getattr(self, quantity)
        if quantity == "theta" and base in self.near:
            value = value + 2 * np.pi * np.round((self.near[base] - value) / (2 * np.pi))
        for link, turn in self.facts.turns.items():
            if turn.base != base:
                continue
            order = ("theta", "omega", "alpha").index(quantity)
            more = self.facts.relative_angle(link) if order == 0 else self.facts.relative_rate(link, order)
            table[link] = value + more


FIXED = complex(0.0)
"""What a fixed point of the mechanism is in a polygon: on the pole, wherever that is found."""


# --- the pencil -------------------------------------------------------------------------------


def replay(construction: Construction, plot: Plot, sides: Mapping[int, Value] | None = None) -> Plot:
    """Do what the steps say, on top of what the plot already holds; scalars or arrays alike.

    plot    the acceleration plane needs a plot with positions and velocities, and so on
    sides   crossings to take instead of those in the steps, by number of the choice: arrays try many at once
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        _begin(plot, construction.plane)
        _draw(construction, plot, sides or {})
    return plot


def _draw(construction: Construction, plot: Plot, sides: Mapping[int, Value]) -> None:
    plane, points = construction.plane, plot.points(construction.plane)
    for step in construction.steps:
        match step:
            case Given(point, also):
                points[point] = plot.facts.shapes[plot.facts.frame][point] if plane == "position" else 0j
                points.update(dict.fromkeys(also, FIXED))
            case LayOff(term, start, tip, backwards):
                assert term.size is not None
                arrow = plot.arrow(term.size, plane)
                points[tip] = points[start] - arrow if backwards else points[start] + arrow
            case Ray() | Arc():
                pass  # alone it fixes no point
            case Meet():
                points[step.point] = _meet(step, plot, plane, sides)
                if step.point == construction.pole:
                    _shift(points, construction.pole)
            case Swing():
                _swing(step, plot, sides)
            case Image(link, corners, base, point):
                points[point] = _image(plot, plane, link, corners, points[base[0]], points[base[1]])
            case Measure():
                _measure(step, plot, points)
            case Roll():
                _roll(step, plot, plane)
            case Fit():
                _fit(step, plot)
            case Touch():
                points[step.point] = _touch(step, plot)
            case Simultaneous():
                _solve_together(step, plot, plane)
            case _:
                assert_never(step)


def _shift(points: dict[str, Value], pole: str) -> None:
    """A pole found last: everything drawn so far is measured from it, and the fixed points come to lie on it."""
    place = points[pole]
    for name, value in points.items():
        points[name] = 0j * place if value is FIXED or name == pole else value - place


def _begin(plot: Plot, plane: Plane) -> None:
    """The frame stands still; what is driven against it moves as given, and so do driven slides."""
    facts = plot.facts
    quantity, slides, given = {
        "position": ("theta", plot.s, facts.values),
        "velocity": ("omega", plot.s_rate, facts.rates),
        "acceleration": ("alpha", plot.s_acceleration, facts.accelerations),
    }[plane]
    plot.settle(quantity, facts.frame, 0.0)
    slides.update({slide: given[driver] for slide, driver in facts.slides_driven.items()})


def _meet(step: Meet, plot: Plot, plane: Plane, sides: Mapping[int, Value]) -> Value:
    points = plot.points(plane)
    side = step.side if step.choice is None else sides.get(step.choice, step.side)
    match step.first, step.second:
        case Ray(p, u), Ray(q, w):
            point, sine = meet_lines(points[p], plot.direction(u), points[q], plot.direction(w))
        case Ray(p, u), Arc(c, reach):
            point, sine, miss = meet_line_circle(
                points[p], plot.direction(u), points[c], np.abs(plot.span(reach)), side
            )
            plot.misses[step.point] = miss
        case Arc(c, reach), Arc(d, other):
            point, sine, miss = meet_circles(
                points[c], np.abs(plot.span(reach)), points[d], np.abs(plot.span(other)), side
            )
            plot.misses[step.point] = miss
        case _:
            raise AssertionError("a line comes before a circle")
    plot.sines[plane, step.point] = sine
    return point


def _swing(step: Swing, plot: Plot, sides: Mapping[int, Value]) -> None:
    """|fixed part + s u| must equal the distance of the two points: s first, then the angle."""
    side = step.side if step.choice is None else sides.get(step.choice, step.side)
    line = plot.slide_line(step.slide) * (1 if Slid(step.slide) in step.span.parts else -1)
    plot.s[step.slide] = 0.0
    fixed = plot.span(step.span)
    way = plot.arm(step.pivot, step.through)
    offset, distance = cross(line, fixed), np.abs(way)
    half = root(distance**2 - offset**2)
    plot.s[step.slide] = side * half - dot(line, fixed)
    base = plot.facts.turns[step.link].base
    plot.settle("theta", base, np.angle(way) - np.angle(plot.span(step.span)))
    plot.misses[step.slide] = np.abs(offset) - distance
    plot.sines["position", step.slide] = half / distance


def _image(
    plot: Plot, plane: Plane, link: str, corners: tuple[str, str, str], first: Value, second: Value
) -> Value:
    if plane == "position":
        shape = plot.facts.shapes[link]
        ratio = (shape[corners[2]] - shape[corners[0]]) / (shape[corners[1]] - shape[corners[0]])
    else:
        ratio = plot.arm(corners[0], corners[2]) / plot.arm(corners[0], corners[1])
    return first + (second - first) * ratio


def _measure(step: Measure, plot: Plot, points: Mapping[str, Value]) -> None:
    arrow = points[step.head] - points[step.tail]
    if step.quantity == "theta":
        assert step.span is not None
        plot.settle("theta", plot.facts.turns[step.of].base, np.angle(arrow) - np.angle(plot.span(step.span)))
    elif step.quantity in ("omega", "alpha"):
        arm = plot.arm(*step.lever)
        order = 1 if step.quantity == "omega" else 2
        value = cross(arm, arrow) / np.abs(arm) ** 2 - plot.facts.relative_rate(step.of, order)
        plot.settle(step.quantity, plot.facts.turns[step.of].base, value)
    else:
        table: dict[str, Value] = getattr(plot, step.quantity)
        table[step.of] = step.sign * dot(plot.guide_direction(step.of), arrow)


# --- rolling contacts and groups ---------------------------------------------------------------


def _roll(step: Roll, plot: Plot, plane: Plane) -> None:
    """The one unknown of a contact: coefficients times turns add up to nothing."""
    coefficients, known = _in_step(step.contact, plot, plane, {step.angle} - {""}, {step.slide} - {""})
    value = -known / sum(coefficients.values())
    if step.angle:
        plot.settle(("theta", "omega", "alpha")[_order(plane)], step.angle, value)
    else:
        (plot.s, plot.s_rate, plot.s_acceleration)[_order(plane)][step.slide] = value


def _order(plane: Plane) -> int:
    return ("position", "velocity", "acceleration").index(plane)


def _in_step(
    contact: InStep, plot: Plot, plane: Plane, angles: set[str], slides: set[str]
) -> tuple[dict[str, float], Value]:
    """A contact's coefficient for each unknown, by base link or slide, and the sum of the rest."""
    order, facts = _order(plane), plot.facts
    turned = (plot.theta, plot.omega, plot.alpha)[order]
    coefficients: dict[str, float] = {}
    known: Value = 0.0
    for link, coefficient in contact.angles:
        drawn = facts.drawn.get(link, 0.0) if order == 0 else 0.0
        base = facts.turns[link].base
        if base in angles:
            coefficients[base] = coefficients.get(base, 0.0) + coefficient
            relative = facts.relative_angle(link) if order == 0 else facts.relative_rate(link, order)
            known = known + coefficient * (relative - drawn)
        else:
            known = known + coefficient * (turned[link] - drawn)
    if contact.slide in slides:
        coefficients[contact.slide] = contact.on_slide
        known = known - contact.on_slide * (facts.drawn[contact.slide] if order == 0 else 0.0)
    elif contact.slide:
        moved = (plot.s, plot.s_rate, plot.s_acceleration)[order][contact.slide]
        known = known + contact.on_slide * (moved - (facts.drawn[contact.slide] if order == 0 else 0.0))
    return coefficients, known


def _touch(step: Touch, plot: Plot) -> Value:
    centre = plot.position[step.centre]
    if step.slide:
        return centre + 1j * step.offset * plot.guide_direction(step.slide)
    return centre + step.ratio * plot.arm(step.centre, step.other)


ROUNDS = 30
FITTED = 1e-13


def _fit(step: Fit, plot: Plot) -> None:
    """Newton's method on the closures and contacts of a group, for all positions at once."""
    names = step.angles + step.slides
    known = (*plot.position.values(), *plot.theta.values(), *plot.s.values(), *plot.near.values())
    shape = np.broadcast_shapes(*(np.shape(value) for value in known))
    x = np.array([np.broadcast_to(plot.near[name], shape) for name in names], dtype=float)
    size = _reach(step, plot)
    scale = np.array([1.0] * len(step.angles) + [size] * len(step.slides))
    for _ in range(ROUNDS):
        _settle_all(step, plot, x)
        residual, slope = _closures(step, plot, shape, size)
        slope = slope * scale.reshape((-1, *(1 for _ in shape)))
        change = _solve(slope, residual) * scale.reshape((-1, *(1 for _ in shape)))
        limit = np.max(np.abs(change) / scale.reshape((-1, *(1 for _ in shape))), axis=0)
        x = x - change / np.maximum(1.0, limit / 0.5)
        if not np.any((limit > FITTED) & (limit < np.inf)):
            break
    _settle_all(step, plot, x)
    residual, slope = _closures(step, plot, shape, size)
    fits = np.max(np.abs(residual), axis=0) < 1e-10
    _settle_all(step, plot, np.where(fits, x, np.nan))
    sine = _least(slope * scale.reshape((-1, *(1 for _ in shape))))
    plot.sines["position", step.name] = np.where(fits, sine, np.nan)[()]
    plot.misses[step.name] = np.where(fits, 0.0, np.max(np.abs(residual), axis=0) * size)[()]


def _reach(step: Fit, plot: Plot) -> float:
    """The longest arm of a group: what its gaps are measured by [m]."""
    arms = [part for closure in step.closures for part in closure.parts if isinstance(part, Arm)]
    shapes = plot.facts.shapes
    lengths = [abs(shapes[a.link][a.head] - shapes[a.link][a.tail]) for a in arms]
    return max([*lengths, *(abs(c) for contact in step.contacts for _, c in contact.angles)]) or 1.0


def _settle_all(step: Fit, plot: Plot, x: np.ndarray) -> None:
    near, plot.near = plot.near, {}
    for k, base in enumerate(step.angles):
        plot.settle("theta", base, x[k][()])
    for k, slide in enumerate(step.slides):
        plot.s[slide] = x[len(step.angles) + k][()]
    plot.near = near


def _closures(step: Fit, plot: Plot, shape: tuple[int, ...], size: float) -> tuple[np.ndarray, np.ndarray]:
    """Gaps (m,) and their slopes (m, n), over positions; in units of the group's size."""
    names = step.angles + step.slides
    rows = 2 * len(step.closures) + len(step.contacts)
    gap, slope = np.zeros((rows, *shape)), np.zeros((rows, len(names), *shape))
    for k, closure in enumerate(step.closures):
        total = plot.position[closure.start] - plot.position[closure.end]
        slopes: dict[str, Value] = {}
        for part in closure.parts:
            base, arrow = _stretch(part, plot)
            total = total + arrow
            slopes[base] = slopes.get(base, 0.0) + 1j * arrow
            if isinstance(part, Slid):
                slopes[part.slide] = part.sign * plot.guide_direction(part.slide)
        gap[2 * k], gap[2 * k + 1] = np.real(total) / size, np.imag(total) / size
        for j, name in enumerate(names):
            slope[2 * k, j] = np.real(slopes.get(name, 0.0)) / size
            slope[2 * k + 1, j] = np.imag(slopes.get(name, 0.0)) / size
    for k, contact in enumerate(step.contacts, 2 * len(step.closures)):
        coefficients, known = _in_step(contact, plot, "position", set(), set())
        gap[k] = known / size
        coefficients, _ = _in_step(contact, plot, "position", set(step.angles), set(step.slides))
        for j, name in enumerate(names):
            slope[k, j] = coefficients.get(name, 0.0) / size
    return gap, slope


def _stretch(part: Arm | Slid, plot: Plot) -> tuple[str, Value]:
    """One part of a closure as it lies now, with the base link that turns it [m]."""
    if isinstance(part, Arm):
        shape = plot.facts.shapes[part.link]
        arrow = (shape[part.head] - shape[part.tail]) * np.exp(1j * plot.theta[part.link])
        return plot.facts.turns[part.link].base, arrow
    guide = plot.facts.lines[part.slide][0]
    return plot.facts.turns[guide].base, part.sign * plot.s[part.slide] * plot.guide_direction(part.slide)


def _solve(slope: np.ndarray, gap: np.ndarray) -> np.ndarray:
    """Linear equations (m, n, ...) x = (m, ...) for every position; least squares where singular."""
    matrix, right = np.moveaxis(slope, (0, 1), (-2, -1)), np.moveaxis(gap, 0, -1)[..., None]
    finite = np.isfinite(matrix).all(axis=(-2, -1)) & np.isfinite(right).all(axis=(-2, -1))
    matrix = np.where(finite[..., None, None], matrix, np.eye(*matrix.shape[-2:]))
    try:
        found = np.linalg.solve(matrix, right)
    except np.linalg.LinAlgError:
        found = np.linalg.pinv(matrix) @ right
    found = np.where(finite[..., None, None], found, np.nan)
    return np.moveaxis(found[..., 0], -1, 0)


def _least(slope: np.ndarray) -> Value:
    """How far a system is from singular: least singular value, columns of length 1. Like the sine of an angle."""
    matrix = np.moveaxis(slope, (0, 1), (-2, -1))
    lengths = np.linalg.norm(matrix, axis=-2, keepdims=True)
    matrix = np.nan_to_num(matrix / np.where(lengths > 0, lengths, 1.0))
    return np.linalg.svd(matrix, compute_uv=False)[..., -1]


def _solve_together(step: Simultaneous, plot: Plot, plane: Plane) -> None:
    """The unknown rates of a group, from all its chains of arrows at once."""
    names = step.angles + step.slides
    shape = np.broadcast_shapes(*(np.shape(v) for v in (*plot.position.values(), *plot.theta.values())))
    rows = 2 * len(step.chains) + len(step.contacts)
    right, matrix = np.zeros((rows, *shape)), np.zeros((rows, len(names), *shape))
    for k, chain in enumerate(step.chains):
        total: Value = sum((sign * plot.arrow(size, plane) for size, sign in chain.known), 0j)
        right[2 * k], right[2 * k + 1] = -np.real(total), -np.imag(total)
        for unknown in chain.unknown:
            if unknown.slide:
                column, arrow = names.index(unknown.slide), unknown.sign * plot.guide_direction(unknown.slide)
            else:
                column = names.index(plot.facts.turns[unknown.link].base)
                arrow = unknown.sign * 1j * plot.arm(unknown.tail, unknown.head)
                more = arrow * plot.facts.relative_rate(unknown.link, _order(plane))
                right[2 * k] -= np.real(more)
                right[2 * k + 1] -= np.imag(more)
            matrix[2 * k, column] += np.real(arrow)
            matrix[2 * k + 1, column] += np.imag(arrow)
    for k, contact in enumerate(step.contacts, 2 * len(step.chains)):
        coefficients, known = _in_step(contact, plot, plane, set(step.angles), set(step.slides))
        right[k] = -known
        for name, coefficient in coefficients.items():
            matrix[k, names.index(name)] = coefficient
    found = _solve(matrix, right)
    for k, base in enumerate(step.angles):
        plot.settle("omega" if plane == "velocity" else "alpha", base, found[k][()])
    table = plot.s_rate if plane == "velocity" else plot.s_acceleration
    for k, slide in enumerate(step.slides, len(step.angles)):
        table[slide] = found[k][()]
