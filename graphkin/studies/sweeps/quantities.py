"""Quantities over many positions, as one series each."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.base.geometry import Value, dot
from graphkin.base.value import frozen
from graphkin.errors import Where
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism, Usual
from graphkin.model.quantities import Quantity, Track, named, read
from graphkin.model.units import Measured, Numbers, measured


@frozen
class Series(Measured):
    """One quantity over positions. As an array it is `signed`; `degrees`, `mm`, `rpm`, `direction`, `x`, `y` as of any
    `graphkin.model.units.Measured`.

    name    as it was asked for
    values  sizes or signed scalars (n,), in SI
    vectors for velocities and accelerations, and the place of a point or an instant centre: (n,) complex, else None
    """

    name: str
    quantity: Quantity
    values: np.ndarray
    vectors: np.ndarray | None = None

    if not TYPE_CHECKING:

        @property
        def unit(self) -> str:
            """SI."""
            return self.quantity.unit

    @property
    def measured(self) -> Numbers:
        """With its unit: the vectors, else the values (n,)."""
        made: Numbers = measured(self.values if self.vectors is None else self.vectors, self.unit)
        return made

    @property
    def si(self) -> np.ndarray:
        return self.values if self.vectors is None else self.vectors

    def _times(self, factor: float, units: tuple[str, ...], name: str) -> np.ndarray:
        """In another unit what the array is in SI: the signed values, of a place the place."""
        shown = measured(self.si if self.is_place else self.signed, self.unit)
        found: np.ndarray = shown._times(factor, units, name)
        return found

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        own = self.si if self.is_place else self.signed
        return np.asarray(own, dtype) if copy is None else np.array(own, dtype, copy=copy)  # NumPy 1 knows no copy=None

    def __len__(self) -> int:
        return len(self.values)

    def __repr__(self) -> str:
        return f"<Series {self.name} [{self.unit}]: {len(self)} values>"

    @property
    def along(self) -> complex | None:
        """For a point that a guide of the frame leads: the direction along which it counts as positive."""
        return self.quantity.along

    @property
    def is_place(self) -> bool:
        """Whether this is where a point or an instant centre lies; that one at infinity is infinite."""
        return self.quantity.is_place

    def without_noise(self, usual: Usual) -> Series:
        """The same, with 0 for what is but rounding."""
        vectors = None if self.vectors is None else usual.cut(self.vectors, self.unit)
        return replace(self, values=usual.cut(self.values, self.unit), vectors=vectors)

    @property
    def signed(self) -> np.ndarray:
        """Along its guide for a point that a guide of the frame leads; else the values."""
        if self.along is None or self.vectors is None:
            return self.values
        return np.asarray(dot(self.along, self.vectors))


def series(name: str, quantity: Quantity, motions: Motions, count: int) -> Series:
    """One quantity over `count` positions."""
    with np.errstate(divide="ignore", invalid="ignore"):
        found = quantity.answer(motions)
    vectors = None if found.vector is None else _row(found.vector, count)
    return Series(name, quantity, _row(found.value, count), vectors)


def _row(value: Value, count: int) -> np.ndarray:
    return np.array(value if np.shape(value) == (count,) else np.broadcast_to(value, (count,)))


def asked(mechanism: Mechanism, names: Sequence[str] = ()) -> tuple[str, ...]:
    """The quantities of a sweep: those named, else what the file asks, else of every link and every named slide.

    Raises UnknownQuantity, UnknownLink, UnknownPoint, UnknownSlide for names that mean nothing.
    """
    for name in names:
        named(mechanism, name, Where("--of"))
    usual = names or [name for name in mechanism.ask if read(mechanism, name) is not None]
    return tuple(dict.fromkeys(usual or _everything(mechanism)))


def drawable(mechanism: Mechanism, names: Sequence[str]) -> tuple[str, ...]:
    """The same over the driver's value, a curve each: of a point's place its x and its y."""
    found: list[str] = []
    for name in names:
        quantity = named(mechanism, name, Where("--of"))
        found += [f"x {quantity.of}", f"y {quantity.of}"] if isinstance(quantity, Track) else [name]
    return tuple(dict.fromkeys(found))


def _everything(mechanism: Mechanism) -> Iterable[str]:
    driven = {driver.link for driver in mechanism.drivers if driver.kind != "slide" and driver.from_vector is None}
    links = [link for link in mechanism.moving if link not in driven] or list(mechanism.moving)
    for quantity in ("theta", "omega", "alpha"):
        yield from (f"{quantity} {link}" for link in links)
