"""Units of results at the edge: SI inside, mm and degrees where people read them. The one table of them."""

from __future__ import annotations

import math

from graphkin.base.value import frozen
from graphkin.model.quantities.digits import significant

GRAVITY = 9.80665
"""Standard acceleration of gravity [m/s^2]."""


@frozen
class Unit:
    """A unit at the edge.

    name    in plain text, as files and tables have it: "deg", "mm", "rad/s^2"; nothing for a quotient
    sign    in print: "°", "mm", "rad/s²"
    factor  by what SI values are multiplied
    """

    name: str
    sign: str
    factor: float = 1.0

    @property
    def after(self) -> str:
        """The sign as it stands after a number: degrees close to it, nothing for a quotient."""
        return self.sign if self.sign in ("°", "") else f" {self.sign}"

    def shown(self, value: float) -> str:
        """`41.2°`, `20 mm`: an SI value in six digits."""
        return significant(value * self.factor, 6) + self.after


EDGE = {
    "rad": Unit("deg", "°", 180 / math.pi), "m": Unit("mm", "mm", 1000.0),
    "rad/s": Unit("rad/s", "rad/s"), "m/s": Unit("m/s", "m/s"),
    "rad/s^2": Unit("rad/s^2", "rad/s²"), "m/s^2": Unit("m/s^2", "m/s²"), "1": Unit("", ""),
}  # fmt: skip
"""By SI unit, how results are shown."""

IN_GRAVITY = Unit("g", "g", 1 / GRAVITY)
"""How accelerations are shown beside."""


def driven(slides: bool) -> str:
    """The SI unit of a driver's value: of one that slides, else of one that turns."""
    return "m" if slides else "rad"
