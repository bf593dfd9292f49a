"""The table of results on the sheet: what was asked in bold, the rest as far as there is room."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property, lru_cache
from itertools import pairwise

from graphkin.construction import Node, Plane, Plot
from graphkin.errors import Lang
from graphkin.mechanism import FRAME
from graphkin.planning import Method
from graphkin.say.noise import Usual
from graphkin.sheet.lettering import (
    Label,
    Run,
    bold,
    link_label,
    number,
    plain,
    point_label,
    quantity_label,
    vector_label,
    width,
)
from graphkin.sheet.marks import Mark, Place, Stroke, Text
from graphkin.value import frozen

PITCH = 4.2
"""From base line to base line [mm]."""
SIZE = 3.0
"""Letters of the table [mm]."""
_GAP, _CLOSE, _BETWEEN = 2.6, 1.0, 6.0
_MOST_ROWS = 12
Cell = tuple[float | None, float]
"""Widths of a number up to its point, None where it is no number, and of the whole of what is written [mm]."""
_SENSE: dict[Lang, tuple[str, str]] = {"en": ("ccw", "cw"), "zh": ("逆", "顺")}


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


def _speed(usual: Usual, value: float) -> Label:
    return number(usual.motion(value, "velocity"))


def _acceleration(usual: Usual, value: float) -> Label:
    return number(usual.motion(value, "acceleration"))


@frozen
class _Results:
    """The tables in the making."""

    method: Method
    plot: Plot
    lang: Lang
    usual: Usual

    def asked(self, name: str, *quantities: str) -> bool:
        """Whether the problem asks for one of these quantities of what bears the name."""
        words = [text.replace("/", " ").split() for text in self.method.mechanism.ask]
        return any(pair[0] in quantities and pair[1] == name for told in words for pair in pairwise(told))

    def told(self, name: str, label: Label, quantity: str) -> Label:
        """A value, in bold where it is asked for."""
        return bold(label) if self.asked(name, quantity) else label

    def links(self) -> Table:
        """Angular velocities and accelerations, and their sense in a column of its own."""
        machine, plot = self.method.mechanism, self.plot
        head = (
            plain({"en": "link", "zh": "构件"}[self.lang]), _unit(quantity_label("ω", ""), "rad/s"), (),
            _unit(quantity_label("α", ""), "rad/s²"), (),
        )  # fmt: skip
        rows = []
        for name in (name for name in machine.moving if name in plot.omega):
            called = machine.called(name)
            label = link_label(called)
            row = [bold(label) if self.asked(called, "omega", "alpha", "theta") else label]
            turns = (self.usual.rate(float(plot.omega[name]), "velocity"),
                     self.usual.rate(float(plot.alpha[name]), "acceleration"))  # fmt: skip
            for kind, value in zip(("omega", "alpha"), turns, strict=True):
                row += [self.told(called, one, kind) for one in self.turning(value)]
            rows.append(tuple(row))
        return Table(head, tuple(rows))

    def turning(self, value: float) -> tuple[Label, Label]:
        """`3.919` and `cw`."""
        if not value:
            return plain("0"), ()
        return number(abs(value)), plain(_SENSE[self.lang][value < 0])

    def points(self) -> Table:
        """Speeds and accelerations of the moving points."""
        word = {"en": "point", "zh": "点"}[self.lang]
        head = (plain(word), _unit(quantity_label("v", ""), "m/s"), _unit(quantity_label("a", ""), "m/s²"))
        method, plot, usual = self.method, self.plot, self.usual
        primed = {node.of: name for name, node in method.acceleration.nodes.items() if node.site is not None}
        rows = []
        for node in method.velocity.nodes.values():
            if node.of in primed and _moves(method, node):
                label = point_label(node.of)
                speed = _speed(usual, abs(plot.velocity[node.name]))
                other = _acceleration(usual, abs(plot.acceleration[primed[node.of]]))
                name = bold(label) if self.asked(node.of, "v", "a") else label
                rows.append((name, self.told(node.of, speed, "v"), self.told(node.of, other, "a")))
        return Table(head, tuple(rows))

    def parts(self) -> Table:
        """Relative motions of coincident points: velocity, Coriolis and relative acceleration."""
        head = (
            plain(""), _unit(quantity_label("v", "", "r"), "m/s"), _unit(quantity_label("a", "", "k"), "m/s²"),
            _unit(quantity_label("a", "", "r"), "m/s²"),
        )  # fmt: skip
        found: list[tuple[Label, ...]] = []
        arrows = self.method.acceleration.vectors()
        at, usual = self.plot.acceleration, self.usual
        for name, term in self.method.velocity.vectors().items():
            low = name.partition("_")[2]
            pair = [arrows.get(f"a^{part}_{low}") for part in ("k", "r")]
            if not any(pair):
                continue
            label, spoken = _pair_label(low), "".join(run.text for run in _pair_label(low))
            speed = _speed(usual, abs(self.plot.velocity[term.head] - self.plot.velocity[term.tail]))
            sizes = [_acceleration(usual, abs(at[t.head] - at[t.tail])) if t else plain("") for t in pair]
            values = zip((speed, *sizes), ("v", "a_k", "a_r"), strict=True)
            first = bold(label) if self.asked(spoken, "v", "a_k", "a_r") else label
            found.append((first, *(self.told(spoken, value, kind) for value, kind in values)))
        told = [k for k in range(len(head)) if not k or any(run.text for row in found for run in row[k])]
        return Table(tuple(head[k] for k in told), tuple(tuple(row[k] for k in told) for row in found))

    def slide(self, name: str) -> Label:
        """What people call it; a name of the file in italics."""
        title = self.method.mechanism.slide_title(name, self.lang)
        return plain(title, title.isascii())

    def slides(self) -> Table:
        """Displacements that have a name, with their rates."""
        head = (
            plain(""), _unit(plain("s", True), "mm"), _unit(plain("ds/dt", True), "m/s"),
            _unit(plain("d²s/dt²", True), "m/s²"),
        )  # fmt: skip
        plot, usual = self.plot, self.usual
        rows = (
            (
                bold(self.slide(slide.name)) if self.asked(slide.name, "s") else self.slide(slide.name),
                self.told(slide.name, number(1000 * float(plot.s[slide.name])), "s"),
                _speed(usual, float(plot.s_rate.get(slide.name, 0.0))),
                _acceleration(usual, float(plot.s_acceleration.get(slide.name, 0.0))),
            )
            for slide in self.method.mechanism.slides
            if slide.named and slide.name in plot.s
        )
        return Table(head, tuple(rows))


_PLANES: dict[str, Plane] = {
    "ω": "velocity", "v": "velocity", "ds/dt": "velocity", "α": "acceleration", "a": "acceleration",
    "d²s/dt²": "acceleration",
}  # fmt: skip
"""Whose colour the values of a column have, by its letter."""


def tables(method: Method, plot: Plot, lang: Lang) -> list[Table]:
    """Links, points, coincident points, slides; empty ones left out."""
    results = _Results(method, plot, lang, Usual.of(plot))
    found = (results.links(), results.points(), results.parts(), results.slides())
    return [table for table in found if table.rows]


def _unit(label: Label, unit: str) -> Label:
    return (*label, Run(f" [{unit}]"))


def _moves(method: Method, node: Node) -> bool:
    """Whether a point of the polygon is a named point of a moving link."""
    unnamed = method.mechanism.unnamed
    return node.site is not None and node.site.point not in unnamed and node.site.link != FRAME


def _pair_label(low: str) -> Label:
    """`B3B2` as a row's name: the subscript of a relative velocity."""
    return tuple(Run(run.text, run.italic) for run in vector_label(f"v_{low}")[1:])


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
