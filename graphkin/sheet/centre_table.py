"""The table of centres: in the order in which they are found, where each is, and how it was found."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from graphkin.base.value import frozen
from graphkin.construction.drafting import LineStep, Pricked, drawn_through
from graphkin.errors import Lang
from graphkin.sheet.centre_arrows import coordinates
from graphkin.sheet.centre_places import Spot, centre_label, spots
from graphkin.sheet.lettering import Label, Run, number, plain, point_label
from graphkin.sheet.marks import Mark, Place, Stroke, Text
from graphkin.sheet.titleblock import PITCH, SIZE, Table, height_of
from graphkin.studies.centres import Centres

_GAP, _BETWEEN = 2.6, 6.0
_WORDS: dict[Lang, dict[str, str]] = {
    "en": {
        "number": "No.", "centre": "centre", "place": "x, y [mm]", "by": "found by",
        "hinge": "hinge ", "slide": "slide", "contact": "rolling contact", "normal": "common normal",
        "velocities": "velocities", "at": " at ",
        "none": "no relative motion", "more": "more",
    },
    "zh": {
        "number": "序号", "centre": "瞬心", "place": "x，y（mm）", "by": "求法", "hinge": "转动副 ", "slide": "移动副",
        "contact": "纯滚动接触点", "normal": "公法线", "velocities": "由速度求得", "at": "，方向 ",
        "none": "无相对运动", "more": "其余",
    },
}  # fmt: skip


@frozen
class CentreTable:
    """The table cut into parts that stand side by side; `lost` rows found no room on the paper."""

    parts: tuple[Table, ...]
    steps: int
    lost: int = 0

    @property
    def height(self) -> float:
        """[mm]"""
        return height_of([list(self.parts)])

    def drawn(self, corner: Place) -> Iterator[Mark]:
        """Each row comes with its own step."""
        step = 0
        for part in self.parts:
            yield from _row(part, part.head, corner, 0, None)
            under = corner + 1j * (PITCH * 1.05)
            yield Stroke((under, under + part.wide), "thin")
            for k, row in enumerate(part.rows, start=1):
                step += 1
                yield from _row(part, row, corner, k, min(step, self.steps))
            corner += part.wide + _BETWEEN


def _row(table: Table, row: tuple[Label, ...], corner: Place, k: int, step: int | None) -> Iterator[Mark]:
    pen = corner + 1j * (PITCH * (k + 0.75) + (0.6 if k else 0))
    for cell, wide in zip(row, table.widths, strict=True):
        if cell:
            yield Text(cell, pen, SIZE, step)
        pen += wide + _GAP


def centre_table(found: Centres, lang: Lang, room: float, most: float) -> CentreTable:
    """The table in so many mm of width, as low as it gets, and not higher than `most`."""
    words = _WORDS[lang]
    head = (plain(words["number"]), plain(words["centre"]), plain(words["place"]), plain(words["by"]))
    rows = [_cells(found, spot, words) for spot in spots(found)]
    for pair in found.centring.together:
        rows.append((plain("–"), centre_label(found.name(*pair)), plain("–"), plain(words["none"])))
    for count in range(3, max(4, int(most / PITCH))):
        parts = tuple(Table(head, tuple(rows)).cut(count))
        if sum(part.wide for part in parts) + _BETWEEN * (len(parts) - 1) <= room:
            return CentreTable(parts, len(found.centring.stages))
    kept, lost = _shortened(Table(head, tuple(rows)), room, max(4, int(most / PITCH)) - 1, words["more"])
    return CentreTable(kept, len(found.centring.stages), lost)


def _shortened(whole: Table, room: float, count: int, more: str) -> tuple[tuple[Table, ...], int]:
    """As many parts as there is room for; the last line tells how many rows are left out."""
    kept: list[Table] = []
    for part in whole.cut(count):
        if kept and sum(p.wide for p in kept) + part.wide + _BETWEEN * len(kept) > room:
            break
        kept.append(part)
    left = len(whole.rows) - sum(len(part.rows) for part in kept) + 1
    last = kept[-1]
    kept[-1] = Table(last.head, (*last.rows[:-1], (plain("…"), plain(f"{left}"), plain(more), plain(""))))
    return tuple(kept), left


def _cells(found: Centres, spot: Spot, words: dict[str, str]) -> tuple[Label, ...]:
    return plain(str(spot.number)), centre_label(spot.name), _place(found, spot, words), _by(found, spot, words)


def _place(found: Centres, spot: Spot, words: dict[str, str]) -> Label:
    """`(34.37, 0)`, or the direction of a centre at infinity."""
    if spot.place is not None:
        return coordinates(found, spot.place)
    angle = round(degrees(float(found.board.direction(spot.name))), 6) % 180
    return (Run("→ ∞ "), Run(words["at"]), *number(angle), Run("°"))


def _by(found: Centres, spot: Spot, words: dict[str, str]) -> Label:
    stage, step = spot.stage, spot.stage.last
    if stage.say == "two lines":
        first, second = (_line(found, line, words) for line in stage.lines)
        return (*first, Run(" × "), *second)
    if stage.say == "hinge" and isinstance(step, Pricked):
        return (Run(words["hinge"]), *point_label(step.point))
    return plain(words[stage.say])


def _line(found: Centres, line: LineStep, words: dict[str, str]) -> Label:
    if line.name in found.centring.normals:
        return (Run(words["normal"]),)
    return tuple(run for end in drawn_through(line) for run in centre_label(end))
