"""The key by which a problem is marked: right values, what paper allows, and the outcome of each mistake; and values
held against it, many students at once.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import field, fields, replace
from functools import cached_property
from typing import Literal

import numpy as np

from graphkin.base.value import bulky, frozen

Sort = Literal["sense", "size", "angle"]
Doubt = Literal["", "steep", "dead point", "too small"]
"""The reason for which paper tells a value badly: it scatters otherwise than in proportion to the pencil's errors; it
cannot be told at all, near a dead point, or since it may be off by most of its size."""
MOST = 0.75  # where a value may be off by a larger part, paper cannot tell it
_SIGMAS = 3.0  # nearly all that a pencil draws lies within so many standard deviations
TELLS = 0.15  # of a value that may be off by a larger part only what is off by no more than this is right
Name = tuple[str, str, tuple[str, ...], str]
"""A mistake as it is made: its id, which way of it, what it was made with, and with what instead."""


@frozen
class Marking:
    """The rules by which a problem is marked.

    lengths, angle   what a pencil errs by: of lengths, in the units of each plane, and of directions [rad]
    scales           of the paper, as a mechanism file has them
    sigmas           how many standard deviations are right
    relative         a part of the right value instead, where it is not 0
    follows          what a value is worth that follows rightly from a wrong one
    """

    lengths: Mapping[str, float]
    angle: float
    scales: Mapping[str, float] = field(default_factory=dict)
    sigmas: float = 3.0
    relative: float = 0.0
    follows: float = 1.0

    @property
    def on_paper(self) -> tuple[float, float]:
        """The errors of the pencil on paper [mm, deg]."""
        return self.lengths["position"] / self.scales["length"], math.degrees(self.angle)


@frozen
class KeyEntry:
    """One quantity that may be handed in, SI.

    text       as it is read: "omega 3"
    sort       "sense": its sign says which way; "size": of a vector, without sign; "angle": counts modulo a turn
    scatter    standard deviation of what a pencil gives, rounding in print with it
    tolerance  what may be off
    points     what it is worth; 0 where it is on the way and is not asked
    doubt      why paper cannot tell it well; "" where it can
    """

    text: str
    unit: str
    sort: Sort
    right: float
    scatter: float
    tolerance: float
    points: float = 0.0
    doubt: Doubt = ""

    @property
    def allowed(self) -> float:
        """The most a right value may be off; where a pencil may err by more than `TELLS`, what only the tolerance lets
        in is neither right nor wrong."""
        paper = replace(self, tolerance=_SIGMAS * self.scatter)
        told = self.doubt in ("", "steep") and part_off(paper, math.inf) <= TELLS
        return self.tolerance if told else min(self.tolerance, TELLS * abs(self.right))


def part_off(entry: KeyEntry, usual: float) -> float:
    """The part of a value that may be off: of its usual size where it is 0 or, as places and angles, has no zero of
    its own."""
    size = abs(entry.right) if "/s" in entry.unit or entry.unit == "1" else 0.0
    return entry.tolerance / (size or usual)


@frozen
class Hypotheses:
    """Outcomes of mistakes: a row each, a column a quantity of the key; NaN where it says nothing of a quantity.

    names     of the mistakes of each row: one or two
    values    (m, n), SI; scatters (m, n): their standard deviations
    together  correlation of each row's scatters (m, n, n); NaN, or None: as right values scatter
    """

    names: tuple[tuple[Name, ...], ...]
    values: np.ndarray
    scatters: np.ndarray
    together: np.ndarray | None = None

    def wider(self, more: np.ndarray) -> Hypotheses:
        """With further errors of the quantities (n,), each its own."""
        scatters = np.hypot(self.scatters, more)
        part = self.scatters / scatters
        together = None if self.together is None else less_together(self.together, part)
        return replace(self, scatters=scatters, together=together)

    @cached_property
    def kinds(self) -> np.ndarray:
        """The same number for rows whose mistakes have the same ids (m,)."""
        numbers: dict[tuple[str, ...], int] = {}
        ids = (tuple(name[0] for name in row) for row in self.names)
        return np.array([numbers.setdefault(each, len(numbers)) for each in ids], dtype=int)


def less_together(together: np.ndarray, part: np.ndarray) -> np.ndarray:
    """Correlations (.., n, n) where but a part (.., n) of each scatter is what it was."""
    own = np.eye(part.shape[-1], dtype=bool)
    return np.where(own, together, together * part[..., :, None] * part[..., None, :])


@frozen
class KeyStep:
    """One vector equation: the arrows of both sides as they are named, and the rotations that are read off it."""

    plane: str
    left: tuple[str, ...]
    right: tuple[str, ...]
    gives: tuple[str, ...]


@bulky
class Key:
    """A problem's key.

    text        the mechanism file; what follows from a student's own values is drawn anew from it
    together    correlation of the quantities' scatters (n, n)
    further     keys of the further positions that the problem asks for, the second position's first
    """

    name: str
    text: str
    coincident: str
    marking: Marking
    entries: tuple[KeyEntry, ...]
    together: np.ndarray
    singles: Hypotheses
    title: Mapping[str, str] = field(default_factory=dict)
    steps: tuple[KeyStep, ...] = ()
    further: tuple[Key, ...] = ()

    @property
    def positions(self) -> tuple[Key, ...]:
        """A key for each position, the drawn one first."""
        return self, *self.further


# --- values against the key --------------------------------------------------------------------


_TURN = 2 * np.pi


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
    return Columns(*(getattr(table, each.name)[which] for each in fields(Columns)))


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
    """Given values that are the right ones but for the tolerance, half of its last digit included, as booleans."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.abs(differences(table, given, value)) <= tolerance * (1 + 1e-9))


def sense_only(table: Columns, given: np.ndarray, value: np.ndarray, tolerance: np.ndarray) -> np.ndarray:
    """Values that would be right with the other sense, as booleans."""
    signed = ~table.angle & ~table.size & (np.abs(value) > tolerance)
    with_other, as_given = agrees(table, -given, value, tolerance), agrees(table, given, value, tolerance)
    return np.asarray(signed & with_other & ~as_given)
