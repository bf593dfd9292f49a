"""Which point of a drawing bears which letter.

A letter stands beside its point, and points that a vector joins are joined by a line: among the line ends, dots and
crossings near a letter the one counts that is nearest, a drawn vector making up for some millimetres.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from graphkin.construction import Plane
from graphkin.submissions.picture import Dot, Picture, Text
from graphkin.submissions.polygons import Polygon
from graphkin.submissions.spelling import plain
from graphkin.value import frozen

__all__ = ["Found", "find_letters"]

_REACH = 10.0
"""A letter belongs to no point farther from it [mm]."""
_JOINED = 4.0
"""What a vector that is drawn makes up for [mm]."""
_SAME = 0.2
"""Closer than this, marks of one point are one [mm]."""
_CLEAR = 0.5
"""By so much the best point must be better than the next [mm]."""
_CANDIDATES = 12
_LINES_NEAR = 40
_ROUNDS = 8

Place = tuple[float, complex]
"""How far a candidate is from its letter, and where it is [mm]."""


@frozen
class Found:
    """Where the letters are, by plane and the construction's letter; and those of which it is not clear."""

    points: Mapping[tuple[Plane, str], complex]
    doubtful: tuple[str, ...]


def find_letters(picture: Picture, polygons: Sequence[Polygon], names: Sequence[str] = ()) -> Found:
    """`names`: letters of the dots in the file's order, instead of those that stand beside them."""
    spelled = _spelled(polygons)
    sure = _by_name(picture.dots, names, spelled)
    written: dict[tuple[Plane, str], list[Text]] = {}
    for text in picture.texts:
        for key in _keys(text.text, spelled):
            written.setdefault(key, []).append(text)
    points, doubtful = dict(sure), []
    for polygon in polygons:
        wanted = {key: texts for key, texts in written.items() if key[0] == polygon.plane and key not in sure}
        choices = {key[1]: _candidates(picture, texts) for key, texts in wanted.items()}
        fixed = {letter: place for (plane, letter), place in sure.items() if plane == polygon.plane}
        chosen = _settled({k: v for k, v in choices.items() if v}, fixed, polygon, picture)
        for letter, place in chosen.items():
            if place is None:
                doubtful.append(letter)
            else:
                points[polygon.plane, letter] = place
    return Found(points, tuple(doubtful))


# --- what letters are written -----------------------------------------------------------------


def _spelled(polygons: Sequence[Polygon]) -> dict[str, tuple[Plane, str]]:
    """By every spelling the point it means; one without its prime is the acceleration's where no other is so called."""
    found: dict[str, tuple[Plane, str]] = {}
    more: dict[str, tuple[Plane, str]] = {}
    for polygon in polygons:
        for letter, alike in polygon.letters.items():
            for name in alike:
                found.setdefault(name, (polygon.plane, letter))
                more.setdefault(name.replace("'", ""), (polygon.plane, letter))
        for short, letter in _without_numbers(polygon).items():
            more.setdefault(short, (polygon.plane, letter))
    return more | found


def _without_numbers(polygon: Polygon) -> dict[str, str]:
    """`n'` for `n3'`, where there is one n in this polygon."""
    short: dict[str, list[str]] = {}
    for letter in polygon.letters:
        if re.fullmatch(r"[nk][0-9]+'+", letter):
            short.setdefault(re.sub("[0-9]", "", letter), []).append(letter)
    return {name: letters[0] for name, letters in short.items() if len(letters) == 1}


def _keys(text: str, spelled: Mapping[str, tuple[Plane, str]]) -> list[tuple[Plane, str]]:
    """What a text letters: `b₃`, `b_{3}'`, `p, a, d`, `p′(a′, d′)`; nothing where it says anything else."""
    if len(text) > 60:
        return []
    made = re.sub(r"[_{}$\\^ ]", "", plain(re.sub(r"[,;/()、]|\s{2,}", " , ", text)))
    pieces = [piece for piece in made.split(",") if piece]
    keys = [_key(piece, spelled) for piece in pieces]
    return [key for key in dict.fromkeys(keys) if key is not None] if keys and all(keys) else []


def _key(piece: str, spelled: Mapping[str, tuple[Plane, str]]) -> tuple[Plane, str] | None:
    """A capital letter is a point of the mechanism, unless a number or a prime makes a polygon's of it."""
    piece = piece.replace('"', "''")
    if piece in spelled:
        return spelled[piece]
    small = piece[:1].lower() + piece[1:]
    return spelled.get(small) if small != piece and (len(piece) > 1 or small in ("p", "o")) else None


def _by_name(
    dots: Sequence[Dot], names: Sequence[str], spelled: Mapping[str, tuple[Plane, str]]
) -> dict[tuple[Plane, str], complex]:
    """Dots whose name the file says; a name at two places is none."""
    places: dict[tuple[Plane, str], set[complex]] = {}
    for k, dot in enumerate(dots):
        name = names[k] if k < len(names) else dot.name
        for key in _keys(name, spelled) if name else ():
            if dot.plane in (None, key[0]):
                places.setdefault(key, set()).add(dot.place)
    return {key: next(iter(found)) for key, found in places.items() if len(found) == 1}


# --- where they belong ------------------------------------------------------------------------


def _candidates(picture: Picture, texts: Sequence[Text]) -> list[Place]:
    """Points near any of a letter's texts, the nearest first."""
    found: list[Place] = []
    for text in texts[:8]:
        near = [(text.distance(dot.place), dot.place) for dot in picture.dots]
        near += [(text.distance(end), end) for line in picture.lines for end in line]
        near += [(text.distance(place), place) for place in _crossings(picture, text)]
        for distance, place in sorted((pair for pair in near if pair[0] <= _REACH), key=lambda pair: pair[0]):
            if all(abs(place - other) > _SAME for _, other in found):
                found.append((distance, place))
            if len(found) >= _CANDIDATES:
                break
    return sorted(found, key=lambda pair: pair[0])


def _crossings(picture: Picture, text: Text) -> Iterator[complex]:
    """Where lines cross near a text: direction lines are drawn beyond their points."""
    middle = text.corner + text.right * text.width / 2
    reach = _REACH + text.width / 2 + text.above
    near = [line for line in picture.lines if _off(middle, *line) < reach][:_LINES_NEAR]
    for one, other in combinations(near, 2):
        place = _crossing(one, other)
        if place is not None and text.distance(place) <= _REACH:
            yield place


def _crossing(one: tuple[complex, complex], other: tuple[complex, complex]) -> complex | None:
    a, b = one[1] - one[0], other[1] - other[0]
    turn = (a.conjugate() * b).imag
    if abs(turn) <= 0.02 * abs(a) * abs(b):
        return None
    along = ((other[0] - one[0]).conjugate() * b).imag / turn
    place = one[0] + along * a
    slack = _SAME / abs(a)
    return place if -slack <= along <= 1 + slack and _off(place, *other) <= _SAME else None


def _off(place: complex, start: complex, end: complex) -> float:
    """The distance of a place from a piece of a line [mm]."""
    along = end - start
    share = ((place - start) * along.conjugate()).real / abs(along) ** 2 if along else 0.0
    return abs(place - start - min(1.0, max(0.0, share)) * along)


def _settled(
    choices: Mapping[str, list[Place]], fixed: Mapping[str, complex], polygon: Polygon, picture: Picture
) -> dict[str, complex | None]:
    """The best point of each letter, the others' standing where they do; None where two are equally good."""
    neighbours: dict[str, set[str]] = {}
    for vector in polygon.vectors:
        neighbours.setdefault(vector.tail, set()).add(vector.head)
        neighbours.setdefault(vector.head, set()).add(vector.tail)
    chosen = {letter: places[0][1] for letter, places in choices.items()} | dict(fixed)

    def costs(letter: str) -> list[Place]:
        around = [chosen[name] for name in neighbours.get(letter, ()) if name in chosen]
        others = [place for name, place in chosen.items() if name != letter]
        return sorted(
            (
                (
                    distance
                    - _JOINED * sum(_joined(place, other, picture) for other in around)
                    + _JOINED * any(abs(place - other) < _SAME for other in others),
                    place,
                )
                for distance, place in choices[letter]
            ),
            key=lambda pair: pair[0],
        )

    for _ in range(_ROUNDS):
        before = dict(chosen)
        for letter in choices:
            chosen[letter] = costs(letter)[0][1]
        if chosen == before:
            break
    found: dict[str, complex | None] = {}
    for letter in choices:
        ranked = costs(letter)
        clear = len(ranked) == 1 or ranked[1][0] - ranked[0][0] > _CLEAR
        found[letter] = ranked[0][1] if clear else None
    return found


def _joined(one: complex, other: complex, picture: Picture) -> bool:
    """Whether a line runs from the one to the other."""
    if abs(one - other) < _SAME:
        return False
    return any(_off(one, *line) < _SAME and _off(other, *line) < _SAME for line in picture.lines)
