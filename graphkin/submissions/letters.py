"""The points of a drawing that bear letters.

A letter stands beside its point, and points that a vector joins are joined by a line: among the line ends, dots and
crossings near a letter the one counts that is nearest, a drawn vector making up for some millimetres. Of a letter that
stands at several places, as b does where the mechanism or the other polygon has its points called so, the one counts
that hangs together with the pole; there a capital letter and one without its prime mean the polygon's point, too.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import chain, combinations, permutations

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.submissions.picture import Figures, PagePicture, PictureText, distances
from graphkin.submissions.polygons import PaperPolygon, by_name, loosely, pieces_of, spellings, texts_of

_REACH = 6.0  # a letter belongs to no dot farther from it [mm]
_NEAR = 4.0  # nor to the end of a line or a crossing so far from it, which may be anything [mm]
_FARTHER = 0.2  # each millimetre more counts for more than the one before [1/mm]
_JOINED = 2.5  # what a vector that is drawn makes up for [mm]
_SAME = 0.2  # closer than this, marks of one point are one [mm]
_END, _LEADER, _CROSSING = 1.5, 2.5, 3.0
"""A dot is meant before a line's end, that before where a leader from the letter leads to or a crossing [mm]."""
_TOUCHES = 3.0  # a leader begins so near its letter [mm]
_CLEAR = 1.5  # by so much the best point must be better than the next [mm]
_CANDIDATES = 12
_LINES_NEAR = 40
_ROUNDS = 8

Place = tuple[float, complex]  # how far a candidate is from its letter, and where it is [mm]


@frozen
class PlacedLetters:
    """The places of letters, by plane and the construction's letter; and letters whose place is not clear."""

    points: Mapping[tuple[Plane, str], complex]
    doubtful: tuple[str, ...]


def find_letters(
    picture: PagePicture, polygons: Sequence[PaperPolygon], others: Collection[str] = (), names: Sequence[str] = ()
) -> PlacedLetters:
    """The place of each letter of each polygon.

    others  letters of something else: the points of the mechanism
    names   letters of the dots in the file's order, instead of those that stand beside them
    """
    spelled = {name: key for name, key in spellings(polygons).items() if name not in others}
    sure = by_name(picture.dots, names, spelled)
    written = texts_of(picture.texts, spelled)
    figures = Figures(picture.lines)
    points, doubtful = dict(sure), []
    for polygon in polygons:
        own = {key: texts for key, texts in written.items() if key[0] == polygon.plane and key not in sure}
        choices = {key[1]: _candidates(picture, texts) for key, texts in own.items()}
        fixed = {letter: place for (plane, letter), place in sure.items() if plane == polygon.plane}
        choices = _own_figure(choices, fixed, polygon, picture, figures)
        for letter, place in _settled(_Arranged({k: v for k, v in choices.items() if v}, fixed, polygon, picture)):
            if place is None:
                doubtful.append(letter)
            else:
                points[polygon.plane, letter] = place
    return PlacedLetters(points, tuple(doubtful))


def _own_figure(
    choices: dict[str, list[Place]], fixed: Mapping[str, complex], polygon: PaperPolygon, picture: PagePicture,
    figures: Figures,
) -> dict[str, list[Place]]:  # fmt: skip
    """The choices that hang together with the pole, for letters that have such; further letters by looser spellings."""
    pole = next(iter(polygon.letters))
    places = [fixed[pole]] if pole in fixed else [place for _, place in choices.get(pole, ())[:1]]
    lines = figures.about(places[0]) if places else ()
    if not lines:
        return choices
    ends = np.array(lines)

    def here(some: Sequence[Place]) -> list[Place]:
        return [one for one in some if np.min(distances(np.array([one[1]]), ends[:, 0], ends[:, 1])) < _SAME]

    own = {letter: here(some) or some for letter, some in choices.items()}
    alike = Counter(map(loosely, polygon.letters))
    for letter in polygon.letters:
        if letter not in fixed and alike[loosely(letter)] == 1 and not here(own.get(letter, ())):
            loose = [text for text in picture.texts if loosely(letter) in map(loosely, pieces_of(text.text))]
            if some := here(_candidates(picture, loose)):
                own[letter] = some
    return own


def _candidates(picture: PagePicture, texts: Sequence[PictureText]) -> list[Place]:
    """Points near any of a letter's texts, the nearest first."""
    candidates: list[Place] = []
    for text in texts[:8]:
        near = [(_far(text, dot.place, _REACH), dot.place) for dot in picture.dots]
        near += [(_END + _far(text, end, _NEAR), end) for line in picture.lines for end in line]
        for line, end, far in [(pair, *ends) for pair in picture.lines for ends in (pair, pair[::-1])]:
            distance = text.distance(end)  # a line that begins at a text and at nothing else leads to its far end
            if distance <= _TOUCHES and abs(far - end) <= 2 * _REACH:
                others = (place for other in picture.lines if other is not line for place in other)
                if all(abs(end - mark) > _SAME for mark in chain((dot.place for dot in picture.dots), others)):
                    near.append((_LEADER + distance, far))
        near += [(_CROSSING + _far(text, place, _NEAR), place) for place in _crossings(picture, text)]
        for distance, place in sorted((pair for pair in near if pair[0] < math.inf), key=lambda pair: pair[0]):
            if all(abs(place - other) > _SAME for _, other in candidates):
                candidates.append((distance, place))
            if len(candidates) >= _CANDIDATES:
                break
    return sorted(candidates, key=lambda pair: pair[0])


def _far(text: PictureText, place: complex, reach: float) -> float:
    """The unlikeliness that a text letters a place, in mm of a letter that stands close by."""
    distance = text.distance(place)
    return distance + distance**2 * _FARTHER if distance <= reach else math.inf


def _crossings(picture: PagePicture, text: PictureText) -> Iterator[complex]:
    """The crossings of lines near a text: direction lines are drawn beyond their points."""
    middle = text.corner + text.right * text.width / 2
    reach = _REACH + text.width / 2 + text.above
    near = [line for line in picture.lines if _off(middle, *line) < reach][:_LINES_NEAR]
    for one, other in combinations(near, 2):
        a, b = one[1] - one[0], other[1] - other[0]
        turn = (a.conjugate() * b).imag
        if abs(turn) <= 0.02 * abs(a) * abs(b):
            continue
        along = ((other[0] - one[0]).conjugate() * b).imag / turn
        place, slack = one[0] + along * a, _SAME / abs(a)
        if -slack <= along <= 1 + slack and _off(place, *other) <= _SAME and text.distance(place) <= _REACH:
            yield place


def _off(place: complex, start: complex, end: complex) -> float:
    """The distance of a place from a piece of a line [mm]."""
    along = end - start
    share = ((place - start) * along.conjugate()).real / abs(along) ** 2 if along else 0.0
    return abs(place - start - min(1.0, max(0.0, share)) * along)


class _Arranged:
    """Letters on points: what an arrangement of them costs [mm]."""

    def __init__(
        self, choices: Mapping[str, list[Place]], fixed: Mapping[str, complex], polygon: PaperPolygon,
        picture: PagePicture,
    ) -> None:  # fmt: skip
        self.choices, self.picture = choices, picture
        self.far = {(letter, place): distance for letter, places in choices.items() for distance, place in places}
        self.around: dict[str, set[str]] = {}
        for vector in polygon.vectors:
            self.around.setdefault(vector.tail, set()).add(vector.head)
            self.around.setdefault(vector.head, set()).add(vector.tail)
        self.chosen = {letter: places[0][1] for letter, places in choices.items()} | dict(fixed)
        self._through: dict[complex, frozenset[int]] = {}

    def cost(self, changes: Mapping[str, complex]) -> float:
        """With some letters moved. Each letter: its distance, less for its drawn vectors, more on another's point."""
        chosen = {**self.chosen, **changes}
        at_place = Counter(_cell(place) for place in chosen.values())
        total = 0.0
        for letter in self.choices:
            place = chosen[letter]
            others = [chosen[name] for name in self.around.get(letter, ()) if name in chosen]
            joined = (abs(place - other) >= _SAME and self._lines(place) & self._lines(other) for other in others)
            drawn = sum(map(bool, joined)) / max(1, len(others))
            total += self.far[letter, place] - _JOINED * drawn + _JOINED * (at_place[_cell(place)] > 1)
        return total

    def _lines(self, place: complex) -> frozenset[int]:
        """Numbers of the lines that run through a place."""
        if place not in self._through:
            passing = (k for k, line in enumerate(self.picture.lines) if _off(place, *line) < _SAME)
            self._through[place] = frozenset(passing)
        return self._through[place]

    def moves(self) -> Iterator[dict[str, complex]]:
        """A letter to another point of its own; one that takes another's, which moves on; two, three that exchange."""
        for letter, places in self.choices.items():
            yield from ({letter: place} for _, place in places if place != self.chosen[letter])
        for one, other in permutations(self.choices, 2):
            there = self.chosen[other]
            if there != self.chosen[one] and (one, there) in self.far:
                yield from ({one: there, other: place} for _, place in self.choices[other] if place != there)
        for letters in permutations(self.choices, 3):
            if letters[0] == min(letters):
                moved = {letter: self.chosen[after] for letter, after in zip(letters, (*letters[1:], letters[0]))}
                if all(move in self.far for move in moved.items()) and len(set(moved.values())) == len(moved):
                    yield moved


def _cell(place: complex) -> tuple[float, float]:
    return round(place.real, 3), round(place.imag, 3)


def _settled(layout: _Arranged) -> Iterator[tuple[str, complex | None]]:
    """The best arrangement; None for letters that could as well be elsewhere."""
    best = layout.cost({})
    for _ in range(_ROUNDS):
        before = best
        for move in layout.moves():
            if (cost := layout.cost(move)) < best - 1e-9:
                layout.chosen.update(move)
                best = cost
        if best == before:
            break
    unclear = {letter for move in layout.moves() if layout.cost(move) < best + _CLEAR for letter in move}
    for letter in layout.choices:
        yield letter, None if letter in unclear else layout.chosen[letter]
