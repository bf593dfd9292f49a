"""Long mechanisms for the tests: chains of dyads, groups of Class III in series, ladders.

Each group is placed so that it moves about as fast as the crank and is far from its dead points; a long chain placed
anyhow multiplies what it does from link to link beyond what sixteen digits tell.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from functools import cache

import numpy as np
from random_mechanisms import DYADS, Build

from graphkin.model.mechanism import FRAME, Driver, Mechanism

REACH = 0.1
"""About how long links are [m]."""
TRIES = 60
"""Places tried for each group."""

Joint = tuple[str, str, str]
"""R or P, and the two bodies."""
Twist = tuple[float, complex]
"""How a body moves: its angular velocity [rad/s], and the velocity of its point at the origin [m/s]."""


@cache
def dyads(count: int, seed: int = 0, kinds: tuple[str, ...] = DYADS) -> Mechanism:
    """A crank and so many dyads, each hung on the one before and on the frame or an earlier link."""

    def one(rng: random.Random, last: str, earlier: list[str]) -> list[Joint]:
        chain = (last, "+1", "+2", rng.choice(earlier))
        return [*zip(rng.choice(kinds), chain, chain[1:])]

    return _hung(f"dyads-{count}-{seed}", count, one)


@cache
def triads(count: int, seed: int = 0) -> Mechanism:
    """So many groups of Class III in series: a ternary link on three bars, one of which hangs on the group before."""
    return _hung(f"triads-{count}-{seed}", count, lambda rng, last, earlier: _plates(1, last))


@cache
def ladder(plates: int, seed: int = 0) -> Mechanism:
    """One group as long as it is: plates hinged one to the next, each on a bar, the first and the last on two.

    No dyad can be taken off it anywhere. With the crank it has 2 plates + 3 moving links.
    """
    return _hung(f"ladder-{plates}-{seed}", 1, lambda rng, last, earlier: _plates(plates, last))


def _plates(count: int, last: str) -> list[Joint]:
    joints = [("R", f"+{k}", f"+{k + 1}") for k in range(1, count)]
    for k, plate in enumerate((1, *range(1, count + 1), count)):
        bar = f"+{count + 1 + k}"
        joints += [("R", FRAME if k else last, bar), ("R", bar, f"+{plate}")]
    return joints


def _hung(name: str, count: int, group: Callable[[random.Random, str, list[str]], list[Joint]]) -> Mechanism:
    """Groups one on another; a group calls its own bodies +1, +2, .."""
    rng = random.Random(name)
    build = Build(rng, letters=[f"{letter}{k}" for k in range(60, 0, -1) for letter in "ABCDEFGHJKLMNQRSTUVWXYZ"])
    build.hinge(FRAME, "1")
    pivot = next(iter(build.body("1").points.values()))
    build.body("1").points[build.letter()] = pivot + REACH * build.direction()
    build.drivers.append(Driver("angle", "1", rate=2.0, acceleration=1.0))
    moving: dict[str, Twist] = {FRAME: (0.0, 0j), "1": (2.0, -2j * pivot)}
    last = "1"
    for _ in range(count):
        first = len(moving) - 1
        joints = [
            (kind, *(str(first + int(body[1:])) if body[0] == "+" else body for body in pair))
            for kind, *pair in group(rng, last, [FRAME, FRAME, *[*moving][-4:-2]])
        ]
        tried = (_placed(build, joints, moving) for _ in range(TRIES))
        _, found, part = min(tried, key=lambda each: each[0])
        _take(build, part)
        moving |= dict(sorted(found.items(), key=lambda item: int(item[0])))
        last = rng.choice([*found])
    return build.finish(name)


def _placed(build: Build, joints: list[Joint], moving: dict[str, Twist]) -> tuple[float, dict[str, Twist], Build]:
    """A group placed anyhow: how badly it moves, how it moves, and where it stands."""
    part = Build(build.rng, letters=[*build.letters], slides=[("", "", "", 0j, "", "")] * len(build.slides))
    for kind, one, two in joints:
        (part.hinge if kind == "R" else part.slide)(one, two)
    own = [body for body in part.bodies if body not in moving]
    rows, sides = [], []
    for point in {p for body in part.bodies.values() for p in body.points}:
        at = [(name, body.points[point]) for name, body in part.bodies.items() if point in body.points]
        if len(at) == 2:
            _hinge(rows, sides, own, moving, at[0][0], at[1][0], at[0][1])
    for _, guide, _, line, block, point in part.slides[len(build.slides) :]:
        _slide(rows, sides, own, moving, guide, block or "", part.bodies[block or ""].points[point], line)
    matrix, right = np.array(rows), np.array(sides)
    x = np.linalg.lstsq(matrix, right, rcond=None)[0]
    found = {body: (x[3 * k] / REACH, complex(x[3 * k + 1], x[3 * k + 2])) for k, body in enumerate(own)}
    speeds = [max(abs(turn) * REACH, abs(v + 1j * turn * z)) for b, (turn, v) in found.items() for z in part.bodies[b].points.values()]
    worst = max(*(speed / 0.2 for speed in speeds), *(0.2 / (speed + 1e-9) for speed in speeds))
    return float(np.linalg.cond(matrix)) * worst, found, part


def _hinge(rows: list, sides: list, own: list[str], moving: dict[str, Twist], one: str, two: str, at: complex) -> None:
    """Both bodies have one velocity there."""
    for along in (1 + 0j, 1j):
        _row(rows, sides, own, moving, one, two, at, along)


def _slide(
    rows: list, sides: list, own: list[str], moving: dict[str, Twist], guide: str, block: str, at: complex, line: complex
) -> None:
    """Both turn alike, and the block's point moves along the line."""
    _row(rows, sides, own, moving, guide, block, at, 1j * line)
    _row(rows, sides, own, moving, guide, block, at, None)


def _row(
    rows: list, sides: list, own: list[str], moving: dict[str, Twist], one: str, two: str, at: complex, along: complex | None
) -> None:
    """Two bodies' velocities at a place have equal parts along a direction; without one, their angular velocities."""
    row, side = np.zeros(3 * len(own)), 0.0
    for body, sign in ((one, 1.0), (two, -1.0)):
        if along is None:
            part = np.array([1.0, 0.0, 0.0])
        else:
            part = np.array([(along.conjugate() * 1j * at).real / REACH, along.real, along.imag])
        if body in own:
            row[3 * own.index(body) : 3 * own.index(body) + 3] += sign * part
        else:
            turn, velocity = moving[body]
            side -= sign * float(part @ (turn * REACH, velocity.real, velocity.imag))
    rows.append(row)
    sides.append(side)


def _take(build: Build, part: Build) -> None:
    """The group as part of the whole."""
    build.letters[:] = part.letters
    build.slides += part.slides[len(build.slides) :]
    for name, body in part.bodies.items():
        build.body(name).points |= body.points
