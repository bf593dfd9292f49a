"""The points of a drawing that bear letters.

A letter stands beside its point, and points that a vector joins are joined by a line: among the line ends, dots and
crossings near a letter the one counts that is nearest, a drawn vector making up for some millimetres. Of a letter that
stands at several places, as b does where the mechanism or the other polygon has its points called so, the one counts
that hangs together with the pole; there a capital letter and one without its prime mean the polygon's point, too.
Letters are written as `b₃`, `b_{3}'`, `p′(a′, d′)`, and in looser spellings.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import field
from itertools import chain, combinations, permutations

import numpy as np

from graphkin import construction as kinds
from graphkin import planning, running
from graphkin.base import geometry
from graphkin.base.boxes import off_lines
from graphkin.base.lines import off_stretch
from graphkin.base.value import frozen
from graphkin.construction import LETTER, Construction, Plane
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities.reading import quietly
from graphkin.submissions.numbers import plain
from graphkin.submissions.picture import Dot, PagePicture, PictureText, lines_about
from graphkin.submissions.questions import Questions

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


def find_letters(
    picture: PagePicture, polygons: Sequence[PaperPolygon], others: Collection[str] = (), names: Sequence[str] = ()
) -> tuple[dict[tuple[Plane, str], complex], tuple[str, ...]]:
    """The place of each letter of each polygon, by plane and the construction's letter; and letters whose place is not
    clear.

    others  letters of something else: the points of the mechanism
    names   letters of the dots in the file's order, instead of those that stand beside them
    """
    spelled = {name: key for name, key in spellings(polygons).items() if name not in others}
    sure = by_name(picture.dots, names, spelled)
    written = texts_of(picture.texts, spelled)
    points, doubtful = dict(sure), []
    for polygon in polygons:
        own = {key: texts for key, texts in written.items() if key[0] == polygon.plane and key not in sure}
        choices = {key[1]: _candidates(picture, texts) for key, texts in own.items()}
        fixed = {letter: place for (plane, letter), place in sure.items() if plane == polygon.plane}
        choices = _own_figure(choices, fixed, polygon, picture)
        for letter, place in _settled(_Arranged({k: v for k, v in choices.items() if v}, fixed, polygon, picture)):
            if place is None:
                doubtful.append(letter)
            else:
                points[polygon.plane, letter] = place
    return points, tuple(doubtful)


def _own_figure(
    choices: dict[str, list[Place]], fixed: Mapping[str, complex], polygon: PaperPolygon, picture: PagePicture
) -> dict[str, list[Place]]:
    """The choices that hang together with the pole, for letters that have such; further letters by looser spellings."""
    pole = next(iter(polygon.letters))
    places = [fixed[pole]] if pole in fixed else [place for _, place in choices.get(pole, ())[:1]]
    lines = lines_about(places[0], picture.lines) if places else ()
    if not lines:
        return choices
    ends = np.array(lines)

    def here(some: Sequence[Place]) -> list[Place]:
        return [one for one in some if np.min(abs(off_lines(one[1], ends[:, 0], ends[:, 1]))) < _SAME]

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
    near = [line for line in picture.lines if off_stretch(middle, *line) < reach][:_LINES_NEAR]
    for one, other in combinations(near, 2):
        a, b = one[1] - one[0], other[1] - other[0]
        turn = (a.conjugate() * b).imag
        if abs(turn) <= 0.02 * abs(a) * abs(b):
            continue
        along = ((other[0] - one[0]).conjugate() * b).imag / turn
        place, slack = one[0] + along * a, _SAME / abs(a)
        if -slack <= along <= 1 + slack and off_stretch(place, *other) <= _SAME and text.distance(place) <= _REACH:
            yield place


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
            passing = (k for k, line in enumerate(self.picture.lines) if off_stretch(place, *line) < _SAME)
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


# --- the polygons of a problem, and how their letters are spelled -----------------------------------------------------

@frozen
class PolygonVector:
    """An arrow of a polygon: the question that its size answers ("" for none), tail and head by their letters."""

    question: str
    tail: str
    head: str


@frozen
class PaperPolygon:
    """One plane as it is drawn on paper.

    letters  by letter those that mean the same point: of the pole also the fixed points', that sit on it
    vectors  all arrows between letters
    known    vectors that are laid off from what is given alone, with their values [m/s, m/s^2], the first first
    right    where each letter belongs [m, m/s, m/s^2]
    """

    plane: Plane
    letters: Mapping[str, tuple[str, ...]]
    vectors: tuple[PolygonVector, ...]
    known: tuple[tuple[PolygonVector, complex], ...]
    right: Mapping[str, complex] = field(default_factory=dict)


def polygons(mechanism: Mechanism, questions: Questions) -> tuple[PaperPolygon, ...]:
    """Of velocities and of accelerations. Raises what planning raises."""
    method = planning.plan(mechanism)
    plot = running.replay_all(method)
    driven = {driver.link for driver in mechanism.drivers if driver.from_link == FRAME and driver.kind != "slide"}
    polygons = []
    for construction in (method.velocity, method.acceleration):
        values = plot.points(construction.plane)
        # the pole and the fixed points that sit on it; another point may be the first to be drawn
        given = (step for step in construction.steps if isinstance(step, kinds.Given))
        fixed = [name for step in given if step.point == construction.pole for name in step.also]
        on_pole = dict.fromkeys([construction.pole, *fixed])
        prime = "'" if construction.plane == "acceleration" else ""
        names = [name for name in construction.nodes if name not in on_pole and name[0].isalpha()]
        pole = dict.fromkeys([construction.pole, *(letter + prime for letter in "poq"), *on_pole])
        letters = {construction.pole: tuple(name for name in pole if name not in names)}
        letters |= {name: tuple(dict.fromkeys((name, name.rstrip("'") + prime))) for name in names}
        vectors = tuple(_vectors(construction, on_pole, questions))
        known = []  # laid off from the givens alone: motions of driven links, and driven sliding
        by_ends = {(vector.tail, vector.head): vector for vector in vectors}
        for step in (step for step in construction.steps if isinstance(step, kinds.LayOff)):
            size, ends = step.term.size, (step.start, step.tip)
            of_driven = isinstance(size, kinds.Turning | kinds.Normal | kinds.Tangential) and size.link in driven
            if of_driven or isinstance(size, kinds.Driven | kinds.Relative):
                vector = by_ends.get(ends, PolygonVector("", *ends))
                if vector.tail in values and vector.head in values:
                    known.append((vector, geometry.place(values[vector.head]) - geometry.place(values[vector.tail])))
        right = {letter: geometry.place(values[letter]) for letter in letters if letter in values}
        polygons.append(PaperPolygon(construction.plane, letters, vectors, tuple(known), right))
    return tuple(polygons)


def _vectors(construction: Construction, on_pole: Collection[str], questions: Questions) -> Iterator[PolygonVector]:
    """Those of the equations, then the absolute motions that are not among them."""

    def question(text: str) -> str:
        # of the mechanism itself: what follows a comma is no unit
        read = questions.read(text) if quietly(questions.mechanism, text) is not None else None
        return read[0] if read is not None else ""

    letter, drawn = LETTER[construction.plane], set[tuple[str, str]]()
    for term in construction.vectors().values():
        tail = construction.pole if term.tail in on_pole else term.tail
        drawn.add((tail, term.head))
        comma = "," if "@" in term.of + term.seen_from and term.seen_from else ""
        word = f"{letter}_{term.part}" if term.part else letter
        yield PolygonVector("" if term.over else question(f"{word} {term.of}{comma}{term.seen_from}"), tail, term.head)
    for name, node in construction.nodes.items():
        if node.site is not None and name not in on_pole and (construction.pole, name) not in drawn:
            yield PolygonVector(question(f"{letter} {node.of}"), construction.pole, name)


def texts_of(
    texts: Sequence[PictureText], spelled: Mapping[str, tuple[Plane, str]]
) -> dict[tuple[Plane, str], list[PictureText]]:
    """The texts of each letter; those with the letter itself where there are any, else those spelled otherwise."""
    exact: dict[tuple[Plane, str], list[PictureText]] = {}
    other: dict[tuple[Plane, str], list[PictureText]] = {}
    for text in texts:
        pieces = pieces_of(text.text)
        for key in _keys(text.text, spelled):
            (exact if key[1] in pieces else other).setdefault(key, []).append(text)
    return other | exact


def spellings(polygons: Sequence[PaperPolygon]) -> dict[str, tuple[Plane, str]]:
    """By every spelling the point it means. One without its prime is the acceleration's where no other is so called.
    One with a capital letter is a polygon's where a number or a prime stands with it. `n'` is n3' or n_rod' where there
    is one n in this polygon."""
    exact: dict[str, tuple[Plane, str]] = {}
    more: dict[str, tuple[Plane, str]] = {}
    for polygon in polygons:
        for letter, alike in polygon.letters.items():
            exact.setdefault(letter, (polygon.plane, letter))
            for name in alike:
                more.setdefault(name, (polygon.plane, letter))
    for polygon in polygons:
        unnumbered: dict[str, list[str]] = {}
        for letter, alike in polygon.letters.items():
            for name in alike:
                more.setdefault(name.replace("'", ""), (polygon.plane, letter))
            if (numbered := re.fullmatch(r"([nk])(?:[0-9]+|_[^']+)('+)", letter)) is not None:
                unnumbered.setdefault("".join(numbered.groups()), []).append(letter)
        for name, letters in unnumbered.items():
            if len(letters) == 1:
                more.setdefault(name, (polygon.plane, letters[0]))
    keys = more | exact
    large = {name[0].upper() + name[1:]: key for name, key in keys.items() if len(name) > 1 or name in ("p", "o")}
    every = large | keys
    # subscripts are read without their mark; of numbers only words stay apart so: n3_1 is not n31
    return {re.sub(r"_(?=[^\W\d])", "", name): key for name, key in every.items()} | every


def _keys(text: str, spelled: Mapping[str, tuple[Plane, str]]) -> list[tuple[Plane, str]]:
    """The points that a text letters: `b₃`, `b_{3}'`, `p, a, d`, `p′(a′, d′)`; none where it says anything else."""
    pieces = (re.sub(r"^([A-Za-z]+)('+)(\w+)$", r"\1\3\2", piece.replace('"', "''")) for piece in pieces_of(text))
    keys = [spelled.get(piece) for piece in pieces]
    return [key for key in dict.fromkeys(keys) if key is not None] if all(keys) else []


def pieces_of(text: str) -> list[str]:
    """The letters of a text, without marks of subscripts and powers."""
    if len(text) > 60:
        return []
    bare = re.sub(r"[_{}$\\^ ]", "", plain(re.sub(r"[,;/()、]|\s{2,}", " , ", text)))
    return [piece for piece in bare.split(",") if piece]


def by_name(
    dots: Sequence[Dot], names: Sequence[str], spelled: Mapping[str, tuple[Plane, str]]
) -> dict[tuple[Plane, str], complex]:
    """Dots whose name the file says; a name at two places is none."""
    places: dict[tuple[Plane, str], set[complex]] = {}
    for k, dot in enumerate(dots):
        name = names[k] if k < len(names) else dot.name
        for key in _keys(name, spelled) if name else ():
            if dot.plane in (None, key[0]):
                places.setdefault(key, set()).add(dot.place)
    return {key: next(iter(several)) for key, several in places.items() if len(several) == 1}


def loosely(letter: str) -> str:
    """However large it is written, and without its prime."""
    return letter.lower().rstrip("'")
