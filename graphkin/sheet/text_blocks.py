"""Text on paper in lines: labels, sentences, and vector equations with what is known under each term."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property

from graphkin.base.value import frozen
from graphkin.say.entry import Entry, Sentence, VectorEquation
from graphkin.sheet.lettering import LABEL, Label, formula, joined, plain, width
from graphkin.sheet.marks import Mark, Place, Text

_PITCH = 1.45  # from base line to base line, as a part of the letters' size


@frozen
class WrittenLines:
    """Lines of letters of one size [mm]."""

    lines: tuple[Label, ...]
    letters: float

    @classmethod
    def of(cls, labels: Sequence[Label], room: float, letters: float, between: str = ",  ") -> WrittenLines:
        """As many labels on each line as fit its width [mm]."""
        lines: list[list[Label]] = []
        for label in labels:
            if lines and width(joined([*lines[-1], label], between), letters) <= room:
                lines[-1].append(label)
            else:
                lines.append([label])
        return cls(tuple(joined(line, between) for line in lines), letters)

    @property
    def size(self) -> complex:
        """Width and height [mm]."""
        wide = max((width(line, self.letters) for line in self.lines), default=0.0)
        return complex(wide, _PITCH * self.letters * len(self.lines))

    def marks(self, corner: Place, step: int | None = None) -> Iterator[Text]:
        """From their upper left corner."""
        for k, line in enumerate(self.lines):
            yield Text(line, corner + 1j * self.letters * (_PITCH * k + 1.0), self.letters, step)


LINE = 1.4  # from base line to base line, as a part of the letters' size
_INDENT = 2.5  # the indent of the further lines of a sentence [mm]
_MOST = 16  # lines in a strip; what is longer is cut
_STOPS = r"[\u3001\u3002\uff0c\uff1b\uff09]?"
_WORD = r"[^\s\u2e80-\uffef]+"
_PIECE = rf"{_WORD}(?: [=≈<>] {_WORD})*{_STOPS}|[\u2e80-\uffef]{_STOPS}|\s+"


def broken(text: str, room: float, size: float) -> Iterator[str]:
    """Lines that fit a width [mm]: broken at blanks, and between Chinese characters."""
    line = ""
    for piece in re.findall(_PIECE, text):
        if line and width(formula((line + piece).rstrip()), size) > room:
            yield line.rstrip()
            line = piece.lstrip()
        else:
            line += piece
    if line.strip():
        yield line.rstrip()


@frozen
class Paragraphs:
    """Lines with how far each stands in [mm], in letters of one size."""

    lines: tuple[tuple[str, float], ...]
    letters: float

    @classmethod
    def of(cls, texts: Sequence[str], room: float, letters: float) -> Paragraphs:
        """Sentences in a width [mm]; a blank at a text's beginning sets all of it in."""
        lines: list[tuple[str, float]] = []
        for text in texts:
            own = _INDENT if text != text.lstrip() else 0.0
            pieces = broken(text.strip(), room - own - _INDENT, letters)
            lines += [(line, own + (_INDENT if k else 0.0)) for k, line in enumerate(pieces)]
        return cls(tuple(lines if len(lines) <= _MOST else [*lines[: _MOST - 1], ("…", 0.0)]), letters)

    @property
    def height(self) -> float:
        """[mm]"""
        return LINE * self.letters * len(self.lines)

    def marks(self, corner: Place) -> Iterator[Text]:
        """From their upper left corner."""
        for k, (line, into) in enumerate(self.lines):
            yield Text(formula(line), corner + into + 1j * self.letters * (LINE * k + 1.1), self.letters)


_SIZES = (LABEL, LABEL, LABEL)
_LINES = (3.6, 8.6, 13.2)  # base lines of the terms and of the two rows under them [mm]
_HIGH, _GAP, _BETWEEN = 15.5, 2.2, 8.0


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
    blocks: list[EquationBlock] = []
    for entry in entries:
        if isinstance(entry, VectorEquation):
            blocks.append(EquationBlock((((), plain(rows[0]), plain(rows[1])), *_columns(entry))))
        elif isinstance(entry, Sentence) and entry.act is not None and blocks and blocks[-1].page is None:
            blocks[-1] = replace(blocks[-1], page=entry.act.page)
    return blocks


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
    """The size of all of them side by side, and one under the other [mm]."""
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
    pieces: list[EquationBlock] = []
    for whole in blocks:
        head, *columns = whole.columns
        cut = max(k for k, (label, _, _) in enumerate(columns) if label == plain("="))
        broken_up = (columns[:cut], columns[cut:]) if whole.size.real > room and cut else (columns,)
        pieces += [replace(whole, columns=(head, *part)) for part in broken_up]
    for block in pieces:
        if block.size.real > room:
            continue
        if lines and head_of([*lines[-1], block])[0].real <= room:
            lines[-1].append(block)
        else:
            lines.append([block])
    return lines
