"""What letters mean that are written in a drawing: `b₃`, `b_{3}'`, `p′(a′, d′)`, and looser spellings of them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from graphkin.construction import Plane
from graphkin.submissions.picture import Dot, PictureText
from graphkin.submissions.polygons import PaperPolygon
from graphkin.submissions.spelling import plain


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
    """By every spelling the point it means.

    One without its prime is the acceleration's where no other is so called. One with a capital letter is a polygon's
    where a number or a prime stands with it.
    """
    found: dict[str, tuple[Plane, str]] = {}
    more: dict[str, tuple[Plane, str]] = {}
    for polygon in polygons:
        for letter, alike in polygon.letters.items():
            found.setdefault(letter, (polygon.plane, letter))
            for name in alike:
                more.setdefault(name, (polygon.plane, letter))
    for polygon in polygons:
        for letter, alike in polygon.letters.items():
            for name in alike:
                more.setdefault(name.replace("'", ""), (polygon.plane, letter))
        for short, letter in _without_numbers(polygon).items():
            more.setdefault(short, (polygon.plane, letter))
    found = more | found
    large = {name[0].upper() + name[1:]: key for name, key in found.items() if len(name) > 1 or name in ("p", "o")}
    every = large | found
    # subscripts are read without their mark; of numbers only words stay apart so: n3_1 is not n31
    return {re.sub(r"_(?=[^\W\d])", "", name): key for name, key in every.items()} | every


def _without_numbers(polygon: PaperPolygon) -> dict[str, str]:
    """`n'` for `n3'` and for `n_rod'`, where there is one n in this polygon."""
    short: dict[str, list[str]] = {}
    for letter in polygon.letters:
        if (numbered := re.fullmatch(r"([nk])(?:[0-9]+|_[^']+)('+)", letter)) is not None:
            short.setdefault("".join(numbered.groups()), []).append(letter)
    return {name: letters[0] for name, letters in short.items() if len(letters) == 1}


def _keys(text: str, spelled: Mapping[str, tuple[Plane, str]]) -> list[tuple[Plane, str]]:
    """What a text letters: `b₃`, `b_{3}'`, `p, a, d`, `p′(a′, d′)`; nothing where it says anything else."""
    pieces = pieces_of(text)
    keys = [_key(piece, spelled) for piece in pieces]
    return [key for key in dict.fromkeys(keys) if key is not None] if keys and all(keys) else []


def pieces_of(text: str) -> list[str]:
    if len(text) > 60:
        return []
    made = re.sub(r"[_{}$\\^ ]", "", plain(re.sub(r"[,;/()、]|\s{2,}", " , ", text)))
    return [piece for piece in made.split(",") if piece]


def _key(piece: str, spelled: Mapping[str, tuple[Plane, str]]) -> tuple[Plane, str] | None:
    """With the primes last, which GeoGebra has before a number: `b'_{3}`."""
    return spelled.get(re.sub(r"^([A-Za-z]+)('+)(\w+)$", r"\1\3\2", piece.replace('"', "''")))


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
    return {key: next(iter(found)) for key, found in places.items() if len(found) == 1}


def loosely(letter: str) -> str:
    """However large it is written, and without its prime."""
    return letter.lower().rstrip("'")
