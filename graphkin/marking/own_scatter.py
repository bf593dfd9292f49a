"""How right values scatter that are drawn by other right ways: by way of other coincident points."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.marking.key import Hypotheses, Key
from graphkin.marking.making import drawn_by, least_of
from graphkin.marking.right_ways import other_methods
from graphkin.marking.scatter import spread
from graphkin.model.quantities import Quantity
from graphkin.planning import Method


def ways_of(method: Method, key: Key, quantities: Sequence[Quantity]) -> Hypotheses:
    """Right values, a row for each other way that gives them all, with what a pencil makes of them by that way.

    Whoever takes it reads off what another has drawn, and the other way round: the same values err by more there, by
    less here, and otherwise together.
    """
    right, sorts = np.array([entry.right for entry in key.entries]), [entry.sort for entry in key.entries]
    least = np.array([least_of(entry.right, entry) for entry in key.entries])
    scatters, together = [], []
    for way in other_methods(method):
        drawn, hang = drawn_by(way, key, quantities)
        off = spread(drawn, right, sorts)
        if np.isfinite(off).all():
            scatters.append(np.hypot(off, least))
            together.append(hang)
    count, size = len(scatters), len(right)
    return Hypotheses(
        ((),) * count, np.tile(right, (count, 1)), np.reshape(scatters, (count, size)),
        np.reshape(together, (count, size, size)),
    )  # fmt: skip
