"""Directions of links, measured on a drawn mechanism.

A letter that is taken for another point's would be a wrong answer of ours: a direction counts only where the link comes
out as long as it is given, by the scale that the drawn lengths have together.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from itertools import combinations

import numpy as np

from graphkin.errors import Where
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import Rotation
from graphkin.submissions.letters import find_letters
from graphkin.submissions.picture import PagePicture
from graphkin.submissions.polygons import PaperPolygon, PolygonVector
from graphkin.submissions.questions import Questions
from graphkin.submissions.submission import HandedValue, Limits

_OFF = 0.03
"""A drawn length that is off by a larger part is of other points."""
_LENGTHS, _AGREE = 3, 2 / 3
"""So many lengths must agree, and more than this part of all: with two letters exchanged half of them may."""

Pair = tuple[str, str]


def directions(picture: PagePicture, questions: Questions, where: Where, limits: Limits) -> dict[str, HandedValue]:
    """theta of the links whose direction the problem asks for, as drawn [rad]."""
    mechanism = questions.mechanism
    wanted = dict(_wanted(mechanism, questions))
    if not wanted:
        return {}
    found = find_letters(picture, [_figure(mechanism)]).points
    places = {name: place for (_, name), place in found.items()}
    lengths = {pair: abs(places[pair[1]] - places[pair[0]]) / size for pair, size in _lengths(mechanism)
               if pair[0] in places and pair[1] in places}  # fmt: skip
    if len(lengths) < _LENGTHS:
        return {}
    scale = float(np.median(list(lengths.values())))
    good = {pair for pair, each in lengths.items() if abs(each - scale) <= _OFF * scale}
    if len(good) < _LENGTHS or len(good) <= _AGREE * len(lengths):
        return {}
    turned = _turned(mechanism, places, good) if limits.turned else 0.0
    return {
        question: HandedValue("", cmath.phase(places[head] - places[tail]) - turned, where=where,
                        ends=(places[tail], places[head]))
        for question, (tail, head) in wanted.items() if good & {(tail, head), (head, tail)}
    }  # fmt: skip


def _wanted(mechanism: Mechanism, questions: Questions) -> Iterator[tuple[str, Pair]]:
    """Questions for a direction, with the two points it runs through."""
    for text in mechanism.ask:
        read = questions.read(text)
        if read is not None and isinstance(read[1], Rotation) and read[1].word == "theta":
            axis = mechanism.links[read[1].link].axis
            if axis is not None and set(axis) <= set(mechanism.points):
                yield read[0], axis


def _figure(mechanism: Mechanism) -> PaperPolygon:
    """The mechanism as a figure with letters; fixed points first, for what hangs together with them is meant."""
    letters = {name: (name,) for name in mechanism.points}
    return PaperPolygon("position", letters, tuple(PolygonVector("", *pair) for pair, _ in _lengths(mechanism)), ())


def _lengths(mechanism: Mechanism) -> Iterator[tuple[Pair, float]]:
    """Every two points of a link, and how far apart they are [m]."""
    for link in mechanism.links.values():
        for pair in combinations(mechanism.named(link.name), 2):
            if (size := abs(link.arm(*pair))) > 0:
                yield pair, size


def _turned(mechanism: Mechanism, places: dict[str, complex], good: set[Pair]) -> float:
    """By how much the page is turned, by two fixed points [rad]."""
    for pair in combinations(mechanism.named(FRAME), 2):
        if pair in good:
            return cmath.phase((places[pair[1]] - places[pair[0]]) / mechanism.links[FRAME].arm(*pair))
    return 0.0
