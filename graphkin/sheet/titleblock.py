"""Tables; and the foot of a sheet: title, source, scales, a line of 100 mm, and what has no room elsewhere over it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cache, cached_property, lru_cache
from math import ceil

from graphkin.base.rooms import Room
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism
from graphkin.say.catalogue import say
from graphkin.sheet.lettering import LABEL, LEAST, TITLE, Label, Run, plain, width
from graphkin.sheet.marks import Mark, Place, Shows, Stroke, Text
from graphkin.sheet.paper import Paper, written
from graphkin.sheet.text_blocks import Ladder, WrittenLines, broken

PITCH = 4.9  # from base line to base line [mm]
_GAP, _CLOSE, _BETWEEN = 2.6, 1.0, 6.0
_WHOLE, _MOST_ROWS = 6, 12  # a table of up to so many rows is whole; one of more than so many is not
_PLANES: dict[str, Plane] = {"s]": "velocity", "s²]": "acceleration"}
"""The plane whose colour the values of a column have, by how its unit ends."""


@frozen
class Table:
    """A heading and rows of labels; numbers under one another stand point under point."""

    head: tuple[Label, ...]
    rows: tuple[tuple[Label, ...], ...]
    steps: tuple[int, ...] = ()  # of rows that come one after the other

    @cached_property
    def widths(self) -> list[float]:
        wide = [[self.before(row[k], k) + width(row[k], LABEL) for row in self.rows] for k in range(len(self.head))]
        return [max([width(head, LABEL), *own]) for head, own in zip(self.head, wide, strict=True)]

    @cached_property
    def _points(self) -> list[float]:
        """The width of each column's widest number before its point [mm]."""
        return [max([_whole(row[k]) or 0.0 for row in self.rows], default=0.0) for k in range(len(self.head))]

    @cached_property
    def wide(self) -> float:
        """Width of the whole [mm]."""
        return sum(self.widths) + sum(self.gaps)

    @property
    def gaps(self) -> list[float]:
        """The gap after each column; less before a column without a heading [mm]."""
        return [_GAP if label else _CLOSE for label in self.head[1:]] + [0.0]

    def before(self, cell: Label, column: int) -> float:
        """The room before a number, so that its point stands under the others' [mm]."""
        own = _whole(cell)
        return 0.0 if own is None else self._points[column] - own

    @cached_property
    def cut(self) -> Callable[[int], list[Table]]:
        """In parts of so many rows; it is tried on many papers."""
        return cache(lambda count: [Table(self.head, self.rows[k : k + count], self.steps[k : k + count])
                                    for k in range(0, len(self.rows), count)])  # fmt: skip


@lru_cache(4096)
def _whole(cell: Label) -> float | None:
    """Width of a number up to its point; of the whole number where it has none; None where it is no number [mm]."""
    first = cell[0] if cell else Run("")
    whole = re.match(r"−?\d+", first.text)
    return width((first._replace(text=whole[0]),), LABEL) if whole is not None and not first.italic else None


def arranged(tables: Sequence[Table], room: float) -> TableBlock:
    """Tables side by side in `room` mm, in one or two tiers, whichever is lower; what has no room is left out."""
    rows = sum(len(table.rows) for table in tables)
    splits = [(tables[:split], tables[split:]) for split in range(1, len(tables) + 1)]
    blocks = (TableBlock([_cut(tier, room) for tier in tiers if tier]) for tiers in splits)
    return min(blocks, key=lambda block: block.size.imag + 20 * (rows - block.rows), default=TableBlock([]))


def _cut(tier: Sequence[Table], room: float) -> list[Table]:
    """Tables cut to as few rows as their room allows, each into like parts."""
    for rows in range(_WHOLE, _MOST_ROWS + 1):
        counts = (len(table.rows) / ceil(len(table.rows) / rows) for table in tier)
        parts = [part for table, count in zip(tier, counts, strict=True) for part in table.cut(ceil(count))]
        if across(parts) <= room:
            return parts
    kept = [table.cut(_MOST_ROWS)[0] for table in tier]
    while across(kept) > room:
        kept.pop()
    return kept


def height_of(tiers: list[list[Table]]) -> float:
    """Height of arranged tables [mm]."""
    return sum(PITCH * (1 + max((len(table.rows) for table in tier), default=0)) + 2.5 for tier in tiers)


def across(tables: Sequence[Table]) -> float:
    """The width of tables side by side [mm]."""
    return sum(table.wide for table in tables) + _BETWEEN * max(0, len(tables) - 1)


@frozen
class TableBlock:
    """Tables in tiers, as one block; `lost`: the rows for which there is no room."""

    tiers: list[list[Table]]
    lost: int = 0

    @classmethod
    def shapes(cls, own: list[Table]) -> list[TableBlock]:
        """In one tier or two, each in its own, cut to some widths; none that takes more room both ways than another."""
        tiers = [[own], *([own[:k], own[k:]] for k in range(1, len(own))), [[table] for table in own]]
        blocks = [*map(cls, tiers), *(arranged(own, wide) for wide in _WIDTHS)]
        sizes = {block.size: block for block in blocks if block.rows == blocks[0].rows}
        least = [size for size in sizes
                 if not any(s != size and s.real <= size.real and s.imag <= size.imag for s in sizes)]  # fmt: skip
        return [sizes[size] for size in least]

    @property
    def rows(self) -> int:
        return sum(len(table.rows) for tier in self.tiers for table in tier)

    @property
    def size(self) -> complex:
        return complex(max(map(across, self.tiers), default=0.0), height_of(self.tiers))

    def marks(self, corner: Place) -> Iterator[Mark]:
        for tier in self.tiers:
            pen = corner
            for part in tier:
                for k, row in enumerate((part.head, *part.rows)):
                    at = pen + 1j * (PITCH * (k + 0.75) + (0.6 if k else 0))
                    for column, (cell, wide, gap) in enumerate(zip(row, part.widths, part.gaps, strict=True)):
                        if cell:
                            head = part.head[column]
                            accent = _PLANES.get(head[-1].text.partition("/")[2]) if k and head else None
                            step = part.steps[k - 1] if k and part.steps else None
                            before = part.before(cell, column) if k else 0.0
                            yield Text(cell, at + before, LABEL, step, accent=accent)
                        at += wide + gap
                under = pen + 1j * (PITCH * 1.05)
                yield Stroke((under, under + part.wide), "thin")
                pen += part.wide + _BETWEEN
            corner += 1j * height_of([tier])


_WIDTHS = (110.0, 75.0, 50.0, 32.0)  # of blocks of tables [mm]
FOOT = 14.0  # height of the footer [mm]
_RULER, _NAME = 100.0, "graphkin"


@frozen
class Strip:
    """The foot of a sheet over title, source and scales: tables of results, sentences under them,
    equations that have no room with their polygons, notes beside the scales, further scales that no figure tells.
    least: room for all that stands over the footer, at least [mm]."""

    found: Sequence[Table] = ()
    told: Sequence[str] = ()
    equations: Sequence[Ladder] = ()
    notes: Sequence[Label] = ()
    further: Mapping[Plane, float] = field(default_factory=dict)
    least: float = 0.0

    def blocks(self, paper: Paper) -> list[TableBlock | WrittenLines | Ladder]:
        """All that stands over the footer, one under the other."""
        wide = tables_room(paper)
        words = WrittenLines.sentences(self.told, wide, LABEL)
        return [arranged(self.found, wide), words, *(each.within(wide) for each in self.equations)]

    def height(self, paper: Paper) -> float:
        """All that it needs on a paper [mm]."""
        above = max(self.least, sum(block.size.imag for block in self.blocks(paper)))
        return FOOT + (above + 2.5 if above else 0.0)

    def marks(self, machine: Mechanism, paper: Paper, scales: Mapping[Plane, float], lang: Lang) -> Iterator[Mark]:
        """The drawing frame, the footer, and what stands over that."""
        _, room = paper.divided(self.height(paper))
        yield Stroke(paper.frame.corners, "visible", closed=True)
        for top in dict.fromkeys((room.top, room.bottom - FOOT)):
            yield Stroke((complex(room.left, top), complex(room.right, top)), "outline")
        corner = complex(room.left + 3, room.top + 1.5)
        for block in self.blocks(paper):
            own = block.plane if isinstance(block, Ladder) else None
            yield from (replace(m, accent=own) if own and isinstance(m, Text) else m for m in block.marks(corner))
            corner += 1j * block.size.imag
        foot = Room(room.left + 3, room.bottom - FOOT, room.right - 3, room.bottom)
        told = [*(written(plane, scale) for plane, scale in {**scales, **self.further}.items()), *self.notes]
        yield from _footer(machine, foot, told, lang, _RULER / paper.times)


def tables_room(paper: Paper) -> float:
    """The width of what stands over the footer [mm]."""
    return paper.frame.size.real - 6


def _footer(machine: Mechanism, room: Room, told: Sequence[Label], lang: Lang, ruler: float) -> Iterator[Mark]:
    """Title, scales and notes; under them source, a line of 100 mm to lay a ruler on, and the program's name."""
    free = room.size.real - sum(width(label, LABEL) + 4 for label in told)
    title = machine.headline(lang)
    size = TITLE if width(plain(title), TITLE) <= free else LABEL
    pen, line = complex(room.left, room.top + 5.8), two_lines(title, size, free)[:1]
    yield from (Text(plain(text), pen, size) for text in line)
    at = complex(room.left + free + 4, pen.imag)
    for label in told:
        yield Text(label, at, LABEL)
        at += width(label, LABEL) + 4
    name, low = plain(_NAME), room.top + 12.2
    yield Text(name, complex(room.right - width(name, LEAST), low), LEAST)
    at = complex(room.right - width(name, LEAST) - 5 - ruler, low)
    yield Stroke((at, at + ruler), "thin", shows=Shows("", "ruler", plane="position"))
    yield from (Stroke((at + x - 1j, at + x + 1j), "thin") for x in (0, ruler))
    yield from (Stroke((at + x - 0.5j, at + x), "hatch") for x in (ruler * k / 10 for k in range(1, 10)))
    yield Text(plain(say("sheet.ruler", lang)), at + 2 - 1.3j, LEAST)
    source = two_lines(machine.credit(lang), LEAST, at.real - room.left - 4)
    for k, text in enumerate(source):
        yield Text(plain(text), complex(room.left, low + 1.1 * LEAST * (k + 1 - len(source))), LEAST)


def two_lines(text: str, size: float, room: float) -> list[str]:
    """At most two lines that fit the room; what is longer ends in dots."""
    first, *others = [*broken(text, room, size), *[""] * (not text)]
    rest, dots = " ".join(others), width(plain("..."), size)
    return [first, *others] if len(others) < 2 else [first, next(broken(rest, room - dots, size)) + "..."]
