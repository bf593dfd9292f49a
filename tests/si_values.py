"""Driver values in SI, for calls that take deg and mm."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.model.mechanism import Mechanism
from graphkin.model.units import Number, Numbers, driven, measured
from graphkin.planning import Method


def si(subject: Mechanism | Method, values: Sequence[object] | np.ndarray | None) -> list[Number | Numbers] | None:
    """Each driver's values [rad, m], with their unit."""
    mechanism = subject.mechanism if isinstance(subject, Method) else subject
    units = [driven(driver.kind == "slide") for driver in mechanism.drivers]
    return None if values is None else [measured(np.asarray(v, float), unit) for v, unit in zip(values, units, strict=True)]
