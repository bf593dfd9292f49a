"""The construction of a polygon: direction lines with their marks, right angles, and the numbers of what was drawn.

It is drawn last, where labels leave room: a line is shortened before it runs into letters, and a mark or a number for
which there is no room is left out. The numbers are those of the sentences that tell of the same acts. On the mechanism
the pencil's own lines and arcs are shown in the drawings of single steps, and annotations where its signs leave room.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import islice, pairwise

import numpy as np

from graphkin.base.geometry import place
from graphkin.base.value import frozen
from graphkin.construction import Arc, Construction, Drawn, Image, LayOff, Meet, Plane, Plot, Ray, Step, Term
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Rotation, read
from graphkin.planning.method import Act, rate_found
from graphkin.say.dimensions import dimensions, length_text, measured_lengths
from graphkin.say.plane import PolygonReading
from graphkin.say.reading import Reading
from graphkin.sheet.free_room import Annotations, FreeRoom
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, LEAST, formula, plain, quantity_label
from graphkin.sheet.marks import ArcMark, Form, Mark, Place, Shows, Stroke, Text
from graphkin.sheet.polygons import PolygonFigure, arrows
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import SWEEP, spin
from graphkin.sheet.text_blocks import RING, WrittenLines, ringed
from graphkin.sheet.window import Window

_BEYOND, _LIKED, _SHORT = 11.0, 7.0, 2.5
"""Lengths of a direction line past where it meets the other; for labels to keep off if they can; shorter than
this it says nothing [mm]."""
_SQUARE = 1.9  # side of the square in a right angle [mm]
_NOTHING = 0.05  # arrows up to this have no length [mm]
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
    """

    polygon: PolygonFigure
    spoken: PolygonReading
    acts: Sequence[Act]

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
        """A number in a circle beside each thing that was drawn: what has no room at one thing has it at the next."""
        waiting = [requests for act in self.acts if (requests := [*self._beside(act)])]
        while waiting:
            spots = free.spots([first for first, *_ in waiting], [complex(RING, RING)] * len(waiting))
            tried, waiting = waiting, []
            for requests, free_ones in zip(tried, spots, strict=True):
                if (middle := free.place(free_ones)) is not None:
                    marks = [*ringed(requests[0].label[0].text, middle, requests[0].step)]
                    free.add(marks)
                    yield from marks
                elif requests[1:]:
                    waiting.append(requests[1:])

    def _beside(self, act: Act) -> Iterator[LabelRequest]:
        """Requests for its number: at what it finds first, then at each arrow that comes with it."""
        points, label = self.polygon.points, plain(str(act.number))
        match act.done:
            case LayOff(term, _, tip) if tip in (term.head, term.tail) and {term.tail, term.head} <= points.keys():
                start, end = points[term.tail], points[term.head]
                if abs(end - start) > _NOTHING:
                    yield LabelRequest(label, start, end, gap=0.6, size=LEAST, step=act.page)
                yield LabelRequest(label, end, gap=0.8, size=LEAST, step=act.page)
            case Meet(point=point) | Image(point=point) if point in points:
                yield LabelRequest(label, points[point], gap=0.8, size=LEAST, step=act.page)
                for vector in self.polygon.vectors():
                    if vector.step == act.page and vector.length > _NOTHING:
                        yield LabelRequest(label, vector.start, vector.end, gap=0.6, size=LEAST, step=act.page)


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


# --- annotations of the mechanism: lengths that are measured, rotations, what is given --------------------------------


_RADII = (7.0, 9.5, 12.0, 15.0)  # of the arcs that show how a link turns [mm]
_ROUND = tuple(cmath.rect(1, math.tau * k / 48) for k in range(48))
_TURNS, _SWEPT = _ROUND[::2], 1 + round(48 * SWEEP / math.tau)
"""Directions round a point in which places are tried; those in which an arc may start, and the number it passes."""
_NARROWER = (75.0, 50.0, 30.0, 20.0)  # given dimensions are written in shorter lines where long ones have no room [mm]
_TOLD = 5.0  # a shorter length is told by words alone [mm]
_TRIED = 12  # so many places are tried for an arc whose letter finds no room beside it
_HALF = 0.9  # half of the width that an arc with its head takes [mm]
_LETTERS: dict[str, tuple[str, Plane]] = {"omega": ("ω", "velocity"), "alpha": ("α", "acceleration")}


@frozen
class MechanismNotes:
    """Annotations of a mechanism with what the solution reads off it.

    planes  of which results may be shown; none where only what is given is drawn
    """

    skeleton: Skeleton
    reading: Reading
    planes: Sequence[Plane] = field(default_factory=tuple)

    def lines(self) -> list[Mark]:
        return []

    def __call__(self, free: FreeRoom) -> Annotations:
        """All of it among what stands there."""
        added = Annotations()
        for one, other in measured_lengths(self.reading) if self.planes else ():
            self._add_length(one, other, free, added)
        machine = self.reading.mechanism
        asked = [quantity for text in machine.ask if (quantity := read(machine, text)) is not None]
        for half in dict.fromkeys(half for quantity in asked for half in quantity.halves):
            if isinstance(half, Rotation) and half.word in _LETTERS and _LETTERS[half.word][1] in self.planes:
                added.over.extend(self._arc(half, free))
        if self.planes:
            texts = [formula(text) for text in dimensions(self.reading)]
            for wide in (free.room.size.real - 8, *_NARROWER):  # in lines at the foot of the figure
                lines = WrittenLines.of(texts, wide, LABEL)
                if lines.lines and (corner := free.corner(lines.size, from_below=True)) is not None:
                    marks: list[Mark] = [*lines.marks(corner)]
                    free.add(marks)
                    added.over.extend(marks)
                    break
        return added

    def _add_length(self, one: str, other: str, free: FreeRoom, added: Annotations) -> None:
        """A thin line between two points with the length it has, where there is room for its letters."""
        start, end = self.skeleton.at(one), self.skeleton.at(other)
        if abs(end - start) < _TOLD or not (pieces := free.pieces(start, end)):
            return
        step = self.skeleton.step(one, other)
        want = LabelRequest(formula(length_text(self.reading, one, other)), start, end, gap=0.5, step=step)
        if letters := next(free.letters([want])):
            added.over.extend(letters)
            lines = [Stroke(piece, "measured", step=step) for piece in pieces]
            added.under.extend(lines)
            free.add(lines)

    def _arc(self, rotation: Rotation, free: FreeRoom) -> list[Mark]:
        """An arc in the sense in which the link turns, about one of its points, with its letter."""
        (letter, plane), link = _LETTERS[rotation.word], rotation.link
        value = float((self.reading.plot.omega if plane == "velocity" else self.reading.plot.alpha)[link])
        driven = any(driver.link == link for driver in self.reading.mechanism.drivers)
        if driven or not self.reading.usual.rate(value, plane):
            return []
        step, sense = rate_found(self.reading.method, plane, link), math.copysign(1, value)
        label = quantity_label(letter, self.reading.mechanism.called(link))
        form: Form = "omega" if plane == "velocity" else "alpha"
        for point, radius, start in islice(self._places(link, sense, free), _TRIED):
            at, shows = self.skeleton.at(point), Shows(link, form, (point,))
            middle = start * cmath.rect(1, -sense * SWEEP / 2)
            want = LabelRequest(label, at + middle * radius, gap=0.9, away=middle, step=step)
            arc = spin(at, start, sense, radius, step, shows)
            if letters := free.letters_with(arc, want):  # in the colour of the polygon
                marks = [replace(mark, accent=plane) if isinstance(mark, ArcMark | Stroke | Text) else mark
                         for mark in (*arc, *letters)]  # fmt: skip
                free.add(marks)
                return marks
        return []

    def _places(self, link: str, sense: float, free: FreeRoom) -> Iterator[tuple[str, float, complex]]:
        """Places with room for such an arc: its point, radius, direction in which it starts; fixed points first."""
        owners, skeleton = self.reading.mechanism.owners, self.skeleton
        points = sorted(skeleton.named(link), key=lambda point: FRAME not in owners[point])
        swept = (2 * np.arange(len(_TURNS))[:, None] - int(sense) * np.arange(_SWEPT)) % len(_ROUND)
        for point in points:
            around = skeleton.at(point) + np.outer(_RADII, _ROUND)
            middle = np.stack([around.real, around.imag], axis=-1)
            clear = free.free((middle - _HALF).reshape(-1, 2), (middle + _HALF).reshape(-1, 2)).reshape(around.shape)
            for radius, places in zip(_RADII, clear, strict=True):
                yield from ((point, radius, _TURNS[k]) for k in np.flatnonzero(places[swept].all(axis=1)))
