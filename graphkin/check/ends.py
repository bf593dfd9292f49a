"""The ends of vectors: each at the point it names, or beside it where it would lie on another vector."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphkin.check.drawing import DrawingFile, Fault

ASIDE = 1.2
"""Vectors on one line are drawn so far apart: both ends are off their points by a whole number of it [mm]."""
_SAME_LINE = 0.35
"""What lies no farther from a vector's line than this lies on it [mm]."""

_Vector = tuple[Mapping[str, str], complex, complex]
_Places = Mapping[tuple[str | None, str | None], list[complex]]


def loose_ends(drawing: DrawingFile, tolerance_mm: float) -> Iterator[Fault]:
    """Vectors must start and end at the points they name; or beside them, where another is on their line."""
    places: dict[tuple[str | None, str | None], list[complex]] = {}
    for attributes, place in drawing.points:
        places.setdefault((attributes.get("data-plane"), attributes.get("data-name")), []).append(place)
    for vector in drawing.vectors:
        aside = _aside(vector, drawing, places, tolerance_mm)
        attributes, tail, head = vector
        for key, end in (("data-tail", tail), ("data-head", head)):
            point, name = (attributes.get("data-plane"), attributes.get(key)), attributes.get("data-name")
            apart = [abs(place + aside - end) for place in places.get(point, ())]
            if not apart:
                yield Fault("loose", f"{name}: {point[1]}")
            elif not min(apart) <= tolerance_mm:
                yield Fault("end", f"{name} - {point[1]}: {min(apart):.4f} mm")


def _aside(vector: _Vector, drawing: DrawingFile, places: _Places, tolerance_mm: float) -> complex:
    """How far a vector was moved off the line of its points because another lies on that line; 0 if it was not."""
    attributes, tail, head = vector
    here = places.get((attributes.get("data-plane"), attributes.get("data-tail")), [])
    if abs(head - tail) <= tolerance_mm or not here:
        return 0j
    normal = 1j * (head - tail) / abs(head - tail)
    off = min((tail - place for place in here), key=abs)
    steps = round((off * normal.conjugate()).real / ASIDE)
    aside = steps * ASIDE * normal
    return aside if steps and abs(off - aside) <= tolerance_mm and _crowded(vector, aside, drawing) else 0j


def _crowded(vector: _Vector, aside: complex, drawing: DrawingFile) -> bool:
    """Whether another vector of the plane runs along this one, a step nearer to the line from which it was moved."""
    attributes, tail, head = vector
    along, beside = (head - tail) / abs(head - tail), tail - ASIDE * aside / abs(aside)
    for other, start, end in drawing.vectors:
        if other is attributes or other.get("data-plane") != attributes.get("data-plane"):
            continue
        offs = [(place - beside) * along.conjugate() for place in (start, end)]
        low, high = sorted(off.real for off in offs)
        if all(abs(off.imag) < _SAME_LINE for off in offs) and min(high, abs(head - tail)) > max(low, 0.0):
            return True
    return False
