"""Boxes and lines on paper: which overlap, which pass through which, which cross.

All are places (2, ..), x and y of each [mm], that broadcast against one another; a box is its corners low and high, a
line its ends.
"""

from __future__ import annotations

from typing import Any


def overlap(low: Any, high: Any, other_low: Any, other_high: Any) -> Any:
    """Whether boxes overlap others; those that only touch do not."""
    found = (low < other_high) & (high > other_low)
    return found[0] & found[1]


def through(start: Any, end: Any, low: Any, high: Any) -> Any:
    """Whether lines, whose surroundings overlap boxes, pass through these: no box lies on one side of its line.

    A level or upright line is as large as its surroundings, and does.
    """
    way, half = end - start, (high - low) / 2
    wide = abs(way)
    found = abs(_turn(way, (low + high) / 2 - start)) <= wide[0] * half[1] + wide[1] * half[0]
    return found | ~(wide[0] * wide[1] > 0)


def meet(start: Any, end: Any, other: Any, other_end: Any, touch: bool = False) -> Any:
    """Whether lines cross others: each has its ends on both sides of the other, and none of them upon it; touch: or
    upon it, where their surroundings overlap."""
    way, other_way, off = end - start, other_end - other, other - start
    first, second, between = _turn(way, off), _turn(other_way, off), _turn(way, other_way)
    first, second = first * (first + between), second * (second + between)
    return (first <= 0) & (second <= 0) if touch else (first < 0) & (second < 0)


def _turn(way: Any, off: Any) -> Any:
    """On which side of a way a place lies."""
    return way[0] * off[1] - way[1] * off[0]
