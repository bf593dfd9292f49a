"""The pencil: `replay` steps through a construction, whoever draws; a hand may do any step otherwise."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Generic, TypeVar, assert_never

import numpy as np

from graphkin.base import geometry
from graphkin.base.geometry import Leg, Real, Value, cross, dot
from graphkin.base.value import frozen
from graphkin.construction import kinds
from graphkin.construction.construction import Construction
from graphkin.construction.fitting import fit
from graphkin.construction.linear import roll, solve_together
from graphkin.construction.plot import Plot
from graphkin.construction.terms import Plane, Slid

FIXED = complex(0.0)  # what a fixed point of the mechanism is in a polygon: on the pole, wherever that is found

PlotT = TypeVar("PlotT", bound=Plot)
DrawnPlot = TypeVar("DrawnPlot", bound=Plot, contravariant=True)


@frozen
class Compass:
    """The arithmetic of a replay: of numbers by `geometry` and `fitting`; a recorder has its own."""

    leg: Leg = geometry.leg
    lines: Callable[..., tuple[Value, Value]] = geometry.meet_lines
    line_circle: Callable[..., tuple[Value, Value, Value]] = geometry.meet_line_circle
    circles: Callable[..., tuple[Value, Value, Value]] = geometry.meet_circles
    image: Callable[[Value, Value, Value], Value] = geometry.third_corner
    fit: Callable[[kinds.Fit, Plot], None] = fit
    together: Callable[[kinds.Simultaneous, Plot, Plane], None] = solve_together


class Hand(Generic[DrawnPlot]):
    """Draws each step exactly; mistakes, a student's own values, a pencil that errs are hands that do some otherwise.

    Each function is given what is right at this place of the drawing as it stands, and gives what is drawn: all that
    follows is drawn from that. Values are scalars or arrays that broadcast with the positions.
    """

    def laid(self, plot: DrawnPlot, plane: Plane, step: kinds.LayOff, arrow: Value, right: Value) -> Value:
        """The tip of a known arrow that is laid off."""
        return right

    def through(self, plot: DrawnPlot, plane: Plane, step: kinds.Meet, ray: kinds.Ray, right: Value) -> Value:
        """A point of a line."""
        return right

    def line(self, plot: DrawnPlot, plane: Plane, step: kinds.Meet, ray: kinds.Ray, right: Value) -> Value:
        """The direction of a line, of length 1."""
        return right

    def met(self, plot: DrawnPlot, plane: Plane, point: str, right: Value) -> Value:
        """The point in which two lines or circles cross."""
        return right

    def image(self, plot: DrawnPlot, plane: Plane, step: kinds.Image, right: Value) -> Value:
        """A further point of a link."""
        return right

    def read(self, plot: DrawnPlot, plane: Plane, step: kinds.Measure, right: Real) -> Real:
        """A reading of ruler and protractor: omega or alpha of a link, or a slide's rate, with its sense."""
        return right

    def rolling(self, plot: DrawnPlot, plane: Plane, contact: kinds.InStep) -> kinds.InStep:
        """The law of a rolling contact, before its unknown is found, or the equations that hold it are solved."""
        return contact


COMPASS = Compass()
EXACT: Hand[Plot] = Hand()


def replay(
    construction: Construction, plot: PlotT, sides: Mapping[int, Value] | None = None, compass: Compass = COMPASS,
    hand: Hand[PlotT] = EXACT,
) -> PlotT:  # fmt: skip
    """Do what the steps say, on top of what the plot already holds; scalars or arrays alike.

    plot    the acceleration plane needs a plot with positions and velocities, and so on
    sides   crossings to take instead of those in the steps, by number of the choice: arrays try many at once
    compass the arithmetic, where the plot's values are no numbers; hand: who draws, if not exactly
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        begin(plot, construction.plane)
        draw(construction.steps, plot, construction.plane, sides or {}, compass, construction.pole, hand)
    return plot


def begin(plot: Plot, plane: Plane) -> None:
    """The frame stands still; what is driven against it moves as given, and so do driven slides."""
    facts = plot.facts
    quantity, slides, given = {
        "position": ("theta", plot.s, facts.values),
        "velocity": ("omega", plot.s_rate, facts.rates),
        "acceleration": ("alpha", plot.s_acceleration, facts.accelerations),
    }[plane]
    plot.settle(quantity, facts.frame, 0.0)
    slides.update({slide: given[driver] for slide, driver in facts.slides_driven.items()})


def draw(
    steps: Iterable[kinds.Step], plot: PlotT, plane: Plane, sides: Mapping[int, Value], compass: Compass = COMPASS,
    pole: str = "", hand: Hand[PlotT] = EXACT,
) -> None:  # fmt: skip
    """Some steps of a replay that has begun; `pole`: that of their plane, where one of them may find it."""
    points = plot.points(plane)
    for step in steps:
        match step:
            case kinds.Given(point, also):
                points[point] = plot.facts.shapes[plot.facts.frame][point] if plane == "position" else 0j
                points.update(dict.fromkeys(also, FIXED))
            case kinds.LayOff(term, start, tip, backwards):
                assert term.size is not None
                arrow, end = plot.arrow(term.size, plane), points[start]
                points[tip] = hand.laid(plot, plane, step, arrow, end - arrow if backwards else end + arrow)
            case kinds.Ray() | kinds.Arc():
                pass  # alone it fixes no point
            case kinds.Meet(point=point):
                place = points[point] = hand.met(plot, plane, point, _meet(step, plot, plane, sides, compass, hand))
                if point == pole:  # found last: all is measured from it, and the fixed points come to lie on it
                    points.update({n: 0j * place if z is FIXED or n == pole else z - place for n, z in points.items()})
            case kinds.Swing():
                _swing(step, plot, sides, compass)
            case kinds.Image(base=(tail, head), point=point, corners=(a, b, c)):
                shape = plot.facts.shapes[step.link] if plane == "position" else plot.position
                corner = compass.image(points[tail], points[head], (shape[c] - shape[a]) / (shape[b] - shape[a]))
                points[point] = hand.image(plot, plane, step, corner)
            case kinds.Measure():
                _measure(step, plot, plane, hand)
            case kinds.Roll():
                roll(replace(step, contact=hand.rolling(plot, plane, step.contact)), plot, plane)
            case kinds.Fit():
                compass.fit(step, plot)
            case kinds.Touch():
                points[step.point] = touch(step, plot)
            case kinds.Simultaneous(contacts=contacts):
                laws = tuple(hand.rolling(plot, plane, contact) for contact in contacts)
                compass.together(replace(step, contacts=laws), plot, plane)
            case _:
                assert_never(step)


def _meet(
    step: kinds.Meet, plot: PlotT, plane: Plane, sides: Mapping[int, Value], compass: Compass, hand: Hand[PlotT]
) -> Value:
    points = plot.points(plane)
    side = step.side if step.choice is None else sides.get(step.choice, step.side)
    match step.first, step.second:
        case kinds.Ray() as one, kinds.Ray() as other:
            (p, u), (q, w) = (
                (hand.through(plot, plane, step, ray, points[ray.through]),
                 hand.line(plot, plane, step, ray, plot.direction(ray.direction)))
                for ray in (one, other)
            )  # fmt: skip
            point, sine = compass.lines(p, u, q, w)
        case kinds.Ray(p, u), kinds.Arc(c, reach):
            radius = np.abs(plot.span(reach))
            point, sine, miss = compass.line_circle(points[p], plot.direction(u), points[c], radius, side)
            plot.misses[step.point] = miss.real
        case kinds.Arc(c, reach), kinds.Arc(d, other_reach):
            radii = np.abs(plot.span(reach)), np.abs(plot.span(other_reach))
            point, sine, miss = compass.circles(points[c], radii[0], points[d], radii[1], side)
            plot.misses[step.point] = miss.real
        case _:
            raise AssertionError("a line comes before a circle")
    plot.sines[plane, step.point] = sine.real
    return point


def _swing(step: kinds.Swing, plot: Plot, sides: Mapping[int, Value], compass: Compass) -> None:
    """|fixed part + s u| must equal the distance of the two points: s first, then the angle."""
    side = step.side if step.choice is None else sides.get(step.choice, step.side)
    line = plot.slide_line(step.slide) * (1 if Slid(step.slide) in step.span.parts else -1)
    plot.s[step.slide] = 0.0
    fixed = plot.span(step.span)
    arm = plot.arm(step.pivot, step.through)
    offset, distance = cross(line, fixed), np.abs(arm)
    half = compass.leg(distance, offset)
    plot.s[step.slide] = (side * half - dot(line, fixed)).real
    base = plot.facts.turns[step.link].base
    plot.settle("theta", base, np.angle(arm) - np.angle(plot.span(step.span)))
    plot.misses[step.slide] = np.abs(offset) - distance
    plot.sines["position", step.slide] = half / distance


def _measure(step: kinds.Measure, plot: PlotT, plane: Plane, hand: Hand[PlotT]) -> None:
    points, base = plot.points(plane), plot.facts.turns[step.of].base if step.of in plot.facts.turns else ""
    arrow = points[step.head] - points[step.tail]
    if step.quantity == "theta":
        assert step.span is not None
        plot.settle("theta", base, np.angle(arrow) - np.angle(plot.span(step.span)))
    elif step.quantity in ("omega", "alpha"):
        arm = plot.arm(*step.lever)
        value = hand.read(plot, plane, step, cross(arm, arrow) / np.abs(arm) ** 2)
        rate = plot.facts.relative_rate(step.of, 1 if step.quantity == "omega" else 2)
        plot.settle(step.quantity, base, value - rate, of=step.of)
    else:
        table: dict[str, Real] = getattr(plot, step.quantity)
        table[step.of] = hand.read(plot, plane, step, step.sign * dot(plot.guide_direction(step.of), arrow))


def touch(step: kinds.Touch, plot: Plot) -> Value:
    """The point in which two wheels touch, or a wheel and its track [m]."""
    centre = plot.position[step.centre]
    if step.slide:
        return centre + 1j * step.offset * plot.guide_direction(step.slide)
    return centre + step.ratio * plot.arm(step.centre, step.other)
