"""Arrow heads: whether a viewer shows one at the head of each vector, pointing the way it goes, and nowhere else."""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from xml.etree.ElementTree import Element

from graphkin.check.drawing import DrawingFile, Fault
from graphkin.check.outlines import is_plain, outline
from graphkin.check.shown import ShownMark
from graphkin.check.styles import Style, styled
from graphkin.check.transforms import Affine, length, numbers_in, transform

_NO_LENGTH = 0.05
"""A vector shorter than this has no head [mm]."""
_BACK = 4.5
"""Where heads meet, one may stand so far off the end of its line [mm]."""
_ENDS = ("marker-start", "marker-mid", "marker-end")


def wrong_heads(drawing: DrawingFile) -> Iterator[Fault]:
    """Vectors whose head is missing, turned, or at the wrong end; and arrows that say nothing of themselves."""
    for element in drawing.sight.shown:
        bears = [end for end in _ENDS if element.style.get(end, "none") != "none"]
        if "vector" in element.kind and element.tag == "line":
            tail, head = element.lines[0]
            wanted = ["marker-end"] if abs(head - tail) > _NO_LENGTH else []
            if bears != wanted or not all(_points_on(drawing.root, element) for _ in wanted):
                yield Fault("head", element.attributes.get("data-name", ""))
        elif bears and element.tag != "text":
            yield Fault("arrow", place_of(element))


def place_of(element: ShownMark) -> str:
    x, y = element.lines[0][0].real, -element.lines[0][0].imag
    return f"({x:.1f}, {y:.1f})"


def _points_on(root: Element, element: ShownMark) -> bool:
    """Whether the marker at a line's end is one dark tip that ends exactly there and opens backwards."""
    named = element.style.get("marker-end").removeprefix("url(").removesuffix(")").strip("\"' ").removeprefix("#")
    marker = next((found for found in root.iter() if found.get("id") == named), None)
    if marker is None or marker.tag.rpartition("}")[2] != "marker":
        return False
    if marker.get("orient") not in ("auto", "auto-start-reverse"):
        return False
    shapes = [child for child in marker if child.tag.rpartition("}")[2] not in ("title", "desc")]
    if len(shapes) != 1 or not _dark(root, shapes[0]):
        return False
    tag = shapes[0].tag.rpartition("}")[2]
    if not is_plain(tag, shapes[0].attrib) or transform(shapes[0].get("transform", "")) != Affine():
        return False
    unit = 1.0 if marker.get("markerUnits") == "userSpaceOnUse" else length(element.style.get("stroke-width", "1"))
    places = _placed(marker, outline(tag, shapes[0].attrib)[0], unit * element.scale)
    return places is not None and _is_tip(places)


def _dark(root: Element, shape: Element) -> bool:
    """Paint comes to a marker's shape from the elements around it, not from the line that bears it."""
    above = {child: parent for parent in root.iter() for child in parent}
    way = [shape]
    while way[-1] in above:
        way.append(above[way[-1]])
    return reduce(lambda style, element: styled(element.attrib, style), reversed(way), Style({})).ink("fill") > 0.3


def _placed(marker: Element, places: list[complex], unit: float) -> list[complex] | None:
    """Corners from the line's end, x along the line [mm]; None where the marker's window cuts or stretches them."""
    wide, high = (length(marker.get(key, "3")) for key in ("markerWidth", "markerHeight"))
    box = numbers_in(marker.get("viewBox", f"0 0 {wide} {high}"))
    if len(box) != 4 or not (box[2] > 0 and box[3] > 0) or abs(wide / box[2] - high / box[3]) > 1e-6 * wide / box[2]:
        return None
    inside = all(box[0] <= p.real <= box[0] + box[2] and box[1] <= p.imag <= box[1] + box[3] for p in places)
    anchor = complex(length(marker.get("refX", "0")), length(marker.get("refY", "0")))
    return [(p - anchor) * wide / box[2] * unit for p in places] if inside else None


def _is_tip(places: list[complex]) -> bool:
    """The foremost corner lies on the line, at its end or a head before it; the others behind it, on both sides or
    along the line and on one side of it.
    """
    tip = max(places, key=lambda p: p.real)
    behind = {p - tip for p in places if abs(p - tip) > 1e-6}
    long, wide = max((-p.real for p in behind), default=0.0), max((abs(p.imag) for p in behind), default=0.0)
    sides = sorted(p.imag for p in behind)
    even = len(behind) > 1 and (abs(sum(sides)) < 0.1 or (len(behind) == 2 and min(abs(y) for y in sides) < 0.01))
    back = -_BACK <= tip.real < 0.01 and abs(tip.imag) < 0.01
    return back and all(p.real < -0.3 for p in behind) and 0.5 < long < 6 and 0.2 < wide < long and even
