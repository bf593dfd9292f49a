"""Both polygons drawn again by another hand, on the mechanism as it was drawn: many hands at once by arrays.

A reader of the steps like `construction.replay`, but one that asks a hand at each of them. The position plane stays.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import count
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Value, cross, dot, meet_lines
from graphkin.construction import (
    Arc,
    Construction,
    Fit,
    Given,
    Image,
    LayOff,
    Measure,
    Meet,
    Plane,
    Plot,
    Ray,
    Roll,
    Simultaneous,
    Swing,
    Touch,
)
from graphkin.construction.chains import solve_together
from graphkin.construction.pencil import FIXED
from graphkin.construction.rolling import roll
from graphkin.marking.hand import Hand, Redrawing
from graphkin.planning import Method

RIGHT = Hand()


def redraw(method: Method, right: Plot, hand: Hand = RIGHT, shape: tuple[int, ...] = ()) -> Redrawing:
    """Velocities and accelerations by a hand, at the positions of a plot, from the rates of that.

    shape  of the values, where the hand gives arrays: it broadcasts with that of the positions
    """
    plot = Redrawing(
        hand.facts(right.facts), right.near, right.follows, right.position,
        theta=dict(right.theta), s=right.s, by_hand=hand, usual=method.mechanism.usual,
    )  # fmt: skip
    if shape and _together(method):
        plot.theta[plot.facts.frame] = np.zeros(shape)  # what is solved together takes its shape from the angles
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for construction in (method.velocity, method.acceleration):
            _begin(plot, construction.plane)
            _draw(construction, plot, hand)
    return plot


def _together(method: Method) -> bool:
    polygons = (method.velocity, method.acceleration)
    return any(isinstance(step, Simultaneous) for polygon in polygons for step in polygon.steps)


def _begin(plot: Redrawing, plane: Plane) -> None:
    facts, velocity = plot.facts, plane == "velocity"
    slides, given = (plot.s_rate, facts.rates) if velocity else (plot.s_acceleration, facts.accelerations)
    plot.settle("omega" if velocity else "alpha", facts.frame, 0.0)
    slides.update({slide: given[driver] for slide, driver in facts.slides_driven.items()})


def _draw(construction: Construction, plot: Redrawing, hand: Hand) -> None:
    plane, points = construction.plane, plot.points(construction.plane)
    for number, step in zip(count(), construction.steps, strict=False):
        match step:
            case Given(point, also):
                points[point] = 0j
                points.update(dict.fromkeys(also, FIXED))
            case LayOff():
                _lay_off(step, plot, plane, hand)
            case Ray():
                pass  # alone it fixes no point
            case Meet():
                plot.met[plane, step.point] = _meet(step, number, plot, plane, hand)
                points[step.point] = hand.met(plot, plane, step.point, plot.met[plane, step.point])
                if step.point == construction.pole:
                    plot.met[plane, step.point] = 0j
                    _shift(points, construction.pole)
            case Image():
                plot.met[plane, step.point] = _image(step, plot, points)
                points[step.point] = hand.image(plot, plane, step, plot.met[plane, step.point])
            case Measure():
                _measure(step, plot, plane, hand)
            case Roll():
                roll(step, plot, plane)
            case Simultaneous():
                contacts = tuple(hand.rolling(plot, plane, contact) for contact in step.contacts)
                solve_together(replace(step, contacts=contacts), plot, plane)
            case Arc() | Swing() | Fit() | Touch():
                raise AssertionError("a step of the position plane")
            case _:
                assert_never(step)


def _lay_off(step: LayOff, plot: Redrawing, plane: Plane, hand: Hand) -> None:
    assert step.term.size is not None
    points = plot.points(plane)
    arrow = plot.arrow(step.term.size, plane)
    plot.laid[plane, step.term.tail, step.term.head] = arrow
    end = points[step.start] - arrow if step.backwards else points[step.start] + arrow
    points[step.tip] = hand.laid(plot, plane, step, end)


def _shift(points: dict[str, Value], pole: str) -> None:
    """A pole found last: everything drawn so far is measured from it."""
    place = points[pole]
    for name, value in points.items():
        points[name] = 0j * place if value is FIXED or name == pole else value - place


def _meet(step: Meet, number: int, plot: Redrawing, plane: Plane, hand: Hand) -> Value:
    points = plot.points(plane)
    first, second = step.first, step.second
    assert isinstance(first, Ray)
    assert isinstance(second, Ray)
    (p, u), (q, w) = (
        (hand.through(plot, plane, number, ray, points[ray.through]),
         hand.line(plot, plane, number, ray, plot.direction(ray.direction)))
        for ray in (first, second)
    )  # fmt: skip
    point, plot.sines[plane, step.point] = meet_lines(p, u, q, w)
    return point


def _image(step: Image, plot: Redrawing, points: Mapping[str, Value]) -> Value:
    first, second, third = step.corners
    tail, head = points[step.base[0]], points[step.base[1]]
    return tail + (head - tail) * (plot.arm(first, third) / plot.arm(first, second))


def _measure(step: Measure, plot: Redrawing, plane: Plane, hand: Hand) -> None:
    points, facts = plot.points(plane), plot.facts
    arrow = points[step.head] - points[step.tail]
    if step.quantity in ("omega", "alpha"):
        arm = plot.arm(*step.lever)
        value = hand.read(plot, plane, step, cross(arm, arrow) / np.abs(arm) ** 2)
        plot.reading = step.of
        rate = facts.relative_rate(step.of, 1 if step.quantity == "omega" else 2)
        plot.settle(step.quantity, facts.turns[step.of].base, value - rate)
        plot.reading = ""
    else:
        table: dict[str, Value] = getattr(plot, step.quantity)
        table[step.of] = hand.read(plot, plane, step, step.sign * dot(plot.guide_direction(step.of), arrow))
