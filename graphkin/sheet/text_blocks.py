"""Text on paper in lines: labels, sentences, and vector equations with what is known under each term."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import repeat

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.say.ladder import Rung
from graphkin.sheet.lettering import LABEL, LEAST, Label, box, formula, joined, plain, width
from graphkin.sheet.marks import Disc, Mark, Place, Stroke, Text

LINE = 1.4  # from base line to base line, as a part of the letters' size
_INDENT = 2.5  # the indent of the further lines of a sentence [mm]
_MOST = 16  # lines in a strip; what is longer is cut
_STOPS = r"[\u3001\u3002\uff0c\uff1b\uff09]?"
_WORD = r"[^\s\u2e80-\uffef]+"
_PIECE = rf"{_WORD}(?: [=≈<>] {_WORD})*{_STOPS}|[\u2e80-\uffef]{_STOPS}|\s+"
_LATIN = r"\S+(?: [=≈<>] \S+)*|\s+"  # the same of a text without wide letters, which is soon compiled


def broken(text: str, room: float, size: float) -> Iterator[str]:
    """Lines that fit a width [mm]: broken at blanks, and between Chinese characters."""
    line = ""
    for piece in re.findall(_PIECE if max(text, default="") >= "\u2e80" else _LATIN, text):
        if line and width(formula((line + piece).rstrip()), size) > room:
            yield line.rstrip()
            line = piece.lstrip()
        else:
            line += piece
    if line.strip():
        yield line.rstrip()


@frozen
class WrittenLines:
    """Lines of letters of one size [mm], and how far each stands in."""

    lines: tuple[Label, ...]
    letters: float
    into: tuple[float, ...] = ()

    @classmethod
    def of(cls, labels: Sequence[Label], room: float, letters: float) -> WrittenLines:
        """As many labels on each line as fit its width [mm]."""
        lines: list[list[Label]] = []
        for label in labels:
            if lines and width(joined([*lines[-1], label], ",  "), letters) <= room:
                lines[-1].append(label)
            else:
                lines.append([label])
        return cls(tuple(joined(line, ",  ") for line in lines), letters)

    @classmethod
    def sentences(cls, texts: Sequence[str], room: float, letters: float) -> WrittenLines:
        """Sentences in a width [mm]; a blank at a text's beginning sets all of it in."""
        lines: list[tuple[Label, float]] = []
        for text in texts:
            own = _INDENT if text != text.lstrip() else 0.0
            pieces = broken(text.strip(), room - own - _INDENT, letters)
            lines += [(formula(line), own + (_INDENT if k else 0.0)) for k, line in enumerate(pieces)]
        lines = lines if len(lines) <= _MOST else [*lines[: _MOST - 1], (plain("…"), 0.0)]
        return cls(tuple(line for line, _ in lines), letters, tuple(into for _, into in lines))

    @property
    def size(self) -> complex:
        wide = max((width(line, self.letters) for line in self.lines), default=0.0)
        return complex(wide, LINE * self.letters * len(self.lines))

    def marks(self, corner: Place, step: int | None = None) -> Iterator[Text]:
        for k, (line, into) in enumerate(zip(self.lines, (*self.into, *repeat(0.0, len(self.lines))))):
            yield Text(line, corner + into + 1j * self.letters * (LINE * k + 1.1), self.letters, step)


RING = 0.76 * LEAST  # radius of the circle about the number of a step [mm]
_ASIDE = 0.6  # between two of them [mm]
ROW = 2 * RING + _ASIDE  # from middle to middle in a row of them [mm]


def ringed(numbers: Sequence[int], middle: Place, step: int | None) -> Iterator[Mark]:
    """The number of a step in a circle, of those that follow one another in a longer ring, `5\u20137`; side by side."""
    at = middle - ring_width(numbers) / 2
    for label, half in _runs(numbers):
        (wide, up, down), at = box(label, LEAST), at + half + RING
        if half > 0:
            turns = [cmath.rect(RING, math.pi * (k / 8 - 0.5)) for k in range(9)]
            rim = [*(at + half + turn for turn in turns), *(at - half - turn for turn in turns)]
            yield Stroke(tuple(rim), "construction", closed=True, step=step)
        else:
            yield Disc(at, RING, "construction", step=step)
        yield Text(label, at + complex(-wide / 2, (up - down) / 2), LEAST, step)
        at += half + RING + _ASIDE


def ring_width(numbers: Sequence[int]) -> float:
    """The width of these rings [mm]."""
    return sum(2 * (half + RING) + _ASIDE for _, half in _runs(numbers)) - _ASIDE


def _runs(numbers: Sequence[int]) -> Iterator[tuple[Label, float]]:
    """`4`, `6\u20138`, and half of the straight part of the ring about it, 0 of a circle [mm]."""
    last = (number for number in numbers if number + 1 not in numbers)
    for first, end in zip((number for number in numbers if number - 1 not in numbers), last, strict=True):
        label = plain(str(first) if first == end else f"{first}\u2013{end}")
        yield label, width(label, LEAST) / 2 - 0.7 * RING if first < end else 0.0


_LINES = tuple(k * LABEL for k in (1, 2.2, 3.4))  # base lines of terms and of the rows under them [mm]
_HIGH, _ON, _GAP = 3.8 * LABEL, 3.6 * LABEL, 2.2
"""Height of an equation, and of one that goes on on the next line; between columns [mm]."""


@frozen
class EquationBlock:
    """One equation with its rows, or what follows on its first line; numbers: of its steps; page: the first act that
    draws it; into: how far it stands in behind the words before its rows; high: to the next [mm]."""

    columns: tuple[tuple[Label, Label, Label], ...]
    page: int | None = None
    numbers: tuple[int, ...] = ()
    into: float = 0.0
    high: float = _HIGH

    @cached_property
    def widths(self) -> list[float]:
        wide = [max(width(label, LABEL) for label in column) for column in self.columns]
        return [max(wide[0], ring_width(self.numbers)), *wide[1:]]

    @property
    def wide(self) -> float:
        """[mm]"""
        return self.into + sum(self.widths) + _GAP * (len(self.columns) - 1)

    def marks(self, corner: Place) -> Iterator[Mark]:
        """From its upper left corner, without its numbers; each column centred, the words before the rows flush
        right."""
        pen = corner
        for k, (column, wide) in enumerate(zip(self.columns, self.widths, strict=True)):
            for label, line in zip(column, _LINES, strict=True):
                if label:
                    spare = wide - width(label, LABEL)
                    yield Text(label, pen + (spare / 2 if k else spare) + 1j * line, LABEL, self.page)
            pen += wide + _GAP + (0 if k else self.into)

    def within(self, room: float) -> Iterator[EquationBlock]:
        """As two, the equals signs one under the other, where it is wider than that [mm]."""
        head, *columns = self.columns
        cut = max((k for k, (label, _, _) in enumerate(columns) if label == plain("=")), default=0)
        if self.wide <= room or cut < 2:
            yield self
        else:
            yield replace(self, columns=(head, *columns[:cut]), high=min(self.high, _ON))
            yield replace(self, columns=(head, *columns[cut:]), numbers=(), into=self.widths[1] + _GAP)


@frozen
class Ladder:
    """The equations of a polygon one under the other, in the order of solving: they stand together or not at all."""

    blocks: tuple[EquationBlock, ...]
    plane: Plane

    @classmethod
    def of(cls, rungs: Iterable[Rung], rows: tuple[str, str], plane: Plane) -> Ladder | None:
        """None of nothing; rows: what stands before those under an equation."""
        blocks = list[EquationBlock]()
        for rung in rungs:
            if isinstance(rung.equation, str):
                row = ((), (), ()), (formula(rung.equation), (), ())
                blocks.append(EquationBlock(row, rung.page, rung.numbers, high=LINE * LABEL))
            else:
                terms = ((formula(name), formula(way), formula(size)) for name, way, size in rung.equation.columns)
                columns = (((), plain(rows[0]), plain(rows[1])), *terms)
                blocks.append(EquationBlock(columns, rung.page, rung.numbers))
        return cls(tuple(blocks), plane) if blocks else None

    @property
    def brief(self) -> Ladder:
        """Without the rows under its equations."""
        rows = ((block, (((), (), ()), *((term, (), ()) for term, _, _ in block.columns[1:]))) for block in self.blocks)
        return replace(self, blocks=tuple(replace(block, columns=own, high=LINE * LABEL) for block, own in rows))

    @property
    def size(self) -> complex:
        first = max(block.widths[0] for block in self.blocks)
        wide = max(first - block.widths[0] + block.wide for block in self.blocks)
        return complex(wide, sum(block.high for block in self.blocks))

    def marks(self, corner: Place) -> Iterator[Mark]:
        yield from self.rows(corner)
        yield from self.rings(corner)

    def rows(self, corner: Place) -> Iterator[Mark]:
        """The same without numbers."""
        for block, at in self._placed(corner):
            yield from block.marks(at - block.widths[0])

    def rings(self, corner: Place, more: Sequence[int] = ()) -> Iterator[Mark]:
        """The numbers of each equation before it, flush right; more: of all steps for which there is no other place,
        each with the last equation that begins before it."""
        placed = [(block, at) for block, at in self._placed(corner) if block.numbers]
        every = {number for block, _ in placed for number in block.numbers}
        homes = {n: max(placed, key=lambda each: (each[0].numbers[0] < n) * each[0].numbers[0])
                 for n in ({*more} - every if placed else ())}  # fmt: skip
        for block, at in placed:
            numbers = sorted({*block.numbers, *(n for n, (home, _) in homes.items() if home is block)})
            yield from ringed(numbers, at + complex(-ring_width(numbers) / 2, 0.7 * LABEL), block.page)

    def _placed(self, corner: Place) -> Iterator[tuple[EquationBlock, Place]]:
        """Each equation, and the right upper corner of the words before its rows."""
        at = corner + max(block.widths[0] for block in self.blocks)
        for block in self.blocks:
            yield block, at
            at += 1j * block.high

    def within(self, room: float) -> Ladder:
        """In a width [mm], as far as breaking its equations helps."""
        return replace(self, blocks=tuple(part for block in self.blocks for part in block.within(room)))
