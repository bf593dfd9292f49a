"""What fixes the places of a mechanism beside its lengths: fixed points, guides of the frame, faces, driven slides."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from graphkin.base.geometry import cross
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Cam
from graphkin.say import names
from graphkin.say.given_sizes import driven
from graphkin.say.numbers import given
from graphkin.say.reading import Reading


def fixed_points(reading: Reading) -> Iterator[str]:
    """`AD = 78 mm` of a point level with the first, or under it; of others how far they are along x and y.

    `x_D` where the first stands at the origin, else `x_AD`.
    """
    shape = reading.plot.facts.shapes[FRAME]
    first, *others = [p for p in reading.mechanism.named(FRAME) if p in reading.plot.position] or [""]
    for other in others:
        away = complex(shape[other] - shape[first])
        if min(abs(away.real), abs(away.imag)) <= reading.noise:
            yield f"{names.pair(first, other)} = {given(abs(away) * 1000)} mm"
        else:
            called = names.pair(first, other) if shape[first] else names.point(other)
            yield from (f"{sign}_{called} = {given(v * 1000)} mm" for sign, v in (("x", away.real), ("y", away.imag)))


def guide_angles(reading: Reading) -> Iterator[str]:
    """`β_C = 30°` of guides of the frame that are neither level nor upright, against +x."""
    for slide in reading.mechanism.slides:
        if slide.guide == FRAME and slide.stands_for is None:
            angle = round(math.degrees(cmath.phase(slide.line.direction)), 9) % 180
            if angle % 90:
                yield f"β_{names.point(slide.point)} = {given(angle)}°"


def face_offsets(reading: Reading) -> Iterator[str]:
    """How far the flat face of a cam or a follower passes the first point of its link."""
    for line in (line for cam in reading.mechanism.of(Cam) for line in cam.lines):
        points = [p for p in reading.mechanism.named(line.link) if p in reading.plot.position]
        if points and line.origin in reading.plot.position:
            along = line.direction * cmath.rect(1, float(reading.plot.theta.get(line.link, 0.0)))
            off = abs(float(cross(along, reading.plot.arm(points[0], line.origin))))
            if off > reading.noise:
                yield f"h_{names.point(points[0])} = {given(off * 1000)} mm"


def driven_slides(reading: Reading) -> Iterator[str]:
    """`s_ram = 90 mm`: where a driven slide stands."""
    for k, driver in enumerate(reading.mechanism.drivers):
        if driver.kind == "slide":
            yield driven(reading, k, driver)[0].text
