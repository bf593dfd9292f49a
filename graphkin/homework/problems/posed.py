"""Problems that can be solved well on paper, and the position in which the figure of one shows the mechanism."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Literal, assert_never

import numpy as np

from graphkin.api import plan
from graphkin.base.geometry import Array, Value, number, place
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.errors import GraphkinError
from graphkin.model import quantities as asked
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Rotation, read
from graphkin.planning import Method
from graphkin.proof.readings import readings
from graphkin.proof.roads import proved
from graphkin.running import driver_values, replay_all
from graphkin.running.drawn_sides import drawn_sides

Refused = Literal["assembly", "elsewhere", "dead point", "short", "taken", "untold", "unlike"]

DEAD = math.radians(5)  # lines that meet at a smaller angle are too near a dead point
SHORTEST = 0.02
"""A vector that is a smaller part of the longest of its polygon is too short to be read off: 2 mm beside 100 mm."""
_NOTHING = 1e-9
_FAR = 1e12
_ELSEWHERE = np.radians((25, -25, 15, -15, 40, -40, 8, -8))
"""By so much a turning driver is set elsewhere; one that slides, by that part of the mechanism's size."""


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
    if any(abs(number(sine)) < math.sin(DEAD) for plot in plots for sine in plot.sines.values()):
        return "dead point"
    if any(_has_short_vector(method, plot) or _turns_slowly(method, plot) for plot in plots):
        return "short"
    return PosedProblem(method, plots)


def answers(posed: PosedProblem) -> Array:
    """The right values of what is asked, at all positions [SI]; one at infinity is as large as can be told."""
    quantities = [read(posed.method.mechanism, question) for question in posed.method.mechanism.ask]
    motions = [readings(posed.method, plot) for plot in posed.plots]
    values = np.array([number(q.answer(m).value) for m in motions for q in quantities if q is not None])
    return np.asarray(np.clip(np.nan_to_num(values, nan=_FAR, posinf=_FAR, neginf=-_FAR), -_FAR, _FAR))


def _has_short_vector(method: Method, plot: Plot) -> bool:
    """True where an arrow that is read off is too small beside the largest; those that are always 0 do not count."""
    longest_of_all = 0.0
    for construction in (method.velocity, method.acceleration):
        points, terms = plot.points(construction.plane), construction.vectors().values()
        lengths = [
            (abs(place(points[term.head]) - place(points[term.tail])), term.size is None)
            for term in terms if term.tail in points and term.head in points
        ]  # fmt: skip
        longest = max((length for length, _ in lengths), default=0.0)
        if any(_NOTHING * longest < length < SHORTEST * longest for length, read_off in lengths if read_off):
            return True
        longest_of_all = max(longest_of_all, longest)
    return not longest_of_all


def _turns_slowly(method: Method, plot: Plot) -> bool:
    """True where a rotation that is asked for is nearly nothing beside the fastest."""
    for question in method.mechanism.ask:
        quantity = read(method.mechanism, question)
        if isinstance(quantity, Rotation) and quantity.word != "theta":
            rates: Mapping[str, Value] = getattr(plot, quantity.word)
            fastest = max(abs(number(rates[name])) for name in method.mechanism.moving if name in rates)
            if _NOTHING * fastest < abs(number(rates[quantity.link])) < SHORTEST * fastest:
                return True
    return False


def shown_at(method: Method, drawn: Plot) -> tuple[Plot, bool] | None:
    """The position of a problem's figure, and whether it is the drawn one; None where it gets nowhere else.

    It is the drawn one, unless that would give away what is asked: an angle, a displacement, a place, an instant centre
    could be measured on the figure. Then the drivers stand elsewhere, in the same assembly.
    """
    if not any(_is_of_position(read(method.mechanism, question)) for question in method.mechanism.ask):
        return drawn, True
    return next(((plot, False) for by in _ELSEWHERE if (plot := _moved(method, drawn, float(by))) is not None), None)


def _is_of_position(quantity: asked.Quantity | None) -> bool:
    """True where the position alone gives it."""
    match quantity:
        case None | asked.Centre() | asked.Displacement() | asked.Place() | asked.Track() | Rotation(word="theta"):
            return True
        case asked.Quotient():
            return any(map(_is_of_position, quantity.halves))
        case Rotation() | asked.Moving() | asked.Component():
            return False
        case _:
            assert_never(quantity)


def _moved(method: Method, drawn: Plot, by: float) -> Plot | None:
    """The mechanism with its drivers set on; None where it does not get there in the same assembly."""
    shapes = [np.array(list(link.points.values())) for link in method.mechanism.links.values() if link.points]
    size = max((float(np.abs(shape[:, None] - shape).max()) for shape in shapes), default=1.0)
    values = [
        number(value) + by * (size if driver.kind == "slide" else 1.0)
        for driver, value in zip(method.drivers, drawn.facts.values, strict=True)
    ]
    try:
        plot = replay_all(method, values)
    except GraphkinError:
        return None
    sides = drawn_sides(method, drawn).lies  # what the text says must be true of the figure
    finite = all(np.isfinite(point) for point in plot.position.values())
    return plot if finite and all(side.holds(plot) for side in sides) else None
