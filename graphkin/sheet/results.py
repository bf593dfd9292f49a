"""The table of results on the sheet: what was asked comes first, the rest as far as there is room."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from graphkin.errors import Lang
from graphkin.mechanism import FRAME
from graphkin.methods import Method
from graphkin.sheet.lettering import (
    Label,
    Run,
    link_label,
    number,
    plain,
    point_label,
    quantity_label,
    vector_label,
    width,
)
from graphkin.sheet.marks import Mark, Place, Stroke, Text
from graphkin.steps import Plot

__all__ = ["PITCH", "Table", "arranged", "drawn_tables", "height_of", "tables"]

PITCH = 4.1
"""From base line to base line [mm]."""
SIZE = 2.8
"""Letters of the table [mm]."""
_GAP, _BETWEEN = 2.6, 6.0
_MOST_ROWS = 12
_SENSE: dict[Lang, tuple[str, str]] = {"en": ("ccw", "cw"), "zh": ("逆", "顺")}


@dataclass(frozen=True, slots=True)
class Table:
    """A heading and rows of labels."""

    head: tuple[Label, ...]
    rows: tuple[tuple[Label, ...], ...]

    @property
    def widths(self) -> list[float]:
        """Width of each column [mm]."""
        return [max(width(row[k], SIZE) for row in (self.head, *self.rows)) for k in range(len(self.head))]

    @property
    def wide(self) -> float:
        return sum(self.widths) + _GAP * (len(self.head) - 1)

    def cut(self, count: int) -> Iterator[Table]:
        for k in range(0, len(self.rows), count):
            yield Table(self.head, self.rows[k : k + count])


def tables(method: Method, plot: Plot, lang: Lang) -> list[Table]:
    """Links, points, coincident points, slides; empty ones left out."""
    found = (_links(method, plot, lang), _points(method, plot, lang), _parts(method, plot), _slides(method, plot))
    return [table for table in found if table.rows]


def _unit(label: Label, unit: str) -> Label:
    return (*label, Run(f" [{unit}]"))


def _asked(method: Method, name: str) -> bool:
    """Whether the problem asks for something of this name."""
    return any(name in text.replace("/", " ").split() for text in method.mechanism.ask)


def _links(method: Method, plot: Plot, lang: Lang) -> Table:
    machine = method.mechanism
    word = {"en": "link", "zh": "构件"}[lang]
    head = (plain(word), _unit(quantity_label("ω", ""), "rad/s"), _unit(quantity_label("α", ""), "rad/s²"))
    names = sorted((n for n in machine.moving if n in plot.omega), key=lambda n: not _asked(method, machine.called(n)))
    rows = tuple(
        (
            link_label(machine.called(n)),
            _turning(plot.omega[n], plot.omega, lang),
            _turning(plot.alpha[n], plot.alpha, lang),
        )
        for n in names
    )
    return Table(head, rows)


def _turning(value: object, among: dict[str, object], lang: Lang) -> Label:
    """`3.919 cw`; what is nothing beside the others is 0."""
    size = float(value)  # type: ignore[arg-type]
    largest = max((abs(float(v)) for v in among.values()), default=0.0)  # type: ignore[arg-type]
    if abs(size) <= 1e-9 * largest:
        return plain("0")
    return (*number(abs(size)), Run(f" {_SENSE[lang][size < 0]}"))


def _points(method: Method, plot: Plot, lang: Lang) -> Table:
    """Speeds and accelerations of the moving points."""
    word = {"en": "point", "zh": "点"}[lang]
    head = (plain(word), _unit(quantity_label("v", ""), "m/s"), _unit(quantity_label("a", ""), "m/s²"))
    primed = {node.of: name for name, node in method.acceleration.nodes.items() if node.site is not None}
    sites = [n for n in method.velocity.nodes.values() if n.site is not None and n.of in primed]
    sites.sort(key=lambda node: not (_asked(method, node.of)))
    rows = tuple(
        (point_label(node.of), _size(plot.velocity, node.name), _size(plot.acceleration, primed[node.of]))
        for node in sites
        if node.site is not None and node.site.point[0].isupper() and node.site.link != FRAME
    )
    return Table(head, rows)


def _size(points: dict[str, complex], name: str, tail: complex = 0j) -> Label:
    largest = max((abs(v) for v in points.values()), default=0.0)
    size = abs(points[name] - tail)
    return number(size if size > 1e-9 * largest else 0.0)


def _parts(method: Method, plot: Plot) -> Table:
    """Relative motions: their velocity, and their Coriolis and relative acceleration."""
    found: list[tuple[Label, ...]] = []
    parts = {k: t for k, t in method.acceleration.vectors().items() if t.part in ("k", "r")}
    for name, term in method.velocity.vectors().items():
        low = name.partition("_")[2]
        if f"a^r_{low}" not in parts and f"a^k_{low}" not in parts:
            continue
        row = [point_label_pair(low), _size(plot.velocity, term.head, plot.velocity[term.tail])]
        for part in ("k", "r"):
            other = parts.get(f"a^{part}_{low}")
            at = plot.acceleration
            row.append(_size(at, other.head, at[other.tail]) if other is not None else plain(""))
        found.append(tuple(row))
    found.sort(key=lambda row: not _asked(method, "".join(run.text for run in row[0])))
    head = (
        plain(""), _unit(quantity_label("v", "", "r"), "m/s"), _unit(quantity_label("a", "", "k"), "m/s²"),
        _unit(quantity_label("a", "", "r"), "m/s²"),
    )  # fmt: skip
    return Table(head, tuple(found))


def point_label_pair(low: str) -> Label:
    """`B3B2` as a row's name: the subscript of a relative velocity."""
    return tuple(Run(run.text, run.italic) for run in vector_label(f"v_{low}")[1:])


def _slides(method: Method, plot: Plot) -> Table:
    head = (
        plain(""), _unit(plain("s", True), "mm"), _unit(plain("ds/dt", True), "m/s"),
        _unit(plain("d²s/dt²", True), "m/s²"),
    )  # fmt: skip
    rows = tuple(
        (plain(slide.name, True), *(number(float(v)) for v in _displacement(plot, slide.name)))
        for slide in method.mechanism.slides
        if slide.named and slide.name in plot.s and not math.isnan(float(plot.s[slide.name]))
    )
    return Table(head, rows)


def _displacement(plot: Plot, slide: str) -> tuple[float, float, float]:
    rate, speed_up = plot.s_rate.get(slide, 0.0), plot.s_acceleration.get(slide, 0.0)
    return 1000 * float(plot.s[slide]), float(rate), float(speed_up)


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
        parts = [part for table in tier for part in table.cut(rows)]
        if _across(parts) <= room:
            return parts
    kept: list[Table] = []
    for table in tier:
        part = next(table.cut(_MOST_ROWS))
        if _across([*kept, part]) <= room:
            kept.append(part)
    return kept


def height_of(tiers: list[list[Table]]) -> float:
    """Height of arranged tables [mm]."""
    return sum(PITCH * (1 + max((len(table.rows) for table in tier), default=0)) + 2.5 for tier in tiers)


def _across(parts: list[Table]) -> float:
    return sum(part.wide for part in parts) + _BETWEEN * max(0, len(parts) - 1)


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
        for cell, wide in zip(row, table.widths, strict=True):
            if cell:
                yield Text(cell, pen, SIZE)
            pen += wide + _GAP
    under = corner + 1j * (PITCH * 1.05)
    yield Stroke((under, under + table.wide), "thin")
