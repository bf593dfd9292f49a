"""When two lengths count as equal."""

EVEN = 1e-9
"""Sums of lengths that differ by less than this part of all lengths together are equal: a change point."""


def even(difference: float, size: float) -> float:
    """A difference of sums of lengths, 0 where it is 0 but for rounding."""
    return 0.0 if abs(difference) <= EVEN * size else difference
