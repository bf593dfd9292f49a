"""The ruler on a drawing file: vectors, points, links and centres beside what they should be; what else is wrong."""

from __future__ import annotations

import cmath
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import Literal

from graphkin.analytic import Motion, motion
from graphkin.base.geometry import number, place
from graphkin.base.tolerances import STILL
from graphkin.base.value import bulky, frozen
from graphkin.check.claims import changed, judged
from graphkin.check.drawing import (
    UNITS,
    DrawingFile,
    Fault,
    driver_values,
    ends,
    mechanism_of,
    plane_of,
    read,
    scales_of,
)
from graphkin.check.expected import Widened, is_called_so, is_named_so, point_value, vector_value, widened
from graphkin.check.links import link_name, worst_of_path, worst_place
from graphkin.check.mark_faults import Layers, loose_ends, wrong_heads
from graphkin.check.outlines import Unread
from graphkin.check.shown import ShownMark
from graphkin.construction import Plane
from graphkin.errors import BadDrawing, Where
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import centre_of

CENTRES: Literal["centres"] = "centres"  # the plane that the marks of centres give


@frozen
class RulerReading:
    """One vector, point or line of a link: what the ruler says, what it should be.

    drawn, exact  in mm on paper, x to the right and y up; of a link, the place that is farthest off
    unit_per_mm   scale of its plane, in `unit` per mm
    """

    plane: Plane | Literal["centres", "sheet"]
    name: str
    kind: str
    drawn: complex
    exact: complex
    unit_per_mm: float
    unit: str

    @property
    def off_mm(self) -> float:
        return abs(self.drawn - self.exact)


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
) -> Iterator[RulerReading]:
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
            yield RulerReading(CENTRES, name, "point", drawn, pole / scale, scale, "m")


def seen_arrows(
    centres: DrawingFile, mechanism: Mechanism, exact: Sequence[Motion], scale: float, origin: complex
) -> Iterator[RulerReading]:
    """Every arrow towards a centre, as long as it is drawn. origin: of the mechanism on paper [mm], y up."""
    for attributes, tail, head in centres.vectors:
        pole, finite = _known(centres, mechanism, exact, attributes)
        toward = pole / scale + origin - tail if finite else pole
        along = toward / abs(toward) if abs(toward) else 0j
        if not finite and (along.conjugate() * (head - tail)).real < 0:
            along = -along
        drawn, name = head - tail, attributes.get("data-name", "")
        yield RulerReading(CENTRES, name, "vector", drawn, abs(drawn) * along, scale, "m")


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

    No line of the drawing is asked how a centre was found: two links have one velocity at P = R + i(v_i - v_j) /
    (omega_i - omega_j), with both velocities at a point R; where neither turns against the other the centre lies at
    infinity, at right angles to v_i - v_j. Source: theoretical mechanics, motion of a plane figure; Sun Huan, 3-2.2.
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


@bulky
class RulerReport:
    """The findings of a ruler in one drawing file.

    faults  what is wrong with it beyond lengths: a point that is not where its vector ends, a mark that is hidden
    notes   what was not judged
    """

    file: str
    measured: tuple[RulerReading, ...]
    faults: tuple[Fault, ...]
    notes: tuple[Fault, ...] = ()

    def passed(self, tolerance_mm: float = 0.01) -> bool:
        """True where nothing is off by more."""
        return not self.faults and all(entry.off_mm <= tolerance_mm for entry in self.measured)

    def wrong(self, tolerance_mm: float) -> int:
        """The number of things that are wrong; a length that is no number is."""
        return sum(not entry.off_mm <= tolerance_mm for entry in self.measured) + len(self.faults)


def measure(path: str | Path, tolerance_mm: float = 0.01) -> RulerReport:
    """Measure what a viewer shows of a drawing file against the analytic solution of the mechanism in it.

    What that proves, and what not, says `graphkin.check.claims`. Raises `BadDrawing` where the file is no drawing of
    graphkin's or a reader cannot tell what a viewer would show, and the errors of `loading` and `analytic` where the
    mechanism in it is none.
    """
    drawing = read(Path(path))
    return measured(drawing, mechanism_of(drawing), tolerance_mm)


def measured(drawing: DrawingFile, mechanism: Mechanism, tolerance_mm: float) -> RulerReport:
    """A drawing beside the mechanism that it should show."""
    values = driver_values(drawing, len(mechanism.drivers))
    planes, centres = parted(drawing)
    scales = scales_of(drawing)
    ruler = _CentrelessDrawing(planes, mechanism, scales, values)
    try:
        entries = [*ruler.vectors(), *ruler.points(), *ruler.links()]
        if centres.points or centres.vectors:
            entries += _centres(planes, centres, mechanism, ruler.solved, scales)
        layers = Layers.of(drawing.sight)
        faults = [*changed(drawing, layers.letters, mechanism, scales), *wrong_heads(drawing), *layers.hidden_marks()]
        signs, notes = judged(drawing, layers.letters)
        faults += [*signs, *ruler.misfits(), *loose_ends(planes, tolerance_mm)]
        notes += ruler.unknown()
    except Unread as error:
        raise BadDrawing(Where(drawing.file), "shown", str(error)) from None
    return RulerReport(drawing.file, tuple(entries), tuple(faults), tuple(notes))


@frozen
class _CentrelessDrawing:
    """A drawing without its centres, beside the solution; values: the drivers' [rad, m]."""

    drawing: DrawingFile
    mechanism: Mechanism
    scales: Mapping[Plane, float]
    values: Sequence[float]

    @cached_property
    def solved(self) -> Motion:
        """The analytic solution; of a sheet without points, which may show dead points, none is asked for."""
        return motion(self.mechanism, self.values)

    @cached_property
    def exact(self) -> Widened:
        return widened(self.mechanism, self.solved, self.drawing)

    def _measured(self, plane: Plane, name: str, kind: str, drawn: complex, right: complex) -> RulerReading:
        return RulerReading(plane, name, kind, drawn, right, self.scales[plane], UNITS[plane])

    def vectors(self) -> Iterator[RulerReading]:
        for attributes, tail, head in self.drawing.vectors:
            plane, name = plane_of(self.drawing, attributes), attributes.get("data-name", "")
            value = vector_value(self.exact, plane, attributes)
            if value is None or plane == "position" or not is_called_so(self.exact, plane, attributes):
                raise BadDrawing(Where(self.drawing.file), "value", f"data-name={name}")
            yield self._measured(plane, name, "vector", head - tail, value / self.scales[plane])

    def _placed(self, plane: Plane) -> list[tuple[str, complex, complex]]:
        """Name, place on paper and right place of the points that are known, the latter from the origin [mm]."""
        there = [(said, place) for said, place in self.drawing.points if said.get("data-plane") == plane]
        values = [point_value(self.mechanism, self.exact, plane, said) for said, _ in there]
        return [(said.get("data-name", ""), place, value / self.scales[plane])
                for (said, place), value in zip(there, values, strict=True) if value is not None]  # fmt: skip

    def points(self) -> Iterator[RulerReading]:
        """Points of the mechanism against each other; points of a polygon against its pole."""
        for plane in self.scales:
            if placed := self._placed(plane):
                origin = _origin([(place, right) for _, place, right in placed])
                for name, place, right in placed:
                    yield self._measured(plane, name, "point", place - origin, right)

    def links(self) -> Iterator[RulerReading]:
        """Lines of links against the places where the points should be."""
        origins: dict[Plane, complex] = {}
        for mark in self.drawing.of_class("link"):
            if mark.attributes.get("data-form") == "ruler":
                along = mark.lines[0][-1] - mark.lines[0][0] if mark.lines else 0j  # 100 mm on paper
                yield RulerReading("sheet", "100 mm", "link", along, 100 * along / (abs(along) or 1.0), 1e-3, "m")
            elif self.drawing.measures_links:
                yield self._link(mark, origins)

    def _link(self, mark: ShownMark, origins: dict[Plane, complex]) -> RulerReading:
        plane, name = plane_of(self.drawing, mark.attributes), link_name(mark.attributes)
        try:
            if plane not in origins:
                origins[plane] = _origin([(place, right) for _, place, right in self._placed(plane)])
            origin, scale = origins[plane], self.scales[plane]
            if mark.attributes.get("data-form") == "path":
                worst = worst_of_path(mark, self.mechanism, self.values, scale, origin)
            elif plane == "position":
                worst = worst_place(mark, self.exact, lambda point: self.exact.place(point) / scale + origin, scale)
            else:
                right = {name: value + origin for name, _, value in self._placed(plane)}
                worst = worst_place(mark, self.exact, right.__getitem__, scale)
        except (KeyError, ValueError):
            worst = None
        if worst is None:
            raise BadDrawing(Where(self.drawing.file), "value", f"data-link={name}")
        return self._measured(plane, name, "link", worst[0] - origin, worst[1] - origin)

    def misfits(self) -> Iterator[Fault]:
        """Points whose name is not that of the site they are measured by."""
        for attributes, _ in self.drawing.points:
            if not is_named_so(self.exact, attributes):
                yield Fault("name", attributes.get("data-name", ""))
        for vector in self.drawing.of_class("vector"):
            if not vector.tip:
                continue
            # its value in words is its length, to the digits that are written
            value, plane = re.search(r"= ([0-9.e+-]+) m/s²?$", vector.tip), plane_of(self.drawing, vector.attributes)
            tail, head = ends(vector)
            size = abs(head - tail) * self.scales[plane]
            if value is None or not abs(float(value[1]) - size) <= 1e-3 * size + 1e-3 * self.scales[plane]:
                yield Fault("tip", vector.attributes.get("data-name", ""))

    def unknown(self) -> Iterator[Fault]:
        """Points of which nobody says what they are, and at which no arrow ends."""
        keys = ("data-tail", "data-head")
        ends = [(said.get("data-plane"), said.get(key)) for said, *_ in self.drawing.vectors for key in keys]
        if not self.drawing.points:
            yield Fault("nothing", "")
        for attributes, _ in self.drawing.points:
            plane, name = attributes.get("data-plane", ""), attributes.get("data-name", "")
            known = plane in self.scales and point_value(self.mechanism, self.exact, plane, attributes) is not None  # type: ignore[arg-type]
            if not known and (plane, name) not in ends:
                yield Fault("unknown", name)


def _centres(
    planes: DrawingFile, centres: DrawingFile, mechanism: Mechanism, solved: Motion, scales: Mapping[Plane, float]
) -> Iterator[RulerReading]:
    """Marks of instant centres with the mechanism's points, and arrows towards centres that have no mark."""
    if "position" not in scales:
        raise BadDrawing(Where(centres.file), "value", "scales.length")
    scale, exact = scales["position"], ways_to_move(mechanism, solved)
    marks = list(seen_centres(centres, mechanism, exact, scale))
    pairs = [(mark.drawn, mark.exact) for mark in marks]
    for attributes, drawn in planes.points:
        of = attributes.get("data-of", "")
        if attributes.get("data-plane") == "position" and of in solved.position:
            pairs.append((drawn, complex(solved.position[of]) / scale))
    origin = _origin(pairs)
    yield from (replace(mark, drawn=mark.drawn - origin) for mark in marks)
    yield from seen_arrows(centres, mechanism, exact, scale, origin)


def _origin(pairs: list[tuple[complex, complex]]) -> complex:
    """The place of zero on the paper, as the point with which most of the others agree has it."""
    origins = [place - right for place, right in pairs]
    return min(origins, key=lambda origin: sorted(abs(other - origin) for other in origins)[len(origins) // 2])
