"""The marks of instant centres measured against the velocities of the analytic solution.

No line of the drawing is asked how a centre was found: two links have one velocity at P = R + i(v_i - v_j) /
(omega_i - omega_j), with both velocities at a point R; where neither turns against the other the centre lies at
infinity, at right angles to v_i - v_j. Source: theoretical mechanics, motion of a plane figure; Sun Huan, 3-2.2.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Literal

from graphkin.analytic import Motion, motion
from graphkin.base.geometry import number, place
from graphkin.base.tolerances import STILL
from graphkin.base.value import frozen
from graphkin.check.drawing import DrawingFile
from graphkin.errors import BadDrawing, Where
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import centre_of

CENTRES: Literal["centres"] = "centres"  # the plane that the marks of centres give


@frozen
class SeenCentre:
    """A centre in the drawing.

    name          `P13`; kind: "point" for a mark, "vector" for an arrow towards it
    drawn, exact  in mm on paper, y up: where a mark lies, and where it should from the mechanism's origin;
                  an arrow from its tail
    """

    name: str
    kind: str
    drawn: complex
    exact: complex


def parted(drawing: DrawingFile) -> tuple[DrawingFile, DrawingFile]:
    """The drawing without its centres, and its centres alone."""
    centres = [element.attributes.get("data-plane") == CENTRES for element in drawing.sight.shown]
    parts = (
        tuple(element for element, is_centre in zip(drawing.sight.shown, centres, strict=True) if is_centre is chosen)
        for chosen in (False, True)
    )
    planes, alone = (replace(drawing, sight=replace(drawing.sight, shown=shown)) for shown in parts)
    return planes, alone


def ways_to_move(mechanism: Mechanism, solved: Motion) -> list[Motion]:
    """The motion itself, and one with the drivers at 1 that rest: links that only those move have centres too."""
    resting = [driver.rate == 0 for driver in mechanism.drivers]
    motions = [] if all(resting) else [solved]
    if any(resting):
        drivers = tuple(replace(driver, rate=float(driver.rate == 0)) for driver in mechanism.drivers)
        motions.append(motion(replace(mechanism, drivers=drivers), solved.values))
    return motions


def seen_centres(
    centres: DrawingFile, mechanism: Mechanism, exact: Sequence[Motion], scale: float
) -> Iterator[SeenCentre]:
    """Every mark of a centre: its place on the paper, and where it should be from the mechanism's origin.

    Links that never move against each other and are not joined have all points in common: there is nothing to measure.

    exact  as `ways_to_move` gives it; scale  [m/mm]. Raises BadDrawing for a centre that is none.
    """
    for attributes, drawn in centres.points:
        name = attributes.get("data-name", "")
        pole, finite = _known(centres, mechanism, exact, attributes)
        if not finite and pole != 0:
            raise BadDrawing(Where(centres.file), "value", f"data-name={name}")
        if finite:
            yield SeenCentre(name, "point", drawn, pole / scale)


def seen_arrows(
    centres: DrawingFile, mechanism: Mechanism, exact: Sequence[Motion], scale: float, origin: complex
) -> Iterator[SeenCentre]:
    """Every arrow towards a centre, as long as it is drawn. origin: of the mechanism on paper [mm], y up."""
    for attributes, tail, head in centres.vectors:
        pole, finite = _known(centres, mechanism, exact, attributes)
        toward = pole / scale + origin - tail if finite else pole
        along = toward / abs(toward) if abs(toward) else 0j
        if not finite and (along.conjugate() * (head - tail)).real < 0:
            along = -along
        yield SeenCentre(attributes.get("data-name", ""), "vector", head - tail, abs(head - tail) * along)


def _known(
    centres: DrawingFile, mechanism: Mechanism, exact: Sequence[Motion], attributes: Mapping[str, str]
) -> tuple[complex, bool]:
    """A centre by the name that an element bears; whether it is at a finite place."""
    name = attributes.get("data-name", "")
    links = centre_of(mechanism, name)
    if links is None:
        raise BadDrawing(Where(centres.file), "value", f"data-name={name}")
    return pole_of(mechanism, exact, *links)


def pole_of(mechanism: Mechanism, exact: Sequence[Motion], first: str, second: str) -> tuple[complex, bool]:
    """The place where two links have one velocity [m], and True; the direction in which it lies at infinity, and False.

    Links at rest against each other at this instant alone (at a dead point) have it where their accelerations say:
    it is the limit of its neighbours. Links that do not move against each other at all have it in their hinge, or at
    right angles to the guide they slide on; 0j and False where they are not joined.
    """
    at = next(point for link in (first, second) for point in mechanism.links[link].points)
    for moved in exact:
        origin = place(moved.position[at])
        size = max(abs(place(other) - origin) for other in moved.position.values()) or 1.0
        speeds = [abs(place(velocity)) / size for velocity in moved.velocity.values()]
        fastest = max(*speeds, *(abs(number(omega)) for omega in moved.omega.values()))  # [rad/s]
        for rates, at_point, usual in (
            (moved.omega, moved.velocity_at, fastest), (moved.alpha, moved.acceleration_at, fastest**2),
        ):  # fmt: skip
            one, other = (0j if link == FRAME else place(at_point(at, link)) for link in (first, second))
            moving, turning = one - other, number(rates[first] - rates[second])
            if abs(turning) > STILL * usual:
                return origin + 1j * moving / turning, True
            if abs(moving) > STILL * usual * size:
                return 1j * moving, False
    # by definition: their hinge, or their guide's normal
    if shared := set(mechanism.links[first].points) & set(mechanism.links[second].points):
        return place(exact[0].position[min(shared)]), True
    for slide in mechanism.slides:
        if {slide.guide, slide.block} == {first, second}:
            return 1j * complex(slide.line.direction) * cmath.exp(1j * number(exact[0].theta[slide.guide])), False
    return 0j, False
