"""Drawings."""

from __future__ import annotations

import cmath
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from pathlib import PurePosixPath

import numpy as np

from graphkin.construction import Plane
from graphkin.errors import GraphkinError, LetterTwice, NoLetters, NoScaleDrawn, Where
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import Rotation
from graphkin.submissions import numbers
from graphkin.submissions.answers import answers
from graphkin.submissions.documents import read_lines
from graphkin.submissions.letters import find_letters
from graphkin.submissions.picture import PagePicture
from graphkin.submissions.polygons import PaperPolygon, PolygonVector, polygons
from graphkin.submissions.questions import Questions
from graphkin.submissions.submission import HandedValue, Limits, MeasuredDrawing, ReadableProblem

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
    turned = _page_turn(mechanism, places, good) if limits.turned else 0.0
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


def _page_turn(mechanism: Mechanism, places: dict[str, complex], good: set[Pair]) -> float:
    """By how much the page is turned, by two fixed points [rad]."""
    for pair in combinations(mechanism.named(FRAME), 2):
        if pair in good:
            return cmath.phase((places[pair[1]] - places[pair[0]]) / mechanism.links[FRAME].arm(*pair))
    return 0.0


_SHORTEST = 1.0
"""A known vector shorter than this gives no scale [mm]."""
_KEYS: Mapping[Plane, str] = {"position": "mu_l", "velocity": "mu_v", "acceleration": "mu_a"}

_SEVERAL = re.compile(r"[,;，；]\s+(?=[^,;=，；]+=)")
"""Between `ω3 = 3.92 rad/s, α3 = 62 rad/s²`."""

Points = Mapping[tuple[Plane, str], complex]
Measured = tuple[dict[str, HandedValue], MeasuredDrawing, list[GraphkinError]]


def picture_of(name: str, content: bytes, where: Where, limits: Limits) -> PagePicture:
    """What is drawn in a file, by its suffix. Raises BrokenSubmission, TooMuch, WantsExtra."""
    from graphkin.submissions import dxf, geogebra, svg

    readers: Mapping[str, Callable[[bytes, Where, Limits], PagePicture]]
    readers = {".svg": svg.read_svg, ".ggb": geogebra.read_ggb, ".dxf": dxf.read_dxf}
    return readers[PurePosixPath(name).suffix.lower()](content, where, limits)


def measured(
    name: str,
    content: bytes,
    where: Where,
    asked: ReadableProblem,
    stated: Mapping[Plane, float],
    questions: Questions,
    limits: Limits,
) -> Measured:
    """The vectors of a drawing's polygons, and what else is written on it. Raises what `picture_of` does, NoLetters."""
    picture = picture_of(name, content, where, limits)
    shapes = polygons(asked.mechanism, questions)
    found = find_letters(picture, shapes, asked.mechanism.points, limits.names)
    told, written = _told(picture, where, questions, limits)
    known = {**numbers.stated_by(asked.mechanism), **_calibrated(found.points, shapes)}
    known |= {**picture.scales, **written, **stated}
    turned = _turned(found.points, shapes) if limits.turned else {}
    values = _named(picture, known, turned, questions, where)
    values |= _vectors(found.points, shapes, known, turned, where)
    values |= directions(picture, questions, where, limits)
    if not values and not told and not found.points:
        raise NoLetters(where, tuple(letter for shape in shapes for letter in shape.letters))
    notes: list[GraphkinError] = [LetterTwice(where, letter) for letter in found.doubtful]
    drawn = {plane for plane, _ in found.points}
    notes += [NoScaleDrawn(where, plane, _KEYS[plane]) for plane in sorted(drawn) if plane not in known]
    own = {plane for plane in known if plane not in {**picture.scales, **written, **stated}}
    calibrated = tuple(sorted(own & set(_calibrated(found.points, shapes))))
    return _with_told(values, told), MeasuredDrawing(found.points, known, calibrated, turned, where), notes


def _with_told(values: dict[str, HandedValue], told: Mapping[str, HandedValue]) -> dict[str, HandedValue]:
    """What is written beside what is measured: the written value, with the drawn direction."""
    for question, given in told.items():
        drawn = values.get(question)
        values[question] = given if drawn is None else replace(given, vector=drawn.vector, ends=drawn.ends)
    return values


def _told(
    picture: PagePicture, where: Where, questions: Questions, limits: Limits
) -> tuple[dict[str, HandedValue], Mapping[Plane, float]]:
    """Answers and scales that are written on a drawing, as `ω3 = 3.92 rad/s`; its other texts are none, and what is
    given is no answer."""
    texts = (text.text.replace("\n", " ") for text in picture.texts if "=" in text.text)
    lines = "\n".join(line for text in texts for line in _SEVERAL.split(text))
    try:
        found = answers(read_lines(lines, where, limits).entries, questions, limits)
    except GraphkinError:
        return {}, {}
    words = ("theta", "omega", "alpha")
    given_by_problem = {f"{word} {driver.link}" for driver in questions.mechanism.drivers for word in words}
    told = {
        question: given for question, given in found.values.items()
        if given.value is not None and question not in given_by_problem
    }  # fmt: skip
    return told, found.scales


# --- scale and turn ---------------------------------------------------------------------------


def _calibrated(points: Points, shapes: Sequence[PaperPolygon]) -> dict[Plane, float]:
    """SI per mm by the first known vector that is drawn long enough."""
    found: dict[Plane, float] = {}
    for shape in shapes:
        for drawn, value in _first_known(points, shape)[:1]:
            found[shape.plane] = abs(value) / abs(drawn)
    return found


def _turned(points: Points, shapes: Sequence[PaperPolygon]) -> dict[Plane, float]:
    """By how much a polygon stands turned, by the same vector [rad]."""
    return {
        shape.plane: cmath.phase(drawn / value) for shape in shapes for drawn, value in _first_known(points, shape)[:1]
    }


def _first_known(points: Points, shape: PaperPolygon) -> list[tuple[complex, complex]]:
    """As drawn [mm] and as it is [SI]."""
    found = []
    for vector, value in shape.known:
        ends = [points.get((shape.plane, letter)) for letter in (vector.tail, vector.head)]
        if ends[0] is not None and ends[1] is not None and abs(ends[1] - ends[0]) >= _SHORTEST and value:
            found.append((ends[1] - ends[0], value))
    return found


# --- vectors ----------------------------------------------------------------------------------


def _vectors(
    points: Points,
    shapes: Sequence[PaperPolygon],
    known: Mapping[Plane, float],
    turned: Mapping[Plane, float],
    where: Where,
) -> dict[str, HandedValue]:
    """Every vector between two letters that are found, where its plane has a scale."""
    found: dict[str, HandedValue] = {}
    for shape in shapes:
        for vector in shape.vectors:
            tail, head = (points.get((shape.plane, letter)) for letter in (vector.tail, vector.head))
            if vector.question and tail is not None and head is not None and shape.plane in known:
                found.setdefault(vector.question, _given(tail, head, shape.plane, known, turned, where))
    return found


def _given(
    tail: complex,
    head: complex,
    plane: Plane,
    known: Mapping[Plane, float],
    turned: Mapping[Plane, float],
    where: Where,
) -> HandedValue:
    vector = (head - tail) * known[plane] * cmath.rect(1, -turned.get(plane, 0.0))
    return HandedValue("", abs(vector), where=where, vector=vector, paper_mm=abs(head - tail), ends=(tail, head))


def _named(
    picture: PagePicture,
    known: Mapping[Plane, float],
    turned: Mapping[Plane, float],
    questions: Questions,
    where: Where,
) -> dict[str, HandedValue]:
    """Arrows that the file itself names after a quantity: `v_B3B2`."""
    found: dict[str, HandedValue] = {}
    for arrow in picture.arrows:
        read = questions.read(arrow.name) if arrow.name else None
        plane = numbers.plane_of(read[1].unit) if read is not None else None
        if read is not None and plane is not None and plane in known and not read[2]:
            found.setdefault(read[0], _given(arrow.tail, arrow.head, plane, known, turned, where))
    return found
