"""The signs of kinematic sketches (ISO 3952, GB/T 4460), as strokes in millimetres on paper.

Each function draws one sign at a given place and knows nothing of mechanisms. Hatching is made of lines.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import replace

from graphkin.construction import Plane
from graphkin.sheet.marks import ArcMark, Mark, Place, Shows, Stroke

SQUARE, _SQUARE_DEG = 2.3, 1e-6  # side of the square in a right angle [mm]; its cosine is no larger
HINGE = 1.3  # radius of a hinge [mm]
PIVOT_DEPTH = 4.6  # from a pivot's centre to the ground [mm]
BLOCK = complex(10.0, 5.6)  # length and height of a block [mm]
TUBE = 0.6  # length of a cylinder's tube, of its length from hinge to hinge
SWEEP = math.radians(62)  # angle of a turning arrow
SLOT = 1.75  # half of the width of a slot [mm]
_HEAD = 3.0
_PITCH, _SLANT = 1.5, 1.7
_WELD = 2.4  # side of the filled corner between lines of one piece [mm]


def pivot(at: Place, down: complex, step: int | None = None) -> list[Mark]:
    """A fixed pivot: a triangle on hatched ground; its hinge is drawn apart. `down` is a unit vector."""
    foot, side = at + PIVOT_DEPTH * down, 1j * down
    triangle = (at, foot + 2.5 * side, foot - 2.5 * side)
    return [
        Stroke(triangle, "outline", closed=True, fill="paper", step=step),
        Stroke((foot + 4.4 * side, foot - 4.4 * side), "outline", step=step),
        *hatch(foot + 4.2 * side, foot - 4.2 * side, down, step),
    ]


def hatch(start: Place, end: Place, side: complex, step: int | None = None) -> list[Stroke]:
    """Short slanting lines along start..end on the side where the ground is."""
    length = abs(end - start)
    if length < _PITCH:
        return []
    along, count = (end - start) / length, int(length / _PITCH)
    first = (length - count * _PITCH) / 2
    slant = (side - along) / abs(side - along) * _SLANT
    feet = [start + along * (first + k * _PITCH) for k in range(count + 1)]
    return [Stroke((foot, foot + slant), "hatch", step=step) for foot in feet]


def rim_hatch(at: Place, radius: float, outward: float, step: int | None = None) -> list[Stroke]:
    """A fixed circle: hatching on its outside (`outward` 1) or inside (-1), in three stretches where it is large."""
    if radius < 2 * _PITCH:
        return []
    half = min(8 / radius, math.pi / 3) if math.tau * radius >= 60 else math.pi / 3
    middles = (cmath.rect(radius, math.radians(turn)) for turn in (30, 150, 270))
    return [mark for arm in middles for mark in arc_hatch(at, arm, half, outward, step)]


def arc_hatch(at: Place, arm: complex, half: float, outward: float, step: int | None = None) -> list[Stroke]:
    """Hatching along an arc, half of it on each side of an arm."""
    radius, count = abs(arm), int(2 * half * abs(arm) / _PITCH)
    turns = [(k - (count - 1) / 2) * _PITCH / radius for k in range(count)]
    ways = [(arm / radius * cmath.rect(1, turn)) for turn in turns]
    slant = (outward - 1j) / abs(outward - 1j) * _SLANT
    return [Stroke((at + radius * out, at + (radius + slant) * out), "hatch", step=step) for out in ways]


def weld(at: Place, one: Place, other: Place, step: int | None = None) -> list[Mark]:
    """Two lines of one piece: the corner between them, filled; nothing where they are almost in line."""
    a, b = ((end - at) / abs(end - at) for end in (one, other))
    if abs((a.conjugate() * b).imag) < math.sin(math.radians(8)):
        return []
    return [Stroke((at, at + a * _WELD, at + b * _WELD), "outline", closed=True, fill="ink", step=step)]


def block_corners(at: Place, along: complex) -> tuple[Place, ...]:
    x, y = along * BLOCK.real / 2, 1j * along * BLOCK.imag / 2
    return at + x + y, at + x - y, at - x - y, at - x + y


def guide(start: Place, end: Place, side: complex, step: int | None = None, shows: Shows | None = None) -> list[Stroke]:
    """A fixed guide: a line with the ground hatched on one side."""
    return [Stroke((start, end), "outline", shows=shows, step=step), *hatch(start, end, side, step)]


def slot(along: Sequence[Place], shows: Shows, step: int | None = None) -> list[Mark]:
    """A slot with round ends along a line or an arc, cut into a link or the ground: white, over the link's bar."""
    ways = [after - before for before, after in zip((along[0], *along), (*along[1:], along[-1]), strict=False)]
    sides = [1j * SLOT * way / abs(way) for way in ways]
    far, near = ([end * cmath.rect(1, -math.pi * k / 10) for k in range(1, 10)] for end in (sides[-1], -sides[0]))
    one, other = ([place + sign * side for place, side in zip(along, sides, strict=True)] for sign in (1, -1))
    rim = (*one, *(along[-1] + off for off in far), *other[::-1], *(along[0] + off for off in near))
    return [Stroke(rim, "outline", closed=True, fill="paper", shows=shows, step=step)]


def cylinder(foot: Place, rod_end: Place, shows: tuple[Shows, Shows, Shows], step: int | None = None) -> list[Mark]:
    """A cylinder hinged at its foot, with piston and rod. `shows`: what its foot, its tube and its rod do."""
    length = abs(rod_end - foot)
    along = (rod_end - foot) / length
    side = 1j * along * 2.6
    near, far = foot + along * min(4.0, 0.15 * length), foot + along * TUBE * length
    piston = foot + along * 0.42 * length
    tube = (near + side, far + side, far - side, near - side)
    return [
        Stroke((foot, near), "visible", shows=shows[0], step=step),
        Stroke(tube, "outline", closed=True, fill="paper", shows=shows[1], step=step),
        Stroke((piston + 0.75 * side, piston - 0.75 * side), "visible", step=step),  # within the walls
        Stroke((piston, rod_end), "visible", shows=shows[2], step=step),
    ]


def spin(
    at: Place, middle: complex, sweep: float, radius: float, step: int | None = None, shows: Shows | None = None
) -> list[Mark]:
    """An arc with an arrow about a pivot, to both sides of a direction; counter-clockwise for a sweep over 0 [rad]."""
    start, turn, sense = cmath.phase(middle) + sweep / 2, -sweep, math.copysign(1, sweep)
    shaft = turn + sense * 0.8 * _HEAD / radius
    head = _arc_head(at, cmath.rect(radius, start + turn), -sense, step, _HEAD)
    return [ArcMark(at, radius, start, shaft, "vector", step=step), replace(head, shows=shows)]


def arrow(
    start: Place, tip: Place, accent: Plane | None = None, shows: Shows | None = None, step: int | None = None
) -> list[Mark]:
    """An arrow of any length, as large as others where it shows something; nothing if too short to be seen."""
    length = abs(tip - start)
    if length < 0.3:
        return []
    along, head = (tip - start) / length, min((0.7 if shows is None else 1.0) * _HEAD, 0.5 * length)
    shaft = Stroke((start, tip - 0.8 * head * along), "vector", accent=accent, step=step)
    return [shaft, replace(arrow_head(tip, along, step, head), accent=accent, shows=shows)]


def arrow_head(tip: Place, along: complex, step: int | None, length: float = _HEAD) -> Stroke:
    back = tip - length * along
    side = 0.55j * along * length / _HEAD
    return Stroke((tip, back + side, back - side), "hatch", closed=True, fill="ink", step=step)


THIN_HEAD = 2.2  # length of the heads of dimension lines [mm]


def angle_arc(at: Place, radius: float, first: complex, sweep: float, step: int | None = None) -> list[Mark]:
    """An arc from a direction on, with a head at each end [rad, clockwise on paper]; heads of a short one point inwards
    from arcs beyond it (ISO 129), where it is shorter still than one; otherwise its end alone has one."""
    if (long := abs(sweep) * radius) < 0.1:
        return []
    on = math.copysign(1, sweep)
    inside = -1 if long < 1.5 * THIN_HEAD else 1
    past = 2 * THIN_HEAD / radius * on if inside < 0 else 0.0
    arc = ArcMark(at, radius, cmath.phase(first) - past, sweep + 2 * past, "thin", step)
    ends = ((first * cmath.rect(1, sweep), on * inside), (first, -on * inside))
    count = 1 if inside > 0 and long < 3 * THIN_HEAD else 2
    return [arc, *(_arc_head(at, radius * arm, sense, step, THIN_HEAD) for arm, sense in ends[:count])]


def _arc_head(at: Place, arm: complex, sense: float, step: int | None, length: float) -> Stroke:
    """A head at the end of an arc about a place, clockwise on paper where `sense` is 1."""
    way = sense * 1j * arm / abs(arm) * cmath.rect(1, -sense * length / 2 / abs(arm))
    return arrow_head(at + arm, way, step, length)


def dimension_line(
    ends: tuple[Place, Place], across: complex, level: float, past: float = 0.0, step: int | None = None,
    clear: tuple[float, float] = (2 * HINGE, 2 * HINGE),
) -> tuple[Stroke, list[Stroke], list[Stroke]]:  # fmt: skip
    """The line, extension lines from what it measures, and heads (ISO 129); heads of a short one point inwards, and the
    line goes on `past` its second end; level: how far it lies `across`; clear: what stays free at each place [mm]."""
    ways = [level - (end / across).real for end in ends]
    one, other = (end + across * way for end, way in zip(ends, ways, strict=True))
    along = (other - one) / abs(other - one)
    inside = abs(other - one) >= 2 * THIN_HEAD + 1.5
    line = Stroke((one - along * 5 * (not inside), other + along * past), "thin", step=step)
    outs = ((end, tip, across * math.copysign(1, way), free)
            for end, tip, way, free in zip(ends, (one, other), ways, clear) if abs(way) > free)  # fmt: skip
    extensions = [Stroke((end + out * free, tip + out * 1.5), "thin", step=step) for end, tip, out, free in outs]
    out = along if inside else -along
    return line, extensions, [arrow_head(one, -out, step, THIN_HEAD), arrow_head(other, out, step, THIN_HEAD)]


def right_angle(
    at: Place, one: complex, other: complex, side: float = SQUARE, step: int | None = None
) -> list[Stroke]:
    """A square between two lines; nothing where the angle is another."""
    if abs(one.real * other.real + one.imag * other.imag) > _SQUARE_DEG * abs(one) * abs(other):
        return []
    one, other = side * one / abs(one), side * other / abs(other)
    return [Stroke((at + one, at + one + other, at + other), "construction", step=step)]
