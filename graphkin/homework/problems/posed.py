"""Whether a problem can be solved well on paper."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Literal

import numpy as np

from graphkin.api import plan
from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Construction, Plot
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Rotation, read
from graphkin.planning import Method
from graphkin.proof.readings import readings
from graphkin.proof.roads import proved
from graphkin.results import driver_values

Refused = Literal["assembly", "dead point", "short", "taken"]

DEAD = math.radians(5)
"""Lines that meet at a smaller angle are too near a dead point."""
SHORTEST = 0.02
"""A vector that is a smaller part of the longest of its polygon is too short to be read off: 2 mm beside 100 mm."""
_NOTHING = 1e-9
_FAR = 1e12


@frozen
class PosedProblem:
    """A mechanism that is solved at the positions its problem asks for."""

    method: Method
    plots: tuple[Plot, ...]

    @property
    def drawn(self) -> Plot:
        """The position that is drawn and marked."""
        return self.plots[0]


def well_posed(mechanism: Mechanism) -> PosedProblem | Refused:
    """Solved at every position asked for, or what is against it. Raises what solving raises: it does not assemble."""
    method = plan(mechanism)
    plots = tuple(proved(method, values).plot for values in driver_values(method))
    if any(_dead(plot) for plot in plots):
        return "dead point"
    if any(_short(method, plot) for plot in plots):
        return "short"
    return PosedProblem(method, plots)


def answers(posed: PosedProblem) -> np.ndarray:
    """The right values of what is asked, at all positions [SI]; one at infinity is as large as can be told."""
    quantities = [read(posed.method.mechanism, question) for question in posed.method.mechanism.ask]
    motions = [readings(posed.method, plot) for plot in posed.plots]
    found = np.array([float(q.answer(m).value) for m in motions for q in quantities if q is not None])
    return np.asarray(np.clip(np.nan_to_num(found, nan=_FAR, posinf=_FAR, neginf=-_FAR), -_FAR, _FAR))


def _dead(plot: Plot) -> bool:
    return any(abs(float(sine)) < math.sin(DEAD) for sine in plot.sines.values())


def _short(method: Method, plot: Plot) -> bool:
    """Whether an arrow that is read off, or a rotation asked for, is too small beside the largest.

    Those that are 0 by what the mechanism is do not count, and those that are laid off may be short.
    """
    polygons = [list(_lengths(construction, plot)) for construction in (method.velocity, method.acceleration)]
    if not any(size for sizes in polygons for size, _ in sizes):
        return True
    for sizes in polygons:
        longest = max((size for size, _ in sizes), default=0.0)
        if any(_NOTHING * longest < size < SHORTEST * longest for size, read_off in sizes if read_off):
            return True
    return _slow(method, plot)


def _slow(method: Method, plot: Plot) -> bool:
    """Whether a rotation that is asked for is nearly nothing beside the fastest."""
    for question in method.mechanism.ask:
        quantity = read(method.mechanism, question)
        if isinstance(quantity, Rotation) and quantity.word != "theta":
            rates: Mapping[str, Value] = getattr(plot, quantity.word)
            fastest = max(abs(float(rates[name])) for name in method.mechanism.moving if name in rates)
            if _NOTHING * fastest < abs(float(rates[quantity.link])) < SHORTEST * fastest:
                return True
    return False


def _lengths(construction: Construction, plot: Plot) -> Iterator[tuple[float, bool]]:
    """Of every arrow, and whether it is read off the closed polygon."""
    points = plot.points(construction.plane)
    for term in construction.vectors().values():
        if term.tail in points and term.head in points:
            yield abs(complex(points[term.head]) - complex(points[term.tail])), term.size is None
