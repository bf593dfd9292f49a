"""Ruler, compass and protractor at work on the steps of a drafting. What does not meet is NaN."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Real, cross, meet_circles, meet_line_circle
from graphkin.construction.drafting import steps
from graphkin.construction.drafting.board import Board, Homogeneous, along, balanced, improper, joined, product, scalar
from graphkin.construction.plot import length

# --- sums done beside the drawing: angles [rad], lengths [m] ----------------------------------

ROUNDING = 1e-9  # sines below this are none


def theta_of(k: float) -> float:
    """Angle between the crank's two limit positions: 180 deg (K - 1)/(K + 1) (极位夹角)."""
    return math.pi * (k - 1) / (k + 1)


def _sine(angle: Real) -> Real:
    """The sine of an angle; 0 for what is only rounding."""
    sine = np.sin(angle)
    return np.where(np.abs(sine) < ROUNDING, 0.0, sine)[()]


RULES: Mapping[str, Callable[..., Real]] = {
    "theta": theta_of,
    "complement": lambda angle: math.pi / 2 - angle,
    "above": lambda angle: math.pi / 2 + angle / 2,
    "half": lambda value: value / 2,
    "double": lambda value: 2 * value,
    "half difference": lambda one, other: abs(one - other) / 2,
    "half sum": lambda one, other: (one + other) / 2,
    "difference": lambda one, other: one - other,
    "straight": lambda: math.pi,
    "same": lambda value: value,
    "over": lambda one, other: one / other,
    "lever": lambda rate, arm, other: rate * arm / other,
    "speed": lambda rate, arm, scale: rate * arm * scale,
    "sines": lambda side, one, other: side * abs(_sine(one) / _sine(other)),
    "sense": lambda sense, angle: sense * np.sign(np.cos(angle)),
    "sense of sines": lambda sense, one, other: sense * np.sign(np.sin(one) * np.sin(other)),
    "rate": lambda speed, arm, scale: speed / (arm * scale),
}


def replay(construction: steps.Drafting, board: Board | None = None) -> Board:
    """Do all steps, on a new board or on one that lies over a drawing.

    >>> stage = steps.Stage("", (steps.ChosenPoint("A", 0j), steps.DraftLayOff("B", "A", "r")))
    >>> board = replay(steps.Drafting({"r": 1.0}, (stage,)))
    >>> board.at("B")
    (1+0j)
    """
    board = board or Board()
    board.numbers.update(construction.given)
    board.points.update({name: balanced(np.asarray(point)) for name, point in construction.points.items()})
    for stage in construction.stages:
        draw(stage, board)
    return board


def draw(stage: steps.Stage, board: Board) -> None:
    """Do the steps of one stage."""
    numbers = board.numbers
    with np.errstate(divide="ignore", invalid="ignore"):
        for step in stage.steps:
            name = step.name
            if isinstance(step, steps.LineStep):
                board.lines[name] = ruled(step, board)
                continue
            match step:
                case steps.ChosenPoint(_, at):
                    board.points[name] = board.seen(at)
                case steps.Pricked(_, point):
                    board.points[name] = board.underlay.points[point]
                case steps.Far(_, line):
                    board.points[name] = improper(1j * along(board.lines[line]))
                case steps.DraftLayOff(_, about, size, toward, angle, sense):
                    turn = sense * numbers[angle] if angle else 0.0
                    direction = board.toward(about, toward) * np.exp(1j * turn)
                    board.points[name] = board.seen(board.at(about) + numbers[size] * direction)
                case steps.MarkOn(_, circle, turn):
                    centre, radius = board.circles[circle]
                    board.points[name] = board.seen(centre + radius * np.exp(1j * turn))
                case steps.DraftTurn(_, of, about, angle):
                    arm = board.at(of) - board.at(about)
                    board.points[name] = board.seen(board.at(about) + arm * np.exp(1j * numbers[angle]))
                case steps.DraftMeet():
                    _meet(step, board)
                case steps.CircleThrough() | steps.CircleAbout():
                    _circle(step, board)
                case steps.Reckon(_, rule, of):
                    numbers[name] = RULES[rule](*(numbers[one] for one in of))
                case steps.DraftMeasure(_, first, second):
                    numbers[name] = board.read(length(board.at(second) - board.at(first)))
                case steps.MeasureAngle(_, corner, toward, to):
                    numbers[name] = scalar(np.angle(board.toward(corner, to) / board.toward(corner, toward))).real
                case _:
                    assert_never(step)


def ruled(step: steps.LineStep, board: Board) -> Homogeneous:
    """A line, of length 1; NaN where two points to be joined coincide."""
    match step:
        case steps.Traced(_, line):
            ruling = board.underlay.lines[line]
        case steps.Through(_, first, second):
            ruling = joined(board.points[first], board.points[second])
        case steps.Slanted(_, at, toward, angle, sense):
            ruling = board.sloping(board.at(at), board.toward(at, toward) * np.exp(1j * sense * board.numbers[angle]))
        case steps.Perpendicular(_, at, to):
            ruling = product(board.points[at], improper(1j * along(board.lines[to])))
        case steps.Parallel(_, to, distance, side):
            start, direction = board.line(to)
            ruling = board.sloping(start + side * 1j * direction * board.numbers[distance], direction)
        case steps.Bisector(_, first, second):
            middle = (board.at(first) + board.at(second)) / 2
            ruling = board.sloping(middle, 1j * board.toward(first, second))
        case steps.CarriedAngle(_, at, line, start, end):
            turn = along(board.lines[end]) / along(board.lines[start])
            ruling = product(improper(along(board.lines[line]) * turn), board.points[at])
        case _:
            assert_never(step)
    return balanced(ruling)


def _circle(step: steps.CircleThrough | steps.CircleAbout, board: Board) -> None:
    if isinstance(step, steps.CircleAbout):
        centre = board.at(step.centre)
        radius = length(board.at(step.through) - centre) if step.through else board.numbers[step.radius]
    else:
        p, q, r = (board.at(name) for name in step.points)
        u, w = q - p, r - p
        area = np.asarray(2 * cross(u, w))
        middle = p + 1j * (u * length(w) ** 2 - w * length(u) ** 2) / area
        in_line = np.abs(area) <= 1e-12 * length(u) * length(w)  # but for rounding
        centre = scalar(np.where(in_line, complex(np.nan, np.nan), middle))
        board.points[step.centre] = board.seen(centre)
        radius = length(p - centre)
    board.circles[step.name] = centre, radius


def _meet(step: steps.DraftMeet, board: Board) -> None:
    if step.first in board.lines and step.second in board.lines:
        crossing = product(board.lines[step.first], board.lines[step.second])
        board.lean[step.name] = np.linalg.norm(crossing, axis=0)
        board.points[step.name] = balanced(crossing)
        return
    # both crossings of two things of which one at least is a circle
    first, *others = [board.circles[name] for name in (step.first, step.second) if name in board.circles]
    if others:
        one, other = (meet_circles(*first, *others[0], side)[0] for side in (1.0, -1.0))
    else:
        line = board.line(step.first if step.first in board.lines else step.second)
        one, other = (meet_line_circle(*line, *first, side)[0] for side in (1.0, -1.0))
    if step.near or step.far:
        known = board.at(step.near or step.far)
        far, farther = length(one - known), length(other - known)
        one = scalar(np.where(far <= farther if step.near else far >= farther, one, other))
    board.points[step.name] = board.seen(one)
