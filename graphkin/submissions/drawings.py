"""A drawing measured: its letters found, its scales known, the size and the direction of every vector taken.

Directions of links are measured on a drawn mechanism. A letter that is taken for another point's would be a wrong
answer of ours: a direction counts only where the link comes out as long as it is given, by the scale that the drawn
lengths have together.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from pathlib import PurePosixPath

import numpy as np

from graphkin import planning, running
from graphkin.base.geometry import place
from graphkin.construction import Plane
from graphkin.errors import GraphkinError, LetterTwice, NoLetters, NoScaleDrawn, OwnSheet, TurnedPage, Where
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import Rotation
from graphkin.submissions import numbers
from graphkin.submissions.answers import answers
from graphkin.submissions.documents import read_lines
from graphkin.submissions.letters import PaperPolygon, PolygonVector, find_letters, polygons
from graphkin.submissions.picture import PagePicture
from graphkin.submissions.questions import Questions
from graphkin.submissions.submission import HandedValue, Limits, MeasuredDrawing, ReadableProblem

_SHORTEST = 1.0  # a known vector shorter than this gives no scale [mm]
_KEYS: Mapping[Plane, str] = {"position": "mu_l", "velocity": "mu_v", "acceleration": "mu_a"}
_SEVERAL = re.compile(r"[,;，；]\s+(?=[^,;=，；]+=)")  # between `ω3 = 3.92 rad/s, α3 = 62 rad/s²`
_OFF = 0.03  # a drawn length that is off by a larger part is of other points
_LENGTHS, _AGREE = 3, 2 / 3
"""So many lengths must agree, and more than this part of all: with two letters exchanged half of them may."""

Pair = tuple[str, str]


def picture_of(name: str, content: bytes, where: Where, limits: Limits) -> PagePicture:
    """The picture in a file, by its suffix. Raises BrokenSubmission, TooMuch, WantsExtra."""
    from graphkin.submissions import dxf, geogebra, svg

    readers: Mapping[str, Callable[[bytes, Where, Limits], PagePicture]]
    readers = {".svg": svg.read_svg, ".ggb": geogebra.read_ggb, ".dxf": dxf.read_dxf}
    return readers[PurePosixPath(name).suffix.lower()](content, where, limits)


def measured(
    name: str, content: bytes, where: Where, asked: ReadableProblem, stated: Mapping[Plane, float],
    questions: Questions, limits: Limits,
) -> tuple[dict[str, HandedValue], MeasuredDrawing, list[GraphkinError]]:  # fmt: skip
    """The vectors of a drawing's polygons, and what else is written on it. Raises what `picture_of` does, NoLetters."""
    picture = picture_of(name, content, where, limits)
    shapes = polygons(asked.mechanism, questions)
    letters, doubtful = find_letters(picture, shapes, asked.mechanism.points, limits.names)
    texts, written = _written_on(picture, where, questions, limits)
    first: dict[Plane, tuple[complex, complex]] = {}  # known and drawn long enough: as drawn [mm] and as it is [SI]
    for plane, vector, value in [(shape.plane, *known) for shape in shapes for known in shape.known]:
        tail, head = (letters.get((plane, letter)) for letter in (vector.tail, vector.head))
        if tail is not None and head is not None and abs(head - tail) >= _SHORTEST and value:
            first.setdefault(plane, (head - tail, value))
    calibrated = {plane: abs(value) / abs(drawn) for plane, (drawn, value) in first.items()}
    claimed = {**picture.scales, **written, **stated}
    scales = numbers.stated_by(asked.mechanism) | calibrated | claimed
    turned = {plane: cmath.phase(drawn / value) for plane, (drawn, value) in first.items()} if limits.turned else {}
    page = turned.get("acceleration", 0.0)  # a driver's own acceleration does not tell its sense
    if abs(cmath.phase(cmath.rect(1.0, turned.get("velocity", page) - page))) > math.pi - _STRAIGHT:
        turned["velocity"] = page  # half a turn of the velocities alone is the sense of a driver
    drawing = MeasuredDrawing(letters, scales, turned, where)
    values = drawn_values(_drawn(picture, drawing, shapes, questions))
    values |= directions(picture, questions, limits)
    if not values and not texts and not letters:
        raise NoLetters(where, tuple(letter for shape in shapes for letter in shape.letters))
    for question, text in texts.items():  # the written value, with the drawn direction
        drawn = values.get(question)
        values[question] = text if drawn is None else replace(text, vector=drawn.vector)
    notes: list[GraphkinError] = [LetterTwice(where, letter) for letter in doubtful]
    planes = sorted({plane for plane, _ in letters})
    notes += [NoScaleDrawn(where, plane, _KEYS[plane]) for plane in planes if plane not in scales]
    remarks = tuple(_page_remarks(picture, drawing, shapes, asked.mechanism))
    return values, replace(drawing, remarks=remarks), notes


def _written_on(
    picture: PagePicture, where: Where, questions: Questions, limits: Limits
) -> tuple[dict[str, HandedValue], Mapping[Plane, float]]:
    """Answers and scales that are written on a drawing, as `ω3 = 3.92 rad/s`; what the problem states is none."""
    texts = (text.text.replace("\n", " ") for text in picture.texts if "=" in text.text)
    lines = "\n".join(line for text in texts for line in _SEVERAL.split(text))
    try:
        written = answers(read_lines(lines, where, limits).entries, questions, limits)
    except GraphkinError:
        return {}, {}
    words = ("theta", "omega", "alpha")
    stated = {f"{word} {driver.link}" for driver in questions.mechanism.drivers for word in words}
    values = {name: value for name, value in written.values.items() if value.value is not None and name not in stated}
    return values, written.scales


def drawn_values(vectors: Mapping[str, complex]) -> dict[str, HandedValue]:
    """The measured values, by question, as they are handed in."""
    return {name: HandedValue("", abs(vector), vector=vector) for name, vector in vectors.items()}


def lettered_vectors(drawing: MeasuredDrawing, shapes: Sequence[PaperPolygon]) -> dict[str, complex]:
    """Vectors between two letters."""
    lettered: dict[str, complex] = {}
    for shape, vector in [(polygon, vector) for polygon in shapes for vector in polygon.vectors]:
        tail, head = (drawing.points.get((shape.plane, letter)) for letter in (vector.tail, vector.head))
        if vector.question and tail is not None and head is not None and shape.plane in drawing.scales:
            lettered.setdefault(vector.question, drawing.vector(head - tail, shape.plane))
    return lettered


def _drawn(
    picture: PagePicture, drawing: MeasuredDrawing, shapes: Sequence[PaperPolygon], questions: Questions
) -> dict[str, complex]:
    """Vectors between two letters, and arrows named after a quantity, `v_B3B2`; one drawn broken with its gap."""
    named, broken = dict[str, complex](), dict[str, complex]()
    for arrow in picture.arrows:
        read = questions.read(arrow.name) if arrow.name else None
        if read is not None and "," in arrow.name and "," not in read[0]:
            continue  # as seen from a point that no question names
        plane = numbers.PLANES.get(read[1].unit) if read is not None else None
        if read is not None and plane is not None and plane in drawing.scales and not read[2]:
            drawn = arrow.head - arrow.tail
            whole = drawn * (1 + arrow.left_out / (abs(drawn) or 1.0))
            (broken if arrow.left_out else named).setdefault(read[0], drawing.vector(whole, plane))
    return named | lettered_vectors(drawing, shapes) | broken


def directions(picture: PagePicture, questions: Questions, limits: Limits) -> dict[str, HandedValue]:
    """theta of the links whose direction the problem asks for, as drawn [rad]."""
    mechanism = questions.mechanism
    axes: dict[str, Pair] = {}  # the two points through which a direction that is asked for runs
    for read in map(questions.read, mechanism.ask):
        if read is not None and isinstance(read[1], Rotation) and read[1].word == "theta":
            axis = mechanism.links[read[1].link].axis
            if axis is not None and set(axis) <= set(mechanism.points):
                axes[read[0]] = axis
    if not axes:
        return {}
    places, good = _drawn_links(picture, mechanism)
    fixed = next((pair for pair in combinations(mechanism.named(FRAME), 2) if pair in good), None)
    turned = 0.0  # the angle by which the page is turned, by two fixed points [rad]
    if limits.turned and fixed is not None:
        turned = cmath.phase((places[fixed[1]] - places[fixed[0]]) / mechanism.links[FRAME].arm(*fixed))
    values = {}
    for question, (tail, head) in axes.items():
        if good & {(tail, head), (head, tail)}:
            values[question] = HandedValue("", cmath.phase(places[head] - places[tail]) - turned)
    return values


def _drawn_links(picture: PagePicture, mechanism: Mechanism) -> tuple[dict[str, complex], set[Pair]]:
    """The points of a drawn mechanism, and pairs of a link as far apart as given; none where too few are."""
    pairs = ((link, pair) for link in mechanism.links.values() for pair in combinations(mechanism.named(link.name), 2))
    sizes: dict[Pair, float] = {pair: size for link, pair in pairs if (size := abs(link.arm(*pair))) > 0}  # [m]
    names = {name: (name,) for name in mechanism.points}
    figure = PaperPolygon("position", names, tuple(PolygonVector("", *pair) for pair in sizes), ())
    places = {name: place for (_, name), place in find_letters(picture, [figure])[0].items()}
    lengths = {(one, other): abs(places[other] - places[one]) / size for (one, other), size in sizes.items()
               if one in places and other in places}  # fmt: skip
    scale = float(np.median(list(lengths.values()))) if lengths else 0.0
    good = {pair for pair, each in lengths.items() if abs(each - scale) <= _OFF * scale}
    enough = len(good) >= _LENGTHS and len(good) > _AGREE * len(lengths)
    return places, good if enough else set()


# --- for the teacher: a page that stands turned, a sheet of graphkin's own ------------------------

_ALIKE, _STRAIGHT = math.radians(6), math.radians(15)
"""Directions that are off by angles that differ by less are off alike; those off by less are not turned."""
_MOST = 2 / 3  # of all directions, and more than half of each figure's, are off alike on a turned page
_FEWEST = 3  # directions by which a turn is told
_SHORT = 0.02  # an arrow that is a smaller part of its figure's longest says nothing
_EXACT = 5e-4  # every arrow of a sheet of graphkin's own is as long and points as it should but for this part


def _page_remarks(
    picture: PagePicture, drawing: MeasuredDrawing, shapes: Sequence[PaperPolygon], mechanism: Mechanism
) -> Iterator[GraphkinError]:
    """A page that seems to be turned is so with both polygons alike, with what is given, and with the mechanism where
    it is drawn. A polygon that alone is turned by half a turn may be a mistake: a driver's sense."""
    drawn, figures, given = drawing.in_si(), [], list[complex]()
    for one in shapes:
        own, known = drawn.get(one.plane, {}), [vector for vector, _ in one.known]
        figures.append(_compared(own, one.right, [(vector.tail, vector.head) for vector in one.vectors]))
        given += _compared(own, one.right, [(vector.tail, vector.head) for vector in known])
    every = [ratio for figure in figures for ratio in figure]
    if any(dot.plane in drawn for dot in picture.dots) and every and max(abs(one - 1) for one in every) < _EXACT:
        yield OwnSheet(drawing.where)  # no hand and no other program draws such marks
    turn = _common_turn(figures)
    if turn and all(_between(one, turn) < _ALIKE for one in given):
        places, good = _drawn_links(picture, mechanism)
        right = running.replay_all(planning.plan(mechanism)).position
        figures.append(_compared(places, {name: place(at) for name, at in right.items()}, [*good]))
        alone = sum(map(bool, figures)) < 2 and _between(turn, -1) < _STRAIGHT
        if not alone and (turn := _common_turn(figures)):
            yield TurnedPage(drawing.where, math.degrees(cmath.phase(turn)) % 360)


def _compared(drawn: Mapping[str, complex], right: Mapping[str, complex], pairs: Sequence[Pair]) -> list[complex]:
    """Arrows as they are drawn, as multiples of the right ones."""
    there = [(drawn[b] - drawn[a], right[b] - right[a]) for a, b in pairs if {a, b} <= drawn.keys() & right.keys()]
    least = [_SHORT * max(map(abs, some)) for some in zip(*there, strict=True)]
    return [own / value for own, value in there if abs(own) > least[0] and abs(value) > least[1]]


def _common_turn(figures: Sequence[Sequence[complex]]) -> complex | None:
    """One of the arrows that are turned alike, where most are."""
    every = [ratio for figure in figures for ratio in figure]
    turn = max(every, key=lambda one: sum(_between(one, other) < _ALIKE for other in every), default=1)
    alike = [[_between(one, turn) < _ALIKE for one in figure] for figure in figures if figure]
    common = all(sum(each) > len(each) / 2 for each in alike) and sum(map(sum, alike)) >= _MOST * len(every)
    return turn if common and len(every) >= _FEWEST and _between(turn, 1) > _STRAIGHT else None


def _between(one: complex, other: complex) -> float:
    return abs(cmath.phase(one / other))
