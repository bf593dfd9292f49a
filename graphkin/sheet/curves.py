"""Curves on paper, cut off at the edge of their room."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import numpy as np

from graphkin.sheet.marks import Place, Stroke
from graphkin.sheet.paper import PenName, Room

_FINE = 0.01
"""How far a drawn curve may stand off from the true one [mm]."""


def clipped(
    places: Sequence[Place] | np.ndarray, room: Room, pen: PenName, step: int | None = None
) -> Iterator[Stroke]:
    """A curve on paper as far as it lies in the room, with no more places than it needs."""
    import shapely

    if len(places) < 2:
        return
    line = shapely.LineString([(z.real, z.imag) for z in places]).simplify(_FINE)
    inside = shapely.clip_by_rect(line, room.left, room.top, room.right, room.bottom)
    for part in getattr(inside, "geoms", [inside]):
        if part.geom_type == "LineString" and part.length > 0.1:
            yield Stroke(tuple(complex(x, y) for x, y in part.coords), pen, step=step)


def circle(centre: Place, radius: float, room: Room) -> list[Place]:
    """A circle on paper as a polyline; of a very large one the part about the room."""
    half = min(math.pi, 2 * abs(room.size) / radius) if radius > 0 else math.pi
    start = cmath.phase(room.middle - centre)
    count = max(120, math.ceil(half * math.sqrt(radius / _FINE)))
    return [centre + cmath.rect(radius, start + half * (2 * k / count - 1)) for k in range(count + 1)]
