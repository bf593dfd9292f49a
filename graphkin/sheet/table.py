"""Tables on paper: headings and rows of labels, arranged side by side, cut where they are long, and drawn."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property, lru_cache

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.sheet.lettering import Label, Run, width
from graphkin.sheet.marks import Mark, Place, Stroke, Text

PITCH = 4.2
"""From base line to base line [mm]."""
SIZE = 3.0
"""Letters of the table [mm]."""
_GAP, _CLOSE, _BETWEEN = 2.6, 1.0, 6.0
_MOST_ROWS = 12
Cell = tuple[float | None, float]
"""Widths of a number up to its point, None where it is no number, and of the whole of what is written [mm]."""
_PLANES: dict[str, Plane] = {
    "ω": "velocity", "v": "velocity", "ds/dt": "velocity", "α": "acceleration", "a": "acceleration",
    "d²s/dt²": "acceleration",
}  # fmt: skip
"""Whose colour the values of a column have, by its letter."""


@frozen
class Table:
    """A heading and rows of labels; numbers under one another stand point under point."""

    head: tuple[Label, ...]
    rows: tuple[tuple[Label, ...], ...]

    @cached_property
    def widths(self) -> list[float]:
        """Width of each column [mm]."""
        return self._widths(0, len(self.rows))

    @cached_property
    def wide(self) -> float:
        return sum(self.widths) + sum(self.gaps)

    @property
    def gaps(self) -> list[float]:
        """What is free after each column; less before a column without a heading [mm]."""
        return [_GAP if label else _CLOSE for label in self.head[1:]] + [0.0]

    def before(self, cell: Label, column: int) -> float:
        """What a number leaves free before it [mm]."""
        own = _whole(cell)
        return self._points[column] - own if own is not None else 0.0

    def cut(self, count: int) -> Iterator[Table]:
        for k in range(0, len(self.rows), count):
            yield Table(self.head, self.rows[k : k + count])

    def wides(self, count: int) -> list[float]:
        """How wide the parts are into which it would be cut [mm]."""
        if count not in self._tried:
            parts, gaps = range(0, len(self.rows), count), sum(self.gaps)
            self._tried[count] = [sum(self._widths(k, k + count)) + gaps for k in parts]
        return self._tried[count]

    @cached_property
    def _tried(self) -> dict[int, list[float]]:
        """What is known of its parts, by their rows: it is tried on many papers."""
        return {}

    def _widths(self, first: int, last: int) -> list[float]:
        """Width of each column, were there only some of the rows [mm]."""
        found = []
        for head, cells in self._cells:
            some = cells[first:last]
            point = _point(some)
            wide = [(point - own if own is not None else 0.0) + whole for own, whole in some]
            found.append(max([head, *wide]))
        return found

    @cached_property
    def _points(self) -> list[float]:
        """How far before its point the widest number of each column begins [mm]."""
        return [_point(cells) for _, cells in self._cells]

    @cached_property
    def _cells(self) -> list[tuple[float, list[Cell]]]:
        """Of each column: the width of its heading, and its cells."""
        cells = [[(_whole(cell), width(cell, SIZE)) for cell in row] for row in self.rows]
        return [(width(head, SIZE), [row[k] for row in cells]) for k, head in enumerate(self.head)]


def _point(cells: list[Cell]) -> float:
    return max((own or 0.0 for own, _ in cells), default=0.0)


@lru_cache(4096)
def _whole(cell: Label) -> float | None:
    """Width of a number up to its point; of the whole number where it has none; None where it is no number [mm]."""
    first = cell[0] if cell else Run("")
    whole = re.match(r"−?\d+", first.text)
    return width((first._replace(text=whole[0]),), SIZE) if whole is not None and not first.italic else None


# --- on paper ---------------------------------------------------------------------------------


def arranged(found: list[Table], room: float) -> list[list[Table]]:
    """Tables side by side in `room` mm, in one or two tiers, whichever is lower; long ones cut.

    What has no room even so is left out, the last asked first.
    """
    best: tuple[float, list[list[Table]]] | None = None
    for split in range(1, len(found) + 1):
        tiers = [tier for tier in (found[:split], found[split:]) if tier]
        cut = [_cut(tier, room) for tier in tiers]
        height = height_of(cut)
        lost = sum(len(table.rows) for table in found) - sum(len(t.rows) for tier in cut for t in tier)
        if best is None or height + 20 * lost < best[0]:
            best = height + 20 * lost, cut
    return best[1] if best is not None else []


def _cut(tier: list[Table], room: float) -> list[Table]:
    """Tables cut to as few rows as their room allows."""
    for rows in range(3, _MOST_ROWS + 1):
        if _across([wide for table in tier for wide in table.wides(rows)]) <= room:
            return [part for table in tier for part in table.cut(rows)]
    kept: list[Table] = []
    for table in tier:
        part = next(table.cut(_MOST_ROWS))
        if _across([each.wide for each in (*kept, part)]) <= room:
            kept.append(part)
    return kept


def height_of(tiers: list[list[Table]]) -> float:
    """Height of arranged tables [mm]."""
    return sum(PITCH * (1 + max((len(table.rows) for table in tier), default=0)) + 2.5 for tier in tiers)


def _across(wides: list[float]) -> float:
    return sum(wides) + _BETWEEN * max(0, len(wides) - 1)


def drawn_tables(tiers: list[list[Table]], corner: Place) -> list[Mark]:
    """Arranged tables from their upper left corner."""
    marks: list[Mark] = []
    for tier in tiers:
        pen = corner
        for part in tier:
            marks += _drawn(part, pen)
            pen += part.wide + _BETWEEN
        corner += 1j * height_of([tier])
    return marks


def _drawn(table: Table, corner: Place) -> Iterator[Mark]:
    for k, row in enumerate((table.head, *table.rows)):
        pen = corner + 1j * (PITCH * (k + 0.75) + (0.6 if k else 0))
        for column, (cell, wide, gap) in enumerate(zip(row, table.widths, table.gaps, strict=True)):
            if cell:
                accent = _PLANES.get(table.head[column][0].text) if k and table.head[column] else None
                yield Text(cell, pen + (table.before(cell, column) if k else 0), SIZE, accent=accent)
            pen += wide + gap
    under = corner + 1j * (PITCH * 1.05)
    yield Stroke((under, under + table.wide), "thin")
