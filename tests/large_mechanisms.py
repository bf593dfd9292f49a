"""Long mechanisms for the tests: chains of dyads, triads in series, ladders. Poses first, dimensions from them."""

from __future__ import annotations

import cmath
import itertools
import math
import random

from random_mechanisms import DYADS, Body, Build

from graphkin.mechanism import FRAME, Driver, Mechanism

CRANK = 2.0
"""How fast cranks turn [rad/s]."""


def dyads(count: int, seed: int = 0, kinds: tuple[str, ...] = DYADS) -> Mechanism:
    """A crank and so many dyads of random kinds, each hung on the one before and on the frame or an earlier link."""
    build = _begun(f"dyads{count}-{seed}")
    rng, known = build.rng, ["1"]
    for _ in range(count):
        one, two = str(len(known) + 1), str(len(known) + 2)
        way = (known[-1], one, two, rng.choice((FRAME, FRAME, known[max(0, len(known) - 4)])))
        for joint, body, other in zip(rng.choice(kinds), way, way[1:]):
            (build.hinge if joint == "R" else build.slide)(body, other)
        known += [one, two]
    return build.finish(f"dyads-{count}-{seed}")


def triads(count: int, seed: int = 0) -> Mechanism:
    """So many groups of Class III in series: a ternary link on three bars, the next group's first bar on one of them."""
    build = _begun(f"triads{count}-{seed}")
    ground = "1"
    for k in range(count):
        plate, *legs = (str(4 * k + number) for number in (2, 3, 4, 5))
        for leg, holder in zip(legs, (ground, FRAME, FRAME)):
            build.hinge(holder, leg)
            build.hinge(leg, plate)
        ground = legs[1]
    return build.finish(f"triads-{count}-{seed}")


def ladder(rungs: int, seed: int = 0) -> Mechanism:
    """A ladder of bars as rungs between two rails of bars, which lean on the frame: one group as long as it is.

    Rail links 2, 5, 8, .. and 3, 6, 9, ..; rungs 4, 7, 10, ..: no dyad can be taken off it anywhere.
    """
    raise NotImplementedError


def _begun(name: str) -> Build:
    """A driven crank on the frame, and names enough."""
    rng = random.Random(name)
    build = Build(rng, letters=[f"{letter}{k}" for k in range(40, 0, -1) for letter in "ABCDEFGHJKLMNQRSTUVWXYZ"])
    build.body(FRAME)
    build.hinge(FRAME, "1")
    build.body("1").points[build.letter()] = build.place()
    build.drivers.append(Driver("angle", "1", rate=CRANK))
    return build
