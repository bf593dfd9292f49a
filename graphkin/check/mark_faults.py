"""Marks that a viewer cannot see, wrong arrow heads, and vectors whose ends are off their points."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, reduce
from itertools import pairwise
from xml.etree.ElementTree import Element

import shapely

from graphkin.base.value import frozen
from graphkin.check.drawing import MARKS, DrawingFile, Fault
from graphkin.check.links import link_name
from graphkin.check.outlines import Affine, is_plain, length, numbers_in, outline, transform
from graphkin.check.shown import FAINT, HAIR, ShownMark, Sight, Style, dashed_away, styled

# --- hidden marks: no ink, off the paper, or painted over --------------------------------------


_SIGN = 7.6  # small signs may lie over a line: a pivot, a corner's filling, a centre's ring; from corner to corner [mm]
_BLOCK = 6.2  # blocks, slots and tubes are no wider than this; they may lie over anything [mm]
_DOT = 1.8  # points are no larger than this [mm]
_THICK = 1.5  # no line of a mark is thicker; one that is counts as a surface [mm]


def name_of(mark: ShownMark) -> str:
    """The name of a link, or the name that the file gives a mark."""
    return link_name(mark.attributes) if "link" in mark.kind else mark.attributes.get("data-name", "")


def _is_mark(element: ShownMark) -> bool:
    return any(kind in element.kind for kind in MARKS)


@frozen
class Layers:
    """The elements of a sheet, from the bottom up. covers: number and area of each surface that hides others."""

    sight: Sight
    covers: tuple[tuple[int, shapely.Geometry], ...]

    @classmethod
    def of(cls, sight: Sight) -> Layers:
        surfaces = ((k, _surface(element)) for k, element in enumerate(sight.shown))
        return cls(sight, tuple((k, area) for k, area in surfaces if area is not None))

    def over(self, number: int) -> list[shapely.Geometry]:
        return [area for at, area in self.covers if at > number]

    def hidden_marks(self) -> Iterator[Fault]:
        """Marks that are not to be seen."""
        for k, mark in enumerate(self.sight.shown):
            if not _is_mark(mark):
                continue
            if not _inked(mark) or not _on_paper(mark, self.sight.paper):
                yield Fault("hidden", name_of(mark))
            if (above := self.over(k)) and mark.lines and _hide(above, mark):
                yield Fault("covered", name_of(mark))

    @cached_property
    def letters(self) -> tuple[tuple[str, complex], ...]:
        """Every text that can be read, and where it begins: on the paper, and not begun under a surface."""
        letters = []
        for k, element in enumerate(self.sight.shown):
            if element.tag == "text" and (words := " ".join(element.text.split())):
                begin = element.lines[0][0] + 0.3 + 0.3j
                under = any(area.contains(shapely.Point(begin.real, begin.imag)) for area in self.over(k))
                if not under and _on_paper(element, self.sight.paper):
                    letters.append((words, element.lines[0][0]))
        return tuple(letters)


def _inked(mark: ShownMark) -> bool:
    """True if there is a line, or a dot, of a width that can be seen and measured."""
    drawn = mark.style.ink("stroke") > FAINT and HAIR < mark.width < _THICK
    if "point" in mark.kind:
        size = abs(mark.lines[0][0] - mark.middle) if mark.tag == "circle" else 0.0
        return 0.2 < size < _DOT and (drawn or mark.style.ink("fill") > FAINT)
    if any(abs(b - a) > 0.05 for line in mark.lines for a, b in pairwise(line)):
        return drawn and not dashed_away(mark.style, "pathLength" in mark.attributes)
    return True


def _on_paper(mark: ShownMark, paper: complex) -> bool:
    places = [place for line in mark.lines for place in line]
    return all(-0.01 <= p.real <= paper.real + 0.01 and -paper.imag - 0.01 <= p.imag <= 0.01 for p in places)


def _hide(above: list[shapely.Geometry], mark: ShownMark) -> bool:
    """A dot is hidden as a whole; a line by a large surface, or for the most part; the path of a point for the most."""
    if "point" in mark.kind:
        return bool(shapely.union_all(above).contains(shapely.Polygon(_xy(mark.lines[0]))))
    line = shapely.MultiLineString([_xy(places) for places in mark.lines])
    under = [(area.intersection(line).length, _size(area)) for area in above]
    large, small = (sum(length for length, size in under if (size > _SIGN) is wanted) for wanted in (True, False))
    most = 0.6 * line.length
    return bool(large > (most if mark.attributes.get("data-form") == "path" else 0.1) or small > max(0.24, most))


def _size(area: shapely.Geometry) -> float:
    left, low, right, high = area.bounds
    return abs(complex(right - left, high - low))


def _surface(element: ShownMark) -> shapely.Geometry | None:
    """The surface that hides what is under an element; nothing for lines, small dark signs, and blocks and hinges."""
    if element.tag == "text" or _belongs(element):
        return None
    parts = []
    if element.tag == "image" or element.style.share("fill") > FAINT:
        parts.append(_whole(element))
    if element.style.share("stroke") > FAINT and element.width > _THICK:
        parts += [shapely.LineString(_xy(line)).buffer(element.width / 2) for line in element.lines]
    whole = shapely.union_all(parts)
    ink = max(element.style.ink("fill"), element.style.ink("stroke"))
    return None if whole.is_empty or (_size(whole) < _SIGN and ink > FAINT) else whole


def _whole(element: ShownMark) -> shapely.Geometry:
    """The area that an element fills; of curves what is around them."""
    areas = [shapely.Polygon(_xy(line)) for line in element.lines if len(line) > 3]
    around = areas if element.plain else [area.convex_hull for area in areas]
    return shapely.union_all([area if area.is_valid else area.buffer(0) for area in around])


def _belongs(element: ShownMark) -> bool:
    """Blocks, slots, tubes and dots are drawn over lines; no larger than they are."""
    if not _is_mark(element) or element.width > _THICK:
        return False
    if element.style.share("fill") <= FAINT:
        return True
    if "point" in element.kind:
        return element.tag == "circle" and abs(element.lines[0][0] - element.middle) < _DOT
    forms = ("block", "slot", "guide", "arc", "omega", "alpha", "push", "thrust")
    return element.attributes.get("data-form") in forms and _whole(element).buffer(-_BLOCK / 2).is_empty


def _xy(line: tuple[complex, ...]) -> list[tuple[float, float]]:
    return [(place.real, place.imag) for place in line]


# --- arrow heads -------------------------------------------------------------------------------


_NO_LENGTH = 0.05  # a vector shorter than this has no head [mm]
_BACK = 4.5  # where heads meet, one may stand so far off the end of its line [mm]
_MARKERS = ("marker-start", "marker-mid", "marker-end")


def wrong_heads(drawing: DrawingFile) -> Iterator[Fault]:
    """Vectors whose head is missing, turned, or at the wrong end; and arrows that say nothing of themselves."""
    for element in drawing.sight.shown:
        bears = [end for end in _MARKERS if element.style.get(end, "none") != "none"]
        if "vector" in element.kind and element.tag == "line":
            tail, head = element.lines[0]
            wanted = ["marker-end"] if abs(head - tail) > _NO_LENGTH else []
            if bears != wanted or not all(_points_on(drawing.root, element) for _ in wanted):
                yield Fault("head", element.attributes.get("data-name", ""))
        elif bears and element.tag != "text":
            yield Fault("arrow", place_of(element))


def place_of(element: ShownMark) -> str:
    """The place of a mark on paper in mm, as text."""
    x, y = element.lines[0][0].real, -element.lines[0][0].imag
    return f"({x:.1f}, {y:.1f})"


def _points_on(root: Element, element: ShownMark) -> bool:
    """True if the marker at a line's end is one dark tip that ends exactly there and opens backwards."""
    named = element.style.get("marker-end").removeprefix("url(").removesuffix(")").strip("\"' ").removeprefix("#")
    marker = next((found for found in root.iter() if found.get("id") == named), None)
    if marker is None or marker.tag.rpartition("}")[2] != "marker":
        return False
    if marker.get("orient") not in ("auto", "auto-start-reverse"):
        return False
    shapes = [child for child in marker if child.tag.rpartition("}")[2] not in ("title", "desc")]
    if len(shapes) != 1:
        return False
    # paint comes to a marker's shape from the elements around it, not from the line that bears it
    above = {child: parent for parent in root.iter() for child in parent}
    nest = [shapes[0]]
    while nest[-1] in above:
        nest.append(above[nest[-1]])
    if reduce(lambda style, element: styled(element.attrib, style), reversed(nest), Style({})).ink("fill") <= 0.3:
        return False
    tag = shapes[0].tag.rpartition("}")[2]
    if not is_plain(tag, shapes[0].attrib) or transform(shapes[0].get("transform", "")) != Affine():
        return False
    unit = 1.0 if marker.get("markerUnits") == "userSpaceOnUse" else length(element.style.get("stroke-width", "1"))
    places = _in_paper_units(marker, outline(tag, shapes[0].attrib)[0], unit * element.scale)
    return places is not None and _is_tip(places)


def _in_paper_units(marker: Element, places: list[complex], unit: float) -> list[complex] | None:
    """Corners from the line's end, x along the line [mm]; None where the marker's window cuts or stretches them."""
    wide, high = (length(marker.get(key, "3")) for key in ("markerWidth", "markerHeight"))
    box = numbers_in(marker.get("viewBox", f"0 0 {wide} {high}"))
    if len(box) != 4 or not (box[2] > 0 and box[3] > 0) or abs(wide / box[2] - high / box[3]) > 1e-6 * wide / box[2]:
        return None
    inside = all(box[0] <= p.real <= box[0] + box[2] and box[1] <= p.imag <= box[1] + box[3] for p in places)
    anchor = complex(length(marker.get("refX", "0")), length(marker.get("refY", "0")))
    return [(p - anchor) * wide / box[2] * unit for p in places] if inside else None


def _is_tip(places: list[complex]) -> bool:
    """The foremost corner lies on the line, where it ends or nearly; the others lie behind it."""
    tip = max(places, key=lambda p: p.real)
    behind = {p - tip for p in places if abs(p - tip) > 1e-6}
    long, wide = max((-p.real for p in behind), default=0.0), max((abs(p.imag) for p in behind), default=0.0)
    sides = sorted(p.imag for p in behind)
    even = len(behind) > 1 and (abs(sum(sides)) < 0.1 or (len(behind) == 2 and min(abs(y) for y in sides) < 0.01))
    back = -_BACK <= tip.real < 0.01 and abs(tip.imag) < 0.01
    return back and all(p.real < -0.3 for p in behind) and 0.5 < long < 6 and 0.2 < wide < long and even


# --- ends of vectors ---------------------------------------------------------------------------


def loose_ends(drawing: DrawingFile, tolerance_mm: float) -> Iterator[Fault]:
    """Vectors must start and end at the points they name."""
    places: dict[tuple[str | None, str | None], list[complex]] = {}
    for attributes, place in drawing.points:
        places.setdefault((attributes.get("data-plane"), attributes.get("data-name")), []).append(place)
    for attributes, tail, head in drawing.vectors:
        ends = [(places.get((attributes.get("data-plane"), attributes.get(key)), []), end)
                for key, end in (("data-tail", tail), ("data-head", head))]  # fmt: skip
        for key, (here, end) in zip(("data-tail", "data-head"), ends, strict=True):
            name, point = attributes.get("data-name"), attributes.get(key)
            apart = [abs(place - end) for place in here]
            if not apart:
                yield Fault("loose", f"{name}: {point}")
            elif not min(apart) <= tolerance_mm:
                yield Fault("end", f"{name} - {point}: {min(apart):.4f} mm")
