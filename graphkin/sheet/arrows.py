"""Arrows of a polygon on one line, heads that would melt, and an arrow that is far longer than all others.

Arrows on one line lie on one another, as books draw them: each from its point to its point. The name of one stands
where no shorter one lies, if it has such a piece; else they lie side by side, tied to their points, as does one to
whose tail a shorter one comes back: it would seem to start where that does. Heads that meet at one point under a small
angle open outwards only; what would still become one to the eye stands back from its point, the longer arrow's.

An arrow over five times as long as most is drawn broken where nothing hangs on where its head is. It has its direction,
a gap between two strokes in its middle, and its size at its name; the scale is chosen by the others.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import count

import numpy as np

from graphkin.base.geometry import Array, place
from graphkin.base.lines import free_pieces
from graphkin.base.rooms import corners
from graphkin.base.triangles import shares_of
from graphkin.construction import Construction, Plot
from graphkin.planning import Method
from graphkin.planning.needed import PartsReader
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.marks import BREAK, Half, Mark, PointMark, Stroke, VectorMark
from graphkin.sheet.polygons import GearImage, PolygonFigure
from graphkin.sheet.window import Figure, trial_window

TIP = 2.8  # length of an arrow head; on arrows too short for it, half of that [mm]
_ON, _ALONG = 0.3, 1.0  # nearer than this to a line, over more than this of it, an arrow lies on it [mm]
_NAMED = 3.0  # a piece of its own that is shorter bears no arrow's name [mm]
_LANE = 1.2  # from arrow to arrow, where they would hide one another [mm]
_SHORT = 0.9  # the heads of shorter arrows stay as they are [mm]
_SAME = 0.2  # heads nearer than this are at one place [mm]
_ONE, _MELT = math.radians(2), math.radians(22)
"""Under the first angle two arrows come from one side; under the second their heads become one to the eye."""
_BACK = (0.0, 2.0, 3.0, 4.0)  # so far a head may stand back [mm]
_SIDES: tuple[Half, Half] = ("left", "right")
_SHARE = 0.08  # so much of a head may lie in another
_Piece = tuple[float, float]
_Key = tuple[str, complex]  # the name of an arrow, and where it starts: points of two links may move alike
Head = tuple[complex, complex, complex]
"""The corners of an arrow head, the tip first [mm]."""


def side_by_side(figure: Figure) -> Figure:
    """The figure with arrows beside those that they would hide, tied to their points; the name of each at the longest
    piece of it on which no shorter one lies, if that can bear it."""
    vectors = [mark for mark in figure.marks if isinstance(mark, VectorMark) and mark.length > _ALONG]
    vectors.sort(key=lambda vector: vector.length)
    start, end = (np.array([getattr(v, side) for v in vectors], dtype=complex) for side in ("start", "end"))
    on = [_pieces_on(vector, start, end) for vector in vectors]
    pieces = [[*free_pieces(v.length, zip(low[:k].tolist(), high[:k].tolist(), strict=True)), (0.0, 0.0)]
              for k, (v, (low, high)) in enumerate(zip(vectors, on, strict=True))]  # fmt: skip
    free = {(v.name, v.start): max(each, key=lambda piece: piece[1] - piece[0])
            for v, each in zip(vectors, pieces, strict=True)}  # fmt: skip
    hidden = np.array([high - low < _NAMED for low, high in (free[v.name, v.start] for v in vectors)], dtype=bool)
    for k, (vector, (low, high)) in enumerate(zip(vectors, on, strict=True)):
        back = ((end - start)[:k] * (vector.end - vector.start).conjugate()).real < 0
        hidden[k] |= (back & (low[:k] < _SAME) & (high[:k] - low[:k] > _NAMED)).any()
    lanes, moved = np.full(len(vectors), np.nan), dict[_Key, VectorMark]()
    for k, (low, high) in enumerate(on):
        beside = (high - low > _NAMED) & (hidden | hidden[k])
        taken, side = lanes[beside], _side(vectors[k], *(ends[beside] for ends in (start, end)))
        lanes[k] = next(lane for n in count() for lane in (n * side, -n * side) if lane not in taken)
        if lanes[k]:
            moved[vectors[k].name, vectors[k].start] = _beside(vectors[k], lanes[k])
    marks = list[Mark]()
    for mark in figure.marks:
        if isinstance(mark, VectorMark) and (new := moved.get((mark.name, mark.start))) is not None:
            ends = (mark.start, new.start), (mark.end, new.end)
            marks += [*(Stroke(tie, new.pen, step=mark.step) for tie in ends), new]
        else:
            marks.append(mark)
    return Figure(marks, [_named(want, moved, free) for want in figure.wanted])


def _beside(vector: VectorMark, lane: float) -> VectorMark:
    """The arrow so far aside, to the same side as others of its line that have as much [mm]."""
    along = (vector.end - vector.start) / vector.length
    aside = float(lane) * _way(along)
    off = -1j * along * aside
    return replace(vector, start=vector.start + off, end=vector.end + off, aside=aside)


def _way(along: complex) -> int:
    """1 of an arrow to the right, or upwards, -1 of others: one side of a line is the same for all."""
    return 1 if (round(along.real, 6), along.imag) > (0, 0) else -1


def _side(vector: VectorMark, starts: Array, ends: Array) -> float:
    """The first lane beside others, on the side on which the arrow lies, if only by a little [mm]."""
    along = (vector.end - vector.start) / vector.length
    off = sum(((vector.start + vector.end - starts - ends) / along).imag) * -_way(along)
    return _LANE if round(off, 3) >= 0 else -_LANE


def _named(want: LabelRequest, moved: Mapping[_Key, VectorMark], free: Mapping[_Key, _Piece]) -> LabelRequest:
    """The label of an arrow where that is drawn now."""
    if (vector := moved.get((want.of, want.start))) is not None:
        off = vector.start - want.start
        return replace(want, start=vector.start, end=vector.end, away=off)
    low, high = free.get((want.of, want.start), (0.0, 0.0))
    if want.end is None or high - low < _NAMED:
        return want
    along = (want.end - want.start) / abs(want.end - want.start)
    return replace(want, start=want.start + low * along, end=want.start + high * along)


def _pieces_on(vector: VectorMark, starts: Array, ends: Array) -> tuple[Array, Array]:
    """From where to where others lie on an arrow, from its tail; nothing of those that do not [mm]."""
    along = ((vector.end - vector.start) / vector.length).conjugate()
    one, other = (starts - vector.start) * along, (ends - vector.start) * along
    low, high = np.sort([one.real, other.real], axis=0).clip(0, vector.length)
    near = (np.maximum(np.abs(one.imag), np.abs(other.imag)) < _ON) & (high - low > _ALONG)
    near &= (abs(starts - vector.start) > _SAME) | (abs(ends - vector.end) > _SAME)  # not the arrow itself
    return low * near, high * near


def heads_apart(figure: Figure) -> Figure:
    """The figure with its arrow heads at the rims of the dots they point to, and off one another."""
    vectors = [mark for mark in figure.marks if isinstance(mark, VectorMark) and mark.length > _SHORT]
    dots = [mark for mark in figure.marks if isinstance(mark, PointMark) and mark.fill == "ink"]
    changed, heads = dict[int, VectorMark](), list[Head]()
    for vector in sorted(vectors, key=lambda vector: vector.length):  # a long one has room to stand back
        near = [other for other in vectors if abs(other.end - vector.end) < _SAME]
        rim = max((dot.radius for dot in dots if abs(dot.at - vector.end) < _SAME), default=0.0)
        half, tries = _half(vector, near), list[tuple[float, VectorMark]]()
        ways = [(half, rim + back) for back in _BACK if back < 0.4 * vector.length]
        for side, back in (*ways, *((side, rim) for side in _SIDES)):
            each = replace(vector, half=side, back=back)
            tries.append((_melting(outline(each), heads), each))
            if not tries[-1][0]:
                break
        _, best = min(tries, key=lambda pair: pair[0])
        changed[id(vector)] = best
        heads.append(outline(best))
    return Figure([changed.get(id(mark), mark) for mark in figure.marks], figure.wanted)


def _half(vector: VectorMark, near: Sequence[VectorMark]) -> Half:
    """The side to which alone its head opens, where others come in under a small angle on the other one."""
    turns = [-cmath.phase((v.start - v.end) / (vector.start - vector.end)) for v in near if v is not vector]
    left = any(-_MELT < turn < -_ONE for turn in turns)  # those that come from the left of it, looking along it
    right = any(_ONE < turn < _MELT for turn in turns)
    return "" if left == right else "right" if left else "left"


def outline(vector: VectorMark) -> Head:
    """The corners of its head, the tip first [mm]; small on a short arrow."""
    along = (vector.end - vector.start) / vector.length
    part, back = head_size(vector)
    left, right = {"": (0.5, 0.5), "left": (0.7, 0.0), "right": (0.0, 0.7)}[vector.half]
    tip, foot = vector.end - along * back, -TIP * part
    return tip, tip + along * (foot - 1j * left * part), tip + along * (foot + 1j * right * part)


def head_size(vector: VectorMark) -> tuple[float, float]:
    """The size of its head as a part of a large one, and how far the tip stands off the end [mm]."""
    return 1.0 if vector.length > 1.6 * TIP + vector.back else 0.5, min(vector.back, 0.4 * vector.length)


def _melting(corners: Head, heads: Sequence[Head]) -> float:
    """The part of a head, or of a smaller one, that lies in another, so far as it is more than a little."""
    others = np.array([each for each in heads if abs(sum(each) - sum(corners)) < 6 * TIP]).T
    if not others.size:
        return 0.0
    return max(0.0, float(shares_of(corners, others).max()) - _SHARE)


# --- an arrow that is drawn broken ----------------------------------------------------------------------------------


_LONG, _WORTH, _DRAWN = 5.0, 1.5, 1.2
"""An arrow is drawn broken that is so many times as long as the median of all, where the polygon becomes so many times
smaller; it is drawn so many times as long as the longest other one."""
_POINT = 0.1  # shorter arrows and distances are none, where the polygon is as large as a trial [mm]
_SIGN = cmath.rect(1.6, cmath.pi / 3)  # half of a stroke of the break sign, on an arrow to the right [mm]


def left_out(method: Method, construction: Construction, plot: Plot, gears: Sequence[GearImage]) -> dict[str, complex]:
    """The head of the arrow that is drawn broken, and the piece of the arrow that is not drawn [SI]; or nothing."""
    points = plot.points(construction.plane)
    places = {name: place(points[name]) for name in (construction.pole, *construction.nodes) if name in points}
    polygon = PolygonFigure(method.mechanism, construction, plot, trial_window([*places.values()]), {})
    vectors = [vector for vector in polygon.vectors() if vector.length > _POINT]
    long = max(vectors, key=lambda vector: vector.length, default=None)
    lengths = sorted(vector.length for vector in vectors)
    if long is None or long.length <= _LONG * (lengths[(len(lengths) - 1) // 2] + lengths[len(lengths) // 2]) / 2:
        return {}
    drawn = _DRAWN * max(vector.length for vector in vectors if vector is not long) / long.length
    piece = (places[long.head] - places[long.tail]) * (1 - drawn)
    circles = [corner for image in gears for corner in image.corners]
    shorter = _span([*{**places, long.head: places[long.head] - piece}.values(), *circles])
    if _WORTH * shorter > _span([*places.values(), *circles]) or _bears(method, polygon, gears, long):
        return {}
    return {long.head: piece}


def _span(places: Iterable[complex]) -> float:
    """From corner to corner of what holds them."""
    low, high = corners([*places])
    return abs(high - low)


def _bears(method: Method, polygon: PolygonFigure, gears: Sequence[GearImage], arrow: VectorMark) -> bool:
    """True if something else is drawn or measured from the head of an arrow: it must be where it belongs."""
    ends = [name for vector in polygon.vectors() for name in (vector.tail, vector.head)]
    ends += [name for _, names in polygon.images() for name in names] + [image.centre for image in gears]
    ends += [arrow.head for name, at in polygon.points.items() if abs(at - arrow.end) < _POINT and name != arrow.head]
    readers = [PartsReader(method, each) for each in method.constructions]
    needs = (fact for reader, each in zip(readers, method.constructions, strict=True) for step in each.steps
             for fact in reader.needs(step))  # fmt: skip
    return ends.count(arrow.head) > 1 or (arrow.plane, arrow.head) in needs


def with_break_signs(figure: Figure) -> Figure:
    """The figure with two strokes across each arrow that is drawn broken, one on each side of its gap."""
    marks = [*figure.marks]
    for vector in (mark for mark in figure.marks if isinstance(mark, VectorMark) and mark.broken):
        along, middle = (vector.end - vector.start) / (vector.length or 1.0), (vector.start + vector.end) / 2
        for at in (middle - BREAK / 2 * along, middle + BREAK / 2 * along):
            marks.append(Stroke((at - along * _SIGN, at + along * _SIGN), "thin", step=vector.step))
    return Figure(marks, figure.wanted)
