"""Arrows of a polygon on one line, and heads that would melt.

Arrows on one line lie on one another, as books draw them: each from its point to its point. The name of one stands
where no shorter one lies, if it has such a piece; else they lie side by side, tied to their points. Heads that meet at
one point under a small angle open outwards only; what would still become one to the eye stands back from its point,
the longer arrow's.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count, pairwise

import numpy as np

from graphkin.base.geometry import Array
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.marks import Half, Mark, PointMark, Stroke, VectorMark
from graphkin.sheet.window import Figure

TIP = 2.8  # length of an arrow head; on arrows too short for it, half of that [mm]
_ON, _ALONG = 0.3, 1.0
"""Nearer than this to a line, over more than this of it, an arrow lies on it [mm]."""
_NAMED = 3.0  # a piece of its own that is shorter bears no arrow's name [mm]
_LANE = 1.2  # from arrow to arrow, where they would hide one another [mm]
_SHORT = 0.9  # the heads of shorter arrows stay as they are [mm]
_SAME = 0.2  # heads nearer than this are at one place [mm]
_ONE, _MELT = math.radians(2), math.radians(22)
"""Under the first angle two arrows come from one side; under the second their heads become one to the eye."""
_BACK = (0.0, 2.0, 3.0, 4.0)  # so far a head may stand back [mm]
_SIDES: tuple[Half, Half] = ("left", "right")
_SHARE = 0.08  # so much of a head may lie in another
_SQUARE = np.stack(np.meshgrid(*2 * [np.linspace(0.04, 0.96, 12)])).reshape(2, -1)
_GRID = np.where(_SQUARE.sum(axis=0) > 1, 1 - _SQUARE, _SQUARE)  # places in a triangle, in parts of two of its sides
_Piece = tuple[float, float]
_Key = tuple[str, complex]
"""The name of an arrow, and where it starts: points of two links may move alike."""
Head = tuple[complex, complex, complex]
"""The corners of an arrow head, the tip first [mm]."""


def side_by_side(figure: Figure) -> Figure:
    """The figure with arrows beside those that they would hide, tied to their points; the name of each at the longest
    piece of it on which no shorter one lies, if that can bear it."""
    vectors = [mark for mark in figure.marks if isinstance(mark, VectorMark) and mark.length > _ALONG]
    vectors.sort(key=lambda vector: vector.length)
    start, end = (np.array([getattr(v, side) for v in vectors], dtype=complex) for side in ("start", "end"))
    on = [_pieces_on(vector, start, end) for vector in vectors]
    pieces = [[*_free(v, low[:k], high[:k]), (0.0, 0.0)] for k, (v, (low, high)) in enumerate(zip(vectors, on))]
    free = {(v.name, v.start): max(each, key=lambda piece: piece[1] - piece[0])
            for v, each in zip(vectors, pieces, strict=True)}  # fmt: skip
    hidden = np.array([high - low < _NAMED for low, high in (free[v.name, v.start] for v in vectors)], dtype=bool)
    lanes, moved = np.full(len(vectors), np.nan), dict[_Key, VectorMark]()
    for k, (low, high) in enumerate(on):
        taken = lanes[(high - low > _NAMED) & (hidden | hidden[k])]
        lanes[k] = next(lane for n in count() for lane in (n * _LANE, -n * _LANE) if lane not in taken)
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
    aside = float(lane) if (round(along.real, 6), along.imag) > (0, 0) else -float(lane)
    off = -1j * along * aside
    return replace(vector, start=vector.start + off, end=vector.end + off, aside=aside)


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


def _free(vector: VectorMark, low: Array, high: Array) -> Iterator[_Piece]:
    """The pieces of an arrow on which no other lies, from its tail [mm]."""
    at = 0.0
    for begin, stop in sorted(zip(low[high > low].tolist(), high[high > low].tolist(), strict=True)):
        if begin > at:
            yield at, begin
        at = max(at, stop)
    if at < vector.length:
        yield at, vector.length


def heads_apart(figure: Figure) -> Figure:
    """The figure with its arrow heads at the rims of the dots they point to, and off one another."""
    vectors = [mark for mark in figure.marks if isinstance(mark, VectorMark) and mark.length > _SHORT]
    dots = [mark for mark in figure.marks if isinstance(mark, PointMark) and mark.fill == "ink"]
    changed: dict[int, VectorMark] = {}
    heads: list[Head] = []
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
    near = [each for each in heads if abs(sum(each) - sum(corners)) < 6 * TIP]
    return max(0.0, float(_shares(corners, np.array(near).T).max()) - _SHARE) if near else 0.0


def _shares(one: Head, others: Array) -> Array:
    """The part of the smaller triangle that lies in the other, of one and each of others (3, n)."""
    alike, larger = np.array(one)[:, None] + 0 * others, abs(_across(*one)) > abs(_across(*others))
    small, large, (u, v) = np.where(larger, others, alike), np.where(larger, alike, others), _GRID[:, :, None]
    inside = small[0] + u * (small[1] - small[0]) + v * (small[2] - small[0])
    sides = np.array([_across(a, b, inside) for a, b in pairwise((*large, large[0]))])
    return np.asarray(((sides >= 0).all(axis=0) | (sides <= 0).all(axis=0)).mean(axis=0))


def _across(a: complex | Array, b: complex | Array, c: complex | Array) -> Array:
    """Twice the area of a triangle, with the sense of its turn."""
    return np.imag((b - a).conjugate() * (c - a))
