"""Several positions of a linkage of four links over each other: the first in thick lines, the others thin."""

from __future__ import annotations

import cmath
from collections.abc import Sequence

from graphkin.linkages import FourBar, GuideBar, Linkage, SliderCrank
from graphkin.linkages.linkage import Position
from graphkin.sheet import symbols
from graphkin.sheet.labels import Wanted
from graphkin.sheet.lettering import Label, Run, point_label
from graphkin.sheet.marks import Disc, Mark, Place, Stroke
from graphkin.sheet.paper import PenName
from graphkin.sheet.window import Figure, Window

__all__ = ["Row", "drawn_over", "numbered", "on_paper", "values"]

_PAST = 9.0
"""How far a bar goes on beyond its block [mm]."""
_GUIDE = 9.0
"""How far a fixed guide goes on beyond its blocks [mm]."""

Row = Sequence[Position]
"""Positions drawn over each other."""


def values(positions: Row) -> list[complex]:
    """The places a figure shows [m]."""
    return [place for position in positions for place in position.places]


def on_paper(position: Position, window: Window) -> list[Place]:
    return [window(place) for place in position.places]


def numbered(name: str, number: int | None, primes: bool = False) -> Label:
    """`B` at position 1 as B with a subscript (after a comma where the name has one of its own), or with a prime."""
    label = point_label(name)
    if number is None:
        return label
    if primes:
        return (*label, Run("′" * number))
    low = any(run.place == "sub" for run in label)
    return (*label, Run(f",{number}" if low else str(number), False, "sub"))


def drawn_over(linkage: Linkage, positions: Row, window: Window, primes: bool = False) -> Figure:
    """Ground first, then the thin positions, then the thick one; moving points lettered with numbers or primes."""
    figure = Figure()
    figure.marks += _ground(linkage, positions, window)
    for number in range(len(positions), 0, -1):
        pen: PenName = "visible" if number == 1 else "thin"
        figure.marks += _links(linkage, positions[number - 1], window, pen)
        if isinstance(linkage, SliderCrank) and linkage.block:
            figure.marks += _sliding_bar(linkage, positions, number - 1, window, pen)
    if isinstance(linkage, SliderCrank) and linkage.block:
        figure.marks += _fixed_block(linkage, positions, window)
    figure.marks += _fixed_hinges(linkage, positions[0], window)
    figure.wanted += _names(linkage, positions, window, primes)
    return figure


def _fixed(linkage: Linkage) -> tuple[int, ...]:
    """Which places are fixed pivots."""
    return {FourBar: (0, 3), SliderCrank: (0,), GuideBar: (0, 2)}[type(linkage)]


def _ground(linkage: Linkage, positions: Row, window: Window) -> list[Mark]:
    marks: list[Mark] = []
    for k in _fixed(linkage):
        if not (isinstance(linkage, GuideBar) and linkage.block and k == 2):
            marks += symbols.pivot(window(positions[0].places[k]), _down(positions, k, window))
    if isinstance(linkage, SliderCrank) and not linkage.block:
        marks += _fixed_guide(linkage, positions, window)
    return marks


def _down(positions: Row, k: int, window: Window) -> complex:
    """The side on which a pivot's ground lies: down, unless links leave that way."""
    at = window(positions[0].places[k])
    others = [place for position in positions for j, place in enumerate(on_paper(position, window)) if j != k]
    ways = [(place - at) / abs(place - at) for place in others if abs(place - at) > 0.5]

    def badness(down: complex) -> float:
        nearest = max(((way * down.conjugate()).real for way in ways), default=-1.0)
        return max(0.0, nearest - 0.6) + {1j: 0.0, -1j: 0.1}.get(down, 0.05)

    return min((1j, -1 + 0j, 1 + 0j, -1j), key=badness)


def _fixed_guide(slider: SliderCrank, positions: Row, window: Window) -> list[Mark]:
    """The guide under all positions of the slider, hatched on the side away from A."""
    along = window.turned(cmath.rect(1, slider.way))
    a = window(positions[0].places[0])
    sliders = [on_paper(position, window)[2] for position in positions]
    reach = sorted(((place - a) * along.conjugate()).real for place in sliders)
    foot = sliders[0] - along * ((sliders[0] - a) * along.conjugate()).real
    side = guide_side(foot, a, along)
    line = foot + side * symbols.BLOCK.imag / 2
    low, high = reach[0] - symbols.BLOCK.real / 2 - _GUIDE, reach[-1] + symbols.BLOCK.real / 2 + _GUIDE
    return symbols.guide(line + along * low, line + along * high, side)


def _block_place(slider: SliderCrank, positions: Row, window: Window) -> tuple[Place, complex]:
    """Where a fixed block is drawn, beyond all places of C, and the direction there."""
    along = window.turned(cmath.rect(1, slider.way))
    a = window(positions[0].places[0])
    ends = [((on_paper(position, window)[2] - a) * along.conjugate()).real for position in positions]
    foot = on_paper(positions[0], window)[2] - along * ends[0]
    way = 1.0 if sum(ends) >= 0 else -1.0
    return foot + along * way * (max(way * end for end in ends) + 2 * symbols.BLOCK.real), along * way


def _sliding_bar(slider: SliderCrank, positions: Row, number: int, window: Window, pen: PenName) -> list[Mark]:
    """The bar from C through the fixed block, under its hinge."""
    at, along = _block_place(slider, positions, window)
    c = on_paper(positions[number], window)[2]
    outline: PenName = "outline" if pen == "visible" else "thin"
    return [Stroke((c, at + along * _PAST), pen), Disc(c, symbols.HINGE, outline, "paper")]


def _fixed_block(slider: SliderCrank, positions: Row, window: Window) -> list[Mark]:
    """The block with the ground under it."""
    at, along = _block_place(slider, positions, window)
    side = guide_side(at, at, along)
    foot = at + side * symbols.BLOCK.imag / 2
    return [*_block(at, along, "outline"), *symbols.guide(foot - 7 * along, foot + 7 * along, side)]


def guide_side(foot: Place, a: Place, along: complex) -> complex:
    """The side of a guide away from A, or the lower one of a guide through A."""
    normal = 1j * along
    off = ((a - foot) * normal.conjugate()).real
    if abs(off) < 4.0:
        return normal if (normal.imag, normal.real) > (0, 0) else -normal
    return -normal if off > 0 else normal


def _links(linkage: Linkage, position: Position, window: Window, pen: PenName) -> list[Mark]:
    places = on_paper(position, window)
    outline: PenName = "outline" if pen == "visible" else "thin"
    marks: list[Mark] = [Stroke((places[0], places[1]), pen)]
    if isinstance(linkage, GuideBar):
        marks += _bar(linkage, position, window, pen)
        moving: tuple[int, ...] = (1,)
    else:
        marks.append(Stroke(tuple(places[1:]), pen))
        moving = (1, 2)
        if isinstance(linkage, SliderCrank) and not linkage.block:
            marks += _block(places[2], window.turned(cmath.rect(1, linkage.way)), outline)
    marks += [Disc(places[k], symbols.HINGE, outline, "paper") for k in moving]
    return marks


def _block(at: Place, along: complex, pen: PenName) -> list[Mark]:
    x, y = along * symbols.BLOCK.real / 2, 1j * along * symbols.BLOCK.imag / 2
    return [Stroke((at + x + y, at + x - y, at - x - y, at - x + y), pen, closed=True, fill="paper")]


def _bar(bar: GuideBar, position: Position, window: Window, pen: PenName) -> list[Mark]:
    """The bar from where it is hinged past its block, welded to its arm where it has an offset."""
    _, b, c = on_paper(position, window)
    along = window.turned(cmath.rect(1, position.turn))
    hinge, block = (b, c) if bar.block else (c, b)
    foot = block + along * ((hinge - block) * along.conjugate()).real
    way = 1.0 if ((block - foot) * along.conjugate()).real >= 0 else -1.0
    marks: list[Mark] = []
    if abs(foot - hinge) > 0.05:
        marks.append(Stroke((hinge, foot), pen))
    marks.append(Stroke((foot, block + way * along * _PAST), pen))
    if abs(foot - hinge) > 0.05 and pen == "visible":
        marks += symbols.corner(foot, hinge, block)
    marks += _block(block, along, "outline" if pen == "visible" else "thin")
    if bar.block:
        down = 1j * along * symbols.BLOCK.imag / 2
        marks += symbols.pivot(block, down / abs(down)) if pen == "visible" else []
    return marks


def _fixed_hinges(linkage: Linkage, position: Position, window: Window) -> list[Mark]:
    return [Disc(window(position.places[k]), symbols.HINGE, "outline", "paper") for k in _fixed(linkage)]


def _names(linkage: Linkage, positions: Row, window: Window, primes: bool) -> list[Wanted]:
    fixed = _fixed(linkage)
    centre = sum(values(positions)) / len(values(positions))
    wanted: list[Wanted] = []
    for k, name in enumerate(linkage.names):
        for number, position in enumerate(positions[:1] if k in fixed else positions, start=1):
            at = window(position.places[k])
            label = numbered(name, None if k in fixed or len(positions) == 1 else number, primes)
            wanted.append(Wanted(label, at, gap=symbols.HINGE + 0.4, away=at - window(centre)))
    return wanted
