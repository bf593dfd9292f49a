"""Text on paper in lines: labels, sentences, and vector equations with what is known under each term."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import pairwise, repeat

from graphkin.base.value import frozen
from graphkin.construction import Image, Plane
from graphkin.planning.method import Act, Method
from graphkin.planning.needed import acts_of_equations
from graphkin.say.entry import Entry, Sentence, VectorEquation
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


def ringed(numbers: Sequence[int], middle: Place, step: int | None) -> Iterator[Mark]:
    """The number of a step in a circle, or `3, 5\u20137` in a longer ring."""
    label = plain(_runs(numbers))
    wide, up, down = box(label, LEAST)
    if (half := ring_width(numbers) / 2 - RING) > 0:
        turns = [cmath.rect(RING, math.pi * (k / 8 - 0.5)) for k in range(9)]
        rim = [*(middle + half + turn for turn in turns), *(middle - half - turn for turn in turns)]
        yield Stroke(tuple(rim), "construction", closed=True, step=step)
    else:
        yield Disc(middle, RING, "construction", step=step)
    yield Text(label, middle + complex(-wide / 2, (up - down) / 2), LEAST, step)


def ring_width(numbers: Sequence[int]) -> float:
    """The width of that ring [mm]."""
    return max(2 * RING, width(plain(_runs(numbers)), LEAST) + 0.6 * RING if len(numbers) > 1 else 0.0)


def _runs(numbers: Sequence[int]) -> str:
    """`4, 6\u20138`."""
    first = [number for number in numbers if number - 1 not in numbers]
    last = [number for number in numbers if number + 1 not in numbers]
    return ", ".join("\u2013".join(map(str, dict.fromkeys(ends))) for ends in zip(first, last, strict=True))


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
            yield replace(self, columns=(head, *columns[:cut]), high=_ON)
            yield replace(self, columns=(head, *columns[cut:]), numbers=(), into=self.widths[1] + _GAP)


@frozen
class Ladder:
    """The equations of a polygon one under the other, in the order of solving: they stand together or not at all."""

    blocks: tuple[EquationBlock, ...]
    plane: Plane

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


def _at_once(acts: Sequence[Act], told: Collection[Act | None]) -> Iterator[Act]:
    """The steps of an equation but for those with a row of their own that are not followed at once by the others; an
    image has its row between them."""
    own = [act for act in acts if not (isinstance(act.done, Image) and act in told)]
    gaps = [act.number for act, other in pairwise(own) if other.number > act.number + 1]
    first = max(gaps, default=0)
    yield from (act for act in acts if act.number > first or act not in told)


def ladder(entries: Iterable[Entry], rows: tuple[str, str], plane: Plane, method: Method) -> Ladder | None:
    """Every equation that the words print, with the numbers of the steps that it needs, and a row for each other
    motion; None where they print none; rows: what stands before the rows."""
    equations: list[tuple[VectorEquation | str, Act | None]] = []
    for entry in entries:
        if isinstance(entry, VectorEquation):
            equations.append((entry, None))
        elif isinstance(entry, Sentence) and entry.act is not None:  # of several that are solved together, of all
            equations = [(equation, first if isinstance(equation, str) else first or entry.act)
                         for equation, first in equations]  # fmt: skip
        if isinstance(entry, Sentence) and entry.row:
            equations.append((entry.row, entry.act))
    acts = [act for equation, act in equations if act is not None and not isinstance(equation, str)]
    told = {act for equation, act in equations if isinstance(equation, str)}
    needs = [[*_at_once(own, told)] for own in acts_of_equations(method, plane, acts)]
    known = {act for each in needs for act in each if not isinstance(act.done, Image)}
    blocks, steps = list[EquationBlock](), iter(needs)
    for equation, act in equations:
        page = None if act is None else act.page
        if isinstance(equation, str) and act not in known:
            row, numbers = (((),) * 3, (formula(equation), (), ())), () if act is None else (act.number,)
            blocks.append(EquationBlock(row, page, numbers, high=LINE * LABEL))
        elif isinstance(equation, VectorEquation):
            own = () if act is None else next(steps)
            terms = ((formula(name), formula(way), formula(size)) for name, way, size in equation.columns)
            columns = (((), plain(rows[0]), plain(rows[1])), *terms)
            blocks.append(EquationBlock(columns, page, tuple(each.number for each in own if each in known)))
    return Ladder(tuple(blocks), plane) if blocks else None
