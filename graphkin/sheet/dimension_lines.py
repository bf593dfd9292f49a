"""The data of a mechanism where they lie: lengths along links, dimension lines (ISO 129), radii, angles at joints.

Each has several places; the first for which figure and letters leave room is taken. A line with its letters is tried as
a whole: `free` touches nothing, `crossing` may cross other lines but no letters.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice, product

from graphkin.base.value import frozen
from graphkin.say.sizes import Corner, Size, Span
from graphkin.sheet.fixed_link import clearance
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, Label, box, formula, plain
from graphkin.sheet.marks import ArcMark, Mark, Place, Stroke, Text
from graphkin.sheet.obstacles import arc_places
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import HINGE, THIN_HEAD, angle_arc, arrow_head, dimension_line
from graphkin.sheet.wheels import disc
from graphkin.sheet.window import Figure

_ALONG = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74)  # places of letters along a line
_GAPS = (1.1, 1.9)  # between a line and its letters [mm]
_OFFSETS = (7.5, 11.0, 16.0, 22.0)  # of a dimension line from what it measures [mm]
_RADII = (9.5, 12.5, 16.0, 20.0, 7.0)  # of the arcs of angles [mm]
_BLOCK = 6.2  # from the middle of a block to an extension line [mm]
_AT_ONCE = 10  # ways that are tried together
_BEYOND = 4.0  # an arm of an angle goes on past its arc [mm]
_SLANT = math.sin(math.radians(1.0))  # a bar lies on an arm under less
_CLEAR = 2.2  # between an arc and what else there is [mm]


@frozen
class _Trial:
    """One way to draw a datum."""

    free: Sequence[Mark]
    crossing: Sequence[Mark] = ()
    touching: Sequence[Mark] = ()


@frozen
class DimensionLines:
    """Draws data on a mechanism; what the file does not state in grey."""

    skeleton: Skeleton
    free: FreeRoom

    def draw(self, size: Size) -> list[Mark]:
        """A datum where there is room for it, else nothing."""
        every = self._trials(size)
        while trials := list(islice(every, _AT_ONCE)):
            number = self.free.first([(trial.free, trial.crossing) for trial in trials])
            if number is not None:
                trial = trials[number]
                marks = [replace(mark, accent="grey") if size.derived and isinstance(mark, Stroke | Text) else mark
                         for mark in (*trial.touching, *trial.crossing, *trial.free)]  # fmt: skip
                self.free.add(marks)
                return marks
        return []

    def _trials(self, size: Size) -> Iterator[_Trial]:
        match size.shape:
            case Span(form="radius") as span:
                yield from self._radius(span, formula(size.text))
            case Span() as span:
                start, end = self.skeleton.window(span.start), self.skeleton.window(span.end)
                step = self.skeleton.step(*span.points)
                label = formula(size.text if span.form == "measured" else size.bare.figure)
                if span.form != "apart" and not self._across_wheel(span.points):
                    yield from self._beside(start, end, label, step, span.form == "measured")
                if span.form != "measured":
                    along = self.skeleton.window.turned(span.along)
                    yield from self._dimension(start, end, along, label, step)
            case Corner() | None:
                pass

    def _across_wheel(self, points: Sequence[str]) -> bool:
        """True of two points of one wheel, neither its centre: nothing is drawn between them."""
        owners = self.skeleton.mechanism.owners
        shared = set.intersection(*(set(owners.get(point, ())) for point in points))
        return any(centre not in points for link in shared if (centre := disc(self.skeleton, link)))

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
        bars = self.skeleton.segments() if measured else ()
        if measured and not any(_lies_on(start, along, bar) and _lies_on(end, -along, bar) for bar in bars):
            pieces = self.free.pieces(start + along * 2 * HINGE, end - along * 2 * HINGE)
        lines = [Stroke(piece, "measured", step=step) for piece in pieces]
        for gap, t, side in product(_GAPS, _ALONG, (1, -1)):
            yield _Trial([self._text(label, start + (end - start) * t, along, side * gap, step)], touching=lines)

    def _dimension(
        self, start: Place, end: Place, along: complex, label: Label, step: int | None
    ) -> Iterator[_Trial]:
        """A dimension line with two heads between extension lines, beyond what it measures or between its ends."""
        if abs(end - start) < 0.5:
            return
        along *= math.copysign(1, ((end - start) / along).real)
        wide, long = box(label, LABEL)[0], ((end - start) / along).real
        blocks = [self.skeleton.at(slide.point) for slide in self.skeleton.blocks.values()]
        first, second = (_BLOCK if min((abs(end - at) for at in blocks), default=9.0) < 0.1 else 2 * HINGE
                         for end in (start, end))  # fmt: skip
        across = 1j * along
        low, high = sorted((place / across).real for place in (start, end))
        levels = [level for offset in _OFFSETS for level in (low - offset, high + offset)]
        levels += [low + part * (high - low) for part in _ALONG if high - low > 2 * _OFFSETS[0]]
        past = 0.0 if wide + 1 <= long else wide + 5
        ends = ((start, end), (first, second), along)
        orders = [ends, (ends[0][::-1], ends[1][::-1], -along)][: 2 if past else 1]
        for crossing, level, (places, clear, way) in product((0, 1, 2), levels, orders):
            line, both, heads = dimension_line(places, across, level, past, step, clear)
            middle = line.places[1] - way * (past - wide / 2 - 4 if past else long / 2)
            text = self._text(label, middle, along, 0.8, step)
            if crossing == 2:  # extension lines, broken at letters
                pieces = [Stroke(piece, "thin", step=step) for each in both for piece in self.free.pieces(*each.places)]
                yield _Trial([line, text], heads, pieces)
            else:
                yield _Trial([line, text], both, heads) if crossing else _Trial([line, text, *both], (), heads)

    def _radius(self, span: Span, label: Label) -> Iterator[_Trial]:
        """A line from a centre to its rim, with letters along it, inside or beyond."""
        centre, rim = self.skeleton.window(span.start), self.skeleton.window(span.end)
        step, radius, wide = self.skeleton.step(*span.points), abs(rim - centre), box(label, LABEL)[0]
        ways = [(rim - centre) / radius]
        if len(span.points) == 1:
            ways = [cmath.rect(1, math.radians(turn)) for turn in range(-45, 315, 15)]
        for way, side in product(ways, (1, -1)):
            tip = centre + way * radius
            inner, from_rim = centre + way * 2 * HINGE, tip - way * THIN_HEAD
            head = arrow_head(tip, way, step, THIN_HEAD)
            if radius > wide + 2 * HINGE + THIN_HEAD + 1:
                middle = (inner + from_rim) / 2
                text = self._text(label, middle, way, side * 0.8, step)
                yield _Trial([Stroke((inner, from_rim), "thin", step=step), text], touching=[head])
                if len(span.points) > 1:  # on a line that is there
                    yield _Trial([self._text(label, middle, way, side * _GAPS[0], step)])
            else:
                far = tip + way * (wide + 3)
                text = self._text(label, tip + way * (wide / 2 + 2), way, side * 0.8, step)
                line = Stroke((tip + way, far), "thin", step=step)
                yield _Trial([line, text], [Stroke((inner, tip - way), "thin", step=step)], [head])


def angles(data: Sequence[Size], skeleton: Skeleton, drawn: Sequence[Mark]) -> Figure:
    """Given angles as arcs between two arms with their values; arms that no link has are drawn, that along +x with
    its letter.

    drawn  arcs that they keep off
    """
    figure, others = Figure(), [place for mark in drawn if isinstance(mark, ArcMark) for place in arc_places(mark)]
    for size in data:
        if isinstance(size.shape, Corner):
            at = skeleton.window(size.shape.at)
            radius, arc = max(((radius, _places(size.shape, skeleton, radius)) for radius in _RADII),
                              key=lambda way: _room(skeleton, way[1], others))  # fmt: skip
            others += arc
            figure += _angle(size, size.shape, skeleton, at, radius)
    return figure


def _places(corner: Corner, skeleton: Skeleton, radius: float) -> list[Place]:
    """Places on the arc of an angle, off its ends."""
    first, long = radius * skeleton.window.turned(corner.start), abs(corner.turn) * radius
    parts = [k / 12 for k in range(13) if 2.0 <= k / 12 * long <= long - 2.0]
    return [skeleton.window(corner.at) + first * cmath.rect(1, -corner.turn * part) for part in parts or [0.5]]


def _room(skeleton: Skeleton, arc: Sequence[Place], others: Sequence[Place]) -> float:
    """Distance of an arc from links and other arcs, as far as it matters [mm]."""
    return min([_CLEAR, *(clearance(skeleton, at) for at in arc), *(abs(at - other) for at in arc for other in others)])


def _angle(size: Size, corner: Corner, skeleton: Skeleton, at: Place, radius: float) -> Figure:
    """The arc with its value, and the arms that no bar of a link has."""
    first, step = skeleton.window.turned(corner.start), skeleton.step(*corner.points)
    middle, last = (first * cmath.rect(1, -corner.turn * part) for part in (0.5, 1.0))
    figure = Figure(angle_arc(at, radius, first, -corner.turn, step))
    figure.wanted.append(LabelRequest(angle_label(size), at + middle * radius, gap=0.5, away=middle, step=step))
    for number, arm in enumerate((first, last)):
        if not any(_lies_on(at, arm, bar) for bar in skeleton.segments()):
            end = at + arm * (radius + _BEYOND)
            figure.marks.append(Stroke((at + arm * 2 * HINGE, end), "thin", step=step))
            if number == 0 and abs(corner.start - 1) < 1e-9 and len(corner.points) > 1:  # the x axis at a driven link
                x = plain("x", italic=True)
                figure.wanted.append(LabelRequest(x, end, gap=0.3, away=arm, step=step, spare=True))
    return figure


def _lies_on(at: Place, arm: complex, bar: tuple[Place, Place]) -> bool:
    """True where a bar leaves a place in a direction."""
    offs = [(end - at) / arm for end in bar]
    level = all(abs(off.imag) < max(0.05, _SLANT * abs(off)) for off in offs)
    return level and min(off.real for off in offs) < 0.1 and max(off.real for off in offs) > 1


def angle_label(size: Size) -> Label:
    """`φ1 = 60°`; of an angle between points the value alone."""
    named = plain(size.symbol, italic=True) if len(size.symbol) == 1 else formula(size.symbol)
    return formula(size.figure) if size.symbol.startswith("∠") else (*named, *plain(f" = {size.figure}"))
