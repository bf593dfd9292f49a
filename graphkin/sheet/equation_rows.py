"""Vector equations on the sheet: terms in columns, under each what is known of its direction and its size."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import chain

from graphkin.base.value import frozen
from graphkin.say.entry import Entry, Sentence, VectorEquation
from graphkin.sheet.formula import formula
from graphkin.sheet.lettering import Label, plain, width
from graphkin.sheet.marks import Mark, Place, Text
from graphkin.sheet.paper import BODY, LEAST

_SIZES = (BODY, LEAST, LEAST)
_LINES = (3.2, 7.3, 11.2)
"""Base lines of the terms and of the two rows under them [mm]."""
_HIGH, _GAP, _BETWEEN = 13.0, 2.2, 8.0


@frozen
class EquationBlock:
    """One equation with its rows; `page`: the first act that draws it."""

    columns: tuple[tuple[Label, Label, Label], ...]
    page: int | None = None

    @cached_property
    def widths(self) -> list[float]:
        return [max(width(label, size) for label, size in zip(column, _SIZES, strict=True)) for column in self.columns]

    @property
    def size(self) -> complex:
        """Width and height [mm]."""
        return complex(sum(self.widths) + _GAP * (len(self.columns) - 1), _HIGH)

    def marks(self, corner: Place) -> Iterator[Mark]:
        """From its upper left corner; each column centred, the words before the rows flush right."""
        pen = corner
        for k, (column, wide) in enumerate(zip(self.columns, self.widths, strict=True)):
            for label, size, line in zip(column, _SIZES, _LINES, strict=True):
                if label:
                    spare = wide - width(label, size)
                    yield Text(label, pen + (spare / 2 if k else spare) + 1j * line, size, self.page)
            pen += wide + _GAP


def equation_blocks(entries: Iterable[Entry], rows: tuple[str, str]) -> list[EquationBlock]:
    """Every equation that the words print, with the number of the act that they tell next.

    rows  what stands before the rows
    """
    found: list[EquationBlock] = []
    for entry in entries:
        if isinstance(entry, VectorEquation):
            found.append(_block(entry, rows))
        elif isinstance(entry, Sentence) and entry.act is not None and found and found[-1].page is None:
            found[-1] = replace(found[-1], page=entry.act.page)
    return found


def _block(equation: VectorEquation, rows: tuple[str, str]) -> EquationBlock:
    return EquationBlock((((), plain(rows[0]), plain(rows[1])), *_columns(equation)))


def _columns(equation: VectorEquation) -> Iterator[tuple[Label, Label, Label]]:
    if equation.front:
        yield formula(equation.front), (), ()
    for k, side in enumerate(equation.sides):
        if k or equation.front:
            yield plain("="), (), ()
        for n, arrow in enumerate(side):
            if n:
                yield plain("+"), (), ()
            yield formula(arrow.name), formula(arrow.direction), formula(arrow.size)


def head_of(blocks: Sequence[EquationBlock]) -> tuple[complex, complex]:
    """What all of them take side by side, and one under the other [mm]."""
    sizes = [block.size for block in blocks]
    beside = complex(sum(size.real for size in sizes) + _BETWEEN * (len(sizes) - 1), max(s.imag for s in sizes))
    return beside, complex(max(size.real for size in sizes), sum(size.imag for size in sizes))


def laid_out(blocks: Sequence[EquationBlock], corner: Place, room: float) -> list[Mark]:
    """Side by side where they fit a width [mm], else one under the other."""
    beside = head_of(blocks)[0].real <= room
    marks: list[Mark] = []
    for block in blocks:
        marks += block.marks(corner)
        corner += block.size.real + _BETWEEN if beside else 1j * block.size.imag
    return marks


def flowed(blocks: Sequence[EquationBlock], room: float) -> list[list[EquationBlock]]:
    """Line by line as many as a width holds [mm]; one that is wider is broken before its last equals sign.

    What is still wider than that is left out.
    """
    lines: list[list[EquationBlock]] = []
    for block in chain.from_iterable(_broken(whole, room) for whole in blocks):
        if block.size.real > room:
            continue
        if lines and head_of([*lines[-1], block])[0].real <= room:
            lines[-1].append(block)
        else:
            lines.append([block])
    return lines


def _broken(block: EquationBlock, room: float) -> tuple[EquationBlock, ...]:
    head, *columns = block.columns
    cut = max(k for k, (label, _, _) in enumerate(columns) if label == plain("="))
    if block.size.real <= room or not cut:
        return (block,)
    return replace(block, columns=(head, *columns[:cut])), replace(block, columns=(head, *columns[cut:]))
