"""What a viewer cannot see of the marks: no ink, off the paper, or something painted over them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import pairwise

import shapely

from graphkin.base.value import frozen
from graphkin.check.drawing import MARKS, Fault
from graphkin.check.links import link_name
from graphkin.check.shown import ShownMark, Sight
from graphkin.check.styles import FAINT, HAIR, dashed_away

_SIGN = 7.6
"""Small signs may lie over a line: a pivot, a corner's filling, a centre's ring; from corner to corner [mm]."""
_BLOCK = 6.2
"""Blocks, slots and tubes are no wider than this; they may lie over anything [mm]."""
_DOT = 1.8
"""Points are no larger than this [mm]."""
_THICK = 1.5
"""No line of a mark is thicker; one that is counts as a surface [mm]."""


def name_of(mark: ShownMark) -> str:
    return link_name(mark.attributes) if "link" in mark.kind else mark.attributes.get("data-name", "")


def _is_mark(element: ShownMark) -> bool:
    return any(kind in element.kind for kind in MARKS)


@frozen
class Layers:
    """What lies on a sheet, one over the other. covers: number and area of each surface that hides what is under it."""

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
        texts = ((k, element) for k, element in enumerate(self.sight.shown) if element.tag == "text")
        found = ((" ".join(text.text.split()), text.lines[0][0]) for k, text in texts if self._can_be_read(k, text))
        return tuple((text, place) for text, place in found if text)

    def _can_be_read(self, number: int, text: ShownMark) -> bool:
        begin = text.lines[0][0] + 0.3 + 0.3j
        under = any(area.contains(shapely.Point(begin.real, begin.imag)) for area in self.over(number))
        return not under and _on_paper(text, self.sight.paper)


def _inked(mark: ShownMark) -> bool:
    """Whether there is a line, or a dot, of a width that can be seen and measured."""
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


# --- one over another -------------------------------------------------------------------------


def _hide(above: list[shapely.Geometry], mark: ShownMark) -> bool:
    """A dot is hidden as a whole; a line by a large surface over any of it, or by small signs over most of it; the path
    of a point, which runs under the links, by anything over most of it.
    """
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
    """What an element hides of what is under it; nothing for lines, small dark signs, and blocks and hinges."""
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
    forms = ("block", "slot", "guide", "arc", "omega", "alpha", "push")
    return element.attributes.get("data-form") in forms and _whole(element).buffer(-_BLOCK / 2).is_empty


def _xy(line: tuple[complex, ...]) -> list[tuple[float, float]]:
    return [(place.real, place.imag) for place in line]
