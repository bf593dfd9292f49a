"""Letters in running text: `A`, `p`, `x` and `AB` of a sentence in italics, as in formulas."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from functools import lru_cache

from graphkin.sheet.lettering import Label, Run, formula, points_label

_FIGURE = r"[\d\ue100-\uf8ff]"  # or the letter that stands for figures that are noted
_UNIT = rf"(?<!{_FIGURE} )(?<!{_FIGURE})(?<![/(（])"  # before a letter that is no unit
_NODE = r"a(?=[,.;:)、，。；）]|$| ?[⊥∥\u4e00-\u9fff]| lies| and [a-z]′*[ ,.]| the line)"  # `a` that is no article
_SUBJECT = r"A(?! [a-z])|A(?= (?:and|is|lies|has|moves|stays|as|at|to|on|in|of|or|from|about|with)\b)"
_LETTER = re.compile(
    rf"(?<![A-Za-z'’.])(?:{_UNIT}[ms](?!/)|(?<!{_FIGURE})[b-ln-rt-zB-ZΑ-Ωα-ω]|{_NODE}|(?<=[^.] )A|{_SUBJECT})′*"
    r"(?![A-Za-z0-9'’-]|/min|\.[A-Za-z]|[\u5f62\u578b])"
)
_STRETCH = re.compile(r"(?<![A-Za-z0-9])[a-z]\d+[a-z]\d*′*(?![A-Za-z0-9])")
_NODES = re.compile(rf"(?<![A-Za-z0-9'’\-])(?<!{_FIGURE} )[a-z]{{2}}(?![A-Za-z0-9'’\-])")
_WORD = re.compile("ad|ah|am|an|as|at|be|by|do|go|he|if|in|is|it|me|mm|my|no|of|oh|on|or|so|to|up|us|we")
_CAPITALS = re.compile(r"(?<![A-Za-z])(?:[A-Z][0-9]*′*){2,}(?![A-Za-z])")


def lettered(text: str, points: Collection[str]) -> Label:
    """Words with their formulas; what letters stand in them is in italics, also points one after another."""
    return _lettered(text, tuple(points))


@lru_cache(4096)
def _lettered(text: str, points: tuple[str, ...]) -> Label:
    runs: list[Run] = []
    for run in formula(text):
        runs += [run] if run.italic or run.place != "base" else _in_words(run.text, points)
    return tuple(runs)


def _in_words(text: str, points: Collection[str]) -> Iterator[Run]:
    at = 0
    matches = [*_LETTER.finditer(text), *_STRETCH.finditer(text)]
    matches += (match for match in _CAPITALS.finditer(text) if _joins(match[0], points))
    matches += (match for match in _NODES.finditer(text) if _is_stretch(match[0], points))
    for match in sorted(matches, key=lambda match: match.start()):
        if match.start() >= at:
            yield from [Run(text[at : match.start()])] if match.start() > at else []
            yield from points_label(match[0])
            at = match.end()
    yield from [Run(text[at:])] if at < len(text) else []


def _joins(letters: str, points: Collection[str]) -> bool:
    """True of names of points one after another."""
    return all(name.replace("′", "'") in points for name in re.findall(r"[A-Z][0-9]*′*", letters))


def _is_stretch(letters: str, points: Collection[str]) -> bool:
    """True of two points of a polygon, of which the first may be its pole, unless they are a word."""
    return not _WORD.fullmatch(letters) and all(one.upper() in points or one == "p" for one in letters)
