"""Kennedy's lines on paper: each once, as far as it is needed and a little beyond."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from graphkin.sheet.centre_places import SAME, CentreLine, Laid, OnPaper, Spot, clipped
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import plain
from graphkin.sheet.marks import Stroke
from graphkin.sheet.paper import PenName
from graphkin.sheet.window import Figure

_BEYOND = 4.0
"""How far a line goes on past the centres on it [mm]."""
_NORMAL = 12.0
"""How far a common normal goes on past the contact [mm]."""
_PARALLEL = 16.0
"""How far lines to a centre at infinity go on [mm]."""
_SHORT = 0.8
"""What is left of a line already drawn is not drawn if shorter [mm]."""


def centre_lines(paper: OnPaper) -> Figure:
    """The lines of all steps, the later ones where no earlier one lies."""
    figure, drawn = Figure(), _DrawnStretches()
    for spot in paper.spots:
        for line in paper.lines(spot):
            laid = reach_of(paper, spot, line, line.normal)
            if laid is None:
                continue
            pen: PenName = "centre" if line.normal else "dashed"
            for piece in drawn.fresh(laid):
                figure.marks.append(Stroke(piece.ends, pen, step=spot.number))
            if line.normal:
                figure.wanted += _normal_letters(laid, spot.number)
    return figure


def _normal_letters(laid: Laid, step: int) -> Iterator[LabelRequest]:
    """n .. n at the ends of a common normal."""
    start, end = laid.ends
    yield LabelRequest(plain("n", italic=True), start, gap=0.2, away=start - end, step=step)
    yield LabelRequest(plain("n", italic=True), end, gap=0.2, away=end - start, step=step)


def reach_of(paper: OnPaper, spot: Spot, line: CentreLine, normal: bool = False) -> Laid | None:
    """How much of a line is drawn: past the centres on it, or to the room's edge towards those beyond."""
    span = clipped(line, paper.room)
    if span is None:
        return None
    low, high = span
    beyond = _NORMAL if normal else _PARALLEL if spot.place is None else _BEYOND
    seen = [line.along(place) for place in line.stops if paper.room.holds(place)]
    outer = [line.along(place) for place in line.stops if not paper.room.holds(place)]
    ends = [*(max(low, t - beyond) for t in seen), *(min(high, t + beyond) for t in seen)]
    ends += [low if t < low else high for t in outer]
    return Laid(line, min(ends), max(ends)) if max(ends, default=0) - min(ends, default=0) > SAME else None


@dataclass
class _DrawnStretches:
    """Stretches that are drawn already."""

    pieces: list[Laid] = field(default_factory=list)

    def fresh(self, laid: Laid) -> list[Laid]:
        """What of a stretch is not yet there."""
        left = [(laid.start, laid.end)]
        for piece in self.pieces:
            if _one_line(laid.line, piece.line):
                first, second = sorted(laid.line.along(end) for end in piece.ends)
                left = [part for old in left for part in _without(old, first, second)]
        fresh = [Laid(laid.line, *part) for part in left if part[1] - part[0] > _SHORT]
        self.pieces += fresh
        return fresh


def _one_line(one: CentreLine, other: CentreLine) -> bool:
    """Whether two lines are the same on paper."""
    if abs((one.way * other.way.conjugate()).imag) > 2e-4:
        return False
    return abs(((other.at - one.at) * one.way.conjugate()).imag) < 2 * SAME


def _without(old: tuple[float, float], first: float, second: float) -> Iterator[tuple[float, float]]:
    """A stretch without what lies between first and second."""
    start, end = old
    if second <= start or first >= end:
        yield old
        return
    if start < first:
        yield start, first
    if second < end:
        yield second, end
