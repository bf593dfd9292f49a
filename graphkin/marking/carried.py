"""Carried errors of many students: what follows from their own wrong values, and whether they have it so."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Image, Plot
from graphkin.marking.answers import ArrowPlaces, arrows_of
from graphkin.marking.by_rotations import OwnRotations, by_contacts, own_rotations, rotations_of
from graphkin.marking.consequences import combined
from graphkin.marking.follow_through import replay_with
from graphkin.marking.key import Columns, Key, agrees, columns, differences, sense_only
from graphkin.marking.weights import SlipOutcomes, once_known
from graphkin.model.quantities import Moving, Quantity, Rotation
from graphkin.planning import Method

_FLAT = np.sin(np.radians(0.5))  # lines that meet under a smaller angle give no point: nothing is carried on to it
_SAME = 1e-6  # an own value that differs from a number of the problem by a smaller part is copied from it
_ANSWERABLE = 5.0  # an own value is carried on between 1/5 and 5 times the right size
_MOVES = 1e-3  # an own value that moves another by a smaller part of its tolerance does not enter it
_ROUNDING = 0.015  # of a value that is calculated from others in three digits
_SEVERAL, _FELT = 3, 0.3  # a slip far off is one that moves so many others by so many standard deviations
_STRETCH = 5.0  # a carried value that is larger than the right one may be off by as much more, within this


@frozen
class Carried:
    """The outcomes for each student and quantity (students, n); NaN where no own value enters it.

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

    def pointing(self, follows: Mapping[tuple[int, int], tuple[str, ...]], right: np.ndarray) -> Carried:
        """With vectors of students that point as own values have it: by student and quantity which these are."""
        agrees, values, nowhere = self.agrees.copy(), self.values.copy(), np.zeros_like(self.agrees)
        enters = {j: self.enters.get(j, nowhere).copy() for j in range(len(self.texts))}
        for (k, n), texts in follows.items():
            agrees[k, n], values[k, n] = True, np.nan_to_num(values[k, n], nan=right[n])
            for text in texts:
                enters[self.texts.index(text)][k, n] = True
        return replace(self, agrees=agrees, values=values, enters=enters)

    def rooted(self, wrong: np.ndarray, costs: np.ndarray) -> Carried:
        """Without what follows from itself alone, by way of others: the first of these in costs (students, n)."""
        agrees, nowhere = self.agrees.copy(), np.zeros_like(wrong)
        into = np.stack([self.enters.get(j, nowhere) for j in range(wrong.shape[1])], axis=1)  # (students, own, n)
        while True:
            rooted = wrong & ~agrees
            for _ in range(wrong.shape[1]):
                rooted |= agrees & (rooted[:, :, None] & into).any(axis=1)
            loose = agrees & ~rooted
            who = np.flatnonzero(loose.any(axis=1))
            if not who.size:
                break
            agrees[who, np.where(loose, costs, np.inf)[who].argmin(axis=1)] = False
        by_itself = self.agrees & ~agrees
        enters = {j: into & ~by_itself for j, into in self.enters.items()}
        return replace(self, agrees=agrees, values=np.where(by_itself, np.nan, self.values), enters=enters)

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

    def usable(self, given: np.ndarray, of_any_size: bool = False) -> np.ndarray:
        """The own values (students, n) that are carried on."""
        return np.asarray(self.bounded(given, of_any_size) & self._carries)

    def bounded(self, given: np.ndarray, of_any_size: bool = False) -> np.ndarray:
        """Values (students, n) that others may follow from: nothing is gained by 0 or by a number of the problem."""
        table = self.table
        with np.errstate(invalid="ignore", divide="ignore"):
            size, right = np.abs(given), np.abs(table.right)
            bounded = (size >= right / _ANSWERABLE) & (size <= right * _ANSWERABLE) | of_any_size & (size > 0)
        copied, units = np.zeros(given.shape, dtype=bool), np.array([entry.unit for entry in self.key.entries])
        for number, unit in self._stated:
            copied |= (np.abs(size - number) <= _SAME * number) & (units == unit)
        angles = table.angle & np.isfinite(given)
        return np.asarray(np.isfinite(given) & (angles | bounded & (right > 0)) & ~copied)

    @cached_property
    def _stated(self) -> list[tuple[float, str]]:
        """The sizes of what the drivers do, with their units, SI."""
        each = ((driver, "m" if driver.kind == "slide" else "rad") for driver in self.method.mechanism.drivers)
        both = (((driver.rate, f"{unit}/s"), (driver.acceleration, f"{unit}/s^2")) for driver, unit in each)
        return [(abs(number), unit) for pair in both for number, unit in pair if number]

    @cached_property
    def _carries(self) -> np.ndarray:
        carries = (isinstance(q, Moving) or (isinstance(q, Rotation) and q.word != "theta") for q in self.quantities)
        return np.array(list(carries), dtype=bool)

    @cached_property
    def _alike(self) -> np.ndarray:
        """Flags of quantities that are one: rotations of links that turn together (quantities, quantities)."""
        rates = dict(rotations_of(self.plot, self.quantities))
        whose = [rates.get(n, (quantity.text,)) for n, quantity in enumerate(self.quantities)]
        return np.array([[one == other for other in whose] for one in whose], dtype=bool)

    @cached_property
    def _left(self) -> np.ndarray:
        """The part of each quantity's scatter that is left once one is known (known, quantities)."""
        return once_known(self.key.together)[0]

    def slips(self, given: np.ndarray, wrong: np.ndarray, there: np.ndarray) -> SlipOutcomes:
        """The outcomes of a slip in each wrong value (students, n), of one far off where several others follow from it;
        for those of the quantities that are handed in."""
        who, own = np.nonzero(wrong & self.usable(given, of_any_size=True))
        # of links that turn together a slip in one is a slip in all
        again = (self._alike[own] & (np.arange(given.shape[1]) < own[:, None]) & wrong[who]).any(axis=1)
        who, own = who[~again], own[~again]
        only = own[:, None] == np.arange(given.shape[1])
        followed = self._values(given[who], only)
        for n, others, _ in self._otherwise(given[who], only):  # the nearer of both ways
            every = np.where(np.arange(given.shape[1]) == n, others[:, None], followed)
            off, before = (np.abs(differences(self.table, given[who], each))[:, n] for each in (every, followed))
            with np.errstate(invalid="ignore"):
                followed[off < before, n] = others[off < before]
        moved = np.abs(differences(self.table, followed, self.table.right)) > _FELT * self.table.scatter
        others = (moved & np.isfinite(given[who]) & ~self._alike[own]).sum(axis=1)
        some = others >= np.where(self.usable(given)[who, own], 0, _SEVERAL)
        who, own, followed = who[some], own[some], np.where(only, np.nan, followed)[some]
        values, scatters = np.full((2, *given.shape, given.shape[1]), np.nan)
        values[who, own], scatters[who, own] = followed, self._scatter(followed, self._left[own])
        return SlipOutcomes(*(each[:, there][:, :, there] for each in (values, scatters)))

    def _scatter(self, followed: np.ndarray, left: np.ndarray) -> np.ndarray:
        """The scatter of values that follow from own ones: the part of the right one's that is left, and rounding."""
        scatter = self.table.scatter * np.maximum(self._larger(followed), self._growth(followed)) * left
        return np.where(np.isfinite(followed), scatter, np.nan)

    def _growth(self, followed: np.ndarray) -> np.ndarray:
        """By how much the largest value of each one's unit has grown (students, n): longer arrows, wider errors."""
        units = [entry.unit for entry in self.key.entries]
        growth = np.ones(followed.shape)
        for unit in dict.fromkeys(units):
            of = np.array([each == unit for each in units], dtype=bool)
            before = np.abs(self.table.right[of]).max()
            if before:
                now = np.nan_to_num(np.abs(followed[:, of])).max(axis=1)
                growth[:, of] = np.maximum(now / before, 1.0)[:, None]
        return growth

    def _tolerance(self, followed: np.ndarray, used: np.ndarray) -> np.ndarray:
        """By how much values may be off that follow from own ones (students, n): less than the right ones, as a part of
        the scatter comes in before the own values; at least the rounding of these, at most half of what follows."""
        left = np.where(used[:, :, None], self._left, 1.0).min(axis=1, initial=1.0)
        whole = self.table.tolerance * self._larger(followed)
        rounding = np.minimum(_ROUNDING * np.abs(followed), whole)
        most = np.where(self.table.angle, np.inf, 0.5 * np.abs(followed))
        return np.asarray(np.minimum(np.maximum(whole * left, rounding), np.maximum(most, rounding)))

    def _larger(self, values: np.ndarray) -> np.ndarray:
        """By how much more values (students, n) may be off than the right ones: larger ones may by as much more."""
        with np.errstate(divide="ignore", invalid="ignore"):
            times = np.abs(values / self.table.right)
        return np.asarray(np.clip(np.nan_to_num(times, nan=1.0, posinf=1.0), 1.0, _STRETCH))

    def carried(self, given: np.ndarray, known: np.ndarray, wrong: np.ndarray) -> Carried:
        """For values (students, n) of which some are wrong; `known`: those of them that can be carried on."""
        allowed = self.usable(given)
        used = known & allowed
        whole = self._values(given, used)
        moved = self._moved(whole, self.table.right)
        tolerance = self._tolerance(whole, used)
        values = np.where(moved, whole, np.nan)
        # own values that enter: without them others would follow
        who, own = np.nonzero(used)
        without = used[who] & (np.arange(used.shape[1]) != own[:, None])
        into = self._moved(whole[who], self._values(given[who], without)) & moved[who]
        enters = {int(j): np.zeros_like(used) for j in np.unique(own)}
        for k, j, entered in zip(who.tolist(), own.tolist(), into, strict=True):
            enters[j][k] = entered
        agree = wrong & agrees(self.table, given, values, tolerance)
        for n, others, sources in self._otherwise(given, used):  # by other rules than the polygon's
            every = np.where(np.arange(values.shape[1]) == n, others[:, None], np.nan)
            near = agrees(self.table, given, every, self._tolerance(every, used))
            also = (wrong & ~agree & near & self._moved(every, self.table.right))[:, n]
            agree[also, n], values[also, n] = True, others[also]
            for j in sources:
                enters[j][also, n] = used[also, j]
        texts = tuple(entry.text for entry in self.key.entries)
        return Carried(
            texts, values, agree,
            wrong & sense_only(self.table, given, values, tolerance), given, wrong & self._carries & ~allowed, enters,
        )  # fmt: skip

    def _values(
        self, given: np.ndarray, used: np.ndarray, calculates: bool = False, backwards: bool = False
    ) -> np.ndarray:
        """The outcomes of the own values that are used; the right values where none is; calculates: as of `Own`,
        backwards: as of `own_rotations`."""
        right = np.broadcast_to(self.table.right, given.shape).copy()
        some = np.flatnonzero(used.any(axis=1))
        if not some.size:
            return right
        own = self._rotations(given[some], used[some], backwards)
        wheels = {
            (word, base): getattr(self.plot, word)[base] + rate.off for (word, (base, _)), rate in own.wheels.items()
        }
        given, used = given[some], used[some]
        followed = replay_with(self.method, self.plot, self.own(given, used), self.arrows, wheels, calculates)
        for j, quantity in enumerate(self.quantities):
            value = followed.value(quantity).value
            right[some, j] = np.abs(value) if self.table.size[j] else value
        sines = np.broadcast_to(followed.least_sine, some.shape)
        right[some[~(sines > _FLAT)]] = np.nan
        return right

    def _rotations(self, given: np.ndarray, used: np.ndarray, backwards: bool = False) -> OwnRotations:
        right = agrees(self.table, given, self.table.right, self.table.tolerance)
        return own_rotations(self.method, self.plot, self.quantities, self.table.right, given, used, right, backwards)

    def _otherwise(
        self, given: np.ndarray, used: np.ndarray
    ) -> Iterator[tuple[int, np.ndarray, frozenset[int]]]:
        """All that own rotations give otherwise than the polygon: quantity, values (students,), which rotations."""
        several = len(self.method.structure.tying) > 1  # contacts, each of which gives a rotation by another
        for backwards in (False, True)[: 1 + several]:
            own = self._rotations(given, used, backwards)
            yield from by_contacts(self.plot, self.quantities, self.table.right, own)
            omegas = frozenset[int]().union(*(off.sources for rate, off in own.rates.items() if rate[0] == "omega"))
            sources = omegas.union(*(off.sources for off in own.rates.values()))
            if sources and self._images:
                values = self._values(given, used, True, backwards)
                for n, quantity in enumerate(self.quantities):
                    yield n, values[:, n], omegas if quantity.unit in ("rad/s", "m/s") else sources

    @cached_property
    def _images(self) -> bool:
        """True where a point is found by image."""
        polygons = (self.method.velocity, self.method.acceleration)
        return any(isinstance(step, Image) for polygon in polygons for step in polygon.steps)

    def own(self, given: np.ndarray, used: np.ndarray) -> dict[Quantity, Value]:
        """Own values (students, n) that are used, by quantity; NaN where a student has none."""
        signed = np.where(self.table.size, np.abs(given) * self.signs, given)  # along a guide as the right one points
        return {
            quantity: np.where(used[:, j], signed[:, j], np.nan)
            for j, quantity in enumerate(self.quantities)
            if used[:, j].any()
        }

    def near(self, given: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Given values (students, n) that are as others have it, as booleans."""
        return agrees(self.table, given, values, self.table.tolerance * self._larger(values))

    def _moved(self, values: np.ndarray, others: np.ndarray) -> np.ndarray:
        """True for values that differ by more than counts; false where they cannot be drawn."""
        with np.errstate(invalid="ignore"):
            return np.asarray(np.abs(values - others) > _MOVES * self.table.tolerance)
