"""Sheets of one mechanism at several positions as one moving SVG (SMIL, which every browser plays).

A mark that is on all the sheets stands in the file once, with the values its attributes take in turn, so that it goes
smoothly from one position to the next; one that is on some of them is hidden on the others. A still viewer shows the
first sheet.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby
from typing import assert_never

from graphkin.outputs.paint import Ink
from graphkin.outputs.svg import Ready, SvgPen
from graphkin.outputs.typesetting import short
from graphkin.sheet import Sheet
from graphkin.sheet.marks import ArcMark, Disc, Mark, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.page import Layer

SECONDS = 8.0
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
_STILL = ("id", "class", "step")  # attributes that tell marks apart, and never move
Row = list[Mark | None]  # a mark as it is on each sheet; None where it is not there


def animation(frames: Sequence[Sheet], seconds: float = SECONDS, ink: Ink = "accent") -> str:
    """One SVG that goes through the sheets, and from the last to the first again."""
    first = frames[0]
    pen = SvgPen(first, ink, metadata=True, moving=True)
    for number, layer in enumerate(first.layers):
        whole, painted = ET.Element("g"), list[tuple[tuple[tuple[str, str], ...], Row]]()
        for row in _rows([frame.layers[number].marks for frame in frames]):
            painted.append((pen.colours.paint(layer, next(mark for mark in row if mark is not None)), row))
        for paint, rows in groupby(painted, key=lambda entry: entry[0]):  # neighbours in one paint share it
            group = ET.SubElement(whole, "g", dict(paint))
            group.extend([_element(pen, layer, row, seconds) for _, row in rows])
        if len(whole):
            pen.drawing.add(Ready(whole))
    return '<?xml version="1.0" encoding="utf-8"?>\n' + str(pen.drawing.tostring()) + "\n"


def _rows(frames: Sequence[Sequence[Mark]]) -> list[Row]:
    """The marks of all sheets; an end or a corner stays the first where it is drawn from another one now."""
    rows = matched(frames)
    for row in rows:
        before: Stroke | None = None
        for k, each in enumerate(row):
            if isinstance(each, Stroke):
                row[k] = before = each if before is None else as_before(each, before)
    return rows


def matched(frames: Sequence[Sequence[Mark]], by_step: bool = False) -> list[Row]:
    """The marks of all positions in their order of painting, each once: by its kind, and its number among that kind;
    by_step: marks of two steps are never one."""
    order: list[tuple[object, ...]] = []
    rows: dict[tuple[object, ...], Row] = {}
    for number, marks in enumerate(frames):
        at, count = 0, Counter[tuple[object, ...]]()
        for mark in marks:
            kind = (*_kind(mark), mark.step if by_step else None)
            count[kind] += 1
            key = (*kind, count[kind])
            if key not in rows:
                rows[key] = [None] * len(frames)
                order.insert(at, key)
            elif at >= len(order) or order[at] != key:  # else it is there
                at = max(at, order.index(key))
            at += 1
            rows[key][number] = mark
    return [rows[key] for key in order]


def as_before(mark: Stroke, before: Stroke) -> Stroke:
    """A stroke with its corners counted from where they were before."""
    if mark.places == before.places:
        return mark
    starts = range(len(mark.places) if mark.closed else 1)
    turned = [(*mark.places[start:], *mark.places[:start]) for start in starts]
    turned += [places[::-1] for places in turned]
    off = [sum(abs(a - b) for a, b in zip(places, before.places, strict=True)) for places in turned]
    return replace(mark, places=turned[off.index(min(off))])


def _kind(mark: Mark) -> tuple[object, ...]:
    """All that stays the same of it while it moves."""
    match mark:
        case Stroke():
            return "stroke", mark.pen, mark.fill, mark.closed, mark.shows, len(mark.places), mark.accent
        case Disc():
            return "disc", mark.pen, mark.fill, mark.shows, mark.accent
        case ArcMark():
            return "arc", mark.pen, abs(mark.sweep) > 3.14, mark.sweep > 0, mark.accent
        case Text():
            return "text", mark.label, mark.size, mark.accent, mark.turn
        case VectorMark():
            return "vector", mark.plane, mark.name, mark.tail, mark.head
        case PointMark():
            return "point", mark.plane, mark.name, mark.fill
        case _:
            assert_never(mark)


def _element(pen: SvgPen, layer: Layer, row: Row, seconds: float) -> ET.Element:
    """A mark as it is first, with all that changes of it but the size of a vector in words; hidden where it is not."""
    elements: list[ET.Element] = []
    last = shown = next(mark for mark in row if mark is not None)
    for mark in row:
        last = mark or last
        if elements and last is shown:
            elements.append(elements[-1])
            continue
        elements.append(pen.element(last, layer))
        for title in elements[-1].findall("title"):
            elements[-1].remove(title)
        shown = last
    _change(elements[0], elements, seconds)
    if None in row:
        states = ["hidden" if mark is None else "visible" for mark in row]
        elements[0].set("visibility", states[0])
        elements[0].insert(0, _steps("visibility", states, seconds))
    return elements[0]


def _change(into: ET.Element, elements: Sequence[ET.Element], seconds: float) -> None:
    """Everything in which the elements differ, as values in turn; and so of their parts."""
    for part, parts in zip(list(into), zip(*map(list, elements), strict=True), strict=True):
        _change(part, parts, seconds)
    names = dict.fromkeys(name for element in elements for name in element.attrib)
    for place, name in enumerate(name for name in names if name not in _STILL):
        values = [element.get(name, "inherit") for element in elements]
        if len(set(values)) == 1:
            continue
        if len({_NUMBER.sub("", value) for value in values}) == 1 and not name.startswith("marker"):
            rounded = [_NUMBER.sub(lambda number: short(float(number[0])), value) for value in values]
            if len(set(rounded)) > 1:  # from value to value, and to the first again
                into.insert(place, _animate(name, [*rounded, rounded[0]], seconds))
        else:
            into.insert(place, _steps(name, values, seconds))


def _steps(name: str, values: Sequence[str], seconds: float) -> ET.Element:
    """One value after the other, each from half a position before its own to half a position after it."""
    count, around = len(values), [*values, values[0]]
    changes = [k for k in range(1, count + 1) if around[k] != around[k - 1]]
    times = ";".join(short(max(0.0, k - 0.5) / count, 4) for k in [0, *changes])
    return _animate(name, [around[k] for k in [0, *changes]], seconds, keyTimes=times, calcMode="discrete")


def _animate(name: str, values: Sequence[str], seconds: float, **more: str) -> ET.Element:
    turn = {"dur": f"{seconds:g}s", "repeatCount": "indefinite"}
    return ET.Element("animate", {"attributeName": name, "values": ";".join(values), **more, **turn})
