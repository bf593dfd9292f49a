"""Annotations of a mechanism, drawn last: how asked links turn, what is given, what is measured in the drawing."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field, replace
from functools import cached_property, partial
from itertools import chain, combinations, groupby, islice, pairwise, product, tee

from graphkin.base.boxes import free_about
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Rotation
from graphkin.model.wheels import wheels_of
from graphkin.planning.asked import plane_of
from graphkin.planning.method import rate_found
from graphkin.say.dimensions import length_size, measured_lengths
from graphkin.say.reading import Reading
from graphkin.say.sizes import DrawnAngle, DrawnLength, Size, in_words
from graphkin.sheet.dimension_lines import DimensionLines, angle_label
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, LEAST, Label, formula, link_label, point_label, quantity_label
from graphkin.sheet.marks import ArcMark, Form, Mark, Place, Shows, Stroke, Text
from graphkin.sheet.obstacles import arc_places, bounds
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import SWEEP, spin
from graphkin.sheet.text_blocks import WrittenLines
from graphkin.sheet.wheels import disc
from graphkin.sheet.window import PLANES

_RADII = (9.0, 12.0, 15.0, 18.5, 22.0, 6.5)  # of the arcs that show how a link turns [mm]
_MIDDLE = (6.0, 8.0, 4.5)  # and of those about the middle of a coupler, where no other is [mm]
_WIDE, _LONG = math.radians(150), 16.0  # the angle of these, whose middle no sign shows; not longer than so many mm
_AROUND = tuple(cmath.rect(1, math.tau * k / 24) for k in range(24))
_NARROWER = (75.0, 50.0, 30.0, 20.0)  # given dimensions are written in shorter lines where long ones have no room [mm]
_TOLD = 5.0  # a shorter length is told by words alone [mm]
_CLOSER = (7.5, 10.5, 13.5, 17.0, 20.0, 5.0)  # tried where none of these has room [mm]
_SHARES = (1, 1), (2, 1), (1, 2), (3, 1), (1, 3)  # how much each of two points counts in a place along their link
_SMALL = (7.0, 5.5, 4.0)  # radii of arcs about such places, where there is no room for others [mm]
_TRIED, _PAIRS, _ASKED, _WORST = 48, 8, 3, 3
"""Places that are tried for an arc and its letter; with one for another arc; numbers of links that make way; ranks."""
_CROSSING, _TUBE = 1.6, 3.6  # half of the stretch of an arc that lies on its own link, on a cylinder [mm]
_APART = 2.0  # what two such arcs keep from each other where there is room [mm]
_OTHER, _AROUND_IT = 4.0, math.radians(115)
"""An arc that crosses its link nearer to a point would look as if it turned about that [mm]; a wider one does not."""
_RIM = 4.0  # an arc farther beyond a wheel's rim would look like another's [mm]

Arc = tuple[tuple[str, ...], float, complex, bool, float]
"""The points about whose middle it lies, radius [mm], direction of its middle, whether a bar passes there, angle."""
_Way = tuple[Arc, list[Mark]]


@frozen
class MechanismNotes:
    """Annotations of a mechanism as it is read, and what is given of it; planes: of which results may be shown; told: a
    text above has what finds no room here."""

    skeleton: Skeleton
    reading: Reading
    given: Sequence[Size]
    planes: Sequence[Plane] = field(default_factory=tuple)
    told: bool = False

    def lines(self) -> Iterator[Mark]:
        """The way of extension lines, from each end of a dimension apart to beside the other: numbers keep off it."""
        window, shapes = self.skeleton.window, (size.shape for size in self.given)
        for span in (shape for shape in shapes if isinstance(shape, DrawnLength) and shape.form == "apart"):
            start, end, along = window(span.start), window(span.end), window.turned(span.along)
            off = end - start - along * ((end - start) / along).real
            yield from (Stroke((start, start + off), "thin"), Stroke((end, end - off), "thin"))

    def __call__(self, free: FreeRoom) -> list[Mark]:
        """All of it among what stands there; data that find no room are written in lines at the foot of the figure."""
        added, drawn = list[Mark](), dict[str, Arc]()
        for turn in self._turns:
            added += self._arc(turn, free, drawn)
        lines, unsaid = DimensionLines(self.skeleton, free), dict[bool, list[Label]]()
        lettered = {mark.label for mark in free.marks if isinstance(mark, Text)}
        at, levers = self.skeleton.at, measured_lengths(self.reading) if self.planes else ()
        measured = [length_size(self.reading, *ends) for ends in levers if abs(at(ends[0]) - at(ends[1])) >= _TOLD]
        every = groupby(lines.once([*self.given, *measured]), key=lambda datum: datum.ends or id(datum))
        for data in ([*alike] for _, alike in every):  # both coordinates of a point, or one datum
            added += (marks := lines.draw(*data))
            for datum in data if not marks else ():
                lettered_too = isinstance(datum.shape, DrawnAngle) and angle_label(datum) in lettered
                if datum not in measured and not lettered_too:
                    unsaid.setdefault(datum.derived, []).append(formula(in_words(self.reading, datum)))
        for derived, labels in sorted(unsaid.items()) if self.planes else ():  # what is given first
            words = self._written(labels, free, (LABEL,) if derived or self.told else (LABEL, LEAST))
            added += (replace(mark, accent="grey") for mark in words) if derived else words
        return added

    def _written(self, labels: Sequence[Label], free: FreeRoom, sizes: Sequence[float]) -> list[Text]:
        """Data in lines, as low as there is room: together, else in parts; in smaller letters where large have none."""
        widths = free.room.size.real - 8, *_NARROWER
        for size, count, wide in product(sizes, range(len(labels), 0, -1), widths):
            text = WrittenLines.of(labels[:count], wide, size)
            if (corner := free.corner(text.size, from_below=True)) is not None:
                marks = [*text.marks(corner)]
                free.add(marks)
                return [*marks, *self._written(labels[count:], free, sizes)]
        return []

    @cached_property
    def _turns(self) -> dict[Rotation, float]:
        return self.reading.asked_turns(self.planes)

    def _arc(self, turn: Rotation, free: FreeRoom, drawn: dict[str, Arc]) -> list[Mark]:
        """An arc as the link turns, with its letter, if need be where a link's number makes way; else the letter alone
        at the link's own. drawn: by link the first, to stand beside."""
        numbers = self._numbers(turn.link, free)
        for number in (None, *numbers):
            rest = free.without(number) if number is not None else free
            if (best := self._chosen(turn, rest, drawn)) is None:
                continue
            place, marks = best
            if number is not None:
                rest.add(marks)
                [moved] = rest.letters([numbers[number]])
                if not moved and number.label != self._number(turn.link):
                    continue
                free.leave_out(number)  # of the link itself its letter tells the number
                marks = [*marks, *moved]
            drawn.setdefault(turn.link, place)
            break
        else:
            marks = self._letter(turn, free)
        free.add(marks)
        return marks

    def _number(self, link: str) -> Label:
        return link_label(self.reading.mechanism.called(link))

    def _numbers(self, link: str, free: FreeRoom) -> dict[Text, LabelRequest]:
        """Numbers of links without a leader, and what they asked for: that of the link first, then the nearest."""
        machine, own = self.reading.mechanism, self._number(link)
        names = {*map(self._number, machine.links)} - {*map(point_label, machine.points)}
        wanted = {want.label: want for want in free.wanted if want.label in names}
        texts = [text for text, after in pairwise((*free.marks, None)) if isinstance(text, Text) and not text.accent
                 and text.label in wanted and not (isinstance(after, Stroke) and after.pen == "leader")]  # fmt: skip
        texts.sort(key=lambda text: (text.label != own, abs(text.at - self._middle(self.skeleton.named(link)))))
        return {text: wanted[text.label] for text in texts[:_ASKED]}

    def _letter(self, turn: Rotation, free: FreeRoom) -> list[Mark]:
        """The letter alone, at the number of its link or another letter of it, or as near as there is room."""
        plane, called = plane_of(turn), self.reading.mechanism.called(turn.link)
        near = {self._number(turn.link), *(quantity_label(each.letter, called) for each in self._turns)}
        at = [text for text in free.marks if isinstance(text, Text) and text.label in near]
        step = rate_found(self.reading.method, plane, turn.link)
        wanted = [LabelRequest(quantity_label(turn.letter, called), text.at, gap=gap, step=step)
                  for gap in (2.5, 5.0, 8.0) for text in at]  # fmt: skip
        every = zip(wanted, free.places(wanted, [want.half for want in wanted], wide=True), strict=True)
        letters = (want.about(place) for want, place in every if place is not None)
        return [replace(text, accent=plane) for text in next(letters, ())]

    def _chosen(self, turn: Rotation, free: FreeRoom, drawn: dict[str, Arc]) -> _Way | None:
        """The best place of an arc with its letter, if any: of two for one link the first is where the other has a good
        one beside it, else any, if there is such a place."""
        beside, new = drawn.get(turn.link), turn.link not in drawn
        also = [each for each in self._turns if new and each.link == turn.link and each != turn]
        first, again, rest = tee(_by_rank(self._rated(turn, free, beside)), 3)
        for ways, worst in ((islice(first, _PAIRS), 0), (again, _WORST)):
            for place, marks in ways:
                others = (self._rated(each, free.also(marks), place) for each in also)
                if all(any(rank <= worst for rank, _ in islice(each, _PAIRS)) for each in others):
                    return place, marks
        return next(rest, None)

    def _rated(self, turn: Rotation, free: FreeRoom, beside: Arc | None) -> Iterator[tuple[int, _Way]]:
        """Places of an arc with its letter: 0 about the link's pivot, if it has one, where this letter and all others
        are nearer to their own heads; 1 where not all are; 2 and 3 elsewhere."""
        alike = [mark for mark in free.marks
                 if _is_head(mark) or (isinstance(mark, Text) and mark.accent in PLANES[1:])]  # fmt: skip
        pivot = self._pivot(turn.link)
        for place, marks in self._lettered(turn, free, beside):
            yield 2 * (pivot is not None and place[0] != (pivot,)) + (not _apart(marks, alike)), (place, marks)

    def _lettered(self, turn: Rotation, free: FreeRoom, beside: Arc | None) -> Iterator[_Way]:
        """Places of an arc with room for its letter, then those a little farther off, in the colour of the polygon."""
        plane, link = plane_of(turn), turn.link
        step, sense = rate_found(self.reading.method, plane, link), math.copysign(1, self._turns[turn])
        label = quantity_label(turn.letter, self.reading.mechanism.called(link))
        form: Form = "omega" if plane == "velocity" else "alpha"
        near, far = tee(islice(self._places(link, free, beside), _TRIED))
        for wide, place in chain(((False, place) for place in near), ((True, place) for place in far)):
            points, radius, middle, crossing, sweep = place
            about, half = self._middle(points), cmath.rect(1, -sense * sweep / 2)
            arc = spin(about, middle, sense * sweep, radius, step, Shows(link, form, points))
            sides = (middle / half, middle * half) if crossing else (middle,)
            wanted = [LabelRequest(label, about + away * radius, gap=0.9, away=away, step=step) for away in sides]
            halves = [want.half for want in wanted]
            for want, at in zip(wanted, free.also(arc).places(wanted, halves, wide), strict=True):
                if at is not None:
                    yield place, [replace(mark, accent=plane) if isinstance(mark, ArcMark | Stroke | Text) else mark
                                  for mark in (*arc, *want.about(at))]  # fmt: skip

    def _places(self, link: str, free: FreeRoom, beside: Arc | None) -> Iterator[Arc]:
        """Places with room for such an arc, beside another first: by a pivot, about a coupler's middle, or a point."""
        own = _TUBE if any(map(self.skeleton.is_cylinder, self.skeleton.guides(link))) else _CROSSING

        def room(place: Arc, wide: float, over: bool) -> Sequence[Sequence[Mark]]:
            points, radius, middle, crossing, sweep = place
            at, half, start = self._middle(points), sweep / 2, cmath.phase(middle)
            cut = own / radius if crossing else -half
            lows = (start - half, start + cut)[: 1 + crossing]
            one, more = ([ArcMark(at, r, low, half - cut) for low in lows for r in radii]
                         for radii in ((radius,), (radius - wide, radius + wide)))  # fmt: skip
            return ((), (), one + more) if over else (one, more, ())

        usual, more = [*self._arcs(link, _RADII, False)], [*self._arcs(link, _CLOSER, True), *self._small(link)]
        first = [arc for arc in (*self._arcs(link, _RADII, True), *more) if beside and arc[:3:2] == beside[:3:2]]
        taken, trials = set[Arc](), ((_APART, False, False), (_APART / 2, False, False), (_APART / 2, True, False))
        last = product((first, usual, more), [(_APART / 2, True, True)])  # on bars of others where no place is off them
        for arcs, (wide, over, on) in chain(product((first, usual, more), trials), last):
            able = (arc for arc in arcs if arc not in taken and (on or not over or not self._on_others(link, arc)))
            for arc in free.fitting(able, partial(room, wide=wide, over=over)):
                taken.add(arc)
                yield arc

    def _on_others(self, link: str, arc: Arc) -> bool:
        """True of an arc on a bar of another link: it would seem to be that one's."""
        points, radius, middle, _, sweep = arc
        way = arc_places(ArcMark(self._middle(points), radius, cmath.phase(middle) - sweep / 2, sweep))
        others = [bar for other in self.skeleton.mechanism.moving if other != link for bar in self.skeleton.bars(other)]
        return bool(free_about(way, others, _APART / 2).min() < _APART / 2)

    def _middle(self, points: Sequence[str]) -> Place:
        return sum(map(self.skeleton.at, points)) / len(points)

    def _alone(self, points: Sequence[str], radius: float, arm: complex) -> bool:
        """No point is near where an arc crosses its link: it would look as if it turned about that."""
        crossing = self._middle(points) + radius * arm / abs(arm)
        return all(abs(self.skeleton.at(point) - crossing) > _OTHER for point in self.skeleton.points)

    def _arcs(self, link: str, radii: Sequence[float], second: bool) -> Iterator[Arc]:
        skeleton, pivot, points = self.skeleton, self._pivot(link), self.skeleton.named(link)
        bars = sorted(skeleton.bars(link), key=lambda bar: -abs(bar[0] - bar[1]))
        if pivot is not None:
            at = skeleton.at(pivot)
            ways = dict[float, complex]()
            for arm in (far - at for bar in bars for near, far in (bar, bar[::-1]) if abs(near - at) < 0.1):
                ways.setdefault(round(cmath.phase(arm), 3), arm)  # the longest of those one way
            for radius, arm in product(radii, ways.values()):
                if abs(arm) > radius + 2:
                    yield (pivot,), radius, arm / abs(arm), True, SWEEP
        pairs = [(pair, skeleton.at(pair[1]) - skeleton.at(pair[0])) for pair in combinations(points, 2) if not pivot]
        pairs.sort(key=lambda pair: -abs(pair[1]))
        for (pair, arm), radius, way in product(pairs, radii if second else _MIDDLE, (1, -1)):
            sweep = max(SWEEP, min(_WIDE, _LONG / radius))
            if abs(arm) > 2 * radius + 4 and (sweep > _AROUND_IT or self._alone(pair, radius, way * arm)):
                yield pair, radius, way * arm / abs(arm), True, sweep
        for radius, (pair, arm), way in product(radii, pairs, (1, -1)):
            about = (pair[way < 0],)
            if abs(arm) > 2 * radius and self._alone(about, radius, way * arm):
                yield about, radius, way * arm / abs(arm), True, SWEEP
        wheels = wheels_of(self.reading.mechanism)
        hub = disc(skeleton, link) or next((wheel.centre for wheel in wheels if wheel.link == link), "")
        rims = [radius for at, radius in skeleton.circles if hub and at == skeleton.at(hub)]
        for point, radius, middle in product([hub] if hub else points if not bars else (), radii, _AROUND):
            if radius < max(rims, default=math.inf) + _RIM:
                yield (point,), radius, middle, False, SWEEP

    def _pivot(self, link: str) -> str | None:
        """The centre of a wheel, or the point about which the link turns on the frame."""
        owners = self.reading.mechanism.owners
        return disc(self.skeleton, link) or next((p for p in self.skeleton.named(link) if FRAME in owners[p]), None)

    def _small(self, link: str) -> Iterator[Arc]:
        """Small ones far around a place anywhere along a link."""
        ends = [*combinations(self.skeleton.named(link), 2)]
        ends += [(slide.line.origin, slide.point) for slide in self.skeleton.guides(link)]
        for (one, other), shares, radius, way in product(ends, _SHARES, _SMALL, (1, -1)):
            points, arm = (one,) * shares[0] + (other,) * shares[1], self.skeleton.at(other) - self.skeleton.at(one)
            if abs(arm) * shares[way < 0] > (radius + 2) * sum(shares):
                yield points, radius, way * arm / abs(arm), True, min(_WIDE, _LONG / radius)


def _by_rank(ways: Iterable[tuple[int, _Way]]) -> Iterator[_Way]:
    """The best first, one after the other as they are asked for."""
    for wanted, each in enumerate(tee(ways, _WORST + 1)):
        yield from (way for rank, way in each if rank == wanted)


def _is_head(mark: Mark) -> bool:
    """True for the head of an arc that shows how a link turns."""
    return isinstance(mark, Stroke) and mark.shows is not None and mark.shows.form in ("omega", "alpha")


def _apart(new: Sequence[Mark], others: Sequence[Mark]) -> bool:
    """True where the letters of an arc are nearer to its head than to others, and those of others to theirs."""

    def off(text: Text, marks: Sequence[Mark]) -> float:
        left, top, right, bottom = bounds([text])
        heads = (mark.places[0] for mark in marks if isinstance(mark, Stroke) and _is_head(mark))
        return min((abs(tip - complex(left + right, top + bottom) / 2) for tip in heads), default=math.inf)

    pairs = ((text, own, foreign) for own, foreign in ((new, others), (others, new)) for text in own)
    return all(off(text, own) < off(text, foreign) for text, own, foreign in pairs if isinstance(text, Text))
