"""The table of centres: in the order in which they are found, where each is, and how it was found."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import assert_never

from graphkin.centres import Centres
from graphkin.construction import Ray
from graphkin.construction.centring import Far, Join, Kennedy, Pole, Seat, direction_of
from graphkin.errors import Lang
from graphkin.sheet.centre_arrows import coordinates
from graphkin.sheet.centre_places import Spot, centre_label, spots
from graphkin.sheet.lettering import Label, Run, number, plain, point_label
from graphkin.sheet.marks import Mark, Place, Stroke, Text
from graphkin.sheet.results import PITCH, SIZE, Table, height_of
from graphkin.value import frozen

__all__ = ["CentreTable", "centre_table"]

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
            return CentreTable(parts, len(found.centring.steps))
    kept, lost = _shortened(Table(head, tuple(rows)), room, max(4, int(most / PITCH)) - 1, words["more"])
    return CentreTable(kept, len(found.centring.steps), lost)


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
    return plain(str(spot.number)), centre_label(spot.name), _place(found, spot, words), _by(spot, words)


def _place(found: Centres, spot: Spot, words: dict[str, str]) -> Label:
    """`(34.37, 0)`, or the direction of a centre at infinity."""
    if spot.place is not None:
        return coordinates(found, spot.place)
    angle = round(degrees(float(direction_of(found.plot, spot.name))), 6) % 180
    return (Run("→ ∞ "), Run(words["at"]), *number(angle), Run("°"))


def _by(spot: Spot, words: dict[str, str]) -> Label:
    step = spot.step
    match step:
        case Seat(contact=None):
            return (Run(words["hinge"]), *point_label(step.point))
        case Seat():
            return plain(words["contact"])
        case Far():
            return plain(words["slide"])
        case Kennedy():
            return (*_line(step.first, words), Run(" × "), *_line(step.second, words))
        case Pole():
            return plain(words["velocities"])
        case _:
            assert_never(step)


def _line(line: Join | Ray, words: dict[str, str]) -> Label:
    if isinstance(line, Ray):
        return (Run(words["normal"]),)
    return (*centre_label(line.first), *centre_label(line.second))
