"""The points of a link about its pole, as a table: speed, acceleration, and how the path curves."""

from __future__ import annotations

import cmath

from graphkin.errors import Lang
from graphkin.sheet.centre_arrows import coordinates
from graphkin.sheet.lettering import Label, Run, number, plain, point_label
from graphkin.sheet.titleblock import Table
from graphkin.studies.centres.about import About, CarriedPoint

_POINT: dict[Lang, str] = {"en": "point", "zh": "点"}
_CENTRE: dict[Lang, str] = {"en": "K (x, y) [mm]", "zh": "K（x，y）[mm]"}


def point_tables(seen: About, lang: Lang) -> list[Table]:
    """Empty for a link without named points."""
    columns = (("v", "m/s"), ("a", "m/s²"), ("ρ", "mm"))
    heads = [(Run(letter, True), Run(f" [{unit}]")) for letter, unit in columns]
    head = (plain(_POINT[lang]), *heads, plain(_CENTRE[lang]))
    rows = tuple(_row(seen, name, carried) for name, carried in seen.points.items())
    return [Table(head, rows)] if rows else []


def _row(seen: About, name: str, carried: CarriedPoint) -> tuple[Label, ...]:
    sizes = [number(abs(value)) for value in (carried.velocity, carried.acceleration)]
    return (point_label(name), *sizes, *_curving(seen, carried))


def _curving(seen: About, carried: CarriedPoint) -> tuple[Label, Label]:
    """Radius and centre of curvature; a dash for a point that stands still, ∞ where the path is straight."""
    if cmath.isnan(carried.centre):
        return plain("–"), plain("–")
    if cmath.isinf(carried.centre):
        return plain("∞"), plain("∞")
    return number(carried.radius * 1e3), coordinates(seen.found, carried.centre)
