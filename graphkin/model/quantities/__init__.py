"""Quantities: all that can be asked of a mechanism, read from text once.

A `Quantity` knows its unit, its letters and its sign rule, and its value in any `Motions`, whichever road they come
from. To add one: a class in `kinds`, also in the union `Quantity` there, and its word in `reading`; mypy then lists the
readers that do not know it yet. Units at the edge are one table, in `graphkin.model.units`.
"""

from graphkin.model.quantities.kinds import (
    Answer,
    Centre,
    Component,
    Displacement,
    Moving,
    Place,
    Quantity,
    Quotient,
    Rotation,
    Track,
    on_axis,
    relative,
)
from graphkin.model.quantities.reading import at_position, centre_of, formed, meant, named, parts, position_of, read
from graphkin.model.units import EDGE, GRAVITY, IN_GRAVITY, Unit, driven

__all__ = [
    "EDGE", "GRAVITY", "IN_GRAVITY", "Answer", "Centre", "Component", "Displacement", "Moving", "Place", "Quantity",
    "Quotient", "Rotation", "Track", "Unit", "at_position", "centre_of", "driven", "formed", "meant", "named",
    "on_axis", "parts", "position_of", "read", "relative",
]  # fmt: skip
