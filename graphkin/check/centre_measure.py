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
from graphkin.base.tolerances import STILL
from graphkin.base.value import frozen
from graphkin.check.drawing import DrawingFile
from graphkin.errors import BadDrawing, Where
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import centre_of

CENTRES: Literal["centres"] = "centres"
"""What the marks of centres give as their plane."""


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
    parts = []
    for wanted in (False, True):
        shown = tuple(element for element in drawing.sight.shown if _is_centre(element.attributes) is wanted)
        parts.append(replace(drawing, sight=replace(drawing.sight, shown=shown)))
    return parts[0], parts[1]


def _is_centre(attributes: Mapping[str, str]) -> bool:
    return attributes.get("data-plane") == CENTRES


def ways_to_move(mechanism: Mechanism, solved: Motion) -> list[Motion]:
    """The motion itself, and one with the drivers at 1 that rest: links that only those move have centres too."""
    resting = [driver.rate == 0 for driver in mechanism.drivers]
    found = [] if all(resting) else [solved]
    if any(resting):
        drivers = tuple(replace(driver, rate=float(driver.rate == 0)) for driver in mechanism.drivers)
        found.append(motion(replace(mechanism, drivers=drivers), solved.values))
    return found


def seen_centres(
    centres: DrawingFile, mechanism: Mechanism, exact: Sequence[Motion], scale: float
) -> Iterator[SeenCentre]:
    """Every mark of a centre: its place on the paper, and where it should be from the mechanism's origin.

    Links that never move against each other and are not joined have all points in common: there is nothing to measure.

    exact  as `ways_to_move` gives it; scale  [m/mm]. Raises BadDrawing for a centre that is none.
    """
    for attributes, place in centres.points:
        name = attributes.get("data-name", "")
        pole, turning = _known(centres, mechanism, exact, attributes)
        if not turning and pole == 0:
            continue
        if not turning:
            raise BadDrawing(Where(centres.file), "value", f"data-name={name}")
        yield SeenCentre(name, "point", place, pole / scale)


def seen_arrows(
    centres: DrawingFile, mechanism: Mechanism, exact: Sequence[Motion], scale: float, origin: complex
) -> Iterator[SeenCentre]:
    """Every arrow towards a centre, as long as it is drawn. origin: of the mechanism on paper [mm], y up."""
    for attributes, tail, head in centres.vectors:
        pole, turning = _known(centres, mechanism, exact, attributes)
        way = pole / scale + origin - tail if turning else pole
        along = way / abs(way) if abs(way) else 0j
        if not turning and (along.conjugate() * (head - tail)).real < 0:
            along = -along
        yield SeenCentre(attributes.get("data-name", ""), "vector", head - tail, abs(head - tail) * along)


def _known(
    centres: DrawingFile, mechanism: Mechanism, exact: Sequence[Motion], attributes: Mapping[str, str]
) -> tuple[complex, bool]:
    """A centre by the name that an element bears; whether it is at a finite place."""
    name = attributes.get("data-name", "")
    links = centre_of(mechanism, name)
    found = pole_of(mechanism, exact, *links) if links is not None else None
    if found is None:
        raise BadDrawing(Where(centres.file), "value", f"data-name={name}")
    return found


def pole_of(mechanism: Mechanism, exact: Sequence[Motion], first: str, second: str) -> tuple[complex, bool]:
    """Where two links have one velocity [m], and True; the direction in which it lies at infinity, and False.

    Links at rest against each other at this instant alone (at a dead point) have it where their accelerations say:
    it is the limit of its neighbours. Links that do not move against each other at all have it in their hinge, or at
    right angles to the guide they slide on; 0j and False where they are not joined.
    """
    at = next(point for link in (first, second) for point in mechanism.links[link].points)
    for moved in exact:
        place, size = complex(moved.position[at]), _size(moved, at)
        fastest = _fastest(moved, size)
        for relative, usual in ((_velocities, fastest), (_accelerations, fastest**2)):
            moving, turning = relative(moved, at, first, second)
            if abs(turning) > STILL * usual:
                return place + 1j * moving / turning, True
            if abs(moving) > STILL * usual * size:
                return 1j * moving, False
    return _joint(mechanism, exact[0], first, second)


def _joint(mechanism: Mechanism, exact: Motion, first: str, second: str) -> tuple[complex, bool]:
    """The centre of two links by definition: their hinge, or their guide's normal."""
    shared = set(mechanism.links[first].points) & set(mechanism.links[second].points)
    if shared:
        return complex(exact.position[min(shared)]), True
    for slide in mechanism.slides:
        if {slide.guide, slide.block} == {first, second}:
            turned = cmath.exp(1j * float(exact.theta[slide.guide]))
            return 1j * complex(slide.line.direction) * turned, False
    return 0j, False


def _size(exact: Motion, at: str) -> float:
    return max(abs(complex(place - exact.position[at])) for place in exact.position.values()) or 1.0


def _fastest(exact: Motion, size: float) -> float:
    """The fastest rotation, or speed by size [rad/s]."""
    speeds = [abs(complex(v)) / size for v in exact.velocity.values()]
    return max(*speeds, *(abs(float(omega)) for omega in exact.omega.values()))


def _velocities(exact: Motion, at: str, first: str, second: str) -> tuple[complex, float]:
    """The first link against the second: velocity of a point, angular velocity."""
    one, other = (0j if link == FRAME else exact.velocity_at(at, link) for link in (first, second))
    return complex(one - other), float(exact.omega[first] - exact.omega[second])


def _accelerations(exact: Motion, at: str, first: str, second: str) -> tuple[complex, float]:
    """The same of accelerations, for links at rest against each other."""
    one, other = (0j if link == FRAME else exact.acceleration_at(at, link) for link in (first, second))
    return complex(one - other), float(exact.alpha[first] - exact.alpha[second])
