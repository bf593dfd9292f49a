"""Rounding noise of computing: the one rule for every 0 that is printed, drawn or marked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen

__all__ = ["ROUNDING", "Usual"]

ROUNDING = 1e-7
"""Sizes below this part of what is usual of their kind are rounding noise: an angle typed to five decimals of a degree,
or a length to a hundred thousandth of a millimetre, says no more."""

Rates = Sequence[tuple[float, float]]
"""Of drivers: velocity and acceleration."""


@frozen
class Usual:
    """Sizes that are usual in a mechanism, by what its drivers do: length [m], omega [rad/s], alpha [rad/s^2]."""

    length: float
    omega: float
    alpha: float

    @classmethod
    def of(cls, length: float, turning: Rates, sliding: Rates) -> Usual:
        rates = [*turning, *((speed / length, more / length) for speed, more in sliding)]
        omega = max((abs(rate) for rate, _ in rates), default=0.0)
        return cls(length, omega, max([omega**2, *(abs(more) for _, more in rates)]))

    def size(self, unit: str) -> float:
        """Of quantities of an SI unit; 1 of angles and plain numbers."""
        speed, more = self.omega * self.length, self.alpha * self.length
        kinds = {"m": self.length, "m/s": speed, "m/s^2": more, "rad/s": self.omega, "rad/s^2": self.alpha}
        return kinds.get(unit, 1.0)

    def least(self, unit: str) -> float:
        """Sizes up to this are rounding noise [SI]."""
        return ROUNDING * self.size(unit)

    def rate(self, value: Value, plane: str) -> Value:
        """omega or alpha, as the plane has it, without noise."""
        return self.cut(value, "rad/s" if plane == "velocity" else "rad/s^2")

    def motion(self, value: Value, plane: str) -> Value:
        """A velocity or an acceleration, as the plane has it, without noise."""
        return self.cut(value, "m/s" if plane == "velocity" else "m/s^2")

    def cut(self, value: Value, unit: str) -> Value:
        """A value [SI]; 0 where it is but rounding noise, of a vector in each part."""
        found = np.array(value, dtype=complex if np.iscomplexobj(value) else float, ndmin=1)
        parts = found.view(float)
        parts[np.abs(parts) <= self.least(unit)] = 0.0
        return found.reshape(np.shape(value)) if np.ndim(value) else found.item()
