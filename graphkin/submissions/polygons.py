"""The polygons of a problem: letters and their spellings, the vectors between them, those known from the start.

Letters are written in drawings as `b₃`, `b_{3}'`, `p′(a′, d′)`, and in looser spellings.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import field

from graphkin import construction as kinds
from graphkin import planning, running
from graphkin.base.geometry import place
from graphkin.base.value import frozen
from graphkin.construction import LETTER, Construction, Plane
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.submissions.numbers import plain
from graphkin.submissions.picture import Dot, PictureText
from graphkin.submissions.questions import Questions


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
                    known.append((vector, place(values[vector.head]) - place(values[vector.tail])))
        right = {letter: place(values[letter]) for letter in letters if letter in values}
        polygons.append(PaperPolygon(construction.plane, letters, vectors, tuple(known), right))
    return tuple(polygons)


def _vectors(construction: Construction, on_pole: Collection[str], questions: Questions) -> Iterator[PolygonVector]:
    """Those of the equations, then the absolute motions that are not among them."""

    def question(text: str) -> str:
        read = questions.read(text)
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
    """The points that a text letters: `b₃`, `b_{3}'`, `p, a, d`, `p′(a′, d′)`; none where it says anything else. Primes
    are read last, which GeoGebra has before a number: `b'_{3}`."""
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
