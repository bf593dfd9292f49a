"""The drawing board: steps carried out one after the other, and what is on it then. What does not meet is NaN."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, field
from typing import assert_never

from graphkin.design.rules import RULES
from graphkin.design.steps import (
    Bisector,
    CircleAbout,
    CircleThrough,
    Construction,
    LayOff,
    MarkOn,
    Measure,
    MeasureAngle,
    Meet,
    Normal,
    Parallel,
    Place,
    Reckon,
    Slanted,
    Step,
    Through,
    Turned,
)
from graphkin.geometry import meet_circles, meet_line_circle, meet_lines

__all__ = ["Board", "replay"]


@dataclass
class Board:
    """What is on the drawing board: points, lines (a point and a direction), circles (centre and radius), numbers."""

    numbers: dict[str, float]
    points: dict[str, complex] = field(default_factory=dict)
    lines: dict[str, tuple[complex, complex]] = field(default_factory=dict)
    circles: dict[str, tuple[complex, float]] = field(default_factory=dict)

    def direction(self, at: str, toward: str) -> complex:
        """Unit vector from a point to another, +x where there is none."""
        if not toward:
            return 1.0 + 0j
        way = self.points[toward] - self.points[at]
        return way / abs(way) if way else complex(math.nan, math.nan)


def replay(construction: Construction) -> Board:
    """Do the steps.

    >>> from graphkin.design.steps import Stage
    >>> board = replay(Construction({"r": 1.0}, (Stage("", (Place("A", 0j), LayOff("B", "A", "r"))),)))
    >>> board.points["B"]
    (1+0j)
    """
    board = Board(dict(construction.given))
    for stage in construction.stages:
        for step in stage.steps:
            _do(step, board)
    return board


def _do(step: Step, board: Board) -> None:
    points, numbers = board.points, board.numbers
    match step:
        case Place(point, at):
            points[point] = at
        case Reckon(name, rule, of):
            numbers[name] = RULES[rule](*(numbers[one] for one in of))
        case LayOff(point, about, length, toward, angle, sense):
            turn = sense * numbers[angle] if angle else 0.0
            points[point] = points[about] + numbers[length] * board.direction(about, toward) * cmath.rect(1, turn)
        case MarkOn(point, circle, direction):
            centre, radius = board.circles[circle]
            points[point] = centre + cmath.rect(radius, direction)
        case Turned(point, of, about, angle):
            points[point] = points[about] + (points[of] - points[about]) * cmath.rect(1, numbers[angle])
        case Meet():
            points[step.point] = _met(step, board)
        case Measure(name, first, second):
            numbers[name] = abs(points[second] - points[first])
        case MeasureAngle(name, at, toward, to):
            numbers[name] = cmath.phase(board.direction(at, to) / board.direction(at, toward))
        case CircleThrough() | CircleAbout():
            _circle(step, board)
        case Slanted() | Through() | Normal() | Parallel() | Bisector():
            board.lines[step.line] = _line(step, board)
        case _:
            assert_never(step)


def _line(step: Slanted | Through | Normal | Parallel | Bisector, board: Board) -> tuple[complex, complex]:
    points = board.points
    match step:
        case Slanted(_, at, toward, angle, sense):
            return points[at], board.direction(at, toward) * cmath.rect(1, sense * board.numbers[angle])
        case Through(_, first, second):
            return points[first], board.direction(first, second)
        case Normal(_, at, to):
            return points[at], 1j * board.lines[to][1]
        case Parallel(_, to, distance, side):
            start, along = board.lines[to]
            return start + side * 1j * along * board.numbers[distance], along
        case Bisector(_, first, second):
            return (points[first] + points[second]) / 2, 1j * board.direction(first, second)


def _circle(step: CircleThrough | CircleAbout, board: Board) -> None:
    points = board.points
    if isinstance(step, CircleThrough):
        p, q, r = (points[name] for name in step.points)
        centre = _circumcentre(p, q, r)
        points[step.centre] = centre
        board.circles[step.circle] = centre, abs(p - centre)
        return
    centre = points[step.centre]
    radius = abs(points[step.through] - centre) if step.through else board.numbers[step.radius]
    board.circles[step.circle] = centre, radius


def _circumcentre(p: complex, q: complex, r: complex) -> complex:
    """Equally far from three points; NaN where they lie in line (but for rounding)."""
    u, w = q - p, r - p
    area = 2 * (u.conjugate() * w).imag
    if abs(area) <= 1e-12 * abs(u) * abs(w):
        return complex(math.nan, math.nan)
    return p + 1j * (u * abs(w) ** 2 - w * abs(u) ** 2) / area


def _met(step: Meet, board: Board) -> complex:
    """The crossing that is meant."""
    found = _crossings(step, board)
    if step.near:
        return min(found, key=lambda z: abs(z - board.points[step.near]))
    return max(found, key=lambda z: abs(z - board.points[step.far])) if step.far else found[0]


def _crossings(step: Meet, board: Board) -> list[complex]:
    lines = [board.lines[name] for name in (step.first, step.second) if name in board.lines]
    circles = [board.circles[name] for name in (step.first, step.second) if name in board.circles]
    if len(lines) == 2:
        return [complex(meet_lines(*lines[0], *lines[1])[0])]
    if lines:
        return [complex(meet_line_circle(*lines[0], *circles[0], side)[0]) for side in (1.0, -1.0)]
    return [complex(meet_circles(*circles[0], *circles[1], side)[0]) for side in (1.0, -1.0)]
