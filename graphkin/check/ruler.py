"""The ruler on a drawing file: every vector and point beside what it should be, and what else is wrong."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Literal

from graphkin.analytic import Motion, motion
from graphkin.check.centre_measure import CENTRES, parted, seen_arrows, seen_centres, ways_to_move
from graphkin.check.drawing import UNITS, DrawingFile, Fault, mechanism_of, numbers, plane_of, read, scales_of
from graphkin.check.widened import Widened, widened
from graphkin.errors import BadDrawing, Where
from graphkin.mechanism import Mechanism
from graphkin.naming import pair, seen
from graphkin.readings import relative
from graphkin.seal import seal
from graphkin.steps import Plane
from graphkin.value import frozen

__all__ = ["Measured", "Report", "measure"]


@frozen
class Measured:
    """One vector or point of the drawing: what the ruler says, what it should be.

    drawn, exact  in mm on paper, x to the right and y up
    unit_per_mm   scale of its plane, in `unit` per mm
    """

    plane: Plane | Literal["centres"]
    name: str
    kind: str
    drawn: complex
    exact: complex
    unit_per_mm: float
    unit: str

    @property
    def off_mm(self) -> float:
        return abs(self.drawn - self.exact)


@frozen
class Report:
    """What a ruler finds in one drawing file.

    faults  what is wrong with it beyond lengths: a point that is not where its vector ends, a transform
    """

    file: str
    measured: tuple[Measured, ...]
    faults: tuple[Fault, ...]

    def passed(self, tolerance_mm: float) -> bool:
        return not self.faults and all(entry.off_mm <= tolerance_mm for entry in self.measured)

    def wrong(self, tolerance_mm: float) -> int:
        """How many things are wrong; a length that is no number is."""
        return sum(not entry.off_mm <= tolerance_mm for entry in self.measured) + len(self.faults)


def measure(path: str | Path, tolerance_mm: float = 0.01) -> Report:
    """Measure a drawing file against the analytic solution of the mechanism in it.

    Raises `BadDrawing` where the file is no drawing of graphkin's, and the errors of `loading` and
    `analytic` where the mechanism in it is none.
    """
    drawing = read(Path(path))
    mechanism = mechanism_of(drawing)
    solved = motion(mechanism, numbers(drawing, "drivers", len(mechanism.drivers)))
    planes, centres = parted(drawing)
    exact = widened(mechanism, solved, planes)
    scales = scales_of(drawing)
    entries = [*_vectors(planes, mechanism, exact, scales), *_points(planes, mechanism, exact, scales)]
    if centres.points or centres.vectors:
        entries += _centres(planes, centres, mechanism, solved, scales)
    faults = (*drawing.faults, *_changed(drawing, scales), *_loose_ends(planes, tolerance_mm))
    return Report(drawing.file, tuple(entries), faults)


# --- lengths ----------------------------------------------------------------------------------


def _vectors(
    drawing: DrawingFile, mechanism: Mechanism, exact: Widened, scales: Mapping[Plane, float]
) -> Iterator[Measured]:
    for attributes, tail, head in drawing.vectors:
        plane, name = plane_of(drawing, attributes), attributes.get("data-name", "")
        value = _exact(mechanism, exact, plane, name)
        if value is None:
            raise BadDrawing(Where(drawing.file), "value", f"data-name={name}")
        yield Measured(plane, name, "vector", head - tail, value / scales[plane], scales[plane], UNITS[plane])


def _exact(mechanism: Mechanism, exact: Widened, plane: Plane, name: str) -> complex | None:
    """What a vector called `v_CB`, `a^k_B3B2` or `v_DG+v_S4D` should be, from the analytic solution."""
    if "+" in name:
        parts = [_exact(mechanism, exact, plane, part) for part in name.split("+")]
        return sum((part for part in parts if part is not None), 0j) if None not in parts else None
    head, _, sites = name.partition("_")
    letter, _, part = head.partition("^")
    if letter != {"velocity": "v", "acceleration": "a"}.get(plane):
        return None
    if (site := seen(mechanism, sites, exact.added)) is not None and not part:
        at = exact.velocity_at if plane == "velocity" else exact.acceleration_at
        return complex(at(site.point, site.link))
    if (both := pair(mechanism, sites, exact.added)) is None:
        return None
    value = relative(mechanism, exact, plane, part, *both)
    return None if value is None else complex(value)


def _points(
    drawing: DrawingFile, mechanism: Mechanism, exact: Widened, scales: Mapping[Plane, float]
) -> Iterator[Measured]:
    """Points of the mechanism against each other; points of a polygon against its pole."""
    for plane in dict.fromkeys(plane_of(drawing, attributes) for attributes, _ in drawing.points):
        placed = [(a, place) for a, place in drawing.points if a.get("data-plane") == plane]
        wanted = {}
        for attributes, place in placed:
            value = _exact_point(mechanism, exact, plane, attributes.get("data-of", ""))
            if value is not None:
                wanted[attributes.get("data-name", "")] = (place, value / scales[plane])
        origin = _origin(list(wanted.values()))
        for name, (place, right) in wanted.items():
            yield Measured(plane, name, "point", place - origin, right, scales[plane], UNITS[plane])


def _exact_point(mechanism: Mechanism, exact: Widened, plane: Plane, of: str) -> complex | None:
    if of == "pole":
        return 0j
    site = seen(mechanism, of, exact.added)
    if site is None:
        return None
    if plane == "position":
        return complex(exact.position[site.point])
    at = exact.velocity_at if plane == "velocity" else exact.acceleration_at
    return complex(at(site.point, site.link))


def _centres(
    planes: DrawingFile, centres: DrawingFile, mechanism: Mechanism, solved: Motion, scales: Mapping[Plane, float]
) -> Iterator[Measured]:
    """Marks of instant centres with the mechanism's points, and arrows towards centres that have no mark."""
    if "position" not in scales:
        raise BadDrawing(Where(centres.file), "value", "scales.length")
    scale, exact = scales["position"], ways_to_move(mechanism, solved)
    marks = list(seen_centres(centres, mechanism, exact, scale))
    pairs = [(mark.drawn, mark.exact) for mark in marks]
    for attributes, place in planes.points:
        of = attributes.get("data-of", "")
        if attributes.get("data-plane") == "position" and of in solved.position:
            pairs.append((place, complex(solved.position[of]) / scale))
    origin = _origin(pairs)
    for mark in marks:
        yield Measured(CENTRES, mark.name, mark.kind, mark.drawn - origin, mark.exact, scale, "m")
    for arrow in seen_arrows(centres, mechanism, exact, scale, origin):
        yield Measured(CENTRES, arrow.name, arrow.kind, arrow.drawn, arrow.exact, scale, "m")


def _origin(pairs: list[tuple[complex, complex]]) -> complex:
    """Where zero lies on the paper, as the point with which most of the others agree has it."""
    origins = [place - right for place, right in pairs]
    return min(origins, key=lambda origin: sorted(abs(other - origin) for other in origins)[len(origins) // 2])


# --- what is no length ------------------------------------------------------------------------


def _changed(drawing: DrawingFile, scales: Mapping[Plane, float]) -> Iterator[Fault]:
    """What the file says of itself must be as it was when it was drawn, and the printed scales the same."""
    if drawing.claims.get("seal") != seal(drawing.claims):
        yield Fault("changed", "")
    letters: Mapping[str, Plane] = {"l": "position", "v": "velocity", "a": "acceleration"}
    for letter, text in dict.fromkeys(drawing.written):
        plane = letters[letter]
        if plane in scales and not _as_written(text, scales[plane]):
            yield Fault("scale", f"μ_{letter} = {text}")
    yield from _missing(drawing)


def _missing(drawing: DrawingFile) -> Iterator[Fault]:
    """Every vector and point that was drawn must be there, once."""
    given = drawing.claims.get("drawn")
    told = given if isinstance(given, list) else []
    wanted = Counter(tuple(entry) for entry in told if isinstance(entry, list))
    kinds = (("vector", drawing.vectors), ("point", drawing.points))
    found = Counter((a.get("data-plane"), kind, a.get("data-name")) for kind, every in kinds for a, *_ in every)
    for plane, _, name in (wanted - found).elements():
        yield Fault("missing", f"{name} ({plane})")
    for plane, _, name in (found - wanted).elements():
        yield Fault("extra", f"{name} ({plane})")


def _as_written(text: str, scale: float) -> bool:
    mantissa, *power = re.split(r"\s*[×·]\s*10", text.replace("−", "-"))
    try:
        return math.isclose(float(mantissa) * 10.0 ** int(power[0] if power else 0), scale, rel_tol=1e-3)
    except ValueError:
        return False


def _loose_ends(drawing: DrawingFile, tolerance_mm: float) -> Iterator[Fault]:
    """Vectors must start and end at the points they name."""
    places = {(a.get("data-plane"), a.get("data-name")): place for a, place in drawing.points}
    for attributes, tail, head in drawing.vectors:
        for key, end in (("data-tail", tail), ("data-head", head)):
            point, name = (attributes.get("data-plane"), attributes.get(key)), attributes.get("data-name")
            if point not in places:
                yield Fault("loose", f"{name}: {point[1]}")
            elif not abs(places[point] - end) <= tolerance_mm:
                yield Fault("end", f"{name} - {point[1]}: {abs(places[point] - end):.4f} mm")
