"""How a guide line lies in its link, by what is given: through which point, at which angle γ to which side."""

from __future__ import annotations

from math import pi

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import cross
from graphkin.base.value import frozen
from graphkin.construction import Swing
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Slide
from graphkin.say import names
from graphkin.say.reading import Reading


@frozen
class GuideAngle:
    """The line through `through` makes `angle` [rad] with corner -> through, counter-clockwise where positive.

    symbol  γ, with the number of the link where several guides have such an angle; "" where another is given
    pivot   the point about which the drawing turns the link, from which γ is counted
    """

    symbol: str
    corner: str
    through: str
    angle: float

    @property
    def arrow(self) -> str:
        return names.arrow(self.corner, self.through)


def guide_angle(reading: Reading, slide: Slide) -> GuideAngle | None:
    """The angle at which a moving guide's line lies; None of one through two points, or that is the link itself."""
    found = _corners(reading)
    if slide.name not in found:
        return None
    corner, through = found[slide.name], slide.line.origin
    arm = reading.mechanism.links[slide.guide].arm(corner, through)
    angle = (float(np.angle(slide.line.direction / arm)) + pi) % (2 * pi) - pi
    alone = len({pair.guide for pair in reading.mechanism.slides if pair.name in found}) == 1
    symbol = "γ" if alone else names.of_link("γ", reading.mechanism.called(slide.guide))
    symbol = symbol if slide.line.base in (None, (corner, through)) else ""
    return GuideAngle(symbol, corner, through, angle)


@kept(8)
def _corners(reading: Reading) -> dict[str, str]:
    """The point from which γ is counted, by the slides that have such an angle."""
    pivots: dict[str, list[str]] = {}
    for step in reading.method.position.steps:
        if isinstance(step, Swing):
            pivots.setdefault(step.slide, []).append(step.pivot)
    corners = ((slide.name, _corner(reading, slide, pivots.get(slide.name, []))) for slide in reading.mechanism.slides)
    return {name: corner for name, corner in corners if corner}


def _corner(reading: Reading, slide: Slide, pivots: list[str]) -> str:
    """The pivot of the drawing, else another point of the guide; "" for none."""
    if slide.guide == FRAME or not slide.line.named:
        return ""
    link, through = reading.mechanism.links[slide.guide], slide.line.origin
    points = [p for p in reading.mechanism.named(slide.guide) if abs(link.arm(p, through)) > reading.noise]
    if any(abs(cross(slide.line.direction, link.arm(p, through))) <= reading.noise for p in points):
        return ""
    stated = [slide.line.base[0]] if slide.line.base is not None and slide.line.base[1] == through else []
    return next((point for point in (*stated, *pivots, *points) if point in points), "")
