"""The paper that a template's problems fit on: scales for a problem without laying out its sheet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.homework.grading.keys import KEYS, marking_of
from graphkin.homework.problems.posed import PosedProblem
from graphkin.marking.key import Marking

_LAID_OUT = 3
"""So many sheets are laid out."""


@frozen
class DrawingSizes:
    """How large a drawing is on paper [mm], by plane, as it usually comes out."""

    sizes: Mapping[Plane, float]

    @classmethod
    def of(cls, some: Sequence[PosedProblem]) -> DrawingSizes:
        """Of the sheets of a few problems."""
        laid_out = [(one, marking_of(one.method).scales) for one in some[:_LAID_OUT]]
        return cls({
            plane: float(np.median([_across(one, plane) / scales[key] for one, scales in laid_out] or [100.0]))
            for plane, key in KEYS.items()
        })  # fmt: skip

    def marking(self, posed: PosedProblem) -> Marking:
        """What a pencil errs by, at the file's scales or at those that make this problem's drawings as large."""
        own = {key: _across(posed, plane) / self.sizes[plane] for plane, key in KEYS.items()}
        return marking_of(posed.method, scales={**own, **posed.method.mechanism.scales})


def _across(posed: PosedProblem, plane: Plane) -> float:
    """How far apart the points of a plane are at most, along an axis [SI]; 1 where all are one."""
    points = np.array([complex(z) for z in posed.drawn.points(plane).values()])
    points = points[np.isfinite(points)]
    return float(max(np.ptp(points.real), np.ptp(points.imag))) or 1.0 if points.size else 1.0
