"""`replay`: what the pencil does, one function a kind of step."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Leg, Value, cross, dot, leg, meet_circles, meet_line_circle, meet_lines, third_corner
from graphkin.base.value import frozen
from graphkin.construction.chains import solve_together
from graphkin.construction.construction import Construction
from graphkin.construction.fitting import fit
from graphkin.construction.kinds import (
    Arc,
    Fit,
    Given,
    Image,
    LayOff,
    Measure,
    Meet,
    Ray,
    Roll,
    Simultaneous,
    Step,
    Swing,
    Touch,
)
from graphkin.construction.plot import Plot
from graphkin.construction.rolling import roll
from graphkin.construction.terms import Plane, Slid

FIXED = complex(0.0)
"""What a fixed point of the mechanism is in a polygon: on the pole, wherever that is found."""


@frozen
class Compass:
    """What finds crossings, and what is calculated: of numbers by `geometry` and `fitting`; where a replay is recorded,
    what records them."""

    leg: Leg = leg
    lines: Callable[..., tuple[Value, Value]] = meet_lines
    line_circle: Callable[..., tuple[Value, Value, Value]] = meet_line_circle
    circles: Callable[..., tuple[Value, Value, Value]] = meet_circles
    image: Callable[[Value, Value, Value], Value] = third_corner
    fit: Callable[[Fit, Plot], None] = fit
    together: Callable[[Simultaneous, Plot, Plane], None] = solve_together


COMPASS = Compass()


def replay(
    construction: Construction, plot: Plot, sides: Mapping[int, Value] | None = None, compass: Compass = COMPASS
) -> Plot:
    """Do what the steps say, on top of what the plot already holds; scalars or arrays alike.

    plot    the acceleration plane needs a plot with positions and velocities, and so on
    sides   crossings to take instead of those in the steps, by number of the choice: arrays try many at once
    compass what finds the crossings, where the plot's values are no numbers
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        begin(plot, construction.plane)
        draw(construction.steps, plot, construction.plane, sides or {}, compass, construction.pole)
    return plot


def draw(
    steps: Iterable[Step], plot: Plot, plane: Plane, sides: Mapping[int, Value], compass: Compass = COMPASS,
    pole: str = "",
) -> None:  # fmt: skip
    """Some steps of a replay that has begun; `pole`: that of their plane, where one of them may find it."""
    points = plot.points(plane)
    for step in steps:
        match step:
            case Given():
                _start(step, plot, plane)
            case LayOff():
                points[step.tip] = _laid_off(step, plot, plane)
            case Ray() | Arc():
                pass  # alone it fixes no point
            case Meet():
                points[step.point] = _meet(step, plot, plane, sides, compass)
                if step.point == pole:
                    _shift(points, pole)
            case Swing():
                _swing(step, plot, sides, compass)
            case Image(link, corners, base, point):
                ratio = _ratio(plot, plane, link, corners)
                points[point] = compass.image(points[base[0]], points[base[1]], ratio)
            case Measure():
                _measure(step, plot, points)
            case Roll():
                roll(step, plot, plane)
            case Fit():
                compass.fit(step, plot)
            case Touch():
                points[step.point] = touch(step, plot)
            case Simultaneous():
                compass.together(step, plot, plane)
            case _:
                assert_never(step)


def _start(step: Given, plot: Plot, plane: Plane) -> None:
    points = plot.points(plane)
    points[step.point] = plot.facts.shapes[plot.facts.frame][step.point] if plane == "position" else 0j
    points.update(dict.fromkeys(step.also, FIXED))


def _laid_off(step: LayOff, plot: Plot, plane: Plane) -> Value:
    """Where the pencil comes to, from the start of an arrow to its head or the other way."""
    assert step.term.size is not None
    start, arrow = plot.points(plane)[step.start], plot.arrow(step.term.size, plane)
    return start - arrow if step.backwards else start + arrow


def _shift(points: dict[str, Value], pole: str) -> None:
    """A pole found last: everything drawn so far is measured from it, and the fixed points come to lie on it."""
    place = points[pole]
    for name, value in points.items():
        points[name] = 0j * place if value is FIXED or name == pole else value - place


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


def _meet(step: Meet, plot: Plot, plane: Plane, sides: Mapping[int, Value], compass: Compass) -> Value:
    points = plot.points(plane)
    side = step.side if step.choice is None else sides.get(step.choice, step.side)
    match step.first, step.second:
        case Ray(p, u), Ray(q, w):
            point, sine = compass.lines(points[p], plot.direction(u), points[q], plot.direction(w))
        case Ray(p, u), Arc(c, reach):
            point, sine, miss = compass.line_circle(
                points[p], plot.direction(u), points[c], np.abs(plot.span(reach)), side
            )
            plot.misses[step.point] = miss
        case Arc(c, reach), Arc(d, other):
            point, sine, miss = compass.circles(
                points[c], np.abs(plot.span(reach)), points[d], np.abs(plot.span(other)), side
            )
            plot.misses[step.point] = miss
        case _:
            raise AssertionError("a line comes before a circle")
    plot.sines[plane, step.point] = sine
    return point


def _swing(step: Swing, plot: Plot, sides: Mapping[int, Value], compass: Compass) -> None:
    """|fixed part + s u| must equal the distance of the two points: s first, then the angle."""
    side = step.side if step.choice is None else sides.get(step.choice, step.side)
    line = plot.slide_line(step.slide) * (1 if Slid(step.slide) in step.span.parts else -1)
    plot.s[step.slide] = 0.0
    fixed = plot.span(step.span)
    way = plot.arm(step.pivot, step.through)
    offset, distance = cross(line, fixed), np.abs(way)
    half = compass.leg(distance, offset)
    plot.s[step.slide] = side * half - dot(line, fixed)
    base = plot.facts.turns[step.link].base
    plot.settle("theta", base, np.angle(way) - np.angle(plot.span(step.span)))
    plot.misses[step.slide] = np.abs(offset) - distance
    plot.sines["position", step.slide] = half / distance


def _ratio(plot: Plot, plane: Plane, link: str, corners: tuple[str, str, str]) -> Value:
    """Of two sides of a link, from the first corner."""
    if plane == "position":
        shape = plot.facts.shapes[link]
        return (shape[corners[2]] - shape[corners[0]]) / (shape[corners[1]] - shape[corners[0]])
    return plot.arm(corners[0], corners[2]) / plot.arm(corners[0], corners[1])


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


def touch(step: Touch, plot: Plot) -> Value:
    """Where two wheels touch, or a wheel and its track [m]."""
    centre = plot.position[step.centre]
    if step.slide:
        return centre + 1j * step.offset * plot.guide_direction(step.slide)
    return centre + step.ratio * plot.arm(step.centre, step.other)
