"""The construction of a polygon: direction lines with their marks, right angles, and the numbers of what was drawn.

It is drawn last, where labels leave room: a line is shortened before it runs into letters, and a mark or a number for
which there is no room is left out. The numbers are those of the sentences that tell of the same acts. On the mechanism
the pencil's own lines and arcs are shown in the drawings of single steps.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise

from graphkin.base.geometry import place
from graphkin.base.value import frozen
from graphkin.construction import Arc, Construction, Drawn, Image, LayOff, Meet, Plane, Plot, Ray, Step, Term
from graphkin.planning.method import Act
from graphkin.say.plane import PolygonReading
from graphkin.sheet.arrows import TIP
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LEAST, formula, plain
from graphkin.sheet.marks import ArcMark, Mark, Place, Stroke, VectorMark
from graphkin.sheet.polygons import PolygonFigure, arrows
from graphkin.sheet.symbols import right_angle
from graphkin.sheet.text_blocks import RING, ringed
from graphkin.sheet.window import Window

_BEYOND, _LIKED, _SHORT = 11.0, 7.0, 2.5
"""Lengths of a direction line past its end; for labels to keep off if they can; shorter it says nothing [mm]."""
_SQUARE = 1.9  # side of the square in a right angle [mm]
_NOTHING = 0.05  # arrows up to this have no length [mm]
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

    def lines(self) -> list[Mark]:
        """The direction lines as far as they like to go on past their ends, for labels to keep off."""
        lines = [Stroke((each.foot - each.along * _LIKED, each.meeting + each.along * _LIKED), "construction",
                        step=each.page) for each in self._lines()]  # fmt: skip
        return [*lines, *(Stroke((start, end), "measured", step=page) for start, end, page in self._carried())]

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
        added.extend(self._numbers(free))
        letters = free.letters([LabelRequest(formula(line.text), tip, gap=-0.2, away=tip - last, step=line.page)
                                for line, _, last, tip in laid if tip != last])  # fmt: skip
        for line, start, last, tip in laid:  # it goes on only to bear its mark
            marks = next(letters) if tip != last else ()
            added += marks
            if abs((end := tip if marks else last) - start) > _NOTHING:
                added.append(Stroke((start, end), "construction", step=line.page))
        return added

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
        """A number in a circle beside each thing drawn, at the next or a name, or with the equations, else beside the
        number before it; images first."""
        drawn, circle = dict[int, Sequence[Mark]](), complex(RING, RING)
        images = [act for act in self.acts if isinstance(act.done, Image)]
        for acts in (images, [act for act in self.acts if act not in images]):
            waiting = [(act, requests) for act in acts if (requests := [*self._beside(act)])]
            while waiting:
                middles = free.places([first for _, (first, *_) in waiting], [circle] * len(waiting))
                tried, waiting = waiting, []
                for (act, (first, *others)), middle in zip(tried, middles, strict=True):
                    at = free.beside(act.page, circle, first.of) if first.of else None  # an arrow's is best at its name
                    if not (at or middle) and others:
                        waiting.append((act, others))
                    elif at := at or middle or free.beside(act.page, circle):
                        drawn[act.number] = marks = [*ringed([act.number], at, act.page)]
                        free.add(marks)
                        yield from marks
        lost = [act for act in self.acts if act.number not in drawn]
        if self.rings is not None:
            yield from self.rings([act.number for act in lost])
        for act in lost if self.rings is None else ():
            near = drawn.get(act.number - 1, drawn.get(act.number + 1))
            if near and (middle := free.next_to(near, circle)) is not None:
                drawn[act.number] = marks = [*ringed([act.number], middle, act.page)]
                free.add(marks)
                yield from marks

    def _beside(self, act: Act) -> Iterator[LabelRequest]:
        """Requests for its number: at what it finds, then at each arrow that comes with it; none without a length."""
        points, label = self.polygon.points, plain(str(act.number))
        match act.done:
            case LayOff(term, _, tip) if tip in (term.head, term.tail) and {term.tail, term.head} <= points.keys():
                start, end = points[term.tail], points[term.head]
                if abs(end - start) > _NOTHING:
                    name = term.name(self.polygon.construction.plane)
                    yield LabelRequest(label, start, end, gap=0.6, size=LEAST, step=act.page, of=name)
                    yield LabelRequest(label, end, gap=0.8, size=LEAST, step=act.page)
            case Meet() as meet if not self._shown(meet):
                return
            case Meet(point=point) | Image(point=point) if point in points:
                yield LabelRequest(label, points[point], gap=0.8, size=LEAST, step=act.page)
                for vector in self._arrows.get(act.page, ()):
                    yield LabelRequest(label, vector.start, vector.end, gap=0.6, size=LEAST, step=act.page,
                                       of=vector.name)  # fmt: skip

    @cached_property
    def _arrows(self) -> dict[int | None, list[VectorMark]]:
        """The arrows that come with each act."""
        arrows = dict[int | None, list[VectorMark]]()
        for vector in self.polygon.vectors():
            arrows.setdefault(vector.step, []).extend([vector] * (vector.length > _NOTHING))
        return arrows


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


def pencil_lines(construction: Construction, plot: Plot, window: Window, pages: Pages) -> list[Mark]:
    """Each ray and arc from where it starts past where it meets another, with the number of its act."""
    ends: dict[Ray | Arc, list[str]] = {}
    for meet in (step for step in construction.steps if isinstance(step, Meet)):
        for line in (meet.first, meet.second):
            ends.setdefault(line, []).append(meet.point)
    points = plot.points(construction.plane)
    marks: list[Mark] = []
    for step in construction.steps:
        number = pages.get((construction.plane, step))
        if isinstance(step, Ray | Arc):
            foot = window(place(points[step.through if isinstance(step, Ray) else step.about]))
            tips = [window(place(points[name])) for name in ends.get(step, ()) if name in points]
            if isinstance(step, Arc):  # short, around each place where the circle is crossed
                for tip in tips:
                    half, start = min(_SWING, _STROKE / max(abs(tip - foot), 1e-9)), cmath.phase(tip - foot)
                    marks.append(ArcMark(foot, abs(tip - foot), start - half, 2 * half, "construction", step=number))
            elif not cmath.isnan(along := window.turned(complex(plot.direction(step.direction)))):
                stops = [(along.conjugate() * (tip - foot)).real for tip in tips] or [0.0]
                low, high = min(0.0, *stops) - _RAY_BEYOND, max(0.0, *stops) + _RAY_BEYOND
                marks.append(Stroke((foot + along * low, foot + along * high), "construction", step=number))
    return marks
