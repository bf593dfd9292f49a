"""The data of a mechanism where they lie: lengths along links, dimension lines (ISO 129), radii, angles at joints.

Each has several places; the first for which figure and letters leave room is taken. A line with its letters is tried as
a whole: `free` touches nothing, `crossing` may cross other lines but no letters. Extension lines keep off
joints where they can.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cache, cached_property
from itertools import product
from typing import NamedTuple

from graphkin.base.boxes import off_lines
from graphkin.base.lines import crossing, leaves, no_crumbs, off_stretch
from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import RollingContact
from graphkin.say.sizes import DrawnAngle, DrawnLength, Size
from graphkin.sheet.fixed_link import clearance, feet, ground_way
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, Label, box, formula, plain
from graphkin.sheet.marks import ArcMark, Mark, Place, PointMark, Stroke, Text
from graphkin.sheet.obstacles import arc_places
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import HINGE, THIN_HEAD, angle_arc, arrow_head, dimension_line
from graphkin.sheet.wheels import disc, track
from graphkin.sheet.window import Entry

_ALONG = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74)  # places of letters along a line
_GAPS = (1.1, 1.9)  # between a line and its letters [mm]
_OFFSETS = (7.5, 11.0, 16.0, 22.0)  # of a dimension line from what it measures [mm]
_RADII = (9.5, 12.5, 16.0, 20.0, 7.0)  # of the arcs of angles [mm]
_BLOCK, _GROUND = 6.2, 7.0  # from the middle of a block, from a pivot past its ground to an extension line [mm]
_BEYOND = 4.0  # an arm of an angle goes on past its arc [mm]
_SHORT, _LIKED = 8.5, 0.5
"""The arm of an angle on a shorter crank is drawn on past the arc, where on the crank that has less room [mm]."""
_CROSS = 1.5 * cmath.rect(1, math.pi / 4)  # arms of the cross where a guide begins [mm]
_MOST, _CRUMB, _LATE = 4, 6.0, 5.0
"""Ways to break extension lines at letters; their least piece, but for the last; how far off they may begin [mm]."""
_FAR = 30.0  # the dimension line of a shorter length is no farther off [mm]
_CLEAR = 2.2  # between an arc and what else there is [mm]


_Trial = tuple[Sequence[Mark], Sequence[Mark], Sequence[Mark]]
"""One way to draw a datum: what touches nothing, what may cross lines, what may touch anything."""


@frozen
class DimensionLines:
    """Draws data on a mechanism; what the file does not state in grey."""

    skeleton: Skeleton
    free: FreeRoom

    def once(self, data: Iterable[Size]) -> Iterator[Size]:
        """Data without those that would stand twice, at the same places and one way."""
        drawn = set[tuple[frozenset[str], str, str]]()
        for size in data:
            if isinstance(span := size.shape, DrawnLength):
                places = frozenset(f"{self.skeleton.window(end):.1f}" for end in (span.start, span.end))
                if (key := (places, f"{span.along**2:.3f}", size.bare.figure)) in drawn:
                    continue
                drawn.add(key)
            yield size

    def draw(self, *sizes: Size) -> list[Mark]:
        """Data where there is room for all of them, else nothing."""
        trial = replace(self, free=self.free.also(()))
        together = len(sizes) == 1 or all(map(trial._drawn, sizes))
        marks = [mark for size in sizes for mark in self._drawn(size)] if together else []
        ends = {end for size in sizes if marks and isinstance(size.shape, DrawnLength) for end in size.shape.points}
        return [*marks, *(mark for end in sorted(ends) for mark in self._beginning(end))]

    def _beginning(self, origin: str) -> Iterator[Stroke]:
        """A cross where a fixed guide or track begins that goes through no point, and the line on to what is drawn."""
        if origin in self.skeleton.points:
            return
        start = self.skeleton.at(origin)
        ends = [self.skeleton.at(slide.point) for slide in self.skeleton.guides(FRAME) if slide.line.origin == origin]
        ends += [start - complex(off_lines(start, *track(self.skeleton, roll).places))
                 for roll in self.skeleton.mechanism.of(RollingContact) if roll.line and roll.line.origin == origin]
        for end in ends:
            yield from (Stroke((start - way, start + way), "thin") for way in (_CROSS, _CROSS * 1j))
            yield from (Stroke(piece, "centre", accent="grey") for piece in self.free.pieces(start, end))

    def _drawn(self, size: Size) -> list[Mark]:
        """A datum where there is room for it, else nothing."""
        for free, over, touching in self.free.fitting(self._trials(size), lambda trial: trial[:2]):
            marks = [replace(mark, accent="grey") if size.derived and isinstance(mark, Stroke | Text) else mark
                     for mark in (*touching, *over, *free)]  # fmt: skip
            self.free.add(marks)
            return marks
        return []

    def _trials(self, size: Size) -> Iterator[_Trial]:
        owners = self.skeleton.mechanism.owners
        match size.shape:
            case DrawnLength(form="radius", points=(_,)) as span:
                yield from self._radius(span, formula(size.text))
            case DrawnLength() as span:
                start, end = self.skeleton.window(span.start), self.skeleton.window(span.end)
                step = self.skeleton.step(*span.points)
                shared = set.intersection(*(set(owners.get(point, ())) for point in span.points))
                centres = {disc(self.skeleton, link) for link in shared} - {""}
                parted = span.form == "bar" and (self._through(start, end, 0.3) or self._shared(start, end, shared)
                                                 or not (centres or self._joined(start, end)))  # fmt: skip
                label = formula(size.bare.figure)
                named = formula(size.text) if parted or span.form in ("measured", "radius") else label
                along = self.skeleton.window.turned(span.along)
                if parted:  # from end to end, past the joints and blocks between, or where no bar lies
                    yield from self._dimension(start, end, along, label, step)
                if span.form != "apart" and centres <= {*span.points}:  # else nothing is drawn between them on a wheel
                    yield from self._beside(start, end, named, step, span.form == "measured")
                if span.form in ("bar", "apart") and not parted:
                    yield from self._dimension(start, end, along, label, step)
            case DrawnAngle() | None:
                pass

    def _joined(self, start: Place, end: Place) -> bool:
        """True where a bar goes from one to the other."""
        along = (end - start) / abs(end - start) if start != end else 1
        return any(leaves(start, along, bar) and leaves(end, -along, bar) for bar in self.skeleton.drawn)

    def _shared(self, start: Place, end: Place, own: Collection[str]) -> bool:
        """True of a line that a bar of another link covers at one of its ends."""
        along = (end - start) / abs(end - start) if start != end else 1
        bars = [bar for link in self.skeleton.mechanism.moving if link not in own for bar in self.skeleton.bars(link)]
        return any(leaves(start, along, bar) or leaves(end, -along, bar) for bar in bars)

    def _through(self, start: Place, end: Place, near: float) -> bool:
        """True of a line that passes a joint between its ends, as near as that."""
        inside = (at for at in self._joints if min(abs(at - start), abs(at - end)) > HINGE)
        return any(off_stretch(at, start, end) < near for at in inside)

    def _crossed(self, start: Place, end: Place) -> int:
        """The number of bars that an extension line crosses; a point on it and the ground of a pivot count as many."""
        points = (mark.at for mark in self.free.marks if isinstance(mark, PointMark))
        passed = any(off_stretch(at, start, end) < HINGE for at in points)
        count = sum(crossing(start, end, *bar) is not None for bar in self.skeleton.drawn)
        circles = self.skeleton.circles
        count += sum(abs(start - centre) > radius > off_stretch(centre, start, end) for centre, radius in circles)
        ground = any(crossing(start, end, *foot) is not None for foot in feet(self.skeleton))
        return count + 2 * (passed or ground)

    @cached_property
    def _joints(self) -> dict[Place, tuple[bool, list[complex], set[str]]]:
        """Where hinges and blocks are: True of a block, the ways down to the ground under it, and its links."""
        skeleton, joints = self.skeleton, dict[Place, tuple[bool, list[complex], set[str]]]()
        blocks = {slide.point for slide in skeleton.blocks.values()}
        for at, links in ((at, links) for at, _, links in skeleton.joints if len(links) > 1):
            points = [point for point in skeleton.points if abs(skeleton.at(point) - at) < 0.1]
            pivots = (point for point in points if FRAME in skeleton.mechanism.owners[point])
            joints[at] = not blocks.isdisjoint(points), [ground_way(point, skeleton) for point in pivots], links
        return joints

    def _from(self, end: Place, across: complex, level: float) -> tuple[Place, float]:
        """The joint of its link, or a pivot, where the extension of an end begins, and how far off its middle [mm]."""
        way, joints = across * (level - (end / across).real), self._joints
        own = {link for at, _, links in self.skeleton.joints if abs(at - end) < 0.1 for link in links}
        level_with = [at for at in joints if abs(((at - end) / across).imag) < 0.05]
        on = [at for at in level_with if 0 < ((at - end) / way).real < 1 and (not own or own & joints[at][2])]
        if all(abs(self.skeleton.at(point) - end) > 0.1 for point in self.skeleton.points):
            on = [at for at in level_with if joints[at][1]]
        at = min(on, key=lambda at: abs(end + way - at), default=end)
        block, grounds, _ = self._joints.get(at, (False, [], set()))
        ahead = across * (level - (at / across).real)
        if any(abs(down * abs(ahead) - ahead) < 0.1 * abs(ahead) for down in grounds):
            return at, _GROUND
        return at, _BLOCK if block else 2 * HINGE

    def _text(self, label: Label, middle: Place, along: complex, off: float, step: int | None) -> Text:
        """Letters along a line, `off` mm above it as they are read, or below it where less than 0."""
        turn = cmath.phase(along)
        turn -= math.copysign(math.pi, turn) if abs(turn) > math.pi / 2 + 1e-6 else 0.0
        turn = -math.pi / 2 if turn > math.pi / 2 - 1e-6 else turn
        (wide, up, down), on = box(label, LABEL), cmath.rect(1, turn)
        base = -1j * on * (off + down) if off > 0 else 1j * on * (up - off)
        turn = 0.0 if abs(turn) < 1e-6 else turn
        return Text(label, middle + base - on * wide / 2, LABEL, step, turn=turn)

    def _beside(self, start: Place, end: Place, label: Label, step: int | None, measured: bool) -> Iterator[_Trial]:
        """Letters along a link, nothing more; along a dashed line between two points that no bar joins."""
        if abs(end - start) <= box(label, LABEL)[0] + (6 if measured else 4) * HINGE:
            return
        along, pieces = (end - start) / abs(end - start), list[tuple[Place, Place]]()
        if measured and not self._joined(start, end):
            pieces = self.free.pieces(start + along * 2 * HINGE, end - along * 2 * HINGE)
        lines = [Stroke(piece, "measured", step=step) for piece in pieces]
        for gap, t, side in product(_GAPS, _ALONG, (1, -1)):
            yield [self._text(label, start + (end - start) * t, along, side * gap, step)], (), lines

    def _dimension(self, start: Place, end: Place, along: complex, label: Label, step: int | None) -> Iterator[_Trial]:
        """A dimension line with two heads between extension lines, beyond what it measures or between its ends."""
        if abs(((end - start) / along).real) < 0.5:
            return
        along *= math.copysign(1, ((end - start) / along).real)
        wide, long = box(label, LABEL)[0], ((end - start) / along).real
        across = 1j * along
        low, high = sorted((place / across).real for place in (start, end))
        levels = [level for offset in _OFFSETS for level in (low - offset, high + offset)]
        levels += [low + part * (high - low) for part in _ALONG if high - low > 2 * _OFFSETS[0]]
        every = [(self.skeleton.at(point) / across).real for point in self.skeleton.points]
        beyond = [level for offset in _OFFSETS for level in (min(every) - offset, max(every) + offset)]
        levels += [level for level in beyond if max(low - level, level - high) < max(_FAR, 2 * long)]
        past = 0.0 if wide + 1 <= long else wide + 5
        orders = [(start, end, along), (end, start, -along)][: 2 if past else 1]

        @cache  # of each level and order once, if they come to it
        def lines(level: float, one: Place, other: Place) -> tuple[Stroke, list[Stroke], list[Stroke], int]:
            (one, near), (other, far) = self._from(one, across, level), self._from(other, across, level)
            line, both, heads = dimension_line((one, other), across, level, past, step, (near, far))
            return line, both, heads, sum(self._crossed(*each.places) for each in both)

        for through, touching, level, order in product((0, 1), range(_MOST + 1), levels, orders):
            line, both, heads, crossed = lines(level, *order[:2])
            if through != crossed:
                continue  # across a bar only where there is no other room, never across more
            way = order[2]
            middle = line.places[1] - way * (past - wide / 2 - 4 if past else long / 2)
            text = self._text(label, middle, along, 0.8, step)
            if touching > 1:  # extension lines, broken at letters, as seldom as there is room for
                broken = [no_crumbs(each.places[0], self.free.pieces(*each.places), _LATE, _CRUMB) for each in both]
                if all(0 < len(left) < touching for left in broken):
                    yield [line, text], heads, [Stroke(piece, "thin", step=step) for left in broken for piece in left]
            else:
                yield ([line, text], both, heads) if touching else ([line, text, *both], (), heads)

    def _radius(self, span: DrawnLength, label: Label) -> Iterator[_Trial]:
        """A line from a centre to its rim, with letters along it, inside or beyond."""
        centre, rim = self.skeleton.window(span.start), self.skeleton.window(span.end)
        step, radius, wide = self.skeleton.step(*span.points), abs(rim - centre), box(label, LABEL)[0]
        ways = [cmath.rect(1, math.radians(turn)) for turn in range(-45, 315, 15)]
        for way, side in product(ways, (1, -1)):
            tip = centre + way * radius
            inner, from_rim = centre + way * 2 * HINGE, tip - way * THIN_HEAD
            head = arrow_head(tip, way, step, THIN_HEAD)
            if radius > wide + 2 * HINGE + THIN_HEAD + 1:
                middle = (inner + from_rim) / 2
                text = self._text(label, middle, way, side * 0.8, step)
                yield [Stroke((inner, from_rim), "thin", step=step), text], (), [head]
            else:
                far = tip + way * (wide + 3)
                text = self._text(label, tip + way * (wide / 2 + 2), way, side * 0.8, step)
                line = Stroke((tip + way, far), "thin", step=step)
                yield [line, text], [Stroke((inner, tip - way), "thin", step=step)], [head]


def angles(data: Sequence[Size], skeleton: Skeleton, drawn: Sequence[Mark]) -> Iterator[Entry]:
    """Given angles as arcs between two arms with their values; arms that no link has are drawn, that along +x with its
    letter; drawn: arcs that they keep off, and thin lines that are arms, too."""
    others = [place for mark in drawn if isinstance(mark, ArcMark) for place in arc_places(mark)]
    lines = [(mark.places[0], mark.places[-1]) for mark in drawn if isinstance(mark, Stroke) and mark.pen == "thin"]
    for size in data:
        if isinstance(corner := size.shape, DrawnAngle):
            arms = [*_arms(skeleton, corner, lines)]
            radius, arc = _arc_with_room(skeleton, corner, arms, others)
            others += arc
            yield from _angle(size, corner, skeleton, arms, radius)


class _Arm(NamedTuple):
    """One side of an angle: its direction, how far a bar or a line goes on there, 0 where none does [mm]; short: it is
    the bar of a short crank."""

    way: complex
    reach: float
    short: bool

    def goes_on(self, radius: float) -> bool:
        """It is drawn past an arc of that radius."""
        return not self.reach or (self.short and self.reach < radius)

    def clear(self, radius: float) -> float:
        """Distance of an arc from the end of its bar [mm]: better on a bar, if there is room, than beyond it."""
        return min(_LIKED, radius - self.reach - HINGE) if self.goes_on(radius) else self.reach - radius - HINGE


def _arms(skeleton: Skeleton, corner: DrawnAngle, lines: Sequence[tuple[Place, Place]]) -> Iterator[_Arm]:
    """The two sides of an angle."""
    at, first = skeleton.window(corner.at), skeleton.window.turned(corner.start)
    driven = corner.points in {driver.vector for driver in skeleton.mechanism.drivers}
    for way in (first, first * cmath.rect(1, -corner.turn)):
        bars = [bar for bar in (*skeleton.segments, *lines) if leaves(at, way, bar)]
        reach = max((abs(end - at) for bar in bars for end in bar), default=0.0)
        yield _Arm(way, reach, driven and reach < _SHORT)


def _arc_with_room(
    skeleton: Skeleton, corner: DrawnAngle, arms: Sequence[_Arm], others: Sequence[Place]
) -> tuple[float, tuple[Place, ...]]:
    """The radius of the arc that lies farthest from links, other arcs and ends of arms [mm], and its places; of those
    that cross links alike, from the other arcs."""
    at, start = skeleton.window(corner.at), cmath.phase(arms[0].way)
    tried = list[tuple[tuple[float, float], float, tuple[Place, ...]]]()
    for radius in _RADII:
        off = math.copysign(min(2 / radius, abs(corner.turn) / 2), corner.turn)
        arc = arc_places(ArcMark(at, radius, start - off, 2 * off - corner.turn))
        ends = [at + arm.way * (radius + _BEYOND) for arm in arms if arm.goes_on(radius)]
        apart = min([_CLEAR, *(abs(place - other) for place in arc for other in others)])
        free = min([apart, *(arm.clear(radius) for arm in arms if arm.reach), clearance(skeleton, *arc, *ends)])
        tried.append(((round(free, 1), round(apart, 1)), radius, arc))
    return max(tried, key=lambda each: each[0])[1:]


def _angle(
    size: Size, corner: DrawnAngle, skeleton: Skeleton, arms: Sequence[_Arm], radius: float
) -> Iterator[Entry]:
    """The arc with its value, and the arms that no bar of a link has so far."""
    first, at, step = arms[0].way, skeleton.window(corner.at), skeleton.step(*corner.points)
    middle = first * cmath.rect(1, -corner.turn / 2)
    yield from angle_arc(at, radius, first, -corner.turn, step)
    yield LabelRequest(angle_label(size), at + middle * radius, gap=0.5, away=middle, step=step, spare=1, between=True)
    for arm in (arm for arm in arms if arm.goes_on(radius)):
        end, start = at + arm.way * (radius + _BEYOND), at + arm.way * (arm.reach + 2 * HINGE)
        yield Stroke((start, end), "thin", step=step)
        level = arm.way == first and not arm.reach and abs(corner.start - 1) < 1e-9
        if level and len(corner.points) > 1:  # the x axis at a driven link
            yield arrow_head(end, arm.way, step, THIN_HEAD)
            yield LabelRequest(plain("x", italic=True), end, gap=0.3, away=arm.way, step=step, spare=True)


def angle_label(size: Size) -> Label:
    """`φ1 = 60°`; of an angle between points the value alone."""
    named = plain(size.symbol, italic=True) if len(size.symbol) == 1 else formula(size.symbol)
    if size.moved:
        return named
    return formula(size.figure) if size.symbol.startswith("∠") else (*named, *plain(f" = {size.figure}"))
