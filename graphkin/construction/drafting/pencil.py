"""What ruler, compass and protractor do for each step. What does not meet is NaN."""

from __future__ import annotations

from typing import assert_never

import numpy as np

from graphkin.base.geometry import Value, cross, meet_circles, meet_line_circle
from graphkin.construction.drafting.board import Board
from graphkin.construction.drafting.projective import Homogeneous, along, balanced, improper, joined, product, scalar
from graphkin.construction.drafting.rules import RULES
from graphkin.construction.drafting.steps import (
    Bisector,
    CarriedAngle,
    ChosenPoint,
    CircleAbout,
    CircleThrough,
    Drafting,
    DraftLayOff,
    DraftMeasure,
    DraftMeet,
    DraftTurn,
    Far,
    LineStep,
    MarkOn,
    MeasureAngle,
    Parallel,
    Perpendicular,
    Pricked,
    Reckon,
    Slanted,
    Stage,
    Step,
    Through,
    Traced,
)


def replay(construction: Drafting, board: Board | None = None) -> Board:
    """Do all steps, on a new board or on one that lies over a drawing.

    >>> board = replay(Drafting({"r": 1.0}, (Stage("", (ChosenPoint("A", 0j), DraftLayOff("B", "A", "r"))),)))
    >>> board.at("B")
    (1+0j)
    """
    board = board or Board()
    board.numbers.update(construction.given)
    board.points.update({name: balanced(np.asarray(point)) for name, point in construction.points.items()})
    for stage in construction.stages:
        draw(stage, board)
    return board


def draw(stage: Stage, board: Board) -> None:
    """Do the steps of one stage."""
    with np.errstate(divide="ignore", invalid="ignore"):
        for step in stage.steps:
            _do(step, board)


def _do(step: Step, board: Board) -> None:
    numbers = board.numbers
    if isinstance(step, LineStep):
        board.lines[step.name] = ruled(step, board)
        return
    match step:
        case ChosenPoint() | Pricked() | Far() | DraftLayOff() | MarkOn() | DraftTurn():
            board.points[step.name] = _point(step, board)
        case DraftMeet():
            _meet(step, board)
        case CircleThrough() | CircleAbout():
            _circle(step, board)
        case Reckon(name, rule, of):
            numbers[name] = RULES[rule](*(numbers[one] for one in of))
        case DraftMeasure(name, first, second):
            numbers[name] = board.read(abs(board.at(second) - board.at(first)))
        case MeasureAngle(name, at, toward, to):
            numbers[name] = scalar(np.angle(board.toward(at, to) / board.toward(at, toward)))
        case _:
            assert_never(step)


def _point(step: ChosenPoint | Pricked | Far | DraftLayOff | MarkOn | DraftTurn, board: Board) -> Homogeneous:
    match step:
        case ChosenPoint(_, at):
            return board.seen(at)
        case Pricked(_, point):
            return board.underlay.points[point]
        case Far(_, line):
            return improper(1j * along(board.lines[line]))
        case DraftLayOff(_, about, length, toward, angle, sense):
            turn = sense * board.numbers[angle] if angle else 0.0
            way = board.toward(about, toward) * np.exp(1j * turn)
            return board.seen(board.at(about) + board.numbers[length] * way)
        case MarkOn(_, circle, turn):
            centre, radius = board.circles[circle]
            return board.seen(centre + radius * np.exp(1j * turn))
        case DraftTurn(_, of, about, angle):
            arm = board.at(of) - board.at(about)
            return board.seen(board.at(about) + arm * np.exp(1j * board.numbers[angle]))
        case _:
            assert_never(step)


def ruled(step: LineStep, board: Board) -> Homogeneous:
    """A line, of length 1; NaN where two points to be joined coincide."""
    match step:
        case Traced(_, line):
            found = board.underlay.lines[line]
        case Through(_, first, second):
            found = joined(board.points[first], board.points[second])
        case Slanted(_, at, toward, angle, sense):
            found = board.sloping(board.at(at), board.toward(at, toward) * np.exp(1j * sense * board.numbers[angle]))
        case Perpendicular(_, at, to):
            found = product(board.points[at], improper(1j * along(board.lines[to])))
        case Parallel(_, to, distance, side):
            start, way = board.line(to)
            found = board.sloping(start + side * 1j * way * board.numbers[distance], way)
        case Bisector(_, first, second):
            middle = (board.at(first) + board.at(second)) / 2
            found = board.sloping(middle, 1j * board.toward(first, second))
        case CarriedAngle(_, at, line, start, end):
            turn = along(board.lines[end]) / along(board.lines[start])
            found = product(improper(along(board.lines[line]) * turn), board.points[at])
        case _:
            assert_never(step)
    return balanced(found)


def _circle(step: CircleThrough | CircleAbout, board: Board) -> None:
    if isinstance(step, CircleThrough):
        p, q, r = (board.at(name) for name in step.points)
        centre = _circumcentre(p, q, r)
        board.points[step.centre] = board.seen(centre)
        board.circles[step.name] = centre, abs(p - centre)
        return
    centre = board.at(step.centre)
    radius = abs(board.at(step.through) - centre) if step.through else board.numbers[step.radius]
    board.circles[step.name] = centre, radius


def _circumcentre(p: Value, q: Value, r: Value) -> Value:
    """Equally far from three points; NaN where they lie in line (but for rounding)."""
    u, w = q - p, r - p
    area = np.asarray(2 * cross(u, w))
    centre = p + 1j * (u * abs(w) ** 2 - w * abs(u) ** 2) / area
    return scalar(np.where(abs(area) <= 1e-12 * abs(u) * abs(w), complex(np.nan, np.nan), centre))


# --- where two things meet --------------------------------------------------------------------


def _meet(step: DraftMeet, board: Board) -> None:
    if step.first in board.lines and step.second in board.lines:
        found = product(board.lines[step.first], board.lines[step.second])
        board.lean[step.name] = np.linalg.norm(found, axis=0)
        board.points[step.name] = balanced(found)
    else:
        board.points[step.name] = board.seen(_meant(step, board))


def _meant(step: DraftMeet, board: Board) -> Value:
    """Of two crossings of which one is a circle's, the one that is meant."""
    one, other = _crossings(step, board)
    if not step.near and not step.far:
        return one
    known = board.at(step.near or step.far)
    far, farther = abs(one - known), abs(other - known)
    return scalar(np.where(far <= farther if step.near else far >= farther, one, other))


def _crossings(step: DraftMeet, board: Board) -> tuple[Value, Value]:
    first, *others = [board.circles[name] for name in (step.first, step.second) if name in board.circles]
    if others:
        left, right = (meet_circles(*first, *others[0], side)[0] for side in (1.0, -1.0))
    else:
        line = board.line(step.first if step.first in board.lines else step.second)
        left, right = (meet_line_circle(*line, *first, side)[0] for side in (1.0, -1.0))
    return left, right
