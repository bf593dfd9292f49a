"""The constructions that may have been drawn on a sheet: the right one, other right ways, and each mistake; on paper.

What a student has drawn and measured before counts as it is: an acceleration polygon follows from the own velocities.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import combinations

import numpy as np

from graphkin.base.geometry import Value, place
from graphkin.base.value import bulky, frozen
from graphkin.construction import SCALES, Construction, Given, Image, LayOff, Measure, Meet, Plane, Plot, Ray
from graphkin.errors import NOWHERE
from graphkin.marking.consequences import rewrites
from graphkin.marking.hand import Redrawing, redraw
from graphkin.marking.pencil import Mark, Pencil, PencilHand, Slips, drawn_positions
from graphkin.marking.rewrite import Mistaken, Rewrite, Spot
from graphkin.marking.synonyms import other_methods
from graphkin.photo.readings import RoomReading
from graphkin.photo.sheets import SheetRoom
from graphkin.planning import Method

_LENGTH, _ANGLE, _PART = 0.3, np.radians(0.4), 0.003
"""A hand errs by so much where it lays off [mm], in a direction [rad], and by this part of what was drawn before."""
_HANDS = 200  # that draw the same
_ASTRAY = 5.0  # corners are known so well where most hands get nowhere [mm]
_POINT = 0.04  # a point has no place that is known better [mm]
_TOLD = 0.6  # own corners that are known worse do not tell what follows from them [mm]


@frozen
class PredictedCorner:
    """A place [mm from the pole, y up]; off: its standard deviation, in the direction in which it is known worst. SI
    where it is a student's own."""

    at: complex
    off: float


@frozen
class PredictedStroke:
    """A line between two corners, by their numbers.

    needed   an arrow without which no equation closes; others, to points of a link and of its figure, may be drawn
    goes_on  it was found on a line that is drawn beyond it
    """

    tail: int
    head: int
    needed: bool
    goes_on: bool = False


@bulky
class Way:
    """The construction of a plane by one method, with each of the mistakes that draw it otherwise.

    letters   of its corners; strokes between them
    columns   mistakes, the right drawing first
    own       measured corners of the velocity plane, SI
    """

    method: Method
    plot: Plot
    construction: Construction
    scale: float
    letters: tuple[str, ...]
    strokes: tuple[PredictedStroke, ...]
    columns: tuple[tuple[Rewrite, ...], ...]
    own: Mapping[str, PredictedCorner]

    @cached_property
    def corners(self) -> np.ndarray:
        """Of each column (columns, letters) [mm from the pole, y up]."""
        return self._drawn(_Own(self.columns), {}, self.plot)

    @property
    def pole(self) -> int:
        return self.letters.index(self.construction.pole)

    @property
    def is_loose(self) -> bool:
        """True if velocities that it follows from are not known, so that right ones stand for them."""
        read = (step for step in self.method.velocity.steps if isinstance(step, Measure))
        needed = {letter for step in read for letter in (step.tail, step.head)}
        return self.construction.plane == "acceleration" and not needed <= self.own.keys()

    @property
    def places(self) -> frozenset[complex]:
        """The corners of the right drawing [mm], to a tenth."""
        return frozenset(complex(round(at.real, 1) + 0.0, round(at.imag, 1) + 0.0) for at in self.corners[0])

    @cached_property
    def spots(self) -> dict[Spot, tuple[str, str] | None]:
        """The places where a length or a direction may be off; the corners of an arrow that is laid off, or of a side
        of a figure, None for a line."""
        plane, found = self.construction.plane, dict[Spot, tuple[str, str] | None]()
        for step in self.construction.steps:
            match step:
                case LayOff(start=start, tip=tip):
                    found["laid", plane, tip] = (start, tip)
                case Meet():
                    rays = (ray for ray in (step.first, step.second) if isinstance(ray, Ray))
                    found.update(dict.fromkeys(("line", plane, step, ray) for ray in rays))
                case Image(base=(tail, _), point=point):
                    found["image", plane, point] = (tail, point)
                case _:
                    pass
        return found

    def altered(self, column: int, factors: Mapping[Spot, np.ndarray]) -> np.ndarray:
        """Corners (n, letters) of a column with arrows, directions and figures multiplied by arrays (n,)."""
        count = max(len(each) for each in factors.values())
        return self._drawn(_Own([self.columns[column]] * count), factors, self.plot)

    def hands(self, column: int, factors: Mapping[Spot, complex]) -> np.ndarray:
        """Corners (n, letters) as many hands draw those of a column, each with its own errors [mm]; those alone that
        get anywhere."""
        plane = self.construction.plane
        sizes = {each: max(map(abs, map(place, self.plot.points(each).values()))) for each in SCALES}
        lengths = {each: _PART * size for each, size in (sizes | {"position": self.method.size}).items()}
        pencil = Pencil(lengths | {plane: _LENGTH * self.scale}, _ANGLE)
        slips = Slips(1, _HANDS)
        hand = _OwnPencil(pencil, slips, self.method.facts(), [self.columns[column]])
        drawn = self._drawn(hand, factors, drawn_positions(self.method, pencil, slips))[0]
        return np.asarray(drawn[np.isfinite(drawn).all(axis=1)])

    def spread(self, column: int, factors: Mapping[Spot, complex]) -> np.ndarray:
        """The covariance of a column's corners by the hands that draw it (2 letters, 2 letters) [mm^2]: of all x, then
        all y."""
        drawn, every = self.hands(column, factors), np.eye(2 * len(self.letters))
        if len(drawn) < _HANDS / 2:
            return every * _ASTRAY**2
        return np.asarray(np.cov(np.hstack([drawn.real, drawn.imag]).T)) + every * _POINT**2

    def _drawn(self, hand: _Own, factors: Mapping[Spot, np.ndarray | complex], right: Plot) -> np.ndarray:
        """Corners as a hand draws them (*shape, letters) [mm]."""
        hand.factors, hand.own = factors, self.own
        points = hand.drawn(self.method, right).points(self.construction.plane)
        every = [np.broadcast_to(np.asarray(points[name], dtype=complex), hand.shape) for name in self.letters]
        return np.stack(every, axis=-1) / self.scale


def predicted(
    method: Method, plot: Plot, room: SheetRoom, velocity: Mapping[str, PredictedCorner] | None = None
) -> tuple[Way, ...]:  # fmt: skip
    """All that may have been drawn in a room: the method of the key first, then other right ones.

    plot      the right one, at the room's position
    velocity  corners of the student's own velocity polygon by letter, SI, as far as they are known
    """
    ways = [_way(method, plot, room, velocity or {}, rewrites(method, plot))]
    for other in other_methods(method):
        way = _way(other, plot, room, velocity or {}, ())
        if all(way.places != known.places for known in ways):
            ways.append(way)
    return tuple(ways)


def own_velocities(room: RoomReading) -> dict[str, PredictedCorner]:
    """The corners of a velocity polygon that are known well enough to tell what follows from them, SI; those that are
    sure are better known than a hand reads them."""
    drawing, scale = room.drawing(NOWHERE), room.room.scale
    every = dict.fromkeys(drawing.points, 0.0) | drawing.off
    return {letter: PredictedCorner(drawing.points[plane, letter] * scale, off * scale)
            for (plane, letter), off in every.items() if off < _TOLD}  # fmt: skip


def _way(
    method: Method, plot: Plot, room: SheetRoom, velocity: Mapping[str, PredictedCorner], mistakes: Iterable[Rewrite]
) -> Way:  # fmt: skip
    construction = method.velocity if room.plane == "velocity" else method.acceleration
    resting = {name for step in construction.steps if isinstance(step, Given) for name in step.also}
    right = redraw(method, plot)
    letters = tuple(name for name in right.points(room.plane) if name not in resting)
    own = _own(method.velocity, velocity) if room.plane == "acceleration" else {}
    columns = ((), *((one,) for one in mistakes if one.edits))
    strokes = tuple(_strokes(construction, letters, resting))
    return Way(method, plot, construction, room.scale, letters, strokes, columns, own)


def _own(construction: Construction, velocity: Mapping[str, PredictedCorner]) -> dict[str, PredictedCorner]:
    """Own corners as far as a construction has them, from where it begins: not at the pole where that is found last."""
    found = {step.point for step in construction.steps if isinstance(step, Meet)}
    begins = (step.point for step in construction.steps if isinstance(step, Given) and step.point not in found)
    start = next(begins, construction.pole)
    known = {**velocity, construction.pole: PredictedCorner(0j, 0.0)}  # it is printed
    if start not in known:
        return {}
    of_it = {*construction.nodes, construction.pole}
    first = known[start]
    return {name: PredictedCorner(one.at - first.at, float(np.hypot(one.off, first.off)))
            for name, one in known.items() if name in of_it}  # fmt: skip


def _strokes(construction: Construction, letters: Sequence[str], resting: set[str]) -> Iterator[PredictedStroke]:
    """Arrows of equations first; then what else may be drawn: from the pole to points, and between those of a link."""
    number = {name: k for k, name in enumerate(letters)}
    pole = number[construction.pole]
    number.update(dict.fromkeys(resting, pole))
    found: dict[frozenset[int], PredictedStroke] = {}
    laid = [step.term for step in construction.steps if isinstance(step, LayOff)]
    terms = construction.vectors().values()
    unknown = {frozenset((number.get(term.tail), number.get(term.head))) for term in terms if term.size is None}
    arrows = [(term.tail, term.head, term.size is None or term in laid) for term in terms]
    arrows += [(construction.pole, name, False) for name, node in construction.nodes.items() if node.site is not None]
    images = [(*step.base, step.point) for step in construction.steps if isinstance(step, Image)]
    arrows += [(*pair, False) for three in images for pair in combinations(three, 2)]
    for tail, head, needed in sorted(arrows, key=lambda each: not each[2]):
        if tail in number and head in number and number[tail] != number[head]:
            ends = frozenset((number[tail], number[head]))
            found.setdefault(ends, PredictedStroke(number[tail], number[head], needed, ends in unknown))
    yield from found.values()


class _Own(Mistaken):
    """Draws columns of mistakes with factors at some places; corners that are measured lie where they do.

    own  of the velocity plane by letter, SI
    """

    factors: Mapping[Spot, np.ndarray | complex] = {}
    own: Mapping[str, PredictedCorner] = {}

    def drawn(self, method: Method, plot: Plot) -> Redrawing:
        with np.errstate(invalid="ignore", divide="ignore"):
            return redraw(method, self.placed(method, plot), self, self.shape)

    def _there(self, plane: Plane, name: str, right: Value) -> Value:
        own = self.own.get(name) if plane == "velocity" else None
        return right if own is None else own.at + own.off * self._error(name)

    def _error(self, name: str) -> np.ndarray:
        """By how much an own corner is misread, in standard deviations."""
        return np.zeros(self.shape, dtype=complex)

    def _from(self, spot: Spot, start: Value, right: Value) -> Value:
        factor = self.factors.get(spot)
        return right if factor is None else start + factor * (right - start)

    def tip(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        start, tip = plot.points(plane)[step.start], super().tip(plot, plane, step, right)
        return self._there(plane, step.tip, self._from(("laid", plane, step.tip), start, tip))

    def line(self, plot: Redrawing, plane: Plane, step: Meet, ray: Ray, right: Value) -> Value:
        return super().line(plot, plane, step, ray, right) * self.factors.get(("line", plane, step, ray), 1.0)

    def crossing(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        return self._there(plane, point, super().crossing(plot, plane, point, right))

    def corner(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        right = super().corner(plot, plane, step, right)
        right = self._from(("image", plane, step.point), plot.points(plane)[step.base[0]], right)
        return self._there(plane, step.point, right)


class _OwnPencil(_Own, PencilHand):
    """Draws one of them with a pencil that errs, many times."""

    def _error(self, name: str) -> np.ndarray:
        mark = Mark("velocity", "point", (name,))
        return np.broadcast_to(self.slips.of(mark) + 1j * self.slips.of(mark, 1), self.shape)
