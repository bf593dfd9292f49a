"""What is given of a mechanism in figures: lengths, offsets, radii, and how it is driven."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphkin.base.geometry import cross
from graphkin.construction import LayOff, Measure, Normal, Step, Tangential, Term, Turning
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Gear, RollingContact, Slide
from graphkin.say import names
from graphkin.say.given_places import driven_slides, face_offsets, fixed_points, guide_angles
from graphkin.say.given_sizes import Size, beside, circle, driven, in_a_row, millimetres, radius, sides
from graphkin.say.numbers import given, number
from graphkin.say.reading import Reading


def dimensions(reading: Reading) -> list[str]:
    """`AD = 78 mm`, `AB = 24 mm`, .. link by link; then offsets of guides, radii of wheels, driven rates."""
    found = (fixed_points, _lengths, _offsets, guide_angles, face_offsets, _radii, driven_slides, _rates)
    return [*dict.fromkeys(text for which in found for text in which(reading))]


def measured_lengths(reading: Reading) -> list[tuple[str, str]]:
    """The distances by which rotations are found or sizes made that no link gives: they are measured in the drawing."""
    method, found = reading.method, dict[tuple[str, str], None]()
    for construction in (method.velocity, method.acceleration):
        for step in construction.steps:
            ends = tuple(sorted(_lever(step)))
            if len(ends) == 2 and all(map(reading.named, ends)) and reading.distance(*ends):
                found[ends[0], ends[1]] = None
    return [ends for ends in found if not _held(reading, *ends)]


def _lever(step: Step) -> tuple[str, ...]:
    """The points whose distance a step uses."""
    match step:
        case Measure(lever=(tail, head)) if tail:
            return tail, head
        case LayOff(term=Term(size=Turning(_, tail, head) | Normal(_, tail, head) | Tangential(_, tail, head))):
            return tail, head
        case _:
            return ()


def _held(reading: Reading, one: str, other: str) -> bool:
    """Whether a link has both points."""
    owners = reading.mechanism.owners
    return bool(set(owners.get(one, ())) & set(owners.get(other, ())))


def length(reading: Reading, one: str, other: str) -> str:
    """`l_BD = 69.2 mm`, of the mechanism itself."""
    return f"l_{names.pair(one, other)} = {number(reading.distance(one, other) * 1000)} mm"


def _lengths(reading: Reading) -> Iterator[str]:
    """Each link by the distances of its points that fix it."""
    for link in reading.mechanism.moving:
        in_line = not [*beside(reading, link)]
        for side in in_a_row(reading, link) if in_line else sides(reading, link):
            yield Size(side.name, millimetres(reading, side.length), "mm").text


def _offsets(reading: Reading) -> Iterator[str]:
    """How far a guide's line passes a point of its link."""
    for slide in reading.mechanism.of(Slide):
        points = [p for p in reading.mechanism.named(slide.guide) if p in reading.plot.position]
        if points and slide.stands_for is None:
            off = abs(float(cross(reading.plot.guide_direction(slide.name), reading.plot.arm(points[0], slide.point))))
            if off > reading.noise:
                called = names.point(points[0])
                yield f"{'e' if slide.guide == FRAME else 'h'}_{called} = {given(off * 1000)} mm"


def _radii(reading: Reading) -> Iterator[str]:
    for gear in reading.mechanism.of(Gear):
        for link, _, size in gear.circles:
            yield radius(reading, link, size).text
    for roll in reading.mechanism.of(RollingContact):
        yield radius(reading, roll.wheel, roll.radius).text
    for centre, size in reading.circles:
        yield circle(reading, centre, size).text


def _rates(reading: Reading) -> Iterator[str]:
    for k, driver in enumerate(reading.mechanism.drivers):
        place, *rates = driven(reading, k, driver)
        if driver.kind == "angle" and driver.value is not None:
            yield place.text
        for size in rates:
            if size.value:
                yield replace(size, value=size.value if driver.kind == "slide" else abs(size.value)).text
