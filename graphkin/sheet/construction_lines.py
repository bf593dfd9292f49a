"""The construction of a polygon: direction lines with their marks, right angles, and the numbers of what was drawn.

It is drawn last, where labels leave room: a line is shortened before it runs into letters, and a mark for which there
is no room is left out; a number stands with its equation then. The numbers are those of the sentences that tell of the
same acts. On the mechanism the pencil's own lines and arcs are shown in the drawings of single steps.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise

from graphkin.base.geometry import place
from graphkin.base.value import frozen
from graphkin.construction import Arc, Construction, Drawn, Image, LayOff, Meet, Plane, Plot, Ray, Step, Term
from graphkin.planning.method import Act
from graphkin.planning.polygon_arrows import arrows
from graphkin.say.plane import PolygonReading
from graphkin.sheet.arrows import TIP
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import formula
from graphkin.sheet.marks import ArcMark, Mark, Place, PointMark, Stroke
from graphkin.sheet.polygons import PolygonFigure
from graphkin.sheet.symbols import right_angle
from graphkin.sheet.text_blocks import RING, ROW, ringed
from graphkin.sheet.window import Window

_BEYOND, _LIKED, _SHORT = 11.0, 7.0, 2.5
"""Lengths of a direction line past its end; for labels to keep off if they can; shorter it says nothing [mm]."""
_SQUARE = 1.9  # side of the square in a right angle [mm]
_NOTHING, _SAME, _EXACT = 0.05, 0.15, 1e-6
"""Arrows up to the first have no length; points closer than the second bear one label, than the third are one [mm]."""
Rings = Callable[[Sequence[int]], Iterator[Mark]]  # the numbers before equations, with more of them
_RIGHT = (("n", "t"), ("k", "r"), ("rn", "rt"))  # parts of one motion that stand at right angles to each other


@frozen
class _DirectionLine:
    """A direction line from its foot along to where it meets another, and the text at its end."""

    foot: Place
    meeting: Place
    along: complex
    text: str
    page: int


@frozen
class PolygonConstruction:
    """A polygon's construction as it is spoken of; acts: of its plane; rings: of its equations, with more numbers."""

    polygon: PolygonFigure
    spoken: PolygonReading
    acts: Sequence[Act]
    rings: Rings | None = None

    def lines(self) -> Iterator[Mark]:
        """The direction lines as far as they like to go on past their ends, for labels to keep off."""
        for line in self._lines():
            ends = line.foot - line.along * _LIKED, line.meeting + line.along * _LIKED
            yield Stroke(ends, "construction", step=line.page)
        yield from (Stroke((start, end), "measured", step=page) for start, end, page in self._carried())

    def __call__(self, free: FreeRoom) -> list[Mark]:
        """All of it among what stands there."""
        added = list[Mark]()
        laid = [(line, *_lay(line, free)) for line in self._lines()]
        for square in self._squares():  # where no letters stand
            first, at, last = square.places
            if all(free.reach(a, (at - a) / abs(at - a), abs(at - a)) >= abs(at - a) for a in (first, last)):
                added.append(square)
        for start, end, page in self._carried():
            added.extend(Stroke(piece, "measured", step=page) for piece in free.pieces(start, end))
        free.add([*added, *(Stroke((start, tip), "construction") for _, start, _, tip in laid)])
        letters = free.letters([LabelRequest(formula(line.text), tip, gap=-0.2, away=tip - last, step=line.page)
                                for line, _, last, tip in laid if tip != last])  # fmt: skip
        for line, start, last, tip in laid:  # it goes on only to bear its mark
            marks = next(letters) if tip != last else ()
            added += marks
            if abs((end := tip if marks else last) - start) > _NOTHING:
                added.append(Stroke((start, end), "construction", step=line.page))
        return [*added, *self._numbers(free)]

    def _lines(self) -> Iterator[_DirectionLine]:
        points = self.polygon.points
        for act in self.acts:
            step = act.done
            if not isinstance(step, Meet) or not self._shown(step):
                continue
            for ray in (step.first, step.second):
                if isinstance(ray, Ray) and ray.through in points:
                    along = self.polygon.window.turned(complex(self.polygon.plot.direction(ray.direction)))
                    closed = (each for each in self.polygon.construction.equations if step in each.steps)
                    terms = next((equation.left + equation.right for equation in closed), ())
                    text = self.spoken.line_direction(ray.direction, terms)
                    if not cmath.isnan(along):
                        foot, meeting = points[ray.through], points[step.point]
                        ahead = (along.conjugate() * (meeting - foot)).real > -_NOTHING
                        yield _DirectionLine(foot, meeting, along if ahead else -along, text, act.page)

    def _shown(self, meet: Meet) -> bool:
        """There is something to see: not where both lines meet in the point from which they start."""
        points, at = self.polygon.points, self.polygon.points.get(meet.point)
        feet = [points.get(line.through) for line in (meet.first, meet.second) if isinstance(line, Ray)]
        apart = (at is not None and (foot is None or abs(foot - at) > _NOTHING) for foot in feet)
        return at is not None and (len(feet) < 2 or any(apart))

    def _carried(self) -> Iterator[tuple[Place, Place, int]]:
        """The ends of arrows that were found elsewhere and are laid off once more, and the act in which they are."""
        points = self.polygon.points
        drawn = {frozenset((a.tail, a.head)) for a in arrows(self.polygon.mechanism, self.polygon.construction, points)}
        for act in self.acts:
            match act.done:
                case LayOff(term=Term(size=Drawn()), start=start, tip=tip) if {start, tip} <= points.keys():
                    if frozenset((start, tip)) not in drawn and abs(points[tip] - points[start]) > _NOTHING:
                        yield points[start], points[tip], act.page

    def _squares(self) -> Iterator[Stroke]:
        """Right angles between a normal and a tangential part, or of what slides and its Coriolis acceleration."""
        points = self.polygon.points
        for equation in self.polygon.construction.equations:
            for side in (equation.left, equation.right):
                for one, other in pairwise(side):
                    parts = {one.part, other.part}
                    if (one.of, one.seen_from) == (other.of, other.seen_from) and parts in map(set, _RIGHT):
                        match [points[name] for name in (one.head, one.tail, other.head) if name in points]:
                            case [at, a, b] if min(abs(a - at), abs(b - at)) >= _SQUARE + TIP:  # else a head is there
                                step = self.polygon.step(one.tail, one.head, other.head)
                                yield from right_angle(at, a - at, b - at, _SQUARE, step)

    def _numbers(self, free: FreeRoom) -> Iterator[Mark]:
        """A number in a circle at each arrow that is laid off, and at each point that is found: in the detail where
        that bears its letters. Those at one place stand side by side and rise as one reads; one that has no room there
        stands at an arrow that comes with it, else with the equations."""
        acts = [act for act in self.acts if isinstance(act.done, LayOff | Meet | Image)]
        arrows, nodes = ({act: [*sites(act, free)] for act in acts} for sites in (self._at_arrows, self._at_nodes))
        laid = {act: arrows[act] for act in acts if isinstance(act.done, LayOff)}  # where that has a length
        placed, drawn = dict[LabelRequest, list[tuple[Act, Place]]](), set[Act]()
        for sites, alone in ((laid, False), (nodes, False), (arrows, True), (nodes, True)):
            groups = dict[tuple[LabelRequest, Act | None], list[Act]]()
            for act in (act for act in sites if act not in drawn):
                for site in dict.fromkeys(sites[act]):
                    groups.setdefault((site, act if alone else None), []).append(act)
            halves = [complex(ROW * (len(group) - 1) / 2 + RING, RING) for group in groups.values()]
            middles = free.places([site for site, _ in groups], halves, wide=alone)
            for ((site, _), group), half, middle in zip(groups.items(), halves, middles, strict=True):
                named = free.beside(site, half) if site.of or middle is None else None  # an arrow's is best at its name
                if (at := named or middle) is not None and not drawn & {*group}:
                    row = [(act, at + ROW * (k - (len(group) - 1) / 2)) for k, act in enumerate(group)]
                    placed.setdefault(site, []).extend(row)
                    drawn |= {*group}
                    free.add([mark for act, at in row for mark in ringed([act.number], at, act.page)])
        for each in placed.values():
            order = sorted((act for act, _ in each), key=lambda act: act.number)
            places = sorted((at for _, at in each), key=lambda at: (round(at.imag / RING), at.real))  # as one reads
            for act, at in zip(order, places, strict=True):
                yield from ringed([act.number], at, act.page)
        if self.rings is not None:
            yield from self.rings([act.number for act in self.acts if act not in drawn])

    def _at_arrows(self, act: Act, free: FreeRoom) -> Iterator[LabelRequest]:
        """The arrow that it lays off, or those that come with it, where their names stand; none without a length."""
        plane, done = self.polygon.construction.plane, act.done
        for vector in self.polygon.vectors():
            laid = isinstance(done, LayOff) and done.term.name(plane) in (vector.name, *vector.also)
            if laid or (vector.step == act.page and not isinstance(done, LayOff)):
                wanted = [want for want in free.wanted if want.of == vector.name]
                for want in wanted or [LabelRequest((), vector.start, vector.end, of=vector.name)]:
                    if want.end is not None and abs(want.end - want.start) > _NOTHING:
                        yield LabelRequest((), want.start, want.end, gap=0.6, away=want.away, of=want.of)

    def _at_nodes(self, act: Act, free: FreeRoom) -> Iterator[LabelRequest]:
        """The point that it finds: in the detail that bears its letters, but for the pole, whose stand outside."""
        match act.done:
            case LayOff(tip=name) | Meet(point=name) | Image(point=name) if name in self.polygon.points:
                at = self.polygon.points[name]
                if abs(at - self.polygon.points[self.polygon.construction.pole]) > _EXACT:
                    seen = (mark for mark in free.marks if isinstance(mark, PointMark) and mark.name == name)
                    at = [at, *(mark.at for mark in seen)][-1]
                near = (want.start for want in free.wanted if not want.of and abs(want.start - at) < _SAME)
                yield LabelRequest((), next(near, at), gap=0.8)


def _lay(line: _DirectionLine, free: FreeRoom) -> tuple[Place, Place, Place]:
    """A line from one end to past the other, where it bears its mark and lies on no other line: start, end and tip."""
    ends = [(line.meeting, line.along), (line.foot, -line.along)]
    bare = [(end, on) for end, on in ends if not free.on_line(end, end + _SHORT * on)] or ends[:1]
    every = [(free.reach(end, on, _BEYOND), end, on) for end, on in bare]
    reach, end, on = next((each for each in every if each[0] >= _LIKED), max(every, key=lambda each: each[0]))
    back = max(0.0, free.reach(end, -on, abs(line.meeting - line.foot)))
    return end - on * back, end, end + on * reach if reach >= _SHORT else end


Pages = Mapping[tuple[Plane, Step], int]
_RAY_BEYOND = 9.0  # the length of a direction line past its points [mm]
_SWING, _STROKE = math.radians(22), 12.0  # half of an arc: this angle, or this length [mm] if that is less


def pencil_lines(construction: Construction, plot: Plot, window: Window, pages: Pages) -> Iterator[Mark]:
    """Each ray and arc from where it starts past where it meets another, with the number of its act."""
    ends: dict[Ray | Arc, list[str]] = {}
    for meet in (step for step in construction.steps if isinstance(step, Meet)):
        for line in (meet.first, meet.second):
            ends.setdefault(line, []).append(meet.point)
    points = plot.points(construction.plane)
    for step in construction.steps:
        number = pages.get((construction.plane, step))
        if isinstance(step, Ray | Arc):
            foot = window(place(points[step.through if isinstance(step, Ray) else step.about]))
            tips = [window(place(points[name])) for name in ends.get(step, ()) if name in points]
            if isinstance(step, Arc):  # short, around each place where the circle is crossed
                for tip in tips:
                    half, start = min(_SWING, _STROKE / max(abs(tip - foot), 1e-9)), cmath.phase(tip - foot)
                    yield ArcMark(foot, abs(tip - foot), start - half, 2 * half, "construction", step=number)
            elif not cmath.isnan(along := window.turned(complex(plot.direction(step.direction)))):
                stops = [(along.conjugate() * (tip - foot)).real for tip in tips] or [0.0]
                low, high = min(0.0, *stops) - _RAY_BEYOND, max(0.0, *stops) + _RAY_BEYOND
                yield Stroke((foot + along * low, foot + along * high), "construction", step=number)
