"""Lengths and places of the three mechanisms of the bench, read from a graphkin method [m, rad, rad/s]."""

from __future__ import annotations

from graphkin.planning import Method


class Lengths:
    """What a peer, or a C program, needs to know of a mechanism with one driven crank AB."""

    def __init__(self, method: Method) -> None:
        self.facts = method.facts(None)
        self.start, self.omega = float(self.facts.values[0]), float(self.facts.rates[0])

    def place(self, point: str) -> complex:
        """Where a fixed point lies [m]."""
        return complex(self.facts.shapes[self.facts.frame][point])

    def arm(self, link: str, tail: str, head: str) -> complex:
        """The vector between two points of a link, in the link's axes [m]."""
        shape = self.facts.shapes[link]
        return complex(shape[head] - shape[tail])

    def length(self, link: str, tail: str, head: str) -> float:
        """The distance of two points of a link [m]."""
        return abs(self.arm(link, tail, head))

    def line(self, slide: str) -> tuple[complex, complex]:
        """A point and the direction of a fixed guide [m, 1]."""
        _, origin, direction = self.facts.lines[slide]
        return self.place(origin), complex(direction)
