"""The velocity image of a gear: a circle about the image of its centre, of radius omega r; a fixed gear is a point."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.model.mechanism import FRAME
from graphkin.planning import Method
from graphkin.planning.step_numbers import rate_found
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, point_label
from graphkin.sheet.marks import Disc, Place, VectorMark
from graphkin.sheet.wheels import Wheel, wheels_of
from graphkin.sheet.window import Figure, Window

_LEAST = 0.4
"""A circle smaller than this is a point [mm]."""


@frozen
class GearImage:
    """One gear in the velocity plane: centre and radius [m/s], the polygon's point there, when it can be drawn."""

    label: Label
    at: complex
    radius: float
    centre: str
    step: int | None

    @property
    def corners(self) -> Iterator[complex]:
        yield from (self.at + self.radius * (1 + 1j), self.at - self.radius * (1 + 1j))


def gear_images(method: Method, plot: Plot) -> list[GearImage]:
    """Every gear once; wheels that only roll have none. `g` is another letter where the mechanism has a point G."""
    letter = next((c for c in "gwzu" if c.upper() not in method.mechanism.points), "g")
    found: list[GearImage] = []
    for wheel in wheels_of(method.mechanism):
        centre = _centre(method, wheel) if wheel.gear else None
        if centre is None or centre not in plot.velocity:
            continue
        omega = abs(float(plot.omega[wheel.link]))
        label = point_label(f"{letter}@{method.mechanism.called(wheel.link)}")
        at = complex(plot.velocity[centre])
        found.append(GearImage(label, at, omega * wheel.radius, centre, _known(method, wheel.link)))
    return found


def _centre(method: Method, wheel: Wheel) -> str | None:
    """The polygon's point of a gear's centre; those of fixed points are the pole's."""
    owners = method.mechanism.owners.get(wheel.centre, ())
    if FRAME in owners or wheel.link == FRAME:
        return method.velocity.pole
    nodes = method.velocity.nodes.items()
    at_centre = [(name, node.site) for name, node in nodes if node.site and node.site.point == wheel.centre]
    at_centre.sort(key=lambda entry: entry[1] is None or entry[1].link != wheel.link)
    return next((name for name, site in at_centre if site is not None and site.link in owners), None)


def _known(method: Method, link: str) -> int | None:
    """The act in which a link's angular velocity is found; the first of the plane for a driven one."""
    first = next((act.page for act in method.acts if act.plane == "velocity"), None)
    return rate_found(method, "velocity", link) or first


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
        ways = [cmath.rect(1, math.radians(15 + 30 * k)) for k in range(12)]
        others = [entry for entry in drawn if entry != (at, radius)]
        way = max(ways, key=lambda w, at=at, radius=radius, o=others: _room(at + radius * w, arrows, places, o))  # type: ignore[misc]
        figure.wanted.append(LabelRequest(image.label, at + radius * way, gap=0.4, away=way, step=image.step))
    return figure


def _room(
    spot: Place, arrows: Sequence[VectorMark], places: Sequence[Place], others: list[tuple[Place, float]]
) -> float:
    """How far a place is from arrows, points and the other circles, as far as it matters [mm]."""
    gaps = [abs(spot - place) for place in places]
    for arrow in arrows:
        way = arrow.end - arrow.start
        t = ((way.conjugate() * (spot - arrow.start)).real / abs(way) ** 2) if way else 0.0
        gaps.append(abs(spot - arrow.start - way * max(0.0, min(1.0, t))))
    gaps += [abs(abs(spot - at) - radius) for at, radius in others]
    return min([9.0, *gaps])


def points(images: Sequence[GearImage], window: Window) -> dict[str, list[Label]]:
    """Letters of the gears whose image is a point, by the polygon's point they lie on."""
    found: dict[str, list[Label]] = {}
    for image in images:
        if image.radius / window.scale < _LEAST and image.label not in found.get(image.centre, []):
            found.setdefault(image.centre, []).append(image.label)
    return found
