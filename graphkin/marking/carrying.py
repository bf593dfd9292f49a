"""Carried errors: what follows from students' own wrong values, and which of these enter it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.marking.asked import ArrowPlaces, arrows_of
from graphkin.marking.consequences import combined
from graphkin.marking.follow_through import replay_with
from graphkin.marking.key import Key
from graphkin.marking.verdicts import Columns, agrees, columns, sense_only, usable
from graphkin.model.quantities import Moving, Quantity, Rotation
from graphkin.planning import Method

_FLAT = np.sin(np.radians(0.5))
"""Lines that meet under a smaller angle give no point: nothing is carried on to it."""
_MOVES = 1e-3
"""An own value that moves another by a smaller part of its tolerance does not enter it."""
_STRETCH = 5.0
"""A carried value that is larger than the right one may be off by as much more, within this."""


@frozen
class Carried:
    """What follows for each student and quantity (students, n); NaN where no own value enters it.

    agrees      whether the handed-in value does; sense_only: whether it would, with the other sense
    given       what was handed in; unused: own wrong values that are not carried on
    enters      by own quantity, what would follow otherwise without it (students, n)
    """

    texts: tuple[str, ...]
    values: np.ndarray
    agrees: np.ndarray
    sense_only: np.ndarray
    given: np.ndarray
    unused: np.ndarray
    enters: Mapping[int, np.ndarray]

    def instead(self, other: Carried, where: np.ndarray) -> Carried:
        """Of some values (students, n) what another says."""
        nowhere = np.zeros_like(where)
        return replace(
            self, values=np.where(where, other.values, self.values), agrees=np.where(where, other.agrees, self.agrees),
            sense_only=np.where(where, other.sense_only, self.sense_only),
            enters={j: np.where(where, other.enters.get(j, nowhere), into) for j, into in self.enters.items()},
        )  # fmt: skip

    def own(self, k: int, n: int) -> dict[str, float]:
        """The own values of student k that enter quantity n."""
        return {self.texts[j]: float(self.given[k, j]) for j, into in self.enters.items() if into[k, n] and j != n}

    def refused(self, k: int, n: int) -> tuple[str, ...]:
        """The own values of student k that are not carried on."""
        return tuple(self.texts[j] for j in np.flatnonzero(self.unused[k]) if j != n)


@frozen
class CarriedProblem:
    """A key with the construction from which values are carried on."""

    key: Key
    method: Method
    plot: Plot
    quantities: tuple[Quantity, ...]

    @cached_property
    def table(self) -> Columns:
        return columns(self.key.entries)

    @cached_property
    def arrows(self) -> ArrowPlaces:
        return arrows_of(self.method)

    @cached_property
    def signs(self) -> np.ndarray:
        """Of the right values: those of sizes along a guide, too."""
        return np.where(combined(self.method, self.plot, self.quantities, [()]).values[0] < 0, -1.0, 1.0)

    def carried(self, given: np.ndarray, known: np.ndarray, wrong: np.ndarray) -> Carried:
        """For values (students, n) of which some are wrong; `known`: those of them that can be carried on."""
        carries = np.array([isinstance(q, Moving) or (isinstance(q, Rotation) and q.word != "theta")
                            for q in self.quantities], dtype=bool)  # fmt: skip
        allowed = usable(self.key, self.table, given)
        used = known & allowed & carries
        whole = self._values(given, used)
        moved, tolerance = self._moved(whole, self.table.right), self._tolerance(whole)
        values = np.where(moved, whole, np.nan)
        every = np.arange(used.shape[1])
        enters = {
            int(j): self._moved(whole, self._values(given, used & (every != j))) & moved & used[:, [j]]
            for j in np.flatnonzero(used.any(axis=0))
        }
        texts = tuple(entry.text for entry in self.key.entries)
        return Carried(
            texts, values, wrong & agrees(self.table, given, values, tolerance),
            wrong & sense_only(self.table, given, values, tolerance), given, wrong & carries & ~allowed, enters,
        )  # fmt: skip

    def _values(self, given: np.ndarray, used: np.ndarray) -> np.ndarray:
        """What follows from the own values that are used; the right values where none is."""
        right = np.broadcast_to(self.table.right, given.shape).copy()
        some = np.flatnonzero(used.any(axis=1))
        if not some.size:
            return right
        own = {
            quantity: np.where(used[some, j], self._signed(given[some, j], j), np.nan)
            for j, quantity in enumerate(self.quantities)
            if used[some, j].any()
        }
        followed = replay_with(self.method, self.plot, own, self.arrows)
        for j, quantity in enumerate(self.quantities):
            value = followed.value(quantity).value
            right[some, j] = np.abs(value) if self.table.size[j] else value
        sines = np.broadcast_to(followed.least_sine, some.shape)
        right[some[~(sines > _FLAT)]] = np.nan
        return right

    def _signed(self, given: np.ndarray, j: int) -> np.ndarray:
        """A size along a guide points as the right one does."""
        return np.abs(given) * self.signs[j] if self.table.size[j] else given

    def _tolerance(self, values: np.ndarray) -> np.ndarray:
        with np.errstate(divide="ignore", invalid="ignore"):
            larger = np.abs(values) / np.abs(self.table.right)
        found: np.ndarray = self.table.tolerance * np.clip(np.nan_to_num(larger, nan=1.0, posinf=1.0), 1.0, _STRETCH)
        return found

    def _moved(self, values: np.ndarray, others: np.ndarray) -> np.ndarray:
        """Where values differ by more than counts; where they cannot be drawn, nowhere."""
        with np.errstate(invalid="ignore"):
            found: np.ndarray = np.abs(values - others) > _MOVES * self.table.tolerance
            return found
