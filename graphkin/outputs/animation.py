"""Sheets of one mechanism at several positions as one moving SVG (SMIL, which every browser plays).

A mark that is on all the sheets stands in the file once, with the values its attributes take in turn, so that it goes
smoothly from one position to the next; one that is on some of them is hidden on the others. A still viewer shows the
first sheet.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby

from graphkin.outputs.paint import Ink
from graphkin.outputs.svg import Ready, SvgPen
from graphkin.outputs.typesetting import short
from graphkin.sheet import Sheet
from graphkin.sheet.marks import ArcMark, Disc, Mark, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.page import Layer

SECONDS = 8.0
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
_STILL = ("id", "class", "step")
"""What tells marks apart, and never moves."""

Key = tuple[object, ...]
Row = list[Mark | None]
"""A mark as it is on each sheet; None where it is not there."""


def animation(frames: Sequence[Sheet], seconds: float = SECONDS, ink: Ink = "accent") -> str:
    """One SVG that goes through the sheets, and from the last to the first again."""
    first = frames[0]
    pen = SvgPen(first, ink, metadata=True, moving=True)
    for number, layer in enumerate(first.layers):
        group = _moving(pen, layer, [frame.layers[number].marks for frame in frames], seconds)
        if len(group):
            pen.drawing.add(Ready(group))
    return '<?xml version="1.0" encoding="utf-8"?>\n' + str(pen.drawing.tostring()) + "\n"


def _moving(pen: SvgPen, layer: Layer, frames: Sequence[Sequence[Mark]], seconds: float) -> ET.Element:
    """A layer's marks; neighbours in one paint share it."""
    whole = ET.Element("g")
    painted = [(_paint(pen, layer, row), row) for row in _rows(frames)]
    for paint, rows in groupby(painted, key=lambda entry: entry[0]):
        group = ET.SubElement(whole, "g", dict(paint))
        for _, row in rows:
            group.append(_element(pen, layer, row, seconds))
    return whole


def _paint(pen: SvgPen, layer: Layer, row: Row) -> tuple[tuple[str, str], ...]:
    return pen.colours.paint(layer, next(mark for mark in row if mark is not None))


# --- which marks of the sheets are one ---------------------------------------------------------


def _rows(frames: Sequence[Sequence[Mark]]) -> list[Row]:
    """The marks of all sheets in their order of painting, each once."""
    order: list[Key] = []
    rows: dict[Key, Row] = {}
    for number, marks in enumerate(frames):
        at = 0
        for key, mark in _keyed(marks):
            if key not in rows:
                rows[key] = [None] * len(frames)
                order.insert(at, key)
            else:
                at = max(at, order.index(key))
            at += 1
            rows[key][number] = mark
    return [_alike(rows[key]) for key in order]


def _keyed(marks: Iterable[Mark]) -> Iterator[tuple[Key, Mark]]:
    """Each mark with what it is, and the how manyth of its kind."""
    met: Counter[Key] = Counter()
    for mark in marks:
        kind = _kind(mark)
        met[kind] += 1
        yield (*kind, met[kind]), mark


def _kind(mark: Mark) -> Key:
    """What stays the same of it while it moves."""
    match mark:
        case Stroke():
            return "stroke", mark.pen, mark.fill, mark.closed, mark.shows, len(mark.places), mark.accent
        case Disc():
            return "disc", mark.pen, mark.fill, mark.shows, mark.accent
        case ArcMark():
            return "arc", mark.pen, abs(mark.sweep) > 3.14, mark.sweep > 0, mark.accent
        case Text():
            return "text", mark.label, mark.size, mark.accent
        case VectorMark():
            return "vector", mark.plane, mark.name, mark.tail, mark.head
        case PointMark():
            return "point", mark.plane, mark.name, mark.fill


def _alike(row: Row) -> Row:
    """A line's ends, and an outline's first corner, as they were before, where it is drawn from another one now."""
    before: Stroke | None = None
    for k, mark in enumerate(row):
        if isinstance(mark, Stroke):
            if before is not None and mark.places != before.places:
                row[k] = mark = replace(mark, places=_nearest(mark, before.places))
            before = mark
    return row


def _nearest(mark: Stroke, before: Sequence[complex]) -> tuple[complex, ...]:
    count = len(mark.places) if mark.closed else 1
    ways = [(*mark.places[k:], *mark.places[:k]) for k in range(count)]
    ways += [way[::-1] for way in ways]
    return min(ways, key=lambda way: sum(abs(a - b) for a, b in zip(way, before, strict=True)))


# --- elements ---------------------------------------------------------------------------------


def _element(pen: SvgPen, layer: Layer, row: Row, seconds: float) -> ET.Element:
    """A mark as it is first, with what of it changes."""
    shown = [mark is not None for mark in row]
    there = _filled(row)
    made = [_plain(pen.element(mark, layer)) if k == 0 or mark is not there[k - 1] else None
            for k, mark in enumerate(there)]  # fmt: skip
    drawn: list[ET.Element] = []
    for element in made:
        drawn.append(element if element is not None else drawn[-1])
    _change(drawn[0], drawn, seconds)
    if not all(shown):
        states = ["visible" if seen else "hidden" for seen in shown]
        drawn[0].set("visibility", states[0])
        drawn[0].insert(0, _steps("visibility", states, seconds))
    return drawn[0]


def _filled(row: Row) -> list[Mark]:
    """Where it is not there it stays as it was last; before it first comes, as it will be."""
    last = next(mark for mark in row if mark is not None)
    found = []
    for mark in row:
        last = mark or last
        found.append(last)
    return found


def _plain(element: ET.Element) -> ET.Element:
    """Without the size of a vector in words, which is another one in each position."""
    for title in element.findall("title"):
        element.remove(title)
    return element


def _change(into: ET.Element, drawn: Sequence[ET.Element], seconds: float) -> None:
    """Everything in which the elements differ, as values in turn; and so of their parts."""
    for part, parts in zip(list(into), zip(*map(list, drawn), strict=True), strict=True):
        _change(part, parts, seconds)
    names = dict.fromkeys(name for element in drawn for name in element.attrib)
    for place, name in enumerate(name for name in names if name not in _STILL):
        values = [element.get(name, "none") for element in drawn]
        if len(set(values)) == 1:
            continue
        if len({_NUMBER.sub("", value) for value in values}) == 1 and not name.startswith("marker"):
            rounded = [_NUMBER.sub(lambda number: short(float(number[0])), value) for value in values]
            if len(set(rounded)) > 1:
                into.insert(place, _glide(name, rounded, seconds))
        else:
            into.insert(place, _steps(name, values, seconds))


def _glide(name: str, values: Sequence[str], seconds: float) -> ET.Element:
    """From value to value, and to the first again."""
    return ET.Element("animate", {"attributeName": name, "values": ";".join([*values, values[0]])} | _turn(seconds))


def _steps(name: str, values: Sequence[str], seconds: float) -> ET.Element:
    """One value after the other; each as long as it stays."""
    count = len(values)
    changes = [k for k in range(count) if k == 0 or values[k] != values[k - 1]]
    told = {
        "attributeName": name,
        "values": ";".join(values[k] for k in changes),
        "keyTimes": ";".join(short_time(k / count) for k in changes),
        "calcMode": "discrete",
    }
    return ET.Element("animate", told | _turn(seconds))


def short_time(part: float) -> str:
    """A part of the turn."""
    return f"{part:.4f}".rstrip("0").rstrip(".") or "0"


def _turn(seconds: float) -> dict[str, str]:
    return {"dur": f"{seconds:g}s", "repeatCount": "indefinite"}
