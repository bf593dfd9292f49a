"""The velocity image of a gear: a circle about the image of its centre, of radius omega r; a fixed gear is a point."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

from graphkin.base import geometry
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.model.mechanism import FRAME
from graphkin.planning import Method
from graphkin.planning.method import rate_found
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, point_label
from graphkin.sheet.marks import Disc, Place, VectorMark
from graphkin.sheet.skeleton import off_stretch
from graphkin.sheet.wheels import Wheel, wheels_of
from graphkin.sheet.window import Figure, Window

_LEAST = 0.4  # a circle smaller than this is a point [mm]


@frozen
class GearImage:
    """One gear in the velocity plane: centre and radius [m/s], the polygon's point there, when it can be drawn."""

    label: Label
    at: complex
    radius: float
    centre: str
    step: int | None

    @property
    def corners(self) -> tuple[complex, complex]:
        return self.at + self.radius * (1 + 1j), self.at - self.radius * (1 + 1j)


def gear_images(method: Method, plot: Plot) -> list[GearImage]:
    """Every gear once; wheels that only roll have none. `g` is another letter where the mechanism has a point G."""
    letter = next((c for c in "gwzu" if c.upper() not in method.mechanism.points), "g")
    start = next((act.page for act in method.acts if act.plane == "velocity"), None)
    images: list[GearImage] = []
    for wheel in wheels_of(method.mechanism):
        centre = _centre(method, wheel) if wheel.gear else None
        if centre is None or centre not in plot.velocity:
            continue
        radius = abs(geometry.number(plot.omega[wheel.link])) * wheel.radius
        label = point_label(f"{letter}@{method.mechanism.called(wheel.link)}")
        at, step = geometry.place(plot.velocity[centre]), rate_found(method, "velocity", wheel.link) or start
        images.append(GearImage(label, at, radius, centre, step))
    return images


def _centre(method: Method, wheel: Wheel) -> str | None:
    """The polygon's point of a gear's centre; those of fixed points are the pole's."""
    owners = method.mechanism.owners.get(wheel.centre, ())
    if FRAME in owners or wheel.link == FRAME:
        return method.velocity.pole
    nodes = method.velocity.nodes.items()
    at_centre = [(name, node.site) for name, node in nodes if node.site and node.site.point == wheel.centre]
    at_centre.sort(key=lambda entry: entry[1] is None or entry[1].link != wheel.link)
    return next((name for name, site in at_centre if site is not None and site.link in owners), None)


def circles(
    images: Sequence[GearImage], window: Window, arrows: Sequence[VectorMark], places: Sequence[Place]
) -> Figure:
    """Thin circles with their letters, each where little else lies."""
    figure = Figure()
    drawn = [(window(image.at), image.radius / window.scale) for image in images]
    for image, (at, radius) in zip(images, drawn, strict=True):
        if radius < _LEAST:
            continue
        figure.marks.append(Disc(at, radius, "thin", step=image.step))
        others = [circle for circle in drawn if circle != (at, radius)]
        rim = [at + cmath.rect(radius, math.radians(15 + 30 * k)) for k in range(12)]
        gaps = [
            min([9.0, *(abs(spot - place) for place in places), *(abs(abs(spot - o) - r) for o, r in others),
                 *(off_stretch(spot, arrow.start, arrow.end) for arrow in arrows)])
            for spot in rim
        ]  # fmt: skip
        spot = rim[gaps.index(max(gaps))]
        figure.wanted.append(LabelRequest(image.label, spot, gap=0.4, away=(spot - at) / radius, step=image.step))
    return figure


def points(images: Sequence[GearImage], window: Window) -> dict[str, list[Label]]:
    """Letters of the gears whose image is a point, by the polygon's point they lie on."""
    letters: dict[str, list[Label]] = {}
    for image in images:
        if image.radius / window.scale < _LEAST and image.label not in letters.get(image.centre, []):
            letters.setdefault(image.centre, []).append(image.label)
    return letters
