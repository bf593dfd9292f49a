"""The sheet of instant centres: the mechanism with its centres, the circle diagram (消元法), the table.

A step is a centre, in the order in which they are found.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache, partial
from itertools import chain, product

import numpy as np

from graphkin.base import geometry
from graphkin.base.boxes import free_about
from graphkin.base.rooms import Room, corners, enlarged
from graphkin.construction import Plane
from graphkin.construction.drafting import Pricked, drawn_through
from graphkin.errors import Lang
from graphkin.say.catalogue import say
from graphkin.sheet.centre_figure import OnPaper, Spot, bare_mechanism, centre_figure, centre_label, coordinates, spots
from graphkin.sheet.detail import detailed
from graphkin.sheet.layout import HEAD, Layout, division
from graphkin.sheet.lettering import LABEL, LEAST, Label, Run, joined, link_label, number, plain, point_label, width
from graphkin.sheet.marks import Disc, Mark, Place, Stroke, Text
from graphkin.sheet.mechanism_figure import mechanism_places
from graphkin.sheet.page import Page, Panel, Sheet, heading
from graphkin.sheet.paper import Paper, PenName, papers_for
from graphkin.sheet.titleblock import PITCH, Strip, Table, TableBlock, across, tables_room
from graphkin.sheet.window import Extent, Window
from graphkin.studies.centres import Centres

_CROWDED = 10  # with more labels at the end of leaders than this, another layout is tried
_TRIES = 3
_SLACK = 5 + 5j  # of the room about the circle, which no figure's points need [mm]
_LARGE_ENOUGH = 14.0
"""The mechanism is to be so large, times the root of how many centres there are, which want letters in it [mm]."""
_SHOWN, _LARGER_PAPER = 16, 80  # worth of a centre on the sheet, and cost of a larger paper, which fewer printers have
_TIMES, _FIT = [1.12**k for k in range(15)], 20.0
"""So many times larger than the mechanism the figure may become for its centres; and where all are to be on it."""


def centre_sheet(found: Centres, *, paper: str | None = None, lang: Lang = "en", fit: bool = False) -> Sheet:
    """Draw a mechanism with all its instant centres, the circle diagram, and the table of centres. Raises UnknownPaper.

    found  at one position
    paper  a key of `PAPERS`; the smallest that serves where left out
    fit    so small that all finite centres are on the sheet for which the figure becomes at most 20 times as large;
           else those farther off are told by an arrow and their coordinates
    """
    tried = list[tuple[int, int, int, Page]]()
    every = {(one[1].paper, one[2], one[0]): one for one in _layouts(found, papers_for(paper), lang, fit)}
    for _, layout, window, table in sorted(every.values(), key=lambda one: -one[0])[:_TRIES]:
        page = _page(found, layout, window, table, lang)
        labels = page.panels[0].far
        tried.append((len(labels.clashing), max(0, len(labels.led) - _CROWDED), len(tried), page))
        if not any(tried[-1][:2]):
            break
    return min(tried)[-1].sheet()


def _page(found: Centres, layout: Layout, window: Window, table: TableBlock, lang: Lang) -> Page:
    """Table, headings and circle diagram; then the figure."""
    whole, strip = layout.rooms["position"], layout.strip
    base = [*table.marks(complex(strip.left + 3, strip.top + 1.5))]
    base += circle_diagram(found, layout.rooms["velocity"], lang)
    base += heading(say("sheet.centres", lang), "position", window.printed, whole)
    drawn = OnPaper(found, window, whole.inset(2, HEAD, 2))
    panel = Panel(centre_figure(drawn), window, drawn.room, tuple(base))
    panel = detailed(panel, lambda larger: centre_figure(replace(drawn, window=larger), False), "position")
    below = Strip(least=table.size.imag)
    return Page(layout.paper, [panel], found.method.mechanism, found.plot.facts.values, lang, below)


def _layouts(
    found: Centres, papers: list[Paper], lang: Lang, fit: bool
) -> Iterator[tuple[float, Layout, Window, TableBlock]]:
    """Worth, paper divided, window and table, with more or fewer centres far off; at the file's scale if it fits."""
    places, given = mechanism_places(found.method, found.plot), found.method.mechanism.scales.get("length")
    alone = Extent.of(places, partial(bare_mechanism, found), given)
    middle, finite = (alone.low + alone.high) / 2, [spot.place for spot in spots(found) if spot.place is not None]
    near = sorted(finite, key=lambda centre: abs(centre - middle))
    figures = dict.fromkeys(corners(enlarged(places, near, times)) for times in ((_FIT,) if fit else _TIMES))
    half = (circle_size(found) - _SLACK) / 2
    diagram = Extent(0j, 0j, half.real, half.imag, half.real, half.imag, labels=0)  # of one size at any scale
    table = cache(lambda paper: centre_table(found, lang, tables_room(paper), 0.4 * paper.height))
    none = True
    for scale in (given, None) if given and not fit else (None,):
        for one, (low, high) in product(papers, figures) if none else ():
            extent = replace(alone, low=low, high=high, given=scale)
            extents: dict[Plane, Extent] = {"position": extent, "velocity": diagram}
            layout = division([one], extents, lambda paper: Strip(least=table(paper).size.imag).height(paper))
            if layout is not None:
                none = False
                window, room = layout.placed("position", extent)[0], layout.rooms["position"].inset(2, HEAD, 2)
                large = (alone.longest or 1.0) / window.scale
                small = max(0.0, _LARGE_ENOUGH * len(found.centring.stages) ** 0.5 - large)
                worth = _SHOWN * sum(room.holds(window(centre)) for centre in finite) + min(large, 100) / 8 - 3 * small
                worth -= _LARGER_PAPER * (one.area > 80_000) + 40 * table(layout.paper).lost
                yield worth, layout, window, table(layout.paper)


# --- circle diagram and table -----------------------------------------------------------------------------------------


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


def _pens(found: Centres) -> list[PenName]:
    used = {_PENS[stage.say] for stage in found.centring.stages}
    return [pen for pen in dict.fromkeys(_PENS.values()) if pen in used]


def circle_size(found: Centres) -> complex:
    """Width and height of the diagram with its key, under its heading, and the links' numbers or names [mm]."""
    names = [width(link_label(found.method.mechanism.called(link)), LABEL) for link in found.method.mechanism.links]
    across = 2 * (_radius(found) + max(_NUMBERS, _OFF + 2 + max(names)))
    return complex(max(across, 56.0), 2 * (_radius(found) + _NUMBERS) + _LINE * len(_pens(found)) + 2)


def circle_diagram(found: Centres, room: Room, lang: Lang) -> Iterator[Mark]:
    """Links as points on a circle, clockwise from the top as they are numbered, a chord for every centre. A missing one
    is found when it closes two triangles whose other sides are there: each is a line with three centres (Kennedy)."""
    size, radius = circle_size(found), _radius(found)
    spare = room.size.imag - HEAD - size.imag
    middle = complex(room.middle.real, room.top + HEAD + max(0.0, spare / 3) + _NUMBERS + radius)
    order = list(dict.fromkeys(link for pair in found.pairs for link in pair))
    turn = 2 * math.pi / max(1, len(order))
    nodes = {link: middle + cmath.rect(radius, turn * k - math.pi / 2) for k, link in enumerate(order)}
    yield Text(plain(say("sheet.circle", lang)), complex(room.left + 3, room.top + 5.5), LABEL)
    yield Disc(middle, radius, "thin")
    yield from _chord_marks(found, nodes)
    for link, at in nodes.items():
        label, out = link_label(found.method.mechanism.called(link)), (at - middle) / abs(at - middle)
        wide, high = width(label, LABEL), 0.68 * LABEL
        x, y = (max(-1.0, min(1.0, 1.6 * part)) for part in (out.real, out.imag))  # side or corner towards the circle
        beside = at + out * _OFF + complex(x * wide, y * high) / 2
        yield from (Disc(at, 0.9, "outline", "ink"), Text(label, beside + complex(-wide / 2, high / 2), LABEL))
    key = {pen: plain(say(f"sheet.chord {pen}", lang)) for pen in _pens(found)}
    wide = max((width(label, LEAST) for label in key.values()), default=0.0) + 14
    for k, (pen, label) in enumerate(key.items()):  # what full and dashed chords mean
        at = complex(middle.real, middle.imag + radius + _NUMBERS + 3) + complex(-wide / 2, k * _LINE)
        yield from (Stroke((at, at + 12), pen), Text(label, at + complex(14, 0.33 * LEAST), LEAST))


def _chord_marks(found: Centres, nodes: dict[str, Place]) -> Iterator[Mark]:
    """The chords with their numbers, each where most room is on its chord, the short chords first."""
    chords = [
        Stroke(tuple(nodes[link] for link in found.centring.links[stage.last.name]), _PENS[stage.say], step=k)
        for k, stage in enumerate(found.centring.stages, start=1)
    ]
    yield from chords
    balls = list[Place]()
    for chord in sorted(chords, key=lambda chord: abs(chord.places[1] - chord.places[0])):
        start, end = chord.places
        spots = np.array([start + share * (end - start) for share in _SHARES])
        to_chord = free_about(spots, [other.places for other in chords if other is not chord], 5.0)
        room = np.minimum(to_chord, free_about(spots, [(ball, ball) for ball in balls], 5.0 + _BALL) - _BALL)
        at = complex(spots[np.round(room, 3).argmax()])
        balls.append(at)
        label = plain(str(chord.step))
        corner = at + complex(-width(label, LEAST) / 2, 0.33 * LEAST)
        yield Disc(at, _BALL, "thin", "paper", step=chord.step)
        yield Text(label, corner, LEAST, chord.step)


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
    for pair, why in found.without.items():
        rows.append((plain("–"), centre_label(found.name(*pair)), plain("–"), plain(say(f"centres.by {why}", lang))))
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
        normals, normal = found.centring.normals, plain(say("centres.by normal", lang))
        ends = ([normal] if line.name in normals else map(centre_label, drawn_through(line)) for line in stage.lines)
        return joined([tuple(chain.from_iterable(each)) for each in ends], " × ")
    if stage.say == "hinge" and isinstance(step, Pricked):
        return (Run(say("centres.by hinge", lang) + " "), *point_label(step.point))
    return plain(say(f"centres.by {stage.say}", lang))
