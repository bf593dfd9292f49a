"""The circle diagram (消元法) and the table of instant centres, both in the order in which they are found."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import numpy as np

from graphkin.base import geometry
from graphkin.construction.drafting import Pricked, drawn_through
from graphkin.errors import Lang
from graphkin.say.catalogue import say
from graphkin.sheet.boxes import free_about
from graphkin.sheet.centre_figure import Spot, centre_label, coordinates, spots
from graphkin.sheet.layout import HEAD
from graphkin.sheet.lettering import LABEL, LEAST, Label, Run, link_label, number, plain, point_label, width
from graphkin.sheet.marks import Disc, Mark, Place, Stroke, Text
from graphkin.sheet.paper import PenName, Room
from graphkin.sheet.titleblock import PITCH, Table, TableBlock, across
from graphkin.studies.centres import Centres

_PENS: dict[str, PenName] = {
    "hinge": "thin", "contact": "thin", "slide": "thin", "two lines": "dashed", "velocities": "centre",
}  # fmt: skip
_BALL = 1.95  # radius of the circle around a chord's number [mm]
_NUMBERS, _OFF = 8.0, 2.2  # room for the links' numbers around the circle; from the circle to them [mm]
_LINE = 4.6  # height of a line of the key [mm]
_SHARES = tuple(0.5 + sign * k / 40 for k in range(15) for sign in (1, -1))
"""Places along its chord at which a number may stand."""


def _radius(found: Centres) -> float:
    return min(48.0, 15.0 + 2.6 * max(4, len(found.method.mechanism.links)))


def _around(found: Centres) -> float:
    """Room beside the circle for the links' numbers or names [mm]."""
    machine = found.method.mechanism
    return max(_NUMBERS, _OFF + 2 + max(width(link_label(machine.called(link)), LABEL) for link in machine.links))


def _pens(found: Centres) -> list[PenName]:
    used = {_PENS[stage.say] for stage in found.centring.stages}
    return [pen for pen in dict.fromkeys(_PENS.values()) if pen in used]


def circle_size(found: Centres) -> complex:
    """Width and height of the diagram with its key, under its heading [mm]."""
    across = 2 * (_radius(found) + _around(found))
    return complex(max(across, 56.0), 2 * (_radius(found) + _NUMBERS) + _LINE * len(_pens(found)) + 2)


def circle_diagram(found: Centres, room: Room, lang: Lang) -> list[Mark]:
    """Links as points on a circle in the middle of a room, a chord for every centre, numbered as they are found.

    A missing chord is found when it closes two triangles whose other sides are there: each triangle is a line with
    three centres (Kennedy and Aronhold). The links' points stand clockwise from the top in the order of their numbers.
    """
    size, radius = circle_size(found), _radius(found)
    spare = room.size.imag - HEAD - size.imag
    middle = complex(room.middle.real, room.top + HEAD + max(0.0, spare / 3) + _NUMBERS + radius)
    order = list(dict.fromkeys(link for pair in found.pairs for link in pair))
    turn = 2 * math.pi / max(1, len(order))
    nodes = {link: middle + cmath.rect(radius, turn * k - math.pi / 2) for k, link in enumerate(order)}
    title = Text(plain(say("sheet.circle", lang)), complex(room.left + 3, room.top + 5.5), LABEL)
    marks = [title, Disc(middle, radius, "thin"), *_chord_marks(found, nodes)]
    for link, at in nodes.items():
        label, out = link_label(found.method.mechanism.called(link)), (at - middle) / abs(at - middle)
        wide, high = width(label, LABEL), 0.68 * LABEL
        x, y = (max(-1.0, min(1.0, 1.6 * part)) for part in (out.real, out.imag))  # side or corner towards the circle
        beside = at + out * _OFF + complex(x * wide, y * high) / 2
        marks += [Disc(at, 0.9, "outline", "ink"), Text(label, beside + complex(-wide / 2, high / 2), LABEL)]
    key = {pen: plain(say(f"sheet.chord {pen}", lang)) for pen in _pens(found)}
    wide = max((width(label, LEAST) for label in key.values()), default=0.0) + 14
    for k, (pen, label) in enumerate(key.items()):  # what full and dashed chords mean
        at = complex(middle.real, middle.imag + radius + _NUMBERS + 3) + complex(-wide / 2, k * _LINE)
        marks += [Stroke((at, at + 12), pen), Text(label, at + complex(14, 0.33 * LEAST), LEAST)]
    return marks


def _chord_marks(found: Centres, nodes: dict[str, Place]) -> list[Mark]:
    """The chords with their numbers, each where most room is on its chord, the short chords first."""
    chords = [
        Stroke(tuple(nodes[link] for link in found.centring.links[stage.last.name]), _PENS[stage.say], step=k)
        for k, stage in enumerate(found.centring.stages, start=1)
    ]
    marks, balls = list[Mark](chords), list[Place]()
    for chord in sorted(chords, key=lambda chord: abs(chord.places[1] - chord.places[0])):
        start, end = chord.places
        spots = np.array([start + share * (end - start) for share in _SHARES])
        to_chord = free_about(spots, [other.places for other in chords if other is not chord], 5.0)
        room = np.minimum(to_chord, free_about(spots, [(ball, ball) for ball in balls], 5.0 + _BALL) - _BALL)
        at = complex(spots[np.round(room, 3).argmax()])
        balls.append(at)
        label = plain(str(chord.step))
        corner = at + complex(-width(label, LEAST) / 2, 0.33 * LEAST)
        ball = Disc(at, _BALL, "thin", "paper", step=chord.step)
        marks += [ball, Text(label, corner, LEAST, chord.step)]
    return marks


def centre_table(found: Centres, lang: Lang, room: float, most: float) -> TableBlock:
    """The table in so many mm of width, as low as it gets, and not higher than `most`."""
    head = tuple(plain(say(f"centres.column {key}", lang)) for key in ("number", "centre", "place", "by"))
    rows: list[tuple[Label, ...]] = []
    for spot in spots(found):
        if spot.place is not None:
            place = coordinates(found, spot.place)
        else:  # the direction of a centre at infinity
            angle = round(math.degrees(geometry.number(found.board.direction(spot.name))), 6) % 180
            place = (Run("→ ∞ "), Run(say("centres.towards", lang)), *number(angle), Run("°"))
        rows.append((plain(str(spot.number)), centre_label(spot.name), place, _by(found, spot, lang)))
    for pair in found.centring.together:
        rows.append((plain("–"), centre_label(found.name(*pair)), plain("–"), plain(say("centres.by together", lang))))
    last = len(found.centring.stages)
    whole = Table(head, tuple(rows), tuple(min(k + 1, last) for k in range(len(rows))))
    most_rows = max(4, int(most / PITCH))
    for count in range(3, most_rows):
        if across(parts := whole.cut(count)) <= room:
            return TableBlock([parts])
    parts = whole.cut(most_rows - 1)  # as many as there is room for; the last line tells how many rows are left out
    kept = parts[: max(1, sum(across(parts[: k + 1]) <= room for k in range(len(parts))))]
    lost = len(rows) - sum(len(part.rows) for part in kept) + 1
    rest = plain("…"), plain(f"{lost}"), plain(say("centres.more", lang)), plain("")
    return TableBlock([[*kept[:-1], replace(kept[-1], rows=(*kept[-1].rows[:-1], rest))]], lost)


def _by(found: Centres, spot: Spot, lang: Lang) -> Label:
    """`P12P23 × P14P34`, a hinge with its point, or a word."""
    stage, step = spot.stage, spot.stage.last
    if stage.say == "two lines":
        first, second = (
            plain(say("centres.by normal", lang)) if line.name in found.centring.normals
            else tuple(run for end in drawn_through(line) for run in centre_label(end))
            for line in stage.lines
        )  # fmt: skip
        return (*first, Run(" × "), *second)
    if stage.say == "hinge" and isinstance(step, Pricked):
        return (Run(say("centres.by hinge", lang) + " "), *point_label(step.point))
    return plain(say(f"centres.by {stage.say}", lang))
