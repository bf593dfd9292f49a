"""Mistakes that the values cannot tell apart, told apart by a drawing's known arrows that point another way.

Sizes and rotations alone may go with an omega misread and with a driver drawn the other way round; only the second
turns the driver's arrow. Arrows that point as they should tell nothing: they may do so by own values before them.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.construction import Plot
from graphkin.marking.consequences import combined
from graphkin.marking.diagnosis import Diagnosis, Explanation
from graphkin.marking.key import Name
from graphkin.marking.read_off import ASTRAY
from graphkin.marking.rewrite import Rewrite
from graphkin.model.quantities import Quantity
from graphkin.planning import Method

Names = tuple[Name, ...]
Turned = Callable[[Sequence[Names]], np.ndarray]
"""Which of the arrows astray each of some explanations turns (explanations, arrows)."""


def as_drawn(diagnosis: Diagnosis, turned: Turned) -> Diagnosis:
    """Of each set the mistakes that turn most of the arrows astray; all of them, where none turns any."""
    return replace(diagnosis, explanations=tuple(_as_drawn(one, turned) for one in diagnosis.explanations))


def _as_drawn(one: Explanation, turned: Turned) -> Explanation:
    if len(one.names) < 2:
        return one
    count = turned(one.names).sum(axis=1)
    return replace(one, names=tuple(names for names, n in zip(one.names, count, strict=True) if n == count.max()))


def turned_by(
    method: Method, plot: Plot, astray: Collection[Quantity], known: Mapping[Name, Rewrite], sets: Sequence[Names]
) -> np.ndarray:
    """Which arrows mistakes turn, so far that they are astray; `known`: how mistakes are made, by name."""
    columns = [(), *(tuple(known[name] for name in names if name in known) for names in sets)]
    vectors = combined(method, plot, tuple(astray), columns).vectors
    with np.errstate(invalid="ignore", divide="ignore"):
        found: np.ndarray = np.abs(np.angle(vectors[1:] / vectors[0])) > ASTRAY
        return found
