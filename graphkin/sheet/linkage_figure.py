"""Several positions of a linkage of four links over each other: the first in thick lines, the others thin.

The linkage itself is the mechanism's own figure at each position; here it is put together and lettered.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations

from graphkin.model.mechanism import FRAME
from graphkin.sheet import symbols
from graphkin.sheet.fixed_link import grounds
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, point_label, points_label
from graphkin.sheet.marks import Disc, Mark, Place, PointMark, Stroke
from graphkin.sheet.mechanism_figure import moving_links
from graphkin.sheet.paper import BODY
from graphkin.sheet.single_figure import Caption, Picture
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Extent, Figure, Window
from graphkin.studies.linkages import Linkage
from graphkin.studies.linkages.linkage import LinkagePosition
from graphkin.studies.linkages.placement import posed

Row = Sequence[LinkagePosition]
"""Positions drawn over each other."""


_SHORT = 8.0
"""A shorter bar bears no letters of its own [mm]."""
_TRIAL = 80.0
"""Size of a figure when it is drawn to see how far its signs reach [mm]."""


def pictured(positions: Row, draw: Callable[[Window], Figure], caption: Caption) -> Picture:
    """A figure of these positions that wants a cell."""
    return Picture(Extent.of(_places(positions), draw, trial=_TRIAL), draw, caption)


def _places(positions: Row) -> list[complex]:
    """The places a figure shows [m]."""
    return [place for position in positions for place in position.places]


def on_paper(position: LinkagePosition, window: Window) -> list[Place]:
    return [window(place) for place in position.places]


def drawn_over(linkage: Linkage, positions: Row, window: Window, primes: bool = False) -> Figure:
    """Ground first, then the thin positions, then the thick one; moving points lettered with numbers or primes."""
    machine = linkage.mechanism()
    first, *others = (Skeleton(machine, posed(linkage, machine, position), window, {}) for position in positions)
    marks = list(grounds(first, *others).marks)
    for skeleton in reversed(others):
        marks += [_thin(mark) for mark in _links(linkage, skeleton)]
    wanted = [*_names(linkage, positions, first, primes), *_bars(linkage, positions[0], window)]
    return Figure([*marks, *_links(linkage, first)], wanted)


def _bars(linkage: Linkage, position: LinkagePosition, window: Window) -> Iterator[LabelRequest]:
    """The links by their ends, as their lengths are called, where there is room for it."""
    named = zip(linkage.names, on_paper(position, window), strict=True)
    for (one, start), (other, end) in combinations(named, 2):
        name = next((name for name in (one + other, other + one) if name in linkage.sizes), "")
        if name and abs(end - start) > _SHORT:
            yield LabelRequest(points_label(name), start, end, gap=1.2, size=BODY, spare=True)


def _links(linkage: Linkage, skeleton: Skeleton) -> Iterator[Mark]:
    """Hinges as plain circles, for such a figure is looked at, not measured; points without a letter are not shown."""
    for mark in moving_links(skeleton):
        if not isinstance(mark, PointMark):
            yield mark
        elif mark.name in linkage.names:
            yield Disc(mark.at, mark.radius, "outline", mark.fill)


def _thin(mark: Mark) -> Mark:
    return replace(mark, pen="thin") if isinstance(mark, Stroke | Disc) else mark


def _names(linkage: Linkage, positions: Row, first: Skeleton, primes: bool) -> Iterator[LabelRequest]:
    """Pivots once, moving points at every position."""
    window = first.window
    centre = sum(places := _places(positions)) / len(places)
    for k, name in enumerate(linkage.names):
        fixed = FRAME in first.mechanism.owners[name]
        for number, position in enumerate(positions[:1] if fixed else positions, start=1):
            at = window(position.places[k])
            label = _numbered(name, None if fixed or len(positions) == 1 else number, primes)
            yield LabelRequest(label, at, gap=symbols.HINGE + 0.4, away=at - window(centre))


def _numbered(name: str, number: int | None, primes: bool) -> Label:
    """`B` at position 1 as B with a subscript (after a comma where the name has one of its own), or with a prime."""
    label = point_label(name)
    if number is None:
        return label
    if primes:
        return (*label, Run("′" * number))
    low = any(run.place == "sub" for run in label)
    return (*label, Run(f",{number}" if low else str(number), False, "sub"))
