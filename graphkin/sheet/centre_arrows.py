"""Centres that no mark can show: arrows to infinity, and to those beyond the edge of the figure."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphkin.construction.drafting import Far
from graphkin.sheet.centre_lines import reach_of
from graphkin.sheet.centre_places import CentreLine as PaperLine
from graphkin.sheet.centre_places import OnPaper, Spot, centre_label, clipped
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, number, plain
from graphkin.sheet.marks import Mark, Place, VectorMark
from graphkin.sheet.obstacles import obstacles
from graphkin.sheet.symbols import BLOCK
from graphkin.sheet.window import Figure
from graphkin.studies.centres import Centres

INFINITY: Label = plain(" → ∞ ")
"""The room after the sign is because it is wider than what letters count as."""
_LONG, _SHORT = 13.0, 8.0
"""An arrow to infinity, and one to a centre beyond the edge [mm]."""
_OFF = BLOCK.imag / 2 + 1.0
"""From a block's middle to where its arrow starts [mm]."""
_APART = 5.0
"""Arrows one way start at least so far from one another [mm]."""


def centre_arrows(paper: OnPaper, drawn: Sequence[Mark]) -> Figure:
    """One arrow for each centre that is not marked, with its name; off the sheet also with its coordinates."""
    figure = Figure()
    for spot in paper.spots:
        if paper.shown(spot):
            continue
        taken = [mark for mark in figure.marks if isinstance(mark, VectorMark)]
        length = _LONG if spot.place is None else _SHORT
        start, way = _free(_places(paper, spot), length, taken, drawn, paper)
        head = "∞" if spot.place is None else spot.name
        arrow = VectorMark("centres", spot.name, "", head, start, start + length * way, spot.number)
        figure.marks.append(arrow)
        label = (*centre_label(spot.name), *(INFINITY if spot.place is None else _off(paper.found, spot)))
        figure.wanted.append(LabelRequest(label, arrow.end, gap=0.7, away=way, step=spot.number))
    return figure


def _off(found: Centres, spot: Spot) -> Label:
    assert spot.place is not None
    return (Run(" "), *coordinates(found, spot.place), Run(" mm"))


def coordinates(found: Centres, place: complex) -> Label:
    """`(34.37, −115.6)`: in mm; what is smaller than rounding is 0."""
    shown = 1000 * complex(found.method.mechanism.usual.cut(place, "m"))
    return (Run("("), *number(shown.real), Run(", "), *number(shown.imag), Run(")"))


# --- where an arrow stands --------------------------------------------------------------------

_Stand = tuple[Place, complex]
"""Where an arrow starts, and its direction."""


def _places(paper: OnPaper, spot: Spot) -> Iterator[_Stand]:
    """Where the arrow of a centre may stand: at its slide, at the end of a line, at last anywhere."""
    if isinstance(spot.stage.last, Far):
        yield from _at_slide(paper, spot, spot.stage.last.line)
    for line in paper.lines(spot):
        laid = reach_of(paper, spot, line)
        if laid is not None:
            yield from _at_ends(paper, spot, line, laid.ends)
    yield from _anywhere(paper, spot)


def _at_slide(paper: OnPaper, spot: Spot, name: str) -> Iterator[_Stand]:
    """On both sides of the block, at right angles to its guide."""
    slide = next(slide for slide in paper.found.method.mechanism.slides if slide.name == name)
    at, normal = paper.window(complex(paper.found.plot.position[slide.point])), paper.window.turned(spot.direction)
    for off in (_OFF, _OFF + 6, _OFF + 14):
        for way in (normal, -normal):
            yield at + off * way, way


def _at_ends(paper: OnPaper, spot: Spot, line: PaperLine, ends: tuple[Place, Place]) -> Iterator[_Stand]:
    """Over the ends of a line that lead to the centre."""
    for end, way in ((ends[1], line.way), (ends[0], -line.way)):
        if spot.place is None:
            yield end - 2 * way, way
        elif ((paper.at(spot) - end) * way.conjugate()).real > 0:
            for back in (0.0, _SHORT + 4, 2 * _SHORT + 8):
                start = end - (_SHORT + 0.5 + back) * way
                yield start, _towards(paper.at(spot), start)


def _anywhere(paper: OnPaper, spot: Spot) -> Iterator[_Stand]:
    """From the middle of the figure to its edge."""
    room = paper.room
    spread = 0.35 * room.size
    for x, y in ((0, 0), (1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, -1), (1, -1), (-1, 1)):
        foot = room.middle + complex(x * spread.real, y * spread.imag)
        way = paper.window.turned(spot.direction) if spot.place is None else _towards(paper.at(spot), foot)
        span = clipped(PaperLine(foot, way, ()), room)
        if span is not None:
            yield foot + way * (span[1] - _LONG - 1), way


def _towards(place: Place, start: Place) -> complex:
    return (place - start) / abs(place - start)


def _free(
    stands: Iterator[_Stand], length: float, taken: Sequence[VectorMark], drawn: Sequence[Mark], paper: OnPaper
) -> _Stand:
    """The place that touches the fewest things; the first of equals."""
    tried = [(start, way, start + length * way) for start, way in stands]
    known = obstacles([*drawn, *taken])
    low = np.array([(start.real, start.imag) for start, _, _ in tried])
    high = np.array([(end.real, end.imag) for _, _, end in tried])
    hits = np.bincount(known.crossed(low, high), minlength=len(tried))

    def price(k: int) -> float:
        start, _, end = tried[k]
        near = any(abs(start - other.start) < _APART or abs(end - other.end) < _APART for other in taken)
        return float(min(hits[k], 6) + 8 * near + 30 * (not (paper.room.holds(start) and paper.room.holds(end))))

    best = min(range(len(tried)), key=lambda k: (price(k) + 0.4 * k, k))
    return tried[best][0], tried[best][1]
