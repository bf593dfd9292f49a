"""What each handed-in value is: right, carried, wrong or missing; many students at once.

The right value counts first. A value that is not right may follow from the student's own earlier ones; such an own
value is used under a guard (`usable`), so that nothing is gained by handing in 0 or a number of the problem.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.marking.key import Key, KeyEntry

_TURN = 2 * np.pi
_SAME = 1e-6
_ANSWERABLE = 5.0
"""An own value is carried on between 1/5 and 5 times the right size."""


@frozen
class Columns:
    """The key's entries as arrays (n,)."""

    right: np.ndarray
    scatter: np.ndarray
    tolerance: np.ndarray
    angle: np.ndarray
    size: np.ndarray
    points: np.ndarray
    allowed: np.ndarray


def columns(entries: Sequence[KeyEntry]) -> Columns:
    """Entries as arrays."""
    right, scatter, tolerance, points, allowed = (
        np.array([getattr(entry, name) for entry in entries])
        for name in ("right", "scatter", "tolerance", "points", "allowed")
    )
    angle, size = (np.array([entry.sort == sort for entry in entries], dtype=bool) for sort in ("angle", "size"))
    return Columns(right, scatter, tolerance, angle, size, points, allowed)


def columns_of(table: Columns, which: np.ndarray) -> Columns:
    """Some of the columns."""
    return Columns(*(getattr(table, name)[which] for name in Columns.__match_args__))


def upright(table: Columns, values: np.ndarray) -> np.ndarray:
    """Values (.., n) with sizes without sign."""
    return np.where(table.size, np.abs(values), values) if table.size.any() else values


def differences(table: Columns, given: np.ndarray, value: np.ndarray) -> np.ndarray:
    """By how much given values are off (.., n): sizes without sign, angles modulo a turn; NaN where either is."""
    plain: np.ndarray = upright(table, given) - upright(table, value)
    if table.angle.any():
        angles = plain[..., table.angle]
        plain[..., table.angle] = angles - _TURN * np.round(angles / _TURN)
    return plain


def agrees(table: Columns, given: np.ndarray, value: np.ndarray, tolerance: np.ndarray) -> np.ndarray:
    """Whether given values are the right ones but for the tolerance, half of its last digit included."""
    with np.errstate(invalid="ignore"):
        found: np.ndarray = np.abs(differences(table, given, value)) <= tolerance * (1 + 1e-9)
        return found


def sense_only(table: Columns, given: np.ndarray, value: np.ndarray, tolerance: np.ndarray) -> np.ndarray:
    """Whether a value would be right with the other sense."""
    signed = ~table.angle & ~table.size & (np.abs(value) > tolerance)
    found: np.ndarray = signed & agrees(table, -given, value, tolerance) & ~agrees(table, given, value, tolerance)
    return found


def usable(key: Key, table: Columns, given: np.ndarray) -> np.ndarray:
    """The guard: which own values (students, n) may be carried on."""
    with np.errstate(invalid="ignore", divide="ignore"):
        size, right = np.abs(given), np.abs(table.right)
        bounded = (size >= right / _ANSWERABLE) & (size <= right * _ANSWERABLE)
    copied = np.zeros(given.shape, dtype=bool)
    for number in key.given:
        copied |= np.abs(size - abs(number)) <= _SAME * abs(number)
    angles = table.angle & np.isfinite(given)
    found: np.ndarray = np.isfinite(given) & (angles | bounded & (right > 0)) & ~copied
    return found
