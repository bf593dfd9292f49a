"""The position in which a problem's figure shows the mechanism.

It is the drawn one, unless that would give away what is asked: an angle, a displacement, a place, an instant centre
could be measured on the figure. Then the drivers stand elsewhere, in the same assembly.
"""

from __future__ import annotations

from typing import assert_never

import numpy as np

from graphkin.construction import Plot
from graphkin.errors import GraphkinError
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import (
    Centre,
    Component,
    Displacement,
    Moving,
    Place,
    Quantity,
    Quotient,
    Rotation,
    Track,
)
from graphkin.model.quantities.reading import read
from graphkin.planning import Method
from graphkin.running import replay_all
from graphkin.running.drawn_sides import drawn_sides

_ELSEWHERE = np.radians((25, -25, 15, -15, 40, -40, 8, -8))
"""By so much a turning driver is set elsewhere; one that slides, by that part of the mechanism's size."""


def shown_at(method: Method, drawn: Plot) -> tuple[Plot, bool] | None:
    """Where the figure shows it, and whether that is the drawn position; None where it gets nowhere else."""
    if not any(_in_place(read(method.mechanism, question)) for question in method.mechanism.ask):
        return drawn, True
    return next(((plot, False) for by in _ELSEWHERE if (plot := _moved(method, drawn, float(by))) is not None), None)


def _in_place(quantity: Quantity | None) -> bool:
    """Whether the position alone gives it."""
    match quantity:
        case None | Centre() | Displacement() | Place() | Track() | Rotation(word="theta"):
            return True
        case Quotient():
            return any(map(_in_place, quantity.halves))
        case Rotation() | Moving() | Component():
            return False
        case _:
            assert_never(quantity)


def _moved(method: Method, drawn: Plot, by: float) -> Plot | None:
    size = _size(method.mechanism)
    values = [
        float(value) + by * (size if driver.kind == "slide" else 1.0)
        for driver, value in zip(method.drivers, drawn.facts.values, strict=True)
    ]
    try:
        plot = replay_all(method, values)
    except GraphkinError:
        return None
    places = np.array([complex(place) for place in plot.position.values()])
    told = drawn_sides(method, drawn).lies  # what the text says must be true of the figure
    return plot if np.isfinite(places).all() and all(lies.holds(plot) for lies in told) else None


def _size(mechanism: Mechanism) -> float:
    """The longest distance of two points of one link [m]."""
    shapes = [np.array(list(link.points.values())) for link in mechanism.links.values() if link.points]
    return max((float(np.abs(shape[:, None] - shape).max()) for shape in shapes), default=1.0)
