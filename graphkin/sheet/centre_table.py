"""The circle diagram (消元法) and the table of instant centres, both in the order in which they are found."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from math import degrees

from graphkin.base.value import frozen
from graphkin.construction.drafting import LineStep, Pricked, drawn_through
from graphkin.errors import Lang
from graphkin.sheet.centre_places import Spot, centre_label, coordinates, spots
from graphkin.sheet.lettering import Label, Run, link_label, number, plain, point_label, width
from graphkin.sheet.marks import Disc, Mark, Place, Stroke, Text
from graphkin.sheet.paper import LABEL, LEAST, PenName, Room
from graphkin.sheet.table import PITCH, SIZE, Table, height_of
from graphkin.studies.centres import Centres

_PENS: dict[str, PenName] = {
    "hinge": "thin", "contact": "thin", "slide": "thin", "two lines": "dashed", "velocities": "centre",
}  # fmt: skip
_KEY: dict[Lang, dict[PenName, str]] = {
    "en": {"thin": "by definition", "dashed": "by Kennedy's theorem", "centre": "from velocities"},
    "zh": {"thin": "由定义直接确定", "dashed": "由三心定理确定", "centre": "由速度求得"},
}
_DIAGRAM: dict[Lang, str] = {"en": "Circle diagram", "zh": "消元法圆图"}
_BALL = 1.95
"""Radius of the circle around a chord's number [mm]."""
_NUMBERS = 8.0
"""Room for the links' numbers around the circle [mm]."""
_HEAD, _LINE = 8.0, 4.6
"""Height of the heading, and of a line of the key [mm]."""
_SHARES = tuple(0.5 + sign * k / 40 for k in range(15) for sign in (1, -1))
"""Where along its chord a number may stand."""


def _radius(found: Centres) -> float:
    return min(48.0, 15.0 + 2.6 * max(4, len(found.method.mechanism.links)))


def _pens(found: Centres) -> list[PenName]:
    used = {_PENS[stage.say] for stage in found.centring.stages}
    return [pen for pen in _KEY["en"] if pen in used]


def circle_size(found: Centres) -> complex:
    """Width and height of the diagram with its heading and key [mm]."""
    across = 2 * (_radius(found) + _NUMBERS)
    return complex(max(across, 56.0), _HEAD + across + _LINE * len(_pens(found)) + 2)


def circle_diagram(found: Centres, room: Room, lang: Lang) -> list[Mark]:
    """The diagram in the middle of a room."""
    size, radius = circle_size(found), _radius(found)
    corner = complex(room.left, room.top + max(0.0, (room.bottom - room.top - size.imag) / 3))
    middle = complex((room.left + room.right) / 2, corner.imag + _HEAD + _NUMBERS + radius)
    nodes = _nodes(found, middle, radius)
    marks: list[Mark] = [Text(plain(_DIAGRAM[lang]), complex(room.left + 3, room.top + 5.5), LABEL)]
    marks.append(Disc(middle, radius, "leader"))
    marks += _chords(found, nodes)
    marks += _links(found, nodes, middle)
    return marks + _key_marks(found, complex(middle.real, middle.imag + radius + _NUMBERS + 3), lang)


def _nodes(found: Centres, middle: Place, radius: float) -> dict[str, Place]:
    """The links' points, clockwise from the top in the order of their numbers."""
    order = list(dict.fromkeys(link for pair in found.pairs for link in pair))
    turn = 2 * math.pi / max(1, len(order))
    return {link: middle + cmath.rect(radius, turn * k - math.pi / 2) for k, link in enumerate(order)}


def _links(found: Centres, nodes: dict[str, Place], middle: Place) -> list[Mark]:
    marks: list[Mark] = []
    for link, at in nodes.items():
        label = link_label(found.method.mechanism.called(link))
        out = (at - middle) / abs(at - middle)
        wide, high = width(label, LABEL), 0.68 * LABEL
        where = at + out * (2.6 + abs(out.real) * wide / 2 + abs(out.imag) * high / 2)
        marks.append(Disc(at, 0.9, "outline", "ink"))
        marks.append(Text(label, where + complex(-wide / 2, high / 2), LABEL))
    return marks


@frozen
class _Chord:
    number: int
    pen: PenName
    start: Place
    end: Place


def _chords(found: Centres, nodes: dict[str, Place]) -> list[Mark]:
    chords = [
        _Chord(k, _PENS[stage.say], *(nodes[link] for link in found.centring.links[stage.last.name]))
        for k, stage in enumerate(found.centring.stages, start=1)
    ]
    marks: list[Mark] = [Stroke((c.start, c.end), c.pen, step=c.number) for c in chords]
    for chord, at in _numbered(chords):
        label = plain(str(chord.number))
        marks.append(Disc(at, _BALL, "leader", "paper", step=chord.number))
        corner = at + complex(-width(label, LEAST) / 2, 0.33 * LEAST)
        marks.append(Text(label, corner, LEAST, chord.number))
    return marks


def _numbered(chords: Sequence[_Chord]) -> list[tuple[_Chord, Place]]:
    """Each number where most room is on its chord, the short chords first."""
    found: list[tuple[_Chord, Place]] = []
    for chord in sorted(chords, key=lambda c: (abs(c.end - c.start), c.number)):
        way = chord.end - chord.start
        others = [other for other in chords if other is not chord]
        taken = [at for _, at in found]

        def room(at: Place, others: list[_Chord] = others, taken: list[Place] = taken) -> float:
            lines = min((_distance(at, other.start, other.end) for other in others), default=9.0)
            balls = min((abs(at - other) - _BALL for other in taken), default=9.0)
            return min(lines, balls, 5.0)

        places = [chord.start + share * way for share in _SHARES]
        found.append((chord, max(places, key=lambda at: round(room(at), 3))))
    return found


def _distance(at: Place, start: Place, end: Place) -> float:
    """From a place to a chord."""
    way = end - start
    t = ((at - start) * way.conjugate()).real / abs(way) ** 2
    return abs(at - start - max(0.0, min(1.0, t)) * way)


def _key_marks(found: Centres, top: Place, lang: Lang) -> list[Mark]:
    """What full and dashed chords mean."""
    pens = _pens(found)
    wide = max((width(plain(_KEY[lang][pen]), LEAST) for pen in pens), default=0.0) + 14
    marks: list[Mark] = []
    for k, pen in enumerate(pens):
        at = top + complex(-wide / 2, k * _LINE)
        marks += [Stroke((at, at + 12), pen), Text(plain(_KEY[lang][pen]), at + complex(14, 0.33 * LEAST), LEAST)]
    return marks


_GAP, _BETWEEN = 2.6, 6.0
_WORDS: dict[Lang, dict[str, str]] = {
    "en": {
        "number": "No.", "centre": "centre", "place": "x, y [mm]", "by": "found by",
        "hinge": "hinge ", "slide": "slide", "contact": "rolling contact", "normal": "common normal",
        "velocities": "velocities", "at": " at ",
        "none": "no relative motion", "more": "more",
    },
    "zh": {
        "number": "序号", "centre": "瞬心", "place": "x，y（mm）", "by": "求法", "hinge": "转动副 ", "slide": "移动副",
        "contact": "纯滚动接触点", "normal": "公法线", "velocities": "由速度求得", "at": "，方向 ",
        "none": "无相对运动", "more": "其余",
    },
}  # fmt: skip


@frozen
class CentreTable:
    """The table cut into parts that stand side by side; `lost` rows found no room on the paper."""

    parts: tuple[Table, ...]
    steps: int
    lost: int = 0

    @property
    def height(self) -> float:
        """[mm]"""
        return height_of([list(self.parts)])

    def drawn(self, corner: Place) -> Iterator[Mark]:
        """Each row comes with its own step."""
        step = 0
        for part in self.parts:
            yield from _row(part, part.head, corner, 0, None)
            under = corner + 1j * (PITCH * 1.05)
            yield Stroke((under, under + part.wide), "thin")
            for k, row in enumerate(part.rows, start=1):
                step += 1
                yield from _row(part, row, corner, k, min(step, self.steps))
            corner += part.wide + _BETWEEN


def _row(table: Table, row: tuple[Label, ...], corner: Place, k: int, step: int | None) -> Iterator[Mark]:
    pen = corner + 1j * (PITCH * (k + 0.75) + (0.6 if k else 0))
    for cell, wide in zip(row, table.widths, strict=True):
        if cell:
            yield Text(cell, pen, SIZE, step)
        pen += wide + _GAP


def centre_table(found: Centres, lang: Lang, room: float, most: float) -> CentreTable:
    """The table in so many mm of width, as low as it gets, and not higher than `most`."""
    words = _WORDS[lang]
    head = (plain(words["number"]), plain(words["centre"]), plain(words["place"]), plain(words["by"]))
    rows = [_cells(found, spot, words) for spot in spots(found)]
    for pair in found.centring.together:
        rows.append((plain("–"), centre_label(found.name(*pair)), plain("–"), plain(words["none"])))
    for count in range(3, max(4, int(most / PITCH))):
        parts = tuple(Table(head, tuple(rows)).cut(count))
        if sum(part.wide for part in parts) + _BETWEEN * (len(parts) - 1) <= room:
            return CentreTable(parts, len(found.centring.stages))
    kept, lost = _shortened(Table(head, tuple(rows)), room, max(4, int(most / PITCH)) - 1, words["more"])
    return CentreTable(kept, len(found.centring.stages), lost)


def _shortened(whole: Table, room: float, count: int, more: str) -> tuple[tuple[Table, ...], int]:
    """As many parts as there is room for; the last line tells how many rows are left out."""
    kept: list[Table] = []
    for part in whole.cut(count):
        if kept and sum(p.wide for p in kept) + part.wide + _BETWEEN * len(kept) > room:
            break
        kept.append(part)
    left = len(whole.rows) - sum(len(part.rows) for part in kept) + 1
    last = kept[-1]
    kept[-1] = Table(last.head, (*last.rows[:-1], (plain("…"), plain(f"{left}"), plain(more), plain(""))))
    return tuple(kept), left


def _cells(found: Centres, spot: Spot, words: dict[str, str]) -> tuple[Label, ...]:
    return plain(str(spot.number)), centre_label(spot.name), _place(found, spot, words), _by(found, spot, words)


def _place(found: Centres, spot: Spot, words: dict[str, str]) -> Label:
    """`(34.37, 0)`, or the direction of a centre at infinity."""
    if spot.place is not None:
        return coordinates(found, spot.place)
    angle = round(degrees(float(found.board.direction(spot.name))), 6) % 180
    return (Run("→ ∞ "), Run(words["at"]), *number(angle), Run("°"))


def _by(found: Centres, spot: Spot, words: dict[str, str]) -> Label:
    stage, step = spot.stage, spot.stage.last
    if stage.say == "two lines":
        first, second = (_line(found, line, words) for line in stage.lines)
        return (*first, Run(" × "), *second)
    if stage.say == "hinge" and isinstance(step, Pricked):
        return (Run(words["hinge"]), *point_label(step.point))
    return plain(words[stage.say])


def _line(found: Centres, line: LineStep, words: dict[str, str]) -> Label:
    if line.name in found.centring.normals:
        return (Run(words["normal"]),)
    return tuple(run for end in drawn_through(line) for run in centre_label(end))
