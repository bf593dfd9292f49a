"""Why a Coriolis acceleration is 0: because its link does not turn, or because nothing slides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Moving
from graphkin.studies.finding.answers import Position
from graphkin.studies.finding.quantities import Reader, looked_for
from graphkin.studies.finding.stretch import Stretch

_SMALL = 1e-6
"""A factor below this part of its largest size is none."""


def with_factors(over: Stretch, positions: tuple[Position, ...]) -> tuple[Position, ...]:
    """Positions at which `a_k B3B2` is 0, each with the factors that are; others as they are."""
    mechanism = over.course.method.mechanism
    wanted = looked_for(mechanism, over.names[0])
    if not isinstance(wanted, Moving) or wanted.which != "k" or wanted.seen_from is None or not positions:
        return positions
    link = wanted.seen_from.link
    pair = over.names[0].split(" ", 1)[1]
    names = ((f"omega {mechanism.called(link)}",) if link != FRAME else ()) + (f"v {pair}",)
    reader = Reader(over.course, names, over.by)
    largest = [float(np.nanmax(np.abs(each.signed))) for each in reader.read(over.places)]
    there = [np.abs(each.signed) for each in reader.read(np.array([position.t for position in positions]))]
    sizes = [*zip(names, there, largest, strict=True)]
    found = [tuple(name for name, size, most in sizes if size[k] <= _SMALL * most) for k in range(len(positions))]
    return tuple(replace(each, factors=factors) for each, factors in zip(positions, found, strict=True))
