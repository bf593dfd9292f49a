"""The asked rates of links that turn, as a figure of the mechanism shows them."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from graphkin.construction import Plane
from graphkin.model.quantities import Rotation, read
from graphkin.say.reading import Reading

TURNS: Mapping[str, tuple[str, Plane]] = {"omega": ("ω", "velocity"), "alpha": ("α", "acceleration")}
"""The letter of a rate, and the plane in which it is found."""


def asked_turns(reading: Reading, planes: Collection[Plane]) -> dict[Rotation, float]:
    """Those found in some planes that are not 0 [rad/s, rad/s²]; none of a driven link, whose arcs are there."""
    machine, plot, rates = reading.mechanism, reading.plot, dict[Rotation, float]()
    asked = (quantity for text in machine.ask if (quantity := read(machine, text)) is not None)
    driven = {driver.link for driver in machine.drivers}
    for half in (half for quantity in asked for half in quantity.halves):
        if isinstance(half, Rotation) and half.word in TURNS and half.link not in driven:
            _, plane = TURNS[half.word]
            if plane in planes:
                rate = float((plot.omega if plane == "velocity" else plot.alpha)[half.link])
                rates |= {half: rate} if reading.usual.rate(rate, plane) else {}
    return rates
