"""The construction of a polygon: direction lines with their marks, right angles, and the numbers of what was drawn.

It is drawn last, where labels leave room: a line is shortened before it runs into letters, and a mark or a number for
which there is no room is left out. The numbers are those of the sentences that tell of the same acts. On the mechanism
the pencil's own lines and arcs are shown in the drawings of single steps.
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
from graphkin.say.plane import PolygonReading
from graphkin.sheet.free_room import Annotations, FreeRoom
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LEAST, formula, plain
from graphkin.sheet.marks import ArcMark, Mark, Place, Stroke
from graphkin.sheet.polygons import PolygonFigure, arrows
from graphkin.sheet.text_blocks import RING, ringed
from graphkin.sheet.window import Window

_BEYOND, _LIKED, _SHORT = 11.0, 7.0, 2.5
"""Lengths of a direction line past where it meets the other; for labels to keep off if they can; shorter than
this it says nothing [mm]."""
_SQUARE = 1.9  # side of the square in a right angle [mm]
_NOTHING = 0.05  # arrows up to this have no length [mm]
Rings = Callable[[Sequence[int]], Iterator[Mark]]  # the numbers before equations, with more of them
_RIGHT = (("n", "t"), ("k", "r"), ("rn", "rt"))  # parts of one motion that stand at right angles to each other


@frozen
class _DirectionLine:
    """A direction line from its foot to where it meets another, and the text at its end."""

    foot: Place
    meeting: Place
    along: complex
    text: str
    page: int

    @property
    def sides(self) -> list[complex]:
        """Its direction past the meeting point; either one where the line starts there."""
        off = self.meeting - self.foot
        ahead = (self.along.conjugate() * off).real
        return [self.along * (1 if ahead > 0 else -1)] if abs(off) > _NOTHING else [self.along, -self.along]


@frozen
class PolygonConstruction:
    """A polygon's construction.

    spoken  the same polygon as it is worded; acts: those of its plane
    rings   those of its equations, with more numbers
    """

    polygon: PolygonFigure
    spoken: PolygonReading
    acts: Sequence[Act]
    rings: Rings | None = None

    def lines(self) -> list[Mark]:
        """The direction lines as far as they like to go on past where they meet, for labels to keep off."""
        sides = [(line, side) for line in self._lines() for side in line.sides]
        on = [Stroke((line.foot, line.meeting, line.meeting + side * _LIKED), "construction") for line, side in sides]
        return [*on, *(Stroke((start, end), "measured") for start, end, _ in self._carried())]

    def __call__(self, free: FreeRoom) -> Annotations:
        """All of it among what stands there."""
        added = Annotations()
        marked: list[tuple[_DirectionLine, Place]] = []
        for line in self._lines():
            if (tip := _lay(line, free, added)) is not None:
                marked.append((line, tip))
        for square in self._squares():  # where no letters stand
            first, middle, last = square.places
            sides = ((first, middle), (last, middle))
            if all(free.reach(a, (b - a) / abs(b - a), abs(b - a)) >= abs(b - a) for a, b in sides):
                added.under.append(square)
        for start, end, page in self._carried():
            added.under.extend(Stroke(piece, "measured", step=page) for piece in free.pieces(start, end))
        free.add(added.under)
        added.over.extend(self._numbers(free))
        named = [
            LabelRequest(formula(line.text), tip, gap=-0.2, away=(tip - line.meeting), step=line.page)
            for line, tip in marked
        ]
        for letters in free.letters(named):
            added.over.extend(letters)
        return added

    # --- direction lines --------------------------------------------------------------------------

    def _lines(self) -> Iterator[_DirectionLine]:
        points = self.polygon.points
        for act in self.acts:
            step = act.done
            if not isinstance(step, Meet) or step.point not in points:
                continue
            for ray in (step.first, step.second):
                if isinstance(ray, Ray) and ray.through in points:
                    along = self.polygon.window.turned(complex(self.polygon.plot.direction(ray.direction)))
                    closed = (each for each in self.polygon.construction.equations if step in each.steps)
                    terms = next((equation.left + equation.right for equation in closed), ())
                    text = self.spoken.line_direction(ray.direction, terms)
                    if not cmath.isnan(along):
                        yield _DirectionLine(points[ray.through], points[step.point], along, text, act.page)

    def _carried(self) -> Iterator[tuple[Place, Place, int]]:
        """The ends of arrows that were found elsewhere and are laid off once more, and the act in which they are."""
        points = self.polygon.points
        drawn = {frozenset((a.tail, a.head)) for a in arrows(self.polygon.mechanism, self.polygon.construction, points)}
        for act in self.acts:
            match act.done:
                case LayOff(term=Term(size=Drawn()), start=start, tip=tip) if {start, tip} <= points.keys():
                    if frozenset((start, tip)) not in drawn and abs(points[tip] - points[start]) > _NOTHING:
                        yield points[start], points[tip], act.page
                case _:
                    pass

    # --- right angles -----------------------------------------------------------------------------

    def _squares(self) -> Iterator[Stroke]:
        """Right angles between a normal and a tangential part, or of what slides and its Coriolis acceleration."""
        points = self.polygon.points
        for equation in self.polygon.construction.equations:
            for chain in (equation.left, equation.right):
                for one, other in pairwise(chain):
                    parts = {one.part, other.part}
                    if (one.of, one.seen_from) == (other.of, other.seen_from) and parts in map(set, _RIGHT):
                        corners = [points[name] for name in (one.head, one.tail, other.head) if name in points]
                        if len(corners) < 3:
                            continue
                        corner, a, b = corners[0], corners[1] - corners[0], corners[2] - corners[0]
                        if min(abs(a), abs(b)) >= _SQUARE / 2 and max(abs(a), abs(b)) >= 2 * _SQUARE:
                            a, b = a / abs(a) * _SQUARE, b / abs(b) * _SQUARE
                            step = self.polygon.step(one.tail, one.head, other.head)
                            yield Stroke((corner + a, corner + a + b, corner + b), "construction", step=step)

    # --- numbers ----------------------------------------------------------------------------------

    def _numbers(self, free: FreeRoom) -> Iterator[Mark]:
        """A number in a circle beside each thing that was drawn: what has no room at one thing has it at the next, and
        what has none at all stands with the equations. Images come first, as their numbers do not."""
        images, lost = [act for act in self.acts if isinstance(act.done, Image)], set[int]()
        for acts in (images, [act for act in self.acts if act not in images]):
            waiting = [(act.number, requests) for act in acts if (requests := [*self._beside(act)])]
            lost.update({act.number for act in acts} - dict(waiting).keys())
            while waiting:
                spots = free.spots([first for _, (first, *_) in waiting], [complex(RING, RING)] * len(waiting))
                tried, waiting = waiting, []
                for (number, requests), free_ones in zip(tried, spots, strict=True):
                    if (middle := free.place(free_ones)) is not None:
                        marks = [*ringed([number], middle, requests[0].step)]
                        free.add(marks)
                        yield from marks
                    elif requests[1:]:
                        waiting.append((number, requests[1:]))
                    else:
                        lost.add(number)
        if self.rings is not None:
            yield from self.rings(sorted(lost))

    def _beside(self, act: Act) -> Iterator[LabelRequest]:
        """Requests for its number: at what it finds first, then at each arrow that comes with it."""
        points, label = self.polygon.points, plain(str(act.number))
        match act.done:
            case LayOff(term, _, tip) if tip in (term.head, term.tail) and {term.tail, term.head} <= points.keys():
                start, end = points[term.tail], points[term.head]
                if abs(end - start) > _NOTHING:
                    name = term.name(self.polygon.construction.plane)
                    yield LabelRequest(label, start, end, gap=0.6, size=LEAST, step=act.page, of=name)
                yield LabelRequest(label, end, gap=0.8, size=LEAST, step=act.page)
            case Meet(point=point) | Image(point=point) if point in points:
                yield LabelRequest(label, points[point], gap=0.8, size=LEAST, step=act.page)
                for vector in self.polygon.vectors():
                    if vector.step == act.page and vector.length > _NOTHING:
                        yield LabelRequest(label, vector.start, vector.end, gap=0.6, size=LEAST, step=act.page,
                                           of=vector.name)  # fmt: skip


def _lay(line: _DirectionLine, free: FreeRoom, added: Annotations) -> Place | None:
    """Add the line from its foot past the meeting point; its end if it goes on far enough to bear its mark."""
    reach, on = max(((free.reach(line.meeting, side, _BEYOND), side) for side in line.sides), key=lambda pair: pair[0])
    tip = line.meeting + on * reach if reach >= _SHORT else line.meeting
    start = line.meeting - on * max(0.0, free.reach(line.meeting, -on, abs(line.meeting - line.foot)))
    if abs(tip - start) > _NOTHING:
        added.under.append(Stroke((start, tip), "construction", step=line.page))
    return tip if tip != line.meeting else None


Pages = Mapping[tuple[Plane, Step], int]
_RAY_BEYOND = 9.0  # the length of a direction line past its points [mm]
_SWING, _STROKE = math.radians(22), 12.0
"""Half of an arc: this angle, or this length [mm] if that is less."""


def pencil_lines(construction: Construction, plot: Plot, window: Window, pages: Pages) -> list[Mark]:
    """Each ray and arc from where it starts past where it meets another, with the number of its act."""
    ends: dict[Ray | Arc, list[str]] = {}
    for step in construction.steps:
        if isinstance(step, Meet):
            ends.setdefault(step.first, []).append(step.point)
            ends.setdefault(step.second, []).append(step.point)
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
