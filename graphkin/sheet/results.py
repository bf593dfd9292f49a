"""The table of results on the sheet: what was asked comes first, the rest as far as there is room."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.construction import Node, Plot
from graphkin.errors import Lang
from graphkin.mechanism import FRAME
from graphkin.planning import Method
from graphkin.say.noise import Usual
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
from graphkin.value import frozen

PITCH = 4.1
"""From base line to base line [mm]."""
SIZE = 2.8
"""Letters of the table [mm]."""
_GAP, _BETWEEN = 2.6, 6.0
_MOST_ROWS = 12
_SENSE: dict[Lang, tuple[str, str]] = {"en": ("ccw", "cw"), "zh": ("逆", "顺")}


@frozen
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

    def asked(self, name: str) -> bool:
        """Whether the problem asks for something of this name."""
        return any(name in text.replace("/", " ").split() for text in self.method.mechanism.ask)

    def links(self) -> Table:
        """Angular velocities and accelerations with their sense."""
        machine, plot = self.method.mechanism, self.plot
        head = (
            plain({"en": "link", "zh": "构件"}[self.lang]), _unit(quantity_label("ω", ""), "rad/s"),
            _unit(quantity_label("α", ""), "rad/s²"),
        )  # fmt: skip
        names = [name for name in machine.moving if name in plot.omega]
        names.sort(key=lambda name: not self.asked(machine.called(name)))
        rows = (
            (
                link_label(machine.called(name)),
                self.turning(self.usual.rate(float(plot.omega[name]), "velocity")),
                self.turning(self.usual.rate(float(plot.alpha[name]), "acceleration")),
            )
            for name in names
        )
        return Table(head, tuple(rows))

    def turning(self, value: float) -> Label:
        """`3.919 cw`."""
        if not value:
            return plain("0")
        return (*number(abs(value)), Run(f" {_SENSE[self.lang][value < 0]}"))

    def points(self) -> Table:
        """Speeds and accelerations of the moving points."""
        word = {"en": "point", "zh": "点"}[self.lang]
        head = (plain(word), _unit(quantity_label("v", ""), "m/s"), _unit(quantity_label("a", ""), "m/s²"))
        method, plot, usual = self.method, self.plot, self.usual
        primed = {node.of: name for name, node in method.acceleration.nodes.items() if node.site is not None}
        nodes = [node for node in method.velocity.nodes.values() if node.of in primed and _moves(method, node)]
        nodes.sort(key=lambda node: not self.asked(node.of))
        rows = (
            (
                point_label(node.of),
                _speed(usual, abs(plot.velocity[node.name])),
                _acceleration(usual, abs(plot.acceleration[primed[node.of]])),
            )
            for node in nodes
        )
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
            speed = abs(self.plot.velocity[term.head] - self.plot.velocity[term.tail])
            sizes = (_acceleration(usual, abs(at[t.head] - at[t.tail])) if t else plain("") for t in pair)
            found.append((_pair_label(low), _speed(usual, speed), *sizes))
        found.sort(key=lambda row: not self.asked("".join(run.text for run in row[0])))
        return Table(head, tuple(found))

    def slides(self) -> Table:
        """Displacements that have a name, with their rates."""
        head = (
            plain(""), _unit(plain("s", True), "mm"), _unit(plain("ds/dt", True), "m/s"),
            _unit(plain("d²s/dt²", True), "m/s²"),
        )  # fmt: skip
        plot, usual = self.plot, self.usual
        rows = (
            (
                plain(slide.name, True),
                number(1000 * float(plot.s[slide.name])),
                _speed(usual, float(plot.s_rate.get(slide.name, 0.0))),
                _acceleration(usual, float(plot.s_acceleration.get(slide.name, 0.0))),
            )
            for slide in self.method.mechanism.slides
            if slide.named and slide.name in plot.s
        )
        return Table(head, tuple(rows))


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
